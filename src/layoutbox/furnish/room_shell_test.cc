#include "layoutbox/furnish/room_shell.h"

#include <gtest/gtest.h>

#include "layoutbox/furnish/furnish.h"
#include "layoutbox/furnish/mesh_checks.h"

namespace layoutbox {
namespace {

Layout room_of(std::vector<Point> polygon) {
  Layout layout;
  layout.room.height = 3000;
  layout.room.polygon = polygon;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    Wall wall;
    wall.id = "wall" + std::to_string(i + 1);
    wall.start = polygon[i];
    wall.end = polygon[(i + 1) % polygon.size()];
    layout.room.walls.push_back(wall);
  }
  return layout;
}

Layout rectangle() { return room_of({{0, 0}, {4000, 0}, {4000, 3200}, {0, 3200}}); }

Opening opening(std::string id, OpeningType type, std::string wall, Mm offset, Mm sill, Mm height) {
  Opening o;
  o.id = std::move(id);
  o.type = type;
  o.wall = std::move(wall);
  o.offset = offset;
  o.sill = sill;
  o.height = height;
  return o;
}

const Node* node_of(const Model& model, std::string_view id) {
  for (const Node& node : model.nodes) {
    if (node.id == id) return &node;
  }
  return nullptr;
}

Model shell(const Layout& layout) {
  const Result<Model> model = furnish(layout, Catalog::builtin());
  EXPECT_TRUE(model);
  return model ? *model : Model{};
}

TEST(RoomShell, WallsEndWhereTheRoofComesDown) {
  Layout layout = rectangle();
  PlacedObject slope;  // along the back wall: from a knee of 1.4 m to the ceiling
  slope.id = slope.category = slope.name = "sloped_ceiling";
  slope.mount = Mount::kCeiling;
  slope.size = {4000, 1400, 1600};
  slope.position = {2000, 2500, 1400};
  layout.objects.push_back(slope);
  const Model model = shell(layout);
  const auto tallest = [&](const char* id, auto is_there) {
    float z = 0;
    for (const Part& part : node_of(model, id)->parts) {
      for (const Vec3f& corner : part.mesh.positions) z = is_there(corner) ? std::max(z, corner[2]) : z;
    }
    return z;
  };
  const auto anywhere = [](const Vec3f&) { return true; };
  EXPECT_NEAR(tallest("wall1", anywhere), 3.0F, 0.02F);
  EXPECT_NEAR(tallest("wall3", anywhere), 1.4F, 0.03F);
  EXPECT_NEAR(tallest("wall2", anywhere), 3.0F, 0.02F);
  EXPECT_LT(tallest("wall2", [](const Vec3f& corner) { return corner[0] > 3.19F; }), 1.5F);
  ASSERT_NE(node_of(model, "roof1"), nullptr);
  EXPECT_EQ(node_of(model, "roof1")->kind, NodeKind::kCeiling);
}

TEST(RoomShell, HasFloorWallsCeilingWithTheirKinds) {
  const Model model = shell(rectangle());
  ASSERT_NE(node_of(model, "floor"), nullptr);
  EXPECT_EQ(node_of(model, "floor")->kind, NodeKind::kFloor);
  EXPECT_EQ(node_of(model, "ceiling")->kind, NodeKind::kCeiling);
  for (const char* id : {"wall1", "wall2", "wall3", "wall4"}) {
    ASSERT_NE(node_of(model, id), nullptr);
    EXPECT_EQ(node_of(model, id)->kind, NodeKind::kWall);
  }
}

TEST(RoomShell, InwardNormalsLookIntoTheRoom) {
  const Model model = shell(rectangle());
  EXPECT_NEAR((*node_of(model, "wall1")->inward)[1], 1, 1e-6);   // front wall looks to the back
  EXPECT_NEAR((*node_of(model, "wall2")->inward)[0], -1, 1e-6);  // right wall looks to the left
}

TEST(RoomShell, OpeningsAreReallyCutOut) {
  Layout layout = rectangle();
  const double whole = mesh_checks::volume(node_of(shell(layout), "wall1")->parts[0].mesh);
  layout.room.openings = {opening("door1", OpeningType::kDoor, "wall1", 300, 0, 2000),
                          opening("window1", OpeningType::kWindow, "wall1", 2000, 900, 1200)};
  const Model model = shell(layout);
  const Node* wall = node_of(model, "wall1");
  EXPECT_NEAR(whole - mesh_checks::volume(wall->parts[0].mesh), (0.9 * 2.0 + 0.9 * 1.2) * 0.1, 1e-4);
  EXPECT_EQ(mesh_checks::open_edges(wall->parts[0].mesh), 0);
  for (const char* id : {"door1", "window1"}) {
    ASSERT_NE(node_of(model, id), nullptr);
    EXPECT_EQ(node_of(model, id)->kind, NodeKind::kOpening);
    EXPECT_EQ(node_of(model, id)->parent, "wall1");
  }
}

TEST(RoomShell, MeshesAreClosedInAnyRoom) {
  const std::vector<std::vector<Point>> rooms{
      {{0, 0}, {6000, 0}, {6000, 3000}, {3000, 3000}, {3000, 5000}, {0, 5000}},
      {{0, 0}, {4000, 0}, {5000, 2000}, {4000, 4000}, {0, 4000}, {-1000, 2000}},
      {{0, 0}, {2000, 0}, {2000, 1500}, {4000, 1500}, {4000, 0}, {6000, 0}, {6000, 4000}, {0, 4000}}};
  for (const auto& polygon : rooms) {
    Layout layout = room_of(polygon);
    layout.room.openings = {opening("door1", OpeningType::kDoor, "wall1", 300, 0, 2000)};
    for (const Node& node : shell(layout).nodes) {
      for (const Part& part : node.parts) {
        EXPECT_EQ(mesh_checks::open_edges(part.mesh), 0) << node.id;
        EXPECT_GT(mesh_checks::volume(part.mesh), 0) << node.id;
      }
    }
  }
}

TEST(RoomShell, ADoorStandsAjarAsItsSwingSays) {
  for (const auto& [swing, inside] :
       {std::pair{Swing::kInLeft, true}, {Swing::kInRight, true}, {Swing::kOutLeft, false}, {Swing::kOutRight, false}}) {
    Layout layout = rectangle();
    layout.room.openings = {opening("door1", OpeningType::kDoor, "wall1", 1000, 0, 2000)};
    layout.room.openings[0].swing = swing;
    const kit::Box b = mesh_checks::bounds_of(*node_of(shell(layout), "door1"));
    EXPECT_EQ(b.max.y > 0.3, inside);
    EXPECT_EQ(b.min.y < -0.3, !inside);
  }
}

TEST(RoomShell, ADoorStopsBeforeFurnitureInItsWay) {
  Layout layout = rectangle();
  layout.room.openings = {opening("door1", OpeningType::kDoor, "wall1", 1000, 0, 2000)};
  PlacedObject box;
  box.id = "box_1";
  box.category = "object";
  box.name = "box";
  box.size = {900, 400, 500};
  box.position = {1450, 250, 0};
  layout.objects = {box};
  EXPECT_LT(mesh_checks::bounds_of(*node_of(shell(layout), "door1")).max.y, 0.1);
}

TEST(RoomShell, ASillReachesUnderWhatStandsOnIt) {
  Layout layout = rectangle();
  layout.room.openings = {opening("window1", OpeningType::kWindow, "wall3", 1000, 900, 1200)};
  PlacedObject vase;
  vase.id = "vase_1";
  vase.category = "vase";
  vase.name = "vase";
  vase.size = {120, 120, 200};
  vase.position = {4000 - 1450, 3200 - 100, 900};
  vase.supported_by = "window1";
  layout.objects = {vase};
  EXPECT_NEAR(mesh_checks::bounds_of(*node_of(shell(layout), "window1")).max.y, 0.16, 1e-3);
}

TEST(RoomShell, OneWallMayHaveALookOfItsOwn) {
  Layout layout = rectangle();
  layout.room.walls[2].material = "exposed brick";
  layout.room.walls[1].material = "wood panelling";
  layout.room.floor_material = "tatami floor";
  const Model model = shell(layout);
  const auto texture_of = [&](std::string_view id) {
    return model.surfaces.at(static_cast<std::size_t>(node_of(model, id)->parts[0].surface)).texture;
  };
  EXPECT_EQ(texture_of("wall1"), "plaster");
  EXPECT_EQ(texture_of("wall2"), "planks");
  EXPECT_EQ(texture_of("wall3"), "bricks");
  EXPECT_EQ(texture_of("floor"), "tatami");
}

TEST(RoomShell, FloorAndWallsTakeTheAskedMaterials) {
  Layout layout = rectangle();
  layout.room.floor_material = "dark wood";
  Material paint;
  paint.id = "wall_paint";
  paint.color = Color{0.2, 0.4, 0.8};
  layout.materials = {paint};
  layout.room.wall_material = "wall_paint";
  const Model model = shell(layout);
  const auto surface_of = [&](std::string_view id) {
    return model.surfaces.at(static_cast<std::size_t>(node_of(model, id)->parts[0].surface));
  };
  EXPECT_EQ(surface_of("floor").name, "walnut_planks");
  EXPECT_NEAR(surface_of("wall1").base.b, 0.8, 1e-9);
}

}  // namespace
}  // namespace layoutbox
