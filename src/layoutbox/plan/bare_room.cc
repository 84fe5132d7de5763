#include <algorithm>
#include <span>

#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/growing_scene.h"
#include "layoutbox/plan/spoken.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox {
namespace {

// An L of seats is open before it.
double covered_by(const CatalogEntry& entry, const Size& size) {
  constexpr Mm kDepthOfSeats = 1000;
  const bool seats = entry.is(Trait::kCenterPiece) && !entry.is(Trait::kBed);
  return double(size.width) * (seats ? std::min(size.depth, kDepthOfSeats) : size.depth);
}

double covered_floor(const SceneGraph& scene, const Catalog& catalog) {
  double area = 0;
  for (const SceneObject& object : scene.objects) {
    const CatalogEntry& entry = catalog.entry_or_nearest(object.category);
    const Size& size = object.size ? object.size->usual : entry.size.usual;
    if (object.mount.value_or(entry.mount) == Mount::kFloor && !entry.thin) area += covered_by(entry, size);
  }
  return area;
}

}  // namespace

// What a bare room of that kind mostly has, the most important first.
void fill_bare_room(GrowingScene& scene, const Spoken& spoken, std::size_t named_count, const Catalog& catalog) {
  const Groups& groups = Groups::builtin();
  const auto named = [&] { return std::span(scene.graph().objects).first(named_count); };
  const RoomKind* kind = scene.graph().room.type.empty() ? nullptr : catalog.find_room(scene.graph().room.type);
  const double floor = std::max(1.0, double(doubled_area(scene.sized_room().polygon)) / 2);
  double share = covered_floor(scene.graph(), catalog) / floor;
  const bool hardly_any =
      std::ranges::count_if(named(), [&](const SceneObject& o) { return stands_on_floor(catalog, o); }) <= groups.fill.hardly_any;
  const double until = hardly_any ? groups.fill.usually_covered : groups.fill.until;
  if (kind == nullptr || share >= (hardly_any ? until : groups.fill.bare) || spoken.says_any(groups.none_to_fill)) return;
  constexpr std::ptrdiff_t kCrowd = 6;
  const std::ptrdiff_t crowd =
      std::ranges::count_if(named(), [&](const SceneObject& o) { return catalog.entry_or_nearest(o.category).is(Trait::kSeat); });
  const bool looked_at =
      std::ranges::any_of(named(), [&](const SceneObject& o) { return catalog.entry_or_nearest(o.category).is(Trait::kScreen); });
  int added = 0;
  for (const auto& [id, usual] : kind->usual) {
    const CatalogEntry* entry = catalog.find(id);
    if (entry == nullptr || spoken.of(*entry) || scene.has_kind(id) || spoken.keeps_off(id, "", scene.graph().room.type)) continue;
    const auto is_there = [&](const std::string& other) { return scene.has_kind(other); };
    const bool lacks_host = entry->mount == Mount::kSurface && std::ranges::none_of(entry->stands_on, is_there);
    const bool lacks_table = entry->is(Trait::kTableSeat) && std::ranges::none_of(entry->beside, is_there);
    const auto is_taken = [&](const SceneObject& o) {
      return std::ranges::any_of(entry->beside, [&](const std::string& other) { return catalog.is_a(o.category, other); }) &&
             scene.has_seat(o.id);
    };
    const bool seated = entry->is(Trait::kTableSeat) && std::ranges::any_of(scene.graph().objects, is_taken);
    // Where a crowd of seats is named, they stand in rows without desks.
    const bool desk = entry->is(Trait::kDeskLike) && crowd >= kCrowd;
    // … and what all look at is there once.
    const bool board = entry->is(Trait::kScreen) && entry->mount == Mount::kWall && looked_at;
    const bool instead =
        std::ranges::any_of(groups.fill.unless, [&](const auto& row) { return row.first == id && scene.has_kind(row.second); });
    if (instead || lacks_host || lacks_table || seated || desk || board) continue;
    const bool takes_floor = entry->mount == Mount::kFloor && !entry->thin;
    const auto has_room = [&] { return share < until || (hardly_any && !takes_floor); };
    for (int k = 0; k < usual && added < groups.fill.most && has_room(); ++k, ++added) {
      scene.add(*entry);
      share = covered_floor(scene.graph(), catalog) / floor;
    }
  }
}

}  // namespace layoutbox
