// A program of one's own on the installed library: a sentence becomes a floor plan (plan.svg) and a model (room.glb) in this folder.
#include <layoutbox/catalog.h>
#include <layoutbox/export.h>
#include <layoutbox/furnish.h>
#include <layoutbox/plan.h>
#include <layoutbox/solve.h>
#include <layoutbox/verify.h>

#include <fstream>
#include <iostream>

namespace {

namespace lb = layoutbox;

lb::Result<lb::Layout> lay_out(std::string_view prompt, const lb::Catalog& catalog) {
  LAYOUTBOX_ASSIGN(lb::Plan plan, lb::make_offline_planner(catalog)->plan(prompt, {}));
  LAYOUTBOX_ASSIGN(const lb::SceneGraph scene, lb::normalize_scene(std::move(plan.scene), catalog));
  return lb::solve(scene, catalog);
}

lb::Status write_room(const lb::Layout& layout, const lb::Catalog& catalog) {
  LAYOUTBOX_ASSIGN(const lb::Model model, lb::furnish(layout, catalog));
  LAYOUTBOX_ASSIGN(const std::string glb, lb::write_glb(model, layout));
  std::ofstream("room.glb", std::ios::binary) << glb;
  std::ofstream("plan.svg") << lb::write_floor_plan_svg(layout, catalog);
  return {};
}

int complain(const lb::Error& error) {
  std::cerr << error.message << '\n';
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
#ifdef LAYOUTBOX_CP_SAT_FOLDER
  lb::set_cp_sat_folder(LAYOUTBOX_CP_SAT_FOLDER);  // the solver library that was installed with layoutbox
#endif
  const lb::Catalog& catalog = lb::Catalog::builtin();
  const auto layout = lay_out(argc > 1 ? argv[1] : "A study with a desk under the window and a bookshelf.", catalog);
  if (!layout) return complain(layout.error());
  if (const auto written = write_room(*layout, catalog); !written) return complain(written.error());
  const lb::Report report = lb::verify(*layout, catalog);
  for (const lb::PlacedObject& object : layout->objects) std::cout << object.id << '\n';
  std::cout << (report.passed ? "all checks passed\n" : "a check failed\n");
  return report.passed ? 0 : 1;
}
