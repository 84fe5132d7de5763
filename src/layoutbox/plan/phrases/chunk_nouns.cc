// Where a noun phrase begins and ends among the chunks, and what of the words after it still says what it is like.
#include <algorithm>
#include <array>

#include "layoutbox/plan/phrases/chunks.h"
#include "layoutbox/plan/phrases/chunks_parts.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

// A new thing is named at that token.
bool Chunker::thing_next(std::size_t at) const {
  return at < tokens_.size() && (lexicon_.is(tokens_[at], WordClass::kIndefinite) || lexicon_.is(tokens_[at], WordClass::kNumber) ||
                                 tokens_[at].kind == Token::Kind::kNumber || lexicon_.is(tokens_[at], WordClass::kAnother));
}

// A thing is named there: "at the far end of the sofa", not "of the room".
bool Chunker::names_thing_at(std::size_t at) const {
  if (at >= tokens_.size()) return false;
  const auto noun = read_noun_phrase(lexicon_, tokens_, at, true);
  return noun && (noun->kind == NounKind::kObject || (noun->kind == NounKind::kPronoun && noun->head == "it"));
}

bool Chunker::noun_follows() const {
  const auto noun = read_noun_phrase(lexicon_, tokens_, i_, false);
  // "a stand that bears a kettle": "that" is of one thing, and "bears" a verb.
  const bool many_after_that = noun && noun->plural && tokens_[i_].text == "that";
  return noun && noun->kind == NounKind::kObject && !many_after_that;
}

// "At its center bubbles a hot tub", "under it hums the minibar": after the place that a clause begins with, and before the thing that is
// there, a word in -s is what that does, whatever else is called so.
bool Chunker::read_inverted_verb() {
  const std::string& word = tokens_[i_].text;
  if (word.size() < 3 || !word.ends_with("s") || word.ends_with("ss") || i_ + 1 >= tokens_.size() || chunks_.empty() ||
      chunks_.back().last != i_)
    return false;
  const Token& next = tokens_[i_ + 1];
  if (!lexicon_.is(next, WordClass::kIndefinite) && !lexicon_.is(next, WordClass::kDefinite) && !lexicon_.is(next, WordClass::kPossessive))
    return false;
  const bool known = std::ranges::any_of(std::array{WordClass::kPlaceVerb, WordClass::kHave, WordClass::kHang, WordClass::kBe},
                                         [&](WordClass listed) { return lexicon_.is(tokens_[i_], listed); }) ||
                     lexicon_.find_phrase(tokens_, i_).length > 0;
  const bool thing = lexicon_.find(tokens_, i_, WordClass::kObject).length > 0;
  const auto there = read_noun_phrase(lexicon_, tokens_, i_ + 1, false);  // not "the length of the wall"
  if (known || (thing && !may_be_verb(word)) || !there || there->kind != NounKind::kObject) return false;
  std::size_t c = chunks_.size() - 1;
  if (chunks_[c].kind == ChunkKind::kNoun && c > 0) --c;
  const bool opens = c == 0 || chunks_[c - 1].kind == ChunkKind::kStop || chunks_[c - 1].kind == ChunkKind::kComma ||
                     chunks_[c - 1].kind == ChunkKind::kAnd || chunks_[c - 1].kind == ChunkKind::kClause;
  if (!opens || chunks_[c].kind != ChunkKind::kRelation) return false;
  add(ChunkKind::kVerb, 1).placing = true;
  return true;
}

bool Chunker::read_noun(bool bare) {
  // Right after a noun phrase no bare one begins: "lamps light the room", "a table holds".
  const bool after_which = !chunks_.empty() && chunks_.back().noun.kind == NounKind::kPronoun && chunks_.back().noun.head == "which";
  const bool after_wall = !chunks_.empty() && chunks_.back().kind == ChunkKind::kNoun && chunks_.back().noun.kind == NounKind::kWall &&
                          !chunks_.back().noun.wall_word.empty() && lexicon_.find(tokens_, i_, WordClass::kObject).length > 0;
  const bool after_noun = bare && previous() == ChunkKind::kNoun && !chunks_.back().noun.owner && !after_which && !after_wall;
  if (after_noun && !lexicon_.is(tokens_[i_], WordClass::kWallWord)) return false;
  // "for the one who watches": after "who" a verb.
  if (bare && i_ > 0 && tokens_[i_ - 1].text == "who" && may_be_verb(tokens_[i_].text)) return false;
  auto noun = read_noun_phrase(lexicon_, tokens_, i_, bare);
  if (!noun || noun->last <= i_) return false;
  if (after_noun && noun->kind != NounKind::kWall && noun->kind != NounKind::kCorner) return false;
  if (bare && is_verb_before_article(*noun)) {
    const bool has = one_of(tokens_[i_].text, WordSet::kHaving);
    add(has ? ChunkKind::kHave : ChunkKind::kPurpose, 1);
    return true;
  }
  if (bare && noun->kind == NounKind::kAbstract && !noun->collective && noun->last == i_ + 1 &&
      lexicon_.find_phrase(tokens_, i_).length > 0)
    return false;
  Chunk& chunk = add(ChunkKind::kNoun, noun->last - i_);
  chunk.noun = std::move(*noun);
  if (chunk.noun.owner && i_ < tokens_.size() && tokens_[i_].text == "'s") {
    ++i_;
    chunk.last = i_;
  }
  return true;
}

// "…, throw a warm light", "and bears a watering can": one word after a break and before an article, which may be a verb.
bool Chunker::is_verb_before_article(const NounPhrase& noun) const {
  const ChunkKind before = previous();
  if ((before != ChunkKind::kComma && before != ChunkKind::kAnd) || noun.last != i_ + 1 || noun.last >= tokens_.size() ||
      noun.determiner != Determiner::kNone || noun.count > 0)
    return false;
  const Token& next = tokens_[noun.last];
  return (lexicon_.is(next, WordClass::kIndefinite) || lexicon_.is(next, WordClass::kPossessive)) && may_be_verb(tokens_[i_].text);
}

// "which bears a jug", "it bears two jars": a verb where something is brought in; elsewhere bears are animals.
std::size_t Chunker::bears_thing() const {
  const bool in_place = previous() == ChunkKind::kRelation && chunks_.back().phrase.senses != nullptr &&
                        std::ranges::any_of(*chunks_.back().phrase.senses, [](const PhraseSense& s) {
                          return s.direction == PhraseSense::Direction::kAlone;  // "the table in the middle bears a jug"
                        });
  const bool subject = previous() == ChunkKind::kNoun || previous() == ChunkKind::kAnd || previous() == ChunkKind::kRelative || in_place;
  return tokens_[i_].text == "bears" && subject && thing_next(i_ + 1) ? 1 : 0;
}

// ", picture over the clock": no "picture a room".
bool Chunker::is_picture() const {
  return tokens_[i_].text == "picture" && i_ + 1 < tokens_.size() && lexicon_.find_phrase(tokens_, i_ + 1).length > 0;
}

// "a drum kit, set up on a rug, …": said of the drum kit, no command.
std::size_t Chunker::set_after_noun() const {
  const std::size_t length = tokens_[i_].text == "set" || tokens_[i_].text == "put" ? length_of(WordClass::kCommand) : 0;
  const bool told = previous() == ChunkKind::kComma && chunks_.size() > 1 && chunks_[chunks_.size() - 2].kind == ChunkKind::kNoun;
  const bool placed = told && length > 0 && i_ + length < tokens_.size() && lexicon_.find_phrase(tokens_, i_ + length).length > 0;
  return placed ? length : 0;
}

// "a rug round pink in the center": how it looks, not what it goes round.
bool Chunker::is_shape_said_after() const {
  if (tokens_[i_].text != "round" || previous() != ChunkKind::kNoun || i_ + 1 >= tokens_.size()) return false;
  const Token& next = tokens_[i_ + 1];
  return next.kind == Token::Kind::kPunctuation || lexicon_.find(tokens_, i_ + 1, WordClass::kColor).length > 0 ||
         lexicon_.find_phrase(tokens_, i_ + 1).length > 0;
}

}  // namespace layoutbox::offline
