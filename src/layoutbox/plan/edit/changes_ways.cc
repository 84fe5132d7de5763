// Which of several, how far to turn, and which way to go, in the words of a command.
#include <algorithm>

#include "layoutbox/plan/edit/changes.h"
#include "layoutbox/plan/edit/changes_parts.h"

namespace layoutbox::edit {

using namespace offline;

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

namespace {

constexpr double kLittleTurn = 15;

// "a bit", "slightly to the left" from `i`: its tokens, 0 for none.
std::size_t little_turn_at(const Tokens& tokens, std::size_t i) {
  const std::size_t degree = degree_words(tokens, i), end = i + degree;
  if (degree == 0 || !says_little(tokens, i, end)) return 0;
  const bool way =
      end < tokens.size() && (one_of(tokens[end].text, {"clockwise", "counterclockwise", "anticlockwise", "counter", "anti"}) ||
                              (is_at(tokens, end, "to") && is_at(tokens, end + 1, "the")));
  return way || end == tokens.size() || tokens[end].kind == Token::Kind::kPunctuation ? degree : 0;
}

// What says a turn from `i`: its tokens, 0 for none. `degrees` and `direction` (counter-clockwise 1) are set as it says.
std::size_t turn_at(const Tokens& tokens, std::size_t i, std::optional<double>& degrees, double& direction) {
  const auto at = [&](std::size_t k, std::string_view word) { return is_at(tokens, k, word); };
  const std::size_t n = i + (at(i, "by") || at(i, "through") ? 1 : 0);
  const auto say = [&](double angle, std::size_t length) {
    degrees = angle;
    return length;
  };
  const auto unless_said = [&](double angle, std::size_t length) { return degrees ? length : say(angle, length); };
  const bool ends = i + 1 == tokens.size() || tokens[i + 1].kind == Token::Kind::kPunctuation;
  if (n + 1 < tokens.size() && tokens[n].kind == Token::Kind::kNumber && one_of(tokens[n + 1].text, {"degree", "degrees", "°", "deg"}))
    return say(tokens[n].number, n + 2 - i);
  if (at(n, "a") && at(n + 1, "quarter")) return say(90, n + 2 + (at(n + 2, "turn") ? 1 : 0) - i);
  const bool half = (at(n, "a") && at(n + 1, "half")) || (at(n, "half") && at(n + 1, "a"));
  if (half && at(n + 2, "turn")) return say(180, n + 3 - i);
  if (at(i, "clockwise")) {
    direction = -1;
    return unless_said(90, 1);
  }
  if (one_of(tokens[i].text, {"counterclockwise", "anticlockwise"})) return unless_said(90, 1);
  if (one_of(tokens[i].text, {"counter", "anti"}) && at(i + 1, "clockwise")) return unless_said(90, 2);
  const bool other = at(i, "the") && i + 2 < tokens.size() && one_of(tokens[i + 1].text, {"other", "opposite"}) &&
                     one_of(tokens[i + 2].text, {"way", "direction"});
  if (other) return unless_said(180, at(i + 3, "around") || at(i + 3, "round") ? 4 : 3);
  if (at(i, "around") && ends) return unless_said(180, 1);
  if (at(i, "sideways")) return unless_said(90, 1);
  const bool side = at(i, "to") && at(i + 1, "the") && (at(i + 2, "left") || at(i + 2, "right"));
  if (!side || (i + 3 < tokens.size() && tokens[i + 3].kind != Token::Kind::kPunctuation)) return 0;
  direction = tokens[i + 2].text == "left" ? 1 : -1;
  return unless_said(90, 3);
}

}  // namespace

std::optional<double> take_turn(Tokens& tokens, bool of_verb) {
  std::optional<double> degrees;
  double direction = 1;
  for (std::size_t i = 0; i < tokens.size();) {
    if (const std::size_t little = of_verb ? little_turn_at(tokens, i) : 0; little > 0) {
      degrees = degrees.value_or(kLittleTurn);
      erase(tokens, i, i + little);
    } else if (const std::size_t length = turn_at(tokens, i, degrees, direction); length > 0) {
      erase(tokens, i, i + length);
      // "face the other way", "looks in the opposite direction"
      while (i > 0 && one_of(tokens[i - 1].text, {"face", "faces", "facing", "look", "looks", "looking", "point", "pointing", "in"}))
        erase(tokens, i - 1, i), --i;
    } else {
      ++i;
    }
  }
  if (degrees) *degrees *= direction;
  return degrees;
}

namespace {

using Way = EditShift::Way;

struct WayWord {
  std::string_view word;
  Way way;
  bool refers = false;  // to something: "closer to the window"
};

constexpr WayWord kWays[] = {{"left", Way::kLeft},
                             {"leftwards", Way::kLeft},
                             {"leftward", Way::kLeft},
                             {"right", Way::kRight},
                             {"rightwards", Way::kRight},
                             {"rightward", Way::kRight},
                             {"forward", Way::kFront},
                             {"forwards", Way::kFront},
                             {"front", Way::kFront},
                             {"back", Way::kBack},
                             {"backward", Way::kBack},
                             {"backwards", Way::kBack},
                             {"up", Way::kUp},
                             {"upward", Way::kUp},
                             {"upwards", Way::kUp},
                             {"higher", Way::kUp},
                             {"down", Way::kDown},
                             {"downward", Way::kDown},
                             {"downwards", Way::kDown},
                             {"lower", Way::kDown},
                             {"closer", Way::kTowards, true},
                             {"nearer", Way::kTowards, true},
                             {"towards", Way::kTowards, true},
                             {"toward", Way::kTowards, true},
                             {"away", Way::kAway, true}};

// "to the left of the bed", "to the left wall", "the left chair", "in the back": places, not ways. `i`: after the word.
bool is_way(const Tokens& tokens, std::size_t way_at, std::size_t i) {
  const bool ends = i >= tokens.size() || tokens[i].kind == Token::Kind::kPunctuation ||
                    one_of(tokens[i].text, {"by", "a", "and", "half"}) || tokens[i].kind == Token::Kind::kNumber;
  const bool article = way_at > 0 && i >= 2 && one_of(tokens[i - 2].text, {"the", "on", "in", "at"}) && !is_at(tokens, way_at, "to");
  return ends && !article;
}

// "… by half a meter", "… a bit": the token after it.
std::size_t read_how_far(const Lexicon& lexicon, const Tokens& tokens, std::size_t i, EditShift& shift) {
  const std::size_t by = is_at(tokens, i, "by") ? 1 : 0;
  if (by > 0 || (!shift.distance && i < tokens.size() && length_at(lexicon, tokens, i))) {
    if (const auto measure = length_at(lexicon, tokens, i + by)) {
      shift.distance = mm_from_m(measure->metres);
      return i + by + measure->length;
    }
    return i + degree_words(tokens, i);
  }
  return is_at(tokens, i, "a") ? i + degree_words(tokens, i) : i;
}

// "closer to the window by 20 cm", "away from the wall a little": taken out behind what it refers to.
void take_how_far_at_end(const Lexicon& lexicon, Tokens& tokens, std::size_t from, EditShift& shift) {
  for (std::size_t k = from; k < tokens.size(); ++k) {
    const std::size_t degree = degree_words(tokens, k);
    if (k > from && degree > 0 && k + degree == tokens.size()) {
      erase(tokens, k, tokens.size());
      return;
    }
    if (!is_at(tokens, k, "by")) continue;
    if (const auto measure = length_at(lexicon, tokens, k + 1)) {
      shift.distance = mm_from_m(measure->metres);
      erase(tokens, k, k + 1 + measure->length);
      return;
    }
  }
}

// The noun's first token behind "closer to", "away from", "towards"; 0 where none follows.
std::size_t noun_after(const Tokens& tokens, std::size_t i, std::string_view word) {
  if (is_at(tokens, i, "to") || is_at(tokens, i, "from"))
    ++i;
  else if (!one_of(word, {"towards", "toward"}))
    return 0;
  if (i >= tokens.size()) return 0;
  const bool side = i + 2 == tokens.size() && is_at(tokens, i, "the") && one_of(tokens[i + 1].text, {"left", "right", "back", "front"});
  return side ? 0 : i;
}

}  // namespace

std::optional<ShiftAt> take_shift(const Lexicon& lexicon, Tokens& tokens, std::string_view verb) {
  for (std::size_t start = 0; start < tokens.size(); ++start) {
    ShiftAt found;
    found.at = start;
    std::size_t i = start + degree_words(tokens, start);
    if (const auto measure = length_at(lexicon, tokens, i)) {
      found.shift.distance = mm_from_m(measure->metres);
      i += measure->length;
    }
    i += degree_words(tokens, i);
    const std::size_t way_at = i;
    if (is_at(tokens, i, "to") && (is_at(tokens, i + 1, "the") || is_at(tokens, i + 1, "its"))) i += 2;
    const std::string word = i < tokens.size() ? tokens[i].text : "";
    const WayWord* way = std::find_if(std::begin(kWays), std::end(kWays), [&](const WayWord& w) { return w.word == word; });
    if (word == "away" && found.shift.distance) return std::nullopt;  // "1 m away from the wall" is a place
    static constexpr WayWord kFurther{"from", Way::kAway, true};
    if (word == "from" && way_at > start && one_of(tokens[way_at - 1].text, {"further", "farther"})) way = &kFurther, --i;
    if (way == std::end(kWays)) {
      if (!found.shift.distance || (verb != "raise" && verb != "lower") || way_at < tokens.size()) continue;
      found.shift.way = verb == "raise" ? Way::kUp : Way::kDown;  // "raise it by 20 cm"
      erase(tokens, start, tokens.size());
      found.at = tokens.size();
      return found;
    }
    found.shift.way = way->way;
    ++i;
    if (way->refers) {
      i = noun_after(tokens, i, word);
      if (i == 0) continue;
      take_how_far_at_end(lexicon, tokens, i, found.shift);
    } else if (is_way(tokens, way_at, i)) {
      i = read_how_far(lexicon, tokens, i, found.shift);
    } else {
      continue;
    }
    erase(tokens, start, i);
    return found;
  }
  return std::nullopt;
}

}  // namespace layoutbox::edit
