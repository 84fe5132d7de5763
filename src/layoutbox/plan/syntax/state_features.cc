#include <algorithm>

#include "layoutbox/plan/syntax/templates.h"

namespace layoutbox::syntax {
namespace {

// Every role has all facets; the atoms of a state come in the order of roles.
enum Role : Atom {
#include "layoutbox/plan/syntax/state_roles.inc"
};
constexpr Atom kRoles = kFirstR + 1;
enum Facet : Atom { kWord, kTag, kGroup, kCoarse, kSense, kLabel };
constexpr Atom kFacets = 6;

constexpr Atom at(Role role, Facet facet) { return static_cast<Atom>(static_cast<Atom>(role) * kFacets + static_cast<Atom>(facet)); }

enum StateAtom : Atom {
  kFirstStateAtom = kRoles * kFacets - 1,
#include "layoutbox/plan/syntax/state_atoms.inc"
  kAtoms
};

using Atoms = std::array<std::uint64_t, kAtoms>;

std::uint64_t sense_of(const Word& word, std::uint8_t tag) {
  if (is_noun(tag)) return word.info.noun_sense() + 32U;
  const Tag t{tag};
  if (is_finite(tag) || t == Tag::kVBG || t == Tag::kVBN) return word.info.verb_sense() + 64U;
  return 1;
}

void fill_role(const TaggedSentence& sentence, const ParserState& state, Role role, int place, Atoms& atoms) {
  std::uint64_t* facets = atoms.data() + at(role, kWord);
  if (place < 0 || place >= sentence.size()) {
    std::fill_n(facets, kFacets, place < 0 ? kNothing : kAfter);
    return;
  }
  const auto i = static_cast<std::size_t>(place);
  const Word& word = sentence.words[i];
  facets[kWord] = word.key;
  facets[kTag] = sentence.tags[i] + 16U;
  facets[kGroup] = word.info.group() != 0 ? word.info.group() + 4096U : word.suffix3;
  facets[kCoarse] = word.info.group() != 0 ? word.info.coarse_group() + 8192U : word.suffix2;
  facets[kSense] = sense_of(word, sentence.tags[i]);
  facets[kLabel] = state.head_of(place) >= 0 ? static_cast<std::uint64_t>(state.arc_of(place)) + 16U : kNothing;
}

std::uint64_t distance(int from, int to) {
  const int d = to - from;
  if (d <= 4) return static_cast<std::uint64_t>(std::max(d, 0));
  return d <= 6 ? 5 : d <= 9 ? 6 : d <= 15 ? 7 : 8;
}

int outer(const ParserState& state, int place, bool left) {
  if (place < 0) return -1;
  return (left ? state.left(place) : state.right(place)).outer;
}
int inner(const ParserState& state, int place, bool left) {
  if (place < 0) return -1;
  return (left ? state.left(place) : state.right(place)).inner;
}
ParserState::Children children(const ParserState& state, int place, bool left) {
  return place < 0 ? ParserState::Children{} : left ? state.left(place) : state.right(place);
}

// The preposition that hangs on a word last: the same one tells parallel members of a list.
int preposition_child(const ParserState& state, int place) {
  const int child = outer(state, place, false);
  return child >= 0 && state.arc_of(child) == Arc::kPrep ? child : -1;
}

void fill_counts(const TaggedSentence& sentence, const ParserState& state, Atoms& atoms) {
  const int s0 = state.top(0), s1 = state.top(1), s2 = state.top(2), b0 = state.next();
  const auto count = [](int n) { return static_cast<std::uint64_t>(std::min(n, 3)); };
  atoms[kSDist] = s1 < 0 ? 9 : distance(s1, s0);
  atoms[kBDist] = s0 < 0 ? 9 : distance(s0, b0);
  const auto s0l = children(state, s0, true), s0r = children(state, s0, false), s1r = children(state, s1, false);
  const auto b0l = children(state, b0, true);
  atoms[kS0Lc] = count(s0l.count);
  atoms[kS0Rc] = count(s0r.count);
  atoms[kS1Rc] = count(s1r.count);
  atoms[kB0Lc] = count(b0l.count);
  atoms[kS0Lm] = s0l.labels;
  atoms[kS0Rm] = s0r.labels;
  atoms[kS1Lm] = children(state, s1, true).labels;
  atoms[kS1Rm] = s1r.labels;
  atoms[kB0Lm] = b0l.labels;
  atoms[kS2Rm] = children(state, s2, false).labels;
  atoms[kDepth] = count(state.depth());
  const bool both = s0 >= 0 && s1 >= 0;
  atoms[kSameTag] = both && atoms[at(kS0R, kTag)] == atoms[at(kS1R, kTag)] ? 1 : 0;
  atoms[kSameKind] = both && atoms[at(kS0R, kSense)] == atoms[at(kS1R, kSense)] ? 1 : 0;
  const int p0 = preposition_child(state, s0), p1 = preposition_child(state, s1);
  atoms[kSamePrep] =
      p0 >= 0 && p1 >= 0 ? 1 + (sentence.words[static_cast<std::size_t>(p0)].key == sentence.words[static_cast<std::size_t>(p1)].key) : 0;
}

void fill_ahead(const TaggedSentence& sentence, const ParserState& state, Atoms& atoms) {
  const auto b0 = static_cast<std::size_t>(state.next());
  const int n = sentence.size();
  const int noun = sentence.next_noun[b0], verb = sentence.next_verb[b0], pause = sentence.next_break[b0];
  fill_role(sentence, state, kNounAhead, noun, atoms);
  fill_role(sentence, state, kVerbAhead, verb, atoms);
  fill_role(sentence, state, kPostNoun, sentence.after_noun[b0], atoms);
  atoms[kNounGap] = noun == n ? 9 : distance(state.next(), noun);
  atoms[kVerbGap] = verb == n ? 9 : distance(state.next(), verb);
  atoms[kBreakGap] = pause == n ? 9 : distance(state.next(), pause);
  atoms[kBreakBeforeVerb] = verb == n ? 2 : pause < verb ? 1 : 0;
  // Whether a verb waits on the stack below the top: near its top only, so that time stays linear.
  std::uint64_t below = 0;
  for (int depth = 1; depth < std::min(state.depth(), 8); ++depth) {
    const std::uint8_t tag = sentence.tags[static_cast<std::size_t>(state.top(depth))];
    if (is_finite(tag) && below < 2) ++below;
  }
  atoms[kVerbBelow] = below;
}

void fill_atoms(const TaggedSentence& sentence, const ParserState& state, Atoms& atoms) {
  const int s0 = state.top(0), s1 = state.top(1), b0 = state.next(), n = sentence.size();
  const auto fill = [&](Role role, int place) { fill_role(sentence, state, role, place, atoms); };
  fill(kS0R, s0);
  fill(kS1R, s1);
  fill(kS2R, state.top(2));
  fill(kS3R, state.top(3));
  fill(kB0R, b0);
  fill(kB1R, b0 + 1);
  fill(kB2R, b0 + 2);
  fill(kB3R, b0 + 3);
  fill(kS0L, outer(state, s0, true));
  fill(kS0Li, inner(state, s0, true));
  fill(kS0Ro, outer(state, s0, false));
  fill(kS0Ri, inner(state, s0, false));
  fill(kS1L, outer(state, s1, true));
  fill(kS1Ro, outer(state, s1, false));
  fill(kS1Ri, inner(state, s1, false));
  fill(kB0L, outer(state, b0, true));
  fill(kB0Li, inner(state, b0, true));
  fill(kS0RoR, outer(state, outer(state, s0, false), false));
  fill(kS0RoL, outer(state, outer(state, s0, false), true));
  fill(kS1RoR, outer(state, outer(state, s1, false), false));
  fill(kS1RoL, outer(state, outer(state, s1, false), true));
  fill(kBeforeB, b0 - 1);
  fill(kAfterS, s0 < 0 ? -1 : std::min(s0 + 1, n));
  fill(kBeforeS, s0 - 1);
  fill(kAfterS1, s1 < 0 ? -1 : s1 + 1);
  fill(kFirstR, n > 0 ? 0 : -1);
  fill_counts(sentence, state, atoms);
  fill_ahead(sentence, state, atoms);
}

constexpr Atom w(Role role) { return at(role, kWord); }
constexpr Atom t(Role role) { return at(role, kTag); }
constexpr Atom g(Role role) { return at(role, kGroup); }
constexpr Atom c(Role role) { return at(role, kCoarse); }
constexpr Atom k(Role role) { return at(role, kSense); }
constexpr Atom l(Role role) { return at(role, kLabel); }

constexpr std::array kStepTemplates = {
#include "layoutbox/plan/syntax/step_templates.inc"
};

constexpr std::array kLabelTemplates = {
#include "layoutbox/plan/syntax/label_templates.inc"
};

}  // namespace

void step_features(const TaggedSentence& sentence, const ParserState& state, Features& features) {
  Atoms atoms{};
  fill_atoms(sentence, state, atoms);
  combine(atoms, kStepTemplates, 0x89abcdef, features);
}

void label_features(const TaggedSentence& sentence, const ParserState& state, ParserStep step, Features& features) {
  // The head plays the part of the second word on the stack, whichever side it is on.
  Atoms atoms{};
  const int child = state.dependent(step), above = state.head(step);
  const auto fill = [&](Role role, int place) { fill_role(sentence, state, role, place, atoms); };
  fill(kS0R, child);
  fill(kS1R, above);
  fill(kB0R, step == ParserStep::kLeft ? state.top(1) : state.next());
  fill(kS0L, outer(state, child, true));
  fill(kS0Ro, outer(state, child, false));
  fill(kS1L, outer(state, above, true));
  fill(kS1Ro, outer(state, above, false));
  fill(kAfterS, child + 1);
  fill(kBeforeS, child - 1);
  fill(kAfterS1, above + 1);
  fill(kFirstR, 0);
  atoms[kDirection] = static_cast<std::uint64_t>(step);
  atoms[kSDist] = step == ParserStep::kLeft ? distance(child, above) : distance(above, child);
  atoms[kS0Lm] = state.left(child).labels;
  atoms[kS0Rm] = state.right(child).labels;
  atoms[kS1Lm] = state.left(above).labels;
  atoms[kS1Rm] = state.right(above).labels;
  combine(atoms, kLabelTemplates, 0xfedcba98, features);
}

}  // namespace layoutbox::syntax
