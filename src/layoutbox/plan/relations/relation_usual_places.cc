// Where single things usually are that the text puts somewhere: under counters, at doors, in windows, along walls.
#include <algorithm>

#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/opening_look.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;

// A hood of which nobody says where it hangs is over the fire.
void RelationBuilder::hang_hoods() {
  for (const SceneObject& hood : scene_.objects) {
    if (!catalog_.entry_or_nearest(hood.category).is(Trait::kHood)) continue;
    const auto fire =
        std::ranges::find_if(scene_.objects, [&](const SceneObject& o) { return catalog_.entry_or_nearest(o.category).is(Trait::kHob); });
    const std::vector<std::size_t>& own = relations_of(hood.id);
    // "the sink, then the stove with a hood above": over no sink and no fridge where there is a fire.
    for (const std::size_t r : own) {
      Relation& above = scene_.relations[r];
      const bool alone = above.type == R::kAbove && above.references.size() == 1 && fire != scene_.objects.end();
      const SceneObject* under = alone ? object_of(above.references[0]) : nullptr;
      const CatalogEntry* unit = under == nullptr ? nullptr : catalog_.find(under->category);
      if (unit != nullptr && unit->is(Trait::kKitchenRun) && !unit->is(Trait::kHob) && !unit->is(Trait::kCounter))
        above.references = {fire->id};
    }
    const bool placed = std::ranges::any_of(own, [&](std::size_t r) {
      const Relation& relation = scene_.relations[r];
      return relation.type != R::kNextTo && !relation.references.empty() && object_of(relation.references.front()) != nullptr;
    });
    if (fire != scene_.objects.end() && !placed) add_habit(R::kAbove, {hood.id}, {fire->id}, 100, "a hood hangs over the fire");
  }
}

// "a toilet behind a half wall": it is not seen from the door.
void RelationBuilder::screen_from_door() {
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    const Relation behind = scene_.relations[r];
    if (behind.type != R::kBehind || behind.targets.size() != 1 || behind.references.size() != 1) continue;
    const SceneObject *thing = object_of(behind.targets[0]), *screen = object_of(behind.references[0]);
    if (thing == nullptr || screen == nullptr || !catalog_.is_a(screen->category, "screen_divider")) continue;
    add_habit(R::kBetween, behind.references, {thing->id, "door"}, kTogether, "what is behind a screen is not seen from the door").origin =
        Origin::kConcluded;
  }
}

// "two single beds on opposite walls": along them, not with their heads to them.
void RelationBuilder::lay_beds_along() {
  constexpr Mm kForOne = 1200;
  std::vector<Relation*> beds;
  for (Relation& r : scene_.relations) {
    const SceneObject* object =
        r.type == R::kAgainstWall && r.targets.size() == 1 && r.references.size() == 1 ? object_of(r.targets[0]) : nullptr;
    const CatalogEntry* entry = object == nullptr ? nullptr : catalog_.find(object->category);
    if (entry != nullptr && entry->is(Trait::kBed) && entry->size.usual.width <= kForOne) beds.push_back(&r);
  }
  // Bunk beds are climbed into from the side: the other one is at the wall.
  const auto is_climbed_into = [&](const std::string& id) {
    const SceneObject* bed = object_of(id);
    return bed != nullptr && catalog_.entry_or_nearest(bed->category).is(Trait::kClimbedInto);
  };
  for (Relation& r : scene_.relations) {
    const bool at_wall = r.type == R::kAgainstWall && r.targets.size() == 1 && is_climbed_into(r.targets[0]);
    if (at_wall && !words_.have(r, WordSet::kHeadEnds)) r.type = R::kSideAgainstWall;
  }
  const bool apart = beds.size() == 2 && beds[0]->references != beds[1]->references && words_.are_one(*beds[0], *beds[1]);
  for (Relation* r : beds) {
    if (apart) r->type = R::kSideAgainstWall;
  }
}

// "a washer and a dryer, a counter above them": they stand under it.
void RelationBuilder::stand_under_counters() {
  for (Relation& relation : scene_.relations) {
    const bool on_top = relation.type == R::kOn && words_.have(relation, "top");
    if ((relation.type != R::kAbove && !on_top) || relation.targets.size() != 1 || relation.references.empty()) continue;
    const auto stands = [&](const std::string& id) {
      const SceneObject* object = object_of(id);
      return object != nullptr && mount_of(noun_of_object(*object)) == Mount::kFloor;
    };
    const SceneObject* top = object_of(relation.targets.front());
    const CatalogEntry* entry = top == nullptr ? nullptr : noun_of_object(*top).entry;
    if (entry == nullptr || !(entry->is(Trait::kCounter) || entry->is(Trait::kTable)) || !std::ranges::all_of(relation.references, stands))
      continue;
    if (!stands(relation.targets.front())) continue;
    std::swap(relation.targets, relation.references);
    relation.type = R::kUnder;
    std::ranges::find(scene_.objects, relation.references.front(), &SceneObject::id)->mount = Mount::kFloor;
    // "a washer and a dryer side by side, a counter above them": both.
    const bool them = on_top || words_.have(relation, "them");
    for (const Relation& beside : scene_.relations) {
      if (!them || beside.type != R::kNextTo || beside.targets.size() != 1 || beside.references.size() != 1) continue;
      const bool first = beside.targets == relation.targets, second = beside.references == relation.targets;
      const std::string& mate = first ? beside.references.front() : beside.targets.front();
      if ((!first && !second) || mate == relation.references.front() || !stands(mate) ||
          (on_top && !words_.have_phrase(beside, {"side", "by", "side"})))
        continue;
      relation.targets.push_back(mate);
      break;
    }
  }
}

// "A counter along the back wall, a chair behind it": as far off the wall as who serves there needs, and who sits there looks over it.
void RelationBuilder::leave_room_to_serve() {
  constexpr Mm kToPass = 700;
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    const Relation behind = scene_.relations[r];
    if (behind.type != R::kBehind || behind.targets.size() != 1 || behind.references.size() != 1) continue;
    const SceneObject *thing = object_of(behind.targets[0]), *counter = object_of(behind.references[0]);
    if (thing == nullptr || counter == nullptr || mount_of(noun_of_object(*thing)) != Mount::kFloor) continue;
    const CatalogEntry &own = catalog_.entry_or_nearest(thing->category), &served = catalog_.entry_or_nearest(counter->category);
    if (std::ranges::find(served.used_sides, Side::kBack) == served.used_sides.end()) continue;
    for (Relation& wall : scene_.relations) {
      if (wall.type == R::kAgainstWall && wall.targets == behind.references) wall.parameters.gap = own.size.usual.depth + kToPass;
    }
    const bool looks =
        std::ranges::any_of(relations_of(thing->id), [&](std::size_t t) { return traits_of(scene_.relations[t].type).turns; });
    if (own.is(Trait::kSeat) && !looks) add_habit(R::kFacing, {thing->id}, {counter->id}, kTogether, "who serves looks over the counter");
  }
}

// "A reception desk on the far wall": whoever serves there sits between it and the wall.
void RelationBuilder::leave_room_at_wall() {
  constexpr Mm kToSit = 1300;
  for (Relation& wall : scene_.relations) {
    if (wall.type != R::kAgainstWall || wall.targets.size() != 1) continue;
    const SceneObject* counter = object_of(wall.targets[0]);
    const CatalogEntry* entry = counter == nullptr ? nullptr : catalog_.find(counter->category);
    const bool served = entry != nullptr && entry->is(Trait::kOpenToRoom) && entry->is(Trait::kDeskLike) &&
                        std::ranges::find(entry->used_sides, Side::kBack) != entry->used_sides.end();
    if (served && (words_.have(wall, "on") || words_.have(wall, "at")) && wall.parameters.gap.value_or(0) < kToSit)
      wall.parameters.gap = kToSit;
  }
}

// Cars stand nose to the garage door, side by side.
void RelationBuilder::park_cars() {
  constexpr Mm kTwoAbreast = 5500;
  const auto door = std::ranges::find_if(
      scene_.room.openings, [](const Opening& o) { return o.type == OpeningType::kDoor && look_of(o).leaf == Leaf::kSectional; });
  // One drives straight in; where two cars have room and nobody says how wide it is, the door is for both.
  if (door != scene_.room.openings.end() && door->origin == Origin::kAssumed) {
    if (door->wall.empty()) door->wall = "front";
    const Point far = scene_.room.polygon.size() == 4 ? scene_.room.polygon[2] : Point{};
    std::vector<std::string> wide{"double " + door->attributes.front()};
    const OpeningLook look = opening_look(OpeningType::kDoor, wide);
    if (far.x >= kTwoAbreast && look.width) door->attributes = wide, door->width = *look.width;
  }
  std::string first;
  for (const SceneObject& object : scene_.objects) {
    if (!catalog_.entry_or_nearest(object.category).is(Trait::kParked)) continue;
    if (first.empty() && door != scene_.room.openings.end()) {
      conclude(R::kFacing, {object.id}, {door->id}, "cars leave by the garage door");
    }
    if (!first.empty()) add_habit(R::kSameOrientation, {object.id}, {first}, kTogether, "cars are parked side by side");
    if (first.empty()) first = object.id;
  }
}

// "four salon chairs, each with a mirror, along the right wall": they look into the mirrors, and these are on the wall.
void RelationBuilder::sit_before_mirrors() {
  std::vector<std::string> seats, mirrors;
  for (const SceneObject& object : scene_.objects) {
    const CatalogEntry& entry = catalog_.entry_or_nearest(object.category);
    const auto is_mirror = [&](const std::string& kind) {
      const CatalogEntry* seen = catalog_.find(kind);
      return seen != nullptr && seen->is(Trait::kMirror);
    };
    if (is_seat(catalog_, noun_of_object(object)) && std::ranges::any_of(entry.faces, is_mirror)) seats.push_back(object.id);
    if (entry.is(Trait::kMirror) && mount_of(noun_of_object(object)) == Mount::kWall) mirrors.push_back(object.id);
  }
  if (seats.empty() || seats.size() != mirrors.size()) return;
  for (Relation& relation : scene_.relations) {
    if (relation.targets.size() != 1 || relation.references.size() != 1) continue;
    const auto seat = std::ranges::find(seats, relation.targets[0]);
    if (relation.type == R::kAbove && std::ranges::find(seats, relation.references[0]) != seats.end()) {
      std::swap(relation.targets, relation.references);
      relation.type = R::kFacing;
    } else if (relation.type == R::kAgainstWall && seat != seats.end()) {
      relation.type = R::kOnWall;
      relation.targets = {mirrors[static_cast<std::size_t>(seat - seats.begin())]};
      relation.parameters = {};
    }
  }
  sit_at_what_they_face(seats);
}

// "a salon chair faces each console": it stands there, where nothing else says where it does.
void RelationBuilder::sit_at_what_they_face(const std::vector<std::string>& seats) {
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    const Relation faces = scene_.relations[r];
    if (faces.type != R::kFacing || faces.targets.size() != 1 || faces.references.size() != 1 ||
        std::ranges::find(seats, faces.targets[0]) == seats.end() || object_of(faces.references[0]) == nullptr)
      continue;
    const auto stands = [&](std::size_t o) { return stands_beside(scene_.relations[o].type) || scene_.relations[o].type == R::kInFrontOf; };
    if (std::ranges::any_of(relations_of(faces.targets[0]), stands)) continue;
    conclude(R::kInFrontOf, faces.targets, faces.references, "who looks into a mirror sits at it");  // how near: `stand_before_middles`
  }
}

// "a bay window, a window seat": the seat is in the window.
void RelationBuilder::seat_in_windows() {
  for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
    const auto at_wall_of_window = [&](std::size_t r) {
      const Relation& at = scene_.relations[r];
      return traits_of(at.type).back_to_wall && std::ranges::any_of(scene_.room.openings, [&](const Opening& o) {
               return o.type == OpeningType::kWindow && !at.references.empty() && o.wall == at.references[0];
             });
    };
    const bool elsewhere = is_placed(static_cast<int>(i)) && std::ranges::none_of(relations_of(id(static_cast<int>(i))), at_wall_of_window);
    if (!catalog_.entry_or_nearest(scene_.objects[i].category).is(Trait::kInWindow) || elsewhere) continue;
    add_habit(R::kUnderWindow, {scene_.objects[i].id}, {}, kTogether, "a window seat is in the window");
  }
}

// Three sofas and more stand round their low table, open to the screen: one of them is across from it.
void RelationBuilder::sit_in_u() {
  constexpr std::size_t kRound = 3;
  std::vector<std::string> sofas, tables, screens;
  for (const SceneObject& object : scene_.objects) {
    const CatalogEntry& entry = catalog_.entry_or_nearest(object.category);
    if (entry.is(Trait::kCenterPiece) && !entry.is(Trait::kBed) && entry.has_front) sofas.push_back(object.id);
    if (entry.is(Trait::kCoffeeTable)) tables.push_back(object.id);
    if (entry.is(Trait::kScreen) && entry.is(Trait::kElseOnWall)) screens.push_back(object.id);
  }
  if (sofas.size() < kRound || tables.size() != 1) return;
  const auto says_of = [&](auto holds) {
    return std::ranges::any_of(scene_.relations,
                               [&](const Relation& r) { return std::ranges::find(r.targets, sofas[0]) != r.targets.end() && holds(r); });
  };
  const auto conclude = [&](R type, std::vector<std::string> targets, std::vector<std::string> references, const char* why) {
    RelationBuilder::conclude(type, std::move(targets), std::move(references), why);
  };
  const auto round_table = [&](const Relation& r) { return traits_of(r.type).around && r.targets.size() == sofas.size(); };
  if (!says_of(round_table)) {
    if (says_of([](const Relation& r) { return !traits_of(r.type).looks; })) return;
    conclude(R::kAround, sofas, tables, "sofas stand round their table");
  }
  if (screens.size() != 1 || says_of([](const Relation& r) { return traits_of(r.type).looks; })) return;
  conclude(R::kOpposite, {sofas[0]}, screens, "the seats are open to the screen");
  conclude(R::kFacing, {sofas[1]}, {sofas[2]}, "the seats are open to the screen");
}

// "a luggage rack and a wardrobe beside the door": side by side there, the second one as near as the first lets it.
void RelationBuilder::share_doors() {
  constexpr Mm kBesideOther = 1200;
  const auto one_that_stands = [&](const Relation& relation) {
    const bool by_door = relation.type == R::kNextTo && relation.references.size() == 1 && relation.references[0].starts_with("door");
    const SceneObject* object = by_door && relation.targets.size() == 1 ? object_of(relation.targets.front()) : nullptr;
    return object != nullptr && mount_of(noun_of_object(*object)) == Mount::kFloor ? object : nullptr;
  };
  for (std::size_t r = 1; r < scene_.relations.size(); ++r) {
    Relation& relation = scene_.relations[r];
    const SceneObject *first = one_that_stands(scene_.relations[r - 1]), *second = one_that_stands(relation);
    if (first == nullptr || second == nullptr || !words_.are_one(scene_.relations[r - 1], relation) || relation.parameters.max) continue;
    if (first->category != second->category) relation.parameters.max = kBesideOther;
  }
}

// "a shower, a fold-down seat, grab rails": of which nothing is said it is within that.
void RelationBuilder::hang_within() {
  for (const SceneObject& thing : scene_.objects) {
    const CatalogEntry* entry = catalog_.find(thing.category);
    if (entry == nullptr || entry->mount != Mount::kWall || !relations_of(thing.id).empty()) continue;
    for (const std::string& kind : Groups::usual_at(Groups::builtin().hangs, catalog_, *entry, Mount::kWall)) {
      const auto host = std::ranges::find_if(
          scene_.objects, [&](const SceneObject& o) { return catalog_.is_a(o.category, kind) && is_used_within(thing, o); });
      if (host == scene_.objects.end()) continue;
      add_habit(R::kInside, {thing.id}, {host->id}, kTogether, "such a thing is used within it");
      break;
    }
  }
}

// "a curtain rail around the bed": the curtain that closes it off, from a rail under the ceiling.
void RelationBuilder::hang_bed_curtains() {
  for (Relation& relation : scene_.relations) {
    const bool round = traits_of(relation.type).around && relation.targets.size() == 1 && relation.references.size() == 1;
    const auto rod = round ? std::ranges::find(scene_.objects, relation.targets[0], &SceneObject::id) : scene_.objects.end();
    const SceneObject* bed = round ? object_of(relation.references[0]) : nullptr;
    const CatalogEntry* entry = bed == nullptr ? nullptr : noun_of_object(*bed).entry;
    if (rod == scene_.objects.end() || entry == nullptr || !entry->is(Trait::kBed)) continue;
    const CatalogEntry* form = kind_at(catalog_, rod->category, KinPlace::kAroundBed);
    if (form == nullptr) continue;
    rod->category = form->id;
    relation.type = R::kNextTo;
  }
}

}  // namespace layoutbox::offline
