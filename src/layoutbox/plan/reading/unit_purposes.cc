// Purposes, and what is not wanted.

#include "layoutbox/plan/phrases/reader_words.h"
#include "layoutbox/plan/reading/unit_reader.h"
#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {

using Use = WordReading::Use;

// "…, for seven stools stand before it": why, and what is there.
bool UnitReader::gives_reason(std::size_t k) {
  const std::size_t n = next(k), verb = next(n);
  if (document_.tokens[chunk(k).first].text != "for" || !is(previous(k), ChunkKind::kComma) || !is(n, ChunkKind::kNoun) ||
      !is(verb, ChunkKind::kVerb) || chunk(n).noun.kind != NounKind::kObject ||
      !(chunk(n).noun.is_plural() || is_finite(document_.tokens[chunk(verb).first].text)))
    return false;
  mark(k, Use::kIgnored, "joins clauses");
  clause_ = true;
  negated_ = skipping_ = false;
  joiner_ = Joiner::kNone;
  return true;
}

void UnitReader::read_purpose(std::size_t k) {
  if (gives_reason(k)) return;
  if (passes_keeper(k) || shares_by_purpose(k) || passes_like(k) || keeps_place_for(k) || wishes_to(k)) return;
  if (reads_as_verb(k) || inverts(k)) {
    mark(k, Use::kUsed, "placing");
    add(UnitKind::kVerb, k);
    return;
  }
  if (names_contents(k) || wall_has(k)) {
    mark(k, Use::kUsed, "has");
    add(UnitKind::kHave, k);
    return;
  }
  if (passes_count(k) || passes_role(k) || brings_for_each(k) || brings_each(k)) return;
  if (k > 0 && chunk(k).first > 0 && lexicon_.is(document_.tokens[chunk(k).first - 1], WordClass::kCommand) &&
      lexicon_.is(document_.tokens[chunk(k).first], WordClass::kCommand)) {
    mark(k, Use::kIgnored, "opens a statement");  // "for the bedroom I imagine a bed"
    return;
  }
  mark(k, Use::kIgnored, "purpose");
  doing_ = is_person(previous(k)) || is_person(k);
  skipping_ = true;
  joiner_ = Joiner::kNone;
}

// "for my brother, who fixes bikes": what somebody does, to no things in particular.
bool UnitReader::passes_trade(std::size_t k) {
  if (document_.tokens[chunk(k).first].text != "who") return false;
  const std::size_t verb = next(k);
  const bool filler = is(verb, ChunkKind::kNoun) && chunk(k).last < chunk(verb).first;
  if (!filler && !is(verb, ChunkKind::kUnknown) && !is(verb, ChunkKind::kVerb) && !is(verb, ChunkKind::kPurpose)) return false;
  const std::size_t thing = filler ? verb : next(verb);
  if (!is(thing, ChunkKind::kNoun)) return false;
  const NounPhrase& noun = chunk(thing).noun;
  if (noun.kind != NounKind::kObject || noun.determiner != Determiner::kNone || noun.count > 0) return false;
  for (std::size_t c = k; c <= thing; ++c) mark(c, Use::kIgnored, "purpose");
  document_.chunks[thing - 1].kind = ChunkKind::kPurpose;
  skipping_ = doing_ = true;
  passed_until_ = thing + 1;
  return true;
}

// "and then like a mirror over the sink" says nothing; "another just like it to the right", "a clock shaped like a cat" say which one.
bool UnitReader::passes_like(std::size_t k) {
  const std::size_t like = next(k), p = previous(k);
  if (skipping_ || document_.tokens[chunk(k).first].text != "like" || chunk(k).last - chunk(k).first != 1 || !is(like, ChunkKind::kNoun))
    return false;
  const NounPhrase& noun = chunk(like).noun;
  if (is(p, ChunkKind::kNoun) && (noun.kind == NounKind::kPronoun || noun.kind == NounKind::kMember)) {
    mark(k, Use::kIgnored, "filler");
    mark(like, Use::kIgnored, "filler");
    passed_over_ = like;
    return true;
  }
  const bool breaks = is(p, ChunkKind::kAnd) || is(p, ChunkKind::kComma) || is(p, ChunkKind::kStop) || is(p, ChunkKind::kClause) ||
                      is(p, ChunkKind::kThere) || is(p, ChunkKind::kHave);
  const bool anew = noun.kind == NounKind::kObject && (noun.determiner == Determiner::kIndefinite || noun.count > 0);
  if (!breaks || !anew) return false;
  mark(k, Use::kIgnored, "filler");
  return true;
}

// A verb that no list has, and then a place: "a lamp towers over the desk", "two stools huddle by the bar".
bool UnitReader::reads_as_verb(std::size_t k) const {
  const std::size_t p = previous(k);
  const bool would = is(p, ChunkKind::kVerb) && chunk(p).passive && is(previous(p), ChunkKind::kNoun);  // "would look good in the corner"
  if (skipping_ || chunk(k).last - chunk(k).first != 1 || !(is(p, ChunkKind::kNoun) || would)) return false;
  const std::size_t n = next(k);
  // "a cat naps on it"
  const bool by_it = is(n, ChunkKind::kRelation) && is(p, ChunkKind::kNoun) && chunk(p).noun.kind == NounKind::kObject &&
                     document_.tokens[chunk(n).last - 1].text == "it";
  if (!is(n, ChunkKind::kRelation) || !(by_it || is(next(n), ChunkKind::kNoun))) return false;
  const std::string& word = document_.tokens[chunk(k).first].text;
  return word_form(word) == WordForm::kVerb && !lexicon_.is(document_.tokens[chunk(k).first], WordClass::kPurpose);
}

// "Plants I do not want": none of what was named before.
bool UnitReader::denies_before(std::size_t k) {
  if (units_.size() != 1 || units_.back().kind != UnitKind::kNoun || !(is(k + 1, ChunkKind::kStop) || is(k + 1, ChunkKind::kComma)))
    return false;
  const std::size_t n = units_.back().chunk;
  if (chunk(n).noun.kind != NounKind::kObject || chunk(n).noun.determiner != Determiner::kNone || chunk(n).noun.count > 0) return false;
  document_.excluded.push_back(chunk(n).noun);
  mark(n, Use::kUsed, "not wanted");
  units_.clear();
  return true;
}

// "nothing else, except a lamp", "no chairs except one": it is there.
bool UnitReader::excepts_from_nothing(std::size_t k) const {
  const std::string& word = document_.tokens[chunk(k).first].text;
  if (word != "except" && word != "excepting") return false;
  for (std::size_t i = chunk(k).first; i-- > 0 && !document_.tokens[i].ends_sentence;) {
    const std::string& before = document_.tokens[i].text;
    if (before == "nothing" || before == "no" || before == "empty" || before == "without" || before == "nobody") return true;
  }
  return false;
}

}  // namespace layoutbox::offline
