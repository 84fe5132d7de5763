// One step of an edit at work on its state. Its functions stand in steps.cc (the order), things.cc and exchange.cc (what becomes of
// things), room.cc and openings.cc (of the room, its doors and windows).
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "layoutbox/edit/state.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox {

class EditStepper {
 public:
  // REQUIRES: all outlive it.
  EditStepper(EditState& state, const Layout& before, const Catalog& catalog)
      : before_(before),
        catalog_(catalog),
        scene_(state.scene),
        guide_(state.guide),
        pins_(state.pins),
        freed_(state.freed),
        locked_(state.locked),
        softened_(state.softened),
        dropped_(state.dropped) {}
  Status apply(const EditStep& step);
  void finish();
  void soften(Relation& relation);

 private:
  using Ids = std::vector<std::string>;

  SceneObject* object(const std::string& id);
  PlacedObject* guide(const std::string& id);
  std::string before_support(const std::string& id) const;

  // What was asked for of a thing's place holds on as a wish.
  template <class Which>
  void soften_targets(const std::string& id, const Which& which) {
    for (Relation& relation : scene_.relations) {
      if (std::find(relation.targets.begin(), relation.targets.end(), id) != relation.targets.end() && which(relation.type))
        soften(relation);
    }
  }
  void remove_support(const std::string& id);

  Status add(const EditStep& step);
  Status remove(const Ids& ids);
  Status move(const EditStep& step);
  void stand_beside(SceneObject& moved, const std::vector<Relation>& relations);
  Status face(const EditStep& step);
  Status shift(const EditStep& step);
  Status turn(const EditStep& step);
  Status swap(const std::string& a, const std::string& b);
  Status replace(const EditStep& step);
  void take_over(const std::string& old_id, SceneObject& fresh);
  bool keep_at_distance(const EditStep& step);
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
  Result<double> way_along(const Opening& opening, const Wall& wall, const EditShift& shift) const;
  Status shift_opening(const std::string& id, const EditShift& shift);
  Status swap_openings(const std::string& a, const std::string& b);
  Status resize_opening(const std::string& id, const EditResize& resize);
  Status resize_room(const EditResize& resize);
  Status move_far_wall(int axis, Mm far, Mm by);
  Status keep_openings(const Wall& wall, Mm by_at_start);
  void take_along(int axis, Mm far, Mm by);

  void remove_what_stood_on_it();
  void drop_relations_of_what_is_gone();
  void number_relations();

  const Layout& before_;
  const Catalog& catalog_;
  SceneGraph& scene_;
  Layout& guide_;
  std::vector<EditPin>& pins_;
  Ids &freed_, &locked_;
  std::set<std::string>& softened_;
  std::vector<Relation>& dropped_;
};

inline bool has_id(const std::vector<std::string>& ids, const std::string& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

inline bool is_support(RelationType type) { return traits_of(type).supports; }

inline bool is_turn(RelationType type) { return traits_of(type).turns; }

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
