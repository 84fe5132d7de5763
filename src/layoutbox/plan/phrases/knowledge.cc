#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/base/words.h"
#include "layoutbox/catalog/size_words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/words/word_sets.h"
#include "layoutbox/scene/relation_traits.h"

#include <algorithm>
#include <array>

namespace layoutbox::offline {

using R = RelationType;

bool is_full_height(const NounPhrase& noun) {
  return std::ranges::any_of(kFullHeight, [&](std::string_view words) {
    return std::ranges::any_of(noun.attributes, [&](const std::string& said) { return same_name(said, words); });
  });
}

bool is_tall(const NounPhrase& noun) {
  return is_full_height(noun) || std::ranges::any_of(noun.attributes, [](const std::string& said) { return one_of(said, WordSet::kTall); });
}

bool is_common(const NounPhrase& noun) {
  return std::ranges::any_of(noun.attributes, [](const std::string& a) { return a == "shared" || a == "common" || a == "communal"; });
}

namespace {

bool may_be_under(const Catalog& catalog, const NounPhrase& host) {
  return is_table(catalog, host) || (host.entry != nullptr && host.entry->is(Trait::kBed)) || one_of(host.head, WordSet::kRoomUnder) ||
         mount_of(host) == Mount::kWall || mount_of(host) == Mount::kCeiling;
}

}  // namespace

bool may_sit_under(const Catalog& catalog, const NounPhrase& seat, const NounPhrase& over) {
  const bool sat_on = is_seat(catalog, seat) || (seat.entry != nullptr && seat.entry->is(Trait::kBed));
  return sat_on && (over.entry == nullptr || mount_of(over) == Mount::kSurface);
}

Mount mount_of(const NounPhrase& noun) {
  if (noun.entry == nullptr) return Mount::kFloor;
  if (std::any_of(noun.attributes.begin(), noun.attributes.end(), [](const std::string& a) { return a == "wall-mounted"; }))
    return Mount::kWall;
  return noun.entry->mount;
}

bool is_table(const Catalog& /*catalog*/, const NounPhrase& noun) {
  if (noun.entry == nullptr) return one_of(noun.head, WordSet::kTables);
  return noun.entry->is(Trait::kTable) || one_of(noun.head, WordSet::kTables);
}

bool one_sits_at(const Catalog& catalog, const NounPhrase& noun) {
  return is_table(catalog, noun) || (noun.entry != nullptr && noun.entry->is(Trait::kDeskLike));
}

bool is_seat(const Catalog& /*catalog*/, const NounPhrase& noun) {
  if (noun.entry != nullptr && noun.entry->is(Trait::kSeat)) return true;
  if (noun.entry != nullptr && noun.entry->is(Trait::kTable)) return false;  // a bench to work at
  return one_of(noun.head, WordSet::kSeats);
}

bool is_lamp(const Catalog& /*catalog*/, const NounPhrase& noun) {
  if (noun.entry != nullptr && noun.entry->is(Trait::kLamp)) return true;
  return one_of(noun.head, WordSet::kLamps);
}

bool is_storage(const NounPhrase& noun) {
  if (noun.entry != nullptr) {
    const auto& spaces = noun.entry->spaces;
    if (std::any_of(spaces.begin(), spaces.end(), [](const SpaceFormula& s) { return s.carries; }) && !noun.entry->used_sides.empty() &&
        noun.entry->is(Trait::kShelving))
      return true;
  }
  return one_of(noun.head, WordSet::kStorage);
}

bool is_textile(const Catalog& catalog, const NounPhrase& noun) {
  (void)catalog;
  return mount_of(noun) == Mount::kHung || one_of(noun.head, WordSet::kSoftThings);
}

bool stands_by(const Catalog& catalog, const NounPhrase& noun, const NounPhrase& other) {
  return noun.entry != nullptr && other.entry != nullptr &&
         std::any_of(noun.entry->beside.begin(), noun.entry->beside.end(),
                     [&](const std::string& kind) { return catalog.is_a(other.entry->id, kind); });
}

bool has_hooks(const NounPhrase& noun) {
  if (!one_of(noun.head, WordSet::kHookBoards)) return false;
  if (noun.entry == nullptr) return false;
  const bool inside = std::any_of(noun.entry->spaces.begin(), noun.entry->spaces.end(), [](const SpaceFormula& s) { return s.carries; });
  return !noun.entry->top_carries && !inside && !noun.entry->is(Trait::kScreen) &&
         (noun.entry->mount == Mount::kWall || noun.entry->mount == Mount::kCeiling);
}

int sides_by_shape(const NounPhrase& noun) {
  static constexpr std::array<std::pair<std::string_view, int>, 5> kShapes = {
      {{"triangular", 3}, {"square", 4}, {"pentagonal", 5}, {"hexagonal", 6}, {"octagonal", 8}}};
  for (const auto& [shape, sides] : kShapes) {
    if (std::find(noun.attributes.begin(), noun.attributes.end(), shape) != noun.attributes.end()) return sides;
  }
  return 0;
}

bool is_heavy(const Catalog& catalog, const NounPhrase& noun) {
  if (noun.entry == nullptr || mount_of(noun) != Mount::kFloor) return false;
  if (is_table(catalog, noun) || is_seat(catalog, noun) || noun.entry->thin) return true;
  if (one_of(noun.head, WordSet::kHeavyThings)) return true;
  constexpr double kHeavy = 0.25e9;  // mm³
  constexpr Mm kTall = 1300;
  const Size& usual = noun.entry->size.usual;
  return noun.entry->back_to_wall && (usual.height >= kTall || 1.0 * usual.width * usual.depth * usual.height > kHeavy);
}

namespace {

// A stage, a dais: low, and wide enough for furniture.
bool is_platform(const NounPhrase& host) {
  constexpr Mm kLow = 450;
  constexpr double kWide = 1e6;  // mm²
  if (host.entry == nullptr || !host.entry->top_carries || host.entry->is(Trait::kBed) || host.entry->is(Trait::kSeat)) return false;
  const Size& usual = host.entry->size.usual;
  return host.entry->mount == Mount::kFloor && usual.height <= kLow && 1.0 * usual.width * usual.depth >= kWide;
}

}  // namespace

// What is made for the wall and flat, as a poster or a mirror, may as well lie or stand on something.
bool lies_or_hangs(const NounPhrase& item) {
  constexpr Mm kFlat = 60;
  return item.entry != nullptr && mount_of(item) == Mount::kWall &&
         (item.entry->size.usual.depth <= kFlat || one_of(item.head, WordSet::kMayStand));
}

bool is_wide_seat(const NounPhrase& noun) {
  return noun.entry != nullptr && noun.entry->size.usual.width >= 2 * noun.entry->size.usual.depth;
}

bool is_for_several(const NounPhrase& noun) {
  constexpr int kLong = 2;
  return noun.entry != nullptr && !noun.plural && noun.entry->is(Trait::kSeat) &&
         noun.entry->size.usual.width >= kLong * noun.entry->size.usual.depth;
}

bool is_drawn_up(const Catalog& catalog, const NounPhrase& noun) {
  const bool sofa = one_of(noun.head, WordSet::kSeatsForSeveral) && noun.head != "bench";
  return is_seat(catalog, noun) && !sofa && (noun.entry == nullptr || !noun.entry->is(Trait::kEasySeat));
}

bool may_carry(const Catalog& catalog, const NounPhrase& host, const NounPhrase& item) {
  if (host.kind != NounKind::kObject) return false;
  const Mount mount = mount_of(item);
  const bool rug_host = host.entry != nullptr && host.entry->thin;
  if (rug_host) return true;
  // No lamp stands on what one lies or sits on.
  const bool soft = host.entry != nullptr && (host.entry->is(Trait::kBed) || host.entry->is(Trait::kCenterPiece));
  if (soft && is_lamp(catalog, item)) return false;
  if (item.collective) return true;
  if (mount == Mount::kHung && one_of(host.head, WordSet::kForClothes)) return true;
  // Clothes lie on beds, seats, tables and shelves as well.
  const bool lies = is_seat(catalog, host) || is_table(catalog, host) || is_storage(host) ||
                    (host.entry != nullptr && (host.entry->is(Trait::kBed) || host.entry->top_carries));
  if (mount == Mount::kHung && lies) return true;
  // A hat or a bag on its stand.
  constexpr Mm kLight = 450;
  if (host.entry != nullptr && host.entry->is(Trait::kCoatStand) && mount == Mount::kSurface && item.entry != nullptr)
    return item.entry->size.usual.width <= kLight;
  // What stands taller than the board or the hook stands by itself: a coat stand.
  constexpr Mm kTallest = 900;
  const bool tall = item.entry != nullptr && mount == Mount::kFloor && item.entry->size.usual.height > kTallest;
  if (has_hooks(host)) return mount != Mount::kCeiling && !is_heavy(catalog, item) && !tall;
  if (is_platform(host) && mount == Mount::kFloor) return true;
  // A sink unit's drainer has no room for a hob.
  constexpr Mm kRoomBeside = 450;
  if (host.entry != nullptr && host.entry->is(Trait::kCounter) && !host.entry->top_carries && item.entry != nullptr &&
      item.entry->size.usual.width > kRoomBeside)
    return false;
  if (mount != Mount::kSurface && !lies_or_hangs(item)) {
    // A thing nobody knows may be small.
    const bool unknown = item.entry == nullptr || (!item.exact && item.entry->id != item.category);
    const bool small = item.entry != nullptr && item.entry->size.usual.width <= 500 && item.entry->size.usual.height <= 600 &&
                       !item.entry->thin && !is_seat(catalog, item) && mount == Mount::kFloor && !is_table(catalog, item) &&
                       (item.entry->used_sides.empty() || one_of(item.head, WordSet::kSmallOnFloor));
    if (!(unknown && item.entry == nullptr) && !small) return false;
  }
  if (is_storage(host) || is_table(catalog, host)) return true;
  if (host.entry == nullptr) return true;
  return host.entry->top_carries || host.entry->is(Trait::kVessel) ||
         std::any_of(host.entry->spaces.begin(), host.entry->spaces.end(), [](const SpaceFormula& s) { return s.carries; });
}

bool goes_into(const NounPhrase& vessel, const NounPhrase& item) {
  if (item.entry == nullptr || !item.exact || vessel.entry == nullptr || !vessel.entry->is(Trait::kVessel)) return true;
  const Size &outer = vessel.entry->size.usual, &inner = item.entry->size.usual;
  if (outer.height < outer.width) return true;  // a tray, a bowl
  std::array<Mm, 3> sides = {inner.width, inner.depth, inner.height};
  std::ranges::sort(sides);
  return sides[1] <= std::max(outer.width, outer.depth);
}

// What things on one floor are to each other.
bool stands_beside(RelationType type) { return traits_of(type).beside || type == R::kAtFootOf; }

bool may_refer(const Catalog& catalog, const PhraseSenses& senses, const NounPhrase& target, const NounPhrase& reference) {
  if (reference.kind != NounKind::kObject || target.kind != NounKind::kObject) return true;
  if (says(senses, &RelationTraits::rests)) return may_carry(catalog, reference, target);
  if (says(senses, RelationType::kUnder) && mount_of(target) == Mount::kFloor && (target.entry == nullptr || !target.entry->thin))
    return may_be_under(catalog, reference) || may_sit_under(catalog, target, reference);
  const bool beside = std::any_of(senses.begin(), senses.end(), [](const PhraseSense& s) { return stands_beside(s.type); });
  if (beside && mount_of(target) == Mount::kFloor) return mount_of(reference) != Mount::kSurface && mount_of(reference) != Mount::kCeiling;
  return true;
}

}  // namespace layoutbox::offline
