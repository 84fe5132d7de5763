// A sentence as the row of units that its reading is decided over: nouns, places, having, verbs, each with what joins it to the one before.
#pragma once

#include <vector>

#include "layoutbox/plan/phrases/document.h"

namespace layoutbox::offline {

enum class Joiner { kNone, kComma, kAnd, kCommaAnd };

enum class UnitKind {
  kNoun,
  kPlace,  // a relation phrase
  kHave,
  kVerb,
  kParticiple,
  kRelative,
  kOpen,  // "there is", "please add"
  kSize,
  kAttribute,
};

inline constexpr std::size_t kNoOrder = static_cast<std::size_t>(-1);

struct Unit {
  UnitKind kind = UnitKind::kNoun;
  std::size_t chunk = 0;  // of the document
  Joiner joiner = Joiner::kNone;
  bool clause = false;                   // "while", "but", "where" stands before it
  bool where = false;                    // … "where"
  bool soft = false;                     // "ideally" was said before
  const PhraseSenses* senses = nullptr;  // of a place
  PhraseSenses direct, inverse, alone;   // … by direction, each turned to direct
  bool each = false;                     // a place on "each side"
  std::size_t order = kNoOrder;          // the chunk that says in which order stands the list that it is of, or that follows
  int share = 1;                         // of a noun: so many times is it there, where it is new
  bool unsaid = false;                   // a having without words: "each plinth a bust"
  bool other = false;                    // … on the other side or end, where the first one was said
};

using Sentence = std::vector<Unit>;

// Splits the document's chunks into sentences. What is a purpose, not wanted, a part or a filler is marked in the document's readings and
// left out; rooms, openings, people and what is excluded are noted in the document. Sentences are cut after `kLongest` units.
std::vector<Sentence> read_units(const Lexicon& lexicon, Document& document);

inline constexpr std::size_t kLongestSentence = 160;

}  // namespace layoutbox::offline
