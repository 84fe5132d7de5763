#include "layoutbox/plan/passes/courtesy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "layoutbox/plan/words/english.h"

namespace layoutbox::offline {
namespace {

template <std::size_t n>
bool is_one_of(const std::array<std::string_view, n>& words, const Token& token) {
  return std::ranges::find(words, token.text) != words.end();
}

// "if you could also", "if someone can please": so many tokens; 0: none.
std::size_t asking_at(const std::vector<Token>& tokens, std::size_t at) {
  static constexpr std::array<std::string_view, 4> kWho{"you", "someone", "somebody", "we"};
  static constexpr std::array<std::string_view, 5> kMay{"can", "could", "would", "might", "may"};
  static constexpr std::array<std::string_view, 7> kPlease{"please", "also", "maybe", "perhaps", "just", "possibly", "kindly"};
  if (at + 3 >= tokens.size() || tokens[at].text != "if" || !is_one_of(kWho, tokens[at + 1]) || !is_one_of(kMay, tokens[at + 2])) return 0;
  std::size_t end = at + 3;
  while (end < tokens.size() && is_one_of(kPlease, tokens[end])) ++end;
  return end < tokens.size() && tokens[end].kind == Token::Kind::kWord ? end - at : 0;
}

// "the 1970s", "in the 80's": no number of things.
std::size_t decade_at(const std::vector<Token>& tokens, std::size_t at) {
  static constexpr std::array<std::string_view, 6> kBeforeYear{"around", "about", "circa", "in", "of", "from"};
  if (tokens[at].kind != Token::Kind::kNumber || at + 1 >= tokens.size()) return 0;
  const double number = tokens[at].number;
  const bool year = number >= 1500 && number < 2100 && at > 0 && (tokens[at + 1].kind == Token::Kind::kPunctuation) &&
                    std::ranges::find(kBeforeYear, tokens[at - 1].text) != std::end(kBeforeYear);
  if (year) return 1;
  const bool decade = (number >= 1000 && number < 2100) || (number >= 20 && number < 100 && std::fmod(number, 10) == 0);
  return decade && (tokens[at + 1].text == "s" || tokens[at + 1].text == "'s") && tokens[at + 1].begin == tokens[at].end ? 2 : 0;
}

// "How could it be arranged?", "What do you think?": a question at `at` that names no thing; so many tokens, 0: none.
std::size_t idle_question_at(const Lexicon& lexicon, const std::vector<Token>& tokens, std::size_t at) {
  static constexpr std::array<std::string_view, 5> kAsks{"how", "what", "why", "which", "any"};
  if ((at > 0 && !tokens[at - 1].ends_sentence) || !is_one_of(kAsks, tokens[at])) return 0;
  std::size_t end = at;
  for (; end < tokens.size() && !tokens[end].ends_sentence; ++end) {
    if (lexicon.find(tokens, end, WordClass::kObject).length > 0 || lexicon.find(tokens, end, WordClass::kRoom).length > 0) return 0;
  }
  return end < tokens.size() && tokens[end].text == "?" ? end - at : 0;
}

// "I'm a nurse": past the person; 0: none such.
std::size_t past_person(const Lexicon& lexicon, const std::vector<Token>& tokens, std::size_t at) {
  if (at + 3 >= tokens.size() || (tokens[at].text != "i" && tokens[at].text != "we")) return 0;
  std::size_t t = at + 1;
  if (tokens[t].text != "am" && tokens[t].text != "are" && tokens[t].text != "'m" && tokens[t].text != "'re") return 0;
  ++t;
  if (tokens[t].text != "a" && tokens[t].text != "an") return 0;
  constexpr std::size_t kWords = 4;  // "a retired primary school teacher"
  for (const std::size_t last = t + kWords; ++t < tokens.size() && t <= last;) {
    if (lexicon.is_person(tokens[t].text) || word_form(tokens[t].text) == WordForm::kPerson) return t + 1;
  }
  return 0;
}

// Where what somebody says of themselves ends: at a colon, with the sentence, or where they go on to what they want.
std::size_t end_of_introduction(const std::vector<Token>& tokens, std::size_t at) {
  static constexpr std::array<std::string_view, 7> kWanting{"need", "want", "have", "like", "would", "wish", "require"};
  for (; at < tokens.size() && !tokens[at].ends_sentence && tokens[at].text != ":"; ++at) {
    const bool joined = at > 0 && (tokens[at - 1].text == "and" || tokens[at - 1].text == "," || tokens[at - 1].text == "so" ||
                                   tokens[at - 1].text == "but");
    if (joined && (tokens[at].text == "i" || tokens[at].text == "we" || tokens[at].text == "my" || tokens[at].text == "our")) return at;
    if (is_one_of(kWanting, tokens[at]) && at + 1 < tokens.size() && tokens[at + 1].text != "to") return at;
  }
  return at;
}

}  // namespace

void read_courtesies(const Lexicon& lexicon, Document& document, std::vector<bool>& skip) {
  const std::vector<Token>& tokens = document.tokens;
  const auto leave_out = [&](std::size_t first, std::size_t last) {
    std::fill(skip.begin() + static_cast<std::ptrdiff_t>(first), skip.begin() + static_cast<std::ptrdiff_t>(last), true);
  };
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (const std::size_t decade = decade_at(tokens, i); decade > 0) leave_out(i, i + decade);
    if (const std::size_t question = idle_question_at(lexicon, tokens, i); question > 0) leave_out(i, i + question);
    if (const std::size_t asking = asking_at(tokens, i); asking > 0) leave_out(i, i + asking);
    const bool opens = i == 0 || tokens[i - 1].ends_sentence;
    const std::size_t person = opens ? past_person(lexicon, tokens, i) : 0;
    if (person == 0) continue;
    const std::size_t end = end_of_introduction(tokens, person);
    bool room = false;
    for (std::size_t t = person; t < end; ++t) room = room || lexicon.find(tokens, t, WordClass::kRoom).length > 0;
    if (!room) leave_out(i, end);
  }
}

}  // namespace layoutbox::offline
