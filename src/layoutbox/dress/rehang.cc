// What was asked for on a wall, and hangs where nobody sees it: behind a wardrobe, or on a wall that the picture leaves out.
#include "layoutbox/dress/rehang.h"

#include <algorithm>
#include <cmath>

namespace layoutbox::dressing {
namespace {

constexpr double kOffItsWall = 150;  // mm between what hangs and its wall, at most
constexpr double kInView = 500;      // mm before it in which nothing stands
constexpr double kBeside = 100;      // between two that hang side by side
constexpr double kOverWallTop = 20;
constexpr double kOverHead = 1500, kOverCurtains = 2280;
constexpr double kStrip = 300;  // what is lower is a strip

// Nothing says where it hangs but that it does so on a wall.
bool is_free_to_hang(const Dresser& dresser, const PlacedObject& object) {
  if (object.mount != Mount::kWall || !dresser.is_one_of(object, Dressings::builtin().rehung)) return false;
  return std::ranges::none_of(dresser.layout().relations, [&](const PlacedRelation& placed) {
    const Relation& relation = placed.relation;
    const auto names = [&](const std::vector<std::string>& ids) { return std::ranges::find(ids, object.id) != ids.end(); };
    const bool any_wall = relation.type == RelationType::kOnWall && relation.references.empty();
    return names(relation.references) || (names(relation.targets) && !any_wall);
  });
}

std::vector<Span> seen_along(const FreeRoom& room, const DressedWall& wall, const PlacedObject& object, double low) {
  const Span height{low, low + object.size.height};
  const Span whole{low < kOverCurtains ? std::min(low, kOverHead) : low, height.high};  // what hangs high leaves windows to their curtains
  return shared(room.free_along(wall, {0, double(object.size.depth)}, whole),
                room.free_along(wall, {0, kInView}, height, FreeRoom::Count::kThings));
}

bool is_in_view(const Dresser& dresser, const FreeRoom& others, const PlacedObject& object) {
  const DressedWall* wall = others.behind(object, kOffItsWall);
  if (wall == nullptr || !dresser.is_shown(*wall)) return wall == nullptr;
  const Span own = wall->along(box_round(object));
  return std::ranges::any_of(
      others.free_along(*wall, {0, kInView}, {object.position[2], object.position[2] + object.size.height}, FreeRoom::Count::kThings),
      [&](const Span& span) { return span.low <= own.low + 1 && span.high >= own.high - 1; });
}

// At that height on the longest stretch of the walls that the picture shows; of what it has the share that leaves room for as many as are
// to hang there.
bool hang_in_view(const Dresser& dresser, const FreeRoom& others, PlacedObject& object, double low, int as_many) {
  if (low + object.size.height > dresser.layout().room.height - kOverWallTop) return false;
  const DressedWall* best = nullptr;
  Span longest;
  for (const DressedWall& wall : others.walls()) {
    if (!dresser.is_shown(wall)) continue;
    for (const Span& span : seen_along(others, wall, object, low)) {
      if (span.length() > longest.length()) best = &wall, longest = span;
    }
  }
  const double needed = object.size.width + 2 * kBeside;
  if (best == nullptr || longest.length() < needed) return false;
  const int fit = std::clamp(static_cast<int>(longest.length() / needed), 1, as_many);
  const double middle = on_grid(longest.middle() - (fit - 1) * needed / 2);
  object.position = best->point(middle, object.size.depth / 2.0, low);
  object.rotation_deg = best->turn_deg, object.supported_by = best->wall->id;
  return true;
}

// Where it hung, else, of lights along a wall, above windows.
bool hang_in_view(const Dresser& dresser, const FreeRoom& others, PlacedObject& object, int as_many) {
  return hang_in_view(dresser, others, object, object.position[2], as_many) ||
         (object.size.height < kStrip && hang_in_view(dresser, others, object, kOverCurtains, as_many));
}

}  // namespace

std::size_t rehang(const Dresser& dresser, Layout& layout) {
  std::vector<std::size_t> hidden;
  for (std::size_t i = 0; i < layout.objects.size(); ++i) {
    if (!is_free_to_hang(dresser, layout.objects[i])) continue;
    if (!is_in_view(dresser, FreeRoom(layout, dresser.catalog(), layout.objects[i].id), layout.objects[i])) hidden.push_back(i);
  }
  std::size_t moved = 0;
  for (std::size_t k = 0; k < hidden.size(); ++k) {
    PlacedObject& object = layout.objects[hidden[k]];
    int alike = 0;
    for (std::size_t n = k; n < hidden.size(); ++n) alike += layout.objects[hidden[n]].category == object.category ? 1 : 0;
    moved += hang_in_view(dresser, FreeRoom(layout, dresser.catalog(), object.id), object, alike) ? 1 : 0;
  }
  return moved;
}

}  // namespace layoutbox::dressing
