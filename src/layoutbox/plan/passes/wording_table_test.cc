// Each row of catalog/words_wordings.json against its own example.
#include "layoutbox/plan/passes/wording_table.h"

#include <gtest/gtest.h>

#include <string>

#include "layoutbox/catalog/catalog.h"

namespace layoutbox::offline {
namespace {

std::string joined(const std::vector<Token>& tokens, const std::vector<bool>& skip) {
  std::string text;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (!skip[i]) text += (text.empty() ? "" : " ") + tokens[i].text;
  }
  return text;
}

TEST(WordingTable, EachRowReadsItsExampleAsItSays) {
  const Lexicon lexicon(Catalog::builtin());
  ASSERT_GT(wordings().size(), 30u);
  for (const Wording& row : wordings()) {
    std::vector<Token> tokens = tokenize(row.example);
    std::vector<bool> skip(tokens.size(), false);
    read_wording_table(lexicon, tokens, skip);
    const std::vector<Token> plain = tokenize(row.plain);
    EXPECT_EQ(joined(tokens, skip), joined(plain, std::vector<bool>(plain.size(), false))) << row.name << ": " << row.example;
    EXPECT_NE(row.example, row.plain) << row.name;
  }
}

TEST(WordingTable, PlainTextStaysAsItIs) {
  const Lexicon lexicon(Catalog::builtin());
  for (const std::string text : {"a kitchen with a double sink and a hob", "a rug with a lamp on it", "the left wall and the right wall",
                                 "a 3 seater sofa", "a chair from the shop"}) {
    std::vector<Token> tokens = tokenize(text);
    std::vector<bool> skip(tokens.size(), false);
    const std::string before = joined(tokens, skip);
    read_wording_table(lexicon, tokens, skip);
    EXPECT_EQ(joined(tokens, skip), before);
  }
}

}  // namespace
}  // namespace layoutbox::offline
