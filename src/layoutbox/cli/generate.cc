#include <fmt/format.h>

#include <cctype>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "layoutbox/cli/commands.h"
#include "layoutbox/cli/inputs.h"
#include "layoutbox/cli/judge_questions.h"
#include "layoutbox/cli/model_flags.h"
#include "layoutbox/pipeline/script_by_model.h"
#include "layoutbox/plan/llm/conversation.h"
#include "layoutbox/scene/json_text.h"

namespace layoutbox::cli {
namespace {

using Json = nlohmann::ordered_json;

struct GenerateArguments {
  std::string prompt, room_kind, scene_file, folder;
  bool no_render = false, by_vlm = false;
  std::string vlm_model, script_by = "template";
  bool unsafe_scripts = false;
  QuestionFlags questions;
  PlanFlags plan;
  ModelFlags model;
  SolveFlags solve;
  RenderFlags render;
  FurnishFlags furnish;
  GenerateOptions options;
};

// "out/design-a-bedroom-4-3fa2": the first words, and four digits that tell prompts with the same beginning apart.
std::string default_folder(std::string_view prompt) {
  std::string slug;
  int words = 0;
  std::uint32_t hash = 2166136261u;  // FNV-1a
  for (const char c : prompt) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 && static_cast<unsigned char>(c) < 128;
    if (words >= 4 || slug.size() > 40) continue;
    if (plain) {
      slug += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!slug.empty() && slug.back() != '-') {
      slug += '-';
      ++words;
    }
  }
  while (!slug.empty() && slug.back() == '-') slug.pop_back();
  return fmt::format("out/{}{}{:04x}", slug, slug.empty() ? "" : "-", hash & 0xffffu);
}

std::string result_json(const GenerateOutcome& outcome, const std::string& folder) {
  Json json{{"asAsked", as_asked(outcome)},    {"status", name_of(outcome.layout.status)}, {"folder", folder},
            {"files", outcome.files},          {"objects", outcome.layout.objects.size()}, {"relations", outcome.layout.relations.size()},
            {"passed", outcome.report.passed}, {"metrics", outcome.report.metrics}};
  for (const auto& [key, list] : {std::pair{"relaxed", &outcome.layout.relaxed}, std::pair{"gaveWay", &outcome.layout.gave_way}}) {
    json[key] = Json::array();
    for (const Relaxation& relaxation : *list) {
      json[key].push_back({{"relation", relaxation.relation}, {"by", relaxation.by}, {"unit", relaxation.unit}, {"why", relaxation.why}});
    }
  }
  json["conflicts"] = Json::array();
  for (const Conflict& conflict : outcome.layout.conflicts) json["conflicts"].push_back(conflict.sentence);
  json["stages"] = Json::array();
  for (const StageTime& stage : outcome.stages) json["stages"].push_back({{"stage", stage.stage}, {"seconds", stage.seconds}});
  if (outcome.picture_error) json["error"] = Json::parse(write_error(*outcome.picture_error));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// What was asked and could not be had, for a person.
void say_what_was_given_up(const Console& console, const GenerateOutcome& outcome) {
  for (const Conflict& conflict : outcome.layout.conflicts) console.warn("cannot all hold: " + conflict.sentence);
  for (const Relaxation& relaxation : outcome.layout.relaxed) {
    const std::string by = relaxation.unit.empty() ? "" : fmt::format(" (missed by {:.2f} {})", relaxation.by, relaxation.unit);
    console.warn(fmt::format("given up: {}{}", relaxation.why.empty() ? relaxation.relation : relaxation.why, by));
  }
  console.gave_way(outcome.layout);
  for (const Check& check : outcome.report.checks) {
    if (check.required && !check.passed) console.warn(fmt::format("check failed: {}", check.message));
  }
}

Status prepare_generate(GenerateArguments& flags, const Console& console) {
  LAYOUTBOX_CHECK(flags.plan.apply(flags.options));
  LAYOUTBOX_CHECK(flags.solve.apply(flags.options.solve, flags.plan.by_model()));
  LAYOUTBOX_CHECK(flags.render.apply(flags.options.render));
  LAYOUTBOX_CHECK(flags.furnish.apply(flags.options.furnish));
  flags.options.pictures = !flags.no_render;
  const std::string& beside = flags.scene_file.empty() ? flags.plan.catalog_file : flags.scene_file;
  flags.options.furnish.asset_folders = asset_folders(beside, flags.plan.assets);
  flags.options.stop = &stop_flag();
  flags.options.on_stage = [&console](const StageTime& stage) { console.stage(stage); };
  flags.options.render.progress = [&console](double share) { console.progress("render", share); };
  return {};
}

// Exactly one of a prompt, a kind of room and a scene file says what the room is like.
Status check_source(const GenerateArguments& flags, bool prompt_given) {
  const int sources = int{prompt_given} + int{!flags.room_kind.empty()} + int{!flags.scene_file.empty()};
  if (sources == 1) return {};
  const char* what = sources == 0 ? "there is no prompt" : "a prompt, --type and --scene exclude one another";
  return layoutbox::fail(ErrorCode::kUsage, what, {}, "say what the room is like: layoutbox generate \"A bedroom with a bed and a desk.\"");
}

Result<std::string> prompt_of(const GenerateArguments& flags) {
  return flags.room_kind.empty() ? read_prompt(flags.prompt) : fmt::format("A {}.", flags.room_kind);
}

// --dry-run: what a model would be asked.
int print_request(GenerateArguments& flags, const Catalog& catalog, const Console& console) {
  const auto prompt = prompt_of(flags);
  if (!prompt) return console.fail(prompt.error());
  const auto planner = flags.model.make_planner(flags.plan.planner, catalog, flags.options, console);
  if (!planner) return console.fail(planner.error());
  return print_first_request(**planner, *prompt, flags.options, console);
}

// --script llm. It can be had with the offline planner too.
Result<DrawPictures> drawing_by_model(const GenerateArguments& flags, const std::string& prompt, const Console& console) {
  ScriptByModel by_model;
  LAYOUTBOX_ASSIGN(by_model.chat, flags.model.chat_options(console));
  by_model.prompt = prompt;
  by_model.seed = flags.options.plan.seed;
  by_model.max_attempts = flags.options.repair.max_attempts;
  by_model.unsafe_scripts = flags.unsafe_scripts;
  by_model.on_note = [&console](const std::string& text) { console.warn(text); };
  return draw_by_model(std::move(by_model));
}

Result<GenerateOutcome> generate_room(GenerateArguments& flags, const Catalog& catalog, const Console& console) {
  if (!flags.scene_file.empty()) {
    LAYOUTBOX_ASSIGN(SceneGraph scene, read_scene_file(flags.scene_file, flags.plan.units));
    if (flags.folder.empty()) flags.folder = default_folder(std::filesystem::path(flags.scene_file).stem().string());
    return generate_from_scene(std::move(scene), catalog, flags.folder, flags.options);
  }
  LAYOUTBOX_ASSIGN(const std::string prompt, prompt_of(flags));
  if (flags.folder.empty()) flags.folder = default_folder(prompt);
  LAYOUTBOX_ASSIGN(const auto planner, flags.model.make_planner(flags.plan.planner, catalog, flags.options, console));
  if (flags.script_by == "llm") {
    LAYOUTBOX_ASSIGN(flags.options.draw, drawing_by_model(flags, prompt, console));
  }
  return generate(prompt, *planner, catalog, flags.folder, flags.options);
}

// The server is the planner's; the model may be another.
QuestionFlags questions_of(const GenerateArguments& flags) {
  QuestionFlags questions = flags.questions;
  questions.model = flags.vlm_model;
  questions.base_url = flags.model.base_url;
  questions.provider = flags.model.provider;
  questions.timeout_s = flags.model.timeout_s;
  questions.max_cost = flags.model.max_cost;
  questions.no_cache = flags.model.no_cache;
  return questions;
}

int run_generate(GenerateArguments& flags, bool prompt_given, const Console& console) {
  clear_up(console);
  if (const Status source = check_source(flags, prompt_given); !source) return console.fail(source.error());
  if (const Status ready = prepare_generate(flags, console); !ready) return console.fail(ready.error());
  const auto catalog = flags.plan.load_catalog();
  if (!catalog) return console.fail(catalog.error());
  flags.options.inputs.insert(flags.options.inputs.end(), catalog->inputs.begin(), catalog->inputs.end());
  if (flags.model.dry_run) return print_request(flags, catalog->get(), console);
  const auto outcome = generate_room(flags, catalog->get(), console);
  if (!outcome) return console.fail(outcome.error());

  console.notes(catalog->notes);
  console.notes(outcome->scene.notes);
  say_what_was_given_up(console, *outcome);
  std::string files;
  for (const std::string& file : outcome->files) files += (files.empty() ? "" : " ") + file;
  console.result(fmt::format("{}: {}", flags.folder, files), result_json(*outcome, flags.folder));
  if (outcome->picture_error) {
    Console without_json = console;
    without_json.json = false;  // the result above already holds it
    return without_json.fail(*outcome->picture_error);
  }
  if (flags.by_vlm) {
    if (const Status judged = judge_generated(questions_of(flags), *outcome, flags.folder, console); !judged) {
      Console without_json = console;
      without_json.json = false;
      return without_json.fail(judged.error());
    }
  }
  return as_asked(*outcome) ? kDone : kNotAsAsked;
}

}  // namespace

void add_generate(CLI::App& app, Context& context) {
  auto flags = std::make_shared<GenerateArguments>();
  CLI::App* command = app.add_subcommand("generate", "Text to a furnished room: scene, layout, floor plan, 3D files, picture, report");
  const auto* prompt = command->add_option("prompt", flags->prompt, "What the room is like, in English; - reads it from stdin");
  command->add_option("--type", flags->room_kind, "Instead of a prompt: a kind of room with its usual furniture (bedroom, office, …)");
  command->add_option("--scene", flags->scene_file, "Instead of a prompt: a scene file, ours or the paper's form");
  command->add_option("-o,--output", flags->folder, "Folder for the files (default: out/ and the first words of the prompt)");
  command->add_flag("--no-render", flags->no_render, "Make no picture: no Blender is needed");
  command
      ->add_option("--script", flags->script_by,
                   "Who writes blender.py: template, or llm: the model, run in a sandbox, with the template where its scripts fail")
      ->capture_default_str()
      ->check(CLI::IsMember({"template", "llm"}));
  command->add_flag("--unsafe-scripts", flags->unsafe_scripts, "Run a model's script although there is no sandbox on this machine");
  const auto* const judging = "Judging by a vision model";
  command->add_flag("--vlm", flags->by_vlm, "A vision model judges the picture: a score and questions, into answers.json")->group(judging);
  command->add_option("--vlm-model", flags->vlm_model, "Its name (else LAYOUTBOX_VLM_MODEL, else LAYOUTBOX_MODEL)")->group(judging);
  command->add_flag("--reasons,--vlm-reasons", flags->questions.options.reasons, "With its reasons")->group(judging);
  add_publish_to(*command, flags->questions.publish, judging);
  flags->plan.add_to(*command);
  flags->plan.add_companions_to(*command);
  flags->model.add_to(*command, flags->options.repair);
  flags->solve.add_to(*command, flags->options.solve);
  add_variants_to(*command, flags->options);
  flags->render.add_to(*command);
  flags->furnish.add_to(*command);
  command->callback([flags, prompt, &context] { context.status = run_generate(*flags, prompt->count() > 0, context.console); });
}

}  // namespace layoutbox::cli
