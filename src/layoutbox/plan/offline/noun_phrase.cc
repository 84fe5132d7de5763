#include "layoutbox/plan/offline/noun_phrase.h"

#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/offline/english.h"

namespace layoutbox::offline {
namespace {

using Class = WordClass;

bool has(const Match& match, Class word_class) {
  return std::any_of(match.meanings.begin(), match.meanings.end(), [&](const Meaning& m) { return m.word_class == word_class; });
}

const Meaning* meaning_of(const Match& match, Class word_class) {
  for (const Meaning& meaning : match.meanings) {
    if (meaning.word_class == word_class) return &meaning;
  }
  return nullptr;
}

bool is_attribute_class(Class c) {
  return c == Class::kSizeWord || c == Class::kColor || c == Class::kMaterial || c == Class::kShape || c == Class::kStyle ||
         c == Class::kQuality;
}

const Meaning* attribute_of(const Match& match) {
  for (const Meaning& meaning : match.meanings) {
    if (is_attribute_class(meaning.word_class)) return &meaning;
  }
  return nullptr;
}

std::string text_of(std::span<const Token> tokens, std::size_t first, std::size_t last) {
  std::string text;
  for (std::size_t i = first; i < last; ++i) {
    if (tokens[i].kind == Token::Kind::kPunctuation) continue;
    if (tokens[i].text == "'s") {
      text += "'s";
      continue;
    }
    if (!text.empty()) text += i > first && tokens[i].glued ? "-" : " ";
    text += tokens[i].text;
  }
  return text;
}

// One word or compound before or at the head.
struct Part {
  std::size_t first = 0, last = 0;
  Class word_class = Class::kFiller;  // kObject, an attribute, a place; kFiller: not in the lexicon
  Meaning meaning{Class::kFiller, nullptr, nullptr, 0, {}};
  bool plural = false;
};

class Reader {
 public:
  Reader(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at, bool bare)
      : lexicon_(lexicon), tokens_(tokens), i_(at), bare_(bare) {
    phrase_.first = at;
  }

  std::optional<NounPhrase> read() {
    if (!read_determiners()) return std::nullopt;
    if (done_) return finish();
    read_parts();
    return settle();
  }

 private:
  bool more() const { return i_ < tokens_.size(); }
  const Token& token() const { return tokens_[i_]; }
  bool at_word(std::string_view text, std::size_t ahead = 0) const {
    return i_ + ahead < tokens_.size() && tokens_[i_ + ahead].text == text;
  }
  bool hyphenated(std::size_t i) const {
    return i > 0 && i < tokens_.size() && tokens_[i].glued && tokens_[i].kind != Token::Kind::kPunctuation &&
           tokens_[i - 1].kind != Token::Kind::kPunctuation && tokens_[i].begin > tokens_[i - 1].end;
  }

  std::optional<NounPhrase> finish() {
    phrase_.last = i_;
    return phrase_;
  }

  // The, a, two, at least three, several, a pair of, both, each, no. False when nothing can follow.
  bool read_determiners();
  bool read_count();
  bool read_subset();
  bool read_pronoun();
  void read_parts();
  bool read_part();
  bool goes_on_after_break() const;
  bool word_may_belong() const;
  std::optional<NounPhrase> settle();
  void settle_object(const Part& head, std::size_t head_index);
  void settle_place(const Part& head);
  void read_of();
  void take_attributes(std::size_t until);

  const Lexicon& lexicon_;
  std::span<const Token> tokens_;
  std::size_t i_;
  bool bare_;
  bool done_ = false, counted_ = false;
  NounPhrase phrase_;
  std::vector<Part> parts_;
};

bool Reader::read_count() {
  // "2 m long", "120 cm wide", "4-seater" are no counts.
  if (token().kind == Token::Kind::kNumber) {
    if (read_measure(lexicon_, tokens_, i_)) {
      const std::size_t taken = read_size(lexicon_, tokens_, i_, phrase_.size);
      i_ += taken;
      return taken > 0;
    }
    if (hyphenated(i_ + 1) && i_ + 1 < tokens_.size() && tokens_[i_ + 1].kind == Token::Kind::kWord) return false;
    const double value = token().number;
    if (value < 0 || value > 500 || value != static_cast<int>(value)) return false;
    phrase_.count = static_cast<int>(value);
    ++i_;
    // "2-3 chairs", "2 to 3": the smaller number, at least.
    if (more() && token().kind == Token::Kind::kNumber && hyphenated(i_)) ++i_, phrase_.at_least = true;
    counted_ = true;
    return true;
  }
  const Match number = lexicon_.find(tokens_, i_, Class::kNumber), vague = lexicon_.find(tokens_, i_, Class::kVague);
  if (number.length == 0 && vague.length == 0) return false;
  // Another word's longer meaning wins: "single bed", "one another", "twin-size".
  const Match any = at_word("dual") ? Match{} : lexicon_.find(tokens_, i_);
  const bool is_number = number.length >= vague.length;
  const Match& best = is_number ? number : vague;
  if (any.length > best.length && !has(any, Class::kNumber) && !has(any, Class::kVague)) return false;
  if (is_number && attribute_of(any) != nullptr && any.length == best.length && counted_) return false;
  // "two-seater", "three-legged": a compound adjective.
  if (best.length == 1 && hyphenated(i_ + 1)) return false;
  const Meaning* meaning = meaning_of(best, is_number ? Class::kNumber : Class::kVague);
  // "twin", "double", "single" and "full" are adjectives of beds and sofas as well: only "dual monitors" and the like are counts.
  if (is_number && attribute_of(any) != nullptr) {
    const Match next = lexicon_.find(tokens_, i_ + best.length);
    if (!next.plural || has(next, Class::kSizeWord)) return false;
  }
  const int value = static_cast<int>(meaning->value);
  // "a pair of two chairs" stays two; "several dozen" is not worth more than several.
  phrase_.count = phrase_.count > 0 && !is_number ? phrase_.count : value;
  phrase_.vague |= !is_number;
  counted_ = true;
  i_ += best.length;
  if (is_number && more()) {  // "three to five", "two or three"
    const bool range = at_word("to") || at_word("or") || (token().kind == Token::Kind::kPunctuation && token().text == "-");
    if (range && i_ + 1 < tokens_.size()) {
      const Match upper = lexicon_.find(tokens_, i_ + 1, Class::kNumber);
      if (upper.length > 0) i_ += 1 + upper.length, phrase_.at_least = true;
    }
  }
  return true;
}

// "one of the beds", "two of them", "each of which".
bool Reader::read_subset() {
  if (!at_word("of") || i_ + 1 >= tokens_.size()) return false;
  const Token& next = tokens_[i_ + 1];
  if (next.text == "which" || next.text == "them" || next.text == "these" || next.text == "those" || next.text == "whom") {
    const bool alone =
        i_ + 2 >= tokens_.size() || !lexicon_.find(tokens_, i_ + 2, Class::kObject).length || next.text == "which" || next.text == "them";
    if (alone) {
      phrase_.kind = NounKind::kMember;
      phrase_.subset = true;
      i_ += 2;
      return done_ = true;
    }
  }
  if (lexicon_.is(next, Class::kDefinite) || lexicon_.is(next, Class::kPossessive)) {
    if (auto base = read_noun_phrase(lexicon_, tokens_, i_ + 1, false); base && base->kind == NounKind::kObject) {
      phrase_.kind = NounKind::kMember;
      phrase_.subset = true;
      i_ = base->last;
      phrase_.of = std::make_shared<NounPhrase>(std::move(*base));
      return done_ = true;
    }
  }
  return false;
}

bool Reader::read_pronoun() {
  const Match pronoun = lexicon_.find(tokens_, i_, Class::kPronoun);
  if (pronoun.length == 0) return false;
  const std::string& text = token().text;
  const bool may_determine = text == "this" || text == "that" || text == "these" || text == "those";
  if (may_determine) {
    const Match next = lexicon_.find(tokens_, i_ + 1);
    if (next.length > 0 && !has(next, Class::kBe) && !has(next, Class::kPlaceVerb)) return false;
    if (next.length == 0 && i_ + 1 < tokens_.size() && tokens_[i_ + 1].kind == Token::Kind::kWord) return false;
  }
  phrase_.kind = NounKind::kPronoun;
  phrase_.head = text;
  phrase_.plural = text == "them" || text == "they" || text == "these" || text == "those" || text == "themselves";
  i_ += pronoun.length;
  return done_ = true;
}

bool Reader::read_determiners() {
  const std::size_t start = i_;
  while (more()) {
    if (token().kind == Token::Kind::kPunctuation) break;
    if (phrase_.determiner == Determiner::kNone && !counted_ && read_pronoun()) return true;
    const Match at_least = lexicon_.find(tokens_, i_, Class::kAtLeast), more_than = lexicon_.find(tokens_, i_, Class::kMoreThan),
                at_most = lexicon_.find(tokens_, i_, Class::kAtMost), exactly = lexicon_.find(tokens_, i_, Class::kExactly);
    const auto count_follows = [&](std::size_t length) {
      return length > 0 && i_ + length < tokens_.size() &&
             (tokens_[i_ + length].kind == Token::Kind::kNumber || lexicon_.find(tokens_, i_ + length, Class::kNumber).length > 0 ||
              lexicon_.is(tokens_[i_ + length], Class::kIndefinite)) &&
             !read_measure(lexicon_, tokens_, i_ + length);
    };
    if (count_follows(more_than.length) && !lexicon_.is(tokens_[i_ + more_than.length], Class::kIndefinite)) {
      i_ += more_than.length;
      if (!read_count()) break;
      phrase_.count += 1;
      phrase_.at_least = true;
      continue;
    }
    if (count_follows(at_least.length)) {
      phrase_.at_least = true;
      i_ += at_least.length;
      continue;
    }
    if (count_follows(at_most.length) ||
        (count_follows(exactly.length) && !lexicon_.is(tokens_[i_ + exactly.length], Class::kIndefinite))) {
      i_ += std::max(at_most.length, exactly.length);
      continue;
    }
    if (read_count()) {
      if (read_subset()) return true;
      continue;
    }
    const auto take = [&](Class word_class, Determiner determiner) {
      const Match match = lexicon_.find(tokens_, i_, word_class);
      if (match.length == 0) return false;
      phrase_.determiner = determiner;
      i_ += match.length;
      return true;
    };
    if (phrase_.determiner == Determiner::kNone || phrase_.determiner == Determiner::kBoth || phrase_.determiner == Determiner::kEach) {
      if (take(Class::kAnother, Determiner::kAnother)) continue;
      if (take(Class::kIndefinite, Determiner::kIndefinite)) {
        if (at_word("few")) i_ += 1, phrase_.count = 3, phrase_.vague = counted_ = true;
        continue;
      }
      if (take(Class::kDefinite, Determiner::kDefinite)) continue;
      if (take(Class::kPossessive, Determiner::kPossessive)) continue;
      if (take(Class::kEach, Determiner::kEach) || take(Class::kBoth, Determiner::kBoth)) {
        counted_ |= phrase_.determiner == Determiner::kEach;
        if (read_subset()) return true;
        continue;
      }
    }
    if (phrase_.determiner == Determiner::kDefinite || phrase_.determiner == Determiner::kNone) {
      const Match other = lexicon_.find(tokens_, i_, Class::kOther);
      if (other.length > 0 && (phrase_.determiner == Determiner::kDefinite || counted_ || at_word("other"))) {
        phrase_.determiner = Determiner::kOther;
        i_ += other.length;
        continue;
      }
    }
    break;
  }
  const bool opened = i_ > start;
  return more() && (opened || bare_);
}

// After a comma or "and" within a row of adjectives: "rectangular, wooden table", "cozy and well-lit room".
bool Reader::goes_on_after_break() const {
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
bool Reader::word_may_belong() const {
  const std::string& text = token().text;
  if (hyphenated(i_)) return true;
  const bool noun_before = std::any_of(parts_.begin(), parts_.end(),
                                       [](const Part& p) { return p.word_class == Class::kObject || p.word_class == Class::kRoom; });
  const WordForm form = word_form(text);
  if (!noun_before) return form != WordForm::kAdverb;
  if (text.ends_with("ed") || text.ends_with("ing") || text.ends_with("ly"))
    return form == WordForm::kThing && !text.ends_with("ing") && !text.ends_with("ed");
  return form == WordForm::kThing || form == WordForm::kNoun || form == WordForm::kUnknown;
}

bool Reader::read_part() {
  Match match = lexicon_.find(tokens_, i_);
  // "a plant stands in the corner" is no plant stand.
  const auto plural_at = [&](std::size_t i) { return singular_of(tokens_[i].text) != tokens_[i].text; };
  if (match.length > 1 && lexicon_.is(tokens_[i_ + match.length - 1], Class::kPlaceVerb)) {
    const bool singular_subject = match.plural && phrase_.determiner == Determiner::kIndefinite && phrase_.count == 0;
    const bool plural_subject = !match.plural && plural_at(i_ + match.length - 2) && !plural_at(i_ + match.length - 1);  // "speakers stand"
    if (singular_subject || plural_subject) match = lexicon_.find(tokens_.first(i_ + match.length - 1), i_);
  }
  if (!parts_.empty() && parts_.back().last == i_ && plural_at(i_ - 1) && match.length == 1 && !plural_at(i_) &&
      has(match, Class::kPlaceVerb) && !is_attribute_class(parts_.back().word_class))
    return false;
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
    const bool noun_next = [&] {
      const Match next = lexicon_.find(tokens_, i_ + match.length);
      return has(next, Class::kObject) && !has(next, Class::kPlaceVerb) && !has(next, Class::kHave);
    }();
    if (attribute != nullptr && object != nullptr && match.length == 1 && noun_next && !noun_before)
      return add(attribute->word_class, *attribute, match.length, match.plural);
    Token single = token();
    single.text = singular_of(single.text);
    const bool part = has(match, Class::kPart) || (match.length == 1 && lexicon_.is(single, Class::kPart));
    if (object != nullptr && !(verbal && noun_before && !hyphenated(i_)) && !part)
      return add(Class::kObject, *object, match.length, match.plural);
    if (object != nullptr && part) return add(Class::kPart, *object, match.length, match.plural);
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
          Class::kRoom, Class::kZone, Class::kRoomNoun, Class::kPart, Class::kSide, Class::kAbstract}) {
      const Meaning* meaning = meaning_of(match, place);
      if (meaning == nullptr) continue;
      if ((place == Class::kSide || place == Class::kPart) && meaning_of(match, Class::kWallWord) != nullptr) {
        const Match next = lexicon_.find(tokens_, i_ + 1);
        if (has(next, Class::kObject) || has(next, Class::kWall) || has(next, Class::kCorner) || has(next, Class::kSide) ||
            has(next, Class::kNumber) || has(next, Class::kWallWord))
          break;  // "left corner"
      }
      if ((verbal && noun_before) || (!named && !bare_)) return false;
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
    if (has(match, Class::kNumber) && at_word("one") && named) {  // "the left one", "the other one"
      phrase_.kind = NounKind::kMember;
      i_ += 1;
      done_ = true;
      return false;
    }
    // Participles and verbs stand before the noun only: "a folded blanket", "a rolling chair".
    if (!noun_before && named && (has(match, Class::kParticiple) || has(match, Class::kHang) || has(match, Class::kVerb)) &&
        match.length == 1 && (token().text.ends_with("ed") || token().text.ends_with("ing"))) {
      return add(Class::kFiller, match.meanings.front(), 1, false);
    }
    if (!noun_before && named && has(match, Class::kAdverb)) {
      i_ += match.length;
      return true;
    }
    return false;
  }
  if (token().kind != Token::Kind::kWord) {
    if (token().kind == Token::Kind::kNumber && hyphenated(i_ + 1))
      return add(Class::kFiller, {Class::kFiller, nullptr, nullptr, 0, {}}, 1, false);
    return false;
  }
  if (lexicon_.find_phrase(tokens_, i_).length > 0) return false;
  if (!named && !bare_) return false;
  if (!word_may_belong()) return false;
  const std::string singular = singular_of(token().text);
  return add(Class::kFiller, {Class::kFiller, nullptr, nullptr, 0, {}}, 1, singular != token().text);
}

void Reader::read_parts() {
  constexpr std::size_t kMostParts = 12;
  while (more() && parts_.size() < kMostParts && !done_) {
    if (token().text == "'s") {
      const bool noun = !parts_.empty() && !is_attribute_class(parts_.back().word_class);
      if (!noun) break;
      // "teenager's bedroom", "child's desk": a person owns it; "the bed's foot": a thing does.
      if (parts_.back().word_class == Class::kObject || parts_.back().word_class == Class::kRoom) {
        phrase_.owner = true;
        break;
      }
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
    if (token().kind == Token::Kind::kNumber) {
      const std::size_t taken = read_size(lexicon_, tokens_, i_, phrase_.size);
      if (taken > 0) {
        i_ += taken;
        continue;
      }
    }
    if (!read_part()) break;
  }
}

void Reader::take_attributes(std::size_t until) {
  for (std::size_t p = 0; p < until; ++p) {
    const Part& part = parts_[p];
    if (is_attribute_class(part.word_class)) {
      // "king" and "size", "marble" and "topped": what a hyphen joins is one attribute.
      std::string text = text_of(tokens_, part.first, part.last);
      if (p > 0 && hyphenated(part.first) && !phrase_.attributes.empty()) {
        phrase_.attributes.back() += "-" + text;
        continue;
      }
      phrase_.attributes.push_back(std::move(text));
      phrase_.attribute_classes.push_back(part.word_class);
    } else if (part.word_class == Class::kWallWord) {
      if (!phrase_.wall_word.empty()) phrase_.wall_word += ' ';
      phrase_.wall_word += part.meaning.word;
    } else if (part.word_class == Class::kWallRelation) {
      phrase_.wall_relation = part.meaning.word;
    }
  }
}

void Reader::settle_object(const Part& head, std::size_t head_index) {
  phrase_.kind = NounKind::kObject;
  phrase_.plural = head.plural;
  phrase_.entry = head.meaning.entry;
  phrase_.head = singular_of(tokens_[head.last - 1].text);
  // The name: from the first word that is no plain attribute.
  std::size_t begin = head.first;
  for (std::size_t p = head_index; p-- > 0;) {
    const Class c = parts_[p].word_class;
    const bool in_name = c == Class::kObject || c == Class::kFiller || c == Class::kRoom || c == Class::kRoomNoun || c == Class::kPart ||
                         c == Class::kAbstract || c == Class::kWall || c == Class::kFloor || c == Class::kCeiling || c == Class::kDoor ||
                         c == Class::kWindow || c == Class::kCorner || c == Class::kCenter;
    if (!in_name) break;
    const WordForm form = word_form(tokens_[parts_[p].last - 1].text);
    if (c == Class::kFiller && (form == WordForm::kAdjective || form == WordForm::kAdverb)) break;
    begin = parts_[p].first;
  }
  for (std::size_t p = 0; p < head_index; ++p) {
    if (parts_[p].last <= begin && parts_[p].word_class == Class::kFiller) {
      phrase_.attributes.push_back(text_of(tokens_, parts_[p].first, parts_[p].last));
      phrase_.attribute_classes.push_back(Class::kQuality);
    }
  }
  phrase_.name = text_of(tokens_, begin, head.last);
  if (phrase_.plural) {
    const std::string& last = tokens_[head.last - 1].text;
    phrase_.name = phrase_.name.substr(0, phrase_.name.size() - last.size()) + phrase_.head;
  }
  phrase_.exact = phrase_.entry != nullptr && begin == head.first;
  if (phrase_.entry != nullptr) {
    phrase_.category = phrase_.entry->id;
  } else {
    phrase_.category = snake_case(phrase_.name);
    const CatalogEntry* kind = lexicon_.catalog().find_by_words(phrase_.name);
    phrase_.entry = kind != nullptr ? kind : known_kind(lexicon_.catalog(), phrase_.name);
  }
}

void Reader::settle_place(const Part& head) {
  phrase_.plural = head.plural;
  phrase_.head = singular_of(tokens_[head.last - 1].text);
  phrase_.name = text_of(tokens_, phrase_.first, head.last);
  switch (head.word_class) {
    case Class::kWall: phrase_.kind = NounKind::kWall; break;
    case Class::kCorner: phrase_.kind = NounKind::kCorner; break;
    case Class::kCenter: phrase_.kind = NounKind::kCenter; break;
    case Class::kFloor: phrase_.kind = NounKind::kFloor; break;
    case Class::kCeiling: phrase_.kind = NounKind::kCeiling; break;
    case Class::kDoor: phrase_.kind = NounKind::kDoor; break;
    case Class::kWindow: phrase_.kind = NounKind::kWindow; break;
    case Class::kRoom:
      phrase_.kind = NounKind::kRoom;
      phrase_.room = head.meaning.room;
      break;
    case Class::kRoomNoun: phrase_.kind = NounKind::kRoom; break;
    case Class::kOutsideRoom: phrase_.kind = NounKind::kOutsideRoom; break;
    case Class::kSide:
    case Class::kPart: phrase_.kind = NounKind::kPart; break;
    default: phrase_.kind = NounKind::kAbstract; break;
  }
}

// "the corner of the desk", "a bowl of fruit".
void Reader::read_of() {
  if (!at_word("of") || i_ + 1 >= tokens_.size()) return;
  const bool bare = phrase_.kind == NounKind::kObject;
  auto base = read_noun_phrase(lexicon_, tokens_, i_ + 1, true);
  if (!base) return;
  if (bare) {  // part of the name, not a thing of its own
    if (base->kind != NounKind::kObject && base->kind != NounKind::kAbstract) return;
    phrase_.name += " of " + (base->name.empty() ? text_of(tokens_, base->first, base->last) : base->name);
    i_ = base->last;
    return;
  }
  i_ = base->last;
  phrase_.of = std::make_shared<NounPhrase>(std::move(*base));
}

std::optional<NounPhrase> Reader::settle() {
  if (done_) {  // "the left one"
    take_attributes(parts_.size());
    return finish();
  }
  // The head is the last noun; words after it that are not nouns were read too far.
  std::size_t head = parts_.size();
  while (head > 0) {
    const Part& part = parts_[head - 1];
    if (!is_attribute_class(part.word_class) && part.word_class != Class::kWallWord && part.word_class != Class::kWallRelation) break;
    --head;
  }
  if (head == 0) {
    // Nothing but attributes: "each", "the other", "both", "the larger", a count alone.
    const bool member = phrase_.determiner == Determiner::kEach || phrase_.determiner == Determiner::kBoth ||
                        phrase_.determiner == Determiner::kOther || phrase_.determiner == Determiner::kAnother || counted_;
    if (!member || (bare_ && !counted_ && phrase_.determiner == Determiner::kNone)) return std::nullopt;
    if (!parts_.empty()) i_ = parts_.front().first;
    phrase_.kind = NounKind::kMember;
    return finish();
  }
  const Part part = parts_[head - 1];
  i_ = part.last;
  if (part.word_class == Class::kFiller) {
    const WordForm form = word_form(tokens_[part.last - 1].text);
    const bool named = phrase_.determiner != Determiner::kNone || counted_;
    const bool thing = form == WordForm::kThing || (form == WordForm::kUnknown && (named || part.plural)) ||
                       (hyphenated(part.first) && form != WordForm::kNoun);
    take_attributes(head - 1);
    if (!thing && !named && form != WordForm::kNoun) return std::nullopt;
    settle_object(part, head - 1);
    if (!thing) phrase_.kind = NounKind::kAbstract;
  } else if (part.word_class == Class::kObject) {
    take_attributes(head - 1);
    settle_object(part, head - 1);
  } else {
    take_attributes(head - 1);
    settle_place(part);
    // "bath essentials", "decorative items": things, where something holds them.
    if (phrase_.kind == NounKind::kAbstract && is_collective(phrase_.head)) {
      const Part as_object{part.first, part.last, Class::kFiller, {Class::kFiller, nullptr, nullptr, 0, {}}, part.plural};
      settle_object(as_object, head - 1);
      phrase_.kind = NounKind::kAbstract;
      phrase_.collective = true;
    }
  }
  read_of();
  if (more() && token().text == "'s") phrase_.owner = true;
  return finish();
}

}  // namespace

std::optional<NounPhrase> read_noun_phrase(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at, bool bare) {
  if (at >= tokens.size() || tokens[at].kind == Token::Kind::kPunctuation) return std::nullopt;
  return Reader(lexicon, tokens, at, bare).read();
}

std::optional<Measure> read_measure(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at) {
  if (at >= tokens.size()) return std::nullopt;
  double value = tokens[at].number;
  std::size_t unit_at = at + 1;
  if (tokens[at].kind != Token::Kind::kNumber) {
    const Match number = lexicon.find(tokens, at, Class::kNumber);
    if (number.length == 0) return std::nullopt;
    value = meaning_of(number, Class::kNumber)->value;
    unit_at = at + number.length;
  }
  if (unit_at >= tokens.size()) return std::nullopt;
  const std::string& unit_word = tokens[unit_at].text;
  Match unit = lexicon.find(tokens, unit_at, Class::kUnit);
  double scale = 0;
  if (unit.length > 0) scale = meaning_of(unit, Class::kUnit)->value;
  if (unit.length == 0 && unit_word == "\"") scale = 0.0254, unit.length = 1;
  if (unit.length == 0 && (unit_word == "'" || unit_word == "'s")) scale = 0.3048, unit.length = 1;
  if (unit.length == 0) return std::nullopt;
  // "in" is a preposition unless a number stands right before it and no noun phrase follows.
  if (unit_word == "in" && tokens[at].kind == Token::Kind::kNumber && !tokens[unit_at].glued) {
    const bool more = unit_at + 1 < tokens.size() &&
                      (lexicon.is(tokens[unit_at + 1], Class::kDefinite) || lexicon.is(tokens[unit_at + 1], Class::kIndefinite));
    if (more) return std::nullopt;
  }
  if (unit_word == "in" && tokens[at].kind != Token::Kind::kNumber) return std::nullopt;
  Measure measure{value * scale, unit_at + 1 - at};
  // Feet and inches: 5 ft 6 in.
  if (scale == 0.3048 && at + measure.length + 1 < tokens.size() && tokens[at + measure.length].kind == Token::Kind::kNumber) {
    const std::string& second = tokens[at + measure.length + 1].text;
    if (second == "\"" || second == "in" || second == "inches" || second == "inch") {
      measure.metres += tokens[at + measure.length].number * 0.0254;
      measure.length += 2;
    }
  }
  return measure;
}

std::size_t read_size(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at, SaidSize& size) {
  const auto measure = read_measure(lexicon, tokens, at);
  if (!measure) return 0;
  std::size_t i = at + measure->length;
  const auto dimension = i < tokens.size() ? lexicon.find(tokens, i, Class::kDimension) : Match{};
  if (dimension.length == 0) return 0;
  const std::string_view which = meaning_of(dimension, Class::kDimension)->word;
  if (which == "w") size.width = measure->metres;
  if (which == "l") size.length = measure->metres;
  if (which == "d") size.depth = measure->metres;
  if (which == "h") size.height = measure->metres;
  if (which == "s") size.width = size.depth = measure->metres;
  return i + dimension.length - at;
}

}  // namespace layoutbox::offline
