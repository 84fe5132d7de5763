// What is to be in or under a thing finds room there, where only the catalogue's sizes and shapes stand against it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "layoutbox/catalog/normalize_steps.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox {
namespace {

constexpr Mm kStillUnder = 50;                                     // a bottom board so high is as good as the floor
constexpr double kLeastShare = 0.3, kLeastShareOfFurniture = 0.6;  // of its least size, for a guest
constexpr double kLeastShareUnder = 0.5;                           // a smaller wardrobe is none
constexpr double kMostRaisedTop = 0.96;  // of a counter's, which is then a board over what stands under it: washing machines
constexpr double kMostRaised = 0.55;     // of its height, for what stands on legs
constexpr double kMostRaisedSeat = 0.25;
constexpr Mm kOverGuest = 40;

// How much smaller than its least size a thing must be for a space of that size; 1: it fits.
double share_that_fits(const Size& least, double width, double depth, double height) {
  constexpr double kPlay = 4;
  width -= kPlay, depth -= kPlay;
  const double plan = std::max(std::min(width / least.width, depth / least.depth), std::min(width / least.depth, depth / least.width));
  return std::min({plan, height / least.height, 1.0});
}

// At the host's usual size, which has grown for its guests already: larger it never is.
std::vector<Space> spaces_of_host(const CatalogEntry& entry, const SceneObject& host, Size& size) {
  size = host.size->usual;
  return spaces_of(host, entry, size);
}

// Whether so many of that size lie in rows and columns on a plane.
bool lie_in_rows(const Size& size, double width, double depth, std::size_t guests) {
  constexpr double kPlay = 2, kGap = 1;
  const auto columns = [&](double room, double one) { return static_cast<std::size_t>(std::max(0.0, room - kPlay) / (one + kGap)); };
  return std::max(columns(width, size.width) * columns(depth, size.depth), columns(width, size.depth) * columns(depth, size.width)) >=
         guests;
}

// How much smaller they must be for that.
double share_in_rows(const Size& size, double width, double depth, std::size_t guests) {
  constexpr int kSteps = 20;
  for (int step = kSteps; step >= kLeastShare * kSteps; --step) {
    const double share = double(step) / kSteps;
    if (lie_in_rows({static_cast<Mm>(size.width * share), static_cast<Mm>(size.depth * share), size.height}, width, depth, guests))
      return share;
  }
  return 0;
}

// To lie in one of the host's spaces, more than half of it below the top; so many of them in all.
double share_inside(const CatalogEntry& entry, const SceneObject& host, const Size& least, std::size_t guests) {
  constexpr double kBelowTop = 0.6, kPlay = 1;
  Size size;
  double best = 0;
  for (const Space& space : spaces_of_host(entry, host, size)) {
    if (!space.carries) continue;
    const bool open_above = space.max[2] >= size.height;
    const double height = open_above ? (size.height - space.min[2] - kPlay) / kBelowTop : space.max[2] - space.min[2];
    const double width = space.max[0] - space.min[0], depth = space.max[1] - space.min[1];
    const double all = guests < 2 ? 1 : share_in_rows(least, width, depth, guests);
    best = std::max(best, std::min(all, share_that_fits(least, width, depth, height)));
  }
  return best;
}

// To stand below it, between its legs or in what is open down to the floor.
double share_under(const CatalogEntry& entry, const SceneObject& host, const Size& least, Mm floor = kStillUnder) {
  Size size;
  double best = 0;
  for (const Space& space : spaces_of_host(entry, host, size)) {
    if (space.min[2] > floor || space.max[2] >= size.height) continue;
    best = std::max(best, share_that_fits(least, space.max[0] - space.min[0], space.max[1] - space.min[1], space.max[2] - space.min[2]));
  }
  return best;
}

// So many things are said to be in it.
std::size_t guests_in(const SceneGraph& scene, const SceneObject& host) {
  std::size_t guests = 0;
  for (const Relation& r : scene.relations) {
    if (r.type == RelationType::kIn && r.references.size() == 1 && r.references.front() == host.id) guests += r.targets.size();
  }
  return guests;
}

// How well what is in it fits there: the share of the one that fits least.
double share_of_guests(const NormalizeContext& context, const CatalogEntry& entry, const SceneObject& host) {
  const std::size_t guests = guests_in(context.scene, host);
  double share = 1;
  for (const Relation& r : context.scene.relations) {
    if (r.type != RelationType::kIn || r.references != std::vector{host.id}) continue;
    for (const SceneObject& guest : context.scene.objects) {
      if (std::ranges::find(r.targets, guest.id) != r.targets.end() && guest.size)
        share = std::min(share, share_inside(entry, host, guest.size->least, guests));
    }
  }
  return share;
}

// A cabinet with a box under it stands on legs, where that leaves what is in it its room.
void raise(NormalizeContext& context, const CatalogEntry& entry, SceneObject& host, const Size& guest) {
  const bool seat = !entry.is(Trait::kBed) && (entry.is(Trait::kSeat) || entry.is(Trait::kEasySeat) || entry.is(Trait::kCenterPiece));
  host.size->least.height = host.size->usual.height;
  const double most = entry.is(Trait::kCounter) ? kMostRaisedTop : seat ? kMostRaisedSeat : kMostRaised;
  const double room_before = share_of_guests(context, entry, host);
  host.raised = std::min<Mm>(guest.height + kOverGuest, static_cast<Mm>(most * host.size->least.height));
  if (share_of_guests(context, entry, host) < room_before) {
    host.raised = 0;
    return;
  }
  context.note("filled",
               fmt::format("\"{}\" stands on legs of {}, so that something finds room under it", host.id, metres_text(host.raised)),
               fmt::format("/furniture/{}/spaces", &host - context.scene.objects.data()));
}

bool may_be_raised(const CatalogEntry& entry, const SceneObject& host) {
  const bool holds = entry.top_carries || std::ranges::any_of(entry.spaces, [](const SpaceFormula& space) { return space.carries; });
  return holds && !entry.thin && !host.spaces_given && host.mesh.empty() && host.raised == 0 && host.mount == Mount::kFloor;
}

// To stand on top of it, where such things stand on the floor: a telescope on a desk leaves room for more.
double share_on_top(const Catalog& catalog, const SceneObject& host, const SceneObject& guest) {
  constexpr double kOfTop = 0.6;
  constexpr Mm kTallest = 700;
  // On a stage, a lift, a pallet things are as large as on the floor.
  constexpr double kPlatform = 1.8e6;  // mm²
  constexpr Mm kLow = 650;
  const Size& top = host.size->usual;
  if (top.height <= kLow && 1.0 * top.width * top.depth >= kPlatform)
    return share_that_fits(guest.size->least, top.width, top.depth, guest.size->least.height);
  if (catalog.entry_or_nearest(guest.category).is(Trait::kBed)) return 1;  // nobody sleeps in a toy
  const CatalogEntry &entry = catalog.entry_or_nearest(guest.category), &below = catalog.entry_or_nearest(host.category);
  constexpr Mm kStack = 1900;
  const bool alike = entry.shape.family == below.shape.family && top.height + guest.size->least.height <= kStack;
  if (guest.category == host.category || (alike && !below.shape.family.empty())) return 1;  // a stack: a dryer on its washing machine
  const bool stands_on_floor = entry.mount == Mount::kFloor && guest.mount == Mount::kSurface;
  if (!stands_on_floor || catalog.entry_or_nearest(host.category).thin) return 1;
  return share_that_fits(guest.size->least, kOfTop * host.size->usual.width, kOfTop * host.size->usual.depth, kTallest);
}

void shrink(NormalizeContext& context, SceneObject& guest, double share, const std::string& host) {
  for (const auto side : {&Size::width, &Size::depth, &Size::height}) {
    const Mm smaller = static_cast<Mm>(guest.size->least.*side * share);
    guest.size->least.*side = guest.size->usual.*side = smaller;
  }
  context.note("filled",
               fmt::format("\"{}\" is {} wide, smaller than usual, so that it finds room in, on or under \"{}\"", guest.id,
                           metres_text(guest.size->usual.width), host),
               fmt::format("/furniture/{}/dims", &guest - context.scene.objects.data()));
}

// A suitcase under a bed lies flat, where it does not stand there.
void lay_down(const Catalog& catalog, const CatalogEntry& entry, const SceneObject& host, SceneObject& guest) {
  const CatalogEntry& kind = catalog.entry_or_nearest(guest.category);
  const Size& least = guest.size->least;
  const bool portable = !kind.back_to_wall && !kind.top_carries && kind.spaces.empty() && !kind.is(Trait::kSeat) && !kind.is(Trait::kRound);
  if (!portable || least.height <= std::min(least.width, least.depth) || share_under(entry, host, least) == 1) return;
  const auto lie = [&](Size size) {
    std::swap(size.height, least.width < least.depth ? size.width : size.depth);
    return size;
  };
  if (share_under(entry, host, lie(least)) < 1) return;
  guest.size = SizeRange{lie(guest.size->least), lie(guest.size->usual), lie(guest.size->greatest)};
}

// A crate that something stands on and nothing is in is closed, or stands upside down.
void close_up(const CatalogEntry& entry, SceneObject& host) {
  if (entry.shape.family != "box_container" || entry.top_carries || host.spaces_given || !host.mesh.empty()) return;
  host.spaces_given = true;
  host.spaces.clear();
}

// Of many that only fit where each is small each is: the search need not find that out.
void pack(const CatalogEntry& entry, const SceneObject& host, SceneObject& guest, std::size_t guests) {
  constexpr int kSteps = 10;
  const Size least = guest.size->least, usual = guest.size->usual;
  for (int step = kSteps; step >= 0; --step) {
    for (const auto side : {&Size::width, &Size::depth, &Size::height})
      guest.size->usual.*side = least.*side + (usual.*side - least.*side) * step / kSteps;
    if (share_inside(entry, host, guest.size->usual, guests) >= 1) return;
  }
  guest.size->usual = usual;
}

// A bench that is tucked under a desk goes between its legs the long way: so wide it is at most, as long as one can sit on it.
void narrow_to_knees(const CatalogEntry& entry, const SceneObject& host, SceneObject& guest) {
  constexpr Mm kPlace = 350, kPlay = 10;
  Size size;
  for (const Space& space : spaces_of_host(entry, host, size)) {
    const Mm room = static_cast<Mm>(space.max[0] - space.min[0]) - kPlay;
    if (space.min[2] > 0 || space.max[2] >= size.height || room < kPlace || guest.size->usual.width <= room) continue;
    guest.size->usual.width = room;
    guest.size->least.width = std::min(guest.size->least.width, room);
    return;
  }
}

// A vessel, what is not known, and what neither has room for things nor carries any on its top: it is said to have some in it.
bool may_be_hollow(const Catalog& catalog, const CatalogEntry& entry, const SceneObject& host) {
  if (host.spaces_given || !host.mesh.empty()) return false;
  if (entry.is(Trait::kVessel) || catalog.find(host.category) == nullptr) return true;
  const bool holds = std::ranges::any_of(entry.spaces, [](const SpaceFormula& space) { return space.carries; });
  return !holds && !entry.thin && !entry.top_carries && host.mount != Mount::kWall && host.mount != Mount::kCeiling;
}

// What one relation says of a guest and the host that it names.
void find_room(NormalizeContext& context, RelationType type, SceneObject& host, SceneObject& guest) {
  const CatalogEntry& entry = context.catalog.entry_or_nearest(host.category);
  const bool in = type == RelationType::kIn, tucked = type == RelationType::kTuckedUnder;
  const bool under = type == RelationType::kUnder || tucked;
  const bool stands = guest.mount == Mount::kFloor || guest.mount == Mount::kSurface;
  if (under && (!stands || context.catalog.entry_or_nearest(guest.category).thin)) return;
  const std::size_t guests = guests_in(context.scene, host);
  if (in && may_be_hollow(context.catalog, entry, host) && share_inside(entry, host, guest.size->least, 1) == 0) host.hollow = true;
  if (type == RelationType::kOn && guests == 0) close_up(entry, host);
  if (under && may_be_raised(entry, host) && share_under(entry, host, guest.size->least, tucked ? 0 : kStillUnder) == 0)
    raise(context, entry, host, guest.size->usual);
  if (guest.size_source != SizeSource::kCatalog || !guest.catalog_id.empty()) return;
  if (tucked) return narrow_to_knees(entry, host, guest);
  if (under) lay_down(context.catalog, entry, host, guest);
  const double share = in      ? share_inside(entry, host, guest.size->least, guests)
                       : under ? share_under(entry, host, guest.size->least)
                               : share_on_top(context.catalog, host, guest);
  // Furniture with a seat or shelves of its own is no toy.
  const bool furniture = !context.catalog.entry_or_nearest(guest.category).spaces.empty();
  const double least_share = under ? kLeastShareUnder : furniture ? kLeastShareOfFurniture : kLeastShare;
  if (share < 1 && share >= least_share) return shrink(context, guest, share, host.id);
  if (in && guests > 1) pack(entry, host, guest, guests);
}

}  // namespace

void fold_over_seat(const Catalog& catalog, const SceneObject& seat, SceneObject& thing) {
  constexpr double kOfWidth = 0.6, kOfDepth = 0.5;
  const CatalogEntry& entry = catalog.entry_or_nearest(seat.category);
  const bool one_sits = !entry.is(Trait::kBed) && (entry.is(Trait::kSeat) || entry.is(Trait::kEasySeat));
  const bool cloth = catalog.entry_or_nearest(thing.category).shape.family == "blanket";
  const bool assumed = cloth && thing.size_source == SizeSource::kCatalog && thing.catalog_id.empty() && thing.mount == Mount::kSurface;
  if (!one_sits || !assumed || !seat.size || thing.size->usual.width <= seat.size->usual.width) return;
  const auto cap = [](SizeRange& range, Mm Size::*side, double most) {
    for (Size* size : {&range.least, &range.usual, &range.greatest}) size->*side = std::min(size->*side, static_cast<Mm>(most));
  };
  cap(*thing.size, &Size::width, kOfWidth * seat.size->usual.width);
  cap(*thing.size, &Size::depth, kOfDepth * seat.size->usual.depth);
}

namespace {

// The relations that hold something, from the floor up: "a fern in a basket on a stool" fits a basket that fits the stool.
std::vector<Relation> from_floor_up(const SceneGraph& scene) {
  constexpr int kMostStoreys = 8;
  std::vector<Relation> all;
  std::map<std::string, std::string> host_of;
  for (const Relation& relation : scene.relations) {
    const bool under = relation.type == RelationType::kUnder || relation.type == RelationType::kTuckedUnder;
    const bool rests = traits_of(relation.type).rests;
    if ((!rests && !under) || !relation.hard || relation.references.size() != 1) continue;
    all.push_back(relation);
    for (const std::string& target : relation.targets) {
      if (rests) host_of.emplace(target, relation.references.front());
    }
  }
  const auto storeys = [&](const Relation& relation) {
    int below = 0;
    for (auto at = host_of.find(relation.references.front()); at != host_of.end() && below < kMostStoreys; at = host_of.find(at->second))
      ++below;
    return below;
  };
  std::ranges::stable_sort(all, {}, storeys);
  return all;
}

}  // namespace

void normalize_guests(NormalizeContext& context) {
  SceneGraph& scene = context.scene;
  for (const Relation& relation : from_floor_up(scene)) {
    const RelationType type = relation.type;
    const auto host = std::ranges::find(scene.objects, relation.references.front(), &SceneObject::id);
    if (host == scene.objects.end() || !host->size) continue;
    if (type != RelationType::kIn && (host->mount == Mount::kWall || host->mount == Mount::kCeiling)) continue;
    for (SceneObject& guest : scene.objects) {
      const bool named = std::ranges::find(relation.targets, guest.id) != relation.targets.end();
      if (named && guest.size && &guest != &*host) find_room(context, type, *host, guest);
    }
  }
}

}  // namespace layoutbox
