// The words of a text that are asked after in catalog/decor.json.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace layoutbox {

// Lower-case words and the signs between them, each by itself; a hyphen parts words as a space does.
std::vector<std::string> words_and_signs(std::string_view text);
bool is_sign(std::string_view word);

// Whether that list of decor.json (words parted by spaces) has the word.
bool is_in_list(const char* list, std::string_view word);

// Whether the text, in lower case, has that phrase; whole words only.
bool says_word(std::string_view text, std::string_view phrase);

// A word that speaks of the room itself: "bedroom", "den".
bool is_room_word(std::string_view word);

// Whether what is said at `at` is said not to be: "no", "nothing too", "no grey or" stand right before it.
bool is_banned_at(const std::vector<std::string>& words, std::size_t at);

}  // namespace layoutbox
