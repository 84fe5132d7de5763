// How large a room is that nobody gave a size, by what stands in it.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>

#include "layoutbox/catalog/normalize_steps.h"
#include "layoutbox/catalog/size_words.h"
#include "layoutbox/catalog/trait_table.h"

namespace layoutbox {
namespace {

// Furniture that stands on the floor of a room whose size is ours to choose covers at most this share of it.
constexpr double kMostCovered = 0.36;
// The same with the free floor that the catalogue wants at its sides; neighbours may share some of that, those of a crowd less.
constexpr double kMostUsed = 0.68, kMostUsedByCrowd = 0.58, kMostCoveredByCrowd = 0.32;
// … and at least this share of an ordinary room's, down to so much of its area: few things are lost in a room for many.
constexpr double kLeastUsed = 0.38, kSmallestShare = 0.42, kSmallestArea = 12e6;  // mm²
constexpr Mm kForCar = 5600;                                                      // the longer side of a garage, though the car be outside
constexpr Point kGridWay{350, 850};                                               // free between the columns and rows of a grid

// Of the strips that the catalogue wants free at its sides, mm².
double wanted_floor(const CatalogEntry& entry, const Size& size) {
  double area = 0;
  for (const auto& [side, depth] : entry.clearance) {
    const bool long_side = side == Side::kFront || side == Side::kBack;
    area += double(long_side ? size.width : size.depth) * depth;
  }
  return area;
}

// A ward's beds, a cafe's tables, an audience: each wants its floor for itself.
bool holds_crowd(const NormalizeContext& context) {
  constexpr int kMany = 6, kManySeats = 20;
  std::map<std::string, int> of_kind;
  return std::ranges::any_of(context.scene.objects, [&](const SceneObject& object) {
    const CatalogEntry& entry = context.catalog.entry_or_nearest(object.category);
    return object.mount == Mount::kFloor && ++of_kind[entry.id] >= (entry.is(Trait::kSeat) ? kManySeats : kMany);
  });
}

std::set<std::string_view> ids_in_grids(const SceneGraph& scene) {
  std::set<std::string_view> ids;
  for (const Relation& r : scene.relations) {
    if (r.type == RelationType::kGrid) ids.insert(r.targets.begin(), r.targets.end());
  }
  return ids;
}

// Of which many are turned alike, as the desks of a class are; seats have their clearances.
std::set<std::string_view> kinds_in_classes(const SceneGraph& scene) {
  constexpr int kClass = 8;
  std::unordered_map<std::string_view, std::string_view> kinds;  // by id
  for (const SceneObject& object : scene.objects) kinds.emplace(object.id, object.category);
  std::unordered_map<std::string_view, int> turned_alike;
  std::set<std::string_view> in_classes;
  for (const Relation& r : scene.relations) {
    const auto kind = r.type == RelationType::kSameOrientation && r.targets.size() == 1 ? kinds.find(r.targets[0]) : kinds.end();
    if (kind != kinds.end() && ++turned_alike[kind->second] + 1 >= kClass) in_classes.insert(kind->second);
  }
  return in_classes;
}

// What is eaten at in numbers wants the floor round each table for who sits there and a way, however small the room is said to be; mm².
double floor_round_tables(const NormalizeContext& context) {
  constexpr Mm kRound = 1300;  // from table to table
  constexpr double kBesides = 1.45;
  constexpr int kMany = 6;
  std::map<std::string, std::pair<int, double>> of_kind;
  double floor = 0;
  for (const SceneObject& object : context.scene.objects) {
    const CatalogEntry& entry = context.catalog.entry_or_nearest(object.category);
    if (object.mount != Mount::kFloor || !object.size || !entry.is(Trait::kTable) || entry.has_front || entry.is(Trait::kCoffeeTable))
      continue;
    const Size& size = object.size->usual;
    auto& [count, wanted] = of_kind[entry.id];
    ++count, wanted += double(size.width + kRound) * (size.depth + kRound) * kBesides;
    if (count >= kMany) floor = std::max(floor, wanted);
  }
  return floor;
}

}  // namespace

double growth_for_furniture(const NormalizeContext& context, double area, double longest_side) {
  double covered = 0, used = 0, longest = 0;
  const std::set<std::string_view> in_grids = ids_in_grids(context.scene), in_classes = kinds_in_classes(context.scene);
  for (const SceneObject& object : context.scene.objects) {
    const CatalogEntry& entry = context.catalog.entry_or_nearest(object.category);
    if (object.mount != Mount::kFloor || !object.size || (entry.thin && !entry.lain_on)) continue;
    const Size& size = object.size->usual;
    covered += double(size.width) * size.depth;
    const bool in_rows = in_grids.contains(object.id) || in_classes.contains(object.category);
    used +=
        in_rows ? double(size.width + kGridWay.x) * (size.depth + kGridWay.y) : double(size.width) * size.depth + wanted_floor(entry, size);
    longest = std::max({longest, double(size.width), double(size.depth)});
  }
  const double factor = room_size_factor(context.scene.room.size_word);
  // A tiny room is smaller than an ordinary one for as little, and fuller.
  const bool may_shrink = (context.scene.room.size_word.empty() || factor < 1) && used > 0;
  const double least = may_shrink ? std::sqrt(std::clamp(used * factor / kLeastUsed / area,
                                                         std::min(1.0, std::max(kSmallestShare, factor * kSmallestArea / area)), 1.0))
                                  : 1.0;
  const bool crowd = holds_crowd(context);
  const RoomKind* kind = context.catalog.find_room(context.scene.room.type);
  const double for_car = kind != nullptr && !kind->door.empty() ? kForCar / longest_side : 0;
  return std::max({least, for_car, std::sqrt(floor_round_tables(context) / area),
                   std::sqrt(covered / (crowd ? kMostCoveredByCrowd : kMostCovered) / area),
                   std::sqrt(used / (crowd ? kMostUsedByCrowd : kMostUsed) / area), (longest + 600) / longest_side});
}

}  // namespace layoutbox
