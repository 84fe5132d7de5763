// Furniture whose size nobody gave is made large enough for what stands on it, lies in it or sits around it.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/normalize_steps.h"
#include "layoutbox/catalog/size_words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox {
namespace {

constexpr Mm kGap = 20;         // between things that stand side by side
constexpr Mm kSeatWidth = 620;  // of a table's edge that one person needs
constexpr Mm kWideSeat = 700;   // an armchair, where a chair has room at its place
constexpr Mm kElbows = 60;      // between seats at a counter
constexpr int kSteps = 10;      // from the usual size to the greatest
constexpr int kMoreSteps = 5;   // as long again as half of that, by a tenth of the greatest each, for what is to be on or in it

struct HostContents {
  std::vector<Size> on_top, inside;
  std::vector<Size> least_on_top, least_inside;  // … at their least sizes
  int around = 0, along = 0;                     // seats
  int before = 0;
  Mm seat = 0;                       // width of the widest seat around or along it
  Mm front = 0;                      // width of the seats before it
  Mm abreast = 0;                    // … and of the screens on it, which stand side by side
  std::vector<std::string> screens;  // their ids
};

// Whether the things find room in rows on a plane, the deepest first; `planes` of the same size may be used.
bool fit_in_rows(std::vector<Size> things, Mm width, Mm depth, int planes) {
  std::ranges::sort(things, std::greater{}, &Size::depth);
  Mm used_width = 0, used_depth = 0, row_depth = 0;
  for (Size thing : things) {
    if (thing.width > width || thing.depth > depth) std::swap(thing.width, thing.depth);
    if (thing.width > width || thing.depth > depth) return false;
    if (used_width > 0 && used_width + kGap + thing.width > width) {
      used_depth += row_depth + kGap;
      used_width = row_depth = 0;
    }
    if (used_depth > 0 && used_depth + thing.depth > depth) {
      if (--planes == 0) return false;
      used_width = used_depth = row_depth = 0;
    }
    used_width += thing.width + (used_width > 0 ? kGap : 0);
    row_depth = std::max(row_depth, thing.depth);
  }
  return true;
}

// What is to be on it and in it finds room.
bool carries_all(const CatalogEntry& entry, const SceneObject& host, const Size& size, const HostContents& contents) {
  if (entry.top_carries && !fit_in_rows(contents.on_top, size.width, size.depth, 1)) return false;
  std::vector<Space> carrying = spaces_of(host, entry, size);
  std::erase_if(carrying, [](const Space& space) { return !space.carries; });
  std::vector<Size> inside = contents.inside;
  if (!entry.top_carries) inside.insert(inside.end(), contents.on_top.begin(), contents.on_top.end());
  if (!inside.empty() && !carrying.empty()) {
    const Space& space = carrying.front();
    const Mm width = static_cast<Mm>(space.max[0] - space.min[0]), depth = static_cast<Mm>(space.max[1] - space.min[1]);
    if (!fit_in_rows(inside, width, depth, static_cast<int>(carrying.size()))) return false;
  }
  return true;
}

// As many places at a table as seats of that width take: an armchair needs more than one.
int places(int seats, const HostContents& contents) {
  const Mm each = std::max(kSeatWidth, contents.seat + kElbows);
  return (seats * each + kSeatWidth - 1) / kSeatWidth;
}

bool holds(const CatalogEntry& entry, const SceneObject& host, const Size& size, const HostContents& contents) {
  if (!carries_all(entry, host, size, contents)) return false;
  const double edge = is_round(host, entry) ? std::numbers::pi * size.width : 2.0 * (size.width + size.depth);
  const Mm width = std::max({contents.front, contents.abreast, places((contents.along + 1) / 2, contents) * kSeatWidth});
  return edge >= 1.0 * places(contents.around, contents) * kSeatWidth && size.width >= width;
}

Mm between(Mm from, Mm to, int step) { return from + (to - from) * step / kSteps; }

// The first size on the way to the greatest that holds it all; the greatest where none does, or a little more where that is enough for
// what is on and in it.
Size size_that_holds(const CatalogEntry& entry, const SceneObject& host, const HostContents& contents) {
  Size size = host.size->usual;
  for (int step = 0; step <= kSteps; ++step) {
    size.width = between(host.size->usual.width, host.size->greatest.width, step);
    size.depth = between(host.size->usual.depth, host.size->greatest.depth, step);
    if (holds(entry, host, size, contents)) return size;
  }
  if (carries_all(entry, host, size, contents)) return size;
  Size larger = size;
  for (int step = 1; step <= kMoreSteps; ++step) {
    larger.width = size.width + size.width * step / kSteps;
    larger.depth = size.depth + size.depth * step / kSteps;
    if (carries_all(entry, host, larger, contents)) return larger;
  }
  HostContents least = contents;  // "a plant stand with three ferns": small ones on a large one
  least.on_top = contents.least_on_top, least.inside = contents.least_inside;
  return carries_all(entry, host, larger, least) ? larger : size;
}

Mm widest_seat(const Catalog& catalog, const std::map<std::string, const SceneObject*>& by_id, const std::vector<std::string>& ids) {
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

using ObjectsById = std::map<std::string, const SceneObject*>;

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

// So large as the catalogue says it is for so many, be that larger than such things mostly are.
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

// Seats that no relation places go to the only thing of the kind they usually stand by, or share those out that one sits round: bar stools
// to the island, chairs to the table.
void share_out_seats(const NormalizeContext& context, std::map<std::string, HostContents>& hosts, const ObjectsById& by_id) {
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

// Screens that would not stand side by side on the widest such desk are smaller ones.
void narrow_screens(SceneGraph& scene, const HostContents& contents, Mm width) {
  if (contents.abreast <= width) return;
  const Mm each = (width / static_cast<Mm>(contents.screens.size()) - kGap) / kGridMm * kGridMm;
  for (SceneObject& screen : scene.objects) {
    if (std::ranges::find(contents.screens, screen.id) == contents.screens.end() || screen.size_source != SizeSource::kCatalog) continue;
    screen.size->usual.width = std::clamp(each, screen.size->least.width, screen.size->usual.width);
  }
}

// Seats along a table, across from what sits at its other side, are side by side: the table is as long as that takes.
void seat_at_one_side(const SceneGraph& scene, std::map<std::string, HostContents>& hosts) {
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

// A bench at the long side of a table is nearly as long as that.
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

void fold_over_seats(const Catalog& catalog, SceneGraph& scene) {
  for (const Relation& relation : scene.relations) {
    if (relation.type != RelationType::kOn || relation.references.size() != 1) continue;
    const SceneObject* seat = scene.find_object(relation.references.front());
    if (seat == nullptr) continue;
    for (SceneObject& thing : scene.objects) {
      if (names(relation.targets, thing.id) && thing.size) fold_over_seat(catalog, *seat, thing);
    }
  }
}

// Who sits at the one that the relation names.
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

}  // namespace

void normalize_hosts(NormalizeContext& context) {
  SceneGraph& scene = context.scene;
  fold_over_seats(context.catalog, scene);
  ObjectsById by_id;
  for (const SceneObject& object : scene.objects) by_id.emplace(object.id, &object);
  std::map<std::string, HostContents> hosts;
  for (const Relation& relation : scene.relations) {
    if (relation.references.size() != 1) continue;
    HostContents& contents = hosts[relation.references.front()];
    count_seats(context.catalog, by_id, relation, contents);
    const bool on = relation.type == RelationType::kOn, in = relation.type == RelationType::kIn;
    for (const std::string& target : relation.targets) {
      const auto thing = by_id.find(target);
      if ((!on && !in) || thing == by_id.end() || !thing->second->size) continue;
      const Size& size = thing->second->size->usual;
      (on ? contents.on_top : contents.inside).push_back(size);
      (on ? contents.least_on_top : contents.least_inside).push_back(thing->second->size->least);
      if (!on || !context.catalog.entry_or_nearest(thing->second->category).is(Trait::kMonitor)) continue;
      contents.screens.push_back(target);
      contents.abreast += size.width + kGap;
    }
  }
  share_out_seats(context, hosts, by_id);
  seat_at_one_side(scene, hosts);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    SceneObject& host = scene.objects[i];
    const auto found = hosts.find(host.id);
    if (found == hosts.end() || !host.size || host.size_source != SizeSource::kCatalog || !host.catalog_id.empty()) continue;
    const CatalogEntry& entry = context.catalog.entry_or_nearest(host.category);
    if (entry.thin) continue;
    const Size before = host.size->usual;
    const Seating* seating = Groups::builtin().seating_at(context.catalog, entry, scene.room.type);
    if (seating == nullptr || seating->seat.empty()) found->second.seat = 0;  // one does not draw up to a low table
    grow_with_seats(context, entry, found->second, host);
    const Size size = size_that_holds(entry, host, found->second);
    narrow_screens(scene, found->second, size.width);
    if (size == before) continue;
    host.size->usual = size;
    host.size->greatest.width = std::max(host.size->greatest.width, size.width);
    host.size->greatest.depth = std::max(host.size->greatest.depth, size.depth);
    context.note("filled",
                 fmt::format("\"{}\" is {} wide and {} deep, so that what it is to hold finds room", host.id, metres_text(size.width),
                             metres_text(size.depth)),
                 fmt::format("/furniture/{}/dims", i));
  }
  stretch_benches(context);
}

}  // namespace layoutbox
