// What rooms of homes are like: their form, ceilings that come down, walls of glass, what units and alcoves have.
#include <gtest/gtest.h>

#include <algorithm>

#include "layoutbox/catalog/normalize.h"
#include "layoutbox/plan/planner.h"

namespace layoutbox {
namespace {

SceneGraph planned(const std::string& text) {
  static const auto planner = make_offline_planner(Catalog::builtin());
  const Result<Plan> plan = planner->plan(text, {});
  EXPECT_TRUE(plan) << text;
  return plan ? plan->scene : SceneGraph{};
}

SceneGraph normalized(const std::string& text) {
  auto scene = normalize_scene(planned(text), Catalog::builtin());
  EXPECT_TRUE(scene) << text;
  return scene ? *scene : SceneGraph{};
}

std::ptrdiff_t count(const SceneGraph& scene, std::string_view category) {
  return std::ranges::count(scene.objects, category, &SceneObject::category);
}

const SceneObject* first(const SceneGraph& scene, std::string_view category) {
  const auto found = std::ranges::find(scene.objects, category, &SceneObject::category);
  return found == scene.objects.end() ? nullptr : &*found;
}

bool related(const SceneGraph& scene, RelationType type, const std::string& target, const std::string& reference) {
  return std::ranges::any_of(scene.relations, [&](const Relation& r) {
    return r.type == type && std::ranges::find(r.targets, target) != r.targets.end() &&
           (reference.empty() || std::ranges::find(r.references, reference) != r.references.end());
  });
}

Point extent(const Room& room) {
  Point most{};
  for (const Point& p : room.polygon) most = {std::max(most.x, p.x), std::max(most.y, p.y)};
  return most;
}

TEST(Homes, TheFormOfTheRoomIsRead) {
  const std::pair<const char*, const char*> cases[] = {
      {"My bedroom is 12 m², long and narrow. A bed and a desk.", "long"},
      {"A long narrow living room with a sofa.", "long"},
      {"The kitchen is really narrow, with a sink and a fridge.", "long"},
      {"small galley kitchen with a fridge", "long"},
      {"A square bedroom with a bed.", "square"},
      {"A wide hall with a bench.", "wide"},
      {"A bedroom with a long narrow table.", ""},
      {"A dining room with a square table.", ""},
      {"A bedroom of 12 square meters with a bed.", ""},
      {"A study with a desk 2 m long and a shelf along the long wall.", ""},
      {"Walk-in wardrobe, long and narrow, with two rails.", "long"},
  };
  for (const auto& [text, form] : cases) EXPECT_EQ(planned(text).room.shape, form) << text;
}

TEST(Homes, AFreeFloorIsNotTheRoom) {
  const SceneGraph scene = planned("Home gym with a treadmill. Leave an open space about 6 by 8 for stretching.");
  EXPECT_TRUE(scene.room.polygon.empty());
  EXPECT_TRUE(std::ranges::any_of(scene.notes, [](const Note& note) { return note.message.find("6 by 8") != std::string::npos; }));
  EXPECT_EQ(extent(planned("bathroom 1 x 1.8 m toilet sink").room).y, 1800);
  EXPECT_EQ(planned("20 qm flat with a bed.").room.area_m2, 20.0);
}

TEST(Homes, WindowsOfANarrowWallShareIt) {
  const SceneGraph scene = normalized("Pottery studio (8ft by 20ft) with two wheels by the windows on the south side, kiln.");
  ASSERT_GE(scene.room.openings.size(), 2u);
  Mm wide = 0;
  for (const Opening& opening : scene.room.openings) wide += opening.type == OpeningType::kWindow ? opening.width : 0;
  EXPECT_LT(wide, extent(scene.room).x);
}

TEST(Homes, AWindowIsInTheWallOfWhatStandsUnderIt) {
  const std::pair<const char*, const char*> cases[] = {
      {"A kitchen with base cabinets and a sink along the left wall under the window, and a fridge.", "left"},
      {"A kitchen with white cabinets on the back wall with a sink under the window.", "back"},
      {"A kitchen with the sink under the window, a stove on the left wall and a fridge on the back wall.", ""},
      {"A living room with a reading chair by the window on the left wall.", "left"},
      {"A bedroom with a bed, and a bay window with a cushioned window seat on the right wall.", "right"},
      {"A bedroom with a bed on the left wall and a desk under the window.", ""},
  };
  for (const auto& [text, wall] : cases) {
    const SceneGraph scene = normalized(text);
    const auto window = std::ranges::find(scene.room.openings, OpeningType::kWindow, &Opening::type);
    ASSERT_NE(window, scene.room.openings.end()) << text;
    EXPECT_EQ(window->wall, std::string_view(wall).empty() ? "" : scene.find_wall(wall)->id) << text;
  }
}

TEST(Homes, ADoorIsKnownByItsName) {
  const SceneGraph scene =
      planned("A hall with an entrance on the left wall and a cellar door on the right wall. A bench next to the cellar door.");
  EXPECT_TRUE(related(scene, RelationType::kNextTo, "bench_1", "door2"));
}

TEST(Homes, ALongRoomIsEnteredAtANarrowEnd) {
  const SceneGraph scene =
      normalized("Bedroom, 12 m² long and narrow, the door at one short end, the window at the other. Single bed, desk.");
  const Point size = extent(scene.room);
  EXPECT_NEAR(double(size.x) * size.y, 12e6, 0.1e6);
  EXPECT_NEAR(double(size.y) / size.x, 2.2, 0.1);
  ASSERT_EQ(scene.room.openings.size(), 2u);
  EXPECT_EQ(scene.room.openings[0].wall, scene.find_wall("front")->id);
  EXPECT_EQ(scene.room.openings[1].wall, scene.find_wall("back")->id);
}

TEST(Homes, ASizeOfAThingIsNotTheRoomsWhereThatHasOne) {
  const Point size = extent(planned("Kitchen and living room 7 x 5 m, kitchen line 3 metres long, a sofa.").room);
  EXPECT_EQ(size.x, 7000);
  EXPECT_EQ(size.y, 5000);
  EXPECT_NE(first(planned("small living room 3.2 x 3.8 m sofa, tv"), "sofa"), nullptr);
}

TEST(Homes, CeilingsComeDownWhereTheTextSaysSo) {
  struct Row {
    const char* text;
    std::vector<double> turns;  // of what has its back to each wall
  };
  const Row rows[] = {
      {"Bedroom with sloping ceilings on both sides and a bed.", {90, 270}},
      {"A bedroom where the ceiling slopes down at the back. A bed.", {0}},
      {"The roof slopes on the left side. A bed and a chair in the bedroom.", {90}},
      {"A loft bedroom with a slanted ceiling, a bed and a desk.", {0}},
      {"Attic bedroom with a bed and a desk.", {90, 270}},
      {"An attic room with no sloping ceiling and a bed.", {}},
      {"A bedroom with a bed and a high ceiling.", {}},
      {"A chalet by a ski slope, with a sofa.", {}},
  };
  for (const Row& row : rows) {
    std::vector<double> turns;
    for (const SceneObject& object : planned(row.text).objects) {
      if (object.category == "sloped_ceiling") turns.push_back(object.hint.rotation_deg.value_or(-1));
    }
    EXPECT_EQ(turns, row.turns) << row.text;
  }
}

TEST(Homes, WhatIsUnderTheSlopeIsSaidToBe) {
  const SceneGraph scene = planned("Attic room, single bed tucked under the eaves, a desk under the slope.");
  ASSERT_NE(first(scene, "sloped_ceiling"), nullptr);
  EXPECT_TRUE(related(scene, RelationType::kUnder, "single_bed_1", first(scene, "sloped_ceiling")->id));
  EXPECT_TRUE(related(scene, RelationType::kUnder, "desk_1", first(scene, "sloped_ceiling")->id));
}

TEST(Homes, SlopesFillTheirWallUpToTheCeilingAndRoofWindowsSitInThem) {
  const SceneGraph scene = normalized("Attic bedroom 4 x 5 m, sloping ceilings on both sides, a skylight and a bed.");
  ASSERT_EQ(count(scene, "sloped_ceiling"), 2);
  const SceneObject& slope = *first(scene, "sloped_ceiling");
  EXPECT_TRUE(slope.fixed);
  EXPECT_EQ(slope.size->usual.width, 5000);
  EXPECT_NEAR((*slope.hint.position)[2] + slope.size->usual.height, scene.room.height, 1);
  EXPECT_NEAR((*slope.hint.position)[0], slope.size->usual.depth / 2.0, 1);
  const SceneObject* window = first(scene, "slope_window");
  ASSERT_NE(window, nullptr);
  EXPECT_TRUE(window->fixed);
  EXPECT_TRUE(related(scene, RelationType::kIn, window->id, slope.id));
}

TEST(Homes, WallsOfGlassAreAsWideAsTheirWall) {
  for (const char* text :
       {"Living room 5 x 4 m with a glass wall and a sofa.", "Living room 5 x 4 m with floor-to-ceiling windows and a sofa.",
        "Living room 5 x 4 m, a wall of windows on the left, a sofa."}) {
    const SceneGraph scene = normalized(text);
    const auto window = std::ranges::find_if(scene.room.openings, [](const Opening& o) { return o.type == OpeningType::kWindow; });
    ASSERT_NE(window, scene.room.openings.end()) << text;
    const Mm wall = window->wall == scene.find_wall("left")->id ? 4000 : 5000;
    EXPECT_GE(window->width, wall - 300) << text;
    EXPECT_EQ(std::ranges::count(scene.room.openings, OpeningType::kWindow, &Opening::type), 1) << text;
  }
  EXPECT_EQ(planned("A bedroom with two floor-to-ceiling windows.").room.openings.front().width, 1500);
}

TEST(Homes, AKitchenetteThatNamesItsPartsIsACounterWithThem) {
  const SceneGraph scene = planned("Studio flat with a kitchenette with two burners and a sink, a bed.");
  EXPECT_EQ(count(scene, "kitchenette"), 0);
  EXPECT_EQ(count(scene, "counter"), 1);
  EXPECT_EQ(count(scene, "cooktop"), 1);
  EXPECT_EQ(count(scene, "inset_sink"), 1);
  EXPECT_TRUE(related(scene, RelationType::kOn, "cooktop_1", "counter_1"));
  EXPECT_EQ(count(planned("Studio flat with a kitchenette and a bed."), "kitchenette"), 1);
}

TEST(Homes, AWorktopThatIsOnlyDescribedIsThatOfTheUnits) {
  EXPECT_EQ(count(planned("Kitchen, white cupboards, oak worktop, sink, fridge."), "counter"), 0);
  EXPECT_EQ(count(planned("Kitchen with an oak worktop, a sink and a fridge."), "counter"), 1);
}

TEST(Homes, WordsThatMeanSomethingElseInARoom) {
  EXPECT_EQ(count(planned("Hallway with a narrow console and a mirror."), "console_table"), 1);
  EXPECT_EQ(count(planned("Small bathroom with a toilet, vanity with mirror."), "bathroom_vanity"), 1);
  EXPECT_EQ(count(planned("minimalist japanese bedroom, futon, low table"), "floor_futon"), 1);
  EXPECT_EQ(count(planned("Bathroom with double sinks, a shower and a toilet."), "double_vanity"), 1);
  EXPECT_EQ(count(planned("Nursery with a crib, pastel green walls"), "pastel"), 0);
}

TEST(Homes, ThingsInAnAlcoveAndUnderACounter) {
  const SceneGraph room = planned("Japanese room with a tokonoma alcove with a scroll and an ikebana arrangement.");
  EXPECT_EQ(count(room, "display_alcove"), 1);
  EXPECT_EQ(room.objects.size(), 3u);
  const SceneGraph laundry = planned("Laundry room with washer and dryer side by side, a counter above them.");
  EXPECT_TRUE(related(laundry, RelationType::kUnder, "washing_machine_1", "counter_1"));
  EXPECT_TRUE(related(laundry, RelationType::kUnder, "dryer_1", "counter_1"));
}

TEST(Homes, WhatIsOppositeAThingWithoutAnArticle) {
  const SceneGraph scene = planned("Living room with sofa, tv on stand opposite sofa, wardrobe opposite bed, bed.");
  EXPECT_EQ(count(scene, "sofa"), 1);
  EXPECT_EQ(count(scene, "tv_stand"), 1);
  EXPECT_TRUE(related(scene, RelationType::kOn, "tv_1", "tv_stand_1"));
}

TEST(Homes, StoolsOfAnIslandAreNoChairsOfTheTable) {
  EXPECT_EQ(count(planned("Kitchen with an island and 4 stools, grey sofa, dining table for 6."), "dining_chair"), 6);
}

TEST(Homes, SeveralAlongOneWallAreAtTheSame) {
  const auto rows = [&](const SceneGraph& scene) {
    return std::ranges::count_if(scene.relations, [](const Relation& r) { return r.type == RelationType::kRow && !r.hard; });
  };
  EXPECT_EQ(rows(planned("A polling station with four voting booths along one wall and a table.")), 1);
  EXPECT_EQ(rows(planned("A shop with five bookcases against the walls.")), 0);
  EXPECT_EQ(rows(planned("A study with a bookcase against the wall and a desk against the wall.")), 0);
}

}  // namespace
}  // namespace layoutbox
