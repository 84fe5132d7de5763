#include "layoutbox/base/words.h"

#include <gmock/gmock.h>

namespace layoutbox {
namespace {

using testing::Contains;
using testing::ElementsAre;

TEST(Words, AreSplitAtSeparators) {
  EXPECT_THAT(words_of(" Book-Shelf_2, café!"), ElementsAre("book", "shelf", "2", "café"));
  EXPECT_THAT(words_of("women's"), ElementsAre("womens"));
  EXPECT_THAT(words_of(""), ElementsAre());
}

TEST(Words, HaveKeysAndSnakeCase) {
  EXPECT_EQ(key_of("Book Shelf"), key_of("book_shelf"));
  EXPECT_EQ(key_of("Bookshelf"), key_of("book-shelf"));
  EXPECT_EQ(snake_case("Dining Table"), "dining_table");
}

TEST(Words, AreCounted) {
  EXPECT_EQ(counted(0, "relation"), "0 relations");
  EXPECT_EQ(counted(1, "relation"), "1 relation");
  EXPECT_EQ(counted(2, "relation"), "2 relations");
  EXPECT_EQ(counted(2, "box", "boxes"), "2 boxes");
}

TEST(Words, PluralsHaveTheirSingular) {
  EXPECT_THAT(singular_forms("shelves"), Contains("shelf"));
  EXPECT_THAT(singular_forms("knives"), Contains("knife"));
  EXPECT_THAT(singular_forms("stoves"), Contains("stove"));
  EXPECT_THAT(singular_forms("couches"), Contains("couch"));
  EXPECT_THAT(singular_forms("vases"), Contains("vase"));
  EXPECT_THAT(singular_forms("trolleys"), Contains("trolley"));
  EXPECT_THAT(singular_forms("canopies"), Contains("canopy"));
  EXPECT_THAT(singular_forms("glass"), ElementsAre("glass"));
  EXPECT_EQ(singular_forms("drawers").front(), "drawers");
}

TEST(Words, CandidateKeysTurnTheHeadNoun) {
  EXPECT_THAT(candidate_keys(words_of("chests of drawers")), Contains("chestofdrawers"));
  EXPECT_THAT(candidate_keys(words_of("floor lamps")), Contains("floorlamp"));
}

TEST(Words, TheNearestIsFoundOrNone) {
  const std::vector<std::string> known{"furniture", "constraints", "room", "materials"};
  EXPECT_EQ(nearest_word("furnitur", known), "furniture");
  EXPECT_EQ(nearest_word("matreials", known), "materials");
  EXPECT_EQ(nearest_word("rooom", known), "room");
  EXPECT_EQ(nearest_word("lamp", known), "");
  EXPECT_EQ(nearest_word("", known), "");
}

}  // namespace
}  // namespace layoutbox
