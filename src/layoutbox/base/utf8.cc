#include "layoutbox/base/utf8.h"

#include <utf8.h>

#include <algorithm>
#include <iterator>

namespace layoutbox {
namespace {

bool begins_character(char byte) { return (static_cast<unsigned char>(byte) & 0xC0u) != 0x80u; }

}  // namespace

bool is_utf8(std::string_view text) { return utf8::is_valid(text.begin(), text.end()); }

std::size_t characters_in(std::string_view text) { return static_cast<std::size_t>(std::ranges::count_if(text, begins_character)); }

std::string_view first_characters(std::string_view text, std::size_t most) {
  std::size_t characters = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (begins_character(text[i]) && ++characters > most) return text.substr(0, i);
  }
  return text;
}

std::string_view first_bytes(std::string_view text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && !begins_character(text[most])) --most;
  return text.substr(0, most);
}

std::string with_blanks(std::string_view text, bool (*goes)(char32_t character)) {
  std::string valid;
  valid.reserve(text.size());
  utf8::replace_invalid(text.begin(), text.end(), std::back_inserter(valid), U' ');
  std::string out;
  out.reserve(valid.size());
  for (const char *at = valid.data(), *end = at + valid.size(); at != end;) {
    const char* begin = at;
    if (goes(utf8::unchecked::next(at))) {
      out += ' ';
    } else {
      out.append(begin, at);
    }
  }
  return out;
}

}  // namespace layoutbox
