// Layouts that guide: mending, locking, least movement.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "layoutbox/scene/layout_scene.h"
#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

using testing::HasSubstr;

PlacedObject piece(const std::string& id, const std::string& kind, Size size, double x, double y, double turn = 0) {
  PlacedObject object;
  object.id = id, object.category = object.name = kind;
  object.size = size;
  object.position = {x, y, 0};
  object.rotation_deg = turn;
  return object;
}

Layout empty_room(Mm width, Mm depth) {
  Layout layout;
  layout.room.polygon = {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
  layout.room.height = 2600;
  layout.room.openings_given = true;
  return layout;
}

// Bed and wardrobe overlap by 0.1 m, the desk sticks out of the room by 0.2 m; the plant is fine.
Layout bad_bedroom() {
  Layout layout = empty_room(4000, 4000);
  layout.objects = {piece("bed", "bed", {1600, 2000, 500}, 1000, 2980), piece("wardrobe", "wardrobe", {1200, 600, 2000}, 2300, 3680),
                    piece("desk", "desk", {1200, 600, 740}, 3900, 1000, 270), piece("plant", "plant", {300, 300, 800}, 200, 200)};
  return layout;
}

Result<Layout> try_to_mend(const Layout& from, SolveOptions options = {}) {
  auto scene = normalize_scene(scene_of(from), Catalog::builtin());
  EXPECT_TRUE(scene) << scene.error().message;
  options.from = &from;
  return solve(*scene, Catalog::builtin(), options);
}

Layout mended(const Layout& from, SolveOptions options = {}) {
  auto layout = try_to_mend(from, options);
  EXPECT_TRUE(layout) << layout.error().message;
  if (!layout) return {};
  expect_sound(*layout);
  return *std::move(layout);
}

double way(const Layout& from, const Layout& to, const std::string& id) {
  const PlacedObject &a = *from.find_object(id), &b = *to.find_object(id);
  return std::hypot(a.position[0] - b.position[0], a.position[1] - b.position[1]);
}

TEST(Guide, OverlapsAndWhatSticksOutAreMendedWithLeastMovement) {
  const Layout bad = bad_bedroom();
  const Layout good = mended(bad);
  EXPECT_EQ(good.status, LayoutStatus::kSolved);
  EXPECT_EQ(good.find_object("plant")->position, bad.find_object("plant")->position);
  EXPECT_NEAR(way(bad, good, "bed") + way(bad, good, "wardrobe"), 100, 1);
  EXPECT_NEAR(way(bad, good, "desk"), 200, 1);
  const Movement movement = movement_between(bad, good);
  EXPECT_EQ(movement.moved, 2);
  EXPECT_NEAR(movement.metres, 0.3, 0.002);
  for (const PlacedObject& o : good.objects) {
    EXPECT_EQ(o.rotation_deg, bad.find_object(o.id)->rotation_deg) << o.id;
    EXPECT_EQ(o.size, bad.find_object(o.id)->size) << o.id;
  }
}

TEST(Guide, ALegalLayoutStaysAsItIs) {
  const Layout good = mended(bad_bedroom());
  const Layout again = mended(good);
  EXPECT_EQ(movement_between(good, again).moved, 0);
  for (const PlacedObject& o : again.objects) EXPECT_EQ(o.position, good.find_object(o.id)->position) << o.id;
}

TEST(Guide, WhatIsPushedPushesOn) {
  // Three cupboards in a row, the first sticks out by 0.1 m: all move by as much, none round the others.
  Layout bad = empty_room(4000, 3000);
  for (int i = 0; i < 3; ++i)
    bad.objects.push_back(piece("cupboard_" + std::to_string(i + 1), "cabinet", {1000, 500, 900}, 400.0 + 1000 * i, 2740));
  const Layout good = mended(bad);
  EXPECT_NEAR(movement_between(bad, good).metres, 0.3, 0.002);
}

TEST(Guide, AnUnusualTurnIsKept) {
  Layout bad = bad_bedroom();
  bad.objects.push_back(piece("armchair", "armchair", {700, 700, 800}, 1500, 1000, 33));
  EXPECT_EQ(mended(bad).find_object("armchair")->rotation_deg, 33);
}

TEST(Guide, WhatStandsOnAThingFollowsIt) {
  Layout bad = bad_bedroom();
  PlacedObject lamp = piece("lamp", "table_lamp", {200, 200, 400}, 3800, 700);
  lamp.position[2] = 740;
  lamp.supported_by = "desk", lamp.mount = Mount::kSurface;
  bad.objects.push_back(lamp);
  const Layout good = mended(bad);
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(good.find_object("lamp")->position[k] - good.find_object("desk")->position[k],
                lamp.position[k] - bad.find_object("desk")->position[k], 1);
  }
}

TEST(Guide, LockedThingsStayExactly) {
  const Layout bad = bad_bedroom();
  SolveOptions options;
  for (const std::string id : {"bed", "wardrobe"}) {
    options.locked = {id};
    const Layout good = mended(bad, options);
    EXPECT_EQ(good.find_object(id)->position, bad.find_object(id)->position) << id;
    EXPECT_EQ(good.status, LayoutStatus::kSolved);
  }
}

TEST(Guide, LocksThatCannotHoldAreNamed) {
  SolveOptions options;
  options.locked = {"bed", "wardrobe"};
  const Layout good = mended(bad_bedroom(), options);
  EXPECT_EQ(good.status, LayoutStatus::kRelaxed);
  ASSERT_EQ(good.conflicts.size(), 1u);
  EXPECT_THAT(good.conflicts[0].sentence, HasSubstr("the bed and the wardrobe are both to stay where they are, and overlap there by 0.10"));
  ASSERT_EQ(good.relaxed.size(), 1u);
  EXPECT_NEAR(good.relaxed[0].by, 0.1, 0.002);

  options.on_conflict = OnConflict::kFail;
  const auto failed = try_to_mend(bad_bedroom(), options);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, ErrorCode::kInfeasible);

  options.locked = {"desk"};
  options.on_conflict = OnConflict::kRelax;
  const Layout inside = mended(bad_bedroom(), options);
  ASSERT_EQ(inside.conflicts.size(), 1u);
  EXPECT_THAT(inside.conflicts[0].sentence, HasSubstr("the desk sticks out of the room"));
}

TEST(Guide, LockAgainstARelationIsNamed) {
  Layout bad = bad_bedroom();
  Relation relation;
  relation.id = "c1", relation.type = RelationType::kAgainstWall;
  relation.targets = {"desk"}, relation.references = {"wall4"};
  bad.objects[2].position = {3600, 1000, 0};
  bad.relations.push_back({relation, false});
  SolveOptions options;
  options.locked = {"desk"};
  const Layout good = mended(bad, options);
  ASSERT_EQ(good.conflicts.size(), 1u);
  EXPECT_THAT(good.conflicts[0].sentence, HasSubstr("the desk stays where it was"));
  EXPECT_TRUE(good.conflicts[0].minimal);
  EXPECT_EQ(good.find_object("desk")->position, bad.find_object("desk")->position);
}

TEST(Guide, WhoIsUnknownCannotBeLocked) {
  SolveOptions options;
  options.locked = {"piano"};
  const auto failed = try_to_mend(bad_bedroom(), options);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, ErrorCode::kReference);
}

TEST(Guide, ANewObjectFindsRoomAndTheRestStays) {
  const Layout earlier = mended(bad_bedroom());
  SceneGraph scene = scene_of(earlier);
  scene.objects.push_back({});
  scene.objects.back().id = scene.objects.back().category = scene.objects.back().name = "bookshelf";
  const auto normalized = normalize_scene(scene, Catalog::builtin());
  ASSERT_TRUE(normalized);
  SolveOptions options;
  options.from = &earlier;
  const auto layout = solve(*normalized, Catalog::builtin(), options);
  ASSERT_TRUE(layout);
  expect_sound(*layout);
  EXPECT_EQ(movement_between(earlier, *layout).moved, 0);
  EXPECT_TRUE(layout->find_object("bookshelf"));
}

TEST(Guide, WhatIsFreedMayGoAnywhere) {
  Layout earlier = mended(bad_bedroom());
  earlier.objects[0].position = {2000, 1500, 0};  // the bed, off every wall
  SolveOptions options;
  EXPECT_EQ(mended(earlier, options).find_object("bed")->position[1], 1500);
  options.freed = {"bed"};
  const Layout moved = mended(earlier, options);
  EXPECT_GT(way(earlier, moved, "bed"), 100);
  EXPECT_EQ(movement_between(earlier, moved).moved, 1);
}

TEST(Guide, OpeningsStayWhereTheyWere) {
  const SceneGraph scene = SceneMaker(4000, 3500).add("bed").add("desk").add("wardrobe").make(true);
  const auto first = solve(scene, Catalog::builtin());
  ASSERT_TRUE(first);
  SolveOptions options;
  options.from = &*first;
  options.seed = 7;
  const auto again = solve(scene, Catalog::builtin(), options);
  ASSERT_TRUE(again);
  EXPECT_EQ(movement_between(*first, *again).moved, 0);
  for (const Opening& o : first->room.openings) {
    EXPECT_EQ(again->find_opening(o.id)->wall, o.wall);
    EXPECT_EQ(again->find_opening(o.id)->offset, o.offset);
  }
}

TEST(Variants, AreGoodAndDifferent) {
  const SceneGraph scene =
      SceneMaker(5000, 4500).add("bed").add("desk").add("wardrobe").add("armchair").relate("againstWall", {"bed_1"}).make(true);
  const auto layouts = solve_variants(scene, Catalog::builtin(), {}, 3);
  ASSERT_TRUE(layouts);
  ASSERT_EQ(layouts->size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    expect_sound((*layouts)[i]);
    EXPECT_EQ((*layouts)[i].status, LayoutStatus::kSolved);
    EXPECT_GT((*layouts)[i].score, 0.5 * (*layouts)[0].score);
    for (std::size_t j = 0; j < i; ++j) {
      const Difference difference = difference_between((*layouts)[i], (*layouts)[j]);
      EXPECT_GT(difference.mean_m, 0.4) << i << " and " << j;
    }
  }
  const auto again = solve_variants(scene, Catalog::builtin(), {}, 2);
  ASSERT_TRUE(again);
  EXPECT_EQ(difference_between((*again)[1], (*layouts)[1]).mean_m, 0);  // the same options, the same layouts
}

TEST(Variants, OneIsWhatSolveGives) {
  const SceneGraph scene = SceneMaker(4000, 3500).add("bed").add("desk").make(true);
  const auto one = solve(scene, Catalog::builtin());
  const auto variants = solve_variants(scene, Catalog::builtin(), {}, 1);
  ASSERT_TRUE(one && variants);
  EXPECT_EQ(difference_between(*one, (*variants)[0]).mean_m, 0);
  EXPECT_EQ(difference_between(*one, (*variants)[0]).other_wall, 0);
}

}  // namespace
}  // namespace layoutbox::placement
