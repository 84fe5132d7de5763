// Secrets that a server says back.
#pragma once

#include <string>
#include <string_view>

namespace layoutbox::chat {

// The text with "[key]" for the secret: whole, in base64, with blanks, line ends, "-" or other signs anywhere in it, and for each piece of
// twelve letters and digits of it.
std::string without_secret(std::string_view text, std::string_view secret);

}  // namespace layoutbox::chat
