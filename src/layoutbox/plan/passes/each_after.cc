#include "layoutbox/plan/passes/each_after.h"

#include <algorithm>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/phrases/splice.h"

namespace layoutbox::offline {
namespace {

bool breaks(const Document& document, std::size_t at) {
  return document.tokens[at].kind == Token::Kind::kPunctuation && document.tokens[at].text != "+" && document.tokens[at].text != "&";
}

// "with four chairs each": where its "with" stands, at most so many words before, or the place of "each" where it has none.
std::size_t having_before(const Lexicon& lexicon, const Document& document, std::size_t each, std::size_t longest = 6) {
  for (std::size_t at = each; at-- > 1 && each - at <= longest;) {
    if (breaks(document, at) || document.tokens[at].ends_sentence) break;
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

// "six desks, a monitor and a chair each": where the list begins that nothing but its comma joins to them; the place of "each": nowhere.
std::size_t bare_list_before(const Lexicon& lexicon, const Document& document, std::size_t each) {
  constexpr std::size_t kLongest = 8;  // words
  bool several = false;
  std::size_t at = each;
  for (; at-- > 1 && each - at <= kLongest && !breaks(document, at) && !document.tokens[at].ends_sentence;) {
    const Token& token = document.tokens[at];
    const bool joins = token.text == "+" || token.text == "&" || token.text == "and" || token.text == "plus";
    several |= joins;
    const bool listed = joins || lexicon.is(token, WordClass::kIndefinite) ||
                        lexicon.find(document.tokens, at, WordClass::kObject).length > 0 || lexicon.is(token, WordClass::kSizeWord) ||
                        lexicon.is(token, WordClass::kColor) || lexicon.is(token, WordClass::kMaterial);
    if (!listed) return each;
  }
  const bool ends = each + 1 >= document.tokens.size() || document.tokens[each].ends_sentence || breaks(document, each + 1);
  return several && ends && at > 0 && document.tokens[at].text == "," ? at + 1 : each;
}

// "four tables with six seats and a lamp on each": where the list of what each has begins; the place of "each": there is none.
std::size_t shared_list_before(const Lexicon& lexicon, const Document& document, std::size_t each) {
  constexpr std::size_t kLongest = 10;  // words
  const bool over = each + 1 >= document.tokens.size() || document.tokens[each].ends_sentence || breaks(document, each + 1);
  const std::size_t with = over ? having_before(lexicon, document, each, kLongest) : each;
  bool several = false;
  for (std::size_t at = with; at < each; ++at) several |= says_one_of(document, at, {"and", "+", "plus"});
  return several ? with : each;
}

}  // namespace

void read_each_after(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  std::vector<Splice> words;
  for (std::size_t i = 3; i < document.tokens.size() && !is_set(document.stop); ++i) {
    if (!says_one_of(document, i, {"each"})) continue;
    if (const std::size_t list = bare_list_before(lexicon, document, i); list < i) {
      document.tokens[i - 1].ends_sentence |= document.tokens[i].ends_sentence;
      document.tokens[i].ends_sentence = false;
      move_before(document, skip, list, i, i + 1);
      words.push_back({list + 1, word_token("with")});
      continue;
    }
    if (const std::size_t with = shared_list_before(lexicon, document, i); with < i) {
      const bool on = says_one_of(document, i - 1, {"on", "at"});
      if (on) skip[i - 1] = true;
      document.tokens[i - (on ? 2 : 1)].ends_sentence |= document.tokens[i].ends_sentence;
      document.tokens[i].ends_sentence = false;
      move_before(document, skip, with, i, i + 1);
      continue;
    }
    if (document.tokens[i].ends_sentence || i + 1 >= document.tokens.size()) continue;
    if (!is_placed(document, i + 1) && !is_placed(document, aside_ends(document, i + 1))) continue;
    if (const std::size_t with = having_before(lexicon, document, i); with < i) move_before(document, skip, with, i, i + 1);
  }
  splice(document, skip, std::move(words));
}

}  // namespace layoutbox::offline
