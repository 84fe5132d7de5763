#include "layoutbox/plan/words/word_sets.h"

#include <array>
#include <unordered_set>

#include "layoutbox/catalog/word_lists.h"

namespace layoutbox::offline {
namespace {

constexpr std::array kWordSetKeys = {
#define LAYOUTBOX_WORD_SET(name, key) std::string_view(key),
#include "layoutbox/plan/words/word_sets.inc"
#undef LAYOUTBOX_WORD_SET
};

using SetOfWords = std::unordered_set<std::string_view>;

// The words of that set, and of those that it names ("@sofas").
void read_set(const WordList& sets, std::string_view key, SetOfWords& words) {
  for (const WordList::Member word : sets.at(key).at("words")) {
    if (word.value.text().starts_with('@'))
      read_set(sets, word.value.text().substr(1), words);
    else
      words.insert(word.value.text());
  }
}

const std::array<SetOfWords, kWordSetKeys.size()>& word_sets() {
  static const auto all = [] {
    std::array<SetOfWords, kWordSetKeys.size()> read;
    const WordList sets = word_list("words_sets").at("sets");
    for (std::size_t i = 0; i < kWordSetKeys.size(); ++i) read_set(sets, kWordSetKeys.at(i), read.at(i));
    return read;
  }();
  return all;
}

}  // namespace

std::string_view word_of(WordSet set, std::string_view word) {
  const SetOfWords& words = word_sets().at(static_cast<std::size_t>(set));
  const auto found = words.find(word);
  return found == words.end() ? std::string_view() : *found;
}

}  // namespace layoutbox::offline
