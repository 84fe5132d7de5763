#include "layoutbox/render/foreign.h"

#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "layoutbox/sandbox/sandbox.h"

namespace layoutbox {
namespace {

using testing::HasSubstr;

constexpr const char* kBed = R"(
import bpy
bpy.ops.mesh.primitive_cube_add(size=1)
bed = bpy.context.object
bed.name, bed.scale, bed.location = "bed_1", (1.6, 2.0, 0.5), (1, 2, 0.25)
)";

class Foreign : public testing::Test {
 protected:
  void SetUp() override {
    if (const auto walls = sandbox::describe_walls(); !walls) GTEST_SKIP() << walls.error().message;
    auto found = find_blender();
    if (!found) GTEST_SKIP() << found.error().message;
    blender_ = *std::move(found);
  }

  ForeignRun run(const std::string& script, const ForeignOptions& options = {}) {
    auto result = run_foreign_script(blender_, script, options);
    EXPECT_TRUE(result) << (result ? "" : result.error().message);
    return result ? *std::move(result) : ForeignRun{};
  }

  // Where a node of the scene is, along x.
  double x_of(const std::string& blend, const std::string& name) {
    const auto text = gltf_of_blend(blender_, blend);
    EXPECT_TRUE(text) << (text ? "" : text.error().message);
    if (!text) return NAN;
    const auto room = nlohmann::json::parse(*text);
    for (const auto& node : room.at("nodes")) {
      if (node.at("name") == name) return node.at("matrix").at(12).get<double>();
    }
    return NAN;
  }

  Blender blender_;
};

TEST_F(Foreign, AScriptsSceneIsReadBack) {
  const ForeignRun made = run(kBed);
  ASSERT_EQ(made.end, ScriptEnd::kDone) << made.message;
  EXPECT_TRUE(is_blend(made.blend));
  EXPECT_DOUBLE_EQ(x_of(made.blend, "bed_1"), 1);
}

TEST_F(Foreign, FailuresHaveAClass) {
  const ForeignRun syntax = run("import bpy\nfor x in\n");
  EXPECT_EQ(syntax.end, ScriptEnd::kSyntax);
  EXPECT_THAT(syntax.message, HasSubstr("line 2"));
  const ForeignRun raised = run("import bpy\nbpy.ops.mesh.primitive_bed_add()\n");
  EXPECT_EQ(raised.end, ScriptEnd::kRunTime);
  EXPECT_THAT(raised.message, HasSubstr("(line 2)"));
  EXPECT_EQ(run("import os\nos.kill(os.getpid(), 11)").end, ScriptEnd::kRunTime);
  EXPECT_EQ(run("import os\nos._exit(0)").end, ScriptEnd::kRunTime);
  EXPECT_FALSE(gltf_of_blend(blender_, "BLENDER-v300 and then nothing"));
}

// What a file does when it is opened: drivers, text that registers itself, handlers.
TEST_F(Foreign, NothingInAFileRuns) {
  const ForeignRun made = run(std::string(kBed) + R"(
text = bpy.data.texts.new("start.py")
text.write("import bpy\nbpy.data.objects['bed_1'].location.x = 9\n")
text.use_module = True
driver = bed.driver_add("location", 0).driver
driver.expression = "__import__('os').getpid() * 0 + 7"
def moved(*_):
    bed.location.x = 8
bpy.app.handlers.load_post.append(moved)
bpy.app.handlers.depsgraph_update_post.append(moved)
import atexit, threading, time
atexit.register(time.sleep, 1000)
threading.Thread(target=time.sleep, args=(1000,)).start()
)");
  ASSERT_EQ(made.end, ScriptEnd::kDone) << made.message;
  const double x = x_of(made.blend, "bed_1");
  EXPECT_TRUE(x < 6.5 || x > 9.5) << x;
}

TEST_F(Foreign, LimitsHoldInBlender) {
  ForeignOptions options;
  options.limits.time_s = 12;
  options.limits.memory_mb = 1500;
  const ForeignRun picture = run(std::string(kBed) + R"(
scene = bpy.context.scene
scene.render.resolution_x = scene.render.resolution_y = 65536
scene.render.engine = "CYCLES"
scene.collection.objects.link(bpy.data.objects.new("c", bpy.data.cameras.new("c")))
scene.camera = bpy.data.objects["c"]
scene.render.filepath = "/job/huge.png"
bpy.ops.render.render(write_still=True)
)",
                                 options);
  EXPECT_EQ(picture.end, ScriptEnd::kLimit) << picture.message;
  const ForeignRun mesh =
      run("import bpy, bmesh\nm = bmesh.new()\nbmesh.ops.create_grid(m, x_segments=30000, y_segments=30000, size=1)", options);
  EXPECT_NE(mesh.end, ScriptEnd::kDone) << "one memory limit or the other";
  EXPECT_EQ(run("while True: pass", options).end, ScriptEnd::kLimit);
}

}  // namespace
}  // namespace layoutbox
