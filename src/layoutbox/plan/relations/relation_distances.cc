// How far off and how exactly a thing stands before or beside another, where the text leaves that open; and which table is dined at.
#include <algorithm>

#include "layoutbox/catalog/measures.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;

// What stands before one other thing: a seat in reach of its table, across a room at most, in the middle of it.
void RelationBuilder::stand_before_middles() {
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    const Relation relation = scene_.relations[r];
    if (relation.targets.size() != 1 || relation.references.size() != 1) continue;
    const SceneObject *target = object_of(relation.targets.front()), *reference = object_of(relation.references.front());
    if (target == nullptr || reference == nullptr) continue;
    const NounPhrase &thing = noun_of_object(*target), &other = noun_of_object(*reference);
    // "a desk facing the door, a swivel chair behind it": where one works at it
    const bool at_desk = relation.type == R::kBehind && other.entry != nullptr && other.entry->is(Trait::kDeskLike) &&
                         is_seat(catalog_, thing) && mount_of(thing) == Mount::kFloor && thing.entry != nullptr &&
                         !thing.entry->is(Trait::kEasySeat);
    const bool turned =
        std::ranges::any_of(relations_of(target->id), [&](std::size_t t) { return traits_of(scene_.relations[t].type).turns; });
    if (at_desk && !turned) add_habit(R::kFacing, relation.targets, relation.references, kTogether, "who sits behind a desk works at it");
    const bool at_back =
        at_desk || (relation.type == R::kBehind && other.entry != nullptr && other.entry->used_sides == std::vector{Side::kBack});
    if ((relation.type == R::kInFrontOf || at_back) && is_seat(catalog_, thing) && is_table(catalog_, other) &&
        !one_of(thing.head, {"sofa", "couch", "loveseat"}) && !scene_.relations[r].parameters.max)
      scene_.relations[r].parameters.max = measures().seat_at_hand;
    // … and in sight of its mirror.
    constexpr Mm kAtMirror = 900;
    if (relation.type == R::kInFrontOf && is_seat(catalog_, thing) && is_mirror(other) && !scene_.relations[r].parameters.max)
      scene_.relations[r].parameters.max = kAtMirror;
    // Both at walls: across the room from each other, as far as that is in most rooms.
    constexpr Mm kAcrossTheRoom = 3500;
    const auto stands_at_wall = [&](const SceneObject& object) {
      const CatalogEntry& entry = catalog_.entry_or_nearest(object.category);
      return entry.mount == Mount::kFloor && entry.back_to_wall;
    };
    if (relation.type == R::kInFrontOf && stands_at_wall(*target) && stands_at_wall(*reference) && !scene_.relations[r].parameters.max &&
        !is_seat(catalog_, thing))
      scene_.relations[r].parameters.max = kAcrossTheRoom;
    // "A desk facing a chair": whoever sits there looks at the desk.
    // … at a sofa or an armchair the desk itself looks.
    if (relation.type == R::kFacing && target->category != reference->category && is_drawn_up(catalog_, other) &&
        catalog_.entry_or_nearest(target->category).is(Trait::kDeskLike))
      std::swap(scene_.relations[r].targets, scene_.relations[r].references);
    // One thing in front of another stands in the middle of it.
    const auto alone = std::count_if(scene_.relations.begin(), scene_.relations.end(),
                                     [&](const Relation& o) { return o.type == R::kInFrontOf && o.references == relation.references; });
    const bool at_end = std::ranges::any_of(scene_.relations, [&](const Relation& o) {
      return o.type == R::kEdgeAlign && o.targets == relation.targets && o.references == relation.references;
    });
    if (relation.type == R::kInFrontOf && alone == 1 && !at_end) {
      add_habit(R::kCenteredOn, relation.targets, relation.references, 80, "what is in front of something is in front of its middle");
    }
  }
}

// "on either side of the sofa, near it": as far as near things are.
void RelationBuilder::keep_sides_near() {
  for (Relation& sides : scene_.relations) {
    if (sides.type != R::kEachSideOf || sides.parameters.max) continue;
    const bool near = std::any_of(scene_.relations.begin(), scene_.relations.end(), [&](const Relation& r) {
      return r.type == R::kNear && r.references == sides.references &&
             std::find(sides.targets.begin(), sides.targets.end(), r.targets.front()) != sides.targets.end();
    });
    if (near) sides.parameters.max = 1500;
  }
}

// A plain table that one dines at.
void RelationBuilder::dine_at_plain_tables() {
  for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
    SceneObject& object = scene_.objects[i];
    if (object.category != "table" || catalog_.find("dining_table") == nullptr) continue;
    const bool chairs = std::any_of(scene_.relations.begin(), scene_.relations.end(), [&](const Relation& r) {
      return traits_of(r.type).around && !r.references.empty() && r.references.front() == object.id &&
             r.targets.front().starts_with("dining_chair");
    });
    if (chairs || (scene_.room.type == "dining_room" && document_.items[i].noun.attributes.empty() && is_only_table(i)))
      object.category = "dining_table";
  }
}

bool RelationBuilder::is_only_table(std::size_t index) const {
  return std::count_if(document_.items.begin(), document_.items.end(),
                       [&](const TextItem& item) { return is_table(catalog_, item.noun); }) == 1 &&
         index < document_.items.size();
}

}  // namespace layoutbox::offline
