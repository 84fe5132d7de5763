// What gives way when not everything fits: never a door, never by an overlap.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"
#include "layoutbox/verify/verify.h"

namespace layoutbox::placement {
namespace {

using testing::HasSubstr;

std::size_t count_of(const Layout& layout, const std::string& category) {
  return static_cast<std::size_t>(
      std::count_if(layout.objects.begin(), layout.objects.end(), [&](const PlacedObject& o) { return o.category == category; }));
}

double opening_clearance(const Layout& layout) { return verify(layout, Catalog::builtin()).metrics.at("openingClearance"); }

// The paper's sixth prompt: more than 4 × 2 m hold.
TEST(Relax, TooMuchFurnitureLeavesTheDoorFree) {
  const SceneGraph scene = SceneMaker(4000, 2000)
                               .opening(OpeningType::kDoor, "wall1", 300)
                               .add("bed", 3)
                               .add("desk", 3)
                               .add("lamp", 3)
                               .add("bookshelf")
                               .add("plant")
                               .make(true);
  const auto layout = solve(scene, Catalog::builtin());
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->status, LayoutStatus::kRelaxed);
  expect_sound(*layout);
  EXPECT_EQ(opening_clearance(*layout), 1.0);
  EXPECT_GE(layout->objects.size(), 9u) << "no more is left out than need be";
  EXPECT_GE(count_of(*layout, "bed"), 1u);
  EXPECT_EQ(count_of(*layout, "bookshelf"), 1u) << "the only one of its kind stays";
  for (const SceneObject& object : scene.objects) {
    const auto says = [&](const Relaxation& r) { return r.relation == object.id && r.why.find("left out") != std::string::npos; };
    if (layout->find_object(object.id) == nullptr) {
      EXPECT_TRUE(std::any_of(layout->relaxed.begin(), layout->relaxed.end(), says)) << object.id;
    }
  }
  ASSERT_FALSE(layout->conflicts.empty());
  EXPECT_THAT(layout->conflicts[0].sentence, HasSubstr("m² of floor"));
}

TEST(Relax, RelationsKeepWhomTheyStillHave) {
  const auto layout = solve(SceneMaker(2600, 2400)
                                .opening(OpeningType::kDoor, "wall1", 300)
                                .add("bed", 3)
                                .relate("againstWall", {"bed_1", "bed_2", "bed_3"}, {"wall3"})
                                .add("nightstand")
                                .relate("nextTo", {"nightstand_1"}, {"bed_1"})
                                .make(true),
                            Catalog::builtin());
  ASSERT_TRUE(layout);
  expect_sound(*layout);
  EXPECT_EQ(opening_clearance(*layout), 1.0);
  EXPECT_TRUE(verify(*layout, Catalog::builtin()).passed);
}

TEST(Relax, WhatIsSaidOfAnObjectThatIsLeftOutIsListed) {
  const auto layout =
      solve(SceneMaker(2500, 2000).add("bed").sized(3000, 2800, 500).add("plant").relate("leftOf", {"plant_1"}, {"bed_1"}).make(),
            Catalog::builtin());
  ASSERT_TRUE(layout);
  EXPECT_NE(layout->find_object("plant_1"), nullptr);
  const auto listed = std::find_if(layout->relaxed.begin(), layout->relaxed.end(), [](const Relaxation& r) { return r.relation == "c1"; });
  ASSERT_NE(listed, layout->relaxed.end());
  EXPECT_THAT(listed->why, HasSubstr("the plant stands to the left of the bed"));
}

// Seed 72875 of the planted scenes: with a target left out there are too few for the pairs, which is no conflict of its own.
TEST(Relax, PairsEndWithATargetThatIsLeftOut) {
  const auto layout = solve(SceneMaker(2400, 2400)
                                .add("chest")
                                .sized(1600, 1900, 500)
                                .add("chest")
                                .sized(1600, 1900, 500)
                                .add("plant", 2)
                                .relate("pairedWith", {"chest_1", "chest_2"}, {"plant_1", "plant_2"})
                                .make(),
                            Catalog::builtin());
  ASSERT_TRUE(layout);
  EXPECT_EQ(count_of(*layout, "chest"), 1u);
  EXPECT_EQ(count_of(*layout, "plant"), 2u);
  for (const Conflict& conflict : layout->conflicts) EXPECT_THAT(conflict.relations, testing::Not(testing::Contains("c1")));
  EXPECT_TRUE(std::any_of(layout->relaxed.begin(), layout->relaxed.end(), [](const Relaxation& r) { return r.relation == "c1"; }));
}

SceneMaker& weighing(SceneMaker& maker, int weight) {
  maker.raw().relations.back().weight = weight;
  return maker;
}

// The widths at the back wall are looked at first: the wardrobe gives way to the bed, which then has to stand elsewhere.
TEST(Relax, WhatWasGivenUpForNothingComesBack) {
  SceneMaker maker(3200, 3400);
  maker.add("bed").sized(1600, 2000, 500).add("wardrobe").sized(2400, 600, 2000);
  weighing(maker.relate("againstWall", {"bed_1"}, {"wall3"}), 50);
  weighing(maker.relate("againstWall", {"wardrobe_1"}, {"wall3"}), 10);
  weighing(maker.relate("againstWall", {"bed_1"}, {"wall1"}), 100);
  SolveOptions options;
  options.improve = false;  // what is still wished for may come back by itself
  const auto layout = solve(maker.make(), Catalog::builtin(), options);
  ASSERT_TRUE(layout);
  EXPECT_TRUE(holds(*layout, "c2"));
  EXPECT_TRUE(holds(*layout, "c3"));
  ASSERT_EQ(layout->relaxed.size(), 1u);
  EXPECT_EQ(layout->relaxed[0].relation, "c1");
}

// What can never be is given up, not the many things that can; with CP-SAT at hand or without.
TEST(Relax, OneImpossibleWishCostsNoOther) {
  RelationParameters across;
  across.min = 1200, across.max = 4000;
  SceneMaker maker(3400, 3400);
  maker.add("crib").add("changing_table").add("bookshelf").add("rocking_chair").add("ottoman").add("side_table").add("book", 3);
  maker.add("table_lamp").add("rug").add("toy_chest");
  maker.relate("againstWall", {"crib_1"}).relate("leftOf", {"bookshelf_1"}, {"crib_1"});
  RelationParameters far;
  far.min = 4000;  // in so small a room
  maker.relate("far", {"crib_1"}, {"toy_chest_1"}, far).relate("nextTo", {"toy_chest_1"}, {"bookshelf_1"});
  maker.relate("distance", {"changing_table_1"}, {"crib_1"}, across).relate("inFrontOf", {"ottoman_1"}, {"rocking_chair_1"});
  maker.relate("rightOf", {"side_table_1"}, {"rocking_chair_1"}).relate("on", {"table_lamp_1"}, {"side_table_1"});
  for (const char* book : {"book_1", "book_2", "book_3"}) maker.relate("in", {book}, {"bookshelf_1"});
  maker.relate("centerOfRoom", {"rug_1"});
  for (const bool prove : {true, false}) {
    SolveOptions options;
    options.prove = prove;
    const auto layout = solve(maker.make(true), Catalog::builtin(), options);
    ASSERT_TRUE(layout);
    std::size_t broken = 0;
    for (const PlacedRelation& placed : layout->relations) broken += placed.relation.hard && !placed.held;
    EXPECT_EQ(broken, 1u) << (prove ? "with a proof" : "without");
    EXPECT_FALSE(holds(*layout, "c3"));
  }
}

TEST(Relax, WordsThatBlockADoorAreHeldAndTheDoorIsListed) {
  const auto layout = solve(SceneMaker(3000, 3000)
                                .opening(OpeningType::kDoor, "wall1", 1050)
                                .add("wardrobe")
                                .sized(1200, 600, 2000)
                                .relate("centeredOnWall", {"wardrobe_1"}, {"wall1"})
                                .make(true),
                            Catalog::builtin());
  ASSERT_TRUE(layout);
  EXPECT_TRUE(holds(*layout, "c1"));
  EXPECT_TRUE(layout->relaxed.empty());  // nothing that was asked for
  ASSERT_EQ(layout->gave_way.size(), 1u);
  EXPECT_EQ(layout->gave_way[0].relation, "door swing of door1");
}

}  // namespace
}  // namespace layoutbox::placement
