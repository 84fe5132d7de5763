// What the service keeps over a restart: jobs and rooms, in one SQLite file.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "layoutbox/base/result.h"

namespace layoutbox::serve {

enum class JobState { kWaiting, kRunning, kDone, kFailed, kCancelled };
std::string_view name_of(JobState state);  // "waiting", "running", "done", "failed", "cancelled"

struct JobRecord {
  std::string id;             // 16 hexadecimal digits
  std::string kind, request;  // "render", the request's JSON
  JobState state = JobState::kWaiting;
  std::vector<std::string> files;  // in the job's folder
  std::string error;               // as write_error(), or empty
  std::string created;             // "2026-01-31T12:00:00Z"
};

struct RoomRecord {
  std::string id, name, prompt, created, layout;  // layout: JSON; empty in lists
};

// May be used from several threads. Everything is on the disk when a function returns (WAL). Errors: kIo.
class Store {
 public:
  // Opens or makes the file. Jobs that were running when the last service ended wait again.
  static Result<Store> open(const std::filesystem::path& file);
  Store(Store&&) noexcept;
  Store& operator=(Store&&) noexcept;
  ~Store();

  Status put_job(const JobRecord& job);
  Result<std::optional<JobRecord>> job(const std::string& id) const;
  // Waiting jobs, oldest first.
  Result<std::vector<JobRecord>> waiting_jobs() const;
  // Ids of ended jobs beyond the newest `keep`; their records are removed.
  Result<std::vector<std::string>> forget_old_jobs(int keep);

  Status put_room(const RoomRecord& room);
  Result<std::vector<RoomRecord>> rooms() const;  // newest first
  Result<std::optional<RoomRecord>> room(const std::string& id) const;
  Result<bool> remove_room(const std::string& id);

 private:
  struct State;
  explicit Store(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

// 16 hexadecimal digits that nobody can guess.
std::string new_id();
// Now, "2026-01-31T12:00:00Z".
std::string time_text();

}  // namespace layoutbox::serve
