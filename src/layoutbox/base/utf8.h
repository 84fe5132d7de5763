// UTF-8 by the character.
#pragma once

#include <string>
#include <string_view>

namespace layoutbox {

// As Unicode has it: no overlong forms, no surrogates.
bool is_utf8(std::string_view text);

// The characters of a text; what is not UTF-8 counts by the bytes that begin something.
std::size_t characters_in(std::string_view text);

// The longest beginning of at most so many characters, or bytes, that cuts no character.
std::string_view first_characters(std::string_view text, std::size_t most);
std::string_view first_bytes(std::string_view text, std::size_t most);

// The text with a blank for each character of which `goes` is true, and for whatever is not UTF-8.
std::string with_blanks(std::string_view text, bool (*goes)(char32_t character));

}  // namespace layoutbox
