#include "layoutbox/plan/room/looks_behind.h"

#include <algorithm>

#include "layoutbox/catalog/opening_look.h"

namespace layoutbox::offline {
namespace {

// As many words right behind the opening's as say a look, and nothing else before its place or the clause's end; 0: none do.
std::size_t words_of_look(const Lexicon& lexicon, const Document& document, std::size_t noun, OpeningType type) {
  constexpr std::size_t kLongest = 4;
  const std::vector<Token>& tokens = document.tokens;
  std::size_t most = 0;
  std::string said, rest;  // without the first word
  for (std::size_t n = noun + 1; n < tokens.size() && n <= noun + kLongest && tokens[n].kind == Token::Kind::kWord; ++n) {
    const std::string without_last = said;
    if (!said.empty()) rest += (rest.empty() ? "" : " ") + tokens[n].text;
    said += (said.empty() ? "" : " ") + tokens[n].text;
    const std::size_t next = n + 1;
    const bool over = next >= tokens.size() || tokens[next].kind == Token::Kind::kPunctuation ||
                      lexicon.is(tokens[next], WordClass::kAnd) || says_one_of(document, next, {"on", "in", "at", "with", "to"});
    const auto says_look = [&](const std::string& words) { return opening_look(type, {words}) != OpeningLook{}; };
    if (over && says_look(said) && !says_look(rest) && !says_look(without_last)) most = n - noun;  // each of its words is needed
  }
  return most;
}

}  // namespace

void put_looks_before(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  for (std::size_t i = 0; i + 1 < document.tokens.size(); ++i) {
    const bool window = says_one_of(document, i, {"window", "windows"}), door = says_one_of(document, i, {"door", "doors"});
    if (skip[i] || (!window && !door)) continue;
    const std::size_t words = words_of_look(lexicon, document, i, window ? OpeningType::kWindow : OpeningType::kDoor);
    const auto turn = [&](auto& all) {
      const auto first = all.begin() + static_cast<std::ptrdiff_t>(i);
      std::rotate(first, first + 1, first + 1 + static_cast<std::ptrdiff_t>(words));
    };
    if (words == 0) continue;
    turn(document.tokens);
    turn(document.readings);
    turn(skip);
    i += words;
  }
}

}  // namespace layoutbox::offline
