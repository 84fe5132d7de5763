// Which relation a phrase means between these two, and how well it suits them.
#include <algorithm>

#include "layoutbox/plan/offline/knowledge.h"

namespace layoutbox::offline {
namespace {

using R = RelationType;

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
    case R::kCenterOfRoom: return reference.kind == NounKind::kRoom;
    case R::kOnCeiling: return reference.kind == NounKind::kCeiling;
    case R::kUnderWindow: return reference.kind == NounKind::kWindow;
    case R::kOn: return (kind_flags(reference) & kObject) != 0 || reference.kind == NounKind::kFloor || reference.kind == NounKind::kWindow;
    case R::kCorner: return reference.kind == NounKind::kCorner || (reference.kind == NounKind::kRoom && sense.region == "corner");
    default:
      if (reference.kind == NounKind::kAbstract || reference.kind == NounKind::kOutsideRoom) return false;
      return (row.reference_kinds & kind_flags(reference)) != 0;
  }
}

// A table with a head and a foot.
bool one_lies_on(const NounPhrase& noun) {
  return noun.entry != nullptr && one_of(noun.entry->id, {"exam_table", "massage_table", "operating_table"});
}

}  // namespace

// NOLINTNEXTLINE(readability-function-cognitive-complexity): to be parted
std::optional<PhraseSense> choose_sense(const Catalog& catalog, const PhraseSenses& senses, PhraseSense::Direction direction,
                                        const NounPhrase& target, const NounPhrase& reference) {
  (void)catalog;
  const auto own = [&](R type) { return PhraseSense{type, direction, {}, {}, {}}; };
  const auto says = [&](R type) {
    return std::any_of(senses.begin(), senses.end(), [&](const PhraseSense& s) { return s.type == type && s.direction == direction; });
  };
  const bool placing = says(R::kOn) || says(R::kIn) || says(R::kNextTo) || says(R::kNear) || says(R::kAgainstWall) || says(R::kOnCeiling) ||
                       says(R::kCorner) || says(R::kCenterOfRoom) || says(R::kFacing) || says(R::kTuckedUnder) || says(R::kAbove);
  if (direction == PhraseSense::Direction::kDirect) {
    if (reference.niche) return own(R::kInRegion);  // in it, at its wall
    if (reference.kind == NounKind::kCorner && placing) {
      if (reference.of && reference.of->kind == NounKind::kObject) {
        PhraseSense sense = own(R::kOn);
        sense.part = reference.wall_word.empty() ? "corner" : reference.wall_word + " corner";
        return sense;
      }
      return own(R::kCorner);
    }
    if (reference.kind == NounKind::kCenter) {
      if (reference.of && (reference.of->kind == NounKind::kObject || reference.of->kind == NounKind::kPronoun)) {
        PhraseSense sense = own(R::kOn);
        sense.part = "center";
        return sense;
      }
      if (reference.of && reference.of->kind == NounKind::kWall) return own(R::kCenteredOnWall);
      if (says(R::kOn) || says(R::kIn) || says(R::kNextTo) || says(R::kNear) || says(R::kCenterOfRoom) || says(R::kAgainstWall))
        return own(R::kCenterOfRoom);
      return std::nullopt;
    }
    if (reference.kind == NounKind::kCeiling) {
      if (says(R::kOnCeiling) || says(R::kOn)) return own(R::kOnCeiling);
      return std::nullopt;
    }
    if (reference.kind == NounKind::kFloor) {
      if (says(R::kCenterOfRoom)) return own(R::kCenterOfRoom);
      if (says(R::kOn) || says(R::kIn)) return own(R::kOn);
      return std::nullopt;
    }
    if (reference.kind == NounKind::kPart) {
      // "at the left end of the counter": on it what stands on such things, beside it the rest.
      if (reference.head == "end" && (reference.wall_word == "left" || reference.wall_word == "right")) {
        const bool left = reference.wall_word == "left";
        if (mount_of(target) != Mount::kSurface && !says(R::kOn)) return own(left ? R::kLeftOf : R::kRightOf);
        PhraseSense sense = own(R::kOn);
        sense.part = reference.wall_word;
        return sense;
      }
      if (reference.head == "foot" || reference.head == "end" || (reference.head == "bottom" && !says(R::kOn))) return own(R::kAtFootOf);
      if (reference.head == "headboard" && says(R::kAbove)) return own(R::kAbove);
      if (reference.head == "head" || reference.head == "headboard") return own(R::kAtHeadOf);
      if (reference.head == "side" || reference.head == "edge") {
        const auto has_word = [&](std::string_view word) {
          return std::any_of(reference.attributes.begin(), reference.attributes.end(),
                             [&](const std::string& a) { return a == word || a == std::string(word) + "er"; });
        };
        if (has_word("long") || has_word("short")) {
          PhraseSense sense = own(R::kAlongSide);
          sense.side = has_word("long") ? Side::kLong : Side::kShort;
          return sense;
        }
        if (reference.wall_word == "left") return own(R::kLeftOf);
        if (reference.wall_word == "right") return own(R::kRightOf);
        if (reference.is_plural()) return own(R::kEachSideOf);
      }
      if (reference.head == "top" || reference.head == "surface" || reference.head == "tabletop" || reference.head == "lid") {
        if (says(R::kOn) || says(R::kIn) || says(R::kCenterOfRoom)) return own(R::kOn);
      }
    }
    if (reference.kind == NounKind::kWall) {
      const Mount mount = mount_of(target);
      if (says(R::kOnWall) && says(R::kAgainstWall) && !says(R::kCenteredOnWall))
        return own(mount == Mount::kFloor || mount == Mount::kSurface ? R::kAgainstWall : R::kOnWall);
      if (says(R::kOn) && says(R::kOnWall) && !says(R::kCenteredOnWall) && one_of(target.head, {"shelf", "rack", "hook"}))
        return own(R::kOnWall);
      if (says(R::kInFrontOf) || (says(R::kOn) && says(R::kOnWall) && !says(R::kCenteredOnWall) && is_heavy(catalog, target)))
        return own(R::kAgainstWall);
    }
  }
  const Mount mount = mount_of(target);
  const bool opening = reference.kind == NounKind::kDoor || reference.kind == NounKind::kWindow;
  // A door has no left of its own: beside it. A seat "on the opposite side" of a table or "along one side" sits at it.
  if (opening && (says(R::kLeftOf) || says(R::kRightOf) || says(R::kBehind))) return own(R::kNextTo);
  if (opening && says(R::kIn) && !says(R::kOn) && mount == Mount::kFloor && direction == PhraseSense::Direction::kDirect)
    return own(R::kNextTo);
  const bool at_table = reference.kind == NounKind::kObject && is_seat(catalog, target) && is_table(catalog, reference);
  if (at_table && (says(R::kAlongSide) || (says(R::kOpposite) && says(R::kEachSideOf))) &&
      !(target.is_plural() && says(R::kEachSideOf) && !says(R::kOpposite))) {
    const auto along = std::find_if(senses.begin(), senses.end(), [](const PhraseSense& s) { return s.type == R::kAlongSide; });
    PhraseSense sense = along != senses.end() ? *along : own(R::kAlongSide);
    sense.direction = direction;
    if (!sense.side) sense.side = Side::kLong;
    return sense;
  }
  for (const PhraseSense& sense : senses) {
    if (sense.direction != direction || !allowed(sense, reference)) continue;
    if (sense.type == R::kTuckedUnder && !is_seat(catalog, target)) continue;
    if (sense.type == R::kOnWall && says(R::kOnCeiling) && is_heavy(catalog, target)) return own(R::kAgainstWall);  // "from the wall"
    // A lamp is over the table, a cloth on it; "at the end of the table" and "at the end of the bed" are two things.
    if (sense.type == R::kAlongSide && reference.kind == NounKind::kObject && !says(R::kAlongSide)) continue;
    if (sense.type == R::kAlongSide && (says(R::kAtFootOf) || says(R::kAtHeadOf)) && one_lies_on(reference)) continue;
    if ((sense.type == R::kAtFootOf || sense.type == R::kAtHeadOf) && is_table(catalog, reference) && !one_lies_on(reference)) continue;
    if (sense.type == R::kOn && !sense.part.empty() && mount != Mount::kSurface && reference.kind == NounKind::kObject &&
        target.entry != nullptr && target.entry->thin && !(is_table(catalog, reference) && target.head == "mat"))
      continue;
    return sense;
  }
  return std::nullopt;
}

// NOLINTNEXTLINE(readability-function-cognitive-complexity): to be parted
int suits(const Catalog& catalog, const PhraseSense& sense, const NounPhrase& target, const NounPhrase& reference) {
  const Mount mount = mount_of(target);
  const bool known = target.entry != nullptr;
  switch (sense.type) {
    case R::kAgainstWall:
    case R::kCenteredOnWall:
    case R::kSideAgainstWall: return mount == Mount::kFloor ? 2 : mount == Mount::kSurface || mount == Mount::kWall ? 1 : 0;
    case R::kCorner: return mount == Mount::kFloor ? 2 : 1;
    case R::kOnWall:
      return mount == Mount::kWall ? 2
             : mount == Mount::kFloor && known &&
                     (is_table(catalog, target) || is_seat(catalog, target) || target.entry->thin ||
                      one_of(target.head, {"bed", "sofa", "couch", "dresser", "wardrobe"}))
                 ? 0
                 : 1;
    case R::kOnCeiling: return mount == Mount::kCeiling || is_lamp(catalog, target) ? 2 : 0;
    case R::kOn:
      if (reference.kind == NounKind::kFloor) return mount == Mount::kFloor ? 2 : 1;
      return reference.kind == NounKind::kObject && may_carry(catalog, reference, target) ? 2 : mount == Mount::kSurface ? 1 : 0;
    case R::kIn: return may_carry(catalog, reference, target) ? 2 : 1;
    case R::kFacing: return known && !target.entry->has_front ? 1 : 2;
    case R::kCenterOfRoom:
    case R::kInRegion: return mount == Mount::kSurface ? 1 : 2;
    case R::kAbove:
      if (mount == Mount::kWall || mount == Mount::kCeiling || is_lamp(catalog, target)) return 2;
      if (one_of(target.head, {"tv", "television", "screen", "monitor", "speaker"})) return 1;  // may hang
      return mount == Mount::kSurface ? 0 : 1;
    default:
      return mount == Mount::kSurface && stands_beside(sense.type) && reference.kind == NounKind::kObject &&
                     mount_of(reference) == Mount::kFloor
                 ? 1
             : mount == Mount::kSurface &&
                     (reference.kind == NounKind::kWindow || reference.kind == NounKind::kDoor || reference.kind == NounKind::kWall)
                 ? 1
                 : 2;
  }
}

}  // namespace layoutbox::offline
