#include "layoutbox/plan/words/american_spelling.h"

#include <string_view>
#include <unordered_map>

#include "layoutbox/catalog/word_lists.h"

namespace layoutbox::offline {

std::string american_spelling(std::string word) {
  using Spellings = std::unordered_map<std::string_view, std::string_view>;
  static const Spellings spellings = [] {
    Spellings read;
    for (const WordList::Member spelling : word_list("words_grammar").at("american")) read.emplace(spelling.key, spelling.value.text());
    return read;
  }();
  const auto twin = spellings.find(word);
  return twin == spellings.end() ? word : std::string(twin->second);
}

}  // namespace layoutbox::offline
