#include "layoutbox/experiment/experiment.h"

#include <fmt/format.h>

#include <memory>
#include <optional>

#include "layoutbox/chat/endpoint.h"
#include "layoutbox/cli/commands.h"
#include "layoutbox/cli/inputs.h"
#include "layoutbox/cli/model_flags.h"

namespace layoutbox::cli {
namespace {

struct ExperimentArguments {
  std::string suite, folder;
  experiment::ExperimentOptions options;
  ModelFlags model;
};

// A model, where one can be asked: a key, or a server at home. All that it is asked draws on one limit.
struct ModelAtHand {
  chat::ChatOptions chat;
  std::unique_ptr<Planner> planner;
};

std::optional<ModelAtHand> model_at_hand(ExperimentArguments& flags, const Console& console) {
  auto chat = flags.model.chat_options(console);
  if (!chat || !chat::check_key(chat->endpoint)) return std::nullopt;
  auto planner = flags.model.make_planner("llm", Catalog::builtin(), flags.options.generate, console, &*chat);
  if (!planner) return std::nullopt;
  flags.options.model_name = fmt::format("{} at {}", chat->endpoint.model, chat->endpoint.base_url);
  return ModelAtHand{*std::move(chat), *std::move(planner)};
}

int run_experiment_command(ExperimentArguments flags, const Console& console) {
  const auto suite = experiment::load_suite(flags.suite);
  if (!suite) return console.fail(suite.error());
  const std::optional<ModelAtHand> model = model_at_hand(flags, console);
  if (model) flags.options.model = model->planner.get(), flags.options.chat = &model->chat;
  flags.options.stop = &stop_flag();
  flags.options.on_run = [&](std::size_t done, std::size_t all, const std::string&) {
    console.progress("rooms", static_cast<double>(done) / static_cast<double>(all));
  };
  const auto outcome = experiment::run_experiment(*suite, Catalog::builtin(), flags.folder, flags.options);
  if (!outcome) return console.fail(outcome.error());
  for (const std::string& skipped : outcome->skipped) console.say("not run  " + skipped);
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
  command->add_flag("--unsafe-scripts", flags->options.unsafe_scripts,
                    "Run scripts of a model although there is no sandbox on this machine");
  flags->model.add_to(*command, flags->options.generate.repair);
  command->callback([flags, &context] { context.status = run_experiment_command(*flags, context.console); });
}

}  // namespace layoutbox::cli
