#include "layoutbox/base/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace layoutbox {
namespace {

// The first numbers of the reference implementation (S. Vigna, splitmix64.c) from the state 1234567.
TEST(Random, IsSplitMix) {
  Random random(1234567);
  for (const std::uint64_t number : {6457827717110365317u, 3203168211198807973u, 9817491932198370423u}) EXPECT_EQ(random.next(), number);
}

// With a remainder alone the lower half of 3 · 2^62 would be drawn twice as often as the rest.
TEST(Random, PrefersNoNumberBelowItsBound) {
  Random random(1);
  constexpr std::uint64_t kBound = 3ULL << 62;
  std::array<int, 3> thirds{};
  for (int i = 0; i < 30'000; ++i) {
    const std::uint64_t number = random.below(kBound);
    ASSERT_LT(number, kBound);
    ++thirds[number >> 62];
  }
  for (const int third : thirds) EXPECT_NEAR(third, 10'000, 500);
}

TEST(Random, FractionsAreOfTheUnitInterval) {
  Random random(2);
  double sum = 0;
  for (int i = 0; i < 10'000; ++i) {
    const double share = random.fraction();
    ASSERT_TRUE(share >= 0 && share < 1) << share;
    sum += share;
  }
  EXPECT_NEAR(sum / 10'000, 0.5, 0.02);
}

TEST(Random, ShufflesIntoEveryOrder) {
  Random random(3);
  std::vector<int> items{0, 1, 2};
  std::array<int, 9> seen{};
  for (int i = 0; i < 6'000; ++i) {
    random.shuffle(items);
    ++seen[static_cast<std::size_t>(items[0] * 3 + items[1])];
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 0), 3);  // the three pairs of a number with itself
  for (const int times : seen) EXPECT_TRUE(times == 0 || (times > 850 && times < 1'150)) << times;
}

}  // namespace
}  // namespace layoutbox
