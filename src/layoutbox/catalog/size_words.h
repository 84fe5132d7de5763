// What words say about a size: "king" bed, "tall" shelf.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/catalog/catalog.h"

namespace layoutbox {

inline constexpr std::array kSizeSides{&Size::width, &Size::depth, &Size::height};

// What is said of the object: its attributes, its name and its category.
std::vector<std::string> words_said_of(const SceneObject& object);

// The entry's size, narrowed by its variants or by general words among `said` (lower-case words in order).
SizeRange size_by_words(const CatalogEntry& entry, const std::vector<std::string>& said);

// True when the words of `phrase` stand in `said` one after the other.
bool says(const std::vector<std::string>& said, std::string_view phrase);

// What is said of things as high as the room.
inline constexpr std::array<std::string_view, 4> kFullHeight{"floor to ceiling", "ceiling high", "full height", "wall to ceiling"};

// True for words of size that hold for every kind of thing: "large", "narrow"…
bool is_size_word(std::string_view word);

// How large a room's floor is of which that is said, as a share of such a room's usual one: 0.65 of a "tiny" one; 1 where it says nothing.
double room_size_factor(std::string_view word);

}  // namespace layoutbox
