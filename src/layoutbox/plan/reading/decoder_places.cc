// What a place is said of.
#include <algorithm>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/decoder.h"
#include "layoutbox/plan/reading/weights.h"
#include "layoutbox/plan/room/room_reader.h"

namespace layoutbox::offline {

namespace {

bool is_known_noun(const NounPhrase& noun) {
  return noun.kind != NounKind::kObject || noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kEach ||
         noun.determiner == Determiner::kPossessive || noun.determiner == Determiner::kBoth;
}

}  // namespace

// A place that is a finite verb: "faces", "hang on".
bool Decoder::finite_place(int u) const { return is(u, UnitKind::kPlace) && (is_finite(word(u)) || lexicon_.is_place_verb(word(u))); }

// What was named last is no thing ("with storage …"), and what follows is said of that.
bool Decoder::speaks_of_no_thing(const State& state) const {
  const int last = state.frontier.back();
  const NounKind kind = noun_of(state, last).kind;
  return read_as(state, last).role == NounRole::kContent && (kind == NounKind::kAbstract || kind == NounKind::kRoom) &&
         host_of(state, last) != kNobody;
}

// Whether no thing was named after the one at that level of the frontier.
bool Decoder::nothing_nearer(const State& state, std::size_t level) const {
  for (std::size_t f = level + 1; f < state.frontier.size(); ++f) {
    if (is_thing(state, state.frontier[f])) return false;
  }
  return true;
}

void Decoder::attach_actions(std::size_t s, int u, Kind kind) {
  const State& state = states_[s];
  for (std::size_t level = state.frontier.size(); level-- > 0;) attach_to(s, u, kind, level);
  // "with space below the window": of nothing that is a thing.
  const bool of_no_thing = !state.frontier.empty() && unit(u).joiner == Joiner::kNone && speaks_of_no_thing(state);
  if (of_no_thing || actions_.empty() || actions_.back().state != s) add(s, kind, of_no_thing ? weight::kNoThing : -1);
}

bool Decoder::says_around(int u) const {
  return says(unit(u).inverse, RelationType::kAround) || says(unit(u).inverse, RelationType::kSurround);
}

// "a desk with a setup of …": what the setup has, the desk has. "supported by turned legs, surrounded by chairs": the table is.
Referent Decoder::whole_of(const State& state, int u, Kind kind, int member) const {
  const NounKind place = noun_of(state, member).kind;
  const int predicate = read_as(state, member).predicate;
  if (place == NounKind::kPart && kind == kAttachInverse && says_around(u) && predicate >= 0) return read_as(state, predicate).subject;
  return place == NounKind::kAbstract && kind == kHaveThing ? host_of(state, member) : kNobody;
}

// "a stool next to the mirror with a candle on it": what carries nothing is not meant; "… next to the tub with a candle and a book on it":
// said of what is new here.
double Decoder::host_of_top_score(const State& state, int u, int member) const {
  if (!follows(u, UnitKind::kNoun) || !lists_on_it(u + 1)) return 0;
  const bool known = is_known(state, member) && read_as(state, member).role == NounRole::kReference;
  const bool soft = sense_.on_soft(noun_of(state, member), chunk(u + 1).noun);  // "a chaise has a table next to it, with a cup on top"
  return (has_top_for(noun_of(state, member), chunk(u + 1).noun) ? 0 : weight::kCannotCarry) + (known ? weight::kKnownHost : 0) +
         (soft ? weight::kSoftHost : 0);
}

void Decoder::attach_to(std::size_t s, int u, Kind kind, std::size_t level) {
  const State& state = states_[s];
  const bool inverse = kind == kAttachInverse || kind == kHaveThing;
  const int member = state.frontier[level];
  const NounKind place = noun_of(state, member).kind;
  const bool opening = place == NounKind::kDoor || place == NounKind::kWindow;
  const Referent owner = whole_of(state, u, kind, member);
  if (owner >= 0 && is_thing(state, owner)) {
    add(s, kind, attach_score(state, u, static_cast<int>(level), true), owner,
        read_as(state, read_as(state, member).predicate).first_subject);
    return;
  }
  // "the sofa and the seating arrangement face the wall"
  if (level == 0 && state.verb && state.first_subject >= 0 && !is_thing(state, member) && is_thing(state, state.first_subject) &&
      kind == kAttach) {
    add(s, kind, 0, member, state.first_subject);
    return;
  }
  if (place == NounKind::kPart && kind == kAttachInverse && says_around(u) && noun_of(state, member).wall_word.empty()) return;
  const bool part_of_room = (place == NounKind::kWall && noun_of(state, member).name != kWallsAndFloor) || opening ||
                            place == NounKind::kCorner || place == NounKind::kCeiling || place == NounKind::kPart ||
                            place == NounKind::kCenter ||
                            (place == NounKind::kRoom && kind == kAttachInverse && says(unit(u).inverse, RelationType::kCenterOfRoom));
  // "a reading corner by the window with …": a part of the room that has things.
  const bool zone = kind == kAttach && (place == NounKind::kCorner || place == NounKind::kAbstract) &&
                    is_zone(noun_of(state, member).head) && read_as(state, member).role != NounRole::kReference &&
                    nothing_nearer(state, level);
  // "under the window in the right wall": which one
  const bool in_wall = opening && member + 1 == u && unit(u).joiner == Joiner::kNone && word(u) == "in" && follows(u, UnitKind::kNoun) &&
                       chunk(u + 1).noun.kind == NounKind::kWall;
  if (in_wall) {
    add(s, kind, weight::kOpeningInWall, member, member);
    return;
  }
  if (!is_thing(state, member) && !(opening && level == 0) && !(inverse && part_of_room) && !zone) return;
  if (state.relative >= 0 && member != state.relative) return;
  double gain = state.relative >= 0 ? 0 : attach_score(state, u, static_cast<int>(level), inverse);
  if (kind == kHaveThing) gain += host_of_top_score(state, u, member);
  // "in a row along the wall": of all that the place before was said of.
  const UnitReading* before = state.place >= 0 ? &read_as(state, state.place) : nullptr;
  if (kind == kAttach && before != nullptr && !before->fronted && before->subject == member && before->first_subject != member &&
      unit(u).joiner == Joiner::kNone) {
    add(s, kind, gain, member, before->first_subject);
    return;
  }
  if (level == 0 && state.verb && state.first_subject >= 0) {
    add(s, kind, gain, member, state.first_subject);
    return;
  }
  // "a vase, a jar and a candle occupy the mantel": a plural verb that is a place.
  if (kind == kAttach && level == 0 && lexicon_.is_place_verb(word(u)) && unit(u).joiner == Joiner::kNone &&
      !noun_of(state, member).is_plural()) {
    if (const int first = first_of_plural(state, member); first != member) {
      add(s, kind, gain, member, first);
      return;
    }
  }
  add(s, kind, gain, member, member);
  if (inverse && !(word(u).ends_with("ed") || word(u).ends_with("ing"))) return;
  double shared = 0;
  for (int m = member; kind != kAttachInverse && m >= 0;) {
    const double more = share_score(state, m, u);
    if (more < -5) break;
    shared += shared == 0 ? more : 0.2;
    m = read_as(state, m).former;
    add(s, kind, gain + shared, member, m);
  }
}

void Decoder::place_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const Unit& place = unit(u);
  const bool noun_follows = follows(u, UnitKind::kNoun);
  const bool joined = place.joiner != Joiner::kNone;
  // "a cabinet bearing on its top a lamp"
  if (!noun_follows && !place.inverse.empty() && !state.frontier.empty() && is(u + 1, UnitKind::kPlace) && says_its(u + 1) &&
      unit(u + 1).joiner == Joiner::kNone && follows(u + 1, UnitKind::kNoun)) {
    attach_actions(s, u, kAttachInverse);
    return;
  }
  if (!noun_follows || (place.direct.empty() && place.inverse.empty())) {
    alone_actions(s, u);
    return;
  }
  const NounPhrase& noun = chunk(u + 1).noun;
  const std::string& last = document_.tokens[chunk(u + 1).last - 1].text;
  // "a desk, on which a computer sits": a clause of its own whose place comes first.
  if ((noun.kind == NounKind::kPronoun || noun.subset) && (last == "which" || last == "whom") && !place.direct.empty()) {
    relative_place_actions(s, u);
    if (!actions_.empty() && actions_.back().state == s) return;
  }
  if (chunk(u).gap && !state.frontier.empty()) {  // "80 cm between the bed and the desk": of nothing else
    add(s, kAttach, 0);
    return;
  }
  // "a room centered on a table": what a room is said to be about is in it.
  const bool about_room = says(place.inverse, RelationType::kCenterOfRoom) && !state.frontier.empty() &&
                          noun_of(state, state.frontier.back()).kind == NounKind::kRoom;
  const bool inverse = place.direct.empty() || about_room;
  if (state.frontier.empty()) {
    opening_place_actions(s, u);
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
  first_place_actions(s, u);
}

// Whom the last "which" of the sentence spoke of.
Referent Decoder::meant_by_which_before(const State& state, int u) const {
  for (int p = u; p-- > 0;) {
    if (is(p, UnitKind::kPlace) && is(p + 1, UnitKind::kNoun) && chunk(p + 1).noun.head == "which" && read_as(state, p).fronted)
      return read_as(state, p).implied;
  }
  return kNobody;
}

// "a desk, on which a computer sits": of which of those before.
void Decoder::relative_place_actions(std::size_t s, int u) {
  const State& state = states_[s];
  int nearer = 0;
  // "a table, at which two chairs stand and on which a lamp stands"
  const bool again = unit(u).joiner == Joiner::kAnd || unit(u).joiner == Joiner::kCommaAnd;
  const Referent before = again ? meant_by_which_before(state, u) : kNobody;
  if (before >= 0) add(s, kFront, weight::kSameWhich, before, -1, before);
  // "Above the mantel, on which three candlesticks stand, hangs a mirror"
  const int by = state.frontier.empty() && state.fronted.size() == 1 && unit(u).joiner == Joiner::kComma ? state.fronted.front() + 1 : -1;
  if (by >= 0 && !read_as(state, by - 1).alone && is_thing(state, by)) add(s, kFront, 1, by, -1, by);
  for (std::size_t f = state.frontier.size(); f-- > 0;) {
    const NounKind kind = noun_of(state, state.frontier[f]).kind;
    if (state.frontier[f] == before) continue;
    // "a fireplace against the wall, above which a painting hangs": nothing is over a wall
    const bool at_wall = one_of(word(u), {"on", "against", "along", "at", "upon", "in"});
    // "a bench along the wall, on which jars stand": the bench
    const bool of_thing = unit(u).joiner == Joiner::kComma && is_thing(state, state.frontier.front());
    const double sense = kind != NounKind::kWall ? 0 : !at_wall ? weight::kNoReference : of_thing ? weight::kNotBeside : 0;
    if (is_thing(state, state.frontier[f]) || kind == NounKind::kWindow || kind == NounKind::kDoor || kind == NounKind::kWall)
      add(s, kFront, sense - 0.9 * nearer++ + weight::kTree * tree_.for_noun(u, state.frontier[f]), state.frontier[f], -1,
          state.frontier[f]);
  }
}

// A clause begins with it.
void Decoder::opening_place_actions(std::size_t s, int u) {
  const Unit& place = unit(u);
  // "To its left a lamp": the noun is the thing.
  const bool subject = verb_like(u + 2) && unit(u + 2).joiner == Joiner::kNone;
  if (!place.alone.empty() && is_new_thing(chunk(u + 1).noun)) {
    const std::size_t before = actions_.size();
    alone_actions(s, u);
    for (std::size_t a = before; a < actions_.size(); ++a) actions_[a].score += subject ? 2.5 : 0;
  }
  // "Line the sofa along the wall": a command.
  const bool command =
      !place.direct.empty() && chunk(u).last - chunk(u).first == 1 && word(u) == "line" && follows(u + 1, UnitKind::kPlace);
  if (command) add(s, kCommand, 1);
  add(s, kFront, 0);
  // "On a chest across from the bed a lamp": the chest is there.
  const State& state = states_[s];
  if (state.fronted.empty() || state.waiting >= 0 || place.joiner != Joiner::kNone || place.direct.empty()) return;
  const int carrier = state.fronted.back() + 1;
  // "From a rail suspended from the ceiling over the island": both places are the rail's.
  const bool goes_on = is(u - 2, UnitKind::kPlace) && read_as(state, u - 2).subject == carrier;
  if ((carrier + 1 != u && !goes_on) || !is_thing(state, carrier) || speaks_of_others(chunk(carrier).noun)) return;
  const NounPhrase &noun = chunk(carrier).noun, &by = chunk(u + 1).noun;
  const bool carried = says(place.direct, RelationType::kOn) && sense_.carries(by, noun);  // "in the bowl on the table five lemons"
  const bool held = mount_of(noun) != Mount::kSurface && (by.kind == NounKind::kWall || by.kind == NounKind::kCeiling);
  if (mount_of(noun) != Mount::kFloor && !carried && !held && !goes_on) return;
  const double known = known_[static_cast<std::size_t>(carrier)] ? weight::kKnownSubject : weight::kNewCarrier;
  const double sense = sense_.of_place(place.direct, noun, by);
  add(s, kAttach, known + (chunk(u).hang || goes_on ? std::max(sense, weight::kUsual) : sense), carrier, carrier);
}

// A thing is brought in there, be it with "the": "on the wall the tv".
bool Decoder::is_fresh(int u) const {
  const NounPhrase& noun = chunk(u).noun;
  const bool definite = noun.determiner == Determiner::kDefinite || noun.determiner == Determiner::kPossessive;
  const bool opening = noun.kind == NounKind::kDoor || noun.kind == NounKind::kWindow;
  return is_new_thing(noun) || (opening && (definite || noun.determiner == Determiner::kIndefinite)) ||
         (noun.kind == NounKind::kObject && definite && !known_[static_cast<std::size_t>(u)]);
}

// "… and, beside the lamp, books"
bool Decoder::is_bare_after_comma(int u) const {
  const NounPhrase& noun = chunk(u).noun;
  return noun.kind == NounKind::kObject && noun.determiner == Determiner::kNone && noun.plural && noun.first > 0 &&
         document_.tokens[noun.first - 1].text == ",";
}

// After a comma or "and" it may as well come before its own thing.
void Decoder::first_place_actions(std::size_t s, int u) {
  const State& state = states_[s];
  const Unit& place = unit(u);
  const NounPhrase& noun = chunk(u + 1).noun;
  // "…, in front of the sofa is a table": the place comes first.
  int after = u + 2;
  const bool between = says(place.direct, RelationType::kBetween);  // "… and between it and the bed stands a cabinet"
  if (between && is(after, UnitKind::kNoun) && unit(after).joiner == Joiner::kAnd && is_known_noun(chunk(after).noun)) ++after;
  while (is(after, UnitKind::kPlace) && unit(after).joiner == Joiner::kNone && follows(after, UnitKind::kNoun)) after += 2;
  // "… and near it, against the wall, a sideboard"
  const int last = past_places(after);
  const bool begins = place.joiner == Joiner::kAnd || place.joiner == Joiner::kCommaAnd || place.clause || goes_on_in_turn(state, u);
  const bool listed = last > after && begins && is(last, UnitKind::kNoun) && unit(last).joiner == Joiner::kComma && is_fresh(last);
  const bool verb_last = last > after && begins && brings_by_verb(last);  // "… are a stall and a rack"
  if (listed || verb_last) after = last;
  if (is(after, UnitKind::kPlace) && says(unit(after).alone, RelationType::kRow)) ++after;  // "on it, from left to right, stand a jar …"
  double pattern = -4;
  const bool known = is_known_noun(noun) || known_[static_cast<std::size_t>(u + 1)];
  // "… and on a low shelf a statue": of a thing that comes right after it, even where the shelf is new.
  if (is(after, UnitKind::kNoun) && unit(after).joiner == Joiner::kNone && (is_fresh(after) || (begins && is_bare_after_comma(after))))
    pattern = known ? 3 : 2;
  // "above the mantel hung a map"
  const bool follows_at_once = verb_last || !is(after, UnitKind::kParticiple) || unit(after).joiner == Joiner::kNone;
  if (brings_by_verb(after) && follows_at_once) pattern = 2.5;
  if (is(after, UnitKind::kNoun) && unit(after).joiner == Joiner::kComma && (place.joiner != Joiner::kComma || begins) &&
      is_new_thing(chunk(after).noun))
    pattern = listed || is_subject(after) ? 2.5 : 1.2;  // "… and in the middle, cleared for play, a rug is spread"
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

}  // namespace layoutbox::offline
