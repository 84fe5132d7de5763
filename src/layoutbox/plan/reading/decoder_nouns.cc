// What a noun phrase is for: the one that a place waits for, the next of a list, the subject of a clause, or one of those before.
#include <algorithm>

#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/decoder.h"
#include "layoutbox/plan/reading/weights.h"

namespace layoutbox::offline {

bool is_another(const NounPhrase& noun) {
  const bool told =
      (noun.determiner == Determiner::kIndefinite || (noun.determiner == Determiner::kNone && noun.plural)) && !noun.attributes.empty();
  return (noun.determiner == Determiner::kAnother || told) && !noun.subset && noun.of == nullptr;
}

bool speaks_of_others(const NounPhrase& noun) {
  return noun.kind == NounKind::kPronoun || (noun.kind == NounKind::kMember && !is_another(noun));
}

namespace {

// A part whose thing is not said ("the left side", "its top").
bool needs_owner(const NounPhrase& noun) {
  if (noun.kind == NounKind::kObject || noun.kind == NounKind::kRoom) return false;
  const bool of_part = noun.of && noun.of->kind == NounKind::kPart && !noun.of->of;  // "the middle of the tabletop"
  if (noun.of) return noun.of->kind == NounKind::kPronoun || noun.of->kind == NounKind::kMember || of_part;
  if (noun.kind == NounKind::kPart) return true;
  return noun.determiner == Determiner::kPossessive && (noun.kind == NounKind::kCorner || noun.kind == NounKind::kCenter);
}

bool is_place_of_room(NounKind kind) {
  return kind == NounKind::kCorner || kind == NounKind::kWall || kind == NounKind::kWindow || kind == NounKind::kDoor ||
         kind == NounKind::kCenter || kind == NounKind::kRoom;
}

}  // namespace

// "its left end", and what has something: "the tabletop carries a tray".
bool Decoder::is_part_of_other(int u) const {
  const NounPhrase& noun = chunk(u).noun;
  if (noun.kind != NounKind::kPart || !needs_owner(noun)) return false;
  const bool carries = follows(u, UnitKind::kPlace) && !unit(u + 1).inverse.empty() && unit(u + 1).direct.empty();  // "supports"
  return noun.determiner == Determiner::kPossessive ||
         (noun.determiner == Determiner::kDefinite && (carries || follows(u, UnitKind::kHave)));
}

void Decoder::noun_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const bool joined = unit(u).joiner != Joiner::kNone;
  if (state.waiting >= 0 && !joined) {
    waited_actions(s, u);
    return;
  }
  const bool others = speaks_of_others(chunk(u).noun) || is_part_of_other(u);
  if (others) member_actions(s, u);
  // "between the bed and the window stands a desk"
  if (joined && state.frontier.empty() && !state.fronted.empty() && is(u - 1, UnitKind::kNoun) &&
      read_as(state, u - 1).predicate == state.fronted.back()) {
    const double gain = reference_list_score(state, u - 1, u);
    if (gain > -5) add(s, kSameList, gain, u - 1);
  }
  if (state.frontier.empty()) {
    double gain = others ? -8 : 0;
    for (const int place : state.fronted) gain += reference_score(state, place, u);
    add(s, kNewRoot, gain);
    return;
  }
  // "one holding a lamp and the other a stack of books": the verb is said once.
  // "… and the one to its right a stack of books"
  const bool placed_alone = is(u - 1, UnitKind::kPlace) && read_as(state, u - 1).alone && read_as(state, u - 1).subject >= 0;
  const int member = placed_alone ? read_as(state, u - 1).subject : u - 1;
  if (!joined && is(member, UnitKind::kNoun) && read_as(state, member).role == NounRole::kMember && is_new_thing(chunk(u).noun)) {
    for (int p = u; p-- > 0;) {
      const bool carries = is(p, UnitKind::kPlace) && read_as(state, p).inverse && !read_as(state, p).fronted;
      if (!carries && (!is(p, UnitKind::kHave) || read_as(state, p).of_room)) continue;
      add(s, kElided, 0.5, p, member);
      break;
    }
  }
  if (state.verb && !joined) {
    add(s, kNewRoot, others ? -8 : 0);  // "two lamps stand one on each side"
    return;
  }
  if (!others) list_actions(s, u);
}

void Decoder::waited_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const int p = state.waiting;
  const UnitReading& place = read_as(state, p);
  const NounPhrase& noun = chunk(u).noun;
  if (is(p, UnitKind::kHave) || place.inverse) {
    waited_content_actions(s, u);
    return;
  }
  if (noun.kind == NounKind::kPronoun && !noun.reciprocal && place.implied != kNobody) {  // "on which"
    add(s, kFill, 0, -1, -1, place.implied);
    return;
  }
  if (noun.reciprocal) {
    const bool many = several(state, place.subject) || (place.subject >= 0 && place.first_subject != place.subject);
    add(s, kFill, many ? 1 : -2);
    return;
  }
  if (speaks_of_others(noun) || needs_owner(noun)) {
    waited_member_actions(s, u);
    return;
  }
  // "on one corner", "in the middle": of what carries the thing.
  if ((noun.kind == NounKind::kCorner || noun.kind == NounKind::kCenter) && !noun.of && noun.wall_word.empty() && word(p) != "in") {
    for (const Candidate& meant : carriers(state, place.subject))
      add(s, kFill, meant.score + (word(p) == "on" ? weight::kPartOfCarrier : 0), -1, -1, meant.referent);
  }
  add(s, kFill, place.fronted ? 0 : reference_score(state, p, u));
}

// … as what something has.
void Decoder::waited_content_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const int p = state.waiting;
  const UnitReading& place = read_as(state, p);
  const NounPhrase& noun = chunk(u).noun;
  if (speaks_of_others(noun) && !noun.reciprocal) {
    for (const Candidate& meant : antecedents(state, place.subject, nullptr, &noun))
      add(s, kFill, meant.score, -1, -1, meant.referent, meant.list);
  }
  add(s, kFill, content_score(state, p, u) + (speaks_of_others(noun) ? -6 : 0));
}

// … as "it", "the other", "the left side".
void Decoder::waited_member_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const int p = state.waiting;
  const UnitReading& place = read_as(state, p);
  const NounPhrase& noun = chunk(u).noun;
  const bool part = noun.kind != NounKind::kPronoun && noun.kind != NounKind::kMember;
  NounPhrase whose = noun;
  if (part && word(u) == "its") whose.plural = false, whose.count = 0;  // "in its drawers": of one
  for (const Candidate& meant : antecedents(state, place.subject, part ? nullptr : &unit(p).direct, &whose, place.first_subject))
    add(s, kFill, meant.score + (part ? part_score(state, p, noun, meant.referent) : 0), -1, -1, meant.referent, meant.list);
  if (part) repeated_part_actions(s, u);
  // "two chairs face two on the other side", "a sofa opposite another": more of the kind.
  const bool count = noun.kind == NounKind::kMember && !noun.of && !noun.subset && noun.ordinal == 0 &&
                     (noun.determiner == Determiner::kNone || noun.determiner == Determiner::kAnother || noun.count > 1);
  const PhraseSenses& senses = unit(p).direct;
  if (count && place.subject >= 0 && is_thing(state, place.subject) &&
      (says(senses, RelationType::kFacing) || says(senses, RelationType::kOpposite) || says(senses, RelationType::kBehind) ||
       says(senses, RelationType::kInFrontOf)))
    add(s, kFill, weight::kMoreOfIt, -1, -1, place.subject);
  // "a wardrobe to the right of the door and a cabinet to the left of it"
  if (noun.head == "it") {
    if (const Referent host = side_host(state, p, unit(p).direct); host != kNobody && !same(state, host, place.subject))
      add(s, kFill, weight::kSameSide, -1, -1, host);
  }
  add(s, kFill, weight::kMeansNobody);
}

// How well that part ("its right end", "the middle of the tabletop") of the one that may be meant suits whom the place speaks of.
double Decoder::part_score(const State& state, int place, const NounPhrase& part, Referent meant) const {
  const NounPhrase& owner = noun_of(state, meant);
  const double own = sense_.of_part(part.of && part.of->kind == NounKind::kPart ? *part.of : part, owner);
  const Referent subject = read_as(state, place).subject;
  if (subject == kNobody || !is_thing(state, subject) || owner.kind != NounKind::kObject) return own;
  NounPhrase of_owner = part;
  of_owner.of = std::make_shared<NounPhrase>(owner);
  const bool small = mount_of(noun_of(state, subject)) == Mount::kSurface;
  const bool carried = small && mount_of(owner) == Mount::kFloor && sense_.carries(owner, noun_of(state, subject));
  return own + std::min(0.0, sense_.of_place(unit(place).direct, noun_of(state, subject), of_owner)) +
         (carried ? weight::kPartOfCarrier : 0);
}

// "a computer at its left end, a printer at its right end": of the same thing.
void Decoder::repeated_part_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const NounPhrase& noun = chunk(u).noun;
  if (noun.determiner != Determiner::kPossessive) return;
  for (int before = u; before-- > 0;) {
    const NounPhrase& part = chunk(before).noun;
    if (!is(before, UnitKind::kNoun) || part.kind != noun.kind || part.determiner != Determiner::kPossessive || part.head != noun.head)
      continue;
    const Referent meant = read_as(state, before).meant;
    const bool itself = meant == kNobody || same(state, meant, read_as(state, state.waiting).subject);
    if (!itself) add(s, kFill, weight::kSameSide + part_score(state, state.waiting, noun, meant), -1, -1, meant);
    return;
  }
}

// What may carry a small thing whose place is a part of it, the likeliest first.
std::vector<Decoder::Candidate> Decoder::carriers(const State& state, Referent subject) const {
  if (subject < 0 || mount_of(noun_of(state, subject)) != Mount::kSurface) return {};
  NounPhrase it;
  it.kind = NounKind::kPronoun;
  it.head = "it";
  std::vector<Candidate> all = antecedents(state, subject, &direct_senses<RelationType::kOn>(), &it);
  std::erase_if(all, [&](const Candidate& one) {
    return one.list || mount_of(noun_of(state, one.referent)) != Mount::kFloor ||
           !sense_.carries(noun_of(state, one.referent), noun_of(state, subject));
  });
  return all;
}

double Decoder::reference_score(const State& state, int place, Referent reference) const {
  const UnitReading& reading = read_as(state, place);
  const bool fronted = reading.fronted;
  const Referent subject = fronted ? reference : reading.subject;  // the noun that comes now
  if (fronted && reading.alone) {
    if (reading.implied == kNobody) return 0;
    const PhraseSenses& senses = alone_senses(place);
    const NounPhrase& thing = noun_of(state, subject);
    return sense_.of_place(senses, thing, noun_of(state, reading.implied)) + by_small_score(state, thing, reading.implied, senses);
  }
  if (fronted && reading.inverse) return 0;
  const Referent other = fronted ? place + 1 : reference;
  if (subject == kNobody) return 0;
  if (same(state, subject, other)) return weight::kItself;
  const NounPhrase &target = noun_of(state, subject), &by = other >= 0 ? called_before(state, other) : noun_of(state, other);
  if (target.kind != NounKind::kObject) return 0;
  double score = sense_.of_place(unit(place).direct, target, by);
  if (!fronted && reading.first_subject != subject && subject >= 0) {
    for (const int member : list_of(state, subject, reading.first_subject)) {
      if (member != subject) score += std::min(0.0, sense_.of_place(unit(place).direct, noun_of(state, member), by) - score);
    }
  }
  if (chunk(place).hang && is_heavy(lexicon_.catalog(), target)) score += weight::kHeavyHung;
  if (fronted)
    return score +
           (chunk(place + 1).noun.head == "it" ? by_small_score(state, target, read_as(state, other).meant, unit(place).direct) : 0);
  return score + habit_score(state, place, subject, other, unit(place).direct) + apart_score(state, other, subject, unit(place).direct);
}

// Seats of a table or desk, nightstands of a bed: where such a group is said to be is where its head is.
bool Decoder::comes_with(const State& state, Referent member) const {
  const Referent host = host_of(state, member);
  if (member < 0 || read_as(state, member).role != NounRole::kContent || !is_thing(state, host)) return false;
  const NounPhrase &target = noun_of(state, member), &head = noun_of(state, host);
  if (target.entry == nullptr || head.entry == nullptr || mount_of(target) != Mount::kFloor || mount_of(head) != Mount::kFloor)
    return false;
  if (is_seat(lexicon_.catalog(), target)) return is_table(lexicon_.catalog(), head);
  return std::ranges::any_of(target.entry->beside, [&](const std::string& kind) { return lexicon_.catalog().is_a(head.entry->id, kind); });
}

// What a thing has is seldom what stands at a wall; a table with chairs in the corner is what stands there.
double Decoder::habit_score(const State& state, int place, Referent subject, Referent other, const PhraseSenses& senses) const {
  if (subject < 0 || read_as(state, subject).role != NounRole::kContent) return 0;
  const NounPhrase &target = noun_of(state, subject), &by = noun_of(state, other);
  double score = 0;
  const Referent host = host_of(state, subject);
  // "a desk with two screens in the corner"
  const bool carried = is_thing(state, host) && mount_of(noun_of(state, host)) == Mount::kFloor && mount_of(target) != Mount::kFloor &&
                       sense_.carries(noun_of(state, host), target);
  const bool small =
      is_seat(lexicon_.catalog(), target) ? !says(senses, RelationType::kFacing) : mount_of(target) == Mount::kSurface || carried;
  const bool in_middle = says(senses, RelationType::kCenterOfRoom) && comes_with(state, subject);
  // "twelve desks with chairs facing the board": the desks
  const bool class_looks = says(senses, RelationType::kFacing) && comes_with(state, subject) && several(state, host);
  // "a counter with a sink along the wall", "four stations with mirrors along it": the counter and the stations
  const bool along = word(place) == "along" && is_thing(state, host) && mount_of(noun_of(state, host)) == Mount::kFloor &&
                     (mount_of(target) == Mount::kWall || sense_.carries(noun_of(state, host), target) ||
                      (target.entry != nullptr && kind_at(lexicon_.catalog(), target.entry->id, KinPlace::kSetIn) != nullptr));
  if (along && is_place_of_room(by.kind)) score += weight::kSmallByPlace;
  // "a desk with monitors and speakers facing the window": who works there does
  const bool looks_out = says(senses, RelationType::kFacing) && (by.kind == NounKind::kWindow || by.kind == NounKind::kDoor);
  if (looks_out && carried && mount_of(target) == Mount::kSurface) score += weight::kLiesTwice;
  // "a squat rack with barbell against the back wall": what is named barely goes with the rack
  const bool bare = target.determiner == Determiner::kNone && target.count == 0;
  const bool backed = !along && bare && is_thing(state, host) && by.kind == NounKind::kWall &&
                      mount_of(noun_of(state, host)) == Mount::kFloor && mount_of(target) == Mount::kFloor;
  if (backed && unit(place).joiner == Joiner::kNone) score += weight::kSmallByPlace;
  // "an armchair with a lamp beside it in the corner": the armchair is
  if (placed_by_host(subject) && unit(place).joiner == Joiner::kNone && place > subject + 2 && is_place_of_room(by.kind) &&
      is_thing(state, host))
    score += weight::kSmallByPlace;
  const bool apart = unit(place).joiner != Joiner::kNone || state.participle || chunk(place).placing;
  if (apart) return score;
  const bool beside = std::ranges::any_of(senses, [](const PhraseSense& sense) {
    return sense.type == RelationType::kBetween || sense.type == RelationType::kOpposite || sense.type == RelationType::kAtHeadOf ||
           sense.type == RelationType::kAtFootOf || stands_beside(sense.type);
  });
  // "a bench with three cushions beneath a row of hooks": the bench
  const bool below = says(senses, RelationType::kUnder) && mount_of(target) == Mount::kSurface && by.kind == NounKind::kObject &&
                     mount_of(by) == Mount::kWall && is_thing(state, host) && mount_of(noun_of(state, host)) == Mount::kFloor;
  if (below) score += weight::kSmallByPlace;
  // "a table with books to the right of the armchair", "an armchair with an ottoman by the fireplace"
  const bool goes_with = mount_of(target) == Mount::kSurface || (target.entry != nullptr && target.entry->is(Trait::kStandsBefore));
  if (beside && goes_with && by.kind == NounKind::kObject && mount_of(by) == Mount::kFloor && is_thing(state, host) &&
      mount_of(noun_of(state, host)) == Mount::kFloor && !same(state, host, other))
    score += weight::kSmallByPlace;
  if ((is_place_of_room(by.kind) || by.niche) && !by.of && (small || in_middle)) score += weight::kSmallByPlace;
  if (class_looks) score += weight::kSmallByPlace;
  const bool by_the_way = unit(read_as(state, subject).predicate).joiner != Joiner::kNone;  // ", with two armchairs near the fireplace"
  if (!by_the_way && is_thing(state, host) && is_seat(lexicon_.catalog(), target) && is_table(lexicon_.catalog(), noun_of(state, host)) &&
      by.kind == NounKind::kObject && !says(senses, RelationType::kFacing) && word(place) != "at" && !same(state, host, other))
    score += weight::kSeatOfTable;
  return score;
}

double Decoder::content_score(const State& state, int predicate, Referent content) const {
  const UnitReading& reading = read_as(state, predicate);
  if (reading.subject == kNobody || reading.of_room) return 0;
  const NounPhrase &host = noun_of(state, reading.subject), &thing = noun_of(state, content);
  if (reading.inverse) {
    const bool place = host.kind == NounKind::kObject || host.kind == NounKind::kWall || host.kind == NounKind::kCorner;
    if (is(predicate, UnitKind::kPlace) && place && thing.kind == NounKind::kObject) {
      const PhraseSenses& senses = unit(predicate).inverse.empty() ? unit(predicate).direct : unit(predicate).inverse;
      return sense_.of_place(senses, thing, host);
    }
    return 0;
  }
  const std::string& how = word(predicate);
  const bool holds =
      how != "with" && !how.starts_with("featur") && !how.starts_with("includ") && how != "has" && how != "have" && how != "having";
  // "a sofa on the left wall with a TV opposite": not on that wall
  const auto is_across = [&](int u) { return follows(u, UnitKind::kPlace) && says(alone_senses(u + 1), RelationType::kOpposite); };
  if (how == "with" && content >= 0 && host.kind == NounKind::kWall && is_across(content)) return weight::kUnlikely;
  const double having = sense_.of_having(host, thing, holds);
  // "a TV with a cabinet under it" does not have the cabinet
  return how == "with" && content >= 0 && placed_by_host(content) ? std::max(having, 0.0) : having;
}

// "one holding a lamp", "each with a chair", "both against the wall", "It stands …".
void Decoder::member_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const NounPhrase& noun = chunk(u).noun;
  const bool verb = is(u + 1, UnitKind::kVerb) && unit(u + 1).joiner == Joiner::kNone;
  std::vector<Candidate> all = antecedents(state, kNobody, nullptr, &noun);
  for (const Candidate& meant : all) {
    const double own = noun.kind == NounKind::kPart ? sense_.of_part(noun, noun_of(state, meant.referent)) : 0;
    add(s, kSpeakOf, meant.score + own + (verb ? 0.2 : 0), -1, -1, meant.referent, meant.list);
  }
  add(s, kSpeakOf, -7);
}

}  // namespace layoutbox::offline
