// Who sits at furniture whose size nobody gave, and how large it is for them.
#include <algorithm>

#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/host_contents.h"
#include "layoutbox/catalog/size_words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox {
namespace {

constexpr Mm kWideSeat = 700;  // an armchair, where a chair has room at its place
constexpr Mm kElbows = 60;     // between seats at a counter

Mm widest_seat(const Catalog& catalog, const ObjectsById& by_id, const std::vector<std::string>& ids) {
  Mm widest = 0;
  for (const std::string& id : ids) {
    const auto seat = by_id.find(id);
    if (seat == by_id.end() || !seat->second->size) continue;
    const CatalogEntry& entry = catalog.entry_or_nearest(seat->second->category);
    const Size& size = seat->second->size->usual;
    const bool for_one = (entry.is(Trait::kSeat) || entry.is(Trait::kEasySeat)) && size.width < 2 * size.depth;
    if (for_one && size.width > kWideSeat) widest = std::max(widest, size.width);
  }
  return widest;
}

Mm seat_width(const Catalog& catalog, const ObjectsById& by_id, const std::vector<std::string>& ids) {
  Mm width = 0;
  for (const std::string& id : ids) {
    const auto seat = by_id.find(id);
    if (seat == by_id.end() || !seat->second->size || !catalog.entry_or_nearest(seat->second->category).is(Trait::kTableSeat)) continue;
    width += seat->second->size->usual.width + kElbows;
  }
  return width;
}

// Where the room is small or has many such tables, or far fewer sit there than could, a table whose size nobody gave is no larger than it
// must be.
void shrink_for_room(const NormalizeContext& context, int seats, const SizeForSeats& wanted, SceneObject& host) {
  constexpr double kSmallRoom = 15e6;  // mm²
  const Room& room = context.scene.room;
  const double area = room.area_m2 ? *room.area_m2 * 1e6 : room.polygon.empty() ? 0 : double(doubled_area(room.polygon)) / 2;
  const bool few = seats <= 2 || 4 * wanted.width <= 3 * host.size->usual.width;
  constexpr std::ptrdiff_t kMany = 3;
  const bool many = std::ranges::count(context.scene.objects, host.category, &SceneObject::category) >= kMany;
  const bool small = many || (area > 0 && area < kSmallRoom) || room_size_factor(room.size_word) < 1 || few;
  if (!small || host.size_source != SizeSource::kCatalog || std::ranges::any_of(host.attributes, is_size_word)) return;
  for (Size* size : {&host.size->usual, &host.size->least}) {
    size->width = std::min(size->width, wanted.width);
    if (wanted.depth > 0) size->depth = std::min(size->depth, wanted.depth);  // a bar is as deep as it is, whoever sits there
  }
}

// The things that a seat which no relation places usually goes to: all of the kind of the first that people sit at.
std::vector<const SceneObject*> usual_hosts(const NormalizeContext& context, const SceneObject& seat) {
  constexpr Mm kLow = 600, kHighSeat = 700;
  const CatalogEntry& entry = context.catalog.entry_or_nearest(seat.category);
  std::vector<const SceneObject*> hosts;
  for (const std::string& kind : entry.beside) {
    for (const SceneObject& object : context.scene.objects) {
      const CatalogEntry& host = context.catalog.entry_or_nearest(object.category);
      if (!object.size || host.thin || !context.catalog.is_a(object.category, kind)) continue;
      const Seating* seating = Groups::builtin().seating_at(context.catalog, host, context.scene.room.type);
      const bool low = object.size->usual.height < kLow && seat.size && seat.size->usual.height > kHighSeat;
      if (low || (seating != nullptr && seating->seat.empty())) continue;
      if (hosts.empty() || object.category == hosts[0]->category) hosts.push_back(&object);
    }
    if (!hosts.empty()) break;
  }
  return hosts;
}

}  // namespace

int places(int seats, const HostContents& contents) {
  const Mm each = std::max(kSeatWidth, contents.seat + kElbows);
  return (seats * each + kSeatWidth - 1) / kSeatWidth;
}

void grow_with_seats(const NormalizeContext& context, const CatalogEntry& entry, const HostContents& contents, SceneObject& host) {
  const Seating* seating = Groups::builtin().seating_at(context.catalog, entry, context.scene.room.type);
  const int seats = std::max(places(contents.around + contents.along, contents), contents.before);
  if (seating == nullptr || seats == 0) return;
  const auto wanted = size_for_seats(*seating, is_round(host, entry), seats);
  if (!wanted) return;
  if (wanted->width <= host.size->usual.width) return shrink_for_room(context, seats, *wanted, host);
  for (Size* size : {&host.size->usual, &host.size->greatest}) {
    size->width = std::max(size->width, wanted->width);
    size->depth = std::max(size->depth, wanted->depth);
  }
}

void share_out_seats(const NormalizeContext& context, HostsById& hosts, const ObjectsById& by_id) {
  const SceneGraph& scene = context.scene;
  std::map<std::string, Mm> widths;
  std::map<std::string, int> counts;
  std::map<std::string, std::size_t> ranks;  // by kind of seat
  for (const SceneObject& seat : scene.objects) {
    const bool placed =
        std::ranges::any_of(scene.relations, [&](const Relation& r) { return std::ranges::find(r.targets, seat.id) != r.targets.end(); });
    if (placed || !context.catalog.entry_or_nearest(seat.category).is(Trait::kTableSeat)) continue;
    const std::vector<const SceneObject*> usual = usual_hosts(context, seat);
    if (usual.empty()) continue;
    if (context.catalog.entry_or_nearest(usual[0]->category).has_front) {
      if (usual.size() > 1) continue;
      widths[usual[0]->id] += seat_width(context.catalog, by_id, {seat.id});
      ++counts[usual[0]->id];
      continue;
    }
    ++hosts[usual[ranks[seat.category]++ % usual.size()]->id].around;
  }
  for (const auto& [host, width] : widths) {
    hosts[host].front += width;
    hosts[host].before += counts[host];
  }
}

void seat_at_one_side(const SceneGraph& scene, HostsById& hosts) {
  std::map<std::string, std::string> table_of;  // by seat
  for (const Relation& r : scene.relations) {
    if (r.type != RelationType::kAlongSide || r.references.size() != 1) continue;
    for (const std::string& seat : r.targets) table_of[seat] = r.references[0];
  }
  for (const Relation& r : scene.relations) {
    const auto table = r.type == RelationType::kOpposite && r.references.size() == 1 ? table_of.find(r.references[0]) : table_of.end();
    if (table == table_of.end()) continue;
    const auto count = std::ranges::count_if(r.targets, [&](const std::string& seat) {
      const auto own = table_of.find(seat);
      return own != table_of.end() && own->second == table->second;
    });
    HostContents& contents = hosts[table->second];
    contents.front = std::max(contents.front, static_cast<Mm>(count) * kSeatWidth);
  }
}

void stretch_benches(const NormalizeContext& context) {
  constexpr Mm kShorter = 200, kLongest = 2600;
  SceneGraph& scene = context.scene;
  for (const Relation& r : scene.relations) {
    if (r.type != RelationType::kAlongSide || r.targets.size() != 1 || r.references.size() != 1) continue;
    const auto bench = std::ranges::find(scene.objects, r.targets.front(), &SceneObject::id);
    const SceneObject* table = scene.find_object(r.references.front());
    if (bench == scene.objects.end() || !bench->size || bench->size_source != SizeSource::kCatalog || table == nullptr || !table->size)
      continue;
    const CatalogEntry& entry = context.catalog.entry_or_nearest(bench->category);
    Size& usual = bench->size->usual;
    const Mm length = std::min(std::max(table->size->usual.width, table->size->usual.depth) - kShorter, kLongest);
    if (!entry.is(Trait::kSeat) || !bench->catalog_id.empty() || usual.width < 2 * usual.depth || length <= usual.width) continue;
    usual.width = length;
    bench->size->greatest.width = std::max(bench->size->greatest.width, length);
  }
}

void count_seats(const Catalog& catalog, const ObjectsById& by_id, const Relation& relation, HostContents& contents) {
  const int seats = static_cast<int>(relation.targets.size());
  const bool around = traits_of(relation.type).around, along = relation.type == RelationType::kAlongSide;
  if (around || along) contents.seat = std::max(contents.seat, widest_seat(catalog, by_id, relation.targets));
  if (around) contents.around += seats;
  if (along && or_default(relation, &RelationParameters::side) == Side::kLong) contents.along += seats;
  if (relation.type != RelationType::kInFrontOf && relation.type != RelationType::kBehind) return;
  const Mm width = seat_width(catalog, by_id, relation.targets);
  contents.front += width;
  contents.before += width > 0 ? seats : 0;
}

}  // namespace layoutbox
