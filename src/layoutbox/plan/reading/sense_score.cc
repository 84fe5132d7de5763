#include "layoutbox/plan/reading/sense_score.h"

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/weights.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

double SenseScore::of_place(const PhraseSenses& senses, const NounPhrase& target, const NounPhrase& reference) const {
  const auto sense = choose_sense(catalog_, senses, PhraseSense::Direction::kDirect, target, reference);
  if (!sense) return weight::kNoSense;
  const int suited = suits(catalog_, *sense, target, reference);
  double score = suited == 0 ? weight::kUnlikely : suited == 2 ? weight::kUsual : 0;
  if (!may_refer(catalog_, senses, target, reference))
    score += stands_beside(sense->type) && mount_of(reference) != Mount::kCeiling ? weight::kNotBeside : weight::kNoReference;
  if (sense->type == RelationType::kOn) score += on_top(target, reference);
  if (reference.entry != nullptr && reference.entry->is(Trait::kPet)) score += weight::kByAnimal;
  if (stands_beside(sense->type) && is_seat(catalog_, target) && one_sits_at(catalog_, reference)) score += weight::kSeatByTable;
  if (sense->type == RelationType::kOpposite) score += opposite(target, reference);
  if (sense->type == RelationType::kFacing && suited < 2) score += weight::kNoFront;
  if (sense->type == RelationType::kAlongSide && reference.kind == NounKind::kObject && !is_table(catalog_, reference))
    score += weight::kNoReference;
  // "on the wall" is where things hang.
  if (reference.kind == NounKind::kWall && says(senses, RelationType::kOn) && says(senses, RelationType::kOnWall))
    score += mount_of(target) == Mount::kWall ? weight::kHangsThere : mount_of(target) == Mount::kFloor ? -weight::kHangsThere : 0;
  // Small things that stand together.
  if (stands_beside(sense->type) && mount_of(target) == Mount::kSurface && reference.kind == NounKind::kObject &&
      mount_of(reference) == Mount::kSurface)
    score += weight::kSmallTogether;
  const bool vessel = reference.entry != nullptr && reference.entry->is(Trait::kVessel);
  if (sense->type == RelationType::kIn && (vessel || is_storage(reference))) score += weight::kInStorage;
  if (sense->type == RelationType::kInFrontOf) score += before_each_seat(target, reference, score);
  score += at_end(sense->type, reference);
  if (sense->type == RelationType::kAbove && reference.kind == NounKind::kObject) score += over(target, reference);
  if ((sense->type == RelationType::kEachSideOf || sense->type == RelationType::kNextTo) && stands_by(catalog_, target, reference))
    score += weight::kStandsBy;
  return score;
}

// "a bench at the foot of the bed, a dresser opposite", "a bed, a nightstand beside it, a wardrobe opposite": the bed.
double SenseScore::opposite(const NounPhrase& target, const NounPhrase& reference) const {
  if (reference.entry == nullptr || is_seat(catalog_, target)) return 0;
  const bool by_another = !reference.entry->beside.empty() && !is_seat(catalog_, reference) && !is_heavy(catalog_, reference);
  return reference.entry->is(Trait::kStandsBefore) || by_another ? weight::kNotBeside : 0;
}

// "arranged with a glass in front of each chair": what lies on the table, not the table. `so_far`: what speaks against small things there.
double SenseScore::before_each_seat(const NounPhrase& target, const NounPhrase& reference, double so_far) const {
  if (!is_seat(catalog_, reference) || reference.determiner != Determiner::kEach) return 0;
  if (mount_of(target) == Mount::kSurface) return weight::kStandsBy - std::min(so_far, 0.0);
  const bool table = is_table(catalog_, target) && mount_of(target) == Mount::kFloor && !target.is_plural();
  return table ? weight::kUnlikely : 0;
}

// What lies on what.
double SenseScore::on_top(const NounPhrase& target, const NounPhrase& reference) const {
  double score = 0;
  constexpr double kFlatSeat = 0.3;  // a stool by the tub is as good as a table
  const bool chair = is_chair(reference) && !is_textile(catalog_, target);
  if (small_host(reference) || chair) score += weight::kSmallHost * (chair && one_of(reference.head, WordSet::kStools) ? kFlatSeat : 1);
  if (on_soft(reference, target)) score += weight::kSoftHost;
  if (one_of(reference.head, WordSet::kSmallVessels)) score += weight::kSmallHost;  // in it, not on it
  if (has_hooks(reference) && is_textile(catalog_, target)) score += weight::kHungOnHook;
  return score;
}

// "… at the foot": of the bed rather than of what stands beside it; no chair has a head.
double SenseScore::at_end(RelationType type, const NounPhrase& reference) const {
  if (type == RelationType::kAtHeadOf && is_seat(catalog_, reference)) return weight::kNoReference;
  if (type != RelationType::kAtFootOf && type != RelationType::kAtHeadOf) return 0;
  const bool bed = reference.entry != nullptr && reference.entry->is(Trait::kBed);
  const bool lain_on = bed || (reference.entry != nullptr && is_table(catalog_, reference));
  double score = 0;
  if (type == RelationType::kAtFootOf && reference.entry != nullptr && !bed && !is_seat(catalog_, reference)) score += weight::kNotBeside;
  if (reference.kind == NounKind::kObject && !lain_on && mount_of(reference) == Mount::kFloor) score += weight::kNotBeside;
  return score;
}

double SenseScore::over(const NounPhrase& target, const NounPhrase& reference) const {
  double score = 0;
  if (is_table(catalog_, reference) && mount_of(target) == Mount::kCeiling) score += weight::kLampOverTable;
  if (is_chair(reference)) score += weight::kOverSeat;
  // Nobody watches what hangs over the head.
  const bool watched = target.entry != nullptr && target.entry->is(Trait::kScreen) && is_seat(catalog_, reference);
  if (watched) score += weight::kUnlikely;
  // What hangs on the wall is over what is as wide, seldom over a box or a bin.
  const bool narrow = reference.entry != nullptr && mount_of(reference) == Mount::kFloor && !reference.entry->back_to_wall &&
                      !is_heavy(catalog_, reference) && reference.entry->size.usual.width <= 600;
  const bool small = mount_of(reference) == Mount::kSurface;  // "a vase on it, a painting above": over what carries the vase
  const bool in_room = reference.entry != nullptr && reference.entry->is(Trait::kTable) && !reference.entry->back_to_wall &&
                       reference.entry->used_sides.size() > 1;  // "a sideboard with a mirror above, a rug under the table"
  if (mount_of(target) == Mount::kWall && (narrow || small || in_room)) score += weight::kOverSeat;
  if (mount_of(target) != Mount::kWall && small) score += weight::kNotBeside;  // "a lantern swings above": over the table that carries it
  // Seats and tables stand under things, not over them.
  const bool chest = one_of(target.head, WordSet::kNeverAbove);
  if (is_seat(catalog_, target) || chest || (is_table(catalog_, target) && mount_of(target) == Mount::kFloor)) score += weight::kUnlikely;
  return score;
}

// What one draws up to a table.
bool SenseScore::is_chair(const NounPhrase& noun) const { return is_seat(catalog_, noun) && one_of(noun.head, {"chair", "stool"}); }

bool SenseScore::on_soft(const NounPhrase& host, const NounPhrase& thing) const {
  const bool easy = host.entry != nullptr && host.entry->is(Trait::kEasySeat);
  const bool soft = one_of(host.head, WordSet::kLainOn) || easy || (is_seat(catalog_, host) && !one_of(host.head, WordSet::kHardSeats));
  return soft && thing.kind == NounKind::kObject && !is_textile(catalog_, thing);
}

bool SenseScore::small_host(const NounPhrase& host) const {
  if (one_of(host.head, WordSet::kCarriesNothing)) return true;
  const bool carries = one_of(host.head, WordSet::kSmallHosts);
  return host.kind == NounKind::kObject && host.entry != nullptr && mount_of(host) == Mount::kSurface && !is_storage(host) && !carries;
}

double SenseScore::of_part(const NounPhrase& part, const NounPhrase& owner) const {
  if (owner.kind != NounKind::kObject) return 0;
  const std::string& head = part.head;
  const bool desk = one_of(owner.head, WordSet::kDesks), counter = one_of(owner.head, WordSet::kCounters);
  if (head == "tabletop")
    return is_table(catalog_, owner) && !desk && !counter ? weight::kOwnPart : is_table(catalog_, owner) ? 0.5 : weight::kNotItsPart;
  if (head == "desktop" || head == "worktop") return desk ? weight::kOwnPart : is_table(catalog_, owner) ? 0.5 : weight::kNotItsPart;
  if (head == "countertop") return counter ? 2 * weight::kOwnPart : is_table(catalog_, owner) ? 0.5 : weight::kNotItsPart;
  if (one_of(head, {"top", "surface", "half", "third", "quarter"})) {
    const bool flat = owner.entry != nullptr && owner.entry->top_carries && mount_of(owner) == Mount::kFloor && !owner.entry->thin;
    return flat ? 0.8 : weight::kNotItsPart / 2;
  }
  // "at its right end": of a bench, not of a pot on it.
  if (head == "end") {
    constexpr Mm kLong = 800;
    const bool is_long = owner.entry == nullptr || std::max(owner.entry->size.usual.width, owner.entry->size.usual.depth) >= kLong;
    return is_long ? 0.5 : weight::kNotItsPart;
  }
  if (one_of(head, {"cushion", "armrest", "backrest"})) return is_seat(catalog_, owner) ? weight::kOwnPart : weight::kNotItsPart;
  if (one_of(head, {"headboard", "pillow", "mattress"}))
    return one_of(owner.head, {"bed", "daybed", "crib"}) ? weight::kOwnPart : weight::kNotItsPart;
  return 0;
}

bool SenseScore::carries(const NounPhrase& host, const NounPhrase& thing) const { return may_carry(catalog_, host, thing); }

double SenseScore::of_having(const NounPhrase& host, const NounPhrase& thing, bool holds) const {
  // "under the window with a chair in front of it": not the window's
  const bool opening = host.kind == NounKind::kWindow || host.kind == NounKind::kDoor;
  if (opening && thing.kind == NounKind::kObject && mount_of(thing) == Mount::kFloor) return weight::kUnlikely;
  if (host.kind != NounKind::kObject || thing.kind != NounKind::kObject) return 0;
  // "a loveseat with two chairs, a table, ceiling fan, lots of ferns": the room's
  if (mount_of(thing) == Mount::kCeiling && is_seat(catalog_, host)) return weight::kUnlikely;
  if (may_carry(catalog_, host, thing) && on_soft(host, thing)) return weight::kSoftHost;  // "armchairs …, and ferns by the window"
  if (may_carry(catalog_, host, thing) && small_host(host)) return weight::kUsual + weight::kSmallHost;
  if (may_carry(catalog_, host, thing)) return host.entry != nullptr && host.entry->thin ? -0.5 : weight::kUsual;
  if (one_sits_at(catalog_, host) && is_seat(catalog_, thing)) return weight::kUsual;
  if (holds) return is_heavy(catalog_, thing) ? weight::kUnlikely : -1;
  if (mount_of(host) == Mount::kSurface && mount_of(thing) == Mount::kFloor) return weight::kUnlikely;
  return 0;
}

}  // namespace layoutbox::offline
