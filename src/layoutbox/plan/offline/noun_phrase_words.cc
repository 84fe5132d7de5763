// The words of a noun phrase up to its head: attributes, compounds, and where it ends.
#include <string_view>
#include <utility>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/offline/english.h"
#include "layoutbox/plan/offline/noun_phrase_parts.h"

namespace layoutbox::offline {

using Class = WordClass;

// After a comma or "and" within a row of adjectives: "rectangular, wooden table", "cozy and well-lit room".
bool NounPhraseReader::goes_on_after_break() const {
  const bool adjectives = !parts_.empty() && std::all_of(parts_.begin(), parts_.end(), [](const Part& p) {
    return is_attribute_class(p.word_class) || p.word_class == Class::kFiller;
  });
  if (!adjectives || i_ + 1 >= tokens_.size()) return false;
  const Match next = lexicon_.find(tokens_, i_ + 1);
  if (attribute_of(next) != nullptr) return true;
  return next.length == 0 && tokens_[i_ + 1].kind == Token::Kind::kWord && at_word("and") &&
         word_form(tokens_[i_ + 1].text) == WordForm::kAdjective;
}

// An unlisted word within the phrase: an adjective or a part of the name, or already the next verb.
bool NounPhraseReader::word_may_belong() const {
  const std::string& text = token().text;
  if (hyphenated(i_)) return true;
  const bool noun_before = std::any_of(parts_.begin(), parts_.end(),
                                       [](const Part& p) { return p.word_class == Class::kObject || p.word_class == Class::kRoom; });
  const WordForm form = word_form(text);
  if (!noun_before) return form != WordForm::kAdverb;
  if (text.ends_with("ed") || text.ends_with("ing") || text.ends_with("ly"))
    return form == WordForm::kThing && !text.ends_with("ing") && !text.ends_with("ed");
  return is_noun(form) || form == WordForm::kUnknown;
}

// "the second bed", "the last one"
bool NounPhraseReader::read_ordinal() {
  static constexpr std::pair<std::string_view, int> kOrdinals[] = {{"first", 1},  {"1st", 1},   {"second", 2}, {"2nd", 2},  {"third", 3},
                                                                   {"fourth", 4}, {"fifth", 5}, {"sixth", 6},  {"last", -1}};
  if (!parts_.empty() || counted_ || phrase_.determiner != Determiner::kDefinite || hyphenated(i_ + 1)) return false;
  for (const auto& [word, place] : kOrdinals) {
    if (!at_word(word)) continue;
    phrase_.ordinal = place;
    ++i_;
    return true;
  }
  return false;
}

// The name of a thing at `at`, or after a part and its attributes: "glass top bistro table".
bool NounPhraseReader::noun_after(std::size_t at) const {
  constexpr int kMostBetween = 3;
  for (int between = 0; between <= kMostBetween && at < tokens_.size(); ++between) {
    const Match next = lexicon_.find(tokens_, at);
    if (has(next, Class::kObject) && !has(next, Class::kPart)) return !has(next, Class::kPlaceVerb) && !has(next, Class::kHave);
    if (!has(next, Class::kPart) && (between == 0 || attribute_of(next) == nullptr)) return false;
    at += next.length;
  }
  return false;
}

// "a kettlebell set and …": no verb where nothing says what is set.
bool NounPhraseReader::names_set() const {
  return at_word("set") && parts_.back().word_class == Class::kObject && !parts_.back().plural && parts_.back().last == i_ &&
         (i_ + 1 >= tokens_.size() || tokens_[i_ + 1].kind == Token::Kind::kPunctuation || lexicon_.is(tokens_[i_ + 1], Class::kAnd));
}

bool NounPhraseReader::read_part() {
  if (read_ordinal()) return true;
  Match match = lexicon_.find(tokens_, i_);
  // "light-filled", "hand-knotted", "ladder-back": one adjective, whatever its first word is.
  if (match.length < 2 && i_ + 1 < tokens_.size() && hyphenated(i_ + 1) && token().kind == Token::Kind::kWord &&
      ((tokens_[i_ + 1].text.ends_with("ed") || tokens_[i_ + 1].text == "style" || tokens_[i_ + 1].text == "free") ||
       (has(lexicon_.find(tokens_, i_ + 1), Class::kSide) && has(lexicon_.find(tokens_, i_ + 2), Class::kObject))) &&
      lexicon_.find(tokens_, i_ + 1, Class::kObject).length == 0) {
    parts_.push_back({i_, i_ + 2, Class::kQuality, {Class::kQuality, nullptr, nullptr, 0, {}}, false});
    i_ += 2;
    return true;
  }
  // "a plant stands in the corner" is no plant stand.
  const auto plural_at = [&](std::size_t i) { return singular_of(tokens_[i].text) != tokens_[i].text; };
  if (match.length > 1 && lexicon_.is(tokens_[i_ + match.length - 1], Class::kPlaceVerb)) {
    const std::size_t after = i_ + match.length;
    const bool subject_follows =
        after < tokens_.size() && (lexicon_.is(tokens_[after], Class::kIndefinite) || lexicon_.is(tokens_[after], Class::kNumber) ||
                                   tokens_[after].kind == Token::Kind::kNumber);  // "in the corner stands a"
    const bool singular_subject = match.plural && phrase_.count == 0 && (phrase_.determiner == Determiner::kIndefinite || subject_follows);
    const bool plural_subject = !match.plural && plural_at(i_ + match.length - 2) && !plural_at(i_ + match.length - 1);  // "speakers stand"
    if (singular_subject || plural_subject) match = lexicon_.find(tokens_.first(i_ + match.length - 1), i_);
  }
  if (!parts_.empty() && parts_.back().last == i_ && plural_at(i_ - 1) && match.length == 1 && !plural_at(i_) &&
      has(match, Class::kPlaceVerb) && !is_attribute_class(parts_.back().word_class))
    return false;
  // "both stand", "all sit": the verb.
  if (parts_.empty() && phrase_.determiner == Determiner::kBoth && match.length == 1 && !plural_at(i_) && has(match, Class::kPlaceVerb))
    return false;
  // "two desks side by side": a place, no part of the name.
  if (!parts_.empty() && lexicon_.find_phrase(tokens_, i_).length > std::max<std::size_t>(match.length, 1)) return false;
  const auto add = [&](Class word_class, const Meaning& meaning, std::size_t length, bool plural) {
    parts_.push_back({i_, i_ + length, word_class, meaning, plural});
    i_ += length;
    return true;
  };
  const bool named = !parts_.empty() || phrase_.determiner != Determiner::kNone || counted_;
  const bool noun_before = std::any_of(parts_.begin(), parts_.end(), [](const Part& p) {
    return !is_attribute_class(p.word_class) && p.word_class != Class::kFiller && p.word_class != Class::kWallWord;
  });
  if (match.length > 0) {
    const Meaning* object = meaning_of(match, Class::kObject);
    // "A bar with a counter": at the very beginning what something is in is the room.
    if (object != nullptr && has(match, Class::kRoom) && phrase_.first < 2 && i_ + match.length < tokens_.size() &&
        lexicon_.is(tokens_[i_ + match.length], Class::kHave))
      return add(Class::kRoom, *meaning_of(match, Class::kRoom), match.length, match.plural);
    const Meaning* attribute = attribute_of(match);
    // "mid-century style table", "tan colored rug": the word belongs to the attribute before it.
    static constexpr std::string_view kOfAttribute[] = {"style", "styled", "themed", "inspired", "shaped", "toned", "colored",
                                                        "size",  "sized",  "type",   "looking",  "backed", "topped"};
    if (!parts_.empty() && is_attribute_class(parts_.back().word_class) && match.length == 1 &&
        std::find(std::begin(kOfAttribute), std::end(kOfAttribute), token().text) != std::end(kOfAttribute)) {
      parts_.back().last = i_ + 1;
      ++i_;
      return true;
    }
    const bool verbal = has(match, Class::kParticiple) || has(match, Class::kPlaceVerb) || has(match, Class::kHang) ||
                        has(match, Class::kHave) || has(match, Class::kVerb) || has(match, Class::kPurpose);
    // A noun that is a verb as well ("light", "plant", "stand", "frames") is a verb right after another noun, unless it ends a name.
    // "glass" before a noun is what the noun is made of; "drawers" are parts where both are listed.
    const bool noun_next = noun_after(i_ + match.length);
    if (attribute != nullptr && object != nullptr && match.length == 1 && noun_next && !noun_before)
      return add(attribute->word_class, *attribute, match.length, match.plural);
    Token single = token();
    single.text = singular_of(single.text);
    const bool part = has(match, Class::kPart) || (match.length == 1 && lexicon_.is(single, Class::kPart));
    // "along the left wall fridge, stove and sink": a place and what stands there.
    if (object != nullptr && !parts_.empty() && parts_.back().word_class == Class::kWall && parts_.size() > 1 &&
        parts_[parts_.size() - 2].word_class == Class::kWallWord && object->entry->mount == Mount::kFloor && !hyphenated(i_))
      return false;
    if (object != nullptr && !(verbal && noun_before && !hyphenated(i_)) && !part)
      return add(Class::kObject, *object, match.length, match.plural);
    if (object != nullptr && part) return add(Class::kPart, *object, match.length, match.plural);
    if (part && match.length == 1 && has(match, Class::kPart)) {  // "two sinks": parts of a vanity, or things
      const Match one = lexicon_.find({&single, 1}, 0);
      if (const Meaning* thing = meaning_of(one, Class::kObject); thing != nullptr && single.text != token().text)
        return add(Class::kPart, *thing, 1, true);
    }
    if (attribute != nullptr && !(noun_before && verbal)) {
      if (noun_before && !hyphenated(i_)) {
        // "bed king size": an attribute after the noun ends the phrase, unless another noun follows it ("table glass lamp").
        const Match next = lexicon_.find(tokens_, i_ + match.length);
        if (!has(next, Class::kObject)) return false;
      }
      return add(attribute->word_class, *attribute, match.length, match.plural);
    }
    for (const Class place :
         {Class::kDoor, Class::kWindow, Class::kWall, Class::kCorner, Class::kCenter, Class::kFloor, Class::kCeiling, Class::kOutsideRoom,
          Class::kRoom, Class::kNiche, Class::kZone, Class::kRoomNoun, Class::kPart, Class::kSide, Class::kAbstract}) {
      const Meaning* meaning = meaning_of(match, place);
      if (meaning == nullptr) continue;
      if ((place == Class::kSide || place == Class::kPart) && meaning_of(match, Class::kWallWord) != nullptr) {
        const Match next = lexicon_.find(tokens_, i_ + 1);
        if (has(next, Class::kObject) || has(next, Class::kWall) || has(next, Class::kCorner) || has(next, Class::kSide) ||
            has(next, Class::kNumber) || has(next, Class::kWallWord))
          break;  // "left corner"
      }
      if ((verbal && noun_before && !names_set()) || (!named && !bare_)) return false;
      // "newspapers lines the wall": the verb, not a name that goes on.
      if (noun_before && !hyphenated(i_) && (place == Class::kAbstract || place == Class::kPart) &&
          lexicon_.find_phrase(tokens_, i_).length > 0)
        return false;
      // "another table right of the sofa", "a chair back": a side after a noun is no part of its name.
      if (noun_before && place == Class::kSide && !hyphenated(i_)) return false;
      if (noun_before && place == Class::kPart && meaning_of(match, Class::kSide) != nullptr && !hyphenated(i_)) return false;
      return add(place, *meaning, match.length, match.plural);
    }
    for (const Class word : {Class::kWallRelation, Class::kWallWord}) {
      if (const Meaning* meaning = meaning_of(match, word); meaning != nullptr && (named || bare_) && !noun_before)
        return add(word, *meaning, match.length, false);
    }
    if (has(match, Class::kNumber) && i_ + 1 < tokens_.size() && (hyphenated(i_ + 1) || says_seats(i_ + 1))) {  // "one-way", "two-tone"
      parts_.push_back({i_, i_ + 2, Class::kQuality, {Class::kQuality, nullptr, nullptr, 0, {}}, false});
      i_ += 2;
      return true;
    }
    if (has(match, Class::kNumber) && at_word("one") && named) {  // "the left one", "the other one"
      phrase_.kind = NounKind::kMember;
      i_ += 1;
      done_ = true;
      return false;
    }
    // Participles and verbs stand before the noun only: "a folded blanket", "a rolling chair".
    if (!noun_before && named && (has(match, Class::kParticiple) || has(match, Class::kHang) || has(match, Class::kVerb)) &&
        match.length == 1 && (token().text.ends_with("ed") || token().text.ends_with("ing")) &&
        lexicon_.find_phrase(tokens_, i_).length < 2 && lexicon_.find(tokens_, i_, Class::kHave).length < 2) {  // "each filled with"
      return add(Class::kFiller, match.meanings.front(), 1, false);
    }
    if (!noun_before && named && has(match, Class::kAdverb)) {
      i_ += match.length;
      return true;
    }
    return false;
  }
  if (token().kind != Token::Kind::kWord) {
    // "55-inch", "2-seater": one adjective.
    if (token().kind == Token::Kind::kNumber && i_ + 1 < tokens_.size() && tokens_[i_ + 1].kind == Token::Kind::kWord &&
        (hyphenated(i_ + 1) || says_seats(i_ + 1)))
      return add(Class::kQuality, {Class::kQuality, nullptr, nullptr, 0, {}}, 2, false);
    return false;
  }
  if (lexicon_.find_phrase(tokens_, i_).length > 0) return false;
  if (!named && !bare_) return false;
  if (!word_may_belong()) return false;
  const std::string singular = singular_of(token().text);
  return add(Class::kFiller, {Class::kFiller, nullptr, nullptr, 0, {}}, 1, singular != token().text);
}

void NounPhraseReader::read_parts() {
  constexpr std::size_t kMostParts = 12;
  while (more() && parts_.size() < kMostParts && !done_) {
    if (token().text == "'s") {
      const bool noun = !parts_.empty() && !is_attribute_class(parts_.back().word_class);
      if (!noun) break;
      // "teenager's bedroom", "child's desk", "the cat's bed": a person or an animal owns it; "the bed's foot": a thing does.
      const CatalogEntry* entry = parts_.back().meaning.entry;
      const bool animal = entry != nullptr && lexicon_.catalog().is_a(entry->id, "pet");
      if (animal) {
        parts_.clear();
        ++i_;
        continue;
      }
      if (parts_.back().word_class == Class::kObject || parts_.back().word_class == Class::kRoom) {
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
    if (token().kind == Token::Kind::kNumber && take_size()) continue;
    if (!read_part()) break;
  }
}

}  // namespace layoutbox::offline
