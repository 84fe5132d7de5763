// Habits of the room as a whole: things spread over it, a class before its board.
#include "layoutbox/catalog/measures.h"
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
  for (const ItemId i : model_.items.ids()) {
    const Item& item = model_.items[i];
    if (item.is_opening() || item.thin || item.mount != Mount::kFloor) continue;
    const std::int64_t area = std::max<std::int64_t>(1, area_of(item) / kUnit);
    for (const int axis : {0, 1}) off[axis] = off[axis] + static_cast<std::int32_t>(area) * (mid2(i, axis) - room_mid2(model_, axis));
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

// What is said of a thing, whatever else of a kind it is said of.
std::vector<std::pair<RelationType, std::vector<std::string>>> Habits::words_of(ItemId item) const {
  std::vector<std::pair<RelationType, std::vector<std::string>>> words;
  for (const Relation* r : said_of(item)) {
    if (std::ranges::find(r->targets, model_.items[item].id) != r->targets.end()) words.emplace_back(r->type, r->references);
  }
  return words;
}

// Things of a kind of which the same is said and that have no front lie parallel where they are long (two benches on a rug), and in line
// where they stand along a wall or a window (tables for two).
void Habits::lie_alike(ItemId item) {
  constexpr int kAlike = 150;  // points a metre
  const Item& self = model_.items[item];
  const Size& size = self.states[0].size;
  if (self.has_front || self.thin || size.width == size.depth) return;
  const auto words = words_of(item);
  const bool in_line = std::ranges::any_of(words, [](const auto& said) { return traits_of(said.first).back_to_wall; });
  if (!in_line && 2 * std::max(size.width, size.depth) < 3 * std::min(size.width, size.depth)) return;
  for (const ItemId other : ids_before(item)) {
    if (model_.items[other].entry != self.entry || model_.items[other].fixed || words_of(other) != words) continue;
    Formula f;
    for (const int axis : {0, 1}) {
      for (int across = in_line ? 0 : 1; across < 2; ++across) {
        Case& c = f.add().when(other, states_with_width_along(model_.items[other], axis)).when(item, states_with_width_along(self, axis));
        if (in_line) c.wish(mid2(item, across) - mid2(other, across), kAlike, 2);
      }
    }
    habit("lies alike", item, kAlike, std::move(f), {other});
    return;
  }
}

// A teacher's desk in a room whose seats or desks look at a board; words say at most that it is by that.
bool Habits::faces_a_class(ItemId item) const {
  const Item& self = model_.items[item];
  const ItemId board = board_of_room();
  return self.mount == Mount::kFloor && self.is(Trait::kDeskLike) && self.is(Trait::kOpenToRoom) &&
         used_sides(self) == std::vector<Side>{Side::kBack} && board.exists() && only_placed_before(item, board);
}

// Do words place it nowhere, in a part of the room, or before or by that other alone?
bool Habits::only_placed_before(ItemId item, ItemId other) const {
  using R = RelationType;
  return std::ranges::none_of(said_of(item), [&](const Relation* r) {
    if (std::ranges::find(r->targets, model_.items[item].id) == r->targets.end()) return false;
    if (traits_of(r->type).turns || r->type == R::kInRegion) return false;
    const bool before = r->type == R::kInFrontOf || r->type == R::kNear || r->type == R::kCenteredOn;
    return !before || r->references.size() != 1 || r->references[0] != model_.items[other].id;
  });
}

// What hangs there for all to look at and is no television, if anything.
ItemId Habits::board_of_room() const {
  for (const ItemId i : model_.items.ids()) {
    const Item& board = model_.items[i];
    if (board.mount == Mount::kWall && board.is(Trait::kScreen) && !board.is(Trait::kElseOnWall)) return i;
  }
  return {};
}

// One comes in behind or beside a class, not between it and its board.
void Habits::enter_behind_class(ItemId door) {
  constexpr int kComesInBefore = 60;  // points a metre
  const ItemId board = board_of_room();
  if (!board.exists() || teachers_depth() == 0) return;
  Formula f;
  for_each_turn(model_.items[board], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction front = side_direction(model_.items[board], Side::kFront, turn);
    f.add().when(board, states).require(2 * gap_towards(door, board, front) - Linear(model_.room.extent(front.axis)));
  });
  if (!f.cases.empty()) habit("behind the class", door, kComesInBefore, std::move(f));
}

// A class looks at a wall without windows, the windows at its side.
void Habits::hang_on_blank_wall(ItemId board) {
  constexpr int kByWindow = 150;  // points a window
  Formula f;
  bool any = false;
  for (const RoomWall& wall : model_.walls) {
    if (!wall.straight) continue;
    const auto windows = std::ranges::count_if(model_.scene->room.openings, [&](const Opening& opening) {
      return opening.type == OpeningType::kWindow && opening.wall == wall.id;
    });
    any |= windows > 0;
    f.add().when(board, model_.items[board].states_at(wall.turn)).price = static_cast<int>(windows) * kByWindow;
  }
  if (any && !f.cases.empty()) habit("not by the windows", board, kByWindow, std::move(f));
}

// The teacher looks the way the board does, and stands on its side of the room.
void Habits::face_the_class(ItemId item) {
  if (!faces_a_class(item)) return;
  const ItemId board = board_of_room();
  Formula f;
  for_each_turn(model_.items[board], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction front = side_direction(model_.items[board], Side::kFront, turn);
    Case& c = f.add().when(board, states).when(item, model_.items[item].states_at(turn));
    c.wish(gap_towards(item, board, front) - Linear(measures().from_board), kFaces);
  });
  if (!f.cases.empty()) habit("faces the class", item, kFaces, std::move(f), {board});
}

}  // namespace layoutbox::placement
