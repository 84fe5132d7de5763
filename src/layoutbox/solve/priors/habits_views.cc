// Habits of who looks at something: into a mirror, at a screen.
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {

std::uint64_t states_looking(const Item& item, Direction direction) {
  std::uint64_t looking = 0;
  for_each_turn(item, [&](int turn, std::uint64_t states) {
    if (turn % 90 == 0 && side_direction(item, Side::kFront, turn) == direction) looking |= states;
  });
  return looking;
}

// The mirror on the wall that a seat is told to look into, where nothing else says where it stands; -1: none.
int Habits::mirror_of(int item) const {
  const Item& self = model_.items[item];
  if ((!self.is(Trait::kSeat) && !self.is(Trait::kEasySeat)) || !self.has_front || placed_besides_facing(item)) return -1;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const bool mirror = model_.items[i].is(Trait::kMirror) && model_.items[i].mount == Mount::kWall;
    if (mirror && related_as_target(item, static_cast<int>(i), RelationType::kFacing)) return static_cast<int>(i);
  }
  return -1;
}

// Who is to look into a mirror sits before it, close enough to see.
void Habits::sit_before_mirror(int item) {
  constexpr Mm kOff = 500;
  const int mirror = mirror_of(item);
  if (mirror < 0) return;
  constexpr Mm kBetween = 450;
  std::vector<int> seats;  // who look into the same one sit side by side
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    if (!model_.items[i].is_opening() && mirror_of(static_cast<int>(i)) == mirror) seats.push_back(static_cast<int>(i));
  }
  const auto k = std::ranges::find(seats, item) - seats.begin(), n = std::ssize(seats);
  const Mm pitch = model_.items[item].states[0].size.width + kBetween;
  Formula f;
  for_each_turn(model_.items[mirror], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction front = side_direction(model_.items[mirror], Side::kFront, turn);
    Case& c = f.add().when(mirror, states).when(item, states_looking(model_.items[item], opposite(front)));
    c.wish(mid2(item, across(front)) - mid2(mirror, across(front)) - Linear((2 * k - (n - 1)) * pitch), kBeside, 2);
    c.wish(gap_towards(item, mirror, front) - Linear(kOff), kBeside);
  });
  habit("before its mirror", item, kBeside, std::move(f), {mirror});
}

// Is a screen all that there is for it to look at? Then it is watched from the wall, not drawn up to like a table.
bool Habits::only_sees_screen(int item) const {
  const std::vector<int> seen = items_of_kinds(model_.items[item].entry->faces, item);
  return !seen.empty() && std::ranges::all_of(seen, [&](int other) { return model_.items[other].is(Trait::kScreen); });
}

// A screen is watched from no farther than one sees it well.
void Habits::watch_from_near(int item, int screen) {
  constexpr Mm kFarthest = 3800;
  constexpr int kTooFar = 150;  // points a metre
  Formula f;
  for_each_turn(model_.items[item], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction front = side_direction(model_.items[item], Side::kFront, turn);
    f.add().when(item, states).require(Linear(kFarthest) - gap_towards(screen, item, front));
  });
  habit("near enough to see", item, kTooFar, std::move(f));
}

// Nobody watches over those who sit at table: high tables, chairs, beds and dividers are not between a sofa and its screen or fire.
void Habits::watch_past_tables(int item, int screen) {
  constexpr int kBetween = 250;  // points a metre
  constexpr Mm kHigh = 600;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const int other = static_cast<int>(i);
    const Item& table = model_.items[i];
    if (table.is_opening() || table.mount != Mount::kFloor || other == item || rests_on(screen, other) || related(item, other)) continue;
    const bool high = table.is(Trait::kTable) && table.states[0].size.height >= kHigh && !table.entry->back_to_wall;
    const bool seat = table.is(Trait::kEasySeat) && !placed_besides_facing(other);
    if (!high && !seat && !table.is(Trait::kBed) && divided_by(other) == nullptr) continue;
    Formula f;
    for_each_turn(model_.items[item], [&](int turn, std::uint64_t states) {
      if (turn % 90 != 0) return;
      const Direction front = side_direction(model_.items[item], Side::kFront, turn);
      for (const int sign : {1, -1}) f.add().when(item, states).require(gap_towards(other, item, {across(front), sign}));
      f.add().when(item, states).require(gap_towards(other, item, opposite(front)));
      f.add().when(item, states).require(gap_towards(other, screen, front));
    });
    habit("not before the screen", other, kBetween, std::move(f));
  }
}

}  // namespace layoutbox::placement
