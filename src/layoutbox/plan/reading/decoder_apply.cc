// What a choice does to the state of the reading.
#include <algorithm>
#include <utility>

#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/decoder.h"
#include "layoutbox/plan/reading/weights.h"

namespace layoutbox::offline {

void Decoder::apply(State& state, const Action& action, int u) const {
  const UnitKind kind = unit(u).kind;
  UnitReading& own = read_as(state, u);
  if (kind == UnitKind::kNoun) {
    apply_noun(state, action, u);
    return;
  }
  if (action.kind != kPass) {
    apply_predicate(state, action, u);
    return;
  }
  if (kind == UnitKind::kOpen) {
    const std::vector<int> fronted = state.fronted;
    const bool keep = state.frontier.empty();
    if (!state.frontier.empty() || unit(u).joiner != Joiner::kNone) begin_clause(state);
    if (keep) state.fronted = fronted;
  } else if (kind == UnitKind::kParticiple) {
    state.participle = true;
    own.subject = state.frontier.empty() ? kNobody : state.frontier.back();
    for (std::size_t f = state.frontier.size(); f-- > 0;) {
      const Mount mount = mount_of(noun_of(state, state.frontier[f]));
      if (!is_thing(state, state.frontier[f]) || (mount != Mount::kWall && mount != Mount::kCeiling)) continue;
      own.subject = state.frontier[f];
      break;
    }
  } else if (kind == UnitKind::kSize) {
    const auto thing = std::find_if(state.frontier.rbegin(), state.frontier.rend(), [&](int f) { return is_thing(state, f); });
    own.subject = thing != state.frontier.rend() ? *thing : before_.topic >= 0 ? referent_of_mention(before_.topic) : kNobody;
  } else if (kind == UnitKind::kAttribute && state.verb && !state.frontier.empty()) {
    own.subject = state.frontier.front();
    own.first_subject = state.first_subject;
  } else if (kind == UnitKind::kAttribute && unit(u).joiner == Joiner::kComma && !follows(u, UnitKind::kNoun) && !state.roots.empty()) {
    own.subject = state.roots.back();  // "L-shaped sofa in the corner, gray"
  } else if (kind == UnitKind::kAttribute && unit(u).joiner == Joiner::kNone &&
             (is(u - 1, UnitKind::kNoun) || is(u - 1, UnitKind::kAttribute)) && !state.frontier.empty() &&
             is_thing(state, state.frontier.back())) {
    own.subject = state.frontier.back();  // "a rug round pink in the center"
  }
}

void Decoder::apply_noun(State& state, const Action& action, int u) const {
  UnitReading& own = read_as(state, u);
  own.meant = action.meant;
  own.whole_list = action.list;
  // "another one", "a smaller one": a thing of the kind that was named last.
  if (chunk(u).noun.kind == NounKind::kMember && own.meant == kNobody && !speaks_of_others(chunk(u).noun))
    own.meant = has_place(u) && state.place >= 0 && is_thing(state, read_as(state, state.place).subject)
                    ? read_as(state, state.place).subject  // "an urn to the left of it and another to the right"
                : action.unit >= 0     ? action.unit
                : !state.roots.empty() ? state.roots.back()
                : before_.topic >= 0   ? referent_of_mention(before_.topic)
                                       : kNobody;
  switch (action.kind) {
    case kFill: apply_fill(state, u); break;
    case kElided:
      own.role = NounRole::kContent;
      own.predicate = action.unit;
      own.subject = action.first;
      state.frontier.push_back(u);
      break;
    case kNextRoot:
    case kNewRoot: apply_root(state, action, u); break;
    case kSameList: {
      cut_frontier(state, action.unit);
      const UnitReading& former = read_as(state, action.unit);
      own.role = former.role;
      own.predicate = former.predicate;
      own.former = action.unit;
      own.placed = former.role == NounRole::kContent && !is(former.predicate, UnitKind::kHave);
      if (!state.frontier.empty()) state.frontier.back() = u;
      break;
    }
    case kSpeakOf: apply_member(state, action.meant, u); break;
    default: break;
  }
  if (own.role == NounRole::kRoot || own.role == NounRole::kContent) state.participle = false;
}

// The noun at u is what the places before it waited for.
void Decoder::fill_fronted(State& state, int u) const {
  for (const int place : state.fronted) {
    UnitReading& fronted = read_as(state, place);
    if (fronted.subject == kNobody) fronted.first_subject = u;
    fronted.subject = u;
    read_as(state, u).placed = true;
  }
  if (state.inverted >= 0) read_as(state, state.inverted).subject = u;
}

// … what a place or having waited for.
void Decoder::apply_fill(State& state, int u) const {
  UnitReading& own = read_as(state, u);
  const int p = state.waiting;
  UnitReading& place = read_as(state, p);
  state.waiting = -1;
  own.predicate = p;
  if (place.of_room) {
    own.role = NounRole::kRoot;
    own.opens_clause = true;
    state.frontier = {u};
    state.roots.push_back(u);
    return;
  }
  own.role = is(p, UnitKind::kHave) || place.inverse ? NounRole::kContent : NounRole::kReference;
  if (own.role == NounRole::kReference) state.place = p;
  if (own.role == NounRole::kContent) own.placed = !is(p, UnitKind::kHave);
  if (own.meant != kNobody && (noun_of(state, u).kind == NounKind::kObject || chunk(u).noun.determiner == Determiner::kPossessive))
    state.it = own.meant;
  const bool of_its_own = place.subject < 0 || host_of(state, place.subject) == own.meant;  // "a tray with a cup on it"
  if (own.meant != kNobody && !of_its_own && chunk(u).noun.head == "it") state.by = own.meant;
  const bool of_front = state.frontier.empty() && !state.fronted.empty();  // of what the clause's place is by
  if (!place.fronted && !of_front) state.frontier.push_back(u);
}

// … one that the sentence itself is about.
void Decoder::apply_root(State& state, const Action& action, int u) const {
  UnitReading& own = read_as(state, u);
  own.role = NounRole::kRoot;
  if (action.kind == kNewRoot && !state.frontier.empty()) {
    const bool room_list = state.room_list;
    const int told = is(u - 1, UnitKind::kRelative) ? state.told : -1;  // "a television, which two speakers flank"
    begin_clause(state);
    state.room_list = room_list;
    state.told = told;
  }
  if (action.kind == kNextRoot && is_thing(state, action.unit)) own.former = action.unit;
  own.opens_clause = own.former < 0;
  fill_fronted(state, u);
  state.frontier = {u};
  state.relative = state.waiting = -1;
  state.roots.push_back(u);
}

// … one of those that were named.
void Decoder::apply_member(State& state, Referent meant, int u) const {
  read_as(state, u).role = NounRole::kMember;
  const bool after_list = !state.frontier.empty() && !verb_like(u + 1);
  if (after_list) {
    // "two tables, one with a lamp": hangs on what it speaks of.
    const auto at = std::find(state.frontier.begin(), state.frontier.end(), meant);
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
    fill_fronted(state, u);
    state.frontier = {u};
  }
  state.it = meant;
}

// A place that stands before what it is of.
void Decoder::front_place(State& state, const Action& action, int u) const {
  const int outer = action.meant >= 0 && !state.frontier.empty() ? state.frontier.front() : -1;
  if (action.meant >= 0 && state.frontier.empty()) {
    std::vector<int> waiting = std::move(state.fronted);
    begin_clause(state);
    state.outer_fronted = std::move(waiting);
  }
  if (action.meant >= 0 || unit(u).joiner != Joiner::kNone) {
    if (!state.frontier.empty()) begin_clause(state);
    state.outer = outer;
  }
  read_as(state, u).fronted = true;
  read_as(state, u).inverse = unit(u).direct.empty();
  state.fronted.push_back(u);
  state.waiting = u;
}

void Decoder::apply_predicate(State& state, const Action& action, int u) const {
  UnitReading& own = read_as(state, u);
  own.after_verb = state.participle || state.verb;
  own.implied = action.meant;
  own.implied_list = action.list;
  switch (action.kind) {
    case kFront: front_place(state, action, u); break;
    case kFrontAlone:
      if (!state.frontier.empty()) begin_clause(state);
      own.fronted = own.alone = true;
      state.fronted.push_back(u);
      if (own.implied != kNobody) state.it = own.implied;
      break;
    case kAttach:
    case kAttachInverse:
      if (action.unit >= 0) take_subject(state, action, u);
      own.inverse = action.kind == kAttachInverse;
      state.waiting = u;
      if (action.unit >= 0 && finite_place(u) && state.relative < 0) state.verb = true;  // "fills the corner"
      break;
    case kAttachAlone:
      take_subject(state, action, u);
      own.alone = true;
      if (says_its(u) && own.implied != kNobody && !own.implied_list) state.it = own.implied;  // "along its sides, and on it"
      if ((document_.tokens[chunk(u).last - 1].text == "it" || says_its(u)) && own.implied != kNobody && !own.implied_list &&
          host_of(state, action.unit) != own.implied)
        state.by = state.it = own.implied;
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
        fill_place(state, action.unit, u);
        break;
      }
      take_subject(state, action, u);
      if (is_finite(word(u))) state.verb = true;
      break;
    case kCommand:
      if (!state.frontier.empty() || is(u, UnitKind::kPlace)) begin_clause(state);
      state.imperative = true;
      if (is(u, UnitKind::kVerb)) state.inverted = u;
      break;
    case kInvert:
      if (unit(u).joiner == Joiner::kComma && !state.outer_fronted.empty()) {
        begin_clause(state);
        state.fronted = std::exchange(state.outer_fronted, {});
      }
      state.inverted = u;
      break;
    case kFinite: apply_finite(state, action, u); break;
    case kRelate:
      cut_frontier(state, action.unit);
      state.relative = state.told = action.unit;
      break;
    default: break;
  }
}

// The place (having …) at u is said of that thing, and of those of its list that share it.
void Decoder::take_subject(State& state, const Action& action, int u) const {
  UnitReading& own = read_as(state, u);
  own.subject = action.unit;
  own.first_subject = action.first >= 0 ? action.first : action.unit;
  for (int m = action.unit; m >= 0; m = read_as(state, m).former) {
    read_as(state, m).placed = true;
    read_as(state, m).many |= is(u, UnitKind::kPlace) && unit(u).each;
    if (m == own.first_subject) break;
  }
  // "a table where two chairs face each other": at the table.
  if (state.where >= 0 && action.unit != state.where && is(u, UnitKind::kPlace) && (verb_like(u) || lexicon_.is_place_verb(word(u))) &&
      own.implied == kNobody && host_of(state, action.unit) != own.implied)
    own.implied = std::exchange(state.where, -1);
  cut_frontier(state, action.unit);
  state.relative = -1;
}

// "Flank the bed with two nightstands": the having at u brings the things of the place before.
void Decoder::fill_place(State& state, int place, int u) const {
  UnitReading& arranging = read_as(state, place);
  arranging.fronted = false;
  arranging.inverse = true;
  arranging.subject = place + 1;
  read_as(state, u).subject = kNobody;
  state.waiting = place;
  state.fronted.clear();
  state.frontier = {place + 1};
}

// The clause's verb has its subject.
void Decoder::apply_finite(State& state, const Action& action, int u) const {
  UnitReading& own = read_as(state, u);
  if (action.unit == state.outer) {
    begin_clause(state);
    state.outer = -1;
    state.frontier = {action.unit};
  }
  own.subject = action.unit;
  own.first_subject = action.first;
  const bool place_follows = is(u + 1, UnitKind::kPlace);
  if (action.unit == state.told && action.unit != state.frontier.front()) state.relative = state.told;  // "which … and is laid with"
  if (state.relative >= 0) {
    cut_frontier(state, action.unit);
    if (!place_follows) state.relative = -1;
    return;
  }
  if (state.where >= 0 && !place_follows) own.implied = state.where;
  cut_frontier(state, action.unit);
  state.first_subject = action.first;
  state.verb = true;
  state.participle = true;
  state.imperative = false;
}

}  // namespace layoutbox::offline
