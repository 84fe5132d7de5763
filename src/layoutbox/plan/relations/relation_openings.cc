// Doors and windows placed by things: "to the right of the bed is a door" puts the bed by that door.
#include <algorithm>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/plan/room/room_reader.h"

namespace layoutbox::offline {

using R = RelationType;

namespace {

// What the thing is said to be by the opening, where the opening is said to be PHRASE the thing.
std::optional<R> turned_sense(const PhraseSenses& senses, const NounPhrase& opening) {
  const bool window = opening.kind == NounKind::kWindow;
  if (window && (says(senses, R::kAbove) || says(senses, R::kBehind))) return R::kUnderWindow;
  if (says(senses, R::kOpposite) || says(senses, R::kFacing)) return R::kOpposite;
  if (says(senses, R::kNear) && !says(senses, R::kNextTo)) return R::kNear;
  if (says(senses, R::kBehind) || says(senses, R::kInFrontOf)) return R::kNear;
  const bool beside = std::ranges::any_of(senses, [](const PhraseSense& sense) { return stands_beside(sense.type); });
  return beside ? std::optional(R::kNextTo) : std::nullopt;
}

}  // namespace

void RelationBuilder::add_by_openings(const Link& link) {
  const std::vector<int> items = items_of(link.references);
  if (link.implied && words_between(document_, link.first, link.last).find(" end") != std::string::npos) return;  // of the room
  if (items.empty() || link.kind != Link::Kind::kRelation) return;
  for (const int target : link.targets) {
    const NounPhrase& opening = mention(target).noun;
    if (!mention(target).items.empty() || !is_opening(opening)) continue;
    if (says(link.senses, R::kBetween) && items.size() == 2) {
      add(link, R::kEachSideOf, ids(items), room_reference(opening, R::kEachSideOf));
      continue;
    }
    const std::optional<R> sense = turned_sense(link.senses, opening);
    for (const int item : sense ? items : std::vector<int>{}) {
      const Mount mount = mount_of(noun_of_item(item));
      const bool under = *sense == R::kUnderWindow;
      const CatalogEntry* entry = noun_of_item(item).entry;
      // "a desk facing the door, a window behind it": who works there sits between
      if (under && !says(link.senses, R::kAbove) && mount == Mount::kFloor && entry != nullptr && entry->is(Trait::kDeskLike)) {
        add(link, R::kInFrontOf, {id(item)}, room_reference(opening, R::kInFrontOf));
        continue;
      }
      if (mount == Mount::kFloor || (under && says(link.senses, R::kAbove)) || (*sense == R::kNextTo && mount == Mount::kWall))
        add(link, *sense, {id(item)}, under ? std::vector<std::string>{} : room_reference(opening, *sense));
    }
  }
}

// "blinds on the window behind the desk", "a window with curtains behind the sofa": the window is behind it, and its blinds with it.
void RelationBuilder::place_by_covered_windows() {
  const auto covers = [&](const Relation& r) {
    const SceneObject* object = r.asked() && r.targets.size() == 1 && r.references.size() == 1 ? object_of(r.targets[0]) : nullptr;
    const CatalogEntry* entry = object == nullptr ? nullptr : catalog_.find(object->category);
    return entry != nullptr && (entry->is(Trait::kCurtain) || catalog_.is_a(entry->id, "blind"));
  };
  for (Relation& r : scene_.relations) {
    const SceneObject* thing = r.type == R::kBehind && covers(r) ? object_of(r.references[0]) : nullptr;
    if (thing == nullptr || mount_of(noun_of_object(*thing)) != Mount::kFloor) continue;
    const auto at_window = std::ranges::find_if(scene_.relations, [&](const Relation& other) {
      return covers(other) && other.targets == r.targets && other.references[0].starts_with(name_of(OpeningType::kWindow));
    });
    if (at_window == scene_.relations.end()) continue;
    // Between a desk and the window behind it somebody sits.
    const bool works = catalog_.entry_or_nearest(thing->category).is(Trait::kDeskLike);
    r.type = works ? R::kInFrontOf : R::kUnderWindow;
    r.targets = {thing->id};
    r.references = {at_window->references[0]};
  }
}

// "The lockers and the vending machine across from the entrance", "the entrance opposite the beds": one thing has the door straight before
// it, of several that stand or hang at walls all have the wall that is opposite.
void RelationBuilder::stand_across_openings() {
  const auto are_across = [&](const std::string& opening) {
    return std::ranges::count_if(scene_.relations, [&](const Relation& r) { return stands_across(r, opening); }) > 1;
  };
  if (scene_.room.openings.empty() && are_across("door")) {  // the door that every room has
    add_assumed_opening(scene_, OpeningType::kDoor, "front");
    add_assumed_opening(scene_, OpeningType::kWindow, {});
    for (Relation& r : scene_.relations) {
      if (r.references == std::vector<std::string>{"door"}) r.references = {scene_.room.openings.front().id};
    }
  }
  for (Opening& opening : scene_.room.openings) {
    if (!are_across(opening.id)) continue;
    if (opening.wall.empty()) opening.wall = "front";
    if (const std::string wall = wall_across(opening.wall); !wall.empty()) stand_at_wall_across(opening.id, wall);
  }
}

// Does it say that something which is at a wall has the opening straight before it?
bool RelationBuilder::stands_across(const Relation& r, const std::string& opening) const {
  const SceneObject* thing = r.targets.size() == 1 ? object_of(r.targets[0]) : nullptr;
  return r.type == R::kOpposite && thing != nullptr && r.references == std::vector<std::string>{opening} && r.asked() && r.hard &&
         stands_at_walls(noun_of_object(*thing));
}

void RelationBuilder::stand_at_wall_across(const std::string& opening, const std::string& wall) {
  std::vector<std::string> things;
  for (Relation& r : scene_.relations) {
    if (!stands_across(r, opening)) continue;
    things.push_back(r.targets[0]);
    r.type = mount_of(noun_of_object(*object_of(r.targets[0]))) == Mount::kWall ? R::kOnWall : R::kAgainstWall;
    r.references = {wall};
  }
  std::erase_if(scene_.relations, [&](const Relation& r) {
    if (r.targets.size() != 1 || std::ranges::find(things, r.targets[0]) == things.end()) return false;
    const bool gap = r.type == R::kDistance && r.references == std::vector<std::string>{opening};
    return gap || ((r.type == R::kAgainstWall || r.type == R::kOnWall) && r.references.empty());
  });
}

// "Four armchairs face the window", "stools looking out of the window", and nothing else: they are by it.
void RelationBuilder::sit_at_windows() {
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    const Relation looks = scene_.relations[r];
    if (looks.type != R::kFacing || !looks.asked() || looks.targets.size() != 1 || looks.references.size() != 1) continue;
    const bool window = looks.references[0].starts_with(name_of(OpeningType::kWindow));  // there or still to come
    const SceneObject* seat = object_of(looks.targets[0]);
    if (!window || seat == nullptr || !is_seat(catalog_, noun_of_object(*seat))) continue;
    const bool placed = std::ranges::any_of(relations_of(seat->id), [&](std::size_t o) {
      return !traits_of(scene_.relations[o].type).turns && scene_.relations[o].type != R::kRow;
    });
    if (!placed) add_habit(R::kNear, {seat->id}, looks.references, kTogether, "who looks out sits by the window");
  }
}

// "a workbench under the window": along it, and who works there looks out.
void RelationBuilder::work_at_windows() {
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    const Relation under = scene_.relations[r];
    if (under.type != R::kUnderWindow || under.targets.size() != 1) continue;
    const SceneObject* bench = object_of(under.targets[0]);
    const CatalogEntry* entry = bench == nullptr ? nullptr : catalog_.find(bench->category);
    if (entry == nullptr || !entry->is(Trait::kDeskLike) || entry->mount != Mount::kFloor) continue;
    const auto turned = [&](std::size_t i) {
      return i != r && (traits_of(scene_.relations[i].type).turns || traits_of(scene_.relations[i].type).back_to_wall);
    };
    const std::string window = under.references.empty() ? std::string(name_of(OpeningType::kWindow)) : under.references[0];
    if (std::ranges::none_of(relations_of(bench->id), turned))
      add_habit(R::kFacing, {bench->id}, {window}, kTogether, "who works under a window looks out of it");
  }
}

bool RelationBuilder::stands_at_walls(const NounPhrase& noun) const {
  return mount_of(noun) == Mount::kWall || (mount_of(noun) == Mount::kFloor && noun.entry != nullptr && noun.entry->back_to_wall);
}

}  // namespace layoutbox::offline
