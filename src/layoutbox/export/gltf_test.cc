#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "layoutbox/export/export.h"
#include "layoutbox/export/gltf_faces.h"
#include "layoutbox/export/pattern.h"
#include "layoutbox/furnish/kit.h"

namespace layoutbox {
namespace {

using nlohmann::json;

Mesh square(float z, float up) {
  return {{{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}},
          {{0, 0, up}, {0, 0, up}, {0, 0, up}, {0, 0, up}},
          {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
          {0, 1, 2, 0, 2, 3}};
}

Surface surface(const char* name, const char* texture = "") {
  Surface out;
  out.name = name;
  out.base = {0.5, 0.25, 1};
  out.texture = texture;
  return out;
}

Node node(std::string id, NodeKind kind, std::vector<Part> parts) {
  Node out;
  out.id = std::move(id);
  out.kind = kind;
  out.parts = std::move(parts);
  return out;
}

struct GltfRoom {
  Model model;
  Layout layout;
};

// Two equal chairs, the second turned, with a lamp; a ceiling.
GltfRoom small_room() {
  GltfRoom out;
  out.model.surfaces = {surface("plain"), surface("oak", "wood")};
  out.model.nodes = {node("chair_1", NodeKind::kObject, {{square(0.5f, 1), 1}}), node("chair_2", NodeKind::kObject, {{square(0.5f, 1), 1}}),
                     node("ceiling", NodeKind::kCeiling, {{square(2.5f, -1), 0}, {square(2.6f, 1), 0}})};
  out.model.nodes[1].position = {1, 2, 0.25f};
  out.model.nodes[1].rotation_deg = 90;
  out.model.nodes[1].lights.push_back({{0, 0, 1}, {1, 1, 1}, 20, 0.05f});
  for (const char* id : {"chair_1", "chair_2"}) {
    PlacedObject object;
    object.id = id;
    object.category = "chair";
    object.name = "red \"chair\"";
    object.size = {400, 500, 900};
    out.layout.objects.push_back(object);
  }
  PlacedRelation relation;
  relation.relation.id = "c1";
  relation.relation.type = RelationType::kNextTo;
  relation.relation.targets = {"chair_1"};
  relation.relation.references = {"chair_2"};
  relation.held = true;
  out.layout.relations.push_back(relation);
  return out;
}

std::uint32_t u32(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

struct Glb {
  std::string bytes;
  json document;
};

Glb write(const GltfRoom& room) {
  Glb out;
  out.bytes = write_glb(room.model, room.layout).value();
  out.document = json::parse(out.bytes.substr(20, u32(out.bytes, 12)));
  return out;
}

json node_named(const Glb& glb, std::string_view name) {
  for (const json& candidate : glb.document["nodes"]) {
    if (candidate["name"] == name) return candidate;
  }
  return {};
}

TEST(Gltf, IsABinaryContainerOfItsOwnLength) {
  const Glb glb = write(small_room());
  EXPECT_EQ(glb.bytes.substr(0, 4), "glTF");
  EXPECT_EQ(u32(glb.bytes, 4), 2u);
  EXPECT_EQ(u32(glb.bytes, 8), glb.bytes.size());
  EXPECT_EQ(glb.document["asset"]["version"], "2.0");
}

TEST(Gltf, TurnsTheRoomSoThatYIsUp) {
  const json chair = node_named(write(small_room()), "chair_2");
  EXPECT_EQ(chair["translation"], json({1.0, 0.25, -2.0}));
  EXPECT_NEAR(chair["rotation"][1].get<double>(), std::sqrt(0.5), 1e-6);
  EXPECT_NEAR(chair["rotation"][3].get<double>(), std::sqrt(0.5), 1e-6);
}

TEST(Gltf, WallsKeepTheFacesThatLookIntoTheRoom) {
  GltfRoom room = small_room();
  const auto face = [](float side) {
    return Mesh{{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}, {{0, side, 0}, {0, side, 0}, {0, side, 0}}, {{0, 0}, {1, 0}, {1, 1}}, {0, 1, 2}};
  };
  const std::pair<float, Vec2f> walls[] = {{0.0f, {0, 1}}, {90.0f, {-1, 0}}, {180.0f, {0, -1}}, {270.0f, {1, 0}}};
  for (const auto& [turn, inward] : walls) {
    Node wall = node("wall_" + std::to_string(turn), NodeKind::kWall, {{face(1), 0}, {face(-1), 1}});
    wall.rotation_deg = turn;
    wall.inward = inward;
    room.model.nodes = {wall};
    const Glb glb = write(room);
    const json& primitives = glb.document["meshes"][0]["primitives"];
    ASSERT_EQ(primitives.size(), 1u) << turn;
    EXPECT_EQ(primitives[0]["material"], 0) << "the inner face, of the wall turned by " << turn;
  }
}

// A wall 4 m long and 2 m high with a window: its inner face and the four reveals stay, nothing that would hang in the air.
TEST(Gltf, WallsKeepTheRevealsOfTheirOpeningsAndNoEdges) {
  const kit::Hole window{1, 2, 0.5, 1.5};
  Node wall = node("wall1", NodeKind::kWall, {{kit::pierced_slab(4, 0, 2, -0.1, 0, {&window, 1}, 0.1, 0.1), 0}});
  wall.inward = Vec2f{0, 1};
  const Mesh& mesh = wall.parts[0].mesh;
  double inner = 0, reveals = 0;
  const std::vector<std::uint32_t> indices = exported_triangles(mesh, wall);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const auto at = [&](std::size_t k) {
      const Vec3f& p = mesh.positions[indices[i + k]];
      return kit::Vec{double{p[0]}, double{p[1]}, double{p[2]}};
    };
    const double area = kit::length(kit::cross(at(1) - at(0), at(2) - at(0))) / 2;
    (mesh.normals[indices[i]][1] > 0.9f ? inner : reveals) += area;
  }
  EXPECT_NEAR(inner, 4 * 2 - 1, 1e-5);
  EXPECT_NEAR(reveals, 4 * 0.1, 1e-5);
}

TEST(Gltf, SharesTheMeshOfEqualObjects) {
  const Glb glb = write(small_room());
  EXPECT_EQ(node_named(glb, "chair_1")["mesh"], node_named(glb, "chair_2")["mesh"]);
  EXPECT_EQ(glb.document["meshes"].size(), 2u);
}

TEST(Gltf, KeepsMeaningInExtras) {
  const json extras = node_named(write(small_room()), "chair_1")["extras"];
  EXPECT_EQ(extras["category"], "chair");
  EXPECT_EQ(extras["name"], "red \"chair\"");
  EXPECT_EQ(extras["supportedBy"], "floor");
  EXPECT_EQ(extras["size"], json({0.4, 0.5, 0.9}));
  ASSERT_EQ(extras["relations"].size(), 1u);
  EXPECT_EQ(extras["relations"][0]["type"], "nextTo");
  EXPECT_EQ(extras["relations"][0]["relativeTo"], json({"chair_2"}));
  EXPECT_EQ(extras["relations"][0]["held"], true);
}

TEST(Gltf, ShowsTheCeilingFromBelowOnly) {
  const Glb glb = write(small_room());
  const json mesh = glb.document["meshes"][node_named(glb, "ceiling")["mesh"].get<std::size_t>()];
  EXPECT_EQ(mesh["primitives"].size(), 1u);
}

TEST(Gltf, EmbedsOneTexturePerPatternedSurface) {
  const Glb glb = write(small_room());
  ASSERT_EQ(glb.document["images"].size(), 1u);
  EXPECT_EQ(glb.document["images"][0]["mimeType"], "image/png");
  const json& materials = glb.document["materials"];
  EXPECT_FALSE(materials[0]["pbrMetallicRoughness"].contains("baseColorTexture"));
  EXPECT_TRUE(materials[1]["pbrMetallicRoughness"].contains("baseColorTexture"));
  EXPECT_NEAR(materials[0]["pbrMetallicRoughness"]["baseColorFactor"][0].get<double>(), 0.2140, 1e-3) << "sRGB 0.5 is 0.214 linear";
}

TEST(Gltf, WritesLampsAsPunctualLights) {
  const Glb glb = write(small_room());
  EXPECT_THAT(glb.document["extensionsUsed"], ::testing::Contains("KHR_lights_punctual"));
  EXPECT_EQ(glb.document["extensions"]["KHR_lights_punctual"]["lights"].size(), 1u);
  const json lamp = node_named(glb, "chair_2 light 1");
  EXPECT_EQ(lamp["extensions"]["KHR_lights_punctual"]["light"], 0);
  EXPECT_EQ(lamp["translation"], json({0.0, 1.0, 0.0}));
}

TEST(Gltf, IsTheSameEveryTime) { EXPECT_EQ(write(small_room()).bytes, write(small_room()).bytes); }

TEST(Gltf, SaysSoWhereTextIsNoText) {
  GltfRoom room = small_room();
  room.layout.objects[0].name = "\xff\xfe";
  const auto glb = write_glb(room.model, room.layout);
  EXPECT_TRUE(glb || glb.error().code == ErrorCode::kInternal);
}

// Every procedure that model.h names has a pattern.
TEST(Pattern, KnowsEveryProcedure) {
  for (const char* name : {"wood", "planks", "parquet", "tiles", "checker", "bricks", "marble", "terrazzo", "concrete", "plaster", "fabric",
                           "carpet", "leather", "wicker", "stripes", "brushed", "tatami", "flags", "flowers"}) {
    ASSERT_TRUE(has_pattern(name)) << name;
    const std::string png = pattern_png(surface("x", name));
    EXPECT_EQ(png.substr(1, 3), "PNG");
    EXPECT_LT(png.size(), 80000u) << name;
    EXPECT_GT(pattern_size(name).u, 0);
  }
  EXPECT_FALSE(has_pattern(""));
  EXPECT_FALSE(has_pattern("lava"));
}

TEST(Pattern, DiffersInColoursOnly) {
  Surface other = surface("b", "planks");
  other.base = {0, 1, 0};
  const std::string a = pattern_png(surface("a", "planks")), b = pattern_png(other);
  EXPECT_NE(a, b);
  EXPECT_EQ(a.substr(a.find("IDAT")), b.substr(b.find("IDAT")));
}

}  // namespace
}  // namespace layoutbox
