// A plan of the room in pixels: where a person can walk, and from where a piece of furniture can be used (quality.md).
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "layoutbox/verify/room_view.h"

namespace layoutbox::checks {

// Square plan of `resolution` pixels a side around the floor's middle, `margin` metres wider than the floor on each side;
// a pixel is the point in its middle, and free while it lies on the floor and nothing is drawn over it.
class FloorPixels {
 public:
  FloorPixels(const RoomView& view, double margin, int resolution);

  // Takes away what lies within half of `width` of the floor's edge (as SceneEval does: a square brush).
  void erode(double width);
  // Takes away what lies within `distance` of the floor's edge (round).
  void keep_from_edges(const Polygon& floor, double distance);
  // Draws bodies, `grow` metres wider all round: their boxes, or what is drawn of them as it is seen from above.
  void block(const std::vector<const Body*>& bodies, double grow);

  bool free_at(Vec2d point) const;  // off the picture: false
  std::int64_t free_pixels() const;
  std::int64_t largest_free_part() const;
  // A label for each pixel: the same in a connected part (eight neighbours), 0 where not free.
  std::vector<int> parts() const;

  // The pixels within `reach` of a point in both directions, as far as the plan goes; the ends are not part of it.
  struct Pixels {
    int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
  };
  Pixels around(Vec2d point, double reach) const;

  double step() const { return step_; }
  int resolution() const { return resolution_; }
  Vec2d point(int column, int row) const;
  bool free(int column, int row) const { return free_[index(column, row)] != 0; }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(resolution_) + static_cast<std::size_t>(column);
  }

 private:
  struct Stretch;

  void draw_floor(const Polygon& floor);
  template <class Test>
  std::pair<int, int> columns(const Interval& span, Test takes) const;
  void block_box(const Body& body, double grow);
  void block_square(const Body& body, Vec2d half, double grow);
  void mark(const Triangle& triangle, std::vector<std::uint8_t>& marks) const;
  void block_near(const std::vector<std::uint8_t>& marks, double distance);
  std::vector<Stretch> stretches() const;

  int resolution_;
  double step_ = 1;
  Vec2d middle_;
  std::vector<std::uint8_t> free_;
};

// Largest connected walkable area over all walkable area, for a person 0.2 m wide; 0 where there is none.
double navigability(const RoomView& view);
// Free share of the strip 0.2 m deep, 0.05 m off the best used side; empty for what has no side to be reached.
std::optional<double> accessibility(const Body& body, const FloorPixels& plan);
FloorPixels plan_for_access(const RoomView& view);

// The used sides at which things are taken hold of from the floor.
std::vector<Side> sides_to_reach(const Body& body);

}  // namespace layoutbox::checks
