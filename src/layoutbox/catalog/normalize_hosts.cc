// Furniture whose size nobody gave is made large enough for what stands on it, lies in it or sits around it.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/host_contents.h"
#include "layoutbox/catalog/trait_table.h"

namespace layoutbox {
namespace {

constexpr int kSteps = 10;     // from the usual size to the greatest
constexpr int kMoreSteps = 5;  // as long again as half of that, by a tenth of the greatest each, for what is to be on or in it

// Whether the things find room in rows on a plane, the deepest first; `planes` of the same size may be used.
bool fit_in_rows(std::vector<Size> things, Mm width, Mm depth, int planes) {
  std::ranges::sort(things, std::greater{}, &Size::depth);
  Mm used_width = 0, used_depth = 0, row_depth = 0;
  for (Size thing : things) {
    if (thing.width > width || thing.depth > depth) std::swap(thing.width, thing.depth);
    if (thing.width > width || thing.depth > depth) return false;
    if (used_width > 0 && used_width + kHostGap + thing.width > width) {
      used_depth += row_depth + kHostGap;
      used_width = row_depth = 0;
    }
    if (used_depth > 0 && used_depth + thing.depth > depth) {
      if (--planes == 0) return false;
      used_width = used_depth = row_depth = 0;
    }
    used_width += thing.width + (used_width > 0 ? kHostGap : 0);
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

// Screens that would not stand side by side on the widest such desk are smaller ones.
void narrow_screens(SceneGraph& scene, const HostContents& contents, Mm width) {
  if (contents.abreast <= width) return;
  const Mm each = (width / static_cast<Mm>(contents.screens.size()) - kHostGap) / kGridMm * kGridMm;
  for (SceneObject& screen : scene.objects) {
    if (std::ranges::find(contents.screens, screen.id) == contents.screens.end() || screen.size_source != SizeSource::kCatalog) continue;
    screen.size->usual.width = std::clamp(each, screen.size->least.width, screen.size->usual.width);
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

// What is on, in and around each host.
HostsById contents_of(NormalizeContext& context) {
  SceneGraph& scene = context.scene;
  ObjectsById by_id;
  for (const SceneObject& object : scene.objects) by_id.emplace(object.id, &object);
  HostsById hosts;
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
      contents.abreast += size.width + kHostGap;
    }
  }
  share_out_seats(context, hosts, by_id);
  return hosts;
}

// The i-th thing is made so large that it holds all that.
void make_room(NormalizeContext& context, std::size_t i, HostContents& contents) {
  SceneGraph& scene = context.scene;
  SceneObject& host = scene.objects[i];
  if (!host.size || host.size_source != SizeSource::kCatalog || !host.catalog_id.empty()) return;
  const CatalogEntry& entry = context.catalog.entry_or_nearest(host.category);
  if (entry.thin) return;
  const Size before = host.size->usual;
  const Seating* seating = Groups::builtin().seating_at(context.catalog, entry, scene.room.type);
  if (seating == nullptr || seating->seat.empty()) contents.seat = 0;  // one does not draw up to a low table
  grow_with_seats(context, entry, contents, host);
  const Size size = size_that_holds(entry, host, contents);
  narrow_screens(scene, contents, size.width);
  if (size == before) return;
  host.size->usual = size;
  host.size->greatest.width = std::max(host.size->greatest.width, size.width);
  host.size->greatest.depth = std::max(host.size->greatest.depth, size.depth);
  context.note("filled",
               fmt::format("\"{}\" is {} wide and {} deep, so that what it is to hold finds room", host.id, metres_text(size.width),
                           metres_text(size.depth)),
               fmt::format("/furniture/{}/dims", i));
}

}  // namespace

void normalize_hosts(NormalizeContext& context) {
  SceneGraph& scene = context.scene;
  fold_over_seats(context.catalog, scene);
  HostsById hosts = contents_of(context);
  seat_at_one_side(scene, hosts);
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (const auto found = hosts.find(scene.objects[i].id); found != hosts.end()) make_room(context, i, found->second);
  }
  stretch_benches(context);
}

void normalize_screens(NormalizeContext& context) {
  HostsById hosts = contents_of(context);
  for (std::size_t i = 0; i < context.scene.objects.size(); ++i) {
    const auto found = hosts.find(context.scene.objects[i].id);
    if (found != hosts.end() && found->second.screens.size() > 1) make_room(context, i, found->second);
  }
}

}  // namespace layoutbox
