// A judge of layouts that shares nothing with the solver: bodies as clouds of points, in metres.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "layoutbox/scene/layout.h"
#include "layoutbox/solve/solver.h"

namespace layoutbox::placement {

struct TestPoint {
  double x, y, z;
};

// The point of the room in the object's own frame (origin under the middle of the footprint).
inline TestPoint in_frame_of(const PlacedObject& o, const TestPoint& p) {
  const double a = -o.rotation_deg * kPi / 180, dx = p.x - o.position[0], dy = p.y - o.position[1];
  return {dx * std::cos(a) - dy * std::sin(a), dx * std::sin(a) + dy * std::cos(a), p.z - o.position[2]};
}

inline bool in_body(const PlacedObject& o, const TestPoint& room_point) {
  const TestPoint p = in_frame_of(o, room_point);
  const double slack = 5;  // mm
  if (std::abs(p.x) > o.size.width / 2.0 - slack || std::abs(p.y) > o.size.depth / 2.0 - slack || p.z < slack ||
      p.z > o.size.height - slack)
    return false;
  for (const Space& s : o.spaces) {
    if (p.x > s.min[0] - slack && p.x < s.max[0] + slack && p.y > s.min[1] - slack && p.y < s.max[1] + slack && p.z > s.min[2] - slack &&
        p.z < s.max[2] + slack) {
      return false;
    }
  }
  return true;
}

inline std::vector<TestPoint> points_of(const PlacedObject& o, int n = 14) {
  std::vector<TestPoint> points;
  const double a = o.rotation_deg * kPi / 180;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) {
        const double x = ((i + 0.5) / n - 0.5) * o.size.width, y = ((j + 0.5) / n - 0.5) * o.size.depth, z = (k + 0.5) / n * o.size.height;
        points.push_back(
            {o.position[0] + x * std::cos(a) - y * std::sin(a), o.position[1] + x * std::sin(a) + y * std::cos(a), o.position[2] + z});
      }
    }
  }
  return points;
}

inline bool is_rug(const PlacedObject& o) { return o.size.height <= 30 && o.supported_by == "floor"; }

inline bool bodies_meet(const PlacedObject& a, const PlacedObject& b) {
  if (is_rug(a) || is_rug(b)) return false;
  for (const PlacedObject* o : {&a, &b}) {
    for (const TestPoint& p : points_of(*o)) {
      if (in_body(a, p) && in_body(b, p)) return true;
    }
  }
  return false;
}

inline void expect_sound(const Layout& layout) {
  double w = 0, d = 0;
  for (const Point& p : layout.room.polygon) w = std::max<double>(w, p.x), d = std::max<double>(d, p.y);
  for (std::size_t i = 0; i < layout.objects.size(); ++i) {
    const PlacedObject& o = layout.objects[i];
    for (const TestPoint& p : points_of(o, 4)) {
      EXPECT_TRUE(p.x > -1 && p.y > -1 && p.x < w + 1 && p.y < d + 1 && p.z > -1 && p.z < layout.room.height + 1) << o.id << " is outside";
    }
    for (std::size_t j = i + 1; j < layout.objects.size(); ++j) {
      EXPECT_FALSE(bodies_meet(o, layout.objects[j])) << o.id << " meets " << layout.objects[j].id;
    }
    if (o.supported_by == "floor") {
      EXPECT_EQ(o.position[2], 0) << o.id;
    } else if (const PlacedObject* host = layout.find_object(o.supported_by); host && o.mount == Mount::kSurface) {
      bool rests = std::abs(o.position[2] - host->position[2] - host->size.height) < 1.5;
      for (const Space& s : host->spaces) rests = rests || std::abs(o.position[2] - host->position[2] - s.min[2]) < 1.5;
      EXPECT_TRUE(rests) << o.id << " floats over " << host->id;
    }
  }
}

// The scene by the built-in catalogue, sound.
inline Layout solved_soundly(const SceneGraph& scene, SolveOptions options = {}) {
  auto layout = solve(scene, Catalog::builtin(), options);
  EXPECT_TRUE(layout) << (layout ? "" : layout.error().message);
  if (!layout) return {};
  expect_sound(*layout);
  return *layout;
}

// … and as it was asked for.
inline Layout solved_as_asked(const SceneGraph& scene) {
  Layout layout = solved_soundly(scene);
  EXPECT_EQ(layout.status, LayoutStatus::kSolved);
  return layout;
}

inline const PlacedObject& object(const Layout& layout, const std::string& id) {
  const PlacedObject* found = layout.find_object(id);
  if (!found) throw std::runtime_error(id + " is not there");
  return *found;
}

// Along the host's own axes, from its middle: x to its right, y to its back.
inline Point seen_from(const PlacedObject& host, const PlacedObject& other) {
  const double a = host.rotation_deg * 3.14159265358979 / 180, x = other.position[0] - host.position[0],
               y = other.position[1] - host.position[1];
  return {static_cast<Mm>(std::lround(std::cos(a) * x + std::sin(a) * y)),
          static_cast<Mm>(std::lround(-std::sin(a) * x + std::cos(a) * y))};
}

inline double turned(const Layout& layout, const std::string& a, const std::string& b) {
  return std::abs(std::remainder(object(layout, a).rotation_deg - object(layout, b).rotation_deg, 360));
}

inline double between_middles(const Layout& layout, const std::string& a, const std::string& b) {
  const PlacedObject *one = layout.find_object(a), *other = layout.find_object(b);
  return std::hypot(one->position[0] - other->position[0], one->position[1] - other->position[1]);
}

inline bool holds(const Layout& layout, const std::string& relation) {
  for (const PlacedRelation& r : layout.relations) {
    if (r.relation.id == relation) return r.held;
  }
  ADD_FAILURE() << "no relation " << relation;
  return false;
}

}  // namespace layoutbox::placement
