// "separated from the living area by an open bookshelf", "a screen as a divider": what parts two groups stands between them.
#include <algorithm>

#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

using R = RelationType;

// What may part a room: as flat as a shelf or a screen, and it stands on the floor or hangs from the ceiling.
bool RelationBuilder::may_divide(int item) const {
  const CatalogEntry* entry = noun_of_item(item).entry;
  if (entry == nullptr || entry->thin) return false;
  const Size& size = entry->size.usual;
  const bool flat = 3 * size.depth <= 2 * size.width && !entry->is(Trait::kSeat) && !entry->is(Trait::kTable) && !entry->is(Trait::kBed) &&
                    !entry->is(Trait::kCenterPiece);
  return flat && (entry->mount == Mount::kFloor || entry->is(Trait::kCurtain));
}

// The great thing of the part of the room whose name stands at token i ("living area"), or that is named there; -1: none.
int RelationBuilder::side_at(std::size_t i) const {
  const auto stands = [&](int item) {
    const CatalogEntry* entry = noun_of_item(item).entry;
    return entry != nullptr && entry->mount == Mount::kFloor && !entry->thin && !entry->is(Trait::kTableSeat);
  };
  for (const Mention& m : document_.mentions) {
    if (m.noun.kind == NounKind::kObject && m.noun.last == i + 1 && !m.items.empty() && stands(m.items.front())) return m.items.front();
  }
  if (!says_one_of(document_, i + 1, WordSet::kRoomParts)) return -1;
  for (const ZoneUse& row : Groups::builtin().zones) {
    if (std::ranges::find(row.said, document_.tokens[i].text) == row.said.end()) continue;
    for (const std::string& kind : row.unless) {
      for (std::size_t item = 0; item < document_.items.size(); ++item) {
        const NounPhrase& noun = document_.items[item].noun;
        if (noun.entry != nullptr && catalog_.is_a(noun.entry->id, kind) && stands(static_cast<int>(item))) return static_cast<int>(item);
      }
    }
  }
  return -1;
}

// Of the other things the greatest that a group of its own stands round.
int RelationBuilder::other_side(int divider, int side) const {
  int greatest = -1;
  double most = 0;
  for (std::size_t i = 0; i < document_.items.size(); ++i) {
    const int item = static_cast<int>(i);
    const CatalogEntry* entry = noun_of_item(item).entry;
    if (entry == nullptr || item == divider || item == side || entry->mount != Mount::kFloor) continue;
    const bool heart = entry->is(Trait::kCenterPiece) || entry->is(Trait::kBed) || entry->is(Trait::kDesk);
    const bool same = side >= 0 && noun_of_item(side).entry == entry;
    const double area = double(entry->size.usual.width) * entry->size.usual.depth;
    if (heart && !same && area > most) greatest = item, most = area;
  }
  return greatest;
}

// "two desks on opposite walls, a bookcase as a divider": the other of the two; -1: there are more, or none.
int RelationBuilder::only_twin(int side) const {
  int twin = -1;
  for (std::size_t i = 0; i < document_.items.size(); ++i) {
    if (static_cast<int>(i) == side || document_.items[i].noun.entry != noun_of_item(side).entry) continue;
    if (twin >= 0) return -1;
    twin = static_cast<int>(i);
  }
  return twin;
}

// What nobody gave a size is as wide as parts something.
// … and hides all of a bed's width, from who sits.
void RelationBuilder::widen(int divider, const std::vector<int>& sides) {
  constexpr Mm kParts = 1600, kBeyondBed = 100, kHides = 1500;
  const NounPhrase& noun = noun_of_item(divider);
  SceneObject& object = scene_.objects[static_cast<std::size_t>(divider)];
  Mm bed = 0;
  for (const int side : sides) {
    const CatalogEntry* entry = noun_of_item(side).entry;
    if (entry != nullptr && entry->is(Trait::kBed)) bed = entry->size.usual.width + kBeyondBed;
  }
  if (noun.size.any() || object.size || noun.entry->size.usual.width >= std::max(kParts, bed)) return;
  SizeRange size = noun.entry->size;
  size.usual.width = std::max(std::min(kParts, size.greatest.width), bed);
  size.greatest.width = std::max(size.greatest.width, size.usual.width);
  if (bed > 0) size.usual.height = std::max(size.usual.height, std::min(kHides, size.greatest.height));
  object.size = size;
}

void RelationBuilder::divide(std::size_t word) {
  std::size_t first = word, last = word;
  while (first > 0 && !document_.tokens[first - 1].ends_sentence) --first;
  while (last < document_.tokens.size() && !document_.tokens[last].ends_sentence) ++last;
  const bool passive = says_one_of(document_, word, WordSet::kDividedBy);
  int divider = -1;
  for (std::size_t i = 0; i < document_.items.size(); ++i) {
    const NounPhrase& noun = document_.items[i].noun;
    if (noun.first < first || noun.first >= last) continue;
    if (passive ? noun.first > word && divider < 0 && may_divide(static_cast<int>(i)) : noun.first <= word) divider = static_cast<int>(i);
  }
  if (divider < 0 || !may_divide(divider)) return;
  // "two tables separated by a curtain": said already.
  const bool said = std::ranges::any_of(scene_.relations, [&](const Relation& r) {
    return r.type == R::kBetween && r.origin == Origin::kAsked && r.targets == std::vector<std::string>{id(divider)};
  });
  std::vector<int> sides;
  const auto take = [&](int item) {
    if (item >= 0 && item != divider && !contains(sides, item) && sides.size() < 2) sides.push_back(item);
  };
  // "a bed behind a shelf used as a divider, a sofa": what is named before parts from what follows.
  const bool between =
      passive || !says_one_of(document_, word, WordSet::kDividers) || says_one_of(document_, word + 1, {"between", "from"});
  for (std::size_t i = word; !between && i-- > first && sides.empty();) take(side_at(i));
  for (std::size_t i = word + 1; i < last; ++i) take(side_at(i));
  if (passive && sides.size() > 1) sides.resize(1);  // "separated from the living area by a shelf, a sofa"
  for (std::size_t i = word; i-- > first && sides.size() < 2;) take(side_at(i));
  if (said && sides.size() < 2) return widen(divider);  // "divides the dining area from the living area" names both
  if (sides.size() == 1) take(other_side(divider, sides.front()));
  const bool twins = sides.size() == 1;
  if (twins) take(only_twin(sides.front()));
  if (sides.size() < 2 || (!twins && noun_of_item(sides[0]).entry == noun_of_item(sides[1]).entry)) return;
  const std::vector<std::string> parted{id(sides[0]), id(sides[1])};
  const std::string& own = id(divider);
  const auto is_parted = [&](const std::string& other) { return std::ranges::find(parted, other) != parted.end(); };
  std::erase_if(scene_.relations, [&](const Relation& r) {
    const bool by_it = r.targets == std::vector<std::string>{own} && std::ranges::any_of(r.references, is_parted);
    const bool it_by = r.references == std::vector<std::string>{own} && std::ranges::any_of(r.targets, is_parted);
    const bool said_otherwise = said && r.type == R::kBetween && r.targets == std::vector<std::string>{own};
    return said_otherwise || ((by_it || it_by) && r.type != R::kDistance);
  });
  widen(divider, sides);
  conclude(R::kBetween, {own}, parted, "what parts two groups stands between them");
}

// "TV with a sofa and two armchairs on the left, dining table on the right, a low bookcase between both": no shelf is between two chairs of
// one group; the groups are meant.
void RelationBuilder::part_groups() {
  for (Relation& between : scene_.relations) {
    if (between.type != R::kBetween || between.targets.size() != 1 || between.references.size() != 2 || !between.asked()) continue;
    const auto divider = objects_.find(between.targets[0]);
    if (divider == objects_.end() || !may_divide(static_cast<int>(divider->second))) continue;
    const auto is_one_seat = [&](const std::string& one) {
      const SceneObject* object = object_of(one);
      const CatalogEntry* entry = object == nullptr ? nullptr : noun_of_object(*object).entry;
      return entry != nullptr && (entry->is(Trait::kSeat) || entry->is(Trait::kEasySeat)) && !entry->is(Trait::kCenterPiece);
    };
    const bool grouped = std::ranges::any_of(scene_.relations, [&](const Relation& r) {
      return r.type == R::kAround && std::ranges::all_of(between.references, [&](const std::string& one) {
               return std::ranges::find(r.targets, one) != r.targets.end();
             });
    });
    if (!grouped || !std::ranges::all_of(between.references, is_one_seat)) continue;
    int table = -1;
    for (std::size_t i = 0; i < document_.items.size(); ++i) {
      if (document_.items[i].noun.entry != nullptr && document_.items[i].noun.entry->is(Trait::kTable) &&
          is_eaten_at(document_.items[i].noun))
        table = static_cast<int>(i);
    }
    const int heart = other_side(static_cast<int>(divider->second), table);
    if (table < 0 || heart < 0) continue;
    between.references = {id(heart), id(table)};
    widen(static_cast<int>(divider->second));
  }
}

// "A bed in the left half, a desk in the right half and a shelf between them": between the two halves.
void RelationBuilder::part_halves() {
  const auto first_in = [&](RoomRegion region, const std::string& but) -> std::string {
    const auto found = std::ranges::find_if(scene_.relations, [&](const Relation& r) {
      const SceneObject* object = r.targets.size() == 1 ? object_of(r.targets[0]) : nullptr;
      return r.type == R::kInRegion && r.asked() && r.parameters.region == region && object != nullptr && object->id != but &&
             is_heavy(catalog_, noun_of_object(*object));
    });
    return found == scene_.relations.end() ? std::string{} : found->targets[0];
  };
  std::vector<std::string> parting;
  for (Relation& between : scene_.relations) {
    const bool said = words_.have_phrase(between, {"between", "them"}) || words_.have_phrase(between, {"between", "both"}) ||
                      words_.have_phrase(between, {"between", "the", "two"});
    if (between.type != R::kNextTo || between.targets.size() != 1 || !said) continue;
    for (const auto& [one, other] : {std::pair{RoomRegion::kLeft, RoomRegion::kRight}, std::pair{RoomRegion::kFront, RoomRegion::kBack}}) {
      const std::string a = first_in(one, between.targets[0]), b = first_in(other, between.targets[0]);
      if (a.empty() || b.empty()) continue;
      between.type = R::kBetween;
      between.references = {a, b};
      parting.push_back(between.targets[0]);
      break;
    }
  }
  for (Relation& r : scene_.relations) {
    if (r.type != R::kInRegion || r.targets.size() != 1 || std::ranges::find(parting, r.targets[0]) == parting.end()) continue;
    r.hard = false;  // it is in neither
    r.origin = Origin::kConcluded;
  }
}

// "a bookcase that separates the bed from the desk": with one end at a wall it does, with its back there it parts nothing.
void RelationBuilder::stand_out_from_walls() {
  std::vector<std::string> dividers;
  for (const Relation& between : scene_.relations) {
    if (between.type != R::kBetween || between.targets.size() != 1 || between.references.size() != 2) continue;
    const auto divider = objects_.find(between.targets[0]);
    if (divider == objects_.end() || !may_divide(static_cast<int>(divider->second))) continue;
    const bool said = between.origin == Origin::kConcluded || words_.have(between, WordSet::kDividing);
    const bool parts = said && std::ranges::all_of(between.references, [&](const std::string& one) {
                         const SceneObject* object = object_of(one);
                         return object != nullptr && is_heavy(catalog_, noun_of_object(*object));
                       });
    if (parts && noun_of_object(scene_.objects[divider->second]).entry->mount == Mount::kFloor) dividers.push_back(between.targets[0]);
  }
  for (const std::string& divider : dividers) {
    const bool placed = std::ranges::any_of(relations_of(divider), [&](std::size_t r) {
      const Relation& relation = scene_.relations[r];
      return relation.type == R::kAgainstWall || relation.type == R::kInRegion || relation.type == R::kCorner;
    });
    if (placed) continue;
    conclude(R::kSideAgainstWall, {divider}, {}, "what parts a room stands out from a wall");
    scene_.relations.back().parameters.side = Side::kShort;
  }
}

void RelationBuilder::divide_groups() {
  std::size_t sentence = document_.tokens.size();
  for (std::size_t i = 0; i < document_.tokens.size(); ++i) {
    const bool as = says_one_of(document_, i, WordSet::kDividers) &&
                    (says_one_of(document_, i - std::min<std::size_t>(i, 1), {"as", "a", "room", "the"}));
    const bool verb = says_one_of(document_, i, WordSet::kDividing);
    const bool screened = says_one_of(document_, i, WordSet::kScreened) && says_one_of(document_, i + 1, {"off", "from"});
    if ((!as && !verb && !screened) || i < 2) continue;
    const bool led = as && (says_one_of(document_, i - 1, {"as"}) || says_one_of(document_, i - 2, {"as"}) ||
                            (i > 2 && says_one_of(document_, i - 3, {"as"})));
    if ((!led && !verb && !screened) || sentence == i) continue;
    sentence = i;
    divide(i);
  }
}

}  // namespace layoutbox::offline
