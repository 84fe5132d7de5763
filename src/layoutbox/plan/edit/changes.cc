#include "layoutbox/plan/edit/changes.h"

#include <algorithm>
#include <array>

namespace layoutbox::edit {
namespace {

using namespace offline;

bool is_at(const Tokens& tokens, std::size_t at, std::string_view word) { return at < tokens.size() && tokens[at].text == word; }

bool one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

void erase(Tokens& tokens, std::size_t first, std::size_t last) {
  tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(first),
               tokens.begin() + static_cast<std::ptrdiff_t>(std::min(last, tokens.size())));
}

// Is that a length, and how many tokens is it?
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

// "a bit", "slightly", "a little", "some more", "further": words of degree.
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

constexpr double kMoreFactor = 1.25, kLessFactor = 0.8;

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

// From `at`: a change of size and how many tokens say it; 0 for none.
std::size_t read_resize(const Lexicon& lexicon, const Tokens& tokens, std::size_t at, std::string_view verb, EditResize& resize) {
  std::size_t i = at;
  const bool by = is_at(tokens, i, "by"), to = is_at(tokens, i, "to");
  if (by || to) ++i;
  const auto of_verb = comparative(verb);
  if (const auto factor = factor_at(lexicon, tokens, i)) {
    std::size_t end = i + factor->length;
    if (is_at(tokens, end, "the") || is_at(tokens, end, "as") || is_at(tokens, end, "its") || is_at(tokens, end, "of")) ++end;
    if (is_at(tokens, end, "its") || is_at(tokens, end, "the")) ++end;
    const auto side = end < tokens.size() ? side_of(tokens[end].text) : std::nullopt;
    const auto word = end < tokens.size() ? comparative(tokens[end].text) : std::nullopt;
    if (word) {  // "20 % larger"
      scale(resize, word->side,
            factor->percent ? 1 + (word->more ? factor->value : -factor->value)
            : word->more    ? factor->value
                            : 1 / factor->value);
      return end + 1 - at;
    }
    if (side) {
      scale(resize, *side, factor->value);
      return end + 1 - at;
    }
    if ((by || to) && factor->percent && of_verb) {
      scale(resize, of_verb->side, by ? 1 + (of_verb->more ? factor->value : -factor->value) : factor->value);
      return i + factor->length - at;
    }
    return 0;
  }
  // "2 x 1 m", "120 by 60 cm".
  if (i + 2 < tokens.size() && tokens[i].kind == Token::Kind::kNumber) {
    std::vector<std::optional<Measure>> sides;
    std::vector<double> values;
    std::size_t end = i;
    double unit = 0;
    while (end < tokens.size() && tokens[end].kind == Token::Kind::kNumber && values.size() < 3) {
      const auto measure = read_measure(lexicon, tokens, end);
      values.push_back(tokens[end].number);
      if (measure && tokens[end].number > 0) unit = measure->metres / tokens[end].number;
      end += measure ? measure->length : 1;
      if (end + 1 < tokens.size() && one_of(tokens[end].text, {"x", "by", "*", "×"}) && tokens[end + 1].kind == Token::Kind::kNumber) {
        ++end;
      } else {
        break;
      }
    }
    if (values.size() >= 2 && unit > 0) {
      for (std::size_t s = 0; s < values.size(); ++s) resize.sides[s].exact = mm_from_m(values[s] * unit);
      return end - at;
    }
  }
  SaidSize said;
  if (const std::size_t taken = read_size(lexicon, tokens, i, said); taken > 0) {
    if (said.width) resize.sides[0].exact = mm_from_m(*said.width);
    if (said.depth) resize.sides[1].exact = mm_from_m(*said.depth);
    if (said.height) resize.sides[2].exact = mm_from_m(*said.height);
    if (said.length) resize.sides[0].exact = mm_from_m(*said.length), resize.longer_side = true;
    return i + taken - at;
  }
  if (const auto measure = length_at(lexicon, tokens, i)) {
    const std::size_t end = i + measure->length;
    const Mm length = mm_from_m(measure->metres);
    if (const auto word = end < tokens.size() ? comparative(tokens[end].text) : std::nullopt) {
      lengthen(resize, word->side, word->more ? length : -length);
      return end + 1 - at;
    }
    if (!of_verb) return 0;
    if (to) {
      const int side = of_verb->side == 4 ? 3 : of_verb->side;
      resize.sides[static_cast<std::size_t>(side % 3)].exact = length;
      resize.longer_side = side == 3;
      return end - at;
    }
    lengthen(resize, of_verb->side, of_verb->more ? length : -length);
    return end - at;
  }
  if (by || to) return 0;
  const std::size_t degree = degree_words(tokens, i);
  const std::size_t word_at = i + degree;
  const auto word = word_at < tokens.size() ? comparative(tokens[word_at].text) : std::nullopt;
  if (!word) return 0;
  scale(resize, word->side, word->more ? kMoreFactor : kLessFactor);
  return word_at + 1 - at;
}

}  // namespace

std::vector<PickedAt> take_picks(Tokens& tokens) {
  struct Word {
    std::string_view word;
    Pick pick;
  };
  static constexpr Word kWords[] = {
      {"larger", Pick::kLargest},     {"largest", Pick::kLargest},     {"bigger", Pick::kLargest},   {"biggest", Pick::kLargest},
      {"smaller", Pick::kSmallest},   {"smallest", Pick::kSmallest},   {"taller", Pick::kTallest},   {"tallest", Pick::kTallest},
      {"higher", Pick::kTallest},     {"highest", Pick::kTallest},     {"shorter", Pick::kShortest}, {"shortest", Pick::kShortest},
      {"lower", Pick::kShortest},     {"lowest", Pick::kShortest},     {"wider", Pick::kWidest},     {"widest", Pick::kWidest},
      {"narrower", Pick::kNarrowest}, {"narrowest", Pick::kNarrowest}, {"longer", Pick::kLongest},   {"longest", Pick::kLongest},
      {"leftmost", Pick::kLeft},      {"rightmost", Pick::kRight},     {"middle", Pick::kMiddle},
  };
  // Taller and the like stand before a noun only after a determiner: "make the table larger" says another thing.
  static constexpr std::string_view kBefore[] = {"the", "this", "that", "two", "my", "our", "three"};
  std::vector<PickedAt> picks;
  for (std::size_t i = 1; i + 1 < tokens.size(); ++i) {
    if (std::find(std::begin(kBefore), std::end(kBefore), tokens[i - 1].text) == std::end(kBefore)) continue;
    const auto found = std::find_if(std::begin(kWords), std::end(kWords), [&](const Word& w) { return w.word == tokens[i].text; });
    if (found == std::end(kWords) || tokens[i + 1].kind != Token::Kind::kWord || one_of(tokens[i + 1].text, {"of", "and"})) continue;
    erase(tokens, i, i + 1);
    picks.push_back({i, found->pick});
  }
  return picks;
}

std::optional<double> take_turn(Tokens& tokens) {
  std::optional<double> degrees;
  double direction = 1;  // counter-clockwise
  for (std::size_t i = 0; i < tokens.size();) {
    const bool by = is_at(tokens, i, "by") || is_at(tokens, i, "through");
    const std::size_t n = i + (by ? 1 : 0);
    if (n + 1 < tokens.size() && tokens[n].kind == Token::Kind::kNumber && one_of(tokens[n + 1].text, {"degree", "degrees", "°", "deg"})) {
      degrees = tokens[n].number;
      erase(tokens, i, n + 2);
    } else if (is_at(tokens, n, "a") && is_at(tokens, n + 1, "quarter")) {
      degrees = 90;
      erase(tokens, i, n + 2 + (is_at(tokens, n + 2, "turn") ? 1 : 0));
    } else if ((is_at(tokens, n, "a") && is_at(tokens, n + 1, "half") && is_at(tokens, n + 2, "turn")) ||
               (is_at(tokens, n, "half") && is_at(tokens, n + 1, "a") && is_at(tokens, n + 2, "turn"))) {
      degrees = 180;
      erase(tokens, i, n + 3);
    } else if (is_at(tokens, i, "clockwise")) {
      direction = -1;
      if (!degrees) degrees = 90;
      erase(tokens, i, i + 1);
    } else if (one_of(tokens[i].text, {"counterclockwise", "anticlockwise"})) {
      if (!degrees) degrees = 90;
      erase(tokens, i, i + 1);
    } else if (one_of(tokens[i].text, {"counter", "anti"}) && is_at(tokens, i + 1, "clockwise")) {
      if (!degrees) degrees = 90;
      erase(tokens, i, i + 2);
    } else if (is_at(tokens, i, "around") && (i + 1 == tokens.size() || tokens[i + 1].kind == Token::Kind::kPunctuation)) {
      if (!degrees) degrees = 180;
      erase(tokens, i, i + 1);
    } else if (is_at(tokens, i, "sideways")) {
      if (!degrees) degrees = 90;
      erase(tokens, i, i + 1);
    } else if (is_at(tokens, i, "to") && is_at(tokens, i + 1, "the") &&
               one_of(i + 2 < tokens.size() ? tokens[i + 2].text : "", {"left", "right"}) &&
               (i + 3 == tokens.size() || tokens[i + 3].kind == Token::Kind::kPunctuation)) {
      direction = tokens[i + 2].text == "left" ? 1 : -1;
      if (!degrees) degrees = 90;
      erase(tokens, i, i + 3);
    } else {
      ++i;
    }
  }
  if (degrees) *degrees *= direction;
  return degrees;
}

std::optional<ShiftAt> take_shift(const Lexicon& lexicon, Tokens& tokens, std::string_view verb) {
  using Way = EditShift::Way;
  for (std::size_t start = 0; start < tokens.size(); ++start) {
    ShiftAt found;
    std::size_t i = start;
    i += degree_words(tokens, i);
    if (const auto measure = length_at(lexicon, tokens, i)) {
      found.shift.distance = mm_from_m(measure->metres);
      i += measure->length;
    }
    i += degree_words(tokens, i);
    const std::size_t way_at = i;
    if (is_at(tokens, i, "to") && is_at(tokens, i + 1, "the")) i += 2;
    if (is_at(tokens, i, "to") && is_at(tokens, i + 1, "its")) i += 2;
    const std::string word = i < tokens.size() ? tokens[i].text : "";
    bool known = true, refers = false;
    if (one_of(word, {"left", "leftwards", "leftward"}))
      found.shift.way = Way::kLeft;
    else if (one_of(word, {"right", "rightwards", "rightward"}))
      found.shift.way = Way::kRight;
    else if (one_of(word, {"forward", "forwards", "front"}))
      found.shift.way = Way::kFront;
    else if (one_of(word, {"back", "backward", "backwards"}))
      found.shift.way = Way::kBack;
    else if (one_of(word, {"up", "upward", "upwards", "higher"}))
      found.shift.way = Way::kUp;
    else if (one_of(word, {"down", "downward", "downwards", "lower"}))
      found.shift.way = Way::kDown;
    else if (one_of(word, {"closer", "nearer"}))
      found.shift.way = Way::kTowards, refers = true;
    else if (one_of(word, {"towards", "toward"}))
      found.shift.way = Way::kTowards, refers = true;
    else if (word == "away" && found.shift.distance)
      return std::nullopt;  // "1 m away from the wall" is a place
    else if (word == "away")
      found.shift.way = Way::kAway, refers = true;
    else if (word == "from" && way_at > start && one_of(tokens[way_at - 1].text, {"further", "farther"}))
      found.shift.way = Way::kAway, refers = true, --i;
    else
      known = false;
    if (!known) {
      if (found.shift.distance && (verb == "raise" || verb == "lower") && way_at >= tokens.size()) {  // "raise it by 20 cm"
        found.shift.way = verb == "raise" ? Way::kUp : Way::kDown;
        erase(tokens, start, tokens.size());
        found.at = tokens.size();
        return found;
      }
      continue;
    }
    ++i;
    if (refers) {
      if (is_at(tokens, i, "to") || is_at(tokens, i, "from"))
        ++i;
      else if (!one_of(word, {"towards", "toward"}))
        continue;
      if (i >= tokens.size()) continue;
      if (i + 2 < tokens.size() && is_at(tokens, i, "the") && one_of(tokens[i + 1].text, {"left", "right", "back", "front"}) &&
          i + 2 == tokens.size())
        continue;
    } else {
      // "to the left of the bed", "to the left wall", "the left chair", "in the back": places, not ways.
      const bool ends = i >= tokens.size() || tokens[i].kind == Token::Kind::kPunctuation ||
                        one_of(tokens[i].text, {"by", "a", "and", "half"}) || tokens[i].kind == Token::Kind::kNumber;
      const bool article = way_at > 0 && i >= 2 && one_of(tokens[i - 2].text, {"the", "on", "in", "at"}) && !is_at(tokens, way_at, "to");
      if (!ends || article) continue;
      if (is_at(tokens, i, "by") || (!found.shift.distance && i < tokens.size() && length_at(lexicon, tokens, i))) {
        const std::size_t by = is_at(tokens, i, "by") ? 1 : 0;
        if (const auto measure = length_at(lexicon, tokens, i + by)) {
          found.shift.distance = mm_from_m(measure->metres);
          i += by + measure->length;
        } else {
          i += degree_words(tokens, i);
        }
      } else if (is_at(tokens, i, "a")) {
        i += degree_words(tokens, i);
      }
    }
    std::size_t end = i;
    if (refers) {  // "closer to the window by 20 cm"
      for (std::size_t k = i; k + 1 < tokens.size(); ++k) {
        if (!is_at(tokens, k, "by")) continue;
        if (const auto measure = length_at(lexicon, tokens, k + 1)) {
          found.shift.distance = mm_from_m(measure->metres);
          erase(tokens, k, k + 1 + measure->length);
          break;
        }
      }
    }
    erase(tokens, start, end);
    found.at = start;
    return found;
  }
  return std::nullopt;
}

std::optional<EditResize> take_resize(const Lexicon& lexicon, Tokens& tokens, std::string_view verb) {
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
