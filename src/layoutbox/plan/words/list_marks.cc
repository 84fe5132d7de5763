#include "layoutbox/plan/words/list_marks.h"

#include <algorithm>
#include <string>

#include "layoutbox/plan/words/letters.h"

namespace layoutbox::offline {
namespace {

// "… wall 2) desk": a number of a list within a line, where no bracket is open.
bool is_inline_number(std::string_view prompt, std::size_t at, std::size_t end) {
  constexpr std::size_t kReach = 80;
  if (end >= prompt.size() || prompt[end] != ')' || at == 0 || (prompt[at - 1] != ' ' && prompt[at - 1] != '\n')) return false;
  const std::string_view before = prompt.substr(at > kReach ? at - kReach : 0, std::min(at, kReach));
  const std::size_t open = before.rfind('(');
  return open == std::string_view::npos || before.find(')', open) != std::string_view::npos;
}

// Does an entry of a list begin at `at`: what stands before ends a sentence, a part of one, or a line?
bool opens_entry(std::string_view prompt, std::size_t at) {
  const std::size_t end = prompt.substr(0, at).find_last_not_of(" \t\r*-");
  if (end == std::string_view::npos) return true;
  return static_cast<unsigned char>(prompt[end]) >= 0x80 || std::string_view(".,;:!?\n|").find(prompt[end]) != std::string_view::npos;
}

bool says_and(std::string_view prompt, std::size_t at) { return at >= 5 && prompt.substr(at - 5, 5) == " and "; }

// Is "a) " said there, with or without a bracket before?
bool says_letter_mark(std::string_view where, char letter) {
  const std::string mark = {letter, ')', ' '};
  for (std::size_t at = where.find(mark); at != std::string_view::npos; at = where.find(mark, at + 1)) {
    if (at == 0 || std::string_view(" (\n").find(where[at - 1]) != std::string_view::npos) return true;
  }
  return false;
}

// "(a) a desk, (b) a lamp", "a) desk b) lamp": the bytes of a letter that another one goes on from or follows.
std::size_t list_letter(std::string_view prompt, std::size_t at) {
  constexpr std::size_t kReach = 600;
  const bool bracketed = prompt[at] == '(';
  const std::size_t letter = bracketed ? at + 1 : at;
  if (letter + 2 >= prompt.size() || !is_letter(prompt[letter]) || prompt.substr(letter + 1, 2) != ") ") return 0;
  if (!bracketed && at > 0 && !is_inline_number(prompt, at, letter + 1)) return 0;
  const bool first = lower(prompt[letter]) == 'a';
  const std::string_view where =
      first ? prompt.substr(letter + 1, kReach) : prompt.substr(at > kReach ? at - kReach : 0, std::min(at, kReach));
  const char other = static_cast<char>(prompt[letter] + (first ? 1 : -1));
  return says_letter_mark(where, other) ? letter + 2 - at : 0;
}

// "(ii) a chair", where "(i)" is before, and that one where "(ii)" follows.
std::size_t roman_number(std::string_view prompt, std::size_t at) {
  constexpr std::size_t kReach = 600, kLongest = 4;
  if (prompt[at] != '(') return 0;
  const std::size_t end = std::min(prompt.find_first_not_of("ivx", at + 1), prompt.size());
  if (end == at + 1 || end > at + 1 + kLongest || prompt.substr(end, 2) != ") ") return 0;
  const bool first = prompt.substr(at + 1, end - at - 1) == "i";
  const std::string_view where = first ? prompt.substr(end, kReach) : prompt.substr(at > kReach ? at - kReach : 0, std::min(at, kReach));
  return where.find(first ? "(ii) " : "(i) ") != std::string_view::npos ? end + 1 - at : 0;
}

// "Item A: a lift", "Prop 3 - a chair", "Object 2. Lamp": the bytes of what an entry of a list is called.
std::size_t entry_label(std::string_view prompt, std::size_t at) {
  static constexpr std::string_view kLabels[] = {"item",    "object", "prop", "thing", "piece", "asset",
                                                 "element", "entry",  "no",   "nr",    "number"};
  std::size_t i = at;
  while (i < prompt.size() && is_letter(prompt[i])) ++i;
  std::string word(prompt.substr(at, i - at));
  std::ranges::transform(word, word.begin(), lower);
  if (std::ranges::find(kLabels, word) == std::end(kLabels) || !(opens_entry(prompt, at) || says_and(prompt, at))) return 0;
  i = std::min(prompt.find_first_not_of(".# ", i), prompt.size());
  const std::size_t name = i;
  if (i < prompt.size() && is_letter(prompt[i])) {
    ++i;
  } else {
    while (i < prompt.size() && is_digit(prompt[i])) ++i;
  }
  constexpr std::size_t kDigits = 3;
  if (i == name || i > name + kDigits || i >= prompt.size()) return 0;
  const std::size_t sign = std::min(prompt.find_first_not_of(' ', i), prompt.size());
  static constexpr std::string_view kLabelEnds[] = {":", ")", ". ", "- ", "\u2013 ", "\u2014", "= "};
  for (const std::string_view one : kLabelEnds) {
    if (prompt.substr(sign).starts_with(one)) return sign + one.size() - at;
  }
  return 0;
}

// "(1) desk; … (2) table": the bytes of a number that goes on with a list, after the end of a sentence. Not "bed. (2) nightstands".
std::size_t bracketed_list_number(std::string_view prompt, std::size_t at) {
  constexpr std::size_t kReach = 600, kLength = 4;
  if (at + kLength > prompt.size() || prompt[at] != '(' || !is_digit(prompt[at + 1]) || prompt.substr(at + 2, 2) != ") ") return 0;
  const char number = prompt[at + 1];
  const std::size_t end = prompt.substr(0, at).find_last_not_of(" \t\r");
  if (end != std::string_view::npos && std::string_view(".;:!?\n").find(prompt[end]) == std::string_view::npos) return 0;
  const std::string other = {'(', static_cast<char>(number == '1' ? '2' : number - 1), ')', ' '};
  const std::string_view where =
      number == '1' ? prompt.substr(at + kLength, kReach) : prompt.substr(at > kReach ? at - kReach : 0, std::min(at, kReach));
  return where.find(other) != std::string_view::npos ? kLength - 1 : 0;
}

}  // namespace

std::size_t list_number(std::string_view prompt, std::size_t at) {
  if (const std::size_t bracketed = bracketed_list_number(prompt, at); bracketed > 0) return bracketed;
  if (const std::size_t letter = std::max(list_letter(prompt, at), roman_number(prompt, at)); letter > 0) return letter;
  if (const std::size_t label = entry_label(prompt, at); label > 0) return label;
  std::size_t back = at;
  while (back > 0 && (prompt[back - 1] == ' ' || prompt[back - 1] == '\t')) --back;
  const bool within = back > 0 && prompt[back - 1] != '\n';
  std::size_t i = at;
  while (i < prompt.size() && is_digit(prompt[i])) ++i;
  if (within && !is_inline_number(prompt, at, i)) return 0;
  if (i == at || i > at + 3 || i + 1 >= prompt.size() || (prompt[i] != '.' && prompt[i] != ')') || prompt[i + 1] != ' ') return 0;
  return i + 1 - at;
}

bool opens_line(std::string_view prompt, std::size_t at) {
  while (at < prompt.size() && (prompt[at] == ' ' || prompt[at] == '\t' || prompt[at] == '\r')) ++at;
  if (at >= prompt.size()) return false;
  const char c = prompt[at];
  return c == '\n' || c == '-' || c == '*' || (c >= 'A' && c <= 'Z') || list_number(prompt, at) > 0;
}

bool ends_short_line(std::string_view prompt, std::size_t at) {
  constexpr std::size_t kShortLine = 45;
  const std::size_t before = at == 0 ? std::string_view::npos : prompt.rfind('\n', at - 1);
  return at - (before == std::string_view::npos ? 0 : before + 1) <= kShortLine;
}

}  // namespace layoutbox::offline
