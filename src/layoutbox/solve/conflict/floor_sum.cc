#include "layoutbox/solve/conflict/floor_sum.h"

#include <algorithm>
#include <limits>

namespace layoutbox::placement {
namespace {

// Slanted walls and all.
std::int64_t room_area(const PlacementModel& model) {
  std::int64_t twice = 0;
  const std::vector<Point>& polygon = model.scene->room.polygon;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    twice += std::int64_t{a.x} * b.y - std::int64_t{b.x} * a.y;
  }
  return (std::abs(twice) + 1) / 2;
}

// Of doors that fit into the room.
void add_widest_door(const PlacementModel& model, const Scope& scope, FloorSum& sum) {
  const Mm longest = std::min(model.room.extent(0), model.room.extent(1));
  for (const ItemId i : model.items.ids()) {
    const Item& item = model.items[i];
    if (!item.is_opening() || item.opening->type == OpeningType::kWindow || item.opening->sill > 0) continue;
    if (item.states.empty() || item.states[0].clear.empty() || scope.gives_up(item.clearance_constraint)) continue;
    const std::int64_t clear = floor_area(item.states[0].clear[0]);
    if (item.opening->width <= longest && clear > sum.before_door) sum.before_door = clear, sum.door = i;
  }
}

}  // namespace

bool covers_floor(const Item& item) {
  return !item.is_opening() && !item.thin && !item.states.empty() && item.supports.size() == 1 &&
         item.supports[0].kind == SupportOption::Kind::kFloor;
}

std::int64_t least_area(const Item& item) {
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (const State& state : item.states) least = std::min(least, std::int64_t{state.size.width} * state.size.depth);
  return least;
}

FloorSum floor_sum(const PlacementModel& model, const Scope& scope) {
  FloorSum sum;
  sum.room = room_area(model);
  add_widest_door(model, scope, sum);
  for (const ItemId i : model.items.ids()) {
    const Item& item = model.items[i];
    if (scope.leaves_out(i) || !covers_floor(item)) continue;
    sum.items.push_back(i);
    sum.covered += least_area(item);
  }
  return sum;
}

}  // namespace layoutbox::placement
