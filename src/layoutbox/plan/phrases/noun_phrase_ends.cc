// Words that end a name though elsewhere they are verbs, commands or units: "a pipe stand", "a station model", "three parking meters".
#include <algorithm>

#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

// "a miniature station model", "three parking meters", "a dog lead hook": no command, unit or verb within a name.
bool NounPhraseReader::names_on(const Match& match) const {
  const std::string& text = token().text;
  if (match.length != 1 || parts_.empty() || parts_.back().last != i_ || opens_at(i_ + 1) || text.size() < 2 || !is_noun(noun_form(text)))
    return false;
  const bool one = phrase_.determiner == Determiner::kIndefinite && phrase_.count == 0 && !parts_.back().plural && !plural_at(i_) &&
                   !text.ends_with("ed") && !text.ends_with("ing");
  return std::all_of(match.meanings.begin(), match.meanings.end(), [&](const Meaning& m) {
    const bool verb = m.word_class == WordClass::kVerb || m.word_class == WordClass::kPurpose;
    return m.word_class == WordClass::kCommand || m.word_class == WordClass::kUnit || (one && verb);
  });
}

// "a wreath stand", "an owl perch", "the witness stand": after one thing a verb would have its -s; but "let a lamp stand".
bool NounPhraseReader::names_after_one(const Match& match) const {
  const std::string& text = token().text;
  if (match.length != 1 || parts_.empty() || parts_.back().last != i_ || parts_.back().plural || has(match, WordClass::kParticiple))
    return false;
  const std::string& named = tokens_[i_ - 1].text;  // "a truing stand", "a wig stand"
  const WordClass before_it = parts_.back().word_class;
  const bool noun = before_it == WordClass::kObject || before_it == WordClass::kRoom || before_it == WordClass::kAbstract ||
                    (before_it == WordClass::kFiller && (named.ends_with("ing") || is_noun(word_form(named))));
  // "; thurible stand, in a corner"
  const bool item = phrase_.determiner == Determiner::kNone && bare_ && phrase_.first > 0 && tokens_[phrase_.first - 1].ends_sentence;
  const bool told = phrase_.determiner == Determiner::kDefinite &&
                    (phrase_.first == 0 || tokens_[phrase_.first - 1].ends_sentence ||
                     (tokens_[phrase_.first - 1].kind == Token::Kind::kWord &&
                      lexicon_.find_phrase(tokens_, phrase_.first - 1).length == 0));  // not "on the mantel stand a clock and a vase"
  const bool one = phrase_.determiner == Determiner::kIndefinite || told || item;
  if (!noun || !one || phrase_.count != 0) return false;
  if (plural_at(i_) || text.ends_with("ed") || text.ends_with("ing") || opens_at(i_ + 1)) return false;
  if (phrase_.first == 0) return true;
  const Token& before = tokens_[phrase_.first - 1];  // "a table and a lamp stand in the corner": of both
  return (!lexicon_.is(before, WordClass::kAnd) || ends_what_is_had()) && !one_of(before.text, WordSet::kCausing);
}

// "with a globe and a pipe stand.", "topped by a clock and a pen stand on it": what something has ends with that word, so it is no verb.
bool NounPhraseReader::ends_what_is_had() const {
  constexpr std::size_t kBack = 12;
  const std::size_t next = i_ + 1, place = next < tokens_.size() ? lexicon_.find_phrase(tokens_, next).length : 0;
  const auto speaks_of_it = [](const Token& token) { return token.text == "it" || token.text == "its"; };
  const bool over = next >= tokens_.size() || tokens_[next].kind == Token::Kind::kPunctuation ||
                    lexicon_.is(tokens_[next], WordClass::kAnd) || std::ranges::any_of(tokens_.subspan(next, place), speaks_of_it) ||
                    (next + place < tokens_.size() && place > 0 && speaks_of_it(tokens_[next + place]));
  for (std::size_t t = phrase_.first; over && t-- > 0 && t + kBack > phrase_.first && !tokens_[t].ends_sentence;) {
    const PhraseMatch phrase = lexicon_.find_phrase(tokens_, t);
    const bool holds = phrase.length > 0 && has_direction(*phrase.senses, Direction::kInverse);
    if (holds || lexicon_.is(tokens_[t], WordClass::kHave) || lexicon_.find(tokens_, t, WordClass::kThere).length > 0) return true;
    if (lexicon_.is(tokens_[t], WordClass::kRelative)) return false;
  }
  return false;
}

}  // namespace layoutbox::offline
