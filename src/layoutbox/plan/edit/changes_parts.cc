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
    if (is_at(tokens, i, "a") && (is_at(tokens, i + 1, "bit") || is_at(tokens, i + 1, "little") || is_at(tokens, i + 1, "tad"))) {
      i += 2;
    } else if (i < tokens.size() && one_of(tokens[i].text, {"slightly", "somewhat", "further", "farther", "more", "much", "even", "by",
                                                            "over", "straight", "just", "some", "about"})) {
      ++i;
    } else {
      return i - at;
    }
  }
}

}  // namespace layoutbox::edit
