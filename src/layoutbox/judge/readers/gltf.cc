// glTF and GLB with named nodes: an object a node, its box from the bounds that every accessor of positions states. No buffer is read.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "layoutbox/furnish/gltf_parts.h"
#include "layoutbox/judge/readers/found_room.h"
#include "layoutbox/judge/readers/readers.h"
#include "layoutbox/scene/json_text.h"

namespace layoutbox::readers {
namespace {

using nlohmann::json;
using MeshPoint = std::array<double, 3>;

constexpr int kDeepest = 64;
constexpr std::size_t kMostNodes = 50'000;
constexpr double kThin = 1e-3, kSameFloor = 0.01;  // m

// The JSON of a GLB is its first chunk.
std::string_view json_of_gltf(std::string_view bytes) {
  if (!bytes.starts_with("glTF")) return bytes;
  if (bytes.size() < 20) return {};
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + 12, sizeof length);
  return length <= bytes.size() - 20 ? bytes.substr(20, length) : std::string_view{};
}

struct Bounds {
  MeshPoint low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
  bool empty() const { return low[0] > high[0]; }
  void add(const MeshPoint& point) {
    for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], point[i]), high[i] = std::max(high[i], point[i]);
  }
};

enum class NodeRole { kNothing, kObject, kFloor, kWall, kCeiling, kDoor, kWindow };

class NodeReader {
 public:
  explicit NodeReader(const json& file) : file_(file) {}

  Status read(FoundRoom& room) {
    std::vector<std::size_t> roots = roots_of();
    // Groups without a mesh that only hold the rest: "Scene", "Sketchfab_model"…
    while (roots.size() == 1 && !node(roots[0]).contains("mesh") && !children(roots[0]).empty()) {
      outer_ = times(outer_, matrix(roots[0]));
      roots = children(roots[0]);
      if (++steps_ > kDeepest) return fail(ErrorCode::kParse, "the nodes do not make a tree");
    }
    for (const std::size_t root : roots) {
      if (visited_ > kMostNodes) return fail(ErrorCode::kTooLarge, "there are too many nodes");
      add(root, room);
    }
    if (room.polygon.empty()) take_bounds_as_floor(room);
    if (room.height <= 0 && !walls_.empty()) room.height = walls_.high[2];
    return {};
  }

 private:
  const json& node(std::size_t i) const {
    static const json none = json::object();
    const auto nodes = file_.find("nodes");
    return nodes != file_.end() && nodes->is_array() && i < nodes->size() && (*nodes)[i].is_object() ? (*nodes)[i] : none;
  }

  static std::vector<std::size_t> places(const json& list) {
    std::vector<std::size_t> result;
    for (const json& item : list) {
      if (item.is_number_unsigned()) result.push_back(item.get<std::size_t>());
    }
    return result;
  }
  std::vector<std::size_t> children(std::size_t i) const {
    const auto found = node(i).find("children");
    return found == node(i).end() ? std::vector<std::size_t>{} : places(*found);
  }

  std::vector<std::size_t> roots_of() const {
    const auto scenes = file_.find("scenes");
    const std::size_t scene = file_.value("scene", std::size_t{0});
    if (scenes != file_.end() && scenes->is_array() && scene < scenes->size() && (*scenes)[scene].contains("nodes")) {
      return places((*scenes)[scene].at("nodes"));
    }
    std::vector<std::size_t> all;
    for (std::size_t i = 0; file_.contains("nodes") && i < file_.at("nodes").size(); ++i) all.push_back(i);
    return all;
  }

  Matrix matrix(std::size_t i) const {
    tinygltf::Node parts;
    const auto fill = [&](const char* key, std::vector<double>& out, std::size_t count) {
      const auto found = node(i).find(key);
      if (found == node(i).end() || !found->is_array() || found->size() != count) return;
      for (const json& value : *found) out.push_back(number(value).value_or(0));
    };
    fill("matrix", parts.matrix, 16);
    fill("translation", parts.translation, 3);
    fill("rotation", parts.rotation, 4);
    fill("scale", parts.scale, 3);
    return matrix_of(parts);
  }

  // Bounds of a mesh's positions as its accessors state them, in its own frame.
  Bounds mesh_bounds(std::size_t mesh) const {
    Bounds bounds;
    const auto meshes = file_.find("meshes");
    if (meshes == file_.end() || mesh >= meshes->size()) return bounds;
    for (const json& primitive : (*meshes)[mesh].value("primitives", json::array())) {
      const auto attributes = primitive.find("attributes");
      if (attributes == primitive.end() || !attributes->contains("POSITION")) continue;
      const std::size_t accessor = attributes->at("POSITION").get<std::size_t>();
      const json& list = file_.at("accessors");
      if (accessor >= list.size()) continue;
      for (const char* key : {"min", "max"}) {
        const auto corner = list[accessor].contains(key) ? point_of(list[accessor].at(key)) : std::nullopt;
        if (corner) bounds.add(*corner);
      }
    }
    return bounds;
  }

  // Adds the corners of all meshes under a node, in the room's frame (z up) turned back by `turn` about z.
  void gather(std::size_t i, const Matrix& parent, double turn, int depth, Bounds& out) {
    if (depth > kDeepest || ++visited_ > kMostNodes) return;
    const Matrix m = times(parent, matrix(i));
    if (node(i).contains("mesh") && node(i).at("mesh").is_number_unsigned()) {
      const Bounds own = mesh_bounds(node(i).at("mesh").get<std::size_t>());
      for (int corner = 0; corner < 8 && !own.empty(); ++corner) {
        const MeshPoint p{corner & 1 ? own.high[0] : own.low[0], corner & 2 ? own.high[1] : own.low[1],
                          corner & 4 ? own.high[2] : own.low[2]};
        const auto at = [&](std::size_t row) { return m[row] * p[0] + m[4 + row] * p[1] + m[8 + row] * p[2] + m[12 + row]; };
        const double x = at(0), y = -at(2);
        out.add({x * std::cos(turn) + y * std::sin(turn), y * std::cos(turn) - x * std::sin(turn), at(1)});
      }
    }
    for (const std::size_t child : children(i)) gather(child, m, turn, depth + 1, out);
  }

  // "wall back"; a wall lamp is none.
  static bool is_a_side_of_walls(std::string_view words) {
    constexpr std::array<std::string_view, 12> kSides{"back", "front", "left", "right", "north", "south",
                                                      "east", "west",  "rear", "a",     "b",     "c"};
    return words.starts_with("wall ") && std::ranges::find(kSides, words.substr(5)) != kSides.end();
  }

  NodeRole role_of(const json& item, const std::string& words) const {
    const auto extras = item.find("extras");
    const std::string kind = extras == item.end() ? "" : text_of(*extras, "kind");
    const auto ends = [&](std::string_view end) { return words == end || words.ends_with(" " + std::string(end)); };
    if (kind == "object") return NodeRole::kObject;
    if (kind == "floor" || words == "floor" || words == "ground") return NodeRole::kFloor;
    if (kind == "wall" || ends("wall") || words == "walls" || is_a_side_of_walls(words)) return NodeRole::kWall;
    if (kind == "ceiling" || words == "ceiling" || words == "roof") return NodeRole::kCeiling;
    if (kind == "base" || kind == "mark") return NodeRole::kNothing;
    if (ends("window") || (kind == "opening" && words.find("window") != std::string::npos)) return NodeRole::kWindow;
    if (kind == "opening" || ends("door") || ends("doorway")) return NodeRole::kDoor;
    return NodeRole::kObject;
  }

  void add(std::size_t i, FoundRoom& room) {
    const json& item = node(i);
    const std::string name = text_of(item, "name"), words = words_in(name);
    const NodeRole role = role_of(item, words);
    const Matrix m = times(outer_, matrix(i));
    // +z of the node is its front; a door's or window's x runs along its wall.
    const double front_x = m[8], front_y = -m[10];
    const bool has_frame = role == NodeRole::kObject || role == NodeRole::kDoor || role == NodeRole::kWindow;
    const double turn = has_frame && std::hypot(front_x, front_y) > 1e-9 ? std::atan2(front_x, -front_y) : 0;
    Bounds bounds;
    gather(i, outer_, turn, 0, bounds);
    if (bounds.empty()) return;  // a camera, a lamp's light, a helper
    switch (role) {
      case NodeRole::kNothing: break;
      case NodeRole::kFloor: add_floor(item, m, bounds, room); break;
      case NodeRole::kWall: walls_.add(bounds.low), walls_.add(bounds.high); break;
      case NodeRole::kCeiling: room.height = bounds.low[2]; break;
      case NodeRole::kDoor: add_opening(item, name, OpeningType::kDoor, m, turn, bounds, room); break;
      case NodeRole::kWindow: add_opening(item, name, OpeningType::kWindow, m, turn, bounds, room); break;
      default: add_object(item, name, turn, bounds, room);
    }
  }

  // The box of the floor, or the corners that our own files state in its frame, unless the mesh was cut or grown since.
  static void add_floor(const json& item, const Matrix& m, const Bounds& bounds, FoundRoom& room) {
    if (!room.polygon.empty()) return;
    room.polygon = {
        {bounds.low[0], bounds.low[1]}, {bounds.high[0], bounds.low[1]}, {bounds.high[0], bounds.high[1]}, {bounds.low[0], bounds.high[1]}};
    const auto extras = item.find("extras");
    if (extras == item.end() || !extras->is_object()) return;
    Bounds stated;
    std::vector<std::array<double, 2>> corners;
    for (const json& corner : extras->value("polygon", json::array())) {
      const bool pair = corner.is_array() && corner.size() == 2;
      const auto x = pair ? number(corner[0]) : std::nullopt, y = pair ? number(corner[1]) : std::nullopt;
      if (!x || !y) return;
      corners.push_back({m[0] * *x - m[8] * *y + m[12], -m[2] * *x + m[10] * *y - m[14]});
      stated.add({corners.back()[0], corners.back()[1], 0});
    }
    const auto same = [](double a, double b) { return std::abs(a - b) < kSameFloor; };
    if (corners.size() >= 3 && same(stated.low[0], bounds.low[0]) && same(stated.low[1], bounds.low[1]) &&
        same(stated.high[0], bounds.high[0]) && same(stated.high[1], bounds.high[1])) {
      room.polygon = std::move(corners);
    }
  }

  // Where the node's origin is within its box, that is the wall's face: a leaf that stands open reaches into the room, casings reach past
  // the hole. Our own nodes say the hole itself, from the origin along x.
  static void add_opening(const json& item, const std::string& name, OpeningType type, const Matrix& m, double turn, const Bounds& bounds,
                          FoundRoom& room) {
    FoundOpening opening{name, type, {}, {}, bounds.low[2], bounds.high[2], Swing::kNone};
    const double cs = std::cos(turn), sn = std::sin(turn);
    const std::array<double, 2> origin{m[12] * cs - m[14] * sn, -m[14] * cs - m[12] * sn};
    const bool along_x = bounds.high[0] - bounds.low[0] >= bounds.high[1] - bounds.low[1];
    const std::size_t along = along_x ? 0 : 1, across = 1 - along;
    double from = bounds.low[along], to = bounds.high[along];
    double at = (bounds.low[across] + bounds.high[across]) / 2;
    if (origin[across] >= bounds.low[across] && origin[across] <= bounds.high[across]) at = origin[across];
    if (const auto extras = item.find("extras"); extras != item.end() && extras->is_object()) {
      opening.type = opening_type_from_name(text_of(*extras, "category")).value_or(type);
      opening.swing = swing_from_name(text_of(*extras, "swing")).value_or(Swing::kNone);
      if (const auto size = extras->find("size"); size != extras->end() && along_x) {
        const auto hole = point_of(*size);  // width, height, sill
        if (hole) from = origin[0], to = from + (*hole)[0], opening.low = (*hole)[2], opening.high = (*hole)[1] + (*hole)[2];
      }
    }
    const auto in_room = [&](double p) {
      const double x = along_x ? p : at, y = along_x ? at : p;
      return std::array{x * cs - y * sn, x * sn + y * cs};
    };
    opening.start = in_room(from);
    opening.end = in_room(to);
    room.openings.push_back(opening);
  }

  static void add_object(const json& item, const std::string& name, double turn, const Bounds& bounds, FoundRoom& room) {
    FoundObject object;
    object.id = name;
    object.name = name;
    std::array<double, 2> middle{(bounds.low[0] + bounds.high[0]) / 2, (bounds.low[1] + bounds.high[1]) / 2};
    for (std::size_t k = 0; k < 3; ++k) object.size[k] = std::max(kThin, bounds.high[k] - bounds.low[k]);
    object.position = {middle[0] * std::cos(turn) - middle[1] * std::sin(turn), middle[0] * std::sin(turn) + middle[1] * std::cos(turn),
                       bounds.low[2]};
    object.rotation_deg = turn * 180 / kPi;
    if (const auto extras = item.find("extras"); extras != item.end()) {
      if (const std::string category = text_of(*extras, "category"); !category.empty()) object.name = category;
      object.supported_by = text_of(*extras, "supportedBy");
      if (const auto size = extras->find("size"); size != extras->end()) object.size = point_of(*size).value_or(object.size);
    }
    room.objects.push_back(std::move(object));
  }

  void take_bounds_as_floor(FoundRoom& room) const {
    Bounds all = walls_;
    for (const FoundObject& object : room.objects) {
      if (!walls_.empty()) break;
      const double reach = std::hypot(object.size[0], object.size[1]) / 2;
      all.add({object.position[0] - reach, object.position[1] - reach, 0});
      all.add({object.position[0] + reach, object.position[1] + reach, 0});
    }
    if (all.empty()) return;
    add_floor({}, outer_, all, room);
    room.notes.push_back({"guessed", "no node is a floor: the room is the box round everything", {}});
  }

  const json& file_;
  Matrix outer_ = kIdentity;
  Bounds walls_;
  std::size_t visited_ = 0;
  int steps_ = 0;
};

}  // namespace

bool is_gltf(std::string_view bytes) {
  if (bytes.starts_with("glTF")) return true;
  const auto document = parse_json(bytes);
  return document && document->is_object() && document->contains("asset") && document->contains("nodes");
}

Result<RoomFile> read_named_nodes(std::string_view bytes, const Catalog& catalog, const json&) {
  LAYOUTBOX_ASSIGN(const json document, parse_json(json_of_gltf(bytes)));
  FoundRoom room;
  NodeReader reader(document);
  LAYOUTBOX_CHECK(reader.read(room));
  room.notes.push_back({"guessed", "a node's front is its +z; its box is that of its meshes' bounds", {}});
  return settle(std::move(room), catalog, "gltf");
}

}  // namespace layoutbox::readers
