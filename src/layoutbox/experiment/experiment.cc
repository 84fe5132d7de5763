#include "layoutbox/experiment/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <thread>

#include "layoutbox/base/files.h"
#include "layoutbox/base/words.h"
#include "layoutbox/scene/json_text.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox::experiment {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct Task {
  const scoring::Annotation* scene;
  const Method* method;
  int repeat;
};

std::string safe_name(const std::string& id) {
  std::string name;
  for (const char c : id) name += (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '.') ? c : '_';
  return name.empty() || name[0] == '.' ? "_" + name : name;
}

fs::path layout_path(const fs::path& folder, const RunRecord& record) {
  return folder / "runs" / safe_name(record.scene) / fmt::format("{}-{}.json", record.method, record.repeat);
}

// A line of results.jsonl.
std::string line_of(const RunRecord& record) {
  Json measures = Json::object(), seconds = Json::object();
  for (const auto& [name, tally] : record.judgement.measures) measures[name] = {tally.part, tally.whole};
  for (const auto& [stage, time] : record.seconds) seconds[stage] = std::round(time * 1e4) / 1e4;
  const Json line{{"key", record.key()},
                  {"scene", record.scene},
                  {"method", record.method},
                  {"repeat", record.repeat},
                  {"outcome", record.outcome},
                  {"error", record.error},
                  {"failure", record.failure},
                  {"structure", record.structure},
                  {"requests", record.requests},
                  {"objects", record.judgement.room.layout.objects.size()},
                  {"everything", record.judgement.everything},
                  {"measures", std::move(measures)},
                  {"seconds", std::move(seconds)}};
  return line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void judge_record(RunRecord& record, const Task& task, std::optional<Layout> layout, const Catalog& catalog) {
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

class Run {
 public:
  Run(const Suite& suite, const Catalog& catalog, fs::path folder, const ExperimentOptions& options)
      : suite_(suite), catalog_(catalog), folder_(std::move(folder)), options_(options) {}

  Result<ExperimentOutcome> run() {
    LAYOUTBOX_CHECK(make_folder(folder_ / "runs"));
    LAYOUTBOX_CHECK(choose_methods());
    for (const scoring::Annotation& scene : suite_.scenes) {
      for (const Method* method : methods_) {
        for (int repeat = 1; repeat <= options_.repeats; ++repeat) tasks_.push_back({&scene, method, repeat});
      }
    }
    outcome_.records.resize(tasks_.size());
    read_earlier();
    std::vector<std::thread> workers;
    for (int i = 1; i < options_.jobs; ++i) workers.emplace_back([this] { work(); });
    work();
    for (std::thread& worker : workers) worker.join();
    if (error_) return Failure(*error_);
    LAYOUTBOX_CHECK(write_results());
    return std::move(outcome_);
  }

 private:
  bool stopped() const { return options_.stop != nullptr && options_.stop->load(); }

  Status choose_methods() {
    for (const std::string& name : options_.methods) {
      const Method* method = find_method(name);
      if (method == nullptr) {
        std::string names;
        for (const Method& row : methods()) names += fmt::format("{}{}", names.empty() ? "" : ", ", row.name);
        return fail(ErrorCode::kUsage, fmt::format("there is no method \"{}\"", name), "--methods", "use some of " + names);
      }
      methods_.push_back(method);
    }
    if (options_.methods.empty()) {
      for (const Method& method : methods()) methods_.push_back(&method);
    }
    std::erase_if(methods_, [&](const Method* method) {
      if (!method->needs_model || options_.model != nullptr) return false;
      outcome_.skipped.push_back(fmt::format("{}: no model is at hand", method->name));
      return true;
    });
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

  bool take_earlier(const Task& task, RunRecord& record) {
    const auto found = earlier_.find(record.key());
    if (found == earlier_.end()) return false;
    const nlohmann::json& line = found->second;
    record.outcome = line.value("outcome", "");
    record.error = line.value("error", "");
    record.failure = line.value("failure", "");
    record.structure = line.value("structure", "");
    record.requests = line.value("requests", 0);
    record.seconds = line.value("seconds", std::map<std::string, double>{});
    std::optional<Layout> layout;
    if (record.outcome != "failed") {
      const auto text = read_file(layout_path(folder_, record));
      auto read = text ? read_layout(*text) : Result<Layout>(Failure(text.error()));
      if (!read) return false;  // made again
      layout = *std::move(read);
    }
    judge_record(record, task, std::move(layout), catalog_);
    return true;
  }

  void work() {
    for (std::size_t i = next_++; i < tasks_.size() && !stopped(); i = next_++) {
      RunRecord& record = outcome_.records[i];
      record.scene = tasks_[i].scene->id, record.method = tasks_[i].method->name, record.repeat = tasks_[i].repeat;
      if (take_earlier(tasks_[i], record)) {
        const std::lock_guard lock(mutex_);
        ++outcome_.kept;
      } else if (Status made = make(tasks_[i], record); !made) {
        const std::lock_guard lock(mutex_);
        if (!error_) error_ = made.error();
        return;
      }
      const std::lock_guard lock(mutex_);
      ++done_;
      if (options_.on_run) options_.on_run(done_, tasks_.size(), record.key());
    }
    if (stopped()) {
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = Error{ErrorCode::kInterrupted, "stopped; what is done is kept", {}, "run the same command again to go on", {}};
    }
  }

  Status make(const Task& task, RunRecord& record) {
    MethodInput input{task.scene->prompt, static_cast<std::uint64_t>(task.repeat), options_.model, options_.chat, options_.unsafe_scripts,
                      options_.generate};
    input.options.stop = input.options.solve.stop = input.options.plan.stop = options_.stop;
    auto result = task.method->run(input, catalog_);
    if (!result && result.error().code == ErrorCode::kInterrupted) return Failure(result.error());
    std::optional<Layout> layout;
    if (result) {
      record.structure = result->structure;
      record.seconds = result->seconds;
      record.requests = count_of(result->requests);
    }
    if (result && result->failure.empty()) {
      record.outcome = result->outcome;
      const fs::path path = layout_path(folder_, record);
      LAYOUTBOX_CHECK(make_folder(path.parent_path()));
      LAYOUTBOX_CHECK(write_file(path, write_layout(result->layout)));
      layout = std::move(result->layout);
    } else {
      record.outcome = "failed";
      record.error = result ? result->error : result.error().message;
      record.failure = result ? result->failure : "other";
    }
    judge_record(record, task, std::move(layout), catalog_);
    const std::lock_guard lock(mutex_);
    std::ofstream file(folder_ / "results.jsonl", std::ios::app);
    file << line_of(record);
    if (!file.flush()) return fail(ErrorCode::kIo, "results.jsonl cannot be written", (folder_ / "results.jsonl").string());
    return {};
  }

  static int count_of(const std::string& requests) {
    const auto list = parse_json(requests);
    return list && list->is_array() ? static_cast<int>(list->size()) : 0;
  }

  // In the suite's order, whoever was ready first.
  Status write_results() {
    std::string lines;
    for (const RunRecord& record : outcome_.records) lines += line_of(record);
    LAYOUTBOX_CHECK(write_file(folder_ / "results.jsonl", lines));
    LAYOUTBOX_CHECK(write_file(folder_ / "results.csv", results_csv(outcome_)));
    return write_file(folder_ / "report.html", experiment_html(suite_, outcome_, options_));
  }

  const Suite& suite_;
  const Catalog& catalog_;
  fs::path folder_;
  const ExperimentOptions& options_;
  std::vector<const Method*> methods_;
  std::vector<Task> tasks_;
  std::map<std::string, nlohmann::json> earlier_;
  std::mutex mutex_;
  std::atomic<std::size_t> next_{0};
  std::size_t done_ = 0;
  std::optional<Error> error_;
  ExperimentOutcome outcome_;
};

}  // namespace

std::string RunRecord::key() const { return fmt::format("{}/{}/{}", scene, method, repeat); }

Result<ExperimentOutcome> run_experiment(const Suite& suite, const Catalog& catalog, const fs::path& folder,
                                         const ExperimentOptions& options) {
  return Run(suite, catalog, folder, options).run();
}

}  // namespace layoutbox::experiment
