#include "layoutbox/chat/tokens.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace layoutbox::chat {
namespace {

constexpr int kLettersPerToken = 6;
constexpr int kLeastAnswer = 128;  // less holds no scene

enum class CharacterKind { kLetter, kDigit, kBlank, kLineEnd, kOther, kSign };

CharacterKind kind_of(char c) {
  if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) return CharacterKind::kLetter;
  if (c >= '0' && c <= '9') return CharacterKind::kDigit;
  if (c == ' ' || c == '\t') return CharacterKind::kBlank;
  if (c == '\n' || c == '\r') return CharacterKind::kLineEnd;
  return static_cast<unsigned char>(c) >= 0x80 ? CharacterKind::kOther : CharacterKind::kSign;
}

// `next`: what follows the run. A blank belongs to the word after it.
std::int64_t tokens_of_run(CharacterKind kind, std::int64_t length, CharacterKind next) {
  switch (kind) {
    case CharacterKind::kLetter: return 1 + (length - 1) / kLettersPerToken;
    case CharacterKind::kDigit:
    case CharacterKind::kOther: return length;
    case CharacterKind::kBlank: return length > 1 || next == CharacterKind::kDigit ? 1 : 0;
    case CharacterKind::kLineEnd: return 1;
    case CharacterKind::kSign: return (length + 1) / 2;
  }
  return length;
}

// The first number of at least three digits after `words`, within a few words; "4,096" counts as 4096.
std::int64_t number_after(std::string_view text, std::string_view words) {
  constexpr std::size_t kNear = 60;
  const std::size_t found = text.find(words);
  if (found == std::string_view::npos) return 0;
  const std::size_t begin = found + words.size();
  std::string digits;
  for (std::size_t i = begin; i < std::min(text.size(), begin + kNear); ++i) {
    if (kind_of(text[i]) == CharacterKind::kDigit) {
      digits += text[i];
    } else if (digits.size() >= 3 && text[i] != ',') {
      break;
    } else if (text[i] != ',') {
      digits.clear();
    }
  }
  std::int64_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return digits.size() >= 3 ? number : 0;
}

// The number that ends just before `words`: "32768 maximum context".
std::int64_t number_before(std::string_view text, std::string_view words) {
  const std::size_t found = text.find(words);
  if (found == std::string_view::npos) return 0;
  std::size_t begin = found;
  while (begin > 0 && kind_of(text[begin - 1]) == CharacterKind::kDigit) --begin;
  std::int64_t number = 0;
  std::from_chars(text.data() + begin, text.data() + found, number);
  return number;
}

}  // namespace

std::int64_t estimated_tokens(std::string_view text) {
  std::int64_t tokens = 1;
  for (std::size_t begin = 0; begin < text.size();) {
    const CharacterKind kind = kind_of(text[begin]);
    std::size_t end = begin;
    while (end < text.size() && kind_of(text[end]) == kind) ++end;
    tokens += tokens_of_run(kind, static_cast<std::int64_t>(end - begin), end < text.size() ? kind_of(text[end]) : CharacterKind::kSign);
    begin = end;
  }
  return tokens;
}

std::int64_t estimated_tokens(const Request& question) {
  constexpr std::int64_t kAround = 8;  // of a message or a function: what a template puts around it
  std::int64_t tokens = 0;
  constexpr std::int64_t kImage = 1600;  // of a large one; providers count by size, and make larger ones smaller
  for (const Message& message : question.messages) {
    tokens += kAround + estimated_tokens(message.content) + kImage * static_cast<std::int64_t>(message.images.size());
  }
  for (const Function& function : question.functions) tokens += kAround + estimated_tokens(function.parameters);
  return tokens;
}

Capacity capacity_told(std::string_view message, std::int64_t context_member) {
  Capacity told{context_member, 0, false};
  constexpr std::array<std::string_view, 4> kBefore = {"context length", "context size", "context window", "context of"};
  for (const std::string_view words : kBefore) {
    if (told.context == 0) told.context = number_after(message, words);
  }
  if (told.context == 0) told.context = number_before(message, " maximum context");
  if (message.find("completion tokens") != std::string_view::npos) told.response = number_after(message, "at most");
  if (told.response == 0) told.response = number_before(message, ", which is the maximum allowed number of output tokens");
  return told;
}

Request fitted(const Request& question, const Capacity& capacity) {
  const Request* best = &question;
  const auto room_of = [&](const Request& one) { return capacity.context - estimated_tokens(one); };
  while (capacity.context > 0 && best->shorter != nullptr && room_of(*best) < best->max_response_tokens) best = best->shorter.get();
  Request chosen = *best;
  std::int64_t most = chosen.max_response_tokens;
  if (capacity.response > 0) most = std::min(most, capacity.response);
  if (capacity.context > 0 && !capacity.cuts) most = std::min(most, std::max<std::int64_t>(room_of(chosen), kLeastAnswer));
  chosen.max_response_tokens = static_cast<int>(most);
  return chosen;
}

}  // namespace layoutbox::chat
