// How much larger or smaller, in the words of a command.
#include <algorithm>

#include "layoutbox/plan/edit/changes.h"
#include "layoutbox/plan/edit/changes_parts.h"

namespace layoutbox::edit {

using namespace offline;

namespace {

// Word → which side it speaks of (0 width, 1 depth, 2 height, 3 the longer one, 4 all), and whether it is more or less.
struct Comparative {
  int side = 4;
  bool more = true;
};
std::optional<Comparative> comparative(std::string_view word) {
  if (one_of(word, {"wider", "widen"})) return Comparative{0, true};
  if (one_of(word, {"narrower", "slimmer", "thinner", "narrow"})) return Comparative{0, false};
  if (one_of(word, {"deeper", "deepen"})) return Comparative{1, true};
  if (one_of(word, {"shallower"})) return Comparative{1, false};
  if (one_of(word, {"taller", "higher", "raise"})) return Comparative{2, true};
  if (one_of(word, {"lower"})) return Comparative{2, false};
  if (one_of(word, {"longer", "lengthen", "extend", "stretch"})) return Comparative{3, true};
  if (one_of(word, {"shorter", "shorten"})) return Comparative{3, false};
  if (one_of(word, {"larger", "bigger", "enlarge"})) return Comparative{4, true};
  if (one_of(word, {"smaller", "shrink", "tinier"})) return Comparative{4, false};
  return std::nullopt;
}

// "wide" of "twice as wide".
std::optional<int> side_of(std::string_view word) {
  if (one_of(word, {"wide", "width"})) return 0;
  if (one_of(word, {"deep", "depth"})) return 1;
  if (one_of(word, {"tall", "high", "height"})) return 2;
  if (one_of(word, {"long", "length"})) return 3;
  if (one_of(word, {"large", "big", "size"})) return 4;
  return std::nullopt;
}

constexpr double kMoreFactor = 1.25, kLessFactor = 0.8, kLittleMore = 1.1, kLittleLess = 0.9;

bool concerns(int side, std::size_t i) { return side == 4 || static_cast<std::size_t>(side % 3) == i; }

void scale(EditResize& resize, int side, double factor) {
  resize.longer_side = side == 3;
  for (std::size_t i = 0; i < 3; ++i) {
    if (concerns(side, i)) resize.sides[i].factor = factor;
  }
}

// "20 cm larger" is wider and deeper, not higher.
void lengthen(EditResize& resize, int side, Mm more) {
  resize.longer_side = side == 3;
  for (std::size_t i = 0; i < 3; ++i) {
    if (concerns(side, i) && (side != 4 || i < 2)) resize.sides[i].more = more;
  }
}

// A factor in words: "twice", "two times", "half", "50 %"; its tokens.
struct Factor {
  double value = 1;
  std::size_t length = 0;
  bool percent = false;
};
std::optional<Factor> factor_at(const Lexicon& lexicon, const Tokens& tokens, std::size_t at) {
  if (is_at(tokens, at, "twice")) return Factor{2, 1, false};
  if (is_at(tokens, at, "double")) return Factor{2, 1, false};
  if (is_at(tokens, at, "half") && !is_at(tokens, at + 1, "a")) return Factor{0.5, 1, false};  // "half a meter" is a length
  double number = 0;
  std::size_t length = 0;
  if (at < tokens.size() && tokens[at].kind == Token::Kind::kNumber) {
    number = tokens[at].number, length = 1;
  } else if (at < tokens.size()) {
    const Match match = lexicon.find(tokens, at, WordClass::kNumber);
    for (const Meaning& meaning : match.meanings) {
      if (meaning.word_class == WordClass::kNumber) number = meaning.value, length = match.length;
    }
  }
  if (length == 0 || number <= 0) return std::nullopt;
  if (is_at(tokens, at + length, "times")) return Factor{number, length + 1, false};
  if (is_at(tokens, at + length, "%") || is_at(tokens, at + length, "percent")) return Factor{number / 100, length + 1, true};
  return std::nullopt;
}

// What "20 % larger", "twice as long", "by 20 %" says from `i`; 0 for nothing. `of_verb`: what the verb says ("enlarge").
std::size_t read_factor(const Tokens& tokens, std::size_t i, const Factor& factor, const std::optional<Comparative>& of_verb, bool by,
                        bool to, EditResize& resize) {
  std::size_t end = i + factor.length;
  if (end < tokens.size() && one_of(tokens[end].text, {"the", "as", "its", "of"})) ++end;
  if (end < tokens.size() && one_of(tokens[end].text, {"its", "the"})) ++end;
  const auto word = end < tokens.size() ? comparative(tokens[end].text) : std::nullopt;
  const auto share = [&](bool more) { return 1 + (more ? factor.value : -factor.value); };
  if (word) {  // "20 % larger"
    scale(resize, word->side, factor.percent ? share(word->more) : word->more ? factor.value : 1 / factor.value);
    return end + 1;
  }
  if (const auto side = end < tokens.size() ? side_of(tokens[end].text) : std::nullopt) {
    scale(resize, *side, factor.value);
    return end + 1;
  }
  if (!(by || to) || !factor.percent || !of_verb) return 0;
  scale(resize, of_verb->side, by ? share(of_verb->more) : factor.value);
  return i + factor.length;
}

// "2 x 1 m", "120 by 60 cm": the token after it, or 0.
std::size_t read_all_sides(const Lexicon& lexicon, const Tokens& tokens, std::size_t i, EditResize& resize) {
  std::vector<double> values;
  std::size_t end = i;
  double unit = 0;
  while (end < tokens.size() && tokens[end].kind == Token::Kind::kNumber && values.size() < 3) {
    const auto measure = read_measure(lexicon, tokens, end);
    values.push_back(tokens[end].number);
    if (measure && tokens[end].number > 0) unit = measure->metres / tokens[end].number;
    end += measure ? measure->length : 1;
    if (end + 1 >= tokens.size() || !one_of(tokens[end].text, {"x", "by", "*", "×"}) || tokens[end + 1].kind != Token::Kind::kNumber) break;
    ++end;
  }
  if (values.size() < 2 || unit <= 0) return 0;
  for (std::size_t s = 0; s < values.size(); ++s) resize.sides[s].exact = mm_from_m(values[s] * unit);
  return end;
}

// "20 cm wider", "by 20 cm", "to 1 m" of a verb: the token after it, or 0.
std::size_t read_length(const Tokens& tokens, std::size_t i, const Measure& measure, const std::optional<Comparative>& of_verb, bool to,
                        EditResize& resize) {
  const std::size_t end = i + measure.length;
  const Mm length = mm_from_m(measure.metres);
  if (const auto word = end < tokens.size() ? comparative(tokens[end].text) : std::nullopt) {
    lengthen(resize, word->side, word->more ? length : -length);
    return end + 1;
  }
  if (!of_verb) return 0;
  if (to) {
    const int side = of_verb->side == 4 ? 3 : of_verb->side;
    resize.sides[static_cast<std::size_t>(side % 3)].exact = length;
    resize.longer_side = side == 3;
    return end;
  }
  lengthen(resize, of_verb->side, of_verb->more ? length : -length);
  return end;
}

// From `at`: a change of size and how many tokens say it; 0 for none.
std::size_t read_resize(const Lexicon& lexicon, const Tokens& tokens, std::size_t at, std::string_view verb, EditResize& resize) {
  std::size_t i = at;
  const bool by = is_at(tokens, i, "by"), to = is_at(tokens, i, "to");
  if (by || to) ++i;
  const auto of_verb = comparative(verb);
  const auto taken = [at](std::size_t end) { return end == 0 ? 0 : end - at; };
  if (const auto factor = factor_at(lexicon, tokens, i)) return taken(read_factor(tokens, i, *factor, of_verb, by, to, resize));
  if (const std::size_t end = read_all_sides(lexicon, tokens, i, resize); end > 0) return taken(end);
  SaidSize said;
  if (const std::size_t length = read_size(lexicon, tokens, i, said); length > 0) {
    if (said.width) resize.sides[0].exact = mm_from_m(*said.width);
    if (said.depth) resize.sides[1].exact = mm_from_m(*said.depth);
    if (said.height) resize.sides[2].exact = mm_from_m(*said.height);
    if (said.length) resize.sides[0].exact = mm_from_m(*said.length), resize.longer_side = true;
    return i + length - at;
  }
  if (const auto measure = length_at(lexicon, tokens, i)) return taken(read_length(tokens, i, *measure, of_verb, to, resize));
  if (by || to) return 0;
  const std::size_t word_at = i + degree_words(tokens, i);
  const auto word = word_at < tokens.size() ? comparative(tokens[word_at].text) : std::nullopt;
  if (!word) return 0;
  const bool little = says_little(tokens, i, word_at);
  scale(resize, word->side, word->more ? (little ? kLittleMore : kMoreFactor) : little ? kLittleLess : kLessFactor);
  return word_at + 1 - at;
}

}  // namespace

std::optional<EditResize> take_resize(const Lexicon& lexicon, Tokens& tokens, std::string_view verb, bool exact_only) {
  EditResize resize;
  bool any = false;
  for (std::size_t i = 0; i < tokens.size();) {
    EditResize next = resize;
    // "a larger rug" is a thing; "the table larger", "it larger" a change.
    const bool before_noun = i > 0 && one_of(tokens[i - 1].text, {"a", "an", "the", "another"}) && !factor_at(lexicon, tokens, i);
    const std::size_t taken = before_noun ? 0 : read_resize(lexicon, tokens, i, verb, next);
    if (taken == 0) {
      ++i;
      continue;
    }
    resize = next;
    any = true;
    // A stop stays in its place: "the desk 20 cm wider and the bed green" are two things.
    tokens[i] = Token{Token::Kind::kPunctuation, ";", tokens[i].begin, tokens[i].end, 0, false, false, true};
    erase(tokens, i + 1, i + taken);
    ++i;
    if (is_at(tokens, i, "and") && i + 1 < tokens.size()) {  // "1.6 m wide and 2 m long"
      EditResize more = resize;
      if (read_resize(lexicon, tokens, i + 1, verb, more) > 0) erase(tokens, i, i + 1);
    }
  }
  if (any) return resize;
  if (exact_only) return std::nullopt;
  if (verb == "double" || verb == "halve") {
    for (std::size_t i = 0; i < tokens.size(); ++i) {  // "double the size of the table"
      const auto side = side_of(tokens[i].text);
      if (!side || !is_at(tokens, i + 1, "of")) continue;
      scale(resize, *side, verb == "double" ? 2 : 0.5);
      erase(tokens, i > 0 && one_of(tokens[i - 1].text, {"the", "its"}) ? i - 1 : i, i + 2);
      return resize;
    }
    scale(resize, 4, verb == "double" ? 2 : 0.5);
    return resize;
  }
  if (const auto word = comparative(verb)) {
    scale(resize, word->side, word->more ? kMoreFactor : kLessFactor);
    return resize;
  }
  return std::nullopt;
}

}  // namespace layoutbox::edit
