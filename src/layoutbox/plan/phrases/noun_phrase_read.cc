// Takes the words of a noun phrase one after the other: listed things, places and attributes, and what no list has.
#include <algorithm>
#include <array>
#include <string_view>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

bool NounPhraseReader::add(WordClass word_class, const Meaning& meaning, std::size_t length, bool plural) {
  parts_.push_back({i_, i_ + length, word_class, meaning, plural});
  i_ += length;
  return true;
}

bool NounPhraseReader::read_part() {
  if (read_ordinal() || read_rank()) return true;
  Match match = lexicon_.find(tokens_, i_);
  if (read_compound_adjective(match)) return true;
  match = without_attribute(without_verb(match));
  if (ends_before(match)) return false;
  const bool noun_before = std::any_of(parts_.begin(), parts_.end(), [](const PhrasePart& p) {
    return !is_attribute_class(p.word_class) && p.word_class != WordClass::kFiller && p.word_class != WordClass::kWallWord;
  });
  if (match.length > 0 && !is_verb_in_name(match) && !names_on(match)) return read_listed(match, noun_before);
  return read_unlisted();
}

// "four perches", "two repair stands": of several, a verb would have no -s.
bool NounPhraseReader::counts_plural(const Match& match) const {
  const WordForm form = noun_form(token().text);
  const bool named = parts_.empty() || (parts_.back().last == i_ && !parts_.back().plural);
  // "a stack of paper rests on the desk", "a pair of binoculars": one heap of them.
  if (!parts_.empty() && phrase_.first < i_ && lexicon_.is(tokens_[phrase_.first], WordClass::kIndefinite)) return false;
  return match.length == 1 && named && phrase_.count > 1 && plural_at(i_) && !opens_at(i_ + 1) &&
         meaning_of(match, WordClass::kObject) == nullptr && meaning_of(match, WordClass::kPart) == nullptr &&
         (form == WordForm::kThing || form == WordForm::kBody || form == WordForm::kRarelyThing);
}

// "two grab rails": after a number or an article, before a thing, no verb.
bool NounPhraseReader::is_verb_in_name(const Match& match) const {
  if (counts_plural(match)) {
    constexpr std::array kVerbs = {WordClass::kVerb,    WordClass::kPlaceVerb, WordClass::kHave,
                                   WordClass::kPurpose, WordClass::kCommand,   WordClass::kHang};
    return std::ranges::any_of(kVerbs, [&](WordClass verb) { return has(match, verb); });
  }
  // "a reflecting telescope": after an article, what the thing does.
  const bool doing = match.length == 1 && parts_.empty() && phrase_.determiner == Determiner::kIndefinite && !counted_ &&
                     token().text.ends_with("ing") && i_ + 1 < tokens_.size() && has(lexicon_.find(tokens_, i_ + 1), WordClass::kObject);
  if (doing) {
    return std::ranges::all_of(match.meanings,
                               [](const Meaning& m) { return m.word_class == WordClass::kVerb || m.word_class == WordClass::kPurpose; });
  }
  if (match.length != 1 || !parts_.empty() || !is_named() || token().text.size() < 2 || !is_noun(noun_form(token().text)) ||
      opens_at(i_ + 1))
    return false;
  if (phrase_.determiner == Determiner::kDefinite && i_ + 1 < tokens_.size() &&
      (tokens_[i_ + 1].text == "is" || tokens_[i_ + 1].text == "are"))
    return has(match, WordClass::kVerb);  // "the highlight is a piano"
  const bool thing_follows = i_ + 1 < tokens_.size() && tokens_[i_ + 1].kind == Token::Kind::kWord &&
                             is_noun(noun_form(tokens_[i_ + 1].text)) && lexicon_.find_phrase(tokens_, i_ + 1).length == 0;
  return thing_follows && std::ranges::all_of(match.meanings, [](const Meaning& m) {
           return m.word_class == WordClass::kCommand || m.word_class == WordClass::kVerb || m.word_class == WordClass::kDoer;
         });
}

bool NounPhraseReader::read_listed(const Match& match, bool noun_before) {
  const Meaning* object = meaning_of(match, WordClass::kObject);
  if (object != nullptr && has(match, WordClass::kRoom) && opens_text(i_ + match.length))
    return add(WordClass::kRoom, *meaning_of(match, WordClass::kRoom), match.length, match.plural);
  // "mid-century style table", "tan colored rug": the word belongs to the attribute before it.
  if (!parts_.empty() && is_attribute_class(parts_.back().word_class) && match.length == 1 && one_of(token().text, WordSet::kLookEnds)) {
    parts_.back().last = i_ + 1;
    ++i_;
    return true;
  }
  const bool verbal = has(match, WordClass::kParticiple) || has(match, WordClass::kPlaceVerb) || has(match, WordClass::kHang) ||
                      has(match, WordClass::kHave) || has(match, WordClass::kVerb) || has(match, WordClass::kPurpose);
  if (const std::optional<bool> thing = read_thing(match, noun_before, verbal)) return *thing;
  if (const std::optional<bool> place = read_place(match, noun_before, verbal)) return *place;
  return read_other(match, noun_before);
}

// "A bar with a counter", "I want a pantry with shelves": what something is in, where nothing else was named before, is the room.
bool NounPhraseReader::opens_text(std::size_t after) const {
  if (after >= tokens_.size() || !lexicon_.is(tokens_[after], WordClass::kHave)) return false;
  const bool had = phrase_.first > 0 && lexicon_.is(tokens_[phrase_.first - 1], WordClass::kHave);
  for (std::size_t i = 0; i < phrase_.first; ++i) {
    if (had && lexicon_.find(tokens_, i, WordClass::kRoom).length > 0) return false;  // "a pub with a bar with five stools"
    if (tokens_[i].kind == Token::Kind::kPunctuation || lexicon_.find(tokens_, i, WordClass::kObject).length > 0 ||
        lexicon_.find_phrase(tokens_, i).length > 0)
      return false;
  }
  return true;
}

// A thing, a part of one, or an attribute; nothing where the words are none of these.
std::optional<bool> NounPhraseReader::read_thing(const Match& match, bool noun_before, bool verbal) {
  const Meaning* object = meaning_of(match, WordClass::kObject);
  const Meaning* attribute = attribute_of(match);
  // A noun that is a verb as well ("light", "plant", "stand", "frames") is a verb right after another noun, unless it ends a name.
  // "glass" before a noun is what the noun is made of; "drawers" are parts where both are listed.
  const std::size_t next = i_ + match.length;
  const bool top = next < tokens_.size() && one_of(tokens_[next].text, {"top", "tops", "surface", "base"}) &&
                   !(next + 1 < tokens_.size() && tokens_[next + 1].text == "of");  // "with a glass top"
  if (const Meaning* things = attribute != nullptr && object == nullptr && !noun_before ? things_of_stuff(match) : nullptr;
      things != nullptr)
    return add(WordClass::kObject, *things, 1, true);
  if (attribute != nullptr && object != nullptr && match.length == 1 && !noun_before &&
      (noun_after(next) || top || has(lexicon_.find(tokens_, next), WordClass::kAbstract)))  // "a mustard accent"
    return add(attribute->word_class, *attribute, match.length, match.plural);
  Token single = token();
  single.text = singular_of(single.text);
  const bool part = has(match, WordClass::kPart) || (match.length == 1 && lexicon_.is(single, WordClass::kPart));
  // "along the left wall fridge, stove and sink": a place and what stands there.
  if (object != nullptr && !parts_.empty() && parts_.back().word_class == WordClass::kWall && parts_.size() > 1 &&
      parts_[parts_.size() - 2].word_class == WordClass::kWallWord && object->entry->mount == Mount::kFloor && !hyphenated(i_))
    return false;
  const bool covers =
      match.length == 1 && !parts_.empty() && parts_.back().plural && lexicon_.is_place_verb(token().text) && opens_at(i_ + 1);
  const bool verb = (verbal || covers) && noun_before && !hyphenated(i_) && !names_after_one(match);  // "curtains frame the window"
  if (object != nullptr && !verb && !part) return add(WordClass::kObject, *object, match.length, match.plural);
  if (object != nullptr && part) return add(WordClass::kPart, *object, match.length, match.plural);
  if (part && match.length == 1 && has(match, WordClass::kPart)) {  // "two sinks": parts of a vanity, or things
    const Match one = lexicon_.find({&single, 1}, 0);
    if (const Meaning* thing = meaning_of(one, WordClass::kObject); thing != nullptr && single.text != token().text)
      return add(WordClass::kPart, *thing, 1, true);
  }
  if (covers) return false;
  if (attribute == nullptr || (noun_before && verbal)) return std::nullopt;
  // "a hall with double doors": no quality of what follows.
  if (has(match, WordClass::kDoor) && !noun_after(i_ + match.length)) return std::nullopt;
  // "bed king size": an attribute after the noun ends the phrase, unless another noun follows it ("table glass lamp").
  if (noun_before && !hyphenated(i_) && !has(lexicon_.find(tokens_, i_ + match.length), WordClass::kObject)) return false;
  return add(attribute->word_class, *attribute, match.length, match.plural);
}

// A place, a room, a part, what is no thing; nothing where the words are none of these.
std::optional<bool> NounPhraseReader::read_place(const Match& match, bool noun_before, bool verbal) {
  const bool named = is_named();
  // "the window side", "the door end", "by the till side": where the window is.
  const bool known = parts_.empty() ? false : parts_.back().word_class == WordClass::kObject && phrase_.determiner == Determiner::kDefinite;
  const bool at_opening = noun_before && parts_.back().last == i_ && match.length == 1 &&
                          (known || parts_.back().word_class == WordClass::kWindow || parts_.back().word_class == WordClass::kDoor);
  if (at_opening && (at_word("side") || at_word("end")) && !at_word("of", 1)) {
    ++i_;
    return true;
  }
  for (const WordClass place : {WordClass::kDoor, WordClass::kWindow, WordClass::kWall, WordClass::kCorner, WordClass::kCenter,
                                WordClass::kFloor, WordClass::kCeiling, WordClass::kOutsideRoom, WordClass::kRoom, WordClass::kNiche,
                                WordClass::kZone, WordClass::kRoomNoun, WordClass::kPart, WordClass::kSide, WordClass::kAbstract}) {
    const Meaning* meaning = meaning_of(match, place);
    if (meaning == nullptr) continue;
    if ((place == WordClass::kSide || place == WordClass::kPart) && meaning_of(match, WordClass::kWallWord) != nullptr) {
      const Match next = lexicon_.find(tokens_, i_ + 1);
      if (has(next, WordClass::kObject) || has(next, WordClass::kWall) || has(next, WordClass::kCorner) || has(next, WordClass::kSide) ||
          has(next, WordClass::kNumber) || has(next, WordClass::kWallWord))
        break;  // "left corner"
    }
    if ((verbal && noun_before && !names_set()) || (!named && !bare_)) return false;
    // "newspapers lines the wall": the verb, not a name that goes on.
    if (noun_before && !hyphenated(i_) && (place == WordClass::kAbstract || place == WordClass::kPart) &&
        lexicon_.find_phrase(tokens_, i_).length > 0)
      return false;
    // "another table right of the sofa", "a chair back": a side after a noun is no part of its name.
    if (noun_before && place == WordClass::kSide && !hyphenated(i_)) return false;
    if (noun_before && place == WordClass::kPart && meaning_of(match, WordClass::kSide) != nullptr && !hyphenated(i_)) return false;
    return add(place, *meaning, match.length, match.plural);
  }
  return std::nullopt;
}

// A thing is named there, with its qualities: "one old chair".
bool NounPhraseReader::counts_thing(std::size_t at) const {
  constexpr std::size_t kQualities = 2;
  for (std::size_t last = at + kQualities; at < tokens_.size() && at <= last; ++at) {
    if (lexicon_.find(tokens_, at, WordClass::kObject).length > 0) return true;
    const Token& word = tokens_[at];
    const bool quality = lexicon_.is(word, WordClass::kColor) || lexicon_.is(word, WordClass::kMaterial) ||
                         lexicon_.is(word, WordClass::kSizeWord) || lexicon_.is(word, WordClass::kShape) ||
                         lexicon_.is(word, WordClass::kStyle) || word_form(word.text) == WordForm::kAdjective;
    if (!quality) return false;
  }
  return false;
}

// Sides, numbers within adjectives, members, participles, adverbs.
bool NounPhraseReader::read_other(const Match& match, bool noun_before) {
  const bool named = is_named();
  // "one left of the door": where it is, not which one.
  const std::size_t after = i_ + match.length;
  const bool side_of = after < tokens_.size() && (tokens_[after].text == "of" || tokens_[after].text == "and") && phrase_.count > 0;
  for (const WordClass word : {WordClass::kWallRelation, WordClass::kWallWord}) {
    if (side_of && named) break;
    if (const Meaning* meaning = meaning_of(match, word); meaning != nullptr && (named || bare_) && !noun_before)
      return add(word, *meaning, match.length, false);
  }
  if (has(match, WordClass::kNumber) && i_ + 1 < tokens_.size() &&
      (hyphenated(i_ + 1) || says_seats(i_ + 1) || describes(i_)))  // "one-way", "two-tone"
    return add(WordClass::kQuality, {WordClass::kQuality, nullptr, nullptr, 0, {}}, 2, false);
  if (doubles_noun(i_)) return add(WordClass::kQuality, {WordClass::kQuality, nullptr, nullptr, 0, {}}, 1, false);
  // "every desk one chair": the next thing, counted.
  const bool names_next = noun_before && parts_.back().word_class == WordClass::kObject && i_ + 1 < tokens_.size() &&
                          tokens_[i_ + 1].kind == Token::Kind::kWord && is_noun(noun_form(tokens_[i_ + 1].text)) &&
                          lexicon_.find_phrase(tokens_, i_ + 1).length == 0;  // "on this table one pack of paper"
  const bool counts_next = noun_before && (names_next || counts_thing(i_ + 1));
  const bool after_plural = noun_before && !parts_.empty() && parts_.back().plural;  // "of the two benches one has a cushion"
  // "one on the left of the screen one on the right": the second of two.
  constexpr std::size_t kBack = 10;
  bool second = false;
  for (std::size_t t = phrase_.first; noun_before && t-- > 0 && t + kBack > phrase_.first && !tokens_[t].ends_sentence && !second;)
    second = tokens_[t].text == "one" && lexicon_.find_phrase(tokens_, t + 1).length > 0;
  second = second && lexicon_.find_phrase(tokens_, i_ + 1).length > 0;
  if (at_word("ones") && named && !noun_before) {  // "blue ones", "the tall ones"
    phrase_.kind = NounKind::kMember;
    phrase_.plural = true;
    i_ += 1;
    done_ = true;
    return false;
  }
  if (has(match, WordClass::kNumber) && at_word("one") && named && !counts_next && !after_plural &&
      !second) {  // "the left one", "the other one"
    phrase_.kind = NounKind::kMember;
    i_ += 1;
    done_ = true;
    return false;
  }
  // Participles and verbs stand before the noun only: "a folded blanket", "a rolling chair".
  if (!noun_before && named && (has(match, WordClass::kParticiple) || has(match, WordClass::kHang) || has(match, WordClass::kVerb)) &&
      match.length == 1 && (token().text.ends_with("ed") || token().text.ends_with("ing")) &&
      lexicon_.find_phrase(tokens_, i_).length < 2 && lexicon_.find(tokens_, i_, WordClass::kHave).length < 2) {  // "each filled with"
    return add(WordClass::kFiller, match.meanings.front(), 1, false);
  }
  const bool rather = has(match, WordClass::kAdverb) || at_word("otherwise");  // "an otherwise bare gallery"
  if (!noun_before && named && rather && lexicon_.find_phrase(tokens_, i_).length <= match.length) {
    i_ += match.length;
    return true;
  }
  return false;
}

void NounPhraseReader::read_parts() {
  constexpr std::size_t kMostParts = 12;
  while (more() && parts_.size() < kMostParts && !done_) {
    if (token().text == "'s") {
      const bool noun = !parts_.empty() && !is_attribute_class(parts_.back().word_class);
      if (!noun) break;
      // "teenager's bedroom", "child's desk", "the cat's bed": a person or an animal owns it; "the bed's foot": a thing does.
      const CatalogEntry* entry = parts_.back().meaning.entry;
      const bool animal = entry != nullptr && entry->is(Trait::kPet);
      if (animal) {
        parts_.clear();
        ++i_;
        continue;
      }
      if (parts_.back().word_class == WordClass::kObject || parts_.back().word_class == WordClass::kRoom) {
        phrase_.owner = true;
        break;
      }
      phrase_.owner_word = text_of(tokens_, parts_.back().first, parts_.back().last);
      parts_.clear();
      ++i_;
      continue;
    }
    if (token().kind == Token::Kind::kPunctuation || token().text == "and") {
      if ((token().text == "," || token().text == "and") && goes_on_after_break()) {
        ++i_;
        if (more() && token().text == "and") ++i_;
        continue;
      }
      break;
    }
    if ((token().kind == Token::Kind::kNumber || at_word("diameter")) && take_size()) continue;
    if (count_follows() || verb_follows() || !read_part()) break;
  }
}

// "two benches border the rug", "three trunks block the corner": between a plural thing and an article stands no noun.
bool NounPhraseReader::verb_follows() const {
  if (parts_.empty() || !parts_.back().plural || parts_.back().last != i_ || i_ + 1 >= tokens_.size()) return false;
  const WordClass before = parts_.back().word_class;
  const Token& next = tokens_[i_ + 1];
  return (before == WordClass::kObject || before == WordClass::kFiller) && token().kind == Token::Kind::kWord && !hyphenated(i_) &&
         (lexicon_.is(next, WordClass::kDefinite) || lexicon_.is(next, WordClass::kIndefinite) ||
          lexicon_.is(next, WordClass::kPossessive));
}

// "bookcases x2", "2 desks, chairs x 4": the number behind the noun.
bool NounPhraseReader::count_follows() const {
  if (parts_.empty() || i_ + 1 >= tokens_.size() || tokens_[i_].text != "x" || tokens_[i_ + 1].kind != Token::Kind::kNumber) return false;
  return i_ + 2 == tokens_.size() || tokens_[i_ + 2].kind == Token::Kind::kPunctuation || !tokens_[i_ + 2].glued;
}

}  // namespace layoutbox::offline
