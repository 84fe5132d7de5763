// What is by a part of the room: its walls, floor and openings, its alcove; and which walls several share out.
#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/plan/room/room_reader.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;

// The wall that the thing was put against; empty: none.
std::string RelationBuilder::wall_behind(int item) const {
  for (const std::size_t r : relations_of(id(item))) {
    const Relation& relation = scene_.relations[r];
    if (relation.type == R::kAgainstWall && !relation.references.empty()) return relation.references.front();
  }
  return {};
}

// The walls or the openings that several things share out: "on the side walls", "curtains at both windows"; empty: they are at one.
std::vector<std::string> RelationBuilder::shared_places(const PhraseSense& sense, const Mention& target, const NounPhrase& place) const {
  if (!is_opening(place)) {
    std::vector<std::string> walls = shared_walls(place, sense.type == R::kOnWall && !is_tall(target.noun));
    // "ten chairs along two walls": those who wait face each other
    const bool any_two = walls.size() == 2 && place.wall_word.empty() && place.wall_relation.empty() && is_seat(catalog_, target.noun);
    if (any_two && walls[1] == "back") walls[1] = "right";
    return walls;
  }
  const bool several = place.determiner == Determiner::kEach || place.determiner == Determiner::kBoth || place.is_plural();
  if (!several) return {};
  constexpr int kAll = 100;
  NounPhrase every = place;
  if (place.count < 2) every.count = kAll;
  const std::vector<std::string> all = opening_ids(every);
  return all.size() > 1 ? all : std::vector<std::string>{};
}

bool RelationBuilder::is_curtain(const NounPhrase& noun) { return noun.entry != nullptr && noun.entry->is(Trait::kCurtain); }

// By a part of the room.
void RelationBuilder::add_in_room(const Link& link, const PhraseSense& sense, const Mention& target, const NounPhrase& place) {
  if (place.niche) return add_in_niche(link, target);
  if (place.kind == NounKind::kFloor) {
    for (const int item : target.items) {
      const Mount mount = mount_of(noun_of_item(item));
      const bool hung = mount == Mount::kHung || is_curtain(noun_of_item(item));  // "drapes that pool on the floor"
      if (mount != Mount::kFloor && !hung) add(link, R::kOn, {id(item)}, {"floor"});
    }
    return;
  }
  // "at the very center of the compartment": whatever the room is called
  if (traits_of(sense.type).rests && sense.part.has(PartWord::kCenter)) {
    for (const int item : target.items) add(link, R::kCenterOfRoom, {id(item)}, {});
    return;
  }
  if (place.kind == NounKind::kRoom && (traits_of(sense.type).rests || sense.type == R::kInside)) return;
  if (sense.type == R::kCorner) return add_corners(link, target, place);
  // "1 m away from the walls", "away from the wall": from each of them
  const bool any_wall = place.kind == NounKind::kWall && place.wall_word.empty() && place.wall_relation.empty() && place.attributes.empty();
  if (any_wall && ((sense.type == R::kDistance && place.is_plural() && !link.at_most) || (sense.type == R::kFar && !link.distance))) {
    for (const int item : target.items) add(link, R::kAwayFromWall, {id(item)}, {});
    return;
  }
  const std::vector<std::string> shared = target.items.size() > 1 ? shared_places(sense, target, place) : std::vector<std::string>{};
  for (std::size_t t = 0; t < target.items.size() && !shared.empty(); ++t)
    add(link, sense.type, {id(target.items[t])}, {shared[t % shared.size()]}, sense);
  if (!shared.empty()) return;
  if (sense.type == R::kOpposite) add_wall_opposite(link, target);
  for (const int item : target.items) {
    const std::string own = sense.type == R::kFacing && place.kind == NounKind::kWall && place.plural ? wall_behind(item) : std::string{};
    add(link, sense.type, {id(item)}, own.empty() ? room_reference(place, sense.type) : std::vector<std::string>{own}, sense);
    if (sense.type == R::kOpposite) add_across(link, item, room_reference(place, sense.type));
  }
}

// "a desk in the alcove": against the alcove's own wall, where that is long enough.
void RelationBuilder::add_in_niche(const Link& link, const Mention& target) {
  const std::string wall = document_.niche ? wall_of_niche(scene_.room, *document_.niche) : std::string{};
  if (wall.empty()) return;
  for (const int item : target.items) {
    const NounPhrase& noun = noun_of_item(item);
    const Mount mount = mount_of(noun);
    if (mount == Mount::kWall) {
      add(link, R::kOnWall, {id(item)}, {wall});
    } else if (mount == Mount::kFloor) {
      Link there = link;
      there.soft |= noun.entry != nullptr && noun.entry->size.least.width > mm_from_m(document_.niche->width);
      add(there, R::kAgainstWall, {id(item)}, {wall});
    }
  }
}

std::vector<std::string> RelationBuilder::shared_walls(const NounPhrase& walls, bool boards) const {
  const bool every = walls.determiner == Determiner::kEach && walls.wall_word.empty();  // "tall shelves on every wall": not the front one
  if (walls.kind != NounKind::kWall || !(walls.is_plural() || walls.determiner == Determiner::kBoth || every)) return {};
  const bool sides = walls.name.find("side wall") != std::string::npos || walls.name.find("long") != std::string::npos;
  if (every && sides) return {"left", "right"};
  if (every && boards) return {"back", "left", "right", "front"};
  if (every) return {"left", "back", "right"};
  const auto said = [&](std::string_view word) {
    return walls.wall_relation == word || std::find(walls.attributes.begin(), walls.attributes.end(), word) != walls.attributes.end();
  };
  if (const auto [one, other] = walls_by_length(walls, scene_.room); !one.empty() && !scene_.room.polygon.empty()) return {one, other};
  if (walls.count >= 3) return {"left", "back", "right"};
  const bool pair = said("opposite") || walls.determiner == Determiner::kBoth || walls.name.find("side wall") != std::string::npos ||
                    walls.name.find("long") != std::string::npos;
  if (pair) return {"left", "right"};
  return said("adjacent") || walls.count == 2 ? std::vector<std::string>{"left", "back"} : std::vector<std::string>{};
}

}  // namespace layoutbox::offline
