// Rooms with walls that run along neither x nor y: what belongs at a wall stands flush with it, turned as it is.
#include <cmath>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

std::vector<Point> regular(int sides, double radius, double first_deg) {
  std::vector<Point> polygon;
  double low_x = 1e9, low_y = 1e9;
  for (const bool measure : {true, false}) {
    for (int k = 0; k < sides; ++k) {
      const double a = (first_deg + 360.0 * k / sides) * kPi / 180, x = radius * std::cos(a), y = radius * std::sin(a);
      if (measure) low_x = std::min(low_x, x), low_y = std::min(low_y, y);
      if (!measure) polygon.push_back({static_cast<Mm>(std::lround(x - low_x)), static_cast<Mm>(std::lround(y - low_y))});
    }
  }
  return polygon;
}

const std::vector<Point> kCutCorner{{0, 0}, {5000, 0}, {5000, 2600}, {3400, 4000}, {0, 4000}};

std::vector<std::array<double, 2>> corners_of(const PlacedObject& o) {
  const double a = o.rotation_deg * kPi / 180;
  std::vector<std::array<double, 2>> corners;
  for (const auto& [x, y] : {std::pair{-0.5, -0.5}, std::pair{0.5, -0.5}, std::pair{0.5, 0.5}, std::pair{-0.5, 0.5}}) {
    const double dx = x * o.size.width, dy = y * o.size.depth;
    corners.push_back({o.position[0] + dx * std::cos(a) - dy * std::sin(a), o.position[1] + dx * std::sin(a) + dy * std::cos(a)});
  }
  return corners;
}

// How far the corners are before the wall's line at least and, of the two at the back, at most.
std::pair<double, double> off_wall(const PlacedObject& o, const Wall& wall) {
  const double dx = wall.end.x - wall.start.x, dy = wall.end.y - wall.start.y, length = std::hypot(dx, dy);
  std::vector<double> off;
  for (const auto& c : corners_of(o)) off.push_back((dx * (c[1] - wall.start.y) - dy * (c[0] - wall.start.x)) / length);
  return {*std::min_element(off.begin(), off.end()), std::max(off[2], off[3])};
}

void expect_inside(const Layout& layout) {
  for (const PlacedObject& o : layout.objects) {
    for (const Wall& wall : layout.room.walls) EXPECT_GT(off_wall(o, wall).first, -2) << o.id << " is behind " << wall.id;
    for (const PlacedObject& other : layout.objects) {
      if (&other == &o) continue;
      EXPECT_FALSE(bodies_meet(o, other)) << o.id << " meets " << other.id;
    }
  }
}

void expect_flush(const Layout& layout, const std::string& id, const std::string& wall) {
  const PlacedObject* o = layout.find_object(id);
  ASSERT_NE(o, nullptr);
  const auto [least, back] = off_wall(*o, *layout.find_wall(wall));
  EXPECT_GT(least, -1) << id;
  EXPECT_LT(back, 21) << id << " is not flush with " << wall;
}

Layout solved(const SceneMaker& maker, std::uint64_t seed = 1) {
  SolveOptions options;
  options.seed = seed;
  const auto layout = solve(maker.make(), Catalog::builtin(), options);
  EXPECT_TRUE(layout) << layout.error().message;
  if (!layout) return {};
  EXPECT_EQ(layout->status, LayoutStatus::kSolved);
  expect_inside(*layout);
  return *layout;
}

TEST(Slanted, AHexagonIsFurnishedAtItsWalls) {
  SceneMaker maker(regular(6, 3000, 240));
  maker.add("double_bed").add("nightstand", 2).add("wardrobe").add("desk").add("chair").add("dresser");
  maker.relate("againstWall", {"double_bed_1"}, {"wall2"}).relate("againstWall", {"wardrobe_1"}, {"wall3"});
  maker.relate("centeredOnWall", {"dresser_1"}, {"wall5"}).relate("againstWall", {"desk_1"}, {"wall6"});
  maker.relate("leftOf", {"nightstand_1"}, {"double_bed_1"}).relate("rightOf", {"nightstand_2"}, {"double_bed_1"});
  maker.relate("inFrontOf", {"chair_1"}, {"desk_1"}).relate("facing", {"chair_1"}, {"desk_1"});
  const Layout layout = solved(maker);
  for (const auto& [id, wall] : {std::pair{"double_bed_1", "wall2"}, std::pair{"wardrobe_1", "wall3"}, std::pair{"dresser_1", "wall5"},
                                 std::pair{"desk_1", "wall6"}}) {
    expect_flush(layout, id, wall);
  }
  // Beside the bed means beside it as it stands: their backs in one line, or at least turned by quarters against it.
  const double bed = layout.find_object("double_bed_1")->rotation_deg;
  for (const char* id : {"nightstand_1", "nightstand_2"})
    EXPECT_LT(std::abs(std::remainder(layout.find_object(id)->rotation_deg - bed, 90)), 0.01) << id;
}

TEST(Slanted, OneWallAtAnAngle) {
  SceneMaker maker(kCutCorner);
  maker.add("desk").add("chair").add("bookshelf").add("armchair");
  maker.relate("againstWall", {"desk_1"}, {"wall3"});
  const Layout layout = solved(maker);
  expect_flush(layout, "desk_1", "wall3");
}

TEST(Slanted, ARoundRoomOfEightWallsWithoutAnyWordOfWalls) {
  SceneMaker maker(regular(8, 2800, 247.5));
  maker.add("double_bed").add("wardrobe").add("desk").add("dresser").add("bookshelf").add("sideboard");
  const Layout layout = solved(maker);
  int flush = 0;
  for (const PlacedObject& o : layout.objects) {
    flush += std::any_of(layout.room.walls.begin(), layout.room.walls.end(), [&](const Wall& w) { return off_wall(o, w).second < 21; });
  }
  EXPECT_EQ(flush, 6);  // all six stand with their backs to walls, of which only four are straight
}

TEST(Slanted, PicturesHangOnThem) {
  SceneMaker maker(kCutCorner);
  maker.add("picture").relate("onWall", {"picture_1"}, {"wall3"});
  const Layout layout = solved(maker);
  expect_flush(layout, "picture_1", "wall3");
  EXPECT_EQ(layout.find_object("picture_1")->supported_by, "wall3");
}

// A door there opens over the floor before it, not over the upright box around that.
TEST(Slanted, BesideADoorInThem) {
  SceneMaker maker(kCutCorner);
  maker.opening(OpeningType::kDoor, "wall3", 613).add("chest").sized(600, 600, 600).at(3150, 2300, 0, 0, true);
  const Layout beside_swing = solved(maker);
  EXPECT_NE(beside_swing.find_object("chest_1"), nullptr);

  SceneMaker same_wall(kCutCorner);
  same_wall.opening(OpeningType::kDoor, "wall3", 100).add("bookshelf").sized(900, 300, 1800);
  same_wall.relate("againstWall", {"bookshelf_1"}, {"wall3"});
  expect_flush(solved(same_wall), "bookshelf_1", "wall3");
}

// What has no front lies along or across the wall it is told to stand at.
TEST(Slanted, TablesStandFlushToo) {
  SceneMaker maker(kCutCorner);
  maker.add("table").add("bookshelf").relate("againstWall", {"table_1"}, {"wall3"});
  const Layout layout = solved(maker);
  const PlacedObject& table = *layout.find_object("table_1");
  const Wall& wall = *layout.find_wall("wall3");
  std::vector<double> off;
  const double dx = wall.end.x - wall.start.x, dy = wall.end.y - wall.start.y, length = std::hypot(dx, dy);
  for (const auto& c : corners_of(table)) off.push_back((dx * (c[1] - wall.start.y) - dy * (c[0] - wall.start.x)) / length);
  std::sort(off.begin(), off.end());
  EXPECT_LT(off[1], 21) << "two corners are at the wall";
}

// Many walls leave room among the states for sizes other than the usual.
TEST(Slanted, ThingsGetSmallerInRoundRoomsToo) {
  SceneMaker maker(regular(24, 2800, 262.5));
  maker.add("dresser").relate("centeredOnWall", {"dresser_1"}, {"wall14"});
  const Layout layout = solved(maker);
  expect_flush(layout, "dresser_1", "wall14");
}

TEST(Slanted, ARoomThatIsNotConvex) {
  // An L whose inner corner is cut off.
  SceneMaker maker(std::vector<Point>{{0, 0}, {6000, 0}, {6000, 2500}, {3500, 2500}, {2500, 3500}, {2500, 6000}, {0, 6000}});
  maker.add("sofa").add("bookshelf").add("desk").add("chair").add("dresser");
  maker.relate("againstWall", {"bookshelf_1"}, {"wall4"});
  const auto layout = solve(maker.make(), Catalog::builtin(), {});
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->status, LayoutStatus::kSolved);
  expect_flush(*layout, "bookshelf_1", "wall4");
  for (const PlacedObject& o : layout->objects) {
    for (const auto& c : corners_of(o)) {  // before the cut corner, or past its ends
      const double beyond = c[0] + c[1] - 6000;
      EXPECT_FALSE(beyond > 2 && c[0] > 2502 && c[1] > 2502) << o.id;
      EXPECT_FALSE(c[0] > 3502 && c[1] > 2502) << o.id;
      EXPECT_FALSE(c[0] > 2502 && c[1] > 3502) << o.id;
    }
  }
}

// The floor behind the slanted wall is none of the room's.
TEST(Slanted, TooMuchIsTooMuchForThePolygon) {
  const auto layout = solve(SceneMaker(kCutCorner).add("bed", 9).add("sofa", 9).make(true), Catalog::builtin());
  ASSERT_TRUE(layout) << layout.error().message;
  ASSERT_FALSE(layout->conflicts.empty());
  const std::string& sentence = layout->conflicts[0].sentence;
  for (const char* part : {"need at least", "the room has 18.9 m²", "m² less", "without"})
    EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
}

}  // namespace
}  // namespace layoutbox::placement
