#include "layoutbox/base/id.h"

#include <gtest/gtest.h>

#include <concepts>
#include <string>
#include <type_traits>

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

}  // namespace
}  // namespace layoutbox
