// How clauses turn: places that come before their thing, and verbs of which the object came before.
#include "layoutbox/plan/reading/decoder.h"

namespace layoutbox::offline {

// "a cabinet holding on its top a lamp": where on itself a thing has what comes next.
bool Decoder::is_own_top(const State& state, int u) const {
  const bool own = says_its(u) || document_.tokens[chunk(u).last - 1].text == "it";
  return own && u > 0 && state.waiting == u - 1 && unit(u).joiner == Joiner::kNone && follows(u, UnitKind::kNoun);
}

// "a television, which two speakers flank", "… that a lamp and a clock flank": the first of those that a relative clause about another
// thing says it of; −1: it ends in no such verb.
int Decoder::doer_of_relative(const State& state, int u) const {
  if (state.told < 0 || unit(u).direct.empty() || unit(u).joiner != Joiner::kNone || !finite_place(u)) return -1;
  int doer = u - 1;
  while (is(doer, UnitKind::kNoun) && is(doer - 1, UnitKind::kNoun) && read_as(state, doer).former == doer - 1) --doer;
  const bool clause = is_thing(state, doer) && is(doer - 1, UnitKind::kRelative) && is_thing(state, state.told);
  return clause ? doer : -1;
}

// The unit after the places, each between commas, that begin there: "…, on the wall, …".
int Decoder::past_places(int u) const {
  while (is(u, UnitKind::kPlace) && unit(u).joiner == Joiner::kComma && follows(u, UnitKind::kNoun)) u += 2;
  return u;
}

// A verb and its thing, which places may stand before: "are three lockers", "hung a crucifix".
bool Decoder::brings_by_verb(int u) const {
  const bool thing = is(u + 1, UnitKind::kNoun) && chunk(u + 1).noun.kind == NounKind::kObject;
  if (is(u, UnitKind::kVerb) || is(u, UnitKind::kOpen)) return thing;
  return thing && is(u, UnitKind::kParticiple) && unit(u + 1).joiner == Joiner::kNone && is_fresh(u + 1);
}

// "to its left, a stand, to its right, a locker": as the place before it came before its thing.
bool Decoder::goes_on_in_turn(const State& state, int u) const {
  if (unit(u).joiner != Joiner::kComma || state.fronted.empty() || !is(u - 1, UnitKind::kNoun)) return false;
  const UnitReading& before = read_as(state, state.fronted.back());
  return before.subject == u - 1 && unit(u - 1).joiner == Joiner::kComma;
}

}  // namespace layoutbox::offline
