// Groups in a room: who dines keeps off the sofas, who has a fire sits by it, guests wait before the desk.
#include <gtest/gtest.h>

#include <cmath>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

double distance(const Layout& layout, const std::string& a, const std::string& b) {
  const PlacedObject *one = layout.find_object(a), *other = layout.find_object(b);
  return std::hypot(one->position[0] - other->position[0], one->position[1] - other->position[1]);
}

TEST(RoomGroups, WhoDinesKeepsOffTheSofas) {
  const Layout layout = solved_as_asked(SceneMaker(6000, 5000)
                                            .add("sofa")
                                            .add("coffee_table")
                                            .add("tv_stand")
                                            .add("dining_table")
                                            .add("chair", 4)
                                            .relate("around", {"chair_1", "chair_2", "chair_3", "chair_4"}, {"dining_table_1"})
                                            .make(true));
  EXPECT_GT(distance(layout, "coffee_table_1", "dining_table_1"), 1800);
}

TEST(RoomGroups, ArmchairsSitBeforeTheFire) {
  const Layout layout = solved_as_asked(SceneMaker(4500, 4000).add("fireplace").add("armchair", 2).make(true));
  for (const char* chair : {"armchair_1", "armchair_2"}) {
    const PlacedObject& fire = *layout.find_object("fireplace_1");
    const PlacedObject& seat = *layout.find_object(chair);
    EXPECT_NEAR(std::abs(std::remainder(fire.rotation_deg - seat.rotation_deg, 360)), 180, 1) << chair;
    EXPECT_LT(distance(layout, "fireplace_1", chair), 2400) << chair;
  }
}

TEST(RoomGroups, GuestsDoNotWaitBehindTheDesk) {
  const Layout layout = solved_as_asked(SceneMaker(6000, 5000).add("reception_desk").add("chair", 6).make(true));
  const PlacedObject& desk = *layout.find_object("reception_desk_1");
  for (int i = 1; i <= 6; ++i) {
    const PlacedObject& chair = *layout.find_object("chair_" + std::to_string(i));
    EXPECT_LT(in_frame_of(desk, {chair.position[0], chair.position[1], 0}).y, desk.size.depth / 2.0) << i;
  }
}

}  // namespace
}  // namespace layoutbox::placement
