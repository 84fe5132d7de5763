// Where a text is a list: numbers of its items, and lines that are items.
#pragma once

#include <cstddef>
#include <string_view>

namespace layoutbox::offline {

// "1." or "2)" at the beginning of a line, or "2)" within one: the bytes it takes, else 0.
std::size_t list_number(std::string_view prompt, std::size_t at);

// Whether what begins at `at` opens a line of its own: an empty line, a list item, a capital.
bool opens_line(std::string_view prompt, std::size_t at);

// Whether the line that ends at `at` is as short as lines of a list are; wrapped prose fills its lines.
bool ends_short_line(std::string_view prompt, std::size_t at);

}  // namespace layoutbox::offline
