#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "layoutbox/base/words.h"
#include "layoutbox/cli/commands.h"
#include "layoutbox/cli/inputs.h"
#include "layoutbox/pipeline/variants.h"
#include "layoutbox/scene/layout_scene.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox::cli {
namespace {

struct Flags {
  std::string scene, output, from;
  std::optional<Layout> earlier;
  PlanFlags plan;
  SolveFlags solve;
  GenerateOptions options;
};

Status prepare(Flags& flags) {
  LAYOUTBOX_CHECK(flags.plan.apply(flags.options));
  return flags.solve.apply(flags.options.solve);
}

// The scene of a scene file; of a layout file, which then guides itself. Another layout may guide either.
Result<SceneGraph> read_room(Flags& flags) {
  LAYOUTBOX_ASSIGN(SceneOrLayout file, read_scene_or_layout_file(flags.scene, flags.plan.units));
  if (file.layout) flags.earlier = std::move(file.layout);
  if (!flags.from.empty()) {
    LAYOUTBOX_ASSIGN(flags.earlier, read_layout_file(flags.from));
  }
  if (flags.earlier) flags.options.solve.from = &*flags.earlier;
  return std::move(file.scene);
}

std::string moved_in_words(const Flags& flags, const Layout& layout) {
  if (!flags.earlier) return {};
  const Movement way = movement_between(*flags.earlier, layout);
  return fmt::format(", {} of {} moved, by {:.2f} m in all", way.moved, counted(layout.objects.size(), "object"), way.metres);
}

// How it went: what holds, what was given up, how far things were moved.
void tell(const Flags& flags, const Layout& layout, const Console& console) {
  const auto held = std::count_if(layout.relations.begin(), layout.relations.end(), [](const auto& r) { return r.held; });
  console.stage({"solve", layout.stats.seconds,
                 fmt::format("{} of {} held, {} given up ({}){}", held, counted(layout.relations.size(), "relation"), layout.relaxed.size(),
                             layout.stats.solver, moved_in_words(flags, layout))});
  for (const Conflict& conflict : layout.conflicts) console.warn("cannot all hold: " + conflict.sentence);
  for (const Relaxation& relaxation : layout.relaxed)
    console.warn("given up: " + (relaxation.why.empty() ? relaxation.relation : relaxation.why));
  console.gave_way(layout);
}

int run(Flags& flags, const Console& console) {
  if (const Status ready = prepare(flags); !ready) return console.fail(ready.error());
  if (flags.options.variants > 1 && (flags.output.empty() || flags.output == "-")) {
    return console.fail({ErrorCode::kUsage, "several layouts need files to go to", "--variants", "name the first one with -o", {}});
  }
  auto scene = read_room(flags);
  if (!scene) return console.fail(scene.error());
  const auto catalog = flags.plan.load_catalog();
  if (!catalog) return console.fail(catalog.error());
  const auto normalized = prepare_scene(*std::move(scene), catalog->get(), flags.options);
  if (!normalized) return console.fail(normalized.error());
  console.notes(catalog->notes);
  console.notes(normalized->notes);
  const auto layouts = solve_variants(*normalized, catalog->get(), flags.options.solve, flags.options.variants);
  if (!layouts) return console.fail(layouts.error());
  int status = kDone;
  for (std::size_t k = 0; k < layouts->size(); ++k) {
    tell(flags, (*layouts)[k], console);
    if (k > 0) console.stage({"variant", 0, fmt::format("{}: {}", variant_name(flags.output, k), variant_in_words(*layouts, k))});
    const Status written = write_output(variant_name(flags.output, k), write_layout((*layouts)[k]));
    if (!written) return console.fail(written.error());
    if ((*layouts)[k].status != LayoutStatus::kSolved) status = kNotAsAsked;
  }
  return status;
}
}  // namespace

void add_solve(CLI::App& app, Context& context) {
  auto flags = std::make_shared<Flags>();
  CLI::App* command = app.add_subcommand("solve", "Scene graph to layout; prints the conflict where there is one");
  command->add_option("scene", flags->scene, "scene.json, ours or the paper's form, or a layout.json to mend; - reads stdin")->required();
  command->add_option("-o,--output", flags->output, "The layout file (default: stdout)");
  command->add_option("--from", flags->from, "An earlier layout: everything stays as near to its place there as can be");
  command->add_option("--lock", flags->options.solve.locked, "Ids of objects that stay exactly where the earlier layout has them")
      ->delimiter(',');
  flags->plan.add_to(*command);
  flags->solve.add_to(*command, flags->options.solve);
  add_variants_to(*command, flags->options);
  command->callback([flags, &context] { context.status = run(*flags, context.console); });
}

}  // namespace layoutbox::cli
