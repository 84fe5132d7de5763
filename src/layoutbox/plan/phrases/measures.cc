// Lengths and sizes: "1.2 m", "5 ft 6 in", "120 cm wide", "6 x 5 m".
#include <algorithm>

#include "layoutbox/plan/phrases/noun_phrase.h"
#include "layoutbox/plan/phrases/noun_phrase_parts.h"

namespace layoutbox::offline {

namespace {

bool is_by(const Token& token) { return token.text == "x" || token.text == "by" || token.text == "*"; }

bool words_at(std::span<const Token> tokens, std::size_t at, std::initializer_list<std::string_view> words) {
  return at + words.size() <= tokens.size() && std::equal(words.begin(), words.end(), tokens.begin() + static_cast<std::ptrdiff_t>(at),
                                                          [](std::string_view word, const Token& token) { return token.text == word; });
}

// "1/2" after a whole number: a stroke leaves no token, only a gap.
bool fraction_at(std::span<const Token> tokens, std::size_t at) {
  return at + 1 < tokens.size() && tokens[at].kind == Token::Kind::kNumber && tokens[at + 1].kind == Token::Kind::kNumber &&
         tokens[at + 1].glued && tokens[at + 1].begin == tokens[at].end + 1 && tokens[at].number < tokens[at + 1].number;
}

// What follows the feet of a measure that begins at `at`: 5 ft 6 in, 5'6, 5'-6 1/2" as draughtsmen write.
void add_inches(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at, Measure& measure) {
  const std::size_t end = at + measure.length;
  const bool by_sign = tokens[end - 1].text == "'";
  const bool hyphen = end < tokens.size() && tokens[end].text == "-" && tokens[end].glued;
  const std::size_t from = end + (hyphen ? 1 : 0);
  if (from >= tokens.size() || tokens[from].kind != Token::Kind::kNumber) return;
  const NumberRead inches = read_number(lexicon, tokens, from);
  const std::size_t after = from + inches.length;
  const std::string_view unit = after < tokens.size() ? std::string_view(tokens[after].text) : "";
  const bool said = unit == "\"" || unit == "in" || unit == "inches" || unit == "inch";
  if (!said && !(tokens[from].glued && by_sign)) return;
  measure.metres += inches.value * kInch;
  measure.length = after + (said ? 1 : 0) - at;
}

}  // namespace

NumberRead read_number(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at) {
  if (at >= tokens.size()) return {};
  if (words_at(tokens, at, {"half", "a"})) return {0.5, 2};
  if (words_at(tokens, at, {"half"}) && at + 1 < tokens.size() && lexicon.is(tokens[at + 1], WordClass::kUnit)) return {0.5, 1};
  NumberRead read;
  if (tokens[at].kind == Token::Kind::kNumber) {
    if (fraction_at(tokens, at)) return {tokens[at].number / tokens[at + 1].number, 2};
    read = {tokens[at].number, 1};
    if (fraction_at(tokens, at + 1) && !tokens[at + 1].glued) {
      read.value += tokens[at + 1].number / tokens[at + 2].number;
      read.length += 2;
    }
  } else {
    const Match match = lexicon.find(tokens, at, WordClass::kNumber);
    if (match.length == 0) return {};
    read = {meaning_of(match, WordClass::kNumber)->value, match.length};
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
  Match unit = lexicon.find(tokens, unit_at, WordClass::kUnit);
  double scale = 0;
  if (unit.length > 0) scale = meaning_of(unit, WordClass::kUnit)->value;
  if (unit.length == 0 && unit_word == "\"") scale = kInch, unit.length = 1;
  if (unit.length == 0 && (unit_word == "'" || unit_word == "'s")) scale = kFoot, unit.length = 1;
  if (unit.length == 0) return std::nullopt;
  // "in" is a preposition unless a number stands right before it and no noun phrase follows.
  if (unit_word == "in" && tokens[at].kind == Token::Kind::kNumber && !tokens[unit_at].glued) {
    constexpr double kFewest = 3;  // nobody measures furniture in such: "1.8 x 0.6 in SW corner"
    const bool more = unit_at + 1 < tokens.size() &&
                      (lexicon.is(tokens[unit_at + 1], WordClass::kDefinite) || lexicon.is(tokens[unit_at + 1], WordClass::kIndefinite) ||
                       lexicon.is(tokens[unit_at + 1], WordClass::kSide) ||
                       one_of(tokens[unit_at + 1].text, {"corner", "middle", "center", "front", "each"}));
    if (more || value < kFewest) return std::nullopt;
  }
  if (unit_word == "in" && tokens[at].kind != Token::Kind::kNumber) return std::nullopt;
  Measure measure{value * scale, unit_at + 1 - at};
  if (scale == kFoot) add_inches(lexicon, tokens, at, measure);
  // "1m20"
  constexpr double kCentimetres = 100;
  const std::size_t rest = at + measure.length;
  if (scale == 1 && rest < tokens.size() && tokens[rest].kind == Token::Kind::kNumber && tokens[rest].glued &&
      tokens[rest].end - tokens[rest].begin == 2 && tokens[rest].begin == tokens[unit_at].end) {
    measure.metres += tokens[rest].number / kCentimetres;
    measure.length += 1;
  }
  if (words_at(tokens, at + measure.length, {"and", "a", "half"})) {  // "a meter and a half"
    measure.metres += scale / 2;
    measure.length += 3;
  }
  return measure;
}

namespace {

void set_side(SaidSize& size, std::string_view which, double metres) {
  if (which == "w") size.width = metres;
  if (which == "l") size.length = metres;
  if (which == "d") size.depth = metres;
  if (which == "h") size.height = metres;
  if (which == "s") size.width = size.depth = metres;
}

// "width", not "wide".
bool names_side(const Token& token) {
  static constexpr std::string_view kNames[] = {"width", "length", "depth", "height", "diameter"};
  return std::find(std::begin(kNames), std::end(kNames), token.text) != std::end(kNames);
}

}  // namespace

std::size_t read_size(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at, SaidSize& size) {
  const auto measure = read_measure(lexicon, tokens, at);
  if (!measure) return 0;
  std::size_t i = at + measure->length;
  const auto dimension = i < tokens.size() ? lexicon.find(tokens, i, WordClass::kDimension) : Match{};
  if (dimension.length == 0) return 0;
  set_side(size, meaning_of(dimension, WordClass::kDimension)->word, measure->metres);
  return i + dimension.length - at;
}

std::size_t read_size_of(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at, SaidSize& size) {
  std::size_t i = at;
  const auto skip = [&](std::initializer_list<WordClass> classes) {
    for (const WordClass word_class : classes) i += i < tokens.size() ? lexicon.find(tokens, i, word_class).length : 0;
  };
  const auto dimension_at = [&](std::size_t place) {
    return place < tokens.size() ? lexicon.find(tokens, place, WordClass::kDimension) : Match{};
  };
  // "of at least 1.6 m width"
  if (words_at(tokens, at, {"of"})) {
    ++i;
    skip({WordClass::kAtLeast, WordClass::kAtMost, WordClass::kExactly});
    const std::size_t length = i > at + 1 || lexicon.find(tokens, i, WordClass::kNumber).length > 0 ||
                                       tokens[std::min(i, tokens.size() - 1)].kind == Token::Kind::kNumber
                                   ? read_size(lexicon, tokens, i, size)
                                   : 0;
    return length > 0 ? i + length - at : 0;
  }
  // "no wider than 1 m"
  static constexpr std::pair<std::string_view, std::string_view> kThan[] = {
      {"wider", "w"}, {"longer", "l"}, {"deeper", "d"}, {"higher", "h"}, {"taller", "h"}};
  if (words_at(tokens, at, {"no"}) || words_at(tokens, at, {"not"})) {
    for (const auto& [word, which] : kThan) {
      const auto most = words_at(tokens, at + 1, {word, "than"}) ? read_measure(lexicon, tokens, at + 3) : std::nullopt;
      if (!most) continue;
      set_side(size, which, most->metres);
      return 3 + most->length;
    }
    return 0;
  }
  // "with a diameter of 1.2 m", "its height of 90 cm", "width 6 m", "depth: 4 m"
  if (words_at(tokens, i, {"with"})) ++i;
  skip({WordClass::kIndefinite, WordClass::kDefinite, WordClass::kPossessive});
  const Match dimension = dimension_at(i);
  if (dimension.length == 0) return 0;
  const bool linked = words_at(tokens, i + dimension.length, {"of"}) || words_at(tokens, i + dimension.length, {":"}) ||
                      words_at(tokens, i + dimension.length, {"="});
  if (!linked && !names_side(tokens[i])) return 0;  // "width 6 m"
  i += dimension.length + (linked ? 1 : 0);
  skip({WordClass::kAtLeast, WordClass::kAtMost, WordClass::kExactly});
  const auto measure = i < tokens.size() ? read_measure(lexicon, tokens, i) : std::nullopt;
  if (!measure) return 0;
  set_side(size, meaning_of(dimension, WordClass::kDimension)->word, measure->metres);
  return i + measure->length - at;
}

bool noun_goes_on(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at) {
  if (at >= tokens.size() || tokens[at].kind != Token::Kind::kWord || lexicon.is(tokens[at], WordClass::kAnd) ||
      lexicon.is(tokens[at], WordClass::kBe) || lexicon.is(tokens[at], WordClass::kDefinite) ||
      lexicon.is(tokens[at], WordClass::kIndefinite) || is_by(tokens[at]))
    return false;
  const Match match = lexicon.find(tokens, at);
  if (has(match, WordClass::kObject) || has(match, WordClass::kDoor) || has(match, WordClass::kWindow) || attribute_of(match) != nullptr)
    return true;
  static constexpr std::string_view kOfDistance[] = {"of", "from", "away", "apart", "off", "to", "in", "on", "at", "between"};
  return match.length == 0 && lexicon.find_phrase(tokens, at).length == 0 &&
         std::find(std::begin(kOfDistance), std::end(kOfDistance), tokens[at].text) == std::end(kOfDistance);
}

std::size_t read_size_before(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at, SaidSize& size) {
  if (const std::size_t named = read_size(lexicon, tokens, at, size); named > 0) return named;
  if (words_at(tokens, at, {"diameter"})) {  // "a diameter 60 cm table"
    SaidSize across;
    const std::size_t length = read_size_of(lexicon, tokens, at, across);
    if (length > 0 && noun_goes_on(lexicon, tokens, at + length)) return size = across, length;
  }
  // "a 60x120 desk": centimetres, where no unit is said and metres are too many.
  constexpr double kFewest = 20, kCentimetre = 0.01;
  const SidesRead read = read_sides(lexicon, tokens, at);
  const bool plain = !read.united && !read.sides.empty();
  const bool bare = plain && std::min(read.numbers[0], read.numbers[1]) >= kFewest;
  // "a 9x12 rug": feet, where metres are too many for a thing; "a 2 x 3 rug" is in metres.
  constexpr double kMostMetres = 3.5;
  const std::size_t named_at = at + read.length;
  const bool of_thing = plain && named_at < tokens.size() && has(lexicon.find(tokens, named_at), WordClass::kObject);
  const bool feet = of_thing && !bare && std::max(read.numbers[0], read.numbers[1]) > kMostMetres;
  if ((read.united || bare || of_thing) && noun_goes_on(lexicon, tokens, named_at)) {
    const auto side = [&](std::size_t s) { return bare ? read.numbers[s] * kCentimetre : feet ? read.numbers[s] * kFoot : read.sides[s]; };
    size.width = side(0);
    size.depth = side(1);
    if (read.sides.size() > 2) size.height = side(2);
    size.either = true;
    return read.length;
  }
  const auto measure = read_measure(lexicon, tokens, at);
  if (!measure || !noun_goes_on(lexicon, tokens, at + measure->length)) return 0;
  // "two foot stools"
  const Match named = lexicon.find(tokens, at + measure->length - 1);
  if (named.length > 1 && has(named, WordClass::kObject)) return 0;
  size.span = measure->metres;
  return measure->length;
}

SidesRead read_sides(const Lexicon& lexicon, std::span<const Token> tokens, std::size_t at) {
  constexpr double kLongestInMetres = 20, kLongestInFeet = 90;  // what is longer and has no unit is in feet, or in centimetres
  SidesRead read;
  std::vector<bool> united;
  double unit = 0;
  std::size_t i = at;
  while (read.sides.size() < 3) {
    const auto [value, digits] = read_number(lexicon, tokens, i);
    if (digits == 0) break;
    const auto measure = read_measure(lexicon, tokens, i);
    read.sides.push_back(measure ? measure->metres : value);
    read.numbers.push_back(value);
    united.push_back(measure.has_value());
    if (measure) unit = value > 0 ? measure->metres / value : 1;
    i += measure ? measure->length : digits;
    // "4 m wide by 3 m deep"
    const Match dimension = i < tokens.size() ? lexicon.find(tokens, i, WordClass::kDimension) : Match{};
    if (measure && dimension.length > 0 && i + dimension.length < tokens.size() && is_by(tokens[i + dimension.length]))
      i += dimension.length;
    if (i >= tokens.size() || !is_by(tokens[i]) || read_number(lexicon, tokens, i + 1).length == 0) break;
    ++i;
  }
  if (read.sides.size() < 2) return {};
  read.united = unit > 0;
  const double longest = *std::max_element(read.sides.begin(), read.sides.end());
  if (unit == 0) unit = longest > kLongestInFeet ? 0.01 : longest > kLongestInMetres ? kFoot : 1.0;
  for (std::size_t s = 0; s < read.sides.size(); ++s) {
    if (!united[s]) read.sides[s] *= unit;
  }
  read.length = i - at;
  return read;
}

}  // namespace layoutbox::offline
