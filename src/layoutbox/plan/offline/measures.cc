// Lengths and sizes: "1.2 m", "5 ft 6 in", "120 cm wide".
#include "layoutbox/plan/offline/noun_phrase.h"
#include "layoutbox/plan/offline/noun_phrase_parts.h"

namespace layoutbox::offline {

using Class = WordClass;

std::optional<Measure> read_measure(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at) {
  if (at >= tokens.size()) return std::nullopt;
  double value = tokens[at].number;
  std::size_t unit_at = at + 1;
  if (tokens[at].kind != Token::Kind::kNumber) {
    const Match number = lexicon.find(tokens, at, Class::kNumber);
    if (number.length == 0) return std::nullopt;
    value = meaning_of(number, Class::kNumber)->value;
    unit_at = at + number.length;
  }
  if (unit_at >= tokens.size()) return std::nullopt;
  const std::string& unit_word = tokens[unit_at].text;
  Match unit = lexicon.find(tokens, unit_at, Class::kUnit);
  double scale = 0;
  if (unit.length > 0) scale = meaning_of(unit, Class::kUnit)->value;
  if (unit.length == 0 && unit_word == "\"") scale = 0.0254, unit.length = 1;
  if (unit.length == 0 && (unit_word == "'" || unit_word == "'s")) scale = 0.3048, unit.length = 1;
  if (unit.length == 0) return std::nullopt;
  // "in" is a preposition unless a number stands right before it and no noun phrase follows.
  if (unit_word == "in" && tokens[at].kind == Token::Kind::kNumber && !tokens[unit_at].glued) {
    const bool more = unit_at + 1 < tokens.size() &&
                      (lexicon.is(tokens[unit_at + 1], Class::kDefinite) || lexicon.is(tokens[unit_at + 1], Class::kIndefinite));
    if (more) return std::nullopt;
  }
  if (unit_word == "in" && tokens[at].kind != Token::Kind::kNumber) return std::nullopt;
  Measure measure{value * scale, unit_at + 1 - at};
  // Feet and inches: 5 ft 6 in.
  if (scale == 0.3048 && at + measure.length + 1 < tokens.size() && tokens[at + measure.length].kind == Token::Kind::kNumber) {
    const std::string& second = tokens[at + measure.length + 1].text;
    if (second == "\"" || second == "in" || second == "inches" || second == "inch") {
      measure.metres += tokens[at + measure.length].number * 0.0254;
      measure.length += 2;
    }
  }
  return measure;
}

std::size_t read_size(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at, SaidSize& size) {
  const auto measure = read_measure(lexicon, tokens, at);
  if (!measure) return 0;
  std::size_t i = at + measure->length;
  const auto dimension = i < tokens.size() ? lexicon.find(tokens, i, Class::kDimension) : Match{};
  if (dimension.length == 0) return 0;
  const std::string_view which = meaning_of(dimension, Class::kDimension)->word;
  if (which == "w") size.width = measure->metres;
  if (which == "l") size.length = measure->metres;
  if (which == "d") size.depth = measure->metres;
  if (which == "h") size.height = measure->metres;
  if (which == "s") size.width = size.depth = measure->metres;
  return i + dimension.length - at;
}

}  // namespace layoutbox::offline
