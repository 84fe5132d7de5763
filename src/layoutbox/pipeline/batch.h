// Many rooms: each line of a batch generated into a folder of its own, a few at a time, and only what is not there yet.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "layoutbox/pipeline/batch_input.h"
#include "layoutbox/pipeline/generate.h"

namespace layoutbox {

enum class BatchState {
  kDone,        // as asked
  kNotAsAsked,  // there is a room, but a hard relation was given up or a check failed
  kFailed,      // no room, or no picture of it; `error` says why
  kNotStarted,  // the batch was stopped before
};
std::string_view name_of(BatchState state);  // "done", "notAsAsked", "failed", "notStarted"

struct BatchItem {
  std::string id;
  std::size_t line = 1;
  BatchState state = BatchState::kNotStarted;
  bool kept = false;   // made by an earlier run, from the same prompt, options and version
  double seconds = 0;  // this time; 0 where it was kept
  std::optional<Error> error;
};

struct BatchOptions {
  GenerateOptions generate;  // its `stop` ends the batch; rooms that are finished stay
  int jobs = 1;              // rooms at a time. REQUIRES: 1…256. The rooms do not depend on it.
  bool force = false;        // also make again what is there
  // Called as each item ends, by one thread at a time; may be empty.
  std::function<void(const BatchItem&, std::size_t ended, std::size_t all)> on_item;
};

struct BatchOutcome {
  std::vector<BatchItem> items;  // in the order of the lines
  double seconds = 0;
  bool stopped = false;
  std::size_t count(BatchState state) const;
  std::size_t kept() const;
};

// Makes DIR/ID/… for every line, and DIR/summary.json. A room is made in a hidden folder and moved to its place when it is whole, so
// that a run that is killed leaves none half-written; what such a run left is removed by the next one. A line that fails stops
// no other; its folder holds what there is and run.json with the reason. All pictures are drawn by one Blender at a time.
// Errors: kIo (the folder cannot be written, or another batch is at work in it).
Result<BatchOutcome> run_batch(const std::vector<BatchLine>& lines, const Planner& planner, const Catalog& catalog,
                               const std::filesystem::path& folder, const BatchOptions& options);

// The options of one line: those of the whole batch with its own.
GenerateOptions options_of(const BatchLine& line, GenerateOptions all);

// summary.json: counts, times, and every item.
std::string write_batch_summary(const BatchOutcome& outcome);

}  // namespace layoutbox
