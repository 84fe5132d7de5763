// Lengths and sizes: "1.2 m", "5 ft 6 in", "120 cm wide", "6 x 5 m".
#include <algorithm>

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

namespace {

bool is_by(const Token& token) { return token.text == "x" || token.text == "by" || token.text == "*"; }

// A number in digits or words and how many tokens it takes; 0 tokens for none.
std::pair<double, std::size_t> number_at(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at) {
  if (at >= tokens.size()) return {0, 0};
  if (tokens[at].kind == Token::Kind::kNumber) return {tokens[at].number, 1};
  const Match match = lexicon.find(tokens, at, Class::kNumber);
  return match.length == 0 ? std::pair{0.0, std::size_t{0}} : std::pair{meaning_of(match, Class::kNumber)->value, match.length};
}

}  // namespace

SidesRead read_sides(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at) {
  constexpr double kLongestInMetres = 20;  // what is longer and has no unit is in feet
  SidesRead read;
  std::vector<bool> united;
  double unit = 0;
  std::size_t i = at;
  while (read.sides.size() < 3) {
    const auto [value, digits] = number_at(lexicon, tokens, i);
    if (digits == 0) break;
    const auto measure = read_measure(lexicon, tokens, i);
    read.sides.push_back(measure ? measure->metres : value);
    united.push_back(measure.has_value());
    if (measure) unit = value > 0 ? measure->metres / value : 1;
    i += measure ? measure->length : digits;
    // "4 m wide by 3 m deep"
    const Match dimension = i < tokens.size() ? lexicon.find(tokens, i, Class::kDimension) : Match{};
    if (measure && dimension.length > 0 && i + dimension.length < tokens.size() && is_by(tokens[i + dimension.length]))
      i += dimension.length;
    if (i >= tokens.size() || !is_by(tokens[i]) || number_at(lexicon, tokens, i + 1).second == 0) break;
    ++i;
  }
  if (read.sides.size() < 2) return {};
  if (unit == 0) unit = *std::max_element(read.sides.begin(), read.sides.end()) > kLongestInMetres ? 0.3048 : 1.0;
  for (std::size_t s = 0; s < read.sides.size(); ++s) {
    if (!united[s]) read.sides[s] *= unit;
  }
  read.length = i - at;
  return read;
}

}  // namespace layoutbox::offline
