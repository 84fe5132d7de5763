// What fills an empty middle of a room, and what hangs below mirrors.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "layoutbox/dress/dress.h"
#include "layoutbox/dress/test_dressed_room.h"

namespace layoutbox {
namespace {

using ::testing::Contains;
using ::testing::Not;

TEST(DressMiddle, ARugLiesInAnEmptyMiddle) {
  DressedRoom room("kids_room", 4, 3.6);
  room.put("desk", 0.6, 3.3, 0).put("wardrobe", 3.4, 3.3, 0);
  EXPECT_THAT(room.dress(), Contains("rug"));
  ASSERT_EQ(room.of("rug").size(), 1u);
  EXPECT_NEAR(room.of("rug")[0].position[0], 2000, 700);
  EXPECT_NEAR(room.of("rug")[0].position[1], 1800, 700);
}

TEST(DressMiddle, NoRugWhereTheMiddleIsTakenOrSomebodyRolls) {
  DressedRoom taken("kids_room", 4, 3.6);
  taken.put("table", 2, 1.8, 0);
  EXPECT_THAT(taken.dress(), Not(Contains("rug")));
  DressedRoom rolls("study", 4, 3.6, "A study for my wheelchair with a desk.");
  rolls.put("desk", 0.6, 3.3, 0);
  EXPECT_THAT(rolls.dress(), Not(Contains("rug")));
}

TEST(DressMiddle, ALedgeIsBelowEachMirrorOfABarber) {
  DressedRoom room("barbershop", 5, 4);
  room.hang("mirror", 1.5, 3.98, 1.15, 0, "wall3").hang("mirror", 3, 3.98, 1.15, 0, "wall3");
  room.dress();
  EXPECT_EQ(room.of("wall_shelf").size(), 2u);
}

}  // namespace
}  // namespace layoutbox
