// How a noun phrase opens: determiner, "at least", pronouns.
#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"
#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {

bool NounPhraseReader::read_pronoun() {
  const Match pronoun = lexicon_.find(tokens_, i_, WordClass::kPronoun);
  if (pronoun.length == 0) return false;
  const std::string& text = token().text;
  const bool may_determine = text == "this" || text == "that" || text == "these" || text == "those";
  if (may_determine) {
    const Match next = lexicon_.find(tokens_, i_ + 1);
    const bool place = lexicon_.find_phrase(tokens_, i_ + 1).length > 0 && !has(next, WordClass::kObject) &&
                       attribute_of(next) == nullptr && !has(next, WordClass::kWallRelation) &&
                       !has(next, WordClass::kWallWord);  // "put that by the window"
    const bool number =
        (text == "that" || text == "this") && has(next, WordClass::kNumber) && !at_word("one", 1);  // "behind that two chairs"
    const bool article =
        place || number || has(next, WordClass::kIndefinite) || has(next, WordClass::kDefinite);  // "between these a table"
    if (next.length > 0 && !article && !has(next, WordClass::kBe) && !has(next, WordClass::kPlaceVerb)) return false;
    if (next.length == 0 && i_ + 1 < tokens_.size() && tokens_[i_ + 1].kind == Token::Kind::kWord) return false;
  }
  phrase_.kind = NounKind::kPronoun;
  phrase_.head = tokens_[i_ + pronoun.length - 1].text;
  phrase_.reciprocal = phrase_.head == "other" || phrase_.head == "another";  // "each other", "one another"
  phrase_.plural = text == "them" || text == "they" || text == "these" || text == "those" || text == "themselves";
  i_ += pronoun.length;
  return done_ = true;
}

// A number follows after so many tokens, and no length.
bool NounPhraseReader::number_follows(std::size_t length) const {
  return length > 0 && i_ + length < tokens_.size() &&
         (tokens_[i_ + length].kind == Token::Kind::kNumber || lexicon_.find(tokens_, i_ + length, WordClass::kNumber).length > 0 ||
          lexicon_.is(tokens_[i_ + length], WordClass::kIndefinite)) &&
         !read_measure(lexicon_, tokens_, i_ + length);
}

// "at least three", "more than two", "exactly four".
NounPhraseReader::Opening NounPhraseReader::read_bound() {
  const Match at_least = lexicon_.find(tokens_, i_, WordClass::kAtLeast), more_than = lexicon_.find(tokens_, i_, WordClass::kMoreThan),
              at_most = lexicon_.find(tokens_, i_, WordClass::kAtMost), exactly = lexicon_.find(tokens_, i_, WordClass::kExactly);
  const auto is_article = [&](const Match& match) { return lexicon_.is(tokens_[i_ + match.length], WordClass::kIndefinite); };
  if (number_follows(more_than.length) && !is_article(more_than)) {
    i_ += more_than.length;
    if (!read_count()) return Opening::kEnds;
    phrase_.count += 1;
    phrase_.at_least = true;
    return Opening::kGoesOn;
  }
  if (number_follows(at_least.length)) {
    phrase_.at_least = true;
    i_ += at_least.length;
    return Opening::kGoesOn;
  }
  if (number_follows(at_most.length) || (number_follows(exactly.length) && !is_article(exactly))) {
    i_ += std::max(at_most.length, exactly.length);
    return Opening::kGoesOn;
  }
  return Opening::kNothing;
}

bool NounPhraseReader::take(WordClass word_class, Determiner determiner) {
  const Match match = lexicon_.find(tokens_, i_, word_class);
  if (match.length == 0) return false;
  phrase_.determiner = determiner;
  i_ += match.length;
  return true;
}

// The, a, my, another, each.
NounPhraseReader::Opening NounPhraseReader::read_article() {
  // "on one a blanket", "above both a shelf"
  if ((counted_ || phrase_.determiner == Determiner::kBoth) && lexicon_.is(token(), WordClass::kIndefinite)) return Opening::kEnds;
  if (take(WordClass::kAnother, Determiner::kAnother)) {
    if (lexicon_.find_phrase(tokens_, i_).length < 2 || !(at_word("left") || at_word("right"))) return Opening::kGoesOn;
    phrase_.kind = NounKind::kMember;  // "… and another right of it"
    done_ = true;
    return Opening::kDone;
  }
  if (take(WordClass::kIndefinite, Determiner::kIndefinite)) {
    if (at_word("few")) i_ += 1, phrase_.count = 3, phrase_.vague = counted_ = true;
    return Opening::kGoesOn;
  }
  if (take(WordClass::kDefinite, Determiner::kDefinite)) return Opening::kGoesOn;
  if (take(WordClass::kPossessive, Determiner::kPossessive)) {
    if (tokens_[i_ - 1].contrasted) phrase_.owner_word = tokens_[i_ - 1].text;
    if (at_word("own")) i_ += 1, phrase_.determiner = Determiner::kIndefinite;  // "each has its own locker"
    return Opening::kGoesOn;
  }
  // "one each side of the door": the sides begin there.
  if (counted_ && i_ + 1 < tokens_.size() && lexicon_.is(tokens_[i_ + 1], WordClass::kSide)) return Opening::kEnds;
  if (!take(WordClass::kEach, Determiner::kEach) && !take(WordClass::kBoth, Determiner::kBoth)) return Opening::kNothing;
  return read_each();
}

// After "each", "both", "all".
NounPhraseReader::Opening NounPhraseReader::read_each() {
  counted_ |= phrase_.determiner == Determiner::kEach;
  read_every_nth();
  if (tokens_[i_ - 1].text == "of") {  // "all of them"
    --i_;
    if (read_subset()) return Opening::kDone;
    ++i_;
  }
  // "each comes with a lamp": one of them would have no -s
  if (phrase_.determiner == Determiner::kEach && more() && plural_at(i_) && may_be_verb(singular_of(token().text)) &&
      meaning_of(lexicon_.find(tokens_, i_), WordClass::kObject) == nullptr) {
    phrase_.kind = NounKind::kMember;
    done_ = true;
    return Opening::kDone;
  }
  // "below each one a bin"
  if (at_word("one") && (i_ + 1 >= tokens_.size() || tokens_[i_ + 1].kind == Token::Kind::kPunctuation || opens_at(i_ + 1))) {
    phrase_.kind = NounKind::kMember;
    i_ += 1;
    done_ = true;
    return Opening::kDone;
  }
  return read_subset() ? Opening::kDone : Opening::kGoesOn;
}

NounPhraseReader::Opening NounPhraseReader::read_opening() {
  if (token().kind == Token::Kind::kPunctuation) return Opening::kEnds;
  if (phrase_.determiner == Determiner::kNone && !counted_ && read_pronoun()) return Opening::kDone;
  if (read_rest() || read_share() || read_superlative()) return Opening::kDone;
  if (const Opening bound = read_bound(); bound != Opening::kNothing) return bound;
  if (read_rows() || read_clusters()) return Opening::kGoesOn;
  if (read_count()) return read_subset() ? Opening::kDone : Opening::kGoesOn;
  if (phrase_.determiner == Determiner::kNone || phrase_.determiner == Determiner::kBoth || phrase_.determiner == Determiner::kEach) {
    if (const Opening article = read_article(); article != Opening::kNothing) return article;
  }
  if (phrase_.determiner != Determiner::kDefinite && phrase_.determiner != Determiner::kNone) return Opening::kEnds;
  if (phrase_.determiner == Determiner::kDefinite && at_word("same") && i_ + 1 < tokens_.size() &&
      is_noun(noun_form(tokens_[i_ + 1].text)) && lexicon_.find_phrase(tokens_, i_ + 1).length == 0) {  // "on the same tabletop"
    ++i_;
    return Opening::kGoesOn;
  }
  // "12 more board games", "two additional stools"
  if (counted_ && (at_word("more") || at_word("additional") || at_word("extra") || at_word("further")) && i_ + 1 < tokens_.size() &&
      tokens_[i_ + 1].kind == Token::Kind::kWord && lexicon_.find_phrase(tokens_, i_ + 1).length == 0) {
    phrase_.determiner = Determiner::kAnother;
    ++i_;
    return Opening::kEnds;
  }
  const Match other = lexicon_.find(tokens_, i_, WordClass::kOther);
  if (other.length == 0 || (phrase_.determiner != Determiner::kDefinite && !counted_ && !at_word("other"))) return Opening::kEnds;
  phrase_.determiner = Determiner::kOther;
  i_ += other.length;
  return Opening::kGoesOn;
}

bool NounPhraseReader::read_determiners() {
  const std::size_t start = i_;
  while (more()) {
    const Opening opening = read_opening();
    if (opening == Opening::kDone) return true;
    if (opening != Opening::kGoesOn) break;
  }
  return more() && (i_ > start || bare_);
}

}  // namespace layoutbox::offline
