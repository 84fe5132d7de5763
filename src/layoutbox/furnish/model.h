// Meshes, materials and lights of a furnished room: what render and export draw. Nothing of Blender or glTF in it.
// Metres, room frame (x right, y away from the viewer, z up); mesh positions are in the node's own frame.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

using Vec3f = std::array<float, 3>;
using Vec2f = std::array<float, 2>;

// Triangles, counter-clockwise seen from outside. positions, normals and uvs have the same length; uvs in metres on the surface.
struct Mesh {
  std::vector<Vec3f> positions, normals;
  std::vector<Vec2f> uvs;
  std::vector<std::uint32_t> indices;
};

// A physically based surface. `texture` names a procedure that render and export both make from the same parameters; empty is a plain
// colour. Pattern coordinates are the mesh's uvs (metres); grain, planks and brushing run along u. The procedures, where `base` is the
// first colour and `second` the other one:
//   wood      fine grain along u: base with streaks of second; `scale` = metres between growth rings across the grain
//   planks    floor boards along u, `scale` long and scale/8 wide, joints staggered and of second, each board a shade of base, wood grain
//   parquet   herringbone of blocks `scale` long and scale/5 wide, shades of base, joints of second
//   tiles     square tiles of edge `scale`, joints of second 1/45 of it wide
//   checker   square tiles of edge `scale`, by turns base and second
//   bricks    bricks `scale` long and scale/3 high in running bond, joints of second
//   tatami    mats `scale` long and half as wide in running bond, rush along u, edged with second
//   flags     slabs of stone `scale` long and 0.6 of it wide in running bond, shades of base, joints of second
//   flowers   blossoms of second, about one in each square of edge `scale`, on base
//   rosettes  square tiles of edge `scale`, figures of second on base
//   logs      round logs along u, each `scale` high, second where two meet
//   glazed    square tiles of edge `scale`, each a shade of base of its own, joints of second
//   marble    base with thin turbulent veins of second about `scale` apart
//   terrazzo  base with small chips of second and darker ones about `scale` in size
//   concrete  base with soft clouds of second about `scale` in size
//   plaster   the same, hardly visible (a tenth of the contrast)
//   fabric    fine weave of threads `scale` thick, base and second
//   carpet    noise of base and second at `scale`, rough
//   leather   base with pores and creases of second about `scale` in size
//   wicker    basket weave of strips `scale` wide, base and second
//   stripes   bands across u, each `scale` wide, by turns base and second
//   brushed   metal with fine lines of second along u
struct Surface {
  std::string name;                                               // unique in a model: "oak", "linen_5a8bbf"
  Color base;                                                     // sRGB, 0–1
  float roughness = 0.7f, metallic = 0, alpha = 1, emission = 0;  // emission: strength of light of the base colour
  std::string texture;                                            // one of the above, or empty
  Color second;                                                   // the texture's other colour (grain, joints)
  float scale = 1;                                                // metres, as said above
  std::string image;                              // a user's own image file, or empty; it is laid over the uvs, `scale` metres per repeat
  std::shared_ptr<const std::string> image_data;  // its bytes, PNG or JPEG; null where it was not read
};

struct Part {
  Mesh mesh;
  int surface = 0;  // index into Model::surfaces
};

enum class NodeKind { kFloor, kWall, kCeiling, kOpening, kObject };

struct Light {
  Vec3f position{};  // in the node's frame
  Color color{1, 0.9, 0.75};
  float watts = 20;  // radiant power of a point light, as Blender counts it
  float radius = 0.05f;
};

struct Node {
  std::string id;  // the object's, wall's or opening's id
  NodeKind kind = NodeKind::kObject;
  std::string category, name;
  std::vector<Part> parts;
  std::array<float, 3> position{};  // metres, room frame
  float rotation_deg = 0;           // about z
  std::vector<Light> lights;
  // Walls and openings: the wall's inward normal in the plan, so that a camera can leave out the walls that face it.
  std::optional<Vec2f> inward;
  std::string parent;  // openings, skirtings: the wall's id
};

struct Model {
  std::vector<Surface> surfaces;
  std::vector<Node> nodes;
  double daylight = 1;  // a share of the usual light from without: dark rooms
};

}  // namespace layoutbox
