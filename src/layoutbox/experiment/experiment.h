// Runs methods over a suite, judges every room, and goes on where it was stopped.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "layoutbox/experiment/methods.h"
#include "layoutbox/experiment/pictures.h"
#include "layoutbox/experiment/ratings.h"
#include "layoutbox/experiment/suite.h"
#include "layoutbox/judge/judge.h"

namespace layoutbox::experiment {

// Who plans for the methods that ask a model.
struct ModelAtHand {
  std::string name;                         // as it stands beside a method where there are several
  const Planner* planner = nullptr;         // asks the same as `chat`
  const chat::ChatOptions* chat = nullptr;  // for methods that are no planner's
};

struct ExperimentOptions {
  std::vector<std::string> methods;  // names; empty: all that need no model, and those that do where a model is at hand
  int repeats = 1;                   // the repeat's number is the seed
  int jobs = 1;                      // runs at once
  std::vector<ModelAtHand> models;   // empty: none is at hand
  bool unsafe_scripts = false;       // see MethodInput
  PictureOptions pictures;
  std::vector<Rating> ratings;  // of people
  GenerateOptions generate;
  const std::atomic<bool>* stop = nullptr;
  std::function<void(std::size_t done, std::size_t all, const std::string& key)> on_run;  // may be empty
};

// What the answers of a model took.
struct Spent {
  int requests = 0;
  std::int64_t request_tokens = 0, response_tokens = 0;
  double cost = 0;         // US dollars
  bool cost_known = true;  // of every answer
};

// One room made by one method, judged.
struct RunRecord {
  std::string scene, method;  // the method's name, with "@" and the model's where there are several
  int repeat = 1;
  std::string outcome;  // of the method, or "failed"
  std::string error, structure;
  // What is wrong with it as a possible room, coarsely: why the method made none ("syntax", "run-time"…), else "collision",
  // "out of bounds", both, or empty.
  std::string failure;
  Spent spent;
  std::map<std::string, double> seconds;
  Judgement judgement;
  PictureJudgement picture;     // what a vision model says of its picture
  std::vector<double> ratings;  // what people say of it
  std::string key() const;      // "5-bedroom/pipeline/1"
  std::string folder() const;   // of its files, within runs/: "5-bedroom.pipeline.1"; the id by which it is rated
  double seconds_in_all() const;
  std::optional<double> rating() const;  // their mean
};

struct ExperimentOutcome {
  std::vector<RunRecord> records;    // by scene, method and repeat, in the suite's order
  std::vector<std::string> skipped;  // methods that were not run, with the reason
  std::size_t kept = 0;              // runs that were there already
  std::size_t unknown_ratings = 0;   // of rooms that are not here
  std::string no_pictures;           // why there are none although they were asked for
};

// Writes into `folder`: runs/SCENE.METHOD.REPEAT/ (layout.json, and scene.png, scene-overlay.png where pictures are asked for),
// results.jsonl, results.csv, report.html.
// Errors: kUsage (an unknown method), kIo, kInterrupted (what is done is kept), those of asking a vision model.
Result<ExperimentOutcome> run_experiment(const Suite& suite, const Catalog& catalog, const std::filesystem::path& folder,
                                         const ExperimentOptions& options);

// The report. Pictures are those in `folder`, which may be empty for none.
std::string experiment_html(const Suite& suite, const ExperimentOutcome& outcome, const ExperimentOptions& options,
                            const std::filesystem::path& folder = {});
// One line for each method: share of rooms with everything met, and so on.
std::string experiment_text(const ExperimentOutcome& outcome);

}  // namespace layoutbox::experiment
