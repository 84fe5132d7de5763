// One edit at work: a scene that changes step by step, and a layout that guides the solver to the places. Its functions stand in
// edit.cc (the order), edit_steps.cc and edit_exchange.cc (what becomes of things), edit_room.cc and edit_openings.cc (of the room, its
// doors and windows) and edit_places.cc (where all then is).
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "layoutbox/pipeline/edit.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox {

class Edit {
 public:
  // REQUIRES: layout and catalog outlive it.
  Edit(const Layout& before, const Catalog& catalog, SolveOptions solve);
  Result<EditOutcome> run(std::string_view text);

 private:
  using Ids = std::vector<std::string>;

  // A thing that is put exactly somewhere.
  struct Pin {
    std::string id;
    std::array<double, 3> from{}, way{};
    double rotation = 0;
    bool loose = false;     // a shorter way will do
    bool may_move = false;  // turned on the spot, or else beside it
  };

  // How an attempt differs from what is said: how much of a loose way is gone along x and y, how far what turns steps towards the middle
  // of the room, and whether it may step anywhere.
  struct Attempt {
    double share_x = 1, share_y = 1, step_in = 0;
    bool turn_free = false;
  };

  SceneObject* object(const std::string& id);
  PlacedObject* guide(const std::string& id);
  std::string before_support(const std::string& id) const;

  void soften(Relation& relation);
  // What was asked for of a thing's place holds on as a wish.
  template <class Which>
  void soften_targets(const std::string& id, const Which& which) {
    for (Relation& relation : scene_.relations) {
      if (std::find(relation.targets.begin(), relation.targets.end(), id) != relation.targets.end() && which(relation.type))
        soften(relation);
    }
  }
  void remove_support(const std::string& id);

  Status apply(const EditStep& step);
  Status add(const EditStep& step);
  Status remove(const Ids& ids);
  Status move(const EditStep& step);
  void stand_beside(SceneObject& moved, const std::vector<Relation>& relations);
  Status face(const EditStep& step);
  Status shift(const EditStep& step);
  Status turn(const EditStep& step);
  Status swap(const std::string& a, const std::string& b);
  Status replace(const EditStep& step);
  Status resize(const EditStep& step);
  Status recolor(const EditStep& step);

  Opening* opening(const std::string& id);
  bool is_of_room(const EditStep& step);
  Status apply_to_room(const EditStep& step);
  std::optional<Mm> free_offset(const Opening& opening, const Wall& wall, Mm wanted) const;
  std::optional<Mm> offset_least_in_the_way(const Opening& opening, const Wall& wall) const;
  Status put(Opening fresh, const EditOpeningPlace& place);
  void soften_about_opening(const std::string& id);
  void settle_opening(Opening changed);
  Status shift_opening(const std::string& id, const EditShift& shift);
  Status swap_openings(const std::string& a, const std::string& b);
  Status resize_opening(const std::string& id, const EditResize& resize);
  Status resize_room(const EditResize& resize);
  Status move_far_wall(int axis, Mm far, Mm by);

  void remove_what_stood_on_it();
  void drop_relations_of_what_is_gone();
  void number_relations();

  std::array<double, 2> middle() const;
  std::array<double, 3> position_of(const Pin& pin, const Attempt& attempt) const;
  Result<Layout> solve_with(const Attempt& attempt);
  Status check_pins(const Layout& layout) const;
  bool something_moved(const Attempt& attempt) const;
  Result<Layout> place();
  void settle(EditOutcome& outcome);

  const Layout& before_;
  const Catalog& catalog_;
  SolveOptions solve_;
  SceneGraph scene_, outcome_scene_;
  Layout guide_;
  std::vector<Pin> pins_;
  std::set<std::string> asked_, softened_;
  std::vector<Relation> dropped_;
};

inline bool has_id(const std::vector<std::string>& ids, const std::string& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

inline bool is_support(RelationType type) { return traits_of(type).supports; }

inline bool is_turn(RelationType type) {
  return type == RelationType::kFacing || type == RelationType::kParallel || type == RelationType::kPerpendicular ||
         type == RelationType::kSameOrientation;
}

// Says where its targets are, and not only which way they look or what stays free.
inline bool says_where(RelationType type) {
  return !is_turn(type) && type != RelationType::kClearance && type != RelationType::kReachable && type != RelationType::kKeepClear &&
         type != RelationType::kNotBlocking;
}

// What a factor or a length makes of one side, on the grid.
inline Mm side_after(Mm before, const EditResize::Side& side) {
  return side.exact ? *side.exact : static_cast<Mm>(std::lround(before * side.factor / kGridMm) * kGridMm) + side.more;
}

inline std::string in_metres(Mm length) { return fmt::format("{:.2f} m", m_from_mm(length)); }

}  // namespace layoutbox
