// For tests: layouts written in metres, and the same layout turned by quarter turns or mirrored.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "layoutbox/verify/verify.h"

namespace layoutbox::judge {

struct Place {
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
  TestRoom& add(const std::string& id, const std::string& category, std::array<double, 3> size, Place place,
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

inline std::string swapped_words(std::string text, const std::vector<std::pair<std::string, std::string>>& changes) {
  for (const auto& [from, to] : changes) {
    if (const std::size_t at = text.find(from); at != std::string::npos) return text.replace(at, from.size(), to);
  }
  return text;
}

// The whole room turned counter-clockwise by 90°: what was along x is along y.
inline Layout quarter_turned(Layout layout) {
  const Mm depth = depth_of(layout);
  const auto turn = [depth](Point p) { return Point{depth - p.y, p.x}; };
  for (Point& p : layout.room.polygon) p = turn(p);
  // The corner at the origin comes first again.
  std::rotate(layout.room.polygon.begin(), layout.room.polygon.end() - 1, layout.room.polygon.end());
  for (Wall& wall : layout.room.walls) wall.start = turn(wall.start), wall.end = turn(wall.end);
  for (PlacedObject& object : layout.objects) {
    object.position = {depth - object.position[1], object.position[0], object.position[2]};
    object.rotation_deg = normalized_degrees(object.rotation_deg + 90);
  }
  for (PlacedRelation& placed : layout.relations) {
    RelationParameters& p = placed.relation.parameters;
    if (p.axis && placed.relation.type != RelationType::kEachSideOf && placed.relation.type != RelationType::kSymmetricAbout) {
      p.axis = *p.axis == Axis::kX ? Axis::kY : *p.axis == Axis::kY ? Axis::kX : Axis::kZ;
    }
    p.region = swapped_words(p.region, {{"left", "front"}, {"front", "right"}, {"right", "back"}, {"back", "left"}});
  }
  return layout;
}

// The room as a mirror at its left wall shows it: left and right change places, for the room and for every object.
inline Layout mirrored(Layout layout) {
  const Mm width = width_of(layout);
  const auto mirror = [width](Point p) { return Point{width - p.x, p.y}; };
  std::vector<Point>& polygon = layout.room.polygon;
  for (Point& p : polygon) p = mirror(p);
  std::reverse(polygon.begin(), polygon.end());
  for (Opening& opening : layout.room.openings) {
    const Wall* wall = layout.find_wall(opening.wall);
    const double length = std::hypot(wall->end.x - wall->start.x, wall->end.y - wall->start.y);
    opening.offset = static_cast<Mm>(length) - *opening.offset - opening.width;
    opening.swing = opening.swing == Swing::kInLeft ? Swing::kInRight : opening.swing == Swing::kInRight ? Swing::kInLeft : opening.swing;
  }
  for (Wall& wall : layout.room.walls) {
    const Point start = wall.start;
    wall.start = mirror(wall.end), wall.end = mirror(start);
  }
  const auto other_side = [](Side side) { return side == Side::kLeft ? Side::kRight : side == Side::kRight ? Side::kLeft : side; };
  for (PlacedObject& object : layout.objects) {
    object.position[0] = width - object.position[0];
    object.rotation_deg = normalized_degrees(-object.rotation_deg);
    for (Space& space : object.spaces) space.min[0] = std::exchange(space.max[0], -space.min[0]) * -1;
    for (Side& side : object.used_sides) side = other_side(side);
  }
  const std::vector<std::pair<std::string, std::string>> words{{"left", "right"}, {"right", "left"}, {"min", "max"}, {"max", "min"}};
  for (PlacedRelation& placed : layout.relations) {
    Relation& relation = placed.relation;
    RelationParameters& p = relation.parameters;
    if (p.side) p.side = other_side(*p.side);
    p.part = swapped_words(p.part, words), p.edge = swapped_words(p.edge, words), p.region = swapped_words(p.region, words);
    if (relation.type == RelationType::kLeftOf || relation.type == RelationType::kRightOf) {
      relation.type = relation.type == RelationType::kLeftOf ? RelationType::kRightOf : RelationType::kLeftOf;
    }
  }
  return layout;
}

}  // namespace layoutbox::judge
