// What a text says of the look of doors and windows.
#include <gtest/gtest.h>

#include "layoutbox/plan/planner.h"

namespace layoutbox {
namespace {

Room room_said(const std::string& text) {
  static const auto planner = make_offline_planner(Catalog::builtin());
  const Result<Plan> plan = planner->plan(text, {});
  EXPECT_TRUE(plan) << text;
  return plan ? plan->scene.room : Room{};
}

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
  };
  for (const auto& [text, openings] : cases) EXPECT_EQ(openings_of(room_said(text)), openings) << text;
}

TEST(RoomLooks, ADoorToTheOutsideIsNoEntrance) {
  const Room room = room_said("A bedroom with a balcony door.");
  ASSERT_EQ(room.openings.size(), 2u);
  EXPECT_EQ(room.openings[1].type, OpeningType::kDoor);
  EXPECT_EQ(room.openings[1].origin, Origin::kAssumed);
  EXPECT_EQ(room_said("A garage with a garage door.").openings.size(), 2u);  // and a window
}

TEST(RoomLooks, SizesFitTheRoom) {
  for (const Opening& opening : room_said("A 2 x 2 m room with a garage door.").openings) EXPECT_LE(opening.width, 2000);
  const Room cabin = room_said("A hall with a round window.");
  ASSERT_FALSE(cabin.openings.empty());
  EXPECT_EQ(cabin.openings[0].width, cabin.openings[0].height);
}

}  // namespace
}  // namespace layoutbox
