// Things that line up with others: under what hangs at the wall, side by side where they are parallel.
#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/plan/words/word_sets.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;

// "a sideboard under the whiteboard": its back is to the wall where that hangs, not only its end below it.
void RelationBuilder::turn_to_what_hangs_over() {
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    const Relation over = scene_.relations[r];
    if (over.type != R::kAbove || over.targets.size() != 1 || over.references.size() != 1) continue;
    const SceneObject *hung = object_of(over.targets[0]), *below = object_of(over.references[0]);
    if (hung == nullptr || below == nullptr) continue;
    const CatalogEntry &own = catalog_.entry_or_nearest(hung->category), &stands = catalog_.entry_or_nearest(below->category);
    const bool at_wall = hung->mount.value_or(own.mount) == Mount::kWall && stands.mount == Mount::kFloor && stands.back_to_wall;
    const auto turned = [&](std::size_t i) {
      return traits_of(scene_.relations[i].type).turns || scene_.relations[i].type == R::kSideAgainstWall ||
             (scene_.relations[i].type == R::kAgainstWall && !scene_.relations[i].references.empty());
    };
    if (!at_wall || !own.has_front || !stands.has_front || std::ranges::any_of(relations_of(below->id), turned)) continue;
    add_habit(R::kSameOrientation, {below->id}, {hung->id}, kTogether, "what is under a hung thing has its back to the same wall");
  }
}

// "a counter with a sink and wall cabinets along the back wall": the counter is below them.
void RelationBuilder::stand_under_wall_cabinets() {
  const auto hangs = [&](const Relation& r) {
    const SceneObject* hung = r.type == R::kOnWall && r.targets.size() == 1 && r.references.size() == 1 ? object_of(r.targets[0]) : nullptr;
    return hung != nullptr && catalog_.is_a(hung->category, "wall_cabinet");
  };
  const auto hung = std::ranges::find_if(scene_.relations, hangs);
  if (hung == scene_.relations.end()) return;
  const std::vector<std::string> wall = hung->references;
  const auto is_counter = [&](const SceneObject& o) {
    const CatalogEntry* entry = catalog_.find(o.category);
    return entry != nullptr && entry->is(Trait::kCounter) && entry->back_to_wall;
  };
  const auto placed = [&](std::size_t i) { return traits_of(scene_.relations[i].type).placing == Placing::kInRoom; };
  if (std::ranges::count_if(scene_.objects, is_counter) != 1) return;
  const std::string counter = std::ranges::find_if(scene_.objects, is_counter)->id;
  if (std::ranges::any_of(relations_of(counter), placed)) return;
  Relation& below = add_habit(R::kAgainstWall, {counter}, wall, kTogether, "a counter is below its wall cabinets");
  below.origin = Origin::kConcluded;
  below.hard = true;
}

// "four rows of shelves on the north side": in that half of the room; only one row could be at its wall.
void RelationBuilder::stand_rows_in_halves() {
  static constexpr std::pair<Side, RoomRegion> kHalves[] = {{Side::kLeft, RoomRegion::kLeft},
                                                            {Side::kRight, RoomRegion::kRight},
                                                            {Side::kBack, RoomRegion::kBack},
                                                            {Side::kFront, RoomRegion::kFront}};
  for (const Relation& grid : std::vector<Relation>(scene_.relations)) {
    const std::size_t columns = grid.type == R::kGrid ? static_cast<std::size_t>(grid.parameters.columns.value_or(0)) : 0;
    if (columns == 0 || columns >= grid.targets.size()) continue;
    for (Relation& wall : scene_.relations) {
      const bool of_it = wall.type == R::kAgainstWall && wall.targets.size() == 1 && wall.references.size() == 1 &&
                         std::ranges::find(grid.targets, wall.targets[0]) != grid.targets.end();
      const std::optional<Side> side = of_it ? room_side_from_word(wall.references[0]) : std::nullopt;
      const auto half = side ? std::ranges::find(kHalves, *side, &std::pair<Side, RoomRegion>::first) : std::end(kHalves);
      if (half == std::end(kHalves)) continue;
      wall.type = R::kInRegion;
      wall.references.clear();
      wall.parameters.gap.reset();
      wall.parameters.region = half->second;
    }
  }
}

// "a fridge at the south end of the counter": at its short side, and of the two at that one.
void RelationBuilder::stand_at_ends() {
  static constexpr std::pair<std::string_view, RoomRegion> kEnds[] = {
      {"south", RoomRegion::kFront}, {"north", RoomRegion::kBack}, {"west", RoomRegion::kLeft}, {"east", RoomRegion::kRight}};
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    Relation& end = scene_.relations[r];
    if (end.type != R::kAtFootOf || end.targets.size() != 1 || end.references.size() != 1) continue;
    const SceneObject* counter = object_of(end.references[0]);
    const CatalogEntry* entry = counter == nullptr ? nullptr : catalog_.find(counter->category);
    if (entry == nullptr || !(entry->is(Trait::kCounter) || entry->is(Trait::kKitchenRun))) continue;
    end.type = R::kAlongSide;
    end.parameters = {};
    end.parameters.side = Side::kShort;
    const std::vector<std::string> targets = end.targets;
    for (const auto& [word, region] : kEnds) {
      if (!words_.have(scene_.relations[r], word)) continue;
      Relation& part = add_habit(R::kInRegion, targets, {}, kTogether, "the end that is said");
      part.parameters.region = region;
      part.origin = Origin::kConcluded;
      break;
    }
  }
}

// "two long benches parallel to each other", "four parallel bookshelves": side by side, not one behind the other's end.
void RelationBuilder::stand_abreast() {
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    const Relation along = scene_.relations[r];
    if (along.type == R::kParallel && along.targets.size() == 1 && along.references.size() == 1)
      line_up(along.references[0], along.targets[0]);
  }
  for (const Mention& mention : document_.mentions) {
    if (!mention.introduces || mention.items.size() < 2 ||
        std::ranges::find(mention.noun.attributes, "parallel") == mention.noun.attributes.end())
      continue;
    std::vector<std::string> all = ids(mention.items);
    for (std::size_t i = 1; i < all.size(); ++i) {
      add_habit(R::kSameOrientation, {all[i]}, {all[0]}, kTogether, "said to be parallel").origin = Origin::kConcluded;
      line_up(all[0], all[i]);
    }
    if (all.size() > 2) add_habit(R::kEvenlySpaced, all, {}, kTogether, "parallel ones stand equally far apart");
  }
}

// "a bed between two bookcases": these flank it, at the same wall.
void RelationBuilder::stand_between_likes() {
  const std::size_t said = scene_.relations.size();
  for (std::size_t r = 0; r < said; ++r) {
    const Relation between = scene_.relations[r];
    if (between.type != R::kBetween || !between.asked() || between.targets.size() != 1 || between.references.size() != 2) continue;
    const SceneObject *middle = object_of(between.targets[0]), *one = object_of(between.references[0]),
                      *other = object_of(between.references[1]);
    if (middle == nullptr || one == nullptr || other == nullptr || one->category != other->category) continue;
    const CatalogEntry &stands = catalog_.entry_or_nearest(middle->category), &flank = catalog_.entry_or_nearest(one->category);
    const bool at_wall = flank.back_to_wall && flank.mount == Mount::kFloor && stands.has_front && stands.mount == Mount::kFloor &&
                         (stands.back_to_wall || stands.is(Trait::kBed) || stands.is(Trait::kDesk));
    if (!at_wall || may_divide(static_cast<int>(objects_.at(middle->id)))) continue;
    for (const std::string& side : between.references) {
      add_habit(R::kNextTo, {side}, between.targets, kTogether, "what something is between stands at its sides");
      add_habit(R::kSameOrientation, {side}, between.targets, kTogether, "what something is between stands at its sides");
    }
  }
}

void RelationBuilder::line_up(const std::string& first, const std::string& next) {
  constexpr Mm kLong = 1000;
  const SceneObject *one = object_of(first), *other = object_of(next);
  if (one == nullptr || other == nullptr || one->category != other->category) return;
  const CatalogEntry& entry = catalog_.entry_or_nearest(one->category);
  if (one->mount.value_or(entry.mount) != Mount::kFloor || entry.size.usual.width < kLong || is_seat(catalog_, noun_of_object(*one)))
    return;
  const auto at_wall = [&](std::size_t i) { return traits_of(scene_.relations[i].type).back_to_wall; };
  if (std::ranges::any_of(relations_of(first), at_wall) || std::ranges::any_of(relations_of(next), at_wall)) return;
  add_habit(R::kEdgeAlign, {next}, {first}, kTogether, "parallel ones stand side by side").parameters.edge = Edge::kCenter;
}

// "pans hanging over the hob": whatever else lies over such a thing.
bool RelationBuilder::is_told_to_hang(const Link& link) const {
  if (!says(link.senses, R::kAbove)) return false;
  for (std::size_t i = link.first > 0 ? link.first - 1 : 0; i < link.last; ++i) {
    if (one_of(document_.tokens[i].text, {"hanging", "hang", "hangs", "hung", "suspended"})) return true;
  }
  return false;
}

}  // namespace layoutbox::offline
