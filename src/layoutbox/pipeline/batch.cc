#include "layoutbox/pipeline/batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "layoutbox/base/files.h"
#include "layoutbox/pipeline/folder_lock.h"
#include "layoutbox/pipeline/run_record.h"

#include <fcntl.h>
#include <unistd.h>

namespace layoutbox {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// Rooms in the making; a batch that was killed leaves it, the next one removes it.
constexpr const char* kWorkshop = ".layoutbox-batch";

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

Failure io_failure(const char* what, const fs::path& path, int reason) {
  return fail(ErrorCode::kIo, fmt::format("cannot {}: {}", what, std::strerror(reason)), path.string());
}

// Puts `made` in the place of `target`, at once where there was something before.
Status put_in_place(const fs::path& made, const fs::path& target) {
  if (::renameat2(AT_FDCWD, made.c_str(), AT_FDCWD, target.c_str(), RENAME_NOREPLACE) == 0) return {};
  if (errno == EEXIST && ::renameat2(AT_FDCWD, made.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) == 0) return {};
  if (errno != EINVAL && errno != ENOSYS) return io_failure("put the room in its place", target, errno);
  std::error_code error;  // a file system that cannot exchange
  const fs::path old = made.string() + ".old";
  fs::rename(target, old, error);
  error.clear();
  fs::rename(made, target, error);
  if (error) return io_failure("put the room in its place", target, error.value());
  return {};
}

// A folder that holds more than what a run writes is somebody's: it is not replaced.
Status check_replaceable(const fs::path& target) {
  std::error_code error;
  if (!fs::exists(target, error)) return {};
  for (const fs::directory_entry& entry : fs::directory_iterator(target, error)) {
    if (is_output_name(entry.path().filename().string())) continue;
    return fail(ErrorCode::kIo, fmt::format("the folder also holds {}, which is not of a room", entry.path().filename().string()),
                target.string(), "move it elsewhere, or choose another id or another folder with -o");
  }
  if (error) return io_failure("replace it", target, error.value());
  return {};
}

class Batch {
 public:
  Batch(const std::vector<BatchLine>& lines, const Planner& planner, const Catalog& catalog, fs::path folder, const BatchOptions& options)
      : lines_(lines), planner_(planner), catalog_(catalog), folder_(std::move(folder)), options_(options) {
    outcome_.items.resize(lines_.size());
    options_.generate.draw = [this, draw = options.generate.draw](const fs::path& script, const fs::path& into, const RenderOptions& how) {
      return draw_alone(draw, script, into, how);
    };
  }

  Result<BatchOutcome> operator()() {
    const Clock::time_point start = Clock::now();
    LAYOUTBOX_CHECK(make_folder(folder_));
    LAYOUTBOX_ASSIGN(const FolderLock lock, FolderLock::acquire(folder_));
    clean();
    LAYOUTBOX_CHECK(make_folder(workshop()));
    std::vector<std::thread> others;
    const auto wanted = static_cast<std::size_t>(std::max(options_.jobs, 1));
    for (std::size_t i = 1; i < std::min(wanted, lines_.size()); ++i) others.emplace_back([this] { work(); });
    work();
    for (std::thread& other : others) other.join();
    clean();
    outcome_.stopped = stopped();
    outcome_.seconds = seconds_since(start);
    LAYOUTBOX_CHECK(write_file(folder_ / "summary.json", write_batch_summary(outcome_)));
    return std::move(outcome_);
  }

 private:
  fs::path workshop() const { return folder_ / kWorkshop; }
  bool stopped() const { return options_.generate.stop && options_.generate.stop->load(); }

  void clean() const {
    std::error_code ignored;
    fs::remove_all(workshop(), ignored);
  }

  // Takes lines until none is left.
  void work() {
    for (std::size_t i = next_++; i < lines_.size(); i = next_++) {
      BatchItem& item = outcome_.items[i];
      item.id = lines_[i].id;
      item.line = lines_[i].line;
      if (stopped()) continue;
      make(lines_[i], item);
      if (item.state == BatchState::kNotStarted) continue;
      const std::lock_guard guard(telling_);
      ++ended_;
      if (options_.on_item) options_.on_item(item, ended_, lines_.size());
    }
  }

  void make(const BatchLine& line, BatchItem& item) {
    const Clock::time_point start = Clock::now();
    if (line.error) {
      item.error = line.error;
      item.state = BatchState::kFailed;
      return;
    }
    const GenerateOptions options = options_of(line, options_.generate);
    const fs::path target = folder_ / line.id;
    if (!options_.force && adopt(line, options, target, item)) return;
    const fs::path made = workshop() / line.id;
    Status done = check_replaceable(target);
    if (done) done = generate_room(line, options, made, item);
    if (done) done = put_in_place(made, target);
    std::error_code ignored;
    fs::remove_all(made, ignored);  // of a room that failed, or what was there before
    item.seconds = seconds_since(start);
    if (done) return;
    if (done.error().code == ErrorCode::kInterrupted) {
      item.state = BatchState::kNotStarted;
      return;
    }
    item.state = BatchState::kFailed;
    item.error = done.error();
  }

  // Generates into `made`. A room that fails is no error here, as long as its folder holds the record of it.
  Status generate_room(const BatchLine& line, const GenerateOptions& options, const fs::path& made, BatchItem& item) const {
    const auto outcome = generate(line.prompt, planner_, catalog_, made, options);
    if (outcome) {
      item.state = outcome->picture_error ? BatchState::kFailed : as_asked(*outcome) ? BatchState::kDone : BatchState::kNotAsAsked;
      item.error = outcome->picture_error;
      return {};
    }
    const Error& error = outcome.error();
    if (error.code == ErrorCode::kInterrupted) return Failure(error);
    item.state = BatchState::kFailed;
    item.error = error;
    std::error_code ignored;
    if (fs::exists(made / "run.json", ignored)) return {};
    LAYOUTBOX_CHECK(make_folder(made));  // a prompt that says nothing touches no folder
    return write_file(made / "run.json", write_run_record(line.prompt, options, {}, &error));
  }

  // Is what an earlier run made just what is asked for now?
  static bool adopt(const BatchLine& line, const GenerateOptions& options, const fs::path& target, BatchItem& item) {
    const auto record = read_file(target / "run.json");
    if (!record) return false;
    const auto state = state_of_same_run(*record, line.prompt, options);
    if (!state) return false;
    item.state = *state == RunState::kDone ? BatchState::kDone : BatchState::kNotAsAsked;
    item.kept = true;
    return true;
  }

  // One picture at a time: each takes all cores as it is.
  Result<RenderOutputs> draw_alone(const DrawPictures& draw, const fs::path& script, const fs::path& into, const RenderOptions& how) {
    const std::lock_guard guard(drawing_);
    if (stopped()) return fail(ErrorCode::kInterrupted, "stopped");
    if (draw) return draw(script, into, how);
    if (!blender_) blender_ = find_blender().map([](Blender found) { return BlenderServer(std::move(found)); });
    if (!*blender_) return Failure(blender_->error());
    return (*blender_)->render(script, into, how);
  }

  const std::vector<BatchLine>& lines_;
  const Planner& planner_;
  const Catalog& catalog_;
  fs::path folder_;
  BatchOptions options_;
  std::atomic<std::size_t> next_{0};
  std::mutex telling_, drawing_;
  std::optional<Result<BlenderServer>> blender_;  // one for all rooms, from the first picture on
  std::size_t ended_ = 0;
  BatchOutcome outcome_;
};

}  // namespace

std::string_view name_of(BatchState state) {
  switch (state) {
    case BatchState::kDone: return "done";
    case BatchState::kNotAsAsked: return "notAsAsked";
    case BatchState::kFailed: return "failed";
    case BatchState::kNotStarted: return "notStarted";
  }
  return "failed";
}

GenerateOptions options_of(const BatchLine& line, GenerateOptions all) {
  if (line.room_size) all.normalize.room_size = *line.room_size;
  if (line.seed) all.solve.seed = *line.seed;
  if (line.effort) all.solve.effort = *line.effort;
  return all;
}

std::size_t BatchOutcome::count(BatchState state) const {
  return static_cast<std::size_t>(std::count_if(items.begin(), items.end(), [&](const BatchItem& item) { return item.state == state; }));
}

std::size_t BatchOutcome::kept() const {
  return static_cast<std::size_t>(std::count_if(items.begin(), items.end(), [](const BatchItem& item) { return item.kept; }));
}

Result<BatchOutcome> run_batch(const std::vector<BatchLine>& lines, const Planner& planner, const Catalog& catalog, const fs::path& folder,
                               const BatchOptions& options) {
  return Batch(lines, planner, catalog, folder, options)();
}

std::string write_batch_summary(const BatchOutcome& outcome) {
  using Json = nlohmann::ordered_json;
  const std::size_t made = outcome.count(BatchState::kDone) + outcome.count(BatchState::kNotAsAsked) - outcome.kept();
  Json json{{"format", "layoutbox/batch@1"},
            {"rooms", outcome.items.size()},
            {"done", outcome.count(BatchState::kDone)},
            {"notAsAsked", outcome.count(BatchState::kNotAsAsked)},
            {"failed", outcome.count(BatchState::kFailed)},
            {"notStarted", outcome.count(BatchState::kNotStarted)},
            {"kept", outcome.kept()},
            {"stopped", outcome.stopped},
            {"seconds", outcome.seconds},
            {"roomsPerSecond", outcome.seconds > 0 ? static_cast<double>(made) / outcome.seconds : 0.0}};
  json["items"] = Json::array();
  for (const BatchItem& item : outcome.items) {
    Json entry{{"id", item.id}, {"line", item.line}, {"state", name_of(item.state)}, {"kept", item.kept}, {"seconds", item.seconds}};
    if (item.error) entry["error"] = json_of_error(*item.error);
    json["items"].push_back(std::move(entry));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace layoutbox
