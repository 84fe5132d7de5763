// Reading and writing scene.json and layout.json. Reading validates against schema/*.schema.json first, then checks what a
// schema cannot say (ids, walls that meet, openings in their walls); all errors of a file come at once, in Error::details.
#pragma once

#include <string>
#include <string_view>

#include "layoutbox/base/result.h"
#include "layoutbox/scene/layout.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

// Reads our own files and the paper's, with all quirks of docs/scene-format.md. What was read in another way than written is in
// `notes`. The scene is not yet normalised. `units` overrides metadata.units of files that are not marked as ours: "m", "cm", "mm", "ft",
// "in" or empty. Errors: kParse, kSchema, kReference, kGeometry, kTooLarge; kUsage for an unknown unit.
Result<SceneGraph> read_scene(std::string_view json, std::string_view units = {});
Result<Layout> read_layout(std::string_view json);

// A room alone, in the form of a scene's `room` (or a whole file that has one): dims or polygon, walls, openings, materials.
Result<Room> read_room(std::string_view json, std::string_view units = {});

// Pretty-printed, keys in the order of docs/scene-format.md, lengths in metres, the same bytes for the same value.
std::string write_scene(const SceneGraph& scene);
std::string write_layout(const Layout& layout);

// Which kind of file this is, by its format member or its shape: "scene", "layout", or an error.
Result<std::string> kind_of_document(std::string_view json);

}  // namespace layoutbox
