// Where all is after the steps: solved so that it follows the guide, pins exactly where they are said to be.
#pragma once

#include "layoutbox/edit/state.h"

namespace layoutbox {

class EditPlacer {
 public:
  // REQUIRES: all outlive it.
  EditPlacer(const EditState& state, const Layout& before, const Catalog& catalog, SolveOptions solve);
  Result<Layout> place();
  // The scene as it was solved last, normalised.
  SceneGraph& scene() { return outcome_scene_; }
  // A relation that only keeps a turned thing looking where it was turned to; nobody asked for it.
  bool is_aid(const Relation& relation) const { return aids_.contains(relation.id); }

 private:
  // How an attempt differs from what is said: how much of a loose way is gone along x and y, how far what turns steps towards the middle
  // of the room, and whether it may step anywhere.
  struct Attempt {
    double share_x = 1, share_y = 1, step_in = 0;
    bool turn_free = false;
  };

  std::array<double, 2> middle() const;
  std::array<double, 3> position_of(const EditPin& pin, const Attempt& attempt) const;
  Result<Layout> solve_with(const Attempt& attempt);
  Status check_pins(const Layout& layout) const;
  bool something_moved(const Attempt& attempt) const;

  const EditState& state_;
  const Layout& before_;
  const Catalog& catalog_;
  SolveOptions solve_;
  SceneGraph outcome_scene_;
  std::set<std::string> aids_;  // ids of relations
};

}  // namespace layoutbox
