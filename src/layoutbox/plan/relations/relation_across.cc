// What is across from something: over the room, a table or a wall.
#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;
using Direction = PhraseSense::Direction;

// "on the wall opposite the bed", "… across from the door": on or against that wall.
void RelationBuilder::add_wall_opposite(const Link& link, const Mention& target) {
  const Mount mount = mount_of(target.noun);
  const std::string words = words_between(document_, link.first, link.last);
  if (mount == Mount::kCeiling || words.find("wall") == std::string::npos) return;
  const bool against = words.find("against") != std::string::npos && mount != Mount::kWall;
  const R type = against || (mount == Mount::kFloor && is_heavy(catalog_, target.noun)) ? R::kAgainstWall : R::kOnWall;
  for (const int item : target.items) add(link, type, {id(item)}, {});
}

// "three chairs facing mirrors, a bench across from them": what looks at a wall's thing has the rest of the room behind it.
bool RelationBuilder::add_across_room(const Link& link, const Mention& target, const std::vector<int>& references) {
  const auto faces_wall = [&](int reference) {
    return std::ranges::any_of(relations_of(id(reference)),
                               [&](std::size_t r) { return mirror_looked_into(scene_.relations[r]) != nullptr; });
  };
  if (mount_of(target.noun) != Mount::kFloor || !std::ranges::all_of(references, faces_wall)) return false;
  const int middle = references[references.size() / 2];
  constexpr Mm kFarthest = 5000;
  for (const int item : target.items) {
    add(link, R::kBehind, {id(item)}, {id(middle)});
    scene_.relations.back().parameters.max = kFarthest;
    add_across(link, item, {id(middle)});
  }
  return true;
}

// The table that a seat was placed at, or empty.
std::string RelationBuilder::table_of(const std::string& seat) const {
  for (const std::size_t r : relations_of(seat)) {
    const Relation& relation = scene_.relations[r];
    const bool at = traits_of(relation.type).around || relation.type == R::kAlongSide || relation.type == R::kInFrontOf ||
                    relation.type == R::kTuckedUnder;
    const SceneObject* table = at && relation.references.size() == 1 ? object_of(relation.references.front()) : nullptr;
    if (table != nullptr && is_table(catalog_, noun_of_object(*table))) return table->id;
  }
  return {};
}

// "On one side of the table a stool, opposite two chairs": at the table, across from the stool. False: nobody sits at its one side.
bool RelationBuilder::add_across_table(const Link& link, const Mention& target, int table) {
  const auto is_chair = [&](const NounPhrase& noun) { return is_seat(catalog_, noun) && mount_of(noun) == Mount::kFloor; };
  if (!link.implied || !is_chair(target.noun) || !is_table(catalog_, noun_of_item(table))) return false;
  for (Relation& first : scene_.relations) {
    const bool at = first.type == R::kAlongSide || first.type == R::kNextTo || first.type == R::kInFrontOf;
    if (!at || first.targets.size() != 1 || first.references != std::vector<std::string>{id(table)}) continue;
    const SceneObject* seat = object_of(first.targets.front());
    if (seat == nullptr || !is_chair(noun_of_object(*seat))) continue;
    if (first.type == R::kNextTo) {
      first.type = R::kAlongSide;
      first.parameters.side = Side::kLong;
    }
    const std::string other = seat->id;
    const PhraseSense along{R::kAlongSide, Direction::kDirect, {}, {}, Side::kLong};
    for (const int item : target.items) {
      add(link, along.type, {id(item)}, {id(table)}, along);
      add_look(link, along.type, item, table);
    }
    add(link, R::kOpposite, ids(target.items), {other});
    scene_.relations.back().parameters.min = 300;  // with the table between them
    return true;
  }
  return false;
}

// "a bench on one side and chairs on the other": with the table between them.
void RelationBuilder::sit_across_table() {
  const auto said_along = [&](const Relation& r) {
    return r.type == R::kAlongSide && r.parameters.side == Side::kLong && r.targets.size() == 1 && r.references.size() == 1 && r.asked() &&
           object_of(r.targets[0]) != nullptr;
  };
  const auto first = std::ranges::find_if(scene_.relations, [&](const Relation& r) {
    return said_along(r) && (words_.have_phrase(r, {"one", "side"}) || words_.have_phrase(r, {"one", "long", "side"}));
  });
  if (first == scene_.relations.end()) return;
  const std::string seat = first->targets[0], kind = object_of(seat)->category;
  std::vector<std::string> others;
  for (const Relation& r : scene_.relations) {
    if (said_along(r) && r.references == first->references && object_of(r.targets[0])->category != kind) others.push_back(r.targets[0]);
  }
  if (others.empty() || !is_seat(catalog_, noun_of_object(*object_of(seat)))) return;
  const auto conclude = [&](R type, std::vector<std::string> references) {
    RelationBuilder::conclude(type, others, std::move(references), "they sit at both sides of the table");
  };
  if (others.size() > 1) conclude(R::kRow, {});
  conclude(R::kOpposite, {seat});
  scene_.relations.back().parameters.min = 0;  // both may be pushed under it
}

// "on the other side of the bed is a nightstand": beside it, where the thing on its first side is not. False: the phrase does not say so.
bool RelationBuilder::add_on_other_side(const Link& link, PhraseSense& sense, const Mention& target, int reference) {
  if (words_between(document_, link.first, link.last).find("other side") == std::string::npos || mount_of(target.noun) != Mount::kFloor)
    return false;
  sense.type = R::kNextTo;
  for (std::size_t r = 0; r < scene_.relations.size(); ++r) {
    Relation& first = scene_.relations[r];
    if (first.references != std::vector<std::string>{id(reference)} || first.targets.size() != 1) continue;
    if (first.type == R::kLeftOf) sense.type = R::kRightOf;
    if (first.type == R::kRightOf) sense.type = R::kLeftOf;
    if (first.type != R::kNextTo && first.type != R::kNear) continue;
    first.type = R::kEachSideOf;
    for (const int item : target.items) {
      first.targets.push_back(id(item));
      of_target_[id(item)].push_back(r);
    }
    return true;
  }
  return false;
}

void RelationBuilder::add_across(const Link& link, int item, const std::vector<std::string>& reference) {
  Link gap = link;
  gap.distance.reset();
  const std::size_t known = scene_.relations.size();
  add(gap, R::kDistance, {id(item)}, reference);
  if (scene_.relations.size() == known) return;
  scene_.relations.back().parameters.min = relation_row(R::kOpposite).defaults.min;
  const Mm most = relation_row(R::kOpposite).defaults.max.value_or(0);
  const bool of_opening =
      !reference.empty() && (scene_.find_opening(reference[0]) != nullptr || reference[0] == "door" || reference[0] == "window");
  if (!of_opening) {
    scene_.relations.back().parameters.max = most;
    return;
  }
  // In a deeper room what is opposite the door is still at the far wall, not half way.
  Relation near = scene_.relations.back();
  near.id = "c" + std::to_string(scene_.relations.size() + 1);
  near.parameters = {};
  near.parameters.max = most;
  near.hard = false;
  near.origin = Origin::kConcluded;
  scene_.relations.push_back(std::move(near));
}

}  // namespace layoutbox::offline
