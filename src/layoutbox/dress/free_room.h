// What is free in a room that is furnished: boxes along the room's axes round everything that stands, hangs or must stay free.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox::dressing {

// An upright box along the room's axes; millimetres.
struct RoomBox {
  double x0 = 0, y0 = 0, z0 = 0, x1 = 0, y1 = 0, z1 = 0;
};
bool overlap(const RoomBox& a, const RoomBox& b);
// The box round a thing, however it is turned.
RoomBox box_round(const PlacedObject& object);

// A part of a wall, from its start; millimetres.
struct Span {
  double low = 0, high = 0;
  double length() const { return high - low; }
  double middle() const { return (low + high) / 2; }
};

// A wall along one of the room's axes, as its own frame: along it (from its start), off it (into the room), up.
struct DressedWall {
  const Wall* wall = nullptr;
  Point start;
  int along_x = 0, along_y = 0;  // one of them is ±1; the floor lies to the left
  double length = 0;
  double turn_deg = 0;  // of what has its back to it

  RoomBox box(Span along, Span off, Span height) const;
  Span along(const RoomBox& box) const;
  Span off(const RoomBox& box) const;
  std::array<double, 3> point(double along, double off, double height) const;
};

// What of it counts when room is looked for.
struct Taken {
  enum class What { kStands, kHangs, kDoorway, kWindow };
  RoomBox box;
  What what = What::kStands;
  std::string id = {};  // of the thing
};

class FreeRoom {
 public:
  // REQUIRES: the layout outlives it; its room has walls along its polygon.
  // `but`: the id of an object that counts for nothing.
  FreeRoom(const Layout& layout, const Catalog& catalog, std::string_view but = {});

  void take(const PlacedObject& object, const CatalogEntry& entry);

  const std::vector<DressedWall>& walls() const { return walls_; }
  // The walls before and after it, where the two meet in a corner of the room that is square; else null.
  const DressedWall* next(const DressedWall& wall) const;
  const DressedWall* previous(const DressedWall& wall) const;
  const DressedWall* opposite(const DressedWall& wall) const;
  // The wall that the thing has its back to, at most so far behind it; null: none.
  const DressedWall* behind(const PlacedObject& object, double reach) const;

  // Does a box of the plan lie on the floor?
  bool inside(const RoomBox& box) const;
  // On the floor of the room, and nothing there; curtains may hang before windows (`window`).
  bool is_free(const RoomBox& box, bool window = false) const;
  // The same, but for things that it may be in: what it lies on, chairs that are pushed under that.
  bool is_free(const RoomBox& box, const std::vector<std::string>& but) const;
  // The parts of a wall that are free so far off it and at these heights, in order; of what is there only what counts.
  enum class Count { kAll, kThings, kStandingAndDoorways };
  std::vector<Span> free_along(const DressedWall& wall, Span off, Span height, Count count = Count::kAll) const;

 private:
  void take_openings();
  static bool counts(Taken::What what, Count count);

  const Layout* layout_;
  std::vector<DressedWall> walls_;
  std::vector<Taken> taken_;
};

// The spans but for what the gap takes of them.
std::vector<Span> without(const std::vector<Span>& spans, const Span& gap);

// The parts that two lists of spans share.
std::vector<Span> shared(const std::vector<Span>& a, const std::vector<Span>& b);

}  // namespace layoutbox::dressing
