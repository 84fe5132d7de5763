#include "layoutbox/plan/room/bare_sides.h"

#include <optional>
#include <string>
#include <utility>

#include "layoutbox/plan/phrases/splice.h"

namespace layoutbox::offline {
namespace {

// "9 m deep" at [first, last); `unit`: where the unit stands, or would.
struct BareSide {
  std::size_t first = 0, unit = 0, last = 0;
  bool has_unit() const { return last - unit > 1; }
};

std::optional<BareSide> side_at(const Lexicon& lexicon, const std::vector<Token>& tokens, std::size_t at) {
  if (tokens[at].kind != Token::Kind::kNumber || at + 1 >= tokens.size()) return {};
  const std::size_t unit = lexicon.find(tokens, at + 1, WordClass::kUnit).length;
  const std::size_t word = at + 1 + unit;
  if (unit > 1 || word >= tokens.size() || tokens[word - 1].ends_sentence) return {};
  if (lexicon.find(tokens, word, WordClass::kDimension).length != 1) return {};
  return BareSide{at, at + 1, word + 1};
}

bool joins_sides(const Token& token) { return token.text == "," || token.text == "and" || token.text == "by" || token.text == "x"; }

}  // namespace

void complete_bare_sides(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  const std::vector<Token>& tokens = document.tokens;
  std::vector<Splice> units;
  for (std::size_t i = 0; i < tokens.size() && !is_set(document.stop);) {
    std::vector<BareSide> sides;
    std::size_t at = i;
    for (auto side = side_at(lexicon, tokens, at); side; side = at < tokens.size() ? side_at(lexicon, tokens, at) : std::nullopt) {
      sides.push_back(*side);
      at = side->last;
      while (at < tokens.size() && !tokens[at - 1].ends_sentence && joins_sides(tokens[at])) ++at;
    }
    Token unit;
    unit.kind = Token::Kind::kWord;
    unit.text = "m";
    for (const BareSide& side : sides) {
      if (side.has_unit()) unit = tokens[side.unit];
    }
    unit.ends_sentence = false;
    for (const BareSide& side : sides) {
      if (sides.size() > 1 && !side.has_unit()) units.push_back({side.unit, unit});
    }
    i = sides.empty() ? i + 1 : at;
  }
  splice(document, skip, std::move(units));
}

}  // namespace layoutbox::offline
