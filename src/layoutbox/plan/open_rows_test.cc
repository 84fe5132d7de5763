// What lines walls and stands in rows, where the text does not count it.
#include "layoutbox/plan/open_rows.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "layoutbox/catalog/normalize.h"
#include "layoutbox/plan/planner.h"

namespace layoutbox {
namespace {

SceneGraph filled(const std::string& prompt) {
  static const std::unique_ptr<Planner> planner = make_offline_planner(Catalog::builtin());
  auto plan = planner->plan(prompt, {});
  EXPECT_TRUE(plan) << prompt;
  if (!plan) return {};
  const auto sized = normalize_scene(plan->scene, Catalog::builtin(), {});
  EXPECT_TRUE(sized) << prompt;
  SceneGraph scene = plan->scene;
  fill_rows(scene, *sized, plan->linings, Catalog::builtin());
  const auto again = normalize_scene(scene, Catalog::builtin(), {});
  EXPECT_TRUE(again) << prompt;
  return *again;
}

std::ptrdiff_t count_of(const SceneGraph& scene, const std::string& kind) {
  return std::ranges::count(scene.objects, kind, &SceneObject::category);
}

// How many are told to be at that wall.
std::ptrdiff_t at_wall(const SceneGraph& scene, const std::string& wall) {
  return std::ranges::count_if(scene.relations, [&](const Relation& r) {
    return r.type == RelationType::kAgainstWall && r.references == std::vector<std::string>{wall};
  });
}

TEST(OpenRows, ShelvesAlongWallsFillThem) {
  const SceneGraph shop = filled("A bookshop, 10 x 4 m, with bookshelves along both long walls and a table.");
  EXPECT_GE(count_of(shop, "bookshelf"), 16);
  EXPECT_GE(at_wall(shop, "wall1"), 7);
  EXPECT_GE(at_wall(shop, "wall3"), 9);
  EXPECT_GE(count_of(filled("A stockroom, 3 x 5 m, with metal shelving on both long walls."), "shelving_unit"), 6);
  EXPECT_GE(count_of(filled("A laboratory, 5 x 4 m, with steel shelving along the back wall."), "shelving_unit"), 4);
}

TEST(OpenRows, ALongRowHasAWallOfItsOwn) {
  const SceneGraph room = filled("A break room, 6 x 5.4 m, with twelve lockers in one row and a sofa along the back wall.");
  EXPECT_EQ(count_of(room, "locker"), 12);
  EXPECT_EQ(at_wall(room, "wall2") + at_wall(room, "wall4"), 12);
  EXPECT_EQ(at_wall(room, "wall3"), 1);
}

TEST(OpenRows, WhatIsCountedIsNotMore) {
  EXPECT_EQ(count_of(filled("A shop, 8 x 4 m, with two bookshelves along the left wall."), "bookshelf"), 2);
  EXPECT_EQ(count_of(filled("A study, 4 x 4 m, with a bookshelf along the left wall."), "bookshelf"), 1);
}

TEST(OpenRows, SeatsAlongTheWallsAreSharedOut) {
  const SceneGraph room = filled("A waiting room, 6 x 5 m, with ten chairs along the walls.");
  EXPECT_EQ(count_of(room, "chair"), 10);
  EXPECT_GE(at_wall(room, "wall3"), 4);
  EXPECT_GE(at_wall(room, "wall2"), 4);
}

TEST(OpenRows, WhatIsLinedUpIsAtOneWall) {
  const SceneGraph room = filled("An arcade, 4.9 x 4.3 m. Four upright cabinets are lined up along the wall, each with a stool in front.");
  for (const char* wall : {"wall1", "wall2", "wall3", "wall4"}) EXPECT_EQ(at_wall(room, wall) % 4, 0) << wall;
}

TEST(OpenRows, StoolsBeforeABarAreAsManyAsSitThere) {
  EXPECT_GE(count_of(filled("A tavern with a bar 3 m long and stools in front of it."), "bar_stool"), 4);
  EXPECT_EQ(count_of(filled("A tavern with a bar 3 m long and two stools in front of it."), "bar_stool"), 2);
}

TEST(OpenRows, ALibraryIsFullOfShelves) {
  EXPECT_GE(count_of(filled("A library, 8 x 7 m, with bookshelves and two reading tables."), "bookshelf"), 12);
  EXPECT_LE(count_of(filled("A bedroom, 5 x 4 m, with bookshelves and a bed."), "bookshelf"), 2);
}

}  // namespace
}  // namespace layoutbox
