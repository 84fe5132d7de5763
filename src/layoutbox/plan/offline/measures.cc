// Lengths and sizes: "1.2 m", "5 ft 6 in", "120 cm wide", "6 x 5 m".
#include <algorithm>

#include "layoutbox/plan/offline/noun_phrase.h"
#include "layoutbox/plan/offline/noun_phrase_parts.h"

namespace layoutbox::offline {

using Class = WordClass;

namespace {

bool words_at(std::span<const Token> tokens, std::size_t at, std::initializer_list<std::string_view> words) {
  return at + words.size() <= tokens.size() && std::equal(words.begin(), words.end(), tokens.begin() + static_cast<std::ptrdiff_t>(at),
                                                          [](std::string_view word, const Token& token) { return token.text == word; });
}

// "1/2" after a whole number: a stroke leaves no token, only a gap.
bool fraction_at(std::span<const Token> tokens, std::size_t at) {
  return at + 1 < tokens.size() && tokens[at].kind == Token::Kind::kNumber && tokens[at + 1].kind == Token::Kind::kNumber &&
         tokens[at + 1].glued && tokens[at + 1].begin == tokens[at].end + 1 && tokens[at].number < tokens[at + 1].number;
}

}  // namespace

NumberRead read_number(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at) {
  if (at >= tokens.size()) return {};
  if (words_at(tokens, at, {"half", "a"})) return {0.5, 2};
  NumberRead read;
  if (tokens[at].kind == Token::Kind::kNumber) {
    if (fraction_at(tokens, at)) return {tokens[at].number / tokens[at + 1].number, 2};
    read = {tokens[at].number, 1};
    if (fraction_at(tokens, at + 1) && !tokens[at + 1].glued) {
      read.value += tokens[at + 1].number / tokens[at + 2].number;
      read.length += 2;
    }
  } else {
    const Match match = lexicon.find(tokens, at, Class::kNumber);
    if (match.length == 0) return {};
    read = {meaning_of(match, Class::kNumber)->value, match.length};
  }
  if (words_at(tokens, at + read.length, {"and", "a", "half"})) {
    read.value += 0.5;
    read.length += 3;
  }
  return read;
}

std::optional<Measure> read_measure(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at) {
  const auto [value, digits] = read_number(lexicon, tokens, at);
  const std::size_t unit_at = at + digits;
  if (digits == 0 || unit_at >= tokens.size()) return std::nullopt;
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
  // Feet and inches: 5 ft 6 in, 5'6.
  if (scale == 0.3048 && at + measure.length < tokens.size() && tokens[at + measure.length].kind == Token::Kind::kNumber) {
    const Token& inches = tokens[at + measure.length];
    const std::string_view second = at + measure.length + 1 < tokens.size() ? std::string_view(tokens[at + measure.length + 1].text) : "";
    const bool said = second == "\"" || second == "in" || second == "inches" || second == "inch";
    if (said || (inches.glued && unit_word == "'")) {
      measure.metres += inches.number * 0.0254;
      measure.length += said ? 2 : 1;
    }
  }
  if (words_at(tokens, at + measure.length, {"and", "a", "half"})) {  // "a meter and a half"
    measure.metres += scale / 2;
    measure.length += 3;
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

}  // namespace

bool noun_goes_on(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at) {
  if (at >= tokens.size() || tokens[at].kind != Token::Kind::kWord || lexicon.is(tokens[at], Class::kAnd) ||
      lexicon.is(tokens[at], Class::kBe) || lexicon.is(tokens[at], Class::kDefinite) || lexicon.is(tokens[at], Class::kIndefinite))
    return false;
  const Match match = lexicon.find(tokens, at);
  if (has(match, Class::kObject) || has(match, Class::kDoor) || has(match, Class::kWindow) || attribute_of(match) != nullptr) return true;
  static constexpr std::string_view kOfDistance[] = {"of", "from", "away", "apart", "off", "to", "in", "on", "at", "between"};
  return match.length == 0 && lexicon.find_phrase(tokens, at).length == 0 &&
         std::find(std::begin(kOfDistance), std::end(kOfDistance), tokens[at].text) == std::end(kOfDistance);
}

std::size_t read_size_before(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at, SaidSize& size) {
  if (const std::size_t named = read_size(lexicon, tokens, at, size); named > 0) return named;
  if (const SidesRead read = read_sides(lexicon, tokens, at); read.united && noun_goes_on(lexicon, tokens, at + read.length)) {
    size.width = read.sides[0];
    size.depth = read.sides[1];
    if (read.sides.size() > 2) size.height = read.sides[2];
    size.either = true;
    return read.length;
  }
  const auto measure = read_measure(lexicon, tokens, at);
  if (!measure || !noun_goes_on(lexicon, tokens, at + measure->length)) return 0;
  // "two foot stools"
  const Match named = lexicon.find(tokens, at + measure->length - 1);
  if (named.length > 1 && has(named, Class::kObject)) return 0;
  size.span = measure->metres;
  return measure->length;
}

SidesRead read_sides(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at) {
  constexpr double kLongestInMetres = 20;  // what is longer and has no unit is in feet
  SidesRead read;
  std::vector<bool> united;
  double unit = 0;
  std::size_t i = at;
  while (read.sides.size() < 3) {
    const auto [value, digits] = read_number(lexicon, tokens, i);
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
    if (i >= tokens.size() || !is_by(tokens[i]) || read_number(lexicon, tokens, i + 1).length == 0) break;
    ++i;
  }
  if (read.sides.size() < 2) return {};
  read.united = unit > 0;
  if (unit == 0) unit = *std::max_element(read.sides.begin(), read.sides.end()) > kLongestInMetres ? 0.3048 : 1.0;
  for (std::size_t s = 0; s < read.sides.size(); ++s) {
    if (!united[s]) read.sides[s] *= unit;
  }
  read.length = i - at;
  return read;
}

}  // namespace layoutbox::offline
