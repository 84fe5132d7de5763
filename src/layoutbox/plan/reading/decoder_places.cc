// What a place, a having or a verb is said of.
#include <algorithm>

#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/reader_words.h"
#include "layoutbox/plan/reading/decoder.h"
#include "layoutbox/plan/reading/weights.h"

namespace layoutbox::offline {

namespace {

bool is_known_noun(const NounPhrase& noun) {
  return noun.kind != NounKind::kObject || noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kEach ||
         noun.determiner == Determiner::kPossessive || noun.determiner == Determiner::kBoth;
}

bool of_group_only(const PhraseSenses& senses) {
  return !senses.empty() &&
         std::all_of(senses.begin(), senses.end(), [](const PhraseSense& s) { return relation_row(s.type).arity == RelationArity::kNone; });
}

bool is_room_like(NounKind kind) {
  return kind == NounKind::kRoom || kind == NounKind::kOutsideRoom || kind == NounKind::kAbstract || kind == NounKind::kWindow ||
         kind == NounKind::kDoor;
}

}  // namespace

// How likely it is that a place (having …) at u speaks of the thing at that level of the frontier.
double Decoder::attach_score(const State& state, int u, int level, bool inverse) const {
  const int member = state.frontier[static_cast<std::size_t>(level)];
  double score = weight::kTree * tree_.for_noun(u, member);
  int nearer = 0;
  for (std::size_t f = static_cast<std::size_t>(level) + 1; f < state.frontier.size(); ++f)
    nearer += is_thing(state, state.frontier[f]) ? 1 : 0;
  int steps = 0;
  for (int f = 0; f < level; ++f) steps += is_thing(state, state.frontier[static_cast<std::size_t>(f)]) ? 1 : 0;
  const bool again = state.place >= 0 && state.units[static_cast<std::size_t>(state.place)].subject == member;
  switch (unit(u).joiner) {
    case Joiner::kNone: score += weight::kLevel * nearer; break;
    case Joiner::kAnd: score += weight::kLevelAfterComma * steps + (again ? weight::kSameSubject : 0); break;
    default: score += weight::kLevelAfterComma * steps + (again ? 0.3 : 0); break;
  }
  // "in the corner by the door": the second place is of the same thing.
  if (again && unit(u).joiner == Joiner::kNone && nearer == 0) score += weight::kSameSubject;
  if (level > 0 && finite_place(u)) score += weight::kFiniteRoot;
  if (word(u) == "from" && level > 0) score += weight::kFromRoot;
  if (!is_definite(state, member)) return score;
  if (inverse) return score + (is_thing(state, member) ? weight::kKnownHost : weight::kPlaceAsHost);
  score += is_known(state, member) ? weight::kKnownSubject : weight::kDefiniteSubject;
  return score;
}

// A place that is a finite verb: "faces", "hang on".
bool Decoder::finite_place(int u) const {
  return is(u, UnitKind::kPlace) &&
         (is_finite(word(u)) || one_of(word(u), {"hang", "face", "line", "flank", "surround", "frame", "fill", "cover", "occupy",
                                                 "dominate", "anchor", "overlook", "decorate", "adorn", "illuminate"}));
}

// "a bed and a desk against the wall": whether the former member is there as well; nothing speaks for it: below −5.
double Decoder::share_score(const State& state, int member, int u, Referent implied) const {
  const int former = state.units[static_cast<std::size_t>(member)].former;
  if (former < 0 || state.units[static_cast<std::size_t>(former)].placed || !is_thing(state, former)) return -10;
  const NounPhrase &noun = noun_of(state, member), &before = noun_of(state, former);
  const Joiner joiner = unit(member).joiner;
  const bool last = member == state.frontier.back() || state.units[static_cast<std::size_t>(member)].former == former;
  if (noun.determiner == Determiner::kNone && noun.count == 0 && !noun.plural && before.determiner != Determiner::kNone)
    return weight::kShareArticle;
  const Unit& place = unit(u);
  const PhraseSenses& senses = place.direct.empty() ? place.alone : place.direct;
  if (says(senses, RelationType::kRow) || says(senses, RelationType::kGrid) || says(senses, RelationType::kEvenlySpaced)) return 2;
  const NounPhrase& by = implied != kNobody ? noun_of(state, implied) : follows(u, UnitKind::kNoun) ? chunk(u + 1).noun : nothing_;
  const NounPhrase& host = by.kind == NounKind::kMember && by.of ? *by.of : by;  // "on each of the two nightstands"
  if ((implied != kNobody || follows(u, UnitKind::kNoun)) && host.kind == NounKind::kObject) {
    const bool lies = says(senses, RelationType::kOn) || says(senses, RelationType::kIn);
    const bool around = says(senses, RelationType::kAround) || says(senses, RelationType::kSurround);
    const auto carried = [&](const NounPhrase& n) {
      return sense_.carries(host, n) && (host.entry != nullptr ? !host.entry->thin : mount_of(n) != Mount::kFloor);
    };
    const bool seats = is_seat(lexicon_.catalog(), noun) && is_seat(lexicon_.catalog(), before);
    const bool listed = joiner != Joiner::kComma || state.frontier.back() != member;
    if (listed && ((lies && carried(noun) && carried(before)) || ((around || lies) && seats))) return weight::kShareKind;
  }
  // "a cabinet with a fridge and a coffee machine on top": all that it has.
  const bool content = state.units[static_cast<std::size_t>(member)].role == NounRole::kContent;
  if (content && implied != kNobody && (says(senses, RelationType::kOn) || says(senses, RelationType::kIn)) &&
      !is_seat(lexicon_.catalog(), before) && !is_table(lexicon_.catalog(), before))
    return 1;
  if (says(senses, RelationType::kCenterOfRoom) && joiner == Joiner::kAnd && state.units[static_cast<std::size_t>(former)].former < 0)
    return 1;
  if (by.reciprocal && several(state, member)) return -10;
  const std::string& first = word(u);
  const bool participle = state.participle || chunk(u).placing || first.ends_with("ing") || first.ends_with("ed");
  if (joiner == Joiner::kAnd && participle) return weight::kShareVerb;
  if (joiner == Joiner::kAnd && follows(u, UnitKind::kNoun) && chunk(u + 1).noun.reciprocal) return weight::kShareVerb;
  (void)last;
  return -10;
}

// What was named last is no thing ("with storage …"), and what follows is said of that.
bool Decoder::speaks_of_no_thing(const State& state) const {
  const int last = state.frontier.back();
  const NounKind kind = noun_of(state, last).kind;
  return state.units[static_cast<std::size_t>(last)].role == NounRole::kContent &&
         (kind == NounKind::kAbstract || kind == NounKind::kRoom) && host_of(state, last) != kNobody;
}

void Decoder::attach_actions(std::size_t s, int u, Kind kind) {
  const State& state = states_[s];
  const bool inverse = kind == kAttachInverse || kind == kHaveThing;
  for (std::size_t level = state.frontier.size(); level-- > 0;) {
    const int member = state.frontier[level];
    const NounKind place = noun_of(state, member).kind;
    const bool opening = place == NounKind::kDoor || place == NounKind::kWindow;
    // "a desk with a setup of …": what the setup has, the desk has.
    const Referent owner = place == NounKind::kAbstract && kind == kHaveThing ? host_of(state, member) : kNobody;
    if (owner >= 0 && is_thing(state, owner)) {
      add(s, kind, attach_score(state, u, static_cast<int>(level), true), owner,
          state.units[static_cast<std::size_t>(state.units[static_cast<std::size_t>(member)].predicate)].first_subject);
      continue;
    }
    // "the sofa and the seating arrangement face the wall"
    if (level == 0 && state.verb && state.first_subject >= 0 && !is_thing(state, member) && is_thing(state, state.first_subject) &&
        kind == kAttach) {
      add(s, kind, 0, member, state.first_subject);
      continue;
    }
    if (!is_thing(state, member) && !(opening && level == 0) &&
        !(inverse &&
          (place == NounKind::kWall || opening || place == NounKind::kCorner || place == NounKind::kCeiling || place == NounKind::kPart)))
      continue;
    if (state.relative >= 0 && member != state.relative) continue;
    double gain = state.relative >= 0 ? 0 : attach_score(state, u, static_cast<int>(level), inverse);
    // "in a row along the wall": of all that the place before was said of.
    const UnitReading* before = state.place >= 0 ? &state.units[static_cast<std::size_t>(state.place)] : nullptr;
    if (kind == kAttach && before != nullptr && before->subject == member && before->first_subject != member &&
        unit(u).joiner == Joiner::kNone) {
      add(s, kind, gain, member, before->first_subject);
      continue;
    }
    if (level == 0 && state.verb && state.first_subject >= 0) {
      add(s, kind, gain, member, state.first_subject);
      continue;
    }
    int first = member;
    double shared = 0;
    add(s, kind, gain, member, member);
    if (inverse && !(word(u).ends_with("ed") || word(u).ends_with("ing"))) continue;
    for (int m = member; kind != kAttachInverse && m >= 0;) {
      const double more = share_score(state, m, u);
      if (more < -5) break;
      shared += shared == 0 ? more : 0.2;
      first = state.units[static_cast<std::size_t>(m)].former;
      add(s, kind, gain + shared, member, first);
      m = first;
    }
  }
  // "with space below the window": of nothing that is a thing.
  const bool of_no_thing = !state.frontier.empty() && unit(u).joiner == Joiner::kNone && speaks_of_no_thing(state);
  if (of_no_thing || actions_.empty() || actions_.back().state != s) add(s, kind, of_no_thing ? weight::kNoThing : -1);
}

void Decoder::place_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const Unit& place = unit(u);
  const bool noun_follows = follows(u, UnitKind::kNoun);
  const bool joined = place.joiner != Joiner::kNone;
  if (!noun_follows || (place.direct.empty() && place.inverse.empty())) {
    alone_actions(s, u);
    return;
  }
  const NounPhrase& noun = chunk(u + 1).noun;
  const std::string& last = document_.tokens[chunk(u + 1).last - 1].text;
  // "a desk, on which a computer sits": a clause of its own whose place comes first.
  if ((noun.kind == NounKind::kPronoun || noun.subset) && (last == "which" || last == "whom") && !place.direct.empty()) {
    int nearer = 0;
    for (std::size_t f = state.frontier.size(); f-- > 0;) {
      if (is_thing(state, state.frontier[f]))
        add(s, kFront, -0.9 * nearer++ + weight::kTree * tree_.for_noun(u, state.frontier[f]), state.frontier[f], -1, state.frontier[f]);
    }
    if (!actions_.empty() && actions_.back().state == s) return;
  }
  const bool inverse = place.direct.empty();
  if (state.frontier.empty()) {
    // "To its left a lamp": the noun is the thing.
    const bool subject = verb_like(u + 2) && unit(u + 2).joiner == Joiner::kNone;
    if (!place.alone.empty() && is_new_thing(noun)) {
      const std::size_t before = actions_.size();
      alone_actions(s, u);
      for (std::size_t a = before; a < actions_.size(); ++a) actions_[a].score += subject ? 2.5 : 0;
    }
    // "Line the sofa along the wall": a command.
    const bool command = !inverse && chunk(u).last - chunk(u).first == 1 && word(u) == "line" && follows(u + 1, UnitKind::kPlace);
    if (command) add(s, kCommand, 1);
    add(s, kFront, 0);
    return;
  }
  // "two sofas facing each other across a table": the table is between them.
  if (is(u - 1, UnitKind::kNoun) && chunk(u - 1).noun.reciprocal && !joined &&
      (says(place.direct, RelationType::kOpposite) || says(place.direct, RelationType::kAbove))) {
    add(s, kAttachInverse, 1, state.frontier.front(), state.frontier.front(), kNobody, true);
    return;
  }
  attach_actions(s, u, inverse ? kAttachInverse : kAttach);
  if (!joined || inverse || verb_like(u)) return;
  // "…, in front of the sofa is a table": the place comes first.
  const int after = u + 2;
  double pattern = -4;
  if (is(after, UnitKind::kNoun) && unit(after).joiner == Joiner::kNone && is_new_thing(chunk(after).noun) && is_known_noun(noun))
    pattern = 3;
  const bool verb = is(after, UnitKind::kVerb) || is(after, UnitKind::kOpen);
  if (verb && is(after + 1, UnitKind::kNoun) && chunk(after + 1).noun.kind == NounKind::kObject) pattern = 2.5;
  if (is(after, UnitKind::kNoun) && unit(after).joiner == Joiner::kComma && place.joiner != Joiner::kComma &&
      is_new_thing(chunk(after).noun))
    pattern = 1.2;
  if (is(after, UnitKind::kOpen)) pattern = 2.5;
  // "…, and nearby a table stands in the center"
  if (!place.alone.empty() && is_new_thing(noun) && verb_like(u + 2) && unit(u + 2).joiner == Joiner::kNone) {
    NounPhrase them;
    them.kind = NounKind::kPronoun;
    for (const Candidate& meant : antecedents(state, kNobody, &place.alone, &them))
      add(s, kFrontAlone, 3 + meant.score, -1, -1, meant.referent, meant.list);
  }
  if (pattern > 0 || (!state.fronted.empty() && state.frontier.empty())) add(s, kFront, pattern);
}

// What the sentence placed something else to the left or right of, where the place at u says left or right.
Referent Decoder::side_host(const State& state, int u, const PhraseSenses& senses) const {
  const auto across = [](const PhraseSenses& all) { return says(all, RelationType::kLeftOf) || says(all, RelationType::kRightOf); };
  const auto along = [](const PhraseSenses& all) { return says(all, RelationType::kInFrontOf) || says(all, RelationType::kBehind); };
  const bool by_side = across(senses);
  if (!by_side && !along(senses)) return kNobody;
  const auto sides = [&](const PhraseSenses& all) { return by_side ? across(all) : along(all); };
  for (int p = u; p-- > 0;) {
    const UnitReading& place = state.units[static_cast<std::size_t>(p)];
    // Of another clause, or after a place that it begins with.
    if (unit(p + 1).clause || (p + 1 < u && is(p + 1, UnitKind::kPlace) && state.units[static_cast<std::size_t>(p) + 1].fronted &&
                               !state.units[static_cast<std::size_t>(p) + 1].alone))
      return kNobody;
    if (!is(p, UnitKind::kPlace) || place.inverse || !(sides(unit(p).direct) || sides(unit(p).alone))) continue;
    const Referent host = place.alone ? place.implied : is(p + 1, UnitKind::kNoun) ? p + 1 : kNobody;
    if (host != kNobody) return host;
  }
  return kNobody;
}

// The reference is not said: "nearby", "on each side", "to its left".
void Decoder::alone_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const Unit& place = unit(u);
  const PhraseMatch& phrase = chunk(u).phrase;
  const bool alone = !place.alone.empty();
  const std::string& last = document_.tokens[chunk(u).last - 1].text;
  const bool open_end = last == "of" || last == "to" || last == "from" || last == "with" || last == "by" || last == "at" || last == "on" ||
                        last == "in" || last == "against";
  const bool up_or_down = says(place.direct, RelationType::kAbove) || says(place.direct, RelationType::kUnder);
  if (!alone && !phrase.possessive && (open_end || place.direct.empty() || !up_or_down)) {
    add(s, kPass, 0);
    return;
  }
  const PhraseSenses& senses = alone ? place.alone : place.direct;
  const bool group = of_group_only(senses);
  NounPhrase them;
  them.kind = NounKind::kPronoun;
  them.plural = says(senses, RelationType::kBetween);
  const auto front = [&](double gain) {
    if (group) {
      add(s, kFrontAlone, gain);
      return;
    }
    if (const Referent host = side_host(state, u, senses); host != kNobody) add(s, kFrontAlone, gain + weight::kSameSide, -1, -1, host);
    for (const Candidate& meant : antecedents(state, kNobody, &senses, &them))
      add(s, kFrontAlone, gain + meant.score, -1, -1, meant.referent, meant.list);
    add(s, kFrontAlone, gain - 5);
  };
  if (state.frontier.empty()) {
    front(0);
    return;
  }
  const bool by_each_other = chunk(u).last > chunk(u).first + 1 && last == word(u) && (last == "side" || last == "back");
  const bool stacked = says(senses, RelationType::kStacked);
  int nearer = 0;
  for (std::size_t level = state.frontier.size(); level-- > 0;) {
    const int member = state.frontier[level];
    if (!is_thing(state, member)) continue;
    double gain =
        attach_score(state, u, static_cast<int>(level), false) + (place.joiner == Joiner::kNone ? weight::kLevelAlone * nearer : 0);
    ++nearer;
    if (is(u - 1, UnitKind::kVerb) && level > 0) gain -= 3;
    const auto with_list = [&](double base, Referent implied, bool list) {
      add(s, kAttachAlone, base, member, state.verb && level == 0 && state.first_subject >= 0 ? state.first_subject : member, implied,
          list);
      double shared = 0;
      for (int m = member; m >= 0;) {
        const double more = by_each_other || stacked
                                ? (state.units[static_cast<std::size_t>(m)].former >= 0 && !several(state, m) ? 1.5 : -10)
                                : share_score(state, m, u, implied);
        if (more < -5) break;
        shared += shared == 0 ? more : 0.2;
        m = state.units[static_cast<std::size_t>(m)].former;
        add(s, kAttachAlone, base + shared, member, m, implied, list);
      }
    };
    if (by_each_other || stacked) {
      with_list(gain + (several(state, member) ? 1 : 0), kNobody, false);
      continue;
    }
    if (group) {
      NounPhrase room;
      room.kind = NounKind::kRoom;
      const double fits = sense_.of_place(senses, noun_of(state, member), room);
      const bool many = says(senses, RelationType::kRow) || says(senses, RelationType::kGrid) || says(senses, RelationType::kColumn);
      // "a table with a laptop in the center": of the table.
      const Referent host = host_of(state, member);
      const bool lies = says(senses, RelationType::kCenterOfRoom) && mount_of(noun_of(state, member)) == Mount::kSurface;
      // "a desk with a chair at the back": behind the desk.
      const bool end = says(senses, RelationType::kInRegion) && mount_of(noun_of(state, member)) == Mount::kFloor &&
                       is_thing(state, host) && place.joiner == Joiner::kNone &&
                       std::any_of(senses.begin(), senses.end(),
                                   [](const PhraseSense& sense) { return sense.region == "back" || sense.region == "front"; });
      if (end) add(s, kAttachAlone, gain + 1.5, member, member, host);
      if (lies && is_thing(state, host)) add(s, kAttachAlone, gain + 1, member, member, host);
      for (const Candidate& meant : lies&& host == kNobody && state.fronted.empty() ? carriers(state, member) : std::vector<Candidate>{})
        add(s, kAttachAlone, gain + meant.score, member, member, meant.referent);
      if (lies && !state.fronted.empty()) add(s, kAttachAlone, gain + 1, member, member, state.fronted.front() + 1);
      with_list(gain + fits + (many ? (several(state, member) ? 1.0 : -1.0) : 0), kNobody, false);
      continue;
    }
    const bool plural = says(senses, RelationType::kBetween);
    NounPhrase whom = them;
    whom.plural = plural;
    // "a laptop on the right side of the desk and a mug on the left side": of the desk as well.
    if (const Referent host = side_host(state, u, senses); host != kNobody && !same(state, host, member))
      with_list(gain + weight::kSameSide, host, false);
    const auto habit = [&](Referent by) { return place.joiner == Joiner::kNone ? habit_score(state, u, member, by, senses) : 0; };
    for (const Candidate& meant : antecedents(state, member, &senses, &whom))
      with_list(gain + meant.score + habit(meant.referent), meant.referent, meant.list);
  }
  const bool of_no_thing = place.joiner == Joiner::kNone && speaks_of_no_thing(state);
  if (of_no_thing || actions_.empty() || actions_.back().state != s) add(s, kPass, of_no_thing ? 1.5 : -2);
  if (place.joiner == Joiner::kNone) return;
  // "to its right there is a plant, to its left a table"
  const bool noun_next = follows(u, UnitKind::kNoun) && chunk(u + 1).noun.kind == NounKind::kObject;
  const bool verb_next = (is(u + 1, UnitKind::kVerb) || is(u + 1, UnitKind::kOpen)) && is(u + 2, UnitKind::kNoun) &&
                         chunk(u + 2).noun.kind == NounKind::kObject;
  const bool comma_next =
      is(u + 1, UnitKind::kNoun) && unit(u + 1).joiner == Joiner::kComma && is_new_thing(chunk(u + 1).noun) && place.clause;
  if (noun_next || verb_next || comma_next) front(2.5);
}

void Decoder::have_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const std::string& how = word(u);
  // "Flank the bed with two nightstands": the place's own things come now.
  if (how == "with" && state.frontier.empty() && state.fronted.size() == 1 && state.fronted.front() + 2 == u &&
      chunk(state.fronted.front()).last - chunk(state.fronted.front()).first == 1 && !unit(state.fronted.front()).direct.empty()) {
    add(s, kHaveThing, 1, state.fronted.front(), -2);
    return;
  }
  if (state.frontier.empty() && state.relative < 0) {
    add(s, kHaveRoom, 0);
    return;
  }
  const bool finite = is_finite(how);
  const std::size_t before = actions_.size();
  if (state.relative < 0) {
    const int root = state.frontier.front();
    const NounKind kind = noun_of(state, root).kind;
    if (is_room_like(kind) && !is_thing(state, root)) {
      double gain = 0;
      for (const int f : state.frontier) gain += is_thing(state, f) ? -1.5 : 0;
      add(s, kHaveRoom, gain);
    }
  }
  if (finite && state.relative < 0) {
    for (std::size_t level = 0; level < state.frontier.size(); ++level) {
      const int member = state.frontier[level];
      const NounKind kind = noun_of(state, member).kind;
      if (!is_thing(state, member) && kind != NounKind::kWall && kind != NounKind::kCorner && kind != NounKind::kPart) continue;
      add(s, kHaveThing, (level == 0 ? 0.5 : -2.5) + weight::kTree * tree_.for_noun(u, member), member, member);
    }
  } else {
    attach_actions(s, u, kHaveThing);
  }
  if (actions_.size() == before) add(s, kHaveRoom, -0.5);
}

void Decoder::verb_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const bool passive = chunk(u).passive;
  const bool joined = unit(u).joiner != Joiner::kNone;
  if (state.relative >= 0) {
    add(s, kFinite, 0, state.relative, state.relative);
    return;
  }
  if (state.outer >= 0 && unit(u).joiner == Joiner::kComma) {
    add(s, kFinite, 1, state.outer, state.outer);
    return;
  }
  if (state.frontier.empty()) {
    add(s, state.fronted.empty() && !passive ? kCommand : kInvert, 0);
    return;
  }
  if (joined && !passive && is(u + 1, UnitKind::kNoun)) {
    add(s, kCommand, state.imperative ? 1 : 0.3);
    if (state.imperative) return;
  }
  // The subject: a plural verb takes all that is listed, a singular one the last.
  const int root = state.frontier.front();
  const std::string& verb = word(u);
  const bool plural = verb == "are" || verb == "were" || verb == "have" || (!verb.ends_with("s") && verb != "is" && verb != "was");
  int first = root;
  while (plural && first >= 0 && state.units[static_cast<std::size_t>(first)].former >= 0) {
    const int former = state.units[static_cast<std::size_t>(first)].former;
    const bool list_ends =
        noun_of(state, root).is_plural() && (unit(first).joiner != Joiner::kAnd || state.units[static_cast<std::size_t>(former)].placed);
    if (list_ends || (state.room_list && unit(first).joiner != Joiner::kAnd)) break;
    first = former;
  }
  add(s, kFinite, 0, root, first);
}

void Decoder::relative_actions(std::size_t s, int u) {
  const State& state = states_[s];
  int nearer = 0;
  for (std::size_t f = state.frontier.size(); f-- > 0;) {
    const int member = state.frontier[f];
    const NounKind kind = noun_of(state, member).kind;
    if (!is_thing(state, member) && kind != NounKind::kWindow && kind != NounKind::kDoor && kind != NounKind::kRoom) continue;
    const bool several_here = several(state, member);
    double gain = -0.9 * nearer++ + weight::kTree * tree_.for_noun(u, member);
    if (verb_like(u + 1)) gain += is_finite(word(u + 1)) == several_here && word(u + 1) != "hold" ? -1 : 0;
    add(s, kRelate, gain, member);
  }
  if (actions_.empty() || actions_.back().state != s) add(s, kPass, 0);
}

void Decoder::apply_predicate(State& state, const Action& action, int u) const {
  UnitReading& own = state.units[static_cast<std::size_t>(u)];
  own.after_verb = state.participle || state.verb;
  own.implied = action.meant;
  own.implied_list = action.list;
  const auto take = [&](int member) {
    own.subject = member;
    own.first_subject = action.first >= 0 ? action.first : member;
    for (int m = member; m >= 0; m = state.units[static_cast<std::size_t>(m)].former) {
      state.units[static_cast<std::size_t>(m)].placed = true;
      state.units[static_cast<std::size_t>(m)].many |= is(u, UnitKind::kPlace) && unit(u).each;
      if (m == own.first_subject) break;
    }
    cut_frontier(state, member);
    state.relative = -1;
  };
  switch (action.kind) {
    case kFront: {
      const int outer = action.meant >= 0 && !state.frontier.empty() ? state.frontier.front() : -1;
      if (action.meant >= 0 || unit(u).joiner != Joiner::kNone) {
        if (!state.frontier.empty()) begin_clause(state);
        state.outer = outer;
      }
      own.fronted = true;
      own.inverse = unit(u).direct.empty();
      state.fronted.push_back(u);
      state.waiting = u;
      break;
    }
    case kFrontAlone:
      if (!state.frontier.empty()) begin_clause(state);
      own.fronted = own.alone = true;
      state.fronted.push_back(u);
      if (own.implied != kNobody) state.it = own.implied;
      break;
    case kAttach:
    case kAttachInverse:
      if (action.unit >= 0) take(action.unit);
      own.inverse = action.kind == kAttachInverse;
      state.waiting = u;
      break;
    case kAttachAlone:
      take(action.unit);
      own.alone = true;
      state.place = u;
      break;
    case kHaveRoom:
      begin_clause(state);
      own.of_room = true;
      state.waiting = u;
      state.room_list = true;
      break;
    case kHaveThing:
      state.waiting = u;
      if (action.first == -2) {
        UnitReading& arranging = state.units[static_cast<std::size_t>(action.unit)];
        arranging.fronted = false;
        arranging.inverse = true;
        arranging.subject = action.unit + 1;
        own.subject = kNobody;
        state.waiting = action.unit;
        state.fronted.clear();
        state.frontier = {action.unit + 1};
        break;
      }
      take(action.unit);
      if (is_finite(word(u))) state.verb = true;
      break;
    case kCommand:
      if (!state.frontier.empty() || is(u, UnitKind::kPlace)) begin_clause(state);
      state.imperative = true;
      if (is(u, UnitKind::kVerb)) state.inverted = u;
      break;
    case kInvert: state.inverted = u; break;
    case kFinite: {
      if (action.unit == state.outer) {
        begin_clause(state);
        state.outer = -1;
        state.frontier = {action.unit};
      }
      own.subject = action.unit;
      own.first_subject = action.first;
      if (state.relative >= 0) {
        cut_frontier(state, action.unit);
        if (!is(u + 1, UnitKind::kPlace)) state.relative = -1;
        break;
      }
      if (state.where >= 0 && !is(u + 1, UnitKind::kPlace)) own.implied = state.where;
      cut_frontier(state, action.unit);
      state.first_subject = action.first;
      state.verb = true;
      state.participle = true;
      state.imperative = false;
      break;
    }
    case kRelate:
      cut_frontier(state, action.unit);
      state.relative = action.unit;
      break;
    default: break;
  }
}

}  // namespace layoutbox::offline
