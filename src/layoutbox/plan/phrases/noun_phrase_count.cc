// How many a noun phrase says: digits and words, "two or three", heaps and clusters of them, rows; and numbers that count nothing.
#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

constexpr std::string_view kBunch = "bunch";

bool NounPhraseReader::read_count() {
  // "the other a stack of books" is two phrases.
  if (phrase_.determiner == Determiner::kOther && lexicon_.is(token(), WordClass::kIndefinite)) return false;
  // "2 m long", "120 cm wide", "five-foot", "4-seater" are no counts.
  if (take_size()) return true;
  if (describes(i_)) return false;
  return token().kind == Token::Kind::kNumber ? read_digits() : read_number_word();
}

// "a 10 litre bucket", "a six burner stove", "two 40 watt lamps": a number of what the thing has, holds or takes.
bool NounPhraseReader::describes(std::size_t at) const {
  if (at + 2 >= tokens_.size() || tokens_[at + 1].kind != Token::Kind::kWord || tokens_[at + 2].kind != Token::Kind::kWord) return false;
  const bool digits = tokens_[at].kind == Token::Kind::kNumber;
  if (!digits && lexicon_.find(tokens_, at, WordClass::kNumber).length != 1) return false;
  if (one_of(tokens_[at].text, WordSet::kCounting)) return false;
  if (one_of(tokens_[at + 1].text, WordSet::kContents))
    return tokens_[at + 2].text != "of" && lexicon_.find_phrase(tokens_, at + 2).length == 0;
  if (phrase_.determiner != Determiner::kIndefinite || counted_ || plural_at(at + 1)) return false;
  return is_noun(noun_form(tokens_[at + 1].text)) && lexicon_.find(tokens_, at + 2).length > 0 && !plural_at(at + 2);
}

// "a stack of four tires": the four stand on each other.
void NounPhraseReader::stack_if_heaped() {
  constexpr std::string_view kStack = "stack";
  if (heaped_ == kStack && phrase_.count > 1) {
    phrase_.attributes.emplace_back("stacked");
    phrase_.attribute_classes.push_back(WordClass::kQuality);
  }
  heaped_ = {};
}

bool NounPhraseReader::read_digits() {
  if (read_measure(lexicon_, tokens_, i_)) return false;
  if (hyphenated(i_ + 1) && i_ + 1 < tokens_.size() && tokens_[i_ + 1].kind == Token::Kind::kWord) return false;
  if (says_seats(i_ + 1)) return false;
  const double value = token().number;
  if (value < 0 || value > 500 || value != static_cast<int>(value)) return false;
  phrase_.count = heaped_.empty() ? std::max(phrase_.count, 1) * static_cast<int>(value) : static_cast<int>(value);
  stack_if_heaped();
  ++i_;
  if (at_word("x") && i_ + 1 < tokens_.size() && tokens_[i_ + 1].kind == Token::Kind::kWord) ++i_;  // "4 x chair"
  // "2-3 chairs", "2 to 3": the smaller number, at least.
  if (more() && token().kind == Token::Kind::kNumber && hyphenated(i_)) ++i_, phrase_.at_least = true;
  if (at_word("or")) read_upper_end();
  counted_ = true;
  return true;
}

// "a stack of", "two piles of": how several lie as one thing; empty where they do not, or where it is not said of how many heaps.
std::string_view NounPhraseReader::heap_at(std::size_t at, std::size_t length) const {
  for (std::size_t i = at; i < at + length; ++i) {
    const std::string_view heap = word_of(WordSet::kHeaps, singular_of(tokens_[i].text));
    if (!heap.empty() && (heap == tokens_[i].text || counted_)) return heap;
    if (singular_of(tokens_[i].text) == kBunch && is_tied(at + length) && (tokens_[i].text == kBunch || counted_)) return kBunch;
  }
  return {};
}

// "a bunch of keys", "three bunches of grapes" hang together; "a bunch of chairs" is only several.
bool NounPhraseReader::is_tied(std::size_t at) const {
  if (at >= tokens_.size()) return false;
  const Match thing = lexicon_.find(tokens_, at, WordClass::kObject);
  const std::size_t last = at + std::max<std::size_t>(thing.length, 1) - 1;
  if (one_of(singular_of(tokens_[last].text), WordSet::kTied)) return true;
  const Meaning* meaning = meaning_of(thing, WordClass::kObject);
  const Catalog& catalog = lexicon_.catalog();
  return meaning != nullptr && meaning->entry != nullptr &&
         (catalog.is_a(meaning->entry->id, "plant") || catalog.is_a(meaning->entry->id, "fruit"));
}

// A number in words, or "several"; the word may belong to something longer or be an adjective.
bool NounPhraseReader::read_number_word() {
  const Match number = lexicon_.find(tokens_, i_, WordClass::kNumber), vague = lexicon_.find(tokens_, i_, WordClass::kVague);
  if (number.length == 0 && vague.length == 0) return false;
  const bool is_number = number.length >= vague.length;
  const Match& best = is_number ? number : vague;
  if (is_no_count(best, is_number)) return false;
  const int value = static_cast<int>(meaning_of(best, is_number ? WordClass::kNumber : WordClass::kVague)->value);
  // "a pair of two chairs" stays two; "several dozen" is not worth more than several.
  // "two pairs of boots", "three dozen": so many times.
  const bool times = is_number && phrase_.count > 0 && (at_word("pairs") || at_word("pair") || at_word("dozen"));
  phrase_.count = times ? phrase_.count * value : phrase_.count > 0 && !is_number ? phrase_.count : value;
  if (is_number) {
    stack_if_heaped();
  } else {
    heaped_ = heap_at(i_, best.length);
  }
  phrase_.vague |= !is_number && (heaped_.empty() || !counted_);  // "two stacks of letters"
  counted_ = true;
  for (std::size_t i = i_; i < i_ + best.length; ++i) paired_ |= tokens_[i].text == "pair" || tokens_[i].text == "pairs";
  i_ += best.length;
  if (is_number && value >= 20 && value < 100 && value % 10 == 0 && more()) {  // "twenty-five"
    const Match ones = lexicon_.find(tokens_, i_, WordClass::kNumber);
    const int more_by = ones.length == 1 ? static_cast<int>(meaning_of(ones, WordClass::kNumber)->value) : 0;
    if (more_by > 0 && more_by < 10) phrase_.count += more_by, i_ += 1;
  }
  if (is_number) read_upper_end();
  return true;
}

bool NounPhraseReader::is_no_count(const Match& best, bool is_number) const {
  // Another word's longer meaning wins: "single bed", "one another", "twin-size".
  const Match any = at_word("dual") ? Match{} : lexicon_.find(tokens_, i_);
  const bool so_many = any.plural && !has(any, WordClass::kObject) && attribute_of(any) != nullptr;  // "two seats" are no "two-seat"
  if (any.length > best.length && !has(any, WordClass::kNumber) && !has(any, WordClass::kVague) && !so_many) return true;
  // "a stack of planks" is one thing that stands on the floor, "a stack of plates" so many.
  if (!is_number && best.length > 1 && lexicon_.is(tokens_[i_], WordClass::kIndefinite)) {
    const Match pile = lexicon_.find(tokens_, i_ + 1, WordClass::kObject);
    const Meaning* thing = meaning_of(pile, WordClass::kObject);
    const bool one = thing != nullptr && thing->entry != nullptr &&
                     (thing->entry->mount == Mount::kFloor || !plural_at(i_ + pile.length));  // "a pile of laundry"
    if (pile.length >= best.length && one) return true;
  }
  const bool adjective = is_number && attribute_of(any) != nullptr;
  if (adjective && any.length == best.length && counted_) return true;
  // "two-seater", "three-legged": a compound adjective. "Twenty-five" is none.
  if (best.length == 1 && !lexicon_.is(tokens_[std::min(i_ + 1, tokens_.size() - 1)], WordClass::kNumber) &&
      (hyphenated(i_ + 1) || (is_number && says_seats(i_ + 1))))
    return true;
  if (doubles_noun(i_)) return true;
  // "twin", "double", "single" and "full" are adjectives of beds and sofas as well: only "dual monitors" and the like are counts.
  if (!adjective) return false;
  const Match next = lexicon_.find(tokens_, i_ + best.length);
  const Meaning* thing = meaning_of(next, WordClass::kObject);
  if (at_word("double") && thing != nullptr && thing->entry != nullptr && thing->entry->mount == Mount::kFloor) return true;
  return !next.plural || has(next, WordClass::kSizeWord);
}

// "three to five", "two or three"
void NounPhraseReader::read_upper_end() {
  if (!more() || i_ + 1 >= tokens_.size()) return;
  if (!at_word("to") && !at_word("or") && !(token().kind == Token::Kind::kPunctuation && token().text == "-")) return;
  if (at_word("or") && (at_word("more", 1) || at_word("so", 1) || at_word("less", 1) || at_word("fewer", 1))) {
    phrase_.at_least |= at_word("more", 1);
    i_ += 2;
    return;
  }
  const Match upper = lexicon_.find(tokens_, i_ + 1, WordClass::kNumber);
  if (upper.length > 0) i_ += 1 + upper.length, phrase_.at_least = true;
}

// "a dual sink vanity", "a triple monitor stand": an adjective of what is one; "dual monitors" are two.
bool NounPhraseReader::doubles_noun(std::size_t at) const {
  if (at + 1 >= tokens_.size() || !one_of(tokens_[at].text, WordSet::kDoubling)) return false;
  const Match next = lexicon_.find(tokens_, at + 1);
  if (tokens_[at + 1].text == "one") return true;  // "a double one"
  return next.length > 0 && has(next, WordClass::kObject) && !next.plural;
}

// A size before the noun. "55-inch" is kept as an attribute as well.
bool NounPhraseReader::take_size() {
  const std::size_t taken = read_size_before(lexicon_, tokens_, i_, phrase_.size);
  if (taken == 0) return false;
  if (phrase_.size.span) {
    phrase_.attributes.push_back(text_of(tokens_, i_, i_ + taken));
    phrase_.attribute_classes.push_back(WordClass::kSizeWord);
  }
  i_ += taken;
  return true;
}

// "two clusters of four desks": eight desks; "two clusters of desks": however many.
bool NounPhraseReader::read_clusters() {
  if (!counted_ || phrase_.count < 2 || !more() || token().kind != Token::Kind::kWord || !at_word("of", 1) || i_ + 3 >= tokens_.size() ||
      !one_of(token().text, WordSet::kClusters))
    return false;
  const std::size_t at = i_;
  const int clusters = phrase_.count;
  i_ += 2;
  phrase_.count = 0;
  const bool of_desks = more() && lexicon_.find(tokens_, i_).plural && has(lexicon_.find(tokens_, i_), WordClass::kObject);
  if ((!read_count() || phrase_.count == 0) && !of_desks) {
    i_ = at;
    phrase_.count = clusters;
    return false;
  }
  phrase_.clusters = clusters;
  phrase_.count *= clusters;
  return true;
}

// "6 seater table", "four person desk": after the number.
bool NounPhraseReader::says_seats(std::size_t at) const {
  static constexpr std::string_view kWords[] = {"seater", "person", "seat", "place"};
  return at + 1 < tokens_.size() && std::find(std::begin(kWords), std::end(kWords), tokens_[at].text) != std::end(kWords) &&
         tokens_[at + 1].kind == Token::Kind::kWord && has(lexicon_.find(tokens_, at + 1), WordClass::kObject);
}

// "two rows of four chairs", "a row of stools", "a bank of monitors".
bool NounPhraseReader::read_rows() {
  const bool columns = at_word("columns") && i_ + 2 < tokens_.size() && lexicon_.find(tokens_, i_ + 2, WordClass::kNumber).length > 0;
  const bool known = has(lexicon_.find(tokens_, i_), WordClass::kObject);  // "a bank of drawers"
  const bool one = at_word("row") || at_word("line") || (at_word("bank") && !known);
  const bool several = at_word("rows") || at_word("lines") || columns || (at_word("banks") && !known);
  if ((!one && !several) || !at_word("of", 1) || i_ + 2 >= tokens_.size()) return false;
  phrase_.rows = one ? 1 : std::max(phrase_.count, 2);
  phrase_.count = 0;
  phrase_.determiner = Determiner::kNone;
  phrase_.vague = counted_ = true;
  i_ += 2;
  return true;
}

}  // namespace layoutbox::offline
