// Noun phrases that say which of several they mean: the rest, half of them, every other one, the middle one, the tallest, the first two.
#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/words/english.h"
#include "layoutbox/plan/words/word_sets.h"

namespace layoutbox::offline {

// Nothing at `at` goes on with a name: the phrase is about members, no "rest area", "half wall".
bool NounPhraseReader::name_ends(std::size_t at) const {
  if (at >= tokens_.size() || tokens_[at].kind != Token::Kind::kWord || lexicon_.find_phrase(tokens_, at).length > 0) return true;
  const Match next = lexicon_.find(tokens_, at);
  static constexpr std::array kAfter = {WordClass::kBe,       WordClass::kHave,       WordClass::kVerb,   WordClass::kPlaceVerb,
                                        WordClass::kHang,     WordClass::kParticiple, WordClass::kAnd,    WordClass::kIndefinite,
                                        WordClass::kDefinite, WordClass::kClause,     WordClass::kAdverb, WordClass::kNumber};
  return tokens_[at].text == "of" || std::ranges::any_of(kAfter, [&](WordClass word) { return has(next, word); });
}

// "the rest", "the rest of the chairs", "the remainder"
bool NounPhraseReader::read_rest() {
  const bool rest = phrase_.determiner == Determiner::kDefinite && !counted_ && (at_word("rest") || at_word("remainder"));
  if (!rest || !name_ends(i_ + 1)) return false;
  const std::size_t at = i_++;
  phrase_.determiner = Determiner::kOther;
  phrase_.plural = true;
  if (at_word("of") && !read_subset()) {  // "the rest of the room"
    i_ = at;
    phrase_.determiner = Determiner::kDefinite;
    phrase_.plural = false;
    return false;
  }
  phrase_.kind = NounKind::kMember;
  return done_ = true;
}

// "half of them", "half the chairs", "a third of the jars", "the other half"
bool NounPhraseReader::read_share() {
  static constexpr std::pair<std::string_view, int> kShares[] = {{"half", 2}, {"third", 3}, {"quarter", 4}};
  const auto share = std::ranges::find_if(kShares, [&](const auto& row) { return at_word(row.first); });
  if (share == std::end(kShares) || counted_ || hyphenated(i_ + 1) || !name_ends(i_ + 1)) return false;
  const std::size_t at = i_;
  if (phrase_.determiner == Determiner::kOther) {
    ++i_;
    // "a car on the left, the other half is my workshop": of the room, where no half of things was spoken of
    const bool first = std::none_of(tokens_.begin(), tokens_.begin() + static_cast<std::ptrdiff_t>(at),
                                    [&](const Token& token) { return token.text == share->first; });
    if (first && (at_word("is") || at_word("for") || at_word("as"))) {
      phrase_.kind = NounKind::kAbstract;
      phrase_.determiner = Determiner::kDefinite;
      phrase_.name = phrase_.head = share->first;
      return done_ = true;
    }
    if (at_word("of")) read_subset();
    phrase_.kind = NounKind::kMember;
    phrase_.plural = true;
    return done_ = true;
  }
  const bool article = phrase_.determiner == Determiner::kIndefinite || phrase_.determiner == Determiner::kNone;
  const bool of_all =
      share->second == 2 && i_ + 1 < tokens_.size() && lexicon_.is(tokens_[i_ + 1], WordClass::kDefinite);  // "half the chairs"
  if (!article || !(of_all || at_word("of", 1))) return false;
  if (!of_all) ++i_;
  const Token of = tokens_[i_];
  if (of_all) {
    auto base = read_noun_phrase(lexicon_, tokens_, i_ + 1, false);
    if (base && base->kind == NounKind::kObject && base->is_plural()) {
      i_ = base->last;
      phrase_.of = std::make_shared<NounPhrase>(std::move(*base));
      phrase_.kind = NounKind::kMember;
      phrase_.subset = true;
    }
  } else {
    read_subset();
  }
  if (phrase_.kind != NounKind::kMember) {
    i_ = at;
    return false;
  }
  phrase_.determiner = Determiner::kNone;
  phrase_.plural = true;
  phrase_.share = share->second;
  return done_ = true;
}

// "every other one", "every second seat": after "every"
void NounPhraseReader::read_every_nth() {
  static constexpr std::pair<std::string_view, int> kSteps[] = {{"other", 2}, {"second", 2}, {"third", 3}, {"fourth", 4}};
  for (const auto& [word, step] : kSteps) {
    if (!at_word(word) || tokens_[i_ - 1].text != "every") continue;
    phrase_.every = step;
    ++i_;
    return;
  }
}

// "the middle one", "the two outer ones", "the leftmost", "the middle desk": before the head.
bool NounPhraseReader::read_rank() {
  static constexpr std::pair<std::string_view, Rank> kRanks[] = {
      {"middle", Rank::kMiddle},   {"center", Rank::kMiddle}, {"central", Rank::kMiddle}, {"outer", Rank::kEnds},
      {"outermost", Rank::kEnds},  {"outside", Rank::kEnds},  {"leftmost", Rank::kFirst}, {"rightmost", Rank::kLast},
      {"left-hand", Rank::kFirst}, {"topmost", Rank::kFirst}};
  const bool definite = phrase_.determiner == Determiner::kDefinite || phrase_.determiner == Determiner::kPossessive;
  if (!parts_.empty() || !definite || phrase_.rank != Rank::kAny) return false;
  const auto rank = std::ranges::find_if(kRanks, [&](const auto& row) { return at_word(row.first); });
  if (rank == std::end(kRanks)) return false;
  const std::size_t after = i_ + 1;
  const bool one = after < tokens_.size() && (tokens_[after].text == "one" || tokens_[after].text == "ones");
  const bool most = rank->first.ends_with("most");
  const Match head = after < tokens_.size() ? lexicon_.find(tokens_, after) : Match{};
  const bool number = has(head, WordClass::kNumber) && !one;  // "the outer two"
  const bool thing = has(head, WordClass::kObject) && !has(head, WordClass::kPart) && (most || rank->second == Rank::kMiddle);
  if (!one && !number && !(most && name_ends(after)) && !thing) return false;
  // "the center table" is one by name; "the middle table" one of several.
  if (thing && rank->first == "center") return false;
  phrase_.rank = rank->second;
  ++i_;
  if (thing) return true;
  if (one) phrase_.plural = at_word("ones"), ++i_;
  if (number) read_count(), phrase_.plural = true;
  phrase_.kind = NounKind::kMember;
  done_ = true;
  return true;
}

// "the tallest", "the smallest one": one of several, by a quality.
bool NounPhraseReader::read_superlative() {
  const bool definite = phrase_.determiner == Determiner::kDefinite;
  if (!definite || !parts_.empty() || !more() || token().kind != Token::Kind::kWord || token().text.size() < 6) return false;
  const std::string& word = token().text;
  const bool compared = one_of(word, WordSet::kCompared);
  if ((!word.ends_with("est") && !compared) || lexicon_.find_phrase(tokens_, i_).length > 0 ||
      lexicon_.find(tokens_, i_, WordClass::kObject).length > 0)
    return false;
  const std::size_t after = i_ + 1;
  const bool one = after < tokens_.size() && (tokens_[after].text == "one" || tokens_[after].text == "ones");
  if (noun_form(word) == WordForm::kThing || (!one && !name_ends(after))) return false;
  phrase_.attributes.push_back(word);
  phrase_.attribute_classes.push_back(WordClass::kQuality);
  if (at_word("of", 1)) {
    ++i_;
    if (!read_subset()) --i_;
  }
  if (phrase_.kind != NounKind::kMember) i_ = one ? after + 1 : after;
  phrase_.kind = NounKind::kMember;
  return done_ = true;
}

// "one of the beds", "two of them", "each of which".
bool NounPhraseReader::read_subset() {
  if (!at_word("of") || i_ + 1 >= tokens_.size()) return false;
  const Token& next = tokens_[i_ + 1];
  if (next.text == "which" || next.text == "them" || next.text == "these" || next.text == "those" || next.text == "whom") {
    const bool alone = i_ + 2 >= tokens_.size() || !lexicon_.find(tokens_, i_ + 2, WordClass::kObject).length || next.text == "which" ||
                       next.text == "them";
    if (alone) {
      phrase_.kind = NounKind::kMember;
      phrase_.subset = true;
      i_ += 2;
      return done_ = true;
    }
  }
  const bool counted = phrase_.determiner == Determiner::kEach && number_follows(1);  // "in each of two corners"
  if (lexicon_.is(next, WordClass::kDefinite) || lexicon_.is(next, WordClass::kPossessive) || counted) {
    auto base = read_noun_phrase(lexicon_, tokens_, i_ + 1, false);
    const bool part_of_room = base && (base->kind == NounKind::kWall || base->kind == NounKind::kCorner ||
                                       base->kind == NounKind::kWindow || base->kind == NounKind::kDoor);
    if (part_of_room || (base && counted && base->kind == NounKind::kObject)) {  // "three of the walls", "by one of the windows"
      if (phrase_.determiner == Determiner::kEach) base->determiner = Determiner::kEach;
      if (phrase_.count > 0) base->count = phrase_.count;
      base->first = phrase_.first;
      phrase_ = std::move(*base);
      i_ = phrase_.last;
      return done_ = true;
    }
    if (base && base->kind == NounKind::kObject) {
      phrase_.kind = NounKind::kMember;
      phrase_.subset = true;
      i_ = base->last;
      phrase_.of = std::make_shared<NounPhrase>(std::move(*base));
      return done_ = true;
    }
  }
  return false;
}

}  // namespace layoutbox::offline
