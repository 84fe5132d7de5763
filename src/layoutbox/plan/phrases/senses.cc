// Which relation a phrase means between these two.
#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/phrases/sense_chooser.h"
#include "layoutbox/plan/words/word_sets.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;

namespace {

unsigned kind_flags(const NounPhrase& reference) {
  switch (reference.kind) {
    case NounKind::kWall: return kWall;
    case NounKind::kDoor:
    case NounKind::kWindow: return kOpening;
    case NounKind::kRoom:
    case NounKind::kFloor:
    case NounKind::kCeiling:
    case NounKind::kCenter:
    case NounKind::kCorner: return kRoom;
    default: return kObject;
  }
}

bool allowed(const PhraseSense& sense, const NounPhrase& reference) {
  const RelationRow& row = relation_row(sense.type);
  switch (sense.type) {
    case R::kInRegion: return reference.kind == NounKind::kRoom;
    case R::kCenterOfRoom: return reference.kind == NounKind::kRoom || reference.kind == NounKind::kAbstract;  // "… of the bay"
    case R::kOnCeiling: return reference.kind == NounKind::kCeiling;
    case R::kUnderWindow: return reference.kind == NounKind::kWindow;
    case R::kUnder:
      if (reference.kind == NounKind::kDoor) return false;
      return (row.reference_kinds & kind_flags(reference)) != 0;
    case R::kOn:
      if (reference.kind == NounKind::kAbstract && sense.part.has(PartWord::kCenter)) return false;
      return (kind_flags(reference) & kObject) != 0 || reference.kind == NounKind::kFloor || reference.kind == NounKind::kWindow;
    case R::kCorner: return reference.kind == NounKind::kCorner || (reference.kind == NounKind::kRoom && sense.of_room);
    default:
      if (reference.kind == NounKind::kAbstract || reference.kind == NounKind::kOutsideRoom) return false;
      return (row.reference_kinds & kind_flags(reference)) != 0;
  }
}

// A table with a head and a foot.
bool one_lies_on(const NounPhrase& noun) { return noun.entry != nullptr && noun.entry->is(Trait::kLieOn); }

bool cooks_on(const NounPhrase& noun) { return noun.entry != nullptr && (noun.entry->is(Trait::kFire) || noun.entry->is(Trait::kHob)); }

}  // namespace

SenseChooser::Choice SenseChooser::by_kind() const {
  if (reference_.niche) return chosen(own(R::kInRegion));  // in it, at its wall
  switch (reference_.kind) {
    case NounKind::kCorner: return at_corner();
    case NounKind::kCenter: return chosen(at_center());
    case NounKind::kCeiling: {
      // "bookcases rise to the ceiling": how high they are
      const bool stands =
          !says(R::kOn) && target_.entry != nullptr && target_.exact && target_.entry->back_to_wall && mount_of(target_) == Mount::kFloor;
      return chosen(!stands && says_any({R::kOnCeiling, R::kOn}) ? std::optional(own(R::kOnCeiling)) : std::nullopt);
    }
    case NounKind::kFloor:
      if (says(R::kCenterOfRoom)) return chosen(own(R::kCenterOfRoom));
      return chosen(says(&RelationTraits::rests) ? std::optional(own(R::kOn)) : std::nullopt);
    case NounKind::kPart: return if_any(at_part());
    case NounKind::kWall: return if_any(at_wall());
    default: return {};
  }
}

// "a vase enlivens the sideboard", "a rug softens the desk": a verb that says only that the two are together.
std::optional<PhraseSense> SenseChooser::by_any_verb() const {
  const Mount mount = mount_of(target_);
  if (reference_.kind == NounKind::kWall) return own(mount == Mount::kFloor || mount == Mount::kSurface ? R::kAgainstWall : R::kOnWall);
  if (reference_.kind == NounKind::kCorner) return own(R::kCorner);
  if (reference_.kind == NounKind::kWindow || reference_.kind == NounKind::kDoor) return own(R::kNextTo);
  if (reference_.kind == NounKind::kPart) {
    if (const auto part = at_part()) return part;
    return own(mount == Mount::kSurface ? R::kOn : R::kNextTo);
  }
  if (reference_.kind != NounKind::kObject) return std::nullopt;
  const bool thin = target_.entry != nullptr && target_.entry->thin && mount == Mount::kFloor;
  if (thin && mount_of(reference_) == Mount::kFloor) return own(R::kUnder);
  if (mount == Mount::kCeiling || (mount == Mount::kWall && mount_of(reference_) == Mount::kFloor)) return own(R::kAbove);
  if ((mount == Mount::kSurface || is_textile(catalog_, target_)) && may_carry(catalog_, reference_, target_)) return own(R::kOn);
  return own(R::kNextTo);
}

// The left of a window or a door is that of whoever looks at it from the room; behind it is no room. A seat "on the opposite side" of a
// table or "along one side" sits at it.
std::optional<PhraseSense> SenseChooser::at_opening_or_table() const {
  const bool opening = is_opening(reference_);
  for (const R side : {R::kLeftOf, R::kRightOf}) {
    if (opening && says(side)) return own(side);
  }
  if (opening && says(R::kBehind)) return own(R::kNextTo);
  if (opening && says(R::kIn) && !says(R::kOn) && mount_of(target_) == Mount::kFloor && direction_ == PhraseSense::Direction::kDirect)
    return own(R::kNextTo);
  // "a basketball hoop on the door", "a wreath on the door": what hangs, beside it
  const bool hangs = mount_of(target_) == Mount::kWall || mount_of(target_) == Mount::kHung;
  if (reference_.kind == NounKind::kDoor && hangs && says(R::kOn)) return own(R::kNextTo);
  const bool turned = opening && says(R::kAgainstWall) && !says_any({R::kUnderWindow, R::kNear, R::kNextTo});  // "its back to the window"
  const bool has_back = mount_of(target_) != Mount::kSurface;  // "a desk with a phone and an ashtray, its back to the window": the desk's
  if (turned && has_back && direction_ == PhraseSense::Direction::kDirect) return own(R::kNear);
  const bool at_table = reference_.kind == NounKind::kObject && is_seat(catalog_, target_) && is_table(catalog_, reference_);
  const bool along_it = says(R::kAlongSide) || (says(R::kOpposite) && says(R::kEachSideOf));
  if (!at_table || !along_it || (target_.is_plural() && says(R::kEachSideOf) && !says(R::kOpposite))) return std::nullopt;
  const auto along = std::find_if(senses_.begin(), senses_.end(), [](const PhraseSense& s) { return s.type == R::kAlongSide; });
  PhraseSense sense = along != senses_.end() ? *along : own(R::kAlongSide);
  sense.direction = direction_;
  if (!sense.side) sense.side = Side::kLong;
  return sense;
}

std::optional<PhraseSense> SenseChooser::first_that_fits() const {
  for (const PhraseSense& sense : senses_) {
    if (sense.direction != direction_ || !allowed(sense, reference_)) continue;
    if (sense.type == R::kTuckedUnder && !is_seat(catalog_, target_)) continue;
    if (sense.type == R::kOn && says(R::kNextTo) && stands_beside(sense)) continue;
    if (sense.type == R::kOnWall && says(R::kOnCeiling) && is_heavy(catalog_, target_)) return own(R::kAgainstWall);  // "from the wall"
    if (contradicts_kinds(sense)) continue;
    if (sense.type == R::kUnder && reference_.kind == NounKind::kWindow) return own(R::kUnderWindow);  // "a window and a bed under it"
    if (at_end_of_seat(sense)) return own(R::kNextTo);
    if (sense.type == R::kAbove && lies_over()) return own(R::kOn);
    return sense;
  }
  return std::nullopt;
}

// "a stool fixed to the table", "a high chair at the corner of the table", "a bin at the edge of the desk": not on it.
bool SenseChooser::stands_beside(const PhraseSense& on) const {
  if (is_seat(catalog_, target_) && is_table(catalog_, reference_)) return true;
  const bool thin = reference_.entry != nullptr && reference_.entry->thin;
  return !on.part.empty() && reference_.kind == NounKind::kObject && !thin && target_.exact && mount_of(target_) == Mount::kFloor;
}

// "a chest at one end of the sofa": beside it; only what one lies on has a head and a foot.
bool SenseChooser::at_end_of_seat(const PhraseSense& sense) const {
  return (sense.type == R::kAtFootOf || sense.type == R::kAtHeadOf) && says(R::kAlongSide) && reference_.kind == NounKind::kObject &&
         reference_.exact && is_seat(catalog_, reference_) && !one_lies_on(reference_);
}

// "books spill over the table", "a kettle over the hearth", "a reagent shelf over the bench": what does not hang is on it.
bool SenseChooser::lies_over() const {
  if (mount_of(target_) != Mount::kSurface || reference_.kind != NounKind::kObject || is_lamp(catalog_, target_)) return false;
  const bool rack = target_.entry != nullptr && target_.entry->is(Trait::kShelving);    // over a stove it hangs
  const bool cooks = !rack && cooks_on(reference_) && !reference_.entry->back_to_wall;  // "a TV above the fireplace" hangs
  const auto is_usual = [&](const std::string& kind) { return reference_.entry != nullptr && catalog_.is_a(reference_.entry->id, kind); };
  const bool shelf = rack && !cooks_on(reference_) && std::ranges::any_of(target_.entry->stands_on, is_usual);
  return (cooks || shelf || one_of(target_.head, WordSet::kLaidThings)) && may_carry(catalog_, reference_, target_);
}

// A lamp is over the table, a cloth on it; "at the end of the table" and "at the end of the bed" are two things.
bool SenseChooser::contradicts_kinds(const PhraseSense& sense) const {
  const bool at_end = sense.type == R::kAtFootOf || sense.type == R::kAtHeadOf;
  if (sense.type == R::kAlongSide && says_any({R::kAtFootOf, R::kAtHeadOf}) && one_lies_on(reference_)) return true;
  if (at_end && is_table(catalog_, reference_) && !one_lies_on(reference_)) return true;
  return sense.type == R::kOn && !sense.part.empty() && mount_of(target_) != Mount::kSurface && reference_.kind == NounKind::kObject &&
         target_.entry != nullptr && target_.entry->thin && !(is_table(catalog_, reference_) && target_.head == "mat");
}

std::optional<PhraseSense> choose_sense(const Catalog& catalog, const PhraseSenses& senses, PhraseSense::Direction direction,
                                        const NounPhrase& target, const NounPhrase& reference) {
  return SenseChooser(catalog, senses, direction, target, reference).run();
}

}  // namespace layoutbox::offline
