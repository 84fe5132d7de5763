#include "layoutbox/plan/passes/each_after.h"

#include "layoutbox/base/words.h"
#include "layoutbox/plan/phrases/splice.h"

namespace layoutbox::offline {
namespace {

// "with four chairs each": where its "with" stands, or the place of "each" where it has none.
std::size_t having_before(const Lexicon& lexicon, const Document& document, std::size_t each) {
  constexpr std::size_t kLongest = 6;  // words
  for (std::size_t at = each; at-- > 1 && each - at <= kLongest;) {
    const Token& token = document.tokens[at];
    if (token.kind == Token::Kind::kPunctuation || token.ends_sentence) break;
    if (!says_one_of(document, at, {"with", "having"})) continue;
    const std::string& before = document.tokens[at - 1].text;
    const bool counted = read_number(lexicon, document.tokens, at + 1).length > 0 || says_one_of(document, at + 1, {"a", "an"});
    return counted && before != singular_of(before) ? at : each;
  }
  return each;
}

bool is_placed(const Document& document, std::size_t at) {
  if (says_one_of(document, at, {","})) ++at;
  return says_one_of(document, at, {"placed", "arranged", "set", "grouped", "laid", "lined", "organized", "positioned", "spaced"});
}

// "each, white and red tablecloths, placed in two rows": the comma behind what is named by the way.
std::size_t aside_ends(const Document& document, std::size_t at) {
  constexpr std::size_t kLongest = 7;  // words
  if (!says_one_of(document, at, {","})) return at;
  for (std::size_t end = at + 1; end < document.tokens.size() && end <= at + kLongest && !document.tokens[end - 1].ends_sentence; ++end) {
    if (says_one_of(document, end, {","})) return end;
  }
  return at;
}

}  // namespace

void read_each_after(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  for (std::size_t i = 3; i + 1 < document.tokens.size() && !is_set(document.stop); ++i) {
    if (!says_one_of(document, i, {"each"}) || document.tokens[i].ends_sentence) continue;
    if (!is_placed(document, i + 1) && !is_placed(document, aside_ends(document, i + 1))) continue;
    if (const std::size_t with = having_before(lexicon, document, i); with < i) move_before(document, skip, with, i, i + 1);
  }
}

}  // namespace layoutbox::offline
