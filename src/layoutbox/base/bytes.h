// Bytes as text.
#pragma once

#include <string>
#include <string_view>

namespace layoutbox {

// RFC 4648 with padding: in one line, or in lines of `line` signs, each ended. REQUIRES: line a multiple of four.
std::string base64(std::string_view bytes, std::size_t line = 0);

// Sixteen hexadecimal digits that differ where texts differ.
std::string content_key(std::string_view text);

}  // namespace layoutbox
