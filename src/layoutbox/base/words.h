// Words as keys: case, separators and plurals apart; and which word was meant.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace layoutbox {

// Lower-case words of a phrase, split at spaces and ASCII punctuation (other UTF-8 is kept): "Book-Shelf" → book, shelf.
std::vector<std::string> words_of(std::string_view phrase);

// The words run together: "book shelf", "book_shelf" and "Bookshelf" have one key.
std::string key_of(std::string_view phrase);

// The words joined by underscores: "Dining Table" → dining_table.
std::string snake_case(std::string_view phrase);

// "1 relation", "2 relations"; `many` where it takes more than an s ("boxes").
std::string counted(std::size_t count, std::string_view one, std::string_view many = {});

// The likeliest singular of a lower-case word, or the word itself: by its ending alone, no list of words is asked.
std::string singular_of(std::string_view word);

// What a word may be the plural of, itself first: "shelves" → shelves, shelve, shelf…; not all are words.
std::vector<std::string> singular_forms(std::string_view word);

// Keys under which words[from…] may be found, best first: as they are, then with the head noun in the singular
// ("chests of drawers" → chestofdrawers, chestsofdrawer…).
std::vector<std::string> candidate_keys(std::span<const std::string> words);

// Letters to change, add, leave out or swap with their neighbour to make one word of the other. REQUIRES: at most 64 bytes matter.
std::size_t edit_distance(std::string_view a, std::string_view b);

// The nearest of `known` to a misspelt word, or empty when none is near.
std::string nearest_word(std::string_view word, std::span<const std::string> known);

}  // namespace layoutbox
