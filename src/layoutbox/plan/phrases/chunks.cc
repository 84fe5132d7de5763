#include "layoutbox/plan/phrases/chunks.h"

#include <algorithm>
#include <array>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/phrases/chunks_parts.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

bool Chunker::opens_noun(const Token& token) const {
  return token.kind == Token::Kind::kNumber || lexicon_.is(token, WordClass::kDefinite) || lexicon_.is(token, WordClass::kIndefinite) ||
         lexicon_.is(token, WordClass::kPossessive) || lexicon_.is(token, WordClass::kEach) || lexicon_.is(token, WordClass::kBoth) ||
         lexicon_.is(token, WordClass::kPronoun) || lexicon_.is(token, WordClass::kAnother) || token.text == "over" || token.text == "at" ||
         token.text == "more" || token.text == "exactly" ||
         (lexicon_.is(token, WordClass::kNumber) && token.text != "double" && token.text != "twin" && token.text != "single");
}

bool Chunker::clause_begins() const {
  const ChunkKind before = previous();
  return before == ChunkKind::kStop || before == ChunkKind::kClause || before == ChunkKind::kComma || before == ChunkKind::kAnd ||
         before == ChunkKind::kCommand;
}

// "there is", but not "the lamp there", "it is there on the shelf"
bool Chunker::read_there(std::size_t without) {
  const std::size_t there = length_of(WordClass::kThere);
  if (there == 0 || there < without) return false;
  const ChunkKind before = previous();
  const bool place =
      there == 1 && tokens_[i_].text == "there" && (before == ChunkKind::kNoun || (before == ChunkKind::kVerb && !thing_next(i_ + 1)));
  add(place ? ChunkKind::kIgnored : ChunkKind::kThere, there);
  return true;
}

// "like three mugs", "stools, say five"
bool Chunker::is_about_number() const {
  return (tokens_[i_].text == "like" || tokens_[i_].text == "say") && i_ + 1 < tokens_.size() &&
         lexicon_.is(tokens_[i_ + 1], WordClass::kNumber);
}

// "chairs all around"
bool Chunker::is_all_around() const { return tokens_[i_].text == "all" && i_ + 1 < tokens_.size() && tokens_[i_ + 1].text == "around"; }

// "the desk's left corner", "the counter's right end": a part of what was named.
bool Chunker::read_owned_side() {
  const bool owned = !chunks_.empty() && chunks_.back().kind == ChunkKind::kNoun && chunks_.back().noun.owner;
  if (!owned || length_of(WordClass::kWallWord) != 1 || i_ + 1 >= tokens_.size()) return false;
  const Token& part = tokens_[i_ + 1];
  return (lexicon_.is(part, WordClass::kSide) || lexicon_.is(part, WordClass::kCorner)) && read_noun(true);
}

void Chunker::read() {
  if (read_owned_side() || read_flush() || read_hung_at() || read_length_from() || read_lettered_size() || read_bare_length() ||
      read_size_chunk() || read_rows() || read_infinitive() || read_wishing() || read_finding() || read_doing() || read_built_place() ||
      read_having_by() || read_manner() || read_trailing_bound() || read_look())
    return;
  if (is_about_number()) {
    add(ChunkKind::kIgnored, 1);
    return;
  }
  if (read_where_in() || read_entering() || read_such_as() || read_leave_out() || read_that_may() || read_whose() || read_inverted_verb())
    return;
  if (opens_question() || says_enough() || is_all_around() || is_loose_particle()) {
    add(ChunkKind::kIgnored, 1);
    return;
  }
  const PhraseMatch phrase = phrase_here();
  if (tokens_[i_].text == "all" && phrase.length == 2) {  // "trays all over it"
    add_phrase(phrase);
    return;
  }
  const ChunkKind before = previous();
  // "my desk is 's": what a person owns was read with the noun; elsewhere the sign stands for "is" or "us".
  if (tokens_[i_].text == "'s") {
    add(before == ChunkKind::kThere ? ChunkKind::kThere : ChunkKind::kIgnored, 1);
    return;
  }
  // "The left nightstand", "two chairs": what opens a noun phrase is one, unless a longer phrase begins so ("one behind the other").
  std::size_t without = length_of(WordClass::kWithout);
  const std::size_t denied = i_ + without;
  // "is no more than a step from it": how far.
  if (without > 1 && denied < tokens_.size() && (tokens_[denied].text == "more" || tokens_[denied].text == "further")) without = 0;
  if (without > 0 && std::max(length_of(WordClass::kAtLeast), length_of(WordClass::kAtMost)) > without)
    without = 0;  // "no fewer than eight pots"
  if (read_there(without)) return;
  const bool counts = tokens_[i_].text == "over" || tokens_[i_].text == "at" || tokens_[i_].text == "more" || tokens_[i_].text == "exactly";
  const bool count_follows =
      !counts || length_of(WordClass::kAtLeast) > 0 ||
      (length_of(WordClass::kMoreThan) > 0 && i_ + 1 < tokens_.size() &&
       (tokens_[i_ + 1].kind == Token::Kind::kNumber || lexicon_.is(tokens_[i_ + 1], WordClass::kNumber)) && before != ChunkKind::kNoun) ||
      length_of(WordClass::kExactly) > 0;
  const bool both_sides = phrase.length == 2 && std::any_of(phrase.senses->begin(), phrase.senses->end(), [](const PhraseSense& s) {
                            return s.type == RelationType::kEachSideOf && s.direction == PhraseSense::Direction::kAlone;
                          });
  const std::size_t after_sides = i_ + phrase.length;
  const bool sides_end = both_sides && (after_sides >= tokens_.size() || tokens_[after_sides].kind == Token::Kind::kPunctuation ||
                                        lexicon_.is(tokens_[after_sides], WordClass::kAnd));
  const bool one_more = tokens_[i_].text == "one" && before == ChunkKind::kAnd;  // "… and one on the other" side
  if (opens_noun(tokens_[i_]) && (phrase.length < 3 || one_more) && !sides_end && count_follows) {
    const bool relative =
        lexicon_.is(tokens_[i_], WordClass::kRelative) && before == ChunkKind::kNoun && !(tokens_[i_].text == "that" && noun_follows());
    if (relative || (before == ChunkKind::kComma && tokens_[i_].text == "which")) {
      add(ChunkKind::kRelative, 1);
      return;
    }
    if (read_noun(false)) return;
  }
  if (read_words(phrase, without)) return;
  if (read_noun(true)) return;
  if (phrase.length > 0) {
    add_phrase(phrase);
    return;
  }
  read_small_word();
}

// "a cabinet whose shelves hold five bottles": the cabinet holds them.
bool Chunker::read_whose() {
  if (tokens_[i_].text != "whose" || previous() != ChunkKind::kNoun) return false;
  const auto part = read_noun_phrase(lexicon_, tokens_, i_, false);
  if (!part || part->last >= tokens_.size() || !lexicon_.is(tokens_[part->last], WordClass::kHave)) return false;
  if (!one_of(singular_of(tokens_[part->last - 1].text), WordSet::kHoldingParts)) return false;
  add(ChunkKind::kRelative, part->last - i_);
  return true;
}

// "Would a bike fit in …", "Could two desks stand …": the question is about the thing.
bool Chunker::opens_question() const {
  static constexpr std::array<std::string_view, 7> kAsking = {"would", "could", "can", "will", "should", "might", "may"};
  return (chunks_.empty() || previous() == ChunkKind::kStop) && i_ + 1 < tokens_.size() &&
         std::find(kAsking.begin(), kAsking.end(), tokens_[i_].text) != kAsking.end() && opens_noun(tokens_[i_ + 1]) &&
         !lexicon_.is(tokens_[i_ + 1], WordClass::kPronoun);
}

// "enough chairs for six": a number is yet to come.
bool Chunker::says_enough() const {
  if (tokens_[i_].text != "enough" || previous() == ChunkKind::kNoun || i_ + 1 >= tokens_.size()) return false;
  const auto noun = read_noun_phrase(lexicon_, tokens_, i_ + 1, true);
  return noun && noun->kind == NounKind::kObject && noun->exact && noun->plural;
}

// The relation phrase that begins here. "On the left" ends before "end", "wall" or "one": "on the left end of the counter".
PhraseMatch Chunker::phrase_here() const {
  if (is_shape_said_after()) return {};
  const PhraseMatch phrase = lexicon_.find_phrase(tokens_, i_);
  const std::size_t after = i_ + phrase.length;
  if (phrase.length < 2 || after >= tokens_.size()) return phrase;
  const std::string& last = tokens_[after - 1].text;
  // "above each of the beds", "behind one of the beds": "each of" are those.
  const Token& before = tokens_[after - 2];
  if (phrase.length > 2 && last == "of" && (lexicon_.is(before, WordClass::kEach) || lexicon_.is(before, WordClass::kNumber)))
    return lexicon_.find_phrase(tokens_.first(after - 2), i_);
  // "at its far end": the end of a thing, not of the room.
  const bool of_room = std::ranges::all_of(*phrase.senses, [](const PhraseSense& s) { return s.type == RelationType::kInRegion; });
  if (of_room && (phrase.possessive || (last == "of" && names_thing_at(after)))) return lexicon_.find_phrase(tokens_.first(i_ + 1), i_);
  // "at its right-hand end": not "at hand".
  if (last == "hand" && lexicon_.is(tokens_[after], WordClass::kSide)) return lexicon_.find_phrase(tokens_.first(i_ + 1), i_);
  const bool end = last == "end" || last == "edge";
  if (phrase.possessive && end && tokens_[after - 2].text == "right") return lexicon_.find_phrase(tokens_.first(i_ + 1), i_);
  // "at the back edge of the table": of the table, not of the room.
  const bool part_follows = lexicon_.is(tokens_[after], WordClass::kSide) && !one_of(tokens_[after].text, {"left", "right"});
  if ((last == "back" || last == "front") && part_follows) return lexicon_.find_phrase(tokens_.first(i_ + 1), i_);
  if (last != "left" && last != "right" && last != "side") return phrase;
  // "on the left and right walls": not on the left.
  if (joins_walls(lexicon_, tokens_, after)) return lexicon_.find_phrase(tokens_.first(i_ + 1), i_);
  const Token& next = tokens_[after].text == "hand" && after + 1 < tokens_.size() ? tokens_[after + 1] : tokens_[after];
  if (next.text != "one" && next.text != "walls" && !lexicon_.is(next, WordClass::kWall) && !lexicon_.is(next, WordClass::kCorner) &&
      !lexicon_.is(next, WordClass::kSide))
    return phrase;
  const PhraseMatch shorter = lexicon_.find_phrase(tokens_.first(i_ + 1), i_);
  return shorter.length > 0 ? shorter : phrase;
}

// "easy to picture", "nice to look at": what one does, after an adjective that begins no relation phrase. "A layout to copy": with it.
bool Chunker::read_infinitive() {
  if (tokens_[i_].text != "to" || i_ == 0 || i_ + 1 >= tokens_.size() || tokens_[i_ + 1].kind != Token::Kind::kWord) return false;
  const bool with_it = previous() == ChunkKind::kNoun && chunks_.back().last == i_ && lexicon_.find(tokens_, i_ + 1).length == 0 &&
                       lexicon_.find_phrase(tokens_, i_ + 1).length == 0;
  if (!with_it && !one_of(tokens_[i_ - 1].text, WordSet::kDoable)) return false;
  // "an arrow to Mecca": whither
  const bool whither = with_it && tokens_[i_ + 1].capital && !tokens_[i_ - 1].capital;
  add(whither ? ChunkKind::kIgnored : ChunkKind::kPurpose, 2);
  return true;
}

void Chunker::add_phrase(const PhraseMatch& phrase) {
  const std::size_t first = i_;
  Chunk& chunk = add(ChunkKind::kRelation, phrase.length);
  chunk.phrase = phrase;
  if (entering_) mean_hand(chunk);
  for (std::size_t i = first; i < first + phrase.length; ++i) {
    chunk.hang |= lexicon_.is(tokens_[i], WordClass::kHang);
    const bool placed = lexicon_.is(tokens_[i], WordClass::kParticiple) && tokens_[i].text != "left";  // "to the left of"
    chunk.placing |= placed || chunk.hang;
  }
}

std::size_t Chunker::be_length() const {
  std::size_t length = length_of(WordClass::kBe);
  if (length == 0) return 0;
  while (i_ + length < tokens_.size() && tokens_[i_ + length].kind == Token::Kind::kWord) {
    const std::size_t at = i_ + length;
    const std::size_t again = lexicon_.find(tokens_, at, WordClass::kBe).length;
    if (again > 0) {
      length += again;
      continue;
    }
    // A relation phrase that begins with the participle ("is flanked by", "is centered on") is left to be read as one.
    const PhraseMatch phrase = lexicon_.find_phrase(tokens_, at);
    if (lexicon_.find(tokens_, at, WordClass::kHave).length > 1) break;
    if (phrase.length == 1 && says(*phrase.senses, RelationType::kStacked)) break;  // "are stacked in the corner"
    if (phrase.length > 1 || (phrase.length == 1 && !lexicon_.is(tokens_[at], WordClass::kParticiple))) break;
    const std::size_t more =
        std::max({lexicon_.find(tokens_, at, WordClass::kParticiple).length, lexicon_.find(tokens_, at, WordClass::kHang).length,
                  lexicon_.find(tokens_, at, WordClass::kAdverb).length});
    if (more == 0) break;
    length += more;
  }
  return length;
}

// "a lamp throws light": what it does, right after it, though things are called so.
bool Chunker::is_thing_as_verb(const Match& match) const {
  const bool thing = match.length == 1 && std::ranges::all_of(match.meanings, [](const Meaning& m) {
                       return m.word_class == WordClass::kObject || m.word_class == WordClass::kPart || m.word_class == WordClass::kSide;
                     });
  const bool after_one =
      previous() == ChunkKind::kNoun && !chunks_.empty() && chunks_.back().last == i_ && !chunks_.back().noun.is_plural();
  return thing && after_one && tokens_[i_].text.ends_with("s") && may_be_verb(tokens_[i_].text) && i_ + 1 < tokens_.size() &&
         tokens_[i_ + 1].kind == Token::Kind::kWord && lexicon_.find_phrase(tokens_, i_ + 1).length == 0;
}

void Chunker::read_small_word() {
  const Match match = lexicon_.find(tokens_, i_);
  const auto is = [&](WordClass word_class) {
    return std::any_of(match.meanings.begin(), match.meanings.end(), [&](const Meaning& m) { return m.word_class == word_class; });
  };
  if (match.length > 0 && (is(WordClass::kVerb) || is(WordClass::kDoer))) {
    add(ChunkKind::kPurpose, match.length);  // what such a verb says of the room is no placing
    return;
  }
  if (is(WordClass::kColor) || is(WordClass::kMaterial) || is(WordClass::kSizeWord) || is(WordClass::kShape) || is(WordClass::kStyle)) {
    add(ChunkKind::kAttribute, match.length);
    return;
  }
  // "a wardrobe blocks the corner": a thing's name that is a verb here.
  const bool verb = match.length == 1 && !is(WordClass::kFiller) && !is(WordClass::kAdverb) && !is(WordClass::kCommand) &&
                    previous() == ChunkKind::kNoun && i_ + 1 < tokens_.size() && tokens_[i_].text.ends_with("s") &&
                    opens_noun(tokens_[i_ + 1]);
  if (verb) {
    add(ChunkKind::kUnknown, 1);
    return;
  }
  if (is_thing_as_verb(match)) {
    add(ChunkKind::kPurpose, 1);
    return;
  }
  if (match.length > 0) {
    add(ChunkKind::kIgnored, match.length);
    return;
  }
  const WordForm form = word_form(tokens_[i_].text);
  if (form == WordForm::kVerb && previous() == ChunkKind::kNoun) {
    add(ChunkKind::kPurpose, 1);
    return;
  }
  add(form == WordForm::kAdverb || form == WordForm::kAdjective ? ChunkKind::kIgnored : ChunkKind::kUnknown, 1);
}

std::vector<Chunk> chunk_tokens(const Lexicon& lexicon, std::span<const Token> tokens, StopFlag stop) {
  return Chunker(lexicon, tokens, stop).run();
}

}  // namespace layoutbox::offline
