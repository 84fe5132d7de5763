#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "layoutbox/scene/json_documents.h"
#include "layoutbox/scene/json_parts.h"
#include "layoutbox/scene/json_text.h"
#include "layoutbox/scene/quirks.h"
#include "layoutbox/scene/scene_check.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/scene/schema_check.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox {
namespace {

using nlohmann::json;

PlacedObject object_from(const json& value) {
  PlacedObject object;
  object.id = text_at(value, "id");
  object.category = text_at(value, "category");
  object.name = text_at(value, "name");
  object.catalog_id = text_at(value, "catalogId");
  object.attributes = texts_at(value, "attributes");
  const std::array<double, 3> size = vector_from(value.at("size"));
  object.size = {static_cast<Mm>(std::lround(size[0])), static_cast<Mm>(std::lround(size[1])), static_cast<Mm>(std::lround(size[2]))};
  object.position = vector_from(value.at("pos"));
  object.rotation_deg = normalized_degrees(value.at("rotation").get<double>());
  object.mount = mount_from_name(text_at(value, "mount")).value_or(Mount::kFloor);
  object.supported_by = text_at(value, "supportedBy");
  if (const auto sides = value.find("usedSides"); sides != value.end()) object.used_sides = sides_from(*sides);
  if (const auto spaces = value.find("spaces"); spaces != value.end()) object.spaces = spaces_from(*spaces);
  object.mesh = text_at(value, "mesh");
  object.mesh_front = text_at(value, "meshFront");
  object.material = text_at(value, "matOverride");
  object.fixed = flag_at(value, "fixed", false);
  object.origin = origin_at(value);
  return object;
}

Room placed_room_from(const json& value) {
  Room room;
  room.polygon = polygon_from(value.at("polygon"));
  room.height = length_at(value, "height");
  if (const auto walls = value.find("walls"); walls != value.end()) {
    for (const json& item : *walls) {
      room.walls.push_back({text_at(item, "id"), point_from(item.at("start")), point_from(item.at("end")),
                            length_at(item, "thickness", Wall{}.thickness), text_at(item, "mat"), text_at(item, "mesh")});
    }
  }
  room.openings_given = true;
  if (const auto openings = value.find("openings"); openings != value.end()) {
    for (const json& item : *openings) room.openings.push_back(opening_from(item));
  }
  room.floor_material = text_at(value, "floorMat");
  room.ceiling_material = text_at(value, "ceilingMat");
  room.wall_material = text_at(value, "wallMat");
  return room;
}

// A layout is written normalised, but anybody may edit it: walls along the polygon are put in order, or made where there are none.
void settle_shell(Room& room) {
  if (auto polygon = tidy_polygon(room.polygon)) room.polygon = std::move(*polygon);
  if (room.walls.empty()) room.walls = walls_along(room.polygon);
  if (auto walls = walls_in_ring(room.walls, room.openings)) room.walls = std::move(*walls);
}

template <class Function>
void for_each_in(const json& document, const char* key, Function function) {
  if (const auto list = document.find(key); list != document.end()) {
    for (const json& item : *list) function(item);
  }
}

void settle_relations(json& document) {
  if (!document.is_object() || !document.contains("relations")) return;
  std::vector<Note> unheard;  // a layout has no notes
  for (json& relation : document.at("relations")) {
    if (relation.is_object()) settle_edge_and_region(relation, {}, unheard);
  }
}

Layout layout_from(const json& document) {
  Layout layout;
  layout.prompt = text_at(document, "prompt");
  layout.name = text_at(document, "name");
  layout.status = layout_status_from_name(text_at(document, "status")).value_or(LayoutStatus::kSolved);
  layout.room = placed_room_from(document.at("room"));
  layout.room.type = text_at(document, "roomType");
  for_each_in(document, "objects", [&](const json& item) { layout.objects.push_back(object_from(item)); });
  for_each_in(document, "relations", [&](const json& item) {
    layout.relations.push_back({relation_from(item), flag_at(item, "held", false)});
  });
  for (const auto& [key, list] : {std::pair{"relaxed", &layout.relaxed}, std::pair{"gaveWay", &layout.gave_way}}) {
    for_each_in(document, key, [&](const json& item) {
      list->push_back({text_at(item, "relation"), item.value("by", 0.0), text_at(item, "unit"), text_at(item, "why")});
    });
  }
  for_each_in(document, "conflicts", [&](const json& item) {
    layout.conflicts.push_back(
        {texts_at(item, "relations"), texts_at(item, "objects"), text_at(item, "sentence"), flag_at(item, "minimal", true)});
  });
  if (const auto materials = document.find("materials"); materials != document.end()) layout.materials = materials_from(*materials);
  if (const auto score = document.find("score"); score != document.end()) {
    layout.score = score->value("total", 0.0);
    layout.score_terms = score->value("terms", std::map<std::string, double>());
  }
  if (const auto stats = document.find("stats"); stats != document.end()) {
    layout.stats = {text_at(*stats, "solver"), stats->value("seed", std::uint64_t{1}), stats->value("seconds", 0.0),
                    flag_at(*stats, "proven", false), flag_at(*stats, "stoppedByClock", false)};
  }
  return layout;
}

}  // namespace

Result<Layout> layout_from_json(json document) {
  try {
    drop_nulls(document);
    settle_relations(document);
    if (std::vector<Error> errors = check_against_schema(document, SchemaName::kLayout); !errors.empty())
      return Failure(combined(std::move(errors)));
    Layout layout = layout_from(document);
    if (std::vector<Error> errors = check_layout(layout); !errors.empty()) return Failure(combined(std::move(errors)));
    settle_shell(layout.room);
    return layout;
  } catch (const std::exception& error) {
    return fail(ErrorCode::kInternal, fmt::format("the layout cannot be read: {}", error.what()));
  }
}

Result<Layout> read_layout(std::string_view text) {
  LAYOUTBOX_ASSIGN(json document, parse_json(text));
  return layout_from_json(std::move(document));
}

Result<std::string> kind_of_document(std::string_view text) {
  LAYOUTBOX_ASSIGN(const json document, parse_json(text));
  if (!document.is_object()) return fail(ErrorCode::kSchema, "the document is no JSON object", {}, "give a scene or a layout file");
  if (const auto format = document.find("format"); format != document.end() && format->is_string()) {
    const std::string name = format->get<std::string>();
    if (name.starts_with("layoutbox/scene@")) return "scene";
    if (name.starts_with("layoutbox/layout@")) return "layout";
    return fail(ErrorCode::kSchema, fmt::format("the format \"{}\" is not known", name), "/format",
                "layoutbox/scene@1 and layoutbox/layout@1 are");
  }
  if (document.contains("furniture") || document.contains("constraints")) return "scene";
  if (document.contains("objects")) return "layout";
  return fail(ErrorCode::kSchema, "this is neither a scene nor a layout", {},
              "a scene has \"room\" and \"furniture\", a layout \"room\" and \"objects\"");
}

}  // namespace layoutbox
