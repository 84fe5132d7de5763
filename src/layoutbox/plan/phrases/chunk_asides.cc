// Small words with a construction of their own: bounds behind their number, what is such or out, loose particles.
#include <algorithm>
#include <array>

#include "layoutbox/plan/phrases/chunks_parts.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

// "plants, ten at least!", "six at most": a bound behind its number.
bool Chunker::read_trailing_bound() {
  const std::size_t length = std::max(length_of(WordClass::kAtLeast), length_of(WordClass::kAtMost));
  if (length == 0 || previous() != ChunkKind::kNoun || chunks_[telling_].noun.count == 0 || i_ + length > tokens_.size()) return false;
  if (i_ + length < tokens_.size() && tokens_[i_ + length].kind != Token::Kind::kPunctuation) return false;
  chunks_[telling_].noun.at_least = length_of(WordClass::kAtLeast) > 0;
  add(ChunkKind::kIgnored, length);
  return true;
}

// "over by the window", "off in the corner": the place comes after it.
bool Chunker::is_loose_particle() const {
  static constexpr std::array<std::string_view, 6> kParticles = {"over", "up", "off", "out", "down", "round"};
  if (std::ranges::find(kParticles, tokens_[i_].text) == kParticles.end() || phrase_here().length > 1) return false;
  return i_ + 2 < tokens_.size() && !opens_noun(tokens_[i_ + 1]) && lexicon_.find_phrase(tokens_, i_ + 1).length > 0 &&
         opens_noun(tokens_[i_ + 2]);
}

// "props such as a suitcase and a hat": what is listed, and nothing besides.
bool Chunker::read_such_as() {
  const auto listed = [&](std::size_t at) {
    if (thing_next(at)) return true;
    const auto noun = at < tokens_.size() ? read_noun_phrase(lexicon_, tokens_, at, true) : std::nullopt;
    return noun && noun->kind == NounKind::kObject && noun->entry != nullptr;
  };
  const bool like = tokens_[i_].text == "like" && listed(i_ + 1);  // "items like a kettle"
  const bool such = tokens_[i_].text == "such" && i_ + 1 < tokens_.size() && tokens_[i_ + 1].text == "as" && listed(i_ + 2);
  if (!like && !such) return false;
  Chunk* kinds = previous() == ChunkKind::kNoun ? &chunks_[telling_] : nullptr;
  if (kinds == nullptr || !(kinds->noun.plural || kinds->noun.head == "furniture") || (kinds->noun.count > 0 && !kinds->noun.vague) ||
      (kinds->noun.determiner != Determiner::kNone && !kinds->noun.vague))
    return false;
  if (like && !is_collective(kinds->noun.head) && kinds->noun.head != "thing" && kinds->noun.head != "furniture") return false;
  kinds->kind = ChunkKind::kIgnored;
  do --telling_;
  while (telling_ < chunks_.size() && (chunks_[telling_].kind == ChunkKind::kIgnored || chunks_[telling_].kind == ChunkKind::kSoft));
  add(ChunkKind::kIgnored, like ? 1 : 2);
  return true;
}

// "…, that I may watch the street": what for.
bool Chunker::read_that_may() {
  static constexpr std::array<std::string_view, 5> kMay = {"may", "might", "can", "could", "should"};
  if (tokens_[i_].text != "that" || previous() != ChunkKind::kComma || i_ + 2 >= tokens_.size()) return false;
  if (!lexicon_.is(tokens_[i_ + 1], WordClass::kDoer) || std::ranges::find(kMay, tokens_[i_ + 2].text) == kMay.end()) return false;
  add(ChunkKind::kClause, 1);
  return true;
}

// "please leave the wardrobe out", "keep plants out": it is not wanted.
bool Chunker::read_leave_out() {
  if (!one_of(tokens_[i_].text, WordSet::kLeaving) || !clause_begins()) return false;
  const auto noun = read_noun_phrase(lexicon_, tokens_, i_ + 1, true);
  if (!noun || noun->kind != NounKind::kObject || noun->last >= tokens_.size() || tokens_[noun->last].text != "out") return false;
  if (noun->last + 1 < tokens_.size() && tokens_[noun->last + 1].kind == Token::Kind::kWord) return false;
  add(ChunkKind::kWithout, 1);
  return true;
}

}  // namespace layoutbox::offline
