// The steps of an edit without a solver: what becomes of the scene, of the guide, and what is put exactly somewhere.
#include "layoutbox/edit/edit.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "layoutbox/edit/changes.h"
#include "layoutbox/edit/placer.h"
#include "layoutbox/edit/state.h"

namespace layoutbox {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

PlacedObject placed(const char* id, const char* category, Size size, double x, double y, double rotation, const char* support) {
  PlacedObject object;
  object.id = id, object.category = category, object.name = category, object.size = size;
  object.position = {x, y, 0};
  object.rotation_deg = rotation;
  object.supported_by = support;
  if (object.supported_by != "floor") object.mount = Mount::kSurface;
  return object;
}

Layout room() {
  Layout layout;
  layout.room.polygon = {{0, 0}, {5000, 0}, {5000, 4000}, {0, 4000}};
  layout.room.height = 2500;
  layout.room.walls = {{"wall1", {0, 0}, {5000, 0}, 100, {}, {}},
                       {"wall2", {5000, 0}, {5000, 4000}, 100, {}, {}},
                       {"wall3", {5000, 4000}, {0, 4000}, 100, {}, {}},
                       {"wall4", {0, 4000}, {0, 0}, 100, {}, {}}};
  layout.room.openings = {{"door1", OpeningType::kDoor, "wall1", 500}};
  layout.objects = {placed("sofa_1", "sofa", {2000, 900, 800}, 2500, 3550, 0, "floor"),
                    placed("desk_1", "desk", {1200, 600, 750}, 300, 2000, 90, "floor"),
                    placed("lamp_1", "table_lamp", {200, 200, 400}, 300, 2000, 90, "desk_1")};
  PlacedRelation at_wall;
  at_wall.relation.id = "r1";
  at_wall.relation.type = RelationType::kAgainstWall;
  at_wall.relation.targets = {"sofa_1"};
  at_wall.relation.references = {"wall3"};
  at_wall.held = true;
  layout.relations = {at_wall};
  return layout;
}

// The state after the commands of the text.
EditState after(std::string_view text, const Layout& layout) {
  EditState state = begin_edit(layout);
  const auto plan = plan_edit(text, layout, Catalog::builtin());
  EXPECT_TRUE(plan) << text;
  for (const EditStep& step : plan ? plan->steps : std::vector<EditStep>{}) {
    auto next = apply_edit_step(state, step, layout, Catalog::builtin());
    EXPECT_TRUE(next) << text;
    if (next) state = std::move(*next);
  }
  return *finish_edit(std::move(state), layout, Catalog::builtin());
}

TEST(EditSteps, AStepLeavesWhatItWasGivenAsItWas) {
  const Layout layout = room();
  const EditState before = begin_edit(layout);
  EditStep step;
  step.kind = EditKind::kRemove;
  step.targets = {"desk_1"};
  const auto state = apply_edit_step(before, step, layout, Catalog::builtin());
  ASSERT_TRUE(state);
  EXPECT_EQ(before.scene.objects.size(), 3U);
  EXPECT_EQ(state->scene.objects.size(), 2U);
}

TEST(EditSteps, WhatStoodOnItGoesWithIt) {
  const EditState state = after("remove the desk", room());
  ASSERT_EQ(state.scene.objects.size(), 1U);
  EXPECT_EQ(state.scene.objects[0].id, "sofa_1");
}

TEST(EditSteps, AMoveFreesTheThingAndMakesItsOldPlaceAWish) {
  const EditState state = after("move the sofa to the left wall", room());
  EXPECT_THAT(state.freed, ElementsAre("sofa_1"));
  EXPECT_THAT(state.softened, Contains("r1"));
  EXPECT_THAT(state.pins, IsEmpty());
}

TEST(EditSteps, AShiftIsAPin) {
  const EditState state = after("move the desk 40 cm to the right", room());
  ASSERT_EQ(state.pins.size(), 1U);
  EXPECT_EQ(state.pins[0].id, "desk_1");
  EXPECT_DOUBLE_EQ(state.pins[0].way[0], 400);
  EXPECT_FALSE(state.pins[0].loose);
}

TEST(EditSteps, AwayFromTheWallKeepsThePlaceAlongIt) {
  const EditState state = after("put the sofa 50 cm away from the wall", room());
  EXPECT_THAT(state.freed, IsEmpty());
  const PlacedObject* sofa = state.guide.find_object("sofa_1");
  ASSERT_NE(sofa, nullptr);
  EXPECT_NEAR(sofa->position[0], 2500, 1);
  EXPECT_NEAR(sofa->position[1], 4000 - 500 - 450, 1);
}

TEST(EditSteps, PaintOnWallsAndFloorIsAChange) {
  const Layout layout = room();
  const EditState state = after("paint the walls green and make the floor oak", layout);
  Layout painted = layout;
  painted.room = state.scene.room;
  const auto changes = changes_between(layout, painted, {"walls", "floor"});
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes[0].id, "walls");
  EXPECT_THAT(changes[0].what, ElementsAre("recolored"));
  EXPECT_EQ(changes[1].id, "floor");
}

TEST(EditSteps, OneWallOrTheCeilingArePaintedAlone) {
  const Layout layout = room();
  const EditState state = after("paint the back wall green and the ceiling blue", layout);
  EXPECT_EQ(state.scene.room.walls[2].material, "green");
  EXPECT_EQ(state.scene.room.walls[0].material, "");
  EXPECT_EQ(state.scene.room.wall_material, "");
  EXPECT_EQ(state.scene.room.ceiling_material, "blue");
  Layout painted = layout;
  painted.room = state.scene.room;
  const auto changes = changes_between(layout, painted, {"wall3", "ceiling"});
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes[0].id, "wall3");
  EXPECT_EQ(changes[1].id, "ceiling");
}

TEST(EditLayout, AFormIsNoColour) {
  for (const auto& [text, what] : {std::pair{"make the sofa round", "reshaped"}, {"make the sofa green", "recolored"}}) {
    const auto outcome = edit_layout(text, room(), Catalog::builtin());
    ASSERT_TRUE(outcome) << outcome.error().message;
    const auto changed = std::ranges::find(outcome->changes, "sofa_1", &ObjectChange::id);
    ASSERT_NE(changed, outcome->changes.end()) << text;
    EXPECT_THAT(changed->what, ElementsAre(what)) << text;
  }
}

// A relation of the user's own is not taken for one that keeps a turned thing turned, whatever it is called.
TEST(EditLayout, RelationsOfAnyIdAreKept) {
  Layout layout = room();
  layout.relations[0].relation.id = "turned_desk_1";
  const auto outcome = edit_layout("turn the desk by 90 degrees", layout, Catalog::builtin());
  ASSERT_TRUE(outcome) << outcome.error().message;
  const auto is_it = [](const Relation& r) { return r.id == "turned_desk_1" && r.type == RelationType::kAgainstWall; };
  EXPECT_EQ(std::count_if(outcome->scene.relations.begin(), outcome->scene.relations.end(), is_it), 1);
}

}  // namespace
}  // namespace layoutbox
