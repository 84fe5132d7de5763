// One room in every form: a bed along the left wall, its head at the back, a desk at the right wall and a lamp on it.
#include <gtest/gtest.h>

#include <cmath>

#include "layoutbox/export/export.h"
#include "layoutbox/furnish/furnish.h"
#include "layoutbox/judge/judge.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox {
namespace {

constexpr std::string_view kModels = R"({
  "bed-1": {"name": "double bed", "size": [1.6, 2.0, 0.5]},
  "desk-1": {"category": "desk", "size": [1.2, 0.6, 0.75]},
  "lamp-1": {"name": "table lamp", "size": [0.2, 0.2, 0.4]}
})";

// Columns of a model that lies with y up and looks along +z: right, up, front, place.
constexpr std::string_view kSceneState = R"({"format": "sceneState", "scene": {"id": "a", "arch": {"elements": [
  {"type": "Floor", "id": "f", "roomId": "bedroom", "points": [[0,0,0],[4,0,0],[4,3,0],[0,3,0]]},
  {"type": "Wall", "id": "w0", "height": 2.5, "points": [[0,0,0],[4,0,0]],
   "holes": [{"type": "Door", "box": {"min": [2.9, 0], "max": [3.8, 2.0]}}]},
  {"type": "Wall", "id": "w1", "height": 2.5, "points": [[4,0,0],[4,3,0]], "holes": []}]},
  "object": [
   {"index": 0, "modelId": "x.bed-1", "transform": {"data": [1,0,0,0, 0,0,1,0, 0,-1,0,0, 0.8,2.0,0,1]}},
   {"index": 1, "modelId": "x.desk-1", "transform": {"data": [0,-1,0,0, 0,0,1,0, -1,0,0,0, 3.7,1.8,0,1]}},
   {"index": 2, "modelId": "x.lamp-1", "transform": {"data": [1,0,0,0, 0,0,1,0, 0,-1,0,0, 3.7,2.1,0.75,1]}}]}})";

// Its x is along the front's direction.
constexpr std::string_view kLayoutVlm = R"({"layout": {
   "bed-1": {"position": [0.8, 2.0, 0.25], "rotation": [0, 0, 270]},
   "desk-1": {"position": [3.7, 1.8, 0.375], "rotation": [0, 0, 180]},
   "lamp-1": {"position": [3.7, 2.1, 0.95], "rotation": [0, 0, 270]}},
  "scene_config": {"task_description": "a bedroom", "boundary": {"floor_vertices": [[0,0,0],[4,0,0],[4,3,0],[0,3,0]], "wall_height": 2.5},
   "assets": {"bed-1": {"category": "double bed", "assetMetadata": {"boundingBox": {"x": 2.0, "y": 1.6, "z": 0.5}}},
              "desk-1": {"category": "desk", "assetMetadata": {"boundingBox": {"x": 0.6, "y": 1.2, "z": 0.75}}},
              "lamp-1": {"category": "table lamp", "assetMetadata": {"boundingBox": {"x": 0.2, "y": 0.2, "z": 0.4}}}}}})";

// y up, z away, turns clockwise seen from above, fronts along +z.
constexpr std::string_view kHolodeck = R"json({"query": "a bedroom", "wall_height": 2.5,
  "rooms": [{"id": "bedroom", "roomType": "bedroom",
             "floorPolygon": [{"x":0,"y":0,"z":0},{"x":4,"y":0,"z":0},{"x":4,"y":0,"z":3},{"x":0,"y":0,"z":3}]}],
  "walls": [{"id": "wall|0", "roomId": "bedroom",
             "polygon": [{"x":0,"y":0,"z":0},{"x":4,"y":0,"z":0},{"x":4,"y":2.5,"z":0},{"x":0,"y":2.5,"z":0}]}],
  "doors": [{"id": "door|0", "wall0": "wall|0", "room0": "bedroom", "holePolygon": [{"x": 2.9, "y": 0, "z": 0}, {"x": 3.8, "y": 2.0, "z": 0}]}],
  "windows": [],
  "objects": [
   {"id": "bed (bedroom)", "object_name": "double_bed-0", "assetId": "bed-1", "roomId": "bedroom", "position": {"x":0.8,"y":0.25,"z":2.0}, "rotation": {"x":0,"y":180,"z":0}},
   {"id": "desk (bedroom)", "object_name": "desk-0", "assetId": "desk-1", "roomId": "bedroom", "position": {"x":3.7,"y":0.375,"z":1.8}, "rotation": {"x":0,"y":270,"z":0}},
   {"id": "lamp|desk", "object_name": "table_lamp-0", "assetId": "lamp-1", "roomId": "bedroom", "position": {"x":3.7,"y":0.95,"z":2.1}, "rotation": {"x":0,"y":180,"z":0}}]})json";

constexpr std::string_view kPositions = R"({"metadata": {"roomType": "bedroom"}, "room": {"dims": {"w": 4, "d": 3, "h": 2.5}},
  "furniture": [
   {"id": "bed", "category": "bed", "name": "double bed", "dims": {"w": 1.6, "d": 2.0, "h": 0.5}, "xform": {"pos": [0.8, 2.0, 0], "rot": [0, 0, 0]}},
   {"id": "desk", "category": "desk", "dims": {"w": 1.2, "d": 0.6, "h": 0.75}, "xform": {"pos": [3.7, 1.8, 0], "rot": [0, 0, 270]}},
   {"id": "lamp", "category": "table_lamp", "dims": {"w": 0.2, "d": 0.2, "h": 0.4}, "xform": {"pos": [3.7, 2.1, 0.75], "rot": [0, 0, 0]}}]})";

constexpr std::string_view kNamedNodes = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
  "accessors": [{"min": [0, 0, -3], "max": [4, 0, 0]}, {"min": [-0.8, 0, -1], "max": [0.8, 0.5, 1]},
                {"min": [-0.6, 0, -0.3], "max": [0.6, 0.75, 0.3]}, {"min": [-0.1, 0, -0.1], "max": [0.1, 0.4, 0.1]},
                {"min": [2.9, 0, 0], "max": [3.8, 2.0, 0.1]}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}, {"primitives": [{"attributes": {"POSITION": 1}}]},
             {"primitives": [{"attributes": {"POSITION": 2}}]}, {"primitives": [{"attributes": {"POSITION": 3}}]},
             {"primitives": [{"attributes": {"POSITION": 4}}]}],
  "nodes": [{"name": "Scene", "children": [1, 2, 3, 4, 5, 6]}, {"name": "Floor", "mesh": 0},
            {"name": "DoubleBed_1", "mesh": 1, "translation": [0.8, 0, -2.0]},
            {"name": "Desk", "mesh": 2, "translation": [3.7, 0, -1.8], "rotation": [0, -0.70710678, 0, 0.70710678]},
            {"name": "table_lamp.001", "mesh": 3, "translation": [3.7, 0.75, -2.1]}, {"name": "Camera", "translation": [9, 9, 9]},
            {"name": "Door", "mesh": 4}]})";

struct Form {
  const char* format;
  std::string_view text;
  bool has_door;
};

class Formats : public testing::TestWithParam<Form> {};

const PlacedObject* kind(const Layout& layout, std::string_view category) {
  for (const PlacedObject& object : layout.objects) {
    if (object.category == category || Catalog::builtin().is_a(object.category, category)) return &object;
  }
  return nullptr;
}

void expect_box(const PlacedObject* object, Size size, std::array<double, 3> at, double rotation, const char* what) {
  ASSERT_NE(object, nullptr) << what;
  EXPECT_NEAR(object->size.width, size.width, 1) << what;
  EXPECT_NEAR(object->size.depth, size.depth, 1) << what;
  EXPECT_NEAR(object->size.height, size.height, 1) << what;
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(object->position[i], at[i], 1) << what << " " << i;
  EXPECT_NEAR(std::remainder(object->rotation_deg - rotation, 360.0), 0, 0.1) << what;
}

TEST_P(Formats, TheSameRoom) {
  const auto room = read_room_file(GetParam().text, Catalog::builtin(), {{}, std::string(kModels)});
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_EQ(room->format, GetParam().format);
  EXPECT_FALSE(room->notes.empty());  // it is said what was guessed
  const Layout& layout = room->layout;
  ASSERT_EQ(layout.objects.size(), 3u);
  ASSERT_EQ(layout.room.polygon.size(), 4u);
  EXPECT_EQ(layout.room.polygon[2], (Point{4000, 3000}));
  expect_box(kind(layout, "bed"), {1600, 2000, 500}, {800, 2000, 0}, 0, "bed");
  expect_box(kind(layout, "desk"), {1200, 600, 750}, {3700, 1800, 0}, 270, "desk");
  expect_box(kind(layout, "table_lamp"), {200, 200, 400}, {3700, 2100, 750}, 0, "lamp");
  EXPECT_EQ(kind(layout, "table_lamp")->supported_by, kind(layout, "desk")->id);
  ASSERT_EQ(layout.room.openings.size(), GetParam().has_door ? 1u : 0u);
  if (GetParam().has_door) {
    EXPECT_EQ(layout.room.openings[0].type, OpeningType::kDoor);
    EXPECT_EQ(layout.room.openings[0].offset, 2900);
    EXPECT_EQ(layout.room.openings[0].width, 900);
  }
  const Judgement judgement = judge_room(*room, {}, Catalog::builtin());
  EXPECT_EQ(judgement.measures.at("COL").part, 0);
  EXPECT_EQ(judgement.measures.at("OOB").part, 0);
  EXPECT_EQ(judgement.measures.at("SUP").share(), 1);
}

INSTANTIATE_TEST_SUITE_P(All, Formats,
                         testing::Values(Form{"scenestate", kSceneState, true}, Form{"layoutvlm", kLayoutVlm, false},
                                         Form{"holodeck", kHolodeck, true}, Form{"scene", kPositions, false},
                                         Form{"gltf", kNamedNodes, true}),
                         [](const auto& test) { return test.param.format; });

// What we write as glTF is judged as the layout is.
TEST(FormatsTest, OwnGlb) {
  const auto first = read_room_file(kHolodeck, Catalog::builtin(), {{}, std::string(kModels)});
  ASSERT_TRUE(first);
  const auto model = furnish(first->layout, Catalog::builtin());
  ASSERT_TRUE(model) << model.error().message;
  const auto glb = write_glb(*model, first->layout);
  ASSERT_TRUE(glb);
  const auto second = read_room_file(*glb, Catalog::builtin());
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_EQ(second->format, "gltf");
  ASSERT_EQ(second->layout.objects.size(), 3u);
  expect_box(kind(second->layout, "desk"), {1200, 600, 750}, {3700, 1800, 0}, 270, "desk");
  EXPECT_EQ(second->layout.room.polygon, first->layout.room.polygon);
}

// Of an L the box of its floor would count what stands in the notch as inside; a floor that was cut since is what it is now.
TEST(FormatsTest, OwnGlbOfAnL) {
  auto made = read_room_file(kHolodeck, Catalog::builtin(), {{}, std::string(kModels)});
  ASSERT_TRUE(made);
  Layout& layout = made->layout;
  layout.room.polygon = {{0, 0}, {4000, 0}, {4000, 3000}, {2000, 3000}, {2000, 2000}, {0, 2000}};
  layout.room.walls = walls_along(layout.room.polygon);
  layout.room.openings.clear();
  layout.objects.clear();
  const auto model = furnish(layout, Catalog::builtin());
  ASSERT_TRUE(model) << model.error().message;
  const auto glb = write_glb(*model, layout);
  ASSERT_TRUE(glb);
  const auto read = read_room_file(*glb, Catalog::builtin());
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->layout.room.polygon, layout.room.polygon);
  Model cut = *model;
  for (Node& node : cut.nodes) {
    for (Part& part : node.parts) {
      for (auto& position : part.mesh.positions) position[0] = node.id == "floor" ? position[0] / 2 : position[0];
    }
  }
  const auto smaller = write_glb(cut, layout);
  ASSERT_TRUE(smaller);
  const auto again = read_room_file(*smaller, Catalog::builtin());
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->layout.room.polygon, (std::vector<Point>{{0, 0}, {2000, 0}, {2000, 3000}, {0, 3000}}));
}

// A leaf that stands open and casings that reach past the hole make no other door of it.
TEST(FormatsTest, OwnGlbHasTheSameDoorsAndWindows) {
  auto made = read_room_file(kHolodeck, Catalog::builtin(), {{}, std::string(kModels)});
  ASSERT_TRUE(made);
  Layout& layout = made->layout;
  layout.room.openings.clear();
  for (std::size_t i = 0; i < 4; ++i) {
    Opening opening;
    opening.id = "opening_" + std::to_string(i);
    opening.type = i == 3 ? OpeningType::kOpen : i % 2 == 0 ? OpeningType::kDoor : OpeningType::kWindow;
    opening.wall = layout.room.walls[i].id;
    opening.offset = 700;
    opening.width = 900;
    opening.height = opening.type == OpeningType::kWindow ? 1200 : 2000;
    opening.sill = opening.type == OpeningType::kWindow ? 900 : 0;
    opening.swing = opening.type == OpeningType::kDoor ? (i == 0 ? Swing::kInLeft : Swing::kInRight) : Swing::kNone;
    layout.room.openings.push_back(opening);
  }
  layout.objects.clear();
  const auto model = furnish(layout, Catalog::builtin());
  ASSERT_TRUE(model) << model.error().message;
  const auto glb = write_glb(*model, layout);
  ASSERT_TRUE(glb);
  const auto read = read_room_file(*glb, Catalog::builtin());
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_EQ(read->layout.room.openings.size(), layout.room.openings.size());
  for (const Opening& wanted : layout.room.openings) {
    const Opening* found = read->layout.find_opening(wanted.id);
    ASSERT_TRUE(found) << wanted.id;
    EXPECT_EQ(found->type, wanted.type) << wanted.id;
    EXPECT_EQ(found->swing, wanted.swing) << wanted.id;
    EXPECT_EQ(found->offset, wanted.offset) << wanted.id;
    EXPECT_EQ(found->width, wanted.width) << wanted.id;
    EXPECT_EQ(found->height, wanted.height) << wanted.id;
    EXPECT_EQ(found->sill, wanted.sill) << wanted.id;
    const Wall *there = read->layout.find_wall(found->wall), *here = layout.find_wall(wanted.wall);
    ASSERT_TRUE(there && here) << wanted.id;
    EXPECT_EQ(there->start, here->start) << wanted.id;
  }
}

TEST(FormatsTest, WhatIsMissingIsSaid) {
  const auto no_sizes = read_room_file(kSceneState, Catalog::builtin());
  ASSERT_FALSE(no_sizes);
  EXPECT_EQ(no_sizes.error().code, ErrorCode::kReference);
  EXPECT_NE(no_sizes.error().hint.find("--models"), std::string::npos);
  const auto unknown = read_room_file("{\"a\": 1}", Catalog::builtin());
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::kParse);
  const auto format = read_room_file("{}", Catalog::builtin(), {"usd", {}});
  ASSERT_FALSE(format);
  EXPECT_EQ(format.error().code, ErrorCode::kUsage);
}

// A file of somebody's may hold anything.
TEST(FormatsTest, BrokenFilesAreErrors) {
  for (const std::string_view text : {kSceneState, kLayoutVlm, kHolodeck, kPositions, kNamedNodes}) {
    for (std::size_t at = 0; at < text.size(); at += 7) {
      std::string broken(text);
      broken[at] = broken[at] == '1' ? '"' : '1';
      (void)read_room_file(broken, Catalog::builtin(), {{}, std::string(kModels)});
      (void)read_room_file(std::string(text.substr(0, at)), Catalog::builtin(), {{}, std::string(kModels)});
    }
  }
}

}  // namespace
}  // namespace layoutbox
