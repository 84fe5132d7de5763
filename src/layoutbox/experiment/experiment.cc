#include "layoutbox/experiment/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <numeric>
#include <thread>

#include "layoutbox/base/files.h"
#include "layoutbox/experiment/records.h"
#include "layoutbox/scene/json_text.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox::experiment {
namespace {

namespace fs = std::filesystem;

// A method, and the model that it asks; a name of its own where there are several models.
struct Contender {
  std::string name;
  const Method* method;
  ModelAtHand model;
};

struct ExperimentTask {
  const scoring::Annotation* scene;
  const Contender* contender;
  int repeat;
};

std::string safe_name(const std::string& id) {
  std::string name;
  for (const char c : id) name += (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '.') ? c : '_';
  return name.empty() || name[0] == '.' ? "_" + name : name;
}

void judge_record(RunRecord& record, const ExperimentTask& task, std::optional<Layout> layout, const Catalog& catalog) {
  Asked asked;
  asked.annotation = *task.scene;
  if (!layout) {
    record.judgement = judge_missing(record.key(), record.error.empty() ? "no room" : record.error, asked);
    return;
  }
  layout->prompt = task.scene->prompt;
  record.failure.clear();
  record.judgement = judge_room(RoomFile{record.key(), "layout", *std::move(layout), {}}, asked, catalog);
  for (const auto& [measure, words] : {std::pair{"COL", "collision"}, {"OOB", "out of bounds"}}) {
    const auto found = record.judgement.measures.find(measure);
    if (found == record.judgement.measures.end() || found->second.part <= 0) continue;
    record.failure += (record.failure.empty() ? "" : ", ") + std::string(words);
  }
}

class ExperimentRun {
 public:
  ExperimentRun(const Suite& suite, const Catalog& catalog, fs::path folder, const ExperimentOptions& options)
      : suite_(suite),
        catalog_(catalog),
        folder_(std::move(folder)),
        options_(options),
        pictures_(options.pictures, catalog, options.stop) {}

  Result<ExperimentOutcome> run() {
    LAYOUTBOX_CHECK(make_folder(folder_ / "runs"));
    LAYOUTBOX_CHECK(choose_methods());
    for (const scoring::Annotation& scene : suite_.scenes) {
      for (const Contender& contender : contenders_) {
        for (int repeat = 1; repeat <= options_.repeats; ++repeat) tasks_.push_back({&scene, &contender, repeat});
      }
    }
    outcome_.records.resize(tasks_.size());
    read_earlier();
    std::vector<std::thread> workers;
    for (int i = 1; i < options_.jobs; ++i) workers.emplace_back([this] { work(); });
    work();
    for (std::thread& worker : workers) worker.join();
    if (error_) return Failure(*error_);
    add_ratings();
    outcome_.no_pictures = pictures_.why_not();
    LAYOUTBOX_CHECK(write_results());
    return std::move(outcome_);
  }

 private:
  bool stopped() const { return options_.stop != nullptr && options_.stop->load(); }

  Status choose_methods() {
    std::vector<const Method*> chosen;
    for (const std::string& name : options_.methods) {
      const Method* method = find_method(name);
      if (method == nullptr) {
        std::string names;
        for (const Method& row : methods()) names += fmt::format("{}{}", names.empty() ? "" : ", ", row.name);
        return fail(ErrorCode::kUsage, fmt::format("there is no method \"{}\"", name), "--methods", "use some of " + names);
      }
      chosen.push_back(method);
    }
    if (options_.methods.empty()) {
      for (const Method& method : methods()) chosen.push_back(&method);
    }
    for (const Method* method : chosen) {
      const std::string name(method->name);
      if (!method->needs_model) contenders_.push_back({name, method, {}});
      if (method->needs_model && options_.models.empty()) outcome_.skipped.push_back(name + ": no model is at hand");
      for (const ModelAtHand& model : options_.models) {
        if (method->needs_model) contenders_.push_back({options_.models.size() > 1 ? name + "@" + model.name : name, method, model});
      }
    }
    return {};
  }

  // What an earlier run has done is judged again, which takes no time, and not made again.
  void read_earlier() {
    std::ifstream file(folder_ / "results.jsonl");
    std::string line;
    while (std::getline(file, line)) {
      const auto document = parse_json(line);
      if (!document || !document->is_object()) continue;  // the last line of a run that was stopped
      earlier_[document->value("key", "")] = *document;
    }
  }

  // False where there is none, or its room is gone.
  Result<bool> take_earlier(const ExperimentTask& task, RunRecord& record) {
    const auto found = earlier_.find(record.key());
    if (found == earlier_.end()) return false;
    read_line(found->second, record);
    std::optional<Layout> layout;
    if (record.outcome != "failed") {
      const auto text = read_file(room_folder(record) / "layout.json");
      auto read = text ? read_layout(*text) : Result<Layout>(Failure(text.error()));
      if (!read) return false;  // made again
      layout = *std::move(read);
    }
    judge_record(record, task, std::move(layout), catalog_);
    LAYOUTBOX_CHECK(look_at(record));
    return true;
  }

  fs::path room_folder(const RunRecord& record) const { return folder_ / "runs" / record.folder(); }

  Status look_at(RunRecord& record) {
    if (!record.judgement.error.empty()) return {};
    return pictures_.look_at(record.judgement.room.layout, record.key(), room_folder(record), record.picture);
  }

  void give_up(const Error& error) {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = error;
  }

  void work() {
    for (std::size_t i = next_++; i < tasks_.size() && !stopped(); i = next_++) {
      RunRecord& record = outcome_.records[i];
      record = {};
      record.scene = tasks_[i].scene->id, record.method = tasks_[i].contender->name, record.repeat = tasks_[i].repeat;
      const Result<bool> there = take_earlier(tasks_[i], record);
      if (!there) return give_up(there.error());
      if (!*there) {
        if (const Status made = make(tasks_[i], record); !made) return give_up(made.error());
      }
      const std::lock_guard lock(mutex_);
      outcome_.kept += *there;
      ++done_;
      if (options_.on_run) options_.on_run(done_, tasks_.size(), record.key());
    }
    if (stopped()) give_up({ErrorCode::kInterrupted, "stopped; what is done is kept", {}, "run the same command again to go on", {}});
  }

  Status make(const ExperimentTask& task, RunRecord& record) {
    const ModelAtHand& model = task.contender->model;
    MethodInput input{task.scene->prompt, static_cast<std::uint64_t>(task.repeat), model.planner, model.chat, options_.unsafe_scripts,
                      options_.generate};
    input.options.stop = input.options.solve.stop = input.options.plan.stop = options_.stop;
    auto result = task.contender->method->run(input, catalog_);
    if (!result && result.error().code == ErrorCode::kInterrupted) return Failure(result.error());
    std::optional<Layout> layout;
    if (result) {
      record.structure = result->structure;
      record.seconds = result->seconds;
      record.spent = spent_on(result->requests);
    }
    if (result && result->failure.empty()) {
      record.outcome = result->outcome;
      result->layout.prompt = task.scene->prompt;
      LAYOUTBOX_CHECK(make_folder(room_folder(record)));
      LAYOUTBOX_CHECK(write_file(room_folder(record) / "layout.json", write_layout(result->layout)));
      layout = std::move(result->layout);
    } else {
      record.outcome = "failed";
      record.error = result ? result->error : result.error().message;
      record.failure = result ? result->failure : "other";
    }
    judge_record(record, task, std::move(layout), catalog_);
    LAYOUTBOX_CHECK(look_at(record));
    const std::lock_guard lock(mutex_);
    std::ofstream file(folder_ / "results.jsonl", std::ios::app);
    file << line_of(record);
    if (!file.flush()) return fail(ErrorCode::kIo, "results.jsonl cannot be written", (folder_ / "results.jsonl").string());
    return {};
  }

  void add_ratings() {
    for (const Rating& rating : options_.ratings) {
      const auto room = std::find_if(outcome_.records.begin(), outcome_.records.end(),
                                     [&](const RunRecord& record) { return record.folder() == rating.room; });
      if (room == outcome_.records.end()) {
        ++outcome_.unknown_ratings;
      } else {
        room->ratings.push_back(rating.score);
      }
    }
  }

  // In the suite's order, whoever was ready first.
  Status write_results() {
    std::string lines;
    for (const RunRecord& record : outcome_.records) lines += line_of(record);
    LAYOUTBOX_CHECK(write_file(folder_ / "results.jsonl", lines));
    LAYOUTBOX_CHECK(write_file(folder_ / "results.csv", results_csv(outcome_)));
    return write_file(folder_ / "report.html", experiment_html(suite_, outcome_, options_, folder_));
  }

  const Suite& suite_;
  const Catalog& catalog_;
  fs::path folder_;
  const ExperimentOptions& options_;
  std::vector<Contender> contenders_;
  std::vector<ExperimentTask> tasks_;
  std::map<std::string, nlohmann::json> earlier_;
  std::mutex mutex_;
  std::atomic<std::size_t> next_{0};
  std::size_t done_ = 0;
  std::optional<Error> error_;
  ExperimentOutcome outcome_;
  Pictures pictures_;
};

}  // namespace

std::string RunRecord::key() const { return fmt::format("{}/{}/{}", scene, method, repeat); }

std::string RunRecord::folder() const { return fmt::format("{}.{}.{}", safe_name(scene), safe_name(method), repeat); }

double RunRecord::seconds_in_all() const {
  double total = 0;
  for (const auto& [stage, time] : seconds) total += time;
  return total;
}

std::optional<double> RunRecord::rating() const {
  if (ratings.empty()) return std::nullopt;
  return std::accumulate(ratings.begin(), ratings.end(), 0.0) / static_cast<double>(ratings.size());
}

Result<ExperimentOutcome> run_experiment(const Suite& suite, const Catalog& catalog, const fs::path& folder,
                                         const ExperimentOptions& options) {
  return ExperimentRun(suite, catalog, folder, options).run();
}

}  // namespace layoutbox::experiment
