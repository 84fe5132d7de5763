#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "layoutbox/cli/commands.h"
#include "layoutbox/cli/inputs.h"
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
  return fmt::format(", {} of {} objects moved, by {:.2f} m in all", way.moved, layout.objects.size(), way.metres);
}

int run(Flags& flags, const Console& console) {
  if (const Status ready = prepare(flags); !ready) return console.fail(ready.error());
  auto scene = read_room(flags);
  if (!scene) return console.fail(scene.error());
  const auto catalog = flags.plan.load_catalog();
  if (!catalog) return console.fail(catalog.error());
  const auto normalized = prepare_scene(*std::move(scene), catalog->get(), flags.options);
  if (!normalized) return console.fail(normalized.error());
  console.notes(catalog->notes);
  console.notes(normalized->notes);
  const auto layout = solve(*normalized, catalog->get(), flags.options.solve);
  if (!layout) return console.fail(layout.error());
  const auto held = std::count_if(layout->relations.begin(), layout->relations.end(), [](const auto& r) { return r.held; });
  console.stage({"solve", layout->stats.seconds,
                 fmt::format("{} of {} relations held, {} given up ({}){}", held, layout->relations.size(), layout->relaxed.size(),
                             layout->stats.solver, moved_in_words(flags, *layout))});
  for (const Conflict& conflict : layout->conflicts) console.warn("cannot all hold: " + conflict.sentence);
  for (const Relaxation& relaxation : layout->relaxed)
    console.warn("given up: " + (relaxation.why.empty() ? relaxation.relation : relaxation.why));
  const Status written = write_output(flags.output, write_layout(*layout));
  if (!written) return console.fail(written.error());
  return layout->status == LayoutStatus::kSolved && layout->relaxed.empty() ? kDone : kNotAsAsked;
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
  command->callback([flags, &context] { context.status = run(*flags, context.console); });
}

}  // namespace layoutbox::cli
