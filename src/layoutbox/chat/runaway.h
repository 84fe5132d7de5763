// Small models repeat themselves until they are stopped.
#pragma once

#include <string_view>

namespace layoutbox::chat {

// True where the end of a text is the same few words again and again, or nothing but blanks: what follows is no use.
// Things that differ in a number ("chair_1", "chair_2") are no repetition.
bool runs_away(std::string_view text);

}  // namespace layoutbox::chat
