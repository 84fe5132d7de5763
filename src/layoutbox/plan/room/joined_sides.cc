#include "layoutbox/plan/room/joined_sides.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string_view>

namespace layoutbox::offline {
namespace {

bool says(std::span<const Token> tokens, std::size_t at, std::initializer_list<std::string_view> words) {
  return at < tokens.size() && std::ranges::find(words, tokens[at].text) != words.end();
}

bool joins_two(std::span<const Token> tokens, std::size_t at) { return says(tokens, at, {"times", "on", "to"}); }

// "a gap of 3 to 4 m", "3 m to 4 m from the wall": no sides.
bool is_range(std::span<const Token> tokens, const SizeOwner& owner, std::size_t first, std::size_t last) {
  const bool after_room = owner.follows_room(first) || (first > 0 && tokens[first - 1].text == ",");
  return !after_room || says(tokens, last, {"from", "off", "apart", "of", "away"});
}

}  // namespace

SidesRead read_two_joined(const Lexicon& lexicon, std::span<const Token> tokens, const SizeOwner& owner, std::size_t at) {
  auto one = read_measure(lexicon, tokens, at);
  const bool shares = !one && tokens[at].kind == Token::Kind::kNumber && joins_two(tokens, at + 1);
  const auto shared = shares && at + 2 < tokens.size() ? read_measure(lexicon, tokens, at + 2) : std::nullopt;
  if (shared && tokens[at + 2].number > 0) one = Measure{tokens[at].number * shared->metres / tokens[at + 2].number, 1};
  const std::size_t joiner = one ? at + one->length : tokens.size();
  if (!joins_two(tokens, joiner) && !says(tokens, joiner, {"and"})) return {};
  const auto two = joiner + 1 < tokens.size() ? read_measure(lexicon, tokens, joiner + 1) : std::nullopt;
  const std::size_t last = two ? joiner + 1 + two->length : 0;
  if (!two || (last < tokens.size() && lexicon.find(tokens, last, WordClass::kDimension).length > 0)) return {};
  if (says(tokens, joiner, {"to"}) && is_range(tokens, owner, at, last)) return {};
  SidesRead read;
  read.sides = read.numbers = {one->metres, two->metres};
  read.length = last - at;
  read.united = true;
  return read;
}

AreaRead read_mats(const Lexicon& lexicon, std::span<const Token> tokens, const SizeOwner& owner, std::size_t at) {
  const NumberRead number = read_number(lexicon, tokens, at);
  const std::size_t unit = at + number.length;
  if (number.length == 0 || !says(tokens, unit, {"tatami"})) return {};
  const Match match = lexicon.find(tokens, unit, WordClass::kAreaUnit);
  if (match.length == 0 || (at > 0 && says(tokens, at - 1, {"with", "and", "has", "on"}))) return {};
  std::size_t last = unit + match.length;
  if (says(tokens, last, {"mat", "mats"})) ++last;
  const double area = number.value * std::ranges::find(match.meanings, WordClass::kAreaUnit, &Meaning::word_class)->value;
  const double side = std::sqrt(area);
  if (!owner.stands_alone(at, last) && !owner.speaks_of_room(at, last, {side, side})) return {};
  return {area, last - at};
}

}  // namespace layoutbox::offline
