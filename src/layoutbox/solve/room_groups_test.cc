// Groups in a room: who dines keeps off the sofas, who has a fire sits by it, guests wait before the desk; what goes by windows, doors,
// beds and toilets.
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

TEST(RoomGroups, ArmchairsToldByTheFireSitBeforeItToo) {
  const Layout layout = solved_as_asked(SceneMaker(4500, 4000)
                                            .add("fireplace")
                                            .add("wingback_chair", 2)
                                            .relate("near", {"wingback_chair_1"}, {"fireplace_1"})
                                            .relate("near", {"wingback_chair_2"}, {"fireplace_1"})
                                            .make(true));
  for (const char* chair : {"wingback_chair_1", "wingback_chair_2"}) {
    const double turned = layout.find_object("fireplace_1")->rotation_deg - layout.find_object(chair)->rotation_deg;
    EXPECT_NEAR(std::abs(std::remainder(turned, 360)), 180, 1) << chair;
  }
}

TEST(RoomGroups, ATubsCurtainHangsAtTheTub) {
  const Layout layout = solved_as_asked(SceneMaker(3000, 2600)
                                            .add("bathtub")
                                            .add("shower_curtain")
                                            .opening(OpeningType::kDoor, "wall1", 200)
                                            .opening(OpeningType::kWindow, "wall2", 1000, 900, 900, 1200)
                                            .make(true));
  EXPECT_LT(distance(layout, "bathtub_1", "shower_curtain_1"), 800);
}

TEST(RoomGroups, TwoWindowsByADoorAreOneOnEachSideOfIt) {
  SceneGraph scene = SceneMaker(9000, 6000).add("table").make();
  for (const auto& [id, type] : {std::pair{"d", OpeningType::kDoor}, {"a", OpeningType::kWindow}, {"b", OpeningType::kWindow}}) {
    Opening opening;
    opening.id = id, opening.type = type, opening.wall = "wall1", opening.width = 1000;
    opening.height = type == OpeningType::kDoor ? 2000 : 1200, opening.sill = type == OpeningType::kDoor ? 0 : 900;
    scene.room.openings.push_back(opening);
  }
  const Layout layout = solved_as_asked(scene);
  const auto at = [&](const char* id) { return *layout.find_opening(id)->offset; };
  EXPECT_LT(std::min(at("a"), at("b")) + 1000, at("d"));
  EXPECT_GT(std::max(at("a"), at("b")), at("d") + 1000);
}

TEST(RoomGroups, GuestsDoNotWaitBehindTheDesk) {
  const Layout layout = solved_as_asked(SceneMaker(6000, 5000).add("reception_desk").add("chair", 6).make(true));
  const PlacedObject& desk = *layout.find_object("reception_desk_1");
  for (int i = 1; i <= 6; ++i) {
    const PlacedObject& chair = *layout.find_object("chair_" + std::to_string(i));
    EXPECT_LT(in_frame_of(desk, {chair.position[0], chair.position[1], 0}).y, desk.size.depth / 2.0) << i;
  }
}

const PlacedObject& placed(const Layout& layout, const std::string& id) { return *layout.find_object(id); }

TEST(RoomGroups, WhatIsLongLiesAlongTheWindowItIsUnder) {
  for (const char* kind : {"bar_counter", "bench", "console_table"}) {
    const std::string id = std::string(kind) + "_1";
    const Layout layout = solved_as_asked(SceneMaker(4500, 3800)
                                              .add(kind)
                                              .opening(OpeningType::kDoor, "wall1", 200)
                                              .opening(OpeningType::kWindow, "wall4", 1000, 1600, 900, 1200)
                                              .relate("underWindow", {id})
                                              .make());
    const bool across = std::lround(placed(layout, id).rotation_deg) % 180 == 0;
    const Size& size = placed(layout, id).size;
    EXPECT_GT(across ? size.depth : size.width, across ? size.width : size.depth) << kind;  // along y, as the wall is
    EXPECT_LT(placed(layout, id).position[0], 600) << kind;
  }
}

TEST(RoomGroups, WhatHangsHangsOverWhatItIsFor) {
  const Layout nursery =
      solved_as_asked(SceneMaker(3600, 3200).add("crib").add("rocking_chair").add("dresser").add("baby_mobile").make(true));
  EXPECT_LT(distance(nursery, "baby_mobile_1", "crib_1"), 200);
  const Layout kitchen = solved_as_asked(SceneMaker(3600, 3200).add("oven").add("poster").make(true));
  EXPECT_GT(distance(kitchen, "poster_1", "oven_1"), 600);
}

TEST(RoomGroups, ARailHangsAtTheSideOfItsToilet) {
  const Layout layout = solved_as_asked(
      SceneMaker(2400, 2200).add("toilet").add("sink").add("grab_rail").relate("nextTo", {"grab_rail_1"}, {"toilet_1"}).make(true));
  const double turned = std::remainder(placed(layout, "grab_rail_1").rotation_deg - placed(layout, "toilet_1").rotation_deg, 180);
  EXPECT_NEAR(std::abs(turned), 90, 1);
}

TEST(RoomGroups, AWardsCurtainHangsAlongItsBed) {
  const Layout layout = solved_as_asked(SceneMaker(4500, 4000).add("hospital_bed").add("nightstand").add("privacy_curtain").make(true));
  const PlacedObject &bed = placed(layout, "hospital_bed_1"), &curtain = placed(layout, "privacy_curtain_1");
  const double turned = std::remainder(curtain.rotation_deg - bed.rotation_deg, 180);
  EXPECT_NEAR(std::abs(turned), 90, 1);
  EXPECT_LT(distance(layout, bed.id, curtain.id), 1000);
}

TEST(RoomGroups, ATillIsByTheDoor) {
  const Layout layout =
      solved_as_asked(SceneMaker(7000, 6000).add("shop_counter").add("display_shelf", 3).opening(OpeningType::kDoor, "wall1", 5000).make());
  EXPECT_GT(placed(layout, "shop_counter_1").position[0], 3000);
  EXPECT_LT(placed(layout, "shop_counter_1").position[1], 3500);
}

TEST(RoomGroups, ALowTableIsBeforeThoseWhoWait) {
  const Layout layout = solved_as_asked(SceneMaker(6000, 5000).add("chair", 6).add("coffee_table").add("reception_desk").make(true));
  double nearest = 1e9;
  for (int k = 1; k <= 6; ++k) nearest = std::min(nearest, distance(layout, "coffee_table_1", "chair_" + std::to_string(k)));
  EXPECT_LT(nearest, 1400);
}

TEST(RoomGroups, AWorktopIsBetweenTheStoveAndTheFridge) {
  const Layout layout =
      solved_as_asked(SceneMaker(4200, 3400).add("fridge").add("kitchen_sink").add("stove").add("base_cabinet").make(true));
  EXPECT_GT(distance(layout, "fridge_1", "stove_1"), 900);
}

}  // namespace
}  // namespace layoutbox::placement
