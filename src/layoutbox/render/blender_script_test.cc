#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "layoutbox/base/files.h"
#include "layoutbox/base/process.h"
#include "layoutbox/render/mesh_block.h"
#include "layoutbox/render/render.h"

namespace layoutbox {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Mesh triangle(float width) {
  return {{{0, 0, 0}, {width, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {{0, 0}, {width, 0}, {0, 1}}, {0, 1, 2}};
}

struct ScriptRoom {
  Model model;
  Layout layout;
};

// A room of 2 × 1 m with a picture on its back wall and a chair; names and prompt try to break out of the script.
ScriptRoom small_room() {
  ScriptRoom out;
  out.layout.prompt = "a \"room\"\n'''import os''' \"\"\" \\ é 🛋 \x01";
  out.layout.room.polygon = {{0, 0}, {2000, 0}, {2000, 1000}, {0, 1000}};
  out.layout.room.height = 2500;
  for (std::size_t i = 0; i < 4; ++i) {
    Wall wall;
    wall.id = "wall" + std::to_string(i + 1);
    wall.start = out.layout.room.polygon[i];
    wall.end = out.layout.room.polygon[(i + 1) % 4];
    out.layout.room.walls.push_back(wall);
  }
  Surface oak;
  oak.name = "oak\"";
  oak.texture = "wood";
  out.model.surfaces.push_back(oak);
  const auto add = [&](std::string id, NodeKind kind, std::string support) {
    Node node;
    node.id = id;
    node.kind = kind;
    node.category = "chair";
    node.parts.push_back({triangle(1), 0});
    node.position = {0.5f, 0.25f, 0};
    out.model.nodes.push_back(node);
    if (kind != NodeKind::kObject) return;
    PlacedObject object;
    object.id = std::move(id);
    object.size = {400, 500, 900};
    object.supported_by = std::move(support);
    out.layout.objects.push_back(object);
  };
  add("floor", NodeKind::kFloor, "");
  add("chair_\"1\\", NodeKind::kObject, "floor");
  add("picture_1", NodeKind::kObject, "wall3");
  return out;
}

std::string script() {
  const ScriptRoom room = small_room();
  return write_blender_script(room.model, room.layout, Catalog::builtin(), {});
}

TEST(BlenderScript, NamesEveryObjectWithItsPlaceAndSize) {
  const std::string text = script();
  EXPECT_THAT(text, HasSubstr(R"("id": "chair_\"1\\")"));
  EXPECT_THAT(text, HasSubstr(R"("id": "picture_1")"));
  EXPECT_THAT(text, HasSubstr("\"at\": (0.5, 0.25, 0.0)"));
  EXPECT_THAT(text, HasSubstr("\"size\": (0.4, 0.5, 0.9)"));
  EXPECT_THAT(text, HasSubstr(R"("stands_on": "wall3", "wall": "", "hangs_on": "wall3", "asked": True)"));
}

TEST(BlenderScript, CarriesTheOptions) {
  const ScriptRoom room = small_room();
  RenderOptions options;
  options.width = 640;
  options.height = 480;
  options.azimuth_deg = 30;
  options.quality = Quality::kFinal;
  options.save_blend = false;
  options.orthographic = false;
  const std::string text = write_blender_script(room.model, room.layout, Catalog::builtin(), options);
  EXPECT_THAT(text, HasSubstr("\"width\": 640, \"height\": 480"));
  EXPECT_THAT(text, HasSubstr("\"azimuth\": 30.0"));
  EXPECT_THAT(text, HasSubstr("\"orthographic\": False"));
  EXPECT_THAT(text, HasSubstr("QUALITY = \"final\""));
  EXPECT_THAT(text, HasSubstr("\"blend\": \"\""));
}

TEST(BlenderScript, HoldsNoPlaceOfThisMachine) {
  for (const char* place : {"/home", "/root", "/tmp", "/usr", "/work", LAYOUTBOX_SOURCE_FOLDER}) {
    EXPECT_THAT(script(), Not(HasSubstr(place)));
  }
}

TEST(BlenderScript, IsTheSameEveryTime) { EXPECT_EQ(script(), script()); }

// Python reads it: the syntax is right, nothing of the prompt is code, and the meshes unpack to what went in.
TEST(BlenderScript, IsGoodPython) {
  if (find_program("python3").empty()) GTEST_SKIP() << "no python3 here";
  const auto folder = TemporaryFolder::make("script-test").value();
  std::ofstream(folder.path() / "blender.py") << script();
  std::ofstream(folder.path() / "check.py") << R"(
import ast, sys, types
text = open(sys.argv[1], encoding="utf-8").read()
tree = ast.parse(text)
tables = {n.targets[0].id: n for n in tree.body if isinstance(n, ast.Assign)}
objects = ast.literal_eval(tables["OBJECTS"].value)
assert [row["id"] for row in objects] == ['chair_"1\\', 'picture_1'], objects
assert ast.literal_eval(tables["MATERIALS"].value)['oak"']["texture"] == "wood"
for node in ast.walk(tree):
    if isinstance(node, ast.Import):
        assert "os" not in [a.name for a in node.names] or node.lineno > tables["SHELL"].lineno
for name in ("bpy", "mathutils", "mathutils.bvhtree"):
    sys.modules[name] = types.ModuleType(name)
sys.modules["mathutils"].Vector = sys.modules["mathutils.bvhtree"].BVHTree = None
space = {"__name__": "blender"}
exec(compile(text, "blender.py", "exec"), space)
meshes = space["read_meshes"]()
assert len(meshes) == 1, "equal meshes share one"
positions, normals, uvs, indices = meshes[0]
assert [round(v, 6) for v in positions] == [0, 0, 0, 1, 0, 0, 0, 1, 0] and list(indices) == [0, 1, 2], positions
assert list(normals)[:3] == [0, 0, 1] and [round(v, 5) for v in uvs] == [0, 0, 1, 0, 0, 1]
)";
  const auto outcome = run_process({"python3", (folder.path() / "check.py").string(), (folder.path() / "blender.py").string()});
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->exit_status, 0) << outcome->output;
}

TEST(MeshBlock, SharesEqualMeshesAndOnlyThose) {
  MeshBlock block;
  EXPECT_EQ(block.add(triangle(1)), 0);
  EXPECT_EQ(block.add(triangle(2)), 1);
  EXPECT_EQ(block.add(triangle(1)), 0);
}

TEST(MeshBlock, MeasuresANode) {
  Node node;
  EXPECT_THAT(bounds_of(node), ::testing::ElementsAre(0, 0, 0));
  node.parts.push_back({triangle(3), 0});
  EXPECT_THAT(bounds_of(node), ::testing::ElementsAre(3, 1, 0));
}

}  // namespace
}  // namespace layoutbox
