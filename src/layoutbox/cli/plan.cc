#include <fmt/format.h>

#include <memory>

#include "layoutbox/cli/commands.h"
#include "layoutbox/cli/inputs.h"
#include "layoutbox/cli/model_flags.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox::cli {
namespace {

struct PlanArguments {
  std::string prompt, output;
  bool explain = false;
  PlanFlags plan;
  ModelFlags model;
  GenerateOptions options;
};

std::string_view mark_of(WordReading::Use use) {
  switch (use) {
    case WordReading::Use::kUsed: return "used";
    case WordReading::Use::kIgnored: return "ignored";
    case WordReading::Use::kNotUnderstood: return "NOT UNDERSTOOD";
  }
  return "";
}

// How every word was read, then the objects and relations they led to.
std::string explanation(std::string_view prompt, const Plan& plan) {
  std::string text;
  for (const WordReading& reading : plan.readings) {
    text +=
        fmt::format("{:<24} {:<15} {}\n", prompt.substr(reading.begin, reading.end - reading.begin), mark_of(reading.use), reading.role);
  }
  if (!plan.close.empty()) text += "\nnearly as likely\n";
  for (const CloseReading& close : plan.close)
    text += fmt::format("  “{}” {}; or it {}\n", prompt.substr(close.begin, close.end - close.begin), close.taken, close.other);
  text += "\nobjects\n";
  for (const SceneObject& object : plan.scene.objects) {
    std::string attributes;
    for (const std::string& attribute : object.attributes) attributes += (attributes.empty() ? "" : ", ") + attribute;
    text += fmt::format("  {:<22} {:<20} {}{}\n", object.id, object.category, attributes,
                        object.asked() ? "" : fmt::format(" ({})", name_of(object.origin)));
  }
  text += "\nrelations\n";
  for (const Relation& relation : plan.scene.relations) {
    text +=
        fmt::format("  {:<6} {:<16} {} → {}  {}“{}”\n", relation.id, relation_row(relation.type).name, fmt::join(relation.targets, ", "),
                    fmt::join(relation.references, ", "), relation.hard ? "" : "soft ", relation.why);
  }
  return text;
}

int run_plan(PlanArguments& flags, const Console& console) {
  if (const Status ready = flags.plan.apply(flags.options); !ready) return console.fail(ready.error());
  const auto prompt = read_prompt(flags.prompt);
  if (!prompt) return console.fail(prompt.error());
  const auto catalog = flags.plan.load_catalog();
  if (!catalog) return console.fail(catalog.error());
  const auto planner = flags.model.make_planner(flags.plan.planner, catalog->get(), flags.options, console);
  if (!planner) return console.fail(planner.error());
  if (flags.model.dry_run) return print_first_request(**planner, *prompt, flags.options, console);
  flags.options.plan.stop = &stop_flag();
  const auto plan = (*planner)->plan(*prompt, flags.options.plan);
  if (!plan) return console.fail(plan.error());
  const auto scene = prepare_plan(*plan, catalog->get(), flags.options);
  if (!scene) return console.fail(scene.error());
  console.notes(catalog->notes);
  console.notes(scene->notes);
  if (flags.explain && !console.json) {
    if (const Status written = write_output("-", explanation(*prompt, *plan)); !written) return console.fail(written.error());
    if (flags.output.empty()) return kDone;
  }
  const Status written = write_output(flags.output, write_scene(*scene));
  return written ? kDone : console.fail(written.error());
}

}  // namespace

void add_plan(CLI::App& app, Context& context) {
  auto flags = std::make_shared<PlanArguments>();
  CLI::App* command = app.add_subcommand("plan", "Text to scene graph");
  command->add_option("prompt", flags->prompt, "What the room is like, in English; - reads it from stdin")->required();
  command->add_option("-o,--output", flags->output, "The scene file (default: stdout)");
  command->add_flag("--explain", flags->explain, "Show how each word was read");
  flags->plan.add_to(*command);
  flags->plan.add_companions_to(*command);
  flags->model.add_to(*command, flags->options.repair);
  command->callback([flags, &context] { context.status = run_plan(*flags, context.console); });
}

}  // namespace layoutbox::cli
