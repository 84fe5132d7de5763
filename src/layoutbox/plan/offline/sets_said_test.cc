// Things that make one with another, as texts speak of them: the relations that follow.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "layoutbox/catalog/opening_look.h"
#include "layoutbox/plan/planner.h"

namespace layoutbox {
namespace {

using R = RelationType;

SceneGraph planned(const std::string& text) {
  static const auto planner = make_offline_planner(Catalog::builtin());
  const Result<Plan> plan = planner->plan(text, {});
  EXPECT_TRUE(plan) << text;
  return plan ? plan->scene : SceneGraph{};
}

std::ptrdiff_t count(const SceneGraph& scene, std::string_view category) {
  return std::ranges::count(scene.objects, category, &SceneObject::category);
}

bool related(const SceneGraph& scene, R type, const std::string& target, const std::string& reference) {
  return std::ranges::any_of(scene.relations, [&](const Relation& r) {
    return r.type == type && std::ranges::find(r.targets, target) != r.targets.end() &&
           std::ranges::find(r.references, reference) != r.references.end();
  });
}

bool at_a_wall(const SceneGraph& scene, const std::string& thing) {
  return std::ranges::any_of(scene.relations,
                             [&](const Relation& r) { return r.type == R::kAgainstWall && r.targets == std::vector{thing}; });
}

const Opening* gate_of(const SceneGraph& scene) {
  const auto found = std::ranges::find_if(
      scene.room.openings, [](const Opening& o) { return o.type == OpeningType::kDoor && look_of(o).leaf == Leaf::kSectional; });
  return found == scene.room.openings.end() ? nullptr : &*found;
}

TEST(SetsSaid, WhatIsUsedWithinAnother) {
  EXPECT_TRUE(
      related(planned("Bathroom with a walk-in shower, a shower chair, a toilet and a sink."), R::kIn, "shower_bench_1", "shower_1"));
  EXPECT_TRUE(related(planned("Gym with a squat rack with a bench and a treadmill."), R::kIn, "weight_bench_1", "squat_rack_1"));
  const SceneGraph beside = planned("Gym with a squat rack and a weight bench next to the squat rack.");
  EXPECT_FALSE(related(beside, R::kIn, "weight_bench_1", "squat_rack_1"));
}

TEST(SetsSaid, RailsAtBothSidesComeFromTheWallBehind) {
  const SceneGraph scene = planned("Bathroom with a toilet with grab rails on both sides and a sink.");
  EXPECT_EQ(count(scene, "fold_down_rail"), 2);
  EXPECT_EQ(count(planned("Bathroom with a toilet and a grab rail on the left wall."), "grab_rail"), 1);
}

TEST(SetsSaid, MusicStandsAreBeforeWhoPlays) {
  const SceneGraph scene = planned("Music room with three chairs with music stands.");
  EXPECT_TRUE(related(scene, R::kInFrontOf, "music_stand_1", "chair_1"));
  EXPECT_TRUE(related(scene, R::kInFrontOf, "music_stand_3", "chair_3"));
}

TEST(SetsSaid, BackToBackThingsTouch) {
  const auto apart = [](const SceneGraph& scene) -> std::optional<Mm> {
    const auto beside = std::ranges::find(scene.relations, R::kNextTo, &Relation::type);
    return beside == scene.relations.end() ? std::nullopt : beside->parameters.max;
  };
  EXPECT_EQ(apart(planned("Office with two desks back to back.")), 0);
  EXPECT_NE(apart(planned("Office with two desks back to back, a low cabinet between them.")), 0);
}

TEST(SetsSaid, WhoLiesAndWhoWaitsIsAlongAWall) {
  const SceneGraph scene = planned("Examination room with an exam couch against the right wall, a desk and a folding screen.");
  EXPECT_TRUE(std::ranges::any_of(scene.relations, [](const Relation& r) { return r.type == R::kSideAgainstWall; }));
  EXPECT_TRUE(related(scene, R::kNextTo, "screen_divider_1", "exam_table_1"));
}

TEST(SetsSaid, AWorktopOnTopOfTwoMachines) {
  const SceneGraph scene = planned("Laundry room. Washer and dryer side by side on the long wall with a counter on top.");
  EXPECT_TRUE(related(scene, R::kUnder, "washing_machine_1", "counter_1"));
  EXPECT_TRUE(related(scene, R::kUnder, "dryer_1", "counter_1"));
}

TEST(SetsSaid, BothSidesOfAHallAreItsWalls) {
  const SceneGraph scene =
      planned("Narrow hallway. Coat hooks and a shoe bench on the left, a console table with a mirror above it on the right.");
  EXPECT_TRUE(std::ranges::none_of(scene.relations, [](const Relation& r) { return r.type == R::kLeftOf || r.type == R::kRightOf; }));
  EXPECT_TRUE(at_a_wall(scene, "entryway_bench_1"));
}

TEST(SetsSaid, CarsDriveStraightIn) {
  const SceneGraph two = planned("Two-car garage, 7 x 6.5 m, with a car on the left and a workbench.");
  ASSERT_NE(gate_of(two), nullptr);
  EXPECT_GT(gate_of(two)->width, 4000);
  const SceneGraph one = planned("Garage, 4 x 6 m, with a car.");
  ASSERT_NE(gate_of(one), nullptr);
  EXPECT_LT(gate_of(one)->width, 3000);
  const SceneGraph rolled = planned("Garage with a roll-up door and metal shelves.");
  EXPECT_EQ(std::ranges::count(rolled.room.openings, OpeningType::kDoor, &Opening::type), 1);
}

TEST(SetsSaid, WhatFacesAUnitIsAtTheWallAcross) {
  const SceneGraph scene = planned("Galley kitchen, a range in the middle of the right wall, a sink facing the range, a fridge.");
  EXPECT_TRUE(at_a_wall(scene, "kitchen_sink_1"));
}

TEST(SetsSaid, OneServesTowardsTheRoom) {
  const SceneGraph scene = planned("Cafe with a counter at the back and three tables.");
  EXPECT_TRUE(std::ranges::any_of(
      scene.relations, [](const Relation& r) { return r.type == R::kFacing && r.targets[0].find("counter") != std::string::npos; }));
}

TEST(SetsSaid, ADividerIsAsWideAsTheBedThatItHides) {
  const SceneGraph scene = planned("Studio with a double bed behind an open shelf as a divider and a sofa.");
  const SceneObject* shelf = scene.find_object("shelf_1");
  ASSERT_NE(shelf, nullptr);
  ASSERT_TRUE(shelf->size.has_value());
  EXPECT_GE(shelf->size->usual.width, 1450);
}

}  // namespace
}  // namespace layoutbox
