// A room from a file of anybody's: one reader a format, all of them give a layout.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox {

struct RoomFile {
  std::string name;
  std::string format;  // a row of room_formats()
  Layout layout;
  std::vector<Note> notes;  // what the format does not say and was guessed
};

struct RoomFormat {
  std::string_view name;         // "layout", "scene", "scenestate"…
  std::string_view description;  // what it is and who writes it
  // Is this text (or these bytes) in that format? Only looks; never fails.
  bool (*is_it)(std::string_view bytes);
  // Errors: kParse, kSchema, kGeometry.
  Result<RoomFile> (*read)(std::string_view bytes, const Catalog& catalog, const nlohmann::json& models);
};

struct RoomFileOptions {
  std::string format;  // a row's name; empty: by what the bytes look like
  std::string models;  // JSON with names and sizes of models, for formats that name only models; may be empty
  // Open a .blend although this machine has no sandbox (docs/sandbox.md). DEFAULT: false.
  bool without_walls = false;
};

std::span<const RoomFormat> room_formats();  // in the order in which they are tried
const RoomFormat* find_room_format(std::string_view name);

// Reads by what the bytes look like, or as the format that is named. A .blend is opened by a Blender in the sandbox, which takes seconds.
// Errors: kUsage (an unknown format), kParse (none fits); for a .blend kNoBlender and kIo (no sandbox).
Result<RoomFile> read_room_file(std::string_view bytes, const Catalog& catalog, const RoomFileOptions& options = {});

}  // namespace layoutbox
