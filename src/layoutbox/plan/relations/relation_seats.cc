// Where those sit of whom nobody says where: at the only table, along the walls, around what they look at.
#include <algorithm>
#include <map>

#include "layoutbox/catalog/measures.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;

// Where people wait the chairs of which nothing is said stand along the walls, more than sit at a table there.
void RelationBuilder::seat_those_who_wait() {
  constexpr std::size_t kMany = 5;
  if (!one_of(scene_.room.type, {"waiting_room", "reception", "lobby", "clinic"})) return;
  std::map<std::string, std::vector<std::string>> chairs;  // by kind
  for (const SceneObject& object : scene_.objects) {
    const CatalogEntry* entry = catalog_.find(object.category);
    if (entry != nullptr && entry->is(Trait::kTableSeat) && relations_of(object.id).empty()) chairs[entry->id].push_back(object.id);
  }
  for (const auto& [kind, alike] : chairs) {
    if (alike.size() < kMany) continue;
    for (const std::string& chair : alike) add_habit(R::kAgainstWall, {chair}, {}, 100, "who waits sits along the walls");
  }
}

// Is nothing said of it but that it is by a door or window?
bool RelationBuilder::is_only_by_opening(const std::string& object) const {
  return std::ranges::all_of(relations_of(object), [&](std::size_t r) {
    const Relation& relation = scene_.relations[r];
    return traits_of(relation.type).close_by &&
           std::ranges::all_of(relation.references, [&](const std::string& id) { return scene_.find_object(id) == nullptr; });
  });
}

// "a table and six chairs in the middle": the table is, the chairs are at it.
void RelationBuilder::seat_at_placed_table() {
  for (std::size_t r = 0; r < scene_.relations.size(); ++r) {
    Relation& middle = scene_.relations[r];
    if (middle.type != R::kCenterOfRoom || middle.targets.size() < 3) continue;
    std::vector<std::string> tables, seats;
    for (const std::string& one : middle.targets) {
      const SceneObject* object = object_of(one);
      const CatalogEntry* entry = object == nullptr ? nullptr : noun_of_object(*object).entry;
      if (entry != nullptr && is_eaten_at(noun_of_object(*object))) tables.push_back(one);
      if (entry != nullptr && entry->is(Trait::kTableSeat)) seats.push_back(one);
    }
    if (tables.size() != 1 || tables.size() + seats.size() != middle.targets.size()) continue;
    middle.targets = tables;
    Link link;
    link.first = noun_of_object(*object_of(seats.front())).first;
    link.last = noun_of_object(*object_of(seats.front())).last;
    link.concluded = true;
    for (const std::string& seat : seats) std::erase(of_target_[seat], r);
    return add(link, R::kAround, seats, tables);
  }
}

// "an oval table, ten swivel chairs": at the only table that has no seats, where nobody says where they are.
void RelationBuilder::seat_at_only_table() {
  std::vector<int> tables, seats;
  for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
    const NounPhrase& noun = document_.items[i].noun;
    if (noun.entry == nullptr || mount_of(noun) != Mount::kFloor) continue;
    const CatalogEntry& entry = *noun.entry;
    const bool works = entry.is(Trait::kDeskLike) || entry.is(Trait::kDesk) || entry.is(Trait::kCounter);
    if (works) return;  // the chairs may be its
    if (entry.is(Trait::kTableSeat) && is_only_by_opening(scene_.objects[i].id)) seats.push_back(static_cast<int>(i));
    if (is_eaten_at(noun)) tables.push_back(static_cast<int>(i));
  }
  constexpr std::size_t kFewest = 2;
  const auto has_seats = [&](const Relation& r) {
    const bool at_it = traits_of(r.type).around || r.type == R::kAlongSide;
    const SceneObject* seat = at_it ? object_of(r.targets.front()) : nullptr;
    return seat != nullptr && is_seat(catalog_, noun_of_object(*seat)) && r.references == ids(tables);
  };
  // "one of the chairs is by the window", and sits at the table with the others; by itself it stands at the window.
  const auto unsaid = [&](int seat) { return relations_of(scene_.objects[static_cast<std::size_t>(seat)].id).empty(); };
  if (std::ranges::count_if(seats, unsaid) < std::ptrdiff_t{2}) std::erase_if(seats, [&](int seat) { return !unsaid(seat); });
  if (tables.size() != 1 || seats.size() < kFewest || std::ranges::any_of(scene_.relations, has_seats)) return;
  Link link;
  link.first = document_.items[static_cast<std::size_t>(seats.front())].noun.first;
  link.last = document_.items[static_cast<std::size_t>(seats.front())].noun.last;
  link.concluded = true;
  add(link, R::kAround, ids(seats), ids(tables));
}

// A table high and large enough to sit at with others.
bool RelationBuilder::is_eaten_at(const NounPhrase& noun) const {
  const CatalogEntry& entry = *noun.entry;
  const Size& usual = entry.size.usual;
  return entry.is(Trait::kTable) && !entry.is(Trait::kCoffeeTable) && usual.height >= measures().eaten_at_high &&
         std::min(usual.width, usual.depth) >= measures().eaten_at_wide && one_of(noun.head, {"table"});
}

// "four manicure tables along the wall, each with two chairs": a table at which one sits face to face has its narrow end at the wall.
void RelationBuilder::turn_two_sided_tables() {
  for (Relation& wall : scene_.relations) {
    const SceneObject* table = wall.type == R::kAgainstWall && wall.targets.size() == 1 ? object_of(wall.targets.front()) : nullptr;
    const CatalogEntry* entry = table == nullptr ? nullptr : catalog_.find(table->category);
    if (entry == nullptr || entry->used_sides != std::vector{Side::kFront, Side::kBack} || !entry->is(Trait::kTable)) continue;
    const auto seats_two = [&](const Relation& r) {
      return (traits_of(r.type).around || r.type == R::kEachSideOf) && r.targets.size() > 1 && r.references == wall.targets;
    };
    if (std::ranges::any_of(scene_.relations, seats_two)) wall.type = R::kSideAgainstWall;
  }
}

// "two armchairs facing a round coffee table": they sit around it, one beside or across from the other, not one behind the other.
void RelationBuilder::seat_around_faced_tables() {
  std::map<std::string, std::vector<std::string>> at;  // table: its seats
  for (const Relation& look : scene_.relations) {
    if (look.type != R::kFacing || look.targets.size() != 1 || look.references.size() != 1 || !look.asked()) continue;
    const SceneObject *seat = object_of(look.targets.front()), *table = object_of(look.references.front());
    if (seat == nullptr || table == nullptr || !is_seat(catalog_, noun_of_object(*seat)) || !is_table(catalog_, noun_of_object(*table)))
      continue;
    const CatalogEntry* entry = noun_of_object(*table).entry;
    const bool works = entry == nullptr || entry->is(Trait::kDesk) || entry->is(Trait::kDeskLike) || entry->is(Trait::kCounter);
    const bool elsewhere = std::ranges::any_of(relations_of(seat->id), [&](std::size_t r) {
      const Relation& own = scene_.relations[r];
      const bool at_opening = own.type == R::kNextTo && own.references.size() == 1 && object_of(own.references.front()) == nullptr;
      return own.type != R::kFacing && own.type != R::kNear && own.type != R::kOn && !at_opening;
    });
    if (!works && !elsewhere) at[table->id].push_back(seat->id);
  }
  for (auto& [table, seats] : at) {
    if (seats.size() > 1) add_habit(R::kAround, seats, {table}, kTogether, "who looks at a table sits around it");
  }
}

// Who has a table beside the seat reaches it; two that look at one thing and have a table between them sit side by side.
void RelationBuilder::seat_in_reach(const std::vector<std::pair<std::string, std::string>>& in_reach) {
  for (const auto& [seat, table] : in_reach)
    add_habit(R::kNextTo, {seat}, {table}, kTogether, "a table between two seats is in reach of both");
  const auto look_of = [&](const std::string& seat) {
    for (const std::size_t r : relations_of(seat)) {
      if (scene_.relations[r].type == R::kFacing && scene_.relations[r].targets.size() == 1) return scene_.relations[r].references;
    }
    return std::vector<std::string>{};
  };
  for (std::size_t s = 0; s + 1 < in_reach.size(); s += 2) {
    const std::string &one = in_reach[s].first, &other = in_reach[s + 1].first;
    if (const auto seen = look_of(one); seen.empty() || seen != look_of(other) || seen.front() == other) continue;
    const auto conclude = [&](R type, const std::string& thing, std::string_view why) {
      RelationBuilder::conclude(type, {thing}, {one}, std::string(why));
    };
    for (const R type : {R::kSameOrientation, R::kEdgeAlign}) conclude(type, other, "who looks at one thing sits side by side");
    conclude(R::kSameOrientation, in_reach[s].second, "a table between two seats looks as they do");
  }
}

// The mirror on a wall that a relation has a seat look into; null: it says nothing of the kind.
const SceneObject* RelationBuilder::mirror_looked_into(const Relation& looks) const {
  if (looks.type != R::kFacing || looks.targets.size() != 1 || looks.references.size() != 1) return nullptr;
  const SceneObject *seat = object_of(looks.targets[0]), *mirror = object_of(looks.references[0]);
  if (seat == nullptr || mirror == nullptr || !is_seat(catalog_, noun_of_object(*seat))) return nullptr;
  const CatalogEntry* glass = noun_of_object(*mirror).entry;
  return glass != nullptr && glass->is(Trait::kMirror) && mount_of(noun_of_object(*mirror)) == Mount::kWall ? mirror : nullptr;
}

// "three chairs facing three mirrors, each with a counter": the mirror hangs over the counter, and the chair stands before both.
void RelationBuilder::hang_mirrors_over_counters() {
  std::map<std::string, std::size_t> counter_by;  // the relation that puts one beside the seat or the mirror
  for (std::size_t r = 0; r < scene_.relations.size(); ++r) {
    const Relation& beside = scene_.relations[r];
    if (beside.type != R::kNextTo || beside.targets.size() != 1 || beside.references.size() != 1) continue;
    const SceneObject* counter = object_of(beside.targets[0]);
    const CatalogEntry* top = counter == nullptr ? nullptr : noun_of_object(*counter).entry;
    const bool stands = top != nullptr && top->mount == Mount::kFloor;
    if (stands && (top->is(Trait::kCounter) || top->is(Trait::kTable) || top->back_to_wall)) counter_by.emplace(beside.references[0], r);
  }
  std::vector<std::string> counters;
  const std::size_t said = counter_by.empty() ? 0 : scene_.relations.size();
  for (std::size_t f = 0; f < said; ++f) {
    const SceneObject* mirror = mirror_looked_into(scene_.relations[f]);
    const auto hangs_over = [&](std::size_t r) { return scene_.relations[r].type == R::kAbove; };
    if (mirror == nullptr || std::ranges::any_of(relations_of(mirror->id), hangs_over)) continue;
    const auto by_seat = counter_by.find(scene_.relations[f].targets[0]), by_mirror = counter_by.find(mirror->id);
    const auto found = by_seat != counter_by.end() ? by_seat : by_mirror;
    if (found == counter_by.end()) continue;
    Relation& beside = scene_.relations[found->second];
    const std::string counter = beside.targets[0];
    if (found == by_seat) {
      beside.type = R::kInFrontOf;
      std::swap(beside.targets, beside.references);
    }
    counters.push_back(counter);
    add_habit(R::kAbove, {mirror->id}, {counter}, kTogether, "one looks into the mirror over the counter");
    scene_.relations.back().hard = true;
  }
  if (counters.size() < 2) return;
  add_habit(R::kRow, counters, {}, kTogether, "places of work of one kind stand in a row");
  scene_.relations.back().hard = true;
}

// "Eight chairs surround the table in the middle of the room": the table is there, the chairs only about it.
void RelationBuilder::middle_what_is_surrounded() {
  for (Relation& middle : scene_.relations) {
    if (middle.type != R::kCenterOfRoom || middle.targets.size() < 2) continue;
    const auto round = std::ranges::find_if(scene_.relations, [&](const Relation& r) {
      return traits_of(r.type).around && r.references.size() == 1 && r.targets == middle.targets;
    });
    if (round != scene_.relations.end()) middle.targets = round->references;
  }
}

}  // namespace layoutbox::offline
