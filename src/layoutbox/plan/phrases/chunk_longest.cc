// Of several readings of the words from one on, the longest.
#include <algorithm>
#include <array>

#include "layoutbox/plan/phrases/chunks.h"
#include "layoutbox/plan/phrases/chunks_parts.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

namespace {

// Not "hangs", "is mounted", "hang the lamp", which are finite.
bool is_participle_form(std::string_view word) {
  return word.ends_with("ing") || word.ends_with("ed") || one_of(word, WordSet::kIrregular);
}

}  // namespace

// The longest of the words that may begin here; of equals the first.
Chunker::Choice Chunker::longest(const PhraseMatch& phrase, std::size_t without) const {
  const ChunkKind before = previous();
  const bool after_noun = before == ChunkKind::kNoun || before == ChunkKind::kRelation;
  // "in all four corners", not "six in all"
  const bool in_all = tokens_[i_].text == "in" && i_ + 2 < tokens_.size() && tokens_[i_ + 1].text == "all" &&
                      tokens_[i_ + 2].kind == Token::Kind::kWord && !lexicon_.is(tokens_[i_ + 2], WordClass::kAnd);
  const std::size_t filler = in_all ? 0 : length_of(WordClass::kFiller);
  const std::array<Choice, 13> choices = {{
      {ChunkKind::kIgnored, filler > 1 ? filler : 0},  // "six in all", "three should do"
      {ChunkKind::kCommand, clause_begins() && !is_picture() && set_after_noun() == 0 ? length_of(WordClass::kCommand) : 0},
      {ChunkKind::kWithout, without},
      {ChunkKind::kSoft, length_of(WordClass::kSoft)},
      {ChunkKind::kHave, std::max(length_of(WordClass::kHave), bears_thing())},
      {ChunkKind::kRelation, phrase.length},
      {ChunkKind::kVerb, be_length()},
      {ChunkKind::kParticiple, std::max({length_of(WordClass::kParticiple), length_of(WordClass::kHang), set_after_noun()})},
      {ChunkKind::kVerb, length_of(WordClass::kPlaceVerb)},
      {ChunkKind::kClause, length_of(WordClass::kClause)},
      {ChunkKind::kAnd, length_of(WordClass::kAnd)},
      {ChunkKind::kPurpose, length_of(WordClass::kPurpose)},
      {ChunkKind::kRelative, after_noun ? length_of(WordClass::kRelative) : 0},
  }};
  return *std::max_element(choices.begin(), choices.end(), [](const Choice& a, const Choice& b) { return a.length < b.length; });
}

// A bare noun begins with such a word and is longer: "standing lamp", "hanging chair", "set of drawers", "display cabinet".
bool Chunker::is_longer_noun(const Choice& best) const {
  const ChunkKind before = previous();
  const bool verb_follows_that = before == ChunkKind::kRelative &&
                                 (best.kind == ChunkKind::kRelation || best.kind == ChunkKind::kHave || best.kind == ChunkKind::kVerb);
  if (best.kind == ChunkKind::kAnd || best.kind == ChunkKind::kClause || before == ChunkKind::kNoun || verb_follows_that) return false;
  const auto noun = read_noun_phrase(lexicon_, tokens_, i_, true);
  if (!noun) return false;
  // "on opposite walls", "against left wall"
  const bool of_room = noun->kind == NounKind::kWall || noun->kind == NounKind::kCorner;
  if (of_room && (best.kind == ChunkKind::kParticiple || (before == ChunkKind::kRelation && best.kind == ChunkKind::kRelation)))
    return true;
  // "Waiting room with eight chairs", "Meeting room for ten".
  if (noun->kind == NounKind::kRoom && noun->room != nullptr && noun->last > i_ + best.length && clause_begins()) return true;
  return noun->kind == NounKind::kObject && is_longer_thing(best, *noun);
}

bool Chunker::is_longer_thing(const Choice& best, const NounPhrase& noun) const {
  // "Round table in the middle": a quality, where it stands first and a noun is right behind it.
  if (best.kind == ChunkKind::kRelation && best.length == 1 && clause_begins() && tokens_[i_].text != "opposite" &&
      std::find(noun.attributes.begin(), noun.attributes.end(), tokens_[i_].text) != noun.attributes.end())
    return true;
  if (noun.last <= i_ + best.length || noun.entry == nullptr) return false;
  const bool verbal = best.kind == ChunkKind::kParticiple || best.kind == ChunkKind::kVerb || best.kind == ChunkKind::kCommand ||
                      best.kind == ChunkKind::kHave;
  const bool verb_first =
      verbal && clause_begins() && !noun.exact && !noun.plural && noun.determiner == Determiner::kNone && noun.attributes.empty();
  const bool preposition = best.kind == ChunkKind::kRelation && noun.name.find(tokens_[i_].text) == std::string::npos;
  return !verb_first && !preposition && best.kind != ChunkKind::kWithout && best.kind != ChunkKind::kPurpose;
}

// "with lights around it", "has shelves on both sides": what something has, and no verb of that form.
bool Chunker::is_thing_held(const Choice& best) const {
  const bool verbal = best.kind == ChunkKind::kRelation || best.kind == ChunkKind::kVerb || best.kind == ChunkKind::kParticiple ||
                      best.kind == ChunkKind::kHave;
  if (!verbal || best.length != 1 || previous() != ChunkKind::kHave || !tokens_[i_].text.ends_with('s')) return false;
  const auto noun = read_noun_phrase(lexicon_, tokens_, i_, true);
  return noun && noun->kind == NounKind::kObject && noun->exact && noun->plural && noun->last == i_ + 1;
}

// "tv on a stand, stand against the wall": a thing that was named before, without its article, and not the verb.
bool Chunker::is_known_thing(const Choice& best) const {
  const bool verbal = best.kind == ChunkKind::kParticiple || best.kind == ChunkKind::kVerb || best.kind == ChunkKind::kCommand;
  if (!verbal || best.length != 1 || !clause_begins() || i_ + 1 >= tokens_.size()) return false;
  if (lexicon_.find_phrase(tokens_, i_ + 1).length == 0 || opens_noun(tokens_[i_ + 1])) return false;
  constexpr std::size_t kBack = 100;
  const auto first = chunks_.size() > kBack ? chunks_.end() - kBack : chunks_.begin();
  return std::any_of(first, chunks_.end(), [&](const Chunk& chunk) {
    return chunk.kind == ChunkKind::kNoun && chunk.noun.kind == NounKind::kObject && chunk.noun.head == tokens_[i_].text;
  });
}

bool Chunker::read_words(const PhraseMatch& phrase, std::size_t without) {
  const Choice best = longest(phrase, without);
  if (best.length == 0) return false;
  if (is_longer_noun(best) || is_known_thing(best) || is_thing_held(best)) return read_noun(true);
  if (best.kind == ChunkKind::kRelation) {
    add_phrase(phrase);
    return true;
  }
  const bool passive = best.kind == ChunkKind::kVerb && be_length() == best.length;
  const std::size_t first = i_;
  Chunk& chunk = add(best.kind, best.length);
  if (best.kind != ChunkKind::kVerb && best.kind != ChunkKind::kParticiple) return true;
  for (std::size_t i = first; i < chunk.last; ++i) chunk.hang |= lexicon_.is(tokens_[i], WordClass::kHang);
  chunk.placing = true;
  chunk.passive = passive;
  if (best.kind == ChunkKind::kParticiple && !is_participle_form(tokens_[chunk.last - 1].text)) chunk.kind = ChunkKind::kVerb;
  return true;
}

}  // namespace layoutbox::offline
