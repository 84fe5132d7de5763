#include "layoutbox/solve/search/taken_cells.h"

#include <gtest/gtest.h>

#include "layoutbox/base/random.h"

namespace layoutbox::placement {
namespace {

// Over rows of all lengths about the words that the bits stand in, against every cell looked at by itself.
TEST(TakenCells, FindsTheCellsThatNoBoxHolds) {
  constexpr std::uint64_t kSeed = 7;
  SCOPED_TRACE(kSeed);
  Random random(kSeed);
  for (const std::size_t count : {1U, 2U, 63U, 64U, 65U, 130U}) {
    std::vector<Mm> xs, ys{0, 10, 20};
    for (std::size_t i = 0; i < count; ++i) xs.push_back(static_cast<Mm>(10 * i));
    TakenCells taken;
    taken.start(xs, ys);
    std::vector<std::pair<Vec3, Vec3>> boxes;
    for (int k = 0; k < 4; ++k) {
      const Mm x = static_cast<Mm>(random.below(static_cast<std::int64_t>(10 * count))), y = static_cast<Mm>(random.below(30));
      boxes.push_back({{x - 35, y - 12, 0}, {x + 140, y + 12, 1}});
      taken.add(boxes.back().first, boxes.back().second);
    }
    for (std::size_t y = 0; y < ys.size(); ++y) {
      std::vector<std::size_t> found, free;
      for (std::size_t x = taken.next_free(y, 0); x < count; x = taken.next_free(y, x + 1)) found.push_back(x);
      for (std::size_t x = 0; x < count; ++x) {
        bool held = false;
        for (const auto& [lo, hi] : boxes) held |= lo[0] < xs[x] && xs[x] < hi[0] && lo[1] < ys[y] && ys[y] < hi[1];
        if (!held) free.push_back(x);
      }
      EXPECT_EQ(found, free) << count << " cells, row " << y;
    }
  }
}

}  // namespace
}  // namespace layoutbox::placement
