// glTF and GLB by tinygltf.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>

#include "layoutbox/base/files.h"
#include "layoutbox/furnish/mesh_readers.h"

#include "layoutbox/furnish/gltf_parts.h"

namespace layoutbox {
namespace {

constexpr std::size_t kMostNodes = 50'000;

double srgb(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  return c <= 0.0031308 ? c * 12.92 : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

class GltfReader {
 public:
  explicit GltfReader(const AssetPlace& place) : place_(place) {}

  Result<MeshFile> read() {
    LAYOUTBOX_CHECK(load());
    for (const tinygltf::Material& material : file_.materials) add_surface(material);
    add_surface({});  // of what names none
    for (const Surface& surface : mesh_.surfaces) {
      if (surface.image_data) LAYOUTBOX_CHECK(check_image(*surface.image_data, surface.image));
    }
    const auto scene = static_cast<std::size_t>(std::max(0, file_.defaultScene));
    if (scene < file_.scenes.size()) {
      for (const int node : file_.scenes[scene].nodes) LAYOUTBOX_CHECK(add_node(node, kIdentity, 0));
    } else {
      for (int node = 0; node < static_cast<int>(file_.nodes.size()); ++node) LAYOUTBOX_CHECK(add_node(node, kIdentity, 0));
    }
    return std::move(mesh_);
  }

 private:
  Failure broken(std::string_view why, ErrorCode code = ErrorCode::kParse) const {
    return fail(code, fmt::format("\"{}\" cannot be read as glTF: {}", place_.name, why), place_.name);
  }

  Status load() {
    LAYOUTBOX_ASSIGN(const std::string bytes, read_file(place_.path, place_.limits.most_bytes));
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(&keep_image, nullptr);
    // What the file names is read by us: from its own folder only.
    tinygltf::FsCallbacks files{};
    files.FileExists = [](const std::string& path, void* self) { return static_cast<GltfReader*>(self)->path_of(path).has_value(); };
    files.ExpandFilePath = [](const std::string& path, void*) { return path; };
    files.ReadWholeFile = [](std::vector<unsigned char>* out, std::string* error, const std::string& path, void* self) {
      return static_cast<GltfReader*>(self)->read_named(*out, *error, path);
    };
    files.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; };
    files.user_data = this;
    loader.SetFsCallbacks(files);
    std::string error, warning;
    bool read = false;
    try {
      read = bytes.starts_with("glTF")
                 ? loader.LoadBinaryFromMemory(&file_, &error, &warning, reinterpret_cast<const unsigned char*>(bytes.data()),
                                               static_cast<unsigned>(bytes.size()), "")
                 : loader.LoadASCIIFromString(&file_, &error, &warning, bytes.data(), static_cast<unsigned>(bytes.size()), "");
    } catch (const std::exception& thrown) {
      error = thrown.what();
    }
    if (!named_.empty()) return broken(named_);
    if (!read) return broken(error.empty() ? "it is broken" : error.substr(0, error.find('\n')));
    return {};
  }

  std::optional<std::filesystem::path> path_of(const std::string& name) {
    const auto path = find_asset(place_.folders, name);
    if (!path && named_.empty()) named_ = path.error().message;
    return path ? std::optional(*path) : std::nullopt;
  }

  bool read_named(std::vector<unsigned char>& out, std::string& error, const std::string& name) {
    const auto path = path_of(name);
    // All that it names together, however often it names it.
    const auto bytes = path ? read_file(*path, place_.limits.most_bytes - named_bytes_) : Result<std::string>(fail(ErrorCode::kIo, named_));
    if (!bytes) {
      error = bytes.error().message;
      if (named_.empty()) named_ = error;
      return false;
    }
    named_bytes_ += bytes->size();
    out.assign(bytes->begin(), bytes->end());
    return true;
  }

  // Images stay as they are: PNG or JPEG.
  static bool keep_image(tinygltf::Image* image, const int, std::string*, std::string*, int, int, const unsigned char* bytes, int size,
                         void*) {
    image->image.assign(bytes, bytes + size);
    return true;
  }

  void add_surface(const tinygltf::Material& material) {
    Surface surface;
    surface.name = fmt::format("{}#{}", place_.name, material.name.empty() ? std::to_string(mesh_.surfaces.size()) : material.name);
    const auto& pbr = material.pbrMetallicRoughness;
    const auto& color = pbr.baseColorFactor;
    surface.base = color.size() == 4 ? Color{srgb(color[0]), srgb(color[1]), srgb(color[2])} : Color{0.8, 0.8, 0.8};
    if (color.size() == 4 && material.alphaMode == "BLEND") surface.alpha = static_cast<float>(color[3]);
    surface.second = surface.base;
    surface.roughness = static_cast<float>(pbr.roughnessFactor);
    surface.metallic = static_cast<float>(material.name.empty() && color.empty() ? 0.0 : pbr.metallicFactor);
    if (const auto& glow = material.emissiveFactor; glow.size() == 3 && std::max({glow[0], glow[1], glow[2]}) > 0.05) {
      surface.base = {srgb(glow[0]), srgb(glow[1]), srgb(glow[2])};
      surface.emission = 1;
    }
    const int texture = pbr.baseColorTexture.index;
    if (texture >= 0 && static_cast<std::size_t>(texture) < file_.textures.size()) {
      const int source = file_.textures[static_cast<std::size_t>(texture)].source;
      if (source >= 0 && static_cast<std::size_t>(source) < file_.images.size()) {
        const auto& bytes = file_.images[static_cast<std::size_t>(source)].image;
        auto data = std::make_shared<const std::string>(bytes.begin(), bytes.end());
        if (!image_kind(*data).empty()) {
          surface.image = fmt::format("{}#image{}", place_.name, source);
          surface.image_data = std::move(data);
        }
      }
    }
    mesh_.surfaces.push_back(std::move(surface));
  }

  Status add_node(int number, const Matrix& parent, int depth) {
    if (number < 0 || static_cast<std::size_t>(number) >= file_.nodes.size() || depth > 64) return broken("its nodes do not make a tree");
    // A small file can name the same node again and again.
    if (++visited_ > kMostNodes) return broken("it has too many nodes", ErrorCode::kTooLarge);
    const tinygltf::Node& node = file_.nodes[static_cast<std::size_t>(number)];
    const Matrix matrix = times(parent, matrix_of(node));
    if (node.mesh >= 0 && static_cast<std::size_t>(node.mesh) < file_.meshes.size()) {
      for (const tinygltf::Primitive& primitive : file_.meshes[static_cast<std::size_t>(node.mesh)].primitives) {
        LAYOUTBOX_CHECK(add_primitive(primitive, matrix));
      }
    }
    for (const int child : node.children) LAYOUTBOX_CHECK(add_node(child, matrix, depth + 1));
    return {};
  }

  Status add_primitive(const tinygltf::Primitive& primitive, const Matrix& m) {
    if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != -1) return {};  // points and lines are no body
    const auto attribute = [&](const char* name) {
      const auto found = primitive.attributes.find(name);
      return found == primitive.attributes.end() ? -1 : found->second;
    };
    if (primitive.extensions.contains("KHR_draco_mesh_compression")) return broken("it is compressed with Draco; export it without");
    if (attribute("POSITION") < 0) return {};
    // A corner of its own for each triangle of the most that are read, and then some that none uses.
    const std::size_t most = 4 * place_.limits.most_triangles;
    const auto numbers = [&](int accessor, std::size_t width) -> Result<std::vector<double>> {
      auto read = accessor_numbers(file_, accessor, width, most);
      return read ? std::move(read) : Result<std::vector<double>>(broken(read.error().message, read.error().code));
    };
    LAYOUTBOX_ASSIGN(const std::vector<double> points, numbers(attribute("POSITION"), 3));
    std::vector<double> normals, uvs;
    if (attribute("NORMAL") >= 0) {
      LAYOUTBOX_ASSIGN(normals, numbers(attribute("NORMAL"), 3));
    }
    if (attribute("TEXCOORD_0") >= 0) {
      LAYOUTBOX_ASSIGN(uvs, numbers(attribute("TEXCOORD_0"), 2));
    }
    Part part;
    const std::size_t count = points.size() / 3;
    if (primitive.indices >= 0) {
      LAYOUTBOX_ASSIGN(const std::vector<double> indices, numbers(primitive.indices, 1));
      for (const double index : indices) {
        if (index >= static_cast<double>(count)) return broken("a triangle names a vertex that is not there");
        part.mesh.indices.push_back(static_cast<std::uint32_t>(index));
      }
    } else {
      for (std::size_t i = 0; i < count; ++i) part.mesh.indices.push_back(static_cast<std::uint32_t>(i));
    }
    part.mesh.indices.resize(part.mesh.indices.size() / 3 * 3);
    triangles_ += part.mesh.indices.size() / 3;
    if (triangles_ > place_.limits.most_triangles) return too_many_triangles(place_);
    for (std::size_t i = 0; i < count; ++i) {
      const double* p = &points[3 * i];
      const auto at = [&](std::size_t r) { return m[r] * p[0] + m[4 + r] * p[1] + m[8 + r] * p[2] + m[12 + r]; };
      part.mesh.positions.push_back(ours(at(0), at(1), at(2)));
      const bool has_normal = normals.size() >= 3 * (i + 1);
      const double* n = has_normal ? &normals[3 * i] : p;
      const auto way = [&](std::size_t r) { return m[r] * n[0] + m[4 + r] * n[1] + m[8 + r] * n[2]; };
      part.mesh.normals.push_back(has_normal ? ours(way(0), way(1), way(2)) : Vec3f{0, 0, 0});
      part.mesh.uvs.push_back(uvs.size() >= 2 * (i + 1) ? Vec2f{static_cast<float>(uvs[2 * i]), static_cast<float>(1 - uvs[2 * i + 1])}
                                                        : Vec2f{0, 0});
      if (!std::isfinite(part.mesh.positions.back()[0] + part.mesh.positions.back()[1] + part.mesh.positions.back()[2])) {
        return broken("a vertex is nowhere");
      }
    }
    complete_normals(part.mesh);
    const int material = primitive.material;
    const auto last = static_cast<int>(mesh_.surfaces.size()) - 1;
    part.surface = material >= 0 && material < last ? material : last;
    mesh_.parts.push_back(std::move(part));
    return {};
  }

  static Vec3f ours(double x, double y, double z) { return {static_cast<float>(x), static_cast<float>(-z), static_cast<float>(y)}; }

  // Vertices without a normal get that of their triangles.
  static void complete_normals(Mesh& mesh) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      const auto at = [&](std::size_t k) {
        const Vec3f& p = mesh.positions[mesh.indices[i + k]];
        return kit::Vec{double{p[0]}, double{p[1]}, double{p[2]}};
      };
      const kit::Vec face = kit::cross(at(1) - at(0), at(2) - at(0));
      for (std::size_t k = 0; k < 3; ++k) {
        Vec3f& n = mesh.normals[mesh.indices[i + k]];
        const double length = std::hypot(double{n[0]}, double{n[1]}, double{n[2]});
        if (length < 1e-6) n = {static_cast<float>(face.x), static_cast<float>(face.y), static_cast<float>(face.z)};
      }
    }
    for (Vec3f& n : mesh.normals) {
      const kit::Vec u = kit::unit({double{n[0]}, double{n[1]}, double{n[2]}});
      n = {static_cast<float>(u.x), static_cast<float>(u.y), static_cast<float>(u.z)};
    }
  }

  const AssetPlace& place_;
  tinygltf::Model file_;
  MeshFile mesh_;
  std::string named_;  // what is wrong with a file that this one names
  std::size_t named_bytes_ = 0, visited_ = 0, triangles_ = 0;
};

}  // namespace

Result<MeshFile> read_gltf(const AssetPlace& place) { return GltfReader(place).read(); }

}  // namespace layoutbox
