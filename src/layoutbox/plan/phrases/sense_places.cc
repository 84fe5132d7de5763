// What a phrase means by a part of the room or of a thing: a corner, the middle, an end, a side, a wall.
#include <algorithm>

#include "layoutbox/catalog/kin.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/phrases/sense_chooser.h"
#include "layoutbox/plan/words/word_sets.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox::offline {

using R = RelationType;

SenseChooser::Choice SenseChooser::at_corner() const {
  if (!says_any({R::kOn, R::kIn, R::kNextTo, R::kNear, R::kAgainstWall, R::kOnCeiling, R::kCorner, R::kCenterOfRoom, R::kFacing,
                 R::kTuckedUnder, R::kAbove, R::kDistance}))
    return {};
  if (reference_.of && reference_.of->kind == NounKind::kObject) {
    const std::string which = reference_.wall_word.empty() ? std::string{} : reference_.wall_word + " ";
    return chosen(on_part(ThingPart(which + "corner")));
  }
  return chosen(own(R::kCorner));
}

std::optional<PhraseSense> SenseChooser::at_center() const {
  const auto of = [&](NounKind kind) { return reference_.of && reference_.of->kind == kind; };
  const bool thing = of(NounKind::kObject) || of(NounKind::kPronoun) || of(NounKind::kPart);
  if (thing && says(R::kAbove)) return own(R::kAbove);  // "hangs above the center of the table"
  if (thing) return on_part(PartWord::kCenter);
  if (reference_.of && reference_.of->kind == NounKind::kWall) return own(R::kCenteredOnWall);
  if (says_any({R::kOn, R::kIn, R::kNextTo, R::kNear, R::kCenterOfRoom, R::kAgainstWall})) return own(R::kCenterOfRoom);
  return std::nullopt;
}

// "in the long part" of an L
bool SenseChooser::is_leg_of_room() const {
  const auto tells = [](const std::string& word) { return one_of(word, WordSet::kLongLegs) || one_of(word, WordSet::kShortLegs); };
  const bool of_thing = reference_.of && reference_.of->kind != NounKind::kRoom;
  return one_of(reference_.head, WordSet::kLegs) && !of_thing && says(R::kIn) && std::ranges::any_of(reference_.attributes, tells);
}

// "behind the sofa's right arm", "in front of the left end of the desk": behind or before it, at that end.
std::optional<PhraseSense> SenseChooser::at_end_of_length() const {
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

std::optional<PhraseSense> SenseChooser::at_part() const {
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
PhraseSense SenseChooser::at_end_of_room() const {
  PhraseSense sense = own(R::kInRegion);
  sense.region = RoomRegion::kBack;
  return sense;
}

std::optional<PhraseSense> SenseChooser::at_side() const {
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

std::optional<PhraseSense> SenseChooser::at_wall() const {
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

}  // namespace layoutbox::offline
