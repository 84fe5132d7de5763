// Layouts, and scenes whose objects have positions: a model's own, or the paper's `xform`.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "layoutbox/catalog/normalize.h"
#include "layoutbox/judge/readers/found_room.h"
#include "layoutbox/judge/readers/readers.h"
#include "layoutbox/scene/json_text.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox::readers {

bool is_layout(std::string_view bytes) { return kind_of_document(bytes).value_or("") == "layout"; }
bool is_scene(std::string_view bytes) { return kind_of_document(bytes).value_or("") == "scene"; }

Result<RoomFile> read_own_layout(std::string_view bytes, const Catalog&, const nlohmann::json&) {
  LAYOUTBOX_ASSIGN(Layout layout, read_layout(bytes));
  return RoomFile{{}, "layout", std::move(layout), {}};
}

Result<RoomFile> read_positions(std::string_view bytes, const Catalog& catalog, const nlohmann::json&) {
  LAYOUTBOX_ASSIGN(SceneGraph scene, read_scene(bytes));
  NormalizeOptions options;
  options.default_openings = false;
  LAYOUTBOX_ASSIGN(scene, normalize_scene(std::move(scene), catalog, options));
  FoundRoom found;
  found.name = scene.name;
  found.type = scene.room.type;
  found.prompt = scene.prompt;
  for (const layoutbox::Point& corner : scene.room.polygon) found.polygon.push_back({m_from_mm(corner.x), m_from_mm(corner.y)});
  found.height = m_from_mm(scene.room.height);
  for (const SceneObject& object : scene.objects) {
    if (!object.hint.position) {
      found.notes.push_back({"ignored", fmt::format("{} has no position", object.id), {}});
      continue;
    }
    const Size size = object.size ? object.size->usual : Size{};
    const std::array<double, 3>& at = *object.hint.position;
    found.objects.push_back({object.id,
                             object.name.empty() ? object.category : object.name,
                             {m_from_mm(size.width), m_from_mm(size.depth), m_from_mm(size.height)},
                             {m_from_mm(at[0]), m_from_mm(at[1]), m_from_mm(at[2])},
                             object.hint.rotation_deg.value_or(0),
                             {}});
  }
  std::vector<Opening> openings = scene.room.openings;
  LAYOUTBOX_ASSIGN(RoomFile file, settle(std::move(found), catalog, "scene"));
  // The scene's own walls and openings, with their names; what chooses its place stays away.
  file.layout.room.walls = scene.room.walls;
  file.layout.room.polygon = scene.room.polygon;
  std::erase_if(openings, [](const Opening& opening) { return opening.wall.empty() || !opening.offset; });
  file.layout.room.openings = std::move(openings);
  for (const Relation& relation : scene.relations) {
    if (relation.asked()) file.layout.relations.push_back({relation, true});
  }
  for (Note& note : scene.notes) file.notes.push_back(std::move(note));
  return file;
}

}  // namespace layoutbox::readers
