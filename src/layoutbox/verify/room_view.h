// A layout as the verifier looks at it: bodies, walls and openings as shapes in metres, with what the catalogue knows of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/layout.h"
#include "layoutbox/verify/drawn.h"
#include "layoutbox/verify/geometry.h"
#include "layoutbox/verify/verify.h"

namespace layoutbox::checks {

inline constexpr double kRugHeight = 0.03;   // m: rugs and mats up to this height collide with nothing
inline constexpr double kBodyReach = 2.0;    // m: what hangs higher is in nobody's way
inline constexpr double kWindowDepth = 0.5;  // m: kept free in front of a window, above its sill

// A free box within a body.
struct Hollow {
  std::string name;
  Polygon plan;
  Interval heights;
  bool carries = true;
};

struct Body {
  std::size_t index = 0;  // in layout.objects
  const PlacedObject* object = nullptr;
  const CatalogEntry* entry = nullptr;
  Shape shape;                  // its frame is the room's where the kind has no front
  Frame own_frame;              // turned with it, front or not
  double width = 0, depth = 0;  // along own_frame
  std::vector<Hollow> hollows;
  const std::vector<Triangle>* drawn = nullptr;  // what is made of it; where there is any, plans are drawn from it instead of the box
  bool rug = false, curtain = false, has_front = true;
  const std::string& id() const { return object->id; }
  double underside() const { return shape.heights.lo; }
  double top() const { return shape.heights.hi; }
};

// A wall's inner face, a door or a window; its frame has x along the wall and y out of the room.
struct Face {
  std::size_t index = 0;  // in room.walls or room.openings
  std::string id;
  const Opening* opening = nullptr;  // null: a wall
  const Face* wall = nullptr;        // of an opening
  Shape shape;
  Vec2d start, end, along, inward;
  double length = 0;
  bool is_window() const { return opening != nullptr && opening->type == OpeningType::kWindow; }
  bool is_door() const { return opening != nullptr && opening->type != OpeningType::kWindow; }
};

// The box that stays free before an opening: a door's as deep as it is wide, a window's 0.5 m.
Shape space_before(const Face& opening);
Shape space_before(const Face& opening, double depth);

// How deep a body reaches into the quarter disc that a hinged door sweeps in the room; 0 when it does not.
double swing_intrusion(const Face& door, const Body& body);
// That quarter disc less 5 mm at its straight edges, as a polygon; empty where no leaf comes into the room.
Polygon swing_of(const Face& door);

// A named side of a body: the outward direction and how far it is from the centre.
struct BodySide {
  Vec2d outward, along;
  double reach = 0, half_width = 0;
};
BodySide side_of(const Body& body, Side side);  // front, back, left or right; in its own frame

class RoomView {
 public:
  // REQUIRES: layout, catalog and options outlive the view.
  RoomView(const Layout& layout, const Catalog& catalog, const VerifyOptions& options);
  RoomView(const RoomView&) = delete;
  RoomView& operator=(const RoomView&) = delete;

  const Body* find_body(std::string_view id) const;
  const Face* find_wall(std::string_view id_or_word) const;
  const Face* find_opening(std::string_view id) const;
  // True when `other` is at `body` because a relation of the layout brought it there (a chair tucked under its desk).
  bool belongs_to(const Body& other, const Body& body) const;

  const Layout& layout;
  const Catalog& catalog;
  const VerifyOptions& options;
  Polygon floor;              // counter-clockwise; empty when the layout has no polygon with an area
  Interval floor_x, floor_y;  // its extents
  double height = 0;
  std::vector<Body> bodies;    // one per object, in order
  std::vector<Face> walls;     // those that have a length
  std::vector<Face> openings;  // those whose wall is there
  std::vector<std::string> unplaced_openings;

 private:
  void read_floor();
  void read_faces();
  void read_bodies();
};

}  // namespace layoutbox::checks
