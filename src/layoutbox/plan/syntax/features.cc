#include "layoutbox/plan/syntax/features.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace layoutbox::syntax {
namespace {

// Atoms are small facts; a template is a set of them (at most five) whose joint values are a feature.
using Atom = std::uint8_t;
using Template = std::array<Atom, 5>;
constexpr Atom kNone = 0xff;

template <typename Atoms>
void combine(const Atoms& atoms, std::span<const Template> templates, std::uint64_t salt, Features& features) {
  features.clear();
  for (const Template& parts : templates) {
    salt += 0x9e3779b97f4a7c15ULL;
    std::uint64_t key = salt;
    for (const Atom part : parts) {
      if (part == kNone) break;
      key = (key ^ atoms[part]) * 0xff51afd7ed558ccdULL;
      key ^= key >> 32;
    }
    features.push_back(scatter(key));
  }
}

template <typename... Parts>
constexpr Template of(Parts... parts) {
  Template made{kNone, kNone, kNone, kNone, kNone};
  std::size_t i = 0;
  ((made[i++] = static_cast<Atom>(parts)), ...);
  return made;
}

// --- tags

struct Near {
  std::uint64_t key, parts, group, coarse;
};

Near near_word(const Sentence& sentence, int place) {
  if (place < 0) return {kBefore, kBefore, kBefore, kBefore};
  if (place >= sentence.size()) return {kAfter, kAfter, kAfter, kAfter};
  const Word& word = sentence.words[static_cast<std::size_t>(place)];
  // A word nobody knows: what it ends in stands for its class.
  const std::uint64_t parts = word.info.bits != 0 ? word.info.parts() + 64U : word.suffix2;
  const std::uint64_t group = word.info.group() != 0 ? word.info.group() + 4096U : word.suffix3;
  const std::uint64_t coarse = word.info.group() != 0 ? word.info.coarse_group() + 8192U : word.suffix3;
  return {word.key, parts, group, coarse};
}

enum TagAtom : Atom {
  kW0,
  kW1,
  kW2,
  kWm1,
  kWm2,  // words
  kP0,
  kP1,
  kP2,
  kP3,
  kPm1,
  kPm2,  // what they can be
  kG0,
  kG1,
  kG2,
  kGm1,  // groups
  kC0,
  kC1,
  kCm1,  // coarse groups
  kTm1,
  kTm2,
  kTm3,  // tags before
  kS2,
  kS3,
  kS4,
  kPre,
  kShape,
  kS3n,
  kS3b,
  kS2n,
  kNounSense,
  kVerbSense,
  kFirst,
  kVerbBefore,
  kNounBefore,  // whether the clause has a finite verb so far, a noun
  kAfterNoun,   // whether a determiner or number comes within the next two words
  kTagAtoms
};

constexpr std::array kTagTemplates = {
    of(kW0),
    of(kS2),
    of(kS3),
    of(kS4),
    of(kPre),
    of(kShape),
    of(kP0),
    of(kG0),
    of(kC0),
    of(kNounSense, kVerbSense),
    of(kW1),
    of(kW2),
    of(kWm1),
    of(kWm2),
    of(kP1),
    of(kPm1),
    of(kG1),
    of(kGm1),
    of(kS3n),
    of(kS3b),
    of(kTm1),
    of(kTm2, kTm1),
    of(kTm3, kTm2, kTm1),
    of(kTm1, kW0),
    of(kTm1, kP0),
    of(kTm2, kTm1, kP0),
    of(kTm1, kS2),
    of(kTm1, kS3),
    of(kTm1, kP0, kP1),
    of(kTm1, kW1),
    of(kTm1, kP1),
    of(kTm1, kP0, kW1),
    of(kTm1, kP0, kP1, kP2),
    of(kTm2, kTm1, kP0, kP1),
    of(kW0, kW1),
    of(kWm1, kW0),
    of(kWm1, kW1),
    of(kWm1, kP0),
    of(kP0, kW1),
    of(kPm1, kP0, kP1),
    of(kW0, kP1),
    of(kPm1, kW0),
    of(kP0, kP1, kP2),
    of(kW0, kP1, kP2),
    of(kPm2, kPm1, kP0),
    of(kTm1, kW0, kP1),
    of(kC0, kC1),
    of(kCm1, kC0),
    of(kTm1, kG0),
    of(kG0, kP1),
    of(kTm1, kC0, kP1),
    of(kVerbBefore, kP0),
    of(kVerbBefore, kW0),
    of(kVerbBefore, kTm1, kP0),
    of(kVerbBefore, kTm1, kP0, kP1),
    of(kVerbBefore, kNounBefore, kTm1, kS2),
    of(kVerbBefore, kTm1, kP0, kW1),
    of(kAfterNoun, kTm1, kP0),
    of(kAfterNoun, kW0),
    of(kFirst, kW0),
    of(kFirst, kP0, kP1),
    of(kP0, kP1, kP2, kP3),
    of(kVerbBefore, kTm1, kVerbSense, kP1),
    of(kTm1, kNounSense, kP1),
    of(kS2, kP1),
    of(kS2, kS2n, kTm1),
    of(kVerbBefore, kTm2, kTm1, kP0, kP1),
    of(kWm1, kS3),
    of(kTm1, kP0, kVerbSense, kC1),
};

// --- steps and labels: words of the state, by role

// Every role has all facets; the atoms of a state come in the order of roles.
enum Role : Atom {
  kS0R,
  kS1R,
  kS2R,
  kB0R,
  kB1R,
  kB2R,
  kB3R,  // stack, buffer
  kS0L,
  kS0Li,
  kS0Ro,
  kS0Ri,
  kS1L,
  kS1Ro,
  kS1Ri,
  kB0L,
  kB0Li,  // outer and inner children, left and right
  kS0RoR,
  kS1RoR,
  kS1RoL,
  kS0RoL,  // children of children
  kNounAhead,
  kVerbAhead,  // from the next word on
  kBeforeB,
  kAfterS,
  kBeforeS,
  kAfterS1,
  kFirstR,  // neighbours in the text
};
constexpr Atom kRoles = kFirstR + 1;
enum Facet : Atom { kWord, kTag, kGroup, kCoarse, kSense, kLabel };
constexpr Atom kFacets = 6;

constexpr Atom at(Role role, Facet facet) { return static_cast<Atom>(static_cast<Atom>(role) * kFacets + static_cast<Atom>(facet)); }

enum StateAtom : Atom {
  kSDist = kRoles * kFacets,
  kBDist,
  kS0Lc,
  kS0Rc,
  kS1Rc,
  kB0Lc,
  kS0Lm,
  kS0Rm,
  kS1Lm,
  kS1Rm,
  kB0Lm,
  kS2Rm,
  kSameTag,
  kSameKind,
  kSamePrep,
  kDepth,
  kVerbGap,
  kNounGap,
  kBreakGap,
  kBreakBeforeVerb,
  kVerbBelow,
  kDirection,
  kAtoms
};

using Atoms = std::array<std::uint64_t, kAtoms>;

std::uint64_t sense_of(const Word& word, std::uint8_t tag) {
  if (is_noun(tag)) return word.info.noun_sense() + 32U;
  const Tag t{tag};
  if (is_finite(tag) || t == Tag::kVBG || t == Tag::kVBN) return word.info.verb_sense() + 64U;
  return 1;
}

void fill_role(const Sentence& sentence, const State& state, Role role, int place, Atoms& atoms) {
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

int outer(const State& state, int place, bool left) {
  if (place < 0) return -1;
  return (left ? state.left(place) : state.right(place)).outer;
}
int inner(const State& state, int place, bool left) {
  if (place < 0) return -1;
  return (left ? state.left(place) : state.right(place)).inner;
}
State::Children children(const State& state, int place, bool left) {
  return place < 0 ? State::Children{} : left ? state.left(place) : state.right(place);
}

// The preposition nearest before what a noun's group begins with: "in" for "the (corner)"; what tells parallel members of a list.
int preposition_child(const State& state, int place) {
  const int child = outer(state, place, false);
  return child >= 0 && state.arc_of(child) == Arc::kPrep ? child : -1;
}

void fill_counts(const Sentence& sentence, const State& state, Atoms& atoms) {
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

void fill_ahead(const Sentence& sentence, const State& state, Atoms& atoms) {
  const auto b0 = static_cast<std::size_t>(state.next());
  const int n = sentence.size();
  const int noun = sentence.next_noun[b0], verb = sentence.next_verb[b0], pause = sentence.next_break[b0];
  fill_role(sentence, state, kNounAhead, noun, atoms);
  fill_role(sentence, state, kVerbAhead, verb, atoms);
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

void fill_atoms(const Sentence& sentence, const State& state, Atoms& atoms) {
  const int s0 = state.top(0), s1 = state.top(1), b0 = state.next(), n = sentence.size();
  const auto fill = [&](Role role, int place) { fill_role(sentence, state, role, place, atoms); };
  fill(kS0R, s0);
  fill(kS1R, s1);
  fill(kS2R, state.top(2));
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
    // one word
    of(w(kS0R), t(kS0R)),
    of(t(kS0R)),
    of(g(kS0R), t(kS0R)),
    of(w(kS1R), t(kS1R)),
    of(t(kS1R)),
    of(g(kS1R), t(kS1R)),
    of(w(kB0R), t(kB0R)),
    of(t(kB0R)),
    of(g(kB0R), t(kB0R)),
    of(w(kB1R), t(kB1R)),
    of(w(kB2R), t(kB2R)),
    of(t(kS2R)),
    of(w(kS2R), t(kS2R)),
    // two words
    of(w(kS0R), w(kB0R)),
    of(w(kS0R), t(kB0R)),
    of(t(kS0R), w(kB0R)),
    of(t(kS0R), t(kB0R)),
    of(c(kS0R), c(kB0R)),
    of(k(kS0R), k(kB0R)),
    of(w(kS1R), w(kS0R)),
    of(w(kS1R), t(kS0R)),
    of(t(kS1R), w(kS0R)),
    of(t(kS1R), t(kS0R)),
    of(c(kS1R), c(kS0R)),
    of(k(kS1R), k(kS0R)),
    of(t(kS1R), t(kB0R)),
    of(w(kS1R), w(kB0R)),
    of(t(kB0R), t(kB1R)),
    of(w(kB0R), w(kB1R)),
    of(g(kS1R), w(kS0R)),
    of(w(kS1R), g(kS0R)),
    // three and more
    of(t(kS0R), t(kB0R), t(kB1R)),
    of(t(kS0R), t(kB0R), t(kB1R), t(kB2R)),
    of(t(kS1R), t(kS0R), t(kB0R)),
    of(t(kS2R), t(kS1R), t(kS0R)),
    of(t(kS2R), t(kS1R), t(kS0R), t(kB0R)),
    of(t(kS1R), t(kS0R), t(kB0R), t(kB1R)),
    of(w(kS1R), t(kS0R), t(kB0R)),
    of(t(kS1R), w(kS0R), t(kB0R)),
    of(t(kS1R), t(kS0R), w(kB0R)),
    of(t(kS1R), w(kS0R), w(kB0R)),
    of(w(kS0R), t(kB0R), t(kB1R)),
    of(w(kS0R), w(kB0R), t(kB1R)),
    of(w(kS0R), t(kB0R), w(kB1R)),
    of(t(kS0R), w(kB0R), w(kB1R)),
    of(t(kS0R), w(kB0R), t(kB1R), t(kB2R)),
    // with children
    of(t(kS0R), t(kB0R), t(kS0L)),
    of(t(kS0R), t(kB0R), t(kS0Ro)),
    of(t(kS0R), t(kB0R), t(kB0L)),
    of(t(kS0R), t(kB0R), l(kS0Ro), t(kS1R)),
    of(t(kS1R), t(kS0R), t(kS1Ro)),
    of(t(kS1R), t(kS0R), t(kS0Ro)),
    of(t(kS1R), t(kS0R), t(kS1L)),
    of(t(kS1R), t(kS0R), t(kS0L)),
    of(t(kS1R), t(kS0R), l(kS1Ro), l(kS0Ro)),
    of(t(kS1R), t(kS0R), w(kS1Ro)),
    of(w(kS1Ro), t(kS0R), t(kB0R)),
    of(w(kS1R), w(kS0R), g(kS0Ro)),
    of(t(kS1R), w(kS0R), w(kS0Ro)),
    of(c(kS1R), w(kS0R), c(kS0Ro)),
    of(g(kS1R), w(kS0R), g(kS0Ro)),
    of(k(kS1R), w(kS0R), k(kS0Ro)),
    of(w(kS1R), w(kS0R), k(kS0Ro), t(kB0R)),
    of(t(kS1R), w(kS0R), w(kS0Ro), t(kB0R), w(kB0R)),
    of(t(kS2R), t(kS1R), w(kS0R), k(kS0Ro)),
    of(t(kS0R), w(kS0Ro), t(kB0R)),
    of(t(kS0R), w(kS0Ro), w(kB0R)),
    of(w(kS0R), w(kS0L), t(kB0R)),
    of(t(kS1R), t(kS0R), w(kS0L)),
    of(w(kS0L), t(kS0R), t(kB0R), t(kS1R)),
    of(l(kS0Ro), l(kS0Ri), t(kS0R), t(kB0R)),
    of(l(kS1Ro), l(kS1Ri), t(kS1R), t(kS0R)),
    of(t(kS1R), t(kS0R), w(kS1RoR)),
    of(t(kS0R), t(kB0R), w(kS0RoR)),
    of(w(kB0L), t(kB0R), t(kS0R)),
    of(t(kS1R), t(kS0R), kS1Rm),
    of(t(kS1R), w(kS0R), kS1Rm),
    of(t(kS0R), t(kB0R), kS0Rm),
    of(t(kS0R), w(kB0R), kS0Rm),
    of(t(kS0R), t(kB0R), kS0Lm),
    of(t(kS1R), t(kS0R), kS1Lm),
    of(t(kS1R), t(kS0R), kS0Lm, kS0Rm),
    of(t(kS0R), t(kB0R), kB0Lm),
    of(t(kS1R), t(kS0R), kS1Lm, kS1Rm),
    of(t(kS0R), kS0Lm, kS0Rm, t(kB0R), t(kS1R)),
    of(w(kS0R), kS0Rm, t(kB0R)),
    of(w(kS1R), kS1Rm, t(kS0R)),
    // distances, counts
    of(t(kS0R), t(kB0R), kBDist),
    of(t(kS1R), t(kS0R), kSDist),
    of(w(kS0R), kBDist),
    of(w(kB0R), kBDist),
    of(w(kS1R), kSDist),
    of(w(kS0R), kSDist),
    of(t(kS0R), kS0Lc, kS0Rc),
    of(t(kS1R), kS1Rc, t(kS0R)),
    of(t(kB0R), kB0Lc, t(kS0R)),
    of(t(kS0R), t(kB0R), kDepth),
    // lists
    of(kSameTag, kSameKind, t(kS0R), t(kB0R)),
    of(kSamePrep, t(kS1R), t(kS0R), t(kB0R)),
    of(kSameKind, t(kS1R), t(kS0R), w(kS1Ro)),
    of(k(kS1R), k(kS0R), w(kS1Ro), t(kB0R)),
    of(t(kS2R), t(kS1R), w(kS1Ro), t(kS0R)),
    of(k(kS2R), k(kS1R), k(kS0R), t(kB0R)),
    of(t(kS2R), w(kS1R), t(kS0R), w(kB0R)),
    of(t(kS2R), t(kS1R), kS2Rm, kS1Rm),
    of(w(kBeforeB), t(kS0R), t(kB0R)),
    of(w(kBeforeS), t(kS0R), t(kB0R)),
    of(w(kBeforeS), t(kS1R), t(kS0R), t(kB0R)),
    of(w(kAfterS), t(kS0R), t(kB0R)),
    of(w(kAfterS1), t(kS1R), t(kS0R)),
    // what is to come
    of(t(kS0R), t(kB0R), t(kVerbAhead), kBreakBeforeVerb),
    of(t(kS1R), t(kS0R), t(kVerbAhead), kBreakBeforeVerb, kVerbBelow),
    of(t(kS0R), w(kB0R), t(kVerbAhead), kBreakBeforeVerb),
    of(t(kS0R), t(kB0R), w(kVerbAhead), kVerbGap),
    of(t(kS0R), t(kB0R), kNounGap, kBreakGap),
    of(w(kB0R), g(kNounAhead)),
    of(t(kS0R), w(kB0R), k(kNounAhead)),
    of(w(kS0R), w(kB0R), g(kNounAhead)),
    of(t(kS0R), w(kB0R), w(kNounAhead)),
    of(t(kS0R), t(kB0R), kVerbBelow, t(kVerbAhead)),
    of(t(kS1R), t(kS0R), t(kB0R), kVerbBelow, t(kVerbAhead)),
    of(t(kS1R), t(kS0R), w(kB0R), t(kB1R), t(kVerbAhead)),
    of(w(kFirstR), t(kS0R), t(kB0R)),
    of(t(kFirstR), t(kS1R), t(kS0R), t(kB0R), kVerbBelow),
    of(t(kS1R), t(kS0R), t(kB0R), t(kB1R), t(kB2R)),
    of(t(kS0R), t(kB0R), t(kB1R), t(kB2R), t(kB3R)),
};

constexpr std::array kLabelTemplates = {
    of(kDirection, w(kS0R)),
    of(kDirection, t(kS0R)),
    of(kDirection, w(kS1R)),
    of(kDirection, t(kS1R)),
    of(kDirection, g(kS0R)),
    of(kDirection, t(kS1R), t(kS0R)),
    of(kDirection, w(kS1R), t(kS0R)),
    of(kDirection, t(kS1R), w(kS0R)),
    of(kDirection, w(kS1R), w(kS0R)),
    of(kDirection, k(kS1R), k(kS0R)),
    of(kDirection, c(kS1R), c(kS0R)),
    of(kDirection, g(kS1R), t(kS0R)),
    of(kDirection, t(kS1R), g(kS0R)),
    of(kDirection, t(kS1R), t(kS0R), kSDist),
    of(kDirection, t(kS1R), t(kS0R), t(kB0R)),
    of(kDirection, t(kS1R), t(kS0R), w(kB0R)),
    of(kDirection, t(kS1R), t(kS0R), kS0Lm),
    of(kDirection, t(kS1R), t(kS0R), kS0Rm),
    of(kDirection, t(kS1R), t(kS0R), kS1Lm),
    of(kDirection, t(kS1R), t(kS0R), kS1Rm),
    of(kDirection, w(kS1R), t(kS0R), kS1Rm),
    of(kDirection, t(kS1R), t(kS0R), kS0Lm, kS0Rm),
    of(kDirection, t(kS1R), t(kS0R), kS1Lm, kS1Rm),
    of(kDirection, w(kS1R), kS1Lm, t(kS0R)),
    of(kDirection, t(kS1R), t(kS0R), w(kS0L)),
    of(kDirection, t(kS1R), t(kS0R), w(kS0Ro)),
    of(kDirection, t(kS1R), t(kS0R), w(kS1Ro)),
    of(kDirection, t(kS1R), t(kS0R), w(kS1L)),
    of(kDirection, w(kS0R), w(kS0Ro)),
    of(kDirection, t(kS0R), t(kS0L), t(kS0Ro)),
    of(kDirection, t(kS1R), t(kS0R), w(kAfterS)),
    of(kDirection, t(kS1R), t(kS0R), w(kBeforeS)),
    of(kDirection, t(kS1R), t(kS0R), w(kAfterS1)),
    of(kDirection, t(kS1R), t(kS0R), t(kS1L), t(kS1Ro)),
    of(kDirection, w(kS1R), t(kS0R), w(kS1Ro)),
    of(kDirection, t(kS1R), t(kS0R), l(kS1Ro), l(kS1L)),
    of(kDirection, t(kS1R), k(kS0R), w(kS1Ro)),
    of(kDirection, t(kS1R), k(kS1R), k(kS0R), kS1Rm),
    of(kDirection, w(kS1R), w(kS0R), t(kB0R)),
    of(kDirection, t(kS1R), t(kS0R), w(kFirstR)),
};

}  // namespace

void tag_features(const Sentence& sentence, int word, Features& features) {
  std::array<std::uint64_t, kTagAtoms> atoms{};
  const Near near[6] = {near_word(sentence, word - 2), near_word(sentence, word - 1), near_word(sentence, word),
                        near_word(sentence, word + 1), near_word(sentence, word + 2), near_word(sentence, word + 3)};
  const Word& here = sentence.words[static_cast<std::size_t>(word)];
  const auto tag = [&](int place) { return place < 0 ? kBefore : sentence.tags[static_cast<std::size_t>(place)] + 16U; };
  atoms[kWm2] = near[0].key, atoms[kWm1] = near[1].key, atoms[kW0] = near[2].key, atoms[kW1] = near[3].key, atoms[kW2] = near[4].key;
  atoms[kPm2] = near[0].parts, atoms[kPm1] = near[1].parts, atoms[kP0] = near[2].parts, atoms[kP1] = near[3].parts;
  atoms[kP2] = near[4].parts, atoms[kP3] = near[5].parts;
  atoms[kGm1] = near[1].group, atoms[kG0] = near[2].group, atoms[kG1] = near[3].group, atoms[kG2] = near[4].group;
  atoms[kCm1] = near[1].coarse, atoms[kC0] = near[2].coarse, atoms[kC1] = near[3].coarse;
  atoms[kTm1] = tag(word - 1), atoms[kTm2] = tag(word - 2), atoms[kTm3] = tag(word - 3);
  atoms[kS2] = here.suffix2, atoms[kS3] = here.suffix3, atoms[kS4] = here.suffix4, atoms[kPre] = here.prefix, atoms[kShape] = here.shape;
  const bool more = word + 1 < sentence.size();
  atoms[kS3n] = more ? sentence.words[static_cast<std::size_t>(word) + 1].suffix3 : kAfter;
  atoms[kS2n] = more ? sentence.words[static_cast<std::size_t>(word) + 1].suffix2 : kAfter;
  atoms[kS3b] = word > 0 ? sentence.words[static_cast<std::size_t>(word) - 1].suffix3 : kBefore;
  atoms[kNounSense] = here.info.noun_sense(), atoms[kVerbSense] = here.info.verb_sense();
  atoms[kFirst] = word == 0 ? 1 : 0;
  std::uint64_t verb = 0, noun = 0, determiner = 0;
  for (int i = word - 1; i >= std::max(0, word - 12); --i) {
    const std::uint8_t before = sentence.tags[static_cast<std::size_t>(i)];
    if (is_finite(before)) verb = 1;
    if (is_noun(before)) noun = 1;
    if (Tag{before} == Tag::kPunct || Tag{before} == Tag::kCC || Tag{before} == Tag::kWDT) {
      verb += 2;
      break;
    }
  }
  for (int i = word + 1; i < std::min(sentence.size(), word + 3); ++i) {
    static const std::uint64_t kWords[] = {word_key("the"), word_key("a"),   word_key("an"),
                                           word_key("its"), word_key("one"), word_key("two")};
    if (determiner == 0 &&
        std::find(std::begin(kWords), std::end(kWords), sentence.words[static_cast<std::size_t>(i)].key) != std::end(kWords))
      determiner = static_cast<std::uint64_t>(i - word);
  }
  atoms[kVerbBefore] = verb, atoms[kNounBefore] = noun, atoms[kAfterNoun] = determiner;
  combine(atoms, kTagTemplates, 0x1234567, features);
}

void step_features(const Sentence& sentence, const State& state, Features& features) {
  Atoms atoms{};
  fill_atoms(sentence, state, atoms);
  combine(atoms, kStepTemplates, 0x89abcdef, features);
}

void label_features(const Sentence& sentence, const State& state, Step step, Features& features) {
  // The head plays the part of the second word on the stack, whichever side it is on.
  Atoms atoms{};
  const int child = state.dependent(step), above = state.head(step);
  const auto fill = [&](Role role, int place) { fill_role(sentence, state, role, place, atoms); };
  fill(kS0R, child);
  fill(kS1R, above);
  fill(kB0R, step == Step::kLeft ? state.top(1) : state.next());
  fill(kS0L, outer(state, child, true));
  fill(kS0Ro, outer(state, child, false));
  fill(kS1L, outer(state, above, true));
  fill(kS1Ro, outer(state, above, false));
  fill(kAfterS, child + 1);
  fill(kBeforeS, child - 1);
  fill(kAfterS1, above + 1);
  fill(kFirstR, 0);
  atoms[kDirection] = static_cast<std::uint64_t>(step);
  atoms[kSDist] = step == Step::kLeft ? distance(child, above) : distance(above, child);
  atoms[kS0Lm] = state.left(child).labels;
  atoms[kS0Rm] = state.right(child).labels;
  atoms[kS1Lm] = state.left(above).labels;
  atoms[kS1Rm] = state.right(above).labels;
  combine(atoms, kLabelTemplates, 0xfedcba98, features);
}

}  // namespace layoutbox::syntax
