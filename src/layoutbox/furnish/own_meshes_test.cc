// Objects and walls that are drawn by meshes of their own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "layoutbox/furnish/furnish.h"
#include "layoutbox/furnish/mesh_checks.h"
#include "layoutbox/furnish/test_mesh_files.h"

namespace layoutbox {
namespace {

using ::testing::HasSubstr;
using OwnMeshes = MeshFiles;

TEST_F(OwnMeshes, AnObjectIsDrawnByItsOwnMesh) {
  Layout layout;
  PlacedObject object;
  object.id = "shelf_1";
  object.category = "shelf";
  object.size = {1000, 2000, 500};
  object.mesh = "box.obj";
  layout.objects = {object};
  FurnishOptions options;
  options.asset_folders = {assets()};
  const auto model = furnish(layout, Catalog::builtin(), options);
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(mesh_checks::triangles_of(model->nodes.at(0)), 12U);
  layout.objects[0].mesh = "none.obj";
  const auto failed = furnish(layout, Catalog::builtin(), options);
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.error().message, HasSubstr("shelf_1"));
  EXPECT_THAT(failed.error().message, HasSubstr("none.obj"));
}

// A wedge that is thin at its front is drawn in the place of a wall of 4 × 3 m.
TEST_F(OwnMeshes, AWallIsDrawnByItsOwnMesh) {
  Layout layout;
  layout.room.height = 3000;
  layout.room.polygon = {{0, 0}, {4000, 0}, {4000, 5000}, {0, 5000}};
  for (std::size_t i = 0; i < 4; ++i) {
    Wall wall;
    wall.id = "wall" + std::to_string(i + 1);
    wall.start = layout.room.polygon[i];
    wall.end = layout.room.polygon[(i + 1) % 4];
    wall.thickness = 100;
    layout.room.walls.push_back(wall);
  }
  layout.room.walls[2].mesh = "box.obj";
  FurnishOptions options;
  options.asset_folders = {assets()};
  const auto wall_of = [&](const Model& model, std::string_view id) {
    for (const Node& node : model.nodes) {
      if (node.id == id) return node;
    }
    return Node{};
  };
  const auto model = furnish(layout, Catalog::builtin(), options);
  ASSERT_TRUE(model) << model.error().message;
  const Node own = wall_of(*model, "wall3");
  EXPECT_EQ(mesh_checks::triangles_of(own), 12U);
  EXPECT_TRUE(own.inward) << "it is cut away as any wall";
  const kit::Box b = mesh_checks::bounds_of(own);
  EXPECT_NEAR(b.min.x, 0, 1e-5);
  EXPECT_NEAR(b.max.x, 4, 1e-5);
  EXPECT_NEAR(b.min.z, 0, 1e-5);
  EXPECT_NEAR(b.max.z, 3, 1e-5);
  EXPECT_NEAR(b.max.y, 0, 1e-5) << "its front is the wall's inner face";
  EXPECT_NEAR(b.min.y, -0.1, 1e-5) << "no thicker than the wall";
  EXPECT_GT(mesh_checks::triangles_of(wall_of(*model, "wall1")), 12U) << "the others stay";
  for (const auto& [name, code] :
       {std::pair{"none.glb", ErrorCode::kIo}, {"../secret.obj", ErrorCode::kUsage}, {"words.obj", ErrorCode::kParse}}) {
    put("words.obj", "these are words\n");
    layout.room.walls[2].mesh = name;
    const auto failed = furnish(layout, Catalog::builtin(), options);
    ASSERT_FALSE(failed) << name;
    EXPECT_EQ(failed.error().code, code);
    EXPECT_THAT(failed.error().message, HasSubstr("the wall \"wall3\""));
    EXPECT_THAT(failed.error().message, HasSubstr(name));
  }
  options.asset_folders.clear();
  EXPECT_TRUE(furnish(layout, Catalog::builtin(), options)) << "without folders nothing is read";
}

}  // namespace
}  // namespace layoutbox
