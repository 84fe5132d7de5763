// Which relation a phrase means between these two, and how well it suits them.
#include <algorithm>

#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
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

// The sense that a phrase has between these two.
class SenseChooser {
 public:
  SenseChooser(const Catalog& catalog, const PhraseSenses& senses, PhraseSense::Direction direction, const NounPhrase& target,
               const NounPhrase& reference)
      : catalog_(catalog), senses_(senses), direction_(direction), target_(target), reference_(reference) {}

  std::optional<PhraseSense> run() const {
    if (says(R::kOn) && says(R::kAbove) && says(R::kUnder) && says(R::kNextTo)) return by_any_verb();
    if (direction_ == PhraseSense::Direction::kDirect) {
      if (const auto place = by_kind(); place.chosen) return place.sense;
    }
    if (const auto sense = at_opening_or_table()) return sense;
    return first_that_fits();
  }

 private:
  // What the reference's kind says; not chosen: it says nothing, and the phrase decides.
  struct Choice {
    bool chosen = false;
    std::optional<PhraseSense> sense;
  };
  static Choice chosen(std::optional<PhraseSense> sense) { return {true, std::move(sense)}; }
  static Choice if_any(std::optional<PhraseSense> sense) { return {sense.has_value(), std::move(sense)}; }

  PhraseSense own(R type) const { return {type, direction_, {}, {}, {}}; }
  PhraseSense on_part(ThingPart part) const {
    PhraseSense sense = own(R::kOn);
    sense.part = std::move(part);
    return sense;
  }
  bool says(R type) const {
    return std::any_of(senses_.begin(), senses_.end(), [&](const PhraseSense& s) { return s.type == type && s.direction == direction_; });
  }
  bool says(bool RelationTraits::*so) const {
    return std::any_of(senses_.begin(), senses_.end(),
                       [&](const PhraseSense& s) { return traits_of(s.type).*so && s.direction == direction_; });
  }
  bool says_at() const { return says_any({R::kNextTo, R::kAlongSide}) && !says(R::kNear); }
  bool says_any(std::initializer_list<R> types) const {
    return std::any_of(types.begin(), types.end(), [&](R type) { return says(type); });
  }

  Choice by_kind() const {
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
  std::optional<PhraseSense> by_any_verb() const {
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

  Choice at_corner() const {
    if (!says_any({R::kOn, R::kIn, R::kNextTo, R::kNear, R::kAgainstWall, R::kOnCeiling, R::kCorner, R::kCenterOfRoom, R::kFacing,
                   R::kTuckedUnder, R::kAbove, R::kDistance}))
      return {};
    if (reference_.of && reference_.of->kind == NounKind::kObject) {
      const std::string which = reference_.wall_word.empty() ? std::string{} : reference_.wall_word + " ";
      return chosen(on_part(ThingPart(which + "corner")));
    }
    return chosen(own(R::kCorner));
  }

  std::optional<PhraseSense> at_center() const {
    const auto of = [&](NounKind kind) { return reference_.of && reference_.of->kind == kind; };
    const bool thing = of(NounKind::kObject) || of(NounKind::kPronoun) || of(NounKind::kPart);
    if (thing && says(R::kAbove)) return own(R::kAbove);  // "hangs above the center of the table"
    if (thing) return on_part(PartWord::kCenter);
    if (reference_.of && reference_.of->kind == NounKind::kWall) return own(R::kCenteredOnWall);
    if (says_any({R::kOn, R::kIn, R::kNextTo, R::kNear, R::kCenterOfRoom, R::kAgainstWall})) return own(R::kCenterOfRoom);
    return std::nullopt;
  }

  // "in the long part" of an L
  bool is_leg_of_room() const {
    const auto tells = [](const std::string& word) { return one_of(word, WordSet::kLongLegs) || one_of(word, WordSet::kShortLegs); };
    const bool of_thing = reference_.of && reference_.of->kind != NounKind::kRoom;
    return one_of(reference_.head, WordSet::kLegs) && !of_thing && says(R::kIn) && std::ranges::any_of(reference_.attributes, tells);
  }

  // "behind the sofa's right arm", "in front of the left end of the desk": behind or before it, at that end.
  std::optional<PhraseSense> at_end_of_length() const {
    const bool end = reference_.wall_word == "left" || reference_.wall_word == "right";
    if (!end || !reference_.of || reference_.of->kind != NounKind::kObject) return std::nullopt;
    for (const R type : {R::kBehind, R::kInFrontOf}) {
      if (!says(type)) continue;
      PhraseSense sense = own(type);
      sense.part = ThingPart(reference_.wall_word);
      return sense;
    }
    return std::nullopt;
  }

  std::optional<PhraseSense> at_part() const {
    if (const auto across = at_end_of_length()) return across;
    if (is_leg_of_room()) return own(R::kInRegion);
    const std::string& head = reference_.head;
    // "at the left end of the counter": on it what stands on such things, beside it the rest.
    if (head == "end" && (reference_.wall_word == "left" || reference_.wall_word == "right")) {
      const bool left = reference_.wall_word == "left";
      if (mount_of(target_) != Mount::kSurface && !says(R::kOn)) return own(left ? R::kLeftOf : R::kRightOf);
      return on_part(ThingPart(reference_.wall_word));
    }
    // "at the far end of the bench": on it, or by it.
    // "on the left half of the tabletop", "takes up the right third"
    const bool share = one_of(head, WordSet::kShares);
    if (share && one_of(reference_.wall_word, {"left", "right", "front", "back"}) && mount_of(target_) == Mount::kSurface)
      return on_part(ThingPart(reference_.wall_word));
    const NounPhrase* whole = reference_.of && reference_.of->kind == NounKind::kObject ? reference_.of.get() : nullptr;
    const bool flat = whole != nullptr && whole->head != "bed" && may_carry(catalog_, *whole, target_);
    if (head == "end" && (!reference_.wall_word.empty() || flat) && mount_of(target_) == Mount::kSurface) return on_part(PartWord::kEnd);
    // "at the far end of the sofa": only what one lies on has a foot.
    if (head == "end" && whole != nullptr && (is_seat(catalog_, *whole) || is_storage(*whole))) return own(R::kNextTo);
    const bool of_room = reference_.of && reference_.of->kind == NounKind::kRoom;
    if (head == "end" && of_room) return at_end_of_room();
    if (head == "foot" || head == "end" || (head == "bottom" && !says(R::kOn))) return own(R::kAtFootOf);
    if (head == "headboard" && says(R::kAbove)) return own(R::kAbove);
    if (head == "head" || head == "headboard") return own(R::kAtHeadOf);
    if (head == "side" || head == "edge") return at_side();
    if (one_of(head, WordSet::kTops) && (says(&RelationTraits::rests) || says(R::kCenterOfRoom))) return own(R::kOn);
    return std::nullopt;
  }

  // "One end of the room is given over to a bar."
  PhraseSense at_end_of_room() const {
    PhraseSense sense = own(R::kInRegion);
    sense.region = RoomRegion::kBack;
    return sense;
  }

  std::optional<PhraseSense> at_side() const {
    const auto has_word = [&](std::string_view word) {
      return std::any_of(reference_.attributes.begin(), reference_.attributes.end(),
                         [&](const std::string& a) { return a == word || a == std::string(word) + "er"; });
    };
    if (has_word("long") || has_word("short")) {
      PhraseSense sense = own(R::kAlongSide);
      sense.side = has_word("long") ? Side::kLong : Side::kShort;
      return sense;
    }
    // "clamped to its right edge"; what lies on such things is at the edge of the top: "a plate at its edge".
    const NounPhrase* whole = reference_.of && reference_.of->kind == NounKind::kObject ? reference_.of.get() : nullptr;
    const bool top = whole != nullptr && (whole->entry == nullptr || !whole->entry->thin) && may_carry(catalog_, *whole, target_);
    const bool on_edge = reference_.head == "edge" && mount_of(target_) == Mount::kSurface && (says(R::kOn) || (top && says_at()));
    if (on_edge && one_of(reference_.wall_word, {"left", "right", "front", "back"})) return on_part(ThingPart(reference_.wall_word));
    if (on_edge && top && reference_.wall_word.empty()) return on_part(PartWord::kFront);
    if (reference_.wall_word == "left") return own(R::kLeftOf);
    if (reference_.wall_word == "right") return own(R::kRightOf);
    if (reference_.is_plural()) return own(R::kEachSideOf);
    // "on the bed's far side"
    if (!reference_.wall_word.empty() && mount_of(target_) != Mount::kSurface) return own(R::kNextTo);
    return std::nullopt;
  }

  std::optional<PhraseSense> at_wall() const {
    const Mount mount = mount_of(target_);
    const bool hung = says(R::kOnWall) && !says(R::kCenteredOnWall);
    if (hung && says(R::kAgainstWall)) return own(mount == Mount::kFloor || mount == Mount::kSurface ? R::kAgainstWall : R::kOnWall);
    const bool hooks = one_of(target_.head, {"shelf", "hook"}) || (target_.head == "rack" && !is_heavy(catalog_, target_));
    if (hung && says(R::kOn) && hooks) return own(R::kOnWall);
    // "three crates on the left wall": what stands on the floor is on that side, unless such things hang
    const bool stands = mount == Mount::kFloor && !reference_.wall_word.empty() &&
                        kind_at(catalog_, target_.category, KinPlace::kOnWall) == nullptr && !one_of(target_.head, WordSet::kMayHang);
    if (says(R::kInFrontOf) || (hung && says(R::kOn) && (stands || is_heavy(catalog_, target_)))) return own(R::kAgainstWall);
    return std::nullopt;
  }

  // The left of a window or a door is that of whoever looks at it from the room; behind it is no room. A seat "on the opposite side" of a
  // table or "along one side" sits at it.
  std::optional<PhraseSense> at_opening_or_table() const {
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

  std::optional<PhraseSense> first_that_fits() const {
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
  bool stands_beside(const PhraseSense& on) const {
    if (is_seat(catalog_, target_) && is_table(catalog_, reference_)) return true;
    const bool thin = reference_.entry != nullptr && reference_.entry->thin;
    return !on.part.empty() && reference_.kind == NounKind::kObject && !thin && target_.exact && mount_of(target_) == Mount::kFloor;
  }

  // "a chest at one end of the sofa": beside it; only what one lies on has a head and a foot.
  bool at_end_of_seat(const PhraseSense& sense) const {
    return (sense.type == R::kAtFootOf || sense.type == R::kAtHeadOf) && says(R::kAlongSide) && reference_.kind == NounKind::kObject &&
           reference_.exact && is_seat(catalog_, reference_) && !one_lies_on(reference_);
  }

  static bool cooks_on(const NounPhrase& noun) {
    return noun.entry != nullptr && (noun.entry->is(Trait::kFire) || noun.entry->is(Trait::kHob));
  }

  // "books spill over the table", "a kettle over the hearth", "a reagent shelf over the bench": what does not hang is on it.
  bool lies_over() const {
    if (mount_of(target_) != Mount::kSurface || reference_.kind != NounKind::kObject || is_lamp(catalog_, target_)) return false;
    const bool rack = target_.entry != nullptr && target_.entry->is(Trait::kShelving);    // over a stove it hangs
    const bool cooks = !rack && cooks_on(reference_) && !reference_.entry->back_to_wall;  // "a TV above the fireplace" hangs
    const auto is_usual = [&](const std::string& kind) { return reference_.entry != nullptr && catalog_.is_a(reference_.entry->id, kind); };
    const bool shelf = rack && !cooks_on(reference_) && std::ranges::any_of(target_.entry->stands_on, is_usual);
    return (cooks || shelf || one_of(target_.head, WordSet::kLaidThings)) && may_carry(catalog_, reference_, target_);
  }

  // A lamp is over the table, a cloth on it; "at the end of the table" and "at the end of the bed" are two things.
  bool contradicts_kinds(const PhraseSense& sense) const {
    const bool at_end = sense.type == R::kAtFootOf || sense.type == R::kAtHeadOf;
    if (sense.type == R::kAlongSide && says_any({R::kAtFootOf, R::kAtHeadOf}) && one_lies_on(reference_)) return true;
    if (at_end && is_table(catalog_, reference_) && !one_lies_on(reference_)) return true;
    return sense.type == R::kOn && !sense.part.empty() && mount_of(target_) != Mount::kSurface && reference_.kind == NounKind::kObject &&
           target_.entry != nullptr && target_.entry->thin && !(is_table(catalog_, reference_) && target_.head == "mat");
  }

  const Catalog& catalog_;
  const PhraseSenses& senses_;
  PhraseSense::Direction direction_;
  const NounPhrase &target_, &reference_;
};

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

}  // namespace

std::optional<PhraseSense> choose_sense(const Catalog& catalog, const PhraseSenses& senses, PhraseSense::Direction direction,
                                        const NounPhrase& target, const NounPhrase& reference) {
  return SenseChooser(catalog, senses, direction, target, reference).run();
}

namespace {

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
