// Runs methods over a suite, judges every room, and goes on where it was stopped.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "layoutbox/experiment/methods.h"
#include "layoutbox/experiment/suite.h"
#include "layoutbox/judge/judge.h"

namespace layoutbox::experiment {

struct ExperimentOptions {
  std::vector<std::string> methods;  // names; empty: all that need no model, and those that do where a model is at hand
  int repeats = 1;                   // the repeat's number is the seed
  int jobs = 1;                      // runs at once
  const Planner* model = nullptr;
  const chat::ChatOptions* chat = nullptr;  // of the same model
  bool unsafe_scripts = false;              // see MethodInput
  std::string model_name;                   // for the report
  GenerateOptions generate;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(std::size_t done, std::size_t all, const std::string& key)> on_run;  // may be empty
};

// One room made by one method, judged.
struct RunRecord {
  std::string scene, method;
  int repeat = 1;
  std::string outcome;  // of the method, or "failed"
  std::string error, structure;
  // What is wrong with it as a possible room, coarsely: why the method made none ("syntax", "run-time"…), else "collision",
  // "out of bounds", both, or empty.
  std::string failure;
  int requests = 0;  // answers of a model
  std::map<std::string, double> seconds;
  Judgement judgement;
  std::string key() const;
};

struct ExperimentOutcome {
  std::vector<RunRecord> records;    // by scene, method and repeat, in the suite's order
  std::vector<std::string> skipped;  // methods that were not run, with the reason
  std::size_t kept = 0;              // runs that were there already
};

// Writes into `folder`: runs/SCENE/METHOD-REPEAT.json (the layout), results.jsonl, results.csv, report.html.
// Errors: kUsage (an unknown method), kIo, kInterrupted (what is done is kept).
Result<ExperimentOutcome> run_experiment(const Suite& suite, const Catalog& catalog, const std::filesystem::path& folder,
                                         const ExperimentOptions& options);

// The files' texts.
std::string results_csv(const ExperimentOutcome& outcome);
std::string experiment_html(const Suite& suite, const ExperimentOutcome& outcome, const ExperimentOptions& options);
// One line for each method: share of rooms with everything met, and so on.
std::string experiment_text(const ExperimentOutcome& outcome);

}  // namespace layoutbox::experiment
