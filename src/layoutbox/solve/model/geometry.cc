#include "layoutbox/solve/model/geometry.h"

#include <cmath>
#include <set>

namespace layoutbox::placement {

Mm gap_between(const GridBox& a, const GridBox& b) {
  double squares = 0;
  for (int k = 0; k < 3; ++k) squares += std::pow(static_cast<double>(gap_along(a, b, k)), 2);
  return static_cast<Mm>(std::sqrt(squares));
}

void subtract(const GridBox& box, const GridBox& hole, std::vector<GridBox>& out) {
  if (!overlap(box, hole)) {
    out.push_back(box);
    return;
  }
  GridBox rest = box;
  for (const int axis : {2, 0, 1}) {  // slabs above and below first: table tops and shelf boards stay whole
    if (hole.lo[axis] > rest.lo[axis]) {
      GridBox piece = rest;
      piece.hi[axis] = hole.lo[axis];
      out.push_back(piece);
      rest.lo[axis] = hole.lo[axis];
    }
    if (hole.hi[axis] < rest.hi[axis]) {
      GridBox piece = rest;
      piece.lo[axis] = hole.hi[axis];
      out.push_back(piece);
      rest.hi[axis] = hole.hi[axis];
    }
  }
}

std::vector<GridBox> less(const GridBox& box, std::span<const GridBox> holes) {
  std::vector<GridBox> pieces{box};
  for (const GridBox& hole : holes) {
    std::vector<GridBox> next;
    for (const GridBox& piece : pieces) subtract(piece, hole, next);
    pieces = std::move(next);
  }
  return pieces;
}

namespace {

bool is_quarter(double degrees) { return degrees == 90 * std::round(degrees / 90); }

GridBox turned_by_quarters(const GridBox& box, int quarters) {
  GridBox out = box;
  switch (quarters) {
    case 1: out.lo[0] = -box.hi[1], out.hi[0] = -box.lo[1], out.lo[1] = box.lo[0], out.hi[1] = box.hi[0]; return out;
    case 2: out.lo[0] = -box.hi[0], out.hi[0] = -box.lo[0], out.lo[1] = -box.hi[1], out.hi[1] = -box.lo[1]; return out;
    case 3: out.lo[0] = box.lo[1], out.hi[0] = box.hi[1], out.lo[1] = -box.hi[0], out.hi[1] = -box.lo[0]; return out;
    default: return out;
  }
}

// A thousandth against the last bits of sin and cos, which differ between machines.
Mm rounded_down(double value) { return static_cast<Mm>(std::floor(value + 1e-3)); }
Mm rounded_up(double value) { return static_cast<Mm>(std::ceil(value - 1e-3)); }

}  // namespace

GridBox turned(const GridBox& box, double degrees) {
  if (is_quarter(degrees)) return turned_by_quarters(box, static_cast<int>(std::lround(degrees / 90)) & 3);
  GridBox out = box;
  const double c = std::cos(radians_from_degrees(degrees)), s = std::sin(radians_from_degrees(degrees));
  double lo[2] = {1e9, 1e9}, hi[2] = {-1e9, -1e9};
  for (const double x : {double(box.lo[0]), double(box.hi[0])}) {
    for (const double y : {double(box.lo[1]), double(box.hi[1])}) {
      const double p[2] = {c * x - s * y, s * x + c * y};
      for (int k = 0; k < 2; ++k) lo[k] = std::min(lo[k], p[k]), hi[k] = std::max(hi[k], p[k]);
    }
  }
  for (int k = 0; k < 2; ++k) out.lo[k] = rounded_down(lo[k]), out.hi[k] = rounded_up(hi[k]);
  return out;
}

GridBox turned_within(const GridBox& box, double degrees) {
  if (is_quarter(degrees)) return turned(box, degrees);
  const double c = std::abs(std::cos(radians_from_degrees(degrees))), s = std::abs(std::sin(radians_from_degrees(degrees)));
  const double length[2] = {double(box.extent(0)), double(box.extent(1))};
  const double longer = std::max(length[0], length[1]), shorter = std::min(length[0], length[1]);
  double half[2];
  if (shorter <= 2 * s * c * longer || std::abs(s - c) < 1e-9) {  // two corners at the longer sides
    const bool wide = length[0] >= length[1];
    half[0] = shorter / 4 / (wide ? s : c), half[1] = shorter / 4 / (wide ? c : s);
  } else {
    const double cos2 = c * c - s * s;
    half[0] = (length[0] * c - length[1] * s) / cos2 / 2, half[1] = (length[1] * c - length[0] * s) / cos2 / 2;
  }
  const double turn = radians_from_degrees(degrees);
  const double x = (double(box.lo[0]) + box.hi[0]) / 2, y = (double(box.lo[1]) + box.hi[1]) / 2;
  const double middle[2] = {std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y};
  GridBox out = box;
  for (int k = 0; k < 2; ++k) {
    out.lo[k] = rounded_up(middle[k] - half[k]), out.hi[k] = rounded_down(middle[k] + half[k]);
    if (out.hi[k] < out.lo[k]) out.hi[k] = out.lo[k];  // so thin that no whole millimetre is in it
  }
  return out;
}

Direction turned(Direction direction, int degrees) {
  for (int quarter = 0; quarter < degrees / 90; ++quarter) {
    direction = direction.axis == 0 ? Direction{1, direction.sign} : Direction{0, -direction.sign};
  }
  return direction;
}

bool is_rectilinear(std::span<const Point> polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    if (a.x != b.x && a.y != b.y) return false;
  }
  return true;
}

bool contains(std::span<const Point> polygon, double x, double y) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point &a = polygon[i], &b = polygon[j];
    if ((a.y > y) != (b.y > y) && x < (double(b.x) - a.x) * (y - a.y) / (double(b.y) - a.y) + a.x) inside = !inside;
  }
  return inside;
}

namespace {

// Does any edge of the polygon pass through the inside of the cell?
bool edge_crosses(std::span<const Point> polygon, double x0, double y0, double x1, double y1) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    double t0 = 0, t1 = 1;
    const double d[2] = {double(b.x) - a.x, double(b.y) - a.y};
    const double start[2] = {double(a.x), double(a.y)}, lo[2] = {x0, y0}, hi[2] = {x1, y1};
    bool misses = false;
    for (int k = 0; k < 2; ++k) {
      if (d[k] == 0) {
        misses |= start[k] <= lo[k] || start[k] >= hi[k];
        continue;
      }
      const double p = (lo[k] - start[k]) / d[k], q = (hi[k] - start[k]) / d[k];
      t0 = std::max(t0, std::min(p, q));
      t1 = std::min(t1, std::max(p, q));
    }
    if (!misses && t1 - t0 > 1e-9) return true;
  }
  return false;
}

std::vector<Mm> cuts_of(std::set<Mm> corners, Mm step, bool fine) {
  if (!fine) return {corners.begin(), corners.end()};
  std::set<Mm> all = corners;
  for (Mm at = *corners.begin(); at < *corners.rbegin(); at += step) all.insert(at);
  return {all.begin(), all.end()};
}

}  // namespace

std::vector<GridBox> outside_of(std::span<const Point> polygon, Mm z_lo, Mm z_hi, Mm step) {
  std::set<Mm> corner_x, corner_y;
  for (const Point& p : polygon) corner_x.insert(p.x), corner_y.insert(p.y);
  const bool fine = !is_rectilinear(polygon);
  const std::vector<Mm> xs = cuts_of(corner_x, step, fine), ys = cuts_of(corner_y, step, fine);
  std::vector<GridBox> boxes;
  for (std::size_t j = 0; j + 1 < ys.size(); ++j) {
    for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
      const bool inside = contains(polygon, (xs[i] + xs[i + 1]) / 2.0, (ys[j] + ys[j + 1]) / 2.0) &&
                          !(fine && edge_crosses(polygon, xs[i], ys[j], xs[i + 1], ys[j + 1]));
      if (inside) continue;
      const bool grows = !boxes.empty() && boxes.back().hi[0] == xs[i] && boxes.back().lo[1] == ys[j];
      if (grows) {
        boxes.back().hi[0] = xs[i + 1];
      } else {
        boxes.push_back({{xs[i], ys[j], z_lo}, {xs[i + 1], ys[j + 1], z_hi}});
      }
    }
  }
  return boxes;
}

std::vector<GridBox> wholly_outside_of(std::span<const Point> polygon, Mm z_lo, Mm z_hi) {
  std::set<Mm> xs, ys;
  for (const Point& p : polygon) xs.insert(p.x), ys.insert(p.y);
  std::vector<GridBox> boxes;
  for (auto y = ys.begin(); std::next(y) != ys.end(); ++y) {
    for (auto x = xs.begin(); std::next(x) != xs.end(); ++x) {
      const Mm x1 = *std::next(x), y1 = *std::next(y);
      if (edge_crosses(polygon, *x, *y, x1, y1) || contains(polygon, (*x + x1) / 2.0, (*y + y1) / 2.0)) continue;
      boxes.push_back({{*x, *y, z_lo}, {x1, y1, z_hi}});
    }
  }
  return boxes;
}

}  // namespace layoutbox::placement
