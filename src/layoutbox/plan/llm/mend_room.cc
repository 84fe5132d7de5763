#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "layoutbox/base/words.h"
#include "layoutbox/plan/llm/mend.h"
#include "layoutbox/plan/llm/mend_text.h"

namespace layoutbox::llm {
namespace {

using nlohmann::json;

// {"w": 4, "h": 2.5}: half a floor is none.
void drop_half_a_size(json& room, Notes& notes) {
  const auto dims = room.find("dims");
  if (dims == room.end() || !dims->is_object() || dims->contains("w") == dims->contains("d")) return;
  note(notes, "of the room's width and depth one alone is given: neither is taken", "/room/dims");
  dims->erase("w");
  dims->erase("d");
  if (dims->empty()) room.erase("dims");
}

// Small models give the room the size of a desk. Where the text says such a size, it is set right after it.
void drop_impossible_size(json& room, Notes& notes) {
  constexpr double kLeastSide = 1.0, kLeastHeight = 1.8;
  const auto dims = room.find("dims");
  if (dims == room.end() || !dims->is_object()) return;
  const auto is_below = [&](const char* side, double least) {
    return dims->contains(side) && (*dims)[side].is_number() && (*dims)[side].get<double>() < least;
  };
  if (!is_below("w", kLeastSide) && !is_below("d", kLeastSide) && !is_below("h", kLeastHeight)) return;
  note(notes,
       fmt::format("nobody can stand in such a room: its size is chosen instead (at least {:g} m wide, {:g} m high)", kLeastSide,
                   kLeastHeight),
       "/room/dims");
  room.erase("dims");
}

// Small models copy the furniture into the openings: what has the id of a thing is no door. Doors and windows of one id are told apart.
class OpeningMender {
 public:
  OpeningMender(json& scene, Notes& notes) : room_(scene["room"]), notes_(notes) {
    for (const json& object : scene["furniture"]) {
      if (object.is_object()) things_.insert(key_of(text_of(object, "id")));
    }
  }

  void run() {
    json kept = json::array();
    for (json& opening : room_["openings"]) {
      if (!opening.is_object()) continue;
      if (things_.contains(key_of(text_of(opening, "id")))) {
        note(notes_, fmt::format("\"{}\" is a thing and no opening: left out", clean_id(text_of(opening, "id"))), "/room/openings");
        continue;
      }
      settle_id(opening, kept.size());
      kept.push_back(std::move(opening));
    }
    room_["openings"] = std::move(kept);
    if (room_["openings"].empty()) room_.erase("openings");
  }

 private:
  void settle_id(json& opening, std::size_t index) {
    const std::string written = text_of(opening, "id");
    std::string id = clean_id(written);
    if (id.empty()) id = text_of(opening, "type") == "window" ? "window_1" : "door_1";
    const std::string stem = id;
    for (int number = 2; things_.contains(key_of(id)) || !ids_.insert(key_of(id)).second; ++number) id = fmt::format("{}_{}", stem, number);
    if (id != written) note(notes_, fmt::format("the id is now {}", id), fmt::format("/room/openings/{}", index));
    opening["id"] = id;
  }

  json& room_;
  Notes& notes_;
  std::set<std::string> things_, ids_;
};

}  // namespace

void mend_room(json& scene, Notes& notes) {
  if (scene.contains("materials") && scene["materials"].is_array()) {
    for (json& material : scene["materials"]) {
      if (material.is_object() && material.erase("tex") > 0) note(notes, "\"tex\" is left out: no model names files", "/materials");
      if (material.is_object()) clean_text(material, "id", "/materials", notes);
    }
  }
  if (scene.contains("room") && scene["room"].is_object()) {
    json& room = scene["room"];
    for (const char* key : {"floorMat", "wallMat"}) clean_text(room, key, "/room", notes);
    drop_half_a_size(room, notes);
    drop_impossible_size(room, notes);
    if (room.contains("openings") && room["openings"].is_array() && !room["openings"].empty()) OpeningMender(scene, notes).run();
  }
  if (scene.contains("metadata") && scene["metadata"].is_object()) {
    for (const char* key : {"roomType", "name"}) clean_text(scene["metadata"], key, "/metadata", notes);
  }
}

}  // namespace layoutbox::llm
