// How long a question is in tokens, and how much of it a model can hold.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "layoutbox/chat/chat.h"

namespace layoutbox::chat {

// Rather more tokens than a text has, by the kinds of its characters: words of English about one for six letters, one for each digit and
// for each byte that is not ASCII. More than small models' tokenizers (vocabulary of 49,000) count, see docs/llm.md.
std::int64_t estimated_tokens(std::string_view text);

// Of messages and functions.
std::int64_t estimated_tokens(const Request& question);

// What a server says that a model can hold, in tokens; 0: nothing is known.
struct Capacity {
  std::int64_t context = 0;   // request and response together
  std::int64_t response = 0;  // of one response
  bool cuts = false;          // known from responses that broke off: such a server takes any limit, so none is set below what one needs

  std::int64_t context_or_any() const { return context > 0 ? context : kAny; }
  std::int64_t response_or_any() const { return response > 0 ? response : kAny; }
  static constexpr std::int64_t kAny = std::numeric_limits<std::int64_t>::max();
};

// The words and numbers of an error about length. Empty where it tells nothing; servers say it in many ways.
Capacity capacity_told(std::string_view message, std::int64_t context_member);

// The question, or the longest of its shorter forms that leaves room for its answer, with an answer no longer than there is room for.
Request fitted(const Request& question, const Capacity& capacity);

}  // namespace layoutbox::chat
