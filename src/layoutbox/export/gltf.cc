// Binary glTF by tinygltf, whose code is compiled in furnish/read_gltf.cc.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <sstream>

#include "layoutbox/export/export.h"
#include "layoutbox/export/gltf_extras.h"
#include "layoutbox/export/gltf_faces.h"
#include "layoutbox/export/pattern.h"

#include "layoutbox/furnish/tinygltf_quietly.h"

namespace layoutbox {
namespace {

using tinygltf::Value;

// Room (x right, y away, z up) to glTF (y up).
std::array<float, 3> gltf_from_room(const Vec3f& p) { return {p[0], p[2], -p[1]}; }

// glTF's colour factors are linear.
double linear(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }

std::vector<double> linear(const Color& c) { return {linear(c.r), linear(c.g), linear(c.b)}; }

class GltfWriter {
 public:
  GltfWriter(const Model& model, const Layout& layout) : model_(model), layout_(layout) {
    out_.asset.version = "2.0";
    out_.asset.generator = "layoutbox";
    out_.buffers.resize(1);
    out_.samplers.emplace_back();
    out_.samplers[0].minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
    out_.samplers[0].magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
    out_.samplers[0].wrapS = out_.samplers[0].wrapT = TINYGLTF_TEXTURE_WRAP_REPEAT;
  }

  Result<std::string> write() {
    for (const Surface& surface : model_.surfaces) add_material(surface);
    tinygltf::Scene scene;
    scene.name = layout_.name.empty() ? "room" : layout_.name;
    for (const Node& node : model_.nodes) scene.nodes.push_back(add_node(node));
    if (out_.textures.empty()) out_.samplers.clear();
    out_.scenes.push_back(std::move(scene));
    out_.defaultScene = 0;
    std::ostringstream bytes;
    if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&out_, bytes, false, true)) {
      return fail(ErrorCode::kInternal, "the glTF could not be written");
    }
    return std::move(bytes).str();
  }

 private:
  void add_material(const Surface& surface) {
    tinygltf::Material material;
    material.name = surface.name;
    auto& pbr = material.pbrMetallicRoughness;
    pbr.roughnessFactor = double{surface.roughness};
    pbr.metallicFactor = double{surface.metallic};
    if (has_texture(surface)) {
      pbr.baseColorTexture.index = add_texture(surface);
      pbr.baseColorFactor = {1, 1, 1, double{surface.alpha}};
    } else {
      pbr.baseColorFactor = linear(surface.base);
      pbr.baseColorFactor.push_back(double{surface.alpha});
    }
    if (surface.emission > 0) {
      material.emissiveFactor = linear(surface.base);
      for (double& c : material.emissiveFactor) c *= std::min(1.0, double{surface.emission});
    }
    if (surface.alpha < 1) {
      material.alphaMode = "BLEND";
      material.doubleSided = true;
    }
    out_.materials.push_back(std::move(material));
  }

  static bool has_texture(const Surface& surface) { return surface.image_data || has_pattern(surface.texture); }

  int add_texture(const Surface& surface) {
    const std::string png = surface.image_data ? *surface.image_data : pattern_png(surface);
    const auto [place, is_new] = textures_.try_emplace(png, static_cast<int>(out_.textures.size()));
    if (is_new) {
      tinygltf::Image image;
      image.name = surface.name;
      image.mimeType = png.starts_with("\xff\xd8") ? "image/jpeg" : "image/png";
      image.bufferView = add_view(png.data(), png.size(), 0);
      tinygltf::Texture texture;
      texture.source = static_cast<int>(out_.images.size());
      texture.sampler = 0;
      out_.images.push_back(std::move(image));
      out_.textures.push_back(std::move(texture));
    }
    return place->second;
  }

  int add_view(const void* data, std::size_t size, int target) {
    auto& bytes = out_.buffers[0].data;
    bytes.resize((bytes.size() + 3) / 4 * 4);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = bytes.size();
    view.byteLength = size;
    view.target = target;
    bytes.resize(bytes.size() + size);
    std::memcpy(bytes.data() + view.byteOffset, data, size);
    out_.bufferViews.push_back(std::move(view));
    return static_cast<int>(out_.bufferViews.size()) - 1;
  }

  template <class Element>
  int add_accessor(const std::vector<Element>& values, int component, int type, int target, bool with_bounds = false) {
    tinygltf::Accessor accessor;
    accessor.bufferView = add_view(values.data(), values.size() * sizeof(Element), target);
    accessor.componentType = component;
    accessor.type = type;
    accessor.count = values.size();
    if constexpr (requires { values[0][0]; }) {
      if (with_bounds) {
        for (std::size_t i = 0; i < values[0].size(); ++i) {
          const auto [least, greatest] = std::minmax_element(values.begin(), values.end(), [i](auto& a, auto& b) { return a[i] < b[i]; });
          accessor.minValues.push_back(double{(*least)[i]});
          accessor.maxValues.push_back(double{(*greatest)[i]});
        }
      }
    }
    out_.accessors.push_back(std::move(accessor));
    return static_cast<int>(out_.accessors.size()) - 1;
  }

  // Coordinates of one repeat of the surface's pattern.
  std::vector<Vec2f> texture_coordinates(const Mesh& mesh, const Surface& surface) const {
    const PatternSize size = surface.image_data ? PatternSize{} : pattern_size(surface.texture);
    const double scale = std::max(1e-4, double{surface.scale}), half = std::sqrt(0.5);
    std::vector<Vec2f> coordinates;
    coordinates.reserve(mesh.uvs.size());
    for (const Vec2f& uv : mesh.uvs) {
      const double u = size.turned ? half * (double{uv[0]} + double{uv[1]}) : double{uv[0]};
      const double v = size.turned ? half * (double{uv[1]} - double{uv[0]}) : double{uv[1]};
      const double across = u / (size.u * scale), up = v / (size.v * scale);  // glTF counts pictures from their top
      coordinates.push_back({static_cast<float>(across), static_cast<float>(surface.image_data ? 1 - up : up)});
    }
    return coordinates;
  }

  void add_primitive(tinygltf::Mesh& out, const Part& part, const Node& node) {
    const Mesh& mesh = part.mesh;
    const std::vector<std::uint32_t> indices = exported_triangles(mesh, node);
    if (indices.empty()) return;
    const Surface& surface = model_.surfaces.at(static_cast<std::size_t>(part.surface));
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = part.surface;
    std::vector<std::array<float, 3>> positions, normals;
    for (const Vec3f& p : mesh.positions) positions.push_back(gltf_from_room(p));
    for (const Vec3f& n : mesh.normals) {
      const float length = std::hypot(n[0], n[1], n[2]);
      normals.push_back(length > 0 ? gltf_from_room({n[0] / length, n[1] / length, n[2] / length}) : std::array<float, 3>{0, 1, 0});
    }
    constexpr int kVertices = TINYGLTF_TARGET_ARRAY_BUFFER;
    primitive.attributes["POSITION"] = add_accessor(positions, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, kVertices, true);
    primitive.attributes["NORMAL"] = add_accessor(normals, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, kVertices);
    if (has_texture(surface)) {
      primitive.attributes["TEXCOORD_0"] =
          add_accessor(texture_coordinates(mesh, surface), TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC2, kVertices);
    }
    constexpr int kIndices = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;
    if (mesh.positions.size() < 65535) {
      const std::vector<std::uint16_t> small(indices.begin(), indices.end());
      primitive.indices = add_accessor(small, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR, kIndices);
    } else {
      primitive.indices = add_accessor(indices, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, kIndices);
    }
    out.primitives.push_back(std::move(primitive));
  }

  // The number of the node's mesh; nodes with the same parts share one. −1 where it has none.
  int add_mesh(const Node& node) {
    std::string key;
    const auto append = [&](const auto& values) {
      key.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
      key += '|';
    };
    for (const Part& part : node.parts) {
      append(part.mesh.positions);
      append(part.mesh.indices);
      append(part.mesh.uvs);
      key += std::to_string(part.surface) + ";";
    }
    if (key.empty()) return -1;
    const auto [place, is_new] = meshes_.try_emplace(std::move(key), -1);
    if (!is_new) return place->second;
    tinygltf::Mesh mesh;
    mesh.name = node.id;
    for (const Part& part : node.parts) add_primitive(mesh, part, node);
    if (mesh.primitives.empty()) return -1;
    out_.meshes.push_back(std::move(mesh));
    return place->second = static_cast<int>(out_.meshes.size()) - 1;
  }

  int add_node(const Node& node) {
    const int number = static_cast<int>(out_.nodes.size());
    out_.nodes.emplace_back();
    const Vec3f at = gltf_from_room(node.position);
    const double half = radians_from_degrees(double{node.rotation_deg}) / 2;
    {
      tinygltf::Node& gltf = out_.nodes.back();
      gltf.name = node.id;
      gltf.mesh = add_mesh(node);
      gltf.translation = {double{at[0]}, double{at[1]}, double{at[2]}};
      if (half != 0) gltf.rotation = {0, std::sin(half), 0, std::cos(half)};
      gltf.extras = gltf_extras(node, layout_);
    }
    for (std::size_t i = 0; i < node.lights.size(); ++i) add_light(number, node, i);
    return number;
  }

  void add_light(int parent, const Node& node, std::size_t index) {
    const Light& light = node.lights[index];
    tinygltf::Light gltf;
    gltf.name = node.id + " light " + std::to_string(index + 1);
    gltf.type = "point";
    gltf.color = linear(light.color);
    gltf.intensity = double{light.watts} / (4 * kPi);
    tinygltf::Node holder;
    holder.name = gltf.name;
    const Vec3f at = gltf_from_room(light.position);
    holder.translation = {double{at[0]}, double{at[1]}, double{at[2]}};
    holder.extensions["KHR_lights_punctual"] = Value(Value::Object{{"light", Value(static_cast<int>(out_.lights.size()))}});
    out_.lights.push_back(std::move(gltf));
    out_.nodes[static_cast<std::size_t>(parent)].children.push_back(static_cast<int>(out_.nodes.size()));
    out_.nodes.push_back(std::move(holder));
  }

  const Model& model_;
  const Layout& layout_;
  tinygltf::Model out_;
  std::map<std::string, int> meshes_, textures_;
};

}  // namespace

Result<std::string> write_glb(const Model& model, const Layout& layout) {
  try {
    return GltfWriter(model, layout).write();
  } catch (const std::exception& error) {  // tinygltf and its JSON throw on text that is not UTF-8
    return fail(ErrorCode::kInternal, std::string("the glTF could not be written: ") + error.what());
  }
}

}  // namespace layoutbox
