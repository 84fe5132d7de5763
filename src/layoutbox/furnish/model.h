// Meshes, materials and lights of a furnished room: what render and export draw. Nothing of Blender or glTF in it.
// Metres, room frame (x right, y away from the viewer, z up); mesh positions are in the node's own frame.
#pragma once

#include <array>
#include <cstdint>
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

// A physically based surface. `texture` names a procedure ("wood", "fabric", "tiles"…) that render and export both make from the same
// parameters, or is empty for a plain colour.
struct Surface {
  std::string name;
  Color base;
  float roughness = 0.7f, metallic = 0, alpha = 1, emission = 0;  // emission: strength of light of the base colour
  std::string texture;
  Color second;          // the texture's other colour (grain, joints)
  float scale = 1;       // metres per repeat
  std::string image;     // a user's own image file, or empty
};

struct Part {
  Mesh mesh;
  int surface = 0;       // index into Model::surfaces
};

enum class NodeKind { kFloor, kWall, kCeiling, kOpening, kObject };

struct Light {
  Vec3f position{};      // in the node's frame
  Color color{1, 0.9, 0.75};
  float watts = 20;      // radiant power of a point light, as Blender counts it
  float radius = 0.05f;
};

struct Node {
  std::string id;        // the object's, wall's or opening's id
  NodeKind kind = NodeKind::kObject;
  std::string category, name;
  std::vector<Part> parts;
  std::array<float, 3> position{};   // metres, room frame
  float rotation_deg = 0;            // about z
  std::vector<Light> lights;
  // Walls and openings: the wall's inward normal in the plan, so that a camera can leave out the walls that face it.
  std::optional<Vec2f> inward;
  std::string parent;                // openings, skirtings: the wall's id
};

struct Model {
  std::vector<Surface> surfaces;
  std::vector<Node> nodes;
};

}  // namespace layoutbox
