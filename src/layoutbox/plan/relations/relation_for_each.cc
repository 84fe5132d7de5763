// Several by one or by several: so many that they are of the room, one for each, shared out, or each by all of them.
#include <algorithm>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

using R = RelationType;
using Direction = PhraseSense::Direction;

// "A fan over them", of two armchairs: over the table that is between them.
bool RelationBuilder::add_over_table_between(const Link& link, const PhraseSense& sense, const Mention& target,
                                             const std::vector<int>& references) {
  if (sense.type != R::kAbove || target.items.size() != 1 || references.size() != 2 || mount_of(target.noun) != Mount::kCeiling)
    return false;
  const auto between = std::ranges::find_if(
      scene_.relations, [&](const Relation& r) { return r.type == R::kBetween && r.references == ids(references) && !r.targets.empty(); });
  if (between == scene_.relations.end()) return false;
  add(link, R::kAbove, ids(target.items), {between->targets.front()});
  return true;
}

// Rows behind a rail; what is at a side of the room and not of one thing.
bool RelationBuilder::add_as_many(const Link& link, const PhraseSense& sense, const Mention& target, const std::vector<int>& references) {
  constexpr std::size_t kMostBeside = 3;
  if (references.size() != 1) return false;
  if (add_rows_behind(link, sense, target, references.front())) return true;
  if ((sense.type != R::kLeftOf && sense.type != R::kRightOf) || !link.implied) return false;
  const bool left = sense.type == R::kLeftOf;
  const Mount mount = mount_of(target.noun);
  // "a dumbbell rack, a mirror wall on the right"
  if (mount == Mount::kWall && target.noun.name.ends_with(" wall")) {
    for (const int item : target.items) add(link, R::kOnWall, {id(item)}, {left ? "left" : "right"});
    return true;
  }
  // "a couch in the centre, wall bars on the left": of the room, of which the couch is the middle.
  const bool at_wall = mount == Mount::kWall || (mount == Mount::kFloor && target.noun.entry != nullptr && target.noun.entry->back_to_wall);
  const bool central = std::ranges::any_of(relations_of(id(references.front())),
                                           [&](std::size_t r) { return scene_.relations[r].type == R::kCenterOfRoom; });
  if (at_wall && central && one_of(document_.tokens[link.first].text, {"on", "to", "at"})) {
    for (const int item : target.items)
      add(link, mount == Mount::kWall ? R::kOnWall : R::kAgainstWall, {id(item)}, {left ? "left" : "right"});
    return true;
  }
  // "a bench for the judge, twelve seats on the right": so many do not stand beside one thing.
  if (mount != Mount::kFloor || target.items.size() <= kMostBeside) return false;
  const PhraseSense side{R::kInRegion, Direction::kDirect, {}, left ? RoomRegion::kLeft : RoomRegion::kRight, {}};
  for (const int item : target.items) add(link, side.type, {id(item)}, {}, side);
  return true;
}

// As many as there are references: one for each; more: shared out; fewer: by all that can be so.
void RelationBuilder::add_for_each(const Link& link, PhraseSense sense, const Mention& target, const std::vector<int>& references) {
  const bool seat_at = references.size() > 1 && sits_at(link, sense, target.noun, noun_of_item(references.front()));
  if (seat_at && target.items.size() > references.size()) {
    add_group(link, {R::kAround, Direction::kDirect, {}, {}, {}}, target.items, references, nullptr);
    return;
  }
  if (seat_at) sense.type = user_side(references.front());  // "a chair at each"
  const std::size_t n = target.items.size(), m = references.size();
  // "a bouquet waits behind both", "to the left of the monitors": of all of them.
  const bool both = sense.type == R::kAbove && m == 2 && says_one_of(document_, link.last - 1, {"both"});  // "a shelf above both"
  if (add_over_table_between(link, sense, target, references)) return;
  const bool sided = both || sense.type == R::kBehind || sense.type == R::kLeftOf || sense.type == R::kRightOf;
  const bool all = sense.type == R::kInFrontOf || sense.type == R::kOpposite || sided;
  if (sense.type == R::kOpposite && m == 1 && n > 1) {  // as a group
    add(link, sense.type, ids(target.items), {id(references.front())}, sense);
    for (const int item : target.items) add_across(link, item, {id(references.front())});
    return;
  }
  for (std::size_t t = 0; t < n; ++t) {
    const int item = target.items[t];
    if (m == 1) {
      add(link, sense.type, {id(item)}, {id(references.front())}, sense);
      if (sense.type == R::kOpposite) add_across(link, item, {id(references.front())});
      add_look(link, sense.type, item, references.front());
    } else if (n > 1 || !all) {
      // As many as there are references: one for each; more: shared out; fewer: the first.
      const std::size_t r = n >= m ? t * m / n : t;
      add(link, sense.type, {id(item)}, {id(references[n > 1 ? r : 0])}, sense);
      add_look(link, sense.type, item, references[n > 1 ? r : 0]);
    } else {
      for (const int reference : references) {
        // Nothing is straight opposite two beds that stand side by side, no keyboard in front of two screens; it is across from both.
        Link one = link;
        const bool beside_all = sense.type == R::kInFrontOf && mount_of(target.noun) != Mount::kSurface;
        one.soft |= !beside_all && reference != references.front();
        add(one, sense.type, {id(item)}, {id(reference)}, sense);
        if (sense.type == R::kOpposite) add_across(link, item, {id(reference)});
      }
      add_look(link, sense.type, item, references.front());
    }
  }
}

}  // namespace layoutbox::offline
