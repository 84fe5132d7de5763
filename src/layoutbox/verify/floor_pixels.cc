// The floor as pixels: what is free, what blocks it, which parts hang together.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "layoutbox/verify/walkability.h"

namespace layoutbox::checks {
namespace {

std::size_t places(int n) { return static_cast<std::size_t>(n); }

// Is hypot(x, y) at most `far`? Most pixels need no root for that. REQUIRES: neither is less than 0.
bool within(double x, double y, double far) {
  if (x > far || y > far) return false;
  return x == 0 || y == 0 || std::hypot(x, y) <= far;
}

}  // namespace

FloorPixels::FloorPixels(const RoomView& view, double margin, int resolution)
    : resolution_(resolution), free_(places(resolution) * places(resolution), 0) {
  if (view.floor.empty()) return;
  middle_ = {(view.floor_x.lo + view.floor_x.hi) / 2, (view.floor_y.lo + view.floor_y.hi) / 2};
  step_ = (std::max(view.floor_x.length(), view.floor_y.length()) / 2 + margin) / (resolution / 2);
  draw_floor(view.floor);
}

Vec2d FloorPixels::point(int column, int row) const {
  return {(column - resolution_ / 2) * step_ + middle_.x, (row - resolution_ / 2) * step_ + middle_.y};
}

// Those of a row whose middles a test takes: all between about the ends of the span, which rounding may miss by one.
template <class Test>
std::pair<int, int> FloorPixels::columns(const Interval& span, Test takes) const {
  const auto column_of = [&](double x) {
    return static_cast<int>(std::clamp(std::nearbyint((x - middle_.x) / step_) + resolution_ / 2, 0.0, double(resolution_)));
  };
  int begin = std::max(column_of(span.lo) - 1, 0), end = std::min(column_of(span.hi) + 2, resolution_);
  while (begin < end && !takes(begin)) ++begin;
  while (begin < end && !takes(end - 1)) --end;
  return {begin, end};
}

// Row by row; a point on the floor's edge is on the floor.
void FloorPixels::draw_floor(const Polygon& floor) {
  std::vector<double> crossings;
  std::vector<Interval> spans;
  for (int row = 0; row < resolution_; ++row) {
    const double y = point(0, row).y;
    crossings.clear();
    spans.clear();
    for (std::size_t i = 0; i < floor.size(); ++i) {
      const Vec2d a = floor[i], b = floor[(i + 1) % floor.size()];
      if (a.y == y) spans.push_back({a.x, a.x});
      if (a.y == y && b.y == y) spans.push_back({std::min(a.x, b.x), std::max(a.x, b.x)});
      if ((a.y > y) != (b.y > y)) crossings.push_back(a.x == b.x ? a.x : a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) spans.push_back({crossings[i], crossings[i + 1]});
    for (const Interval& span : spans) {
      const auto [begin, end] = columns(span, [&](int column) {
        const double x = point(column, row).x;
        return x >= span.lo && x <= span.hi;
      });
      std::fill_n(free_.begin() + static_cast<std::ptrdiff_t>(index(begin, row)), end - begin, std::uint8_t{1});
    }
  }
}

void FloorPixels::erode(double width) {
  const int size = std::min(static_cast<int>(width / step_), resolution_);
  if (size <= 0) return;
  // A pixel stays free when `size` neighbours in its line are: from `before` pixels before it to `after` after it, round the edge.
  const int after = size / 2, before = size - after - 1;
  const auto wrapped = [this](int i) { return i < 0 ? i + resolution_ : i >= resolution_ ? i - resolution_ : i; };
  const std::vector<std::uint8_t> drawn = free_;
  std::vector<std::uint16_t> free(places(resolution_), 0);  // of those neighbours, for each column
  const auto count_row = [&](int row, int sign) {
    const std::uint8_t* line = drawn.data() + index(0, wrapped(row));
    for (std::size_t i = 0; i < free.size(); ++i) free[i] = static_cast<std::uint16_t>(free[i] + sign * line[i]);
  };
  for (int row = -before; row < after; ++row) count_row(row, 1);
  for (int row = 0; row < resolution_; ++row) {
    count_row(row + after, 1);
    for (std::size_t i = 0; i < free.size(); ++i) free_[index(0, row) + i] = free[i] == size;
    count_row(row - before, -1);
  }
  std::vector<std::uint8_t> line(places(before + resolution_ + after));
  for (int row = 0; row < resolution_; ++row) {
    std::uint8_t* to = free_.data() + index(0, row);
    for (int i = -before; i < resolution_ + after; ++i) line[places(before + i)] = to[wrapped(i)];
    int near = std::accumulate(line.begin(), line.begin() + before + after, 0);
    for (int i = 0; i < resolution_; ++i) {
      near += line[places(before + i + after)];
      to[i] = near == size;
      near -= line[places(i)];
    }
  }
}

void FloorPixels::keep_from_edges(const Polygon& floor, double distance) {
  for (std::size_t i = 0; i < floor.size(); ++i) {
    const Vec2d a = floor[i], b = floor[(i + 1) % floor.size()];
    const Pixels near_a = around(a, distance), near_b = around(b, distance);
    for (int row = std::min(near_a.y0, near_b.y0); row < std::max(near_a.y1, near_b.y1); ++row) {
      for (int column = std::min(near_a.x0, near_b.x0); column < std::max(near_a.x1, near_b.x1); ++column) {
        if (free(column, row) && distance_to_segment(point(column, row), a, b) < distance) free_[index(column, row)] = 0;
      }
    }
  }
}

FloorPixels::Pixels FloorPixels::around(Vec2d point, double reach) const {
  const auto pixel = [&](double offset, bool up) {
    const double at = (up ? std::ceil(offset / step_) + 1 : std::floor(offset / step_)) + resolution_ / 2;
    return static_cast<int>(std::clamp(at, 0.0, double(resolution_)));
  };
  const Vec2d from_middle = point - middle_;
  return {pixel(from_middle.x - reach, false), pixel(from_middle.x + reach, true), pixel(from_middle.y - reach, false),
          pixel(from_middle.y + reach, true)};
}

void FloorPixels::block(const std::vector<const Body*>& bodies, double grow) {
  std::vector<std::uint8_t> marks;
  for (const Body* body : bodies) {
    if (body->drawn == nullptr) {
      block_box(*body, grow);
      continue;
    }
    if (marks.empty()) marks.resize(free_.size(), 0);
    for (const Triangle& triangle : *body->drawn) {
      // What looks down has something above it that looks up.
      const auto [a, b, c] = triangle;
      if ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) >= 0) mark(triangle, marks);
    }
  }
  if (!marks.empty()) block_near(marks, grow);
}

// Row by row: from the leftmost to the rightmost place of the triangle within the height of a pixel.
void FloorPixels::mark(const Triangle& triangle, std::vector<std::uint8_t>& marks) const {
  const auto column_of = [&](double x) { return (x - middle_.x) / step_ + resolution_ / 2; };
  const auto row_of = [&](double y) { return (y - middle_.y) / step_ + resolution_ / 2; };
  const auto bounded = [&](double at) { return static_cast<int>(std::clamp(std::nearbyint(at), 0.0, double(resolution_ - 1))); };
  double low = row_of(triangle[0].y), high = low;
  for (const Point3& corner : triangle) low = std::min(low, row_of(corner.y)), high = std::max(high, row_of(corner.y));
  if (!(high >= -0.5) || !(low <= resolution_ - 0.5)) return;
  for (int row = bounded(low); row <= bounded(high); ++row) {
    double left = std::numeric_limits<double>::infinity(), right = -left;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3 &a = triangle[i], &b = triangle[(i + 1) % 3];
      double from = 0, to = 1;  // of the edge, within this row
      const double ya = row_of(a.y) - row, yb = row_of(b.y) - row;
      if (std::abs(yb - ya) < 1e-12) {
        if (std::abs(ya) > 0.5) continue;
      } else {
        const double first = (-0.5 - ya) / (yb - ya), last = (0.5 - ya) / (yb - ya);
        from = std::max(from, std::min(first, last)), to = std::min(to, std::max(first, last));
        if (from > to) continue;
      }
      for (const double at : {from, to}) {
        const double x = column_of(a.x + (b.x - a.x) * at);
        left = std::min(left, x), right = std::max(right, x);
      }
    }
    if (!(left <= right) || right < -0.5 || left > resolution_ - 0.5) continue;
    std::fill(marks.begin() + static_cast<std::ptrdiff_t>(index(bounded(left), row)),
              marks.begin() + static_cast<std::ptrdiff_t>(index(bounded(right), row)) + 1, std::uint8_t{1});
  }
}

// Pixels whose middle is at most that far from the middle of a marked one: along rows first, then across them.
void FloorPixels::block_near(const std::vector<std::uint8_t>& marks, double distance) {
  const double reach = distance / step_;
  const int rows = static_cast<int>(reach);
  std::vector<int> off(marks.size(), resolution_);  // columns to the nearest mark in the row
  for (int row = 0; row < resolution_; ++row) {
    int far = resolution_;
    for (int column = 0; column < resolution_; ++column) off[index(column, row)] = far = marks[index(column, row)] ? 0 : far + 1;
    far = resolution_;
    for (int column = resolution_ - 1; column >= 0; --column) {
      far = marks[index(column, row)] ? 0 : far + 1;
      off[index(column, row)] = std::min(off[index(column, row)], far);
    }
  }
  for (int up = -rows; up <= rows; ++up) {
    const int across = static_cast<int>(std::sqrt(std::max(0.0, reach * reach - up * up)));
    for (int row = std::max(0, -up); row < resolution_ - std::max(0, up); ++row) {
      const int* from = off.data() + index(0, row + up);
      std::uint8_t* to = free_.data() + index(0, row);
      for (int column = 0; column < resolution_; ++column) to[column] = from[column] <= across ? 0 : to[column];
    }
  }
}

// What stands square to the room.
void FloorPixels::block_square(const Body& body, Vec2d half, double grow) {
  const double reach = grow + kTiny;
  const Vec2d center = body.shape.center;
  const auto rows = around(center, half.y + grow);
  for (int row = rows.y0; row < rows.y1; ++row) {
    const double over_y = std::max(std::abs(point(0, row).y - center.y) - half.y, 0.0);
    if (over_y > reach) continue;
    const double most = half.x + (over_y > 0 ? std::sqrt(std::max(0.0, reach * reach - over_y * over_y)) : reach);
    const auto [begin, end] = columns({center.x - most, center.x + most}, [&](int column) {
      return within(std::max(std::abs(point(column, row).x - center.x) - half.x, 0.0), over_y, reach);
    });
    std::fill_n(free_.begin() + static_cast<std::ptrdiff_t>(index(begin, row)), end - begin, std::uint8_t{0});
  }
}

void FloorPixels::block_box(const Body& body, double grow) {
  const Frame& frame = body.own_frame;
  if (frame.x.y == 0) return block_square(body, Vec2d{body.width, body.depth} * 0.5, grow);
  if (frame.x.x == 0) return block_square(body, Vec2d{body.depth, body.width} * 0.5, grow);
  const double reach = std::hypot(body.width, body.depth) / 2 + grow;
  const auto [x0, x1, y0, y1] = around(body.shape.center, reach);
  for (int row = y0; row < y1; ++row) {
    for (int column = x0; column < x1; ++column) {
      if (!free(column, row)) continue;
      const Vec2d off = point(column, row) - body.shape.center;
      const double over_x = std::max(std::abs(dot(off, body.own_frame.x)) - body.width / 2, 0.0);
      const double over_y = std::max(std::abs(dot(off, body.own_frame.y)) - body.depth / 2, 0.0);
      if (within(over_x, over_y, grow + kTiny)) free_[index(column, row)] = 0;
    }
  }
}

bool FloorPixels::free_at(Vec2d at) const {
  const double column = std::nearbyint((at.x - middle_.x) / step_) + resolution_ / 2;
  const double row = std::nearbyint((at.y - middle_.y) / step_) + resolution_ / 2;
  if (!(column >= 0 && column < resolution_ && row >= 0 && row < resolution_)) return false;
  return free(static_cast<int>(column), static_cast<int>(row));
}

std::int64_t FloorPixels::free_pixels() const { return std::accumulate(free_.begin(), free_.end(), std::int64_t{0}); }

// A stretch of free pixels in a row, and the one that stands for its part.
struct FloorPixels::Stretch {
  int row, begin, end;
  std::size_t part;
};

// Row by row; what touches a stretch of the row before, corners too, is one part with it.
std::vector<FloorPixels::Stretch> FloorPixels::stretches() const {
  std::vector<Stretch> all;
  const auto part_of = [&all](std::size_t one) {
    while (all[one].part != one) one = all[one].part = all[all[one].part].part;
    return one;
  };
  std::size_t above = 0;  // the first of the row before that may touch
  for (int row = 0; row < resolution_; ++row) {
    const std::size_t first = all.size();
    const std::uint8_t* line = free_.data() + index(0, row);
    for (int column = 0; column < resolution_; ++column) {
      if (line[column] == 0) continue;
      const int begin = column;
      while (column < resolution_ && line[column] != 0) ++column;
      all.push_back({row, begin, column, all.size()});
      while (above < first && all[above].end < begin) ++above;
      for (std::size_t other = above; other < first && all[other].begin <= column; ++other) {
        const std::size_t a = part_of(other), b = part_of(all.size() - 1);
        all[std::max(a, b)].part = std::min(a, b);
      }
    }
    above = first;
  }
  for (std::size_t i = 0; i < all.size(); ++i) all[i].part = part_of(i);
  return all;
}

std::vector<int> FloorPixels::parts() const {
  std::vector<int> label(free_.size(), 0);
  for (const Stretch& one : stretches()) {
    const auto begin = label.begin() + static_cast<std::ptrdiff_t>(index(0, one.row));
    std::fill(begin + one.begin, begin + one.end, static_cast<int>(one.part) + 1);
  }
  return label;
}

std::int64_t FloorPixels::largest_free_part() const {
  const std::vector<Stretch> all = stretches();
  std::vector<std::int64_t> size(all.size() + 1, 0);
  for (const Stretch& one : all) size[one.part] += one.end - one.begin;
  return *std::max_element(size.begin(), size.end());
}

}  // namespace layoutbox::checks
