#include "layoutbox/furnish/kit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "layoutbox/furnish/mesh_checks.h"

namespace layoutbox::kit {
namespace {

constexpr double kPi = 3.14159265358979323846;

const Box kBox{{-0.4, -0.3, 0.1}, {0.6, 0.5, 0.7}};

struct NamedSolid {
  const char* name;
  Mesh mesh;
};

std::vector<NamedSolid> solids() {
  return {{"box", box(kBox, 0.01)},
          {"sharp box", box(kBox, 0)},
          {"thin box", box({{0, 0, 0}, {1, 1, 0.002}}, 0.01)},
          {"rounded box", rounded_box(kBox, 0.1, 3)},
          {"cushion", cushion(kBox, 0.05)},
          {"cushion domed below", cushion(kBox, 0.05, false)},
          {"pillow", pillow(kBox)},
          {"taper", taper({0, 0, 0}, {0.1, 0.1}, {0.05, 0, 1}, {0.2, 0.15})},
          {"beam", beam({0, 0, 0}, {0.3, 0.4, 0.5}, {0.05, 0.04}, 0.004)},
          {"cylinder", cylinder({0.1, 0.2, 0.3}, 0.2, 0.5)},
          {"cone", cone({0, 0, 0}, 0.3, 0.1, 0.5)},
          {"leg", leg({0.1, 0, 0}, {0, 0.1, 0.7}, 0.01, 0.02)},
          {"rod", rod({0, 0, 0}, {0.3, -0.2, 0.5}, 0.02)},
          {"lathe", lathe({{0, 0}, {0.5, 0}, {0.4, 0.3}, {0.2, 0.9}, {0, 1}})},
          {"squashed lathe", lathe({{0.3, 0}, {0.5, 0}, {0.5, 0.2}, {0.3, 0.2}, {0.3, 0}}, 20, 0.5)},
          {"tube", tube(curve({{0, 0, 0}, {0.1, 0.2, 0.5}, {0.6, 0, 0.6}}), 0.03)},
          {"closed tube", tube(curve({{1, 0, 0}, {0, 1, 0.1}, {-1, 0, 0}, {0, -1, 0.1}}, 6, true), 0.05, 8, true)},
          {"torus", torus({0, 0, 0}, 0.5, 0.1)},
          {"prism", prism({{0, 0}, {1, 0}, {1, 1}, {0.5, 0.2}, {0, 1}}, 0, 0.3)},
          {"round prism", prism(ellipse({0, 0}, {0.5, 0.3}), 0, 0.1, true)},
          {"ellipsoid", ellipsoid({0, 0, 0}, {0.5, 0.3, 0.2})},
          {"leaf", leaf({0, 0, 0}, {0.3, 0, 0.2}, 0.1, 0.05)},
          {"waves", waves(kBox, 4)},
          {"wall with holes", pierced_slab(4, 0, 3, -0.1, 0, std::vector<Hole>{{0.5, 1.4, 0, 2}, {2, 3.2, 0.9, 2.1}}, 0.1, 0.1)},
          {"mirrored box", posed(box(kBox), scaled(-1, 1, 1))}};
}

TEST(Kit, EverySolidIsClosedAndFacesOutwards) {
  for (const NamedSolid& solid : solids()) {
    EXPECT_EQ(mesh_checks::open_edges(solid.mesh), 0) << solid.name;
    EXPECT_GT(mesh_checks::volume(solid.mesh), 0) << solid.name;
    EXPECT_EQ(solid.mesh.positions.size(), solid.mesh.normals.size()) << solid.name;
    EXPECT_EQ(solid.mesh.positions.size(), solid.mesh.uvs.size()) << solid.name;
  }
}

TEST(Kit, NormalsHaveUnitLength) {
  for (const NamedSolid& solid : solids()) {
    for (const Vec3f& n : solid.mesh.normals) {
      EXPECT_NEAR(std::hypot(static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])), 1, 1e-4) << solid.name;
    }
  }
}

TEST(Kit, SolidsFillTheirBoxExactly) {
  for (const Mesh& mesh : {box(kBox), rounded_box(kBox, 0.1), cushion(kBox, 0.05), pillow(kBox)}) {
    const Box b = bounds(mesh);
    for (const Vec difference : {b.min - kBox.min, b.max - kBox.max}) EXPECT_LT(length(difference), 1e-6);
  }
}

TEST(Kit, VolumesAreThoseOfTheShapes) {
  EXPECT_NEAR(mesh_checks::volume(box(kBox, 0)), 1.0 * 0.8 * 0.6, 1e-6);
  EXPECT_NEAR(mesh_checks::volume(prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 0, 0.5)), 1.5, 1e-6);
  EXPECT_NEAR(mesh_checks::volume(ellipsoid({0, 0, 0}, {0.5, 0.5, 0.5}, 64, 32)), 4.0 / 3 * kPi * 0.125, 0.005);
  const std::vector<Hole> holes{{1, 2, 0.5, 1.5}};
  EXPECT_NEAR(mesh_checks::volume(pierced_slab(3, 0, 2, -0.1, 0, holes)), (6 - 1) * 0.1, 1e-6);
}

TEST(Kit, MitredWallsReachFurtherOutside) {
  const Box b = bounds(pierced_slab(3, 0, 2, -0.1, 0, {}, 0.1, 0.2));
  EXPECT_NEAR(b.min.x, -0.1, 1e-6);
  EXPECT_NEAR(b.max.x, 3.2, 1e-6);
}

TEST(Kit, TriangulatesHollowOutlines) {
  const std::vector<Vec2> u{{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  double area = 0;
  for (const auto& [a, b, c] : triangulate(u)) area += ((u[b].x - u[a].x) * (u[c].y - u[a].y) - (u[b].y - u[a].y) * (u[c].x - u[a].x)) / 2;
  EXPECT_NEAR(area, 5, 1e-9);
}

// Whatever lies in memory beside its faces (once the first ring's normals took some of that).
TEST(Loft, NormalsFollowFromItsRingsAlone) {
  std::vector<std::vector<Vec>> rings(2);
  for (std::size_t k = 0; k < rings.size(); ++k) {
    for (int i = 0; i < 16; ++i) rings[k].push_back({std::cos(kPi * i / 8), std::sin(kPi * i / 8), static_cast<double>(k)});
  }
  std::vector<std::unique_ptr<std::vector<double>>> around;
  for (int i = 0; i < 400; ++i) around.push_back(std::make_unique<std::vector<double>>(48, i % 3 == 0 ? 1e3 : i % 3 == 1 ? 4e2 : -1e3));
  for (std::size_t i = 0; i < around.size(); i += 2) around[i].reset();
  for (int turn = 0; turn < 50; ++turn) {
    const Mesh tube = loft(rings);
    for (std::size_t v = 0; v < tube.normals.size(); ++v) {
      const auto& n = tube.normals[v];
      if (std::abs(n[2]) > 0.99F) continue;  // an end
      EXPECT_NEAR(n[2], 0, 1e-5) << "vertex " << v;
      EXPECT_NEAR(n[0] * tube.positions[v][0] + n[1] * tube.positions[v][1], 1, 1e-5) << "vertex " << v;
    }
  }
}

}  // namespace
}  // namespace layoutbox::kit
