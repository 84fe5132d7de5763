// The sets of catalog/words_sets.json against their names in the code.
#include "layoutbox/plan/words/word_sets.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "layoutbox/catalog/word_lists.h"

namespace layoutbox::offline {
namespace {

const std::set<std::string, std::less<>>& keys_in_code() {
  static const std::set<std::string, std::less<>> keys = {
#define LAYOUTBOX_WORD_SET(name, key) key,
#include "layoutbox/plan/words/word_sets.inc"
#undef LAYOUTBOX_WORD_SET
  };
  return keys;
}

void words_with(const WordList& sets, std::string_view key, std::multiset<std::string>& words) {
  for (const WordList::Member word : sets.at(key).at("words")) {
    if (word.value.text().starts_with('@'))
      words_with(sets, word.value.text().substr(1), words);
    else
      words.emplace(word.value.text());
  }
}

TEST(WordSets, EachStandsInTheDataAndEachOfTheDataIsAskedFor) {
  const WordList sets = word_list("words_sets").at("sets");
  for (const std::string& key : keys_in_code()) EXPECT_TRUE(sets.contains(key)) << key;
  std::set<std::string, std::less<>> asked = keys_in_code();
  for (const WordList::Member set : sets) {
    for (const WordList::Member word : set.value.at("words")) {
      if (!word.value.text().starts_with('@')) continue;
      const std::string_view other = word.value.text().substr(1);
      EXPECT_TRUE(sets.contains(other)) << set.key << " takes in " << other;
      asked.emplace(other);
    }
  }
  for (const WordList::Member set : sets) EXPECT_TRUE(asked.contains(set.key)) << set.key << " is asked for by nothing";
}

TEST(WordSets, EachSaysWhatItIsAndHasNoWordTwice) {
  const WordList sets = word_list("words_sets").at("sets");
  for (const WordList::Member set : sets) {
    EXPECT_TRUE(set.value.contains("is")) << set.key;
    std::multiset<std::string> words;
    words_with(sets, set.key, words);
    EXPECT_GT(words.size(), 1u) << set.key;
    for (const std::string& word : words) EXPECT_EQ(words.count(word), 1u) << set.key << ": " << word;
  }
}

TEST(WordSets, HasTheWordsOfTheSetsThatItTakesIn) {
  EXPECT_TRUE(one_of("sofa", WordSet::kLainOn));
  EXPECT_TRUE(one_of("crib", WordSet::kLainOn));
  EXPECT_FALSE(one_of("crib", WordSet::kSofas));
  EXPECT_FALSE(one_of("@sofas", WordSet::kLainOn));
}

}  // namespace
}  // namespace layoutbox::offline
