#include "layoutbox/furnish/mesh_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "layoutbox/furnish/furnish.h"
#include "layoutbox/furnish/mesh_checks.h"
#include "layoutbox/furnish/test_mesh_files.h"

namespace layoutbox {
namespace {

// A triangle as glTF; `buffer` is what its buffer's uri says.
std::string gltf(const std::string& buffer, int last_index = 2) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"translation":[0,5,0]}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],
    "materials":[{"name":"paint","pbrMetallicRoughness":{"baseColorFactor":[0.5,0.5,0.5,1],"roughnessFactor":0.25}}],
    "buffers":[{"byteLength":42,"uri":")" +
         buffer + R"("}],"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
                 {"bufferView":1,"componentType":5123,"count":)" +
         std::to_string(last_index + 1) + R"(,"type":"SCALAR"}]})";
}

std::string triangle_bytes() {
  const std::array<float, 9> points{0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::array<std::uint16_t, 3> indices{0, 1, 2};
  std::string bytes(42, '\0');
  std::memcpy(bytes.data(), points.data(), 36);
  std::memcpy(bytes.data() + 36, indices.data(), 6);
  return bytes;
}

TEST_F(MeshFiles, ReadsAnObjWithItsMaterial) {
  const auto mesh = read("box.obj");
  ASSERT_TRUE(mesh) << mesh.error().message;
  ASSERT_EQ(mesh->parts.size(), 1U);
  EXPECT_EQ(mesh->parts[0].mesh.indices.size(), 36U);
  const Surface& red = mesh->surfaces.at(static_cast<std::size_t>(mesh->parts[0].surface));
  EXPECT_NEAR(red.base.r, 0.9, 1e-6);
  EXPECT_EQ(mesh_checks::open_edges(mesh->parts[0].mesh), 0);
  EXPECT_NEAR(mesh_checks::volume(mesh->parts[0].mesh), 8, 1e-4) << "outside stays outside";
  const kit::Vec size = bounds(*mesh).size();
  EXPECT_NEAR(size.z, 1, 1e-6) << "the file's y is up";
  EXPECT_NEAR(size.y, 4, 1e-6);
}

TEST_F(MeshFiles, ReadsGltfWithItsNodesAndColours) {
  put("triangle.bin", triangle_bytes());
  put("triangle.gltf", gltf("triangle.bin"));
  const auto mesh = read("triangle.gltf");
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_NEAR(bounds(*mesh).min.z, 5, 1e-6) << "where its node stands";
  const Surface& paint = mesh->surfaces.at(static_cast<std::size_t>(mesh->parts.at(0).surface));
  EXPECT_NEAR(paint.base.r, 0.735, 0.01) << "its colours are linear";
  EXPECT_NEAR(static_cast<double>(paint.roughness), 0.25, 1e-6);
}

TEST_F(MeshFiles, FitsEvenlyAndStandsOnTheFloor) {
  auto mesh = read("box.obj");
  ASSERT_TRUE(mesh && fit_mesh(*mesh, {1, 1, 1}, "", Mount::kFloor));
  const kit::Box b = bounds(*mesh);
  EXPECT_NEAR(b.size().y, 1, 1e-6);
  EXPECT_NEAR(b.size().x, 0.5, 1e-6);
  EXPECT_NEAR(b.size().z, 0.25, 1e-6);
  EXPECT_NEAR(b.min.z, 0, 1e-6);
  EXPECT_NEAR(b.center().x, 0, 1e-6);
}

TEST_F(MeshFiles, FillsTheSizeExactlyWhereTheProportionsAreTheSame) {
  auto mesh = read("box.obj");
  ASSERT_TRUE(mesh && fit_mesh(*mesh, {1.01, 2, 0.5}, "", Mount::kFloor));
  EXPECT_NEAR(bounds(*mesh).size().x, 1.01, 1e-6);
  EXPECT_NEAR(bounds(*mesh).size().y, 2, 1e-6);
}

TEST_F(MeshFiles, TheFrontIsTurnedToUs) {
  // A wedge that is high at the file's +x end: with front +x, the high end is at −y.
  put("wedge.obj", "v 0 0 0\nv 0 0 1\nv 2 0 0\nv 2 0 1\nv 2 1 0\nv 2 1 1\nf 1 3 4 2\nf 3 5 6 4\nf 1 2 6 5\nf 1 5 3\nf 2 4 6\n");
  const auto high_end = [&](const char* front) {
    auto mesh = read("wedge.obj");
    EXPECT_TRUE(mesh && fit_mesh(*mesh, {5, 5, 5}, front, Mount::kFloor)) << front;
    kit::Vec high;
    for (const Vec3f& p : mesh->parts[0].mesh.positions) {
      if (double{p[2]} > high.z) high = {double{p[0]}, double{p[1]}, double{p[2]}};
    }
    return high;
  };
  EXPECT_LT(high_end("+x").y, -1);
  EXPECT_GT(high_end("-x").y, 1);
  EXPECT_GT(high_end("+z").x, 1);
  EXPECT_LT(high_end("-z").x, -1);
  auto mesh = read("wedge.obj");
  EXPECT_FALSE(fit_mesh(*mesh, {1, 1, 1}, "sideways", Mount::kFloor));
}

TEST_F(MeshFiles, WhatIsWrongIsSaidWithTheName) {
  put("broken.glb", "glTF\2\0\0\0 this is no glTF");
  put("words.obj", "these are words\n");
  put("list.txt", "x");
  put("short.gltf", gltf("triangle.bin", 90));
  put("triangle.bin", triangle_bytes());
  put("wild.obj", "v 0 0 0\nv 1 0 0\nf 1 2 99\n");
  std::ofstream(folder_.path() / "secret.obj") << kBox;
  expect_error("none.glb", ErrorCode::kIo, "not there");
  expect_error("../secret.obj", ErrorCode::kUsage, "outside");
  expect_error((folder_.path() / "secret.obj").string(), ErrorCode::kUsage, "whole path");
  expect_error("broken.glb", ErrorCode::kParse, "glTF");
  expect_error("words.obj", ErrorCode::kParse, "no triangles");
  expect_error("list.txt", ErrorCode::kParse, "no glTF, GLB or OBJ");
  expect_error("short.gltf", ErrorCode::kParse, "shorter");
  expect_error("wild.obj", ErrorCode::kParse, "wild.obj");
  expect_error("box.obj", ErrorCode::kTooLarge, "MB", {20, 400'000});
  expect_error("box.obj", ErrorCode::kTooLarge, "more than 5 triangles", {1 << 20, 5});
}

// Small files that ask for much: each is refused before it is given.
TEST_F(MeshFiles, SmallFilesThatAskForMuchAreRefused) {
  put("triangle.bin", triangle_bytes());
  const auto with = [](std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
  };
  const std::string good = gltf("triangle.bin");
  put("count.gltf", with(good, R"("bufferView":0,"componentType":5126,"count":3)", R"("componentType":5126,"count":39999999)"));
  expect_error("count.gltf", ErrorCode::kTooLarge, "too many vertices");
  std::string many = "0";
  for (int i = 0; i < 60'000; ++i) many += ",0";
  put("nodes.gltf", with(good, R"("nodes":[0])", R"("nodes":[)" + many + "]"));
  expect_error("nodes.gltf", ErrorCode::kTooLarge, "too many nodes");
  put("often.gltf", with(good, R"("nodes":[0])", R"("nodes":[0,0,0,0,0,0])"));
  expect_error("often.gltf", ErrorCode::kTooLarge, "more than 5 triangles", {1 << 20, 5});
  std::string tree = R"({"children":[1,1]})";  // 2^40 instances
  for (int i = 1; i < 40; ++i) tree += R"(,{"children":[)" + std::to_string(i + 1) + "," + std::to_string(i + 1) + "]}";
  put("tree.gltf", with(good, R"("meshes":[{)", R"("nodes":[)" + tree + R"(,{"translation":[0,0,0]}],"meshes":[{)"));
  expect_error("tree.gltf", ErrorCode::kTooLarge, "too many nodes");
  std::string polygon = "f";
  for (int i = 0; i < 20'000; ++i) polygon += " 1 2 3";
  put("polygon.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + polygon + "\n");
  expect_error("polygon.obj", ErrorCode::kParse, "too long");
  std::string again;
  for (int i = 0; i < 2'000; ++i) again += "mtllib box.mtl\n";
  put("again.obj", again + std::string(kBox));
  EXPECT_TRUE(read("again.obj", {1 << 16, 100})) << "named often, read once";
}

TEST_F(MeshFiles, WhatIsCompressedIsRefusedInWords) {
  put("triangle.bin", triangle_bytes());
  std::string text = gltf("triangle.bin");
  const std::string from = R"("indices":1,)";
  text.replace(text.find(from), from.size(),
               R"("indices":1,"extensions":{"KHR_draco_mesh_compression":{"bufferView":0,"attributes":{"POSITION":0}}},)");
  put("draco.gltf", text);
  expect_error("draco.gltf", ErrorCode::kParse, "Draco");
}

TEST_F(MeshFiles, QuadsAndNegativeNumbersOfAnObjAreRead) {
  put("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1\n");
  const auto mesh = read("quad.obj");
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->parts.at(0).mesh.indices.size(), 6U);
  put("thief.obj", "mtllib ../secret.mtl\n" + std::string(kBox));
  expect_error("thief.obj", ErrorCode::kParse, "outside");
}

TEST_F(MeshFiles, WhatAFileNamesMustLieInItsFolderToo) {
  std::ofstream(folder_.path() / "secret.bin", std::ios::binary) << triangle_bytes();
  put("thief.gltf", gltf("../secret.bin"));
  expect_error("thief.gltf", ErrorCode::kParse, "outside");
  fs::create_symlink(folder_.path() / "secret.bin", assets() / "link.bin");
  put("linked.gltf", gltf("link.bin"));
  expect_error("linked.gltf", ErrorCode::kParse, "outside");
}

// One white pixel.
std::string white_png() {
  std::string bytes;
  for (const unsigned char c : {0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00,
                                0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x00, 0x00, 0x00, 0x00, 0x3a, 0x7e, 0x9b, 0x55, 0x00,
                                0x00, 0x00, 0x0a, 0x49, 0x44, 0x41, 0x54, 0x78, 0x9c, 0x63, 0xf8, 0x0f, 0x00, 0x01, 0x01, 0x01, 0x00,
                                0xb1, 0x38, 0xf6, 0x14, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82}) {
    bytes += static_cast<char>(c);
  }
  return bytes;
}

TEST_F(MeshFiles, NumbersThatAreNoneAreAnError) {
  put("nan.obj", "v nan 0 0\nv 2 0 0\nv 2 1 0\nf 1 2 3\n");
  expect_error("nan.obj", ErrorCode::kParse, "nan 0 0");
  put("infinite.obj", "v 0 0 0 # not\nv 2 0 0\nv 2 1 0\nvn 0 -Inf 0\nf 1//1 2//1 3//1\n");
  expect_error("infinite.obj", ErrorCode::kParse, "-Inf");
}

TEST_F(MeshFiles, ABrokenTextureIsAnErrorAndAMissingOneIsNot) {
  put("box.mtl", "newmtl red\nKd 0.9 0.1 0.1\nmap_Kd wood.png\n");
  EXPECT_TRUE(read("box.obj"));
  put("wood.png", white_png());
  const auto whole = read("box.obj");
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_TRUE(whole->surfaces[0].image_data);
  put("wood.png", white_png().substr(0, 50));
  expect_error("box.obj", ErrorCode::kParse, "wood.png");
}

TEST_F(MeshFiles, ASceneMaterialsImageIsReadAndAMissingOneIsAnError) {
  put("paint.png", white_png());
  Layout layout;
  Material own;
  own.id = "paper";
  own.texture = "paint.png";
  layout.materials = {own};
  PlacedObject table;
  table.id = "table_1";
  table.category = "table";
  table.size = {1000, 700, 750};
  table.material = "paper";
  layout.objects = {table};
  FurnishOptions options;
  options.asset_folders = {assets()};
  const auto model = furnish(layout, Catalog::builtin(), options);
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_TRUE(std::any_of(model->surfaces.begin(), model->surfaces.end(), [](const Surface& s) { return s.image_data != nullptr; }));
  layout.materials[0].texture = "gone.png";
  EXPECT_FALSE(furnish(layout, Catalog::builtin(), options));
}

}  // namespace
}  // namespace layoutbox
