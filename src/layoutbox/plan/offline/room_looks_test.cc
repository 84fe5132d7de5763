// What a text says of the look of doors and windows.
#include <gtest/gtest.h>

#include <algorithm>

#include "layoutbox/catalog/normalize.h"
#include "layoutbox/plan/planner.h"

namespace layoutbox {
namespace {

SceneGraph scene_said(const std::string& text) {
  static const auto planner = make_offline_planner(Catalog::builtin());
  Result<Plan> plan = planner->plan(text, {});
  EXPECT_TRUE(plan) << text;
  return plan ? std::move(plan->scene) : SceneGraph{};
}

Room room_said(const std::string& text) { return scene_said(text).room; }

// "door french sliding, window": of every opening its type and its words.
std::string openings_of(const Room& room) {
  std::string all;
  for (const Opening& opening : room.openings) {
    if (!opening.asked()) continue;
    all += (all.empty() ? "" : ", ") + std::string(name_of(opening.type));
    for (const std::string& word : opening.attributes) all += " " + word;
  }
  return all;
}

TEST(RoomLooks, WordsOfDoorsAndWindows) {
  const std::pair<const char*, const char*> cases[] = {
      {"A bedroom with French doors on the back wall and a bed.", "door french"},
      {"A living room with patio doors and a sofa.", "door patio"},
      {"modern bedroom with balcony", "door balcony"},
      {"A kitchen with a sliding glass door to the garden.", "door sliding glass garden"},
      {"A hall with double doors.", "door double"},
      {"A garage with a garage door and a workbench.", "door garage"},
      {"A study with a red door and a desk.", "door red"},
      {"A tea room with shoji doors.", "door shoji"},
      {"An attic with two round windows on the back wall and an oak door on the right wall.", "window round, window round, door oak"},
      {"A loft with black-framed windows.", "window black-framed, window black-framed"},
      {"A bathroom with a frosted window.", "window frosted"},
      {"A study with an oak door and a balcony door.", "door oak, door balcony"},
      {"A wardrobe with sliding doors and a bed.", ""},
      {"A bathroom with a door opening outwards.", "door outwards"},
      {"Bedroom with a bed and a wardrobe, bathroom door visible from the bed.", "door bathroom"},
  };
  for (const auto& [text, openings] : cases) EXPECT_EQ(openings_of(room_said(text)), openings) << text;
}

TEST(RoomLooks, OpeningsAreInTheWallThatIsMeant) {
  const auto walls_of = [](const Room& room) {
    std::string all;
    for (const Opening& opening : room.openings) all += (all.empty() ? "" : ", ") + std::string(name_of(opening.type)) + " " + opening.wall;
    return all;
  };
  const std::pair<const char*, const char*> cases[] = {
      {"A bedroom with a door in the left wall and a window in the opposite wall.", "door left, window right"},
      {"A garage with a car, single entrance south, side door north.", "door front, door back, window "},
      {"A bedroom with a bed, window (east), door (west).", "window right, door left"},
      {"A workshop with a saw. The overhead door is on the front, man door back right corner.", "door front, door back, window "},
      {"A living room with a sofa, windows on both long sides.", "window back, window front, door "},
      {"Bedroom 3.4 by 4.1 metres, door in the corner of the short wall, window on the opposite wall.", "door front, window back"},
      {"A corridor 1.3 x 5 m with doors at both ends, no windows.", "door back, door front"},
      {"An office with windows on two sides, door in the front wall.", "door front, window back, window left"},
      {"The room is 5 x 4 m, no windows. The door is on the north wall near the east corner.", "door back"},
  };
  for (const auto& [text, walls] : cases) EXPECT_EQ(walls_of(room_said(text)), walls) << text;
  const auto offset_of = [](const char* text) {
    auto normalized = normalize_scene(scene_said(text), Catalog::builtin());
    EXPECT_TRUE(normalized.has_value()) << text;
    return normalized ? normalized->room.openings.front().offset.value_or(-1) : -1;
  };
  EXPECT_EQ(offset_of("The room is 5 x 4 m. The door is on the north wall near the east corner."), 100);
  EXPECT_EQ(offset_of("A room of 5 x 4 m with a door in the middle of the front wall."), (5000 - 900) / 2);
  EXPECT_GT(offset_of("A bedroom with a bed and a door in the middle of the front."), 1000);  // of whatever size
}

TEST(RoomLooks, ADoorToTheOutsideIsNoEntrance) {
  const Room room = room_said("A bedroom with a balcony door.");
  ASSERT_EQ(room.openings.size(), 3u);
  EXPECT_EQ(room.openings[1].type, OpeningType::kDoor);
  EXPECT_EQ(room.openings[1].origin, Origin::kAssumed);
  EXPECT_EQ(room_said("A garage with a garage door.").openings.size(), 2u);  // and a window
  EXPECT_EQ(room_said("A bedroom with a bed and a bathroom door.").openings.size(), 3u);
  EXPECT_EQ(room_said("A bathroom with a tub and a bathroom door.").openings.size(), 2u);
}

TEST(RoomLooks, SizesFitTheRoom) {
  const Room glazed = room_said("A room with a window 3 x 2.3 m and a bed.");
  ASSERT_FALSE(glazed.openings.empty());
  EXPECT_EQ(glazed.openings[0].height, 2300);
  EXPECT_LE(glazed.openings[0].sill, 100);
  EXPECT_FALSE(room_said("A studio with a north window, 6 x 5 m. Two easels.").polygon.empty());
  for (const Opening& opening : room_said("A 2 x 2 m room with a garage door.").openings) EXPECT_LE(opening.width, 2000);
  const Room cabin = room_said("A hall with a round window.");
  ASSERT_FALSE(cabin.openings.empty());
  EXPECT_EQ(cabin.openings[0].width, cabin.openings[0].height);
}

// "back: brick; floor: oak floor": the looks of single walls, of all walls, and of the floor.
std::string finishes_of(const Room& room) {
  std::string all;
  const auto add = [&](const std::string& where, const std::string& what) {
    if (!what.empty()) all += (all.empty() ? "" : "; ") + where + ": " + what;
  };
  for (const auto& [wall, material] : room.wall_looks) add(wall, material);
  add("walls", room.wall_material);
  add("floor", room.floor_material);
  add("ceiling", room.ceiling_material);
  return all;
}

TEST(RoomLooks, FinishesOfWallsAndFloors) {
  const std::pair<const char*, const char*> cases[] = {
      {"A loft with exposed brick on the back wall and a leather sofa.", "back: exposed brick"},
      {"A living room with an exposed brick wall and a sofa.", "back: exposed brick"},
      {"A bedroom with brick walls and a wooden floor.", "walls: brick; floor: wooden floor"},
      {"A study with wood panelling on the left wall and a desk.", "left: wood panelling"},
      {"A bedroom with a dark green accent wall behind the bed.", "back: dark green"},
      {"A bed stands against the left wall. The wall behind the bed is dark blue.", "left: dark blue"},
      {"A bathroom with white tiles up the walls.", "walls: white tiles"},
      {"Dark bathroom, black tiles, a freestanding tub.", "walls: black tiles; floor: black tiles"},
      {"A kitchen with a table with green tiles on top.", ""},
      {"A nursery with striped wallpaper and a crib.", "walls: striped wallpaper"},
      {"A living room with wallpaper with flowers and a sofa.", "walls: wallpaper with flowers"},
      {"A bathroom with a bathtub. White tiles on the floor and green tiles on the walls.", "walls: green tiles; floor: white tiles floor"},
      {"A hall with a stone floor and stone walls.", "walls: stone; floor: stone floor"},
      {"A living room with herringbone parquet and a sofa.", "floor: herringbone parquet floor"},
      {"A dojo with tatami mats on the floor.", "floor: tatami mats floor"},
      {"A tea room with tatami floor.", "floor: tatami floor"},
      {"Six tatami mats in a dojo.", ""},
      {"A kids room. The back wall is blue.", "back: blue"},
      {"A hall with white walls and a dark wooden ceiling.", "walls: white; ceiling: dark wooden"},
      {"A study with a desk. The ceiling is painted navy blue.", "ceiling: navy blue"},
      {"A dining room with soft yellow walls and a table.", "walls: soft yellow"},
      {"A nursery with pale blue walls.", "walls: pale blue"},
      {"A coffee shop with a counter. Brick wall, dark green paint.", "back: brick; walls: dark green paint"},
      {"An office with a desk. Navy paint on the walls.", "walls: navy paint"},
      {"A living room painted dark green with a sofa.", "walls: dark green"},
      {"A workshop with a shelf and a tin of paint.", ""},
      {"A living room, one wall is exposed brick, a sofa.", "back: exposed brick"},
      {"A loft with brick on one wall and a leather sofa.", "back: brick"},
      {"A cabin with a stone fireplace and a sofa. Log walls.", "walls: log walls"},
      {"A kitchen with a table, floor red tiles.", "floor: red tiles floor"},
      {"A barber shop. Checkerboard floor, black and white, that has to stay.", "floor: black checkerboard floor"},
      {"A studio flat with a bed. White walls, light laminate.", "walls: white; floor: light laminate floor"},
      {"A cafe with a counter on the back wall, blue tiles behind the counter.", "back: blue tiles"},
      {"A bathroom with a bathtub. Patterned cement tiles on the floor and green zellige tiles on the walls.",
       "walls: green zellige tiles; floor: patterned cement tiles floor"},
  };
  for (const auto& [text, finishes] : cases) EXPECT_EQ(finishes_of(room_said(text)), finishes) << text;
}

TEST(RoomLooks, WhatAWallIsBehindStandsAtIt) {
  const auto planner = make_offline_planner(Catalog::builtin());
  const Result<Plan> plan = planner->plan("A bedroom with a dark green accent wall behind the bed.", {});
  ASSERT_TRUE(plan);
  const bool at_wall = std::ranges::any_of(plan->scene.relations, [](const Relation& relation) {
    return relation.type == RelationType::kAgainstWall && relation.references == std::vector<std::string>{"back"};
  });
  EXPECT_TRUE(at_wall);
}

}  // namespace
}  // namespace layoutbox
