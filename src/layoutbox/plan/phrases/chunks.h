// A sentence as a row of chunks: noun phrases, relation phrases, verbs, and the small words that join them.
#pragma once

#include <span>
#include <vector>

#include "layoutbox/plan/phrases/noun_phrase.h"
#include "layoutbox/plan/words/stop.h"

namespace layoutbox::offline {

enum class ChunkKind {
  kNoun,
  kRelation,    // a relation phrase: "next to", "on each side of", "flanked by"
  kHave,        // with, featuring, holds: the things of a room or an object
  kVerb,        // finite: is placed, stands; or a command's verb: place, put
  kParticiple,  // placed, positioned, mounted
  kComma,
  kAnd,
  kClause,
  kRelative,
  kThere,
  kCommand,
  kPurpose,
  kWithout,
  kSoft,
  kAttribute,  // after a verb: "is blue", "are white"
  kSize,       // "120 cm wide", "2 m by 1 m"
  kStop,       // end of a sentence
  kIgnored,    // adverbs, fillers
  kUnknown,    // a word nobody knows what to do with
};

struct Chunk {
  ChunkKind kind = ChunkKind::kUnknown;
  std::size_t first = 0, last = 0;  // tokens [first, last)
  NounPhrase noun;
  PhraseMatch phrase;
  bool placing = false;            // a relation phrase or verb that says that something is put somewhere
  bool hang = false;               // … or hung
  bool passive = false;            // a verb with is, are
  std::optional<double> distance;  // metres, of a relation: "50 cm from"
  bool at_least = false, at_most = false;
  int rows = 0, columns = 0;  // "in three rows", "in rows of four"
  bool gap = false;           // "80 cm between the sofa and the table"
  SaidSize size;
};

// Is it a noun phrase that means a thing of the room?
inline bool is_thing(const Chunk& chunk) { return chunk.kind == ChunkKind::kNoun && chunk.noun.kind == NounKind::kObject; }

std::vector<Chunk> chunk_tokens(const Lexicon& lexicon, std::span<const Token> tokens, StopFlag stop = nullptr);

}  // namespace layoutbox::offline
