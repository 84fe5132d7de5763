#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/export/export.h"
#include "layoutbox/export/plan_symbols.h"
#include "layoutbox/export/svg.h"

namespace layoutbox {
namespace {

FloorPlanOptions bare_plan() {
  FloorPlanOptions options;
  options.names = options.sizes = options.scale_bar = false;
  return options;
}

using ::testing::HasSubstr;
using ::testing::Not;

Layout room_of(Mm width, Mm depth) {
  Layout layout;
  layout.room.type = "living_room";
  layout.room.height = 2600;
  layout.room.polygon = {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
  for (std::size_t i = 0; i < 4; ++i) {
    Wall wall;
    wall.id = "wall" + std::to_string(i + 1);
    wall.start = layout.room.polygon[i];
    wall.end = layout.room.polygon[(i + 1) % 4];
    layout.room.walls.push_back(wall);
  }
  return layout;
}

void add_object(Layout& layout, std::string category, Size size, double x, double y, double rotation = 0) {
  PlacedObject object;
  object.id = category + "_" + std::to_string(layout.objects.size() + 1);
  object.category = std::move(category);
  object.size = size;
  object.position = {x, y, 0};
  object.rotation_deg = rotation;
  layout.objects.push_back(std::move(object));
}

// Elements close in order, attributes are quoted, no bare & in between. Empty where all is well.
std::string fault_of(const std::string& xml) {
  static const std::regex tag(R"(<(/?)([a-zA-Z]+)((?:\s+[a-zA-Z:-]+="[^"<]*")*)\s*(/?)>)");
  std::vector<std::string> open;
  std::size_t at = xml.find("?>") + 2;
  while (at < xml.size()) {
    if (xml[at] == '<') {
      std::smatch match;
      if (!std::regex_search(xml.begin() + static_cast<std::ptrdiff_t>(at), xml.end(), match, tag,
                             std::regex_constants::match_continuous)) {
        return "bad tag at " + xml.substr(at, 60);
      }
      if (match[1].length() > 0) {
        if (open.empty() || open.back() != match[2]) return "closes " + match[2].str();
        open.pop_back();
      } else if (match[4].length() == 0) {
        open.push_back(match[2]);
      }
      at += static_cast<std::size_t>(match.length());
    } else if (xml[at] == '&') {
      static const std::regex entity("&(amp|lt|gt|quot);");
      if (!std::regex_search(xml.begin() + static_cast<std::ptrdiff_t>(at), xml.end(), entity, std::regex_constants::match_continuous))
        return "bare &";
      ++at;
    } else {
      ++at;
    }
  }
  return open.empty() ? "" : "leaves " + open.back() + " open";
}

TEST(FloorPlan, HasTheSymbolsThatTheCatalogueNames) {
  for (const CatalogEntry& entry : Catalog::builtin().entries()) {
    if (!entry.shape.symbol.empty() && entry.shape.symbol != "box") {
      EXPECT_TRUE(has_symbol(entry.shape.symbol)) << entry.id << ": " << entry.shape.symbol;
    }
  }
}

TEST(FloorPlan, IsWellFormedWhateverTheNames) {
  Layout layout = room_of(4000, 3000);
  layout.prompt = "<script>alert(\"1\")</script> & ]]> \x01 \xff é 🛋";
  layout.name = "a < b & \"c\"";
  add_object(layout, "bed", {1600, 2000, 500}, 1000, 1500);
  layout.objects[0].name = "<b>&amp;\"'bed";
  layout.objects[0].id = "bed\"1<";
  const std::string svg = write_floor_plan_svg(layout, Catalog::builtin());
  EXPECT_EQ(fault_of(svg), "");
  EXPECT_THAT(svg, Not(HasSubstr("<script>")));
  EXPECT_THAT(svg, HasSubstr("é 🛋"));
}

TEST(FloorPlan, PartsTheLinesOfAPromptAndItsEdits) {
  Layout layout = room_of(4000, 3000);
  layout.prompt = "A room with a sofa.\npaint the walls blue\nremove the rug";
  EXPECT_THAT(write_floor_plan_svg(layout, Catalog::builtin()), HasSubstr("A room with a sofa. · paint the walls blue · remove the rug"));
}

TEST(FloorPlan, NamesAndMeasuresEveryObject) {
  Layout layout = room_of(4000, 3000);
  add_object(layout, "bed", {1600, 2000, 500}, 1000, 1500);
  add_object(layout, "table_lamp", {60, 60, 300}, 3000, 1500);  // too small for its name: beside the room
  const std::string svg = write_floor_plan_svg(layout, Catalog::builtin());
  EXPECT_THAT(svg, HasSubstr(">bed</text>"));
  EXPECT_THAT(svg, HasSubstr(">160 × 200</text>"));
  EXPECT_THAT(svg, HasSubstr(">table lamp</text>"));
  EXPECT_THAT(svg, HasSubstr(">4.00</text>"));
  EXPECT_THAT(svg, HasSubstr(">3.00</text>"));
  EXPECT_THAT(svg, HasSubstr("12.0 m²"));
  const std::string bare = write_floor_plan_svg(layout, Catalog::builtin(), bare_plan());
  EXPECT_THAT(bare, Not(HasSubstr(">bed</text>")));
}

TEST(FloorPlan, TakesTheLargestScaleThatFits) {
  EXPECT_THAT(write_floor_plan_svg(room_of(1500, 1500), Catalog::builtin()), HasSubstr("1 : 20 "));
  EXPECT_THAT(write_floor_plan_svg(room_of(4000, 3000), Catalog::builtin()), HasSubstr("1 : 25 "));
  EXPECT_THAT(write_floor_plan_svg(room_of(20000, 15000), Catalog::builtin()), HasSubstr("1 : 125 "));
  EXPECT_THAT(write_floor_plan_svg(room_of(90000, 60000), Catalog::builtin()), HasSubstr("1 : 500 "));
}

// All coordinates of shapes lie on the page.
TEST(FloorPlan, StaysOnThePage) {
  for (const auto& [width, depth] : {std::pair<Mm, Mm>{1500, 1500}, {20000, 15000}, {20000, 1500}, {2000, 15000}}) {
    Layout layout = room_of(width, depth);
    for (int i = 0; i < 40; ++i) add_object(layout, "chair", {100, 100, 900}, width / 2.0, depth * i / 40.0);
    const std::string svg = write_floor_plan_svg(layout, Catalog::builtin());
    const std::regex points("points=\"([^\"]*)\"");
    for (std::sregex_iterator it(svg.begin(), svg.end(), points), end; it != end; ++it) {
      std::istringstream list((*it)[1]);
      double x = 0, y = 0;
      for (char comma = 0; list >> x >> comma >> y;) {
        EXPECT_TRUE(x >= 0 && x <= 297 && y >= 0 && y <= 210) << x << "," << y << " in a room of " << width << " × " << depth;
      }
    }
  }
}

// Whatever font draws it: the width of each text is said, and no text reaches over the page's edge.
TEST(FloorPlan, LongPromptsWrap) {
  Layout layout = room_of(4000, 3000);
  for (int i = 0; i < 90; ++i) layout.prompt += i % 2 == 0 ? "a wide mahogany wardrobe, " : "il filo ";
  const std::string svg = write_floor_plan_svg(layout, Catalog::builtin());
  const std::regex text(R"re(<text x="([0-9.]+)"[^>]*text-anchor="start" textLength="([0-9.]+)"[^>]*>([^<]*)<)re");
  int of_prompt = 0;
  for (std::sregex_iterator it(svg.begin(), svg.end(), text), end; it != end; ++it) {
    EXPECT_LE(std::stod((*it)[1]) + std::stod((*it)[2]), 297 - 5) << (*it)[3];
    of_prompt += (*it)[3].str().find("mahogany") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(of_prompt, 3);
}

// A leaf hung at the left as seen from within is at the wall's end, and "in" opens into the room.
TEST(FloorPlan, DrawsTheLeafWhereItSwings) {
  const auto leaf = [](Swing swing) {
    Layout layout = room_of(4000, 3000);
    Opening door;
    door.id = "door1";
    door.wall = "wall1";
    door.offset = 1000;
    door.width = 800;
    door.swing = swing;
    layout.room.openings.push_back(door);
    const std::string svg = write_floor_plan_svg(layout, Catalog::builtin());
    const std::regex line(R"re(points="([0-9.]+),([0-9.]+) ([0-9.]+),([0-9.]+)" fill="none" stroke="#222" stroke-width="0.5")re");
    std::smatch match;
    EXPECT_TRUE(std::regex_search(svg, match, line));
    // x in room millimetres, from the floor's left front corner, and which way the leaf goes.
    const std::regex floor(R"re(points="([0-9.]+),[0-9. ,]+" fill="#fdfcf9")re");
    std::smatch corner;
    EXPECT_TRUE(std::regex_search(svg, corner, floor));
    return std::pair{(std::stod(match[1]) - std::stod(corner[1])) * 25, std::stod(match[4]) - std::stod(match[2])};
  };
  EXPECT_NEAR(leaf(Swing::kInLeft).first, 1800, 10);
  EXPECT_NEAR(leaf(Swing::kInRight).first, 1000, 10);
  EXPECT_LT(leaf(Swing::kInLeft).second, 0) << "up the page, into the room";
  EXPECT_GT(leaf(Swing::kOutRight).second, 0);
}

// Two leaves where the door's words or its width say so, turning or on two tracks.
TEST(FloorPlan, DrawsBothLeavesOfADoor) {
  const auto leaves = [](Mm width, Swing swing, std::vector<std::string> words) {
    Layout layout = room_of(4000, 3000);
    Opening door;
    door.id = "door1";
    door.wall = "wall1";
    door.offset = 1000;
    door.width = width;
    door.swing = swing;
    door.attributes = std::move(words);
    layout.room.openings.push_back(door);
    const std::string svg = write_floor_plan_svg(layout, Catalog::builtin());
    const std::regex line(R"re(fill="none" stroke="#222" stroke-width="0.5")re");
    return std::distance(std::sregex_iterator(svg.begin(), svg.end(), line), std::sregex_iterator());
  };
  EXPECT_EQ(leaves(900, Swing::kInLeft, {}), 1);
  EXPECT_EQ(leaves(1600, Swing::kInLeft, {}), 2);
  EXPECT_EQ(leaves(1200, Swing::kInLeft, {"saloon"}), 2);
  EXPECT_EQ(leaves(900, Swing::kSliding, {}), 1);
  EXPECT_EQ(leaves(1800, Swing::kSliding, {"patio"}), 2);
}

TEST(FloorPlan, DrawsKindsDifferently) {
  const auto body = [](const char* category) {
    Layout layout = room_of(4000, 3000);
    add_object(layout, category, {800, 800, 800}, 2000, 1500);
    layout.objects[0].name = "thing";
    layout.objects[0].id = "thing_1";
    return write_floor_plan_svg(layout, Catalog::builtin(), bare_plan());
  };
  const char* kinds[] = {"bed",   "sofa",     "chair",     "round_stool", "floor_lamp", "desk",  "toilet",
                         "sink",  "bathtub",  "shower",    "stove",       "fridge",     "plant", "tv",
                         "piano", "wardrobe", "bookshelf", "dresser",     "picture",    "robot", "rug"};
  for (const char* a : kinds) {
    for (const char* b : kinds) {
      EXPECT_TRUE(a == b || body(a) != body(b)) << a << " and " << b;
    }
  }
}

TEST(FloorPlan, DrawsALayoutWithoutRoomOrObjects) { EXPECT_EQ(fault_of(write_floor_plan_svg(Layout{}, Catalog::builtin())), ""); }

TEST(EscapeXml, ReplacesWhatXmlDoesNotAllow) {
  EXPECT_EQ(escape_xml("a<b>&\"c"), "a&lt;b&gt;&amp;&quot;c");
  EXPECT_EQ(escape_xml("é🛋"), "é🛋");
  EXPECT_EQ(escape_xml(std::string("\0\x01\x7f", 3)), "   ");
  EXPECT_EQ(escape_xml("\xc0\xaf|\xed\xa0\x80|\xff"), " | | ");  // overlong, surrogate, never valid: a blank each
  EXPECT_EQ(escape_xml("\xc3"), " ");                            // cut off
}

}  // namespace
}  // namespace layoutbox
