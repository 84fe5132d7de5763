#include "layoutbox/plan/offline/tokens.h"

#include <array>
#include <charconv>
#include <utility>

namespace layoutbox::offline {
namespace {

// Signs outside ASCII and what they mean here.
constexpr std::array<std::pair<std::string_view, char>, 22> kSigns = {{
    {"\u2018", '\''}, {"\u2019", '\''}, {"\u02BC", '\''}, {"\u201C", '"'}, {"\u201D", '"'}, {"\u2032", '\''},
    {"\u2033", '"'},  {"\u2013", '-'},  {"\u2014", ','},  {"\u2010", '-'}, {"\u2011", '-'}, {"\u2212", '-'},
    {"\u00D7", 'x'},  {"\u2715", 'x'},  {"\u2A2F", 'x'},  {"\u2026", '.'}, {"\u00A0", ' '}, {"\u202F", ' '},
    {"\u2009", ' '},  {"\u2022", ';'},  {"\u00BD", 'h'},  {"\u00B2", '2'},
}};

// Letters with accents, folded to plain ones.
constexpr std::array<std::pair<std::string_view, char>, 16> kAccents = {{
    {"\u00E9", 'e'},
    {"\u00E8", 'e'},
    {"\u00EA", 'e'},
    {"\u00EB", 'e'},
    {"\u00E0", 'a'},
    {"\u00E2", 'a'},
    {"\u00E4", 'a'},
    {"\u00E1", 'a'},
    {"\u00F6", 'o'},
    {"\u00F4", 'o'},
    {"\u00F3", 'o'},
    {"\u00FC", 'u'},
    {"\u00FB", 'u'},
    {"\u00EE", 'i'},
    {"\u00EF", 'i'},
    {"\u00E7", 'c'},
}};

struct Letter {
  char value = 0;
  std::size_t size = 1;
};

Letter letter_at(std::string_view text, std::size_t at) {
  const char c = text[at];
  if (static_cast<unsigned char>(c) < 0x80) {
    if (c == '`') return {'\'', 1};
    return {c, 1};
  }
  for (const auto& [sign, value] : kSigns) {
    if (text.substr(at).starts_with(sign)) return {value, sign.size()};
  }
  for (const auto& [sign, value] : kAccents) {
    if (text.substr(at).starts_with(sign)) return {value, sign.size()};
  }
  std::size_t size = 1;
  while (at + size < text.size() && (static_cast<unsigned char>(text[at + size]) & 0xC0) == 0x80) ++size;
  return {'~', size};  // another script or a picture sign: a word of its own
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '~'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// British spellings whose American twin is what the word lists have.
constexpr std::array<std::pair<std::string_view, std::string_view>, 36> kSpellings = {{
    {"colour", "color"},
    {"coloured", "colored"},
    {"colourful", "colorful"},
    {"grey", "gray"},
    {"centre", "center"},
    {"centred", "centered"},
    {"centres", "centers"},
    {"storeys", "stories"},
    {"metre", "meter"},
    {"metres", "meters"},
    {"cosy", "cozy"},
    {"centimetre", "centimeter"},
    {"centimetres", "centimeters"},
    {"millimetre", "millimeter"},
    {"millimetres", "millimeters"},
    {"theatre", "theater"},
    {"jewellery", "jewelry"},
    {"moulding", "molding"},
    {"plough", "plow"},
    {"aluminium", "aluminum"},
    {"organiser", "organizer"},
    {"mouldings", "moldings"},
    {"catalogue", "catalog"},
    {"centrepiece", "centerpiece"},
    {"grilles", "grills"},
    {"kerb", "curb"},
    {"neighbouring", "neighboring"},
    {"rigourous", "rigorous"},
    {"draught", "draft"},
    {"tyre", "tire"},
    {"tyres", "tires"},
    {"pyjama", "pajama"},
    {"storey", "story"},
    {"favourite", "favorite"},
    {"parallelled", "paralleled"},
    {"armour", "armor"},
}};

void finish_word(Token& token) {
  for (const auto& [british, american] : kSpellings) {
    if (token.text == british) token.text = american;
  }
}

// "… wall 2) desk": a number of a list within a line, where no bracket is open.
bool is_inline_number(std::string_view prompt, std::size_t at, std::size_t end) {
  constexpr std::size_t kReach = 80;
  if (end >= prompt.size() || prompt[end] != ')' || at == 0 || prompt[at - 1] != ' ') return false;
  const std::string_view before = prompt.substr(at > kReach ? at - kReach : 0, std::min(at, kReach));
  const std::size_t open = before.rfind('(');
  return open == std::string_view::npos || before.find(')', open) != std::string_view::npos;
}

// "1." or "2)" at the beginning of a line, or "2)" within one: the bytes it takes, else 0.
std::size_t list_number(std::string_view prompt, std::size_t at) {
  std::size_t back = at;
  while (back > 0 && (prompt[back - 1] == ' ' || prompt[back - 1] == '\t')) --back;
  const bool within = back > 0 && prompt[back - 1] != '\n';
  std::size_t i = at;
  while (i < prompt.size() && is_digit(prompt[i])) ++i;
  if (within && !is_inline_number(prompt, at, i)) return 0;
  if (i == at || i > at + 3 || i + 1 >= prompt.size() || (prompt[i] != '.' && prompt[i] != ')') || prompt[i + 1] != ' ') return 0;
  return i + 1 - at;
}

// Whether what begins at `at` opens a line of its own: an empty line, a list item, a capital.
bool opens_line(std::string_view prompt, std::size_t at) {
  while (at < prompt.size() && (prompt[at] == ' ' || prompt[at] == '\t' || prompt[at] == '\r')) ++at;
  if (at >= prompt.size()) return false;
  const char c = prompt[at];
  return c == '\n' || c == '-' || c == '*' || (c >= 'A' && c <= 'Z') || list_number(prompt, at) > 0;
}

// Whether the line that ends at `at` is as short as lines of a list are; wrapped prose fills its lines.
bool ends_short_line(std::string_view prompt, std::size_t at) {
  constexpr std::size_t kShortLine = 45;
  const std::size_t before = at == 0 ? std::string_view::npos : prompt.rfind('\n', at - 1);
  return at - (before == std::string_view::npos ? 0 : before + 1) <= kShortLine;
}

// "n't", "'d", "'ll" … after the word they are glued to: what they stand for becomes a word. Returns the bytes taken.
std::size_t read_contraction(std::string_view prompt, std::size_t at, std::vector<Token>& tokens) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kShort = {
      {{"t", "not"}, {"d", "would"}, {"ll", "will"}, {"ve", "have"}, {"re", "are"}, {"m", "am"}}};
  const Letter sign = letter_at(prompt, at);
  if (sign.value != '\'' || tokens.empty() || tokens.back().kind != Token::Kind::kWord || tokens.back().end != at) return 0;
  const std::size_t from = at + sign.size;
  for (const auto& [letters, word] : kShort) {
    const std::size_t end = from + letters.size();
    if (end > prompt.size() || (end < prompt.size() && is_letter(letter_at(prompt, end).value))) continue;
    if (!std::equal(letters.begin(), letters.end(), prompt.begin() + static_cast<std::ptrdiff_t>(from),
                    [](char a, char b) { return a == lower(b); }))
      continue;
    Token& before = tokens.back();
    if (word == "not") {
      if (!before.text.ends_with('n')) return 0;
      if (before.text == "won") before.text = "will";
      if (before.text != "can" && before.text != "will") before.text.pop_back();
    }
    tokens.push_back({Token::Kind::kWord, std::string(word), at, end, 0, false, false, false});
    return end - at;
  }
  return 0;
}

}  // namespace

std::vector<Token> tokenize(std::string_view prompt) {
  std::vector<Token> tokens;
  std::size_t at = 0;
  bool space_before = true;
  while (at < prompt.size()) {
    const Letter first = letter_at(prompt, at);
    if (first.value == ' ' || first.value == '\t' || first.value == '\r' || first.value == '\n') {
      if (first.value == '\n' && (opens_line(prompt, at + 1) || ends_short_line(prompt, at)) && !tokens.empty() && !tokens.back().ends_sentence) {
        tokens.push_back({Token::Kind::kPunctuation, ";", at, at + 1, 0, false, false, true});
      }
      space_before = true;
      at += first.size;
      continue;
    }
    if (const std::size_t number = list_number(prompt, at); number > 0) {
      tokens.push_back({Token::Kind::kPunctuation, ";", at, at + number, 0, false, false, true});
      at += number;
      continue;
    }
    Token token;
    token.begin = at;
    token.glued = !space_before;
    space_before = false;
    if (is_digit(first.value) && first.size > 1) {  // ²
      token.kind = Token::Kind::kNumber;
      token.text = std::string(1, first.value);
      token.number = first.value - '0';
      at += first.size;
    } else if (is_digit(first.value) || (first.value == '.' && at + 1 < prompt.size() && is_digit(prompt[at + 1]) && !token.glued)) {
      token.kind = Token::Kind::kNumber;
      bool dot = false;
      while (at < prompt.size()) {
        const char c = prompt[at];
        const bool digit_follows = at + 1 < prompt.size() && is_digit(prompt[at + 1]);
        const bool thousands = c == ',' && digit_follows && at + 4 <= prompt.size() && !dot && at + 3 < prompt.size() &&
                               is_digit(prompt[at + 2]) && is_digit(prompt[at + 3]) &&
                               (at + 4 == prompt.size() || !is_digit(prompt[at + 4]));
        const bool decimal_comma = c == ',' && digit_follows && !dot && !thousands;
        if (is_digit(c)) {
          token.text.push_back(c);
        } else if ((c == '.' && digit_follows && !dot) || decimal_comma) {
          token.text.push_back('.');
          dot = true;
        } else if (!thousands) {
          break;
        }
        ++at;
      }
      std::from_chars(token.text.data(), token.text.data() + token.text.size(), token.number);
    } else if (is_letter(first.value)) {
      token.capital = first.value >= 'A' && first.value <= 'Z';
      while (at < prompt.size()) {
        const Letter letter = letter_at(prompt, at);
        if (!is_letter(letter.value)) break;
        token.text.push_back(lower(letter.value));
        at += letter.size;
      }
      finish_word(token);
    } else if (const std::size_t taken = read_contraction(prompt, at, tokens); taken > 0) {
      at += taken;
      continue;
    } else if (first.value == '/' && token.glued && !tokens.empty() && tokens.back().text == "w") {  // w/, w/o
      const bool without = at + 1 < prompt.size() && lower(prompt[at + 1]) == 'o' &&
                           (at + 2 == prompt.size() || !is_letter(letter_at(prompt, at + 2).value));
      at += without ? 2 : 1;
      tokens.back().text = without ? "without" : "with";
      tokens.back().end = at;
      space_before = true;
      continue;
    } else if (first.value == '+' && first.size == 1) {
      token.text = "and";
      at += 1;
    } else if (first.value == '\'' && token.glued && !tokens.empty() && tokens.back().kind == Token::Kind::kWord) {
      // A possessive: "bed's", "inhabitants'".
      token.text = "'s";
      at += first.size;
      if (at < prompt.size() && lower(prompt[at]) == 's' && (at + 1 == prompt.size() || !is_letter(letter_at(prompt, at + 1).value))) ++at;
    } else if ((first.value == '-' || first.value == '/') && token.glued && at + first.size < prompt.size() && !tokens.empty() &&
               (is_letter(letter_at(prompt, at + first.size).value) || is_digit(prompt[at + first.size])) && tokens.back().end == at &&
               tokens.back().kind != Token::Kind::kPunctuation) {
      at += first.size;  // a hyphen within a word leaves no token; what follows is glued
      continue;
    } else if (first.value == 'h' && first.size > 1) {  // ½
      token.kind = Token::Kind::kNumber;
      token.number = 0.5;
      token.text = "0.5";
      at += first.size;
      if (token.glued && !tokens.empty() && tokens.back().kind == Token::Kind::kNumber) {
        tokens.back().number += 0.5;
        tokens.back().end = at;
        continue;
      }
    } else {
      token.kind = Token::Kind::kPunctuation;
      token.text = std::string(1, first.value);
      at += first.size;
      token.ends_sentence = first.value == '.' || first.value == '!' || first.value == '?' || first.value == ';';
      // "(not under the window!)" ends no sentence.
      if (at < prompt.size() && prompt[at] == ')') token.ends_sentence = false;
      if (first.value == '-' && !token.glued) token.text = ",";
    }
    token.end = at;
    tokens.push_back(std::move(token));
  }
  return tokens;
}

}  // namespace layoutbox::offline
