#include "layoutbox/edit/edit.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "layoutbox/cli/commands.h"
#include "layoutbox/cli/inputs.h"
#include "layoutbox/cli/model_flags.h"
#include "layoutbox/pipeline/edit_by_planner.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox::cli {
namespace {

using Json = nlohmann::ordered_json;

struct EditArguments {
  std::string layout, text, output, catalog_file, assets;
  std::string planner = "offline";
  bool no_render = false;
  ModelFlags model;
  RenderFlags render;
  FurnishFlags furnish;
  GenerateOptions options;
};

// A name that ends in .json (or stdout) is the layout alone; any other the folder of a whole room.
bool is_folder(const std::string& output) {
  std::error_code ignored;
  const std::filesystem::path path(output);
  return output != "-" && (std::filesystem::is_directory(path, ignored) || path.extension() != ".json");
}

std::string words_of(const ObjectChange& change) {
  std::string what;
  for (const std::string& word : change.what) {
    what += (what.empty() ? "" : ", ") + word;
    if (word == "moved") what += fmt::format(" {:.2f} m", change.metres);
    if (word == "turned") what += fmt::format(" {:.0f}°", change.degrees);
  }
  return fmt::format("{} {}{}", change.id, what, change.asked ? "" : " (made room, or went along)");
}

// What made room by less than the centimetre that is shown is not worth a line.
bool is_shown(const ObjectChange& change) {
  constexpr double kShown = 0.005;
  return change.asked || change.metres >= kShown || change.what != std::vector<std::string>{"moved"};
}

std::string text_of(const EditOutcome& outcome) {
  std::string text;
  for (const ObjectChange& change : outcome.changes) {
    if (is_shown(change)) text += words_of(change) + "\n";
  }
  for (const Relation& relation : outcome.dropped) {
    text += fmt::format("no longer asked for: {}\n", relation.why.empty() ? std::string(relation_row(relation.type).name) : relation.why);
  }
  for (const Relaxation& relaxation : outcome.layout.relaxed) {
    text += fmt::format("given up: {}\n", relaxation.why.empty() ? relaxation.relation : relaxation.why);
  }
  if (text.empty()) return "nothing changed";
  text.pop_back();
  return text;
}

std::string outcome_json(const EditOutcome& outcome, const EditArguments& flags) {
  Json json{{"output", flags.output}, {"status", name_of(outcome.layout.status)}};
  json["changes"] = Json::array();
  for (const ObjectChange& change : outcome.changes) {
    json["changes"].push_back(
        {{"id", change.id}, {"what", change.what}, {"metres", change.metres}, {"degrees", change.degrees}, {"asked", change.asked}});
  }
  json["dropped"] = Json::array();
  for (const Relation& relation : outcome.dropped) {
    json["dropped"].push_back({{"id", relation.id},
                               {"type", relation_row(relation.type).name},
                               {"targets", relation.targets},
                               {"relativeTo", relation.references},
                               {"why", relation.why}});
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// The whole room; a missing picture costs exit status 3 and nothing else.
int write_folder(EditArguments& flags, const EditOutcome& edited, const Catalog& catalog, const Console& console) {
  flags.options.pictures = !flags.no_render;
  flags.options.on_stage = [&console](const StageTime& stage) { console.stage(stage); };
  flags.options.render.progress = [&console](double share) { console.progress("render", share); };
  const auto made = generate_from_layout(edited.scene, edited.layout, catalog, flags.output, flags.options);
  if (!made) return console.fail(made.error());
  if (made->picture_error) {
    Console without_json = console;
    without_json.json = false;
    return without_json.fail(*made->picture_error);
  }
  return as_asked(*made) ? kDone : kNotAsAsked;
}

Result<EditOutcome> edited_layout(EditArguments& flags, const std::string& text, const Layout& layout, const Catalog& catalog,
                                  const Console& console) {
  if (flags.model.dry_run) return layoutbox::fail(ErrorCode::kUsage, "edit shows no request", "--dry-run", "generate and plan do");
  if (flags.planner == "offline") return edit_layout(text, layout, catalog, flags.options.solve);
  LAYOUTBOX_ASSIGN(const auto planner, flags.model.make_planner(flags.planner, catalog, flags.options, console));
  return edit_by_planner(text, layout, catalog, *planner, flags.options);
}

int run_edit(EditArguments& flags, const Console& console) {
  clear_up(console);
  if (const Status ready = flags.render.apply(flags.options.render); !ready) return console.fail(ready.error());
  if (const Status ready = flags.furnish.apply(flags.options.furnish); !ready) return console.fail(ready.error());
  flags.options.furnish.asset_folders = asset_folders(flags.layout, flags.assets);
  flags.options.stop = &stop_flag();
  flags.options.solve.stop = &stop_flag();
  const auto layout = read_layout_file(flags.layout);
  if (!layout) return console.fail(layout.error());
  const auto text = read_prompt(flags.text);
  if (!text) return console.fail(text.error());
  const auto catalog = load_catalog(flags.catalog_file);
  if (!catalog) return console.fail(catalog.error());
  const auto edited = edited_layout(flags, *text, *layout, catalog->get(), console);
  if (!edited) return console.fail(edited.error());
  console.notes(edited->notes);
  int status = edited->layout.status == LayoutStatus::kSolved ? kDone : kNotAsAsked;
  if (is_folder(flags.output)) {
    status = write_folder(flags, *edited, catalog->get(), console);
  } else if (const Status written = write_output(flags.output, write_layout(edited->layout)); !written) {
    return console.fail(written.error());
  }
  if (flags.output != "-") console.result(text_of(*edited), outcome_json(*edited, flags));
  return status;
}

}  // namespace

void add_edit(CLI::App& app, Context& context) {
  auto flags = std::make_shared<EditArguments>();
  CLI::App* command = app.add_subcommand("edit", "A layout changed by words; all else stays where it is as far as can be");
  command->add_option("layout", flags->layout, "layout.json; - reads stdin")->required();
  command->add_option("text", flags->text, "What to change: \"move the desk under the window and remove the rug\"; - reads stdin")
      ->required();
  command->add_option("-o,--output", flags->output, "The new layout (a name in .json, or - for stdout), or a folder for all files")
      ->required();
  add_catalog_option(*command, flags->catalog_file);
  command->add_option("--assets", flags->assets, "Folder that meshes and images are named from (default: the layout's)");
  flags->options.solve.effort = 100;
  add_seed_option(*command, flags->options.solve.seed);
  command->add_option("--effort", flags->options.solve.effort, "Deterministic work units of the solver")
      ->capture_default_str()
      ->check(CLI::Range(1, 10'000'000));
  command->add_option("--planner", flags->planner, "Who reads the text: offline, or llm (a language model)")
      ->capture_default_str()
      ->check(CLI::IsMember({"offline", "llm"}));
  flags->model.add_to(*command, flags->options.repair);
  command->add_flag("--no-render", flags->no_render, "Into a folder: make no picture, no Blender is needed");
  flags->render.add_to(*command);
  flags->furnish.add_to(*command);
  command->callback([flags, &context] { context.status = run_edit(*flags, context.console); });
}

}  // namespace layoutbox::cli
