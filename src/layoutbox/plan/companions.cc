#include "layoutbox/plan/companions.h"

#include <algorithm>
#include <map>
#include <ranges>
#include <set>
#include <span>

#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/measures.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/growing_scene.h"
#include "layoutbox/plan/named_seats.h"
#include "layoutbox/plan/spoken.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox {
namespace {

constexpr int kMostSeats = 24;

class Companions {
 public:
  // REQUIRES: nothing has been added yet.
  Companions(GrowingScene& scene, const std::vector<std::string>& excluded, const Catalog& catalog)
      : scene_(scene),
        catalog_(catalog),
        groups_(Groups::builtin()),
        spoken_(scene.graph(), excluded, catalog),
        seats_(scene, catalog),
        named_(scene.graph().objects.size()) {}

  void run() {
    if (spoken_.wants_no_more(groups_)) return;
    for (std::size_t i = 0; i < named_; ++i) seat_at(i);
    for (std::size_t i = 0; i < named_; ++i) carry(i);
    add_needs();
    for (const Companion& companion : groups_.companions) add_by(companion);
    if (!says_where() || !names_furniture()) fill_bare_room(scene_, spoken_, named_, catalog_);
  }

 private:
  bool akin(const std::string& a, const std::string& b) const { return catalog_.is_a(a, b) || catalog_.is_a(b, a); }

  bool in_rooms(const std::vector<std::string>& rooms) const {
    return rooms.empty() || std::ranges::find(rooms, scene_.graph().room.type) != rooms.end();
  }

  void seat_at(std::size_t i) {
    const std::string id = named_thing(i).id, category = named_thing(i).category;
    const CatalogEntry* entry = catalog_.find(category);
    const SceneObject* sized = scene_.sized(id);
    const Seating* seating = entry == nullptr ? nullptr : groups_.seating_at(catalog_, *entry, scene_.graph().room.type);
    if (seating == nullptr || !(seating->comes || spoken_.says_any(groups_.sat_at)) || sized == nullptr || !sized->size ||
        sized->mount != Mount::kFloor)
      return;
    if (sit_in_aid(id, *entry, *seating)) return;
    const CatalogEntry* seat = catalog_.find(seating->seat);
    const std::vector<Side> used = sized->used_sides.value_or(entry->used_sides);
    const auto is_used = [&](Side side) { return std::ranges::find(used, side) != used.end(); };
    // Who serves sits behind; the chairs that are named are the guests'.
    const bool serves = entry->is(Trait::kOpenToRoom) && is_used(Side::kBack) && is_used(Side::kFront);
    // … and seats that follow from how many people there are stand at tables of their own: the teacher's desk has its chair.
    const bool visited = entry->is(Trait::kDeskLike) && scene_.has_kind("visitor_chair");
    const bool named_only = serves || visited || !seats_.spoken_of || (entry->is(Trait::kDesk) && (seats_.taken || seats_.easy_only)) ||
                            (entry->is(Trait::kOpenToRoom) && seats_.at_desks);
    if (seat == nullptr || (named_only ? spoken_.names(*seat) : spoken_.of(*seat)) || scene_.has_seat(id) || (!serves && seats_.loose))
      return;
    const int count = std::min(seats_at_size(*seating, is_round(*sized, *entry), sized->size->usual), kMostSeats);
    std::vector<std::string> seats;
    for (int k = 0; k < count; ++k) seats.push_back(scene_.add(*seat));
    if (count > 1) {
      scene_.relate(RelationType::kAround, seats, id);
      return;
    }
    const bool knees = std::ranges::any_of(entry->spaces, [](const SpaceFormula& space) { return !space.carries; });
    if (knees && is_used(Side::kFront) && !serves && !visited) {  // pushed under, out of the way until somebody sits down
      scene_.relate(RelationType::kNextTo, seats, id);
      return;
    }
    const bool behind = serves || visited || (!is_used(Side::kFront) && is_used(Side::kBack));
    scene_.relate(behind ? RelationType::kBehind : RelationType::kInFrontOf, seats, id, measures().seat_at_hand);
    scene_.relate(RelationType::kFacing, seats, id);
  }

  // Who comes in a wheelchair needs no chair at the desk: it is drawn up there, where words put it nowhere else.
  bool sit_in_aid(const std::string& desk, const CatalogEntry& entry, const Seating& seating) {
    if (seating.seats != 1 || !entry.is(Trait::kDesk)) return false;
    const auto is_sat_in = [&](const SceneObject& object) {
      const CatalogEntry& kind = catalog_.entry_or_nearest(object.category);
      return kind.is(Trait::kPersonalAid) && std::ranges::any_of(kind.spaces, [](const SpaceFormula& s) { return s.name == "seat"; });
    };
    const auto& objects = scene_.graph().objects;
    const auto aid = std::ranges::find_if(objects, is_sat_in);
    if (aid == objects.end() || scene_.has_seat(desk)) return false;
    const std::string sitter = aid->id;
    if (!scene_.relations_of(sitter).empty()) return true;
    scene_.relate(RelationType::kInFrontOf, {sitter}, desk, measures().seat_at_hand);
    scene_.relate(RelationType::kFacing, {sitter}, desk);
    return true;
  }

  // What stands on something, and has nothing to stand on, gets what usually carries it in such a room: a record player in the corner a
  // sideboard there, lamps at both sides of a bed a nightstand each.
  void carry(std::size_t i) {
    const SceneObject thing = named_thing(i);
    const CatalogEntry* entry = catalog_.find(thing.category);
    const SceneObject* sized = scene_.sized(thing.id);
    if (entry == nullptr || entry->mount != Mount::kSurface || sized == nullptr || !sized->size) return;
    if (sized->mount != Mount::kFloor && !only_carriers_are_elsewhere(thing.id, *entry) && !hangs_in_corner(thing, *sized)) return;
    const auto is_such = [&](const std::string& kind) { return catalog_.is_a(thing.category, kind); };
    if (std::ranges::none_of(groups_.carried, is_such)) return;  // dolls, baskets and bowls may well lie on the floor
    bool own = false;
    for (const std::size_t r : scene_.relations_of(thing.id)) {
      const RelationType type = scene_.graph().relations[r].type;
      if (type == RelationType::kOn) return;  // said: on the floor
      own |= type == RelationType::kEachSideOf || traits_of(type).sideways;
    }
    const CatalogEntry* host = usual_host(*entry, sized->size->usual);
    if (host == nullptr) return;
    std::string& shared = hosts_[host->id];
    const std::string id = own || shared.empty() ? scene_.add(*host) : shared;
    if (!own) shared = id;
    scene_.relate(RelationType::kOn, {thing.id}, id);
  }

  // "The telly in the corner": nothing flat hangs there, it stands on something.
  bool hangs_in_corner(const SceneObject& thing, const SceneObject& sized) const {
    return is_told_in_corner(thing.id) && sized.mount == Mount::kWall && thing.mount != Mount::kWall;
  }

  // A sewing machine under the window, where the only table has the middle of the room.
  bool only_carriers_are_elsewhere(const std::string& thing, const CatalogEntry& entry) const {
    const auto is_told = [&](const std::string& id, std::initializer_list<RelationType> places) {
      return std::ranges::any_of(scene_.relations_of(id), [&](std::size_t r) {
        return std::ranges::find(places, scene_.graph().relations[r].type) != places.end();
      });
    };
    if (!is_told(thing, {RelationType::kUnderWindow, RelationType::kCorner, RelationType::kAgainstWall})) return false;
    bool any = false;
    for (const SceneObject& object : scene_.graph().objects) {
      if (std::ranges::none_of(entry.stands_on, [&](const std::string& kind) { return catalog_.is_a(object.category, kind); })) continue;
      if (!is_told(object.id, {RelationType::kCenterOfRoom})) return false;
      any = true;
    }
    return any;
  }

  bool is_told_in_corner(const std::string& id) const {
    return std::ranges::any_of(scene_.relations_of(id),
                               [&](std::size_t r) { return scene_.graph().relations[r].type == RelationType::kCorner; });
  }

  bool has_bed() const {
    return std::ranges::any_of(scene_.graph().objects,
                               [&](const SceneObject& o) { return catalog_.entry_or_nearest(o.category).is(Trait::kBed); });
  }

  // Of the kinds that such a thing stands on the first that is usual in the room or goes with what is there, else the smallest.
  const CatalogEntry* usual_host(const CatalogEntry& thing, const Size& size) const {
    const CatalogEntry* smallest = nullptr;
    const auto area = [](const Size& s) { return double(s.width) * s.depth; };
    for (const std::string& id : thing.stands_on) {
      const CatalogEntry* host = catalog_.find(id);
      if (host == nullptr || host->mount != Mount::kFloor || host->is(Trait::kBed) || area(host->size.usual) <= area(size)) continue;
      if (spoken_.of(*host) || (host->is(Trait::kBedside) && !has_bed())) continue;
      const bool goes = std::ranges::any_of(host->beside, [&](const std::string& other) { return scene_.has_kind(other); });
      if (goes || (!scene_.graph().room.type.empty() && std::ranges::find(host->rooms, scene_.graph().room.type) != host->rooms.end()))
        return host;
      if (smallest == nullptr || area(host->size.usual) < area(smallest->size.usual)) smallest = host;
    }
    return smallest;
  }

  void add_by(const Companion& companion) {
    const CatalogEntry* kind = catalog_.find(companion.adds);
    // counters are no sink, though sinks are a kind of counter
    const bool spoken = kind != nullptr && (kind->top_carries ? spoken_.of(*kind) : spoken_.of_just(*kind));
    if (kind == nullptr || !in_rooms(companion.rooms) || spoken || scene_.has_kind(companion.adds)) return;
    if (spoken_.keeps_off(companion.adds, "", scene_.graph().room.type)) return;
    const auto named = std::span(scene_.graph().objects).first(named_);
    const auto is_named = [&](const std::string& other) {
      return std::ranges::any_of(named, [&](const SceneObject& thing) { return catalog_.is_a(thing.category, other); });
    };
    if (std::ranges::any_of(companion.unless, is_named)) return;
    const bool on_it = std::ranges::any_of(kind->stands_on, [&](const std::string& id) { return akin(id, companion.of); });
    const auto is_there = [&](const std::string& other) { return scene_.has_kind(other); };
    if (kind->mount == Mount::kSurface && !on_it && std::ranges::none_of(kind->stands_on, is_there)) return;  // no lamp on the floor
    // What stands on the floor comes with those kinds only that such a thing stands beside: no nightstand with a bunk bed.
    const auto takes = [&](const SceneObject& object) {
      const CatalogEntry* entry = catalog_.find(object.category);
      return entry != nullptr && catalog_.is_a(object.category, companion.of) &&
             (kind->mount != Mount::kFloor || companion.anywhere || (kind->is(Trait::kKitchenRun) && entry->is(Trait::kKitchenRun)) ||
              std::ranges::any_of(entry->beside, [&](const std::string& id) { return akin(id, kind->id); }));
    };
    std::vector<std::string> hosts;
    for (const SceneObject& object : scene_.graph().objects) {
      if (takes(object)) hosts.push_back(object.id);
    }
    if (companion.up_to > 0 && hosts.size() > static_cast<std::size_t>(companion.up_to)) return;
    for (const std::string& host : hosts) {
      const SceneObject* sized = scene_.sized(host);
      // A bed that is told to be in a corner has no room at its other side.
      const bool for_two = companion.both_sides_from > 0 && sized != nullptr && sized->size &&
                           sized->size->usual.width >= companion.both_sides_from && !is_told_in_corner(host);
      for (int k = 0; k < companion.each * (for_two ? 2 : 1); ++k) {
        const std::string id = scene_.add(*kind);
        if (on_it && kind->mount == Mount::kSurface) scene_.relate(RelationType::kOn, {id}, host);
      }
    }
  }

  // Does the text say where furniture stands? Then it is the whole arrangement; rows and ways to look alone are not.
  bool says_where() const {
    const auto is_furniture = [&](const std::string& id) {
      const SceneObject* object = scene_.find(id);
      return object != nullptr && stands_on_floor(catalog_, *object);
    };
    return std::ranges::any_of(scene_.graph().relations, [&](const Relation& r) {
      const RelationTraits& traits = traits_of(r.type);
      return r.origin == Origin::kAsked && !traits.order_only && !traits.turns && std::ranges::any_of(r.targets, is_furniture);
    });
  }

  // "toys on the floor in the middle" are none.
  bool names_furniture() const {
    return std::ranges::any_of(std::views::iota(std::size_t{0}, named_), [&](std::size_t i) {
      const CatalogEntry& entry = catalog_.entry_or_nearest(named_thing(i).category);
      return entry.mount == Mount::kFloor && !entry.is(Trait::kPet);
    });
  }

  // A kitchen of which little is named has what one cooks with, wherever the text places that little.
  void add_needs() {
    constexpr std::size_t kLittle = 3;  // kinds of furniture
    const RoomKind* room = scene_.graph().room.type.empty() ? nullptr : catalog_.find_room(scene_.graph().room.type);
    std::set<std::string> kinds;
    for (std::size_t i = 0; i < named_; ++i) {
      if (stands_on_floor(catalog_, named_thing(i))) kinds.insert(named_thing(i).category);
    }
    if (room == nullptr || kinds.size() > kLittle || spoken_.says_any(groups_.none_to_fill)) return;
    for (const std::vector<std::string>& any_of : room->needs) {
      const CatalogEntry* usual = catalog_.find(any_of.front());
      const auto is_there = [&](const std::string& id) { return scene_.has_kind(id); };
      if (usual != nullptr && !spoken_.of(*usual) && std::ranges::none_of(any_of, is_there)) scene_.add(*usual);
    }
  }

  const SceneObject& named_thing(std::size_t i) const { return scene_.graph().objects[i]; }

  GrowingScene& scene_;
  const Catalog& catalog_;
  const Groups& groups_;
  const Spoken spoken_;
  const NamedSeats seats_;
  const std::size_t named_;                   // so many things are the text's
  std::map<std::string, std::string> hosts_;  // that came for small things, by kind
};

}  // namespace

std::size_t add_companions(SceneGraph& scene, const SceneGraph& sized, const std::vector<std::string>& excluded, const Catalog& catalog) {
  // Where nothing is asked for it has what is usual already; "a living room with a reading corner" has the corner's things alone.
  const auto is_said = [](const SceneObject& object) { return object.asked() || object.origin == Origin::kConcluded; };
  if (std::ranges::none_of(scene.objects, is_said) || catalog.only_articles()) return 0;
  const std::size_t before = scene.objects.size();
  GrowingScene growing(scene, sized, catalog);
  Companions(growing, excluded, catalog).run();
  return scene.objects.size() - before;
}

}  // namespace layoutbox
