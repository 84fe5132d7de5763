// From "what was said" to "what the solver needs": everything that is missing gets a value here, and nothing later guesses.
#pragma once

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

struct NormalizeOptions {
  // DEFAULT: 0 = from the scene, else from the kind of room and what it must hold. Millimetres.
  Size room_size{};
  // DEFAULT: true. A room whose scene names no openings gets a door and a window (marked as assumed).
  bool default_openings = true;
  // By how much a room of which nobody says how large it is becomes longer and deeper than it is guessed. REQUIRES: > 0. DEFAULT: 1.
  double room_growth = 1;
};

// The corners of a room of that shape ("L", "T", "U", "round": eight walls; anything else: a rectangle) within a box of that width and
// depth, in millimetres.
std::vector<Point> room_outline(std::string_view shape, Mm width, Mm depth);

// What is said of a thing that the catalogue does not have: like what kind it is sized and drawn, or, of what is like nothing, that it is
// a plain box (a "warning").
Note unknown_kind_note(const std::string& name, const CatalogEntry& kind, std::string pointer);

// Fills the room (polygon, walls, height, openings), every object's category, size range, mount and used sides, and the support of
// objects that stand on something which no relation names. Turns walls so that they run counter-clockwise along the polygon (and their
// openings with them). Every value that was filled is listed in the notes. The result is what solve() REQUIRES.
// Errors: a room or an object with an impossible size, walls that do not meet, a polygon that crosses itself.
Result<SceneGraph> normalize_scene(SceneGraph scene, const Catalog& catalog, const NormalizeOptions& options = {});

}  // namespace layoutbox
