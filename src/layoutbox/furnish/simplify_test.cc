#include "layoutbox/furnish/simplify.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "layoutbox/furnish/mesh_checks.h"

namespace layoutbox {
namespace {

Vec3f on_sphere(int column, int row, int columns, int rows) {
  const double azimuth = 2 * std::numbers::pi * column / columns, polar = std::numbers::pi * row / rows;
  return {static_cast<float>(std::sin(polar) * std::cos(azimuth)), static_cast<float>(std::sin(polar) * std::sin(azimuth)),
          static_cast<float>(std::cos(polar))};
}

// A ball of radius 1 with `rows` rings, finely divided as a scan is.
Node ball(int rows) {
  const int columns = 2 * rows;
  Mesh mesh;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column < columns; ++column) mesh.positions.push_back(on_sphere(column, row, columns, rows));
  }
  mesh.normals = mesh.positions;
  mesh.uvs.assign(mesh.positions.size(), {0, 0});
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const auto at = [&](int c, int r) { return static_cast<std::uint32_t>(r * columns + c % columns); };
      const std::uint32_t a = at(column, row), b = at(column, row + 1), c = at(column + 1, row + 1), d = at(column + 1, row);
      mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
    }
  }
  Node node;
  node.parts.push_back({std::move(mesh), 0});
  return node;
}

MeshFile file_of(Node node) { return {{Surface{}}, std::move(node.parts)}; }

Node node_of(const MeshFile& file) {
  Node node;
  node.parts = file.parts;
  return node;
}

TEST(Simplify, AScanKeepsItsShape) {
  MeshFile file = file_of(ball(200));
  ASSERT_EQ(mesh_checks::triangles_of(node_of(file)), 160'000u);
  simplify(file, 5'000);
  const Node node = node_of(file);
  EXPECT_LE(mesh_checks::triangles_of(node), 5'000u);
  EXPECT_GE(mesh_checks::triangles_of(node), 500u);
  EXPECT_EQ(mesh_checks::open_edges(node.parts[0].mesh), 0);
  EXPECT_NEAR(mesh_checks::volume(node.parts[0].mesh), 4 * std::numbers::pi / 3, 0.05);
  const Mesh& mesh = node.parts[0].mesh;
  EXPECT_EQ(mesh.normals.size(), mesh.positions.size());
  EXPECT_EQ(mesh.uvs.size(), mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) ASSERT_EQ(mesh.normals[i], mesh.positions[i]) << "rows that belong together";
}

// As OBJ and STL have it: each triangle with corners of its own, smooth or flat.
Mesh torn(const Mesh& mesh, bool flat) {
  Mesh out;
  for (const std::uint32_t i : mesh.indices) {
    out.indices.push_back(static_cast<std::uint32_t>(out.positions.size()));
    out.positions.push_back(mesh.positions[i]);
    out.normals.push_back(flat ? mesh.positions[mesh.indices[3 * ((out.indices.size() - 1) / 3)]] : mesh.normals[i]);
    out.uvs.push_back(mesh.uvs[i]);
  }
  return out;
}

TEST(Simplify, TrianglesWithCornersOfTheirOwnAreReducedToo) {
  for (const bool flat : {false, true}) {
    MeshFile file = file_of(ball(200));
    file.parts[0].mesh = torn(file.parts[0].mesh, flat);
    simplify(file, 5'000);
    const Mesh& mesh = file.parts[0].mesh;
    EXPECT_LE(mesh_checks::triangles_of(node_of(file)), 5'000u) << flat;
    EXPECT_NEAR(mesh_checks::volume(mesh), 4 * std::numbers::pi / 3, 0.05) << flat;
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const auto &n = mesh.normals[i], &p = mesh.positions[i];
      ASSERT_GT(n[0] * p[0] + n[1] * p[1] + n[2] * p[2], 0.95) << "looks outwards";
    }
  }
}

TEST(Simplify, FewTrianglesStayAsTheyAre) {
  MeshFile file = file_of(ball(10));
  const Mesh before = file.parts[0].mesh;
  simplify(file, 5'000);
  EXPECT_EQ(file.parts[0].mesh.indices, before.indices);
  EXPECT_EQ(file.parts[0].mesh.positions, before.positions);
}

TEST(Simplify, EveryPartKeepsItsShare) {
  MeshFile file = file_of(ball(100));
  file.parts.push_back(ball(50).parts[0]);
  simplify(file, 5'000);
  EXPECT_LE(mesh_checks::triangles_of(node_of(file)), 5'000u);
  EXPECT_GE(file.parts[1].mesh.indices.size(), 3 * 100u);
  EXPECT_GT(file.parts[0].mesh.indices.size(), file.parts[1].mesh.indices.size());
}

TEST(Simplify, LevelsGrow) {
  EXPECT_LT(most_triangles(Detail::kLow), most_triangles(Detail::kUsual));
  EXPECT_LT(most_triangles(Detail::kUsual), most_triangles(Detail::kHigh));
}

}  // namespace
}  // namespace layoutbox
