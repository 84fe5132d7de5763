// What stands between two things: "a screen shields the bath from the door", "the bath is shielded from the door by a screen".
#include <algorithm>
#include <array>

#include "layoutbox/plan/phrases/chunks_parts.h"

namespace layoutbox::offline {

// "a screen shields the bath from the door": between the two.
bool Chunker::parts_from() const {
  constexpr std::size_t kFar = 8;
  if (previous() != ChunkKind::kNoun && previous() != ChunkKind::kRelative) return false;
  if (!is_verb_of("parting", i_) || i_ + 1 >= tokens_.size() || !opens_noun(tokens_[i_ + 1])) return false;
  for (std::size_t i = i_ + 2; i < tokens_.size() && i < i_ + kFar && tokens_[i].kind == Token::Kind::kWord; ++i) {
    if (tokens_[i].text != "from") continue;
    const auto from = read_noun_phrase(lexicon_, tokens_, i + 1, true);  // not "from view"
    return from && from->kind != NounKind::kAbstract;
  }
  return false;
}

// The bath, of which "is shielded from the door by a screen" is said, as a pronoun: one or several, as the verb has it.
NounPhrase Chunker::mean_parted() const {
  NounPhrase parted;
  parted.kind = NounKind::kPronoun;
  for (std::size_t c = chunks_.size(); c-- > 0;) {
    const Chunk& before = chunks_[c];
    const std::string& word = tokens_[before.first].text;
    if (before.kind == ChunkKind::kVerb && before.passive) {
      parted.plural = word == "are" || word == "were";
      break;
    }
    if (before.kind != ChunkKind::kNoun) continue;
    parted.plural = before.noun.is_plural();
    break;
  }
  parted.head = parted.plural ? "them" : "it";
  return parted;
}

// "The sofa is separated from the table by a screen": with the screen between it and the table. The chunks stand in that order.
bool Chunker::read_parted() {
  const ChunkKind before = previous();
  const bool subject = before == ChunkKind::kNoun || before == ChunkKind::kVerb || before == ChunkKind::kComma ||
                       before == ChunkKind::kAnd || before == ChunkKind::kRelative;
  if (!subject || !is_verb_of("parting", i_)) return false;
  std::size_t from = i_ + 1;
  while (from < tokens_.size() &&
         (tokens_[from].text == "off" || tokens_[from].text == "apart" || lexicon_.is(tokens_[from], WordClass::kAdverb)))
    ++from;
  if (from >= tokens_.size() || tokens_[from].text != "from") return false;
  const auto other = read_noun_phrase(lexicon_, tokens_, from + 1, true);
  if (!other || other->kind == NounKind::kAbstract || other->last >= tokens_.size()) return false;
  std::size_t by = other->last;
  while (by + 1 < tokens_.size() && lexicon_.is(tokens_[by], WordClass::kAdverb)) ++by;
  if (by + 1 >= tokens_.size() || (tokens_[by].text != "by" && tokens_[by].text != "with")) return false;
  const auto screen = read_noun_phrase(lexicon_, tokens_, by + 1, true);
  if (!screen || screen->kind != NounKind::kObject) return false;
  const auto say = [&](ChunkKind kind, std::size_t first, std::size_t last) -> Chunk& {
    i_ = first;
    return add(kind, last - first);
  };
  const std::size_t verb = i_;
  NounPhrase parted = mean_parted();
  parted.first = from;
  parted.last = from + 1;
  say(ChunkKind::kHave, by, by + 1);
  say(ChunkKind::kNoun, screen->first, screen->last).noun = *screen;
  Chunk& between = say(ChunkKind::kRelation, verb, from);
  between.phrase.length = from - verb;
  between.phrase.senses = lexicon_.senses_of("between");
  say(ChunkKind::kNoun, from, from + 1).noun = parted;
  say(ChunkKind::kAnd, from, from + 1);
  say(ChunkKind::kNoun, other->first, other->last).noun = *other;
  i_ = screen->last;
  return true;
}

}  // namespace layoutbox::offline
