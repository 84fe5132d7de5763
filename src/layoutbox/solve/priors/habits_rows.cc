// What a formation stands before, and the floor that it leaves for that and for those who sit there.
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kStageDepth = 1600;    // left before a crowd for what it looks at and who stands there
constexpr Mm kClearOfCrowd = 1000;  // free before the first row, between it and what all look at

}  // namespace

// Where guests or customers are served, which nobody placed; -1: nowhere.
int Habits::counter_of_room() const {
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const Item& bar = model_.items[i];
    const bool served_over = bar.is(Trait::kCounter) && bar.is(Trait::kOpenToRoom) && bar.has_front && bar.mount == Mount::kFloor;
    if (served_over && used_sides(bar).size() < 4 && !placed_besides_facing(static_cast<int>(i))) return static_cast<int>(i);
  }
  return -1;
}

// The reception desk that these seats wait before, where nothing says what they look at; -1: none.
int Habits::desk_waited_at(const Group& group) const {
  const int first = group.members[0];
  if (!model_.items[first].is_seat || !model_.items[first].has_front || told_where_to_look(first)) return -1;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const int desk = static_cast<int>(i);
    if (!model_.items[i].is_opening() && model_.items[i].mount == Mount::kFloor && is_served_over(desk) && waits_for(first, desk))
      return desk;
  }
  return -1;
}

// What a teacher's desk that nobody placed takes between the class and its board.
Mm Habits::teachers_depth() const {
  constexpr Mm kForTeacher = 900;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    if (faces_a_class(static_cast<int>(i))) return kForTeacher;
  }
  return 0;
}

// The floor behind each of them that its seat takes: all of that where words put it behind or before, else what is not tucked under.
Mm Habits::depth_of_seats(const Group& group) const {
  constexpr Mm kTucked = 200, kOffDesk = 50;
  const int first = group.members[0];
  const Item& desk = model_.items[first];
  if (!desk.has_front || desk.is_seat || !(has_knee_room(desk) || desk.is(Trait::kDeskLike))) return 0;
  Mm deepest = 0;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const int seat = static_cast<int>(i);
    const Item& chair = model_.items[i];
    if (chair.is_opening() || chair.mount != Mount::kFloor || !chair.is(Trait::kTableSeat)) continue;
    const bool told = std::ranges::any_of(group.members, [&](int desk_of_it) {
      return related_as_target(seat, desk_of_it, RelationType::kBehind) || related_as_target(seat, desk_of_it, RelationType::kInFrontOf);
    });
    const bool here = told ||
                      (!placed_besides_facing(seat) && std::ranges::any_of(usual_hosts(seat), [&](int host) { return host == first; })) ||
                      std::ranges::any_of(group.members, [&](int desk_of_it) { return related(seat, desk_of_it); });
    if (here) deepest = std::max(deepest, chair.states[0].size.depth - (told ? -kOffDesk : kTucked));
  }
  return deepest;
}

// Floor left free before the first row for what all look at and who stands there.
Mm Habits::depth_before(int first) const {
  Mm depth = kStageDepth + teachers_depth();
  for (const Relation* r : said_of(first)) {
    if (r->type != RelationType::kFacing || r->references.size() != 1) continue;
    const int faced = model_.find_item(r->references[0]);
    if (faced < 0 || model_.items[faced].is_opening() || model_.items[faced].mount != Mount::kFloor) continue;
    const Size& size = model_.items[faced].states[0].size;
    depth = std::max(depth, std::min(size.width, size.depth) + kClearOfCrowd);
  }
  return depth;
}

// How wide what each of them is told to look at is; 0: one looks for all, or nobody.
Mm Habits::view_of(const Group& group) const {
  constexpr Mm kEdge = 200;  // of it that nobody looks at
  int lookers = 0, seen = -1;
  for (const int member : group.members) {
    for (const Relation* r : said_of(member)) {
      if (r->type != RelationType::kFacing || r->references.size() != 1 || r->targets[0] != model_.items[member].id) continue;
      seen = model_.find_item(r->references[0]);
      ++lookers;
    }
  }
  return lookers < 2 || seen < 0 || model_.items[seen].is_opening() ? 0 : std::max(0, model_.items[seen].states[0].size.width - kEdge);
}

}  // namespace layoutbox::placement
