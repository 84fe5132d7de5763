// One relation for each single thing: what a phrase means for these two, and what it says besides.
#include <algorithm>

#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

using R = RelationType;
using Direction = PhraseSense::Direction;

// "on the left side of the desk" is on the desk for what stands on desks, beside it for the rest.
bool RelationBuilder::is_side_on(const Link& link, const PhraseSense& sense, const NounPhrase& thing, const NounPhrase& host) const {
  if (sense.type != R::kLeftOf && sense.type != R::kRightOf) return false;
  const std::string words = words_between(document_, link.first, link.last);
  const bool bare =
      one_of(document_.tokens[std::min(link.first + 1, document_.tokens.size() - 1)].text, {"left", "right"});  // "on left of"
  const bool side_of = words.find("side") != std::string::npos || (document_.tokens[link.first].text == "on" && !bare);
  const bool lies = is_seat(catalog_, host) || one_of(host.head, WordSet::kLainOn);
  // "a scale on the left side of the counter": such a thing has a kind that stands there
  const bool kept = host.entry != nullptr && thing.name == thing.head && !kept_in_entry(thing.head, *host.entry).empty();
  return side_of && !lies && may_carry(catalog_, host, thing) && (mount_of(thing) == Mount::kSurface || thing.entry == nullptr || kept) &&
         mount_of(host) != Mount::kSurface;
}

// "on top of every locker", "atop".
bool RelationBuilder::says_top(const Link& link) const {
  for (std::size_t i = link.first; i < link.last; ++i) {
    const std::string& word = document_.tokens[i].text;
    if (word == "atop" || (word == "top" && i > 0 && document_.tokens[i - 1].text == "on")) return true;
  }
  return false;
}

// A wardrobe, a locker: what is on it is on its top.
bool RelationBuilder::is_closed(const CatalogEntry& host) {
  return std::ranges::all_of(host.spaces, [](const SpaceFormula& space) { return !space.carries || space.name == "inside"; });
}

// What the phrase comes to mean by what the two are and where the reference is.
void RelationBuilder::settle_sense(const Link& link, PhraseSense& sense, const Mention& target, const std::vector<int>& references) const {
  const NounPhrase& host = noun_of_item(references.front());
  const Mount mount = mount_of(target.noun);
  // What lies on something itself has things beside it.
  const bool lies = host.entry == nullptr && !said_support(id(references.front())).empty();
  // "flanked by two lanterns, one on its left": beside it
  const bool flanks_it = std::ranges::any_of(relations_of(id(target.items.front())), [&](std::size_t r) {
    return scene_.relations[r].type == R::kEachSideOf && scene_.relations[r].references.front() == id(references.front());
  });
  if (!lies && !flanks_it && is_side_on(link, sense, target.noun, host)) {
    sense.part = sense.type == R::kLeftOf ? PartWord::kLeft : PartWord::kRight;
    sense.type = R::kOn;
  }
  if (sense.type == R::kAbove && !says_over(link)) settle_lighting(sense, target.noun, host);
  if (sense.type == R::kAtHeadOf && mount == Mount::kWall) sense.type = R::kAbove;  // "a picture above the head of the bed"
  if (sense.type == R::kOn && sense.part.empty() && host.entry != nullptr && host.entry->top_carries &&
      (says_top(link) || is_closed(*host.entry)) && std::ranges::any_of(host.entry->spaces, &SpaceFormula::carries))
    sense.part = PartWord::kTop;  // of a locker, not in it
  if (sense.type == R::kOpposite && mount == Mount::kSurface && document_.tokens[link.first].text == "across" &&
      link.last - link.first <= 3 && mount_of(host) == Mount::kFloor && !link.implied)
    sense.type = R::kOn;  // "a tray across the tub"
}

// "a desk facing a chair": the chair is drawn up to it.
bool RelationBuilder::add_drawn_up(const Link& link, const PhraseSense& sense, const Mention& target, const std::vector<int>& references) {
  if (sense.type != R::kFacing || !is_table(catalog_, target.noun)) return false;
  const NounPhrase& other = noun_of_item(references.front());
  if (!is_seat(catalog_, other) || !one_of(other.head, {"chair", "stool"}) || target.items.size() != 1 ||
      mount_of(target.noun) != Mount::kFloor)
    return false;
  for (const int seat : references) {
    add(link, R::kInFrontOf, {id(seat)}, {id(target.items.front())});
    add(link, R::kFacing, {id(seat)}, {id(target.items.front())});
  }
  return true;
}

// "a glass in front of every chair": on the table where it stands.
bool RelationBuilder::add_before_seats(const Link& link, const PhraseSense& sense, const Mention& target,
                                       const std::vector<int>& references) {
  if (sense.type != R::kInFrontOf || mount_of(target.noun) != Mount::kSurface || !is_seat(catalog_, noun_of_item(references.front())))
    return false;
  std::size_t laid = 0;
  for (std::size_t t = 0; t < target.items.size(); ++t) {
    const std::string table = table_of(id(references[std::min(t * references.size() / target.items.size(), references.size() - 1)]));
    if (table.empty()) break;
    add(link, R::kOn, {id(target.items[t])}, {table});
    const std::size_t seat = std::min(t * references.size() / target.items.size(), references.size() - 1);
    if (target.items.size() <= references.size()) {
      add(link, R::kInFrontOf, {id(target.items[t])}, {id(references[seat])});
      scene_.relations.back().hard = false;  // as near as the others leave room
    }
    ++laid;
  }
  return laid == target.items.size();
}

// "a mirror in front of each chair": who sits there looks into it.
bool RelationBuilder::add_before_mirrors(const Link& link, const Mention& target, const std::vector<int>& references) {
  if (!is_seat(catalog_, noun_of_item(references.front())) || target.items.size() != references.size()) return false;
  for (std::size_t m = 0; m < target.items.size(); ++m) {
    add(link, R::kOnWall, {id(target.items[m])}, {});
    add(link, R::kInFrontOf, {id(references[m])}, {id(target.items[m])});
    add(link, R::kFacing, {id(references[m])}, {id(target.items[m])});
  }
  return true;
}

// "two seats at a panel of dials" on the wall, as at a desk.
bool RelationBuilder::is_worked_at(const NounPhrase& noun) const {
  return mount_of(noun) == Mount::kWall && noun.entry != nullptr && !noun.entry->used_sides.empty() && !noun.entry->is(Trait::kCurtain) &&
         !noun.entry->is(Trait::kMirror);
}

// A seat "at" a table, "drawn up to" it, is used there, from any side.
bool RelationBuilder::sits_at(const Link& link, const PhraseSense& sense, const NounPhrase& seat, const NounPhrase& table) const {
  if (!is_seat(catalog_, seat) || !(is_table(catalog_, table) || is_worked_at(table))) return false;
  const std::string& word = document_.tokens[link.first].text;
  if (sense.type == R::kInFrontOf) return one_of(word, {"pulled", "drawn"});
  return sense.type == R::kNextTo && one_of(word, {"at", "to", "for"});
}

// Two that stand on either side of what such things flank; seats at a table or along a counter.
bool RelationBuilder::add_by_one(const Link& link, const PhraseSense& sense, const Mention& target, int reference) {
  const NounPhrase& host = noun_of_item(reference);
  const bool several = target.items.size() > 1;
  if (sense.type == R::kNextTo && target.items.size() == 2 && link.references.size() == 1 && flanks(target.noun, host)) {
    add(link, R::kEachSideOf, ids(target.items), {id(reference)});
    return true;
  }
  const bool at = sits_at(link, sense, target.noun, host);
  // Several of them along a counter sit before it.
  const bool along = (sense.type == R::kNextTo || sense.type == R::kAlongSide) && !sense.side && several &&
                     seats_one_side(link, target.items.front(), reference);
  if (several && (at || along)) {
    add_group(link, {R::kAround, Direction::kDirect, {}, {}, {}}, target.items, {reference}, nullptr);
    return true;
  }
  if (!at) return false;
  add(link, user_side(reference, !several), {id(target.items.front())}, {id(reference)});
  add(link, R::kFacing, {id(target.items.front())}, {id(reference)});
  return true;
}

// What stands under a thing on the wall: the wall's thing is above it.
bool RelationBuilder::add_under_hung(const Link& link, const PhraseSense& sense, const Mention& target,
                                     const std::vector<int>& references) {
  if (sense.type != R::kUnder || mount_of(target.noun) != Mount::kFloor || target.items.size() != 1) return false;
  const std::vector<std::size_t>& all = relations_of(id(references.front()));
  const bool hung = std::any_of(all.begin(), all.end(), [&](std::size_t r) { return scene_.relations[r].type == R::kOnWall; });
  const Mount above = may_sit_under(catalog_, target.noun, noun_of_item(references.front())) ? Mount::kWall
                      : hung                                                                 ? Mount::kWall
                                                                                             : mount_of(noun_of_item(references.front()));
  if (above != Mount::kWall && above != Mount::kCeiling) return false;
  for (const int reference : references) add(link, R::kAbove, {id(reference)}, {id(target.items.front())});
  return true;
}

// "behind the desk a clock is mounted on the wall": above it where the desk itself stands against the wall.
bool RelationBuilder::hangs_over(const PhraseSense& sense, const Mention& target, const std::vector<int>& references) const {
  if (sense.type != R::kBehind || mount_of(target.noun) != Mount::kWall || references.size() != 1) return false;
  const std::vector<std::size_t>& all = relations_of(id(references.front()));
  return std::any_of(all.begin(), all.end(), [&](std::size_t r) {
    return scene_.relations[r].type == R::kAgainstWall || scene_.relations[r].type == R::kCenteredOnWall;
  });
}

void RelationBuilder::add_single(const Link& link, PhraseSense sense, const Mention& target, const std::vector<int>& references,
                                 const Mention* place) {
  if (references.empty()) {
    if (place != nullptr) add_in_room(link, sense, target, place->noun);
    return;
  }
  if (sense.type == R::kOpposite && references.size() == 1 && add_on_other_side(link, sense, target, references.front())) return;
  if (sense.type == R::kOpposite && references.size() == 1 && add_across_table(link, target, references.front())) return;
  if (sense.type == R::kOpposite && add_across_room(link, target, references)) return;
  if (sense.type == R::kOpposite) add_wall_opposite(link, target);
  settle_sense(link, sense, target, references);
  if (add_drawn_up(link, sense, target, references)) return;
  if (hangs_over(sense, target, references)) sense.type = R::kAbove;
  if (add_before_seats(link, sense, target, references)) return;
  // "magazines at one end" of a table lie on it.
  if (sense.type == R::kAlongSide && mount_of(target.noun) == Mount::kSurface) sense = {R::kOn, Direction::kDirect, PartWord::kEnd, {}, {}};
  if (sense.type == R::kIn && !has_inside(noun_of_item(references.front())) && !is_hollow_by(link, noun_of_item(references.front()))) {
    const auto object = [&](int item) -> const SceneObject& { return scene_.objects[static_cast<std::size_t>(item)]; };
    sense.type = is_used_within(object(target.items.front()), object(references.front())) ? R::kInside : R::kOn;
  }
  if (references.size() == 1 && add_by_one(link, sense, target, references.front())) return;
  if (add_under_hung(link, sense, target, references) || add_by_carrier(link, sense, target, references.front()) ||
      add_as_many(link, sense, target, references))
    return;
  // "A mirror wall in front" of mats: on the wall there, not on the floor before them.
  if (sense.type == R::kInFrontOf && mount_of(target.noun) == Mount::kWall && is_mirror(target.noun)) {
    if (add_before_mirrors(link, target, references)) return;
    for (const int item : target.items) add(link, R::kOnWall, {id(item)}, {});
    return;
  }
  add_for_each(link, sense, target, references);
}

bool RelationBuilder::is_mirror(const NounPhrase& noun) { return noun.entry != nullptr && noun.entry->is(Trait::kMirror); }

bool RelationBuilder::flanks(const NounPhrase& thing, const NounPhrase& host) const {
  if (thing.entry == nullptr || host.entry == nullptr) return false;
  if (!one_of(host.head, WordSet::kLainOn)) return false;
  return stands_by(catalog_, thing, host);
}

void RelationBuilder::add_look(const Link& link, R type, int item, int reference) {
  const NounPhrase &thing = noun_of_item(item), &other = noun_of_item(reference);
  const auto screen = [](const NounPhrase& n) {
    return one_of(n.head, WordSet::kScreens) || n.name.find("tv ") != std::string::npos || n.name.find("media") != std::string::npos;
  };
  const bool seat = is_seat(catalog_, thing);
  const bool before = (type == R::kInFrontOf || type == user_side(reference)) &&
                      ((seat && (is_table(catalog_, other) || screen(other) || is_mirror(other))) || screen(thing));
  if (!before && (type != R::kAlongSide || !seat)) return;
  Link look = link;
  look.concluded = true;
  add(look, R::kFacing, {id(item)}, {id(reference)});
}

}  // namespace layoutbox::offline
