// What is read of the room itself: its size and form, its kind, doors, windows and finishes.
#include <gtest/gtest.h>

#include <algorithm>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/catalog/normalize.h"
#include "layoutbox/plan/offline/test_planner.h"

namespace layoutbox {
namespace {

using PlannedRooms = OfflinePlannerTest;

TEST_F(PlannedRooms, ReadsRoomSizesInTheirUsualForms) {
  for (const char* text : {"Create a bedroom with dimensions 4 x 2 x 3 meters. Include a bed.", "A bedroom (4.0 × 2.0 × 3.0 m) with a bed.",
                           "A bedroom (4.0 * 2.0 * 3.0 m) with a bed.", "A 4 by 2 by 3 metre bedroom with a bed.",
                           "A 4x2x3m bedroom with a bed.", "A 400 x 200 x 300 cm bedroom with a bed."}) {
    const SceneGraph read = scene(text);
    EXPECT_EQ(read.room.polygon, rectangle(4, 2)) << text;
    EXPECT_EQ(read.room.height, 3000) << text;
    EXPECT_EQ(read.objects.size(), 1u) << text;
  }
  // A size that no such thing has is the room's; one that it may have is its own.
  EXPECT_EQ(scene("A student room with a desk and a bookshelf, 3 x 4 m.").room.polygon, rectangle(3, 4));
  EXPECT_TRUE(scene("A living room with a sofa and a rug, 2 x 3 m.").room.polygon.empty());
  EXPECT_EQ(scene("A room 12 by 14 feet with a bed.").room.polygon, rectangle(3.658, 4.267));
  EXPECT_NEAR(scene("A bedroom of 20 m² with a bed.").room.area_m2.value_or(0), 20, 1e-9);
  EXPECT_NEAR(scene("A bedroom of 20 square meters with a bed.").room.area_m2.value_or(0), 20, 1e-9);
  EXPECT_EQ(scene("A small bedroom with a bed.").room.size_word, "small");
}

// A notch is cut out of the room's rectangle, an alcove goes out of it.
TEST_F(PlannedRooms, NichesChangeTheOutline) {
  const std::vector<Point> notched = {{0, 0}, {6000, 0}, {6000, 3000}, {4000, 3000}, {4000, 5000}, {0, 5000}};
  for (const char* text : {"An L-shaped living room, 6 x 5 m with a 2 x 2 m notch, with a sofa.",
                           "An L-shaped room, 6 x 5 m, missing a corner of 2 by 2, with a sofa.",
                           "A room of 6 x 5 m whose back right corner of 2 m x 2 m is missing. It has a sofa.",
                           "A room, 6 m by 5 m, with a notch of 2 x 2 m in the north-east corner and a sofa.",
                           "A 6x5 m room with a 2x2 m corner cut out at the back right and a sofa."}) {
    const SceneGraph read = scene(text);
    EXPECT_EQ(read.room.polygon, notched) << text;
    EXPECT_EQ(read.objects.size(), 1u) << text;
  }
  EXPECT_EQ(scene("A 6 x 5 m room with a 1.5 m x 1 m alcove in the north-east corner and a desk.").room.polygon,
            (std::vector<Point>{{0, 0}, {6000, 0}, {6000, 6000}, {4500, 6000}, {4500, 5000}, {0, 5000}}));
  EXPECT_EQ(scene("A 6 x 5 m room with a 2 m wide and 0.6 m deep recess in the left wall and a desk.").room.polygon,
            (std::vector<Point>{{0, 0}, {6000, 0}, {6000, 5000}, {0, 5000}, {0, 3500}, {-600, 3500}, {-600, 1500}, {0, 1500}}));
  EXPECT_EQ(scene("A bedroom 4 x 4 m with a bed and a niche of 1 x 0.5 m for the wardrobe.").room.polygon.size(), 6u);
  // Its own size is not the room's.
  EXPECT_TRUE(scene("A room with a sofa and an alcove of 1.5 by 1 m.").room.polygon.empty());
  EXPECT_EQ(scene("An L-shaped room, 6 x 4 m, with a sofa.").room.polygon,
            (std::vector<Point>{{0, 0}, {6000, 0}, {6000, 2000}, {4000, 2000}, {4000, 4000}, {0, 4000}}));
}

TEST_F(PlannedRooms, TheShapeOfAKitchenIsThatOfItsUnits) {
  EXPECT_EQ(scene("An L-shaped kitchen with a sink and a stove.").room.shape, "");
  EXPECT_EQ(scene("A U-shaped kitchen, 4 x 3 m, with a sink.").room.polygon, rectangle(4, 3));
  EXPECT_EQ(scene("An L-shaped kitchen diner with a sink.").room.shape, "L");
  EXPECT_EQ(scene("An L-shaped kitchen, 6 x 5 m with a 2 x 2 m notch, with a sink.").room.polygon.size(), 6u);
}

TEST_F(PlannedRooms, OpeningsHaveTheSizesThatAreSaid) {
  const auto opening = [&](const char* text, OpeningType type) {
    const SceneGraph read = scene(text);
    const auto found = std::find_if(read.room.openings.begin(), read.room.openings.end(), [&](const Opening& o) { return o.type == type; });
    EXPECT_NE(found, read.room.openings.end()) << text;
    return found == read.room.openings.end() ? Opening{} : *found;
  };
  EXPECT_EQ(opening("A bedroom with a bed. The door is 1 m wide.", OpeningType::kDoor).width, 1000);
  EXPECT_EQ(opening("A bedroom with a bed and a 1 m wide door in the left wall.", OpeningType::kDoor).width, 1000);
  const SceneGraph two = scene("A bedroom with a bed and two windows, each 2 m wide, in the back wall.");
  EXPECT_EQ(std::count_if(two.room.openings.begin(), two.room.openings.end(),
                          [](const Opening& o) { return o.type == OpeningType::kWindow && o.width == 2000; }),
            2);
}

TEST_F(PlannedRooms, RoomsOfTwoSizesAndOfTwoParts) {
  EXPECT_TRUE(notes(scene("A bedroom of 4 x 3 m and 5 x 6 m with a bed."), "contradiction"));
  EXPECT_TRUE(notes(scene("A bedroom of 4 x 3 m with a bed. The room is 5 x 6 m."), "contradiction"));
  EXPECT_EQ(scene("A 4 x 3 m bedroom with a bed. The room is 5 x 6 m.").room.polygon, rectangle(4, 3));
  EXPECT_EQ(scene("A room of 5 and a half metres by 4 metres with a piano.").room.polygon, rectangle(5.5, 4));
  EXPECT_EQ(scene("An L-shaped living room: the main part is 5 x 4 m and the smaller part 2 x 3 m, with a sofa.").room.polygon,
            (std::vector<Point>{{0, 0}, {5000, 0}, {5000, 1000}, {7000, 1000}, {7000, 4000}, {0, 4000}}));
}

TEST_F(PlannedRooms, TheFrontOfTheRoomIsWhereTheBoardIs) {
  const auto front = [&](const char* text) {
    const SceneGraph read = scene(text);
    return std::any_of(read.relations.begin(), read.relations.end(),
                       [](const Relation& r) { return !r.asked() && r.references == std::vector<std::string>{"front"}; });
  };
  EXPECT_TRUE(front("A classroom with 12 desks facing the whiteboard and a bookshelf at the back."));
  EXPECT_TRUE(front("A hall with ten chairs facing the stage. A table stands at the back of the room."));
  EXPECT_FALSE(front("A classroom with 12 desks facing the whiteboard on the left wall and a bookshelf at the back."));
  EXPECT_FALSE(front("A classroom with 12 desks facing the whiteboard."));
}

TEST_F(PlannedRooms, KnowsTheKindOfRoom) {
  EXPECT_EQ(scene("Design Bedroom (4.0 × 3.2 × 3.0 m). Place the bed centred on the back wall.").room.type, "bedroom");
  EXPECT_EQ(scene("In this bathroom, a vanity stands against the wall.").room.type, "bathroom");
  EXPECT_EQ(scene("A cozy living room with a sofa.").room.type, "living_room");
  EXPECT_EQ(scene("Waiting room with eight chairs").room.type, "waiting_room");
  EXPECT_EQ(scene("Meeting room for ten: long table, ten chairs.").room.type, "conference_room");
}

TEST_F(PlannedRooms, OpeningsStandWhereCoordinatesSay) {
  const auto normal = [&](const std::string& text) {
    return normalize_scene(scene(text), Catalog::builtin()).value().room.openings.front();
  };
  EXPECT_EQ(normal("A room 6 x 4.5 m with a bed. Door 0.9 m wide in the left wall at y=3.5.").offset, 550);  // from the back
  EXPECT_EQ(normal("A room 6 x 4.5 m with a bed. Door 0.9 m wide in the front wall, 0.3 m from the left corner.").offset, 300);
  EXPECT_EQ(normal("A room 7 x 4 m with a sofa. A balcony door 1.6 m in the middle of the right wall.").offset, 1200);
  const Opening window = normal("A room 6 x 4.5 m with a bed. A window 2 m wide in the right wall at y = 2 m, sill at 0.8 m.");
  EXPECT_EQ(window.offset, 1000);
  EXPECT_EQ(window.sill, 800);
  EXPECT_EQ(scene("A bedroom with a bed. Window full height on the left wall.").room.openings.front().wall, "left");
}

TEST_F(PlannedRooms, PutsDoorsAndWindowsWhereTheTextSays) {
  const SceneGraph read = scene("A room with two windows on the back wall and a door on the left wall.");
  ASSERT_EQ(read.room.openings.size(), 3u);
  EXPECT_EQ(std::count_if(read.room.openings.begin(), read.room.openings.end(),
                          [](const Opening& o) { return o.type == OpeningType::kWindow && o.wall == "back"; }),
            2);
  EXPECT_EQ(std::count_if(read.room.openings.begin(), read.room.openings.end(),
                          [](const Opening& o) { return o.type == OpeningType::kDoor && o.wall == "left"; }),
            1);
}

TEST_F(PlannedRooms, WallsOfOpeningsByTheirSide) {
  const auto wall = [&](const char* text, OpeningType type) {
    const SceneGraph read = scene(text);
    const auto found = std::find_if(read.room.openings.begin(), read.room.openings.end(), [&](const Opening& o) { return o.type == type; });
    EXPECT_NE(found, read.room.openings.end()) << text;
    return found == read.room.openings.end() ? std::string{} : found->wall;
  };
  EXPECT_EQ(wall("A desk. There is a window to the east.", OpeningType::kWindow), "right");
  EXPECT_EQ(wall("The entrance is on the left. A table.", OpeningType::kDoor), "left");
  EXPECT_EQ(wall("The window faces east. A bed.", OpeningType::kWindow), "right");
  const char* cellar = "A cellar, 2 x 5 m, the door at one end and the window at the other. A rack.";
  EXPECT_EQ(wall(cellar, OpeningType::kDoor), "front");
  EXPECT_EQ(wall(cellar, OpeningType::kWindow), "back");
  const char* studio = "A studio of 6 x 4 m, door on the short side, window opposite the door. A sofa.";
  EXPECT_EQ(wall(studio, OpeningType::kDoor), "right");
  EXPECT_EQ(wall(studio, OpeningType::kWindow), "left");
  EXPECT_EQ(wall("A desk. The door to the yard is at the back.", OpeningType::kDoor), "back");
  const SceneGraph two = scene("The room has two doors, one in the front wall and one in the left wall. A bed.");
  EXPECT_EQ(
      std::count_if(two.room.openings.begin(), two.room.openings.end(), [](const Opening& o) { return o.type == OpeningType::kDoor; }), 2);
  for (const char* text : {"No windows. A bed and a desk.", "A windowless storage room with shelves."}) {
    const SceneGraph read = scene(text);
    ASSERT_EQ(read.room.openings.size(), 1u) << text;
    EXPECT_EQ(read.room.openings.front().type, OpeningType::kDoor) << text;
  }
}

// Windows are called after their walls or say them by what they are, walls after what is in them.
TEST_F(PlannedRooms, WallsOfOpeningsByNames) {
  const auto openings = [&](const char* text) {
    const SceneGraph read = scene(text);
    std::string all;
    for (const Opening& o : read.room.openings) all += (all.empty() ? "" : ", ") + std::string(name_of(o.type)) + " " + o.wall;
    return all;
  };
  EXPECT_EQ(openings("A café. A bench under the front window."), "window front, door ");
  EXPECT_EQ(openings("A flower shop. Stands in front of the big shop window, a counter. Door in the front wall."),
            "door front, window front");
  EXPECT_EQ(openings("A shop with a shop window on the left wall. A table in front of the shop window."), "window left, door ");
  EXPECT_EQ(openings("A studio. Two easels near the north windows. Three tall windows on the north side."),
            "window back, window back, window back, door ");
  EXPECT_EQ(openings("An open office with four desks and a sofa under the windows."), "window back, window back, door ");
  EXPECT_EQ(openings("A gym with two treadmills facing the windows, a mirror on the back wall."), "window left, window left, door ");
  EXPECT_EQ(openings("A workshop with a bench under the two windows, a saw."), "window back, window back, door ");
  EXPECT_EQ(openings("Coffee shop, entrance in the middle of the front with a big window either side. A counter."),
            "door front, window front, window front");
  EXPECT_EQ(openings("Meeting room 6 x 4 m. A screen on the left wall, glass door at the other end, a table."), "door right, window ");
  EXPECT_EQ(openings("A bedroom, window on the right wall. A desk along the window wall."), "window right, door ");
}

TEST_F(PlannedRooms, EndsOfTheCompassAreTheNarrowSides) {
  EXPECT_EQ(scene("Chapel, 12 m long and 7 m wide. Altar at the east end.").room.polygon, rectangle(12, 7));
  EXPECT_EQ(scene("Chapel, 12 m long and 7 m wide. Altar at the north end.").room.polygon, rectangle(7, 12));
}

TEST_F(PlannedRooms, ReadsFloorAndWalls) {
  EXPECT_EQ(scene("A den with a sofa. Teal and white.").room.wall_material, "teal");
  EXPECT_EQ(scene("A kitchen in cream and walnut with a stove.").room.floor_material, "walnut floor");
  EXPECT_EQ(scene("A bedroom with a bed and a shelf, dark green and white. A window above the desk.").room.wall_material, "dark green");
  EXPECT_EQ(scene("A bedroom with a bed, a shelf, white curtains and a rug.").room.wall_material, "");
  EXPECT_EQ(scene("A bed and a wardrobe.").room.type, "bedroom");
  EXPECT_EQ(scene("My room in the shared flat, with a bed and a desk.").room.type, "bedroom");
  EXPECT_EQ(scene("A flat with a bed and a sofa.").room.type, "studio_apartment");
  EXPECT_EQ(scene("I'm 9 and I want a loft bed and a wardrobe.").room.type, "kids_room");
  EXPECT_EQ(scene("I'm 49 and I want a bed and a wardrobe.").room.type, "bedroom");
  const SceneGraph read = scene("An office with white walls and a wooden floor has a desk.");
  EXPECT_EQ(read.room.wall_material, "white");
  EXPECT_EQ(read.room.floor_material, "wooden floor");
  EXPECT_EQ(read.objects.size(), 1u);
}

TEST_F(PlannedRooms, WallsAndFloorsHaveTheFinishesSaidBehindThem) {
  EXPECT_EQ(scene("A guest room with a bed. Walls pale blue. Ceiling 2.5 m.").room.wall_material, "pale blue");
  const SceneGraph read = scene("A study with a desk, walls in sage green, floor oak");
  EXPECT_EQ(read.room.wall_material, "sage green");
  EXPECT_EQ(read.room.floor_material, "oak floor");
  EXPECT_EQ(scene("A study with a desk. Walls: white, floor: oak.").room.wall_material, "white");
  EXPECT_EQ(scene("A kitchen for my mum, everything low, red tiles, a step stool").room.wall_material, "red tiles");
  EXPECT_EQ(scene("A room with pictures on the walls and a red sofa.").room.wall_material, "");
}

TEST_F(PlannedRooms, StorageAtAnEndOfTheRoomStandsAtItsWall) {
  const auto at_wall = [](const SceneGraph& scene) {
    return std::ranges::any_of(
        scene.relations, [](const Relation& r) { return r.type == RelationType::kAgainstWall && r.origin == Origin::kAssumed && !r.hard; });
  };
  EXPECT_TRUE(at_wall(scene("A hall with a wardrobe at the back.")));
  EXPECT_FALSE(at_wall(scene("A hall with a stool at the back.")));
}

}  // namespace
}  // namespace layoutbox
