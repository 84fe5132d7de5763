// For tests: layouts written in metres, and the same layout turned by quarter turns or mirrored.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "layoutbox/scene/test_turned.h"
#include "layoutbox/verify/verify.h"

namespace layoutbox::checks {

struct TestPlace {
  double x = 0, y = 0, z = 0, rotation = 0;
};

// A rectangular room with wall1 front, wall2 right, wall3 back, wall4 left; 5.0 × 4.0 × 2.6 m unless said otherwise.
class TestRoom {
 public:
  explicit TestRoom(double w = 5, double d = 4, double h = 2.6) {
    layout.room.height = mm_from_m(h);
    layout.room.polygon = {point(0, 0), point(w, 0), point(w, d), point(0, d)};
    for (std::size_t i = 0; i < 4; ++i) {
      Wall wall;
      wall.id = "wall" + std::to_string(i + 1);
      wall.start = layout.room.polygon[i];
      wall.end = layout.room.polygon[(i + 1) % 4];
      layout.room.walls.push_back(wall);
    }
  }

  TestRoom& door(const std::string& id, const std::string& wall, double offset, double width = 0.9, Swing swing = Swing::kInLeft) {
    return opening(id, OpeningType::kDoor, wall, offset, width, 2.0, 0, swing);
  }
  TestRoom& window(const std::string& id, const std::string& wall, double offset, double width = 1.2, double sill = 0.9) {
    return opening(id, OpeningType::kWindow, wall, offset, width, 1.2, sill, Swing::kNone);
  }

  // Size in metres, width × depth × height. Stands on the floor unless `on` says otherwise.
  TestRoom& add(const std::string& id, const std::string& category, std::array<double, 3> size, TestPlace place,
                const std::string& on = "floor", Mount mount = Mount::kFloor) {
    PlacedObject object;
    object.id = id;
    object.category = category;
    object.size = {mm_from_m(size[0]), mm_from_m(size[1]), mm_from_m(size[2])};
    object.position = {place.x * 1000, place.y * 1000, place.z * 1000};
    object.rotation_deg = place.rotation;
    object.supported_by = on;
    object.mount = on == "ceiling"                           ? Mount::kCeiling
                   : on.starts_with("wall")                  ? Mount::kWall
                   : on != "floor" && mount == Mount::kFloor ? Mount::kSurface
                                                             : mount;
    layout.objects.push_back(object);
    return *this;
  }

  // A free box in the last object, in metres.
  TestRoom& space(const std::string& name, std::array<double, 3> min, std::array<double, 3> max, bool carries = true) {
    Space space{name, min, max, carries};
    for (double& value : space.min) value *= 1000;
    for (double& value : space.max) value *= 1000;
    layout.objects.back().spaces.push_back(space);
    return *this;
  }
  TestRoom& used(std::vector<Side> sides) {
    layout.objects.back().used_sides = std::move(sides);
    return *this;
  }

  TestRoom& relation(RelationType type, std::vector<std::string> targets, std::vector<std::string> references = {},
                     RelationParameters parameters = {}, bool hard = true) {
    PlacedRelation placed;
    placed.relation.id = "c" + std::to_string(layout.relations.size() + 1);
    placed.relation.type = type;
    placed.relation.targets = std::move(targets);
    placed.relation.references = std::move(references);
    placed.relation.parameters = std::move(parameters);
    placed.relation.hard = hard;
    placed.held = true;
    layout.relations.push_back(placed);
    return *this;
  }

  PlacedObject& object(const std::string& id) {
    return *std::find_if(layout.objects.begin(), layout.objects.end(), [&](const PlacedObject& object) { return object.id == id; });
  }

  Report judge() const { return verify(layout, Catalog::builtin()); }

  Layout layout;

 private:
  static Point point(double x, double y) { return {mm_from_m(x), mm_from_m(y)}; }

  TestRoom& opening(const std::string& id, OpeningType type, const std::string& wall, double offset, double width, double height,
                    double sill, Swing swing) {
    Opening hole;
    hole.id = id;
    hole.type = type;
    hole.wall = wall;
    hole.offset = mm_from_m(offset);
    hole.width = mm_from_m(width);
    hole.height = mm_from_m(height);
    hole.sill = mm_from_m(sill);
    hole.swing = swing;
    layout.room.openings.push_back(hole);
    return *this;
  }
};

// The first check of that name about that subject; null when there is none.
inline const Check* find_check(const Report& report, std::string_view name, std::string_view subject = {}) {
  for (const Check& check : report.checks) {
    if (check.name == name && (subject.empty() || check.subject == subject)) return &check;
  }
  return nullptr;
}

inline bool passes(const Report& report, std::string_view name, std::string_view subject = {}) {
  const Check* check = find_check(report, name, subject);
  return check != nullptr && check->passed;
}

inline Mm depth_of(const Layout& layout) { return layout.room.polygon[2].y; }
inline Mm width_of(const Layout& layout) { return layout.room.polygon[1].x; }

}  // namespace layoutbox::checks
