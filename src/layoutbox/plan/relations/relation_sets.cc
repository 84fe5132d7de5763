// Things that make one with another: a chair in the shower, a bench in the rack, a music stand before who plays; who lies and waits along
// walls.
#include <algorithm>
#include <map>

#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/measures.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/plan/room/room_reader.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;

namespace {

// Of the things of such kinds the one of that rank, round and round; null: there is none.
const SceneObject* host_of(const Catalog& catalog, const std::vector<SceneObject>& objects, const std::vector<std::string>& kinds,
                           std::size_t rank) {
  std::vector<const SceneObject*> hosts;
  for (const std::string& kind : kinds) {
    if (!hosts.empty()) break;
    for (const SceneObject& object : objects) {
      if (catalog.is_a(object.category, kind)) hosts.push_back(&object);
    }
  }
  return hosts.empty() ? nullptr : hosts[rank % hosts.size()];
}

}  // namespace

// The things of the rows, with those that they are said to be with, or by nothing: each is put to its host by one relation.
void RelationBuilder::stand_within() {
  std::map<std::string, std::size_t> ranks;
  for (const SceneObject& thing : scene_.objects) {
    const CatalogEntry* entry = catalog_.find(thing.category);
    if (entry == nullptr || entry->mount != Mount::kFloor) continue;
    const auto& by = Groups::usual_at(Groups::builtin().by, catalog_, *entry, Mount::kFloor);
    const SceneObject* mate = by.empty() ? nullptr : host_of(catalog_, scene_.objects, by, 0);
    if (mate != nullptr && relations_of(thing.id).empty())
      add_habit(R::kNextTo, {thing.id}, {mate->id}, kTogether, "such a thing stands by it");
    const std::vector<std::string>& kinds = Groups::usual_at(Groups::builtin().within, catalog_, *entry, Mount::kFloor);
    const SceneObject* host = kinds.empty() ? nullptr : host_of(catalog_, scene_.objects, kinds, ranks[thing.category]++);
    const std::vector<std::size_t> own = relations_of(thing.id);
    const auto only_with = [&](std::size_t r) {
      const Relation& relation = scene_.relations[r];
      return traits_of(relation.type).close_by && relation.targets.size() == 1 && relation.references == std::vector{host->id} &&
             words_.have(relation, "with");
    };
    if (host == nullptr || !std::ranges::all_of(own, only_with)) continue;
    if (own.empty()) {
      add_habit(R::kIn, {thing.id}, {host->id}, kTogether, "such a thing is used within it").origin = Origin::kConcluded;
    } else {
      scene_.relations[own.front()].type = R::kIn;
      scene_.relations[own.front()].parameters = {};
    }
  }
}

// "five chairs with music stands": before each, turned to who sits there.
void RelationBuilder::stand_before_sitters() {
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    Relation& with = scene_.relations[r];
    const bool two = with.targets.size() == 1 && with.references.size() == 1;
    if (!two || !traits_of(with.type).close_by || !words_.have(with, "with")) continue;
    const SceneObject *thing = object_of(with.targets[0]), *host = object_of(with.references[0]);
    const CatalogEntry* entry = thing == nullptr || host == nullptr ? nullptr : catalog_.find(thing->category);
    if (entry == nullptr || entry->mount != Mount::kFloor) continue;
    const std::vector<std::string>& kinds = Groups::usual_at(Groups::builtin().before, catalog_, *entry, Mount::kFloor);
    if (std::ranges::none_of(kinds, [&](const std::string& kind) { return catalog_.is_a(host->category, kind); })) continue;
    with.type = R::kInFrontOf;
    with.parameters = {};
    const Relation before = with;
    if (entry->has_front) add_habit(R::kFacing, before.targets, before.references, kTogether, "it is turned to who sits there");
  }
}

// "a desk with free space beneath", for who comes in a wheelchair: that is drawn up to it, and nothing is under that.
void RelationBuilder::sit_in_aids() {
  for (std::size_t r = 0; r < scene_.relations.size(); ++r) {
    Relation& under = scene_.relations[r];
    if (under.type != R::kUnder || under.targets.size() != 1 || under.references.size() != 1) continue;
    const SceneObject *table = object_of(under.targets[0]), *aid = object_of(under.references[0]);
    if (table == nullptr || aid == nullptr || !catalog_.entry_or_nearest(aid->category).is(Trait::kPersonalAid)) continue;
    if (!is_table(catalog_, noun_of_object(*table))) continue;
    std::swap(under.targets, under.references);
    under.type = R::kInFrontOf;
    under.parameters = {};
    under.parameters.max = measures().seat_at_hand;
    const Relation before = under;
    add_habit(R::kFacing, before.targets, before.references, kTogether, "who comes in it sits at the table");
  }
}

// "Two desks back to back" touch, one all along the other, where nothing is between them.
void RelationBuilder::touch_back_to_back() {
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    Relation& beside = scene_.relations[r];
    const bool backs = beside.type == R::kNextTo && beside.targets.size() == 1 && beside.references.size() == 1 &&
                       words_.have_phrase(beside, {"back", "to", "back"});
    if (!backs) continue;
    const auto both_behind = [&](const Relation& other) {
      return other.type == R::kBehind && other.targets == beside.references && other.references == beside.targets;
    };
    const auto parts = [&](const Relation& other) {
      const auto has = [&](const std::string& id) { return std::ranges::find(other.references, id) != other.references.end(); };
      return other.type == R::kBetween && has(beside.targets[0]) && has(beside.references[0]);
    };
    if (std::ranges::none_of(scene_.relations, both_behind) || std::ranges::any_of(scene_.relations, parts)) continue;
    beside.parameters.max = 0;
    const Relation touching = beside;
    add_habit(R::kCenteredOn, touching.references, touching.targets, kTogether, "what is back to back is so all along");
  }
}

// "an exam couch against the right wall": along it. Who lies there is not got at from its head alone.
void RelationBuilder::lie_along_walls() {
  constexpr Mm kForOne = 1200;
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    Relation& at = scene_.relations[r];
    const SceneObject* object = at.type == R::kAgainstWall && at.targets.size() == 1 ? object_of(at.targets[0]) : nullptr;
    const CatalogEntry* entry = object == nullptr ? nullptr : catalog_.find(object->category);
    // … and "a single bed along the left wall" lies along it
    const bool for_one = entry != nullptr && entry->is(Trait::kBed) && entry->size.usual.width <= kForOne && words_.have(at, "along");
    // "a long bench against the wall": its long side is
    const bool long_one = entry != nullptr && !entry->has_front && entry->mount == Mount::kFloor && !entry->thin &&
                          entry->size.usual.width >= 2 * entry->size.usual.depth && at.asked() && !words_.have(at, WordSet::kHeadEnds);
    if (long_one) {
      const std::vector<std::string> targets = at.targets, walls = at.references;
      add_habit(R::kSideAgainstWall, targets, walls, kTogether, "long things stand along walls").parameters.side = Side::kLong;
      continue;
    }
    if (entry == nullptr || !(entry->is(Trait::kLieOn) || for_one) || (entry->is(Trait::kBed) && !for_one) || !at.asked()) continue;
    if (2 * entry->size.usual.depth >= 3 * entry->size.usual.width && !words_.have(at, WordSet::kHeadEnds)) at.type = R::kSideAgainstWall;
  }
}

// "Coat hooks and a shoe bench on the left, a console table on the right": at the walls of those sides, not beside one another.
void RelationBuilder::stand_at_both_sides() {
  const auto hangs_on_wall = [&](const std::string& id) {  // nothing stands at the sides of such a thing
    const SceneObject* object = object_of(id);
    return object != nullptr && mount_of(noun_of_object(*object)) == Mount::kWall;
  };
  const auto says = [&](const Relation& r, R type, const char* side) {
    return r.type == type && r.asked() && r.targets.size() == 1 && r.references.size() == 1 && words_.have_phrase(r, {"on", "the", side}) &&
           words_.are_without_reference(r) && hangs_on_wall(r.references[0]);
  };
  const std::vector<Relation> said = scene_.relations;
  for (const Relation& left : said) {
    if (!says(left, R::kLeftOf, "left")) continue;
    const auto right =
        std::ranges::find_if(said, [&](const Relation& r) { return says(r, R::kRightOf, "right") && r.references == left.references; });
    if (right == said.end()) continue;
    std::erase_if(scene_.relations, [&](const Relation& r) { return r.id == left.id || r.id == right->id; });
    const auto put = [&](std::string thing, const char* side) {
      for (const Relation& r : said) {  // what hangs above something is where that is
        if (r.type == R::kAbove && r.targets == std::vector{thing} && r.references.size() == 1) thing = r.references[0];
      }
      const SceneObject* object = object_of(thing);
      if (object == nullptr) return;
      const Mount mount = mount_of(noun_of_object(*object));
      if (mount != Mount::kFloor && mount != Mount::kWall) return;
      add_habit(mount == Mount::kWall ? R::kOnWall : R::kAgainstWall, {thing}, {side}, kTogether, "at the walls of both sides");
      scene_.relations.back().hard = true;
      scene_.relations.back().origin = Origin::kAsked;
    };
    put(left.references[0], "left");
    put(left.targets[0], "left");
    put(right->targets[0], "right");
  }
}

// "a waiting bench opposite": with its back to a wall, out of the way.
void RelationBuilder::wait_at_walls() {
  const std::size_t said = scene_.objects.size();
  for (std::size_t i = 0; i < said; ++i) {
    const SceneObject& seat = scene_.objects[i];
    const NounPhrase& noun = noun_of_object(seat);
    const CatalogEntry* entry = noun.entry;
    const bool waits = noun.name.find("waiting") != std::string::npos || contains_word(noun.attributes, "waiting");
    if (entry == nullptr || !waits || entry->mount != Mount::kFloor || !is_seat(catalog_, noun)) continue;
    const bool told = std::ranges::any_of(relations_of(seat.id), [&](std::size_t r) {
      const R type = scene_.relations[r].type;
      return traits_of(type).back_to_wall || traits_of(type).around || type == R::kCenterOfRoom || type == R::kRow || type == R::kGrid;
    });
    if (told) continue;
    add_habit(entry->has_front ? R::kAgainstWall : R::kSideAgainstWall, {seat.id}, {}, kTogether, "who waits sits along the walls");
    if (!entry->has_front) scene_.relations.back().parameters.side = Side::kLong;
  }
}

// "two bean bags", "a place for friends to sit": who sits on such seats sits together, where nothing says otherwise.
void RelationBuilder::sit_together() {
  constexpr std::size_t kMost = 4;
  for (const Mention& mention : document_.mentions) {
    const CatalogEntry* entry = mention.noun.entry;
    if (!mention.introduces || entry == nullptr || mention.items.size() < 2 || mention.items.size() > kMost) continue;
    if (!catalog_.is_a(entry->id, "bean_bag") && !catalog_.is_a(entry->id, "floor_cushion") && !catalog_.is_a(entry->id, "recliner"))
      continue;
    const bool told = std::ranges::any_of(mention.items, [&](int item) { return !relations_of(id(item)).empty(); });
    if (told) continue;
    const std::string first = id(mention.items.front());
    for (std::size_t k = 1; k < mention.items.size(); ++k)
      add_habit(R::kNextTo, {id(mention.items[k])}, {first}, kTogether, "seats of one kind stand together");
  }
}

// A printer does not stand where several sit round a table, unless such a table is what it mostly stands on.
bool RelationBuilder::is_sat_round(const std::string& table, const NounPhrase& thing) const {
  const SceneObject* object = object_of(table);
  if (object == nullptr || thing.entry == nullptr ||
      std::ranges::find(thing.entry->stands_on, object->category) != thing.entry->stands_on.end())
    return false;
  return std::ranges::any_of(scene_.relations, [&](const Relation& r) {
    return traits_of(r.type).around && r.targets.size() > 1 && r.references == std::vector{table};
  });
}

// "the counter at the back": one serves over it towards the room.
void RelationBuilder::serve_towards_room(const SceneObject& counter, const std::string& end) {
  const CatalogEntry& entry = catalog_.entry_or_nearest(counter.category);
  const bool looks =
      std::ranges::any_of(relations_of(counter.id), [&](std::size_t r) { return traits_of(scene_.relations[r].type).looks; });
  if (!looks && entry.has_front && entry.is(Trait::kOpenToRoom) && entry.is(Trait::kCounter) && entry.used_sides.size() < 4)
    add_habit(R::kFacing, {counter.id}, {wall_across(end)}, kTogether, "one serves towards the room");
}

}  // namespace layoutbox::offline
