#include "layoutbox/plan/phrases/object_size.h"

#include <algorithm>
#include <cmath>

#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {
namespace {

// "a 55-inch TV": the diagonal of a screen of 16:9.
constexpr double kWidthOfDiagonal = 0.8716, kHeightOfDiagonal = 0.4903;

bool is_screen(const CatalogEntry& entry) { return entry.is(Trait::kScreen) || entry.is(Trait::kMonitor); }

bool is_as_wide_as_deep(const NounPhrase& noun) {
  return std::any_of(noun.attributes.begin(), noun.attributes.end(),
                     [](const std::string& a) { return a == "square" || one_of(a, WordSet::kAllRound); });
}

// Which of the three sides "a 6-foot bookcase" speaks of: the longest that such a thing usually has, unless that is never so long and
// another one may be: "a 48 inch vanity" and "a 140 cm bed" are so wide.
Mm Size::*side_spoken_of(const SizeRange& range, double span) {
  const Mm length = mm_from_m(span);
  const auto may_be = [&](Mm Size::*side) { return range.least.*side <= length && length <= range.greatest.*side; };
  const Size& usual = range.usual;
  Mm Size::*longest = usual.depth > usual.width ? &Size::depth : &Size::width;
  if (usual.height > usual.*longest) longest = &Size::height;
  if (may_be(longest)) return longest;
  for (Mm Size::*side : {&Size::width, &Size::depth}) {
    if (may_be(side)) return side;
  }
  return longest;
}

SaidSize with_span(SaidSize size, const CatalogEntry& entry, const NounPhrase& noun) {
  const double span = *size.span;
  if (is_screen(entry)) {
    size.width = span * kWidthOfDiagonal;
    size.height = span * kHeightOfDiagonal;
    return size;
  }
  Mm Size::*side = side_spoken_of(entry.size, span);
  if (side == &Size::height) {
    size.height = span;
  } else if (is_as_wide_as_deep(noun)) {
    size.width = size.depth = span;
  } else if (side == &Size::depth) {
    size.depth = span;
  } else {
    size.width = span;
  }
  return size;
}

SaidSize settled(const NounPhrase& noun, const CatalogEntry& entry) {
  SaidSize size = noun.size;
  const Size& usual = entry.size.usual;
  if (size.span) size = with_span(size, entry, noun);
  if (size.length && size.width && !size.depth && usual.depth <= usual.width) size.depth = size.width;  // "2.4 m long, 1 m wide"
  if (size.length) (usual.depth > usual.width ? size.depth : size.width) = size.length;
  if (is_as_wide_as_deep(noun) && size.width.has_value() != size.depth.has_value())
    size.width = size.depth = size.width ? size.width : size.depth;
  // "a mirror 60 x 90 cm", "a poster of 50 x 70": what hangs flat on a wall has a width and a height.
  constexpr Mm kFlat = 150;
  const bool flat = (entry.mount == Mount::kWall || entry.mount == Mount::kHung) && usual.depth <= kFlat && usual.height > usual.depth;
  if (size.either && flat && size.depth && !size.height) {
    std::swap(size.height, size.depth);
    size.either = false;
  }
  const bool turned =
      size.either && size.width && size.depth && usual.width != usual.depth && (*size.width > *size.depth) != (usual.width > usual.depth);
  if (turned) std::swap(size.width, size.depth);
  return size;
}

// "a stack of menus": several on one another, a forearm high at most; what stands on the floor as one does.
void apply_heap_size(const NounPhrase& noun, SceneObject& object) {
  constexpr int kSeveral = 6;
  constexpr Mm kHighest = 350;
  if (noun.entry == nullptr || noun.entry->mount == Mount::kFloor) return;
  SizeRange range = noun.entry->size;
  for (Size* size : {&range.least, &range.usual, &range.greatest})
    size->height = std::max(size->height, std::min(kSeveral * size->height, kHighest));
  object.size = range;
  object.size_source = SizeSource::kInferred;
}

// "a bench for four": as wide as they sit. "A table for ten": as large as such a table, whoever sits on which side.
void apply_seats(const Catalog& catalog, const NounPhrase& noun, SceneObject& object) {
  constexpr Mm kPlace = 480;
  constexpr int kMost = 8, kSeveral = 3;
  if (noun.entry == nullptr || noun.plural || noun.seats == 0) return;
  SizeRange range = noun.entry->size;
  if (is_for_several(noun) && noun.seats <= kMost && noun.seats * kPlace > range.usual.width) {
    range.least.width = range.usual.width = noun.seats * kPlace;
  } else if (const Seating* seating = Groups::builtin().seating_at(catalog, *noun.entry, "");
             seating != nullptr && noun.seats >= kSeveral) {
    const auto wanted = size_for_seats(*seating, is_round(object, *noun.entry), noun.seats);
    if (!wanted) return;
    range.usual.width = std::max(range.usual.width, wanted->width);
    range.usual.depth = std::max(range.usual.depth, wanted->depth);
    const auto tight = [](Mm side) { return side * 9 / 10; };  // they still sit there
    range.least.width = std::max(range.least.width, tight(wanted->width));
    range.least.depth = std::max(range.least.depth, std::min(tight(wanted->depth), range.usual.depth));
  } else {
    return;
  }
  range.greatest.width = std::max(range.greatest.width, range.usual.width);
  range.greatest.depth = std::max(range.greatest.depth, range.usual.depth);
  object.size = range;
  object.size_source = SizeSource::kInferred;
}

}  // namespace

void apply_size(const Catalog& catalog, const NounPhrase& noun, SceneObject& object) {
  if (noun.heaped) apply_heap_size(noun, object);
  apply_seats(catalog, noun, object);
  if (!noun.size.any()) return;
  static const CatalogEntry unknown;
  const CatalogEntry& entry = noun.entry != nullptr ? *noun.entry : unknown;
  const SaidSize size = settled(noun, entry);
  SizeRange range = entry.size;
  const auto fix = [&](const std::optional<double>& said, Mm Size::*side) {
    if (said) range.least.*side = range.usual.*side = range.greatest.*side = mm_from_m(*said);
  };
  fix(size.width, &Size::width);
  fix(size.depth, &Size::depth);
  fix(size.height, &Size::height);
  object.size = range;
  object.size_source = SizeSource::kUser;
}

void apply_assorted_size(const NounPhrase& noun, int rank, int count, SceneObject& object) {
  if (noun.entry == nullptr || count < 2 || noun.size.any()) return;
  constexpr double kOwnRange = 0.1;  // it may be so much smaller or larger than its rank says
  const double share = static_cast<double>(rank) / (count - 1);
  SizeRange range = noun.entry->size;
  for (const auto side : {&Size::width, &Size::depth, &Size::height}) {
    const double low = range.least.*side, high = (range.usual.*side + range.greatest.*side) / 2.0;
    const double usual = low + share * (high - low);
    range.usual.*side = static_cast<Mm>(std::lround(usual));
    range.least.*side = static_cast<Mm>(std::lround(std::max(low, usual * (1 - kOwnRange))));
    range.greatest.*side = static_cast<Mm>(std::lround(std::min(high, usual * (1 + kOwnRange))));
  }
  object.size = range;
  object.size_source = SizeSource::kInferred;
}

}  // namespace layoutbox::offline
