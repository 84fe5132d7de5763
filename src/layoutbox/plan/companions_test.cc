// What comes with what is named, and what never does.
#include "layoutbox/plan/companions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "layoutbox/catalog/groups.h"
#include "layoutbox/catalog/normalize.h"
#include "layoutbox/plan/planner.h"

namespace layoutbox {
namespace {

// The kinds that come besides what the text names.
std::vector<std::string> added_to(const std::string& prompt) {
  static const std::unique_ptr<Planner> planner = make_offline_planner(Catalog::builtin());
  auto plan = planner->plan(prompt, {});
  EXPECT_TRUE(plan) << prompt;
  if (!plan) return {};
  const auto sized = normalize_scene(plan->scene, Catalog::builtin(), {});
  EXPECT_TRUE(sized) << prompt;
  SceneGraph scene = plan->scene;
  const std::size_t count = add_companions(scene, *sized, plan->unwanted, Catalog::builtin());
  EXPECT_EQ(scene.objects.size(), plan->scene.objects.size() + count);
  EXPECT_TRUE(normalize_scene(scene, Catalog::builtin(), {})) << prompt;
  std::vector<std::string> kinds;
  for (const SceneObject& object : scene.objects) {
    if (object.origin == Origin::kAdded) kinds.push_back(object.category);
  }
  return kinds;
}

int count_of(const std::vector<std::string>& kinds, const std::string& kind) {
  return static_cast<int>(std::count(kinds.begin(), kinds.end(), kind));
}

TEST(Companions, SeatsComeWithDesksAndTables) {
  // The pupils' chairs are told to be at their own desks.
  EXPECT_EQ(count_of(added_to("A classroom, 8 x 7 m, with 6 desks, two chairs at every desk, and a teacher's desk."), "office_chair"), 1);
  EXPECT_EQ(count_of(added_to("A bedroom, 4 x 4 m, with a bed, a wardrobe and a desk for homework."), "office_chair"), 1);
  EXPECT_GE(count_of(added_to("A dining room, 4 x 4 m, with a dining table and a sideboard."), "dining_chair"), 4);
  EXPECT_EQ(count_of(added_to("A bedroom with a bed, a wardrobe and a dressing table."), "vanity_stool"), 1);
}

TEST(Companions, NothingOutOfThemeAndNothingFromAnotherRoom) {
  EXPECT_EQ(count_of(added_to("A barracks room with two bunk beds and a table."), "table_lamp"), 0);
  EXPECT_TRUE(added_to("A bare cell with a bed and a chair.").empty());
  EXPECT_TRUE(added_to("A room with as little as possible: a bed and a chair.").empty());
  EXPECT_EQ(count_of(added_to("A meeting room with a whiteboard and two glasses below it."), "nightstand"), 0);
}

TEST(Companions, DesksHaveTheirChairsBesideThoseOfAnotherTable) {
  EXPECT_EQ(count_of(added_to("A home office with two desks facing each other and a meeting table with four chairs."), "office_chair"), 2);
  EXPECT_EQ(count_of(added_to("A bedroom with a bed, a desk and a chair."), "office_chair"), 0);
}

TEST(Companions, ABedForTwoHasANightstandAtEachSide) {
  EXPECT_EQ(count_of(added_to("A bedroom, 4 x 4 m, with a queen bed and a wardrobe."), "nightstand"), 2);
  EXPECT_EQ(count_of(added_to("A bedroom, 4 x 4 m, with a single bed and a wardrobe."), "nightstand"), 1);
  // One at its other side would keep it out of its corner.
  EXPECT_EQ(count_of(added_to("A bedroom, 4 x 4 m, with a double bed in the left corner and a wardrobe."), "nightstand"), 1);
}

TEST(Companions, WhoIsVisitedAtADeskSitsBehindIt) {
  EXPECT_EQ(count_of(added_to("A doctor's office with a desk, two chairs for patients and a cabinet."), "office_chair"), 1);
}

TEST(Companions, ATableToSitAtGetsItsSeats) {
  EXPECT_GE(count_of(added_to("A studio with a bed, a wardrobe and a small table to eat and work at."), "chair"), 1);
  EXPECT_EQ(count_of(added_to("A studio with a bed, a wardrobe and a small table for the plants."), "chair"), 0);
}

TEST(Companions, ToysOnTheFloorFurnishNoRoom) { EXPECT_GE(added_to("A living room with toys on the floor in the middle.").size(), 3u); }

TEST(Companions, ACrowdOfSeatsNeedsNoDesks) {
  EXPECT_EQ(count_of(added_to("A lecture room with twelve chairs in rows facing a screen."), "school_desk"), 0);
  EXPECT_GE(count_of(added_to("A lecture room with a lectern."), "theater_seat"), 1);
}

TEST(Companions, NoChairsWhereOtherSeatsAreByTheTable) {
  EXPECT_EQ(count_of(added_to("A dining room with a dining table. A bench stands next to the dining table."), "dining_chair"), 0);
  EXPECT_EQ(count_of(added_to("A playroom with an activity table. Two floor cushions lie beside the table."), "kids_chair"), 0);
}

TEST(Companions, WhatNothingCarriesGetsSomethingToStandOn) {
  EXPECT_EQ(count_of(added_to("A bedroom with a double bed flanked by two bedside lamps."), "nightstand"), 2);
  EXPECT_EQ(added_to("A living room with a sofa, and a record player in the corner.").size(), 1u);
  EXPECT_EQ(count_of(added_to("A study, 3 x 3 m, with two monitors and an armchair."), "desk"), 1);
  EXPECT_EQ(count_of(added_to("A study, 3 x 3 m, with a desk, a stool and a monitor."), "desk"), 0);
}

TEST(Companions, ATextThatSaysWhereThingsStandIsNotFilledUp) {
  EXPECT_TRUE(added_to("A supermarket with a shelf unit against the wall and a shopping cart in front of the shelf unit.").empty());
}

// Things in a row, evenly apart or turned to one another may be anywhere: the room is filled up as if that were not said.
TEST(Companions, OrderAndTurnsAloneSayNotWhereThingsStand) {
  static const std::unique_ptr<Planner> planner = make_offline_planner(Catalog::builtin());
  const auto plan = planner->plan("A classroom of 148 square meters with six school desks.", {});
  ASSERT_TRUE(plan);
  const auto added_beside = [&](RelationType type) {
    SceneGraph scene = plan->scene;
    Relation said;
    said.id = "said", said.type = type, said.origin = Origin::kAsked;
    said.targets = {scene.objects.at(0).id};
    (relation_row(type).arity == RelationArity::kNone ? said.targets : said.references).push_back(scene.objects.at(1).id);
    scene.relations.push_back(said);
    const auto sized = normalize_scene(scene, Catalog::builtin(), {});
    EXPECT_TRUE(sized);
    return sized ? add_companions(scene, *sized, plan->unwanted, Catalog::builtin()) : 0;
  };
  const std::size_t nothing_said = added_beside(RelationType::kRow);
  EXPECT_GT(nothing_said, added_beside(RelationType::kLeftOf));
  for (const RelationType type : {RelationType::kEvenlySpaced, RelationType::kParallel, RelationType::kPerpendicular})
    EXPECT_EQ(added_beside(type), nothing_said) << relation_row(type).name;
}

TEST(Companions, ALampComesWithABed) {
  EXPECT_EQ(count_of(added_to("A bedroom, 4 x 4 m, with a bed, two nightstands and a wardrobe."), "table_lamp"), 2);
  EXPECT_EQ(count_of(added_to("A bedroom, 4 x 4 m, with a bed and a floor lamp."), "table_lamp"), 0);
}

TEST(Companions, NothingThatTheTextNamesCountsOrWantsNoneOf) {
  EXPECT_THAT(added_to("A study, 3 x 3 m, with two desks, one chair, a bookshelf, a lamp."),
              testing::Not(testing::Contains("office_chair")));
  EXPECT_EQ(count_of(added_to("A study, 3 x 3 m, with a desk and a stool, a lamp."), "office_chair"), 0);
  EXPECT_EQ(count_of(added_to("A study, 3 x 3 m, with a desk, a sofa and a lamp."), "office_chair"), 1);
  EXPECT_THAT(added_to("A study, 3 x 3 m, with a desk but no chair, and a lamp."), testing::Not(testing::Contains("office_chair")));
  EXPECT_TRUE(added_to("An office with a desk and nothing else.").empty());
  EXPECT_TRUE(added_to("A bedroom").empty()) << "it has what is usual already";
}

TEST(Companions, BareRoomsOfAKnownKindGetSomeOfWhatIsUsual) {
  const std::vector<std::string> kinds = added_to("A classroom of 148 square meters with six school desks.");
  EXPECT_EQ(count_of(kinds, "student_chair"), 6);
  EXPECT_GE(count_of(kinds, "chalkboard") + count_of(kinds, "teacher_desk") + count_of(kinds, "bookshelf"), 2);
  EXPECT_THAT(added_to("A minimalist bedroom of 40 square meters with a single bed."), testing::Not(testing::Contains("wardrobe")));
}

TEST(Companions, ARoomOfWhichHardlyAnythingIsNamedIsFurnished) {
  const std::vector<std::string> living = added_to("A cosy living room with a fireplace.");
  for (const char* kind : {"sofa", "coffee_table", "rug"}) EXPECT_EQ(count_of(living, kind), 1) << kind;
  EXPECT_EQ(count_of(added_to("A bedroom with a desk."), "bed"), 1);
  EXPECT_TRUE(added_to("A study, 3 x 3 m, with only a desk and an office chair.").empty());
}

TEST(Companions, AKitchenHasWorktops) {
  EXPECT_EQ(count_of(added_to("A kitchen with a sink, a dishwasher, a fridge and a table in the middle."), "base_cabinet"), 2);
  EXPECT_EQ(count_of(added_to("A kitchen with a sink, a stove and two counters."), "base_cabinet"), 0);
  EXPECT_EQ(count_of(added_to("A kitchen with a hob and a table in the middle."), "base_cabinet"), 1);
}

TEST(Companions, WhatIsAtAWallHasATableThereWhereTheOnlyOneHasTheMiddle) {
  const auto tables = [](const std::string& prompt) {
    const std::vector<std::string> kinds = added_to(prompt);
    return count_of(kinds, "sewing_table") + count_of(kinds, "desk") + count_of(kinds, "table");
  };
  EXPECT_EQ(tables("A sewing room with a cutting table in the middle and a sewing machine under the window."), 1);
  EXPECT_EQ(tables("A sewing room with a cutting table in the middle and a sewing machine."), 0);
}

TEST(Companions, NeverWhereOnlyTheUsersArticlesMayBePlaced) {
  const Catalog only({Catalog::builtin().entries().begin(), Catalog::builtin().entries().end()}, {}, true);
  SceneGraph scene;
  scene.prompt = "a desk";
  SceneObject desk;
  desk.id = "desk_1", desk.category = desk.name = "desk";
  scene.objects.push_back(desk);
  EXPECT_EQ(add_companions(scene, scene, {}, only), 0u);
}

TEST(Groups, SizesGrowWithTheSeats) {
  const Seating* table = Groups::builtin().seating_at(Catalog::builtin(), *Catalog::builtin().find("table"), "");
  ASSERT_NE(table, nullptr);
  Mm before = 0;
  for (int seats = 1; seats <= 30; ++seats) {
    const auto size = size_for_seats(*table, false, seats);
    ASSERT_TRUE(size);
    EXPECT_GE(size->width, before);
    before = size->width;
  }
  EXPECT_GE(size_for_seats(*table, false, 12)->width, 3000);
  for (const Seating& seating : Groups::builtin().seatings) {
    EXPECT_NE(Catalog::builtin().find(seating.at), nullptr) << seating.at;
    EXPECT_TRUE(seating.seat.empty() || Catalog::builtin().find(seating.seat) != nullptr) << seating.seat;
  }
  for (const std::string& id : Groups::builtin().carried) EXPECT_NE(Catalog::builtin().find(id), nullptr) << id;
  for (const Companion& companion : Groups::builtin().companions) {
    EXPECT_NE(Catalog::builtin().find(companion.of), nullptr) << companion.of;
    EXPECT_NE(Catalog::builtin().find(companion.adds), nullptr) << companion.adds;
    for (const std::string& id : companion.unless) EXPECT_NE(Catalog::builtin().find(id), nullptr) << id;
  }
}

TEST(Companions, WhoComesInAWheelchairNeedsNoChairAtTheDesk) {
  EXPECT_THAT(added_to("Study with a desk and a bookshelf."), testing::Contains("office_chair"));
  EXPECT_THAT(added_to("Study with a desk, a wheelchair and a bookshelf."), testing::Not(testing::Contains("office_chair")));
}

}  // namespace
}  // namespace layoutbox
