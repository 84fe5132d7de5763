#include "layoutbox/plan/companions.h"

#include <algorithm>
#include <map>
#include <set>

#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/measures.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/spoken.h"
#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox {
namespace {

constexpr int kMostSeats = 24;

class Companions {
 public:
  Companions(SceneGraph& scene, const SceneGraph& sized, const std::vector<std::string>& excluded, const Catalog& catalog)
      : scene_(scene), sized_(sized), catalog_(catalog), groups_(Groups::builtin()), spoken_(scene, excluded, catalog) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i) named_.push_back(i);
    if (std::ranges::none_of(scene.objects, &SceneObject::asked)) named_.clear();  // it has what is usual already
  }

  std::size_t run() {
    if (named_.empty() || catalog_.only_articles() || spoken_.wants_no_more(groups_)) return 0;
    const std::size_t before = scene_.objects.size();
    for (const std::size_t i : named_) seat_at(i);
    for (const std::size_t i : named_) carry(i);
    add_needs();
    for (const Companion& companion : groups_.companions) add_by(companion);
    if (!says_where()) fill();
    return scene_.objects.size() - before;
  }

 private:
  bool akin(const std::string& a, const std::string& b) const { return catalog_.is_a(a, b) || catalog_.is_a(b, a); }

  bool has_kind(const std::string& kind) const {
    return std::ranges::any_of(scene_.objects, [&](const SceneObject& o) { return catalog_.is_a(o.category, kind); });
  }

  bool in_rooms(const std::vector<std::string>& rooms) const {
    return rooms.empty() || std::ranges::find(rooms, scene_.room.type) != rooms.end();
  }

  std::string add(const CatalogEntry& kind) {
    SceneObject object;
    object.category = kind.id;
    object.name = kind.name;
    object.origin = Origin::kAdded;
    int number = 0;
    do {
      object.id = kind.id + "_" + std::to_string(++number);
    } while (scene_.find_object(object.id) != nullptr);
    scene_.objects.push_back(std::move(object));
    return scene_.objects.back().id;
  }

  void relate(RelationType type, std::vector<std::string> targets, const std::string& reference, std::optional<Mm> max = {}) {
    Relation relation;
    relation.id = "a" + std::to_string(++relations_);
    relation.type = type;
    relation.targets = std::move(targets);
    relation.references = {reference};
    relation.parameters.max = max;
    relation.origin = Origin::kAdded;
    relation.why = "what its use needs";
    scene_.relations.push_back(std::move(relation));
  }

  // Is a seat placed by it already: a chair, a bench, cushions on the floor?
  bool has_seat(const std::string& table) const {
    return std::ranges::any_of(scene_.relations, [&](const Relation& r) {
      if (std::ranges::find(r.references, table) == r.references.end()) return false;
      return std::ranges::any_of(r.targets, [&](const std::string& id) {
        const SceneObject* object = scene_.find_object(id);
        if (object == nullptr) return false;
        const CatalogEntry& kind = catalog_.entry_or_nearest(object->category);
        return kind.is(Trait::kSeat) && !kind.is(Trait::kVisitorSeat);  // who works there sits behind
      });
    });
  }

  // A seat that is named and stands by nothing in particular: it may well be meant for this.
  bool has_loose_seat() const {
    return std::ranges::any_of(named_, [&](std::size_t i) {
      const SceneObject& object = scene_.objects[i];
      const auto says_where = [&](const Relation& r) {
        return std::ranges::find(r.targets, object.id) != r.targets.end() &&
               (!r.references.empty() || r.type == RelationType::kAgainstWall);
      };
      const CatalogEntry& kind = catalog_.entry_or_nearest(object.category);
      return kind.is(Trait::kTableSeat) && !kind.is(Trait::kVisitorSeat) && std::ranges::none_of(scene_.relations, says_where);
    });
  }

  // The text itself speaks of chairs or stools.
  bool names_seat() const {
    return std::ranges::none_of(named_, [&](std::size_t i) { return scene_.objects[i].origin == Origin::kConcluded; }) ||
           std::ranges::any_of(named_, [&](std::size_t i) {
             return scene_.objects[i].asked() && catalog_.entry_or_nearest(scene_.objects[i].category).is(Trait::kTableSeat);
           });
  }

  // "two desks, a meeting table with four chairs": all seats that are named are those of another table, so that the desk's are still to
  // come.
  bool seats_are_taken() const {
    const auto sat_at = [&](const std::string& host) {
      const SceneObject* object = scene_.find_object(host);
      if (object == nullptr) return false;
      const CatalogEntry& kind = catalog_.entry_or_nearest(object->category);
      return kind.is(Trait::kTable) && !kind.is(Trait::kDesk) && !kind.is(Trait::kOccasional);
    };
    bool any = false;
    for (const std::size_t i : named_) {
      const SceneObject& seat = scene_.objects[i];
      if (!seat.asked() || !catalog_.entry_or_nearest(seat.category).is(Trait::kTableSeat)) continue;
      any = true;
      const auto at_table = [&](const Relation& r) {
        return std::ranges::find(r.targets, seat.id) != r.targets.end() && std::ranges::any_of(r.references, sat_at);
      };
      if (std::ranges::none_of(scene_.relations, at_table)) return false;
    }
    return any;
  }

  void seat_at(std::size_t i) {
    const std::string id = scene_.objects[i].id, category = scene_.objects[i].category;
    const CatalogEntry* entry = catalog_.find(category);
    const SceneObject* sized = sized_.find_object(id);
    const Seating* seating = entry == nullptr ? nullptr : groups_.seating_at(catalog_, *entry, scene_.room.type);
    if (seating == nullptr || !(seating->comes || spoken_.says_any(groups_.sat_at)) || sized == nullptr || !sized->size ||
        sized->mount != Mount::kFloor)
      return;
    const CatalogEntry* seat = catalog_.find(seating->seat);
    const std::vector<Side> used = sized->used_sides.value_or(entry->used_sides);
    const auto is_used = [&](Side side) { return std::ranges::find(used, side) != used.end(); };
    // Who serves sits behind; the chairs that are named are the guests'.
    const bool serves = entry->is(Trait::kOpenToRoom) && is_used(Side::kBack) && is_used(Side::kFront);
    // … and seats that follow from how many people there are stand at tables of their own: the teacher's desk has its chair.
    const bool visited = entry->is(Trait::kDeskLike) && has_kind("visitor_chair");
    const bool named_only = serves || visited || !names_seat() || (entry->is(Trait::kDesk) && seats_are_taken());
    if (seat == nullptr || (named_only ? spoken_.names(*seat) : spoken_.of(*seat)) || has_seat(id) || (!serves && has_loose_seat())) return;
    const int count = std::min(seats_at_size(*seating, is_round(*sized, *entry), sized->size->usual), kMostSeats);
    std::vector<std::string> seats;
    for (int k = 0; k < count; ++k) seats.push_back(add(*seat));
    if (count > 1) {
      relate(RelationType::kAround, seats, id);
      return;
    }
    const bool knees = std::ranges::any_of(entry->spaces, [](const SpaceFormula& space) { return !space.carries; });
    if (knees && is_used(Side::kFront) && !serves && !visited) {  // pushed under, out of the way until somebody sits down
      relate(RelationType::kNextTo, seats, id);
      return;
    }
    const bool behind = serves || visited || (!is_used(Side::kFront) && is_used(Side::kBack));
    relate(behind ? RelationType::kBehind : RelationType::kInFrontOf, seats, id, measures().seat_at_hand);
    relate(RelationType::kFacing, seats, id);
  }

  // What stands on something, and has nothing to stand on, gets what usually carries it in such a room: a record player in the corner a
  // sideboard there, lamps at both sides of a bed a nightstand each.
  void carry(std::size_t i) {
    const SceneObject thing = scene_.objects[i];
    const CatalogEntry* entry = catalog_.find(thing.category);
    const SceneObject* sized = sized_.find_object(thing.id);
    if (entry == nullptr || entry->mount != Mount::kSurface || sized == nullptr || !sized->size) return;
    if (sized->mount != Mount::kFloor && !only_carriers_are_elsewhere(thing, *entry)) return;
    const auto is_such = [&](const std::string& kind) { return catalog_.is_a(thing.category, kind); };
    if (std::ranges::none_of(groups_.carried, is_such)) return;  // dolls, baskets and bowls may well lie on the floor
    const auto sides = [&](const Relation& r) {
      return (r.type == RelationType::kEachSideOf || traits_of(r.type).sideways) && targets(r, thing.id);
    };
    const auto supports = [&](const Relation& r) { return r.type == RelationType::kOn && targets(r, thing.id); };
    if (std::ranges::any_of(scene_.relations, supports)) return;  // said: on the floor
    const CatalogEntry* host = usual_host(*entry, sized->size->usual);
    if (host == nullptr) return;
    const bool own = std::ranges::any_of(scene_.relations, sides);
    std::string& shared = hosts_[host->id];
    const std::string id = own || shared.empty() ? add(*host) : shared;
    if (!own) shared = id;
    relate(RelationType::kOn, {thing.id}, id);
  }

  // A sewing machine under the window, where the only table has the middle of the room.
  bool only_carriers_are_elsewhere(const SceneObject& thing, const CatalogEntry& entry) const {
    const auto told = [&](const std::string& id, auto&& matches) {
      return std::ranges::any_of(scene_.relations, [&](const Relation& r) { return targets(r, id) && matches(r.type); });
    };
    const auto at_edge = [](RelationType type) {
      return type == RelationType::kUnderWindow || type == RelationType::kCorner || type == RelationType::kAgainstWall;
    };
    if (!told(thing.id, at_edge)) return false;
    bool any = false;
    for (const SceneObject& object : scene_.objects) {
      if (std::ranges::none_of(entry.stands_on, [&](const std::string& kind) { return catalog_.is_a(object.category, kind); })) continue;
      if (!told(object.id, [](RelationType type) { return type == RelationType::kCenterOfRoom; })) return false;
      any = true;
    }
    return any;
  }

  static bool targets(const Relation& relation, const std::string& id) {
    return std::ranges::find(relation.targets, id) != relation.targets.end();
  }

  bool has_bed() const {
    return std::ranges::any_of(scene_.objects, [&](const SceneObject& o) { return catalog_.entry_or_nearest(o.category).is(Trait::kBed); });
  }

  // Of the kinds that such a thing stands on the first that is usual in the room or goes with what is there, else the smallest.
  const CatalogEntry* usual_host(const CatalogEntry& thing, const Size& size) const {
    const CatalogEntry* smallest = nullptr;
    const auto area = [](const Size& s) { return double(s.width) * s.depth; };
    for (const std::string& id : thing.stands_on) {
      const CatalogEntry* host = catalog_.find(id);
      if (host == nullptr || host->mount != Mount::kFloor || host->is(Trait::kBed) || area(host->size.usual) <= area(size)) continue;
      if (spoken_.of(*host) || (host->is(Trait::kBedside) && !has_bed())) continue;
      const bool goes = std::ranges::any_of(host->beside, [&](const std::string& other) { return has_kind(other); });
      if (goes || (!scene_.room.type.empty() && std::ranges::find(host->rooms, scene_.room.type) != host->rooms.end())) return host;
      if (smallest == nullptr || area(host->size.usual) < area(smallest->size.usual)) smallest = host;
    }
    return smallest;
  }

  void add_by(const Companion& companion) {
    const CatalogEntry* kind = catalog_.find(companion.adds);
    if (kind == nullptr || !in_rooms(companion.rooms) || spoken_.of(*kind) || has_kind(companion.adds)) return;
    if (spoken_.keeps_off(companion.adds, "", scene_.room.type)) return;
    const auto named = [&](const std::string& other) {
      return std::ranges::any_of(named_, [&](std::size_t i) { return catalog_.is_a(scene_.objects[i].category, other); });
    };
    if (std::ranges::any_of(companion.unless, named)) return;
    const bool on_it = std::ranges::any_of(kind->stands_on, [&](const std::string& id) { return akin(id, companion.of); });
    const auto is_there = [&](const std::string& other) { return has_kind(other); };
    if (kind->mount == Mount::kSurface && !on_it && std::ranges::none_of(kind->stands_on, is_there)) return;  // no lamp on the floor
    // What stands on the floor comes with those kinds only that such a thing stands beside: no nightstand with a bunk bed.
    const auto takes = [&](const SceneObject& object) {
      const CatalogEntry* entry = catalog_.find(object.category);
      return entry != nullptr && catalog_.is_a(object.category, companion.of) &&
             (kind->mount != Mount::kFloor || companion.anywhere || (kind->is(Trait::kKitchenRun) && entry->is(Trait::kKitchenRun)) ||
              std::ranges::any_of(entry->beside, [&](const std::string& id) { return akin(id, kind->id); }));
    };
    std::vector<std::string> hosts;
    for (const SceneObject& object : scene_.objects) {
      if (takes(object)) hosts.push_back(object.id);
    }
    if (companion.up_to > 0 && hosts.size() > static_cast<std::size_t>(companion.up_to)) return;
    for (const std::string& host : hosts) {
      const SceneObject* sized = sized_.find_object(host);
      const bool for_two =
          companion.both_sides_from > 0 && sized != nullptr && sized->size && sized->size->usual.width >= companion.both_sides_from;
      for (int k = 0; k < companion.each * (for_two ? 2 : 1); ++k) {
        const std::string id = add(*kind);
        if (on_it && kind->mount == Mount::kSurface) relate(RelationType::kOn, {id}, host);
      }
    }
  }

  bool stands(const SceneObject& object) const {
    const CatalogEntry* entry = catalog_.find(object.category);
    return entry != nullptr && object.mount.value_or(entry->mount) == Mount::kFloor && !entry->thin && !entry->is(Trait::kPet);
  }

  double covered(const SceneGraph& scene) const {
    double area = 0;
    for (const SceneObject& object : scene.objects) {
      const CatalogEntry& entry = catalog_.entry_or_nearest(object.category);
      const Size& size = object.size ? object.size->usual : entry.size.usual;
      if (object.mount.value_or(entry.mount) == Mount::kFloor && !entry.thin) area += double(size.width) * size.depth;
    }
    return area;
  }

  // Does the text say where furniture stands? Then it is the whole arrangement; rows and ways to look alone are not.
  bool says_where() const {
    const auto is_furniture = [&](const std::string& id) {
      const SceneObject* object = scene_.find_object(id);
      return object != nullptr && stands(*object);
    };
    return std::ranges::any_of(scene_.relations, [&](const Relation& r) {
      const RelationTraits& traits = traits_of(r.type);
      return r.origin == Origin::kAsked && !traits.order_only && !traits.turns && std::ranges::any_of(r.targets, is_furniture);
    });
  }

  // A kitchen of which little is named has what one cooks with, wherever the text places that little.
  void add_needs() {
    constexpr std::size_t kLittle = 3;  // kinds of furniture
    const RoomKind* room = scene_.room.type.empty() ? nullptr : catalog_.find_room(scene_.room.type);
    std::set<std::string> kinds;
    for (const std::size_t i : named_) {
      if (stands(scene_.objects[i])) kinds.insert(scene_.objects[i].category);
    }
    if (room == nullptr || kinds.size() > kLittle || spoken_.says_any(groups_.none_to_fill)) return;
    for (const std::vector<std::string>& any_of : room->needs) {
      const CatalogEntry* usual = catalog_.find(any_of.front());
      const auto is_there = [&](const std::string& id) { return has_kind(id); };
      if (usual != nullptr && !spoken_.of(*usual) && std::ranges::none_of(any_of, is_there)) add(*usual);
    }
  }

  // What a bare room of that kind mostly has, the most important first.
  void fill() {
    const RoomKind* kind = scene_.room.type.empty() ? nullptr : catalog_.find_room(scene_.room.type);
    const double floor = std::max(1.0, double(doubled_area(sized_.room.polygon)) / 2);
    double share = covered(scene_) / floor;
    const bool hardly_any =
        std::ranges::count_if(named_, [&](std::size_t i) { return stands(scene_.objects[i]); }) <= groups_.fill.hardly_any;
    const double until = hardly_any ? groups_.fill.usually_covered : groups_.fill.until;
    if (kind == nullptr || share >= (hardly_any ? until : groups_.fill.bare) || spoken_.says_any(groups_.none_to_fill)) return;
    constexpr std::ptrdiff_t kCrowd = 6;
    const std::ptrdiff_t crowd = std::ranges::count_if(
        named_, [&](std::size_t i) { return catalog_.entry_or_nearest(scene_.objects[i].category).is(Trait::kSeat); });
    const bool looked_at = std::ranges::any_of(
        named_, [&](std::size_t i) { return catalog_.entry_or_nearest(scene_.objects[i].category).is(Trait::kScreen); });
    int added = 0;
    for (const auto& [id, usual] : kind->usual) {
      const CatalogEntry* entry = catalog_.find(id);
      if (entry == nullptr || spoken_.of(*entry) || has_kind(id) || spoken_.keeps_off(id, "", scene_.room.type)) continue;
      const auto is_there = [&](const std::string& other) { return has_kind(other); };
      const bool lacks_host = entry->mount == Mount::kSurface && std::ranges::none_of(entry->stands_on, is_there);
      const bool lacks_table = entry->is(Trait::kTableSeat) && std::ranges::none_of(entry->beside, is_there);
      const auto is_taken = [&](const SceneObject& o) {
        return std::ranges::any_of(entry->beside, [&](const std::string& other) { return catalog_.is_a(o.category, other); }) &&
               has_seat(o.id);
      };
      const bool seated = entry->is(Trait::kTableSeat) && std::ranges::any_of(scene_.objects, is_taken);
      // Where a crowd of seats is named, they stand in rows without desks.
      const bool desk = entry->is(Trait::kDeskLike) && crowd >= kCrowd;
      // … and what all look at is there once.
      const bool board = entry->is(Trait::kScreen) && entry->mount == Mount::kWall && looked_at;
      const bool instead =
          std::ranges::any_of(groups_.fill.unless, [&](const auto& row) { return row.first == id && has_kind(row.second); });
      if (instead || lacks_host || lacks_table || seated || desk || board) continue;
      const bool takes_floor = entry->mount == Mount::kFloor && !entry->thin;
      const auto has_room = [&] { return share < until || (hardly_any && !takes_floor); };
      for (int k = 0; k < usual && added < groups_.fill.most && has_room(); ++k, ++added) {
        add(*entry);
        share = covered(scene_) / floor;
      }
    }
  }

  SceneGraph& scene_;
  const SceneGraph& sized_;
  const Catalog& catalog_;
  const Groups& groups_;
  const Spoken spoken_;
  std::vector<std::size_t> named_;
  std::map<std::string, std::string> hosts_;  // that came for small things, by kind
  int relations_ = 0;
};

}  // namespace

std::size_t add_companions(SceneGraph& scene, const SceneGraph& sized, const std::vector<std::string>& excluded, const Catalog& catalog) {
  return Companions(scene, sized, excluded, catalog).run();
}

}  // namespace layoutbox
