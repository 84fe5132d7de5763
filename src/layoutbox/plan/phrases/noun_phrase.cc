#include "layoutbox/base/words.h"
#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

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

void NounPhraseReader::take_attributes(std::size_t until) {
  for (std::size_t p = 0; p < until; ++p) {
    const PhrasePart& part = parts_[p];
    if (is_attribute_class(part.word_class)) {
      // "king" and "size", "marble" and "topped": what a hyphen joins is one attribute.
      std::string text = text_of(tokens_, part.first, part.last);
      if (p > 0 && hyphenated(part.first) && !phrase_.attributes.empty()) {
        phrase_.attributes.back() += "-" + text;
        continue;
      }
      phrase_.attributes.push_back(std::move(text));
      phrase_.attribute_classes.push_back(part.word_class);
    } else if (part.word_class == WordClass::kWallWord) {
      if (!phrase_.wall_word.empty()) phrase_.wall_word += ' ';
      phrase_.wall_word += part.meaning.word;
    } else if (part.word_class == WordClass::kWallRelation) {
      phrase_.wall_relation = part.meaning.word;
    }
  }
}

void NounPhraseReader::settle_object(const PhrasePart& head, std::size_t head_index) {
  settle_kind(head, head_index);
  if (phrase_.kind != NounKind::kObject) return;
  count_singly(head);
  if (pair_named_) phrase_.name = "pair of " + phrase_.name;
  if (!heaped_.empty()) settle_heap(head);
}

// "five coat hooks" are hooks, though "coat hooks" by themselves are a rail of them.
void NounPhraseReader::count_singly(const PhrasePart& head) {
  if (!counted_ || phrase_.vague || phrase_.count < 2 || phrase_.entry == nullptr) return;
  const std::string named = text_of(tokens_, head.first, head.last);
  const std::string& last = tokens_[head.last - 1].text;
  const std::string single = named.substr(0, named.size() - last.size()) + singular_of(last);
  if (single == named || std::ranges::find(phrase_.entry->synonyms, named) == phrase_.entry->synonyms.end()) return;
  const CatalogEntry* own = lexicon_.entry_called(single);
  if (own == nullptr || own == phrase_.entry) return;
  phrase_.entry = own, phrase_.category = own->id, phrase_.exact = true;
}

// "a stack of menus", "two piles of letters": as many heaps as are said, drawn as such where the catalogue has it.
void NounPhraseReader::settle_heap(const PhrasePart& head) {
  const std::size_t last_word = phrase_.name.rfind(' ') + 1;  // 0 where it is the only one
  phrase_.name = std::string(heaped_) + " of " + phrase_.name.substr(0, last_word) + tokens_[head.last - 1].text;
  const CatalogEntry* own = lexicon_.entry_called(phrase_.name);
  if (own != nullptr) {
    phrase_.entry = own;
    phrase_.category = own->id;
    phrase_.exact = true;
  } else {
    phrase_.heaped = true;
  }
  phrase_.head = heaped_;
  if (phrase_.vague) phrase_.count = 1;
  phrase_.vague = false;
  phrase_.plural = phrase_.count > 1;
}

// "some big painting", "any table": one of it, and "lots of worktop" is a long one. "Some fruit" and "some storage" are as many as may be.
void NounPhraseReader::settle_vague(const PhrasePart& head) {
  if (!phrase_.vague || phrase_.plural || phrase_.entry == nullptr) return;
  const bool of_many = one_of(phrase_.head, WordSet::kStuff);
  const bool furniture = phrase_.entry->mount != Mount::kSurface && head.last == head.first + 1 && !of_many;
  if (!phrase_.entry->is(Trait::kCounter) && !(furniture && tokens_[phrase_.first].text == "some")) return;
  phrase_.count = 1;
  phrase_.vague = false;
}

void NounPhraseReader::settle_kind(const PhrasePart& head, std::size_t head_index) {
  phrase_.kind = NounKind::kObject;
  phrase_.plural = head.plural;
  phrase_.entry = head.meaning.entry;
  phrase_.head = singular_of(tokens_[head.last - 1].text);
  const std::string_view called = settle_pair(head);
  // The name: from the first word that is no plain attribute.
  std::size_t begin = head.first;
  for (std::size_t p = head_index; p-- > 0;) {
    const WordClass c = parts_[p].word_class;
    const bool in_name = c == WordClass::kObject || c == WordClass::kFiller || c == WordClass::kRoom || c == WordClass::kRoomNoun ||
                         c == WordClass::kPart || c == WordClass::kAbstract || c == WordClass::kWall || c == WordClass::kFloor ||
                         c == WordClass::kCeiling || c == WordClass::kDoor || c == WordClass::kWindow || c == WordClass::kCorner ||
                         c == WordClass::kCenter;
    if (!in_name) break;
    const WordForm form = word_form(tokens_[parts_[p].last - 1].text);
    if (c == WordClass::kFiller && (form == WordForm::kAdjective || form == WordForm::kAdverb)) break;
    begin = parts_[p].first;
  }
  for (std::size_t p = 0; p < head_index; ++p) {
    if (parts_[p].last <= begin && parts_[p].word_class == WordClass::kFiller) {
      phrase_.attributes.push_back(text_of(tokens_, parts_[p].first, parts_[p].last));
      phrase_.attribute_classes.push_back(WordClass::kQuality);
    }
  }
  if (phrase_.determiner == Determiner::kIndefinite && phrase_.count == 0) phrase_.plural = false;  // "a box of tissues"
  settle_vague(head);
  // A row has three, of several rows each two, where no number is said.
  if (phrase_.rows > 0 && phrase_.count == 0) phrase_.vague = true;
  if (phrase_.rows > 0) phrase_.count = phrase_.rows * (phrase_.count > 0 ? phrase_.count : phrase_.rows == 1 ? 3 : 2);
  phrase_.name = text_of(tokens_, begin, head.last);
  const bool several_of = phrase_.plural && head.last - head.first > 2 && tokens_[head.first + 1].text == "of" && plural_at(head.first);
  if (several_of && begin == head.first) {  // "two chests of drawers"
    phrase_.name = singular_of(tokens_[begin].text) + " " + text_of(tokens_, begin + 1, head.last);
  } else if (phrase_.plural) {
    const std::string& last = tokens_[head.last - 1].text;
    phrase_.name = phrase_.name.substr(0, phrase_.name.size() - last.size()) + phrase_.head;
  }
  // "the following objects:" announces things.
  if (std::find(phrase_.attributes.begin(), phrase_.attributes.end(), "following") != phrase_.attributes.end()) {
    phrase_.kind = NounKind::kAbstract;
    return;
  }
  phrase_.exact = phrase_.entry != nullptr && begin == head.first;
  if (phrase_.entry == nullptr) return settle_unknown();
  // "crash trolley": a crash cart, by another word for its head.
  const CatalogEntry* special = phrase_.exact ? nullptr : lexicon_.catalog().find_by_words(phrase_.name);
  if (special != nullptr && special != phrase_.entry && lexicon_.catalog().is_a(special->id, phrase_.entry->id)) {
    phrase_.entry = special;
    phrase_.category = special->id;
  } else {
    phrase_.category = snake_case(called);  // the entry's, or the word for what is only like it
    if (!phrase_.exact && (special == nullptr || special == phrase_.entry)) settle_modeled();
  }
}

// "four model buses", "a toy station": small, whatever size the real one has.
void NounPhraseReader::settle_modeled() {
  constexpr Mm kSmall = 600;
  std::vector<std::string> words = phrase_.attributes;
  for (std::size_t t = phrase_.first; t + 1 < i_; ++t) words.push_back(tokens_[t].text);
  const auto telling = std::find_if(words.begin(), words.end(), is_kin_modifier);
  if (telling == words.end()) return;
  const Size& real = phrase_.entry->size.usual;
  const bool listed = lexicon_.catalog().find(phrase_.category) != nullptr;
  if (listed && std::max({real.width, real.depth, real.height}) <= kSmall) return;
  const std::string called = *telling + " " + phrase_.head;
  const CatalogEntry* small = kin_of(lexicon_.catalog(), called);
  if (small == nullptr) return;
  phrase_.entry = small;
  phrase_.category = snake_case(called);
}

// What no list has: its category is its own name, which then is all that says what it is like ("plush narwhal").
void NounPhraseReader::settle_unknown() {
  std::string called = phrase_.name;
  const auto telling = std::find_if(phrase_.attributes.begin(), phrase_.attributes.end(), is_kin_modifier);
  if (telling != phrase_.attributes.end()) called = *telling + " " + called;
  phrase_.category = snake_case(called);
  const CatalogEntry* kind = lexicon_.catalog().find_by_words(phrase_.name);
  phrase_.entry = kind != nullptr ? kind : kin_of(lexicon_.catalog(), called);
}

// What the catalogue has as a pair of them: "work gloves" as gloves; null: nothing.
const CatalogEntry* NounPhraseReader::pair_of(const PhrasePart& head) const {
  for (const std::size_t first : {head.first, head.last - 1}) {
    const CatalogEntry* pair = lexicon_.entry_called("pair of " + text_of(tokens_, first, head.last));
    if (pair != nullptr) return pair;
  }
  return nullptr;
}

// "scissors", "a pair of glasses": one thing by two words, or by a plural. Returns the category's word.
std::string_view NounPhraseReader::settle_pair(const PhrasePart& head) {
  const std::string word = text_of(tokens_, head.first, head.last);  // "wine glasses" are no "glasses"
  std::string_view meant = paired_ ? lexicon_.meant_by_pair(word) : std::string_view{};
  // "a pair of boots", "three pairs of skis": what is drawn as a pair is one thing.
  if (const CatalogEntry* pair = paired_ && meant.empty() ? pair_of(head) : nullptr; pair != nullptr) {
    meant = pair->id;
    pair_named_ = true;
  }
  // "dog scales", "garden shears"
  const bool one = lexicon_.is_plural_only(word) || lexicon_.is_plural_only(tokens_[head.last - 1].text) || !meant.empty();
  if (!one) return head.meaning.word;
  if (!meant.empty()) phrase_.entry = &lexicon_.catalog().entry_or_nearest(meant);
  pair_named_ |= paired_ && phrase_.count <= 2 && !phrase_.vague;
  if (paired_) phrase_.count /= 2;
  if (phrase_.vague && !paired_ && tokens_[head.first > 1 ? head.first - 2 : 0].text == "set") phrase_.count = 1;  // "a set of scales"
  phrase_.plural = false;
  phrase_.head = tokens_[head.last - 1].text;
  return meant.empty() ? head.meaning.word : meant;
}

void NounPhraseReader::settle_place(const PhrasePart& head) {
  phrase_.plural = head.plural;
  phrase_.head = singular_of(tokens_[head.last - 1].text);
  phrase_.name = text_of(tokens_, phrase_.first, head.last);
  if (phrase_.vague && !phrase_.plural && phrase_.count > 1) {  // "in some corner"
    phrase_.count = 0;
    phrase_.vague = false;
    phrase_.determiner = Determiner::kIndefinite;
  }
  switch (head.word_class) {
    case WordClass::kWall: phrase_.kind = NounKind::kWall; break;
    case WordClass::kCorner: phrase_.kind = NounKind::kCorner; break;
    case WordClass::kCenter: phrase_.kind = NounKind::kCenter; break;
    case WordClass::kFloor: phrase_.kind = NounKind::kFloor; break;
    case WordClass::kCeiling: phrase_.kind = NounKind::kCeiling; break;
    case WordClass::kDoor: phrase_.kind = NounKind::kDoor; break;
    case WordClass::kWindow: phrase_.kind = NounKind::kWindow; break;
    case WordClass::kRoom:
      phrase_.kind = NounKind::kRoom;
      phrase_.room = head.meaning.room;
      break;
    case WordClass::kRoomNoun: phrase_.kind = NounKind::kRoom; break;
    case WordClass::kOutsideRoom: phrase_.kind = NounKind::kOutsideRoom; break;
    case WordClass::kSide:
    case WordClass::kPart: phrase_.kind = NounKind::kPart; break;
    case WordClass::kNiche: phrase_.kind = NounKind::kAbstract, phrase_.niche = true; break;
    default: phrase_.kind = NounKind::kAbstract; break;
  }
}

// "the corner of the desk", "a bowl of fruit".
void NounPhraseReader::read_of() {
  if (!at_word("of") || i_ + 1 >= tokens_.size()) return;
  const bool bare = phrase_.kind == NounKind::kObject;
  if (read_sides(lexicon_, tokens_, i_ + 1).united) return;  // "a rug of 3 x 2 m"
  auto base = read_noun_phrase(lexicon_, tokens_, i_ + 1, true);
  if (!base && bare && (is_noun(noun_form(tokens_[i_ + 1].text)) || is_english(tokens_[i_ + 1].text)) &&
      !lexicon_.is(tokens_[i_ + 1], WordClass::kDefinite)) {
    phrase_.name += " of " + tokens_[i_ + 1].text;  // "a spool of solder": a verb elsewhere
    i_ += 2;
    return;
  }
  if (!base) return;
  // "a table of glass": what furniture is made of is no part of its name
  const std::size_t stuff = lexicon_.find(tokens_, i_ + 1, WordClass::kMaterial).length;
  const bool furniture = bare && phrase_.entry != nullptr && phrase_.entry->mount == Mount::kFloor;
  if (furniture && stuff > 0 && base->last == i_ + 1 + stuff && base->determiner == Determiner::kNone && base->count == 0) return;
  // "the lower shelf of a bookcase": a part of what has shelves, not what is on them ("a shelf of books")
  const bool has_it = base->kind == NounKind::kObject && base->entry != nullptr && base->entry->mount == Mount::kFloor &&
                      !base->is_plural() && base->determiner != Determiner::kNone;
  if (bare && phrase_.head == "shelf" && has_it && phrase_.count <= 1 && !phrase_.plural) {
    phrase_.kind = NounKind::kPart;
    i_ = base->last;
    phrase_.of = std::make_shared<NounPhrase>(std::move(*base));
    return;
  }
  // "a shoebox of a bedroom" at the very beginning; a "model of a theater" is a thing
  constexpr std::size_t kOpening = 4;
  if (bare && phrase_.first < kOpening && base->kind == NounKind::kRoom && base->determiner == Determiner::kIndefinite) {
    base->first = phrase_.first;
    i_ = base->last;
    phrase_ = std::move(*base);
    return;
  }
  if (bare) {  // part of the name, not a thing of its own
    if (base->kind != NounKind::kObject && base->kind != NounKind::kAbstract) return;
    i_ = base->last;
    if (phrase_.head == "set" && base->kind == NounKind::kObject && base->count > 0) {  // "a tea set of six cups": the cups
      base->first = phrase_.first;
      phrase_ = std::move(*base);
      return;
    }
    phrase_.name += " of " + (base->name.empty() ? text_of(tokens_, base->first, base->last) : base->name);
    // "a bar of lavender soap", "a tub of modeling clay": listed by what it is of, whatever is said of that.
    const std::vector<Token> called = tokenize(phrase_.name);
    const Match listed = lexicon_.find(called, 0);
    if (const Meaning* thing = meaning_of(listed, WordClass::kObject); thing != nullptr && listed.length == called.size()) {
      phrase_.entry = thing->entry;
      phrase_.category = thing->entry->id;
      return;
    }
    // "a bin of toys", "a rack of shoes": what is called a toy bin.
    const CatalogEntry* own = base->count == 0 ? lexicon_.entry_called(base->head + " " + phrase_.head) : nullptr;
    if (own != nullptr && phrase_.entry != nullptr && !phrase_.entry->is(Trait::kShelving)) {
      phrase_.entry = own;
      phrase_.category = own->id;
    }
    // "a tub of clay" is none to bathe in.
    if (const CatalogEntry* portion = lexicon_.catalog().find(portion_entry(phrase_.head)); portion != nullptr && !base->exact) {
      phrase_.entry = portion;
      phrase_.category = portion->id;
    }
    const bool things = base->kind == NounKind::kObject && base->exact && base->plural && base->determiner == Determiner::kNone;
    if (things) phrase_.contents = std::make_shared<NounPhrase>(std::move(*base));
    return;
  }
  i_ = base->last;
  phrase_.of = std::make_shared<NounPhrase>(std::move(*base));
}

}  // namespace layoutbox::offline
