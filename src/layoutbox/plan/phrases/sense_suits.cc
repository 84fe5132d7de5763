// How well a relation suits the things that a phrase would have in it.

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

using R = RelationType;

namespace {

// On the wall hangs what is made for it; beds, tables and seats do not.
int suits_on_wall(const Catalog& catalog, const NounPhrase& target) {
  const Mount mount = mount_of(target);
  if (mount == Mount::kWall) return 2;
  const bool stands = is_table(catalog, target) || is_seat(catalog, target) || one_of(target.head, WordSet::kBigFurniture);
  return mount == Mount::kFloor && target.entry != nullptr && (stands || target.entry->thin) ? 0 : 1;
}

int suits_on(const Catalog& catalog, const NounPhrase& target, const NounPhrase& reference) {
  if (reference.kind == NounKind::kFloor) return mount_of(target) == Mount::kFloor ? 2 : 1;
  if (reference.kind == NounKind::kObject && may_carry(catalog, reference, target)) return 2;
  return mount_of(target) == Mount::kSurface ? 1 : 0;
}

int suits_above(const Catalog& catalog, const NounPhrase& target, const NounPhrase& reference) {
  const Mount mount = mount_of(target);
  // What lies or hangs loosely is over no door or window; curtains are.
  const bool opening = is_opening(reference);
  if (opening && mount == Mount::kHung && !(target.entry != nullptr && target.entry->is(Trait::kCurtain))) return 0;
  // "a dispenser on the counter, lanterns from the ceiling above it": above the counter
  if (mount == Mount::kCeiling && reference.kind == NounKind::kObject && mount_of(reference) == Mount::kSurface) return 0;
  // "a shower, a toilet, a vanity, a mirror over it": over none of which the wall ends
  constexpr Mm kUpToCeiling = 1900;
  const bool high = reference.kind == NounKind::kObject && mount_of(reference) == Mount::kFloor && reference.entry != nullptr &&
                    reference.entry->size.usual.height >= kUpToCeiling;
  if (mount == Mount::kWall && high) return 0;
  if (mount == Mount::kWall || mount == Mount::kCeiling || is_lamp(catalog, target)) return 2;
  if (one_of(target.head, WordSet::kMayHang)) return 1;  // may hang
  return mount == Mount::kSurface ? 0 : 1;
}

// A small thing is seldom beside what stands on the floor, or at a door, a window or a wall.
int suits_beside(RelationType type, const NounPhrase& target, const NounPhrase& reference) {
  if (mount_of(target) != Mount::kSurface) return 2;
  const bool by_great = stands_beside(type) && reference.kind == NounKind::kObject && mount_of(reference) == Mount::kFloor;
  const bool by_room = reference.kind == NounKind::kWindow || reference.kind == NounKind::kDoor || reference.kind == NounKind::kWall;
  return by_great || by_room ? 1 : 2;
}

// Furniture looks at furniture, at screens and out of windows, seldom at what lies on a table.
int suits_facing(const NounPhrase& target, const NounPhrase& reference) {
  if (target.entry != nullptr && !target.entry->has_front) return 1;
  const bool small = reference.kind == NounKind::kObject && mount_of(reference) == Mount::kSurface;
  const bool screen = reference.entry != nullptr && reference.entry->is(Trait::kScreen);
  return small && !screen && mount_of(target) == Mount::kFloor ? 1 : 2;
}

}  // namespace

int suits(const Catalog& catalog, const PhraseSense& sense, const NounPhrase& target, const NounPhrase& reference) {
  const Mount mount = mount_of(target);
  switch (sense.type) {
    case R::kAgainstWall:
    case R::kCenteredOnWall:
    case R::kSideAgainstWall: return mount == Mount::kFloor ? 2 : mount == Mount::kSurface || mount == Mount::kWall ? 1 : 0;
    case R::kCorner: return mount == Mount::kFloor ? 2 : 1;
    case R::kOnWall: return suits_on_wall(catalog, target);
    case R::kOnCeiling: return mount == Mount::kCeiling || is_lamp(catalog, target) ? 2 : 0;
    case R::kOn: return suits_on(catalog, target, reference);
    case R::kIn: return may_carry(catalog, reference, target) ? 2 : 1;
    case R::kFacing: return suits_facing(target, reference);
    case R::kCenterOfRoom:
    case R::kInRegion: return mount == Mount::kSurface ? 1 : 2;
    case R::kAbove: return suits_above(catalog, target, reference);
    case R::kOpposite: return mount == Mount::kSurface ? 0 : 2;
    case R::kAround:
    case R::kSurround:  // "a tureen in the middle of the table, six bowls around it"; cushions are sat on
      if (is_textile(catalog, target)) return 2;
      return mount == Mount::kSurface && reference.kind == NounKind::kObject && mount_of(reference) == Mount::kFloor ? 0 : 2;
    default: return suits_beside(sense.type, target, reference);
  }
}

}  // namespace layoutbox::offline
