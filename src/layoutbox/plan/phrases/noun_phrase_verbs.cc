// Where a noun phrase was read on into the verb after it.
#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {

// "a bear guards a safe": one bear, and what it does. "The party shoulders open the door." "A floor lamp towers over the chair."
bool NounPhraseReader::ends_in_verb(std::size_t head) const {
  const bool definite = phrase_.determiner == Determiner::kDefinite || phrase_.determiner == Determiner::kPossessive ||
                        phrase_.determiner == Determiner::kEach;
  if (head < 2 || phrase_.count != 0) return false;
  const PhrasePart &last = parts_[head - 1], &before = parts_[head - 2];
  const bool place_follows = last.last < tokens_.size() && lexicon_.find_phrase(tokens_, last.last).length > 0;
  // "Sunlight spills over the table."
  if (phrase_.determiner == Determiner::kNone && before.word_class == WordClass::kAbstract && last.word_class == WordClass::kFiller)
    return !before.plural && last.plural && (place_follows || opens_at(last.last));
  if (phrase_.determiner != Determiner::kIndefinite && !definite) return false;
  const bool listed_noun = last.word_class == WordClass::kAbstract && place_follows;
  const bool whom = opens_at(last.last) || (last.last < tokens_.size() && lexicon_.is(tokens_[last.last], WordClass::kDoer));  // "nobody"
  if (!last.plural || before.plural || (last.word_class != WordClass::kFiller && !whom && !listed_noun)) return false;
  if (definite) {
    const bool particle = last.last < tokens_.size() && lexicon_.is(tokens_[last.last], WordClass::kVerb);
    const std::size_t object = last.last + (particle ? 1 : 0);
    const bool whose =
        object < tokens_.size() && (lexicon_.is(tokens_[object], WordClass::kEach) || lexicon_.is(tokens_[object], WordClass::kPossessive));
    const bool places = before.word_class == WordClass::kObject && place_follows && may_be_verb(tokens_[last.last - 1].text);
    return last.last - last.first == 1 && (opens_at(object) || whose || places);
  }
  const bool room = before.word_class == WordClass::kRoom && opens_at(last.last);  // "a gallery stages a plinth"
  return room || before.word_class == WordClass::kObject || (before.word_class == WordClass::kFiller && is_thing(before));
}

// "a gripper sorts bolts", "a lamp throws light on it": what one thing does, within what was taken for one name. Names have no plural
// before their last word.
void NounPhraseReader::end_before_doing() {
  const bool one = phrase_.determiner == Determiner::kIndefinite || phrase_.determiner == Determiner::kDefinite;
  if (!one || phrase_.count != 0) return;
  for (std::size_t p = 1; p + 1 < parts_.size(); ++p) {
    const PhrasePart &before = parts_[p - 1], &verb = parts_[p], &what = parts_[p + 1];
    const WordForm form = word_form(tokens_[before.last - 1].text);
    const bool thing = before.word_class == WordClass::kObject ||
                       (before.word_class == WordClass::kFiller && (form == WordForm::kThing || form == WordForm::kUnknown));
    const bool does =
        verb.plural && verb.last == verb.first + 1 && (verb.word_class == WordClass::kFiller || verb.word_class == WordClass::kObject);
    const bool uncounted = what.plural || one_of(tokens_[what.last - 1].text, WordSet::kDaylight);
    if (!thing || before.plural || !does || !uncounted || hyphenated(verb.first) || before.last != verb.first || verb.last != what.first)
      continue;
    parts_.resize(p);
    return;
  }
}

// "a mirror crowns the dresser": the thing, though its name is a material before a noun.
void NounPhraseReader::mean_thing_before_verb(std::size_t head) {
  if (head < 2 || phrase_.count != 0 || phrase_.determiner == Determiner::kNone) return;
  const PhrasePart& verb = parts_[head - 1];
  PhrasePart& thing = parts_[head - 2];
  const bool does =
      verb.plural && verb.last == verb.first + 1 && opens_at(verb.last) && lexicon_.find_phrase(tokens_, verb.first).length > 0;
  if (!does || thing.plural || !is_attribute_class(thing.word_class) || thing.last != verb.first) return;
  const Match match = lexicon_.find(tokens_.first(thing.last), thing.first);
  const Meaning* object = meaning_of(match, WordClass::kObject);
  if (object == nullptr || match.length != thing.last - thing.first) return;
  thing.word_class = WordClass::kObject;
  thing.meaning = *object;
}

// "two sconces guard it", "the stools rim the table", "three brushes stick up in the jar": several, and what they do. Compounds begin with
// one ("sconce guard").
bool NounPhraseReader::ends_in_plural_verb(std::size_t head) const {
  if (head < 2) return false;
  const PhrasePart &last = parts_[head - 1], &before = parts_[head - 2];
  if (last.last != last.first + 1 || before.last != last.first || hyphenated(last.first) || last.plural || !before.plural ||
      before.word_class != WordClass::kObject || last.last >= tokens_.size())
    return false;
  const Token& next = tokens_[last.last];
  const bool placed = phrase_.count > 1 && place_at(last.last);
  if (placed && lexicon_.find_phrase(tokens_, last.last).length == 0) return true;  // "stick up in"
  const bool object = placed || lexicon_.is(next, WordClass::kDefinite) || lexicon_.is(next, WordClass::kIndefinite) ||
                      lexicon_.is(next, WordClass::kPronoun) || lexicon_.is(next, WordClass::kPossessive);
  return object && may_be_verb(tokens_[last.first].text);
}

// "Planks lean against the wall", "three planks": the things themselves, though floors are called so; null: what something is made of.
const Meaning* NounPhraseReader::things_of_stuff(const Match& match) const {
  const std::size_t next = i_ + match.length;
  if (match.length != 1 || !plural_at(i_) || next >= tokens_.size() || noun_after(next)) return nullptr;
  const bool acts = lexicon_.is(tokens_[next], WordClass::kPlaceVerb) || lexicon_.is(tokens_[next], WordClass::kHang);
  if (!(counted_ && phrase_.count > 1) && !(acts && !lexicon_.is(tokens_[next], WordClass::kBe))) return nullptr;
  Token single = token();
  single.text = singular_of(single.text);
  return meaning_of(lexicon_.find({&single, 1}, 0), WordClass::kObject);
}

// "the wardrobe or a bookcase can divide the room", "seven guests can eat at the counter": what they may do, and no tin.
bool NounPhraseReader::ends_in_can(std::size_t head) const {
  if (head < 2 || parts_[head - 1].last != parts_[head - 1].first + 1 || tokens_[parts_[head - 1].first].text != "can") return false;
  const std::size_t next = parts_[head - 1].last;
  const std::string& who = tokens_[parts_[head - 2].last - 1].text;
  const bool person = word_form(singular_of(who)) == WordForm::kPerson || lexicon_.is_person(singular_of(who));
  return (person || parts_[head - 2].word_class == WordClass::kObject) && next < tokens_.size() &&
         tokens_[next].kind == Token::Kind::kWord && !place_at(next) && !lexicon_.is(tokens_[next], WordClass::kAnd) &&
         !is_finite(tokens_[next].text);
}

// Whether a place is said there: "in the corner", "up against the wall".
bool NounPhraseReader::place_at(std::size_t at) const {
  static constexpr std::string_view kParticles[] = {"up", "down", "out", "off", "over", "away", "back"};
  if (at >= tokens_.size() || tokens_[at].text == "of") return false;
  if (lexicon_.find_phrase(tokens_, at).length > 0) return true;
  return std::find(std::begin(kParticles), std::end(kParticles), tokens_[at].text) != std::end(kParticles) &&
         lexicon_.find_phrase(tokens_, at + 1).length > 0;
}

// No verb comes before the sentence or clause is over.
bool NounPhraseReader::lacks_verb(std::size_t at) const {
  for (; at < tokens_.size() && tokens_[at].kind == Token::Kind::kWord; ++at) {
    const Token& word = tokens_[at];
    const bool has = word.text != "with" && lexicon_.is(word, WordClass::kHave);
    if (has || lexicon_.is(word, WordClass::kBe) || (lexicon_.is(word, WordClass::kPlaceVerb) && is_finite(word.text))) return false;
  }
  return true;
}

// "the harp slouches in the corner", "a robe floats by the door": one thing, and what it does there.
bool NounPhraseReader::ends_in_doing(std::size_t head) const {
  if (head < 2 || phrase_.count > 1 || counted_) return false;
  const PhrasePart &last = parts_[head - 1], &before = parts_[head - 2];
  const bool one = phrase_.determiner == Determiner::kIndefinite;
  if (!one && phrase_.determiner != Determiner::kDefinite && phrase_.determiner != Determiner::kPossessive) return false;
  const std::string& word = tokens_[last.first].text;
  if (last.last != last.first + 1 || before.last != last.first || hyphenated(last.first) || !last.plural || before.plural ||
      before.word_class != WordClass::kObject || !place_at(last.last))
    return false;
  if ((one && may_be_verb(word)) || word_form(word) == WordForm::kVerb) return true;
  return (phrase_.first == 0 || tokens_[phrase_.first - 1].ends_sentence) && lacks_verb(last.last);
}

}  // namespace layoutbox::offline
