#include "layoutbox/catalog/normalize.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "layoutbox/catalog/test_kinds.h"
#include "layoutbox/scene/random_scene.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox {
namespace {

using namespace test_kinds;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::Not;

TEST(NormalizeObjects, TakeTheirSizeFromTheCatalogue) {
  const SceneGraph scene = normalized(scene_of({object("desk_1", "desk")}));
  EXPECT_EQ(scene.objects[0].size, catalog().find("desk")->size);
  EXPECT_EQ(scene.objects[0].size_source, SizeSource::kCatalog);
  EXPECT_EQ(scene.objects[0].mount, Mount::kFloor);
  EXPECT_THAT(*scene.objects[0].used_sides, ElementsAre(Side::kFront));
  EXPECT_THAT(scene.notes, Contains(Field(&Note::pointer, "/furniture/0/dims")));
}

// Asked beats assumed: no size or shape of the catalogue's keeps a thing from where the text has it.
TEST(NormalizeGuests, FurnitureIsRaisedAboveWhatIsToBeUnderIt) {
  const SceneGraph scene = normalized(
      scene_of({object("desk_1", "desk"), object("plant_1", "plant")}, {relation(RelationType::kUnder, {"plant_1"}, {"desk_1"})}));
  const SceneObject &desk = scene.objects[0], &plant = scene.objects[1];
  EXPECT_GT(desk.raised, 300);
  EXPECT_LT(plant.size->least.height, desk.raised);
  const std::vector<Space> spaces = spaces_of(desk, *catalog().find("desk"), desk.size->usual);
  ASSERT_FALSE(spaces.empty());
  EXPECT_EQ(spaces.back().name, kSpaceUnderIt);
  EXPECT_EQ(spaces.back().max[2], desk.raised);
}

TEST(NormalizeGuests, AWorktopOverAWashingMachineIsABoardAndTheMachineWholeSized) {
  const auto scene = normalize_scene(scene_of({object("counter_1", "counter"), object("washing_machine_1", "washing_machine")},
                                              {relation(RelationType::kUnder, {"washing_machine_1"}, {"counter_1"})}),
                                     Catalog::builtin());
  ASSERT_TRUE(scene);
  EXPECT_GE(scene->objects[1].size->usual.height, 800);
  EXPECT_GE(scene->objects[0].raised, scene->objects[1].size->usual.height);
}

// A telescope on a desk is a small one; a dryer on its washing machine is as large as that.
TEST(NormalizeGuests, MachinesAreStackedInTheirOwnSize) {
  const auto scene = normalize_scene(scene_of({object("washing_machine_1", "washing_machine"), object("dryer_1", "dryer")},
                                              {relation(RelationType::kOn, {"dryer_1"}, {"washing_machine_1"})}),
                                     Catalog::builtin());
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->objects[1].size, Catalog::builtin().find("dryer")->size);
}

// What is in it needs its shelf: legs would leave none.
TEST(NormalizeGuests, FurnitureKeepsTheShelfOfWhatIsInIt) {
  const auto raised = [](std::vector<Relation> relations) {
    relations.push_back(relation(RelationType::kTuckedUnder, {"plant_1"}, {"workbench_1"}));
    const SceneGraph scene = normalized(
        scene_of({object("workbench_1", "workbench"), object("plant_1", "plant"), object("jar_1", "jar")}, std::move(relations)));
    return scene.objects[0].raised;
  };
  EXPECT_GT(raised({}), 0);
  EXPECT_EQ(raised({relation(RelationType::kIn, {"jar_1"}, {"workbench_1"})}), 0);
}

TEST(NormalizeGuests, WhatIsSaidToBeUnderSomethingElseOrNowhereLeavesItAsItIs) {
  for (const RelationType type : {RelationType::kNextTo, RelationType::kOn}) {
    const SceneGraph scene =
        normalized(scene_of({object("desk_1", "desk"), object("book_1", "book")}, {relation(type, {"book_1"}, {"desk_1"})}));
    EXPECT_EQ(scene.objects[0].raised, 0);
    EXPECT_EQ(scene.objects[1].size, catalog().find("book")->size);
  }
}

TEST(NormalizeGuests, AVesselIsHollowWhereSomethingIsInIt) {
  const auto scene = [](const char* host) {
    return normalized(scene_of({object("host", host), object("book_1", "book")}, {relation(RelationType::kIn, {"book_1"}, {"host"})}));
  };
  const SceneGraph jar = scene("jar");
  EXPECT_TRUE(jar.objects[0].hollow);
  EXPECT_LT(jar.objects[1].size->usual.width, 120);  // a book is 20 cm wide, the jar 12
  EXPECT_FALSE(scene("nightstand").objects[0].hollow);
}

TEST(NormalizeGuests, ManyInOneVesselAreAllSmallEnough) {
  std::vector<SceneObject> objects{object("jar_1", "jar")};
  std::vector<Relation> relations;
  for (int i = 0; i < 2; ++i) {
    objects.push_back(object("book_" + std::to_string(i), "book"));
    relations.push_back(relation(RelationType::kIn, {objects.back().id}, {"jar_1"}));
  }
  const SceneGraph scene = normalized(scene_of(objects, relations));
  const std::vector<Space> spaces = spaces_of(scene.objects[0], *catalog().find("jar"), scene.objects[0].size->usual);
  ASSERT_FALSE(spaces.empty());
  double covered = 0;
  for (int i = 1; i <= 2; ++i)
    covered += double(scene.objects[static_cast<std::size_t>(i)].size->usual.width) * scene.objects[1].size->usual.depth;
  EXPECT_LT(covered, (spaces[0].max[0] - spaces[0].min[0]) * (spaces[0].max[1] - spaces[0].min[1]));
}

TEST(NormalizeRelations, APartThatAThingDoesNotHaveIsRefusedWithThoseItHas) {
  const auto with_part = [](RelationType type, const char* part) {
    Relation said = relation(type, {"book_1"}, {"wardrobe_1"});
    said.parameters.part = ThingPart(part);
    SceneObject wardrobe = object("wardrobe_1", "wardrobe");
    wardrobe.spaces = {{"shelf 1", {-300, -250, 100}, {300, 250, 900}}, {"shelf 2", {-300, -250, 950}, {300, 250, 1800}}};
    wardrobe.spaces_given = true;
    return normalize_scene(scene_of({wardrobe, object("book_1", "book")}, {said}), catalog());
  };
  for (const char* part : {"left", "back right corner", "top", "shelf 1"}) EXPECT_TRUE(with_part(RelationType::kOn, part)) << part;
  EXPECT_TRUE(with_part(RelationType::kIn, "shelf 2"));
  EXPECT_FALSE(with_part(RelationType::kIn, "top"));
  const auto refused = with_part(RelationType::kOn, "xyz");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().pointer, "/constraints/0/part");
  EXPECT_THAT(refused.error().message, HasSubstr("\"xyz\", which wardrobe_1 does not have"));
  EXPECT_THAT(refused.error().hint, AllOf(HasSubstr("left, right, center"), HasSubstr("shelf 1, shelf 2")));
}

TEST(NormalizeObjects, WhatWasKnockedOverLiesOnItsSide) {
  SceneObject chair = object("chair_1", "chair"), lying = object("chair_2", "chair");
  lying.attributes = {"overturned"};
  const SceneGraph scene = normalized(scene_of({chair, lying}));
  const Size up = scene.objects[0].size->usual, down = scene.objects[1].size->usual;
  EXPECT_EQ(down.height, up.width);
  EXPECT_EQ(down.width, up.height);
  EXPECT_TRUE(scene.objects[1].used_sides->empty());
}

TEST(NormalizeObjects, WordsNarrowTheSize) {
  SceneObject king = object("bed_1", "bed"), tall = object("plant_1", "plant"), small = object("desk_1", "desk");
  king.name = "king size bed";
  tall.attributes = {"tall"};
  small.attributes = {"small"};
  const SceneGraph scene = normalized(scene_of({king, tall, small}));
  EXPECT_EQ(scene.objects[0].size->least.width, 1800);
  EXPECT_EQ(scene.objects[0].size->least.depth, 1900);
  EXPECT_GE(scene.objects[1].size->least.height, 800);
  EXPECT_GT(scene.objects[1].size->usual.height, 1000);
  EXPECT_EQ(scene.objects[1].size->usual.width, 400);
  EXPECT_LE(scene.objects[2].size->greatest.width, 1200);
  EXPECT_LT(scene.objects[2].size->usual.width, 1100);
}

TEST(NormalizeObjects, GivenSidesStayExact) {
  SceneObject desk = object("desk_1", "desk"), lamp = object("lamp_1", "lamp"), bed = object("bed_1", "bed");
  desk.size = SizeRange{{1234, 0, 0}, {1234, 0, 0}, {1234, 0, 0}};
  lamp.size = SizeRange{{250, 0, 0}, {250, 0, 0}, {250, 0, 0}};
  bed.size = SizeRange{{3, 3, 3}, {3, 3, 3}, {3, 3, 3}};
  const SceneGraph scene = normalized(scene_of({desk, lamp, bed}));
  EXPECT_EQ(scene.objects[0].size, (SizeRange{{1234, 500, 750}, {1234, 600, 750}, {1234, 800, 750}}));
  EXPECT_EQ(scene.objects[0].size_source, SizeSource::kInferred);
  EXPECT_EQ(scene.objects[1].size->least.depth, 250) << "what is as deep as wide stays so";
  EXPECT_EQ(scene.objects[2].size->usual, (Size{3, 3, 3})) << "odd sizes are not changed";
}

TEST(NormalizeObjects, ScaleIsWorkedIntoTheSize) {
  SceneObject desk = object("desk_1", "desk");
  desk.size = SizeRange{{1000, 500, 700}, {1000, 500, 700}, {1000, 500, 700}};
  desk.scale = {1, 2, 0.5};
  const SceneGraph scene = normalized(scene_of({desk}));
  EXPECT_EQ(scene.objects[0].size->usual, (Size{1000, 1000, 350}));
  EXPECT_EQ(scene.objects[0].scale, (std::array<double, 3>{1, 1, 1}));
}

TEST(NormalizeObjects, ImpossibleSizesAreErrors) {
  SceneObject desk = object("desk_1", "desk");
  desk.size = SizeRange{{-5, 500, 700}, {-5, 500, 700}, {-5, 500, 700}};
  EXPECT_EQ(error_of(scene_of({desk})).code, ErrorCode::kGeometry);
  desk.size = SizeRange{{60'000, 500, 700}, {60'000, 500, 700}, {60'000, 500, 700}};
  EXPECT_EQ(error_of(scene_of({desk})).pointer, "/furniture/0/dims");
  desk.size = SizeRange{{2000, 500, 700}, {1000, 500, 700}, {3000, 500, 700}};
  EXPECT_EQ(error_of(scene_of({desk})).pointer, "/furniture/0/dimsRange");
}

TEST(NormalizeObjects, CategoriesBecomeEntriesOrStayTheirOwn) {
  SceneObject writing = object("a", "Writing Desk"), king = object("b", "king bed"), picnic = object("c", "picnic desk"),
              odd = object("d", "spaceship");
  const SceneGraph scene = normalized(scene_of({writing, king, picnic, odd}));
  EXPECT_EQ(scene.objects[0].category, "desk");
  EXPECT_EQ(scene.objects[1].category, "bed");
  EXPECT_EQ(scene.objects[1].size->usual.width, 1900);
  EXPECT_EQ(scene.objects[2].category, "picnic_desk") << "a kind of its own stays that kind";
  EXPECT_EQ(scene.objects[2].size->usual.width, 1200);
  EXPECT_EQ(scene.objects[3].category, "spaceship");
  EXPECT_THAT(scene.notes,
              Contains(AllOf(Field(&Note::code, "warning"), Field(&Note::message, "\"spaceship\" is not known: it is a plain box"))));
}

TEST(NormalizeObjects, AnUnknownThingIsSpokenOfOnce) {
  SceneGraph scene = scene_of({object("a", "spaceship"), object("b", "spaceship"), object("c", "wok")});
  scene.notes.push_back(unknown_kind_note("spaceship", catalog().entry_or_nearest("spaceship"), "prompt:2-11"));
  const SceneGraph filled = normalized(std::move(scene));
  const auto speaks_of = [&](std::string_view name) {
    return std::ranges::count_if(filled.notes,
                                 [&](const Note& note) { return note.message.starts_with("\"" + std::string(name) + "\" is not"); });
  };
  EXPECT_EQ(speaks_of("spaceship"), 1);
  EXPECT_EQ(speaks_of("wok"), 1);
}

TEST(NormalizeObjects, IdsBecomeUnique) {
  const SceneGraph scene = normalized(scene_of({object("bed", "bed"), object("bed", "bed"), object("", "desk"), object("room", "desk")}));
  std::vector<std::string> ids;
  for (const SceneObject& item : scene.objects) ids.push_back(item.id);
  std::ranges::sort(ids);
  EXPECT_EQ(std::ranges::adjacent_find(ids), ids.end());
  EXPECT_THAT(ids, Not(Contains("room")));
  EXPECT_THAT(ids, Contains("bed"));
}

TEST(NormalizeObjects, RelationsDecideTheMount) {
  const SceneGraph scene =
      normalized(scene_of({object("plant_1", "plant"), object("plant_2", "plant"), object("plant_3", "plant"), object("desk_1", "desk"),
                           object("rug_1", "rug"), object("lamp_1", "lamp")},
                          {relation(RelationType::kOn, {"plant_1"}, {"desk_1"}), relation(RelationType::kOnWall, {"plant_2"}, {"back"}),
                           relation(RelationType::kOn, {"plant_3"}, {"rug_1"}), relation(RelationType::kOn, {"lamp_1"}, {"floor"})}));
  EXPECT_EQ(scene.objects[0].mount, Mount::kSurface);
  EXPECT_EQ(scene.objects[1].mount, Mount::kWall);
  EXPECT_EQ(scene.objects[2].mount, Mount::kFloor) << "what stands on a rug stands on the floor";
  EXPECT_EQ(scene.objects[5].mount, Mount::kFloor);
  EXPECT_THAT(scene.relations[1].references, ElementsAre("wall3"));
}

TEST(NormalizeObjects, AMountIsAssumedWhereNoRelationSaysIt) {
  const SceneGraph scene =
      normalized(scene_of({object("a", "lamp"), object("b", "tv"), object("c", "wardrobe"), object("d", "desk")},
                          {relation(RelationType::kOn, {"a"}, {"floor"}), relation(RelationType::kOnWall, {"c"}, {"back"})}));
  EXPECT_EQ(scene.objects[0].mount, Mount::kFloor);
  EXPECT_FALSE(scene.objects[0].mount_assumed);
  EXPECT_TRUE(scene.objects[1].mount_assumed);
  EXPECT_FALSE(scene.objects[2].mount_assumed);
  EXPECT_TRUE(scene.objects[3].mount_assumed);
}

TEST(NormalizeRelations, ToNobodyAreLeftOutAndNoted) {
  const SceneGraph scene = normalized(
      scene_of({object("bed_1", "bed"), object("desk_1", "desk")},
               {relation(RelationType::kNear, {"desk_1"}, {"ghost"}), relation(RelationType::kRow, {"bed_1", "ghost", "desk_1"}, {}),
                relation(RelationType::kNearDoor, {"desk_1"}, {"door"})}));
  ASSERT_EQ(scene.relations.size(), 2u);
  EXPECT_THAT(scene.relations[0].targets, ElementsAre("bed_1", "desk_1"));
  EXPECT_THAT(scene.relations[1].references, ElementsAre("door1"));
  EXPECT_THAT(scene.notes, Contains(Field(&Note::message, HasSubstr("ghost"))));
  EXPECT_NE(scene.relations[0].id, scene.relations[1].id);
}

// What solve() requires holds for whatever came in, and a second time changes nothing.
// Six desks in rows of three that look at a board on the left wall: three abreast before it, straight at its wall.
TEST(NormalizeGrids, RowsLookStraightAtTheWallOfWhatTheyLookAt) {
  std::vector<SceneObject> objects{object("board_1", "whiteboard")};
  std::vector<Relation> relations{relation(RelationType::kOnWall, {"board_1"}, {"left"})};
  Relation grid = relation(RelationType::kGrid, {}, {});
  grid.parameters.columns = 3;
  for (int i = 1; i <= 6; ++i) {
    const std::string id = "school_desk_" + std::to_string(i);
    objects.push_back(object(id, "school_desk"));
    grid.targets.push_back(id);
    relations.push_back(i == 1 ? relation(RelationType::kFacing, {id}, {"board_1"})
                               : relation(RelationType::kSameOrientation, {id}, {"school_desk_1"}));
  }
  relations.push_back(grid);
  SceneGraph scene = scene_of(objects, relations);
  scene.prompt = "Six desks in rows of three face the board on the left wall.";
  scene = normalized(scene);
  const auto of = [&](RelationType type) { return std::ranges::find(scene.relations, type, &Relation::type); };
  EXPECT_EQ(of(RelationType::kGrid)->parameters.columns, 2);
  EXPECT_THAT(of(RelationType::kGrid)->targets,
              ElementsAre("school_desk_1", "school_desk_4", "school_desk_2", "school_desk_5", "school_desk_3", "school_desk_6"))
      << "who is in the middle of a row stays there";
  const std::string wall = of(RelationType::kOnWall)->references.at(0);
  const auto straight = [&](const Relation& r) {
    return r.type == RelationType::kFacing && r.references == std::vector<std::string>{wall};
  };
  EXPECT_EQ(std::ranges::count_if(scene.relations, straight), 1);
  EXPECT_EQ(std::ranges::count_if(normalized(scene).relations, straight), 1);
}

TEST(NormalizeScene, AnyValidSceneBecomesCompleteAndStaysSo) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const auto first = normalize_scene(RandomScenes(seed).scene(), Catalog::builtin());
    if (!first) {
      EXPECT_EQ(first.error().code, ErrorCode::kGeometry) << "seed " << seed << ": " << first.error().message;
      continue;
    }
    EXPECT_GE(first->room.polygon.size(), 3u) << "seed " << seed;
    EXPECT_GT(doubled_area(first->room.polygon), 0);
    ASSERT_EQ(first->room.walls.size(), first->room.polygon.size());
    for (std::size_t i = 0; i < first->room.walls.size(); ++i)
      ASSERT_EQ(first->room.walls[i].start, first->room.polygon[i]) << "seed " << seed;
    EXPECT_GT(first->room.height, 0);
    for (const SceneObject& item : first->objects) {
      ASSERT_TRUE(item.size && item.mount && item.used_sides) << "seed " << seed;
      ASSERT_GT(item.size->least.width, 0) << "seed " << seed;
      ASSERT_LE(item.size->least.height, item.size->greatest.height) << "seed " << seed;
    }
    auto again = normalize_scene(*first, Catalog::builtin());
    ASSERT_TRUE(again) << "seed " << seed;
    again->notes = first->notes;
    ASSERT_EQ(write_scene(*again), write_scene(*first)) << "seed " << seed;
    ASSERT_TRUE(read_scene(write_scene(*first))) << "seed " << seed;
  }
}

}  // namespace
}  // namespace layoutbox
