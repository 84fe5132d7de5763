// The script: tables that a person can read and change, then blender/*.py, then the meshes.
#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <span>

#include "layoutbox/embedded/blender_scripts.h"
#include "layoutbox/render/mesh_block.h"
#include "layoutbox/render/render.h"
#include "layoutbox/render/slope_wall.h"
#include "layoutbox/scene/relation_table.h"

namespace layoutbox {
namespace {

// A Python string literal. JSON's escapes are Python's too as long as nothing but ASCII control characters is escaped.
std::string literal(std::string_view text) { return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace); }

// Metres, degrees and colours with as many digits as they need, and always readable as a float.
std::string number(double value, int digits = 5) {
  std::string text = fmt::format("{:.{}f}", value, digits);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text += '0';
  return text == "-0.0" ? "0.0" : text;
}

template <class T, std::size_t N>
std::string tuple(const std::array<T, N>& values, int digits = 5) {
  std::string text = "(";
  for (std::size_t i = 0; i < N; ++i) text += (i == 0 ? "" : ", ") + number(static_cast<double>(values[i]), digits);
  return text + ")";
}

std::string point(const Point& p) { return fmt::format("({}, {})", number(m_from_mm(p.x)), number(m_from_mm(p.y))); }

std::string color(const Color& c) { return tuple(std::array<double, 3>{c.r, c.g, c.b}, 4); }

std::string_view python(bool value) { return value ? "True" : "False"; }

std::string_view quality_name(Quality quality) {
  switch (quality) {
    case Quality::kDraft: return "draft";
    case Quality::kPreview: return "preview";
    case Quality::kFinal: return "final";
  }
  return "preview";
}

std::string_view kind_name(NodeKind kind) {
  switch (kind) {
    case NodeKind::kFloor: return "floor";
    case NodeKind::kWall: return "wall";
    case NodeKind::kCeiling: return "ceiling";
    case NodeKind::kOpening: return "opening";
    case NodeKind::kObject: return "object";
  }
  return "object";
}

// The prompt as comment lines: whatever it holds, it cannot become code.
std::string as_comment(std::string_view text) {
  std::string out = "#   ";
  std::size_t column = 4;
  for (const char c : text) {
    const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    if ((control || c == ' ') && column > 120) {
      out += "\n#   ";
      column = 4;
    } else {
      out += control ? ' ' : c;
      ++column;
    }
  }
  return out + "\n";
}

std::string head(const Layout& layout) {
  std::string text =
      "# A furnished room for Blender 3.4 to 5.x.\n"
      "#\n"
      "#   blender -b --python blender.py              scene.png and scene.blend beside this file\n"
      "#   blender -b --python blender.py -- FOLDER    into FOLDER\n"
      "#   python3 blender.py FOLDER                   a Python with the module bpy\n"
      "#\n"
      "# More words after FOLDER: --mask (an object mask and what is visible of each object), --no-picture, --no-blend,\n"
      "# --engine=workbench (quick and flat, needs GL). Change the tables below as you like; the code and the meshes follow them.\n"
      "# Frame: metres and degrees, x to the right, y away from the viewer, z up; the origin is the floor's front left corner.\n";
  if (!layout.prompt.empty()) text += "#\n# The room was made from these words:\n" + as_comment(layout.prompt);
  return text + "\n";
}

std::string settings(const Layout& layout, const Catalog& catalog, const RenderOptions& options) {
  std::string views;
  for (const View view : options.views) views += fmt::format("\"{}\", ", name_of(view));
  return fmt::format(
      "OUTPUT = {{\"picture\": \"scene.png\", \"blend\": {}, \"mask\": \"mask.png\", \"mask_index\": \"mask.json\",\n"
      "          \"overlay\": \"scene-overlay.png\", \"thumbnail\": \"scene-small.jpg\", \"turntable\": \"scene-turntable\"}}\n\n"
      "# A picture each: iso (scene.png), top, front, eye (in the room), door (scene-top.png and so on).\n"
      "VIEWS = ({})\n\n"
      "# The camera of iso. Azimuth 0 looks from the front, 90 from the right. Walls that would stand before the room are cut away.\n"
      "CAMERA = {{\"azimuth\": {}, \"elevation\": {}, \"orthographic\": {}, \"lens_angle\": 35.0,\n"
      "          \"width\": {}, \"height\": {}, \"margin\": 0.04{}}}\n\n"
      "# draft, preview or final; samples of Cycles with OpenImageDenoise, and where this Blender has none.\n"
      "QUALITY = \"{}\"\n"
      "SAMPLES = {{\"draft\": {{\"denoised\": 3, \"filtered\": 6}}, \"preview\": {{\"denoised\": 10, \"filtered\": 20}},\n"
      "           \"final\": {{\"denoised\": 96, \"filtered\": 128}}}}\n\n",
      options.save_blend ? "\"scene.blend\"" : "\"\"", views, number(azimuth_from(layout, catalog, options)), number(options.elevation_deg),
      python(options.orthographic), options.width, options.height, options.all_walls ? ", \"all_walls\": True" : "",
      quality_name(options.quality));
}

std::string room_tables(const Layout& layout) {
  const Room& room = layout.room;
  std::string text = "ROOM = {\"polygon\": [";
  for (std::size_t i = 0; i < room.polygon.size(); ++i) text += (i == 0 ? "" : ", ") + point(room.polygon[i]);
  text += fmt::format("], \"height\": {}}}\n\nWALLS = [\n", number(m_from_mm(room.height)));
  for (const Wall& wall : room.walls) {
    text += fmt::format("    {{\"id\": {}, \"start\": {}, \"end\": {}, \"thickness\": {}}},\n", literal(wall.id), point(wall.start),
                        point(wall.end), number(m_from_mm(wall.thickness)));
  }
  text += "]\n\nOPENINGS = [\n";
  for (const Opening& opening : room.openings) {
    text += fmt::format(
        "    {{\"id\": {}, \"type\": \"{}\", \"wall\": {}, \"offset\": {}, \"w\": {}, \"h\": {}, \"sill\": {}, \"swing\": \"{}\"}},\n",
        literal(opening.id), name_of(opening.type), literal(opening.wall), number(m_from_mm(opening.offset.value_or(0))),
        number(m_from_mm(opening.width)), number(m_from_mm(opening.height)), number(m_from_mm(opening.sill)), name_of(opening.swing));
  }
  return text + "]\n\n";
}

// What does not hold, for the overlay.
std::string failed_table(const Layout& layout) {
  std::string text = "# What was asked and does not hold.\nFAILED = [\n";
  for (const PlacedRelation& placed : layout.relations) {
    if (placed.held) continue;
    const Relation& relation = placed.relation;
    std::string ids;
    for (const auto* names : {&relation.targets, &relation.references}) {
      for (const std::string& id : *names) ids += literal(id) + ", ";
    }
    const bool brief = !relation.why.empty() && relation.why.size() <= 32;
    const std::string words = brief ? relation.why : std::string(relation_row(relation.type).name);
    text += fmt::format("    {{\"targets\": [{}], \"words\": {}}},\n", ids, literal(words));
  }
  return text + "]\n\n";
}

// The images of surfaces, as text.
std::string images_table(const Model& model) {
  std::string text = "# Image files that materials name: base64.\nIMAGES = {\n";
  std::set<std::string> done;
  for (const Surface& s : model.surfaces) {
    if (!s.image_data || !done.insert(s.image).second) continue;
    text += fmt::format("    {}: \"\"\"\n{}\"\"\",\n", literal(s.image), base64_lines(*s.image_data));
  }
  return text + "}\n\n";
}

std::string materials_table(const Model& model) {
  std::string text =
      "# Colours are sRGB, 0 to 1. texture: a procedure of PAINTERS below, in color and second, at `scale` metres; or \"\".\n"
      "MATERIALS = {\n";
  for (const Surface& s : model.surfaces) {
    text += fmt::format(
        "    {}: {{\"color\": {}, \"roughness\": {}, \"metallic\": {}, \"alpha\": {}, \"emission\": {},\n"
        "        \"texture\": {}, \"second\": {}, \"scale\": {}, \"image\": {}}},\n",
        literal(s.name), color(s.base), number(double{s.roughness}, 3), number(double{s.metallic}, 3), number(double{s.alpha}, 3),
        number(double{s.emission}, 3), literal(s.texture), color(s.second), number(std::max(1e-4, double{s.scale})), literal(s.image));
  }
  return text + "}\n\n";
}

// "bed" → "Bed": the collection that an object is put into.
std::string collection_name(const Node& node) {
  if (node.kind == NodeKind::kWall || node.kind == NodeKind::kOpening) return "Walls";
  if (node.kind != NodeKind::kObject) return "Room";
  std::string name = node.category.empty() ? "object" : node.category;
  for (char& c : name) {
    if (c == '_') c = ' ';
  }
  if (name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

// The wall that something hangs on, directly or by a window of it, or empty.
std::string hangs_on(const Layout& layout, std::string_view support) {
  if (layout.find_wall(support) != nullptr) return layout.find_wall(support)->id;
  if (const Opening* opening = layout.find_opening(support)) return opening->wall;
  return {};
}

// Asked for, or it follows from what was: not ours.
bool is_spoken_of(const PlacedObject* object) {
  return object == nullptr || object->origin == Origin::kAsked || object->origin == Origin::kConcluded;
}

Size3f box_of(const Node& node, const Layout& layout) {
  if (const PlacedObject* object = layout.find_object(node.id)) {
    return {m_from_mm(object->size.width), m_from_mm(object->size.depth), m_from_mm(object->size.height)};
  }
  return bounds_of(node);
}

std::string row(const Node& node, const Layout& layout, const Catalog& catalog, const Model& model, std::span<const int> meshes) {
  const PlacedObject* object = node.kind == NodeKind::kObject ? layout.find_object(node.id) : nullptr;
  const std::string support = object != nullptr ? object->supported_by : "";
  std::string uses;
  if (object != nullptr) {
    for (const Side side : object->used_sides) uses += fmt::format("{}\"{}\"", uses.empty() ? "" : ", ", name_of(side));
  }
  const Wall* slope = object == nullptr ? nullptr : wall_of_slope(layout, *object, catalog);  // it goes with its wall
  const std::string wall = node.kind == NodeKind::kWall ? node.id : node.kind == NodeKind::kObject ? "" : node.parent;
  std::string text = fmt::format(
      "    {{\"id\": {}, \"category\": {}, \"name\": {}, \"kind\": \"{}\", \"collection\": {},\n"
      "     \"at\": {}, \"turn\": {}, \"size\": {}, \"stands_on\": {}, \"wall\": {}, \"hangs_on\": {}, \"asked\": {}, \"uses\": [{}],\n    "
      " \"parts\": [",
      literal(node.id), literal(node.category), literal(node.name), kind_name(node.kind), literal(collection_name(node)),
      tuple(node.position), number(double{node.rotation_deg}), tuple(box_of(node, layout)), literal(support), literal(wall),
      literal(slope != nullptr ? slope->id : hangs_on(layout, support)), is_spoken_of(object) && slope == nullptr ? "True" : "False", uses);
  for (std::size_t i = 0; i < node.parts.size(); ++i) {
    const auto surface = static_cast<std::size_t>(node.parts[i].surface);
    text += fmt::format("{}({}, {})", i == 0 ? "" : ", ", literal(model.surfaces.at(surface).name), meshes[i]);
  }
  text += "], \"lights\": [";
  for (std::size_t i = 0; i < node.lights.size(); ++i) {
    const Light& light = node.lights[i];
    text += fmt::format("{}{{\"at\": {}, \"color\": {}, \"watts\": {}, \"radius\": {}}}", i == 0 ? "" : ", ", tuple(light.position),
                        color(light.color), number(double{light.watts}, 2), number(double{light.radius}, 3));
  }
  return text + "]},\n";
}

}  // namespace

std::string write_blender_script(const Model& model, const Layout& layout, const Catalog& catalog, const RenderOptions& options) {
  MeshBlock block;
  std::string shell =
      "# Floor, walls, ceiling, doors and windows; parts are (material, number of the mesh at the end of the file).\nSHELL = [\n";
  std::string objects =
      "# The furniture: where it stands (centre of the footprint, height of the underside), turned about z.\nOBJECTS = [\n";
  for (const Node& node : model.nodes) {
    std::vector<int> meshes;
    for (const Part& part : node.parts) meshes.push_back(block.add(part.mesh));
    (node.kind == NodeKind::kObject ? objects : shell) += row(node, layout, catalog, model, meshes);
  }
  std::string script = head(layout) + settings(layout, catalog, options);
  script += embedded::light_py;
  if (model.daylight < 1)
    script += fmt::format("for part in (\"sun\", \"sky\", \"beams\"):\n    LIGHT[part] *= {0}\nLIGHT[\"lamps\"] /= {0} * {0}\n",
                          number(model.daylight));
  script += "\n";
  script += room_tables(layout) + objects + "]\n\n" + failed_table(layout) + images_table(model) + materials_table(model) + shell + "]\n\n";
  for (const std::string_view code :
       {embedded::geometry_py, embedded::nodes_py, embedded::materials_py, embedded::scene_py, embedded::render_py, embedded::visibility_py,
        embedded::overlay_py, embedded::turntable_py, embedded::main_py}) {
    script += "\n";
    script += code;
  }
  script +=
      "\n\n# ---- The meshes: zlib, base64. Each: vertices, indices; positions (10 µm), normals (1/32767), uvs (0.1 mm), indices. ----\n";
  script += "MESHES = \"\"\"\n" + block.text() + "\"\"\"\n\nif __name__ == \"__main__\":\n    main()\n    leave()\n";
  return script;
}

}  // namespace layoutbox
