// Long work: pictures, one Blender for all, with progress, cancelling, and a queue that a restart does not lose.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/serve/store.h"

namespace layoutbox::serve {

struct JobView {
  JobRecord record;
  double progress = 0;  // 0…1
  int version = 0;      // grows with each change, while the service runs
};

std::string write_job(const JobView& job);  // a Job of the OpenAPI document

struct JobCounts {
  int waiting = 0, running = 0, done = 0, failed = 0, cancelled = 0;  // the last three since the service began
};

class Jobs {
 public:
  // Work that an earlier service left waits and is begun. `folder` holds a folder of files for each job. Everything outlives it.
  Jobs(Store& store, const Catalog& catalog, std::filesystem::path folder, int longest_queue);
  ~Jobs();  // what runs is put back to wait
  Jobs(const Jobs&) = delete;
  Jobs& operator=(const Jobs&) = delete;

  // Errors: kTooLarge where too many wait, of all or of this client, kIo, those of the layout.
  Result<JobView> start(const nlohmann::json& request, const std::string& client);
  Result<std::optional<JobView>> find(const std::string& id) const;
  Result<std::optional<JobView>> cancel(const std::string& id);
  // Waits until the job is at another version than `seen`, or for `patience`.
  Result<std::optional<JobView>> wait(const std::string& id, int seen, std::chrono::milliseconds patience) const;
  // The file's bytes; nothing where the job has none of that name.
  std::optional<std::string> file(const std::string& id, const std::string& name) const;
  JobCounts counts() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace layoutbox::serve
