// What a reader finds in a file, before it is a layout: what the format does not say is guessed here, once for all of them.
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "layoutbox/judge/room_file.h"

namespace layoutbox::readers {

struct FoundObject {
  std::string id;                    // empty: made from its name
  std::string name;                  // "modern sofa", "chair_12": the words for it
  std::array<double, 3> size{};      // m, along its own x, y and up
  std::array<double, 3> position{};  // m; centre of the footprint, and the underside
  double rotation_deg = 0;           // counter-clockwise; its front faces −y at 0
  std::string supported_by;          // empty: guessed
};

struct FoundOpening {
  std::string id;
  OpeningType type = OpeningType::kDoor;
  std::array<double, 2> start{}, end{};  // m, on the floor plan, near a wall
  double low = 0, high = 2;              // m
  Swing swing = Swing::kNone;            // which way a door turns, where that is said
};

struct FoundRoom {
  std::string name, type, prompt;
  std::vector<std::array<double, 2>> polygon;  // m
  double height = 0;                           // m; 0: 2.6 is assumed
  std::vector<FoundOpening> openings;
  std::vector<FoundObject> objects;
  std::vector<Note> notes;
};

// Moves the room to the origin, finds each object's kind by its words, its used sides and spaces in the catalogue, and what holds it by
// where it is. Errors: kGeometry (a polygon without area), kSchema (a size or place that is no number), kTooLarge.
Result<RoomFile> settle(FoundRoom found, const Catalog& catalog, std::string format);

// The words of an identifier: "modern_sofa-0 (living room)" → "modern sofa".
std::string words_in(std::string_view identifier);

// ---- reading JSON of others without trusting it
// A number there (an element or a member), else empty.
std::optional<double> number(const nlohmann::json& value);
std::string text_of(const nlohmann::json& value, const char* key);
// [x, y, …] or {"x": …, "y": …, "z": …} as three numbers, absent ones 0; empty where it is neither.
std::optional<std::array<double, 3>> point_of(const nlohmann::json& value);

// What a file of models says of one: {"chair-1": {"category": "chair", "size": [w, d, h]}} or LayoutVLM's assets (`assetMetadata`).
struct ModelFacts {
  std::string name;
  std::optional<std::array<double, 3>> size;
};
std::optional<ModelFacts> model_facts(const nlohmann::json& models, const std::string& id);

}  // namespace layoutbox::readers
