// The words of a noun phrase up to its head: attributes, compounds, and where it ends.
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {

// After a comma or "and" within a row of adjectives: "rectangular, wooden table", "cozy and well-lit room".
bool NounPhraseReader::goes_on_after_break() const {
  const bool adjectives = !parts_.empty() && std::all_of(parts_.begin(), parts_.end(), [this](const PhrasePart& p) {
    // "sheet goods, timber rack" are two, "a warm, wooden table" is one
    const bool things = plural_at(p.last - 1) && word_form(tokens_[p.last - 1].text) != WordForm::kAdjective;
    return is_attribute_class(p.word_class) || (p.word_class == WordClass::kFiller && !things);
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
  if (text == "per") return false;  // "(2 per table)"
  if (hyphenated(i_)) return true;
  if (text.size() == 1) return false;  // "1.6 x 2", "in an L"
  const bool noun_before = std::any_of(parts_.begin(), parts_.end(), [this](const PhrasePart& p) {
    return p.word_class == WordClass::kObject || p.word_class == WordClass::kRoom || p.word_class == WordClass::kDoor ||
           p.word_class == WordClass::kWindow ||
           (p.word_class == WordClass::kWall && p.last == i_);  // "the clock on the wall reminds everyone"
  });
  const WordForm form = word_form(text);
  // "our two cats nap on the sofa": names go on after a singular.
  const bool after_plural =
      !parts_.empty() && parts_.back().word_class == WordClass::kObject && parts_.back().plural && parts_.back().last == i_;
  if (after_plural && !plural_at(i_) && i_ + 1 < tokens_.size() && lexicon_.find_phrase(tokens_, i_ + 1).length > 0) return false;
  if (!noun_before) return form != WordForm::kAdverb;
  const bool place_next = i_ + 1 < tokens_.size() && (opens_at(i_ + 1) || lexicon_.find_phrase(tokens_, i_ + 1).length > 0);
  if (place_next && !lexicon_.present_of(text).empty()) return false;  // "the bed ran along the wall"
  if (text.ends_with("ed") || text.ends_with("ing") || text.ends_with("ly"))
    return form == WordForm::kThing && !text.ends_with("ing") && !text.ends_with("ed");
  // "soup cans"; "the lamp fronts the wall" goes on as a verb does.
  if (form == WordForm::kVerb && noun_form(text) == WordForm::kThing && plural_at(i_)) return !opens_at(i_ + 1);
  return is_noun(form) || form == WordForm::kUnknown;
}

// "the second bed", "the last one"
bool NounPhraseReader::read_ordinal() {
  static constexpr std::pair<std::string_view, int> kOrdinals[] = {
      {"first", 1}, {"1st", 1},     {"second", 2}, {"2nd", 2},   {"third", 3},  {"fourth", 4}, {"fifth", 5},
      {"sixth", 6}, {"seventh", 7}, {"eighth", 8}, {"ninth", 9}, {"tenth", 10}, {"last", -1}};
  if (!parts_.empty() || counted_ || phrase_.determiner != Determiner::kDefinite || hyphenated(i_ + 1)) return false;
  for (const auto& [word, place] : kOrdinals) {
    if (!at_word(word)) continue;
    phrase_.ordinal = place;
    ++i_;
    const Match number = more() ? lexicon_.find(tokens_, i_, WordClass::kNumber) : Match{};  // "the first two"
    if (number.length > 0 && !at_word("one") && read_count()) phrase_.plural = true;
    return true;
  }
  return false;
}

// The name of a thing at `at`, or after a part and its attributes: "glass top bistro table".
bool NounPhraseReader::noun_after(std::size_t at) const {
  constexpr int kMostBetween = 3;
  for (int between = 0; between <= kMostBetween && at < tokens_.size(); ++between) {
    const Match next = lexicon_.find(tokens_, at);
    if (has(next, WordClass::kObject) && !has(next, WordClass::kPart))
      return !has(next, WordClass::kPlaceVerb) && !has(next, WordClass::kHave);
    if (!has(next, WordClass::kPart) && (between == 0 || attribute_of(next) == nullptr)) return false;
    at += next.length;
  }
  return false;
}

// "a kettlebell set and …": no verb where nothing says what is set.
bool NounPhraseReader::names_set() const {
  return at_word("set") && parts_.back().word_class == WordClass::kObject && !parts_.back().plural && parts_.back().last == i_ &&
         (i_ + 1 >= tokens_.size() || tokens_[i_ + 1].kind == Token::Kind::kPunctuation || lexicon_.is(tokens_[i_ + 1], WordClass::kAnd));
}

// "light-filled", "hand-knotted", "ladder-back", "ride-on", "half-open": one adjective, whatever its first word is.
bool NounPhraseReader::read_compound_adjective(const Match& match) {
  if (match.length > 1 || i_ + 1 >= tokens_.size() || !hyphenated(i_ + 1) || token().kind != Token::Kind::kWord) return false;
  static constexpr std::string_view kEnds[] = {"style", "free", "on",  "up",    "in",   "out",  "off",  "down",  "over", "thrown",
                                               "made",  "spun", "cut", "woven", "sewn", "worn", "hewn", "drawn", "blown"};
  const std::string& end = tokens_[i_ + 1].text;
  const bool halfway = one_of(token().text, {"half", "semi"}) && (word_form(end) == WordForm::kAdjective || end.ends_with("en"));
  const bool adjective = halfway || end.ends_with("ed") || end.ends_with("ing") || end == "open" ||
                         std::find(std::begin(kEnds), std::end(kEnds), end) != std::end(kEnds);
  const bool side = has(lexicon_.find(tokens_, i_ + 1), WordClass::kSide) && has(lexicon_.find(tokens_, i_ + 2), WordClass::kObject);
  if ((!adjective && !side) || lexicon_.find(tokens_, i_ + 1, WordClass::kObject).length > 0) return false;
  if (lexicon_.find_phrase(tokens_, i_).length > 1) return false;  // "close-up", "in-between"
  parts_.push_back({i_, i_ + 2, WordClass::kQuality, {WordClass::kQuality, nullptr, nullptr, 0, {}}, false});
  i_ += 2;
  return true;
}

bool NounPhraseReader::plural_at(std::size_t i) const { return singular_of(tokens_[i].text) != tokens_[i].text; }

// "a", "two", "the" at `i`: what went before was a verb.
bool NounPhraseReader::opens_at(std::size_t i) const {
  return i < tokens_.size() && (tokens_[i].kind == Token::Kind::kNumber || lexicon_.is(tokens_[i], WordClass::kIndefinite) ||
                                lexicon_.is(tokens_[i], WordClass::kNumber) || lexicon_.is(tokens_[i], WordClass::kDefinite));
}

// "two monitors and a keyboard stand on every desk": no stand, which would be on the floor.
bool NounPhraseReader::stands_on_table(const Match& match) const {
  const Meaning* stand = meaning_of(match, WordClass::kObject);
  const std::size_t on = i_ + match.length, thing = on + 2;
  if (match.plural || phrase_.first == 0 || !lexicon_.is(tokens_[phrase_.first - 1], WordClass::kAnd) || thing >= tokens_.size() ||
      tokens_[on].text != "on" || stand == nullptr || stand->entry == nullptr || stand->entry->mount != Mount::kFloor)
    return false;
  const Match carrier = lexicon_.find(tokens_, thing);
  const Meaning* host = meaning_of(carrier, WordClass::kObject);
  return host != nullptr && host->entry != nullptr && host->entry->top_carries && lacks_verb(thing);
}

// "a plant stands in the corner" is no plant stand.
Match NounPhraseReader::without_verb(const Match& match) const {
  const std::size_t final = i_ + match.length - 1;
  // "a sofa set against the wall" was put there.
  if (match.length == 2 && lexicon_.set_of(text_of(tokens_, i_, final + 1)) != nullptr && tokens_[final].text == "set" &&
      final + 1 < tokens_.size() && tokens_[final + 1].text != "in" && lexicon_.find_phrase(tokens_, final + 1).length > 0) {
    const Match thing = lexicon_.find(tokens_.first(final), i_);
    if (has(thing, WordClass::kObject)) return thing;
  }
  if (match.length < 2 || (!lexicon_.is(tokens_[final], WordClass::kPlaceVerb) && !lexicon_.is(tokens_[final], WordClass::kHave)))
    return match;
  const bool one =
      phrase_.count == 1 || (phrase_.count == 0 && (phrase_.determiner == Determiner::kIndefinite || opens_at(i_ + match.length)));
  // "in the corner stands a"; "the TV stands near the window", where no other verb says that they are stands.
  const bool opens_clause = phrase_.first == 0 || tokens_[phrase_.first - 1].kind != Token::Kind::kWord ||
                            tokens_[phrase_.first - 1].ends_sentence || lexicon_.is(tokens_[phrase_.first - 1], WordClass::kAnd) ||
                            one_of(tokens_[phrase_.first - 1].text, {"while", "where", "whereas"});
  const bool stands_there = opens_clause && phrase_.count == 0 && !counted_ && place_at(i_ + match.length) && lacks_verb(i_ + match.length);
  const bool singular_subject = match.plural && (one || (stands_there && phrase_.determiner != Determiner::kBoth));
  const bool plural_subject = !match.plural && plural_at(i_ + match.length - 2) && !plural_at(i_ + match.length - 1);  // "speakers stand"
  if (!singular_subject && !plural_subject && !stands_on_table(match)) return match;
  const Match subject = lexicon_.find(tokens_.first(i_ + match.length - 1), i_);
  return one || plural_subject || has(subject, WordClass::kObject) ? subject : match;  // "the music stands near the piano" has no other
}

// "a wooden puppet theater": what something is made of gives way to the longer name that begins after it.
Match NounPhraseReader::without_attribute(const Match& match) const {
  if (match.length < 2 || !has(match, WordClass::kObject)) return match;
  const Match first = lexicon_.find(tokens_.first(i_ + 1), i_);
  if (attribute_of(first) == nullptr) return match;
  const Match after = lexicon_.find(tokens_, i_ + 1);
  return has(after, WordClass::kObject) && after.length >= match.length ? first : match;
}

bool NounPhraseReader::read_unlisted() {
  if (token().kind != Token::Kind::kWord) {
    // "55-inch", "2-seater": one adjective.
    if (token().kind == Token::Kind::kNumber && i_ + 1 < tokens_.size() && tokens_[i_ + 1].kind == Token::Kind::kWord &&
        (hyphenated(i_ + 1) || says_seats(i_ + 1) || describes(i_)))
      return add(WordClass::kQuality, {WordClass::kQuality, nullptr, nullptr, 0, {}}, 2, false);
    return false;
  }
  // "five freshly rinsed prints": how, before what was done to it
  const bool how = parts_.empty() && is_named() && token().text.ends_with("ly") && word_form(token().text) == WordForm::kAdverb &&
                   i_ + 1 < tokens_.size() && tokens_[i_ + 1].kind == Token::Kind::kWord &&
                   (tokens_[i_ + 1].text.ends_with("ed") || tokens_[i_ + 1].text.ends_with("ing") ||
                    word_form(tokens_[i_ + 1].text) == WordForm::kAdjective);
  if (how) {
    ++i_;
    return true;
  }
  // "a heron watching the door": what it does to something
  const bool does = !parts_.empty() && parts_.back().last == i_ && token().text.ends_with("ing") && opens_at(i_ + 1) &&
                    parts_.back().word_class == WordClass::kFiller;
  if (does) return false;
  if ((lexicon_.find_phrase(tokens_, i_).length > 0 && !counts_unlisted()) || (!is_named() && !bare_) || !word_may_belong()) return false;
  return add(WordClass::kFiller, {WordClass::kFiller, nullptr, nullptr, 0, {}}, 1, plural_at(i_));
}

// "four rings in the case": so many of them, and no verb, which would have something to go with.
bool NounPhraseReader::counts_unlisted() const {
  if (!parts_.empty() || phrase_.count < 2 || phrase_.vague || !plural_at(i_)) return false;
  if (lexicon_.find_phrase(tokens_, i_).length != 1 || noun_form(token().text) != WordForm::kThing) return false;
  const std::size_t next = i_ + 1;
  return next >= tokens_.size() || tokens_[next].kind == Token::Kind::kPunctuation || lexicon_.is(tokens_[next], WordClass::kAnd) ||
         lexicon_.is(tokens_[next], WordClass::kBe) || lexicon_.find_phrase(tokens_, next).length > 0;
}

// Whether the name ends before what is at hand: a verb, a place, somebody who does something.
bool NounPhraseReader::ends_before(const Match& match) const {
  // "both stand", "all sit": the verb.
  const bool verb = match.length == 1 && !plural_at(i_) && has(match, WordClass::kPlaceVerb);
  if (parts_.empty()) {
    if (verb && counted_ && phrase_.count > 1 && place_at(i_ + 1)) return true;  // "the other two stand by the wall"
    // "both look toward the window"
    if (phrase_.determiner == Determiner::kBoth && may_be_verb(token().text) && lexicon_.find_phrase(tokens_, i_).length > 1 &&
        !plural_at(i_))
      return true;
    // "each looks at the bar"
    const bool place = phrase_.determiner == Determiner::kEach && is_finite(token().text) && lexicon_.find_phrase(tokens_, i_).length > 1;
    // "four stools each stand before a machine"
    const bool after_several = phrase_.determiner == Determiner::kEach && verb && phrase_.first > 0 && plural_at(phrase_.first - 1);
    return place || after_several || (phrase_.determiner == Determiner::kBoth && verb);
  }
  const PhrasePart& last = parts_.back();
  if (verb && last.last == i_ && plural_at(i_ - 1) && !is_attribute_class(last.word_class)) return true;
  // "in the case rest three coins": of one thing a verb would have its -s, so that what follows is its subject
  const bool inverts = verb && last.last == i_ && has(match, WordClass::kAbstract) && opens_at(i_ + 1);
  if (inverts && (tokens_[i_ + 1].kind == Token::Kind::kNumber || lexicon_.is(tokens_[i_ + 1], WordClass::kNumber))) return true;
  const std::size_t phrase = lexicon_.find_phrase(tokens_, i_).length;
  if (phrase > std::max<std::size_t>(match.length, 1)) return true;  // "two desks side by side": a place, no part of the name
  // "a VR rig positioned beside the door"
  const bool participle =
      match.length == 1 && has(match, WordClass::kParticiple) && (token().text.ends_with("ed") || token().text.ends_with("ing"));
  if (!participle || last.word_class != WordClass::kFiller || last.last != i_) return false;
  const WordForm before = noun_form(tokens_[last.last - 1].text);
  std::size_t after = i_ + match.length;  // "a missal lying open upon it"
  if (after + 1 < tokens_.size() && lexicon_.find_phrase(tokens_, after).length == 0 && lexicon_.find_phrase(tokens_, after + 1).length > 0)
    ++after;
  const bool over =
      after >= tokens_.size() || tokens_[after].kind == Token::Kind::kPunctuation || lexicon_.find_phrase(tokens_, after).length > 0;
  return over && (is_noun(before) || before == WordForm::kUnknown);
}

}  // namespace layoutbox::offline
