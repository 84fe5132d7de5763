#include "layoutbox/experiment/experiment.h"

#include <fmt/format.h>

#include <iterator>
#include <memory>
#include <optional>

#include "layoutbox/chat/endpoint.h"
#include "layoutbox/cli/commands.h"
#include "layoutbox/cli/inputs.h"
#include "layoutbox/cli/judge_questions.h"
#include "layoutbox/cli/model_flags.h"

namespace layoutbox::cli {
namespace {

struct ExperimentArguments {
  std::string suite, folder;
  std::vector<std::string> models, ratings;
  bool by_vlm = false;
  std::string vlm_model;
  QuestionFlags questions;
  experiment::ExperimentOptions options;
  ModelFlags model;
};

// A model, where one can be asked: a key, or a server at home. All that it is asked draws on one limit.
struct AskedModel {
  chat::ChatOptions chat;
  std::unique_ptr<Planner> planner;
};

// Those that are named; without a name the one that would be asked anyway. None where there is no key and no server at home.
Result<std::vector<std::unique_ptr<AskedModel>>> models_at_hand(ExperimentArguments& flags, const Console& console) {
  std::vector<std::unique_ptr<AskedModel>> models;
  const std::vector<std::string> names = flags.models.empty() ? std::vector{flags.model.model} : flags.models;
  for (const std::string& name : names) {
    flags.model.model = name;
    auto chat = flags.model.chat_options(console);
    if (!chat || !chat::check_key(chat->endpoint)) {
      if (flags.models.empty()) break;
      return Failure(chat ? chat::check_key(chat->endpoint).error() : chat.error());
    }
    LAYOUTBOX_ASSIGN(auto planner, flags.model.make_planner("llm", Catalog::builtin(), flags.options.generate, console, &*chat));
    models.push_back(std::make_unique<AskedModel>(AskedModel{*std::move(chat), std::move(planner)}));
    const chat::Endpoint& endpoint = models.back()->chat.endpoint;
    const std::string shown = names.size() > 1 ? endpoint.model : fmt::format("{} at {}", endpoint.model, endpoint.base_url);
    flags.options.models.push_back({shown, models.back()->planner.get(), &models.back()->chat});
  }
  return models;
}

// --vlm: who judges the pictures. The server is the planner's; the model may be another.
Status set_judge(ExperimentArguments& flags, std::optional<chat::ChatOptions>& judge, const Console& console) {
  if (!flags.by_vlm) return {};
  flags.questions.model = flags.vlm_model;
  flags.questions.base_url = flags.model.base_url;
  flags.questions.provider = flags.model.provider;
  flags.questions.timeout_s = flags.model.timeout_s;
  flags.questions.max_cost = flags.model.max_cost;
  flags.questions.no_cache = flags.model.no_cache;
  LAYOUTBOX_ASSIGN(judge, flags.questions.chat_options(console));
  LAYOUTBOX_CHECK(chat::check_key(judge->endpoint));
  experiment::PictureOptions& pictures = flags.options.pictures;
  pictures.judge = &*judge;
  pictures.judge_name = fmt::format("{} at {}", judge->endpoint.model, judge->endpoint.base_url);
  pictures.asking = flags.questions.options;
  return {};
}

Status read_all_ratings(ExperimentArguments& flags) {
  for (const std::string& file : flags.ratings) {
    LAYOUTBOX_ASSIGN(const std::string text, read_input(file));
    LAYOUTBOX_ASSIGN(std::vector<experiment::Rating> ratings, experiment::read_ratings(text, file));
    std::move(ratings.begin(), ratings.end(), std::back_inserter(flags.options.ratings));
  }
  return {};
}

int run_experiment_command(ExperimentArguments flags, const Console& console) {
  clear_up(console);
  const auto suite = experiment::load_suite(flags.suite);
  if (!suite) return console.fail(suite.error());
  const auto models = models_at_hand(flags, console);
  if (!models) return console.fail(models.error());
  std::optional<chat::ChatOptions> judge;
  if (const Status set = set_judge(flags, judge, console); !set) return console.fail(set.error());
  if (const Status read = read_all_ratings(flags); !read) return console.fail(read.error());
  flags.options.stop = &stop_flag();
  flags.options.on_run = [&](std::size_t done, std::size_t all, const std::string&) {
    console.progress("rooms", static_cast<double>(done) / static_cast<double>(all));
  };
  const auto outcome = experiment::run_experiment(*suite, Catalog::builtin(), flags.folder, flags.options);
  if (!outcome) return console.fail(outcome.error());
  for (const std::string& skipped : outcome->skipped) console.say("not run  " + skipped);
  if (!outcome->no_pictures.empty()) console.warn("no pictures: " + outcome->no_pictures);
  if (outcome->unknown_ratings > 0) console.warn(fmt::format("{} ratings are of rooms that are not here", outcome->unknown_ratings));
  if (outcome->kept > 0) console.say(fmt::format("{} of {} rooms were there already", outcome->kept, outcome->records.size()));
  console.result(experiment::experiment_text(*outcome), fmt::format("{{\"rooms\": {}, \"kept\": {}, \"skipped\": {}}}\n",
                                                                    outcome->records.size(), outcome->kept, outcome->skipped.size()));
  return kDone;
}

}  // namespace

void add_experiment(CLI::App& app, Context& context) {
  auto flags = std::make_shared<ExperimentArguments>();
  CLI::App* command = app.add_subcommand("experiment", "Compare ways to make rooms over a suite of prompts, with a report");
  command->add_option("suite", flags->suite, "paper, crowded, ladder, or an annotated table (ID, Description, ObjCount, OORel, OARel)")
      ->required();
  command->add_option("-o,--output", flags->folder, "The folder of results.jsonl, results.csv, report.html and the rooms")->required();
  command->add_option("--methods", flags->options.methods, "Which, with commas between (else all that can be run)")->delimiter(',');
  command->add_option("--repeats", flags->options.repeats, "How often; the number is the seed")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  command->add_option("-j,--jobs", flags->options.jobs, "Rooms at once")->capture_default_str()->check(CLI::Range(1, 256));
  command->add_option("--effort", flags->options.generate.solve.effort, "How long the solver improves, in deterministic units")
      ->capture_default_str()
      ->check(CLI::Range(1, 10'000'000));
  command->add_option("--models", flags->models, "Models to compare, with commas between (else --model)")->delimiter(',');
  command->add_flag("--pictures", flags->options.pictures.draw, "Blender draws each room, and what does not hold over it");
  command->add_option("--ratings", flags->ratings, "Ratings by people: tables of the studio's rating page (id, score), a file a rater")
      ->delimiter(',');
  const auto* const judging = "Judging by a vision model";
  command->add_flag("--vlm", flags->by_vlm, "A vision model judges each picture, else floor plan: scores and questions")->group(judging);
  command->add_option("--vlm-model", flags->vlm_model, "Its name (else LAYOUTBOX_VLM_MODEL, else LAYOUTBOX_MODEL)")->group(judging);
  command->add_flag("--all-walls", flags->options.pictures.all_walls, "Each room is also drawn and judged with no wall cut away")
      ->group(judging);
  flags->questions.add_asking_to(*command);
  command->add_flag("--unsafe-scripts", flags->options.unsafe_scripts,
                    "Run scripts of a model although there is no sandbox on this machine");
  flags->model.add_to(*command, flags->options.generate.repair);
  command->callback([flags, &context] { context.status = run_experiment_command(*flags, context.console); });
}

}  // namespace layoutbox::cli
