// Text of others, made fit to be shown.
#pragma once

#include <string>
#include <string_view>

namespace layoutbox {

// The text with a blank for each control character and each that cannot be seen or turns the direction of writing, with which a name can
// look like another, and for what is not UTF-8. Line feeds and tabs become blanks too.
std::string plain_text(std::string_view text);

}  // namespace layoutbox
