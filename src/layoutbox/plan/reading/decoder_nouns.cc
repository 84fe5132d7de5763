// What a noun phrase is for: the one that a place waits for, the next of a list, the subject of a clause, or one of those before.
#include <algorithm>

#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/reader_words.h"
#include "layoutbox/plan/reading/decoder.h"
#include "layoutbox/plan/reading/weights.h"

namespace layoutbox::offline {

namespace {

// "it", "one", "each", "the other": speaks of what was named. "Another one" is new.
bool speaks_of_others(const NounPhrase& noun) {
  if (noun.kind == NounKind::kPronoun) return true;
  if (noun.kind != NounKind::kMember) return false;
  const bool fresh = noun.determiner == Determiner::kAnother || (noun.determiner == Determiner::kIndefinite && !noun.attributes.empty());
  return !fresh || noun.subset || noun.of != nullptr;
}

// A part whose thing is not said ("the left side", "its top").
bool needs_owner(const NounPhrase& noun) {
  if (noun.kind == NounKind::kObject || noun.kind == NounKind::kRoom) return false;
  if (noun.of) return noun.of->kind == NounKind::kPronoun || noun.of->kind == NounKind::kMember;
  if (noun.kind == NounKind::kPart) return true;
  return noun.determiner == Determiner::kPossessive && (noun.kind == NounKind::kCorner || noun.kind == NounKind::kCenter);
}

bool is_place_of_room(NounKind kind) {
  return kind == NounKind::kCorner || kind == NounKind::kWall || kind == NounKind::kWindow || kind == NounKind::kDoor ||
         kind == NounKind::kCenter || kind == NounKind::kRoom;
}

// "stand", "are": of several.
bool is_plural_verb(std::string_view word) { return !word.ends_with("s") && !word.ends_with("ed") && !word.ends_with("ing"); }

bool shares_article(const NounPhrase& noun, const NounPhrase& former) {
  return noun.determiner == Determiner::kNone && noun.count == 0 && !noun.plural && former.determiner != Determiner::kNone;
}

}  // namespace

void Decoder::noun_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const bool joined = unit(u).joiner != Joiner::kNone;
  if (state.waiting >= 0 && !joined) {
    waited_actions(s, u);
    return;
  }
  const bool others = speaks_of_others(chunk(u).noun) || (chunk(u).noun.kind == NounKind::kPart && needs_owner(chunk(u).noun) &&
                                                          chunk(u).noun.determiner == Determiner::kPossessive);
  if (others) member_actions(s, u);
  // "between the bed and the window stands a desk"
  if (joined && state.frontier.empty() && !state.fronted.empty() && is(u - 1, UnitKind::kNoun) &&
      state.units[static_cast<std::size_t>(u - 1)].predicate == state.fronted.back()) {
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
  if (!joined && is(u - 1, UnitKind::kNoun) && state.units[static_cast<std::size_t>(u - 1)].role == NounRole::kMember &&
      is_new_thing(chunk(u).noun)) {
    for (int p = u; p-- > 0;) {
      if (!is(p, UnitKind::kHave) || state.units[static_cast<std::size_t>(p)].of_room) continue;
      add(s, kElided, 0.5, p);
      break;
    }
  }
  if (state.verb && !joined) {
    add(s, kNewRoot, 0);
    return;
  }
  if (!others) list_actions(s, u);
}

void Decoder::waited_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const int p = state.waiting;
  const UnitReading& place = state.units[static_cast<std::size_t>(p)];
  const NounPhrase& noun = chunk(u).noun;
  if (is(p, UnitKind::kHave) || place.inverse) {
    if (speaks_of_others(noun) && !noun.reciprocal) {
      for (const Candidate& meant : antecedents(state, place.subject, nullptr, &noun))
        add(s, kFill, meant.score, -1, -1, meant.referent, meant.list);
    }
    add(s, kFill, content_score(state, p, u) + (speaks_of_others(noun) ? -6 : 0));
    return;
  }
  if (noun.kind == NounKind::kPronoun && place.implied != kNobody) {  // "on which"
    add(s, kFill, 0, -1, -1, place.implied);
    return;
  }
  if (noun.reciprocal) {
    const bool many = several(state, place.subject) || (place.subject >= 0 && place.first_subject != place.subject);
    add(s, kFill, many ? 1 : -2);
    return;
  }
  if (speaks_of_others(noun) || needs_owner(noun)) {
    const bool part = noun.kind != NounKind::kPronoun && noun.kind != NounKind::kMember;
    for (const Candidate& meant : antecedents(state, place.subject, part ? nullptr : &unit(p).direct, &noun, place.first_subject))
      add(s, kFill, meant.score + (part ? sense_.of_part(noun, noun_of(state, meant.referent)) : 0), -1, -1, meant.referent, meant.list);
    // "a wardrobe to the right of the door and a cabinet to the left of it"
    if (noun.head == "it") {
      if (const Referent host = side_host(state, p, unit(p).direct); host != kNobody && !same(state, host, place.subject))
        add(s, kFill, weight::kSameSide, -1, -1, host);
    }
    add(s, kFill, weight::kMeansNobody);
    return;
  }
  // "on one corner", "in the middle": of what carries the thing.
  if ((noun.kind == NounKind::kCorner || noun.kind == NounKind::kCenter) && !noun.of && noun.wall_word.empty() && word(p) != "in") {
    for (const Candidate& meant : carriers(state, place.subject))
      add(s, kFill, meant.score + (word(p) == "on" ? weight::kPartOfCarrier : 0), -1, -1, meant.referent);
  }
  add(s, kFill, place.fronted ? 0 : reference_score(state, p, u));
}

// What may carry a small thing whose place is a part of it, the likeliest first.
std::vector<Decoder::Candidate> Decoder::carriers(const State& state, Referent subject) const {
  static const PhraseSenses kLies = {{RelationType::kOn, PhraseSense::Direction::kDirect, {}, {}, {}}};
  if (subject < 0 || mount_of(noun_of(state, subject)) != Mount::kSurface) return {};
  NounPhrase it;
  it.kind = NounKind::kPronoun;
  it.head = "it";
  std::vector<Candidate> all = antecedents(state, subject, &kLies, &it);
  std::erase_if(all, [&](const Candidate& one) {
    return one.list || mount_of(noun_of(state, one.referent)) != Mount::kFloor ||
           !sense_.carries(noun_of(state, one.referent), noun_of(state, subject));
  });
  return all;
}

double Decoder::reference_score(const State& state, int place, Referent reference) const {
  const UnitReading& reading = state.units[static_cast<std::size_t>(place)];
  const bool fronted = reading.fronted;
  const Referent subject = fronted ? reference : reading.subject;  // the noun that comes now
  if (fronted && reading.alone) {
    if (reading.implied == kNobody) return 0;
    return sense_.of_place(unit(place).alone.empty() ? unit(place).direct : unit(place).alone, noun_of(state, subject),
                           noun_of(state, reading.implied));
  }
  if (fronted && reading.inverse) return 0;
  const Referent other = fronted ? place + 1 : reference;
  if (subject == kNobody) return 0;
  if (same(state, subject, other)) return weight::kItself;
  const NounPhrase &target = noun_of(state, subject), &by = noun_of(state, other);
  if (target.kind != NounKind::kObject) return 0;
  double score = sense_.of_place(unit(place).direct, target, by);
  if (!fronted && reading.first_subject != subject && subject >= 0) {
    for (const int member : list_of(state, subject, reading.first_subject)) {
      if (member != subject) score += std::min(0.0, sense_.of_place(unit(place).direct, noun_of(state, member), by) - score);
    }
  }
  if (chunk(place).hang && is_heavy(lexicon_.catalog(), target)) score += weight::kHeavyHung;
  return fronted ? score : score + habit_score(state, place, subject, other, unit(place).direct);
}

// What a thing has is seldom what stands at a wall; a table with chairs in the corner is what stands there.
double Decoder::habit_score(const State& state, int place, Referent subject, Referent other, const PhraseSenses& senses) const {
  if (subject < 0 || state.units[static_cast<std::size_t>(subject)].role != NounRole::kContent) return 0;
  const NounPhrase &target = noun_of(state, subject), &by = noun_of(state, other);
  double score = 0;
  const Referent host = host_of(state, subject);
  const bool small = is_seat(lexicon_.catalog(), target) ? !says(senses, RelationType::kFacing) : mount_of(target) == Mount::kSurface;
  const bool apart = unit(place).joiner != Joiner::kNone || state.participle || chunk(place).placing;
  if (apart) return score;
  const bool beside = says(senses, RelationType::kBetween) || says(senses, RelationType::kNextTo) || says(senses, RelationType::kNear);
  if (beside && mount_of(target) == Mount::kSurface && by.kind == NounKind::kObject && mount_of(by) == Mount::kFloor &&
      is_thing(state, host) && mount_of(noun_of(state, host)) == Mount::kFloor && !same(state, host, other))
    score += weight::kSmallByPlace;
  if ((is_place_of_room(by.kind) || by.niche) && !by.of && small) score += weight::kSmallByPlace;
  if (is_thing(state, host) && is_seat(lexicon_.catalog(), target) && is_table(lexicon_.catalog(), noun_of(state, host)) &&
      by.kind == NounKind::kObject && !says(senses, RelationType::kFacing) && word(place) != "at" && !same(state, host, other))
    score += weight::kSeatOfTable;
  return score;
}

double Decoder::content_score(const State& state, int predicate, Referent content) const {
  const UnitReading& reading = state.units[static_cast<std::size_t>(predicate)];
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
  return sense_.of_having(host, thing, holds);
}

void Decoder::list_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const NounPhrase& noun = chunk(u).noun;
  const bool subject = verb_like(u + 1) && unit(u + 1).joiner == Joiner::kNone && !unit(u + 1).clause;
  const bool placed = follows(u, UnitKind::kPlace) || (follows(u, UnitKind::kParticiple) && follows(u + 1, UnitKind::kPlace));
  const double beside = unit(u).joiner == Joiner::kNone && is(u - 1, UnitKind::kNoun) ? weight::kNoJoiner : 0;
  // "books and newspapers lines the wall": not the newspapers.
  const bool disagrees = subject && noun.is_plural() && (is_finite(word(u + 1)) || word(u + 1) == "is" || word(u + 1) == "was");
  const std::size_t n = state.frontier.size();
  for (std::size_t level = 0; level < n; ++level) {
    const int member = state.frontier[level];
    const UnitReading& reading = state.units[static_cast<std::size_t>(member)];
    double gain = beside + weight::kTreeList * tree_.for_noun(u, member);
    if (level == 0) {
      const bool of_clause = !state.verb || state.imperative;
      gain += disagrees ? weight::kDisagrees : subject ? weight::kSubjectFollows : placed ? weight::kPlaceFollows : 0;
      double share = 0;
      for (const int place : state.fronted) share += reference_score(state, place, u);
      // "On the table a mug and a pad lie beside a clock": a plural verb of one thing speaks of the list.
      const bool agrees = subject && unit(u).joiner == Joiner::kAnd && !noun.is_plural() && is_plural_verb(word(u + 1));
      if (of_clause && (state.fronted.empty() || !subject || agrees))
        add(s, kNextRoot,
            gain + (agrees && !state.fronted.empty() ? weight::kAgrees : 0) + std::max(share, -2.5) -
                (placed && !state.fronted.empty() && !(share > 0 && mount_of(noun) == Mount::kSurface) ? 1.2 : 0),
            member);
      if (!of_clause || !state.fronted.empty()) add(s, kNewRoot, gain - (state.fronted.empty() ? 0 : 0.4));
      continue;
    }
    if (reading.role == NounRole::kMember) continue;
    for (std::size_t f = level + 1; f < n; ++f)
      gain += state.units[static_cast<std::size_t>(state.frontier[f])].role == NounRole::kContent ? weight::kNearerList : 0;
    gain += reading.role == NounRole::kContent ? content_list_score(state, member, u) : reference_list_score(state, member, u);
    if (subject)
      gain += reading.role == NounRole::kContent && unit(u).joiner == Joiner::kAnd && is_finite(word(u + 1)) != noun.is_plural() ? -2.0 : 0;
    if (gain > -5) add(s, kSameList, gain, member);
  }
}

// "a desk with a lamp and a clock": the clock is the desk's as well.
double Decoder::content_list_score(const State& state, int member, int u) const {
  const UnitReading& reading = state.units[static_cast<std::size_t>(member)];
  const NounPhrase &noun = chunk(u).noun, &former = noun_of(state, member);
  const int predicate = reading.predicate;
  const Referent owner = state.units[static_cast<std::size_t>(predicate)].subject;
  const NounPhrase& host = noun_of(state, owner);
  const Joiner joiner = unit(u).joiner;
  if (noun.kind != NounKind::kObject && noun.kind != NounKind::kAbstract && noun.kind != NounKind::kPart && noun.kind != NounKind::kMember)
    return -4;
  double score = 0;
  bool ended = false;
  std::size_t length = 0;
  for (int m = member; m >= 0; m = state.units[static_cast<std::size_t>(m)].former, ++length) {
    ended |= unit(m).joiner == Joiner::kAnd || unit(m).joiner == Joiner::kCommaAnd;
  }
  if (ended) score += weight::kListEnded;
  if (joiner == Joiner::kAnd) score += weight::kBareAnd;
  if (joiner == Joiner::kCommaAnd) score += length > 1 ? 0.6 : -1.2;
  if (shares_article(noun, former)) score += joiner == Joiner::kAnd ? weight::kShareArticle : 0;
  const bool inverse = state.units[static_cast<std::size_t>(predicate)].inverse;
  if (reading.placed && !inverse && mount_of(noun) == Mount::kFloor) score -= 2;
  if (noun.determiner == Determiner::kDefinite) score -= 1.5;
  const bool own_place =
      follows(u, UnitKind::kPlace) && !unit(u + 1).direct.empty() && follows(u + 1, UnitKind::kNoun) && !chunk(u + 2).noun.reciprocal;
  if (owner == kNobody || host.kind != NounKind::kObject) return score + (host.kind == NounKind::kWall ? 0.5 : 0);
  const bool carried = sense_.carries(host, noun), before = sense_.carries(host, former);
  const bool at_it = is_table(lexicon_.catalog(), host) && is_seat(lexicon_.catalog(), noun);
  if (carried && (before || mount_of(noun) == Mount::kSurface)) {
    score += mount_of(noun) == Mount::kFloor && mount_of(former) != Mount::kFloor ? 0.2 : weight::kCarriedToo;
  } else if (at_it && one_of(noun.head, {"sofa", "couch", "loveseat", "ottoman", "recliner"})) {
    score += weight::kNotCarried;
  } else if (at_it) {
    score += (joiner == Joiner::kAnd || (joiner == Joiner::kCommaAnd && length > 1)) && !own_place ? 0.6 : -0.6;
  } else if (mount_of(noun) != mount_of(former)) {
    score += weight::kNotCarried;
  } else if (!inverse && before) {
    score += weight::kNotCarried;
  } else if (joiner == Joiner::kComma) {
    score -= 1.2;
  }
  if (unit(predicate).joiner != Joiner::kNone && mount_of(noun) == Mount::kFloor && !inverse) score -= 2;  // ", with …"
  if (own_place) score -= !carried ? 1.6 : joiner == Joiner::kAnd ? 0.6 : 1.4;
  // "each with a bed, a chair and a lamp": every one has all of them.
  if (owner >= 0 && chunk(owner).noun.determiner == Determiner::kEach) score += weight::kEachHas;
  if (host.entry != nullptr && host.entry->thin) score -= 3;
  return score;
}

// "next to the bed and the desk"
double Decoder::reference_list_score(const State& state, int member, int u) const {
  const UnitReading& reading = state.units[static_cast<std::size_t>(member)];
  const NounPhrase &noun = chunk(u).noun, &former = chunk(member).noun;
  const int place = reading.predicate;
  const Joiner joiner = unit(u).joiner;
  const bool next_to_it = member + 1 == u;
  const bool between = place >= 0 && says(unit(place).direct, RelationType::kBetween);
  if (between && !former.is_plural() && reading.former < 0 && next_to_it && joiner == Joiner::kAnd) return 8;
  if (joiner != Joiner::kAnd || between || !next_to_it) return -6;
  const auto definite = [](const NounPhrase& n) {
    return n.determiner == Determiner::kDefinite || n.determiner == Determiner::kEach || n.determiner == Determiner::kBoth ||
           n.determiner == Determiner::kPossessive;
  };
  if (former.kind != NounKind::kObject || noun.kind != NounKind::kObject)
    return noun.kind == former.kind && noun.kind != NounKind::kRoom ? 1.5 : -6;
  double score = definite(former) == definite(noun) ? 0.5 : -3;
  if (definite(former) && definite(noun)) score += 1.2;
  if (!definite(noun)) score += 0.4;
  if (follows(u, UnitKind::kPlace) || follows(u, UnitKind::kHave) || follows(u, UnitKind::kParticiple) || follows(u, UnitKind::kVerb))
    score -= 2;
  const UnitReading& of = state.units[static_cast<std::size_t>(place)];
  if (of.fronted) score += 2;
  if (!of.fronted && is_thing(state, of.subject))
    score += std::min(0.3, sense_.of_place(unit(place).direct, noun_of(state, of.subject), noun));
  return score;
}

// "one holding a lamp", "each with a chair", "both against the wall", "It stands …".
void Decoder::member_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const NounPhrase& noun = chunk(u).noun;
  const bool verb = is(u + 1, UnitKind::kVerb) && unit(u + 1).joiner == Joiner::kNone;
  std::vector<Candidate> all = antecedents(state, kNobody, nullptr, &noun);
  for (const Candidate& meant : all) add(s, kSpeakOf, meant.score + (verb ? 0.2 : 0), -1, -1, meant.referent, meant.list);
  add(s, kSpeakOf, -7);
}

void Decoder::apply_noun(State& state, const Action& action, int u) const {
  UnitReading& own = state.units[static_cast<std::size_t>(u)];
  own.meant = action.meant;
  own.whole_list = action.list;
  // "another one", "a smaller one": a thing of the kind that was named last.
  if (chunk(u).noun.kind == NounKind::kMember && own.meant == kNobody && !speaks_of_others(chunk(u).noun))
    own.meant = action.unit >= 0       ? action.unit
                : !state.roots.empty() ? state.roots.back()
                : before_.topic >= 0   ? referent_of_mention(before_.topic)
                                       : kNobody;
  const auto fill_fronted = [&] {
    for (const int place : state.fronted) {
      UnitReading& fronted = state.units[static_cast<std::size_t>(place)];
      if (fronted.subject == kNobody) fronted.first_subject = u;
      fronted.subject = u;
      own.placed = true;
    }
    if (state.inverted >= 0) state.units[static_cast<std::size_t>(state.inverted)].subject = u;
  };
  switch (action.kind) {
    case kFill: {
      const int p = state.waiting;
      UnitReading& place = state.units[static_cast<std::size_t>(p)];
      state.waiting = -1;
      own.predicate = p;
      if (place.of_room) {
        own.role = NounRole::kRoot;
        own.opens_clause = true;
        state.frontier = {u};
        state.roots.push_back(u);
        break;
      }
      own.role = is(p, UnitKind::kHave) || place.inverse ? NounRole::kContent : NounRole::kReference;
      if (own.role == NounRole::kReference) state.place = p;
      if (own.role == NounRole::kContent) own.placed = !is(p, UnitKind::kHave);
      if (own.meant != kNobody && noun_of(state, u).kind == NounKind::kObject) state.it = own.meant;
      if (!place.fronted) state.frontier.push_back(u);
      break;
    }
    case kElided:
      own.role = NounRole::kContent;
      own.predicate = action.unit;
      own.subject = u - 1;
      state.frontier.push_back(u);
      break;
    case kNextRoot:
    case kNewRoot: {
      own.role = NounRole::kRoot;
      if (action.kind == kNewRoot && !state.frontier.empty()) {
        const bool room_list = state.room_list;
        begin_clause(state);
        state.room_list = room_list;
      }
      if (action.kind == kNextRoot && is_thing(state, action.unit)) own.former = action.unit;
      own.opens_clause = own.former < 0;
      fill_fronted();
      state.frontier = {u};
      state.relative = state.waiting = -1;
      state.roots.push_back(u);
      break;
    }
    case kSameList: {
      cut_frontier(state, action.unit);
      const UnitReading& former = state.units[static_cast<std::size_t>(action.unit)];
      own.role = former.role;
      own.predicate = former.predicate;
      own.former = action.unit;
      own.placed = former.role == NounRole::kContent && !is(former.predicate, UnitKind::kHave);
      if (!state.frontier.empty()) state.frontier.back() = u;
      break;
    }
    case kSpeakOf: {
      own.role = NounRole::kMember;
      const bool after_list = !state.frontier.empty() && !verb_like(u + 1);
      if (after_list) {
        // "two tables, one with a lamp": hangs on what it speaks of.
        const auto at = std::find(state.frontier.begin(), state.frontier.end(), action.meant);
        cut_frontier(state, at != state.frontier.end() ? *at : state.frontier.front());
        state.frontier.push_back(u);
        state.verb = true;
        state.imperative = false;
      } else {
        const std::vector<int> fronted = state.fronted;
        const int inverted = state.inverted;
        const bool keep = state.frontier.empty();
        begin_clause(state);
        if (keep) state.fronted = fronted, state.inverted = inverted;
        fill_fronted();
        state.frontier = {u};
      }
      state.it = action.meant;
      break;
    }
    default: break;
  }
  if (own.role == NounRole::kRoot || own.role == NounRole::kContent) state.participle = false;
}

}  // namespace layoutbox::offline
