// What a finished room gets besides, what it does not get, and that nothing is worse for it.
#include "layoutbox/dress/dress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "layoutbox/catalog/dressing.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/dress/free_room.h"
#include "layoutbox/dress/hinges.h"
#include "layoutbox/dress/places.h"
#include "layoutbox/dress/test_dressed_room.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/scene/shell.h"
#include "layoutbox/verify/verify.h"

namespace layoutbox {
namespace {

using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::Not;

// Units along the back wall with a gap between them: sink 0–0.9, fridge at the right end.
DressedRoom kitchen(const std::string& prompt = {}) {
  DressedRoom room("kitchen", 4, 3.4, prompt);
  room.put("kitchen_sink", 0.45, 3.4 - 0.31, 0).put("stove", 2.0, 3.4 - 0.31, 0).put("fridge", 4 - 0.325, 3.4 - 0.33, 0);
  return room;
}

TEST(Dress, OneCabinetOfAKitchenIsOneAndCabinetsAreItsUnits) {
  DressedRoom one = kitchen("A kitchen with a sink, a stove, a fridge and a cabinet.");
  one.put("cabinet", 0.25, 1.2, 90);
  EXPECT_THAT(one.dress(), Not(Contains(testing::AnyOf("base_cabinet", "wall_cabinet"))));
  DressedRoom many = kitchen("A kitchen with a sink, a stove, a fridge and white cabinets.");
  many.put("cabinet", 0.25, 1.2, 90);
  EXPECT_THAT(many.dress(), Contains("base_cabinet"));
}

TEST(Dress, KitchensBecomeFitted) {
  DressedRoom room = kitchen();
  EXPECT_THAT(room.dress(), Contains("base_cabinet").Times(::testing::Ge(3)));
  double along = 0;  // the whole wall is taken
  for (const PlacedObject& object : room.layout().objects) {
    if (object.rotation_deg == 0 && object.mount == Mount::kFloor && object.position[2] < 1) along += object.size.width;
  }
  EXPECT_NEAR(along, 4000, 20);
  ASSERT_EQ(room.of("range_hood").size(), 1u);
  EXPECT_NEAR(room.of("range_hood")[0].position[0], 2000, 1);
  EXPECT_FALSE(room.of("wall_cabinet").empty());
  for (const PlacedObject& cabinet : room.of("wall_cabinet")) {
    EXPECT_FALSE(dressing::overlap(dressing::box_round(cabinet), dressing::box_round(room.of("range_hood")[0])));
  }
}

TEST(Dress, ACabinetStandsNotBeforeALowWindowOrADoor) {
  DressedRoom room = kitchen();
  room.opening(OpeningType::kWindow, "wall3", 1.8, 1.0, 1.6, 0.4);  // between sink and stove, seen from the right end of the wall
  room.dress();
  for (const PlacedObject& cabinet : room.of("base_cabinet")) {
    const dressing::RoomBox box = dressing::box_round(cabinet);
    EXPECT_FALSE(box.y1 > 3300 && box.x0 < 2200 && box.x1 > 1200) << cabinet.id;
  }
}

TEST(Dress, TheTextSaysTheFormOfAKitchen) {
  DressedRoom plain("kitchen", 3.4, 3.4, "A one-wall kitchen with a sink and a stove.");
  plain.put("kitchen_sink", 0.45, 3.09, 0).put("stove", 1.2, 3.09, 0);
  plain.dress();
  EXPECT_TRUE(plain.of("kitchen_corner_unit").empty());
  DressedRoom turned("kitchen", 3.4, 3.4, "An L-shaped kitchen with a sink and a stove.");
  turned.put("kitchen_sink", 0.45, 3.09, 0).put("stove", 1.2, 3.09, 0);
  turned.dress();
  ASSERT_EQ(turned.of("kitchen_corner_unit").size(), 1u);
  EXPECT_TRUE(std::ranges::any_of(turned.of("base_cabinet"), [](const PlacedObject& o) { return o.rotation_deg == 270; }));
  // A worktop that came with the sink is the corner's unit, and the run goes on from it.
  DressedRoom flush("kitchen", 4.0, 3.6, "A kitchen with L-shaped counters.");
  flush.put("base_cabinet", 0.4, 3.29, 0, Origin::kAdded)
      .put("stove", 1.1, 3.29, 0)
      .put("kitchen_sink", 1.85, 3.29, 0)
      .put("fridge", 2.65, 3.26, 0);
  flush.dress();
  const auto goes_on = [](const PlacedObject& o) { return o.rotation_deg == 90 && o.position[1] > 2500; };
  EXPECT_TRUE(std::ranges::any_of(flush.of("base_cabinet"), goes_on));
  DressedRoom facing("kitchen", 3.4, 2.6, "A galley kitchen with a sink and a stove.");
  facing.put("kitchen_sink", 2.0, 2.29, 0).put("stove", 2.75, 2.29, 0);
  facing.dress();
  EXPECT_TRUE(std::ranges::any_of(facing.of("base_cabinet"), [](const PlacedObject& o) { return o.rotation_deg == 180; }));
}

TEST(Dress, NoCabinetStandsBeforeASinkInTheCorner) {
  DressedRoom room("kitchen", 4.0, 3.6, "An L-shaped kitchen with a sink, a stove and a fridge.");
  room.put("kitchen_sink", 0.4, 3.29, 0).put("stove", 1.1, 3.29, 0).put("fridge", 1.75, 3.26, 0);
  room.dress();
  for (const PlacedObject& cabinet : room.of("base_cabinet")) {
    const dressing::RoomBox box = dressing::box_round(cabinet);
    EXPECT_FALSE(box.x0 < 750 && box.y1 > 2600 && box.y0 < 2980) << cabinet.id;
  }
}

TEST(Dress, RunsAlongTwoWallsMeetInTheCorner) {
  DressedRoom room("kitchen", 4.4, 3.7, "A kitchen with an L-shaped counter along the north and west walls.");
  room.put("counter", 1.6, 3.39, 0).put("counter", 0.31, 1.55, 90);
  room.dress();
  ASSERT_EQ(room.of("kitchen_corner_unit").size(), 1u);
  double north = 0, west = 0;
  for (const PlacedObject& unit : room.layout().objects) {
    if (unit.mount != Mount::kFloor || unit.position[2] > 0) continue;
    const dressing::RoomBox box = dressing::box_round(unit);
    if (box.y1 > 3690) north += std::min(box.x1, 2500.0) - std::min(box.x0, 2500.0);
    if (box.x0 < 10 && box.y0 > 600) west += box.y1 - box.y0;
  }
  EXPECT_NEAR(north, 2500, 20);       // from the corner to the end of the counter
  EXPECT_NEAR(west, 3700 - 650, 20);  // and down the other
  EXPECT_TRUE(std::ranges::none_of(room.of("base_cabinet"), [](const PlacedObject& o) { return o.rotation_deg == 270; }));
  // One that stands in the corner is met by the other.
  DressedRoom flush("kitchen", 4.4, 3.7, "A kitchen with an L-shaped counter along the north and west walls.");
  flush.put("counter", 0.9, 3.39, 0).put("counter", 0.31, 1.55, 90);
  flush.dress();
  EXPECT_TRUE(
      std::ranges::any_of(flush.of("base_cabinet"), [](const PlacedObject& o) { return o.rotation_deg == 90 && o.position[1] > 2450; }));
}

TEST(Dress, CurtainsHangAtWindows) {
  DressedRoom room("bedroom", 4, 3.6);
  room.window("wall3", 1.4).put("double_bed", 1.0, 1.8, 90);
  room.dress();
  ASSERT_EQ(room.of("curtain").size(), 1u);
  EXPECT_NEAR(room.of("curtain")[0].position[0], 2000, 1);
  EXPECT_LT(room.of("curtain")[0].position[2], 100) << "down to the floor";
  DressedRoom low("bedroom", 4, 3.6);
  low.window("wall3", 1.4).put("desk", 2.0, 3.6 - 0.35, 0);
  low.dress();
  ASSERT_EQ(low.of("curtain").size(), 1u);
  EXPECT_GT(low.of("curtain")[0].position[2], 700) << "down to the sill";
}

TEST(Dress, TheMoodOfTheTextSaysWhatStaysAway) {
  const auto study = [](const std::string& prompt) {
    DressedRoom room("study", 4.5, 4, prompt);
    room.window("wall3", 0.6).put("desk", 3.2, 3.7, 0).put("chair", 3.2, 3.2, 180);
    return room.dress();
  };
  EXPECT_THAT(study("A study with a desk and a chair."), testing::AllOf(Contains("painting"), Contains("laptop"), Contains("pen_holder")));
  EXPECT_THAT(study("A wizard's study with a desk and a chair."), Not(Contains(testing::AnyOf("painting", "laptop", "plant"))));
  EXPECT_THAT(study("An abandoned study with a desk and a chair."), Not(Contains(testing::AnyOf("painting", "laptop", "plant"))));
}

TEST(Dress, TablesAreLaidBeforeTheirSeats) {
  DressedRoom room("dining_room", 5, 4);
  room.put("dining_table", 2.5, 2.0, 0).put("chair", 2.2, 1.3, 180).put("chair", 2.5, 2.75, 0).put("chair", 4.6, 0.6, 0);
  room.dress();
  const std::vector<PlacedObject> plates = room.of("plate");
  ASSERT_EQ(plates.size(), 2u) << "none for who sits elsewhere";
  EXPECT_NEAR(plates[0].position[0], 2200, 1);
  EXPECT_LT(plates[0].position[1], 1800);
  EXPECT_GT(plates[1].position[1], 2200);
}

TEST(Dress, WhoWorksBehindAReceptionSeesTheScreen) {
  DressedRoom room("reception", 5, 4);
  room.put("reception_desk", 2.5, 2.4, 0).put("office_chair", 2.5, 3.0, 0);
  room.dress();
  ASSERT_EQ(room.of("monitor").size(), 1u);
  EXPECT_NEAR(room.of("monitor")[0].rotation_deg, 180, 1);
}

TEST(Dress, NothingOfWhatTheTextSpeaksOf) {
  DressedRoom named("bedroom", 4, 3.6);
  named.window("wall3", 1.4).put("plant", 3.5, 0.5, 0);
  EXPECT_THAT(named.dress(), Not(Contains("plant")));
  DressedRoom without("bedroom", 4, 3.6);
  EXPECT_THAT(without.window("wall3", 1.4).unwanted("curtain").dress(), Not(Contains("curtain")));
  for (const char* text : {"A minimalist bedroom with a bed.", "A bedroom with a bed and nothing else.", "A bedroom with only a bed."}) {
    DressedRoom room("bedroom", 4, 3.6, text);
    EXPECT_THAT(room.window("wall3", 1.4).put("double_bed", 1.0, 1.8, 90).dress(), IsEmpty()) << text;
  }
  for (const char* kind : {"prison_cell", "warehouse", "operating_room", "sauna", "", "server_room"}) {
    EXPECT_THAT(DressedRoom(kind, 4, 4).window("wall3", 1.4).dress(), IsEmpty()) << kind;
  }
}

TEST(Dress, APictureHangsOverTheSofaAndNotBehindTallThings) {
  DressedRoom room("living_room", 5, 4.2);
  room.put("sofa", 2.5, 4.2 - 0.45, 0).put("coffee_table", 2.5, 2.6, 0);
  EXPECT_THAT(room.dress(), Contains("rug"));
  ASSERT_FALSE(room.of("painting").empty());
  EXPECT_NEAR(room.of("painting")[0].position[0], 2500, 1);
  EXPECT_GE(room.of("painting")[0].size.width, 1000) << "a large one over a sofa";
  DressedRoom hidden("living_room", 2.2, 2.2);
  hidden.put("wardrobe", 1.1, 1.9, 0).put("wardrobe", 1.9, 1.0, 270).put("wardrobe", 0.3, 1.7, 90);
  EXPECT_THAT(hidden.dress(), Not(Contains("painting")));
}

TEST(Dress, APlantStandsInTheCornerFarthestFromTheDoor) {
  DressedRoom room("office", 4, 4);
  EXPECT_THAT(room.put("desk", 2.0, 2.0, 0).dress(), Contains("plant"));
  EXPECT_GT(room.of("plant")[0].position[0], 3500);
  EXPECT_GT(room.of("plant")[0].position[1], 3500);
}

TEST(Dress, SmallThingsStandOnWhatCarriesThem) {
  DressedRoom room("dining_room", 4, 4);
  room.put("dining_table", 2.0, 2.0, 0);
  EXPECT_THAT(room.dress(), Contains("vase"));
  EXPECT_EQ(room.of("vase")[0].supported_by, room.of("dining_table")[0].id);
  EXPECT_TRUE(std::ranges::any_of(room.layout().relations, [&](const PlacedRelation& placed) {
    return placed.relation.type == RelationType::kOn && placed.relation.targets[0] == room.of("vase")[0].id && placed.held;
  }));
}

// A poster that hides behind a wardrobe hangs where it is seen, unless the text says on which wall.
TEST(Dress, WhatHidesOnAWallIsHungInView) {
  for (const std::string where : {"", "wall3"}) {
    DressedRoom room("bedroom", 4, 3.4, "a bedroom with a wardrobe and a poster");
    room.hang("poster", 2, 3.395, 1.15, 0, "wall3", where).put("wardrobe", 2, 3.1, 0);
    room.dress();
    const auto posters = room.of("poster");
    const auto& at = posters[0].position;
    EXPECT_EQ(at[0] == 2000 && at[1] == 3395, !where.empty());
  }
}

TEST(Dress, SomeRowsAreForWhatTheTextSays) {
  const auto mat = [](const std::string& prompt) {
    DressedRoom room("bathroom", 3, 2.6, prompt);
    room.put("bathtub", 1.5, 2.2, 0);
    return room.dress();
  };
  EXPECT_THAT(mat("a bathroom with a bathtub"), Contains("bath_mat"));
  EXPECT_THAT(mat("a bathroom with a bathtub, for my mother who uses a walker"), Not(Contains("bath_mat")));
}

TEST(Dress, WhoNamesManyThingsGetsNoClockBesides) {
  DressedRoom few("office", 5, 4);
  few.put("desk", 2.5, 3.6, 180);
  EXPECT_THAT(few.dress(), Contains("calendar"));
  DressedRoom many("office", 5, 4);
  many.put("desk", 2.5, 3.6, 180).put("office_chair", 2.5, 2.8, 0).put("armchair", 4.3, 0.6, 90).put("sofa", 4.4, 2.4, 90);
  many.put("bookshelf", 0.4, 3.7, 180).put("printer", 2.5, 3.6, 0).put("trash_can", 1.4, 3.7, 0);
  EXPECT_THAT(many.dress(), Not(Contains(testing::AnyOf("calendar", "clock", "whiteboard", "vase"))));
}

TEST(Dress, WhatIsPlainOrClearStaysSo) {
  const auto come = [](const std::string& prompt) {
    DressedRoom room("living_room", 5, 4.2, prompt);
    room.put("sofa", 2.5, 4.2 - 0.45, 0).put("coffee_table", 2.5, 2.6, 0).put("sideboard", 0.4, 2, 270);
    return room.dress();
  };
  EXPECT_THAT(come("a living room"), testing::AllOf(Contains("painting"), Contains("rug"), Contains("mug")));
  EXPECT_THAT(come("a plain living room"), Not(Contains(testing::AnyOf("painting", "rug", "plant", "vase"))));
  EXPECT_THAT(come("a living room, nothing on the walls"), testing::AllOf(Not(Contains("painting")), Contains("rug")));
  EXPECT_THAT(come("a living room, earth floor"), testing::AllOf(Contains("painting"), Not(Contains("rug"))));
  EXPECT_THAT(come("a living room, nothing on the surfaces"),
              testing::AllOf(Contains("rug"), Not(Contains(testing::AnyOf("mug", "book")))));
}

TEST(Dress, TheDataNamesWhatIsThere) {
  const auto exists = [](const std::string& kind) { return catalog().find(kind) != nullptr; };
  for (const Dressing& row : Dressings::builtin().rows) {
    EXPECT_NE(dressing::find_place(row.place), nullptr) << row.place;
    EXPECT_TRUE(exists(row.adds)) << row.adds;
    for (const auto* kinds : {&row.of, &row.unless, &row.unspoken}) {
      for (const std::string& kind : *kinds) EXPECT_TRUE(exists(kind)) << kind;
    }
    for (const std::string& room : row.rooms) {
      EXPECT_TRUE(std::ranges::any_of(catalog().rooms(), [&](const RoomKind& kind) { return kind.id == room; })) << room;
    }
    EXPECT_FALSE(row.rooms.empty()) << row.adds;
    EXPECT_GT(row.most, 0) << row.adds;
  }
  for (const DressingTheme& theme : Dressings::builtin().themes) {
    for (const std::string& kind : theme.without) EXPECT_TRUE(exists(kind)) << kind;
    for (const std::string& place : theme.places) EXPECT_NE(dressing::find_place(place), nullptr) << place;
  }
}

// A door hangs where its open leaf has less behind it: away from the shelf beside it, at the corner where both sides are free.
TEST(Dress, DoorsHangClearOfWhatIsBesideThem) {
  for (const bool shelf : {false, true}) {
    DressedRoom room("bedroom", 4, 3.4);
    if (shelf) room.put("bookshelf", 1.45, 0.16, 180);
    SceneGraph scene;
    Layout layout = room.layout();
    layout.room.openings[0].swing = Swing::kInLeft;  // at the end of its wall, away from the corner
    scene.room = layout.room;
    EXPECT_EQ(hang_doors_clear(scene, layout, catalog()), 1U) << shelf;
    EXPECT_EQ(layout.room.openings[0].swing, Swing::kInRight);
    EXPECT_EQ(scene.room.openings[0].swing, Swing::kInRight);
    EXPECT_EQ(hang_doors_clear(scene, layout, catalog()), 0U) << "it stays there";
  }
  DressedRoom room("bedroom", 4, 3.4);  // something hangs on the wall that the leaf would open against
  room.opening(OpeningType::kDoor, "wall3", 0.3, 0.9, 2.0, 0).hang("painting", 3.98, 3.0, 1.2, 90, "wall2");
  SceneGraph scene;
  Layout layout = room.layout();
  layout.room.openings[1].swing = Swing::kInLeft;
  hang_doors_clear(scene, layout, catalog());
  EXPECT_EQ(layout.room.openings[1].swing, Swing::kInLeft);
}

}  // namespace
}  // namespace layoutbox
