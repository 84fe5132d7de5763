// Which room is meant where others are named, what it has none of, and what things are made of.
#include <string>

#include "layoutbox/plan/offline/test_planner.h"

namespace layoutbox {
namespace {

TEST_F(OfflinePlannerTest, WhatIsNotThereIsNotAssumed) {
  const auto openings = [&](const char* text) {
    const SceneGraph read = scene(text);
    std::string all;
    for (const Opening& opening : read.room.openings) all += std::string(name_of(opening.type)) + " ";
    return all + (read.room.openings_given ? "given" : "");
  };
  EXPECT_EQ(openings("A windowless, doorless cell with a cot."), "given");
  EXPECT_EQ(openings("A meeting room with no windows and no doors, a table."), "given");
  EXPECT_EQ(openings("A window-less bathroom with a shower."), "door ");
  EXPECT_EQ(openings("A cellar with a bricked-up window, barrels along the left wall."), "door ");
  EXPECT_EQ(openings("A hall. No doors. A table in the middle."), "window ");
  EXPECT_EQ(openings("A bedroom with a doorless wardrobe and a cabinet without doors."), "");
}

TEST_F(OfflinePlannerTest, TheRoomIsNotWhereSomebodyWorks) {
  const auto kind = [&](const char* text) { return scene(text).room.type; };
  EXPECT_EQ(kind("I work nights on a ward and sleep in the day, so the bedroom must be dark. A double bed."), "bedroom");
  EXPECT_EQ(kind("My son works in a restaurant kitchen. His bedroom has a bed and a desk."), "bedroom");
  EXPECT_EQ(kind("She teaches in a classroom all day and wants a quiet study with a desk."), "study");
  EXPECT_EQ(kind("I work in an office. Two desks and a cabinet."), "office");
  EXPECT_EQ(kind("A kitchen where I can work in peace, with a table."), "kitchen");
}

TEST_F(OfflinePlannerTest, ReadsColorsAndStuffSaidBehind) {
  const auto attributes = [&](const char* text) {
    const SceneGraph read = scene(text);
    std::string all;
    for (const std::string& word : read.objects.at(0).attributes) all += word + " ";
    return all;
  };
  EXPECT_EQ(attributes("A couch in washable gray and a rug."), "washable gray ");
  EXPECT_EQ(attributes("Chairs in dark green velvet."), "dark green velvet ");
  EXPECT_EQ(attributes("A table of glass and a rug."), "glass ");
  const SceneGraph steel = scene("A submarine cabin of riveted steel with a bunk and a table.");
  EXPECT_EQ(steel.room.wall_material, "riveted steel");
  EXPECT_EQ(steel.room.floor_material, "riveted steel");
  EXPECT_TRUE(steel.relations.empty());
}

}  // namespace
}  // namespace layoutbox
