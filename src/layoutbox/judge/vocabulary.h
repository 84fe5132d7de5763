// Words of annotations: which check a relation's word stands for (catalog/annotation_words.json), and which objects a noun means.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/catalog/catalog.h"

namespace layoutbox::scoring {

using Phrase = std::vector<std::string>;  // lower case, singular

// "Potted_Plants" → potted, plant.
Phrase phrase_of(std::string_view text);
// The phrase up to its first preposition: "bed with drawers" → bed.
Phrase head_of(Phrase phrase);

// The check that a word means in a list of annotation_words.json ("objects", "faces", "wall", "opening", "ceiling", "floor", "room"),
// spaces, dashes and a last "of", "from", "to" or "the" apart; empty where none does.
std::string_view check_for(std::string_view word, std::string_view list);

bool is_ring_word(std::string_view word);
// wall, door, window, ceiling, floor, room; else the name of a room.
bool is_part_of_room(std::string_view element);
bool ends_in(const Phrase& phrase, const Phrase& end);
// The last word of the category is one that keeps things inside it, or that things hang on.
bool is_shelf_like(std::string_view category);
bool is_hanger_like(std::string_view category);

// How well an object's words fit an annotation's: 4 the same words, 3 another name of it, 2 a kind of it, 1 its head noun alone, 0 not.
class NounMatcher {
 public:
  explicit NounMatcher(const Catalog& catalog) : catalog_(catalog) {}
  int strength(const std::string& wanted, const std::string& text);
  // How narrow a noun is: the words it takes.
  int narrowness(const std::string& wanted);

 private:
  struct Noun {
    Phrase words, head;
    const CatalogEntry* entry = nullptr;
    bool whole = false;  // all its words together name the entry
  };
  const Noun& noun(const std::string& text);

  const Catalog& catalog_;
  std::map<std::string, Noun> nouns_;
  std::map<std::pair<std::string, std::string>, int> strengths_;
};

}  // namespace layoutbox::scoring
