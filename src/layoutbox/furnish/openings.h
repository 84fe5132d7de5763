// Doors, windows and open passages: what fills a wall's openings.
#pragma once

#include "layoutbox/furnish/decor.h"
#include "layoutbox/furnish/kit.h"
#include "layoutbox/furnish/palette.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox {

inline constexpr double kCasing = 0.06;  // metres: width of the boards round an opening

// A wall in metres: where it stands and which way it runs. Its frame: x along the wall, y into the room.
struct WallFrame {
  explicit WallFrame(const Wall& wall);
  kit::Vec2 start, along, inward;
  double length, thickness, rotation_deg;
  // A node in this frame, at `offset` along the wall.
  Node node(const std::string& id, NodeKind kind, double offset = 0) const;
  // A point of the room in this frame, less `offset`.
  kit::Vec2 local(kit::Vec2 room_point, double offset) const;
};

void add_openings(const Layout& layout, const Decor& decor, Palette& palette, Model& model);

}  // namespace layoutbox
