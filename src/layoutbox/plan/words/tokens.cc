#include "layoutbox/plan/words/tokens.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "layoutbox/plan/words/american_spelling.h"
#include "layoutbox/plan/words/letters.h"
#include "layoutbox/plan/words/list_marks.h"

namespace layoutbox::offline {
namespace {

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

// "doesnt", "thats": what is written without its apostrophe, as the two words it is short for; empty: nothing of the kind.
std::pair<std::string_view, std::string_view> unmarked_contraction(std::string_view word) {
  static constexpr std::array<std::array<std::string_view, 3>, 20> kShort = {
      {{"dont", "do", "not"},       {"doesnt", "does", "not"},   {"didnt", "did", "not"},       {"isnt", "is", "not"},
       {"arent", "are", "not"},     {"wasnt", "was", "not"},     {"cant", "can", "not"},        {"wont", "will", "not"},
       {"wouldnt", "would", "not"}, {"couldnt", "could", "not"}, {"shouldnt", "should", "not"}, {"mustnt", "must", "not"},
       {"havent", "have", "not"},   {"hasnt", "has", "not"},     {"thats", "that", "is"},       {"whats", "what", "is"},
       {"theres", "there", "is"},   {"theyre", "they", "are"},   {"youre", "you", "are"},       {"ive", "i", "have"}}};
  for (const auto& [text, first, second] : kShort) {
    if (text == word) return {first, second};
  }
  return {};
}

class Tokenizer {
 public:
  explicit Tokenizer(std::string_view prompt) : prompt_(prompt) {
    std::size_t dashes = 0;
    for (std::size_t at = prompt.find(" - "); at != std::string_view::npos; at = prompt.find(" - ", at + 1)) ++dashes;
    dashes_list_ = dashes >= kDashesOfList;
  }
  std::vector<Token> run() {
    while (at_ < prompt_.size()) {
      const Letter first = letter_at(prompt_, at_);
      if (!skip_space(first) && !take_list_number()) take_token(first);
    }
    return std::move(tokens_);
  }

 private:
  bool digit_at(std::size_t at) const { return at < prompt_.size() && is_digit(prompt_[at]); }
  bool letter_follows(std::size_t at) const { return at < prompt_.size() && is_letter(letter_at(prompt_, at).value); }
  bool after(Token::Kind kind) const { return !tokens_.empty() && tokens_.back().kind == kind; }

  bool skip_space(const Letter& first) {
    if (first.value != ' ' && first.value != '\t' && first.value != '\r' && first.value != '\n') return false;
    if (first.value == '\n' && (opens_line(prompt_, at_ + 1) || ends_short_line(prompt_, at_)) && !tokens_.empty() &&
        !tokens_.back().ends_sentence) {
      tokens_.push_back({Token::Kind::kPunctuation, ";", at_, at_ + 1, 0, false, false, true});
    }
    space_before_ = true;
    at_ += first.size;
    return true;
  }

  bool take_list_number() {
    const std::size_t number = list_number(prompt_, at_);
    if (number == 0) return false;
    tokens_.push_back({Token::Kind::kPunctuation, ";", at_, at_ + number, 0, false, false, true});
    at_ += number;
    return true;
  }

  void take_token(const Letter& first) {
    Token token;
    token.begin = at_;
    token.glued = !space_before_;
    space_before_ = false;
    if (is_digit(first.value) && first.size > 1) {  // ²
      token.kind = Token::Kind::kNumber;
      token.text = std::string(1, first.value);
      token.number = first.value - '0';
      at_ += first.size;
    } else if (is_digit(first.value) || (first.value == '.' && digit_at(at_ + 1) && !token.glued)) {
      take_number(token);
    } else if (const std::size_t sign = diameter_sign(); sign > 0) {
      token.text = "diameter";
      at_ += sign;
    } else if (is_letter(first.value)) {
      take_word(token);
      if (ends_dimensions(token)) return;
      part_unmarked(token);
    } else if (const std::size_t taken = read_contraction(prompt_, at_, tokens_); taken > 0) {
      at_ += taken;
      return;
    } else if (!take_sign(first, token)) {
      return;
    }
    token.end = at_;
    tokens_.push_back(std::move(token));
  }

  // "Ø 80 cm": the bytes of a sign of the diameter that stands before a number, else 0.
  std::size_t diameter_sign() const {
    for (const std::string_view sign : {"\u00D8", "\u00F8", "\u2300"}) {
      const std::size_t after = at_ + sign.size();
      if (prompt_.substr(at_).starts_with(sign) && (digit_at(after) || (after < prompt_.size() && prompt_[after] == ' ')))
        return sign.size();
    }
    return 0;
  }

  void take_number(Token& token) {
    token.kind = Token::Kind::kNumber;
    bool dot = false;
    for (; at_ < prompt_.size(); ++at_) {
      const char c = prompt_[at_];
      const bool digit_follows = digit_at(at_ + 1);
      const bool thousands = c == ',' && digit_follows && !dot && digit_at(at_ + 2) && digit_at(at_ + 3) && !digit_at(at_ + 4);
      const bool decimal_comma = c == ',' && digit_follows && !dot && !thousands;
      if (is_digit(c)) {
        token.text.push_back(c);
      } else if ((c == '.' && digit_follows && !dot) || decimal_comma) {
        token.text.push_back('.');
        dot = true;
      } else if (!thousands) {
        break;
      }
    }
    std::from_chars(token.text.data(), token.text.data() + token.text.size(), token.number);
  }

  void take_word(Token& token) {
    const char first = letter_at(prompt_, at_).value;
    token.capital = first >= 'A' && first <= 'Z';
    while (at_ < prompt_.size()) {
      const Letter letter = letter_at(prompt_, at_);
      if (!is_letter(letter.value)) break;
      token.text.push_back(lower(letter.value));
      at_ += letter.size;
    }
    token.text = american_spelling(std::move(token.text));
    if (token.text == "round" && !tokens_.empty() && tokens_.back().text == "all") token.text = "around";  // "chairs all round"
  }

  // The first of the two words that "doesnt" is short for becomes a token of its own.
  void part_unmarked(Token& token) {
    const auto [first, second] = unmarked_contraction(token.text);
    if (first.empty()) return;
    Token before = token;
    const std::size_t cut = at_ - (second == "is" ? 1 : 2);
    before.text = first;
    before.end = cut;
    tokens_.push_back(std::move(before));
    token.text = second;
    token.begin = cut;
    token.capital = false;
  }

  // "a 3D printer", "a 2D map": one word, no count.
  bool ends_dimensions(const Token& token) {
    if (token.text != "d" || !token.glued || tokens_.empty()) return false;
    Token& number = tokens_.back();
    if (number.kind != Token::Kind::kNumber || number.end != token.begin || (number.text != "2" && number.text != "3")) return false;
    number.kind = Token::Kind::kWord;
    number.text += "d";
    number.number = 0;
    number.end = at_;
    return true;
  }

  // Neither letter nor digit. Whether it makes a token of its own.
  bool take_sign(const Letter& first, Token& token) {
    if (first.value == '/' && token.glued && !tokens_.empty() && tokens_.back().text == "w") {
      take_with_short();
      return false;
    }
    if (first.value == '+' && token.glued && after(Token::Kind::kNumber) && at_ + 1 < prompt_.size() && prompt_[at_ + 1] == ' ') {
      at_ += 1;  // "5+ chairs"
      return false;
    }
    if (first.value == '+' && first.size == 1) {
      token.text = "and";
      at_ += 1;
      return true;
    }
    if (first.value == '\'' && token.glued && after(Token::Kind::kWord)) {  // a possessive: "bed's", "inhabitants'"
      token.text = "'s";
      at_ += first.size;
      if (at_ < prompt_.size() && lower(prompt_[at_]) == 's' && !letter_follows(at_ + 1)) ++at_;
      return true;
    }
    if (take_leader(first, token)) return true;
    if (first.value == '-' && !token.glued && take_degrees_below_zero(token)) return true;
    const std::size_t next = at_ + first.size;
    const bool joins = first.value == '-' || first.value == '/' || (first.value == '_' && letter_follows(next));
    if (joins && token.glued && (letter_follows(next) || digit_at(next)) && !tokens_.empty() && tokens_.back().end == at_ &&
        tokens_.back().kind != Token::Kind::kPunctuation) {
      at_ = next;  // a hyphen within a word leaves no token; what follows is glued
      return false;
    }
    at_ = next;
    if (first.value == 'h' && first.size > 1) return take_half(token);
    token.kind = Token::Kind::kPunctuation;
    token.text = std::string(1, first.value);
    token.ends_sentence = first.value == '.' || first.value == '!' || first.value == '?' || first.value == ';';
    // "(not under the window!)" ends no sentence.
    if (at_ < prompt_.size() && prompt_[at_] == ')') token.ends_sentence = false;
    if (opens_item(first.value, token)) {
      token.text = ";";
      token.ends_sentence = true;
    } else if (first.value == '-' && !token.glued) {
      token.text = ",";
    }
    return true;
  }

  // "a fridge and a -80 freezer": how cold it is, and no count. Not "- 2 chairs", "-2 chairs" at the beginning of a line.
  bool take_degrees_below_zero(Token& token) {
    std::size_t line = at_;
    while (line > 0 && prompt_[line - 1] == ' ') --line;
    std::size_t end = at_ + 1;
    while (digit_at(end)) ++end;
    if (line == 0 || prompt_[line - 1] == '\n' || dashes_list_ || end == at_ + 1) return false;
    std::size_t unit = end;
    while (unit < prompt_.size() && prompt_[unit] == ' ') ++unit;
    if (prompt_.substr(unit).starts_with("\u00B0")) end = unit + 2 + (prompt_.substr(unit + 2).starts_with("C") ? 1 : 0);
    if (end + 1 >= prompt_.size() || prompt_[end] != ' ' || !letter_follows(end + 1)) return false;
    at_ = end;
    token.kind = Token::Kind::kWord;
    token.text = "cold";
    return true;
  }

  // "Chair ........ 2", "and then… maybe a rug": dots that end no sentence, before what has no capital.
  bool take_leader(const Letter& first, Token& token) {
    constexpr std::size_t kFewest = 3;
    const bool ellipsis = first.value == '.' && first.size > 1;
    const bool goes_on = at_ > 0 && prompt_[at_ - 1] == first.value;  // its first one was looked at
    if ((first.value != '.' && first.value != '_') || goes_on) return false;
    std::size_t end = at_;
    while (end < prompt_.size() && letter_at(prompt_, end).value == first.value) end += letter_at(prompt_, end).size;
    if (end - at_ < kFewest && !ellipsis) return false;
    std::size_t next = end;
    while (next < prompt_.size() && prompt_[next] == ' ') ++next;
    if (next >= prompt_.size() || !(digit_at(next) || (prompt_[next] >= 'a' && prompt_[next] <= 'z'))) return false;
    at_ = end;
    token.kind = Token::Kind::kPunctuation;
    token.text = ",";
    return true;
  }

  // "… - bench under the window - dartboard on the wall", "* sink * bin": a bullet in the line, the sign just taken. Not "5 * 6 m".
  bool opens_item(char sign, const Token& token) const {
    const bool spaced = !token.glued && at_ < prompt_.size() && prompt_[at_] == ' ';
    if (!spaced || tokens_.empty() || (after(Token::Kind::kNumber) && digit_at(at_ + 1))) return false;
    return sign == '*' || (sign == '-' && dashes_list_);
  }

  // "w/", "w/o"
  void take_with_short() {
    const bool without = at_ + 1 < prompt_.size() && lower(prompt_[at_ + 1]) == 'o' && !letter_follows(at_ + 2);
    at_ += without ? 2 : 1;
    tokens_.back().text = without ? "without" : "with";
    tokens_.back().end = at_;
    space_before_ = true;
  }

  // "½", and "2½".
  bool take_half(Token& token) {
    token.kind = Token::Kind::kNumber;
    token.number = 0.5;
    token.text = "0.5";
    if (!token.glued || !after(Token::Kind::kNumber)) return true;
    tokens_.back().number += 0.5;
    tokens_.back().end = at_;
    return false;
  }

  std::string_view prompt_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  bool space_before_ = true;
  static constexpr std::size_t kDashesOfList = 3;  // fewer are asides
  bool dashes_list_ = false;
};

// "6.0 m (x) by 4.5 m (y)": which axis a length is along follows from its place.
std::vector<Token> without_axis_marks(std::vector<Token> tokens) {
  const auto marks = [&](std::size_t i) {
    const auto number = [&](std::size_t back) { return i >= back && tokens[i - back].kind == Token::Kind::kNumber; };
    if (!(number(1) || number(2)) || i + 2 >= tokens.size() || tokens[i].text != "(" || tokens[i + 2].text != ")") return false;
    return tokens[i + 1].text == "x" || tokens[i + 1].text == "y" || tokens[i + 1].text == "z";
  };
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (marks(i)) tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(i), tokens.begin() + static_cast<std::ptrdiff_t>(i + 3));
  }
  return tokens;
}

}  // namespace

std::vector<Token> tokenize(std::string_view prompt) { return settle_on(without_axis_marks(Tokenizer(prompt).run())); }

}  // namespace layoutbox::offline
