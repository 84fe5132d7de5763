// Habits of the room as a whole: things spread over it, a class before its board.
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {

// What stands on the floor is spread over the room: the middle of all, each by its area, is near the room's.
void Habits::spread() {
  constexpr int kSpread = 80;             // points a metre
  constexpr std::int64_t kUnit = 10'000;  // mm²
  constexpr int kFewest = 5;
  Linear off[2];
  std::int64_t all = 0;
  int things = 0;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const Item& item = model_.items[i];
    if (item.is_opening() || item.thin || item.mount != Mount::kFloor) continue;
    const std::int64_t area = std::max<std::int64_t>(1, area_of(item) / kUnit);
    for (const int axis : {0, 1})
      off[axis] = off[axis] + static_cast<std::int32_t>(area) * (mid2(static_cast<int>(i), axis) - room_mid2(model_, axis));
    all += area, ++things;
  }
  if (things < kFewest) return;
  Formula f;
  Case& c = f.add();
  for (const int axis : {0, 1}) c.wish(off[axis], kSpread, static_cast<std::int32_t>(2 * all));
  Constraint& spread = model_.constraints.emplace_back();
  spread.name = "spread over the room";
  spread.firmness = Firmness::kSoft;
  spread.weight = kSpread;
  spread.formulas.push_back(std::move(f));
}

// Long things of a kind that look alike from both ends and of which the same is said (two benches on a rug) lie parallel.
void Habits::lie_alike(int item) {
  constexpr int kAlike = 150;  // points a metre
  const Item& self = model_.items[item];
  const Size& size = self.states[0].size;
  if (self.has_front || self.thin || 2 * std::max(size.width, size.depth) < 3 * std::min(size.width, size.depth)) return;
  const auto said_of = [&](int i) {
    std::vector<std::pair<RelationType, std::vector<std::string>>> said;
    for (const Relation& r : model_.scene->relations) {
      if (std::ranges::find(r.targets, model_.items[i].id) != r.targets.end()) said.emplace_back(r.type, r.references);
    }
    return said;
  };
  for (int other = 0; other < item; ++other) {
    if (model_.items[other].entry != self.entry || model_.items[other].fixed || said_of(other) != said_of(item)) continue;
    Formula f;
    for (const int axis : {0, 1})
      f.add().when(other, states_with_width_along(model_.items[other], axis)).when(item, states_with_width_along(self, axis));
    habit("lies alike", item, kAlike, std::move(f), {other});
    return;
  }
}

// A teacher's desk in a room whose seats or desks look at a board.
bool Habits::faces_a_class(int item) const {
  const Item& self = model_.items[item];
  return self.mount == Mount::kFloor && self.is(Trait::kDeskLike) && self.is(Trait::kOpenToRoom) &&
         used_sides(self) == std::vector<Side>{Side::kBack} && !placed_besides_facing(item) && board_of_room() >= 0;
}

// What hangs there for all to look at and is no television; -1: nothing.
int Habits::board_of_room() const {
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const Item& board = model_.items[i];
    if (board.mount == Mount::kWall && board.is(Trait::kScreen) && !board.is(Trait::kElseOnWall)) return static_cast<int>(i);
  }
  return -1;
}

// The teacher looks the way the board does, and stands on its side of the room.
void Habits::face_the_class(int item) {
  constexpr Mm kFromBoard = 1200;
  if (!faces_a_class(item)) return;
  const int board = board_of_room();
  Formula f;
  for_each_turn(model_.items[board], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction front = side_direction(model_.items[board], Side::kFront, turn);
    Case& c = f.add().when(board, states).when(item, model_.items[item].states_at(turn));
    c.wish(gap_towards(item, board, front) - Linear(kFromBoard), kFaces);
  });
  if (!f.cases.empty()) habit("faces the class", item, kFaces, std::move(f), {board});
}

}  // namespace layoutbox::placement
