#include "layoutbox/catalog/room_size.h"

#include <gtest/gtest.h>

namespace layoutbox {
namespace {

struct RoomSizeCase {
  const char* text;
  const char* units;
  Size size;
};

class RoomSizes : public testing::TestWithParam<RoomSizeCase> {};

TEST_P(RoomSizes, AreRead) {
  const auto size = parse_room_size(GetParam().text, GetParam().units);
  ASSERT_TRUE(size) << size.error().message;
  EXPECT_EQ(size->width, GetParam().size.width);
  EXPECT_EQ(size->depth, GetParam().size.depth);
  EXPECT_EQ(size->height, GetParam().size.height);
}

INSTANTIATE_TEST_SUITE_P(
    Spellings, RoomSizes,
    testing::Values(RoomSizeCase{"4x3.2x3", "", {4000, 3200, 3000}}, RoomSizeCase{"4.0 × 3.2 × 3.0 m", "", {4000, 3200, 3000}},
                    RoomSizeCase{"4.0 * 3.2 * 3.0 m", "", {4000, 3200, 3000}}, RoomSizeCase{"4m x 3.2m", "", {4000, 3200, 0}},
                    RoomSizeCase{"4mx3.2mx2.5m", "", {4000, 3200, 2500}}, RoomSizeCase{"400 by 320 cm", "", {4000, 3200, 0}},
                    RoomSizeCase{"400x320", "cm", {4000, 3200, 0}}, RoomSizeCase{"4000 X 3200 mm", "", {4000, 3200, 0}},
                    RoomSizeCase{"12'6\" x 10'", "", {3810, 3048, 0}}, RoomSizeCase{"10ft x 10 feet x 8 ft", "", {3048, 3048, 2438}},
                    RoomSizeCase{"4,5 x 3,25 m", "", {4500, 3250, 0}}, RoomSizeCase{"4, 3.2, 3", "", {4000, 3200, 3000}},
                    RoomSizeCase{"(4 x 2 x 3 meters)", "", {4000, 2000, 3000}}, RoomSizeCase{"4 m × 320 cm", "mm", {4000, 3200, 0}}));

TEST(RoomSize, WrongTextIsAnError) {
  for (const char* text : {"", "big", "4", "4x", "4x3x2x1", "4x3.2.1", "x", "4--3x2"}) {
    const auto size = parse_room_size(text);
    ASSERT_FALSE(size) << text;
    EXPECT_EQ(size.error().code, ErrorCode::kParse) << text;
    EXPECT_FALSE(size.error().hint.empty()) << text;
  }
  EXPECT_EQ(parse_room_size("4 furlongs x 3").error().code, ErrorCode::kUsage);
  EXPECT_EQ(parse_room_size("4x3", "furlong").error().code, ErrorCode::kUsage);
}

TEST(RoomSize, ImpossibleRoomsAreErrors) {
  for (const char* text : {"0x3", "10000x3", "4x-3", "4x3x0", "4x3x80"}) {
    const auto size = parse_room_size(text);
    ASSERT_FALSE(size) << text;
    EXPECT_EQ(size.error().code, ErrorCode::kGeometry) << text;
  }
}

}  // namespace
}  // namespace layoutbox
