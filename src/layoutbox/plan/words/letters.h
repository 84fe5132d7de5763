// Text letter by letter: signs and accents of other alphabets as what they mean here.
#pragma once

#include <cstddef>
#include <string_view>

namespace layoutbox::offline {

struct Letter {
  char value = 0;
  std::size_t size = 1;
};

// REQUIRES: at < text.size(). Another script is '~': a word of its own.
Letter letter_at(std::string_view text, std::size_t at);

inline bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '~'; }
inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace layoutbox::offline
