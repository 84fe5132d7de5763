#include "layoutbox/base/id.h"

#include <gtest/gtest.h>

#include <concepts>
#include <string>
#include <type_traits>
#include <vector>

namespace layoutbox {
namespace {

using Apple = Id<struct AppleTag>;
using Pear = Id<struct PearTag>;
using Apples = ById<Apple, std::string>;

template <typename List, typename Key>
concept AskedBy = requires(const List& list, Key key) { list[key]; };

template <typename A, typename B>
concept Comparable = requires(A a, B b) { a == b; };

// What is mixed up does not compile.
static_assert(!std::is_convertible_v<int, Apple> && !std::is_convertible_v<Apple, int> && !std::is_constructible_v<Apple, Pear>);
static_assert(AskedBy<Apples, Apple> && !AskedBy<Apples, Pear> && !AskedBy<Apples, int> && !AskedBy<Apples, std::size_t>);
static_assert(Comparable<Apple, Apple> && !Comparable<Apple, Pear> && !Comparable<Apple, int>);

TEST(Ids, OfNothingAreInNoList) {
  const Apples apples(2, "green");
  EXPECT_FALSE(Apple().exists());
  EXPECT_FALSE(apples.has(Apple()));
  EXPECT_FALSE(apples.has(Apple(2)));
  EXPECT_TRUE(apples.has(Apple(1)));
}

TEST(Ids, ListsAreAskedByThem) {
  Apples apples;
  const Apple red = apples.push_back("red"), green = apples.push_back("green");
  EXPECT_EQ(apples[green], "green");
  EXPECT_EQ(apples.id_of(apples[red]), red);
  EXPECT_EQ(apples.next(green), red);
  int count = 0;
  for (const Apple id : apples.ids()) EXPECT_EQ(id.number(), count++);
  EXPECT_EQ(count, 2);
}

TEST(Ids, ListsGoOnAfterOneAndUpToOne) {
  const ById<Apple, int> apples(4, 0);
  std::vector<int> before, after;
  for (const Apple id : ids_before(Apple(2))) before.push_back(id.number());
  for (const Apple id : apples.ids_after(Apple(2))) after.push_back(id.number());
  EXPECT_EQ(before, (std::vector{0, 1}));
  EXPECT_EQ(after, std::vector{3});
  EXPECT_EQ(apples.ids_after(Apple(3)).begin(), apples.ids().end());
}

TEST(Ids, AreAsSmallAsTheyAreToldToBe) {
  using Plum = Id<struct PlumTag, std::int16_t>;
  static_assert(sizeof(Plum) == sizeof(std::int16_t));
  EXPECT_FALSE(Plum().exists());
  EXPECT_EQ(Plum(500).number(), 500);
}

}  // namespace
}  // namespace layoutbox
