// Where words leave it open, things stand where their kind usually does.
#include <gtest/gtest.h>

#include <cmath>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

double between(const Layout& layout, const std::string& a, const std::string& b) {
  const PlacedObject *one = layout.find_object(a), *other = layout.find_object(b);
  return std::hypot(one->position[0] - other->position[0], one->position[1] - other->position[1]);
}

TEST(UsualPlaces, ANightstandSaidToBeAtASideStandsByThePillow) {
  const Layout layout = solved_as_asked(
      SceneMaker(4400, 4000).add("bed").add("nightstand").add("wardrobe").relate("rightOf", {"nightstand_1"}, {"bed_1"}).make(true));
  const PlacedObject &bed = *layout.find_object("bed_1"), &stand = *layout.find_object("nightstand_1");
  EXPECT_LT(between(layout, "bed_1", "nightstand_1"), std::hypot(bed.size.width, bed.size.depth) / 2 + stand.size.width);
}

TEST(UsualPlaces, AChairSaidToBeNearADeskSitsAtIt) {
  const Layout layout =
      solved_as_asked(SceneMaker(4000, 3500).add("desk").add("office_chair").relate("near", {"office_chair_1"}, {"desk_1"}).make(true));
  EXPECT_LT(between(layout, "office_chair_1", "desk_1"), 1200);  // near is half a metre off at least
  const double turned =
      std::remainder(layout.find_object("office_chair_1")->rotation_deg - layout.find_object("desk_1")->rotation_deg, 360);
  EXPECT_NEAR(std::abs(turned), 180, 1);
}

TEST(UsualPlaces, AScreenLooksAtWhoIsToldToSitThere) {
  const Layout layout = solved_as_asked(SceneMaker(4000, 3500)
                                            .add("table")
                                            .add("office_chair")
                                            .add("monitor")
                                            .relate("facing", {"office_chair_1"}, {"table_1"})
                                            .relate("on", {"monitor_1"}, {"table_1"})
                                            .make(true));
  const double turned =
      std::remainder(layout.find_object("office_chair_1")->rotation_deg - layout.find_object("monitor_1")->rotation_deg, 360);
  EXPECT_NEAR(std::abs(turned), 180, 1);
}

}  // namespace
}  // namespace layoutbox::placement
