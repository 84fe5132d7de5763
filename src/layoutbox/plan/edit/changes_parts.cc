#include "layoutbox/plan/edit/changes_parts.h"

namespace layoutbox::edit {

using namespace offline;

std::optional<Measure> length_at(const Lexicon& lexicon, const Tokens& tokens, std::size_t at) {
  if (at < tokens.size() && (is_at(tokens, at, "a") || is_at(tokens, at, "half") || is_at(tokens, at, "an"))) {
    const std::size_t half = is_at(tokens, at, "half") ? 1 : 0;  // "half a meter", "a meter", "a foot"
    std::size_t unit = at + 1;
    if (half == 1 && is_at(tokens, unit, "a")) ++unit;
    if (unit < tokens.size() && !is_at(tokens, unit, "in")) {
      Tokens one = {tokens[unit], tokens[unit]};
      one[0].kind = Token::Kind::kNumber;
      one[0].number = half == 1 ? 0.5 : 1;
      one[0].text = "1";
      if (const auto measure = read_measure(lexicon, one, 0)) return Measure{measure->metres, unit + 1 - at};
    }
    return std::nullopt;
  }
  return read_measure(lexicon, tokens, at);
}

std::size_t degree_words(const Tokens& tokens, std::size_t at) {
  std::size_t i = at;
  for (;;) {
    const bool one_more = i + 1 < tokens.size() && one_of(tokens[i + 1].text, {"little", "tiny", "small"}) && is_at(tokens, i + 2, "bit");
    if (is_at(tokens, i, "a") && one_more) {  // "a little bit"
      i += 3;
    } else if (is_at(tokens, i, "a") && i + 1 < tokens.size() && one_of(tokens[i + 1].text, {"bit", "little", "tad", "touch"})) {
      i += 2;
    } else if (i < tokens.size() && one_of(tokens[i].text, {"slightly", "somewhat", "further", "farther", "more", "much", "even", "by",
                                                            "over", "straight", "just", "some", "about"})) {
      ++i;
    } else {
      return i - at;
    }
  }
}

bool says_little(const Tokens& tokens, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    if (one_of(tokens[i].text, {"bit", "little", "tad", "touch", "slightly", "somewhat"})) return true;
  }
  return false;
}

}  // namespace layoutbox::edit
