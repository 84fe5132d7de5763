#include "layoutbox/plan/words/list_marks.h"

#include <algorithm>
#include <string>

#include "layoutbox/plan/words/letters.h"

namespace layoutbox::offline {
namespace {

// "… wall 2) desk": a number of a list within a line, where no bracket is open.
bool is_inline_number(std::string_view prompt, std::size_t at, std::size_t end) {
  constexpr std::size_t kReach = 80;
  if (end >= prompt.size() || prompt[end] != ')' || at == 0 || prompt[at - 1] != ' ') return false;
  const std::string_view before = prompt.substr(at > kReach ? at - kReach : 0, std::min(at, kReach));
  const std::size_t open = before.rfind('(');
  return open == std::string_view::npos || before.find(')', open) != std::string_view::npos;
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
