// The loop between a model and the solver: a scene that has no layout goes back with the reason and with ways out.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "layoutbox/pipeline/generate.h"
#include "layoutbox/plan/llm/conversation.h"

namespace layoutbox {

struct PlannedRoom {
  SceneGraph scene;  // normalised
  Layout layout;
};

class RepairLoop {
 public:
  // All must outlive it. REQUIRES: options.repair.max_attempts > 0.
  RepairLoop(llm::Conversation& conversation, const Catalog& catalog, const GenerateOptions& options);

  // Asks until there is a layout that gives up nothing, or no more attempts; then what `options.solve.on_conflict` says.
  // Errors: those of the model where it gave nothing usable; of solve().
  Result<PlannedRoom> run();

  // Once more, after a script or a picture failed. `failure`: the error as the model hears it.
  Result<PlannedRoom> run_again(const std::string& failure);

  // Called with each scene before it is normalised; may be empty.
  std::function<void(SceneGraph&)> adjust;

  bool has_attempts_left() const { return attempts() < limits_.max_attempts; }
  int attempts() const { return static_cast<int>(conversation_.attempts().size()); }

 private:
  struct Candidate {
    PlannedRoom room;
    std::string document;
    std::size_t given_up = 0;
  };

  Result<PlannedRoom> loop(std::optional<llm::Complaint> complaint);
  Status pause() const;
  // True: this draft has a layout that gives up nothing.
  Result<bool> try_draft(llm::Draft draft, llm::Attempt& attempt);
  llm::Complaint conflict_complaint(const Candidate& candidate) const;
  Result<PlannedRoom> settle();

  llm::Conversation& conversation_;
  const Catalog& catalog_;
  const GenerateOptions& options_;
  RepairOptions limits_;
  int repairs_ = 0;
  std::optional<Candidate> last_, best_;
  std::optional<Error> unsolved_;  // of a scene that has no layout whatever is given up
  std::vector<Error> faults_;
};

// run.json's list of what was asked of a model: an object for each attempt.
std::string write_attempts(const std::vector<llm::Attempt>& attempts);

}  // namespace layoutbox
