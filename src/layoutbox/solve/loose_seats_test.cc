// Seats of which words say little: what one looks at from them, sits round on them or is to be away from.
#include <gtest/gtest.h>

#include <cmath>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

// Free before its front up to the room's edge.
double before(const PlacedObject& seat, double width, double depth) {
  const double turn = std::remainder(seat.rotation_deg, 360) * kPi / 180, x = std::sin(turn), y = -std::cos(turn);
  const double to_edge =
      std::abs(x) > 0.5 ? (x > 0 ? width - seat.position[0] : seat.position[0]) : (y > 0 ? depth - seat.position[1] : seat.position[1]);
  return to_edge - seat.size.depth / 2.0;
}

// "A swivel chair faces the standing-height table, a bean bag is next to it."
TEST(LooseSeats, WhoLooksAtATableSitsAtIt) {
  for (const char* seat : {"office_chair", "bar_stool", "chair"}) {
    const std::string id = std::string(seat) + "_1";
    const Layout layout = solved_as_asked(SceneMaker(3800, 3300)
                                              .add("table")
                                              .add(seat)
                                              .add("bean_bag")
                                              .relate("facing", {id}, {"table_1"})
                                              .relate("nextTo", {"bean_bag_1"}, {"table_1"})
                                              .make(true));
    EXPECT_LT(between_middles(layout, id, "table_1"), 1100) << seat;
  }
}

TEST(LooseSeats, BarStoolsStandAtAKitchensCounter) {
  const Layout layout = solved_as_asked(SceneMaker(4000, 3400).add("fridge").add("counter").add("bar_stool", 2).make(true));
  for (const char* stool : {"bar_stool_1", "bar_stool_2"}) EXPECT_LT(between_middles(layout, stool, "counter_1"), 1000) << stool;
}

TEST(LooseSeats, WhoSitsRoundAStoveKeepsTheKneesOffIt) {
  const Layout layout = solved_as_asked(
      SceneMaker(3900, 3300)
          .add("wood_stove")
          .add("folding_chair", 4)
          .relate("centerOfRoom", {"wood_stove_1"})
          .relate("surround", {"folding_chair_1", "folding_chair_2", "folding_chair_3", "folding_chair_4"}, {"wood_stove_1"})
          .make(true));
  const PlacedObject& stove = *layout.find_object("wood_stove_1");
  for (int i = 1; i <= 4; ++i) {
    const std::string id = "folding_chair_" + std::to_string(i);
    const double reach = layout.find_object(id)->size.depth / 2.0 + std::max(stove.size.width, stove.size.depth) / 2.0;
    EXPECT_GT(between_middles(layout, id, "wood_stove_1") - reach, 400) << id;
  }
}

TEST(LooseSeats, AChairAwayFromItsDeskDoesNotLookAtTheWall) {
  const Layout layout =
      solved_as_asked(SceneMaker(4700, 4200).add("desk").add("office_chair").relate("far", {"office_chair_1"}, {"desk_1"}).make(true));
  EXPECT_GT(before(*layout.find_object("office_chair_1"), 4700, 4200), 450);
}

}  // namespace
}  // namespace layoutbox::placement
