#include "layoutbox/plan/growing_scene.h"

#include <gtest/gtest.h>

namespace layoutbox {
namespace {

SceneGraph scene_with(std::initializer_list<std::pair<const char*, const char*>> things) {
  SceneGraph scene;
  for (const auto& [id, category] : things) {
    SceneObject& object = scene.objects.emplace_back();
    object.id = id, object.category = category, object.name = category;
  }
  return scene;
}

TEST(GrowingScene, WhatComesGetsTheNextFreeNumberOfItsKind) {
  SceneGraph scene = scene_with({{"desk_1", "desk"}, {"chair_2", "chair"}});
  GrowingScene growing(scene, scene, Catalog::builtin());
  const CatalogEntry& chair = *Catalog::builtin().find("chair");
  EXPECT_FALSE(growing.has_kind("lamp"));
  EXPECT_EQ(growing.add(chair), "chair_1");
  EXPECT_EQ(growing.add(chair), "chair_3");
  ASSERT_NE(growing.find("chair_3"), nullptr);
  EXPECT_EQ(growing.find("chair_3")->origin, Origin::kAdded);
  growing.add(*Catalog::builtin().find("desk_lamp"));
  EXPECT_TRUE(growing.has_kind("lamp")) << "a special kind is of the more general one";
}

TEST(GrowingScene, KnowsWhatHasASeat) {
  SceneGraph scene = scene_with({{"desk_1", "desk"}, {"desk_2", "desk"}, {"visitor_chair_1", "visitor_chair"}});
  Relation& visits = scene.relations.emplace_back();
  visits.type = RelationType::kInFrontOf, visits.targets = {"visitor_chair_1"}, visits.references = {"desk_1"};
  GrowingScene growing(scene, scene, Catalog::builtin());
  EXPECT_FALSE(growing.has_seat("desk_1")) << "who works there sits behind";
  EXPECT_EQ(growing.relations_of("visitor_chair_1").size(), 1u);
  growing.relate(RelationType::kNextTo, {growing.add(*Catalog::builtin().find("office_chair"))}, "desk_2");
  EXPECT_TRUE(growing.has_seat("desk_2"));
  EXPECT_FALSE(growing.has_seat("desk_1"));
  EXPECT_EQ(growing.relations_of("office_chair_1").size(), 1u);
}

}  // namespace
}  // namespace layoutbox
