// Holodeck writes ProcTHOR's houses: y up, z away, left-handed (turns are clockwise seen from above), fronts along +z.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "layoutbox/judge/readers/found_room.h"
#include "layoutbox/judge/readers/readers.h"
#include "layoutbox/scene/json_text.h"

namespace layoutbox::readers {
namespace {

using nlohmann::json;

const json& part(const json& value, const char* key) {
  static const json none;
  if (!value.is_object()) return none;
  const auto found = value.find(key);
  return found == value.end() ? none : *found;
}

std::vector<const json*> all_objects(const json& objects) {
  std::vector<const json*> list;
  for (const json& object : objects) {
    list.push_back(&object);
    for (const json& child : part(object, "children")) list.push_back(&child);
  }
  return list;
}

// The room with the most objects: one is judged at a time.
const json* fullest_room(const json& document, const std::vector<const json*>& objects) {
  std::map<std::string, int> counts;
  for (const json* object : objects) ++counts[text_of(*object, "roomId")];
  const json* best = nullptr;
  for (const json& room : part(document, "rooms")) {
    if (best == nullptr || counts[text_of(room, "id")] > counts[text_of(*best, "id")]) best = &room;
  }
  return best;
}

// Footprint in the object's own axes from its corners on the floor (in centimetres), else nothing.
std::optional<std::array<double, 2>> footprint_of(const json& vertices, double turn_deg) {
  if (!vertices.is_array() || vertices.size() < 4) return std::nullopt;
  const double c = std::cos(radians_from_degrees(turn_deg)), s = std::sin(radians_from_degrees(turn_deg));
  std::array<double, 2> low{1e9, 1e9}, high{-1e9, -1e9};
  for (const json& vertex : vertices) {
    const auto corner = point_of(vertex);
    if (!corner) return std::nullopt;
    const std::array<double, 2> own{((*corner)[0] * c + (*corner)[1] * s) / 100, ((*corner)[1] * c - (*corner)[0] * s) / 100};
    for (std::size_t i = 0; i < 2; ++i) low[i] = std::min(low[i], own[i]), high[i] = std::max(high[i], own[i]);
  }
  return std::array<double, 2>{high[0] - low[0], high[1] - low[1]};
}

// The lower edge of the wall that an opening is in, by the wall's id.
void read_openings(const json& document, const std::string& room_id, const char* list, OpeningType type, FoundRoom& room) {
  for (const json& opening : part(document, list)) {
    if (text_of(opening, "room0") != room_id && text_of(opening, "room1") != room_id) continue;
    for (const char* key : {"wall0", "wall1"}) {
      const std::string wall_id = text_of(opening, key);
      for (const json& wall : part(document, "walls")) {
        if (text_of(wall, "id") != wall_id || text_of(wall, "roomId") != room_id) continue;
        const json& polygon = part(wall, "polygon");
        const json& hole = part(opening, "holePolygon");
        if (!polygon.is_array() || polygon.size() < 3 || !hole.is_array() || hole.size() < 2) continue;
        std::vector<std::array<double, 3>> low;
        for (const json& vertex : polygon) {
          const auto corner = point_of(vertex);
          if (corner && std::abs((*corner)[1]) < 0.01) low.push_back(*corner);
        }
        const auto from = point_of(hole[0]), to = point_of(hole[1]);
        if (low.size() < 2 || !from || !to) continue;
        const double length = std::hypot(low[1][0] - low[0][0], low[1][2] - low[0][2]);
        if (length <= 0) continue;
        const auto at = [&](double along) {
          return std::array<double, 2>{low[0][0] + (low[1][0] - low[0][0]) * along / length,
                                       low[0][2] + (low[1][2] - low[0][2]) * along / length};
        };
        room.openings.push_back(
            {text_of(opening, "id"), type, at((*from)[0]), at((*to)[0]), std::min((*from)[1], (*to)[1]), std::max((*from)[1], (*to)[1])});
        return;
      }
    }
  }
}

}  // namespace

bool is_holodeck(std::string_view bytes) {
  const auto document = parse_json(bytes);
  if (!document) return false;
  const json& rooms = part(*document, "rooms");
  return rooms.is_array() && !rooms.empty() && part(rooms[0], "floorPolygon").is_array() && part(*document, "objects").is_array();
}

Result<RoomFile> read_holodeck(std::string_view bytes, const Catalog& catalog, const json& models) {
  LAYOUTBOX_ASSIGN(const json document, parse_json(bytes));
  const std::vector<const json*> objects = all_objects(part(document, "objects"));
  const json* chosen = fullest_room(document, objects);
  if (chosen == nullptr) return fail(ErrorCode::kSchema, "the house has no room");
  const std::string room_id = text_of(*chosen, "id");
  FoundRoom room;
  room.name = room_id;
  room.type = text_of(*chosen, "roomType");
  room.prompt = text_of(document, "query");
  for (const json& vertex : part(*chosen, "floorPolygon")) {
    if (const auto corner = point_of(vertex)) room.polygon.push_back({(*corner)[0], (*corner)[2]});
  }
  room.height = number(part(document, "wall_height")).value_or(0);
  for (const json& wall : part(document, "walls")) {
    for (const json& vertex : part(wall, "polygon")) {
      if (const auto corner = point_of(vertex)) room.height = std::max(room.height, (*corner)[1]);
    }
  }
  read_openings(document, room_id, "doors", OpeningType::kDoor, room);
  read_openings(document, room_id, "windows", OpeningType::kWindow, room);
  std::size_t elsewhere = 0;
  for (const json* object : objects) {
    if (const std::string in = text_of(*object, "roomId"); !in.empty() && in != room_id) {
      ++elsewhere;
      continue;
    }
    const auto at = point_of(part(*object, "position"));
    const double turn = number(part(part(*object, "rotation"), "y")).value_or(0);
    const std::optional<ModelFacts> facts = model_facts(models, text_of(*object, "assetId"));
    std::string name = text_of(*object, "object_name");
    if (name.empty()) name = facts && !facts->name.empty() ? facts->name : text_of(*object, "id");
    if (!at) return fail(ErrorCode::kSchema, fmt::format("{} has no position", name));
    FoundObject found{text_of(*object, "id"), name, {}, {(*at)[0], (*at)[2], 0}, 180 - turn, {}};
    if (facts && facts->size) {
      found.size = *facts->size;
    } else if (const auto footprint = footprint_of(part(*object, "vertices"), -turn)) {
      // What stands on the floor is as high as twice its middle.
      found.size = {(*footprint)[0], (*footprint)[1], 2 * (*at)[1]};
      const CatalogEntry& entry = catalog.entry_or_nearest(words_in(name));
      if (entry.mount != Mount::kFloor) found.size[2] = m_from_mm(entry.size.usual.height);
    } else {
      const Size usual = catalog.entry_or_nearest(words_in(name)).size.usual;
      found.size = {m_from_mm(usual.width), m_from_mm(usual.depth), m_from_mm(usual.height)};
      room.notes.push_back({"guessed", fmt::format("the size of {} is not said: the usual one of its kind", name), {}});
    }
    found.position[2] = (*at)[1] - found.size[2] / 2;
    room.objects.push_back(std::move(found));
  }
  if (elsewhere > 0) {
    room.notes.push_back({"ignored", fmt::format("the house has other rooms; {} is judged, {} objects are not", room_id, elsewhere), {}});
  }
  room.notes.push_back({"guessed", "an object's position is its middle; its front is +z at rotation 0", {}});
  return settle(std::move(room), catalog, "holodeck");
}

}  // namespace layoutbox::readers
