// The room on a floor plan: its walls' frames and how far it reaches with its doors, in the room's millimetres.
#pragma once

#include <vector>

#include "layoutbox/scene/layout.h"

namespace layoutbox {

struct PlanVector {
  double x = 0, y = 0;
};

inline PlanVector operator+(PlanVector a, PlanVector b) { return {a.x + b.x, a.y + b.y}; }
inline PlanVector operator*(double s, PlanVector a) { return {s * a.x, s * a.y}; }

// A wall with its direction and its outward normal.
struct PlanWall {
  PlanVector start, along, out;
  double length = 0, thickness = 0;
  PlanVector at(double s, double t) const { return start + s * along + t * out; }
};

struct PlanRoom {
  explicit PlanRoom(const Layout& layout);

  std::vector<PlanWall> walls;  // in the layout's order
  // The bounds of the walls' outer faces, and of the leaves that open outwards.
  double x0 = 0, y0 = 0, x1 = 1000, y1 = 1000;
};

// The place of the opening's wall in PlanRoom::walls, or −1.
int wall_of(const Opening& opening, const Layout& layout);

// The leaves of a door that turn: one, or two where it is wider than a leaf can be. Each: the hinge, then the arc that its edge runs
// along from closed to open.
std::vector<std::vector<PlanVector>> door_sweeps(const PlanWall& wall, const Opening& door);

}  // namespace layoutbox
