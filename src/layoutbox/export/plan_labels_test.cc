// What stands on a floor plan can be read: labels, numbers, dimension lines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <regex>
#include <set>

#include "layoutbox/base/units.h"
#include "layoutbox/export/export.h"
#include "layoutbox/export/plan_ink.h"

namespace layoutbox {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Layout room_with(const std::vector<Point>& corners) {
  Layout layout;
  layout.room.height = 2600;
  layout.room.polygon = corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Wall wall;
    wall.id = "wall" + std::to_string(i + 1);
    wall.start = corners[i];
    wall.end = corners[(i + 1) % corners.size()];
    layout.room.walls.push_back(wall);
  }
  return layout;
}

PlacedObject& add(Layout& layout, std::string category, Size size, double x, double y, double z = 0) {
  PlacedObject object;
  object.id = category + "_" + std::to_string(layout.objects.size() + 1);
  object.category = std::move(category);
  object.size = size;
  object.position = {x, y, z};
  object.supported_by = "floor";
  layout.objects.push_back(std::move(object));
  return layout.objects.back();
}

// A dining table laid for six, a sideboard full of small things, a lamp over it all, pictures and a rug.
Layout laid_table() {
  Layout layout = room_with({{0, 0}, {4200, 0}, {4200, 3600}, {0, 3600}});
  add(layout, "rug", {2400, 1800, 10}, 2100, 1800);
  add(layout, "dining_table", {1800, 900, 750}, 2100, 1800);
  for (int i = 0; i < 6; ++i) {
    const double x = 1500 + 600 * (i % 3), side = i < 3 ? -1 : 1;
    add(layout, "chair", {450, 480, 900}, x, 1800 + side * 500).rotation_deg = i < 3 ? 180 : 0;
    add(layout, "plate", {260, 260, 20}, x, 1800 + side * 280, 750).supported_by = "dining_table_2";
    add(layout, "glass", {75, 75, 120}, x + 170, 1800 + side * 330, 750).supported_by = "dining_table_2";
  }
  add(layout, "chandelier", {750, 750, 600}, 2100, 1800, 2000).mount = Mount::kCeiling;
  add(layout, "sideboard", {1500, 420, 800}, 1000, 3390);
  for (int i = 0; i < 4; ++i) add(layout, "vase", {140, 140, 300}, 500 + 300 * i, 3390, 800).supported_by = "sideboard_22";
  for (int i = 0; i < 2; ++i) add(layout, "picture", {700, 40, 500}, 800 + 800 * i, 3580, 1500).mount = Mount::kWall;
  return layout;
}

struct DrawnText {
  std::string words;
  double x0, y0, x1, y1;
};

std::vector<DrawnText> texts_of(const std::string& svg) {
  static const std::regex text(R"re(<text x="([0-9.-]+)" y="([0-9.-]+)" font-size="([0-9.]+)" text-anchor="([a-z]+)"([^>]*)>([^<]*)<)re");
  std::vector<DrawnText> out;
  for (std::sregex_iterator it(svg.begin(), svg.end(), text), end; it != end; ++it) {
    const std::smatch& m = *it;
    const double x = std::stod(m[1]), y = std::stod(m[2]), size = std::stod(m[3]), width = text_width(m[6].str(), size);
    const double left = m[4] == "start" ? 0 : m[4] == "middle" ? -width / 2 : -width, up = -0.7 * size;
    if (m[5].str().find("rotate(-90") != std::string::npos) {
      out.push_back({m[6], x + up, y + left, x, y + left + width});
    } else {
      out.push_back({m[6], x + left, y + up, x + left + width, y});
    }
  }
  return out;
}

// The lines from numbers to their objects: from and to.
std::vector<std::array<double, 4>> leaders_of(const std::string& svg) {
  static const std::regex line(
      R"re(<polyline points="([0-9.]+),([0-9.]+) ([0-9.]+),([0-9.]+)" fill="none" stroke="#555" stroke-width="0.15")re");
  std::vector<std::array<double, 4>> out;
  for (std::sregex_iterator it(svg.begin(), svg.end(), line), end; it != end; ++it) {
    out.push_back({std::stod((*it)[1]), std::stod((*it)[2]), std::stod((*it)[3]), std::stod((*it)[4])});
  }
  return out;
}

TEST(PlanLabels, NoTwoTextsOverlapAndNoLineCrossesOne) {
  const std::string svg = write_floor_plan_svg(laid_table(), Catalog::builtin());
  const std::vector<DrawnText> texts = texts_of(svg);
  ASSERT_GT(texts.size(), 25U);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const bool apart =
          texts[i].x1 <= texts[k].x0 || texts[k].x1 <= texts[i].x0 || texts[i].y1 <= texts[k].y0 || texts[k].y1 <= texts[i].y0;
      EXPECT_TRUE(apart) << texts[i].words << " over " << texts[k].words;
    }
  }
  const auto leaders = leaders_of(svg);
  ASSERT_GT(leaders.size(), 5U);
  for (const auto& [xa, ya, xb, yb] : leaders) {
    EXPECT_LT(std::hypot(xb - xa, yb - ya), 12) << "numbers are close to what they name";
    for (int i = 0; i <= 20; ++i) {
      const double x = xa + (xb - xa) * i / 20, y = ya + (yb - ya) * i / 20;
      for (const DrawnText& text : texts)
        EXPECT_FALSE(x > text.x0 && x < text.x1 && y > text.y0 && y < text.y1) << "through " << text.words;
    }
  }
}

TEST(PlanLabels, WhatHasNoRoomForItsNameIsInTheKeyOnce) {
  const std::string svg = write_floor_plan_svg(laid_table(), Catalog::builtin());
  EXPECT_THAT(svg, HasSubstr(">6 × glass</text>"));
  EXPECT_THAT(svg, HasSubstr(">7.5 × 7.5</text>"));
  EXPECT_THAT(svg, HasSubstr(">chandelier</text>"));
  FloorPlanOptions without_sizes;
  without_sizes.sizes = false;
  EXPECT_THAT(write_floor_plan_svg(laid_table(), Catalog::builtin(), without_sizes), Not(HasSubstr(">7.5 × 7.5</text>")));
}

TEST(PlanLabels, EqualThingsAreLabelledAlike) {
  const std::string svg = write_floor_plan_svg(laid_table(), Catalog::builtin());
  std::set<std::string> sizes;
  int chairs = 0;
  static const std::regex chair(R"re(font-size="([0-9.]+)"[^>]*>chair<)re");
  for (std::sregex_iterator it(svg.begin(), svg.end(), chair), end; it != end; ++it, ++chairs) sizes.insert((*it)[1]);
  EXPECT_EQ(chairs, 6);
  EXPECT_EQ(sizes.size(), 1U);
}

TEST(PlanLabels, AFullHouseIsStillExplained) {
  Layout layout = room_with({{0, 0}, {9000, 0}, {9000, 9000}, {0, 9000}});
  for (int i = 0; i < 120; ++i) {
    add(layout, "thing", {100, 100, 100}, 400 + 700 * (i % 12), 400 + 800 * (i / 12)).name = "curious thing number " + std::to_string(i);
  }
  EXPECT_THAT(write_floor_plan_svg(layout, Catalog::builtin()), HasSubstr("kinds more</text>"));
}

TEST(PlanDimensions, AnLIsMeasuredAlongItsSides) {
  const std::string svg =
      write_floor_plan_svg(room_with({{0, 0}, {7000, 0}, {7000, 2900}, {4700, 2900}, {4700, 5800}, {0, 5800}}), Catalog::builtin());
  for (const char* length : {">7.00<", ">5.80<", ">4.70<", ">2.30<", ">2.90<"}) EXPECT_THAT(svg, HasSubstr(length)) << length;
}

TEST(PlanDimensions, ManyWallsAreMeasuredAsAWhole) {
  std::vector<Point> corners;
  for (int i = 0; i < 24; ++i) {
    const double angle = i * kPi / 12;
    corners.push_back(
        {static_cast<Mm>(std::lround(2500 + 2500 * std::cos(angle))), static_cast<Mm>(std::lround(2500 + 2500 * std::sin(angle)))});
  }
  const std::string svg = write_floor_plan_svg(room_with(corners), Catalog::builtin());
  EXPECT_THAT(svg, HasSubstr(">5.00<"));
  EXPECT_THAT(svg, Not(HasSubstr(">0.65<")));
}

// A piece that is shorter than its figure has it beside the line.
TEST(PlanDimensions, ShortPiecesHaveTheirFigureToo) {
  Layout layout = room_with({{0, 0}, {4000, 0}, {4000, 3000}, {0, 3000}});
  Opening door;
  door.id = "door1";
  door.wall = "wall1";
  door.offset = 60;
  door.width = 900;
  layout.room.openings.push_back(door);
  const std::string svg = write_floor_plan_svg(layout, Catalog::builtin());
  EXPECT_THAT(svg, HasSubstr(">0.06<"));
  EXPECT_THAT(svg, HasSubstr(">3.04<"));
}

TEST(FloorPlan, AWideDoorHasTwoLeaves) {
  Layout layout = room_with({{0, 0}, {4000, 0}, {4000, 3000}, {0, 3000}});
  Opening door;
  door.id = "door1";
  door.wall = "wall1";
  door.offset = 1000;
  door.width = 1600;
  const auto leaves = [&] {
    layout.room.openings = {door};
    const std::string svg = write_floor_plan_svg(layout, Catalog::builtin());
    int count = 0;
    for (std::size_t at = 0; (at = svg.find("stroke-width=\"0.5\"", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  EXPECT_EQ(leaves(), 2);
  door.width = 900;
  EXPECT_EQ(leaves(), 1);
}

TEST(PlanInk, WhatIsFilledHidesWhatLiesBelow) {
  PlanInk ink(100, 100);
  const auto square = [](double a, double b) { return std::vector<PaperPoint>{{a, a}, {b, a}, {b, b}, {a, b}}; };
  const auto mine = [](int owner) { return owner == 7; };
  ink.set_owner(3);
  ink.polygon(square(10, 90), {"#fff", "#000", 0.2, {}});
  ink.polyline({{20, 50}, {80, 50}}, {});
  EXPECT_FALSE(ink.is_clear({40, 48, 60, 52}, [](int) { return true; })) << "a line runs through";
  ink.set_owner(7);
  ink.polygon(square(30, 70), {"#fff", "#000", 0.2, {}});
  EXPECT_TRUE(ink.is_clear({40, 48, 60, 52}, mine));
  EXPECT_FALSE(ink.is_clear({20, 48, 60, 52}, mine)) << "partly another's";
  EXPECT_FALSE(ink.is_clear({95, 95, 105, 99}, [](int) { return true; })) << "off the page";
  ink.text({50, 50}, 3, "words", TextAnchor::kMiddle, 0, "#000");
  EXPECT_FALSE(ink.is_clear({45, 47, 55, 52}, mine));
}

}  // namespace
}  // namespace layoutbox
