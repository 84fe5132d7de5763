// Which word of a noun phrase is its head, and whether that is a thing.
#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

// "an owl", "a cross"; no "leading", no "ride" of "ride-on".
bool NounPhraseReader::is_thing_where_named(const PhrasePart& part) const {
  const std::string& word = tokens_[part.last - 1].text;
  if (word.ends_with("ing") || word.ends_with("ed") || hyphenated(part.last)) return false;
  const WordForm noun = noun_form(word);
  return noun == WordForm::kBody || noun == WordForm::kThing;
}

bool NounPhraseReader::is_thing(const PhrasePart& part) const {
  const WordForm form = word_form(tokens_[part.last - 1].text);
  return form == WordForm::kThing || form == WordForm::kBody;
}

bool NounPhraseReader::has_attribute(WordClass word_class) const {
  return std::find(phrase_.attribute_classes.begin(), phrase_.attribute_classes.end(), word_class) != phrase_.attribute_classes.end();
}

// "wooden mandir", "red zafu": a word that nobody knows, but what it looks like.
bool NounPhraseReader::is_bodily_described() const {
  return has_attribute(WordClass::kMaterial) || has_attribute(WordClass::kColor) || has_attribute(WordClass::kShape) ||
         has_attribute(WordClass::kSizeWord);
}

// "; transceiver on the desk", "- sconce, mirror": a word that nobody knows where a thing is named without its article. Not the first
// of the text, nor with a capital letter within a sentence: those call somebody.
bool NounPhraseReader::is_unknown_subject(const PhrasePart& part) const {
  constexpr std::size_t kShortest = 5;  // shorter ones are rather said by the way
  const Token& word = tokens_[part.first];
  if (part.last != part.first + 1 || part.first != phrase_.first || part.first == 0 || word.text.size() < kShortest) return false;
  const Token& before = tokens_[part.first - 1];
  if (word.capital && !(before.ends_sentence && lexicon_.find_phrase(tokens_, part.last).length > 0)) return false;
  if (before.kind != Token::Kind::kPunctuation && !lexicon_.is(before, WordClass::kAnd)) return false;
  if (lexicon_.find_phrase(tokens_, part.last).length > 0) return true;
  const bool listed =
      part.last + 1 < tokens_.size() && (tokens_[part.last].text == "," || lexicon_.is(tokens_[part.last], WordClass::kAnd));
  return listed && (lexicon_.find(tokens_, part.last + 1, WordClass::kObject).length > 0 ||
                    lexicon_.find(tokens_, part.last + 2, WordClass::kObject).length > 0);
}

// "two blue cases", "a game case", "a metal case"; a plain "case" is none.
bool NounPhraseReader::is_rare_thing(const PhrasePart& part, std::size_t head) const {
  const std::string& word = tokens_[part.last - 1].text;
  if (word.ends_with("ing") || word.ends_with("ed") || noun_form(word) != WordForm::kRarelyThing) return false;
  const bool counted = counted_ && !phrase_.vague && phrase_.count > 1;
  const bool compound = is_compound(head);
  return counted || compound || has_attribute(WordClass::kColor) || has_attribute(WordClass::kMaterial);
}

// "drawing board", "flannel board", "cardboard tubes": compounds of a head that usually is a thing; "wooden boards" are stuff.
bool NounPhraseReader::has_telling_head(const PhrasePart& part, std::size_t head) const {
  if (head == 0 || parts_[head - 1].last != part.first || !is_kin_head(singular_of(tokens_[part.last - 1].text))) return false;
  const WordClass before = parts_[head - 1].word_class;
  return before == WordClass::kFiller || before == WordClass::kObject || (before == WordClass::kMaterial && !part.plural);
}

// "a kettlebell set", "a first aid kit": the things themselves, as one.
void NounPhraseReader::join_set(std::size_t& head) {
  if (head < 2) return;
  const PhrasePart& last = parts_[head - 1];
  PhrasePart& thing = parts_[head - 2];
  if (thing.word_class != WordClass::kObject || thing.last != last.first || thing.last + 1 != last.last ||
      last.word_class == WordClass::kObject || lexicon_.set_of(text_of(tokens_, thing.first, last.last)) != nullptr)
    return;
  const std::string word = singular_of(tokens_[last.first].text);
  if (!one_of(word, WordSet::kTogether)) return;
  thing.last = last.last;
  thing.plural = last.plural;
  parts_.erase(parts_.begin() + static_cast<std::ptrdiff_t>(head) - 1);
  --head;
}

// "a drying rack thing": the rack; "an armchair pair": two. Where the phrase ends then, 0 where no such word is there.
std::size_t NounPhraseReader::drop_thing(std::size_t& head) {
  if (head < 2 || head != parts_.size()) return 0;
  const PhrasePart &last = parts_[head - 1], &named = parts_[head - 2];
  if (named.word_class != WordClass::kObject || named.last != last.first || last.last != last.first + 1 ||
      !one_of(tokens_[last.first].text, WordSet::kVagueThings))
    return 0;
  const std::size_t end = last.last;
  const std::string& word = tokens_[last.first].text;
  if ((word == "pair" || word == "duo") && phrase_.count == 0) phrase_.count = 2;
  parts_.pop_back();
  --head;
  return end;
}

// "one overturned", "two broken": so many of those that were named.
bool NounPhraseReader::is_described_member() const {
  if (!counted_ || parts_.size() != 1 || parts_.front().word_class != WordClass::kFiller || parts_.front().last != parts_.front().first + 1)
    return false;
  const std::string& word = tokens_[parts_.front().first].text;
  const std::size_t after = parts_.front().last;
  const bool ends =
      after >= tokens_.size() || tokens_[after].kind == Token::Kind::kPunctuation || lexicon_.is(tokens_[after], WordClass::kAnd);
  return ends && phrase_.first + 2 == after && word.ends_with("ed") && !is_noun(word_form(word));
}

// "the TV wall": the TV on it. Where the phrase ends then, 0 where it is another wall.
std::size_t NounPhraseReader::drop_own_wall(std::size_t& head) {
  if (head < 2 || parts_[head - 1].word_class != WordClass::kWall || parts_[head - 2].last != parts_[head - 1].first) return 0;
  const Meaning* screen = meaning_of(lexicon_.find(tokens_, parts_[head - 2].first, WordClass::kObject), WordClass::kObject);
  if (parts_[head - 2].word_class != WordClass::kObject || screen == nullptr || screen->entry == nullptr ||
      !screen->entry->is(Trait::kScreen))
    return 0;
  const std::size_t end = parts_[head - 1].last;
  parts_.pop_back();
  --head;
  return end;
}

// Whether the part at `head` follows right after a noun: "cipher wheel", "eyewash station".
bool NounPhraseReader::is_compound(std::size_t head) const {
  if (head == 0 || parts_[head - 1].last != parts_[head].first) return false;
  const PhrasePart& before = parts_[head - 1];
  const std::string& word = tokens_[before.last - 1].text;
  if (before.word_class == WordClass::kObject || before.word_class == WordClass::kZone) return !before.plural;
  if (before.word_class != WordClass::kFiller || word.ends_with("ing") || word.ends_with("ed")) return false;
  WordForm form = word_form(word);
  if (form == WordForm::kVerb) form = noun_form(word);  // "a call button"
  return is_noun(form) || form == WordForm::kUnknown;
}

// "a plush", "miniature", "toy" something
bool NounPhraseReader::is_modeled(std::size_t head) const {
  return std::any_of(parts_.begin(), parts_.begin() + static_cast<std::ptrdiff_t>(head),
                     [&](const PhrasePart& p) { return p.last == p.first + 1 && is_kin_modifier(tokens_[p.first].text); });
}

// "a miniature station", "plush animals", "a toy garage", "eyewash station": a thing, though the last word alone is none.
bool NounPhraseReader::is_thing_by_name(std::size_t head) const {
  const PhrasePart& part = parts_[head];
  const std::string& word = tokens_[part.last - 1].text;
  const bool station = part.word_class == WordClass::kZone && singular_of(word) == "station";
  if (station && is_compound(head)) return true;
  if (!is_modeled(head)) return false;
  constexpr std::size_t kOpening = 3;  // "a miniature house with …" is what the text is about
  if (part.word_class == WordClass::kRoom || part.word_class == WordClass::kRoomNoun) return phrase_.first >= kOpening && is_compound(head);
  return station || (part.word_class == WordClass::kAbstract && is_thing_where_named(part));
}

// "a tall magnolia", "two topazes": what a color has its name from, where nothing is of that color; not "painted a jade", "a soft sage".
bool NounPhraseReader::is_namesake(std::size_t head) const {
  const PhrasePart& part = parts_[head];
  const std::string& word = tokens_[part.first].text;
  const bool stuff = part.word_class == WordClass::kMaterial;  // "a cloth over the rail", "a slate on the wall"
  if ((part.word_class != WordClass::kColor && !stuff) || part.last != part.first + 1 || word_form(word) == WordForm::kAdjective)
    return false;
  if (stuff && !one_of(word, WordSet::kNamedAsStuff)) return false;
  if (phrase_.determiner != Determiner::kIndefinite && !(counted_ && phrase_.count > 1)) return false;
  const bool told = phrase_.first > 0 && one_of(tokens_[phrase_.first - 1].text, {"in", "painted", "of", "is", "are"});
  const WordForm form = noun_form(word);
  const auto is_size = [](const PhrasePart& p) { return p.word_class == WordClass::kSizeWord; };
  return !told && (form == WordForm::kThing || form == WordForm::kBody || form == WordForm::kUnknown) &&
         std::all_of(parts_.begin(), parts_.begin() + static_cast<std::ptrdiff_t>(head), is_size);
}

// The head is the last noun; words after it that are not nouns were read too far.
void NounPhraseReader::find_head(std::size_t& head) {
  for (head = parts_.size(); head > 0; --head) {
    PhrasePart& part = parts_[head - 1];
    if (!is_attribute_class(part.word_class) && part.word_class != WordClass::kWallWord && part.word_class != WordClass::kWallRelation)
      return;
    // "a climbing cube", "two wooden spheres"
    const bool shape = part.word_class == WordClass::kShape && head == parts_.size() && is_noun(word_form(tokens_[part.last - 1].text));
    if (head == parts_.size() && is_namesake(head - 1)) {
      part.word_class = WordClass::kFiller;
      part.plural = plural_at(part.last - 1);
      return;
    }
    if (shape && is_named() && !(part.first > 0 && tokens_[part.first - 1].text == "all") &&
        (head == 1 || parts_[head - 2].last == part.first)) {
      part.word_class = WordClass::kFiller;
      part.plural = plural_at(part.last - 1);
      shaped_ = true;
      return;
    }
  }
  if (parts_.empty()) return;
  PhrasePart& last = parts_.back();  // "a family": an adjective that is a noun as well
  const Match match = lexicon_.find(tokens_.first(last.last), last.first);
  if (last.word_class != WordClass::kQuality || meaning_of(match, WordClass::kAbstract) == nullptr ||
      phrase_.determiner != Determiner::kIndefinite)
    return;
  last.word_class = WordClass::kAbstract;
  head = parts_.size();
}

}  // namespace layoutbox::offline
