// From which corner the picture is taken.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "layoutbox/render/render.h"

namespace layoutbox {
namespace {

Layout room_with(std::vector<PlacedObject> objects) {
  Layout layout;
  layout.room.polygon = {{0, 0}, {4000, 0}, {4000, 3000}, {0, 3000}};
  layout.room.height = 2500;
  layout.objects = std::move(objects);
  return layout;
}

PlacedObject thing(Size size, double x, double y, double rotation, std::vector<Side> used = {Side::kFront}) {
  PlacedObject object;
  object.size = size, object.position = {x, y, 0}, object.rotation_deg = rotation, object.used_sides = std::move(used);
  return object;
}

const std::vector<Side> kAllSides{Side::kFront, Side::kBack, Side::kLeft, Side::kRight};

TEST(BestCorner, AnEmptyRoomIsSeenFromTheUsualOne) { EXPECT_EQ(best_corner(room_with({}), Catalog::builtin()), Corner::kSouthEast); }

TEST(BestCorner, IsWhereTheFrontsAreSeen) {
  const Size wardrobe{1800, 600, 2200};
  // Backs to the back and the left wall: from the front right. To the front and right wall: from the back left.
  EXPECT_EQ(best_corner(room_with({thing(wardrobe, 2000, 2700, 0), thing(wardrobe, 300, 1500, 90)}), Catalog::builtin()),
            Corner::kSouthEast);
  EXPECT_EQ(best_corner(room_with({thing(wardrobe, 2000, 300, 180), thing(wardrobe, 3700, 1500, 270)}), Catalog::builtin()),
            Corner::kNorthWest);
  EXPECT_EQ(best_corner(room_with({thing(wardrobe, 2000, 2700, 0), thing(wardrobe, 3700, 1500, 270)}), Catalog::builtin()),
            Corner::kSouthWest);
}

TEST(BestCorner, IsWhereNothingTallHides) {
  // A shelf without a front at the right front corner, low things behind it.
  EXPECT_EQ(best_corner(room_with({thing({1200, 1200, 2400}, 3300, 700, 0, {}), thing({700, 500, 400}, 2500, 1600, 0, kAllSides),
                                   thing({400, 400, 400}, 2400, 700, 0, kAllSides), thing({400, 400, 400}, 3300, 1500, 0, kAllSides)}),
                        Catalog::builtin()),
            Corner::kNorthWest);
}

TEST(BestCorner, ShowsAWallOfItsOwnLook) {
  Layout layout = room_with({});
  Wall front, back;
  front.start = {0, 0}, front.end = {4000, 0};
  back.start = {4000, 3000}, back.end = {0, 3000};
  layout.room.walls = {front, back};
  layout.room.walls[0].material = "exposed brick";
  EXPECT_EQ(best_corner(layout, Catalog::builtin()), Corner::kNorthEast);
  std::swap(layout.room.walls[0].material, layout.room.walls[1].material);
  EXPECT_EQ(best_corner(layout, Catalog::builtin()), Corner::kSouthEast);
  layout.room.walls[0].material = layout.room.walls[1].material = layout.room.wall_material = "plaster";
  EXPECT_EQ(best_corner(layout, Catalog::builtin()), Corner::kSouthEast);
}

TEST(BestCorner, ShowsWhatHangsOnWalls) {
  PlacedObject poster = thing({500, 20, 700}, 2000, 30, 180, {});
  poster.mount = Mount::kWall;
  PlacedObject bed = thing({900, 2000, 500}, 600, 1900, 0, kAllSides);
  EXPECT_EQ(best_corner(room_with({bed, poster}), Catalog::builtin()), Corner::kNorthEast);
  poster.origin = Origin::kAdded;
  EXPECT_EQ(best_corner(room_with({bed, poster}), Catalog::builtin()), Corner::kSouthEast);
}

TEST(BestCorner, OneThatIsNamedHolds) {
  const Layout layout = room_with({thing({1800, 600, 2200}, 2000, 300, 180)});
  RenderOptions options;
  EXPECT_NE(azimuth_from(layout, Catalog::builtin(), options), 45);
  options.corner = Corner::kSouthEast;
  EXPECT_EQ(azimuth_from(layout, Catalog::builtin(), options), 45);
  options.corner = Corner::kNorthWest;
  EXPECT_EQ(azimuth_from(layout, Catalog::builtin(), options), 225);
  options.azimuth_deg = 30;
  EXPECT_EQ(azimuth_from(layout, Catalog::builtin(), options), 30);
  for (const Corner corner : {Corner::kBest, Corner::kNorthEast, Corner::kNorthWest, Corner::kSouthEast, Corner::kSouthWest}) {
    EXPECT_EQ(corner_from_name(name_of(corner)), corner);
    std::string small(name_of(corner));
    std::ranges::transform(small, small.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    EXPECT_EQ(corner_from_name(small), corner);
  }
}

}  // namespace
}  // namespace layoutbox
