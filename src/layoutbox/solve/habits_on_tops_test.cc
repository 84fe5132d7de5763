// What stands and lies on tables where nobody said where.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

TEST(Habits, ScreensOnADeskStandSideBySide) {
  const Layout layout = solved_as_asked(SceneMaker(4000, 3600)
                                            .add("desk")
                                            .sized(1500, 700, 750)
                                            .add("monitor", 2)
                                            .add("keyboard")
                                            .relate("on", {"monitor_1"}, {"desk_1"})
                                            .relate("on", {"monitor_2"}, {"desk_1"})
                                            .relate("on", {"keyboard_1"}, {"desk_1"})
                                            .make(true));
  const PlacedObject& desk = object(layout, "desk_1");
  const Point one = seen_from(desk, object(layout, "monitor_1")), two = seen_from(desk, object(layout, "monitor_2"));
  EXPECT_NEAR(one.y, two.y, 20);
  EXPECT_NEAR(one.x, -two.x, 20);
}

TEST(Habits, WhatStandsOnATableAloneStandsInItsMiddle) {
  const Layout layout =
      solved_as_asked(SceneMaker(4000, 3600).add("dining_table").add("vase").relate("on", {"vase_1"}, {"dining_table_1"}).make(true));
  const Point vase = seen_from(object(layout, "dining_table_1"), object(layout, "vase_1"));
  EXPECT_NEAR(vase.x, 0, 10);
  EXPECT_NEAR(vase.y, 0, 10);
}

TEST(Habits, WhatStandsOnATableIsSpreadOverItAndNeighboursDoNotTouch) {
  SceneMaker maker(4000, 3600);
  maker.add("dining_table").sized(1600, 900, 750).add("vase").add("bowl").add("candle");
  for (const char* id : {"vase_1", "bowl_1", "candle_1"}) maker.relate("on", {id}, {"dining_table_1"});
  const Layout layout = solved_as_asked(maker.relate("nextTo", {"candle_1"}, {"bowl_1"}).make(true));
  const PlacedObject& table = object(layout, "dining_table_1");
  const Point vase = seen_from(table, object(layout, "vase_1")), bowl = seen_from(table, object(layout, "bowl_1"));
  EXPECT_NEAR(vase.x, -400, 60) << "the words' order";
  EXPECT_NEAR(bowl.x, 400, 60);
  EXPECT_NEAR(vase.y, bowl.y, 60);
  const Point candle = seen_from(object(layout, "bowl_1"), object(layout, "candle_1"));
  EXPECT_GT(std::abs(candle.x) - (object(layout, "bowl_1").size.width + object(layout, "candle_1").size.width) / 2, 20);
}

TEST(Habits, TheKeyboardLiesBeforeTheScreenAndTheMouseToItsRight) {
  const Layout layout = solved_as_asked(SceneMaker(4000, 3600)
                                            .add("desk")
                                            .add("monitor")
                                            .add("keyboard")
                                            .add("mouse")
                                            .relate("on", {"monitor_1"}, {"desk_1"})
                                            .relate("on", {"keyboard_1"}, {"desk_1"})
                                            .relate("on", {"mouse_1"}, {"desk_1"})
                                            .make(true));
  const PlacedObject& desk = object(layout, "desk_1");
  const Point screen = seen_from(desk, object(layout, "monitor_1")), keys = seen_from(desk, object(layout, "keyboard_1")),
              mouse = seen_from(desk, object(layout, "mouse_1"));
  EXPECT_NEAR(keys.x, screen.x, 100);
  EXPECT_LT(keys.y, screen.y - 100);
  EXPECT_GT(mouse.x, keys.x + 200);
  EXPECT_LT(mouse.x, keys.x + 400);
}

TEST(Habits, NothingStandsOnAMatThatIsUsed) {
  const Layout layout =
      solved_as_asked(SceneMaker(3600, 3000).add("yoga_mat", 2).add("treadmill").relate("centerOfRoom", {"yoga_mat_1"}).make(true));
  const PlacedObject& treadmill = object(layout, "treadmill_1");
  for (const char* id : {"yoga_mat_1", "yoga_mat_2"}) {
    const PlacedObject& mat = object(layout, id);
    for (int k = 0; k < 40; ++k) {  // along its long middle line
      const double along = (k + 0.5) / 40 - 0.5, a = mat.rotation_deg * 3.14159265358979 / 180;
      const TestPoint p{mat.position[0] - std::sin(a) * along * mat.size.depth, mat.position[1] + std::cos(a) * along * mat.size.depth, 3};
      EXPECT_FALSE(in_body(treadmill, p)) << id;
    }
  }
}

}  // namespace
}  // namespace layoutbox::placement
