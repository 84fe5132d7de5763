// The loop between a planner and the solver: a scene that has no layout goes back with the reason and with ways out.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "layoutbox/pipeline/generate.h"
#include "layoutbox/plan/planner.h"

namespace layoutbox {

struct PlannedRoom {
  SceneGraph scene;  // normalised
  Layout layout;
};

class RepairLoop {
 public:
  // All must outlive it. REQUIRES: options.repair.max_attempts > 0.
  RepairLoop(Planning& planning, const Catalog& catalog, const GenerateOptions& options);

  // Asks until there is a layout that gives up nothing, or no more attempts; then what `options.solve.on_conflict` says.
  // Errors: those of the planner where it gave nothing usable; of solve().
  Result<PlannedRoom> run();

  // Once more, after a script or a picture failed. `failure`: what happened, a sentence without its full stop.
  Result<PlannedRoom> run_again(const std::string& failure);

  // Called with each scene before it is normalised; may be empty.
  std::function<void(SceneGraph&)> adjust;

  bool has_attempts_left() const { return attempts() < limits_.max_attempts; }
  int attempts() const { return planning_.attempts(); }

 private:
  struct Candidate {
    PlannedRoom room;
    std::string document;
    std::size_t given_up = 0;
  };

  Result<PlannedRoom> loop(std::optional<Feedback> feedback);
  // Is there a layout that gives up nothing? REQUIRES: the proposal is a scene.
  Result<ProposalOutcome> judge(Proposal proposal);
  Feedback conflict_feedback(const Candidate& candidate) const;
  Result<PlannedRoom> settle();

  Planning& planning_;
  const Catalog& catalog_;
  const GenerateOptions& options_;
  RepairOptions limits_;
  int repairs_ = 0;
  bool repeated_ = false;  // the last scene was the one before
  std::optional<Candidate> last_, best_;
  std::optional<Error> unsolved_;  // of a scene that has no layout whatever is given up
};

}  // namespace layoutbox
