// For tests: a scene or a layout in the same room turned by a quarter, mirrored, or shifted. What was held is held.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "layoutbox/scene/layout.h"

namespace layoutbox::turned {

using Words = std::vector<std::pair<std::string, std::string>>;

// Every word that is one of the first is replaced by its second.
inline std::string swapped_words(const std::string& text, const Words& changes) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const auto change =
        std::find_if(changes.begin(), changes.end(), [&](const auto& c) { return text.compare(at, c.first.size(), c.first) == 0; });
    if (change == changes.end()) {
      out += text[at++];
    } else {
      out += change->second;
      at += change->first.size();
    }
  }
  return out;
}

inline void swap_words(std::optional<Edge>& edge, const Words& changes) {
  if (edge) edge = edge_from_words(swapped_words(std::string(name_of(*edge)), changes));
}
inline void swap_words(std::optional<RoomRegion>& region, const Words& changes) {
  if (region) region = region_from_words(swapped_words(std::string(name_of(*region)), changes));
}

inline Side other_side(Side side) { return side == Side::kLeft ? Side::kRight : side == Side::kRight ? Side::kLeft : side; }

// Left and right of the room's own axes, where a relation speaks of those and not of the frame of an object.
inline bool speaks_of_room_edges(RelationType type) { return type == RelationType::kAlign || type == RelationType::kGroupAlign; }
inline bool speaks_of_own_axes(RelationType type) { return type == RelationType::kEachSideOf || type == RelationType::kSymmetricAbout; }

// Turned counter-clockwise by 90°: what was along x is along y.
inline void turn(Relation& relation) {
  static const Words kQuarter{{"left", "front"}, {"front", "right"}, {"right", "back"}, {"back", "left"}};
  RelationParameters& p = relation.parameters;
  if (relation.type == RelationType::kColumn) {  // along y, and so along x
    relation.type = RelationType::kRow, p.axis = Axis::kX;
  } else if (p.axis && !speaks_of_own_axes(relation.type)) {
    // The lesser y becomes the greater x.
    if (*p.axis == Axis::kY) swap_words(p.edge, {{"min", "max"}, {"max", "min"}});
    p.axis = *p.axis == Axis::kX ? Axis::kY : *p.axis == Axis::kY ? Axis::kX : Axis::kZ;
  }
  swap_words(p.region, kQuarter);
  if (speaks_of_room_edges(relation.type)) swap_words(p.edge, kQuarter);
  if (relation.type == RelationType::kGrid) {
    const int n = static_cast<int>(relation.targets.size());
    const int columns = p.columns.value_or(static_cast<int>(std::ceil(std::sqrt(n))));
    p.columns = (n + columns - 1) / columns;
  }
}

inline void mirror(Relation& relation) {
  static const Words kMirror{{"left", "right"}, {"right", "left"}};
  RelationParameters& p = relation.parameters;
  if (p.side) p.side = other_side(*p.side);
  p.part = ThingPart(swapped_words(p.part.text(), kMirror));
  swap_words(p.edge, kMirror);
  swap_words(p.region, kMirror);
  if (p.axis == Axis::kX) swap_words(p.edge, {{"min", "max"}, {"max", "min"}});
  if (relation.type == RelationType::kLeftOf || relation.type == RelationType::kRightOf) {
    relation.type = relation.type == RelationType::kLeftOf ? RelationType::kRightOf : RelationType::kLeftOf;
  }
}

// The polygon begins at its front left corner again.
inline void begin_at_the_origin(Room& room) {
  std::vector<Point>& polygon = room.polygon;
  if (polygon.empty()) return;
  const auto first = std::min_element(polygon.begin(), polygon.end(), [](Point a, Point b) { return a.x + a.y < b.x + b.y; });
  const auto by = first - polygon.begin();
  std::rotate(polygon.begin(), first, polygon.end());
  if (room.walls.size() == polygon.size()) std::rotate(room.walls.begin(), room.walls.begin() + by, room.walls.end());
}

inline Mm greatest(const Room& room, Mm Point::*coordinate) {
  Mm most = 0;
  for (const Point p : room.polygon) most = std::max(most, p.*coordinate);
  return most;
}

// Walls keep their ids, and the openings their places in them.
inline void turn(Room& room) {
  const Mm depth = greatest(room, &Point::y);
  const auto turned = [depth](Point p) { return Point{depth - p.y, p.x}; };
  for (Point& p : room.polygon) p = turned(p);
  for (Wall& wall : room.walls) wall.start = turned(wall.start), wall.end = turned(wall.end);
  begin_at_the_origin(room);
}

// As a mirror at its left wall shows it: left and right change places, for the room and for every object.
inline void mirror(Room& room) {
  const Mm width = greatest(room, &Point::x);
  const auto mirrored = [width](Point p) { return Point{width - p.x, p.y}; };
  for (Opening& opening : room.openings) {
    const auto wall = std::find_if(room.walls.begin(), room.walls.end(), [&](const Wall& w) { return w.id == opening.wall; });
    if (wall != room.walls.end() && opening.offset) {
      const double length = std::hypot(wall->end.x - wall->start.x, wall->end.y - wall->start.y);
      opening.offset = static_cast<Mm>(length) - *opening.offset - opening.width;
    }
    const auto swing = [&](Swing a, Swing b) { return opening.swing == a ? b : opening.swing == b ? a : opening.swing; };
    opening.swing = swing(Swing::kInLeft, Swing::kInRight);
    opening.swing = swing(Swing::kOutLeft, Swing::kOutRight);
  }
  for (Point& p : room.polygon) p = mirrored(p);
  for (Wall& wall : room.walls) {
    const Point start = wall.start;
    wall.start = mirrored(wall.end), wall.end = mirrored(start);
  }
  // The edges run the other way round, each in its place.
  std::reverse(room.polygon.begin(), room.polygon.end());
  std::rotate(room.polygon.begin(), room.polygon.end() - 1, room.polygon.end());
  std::reverse(room.walls.begin(), room.walls.end());
  begin_at_the_origin(room);
}

inline void shift(Room& room, Mm dx, Mm dy) {
  for (Point& p : room.polygon) p.x += dx, p.y += dy;
  for (Wall& wall : room.walls) wall.start.x += dx, wall.start.y += dy, wall.end.x += dx, wall.end.y += dy;
}

inline void mirror_spaces(std::vector<Space>& spaces) {
  for (Space& space : spaces) space.min[0] = std::exchange(space.max[0], -space.min[0]) * -1;
}

}  // namespace layoutbox::turned

namespace layoutbox {

inline Layout quarter_turned(Layout layout) {
  const Mm depth = turned::greatest(layout.room, &Point::y);
  turned::turn(layout.room);
  for (PlacedObject& object : layout.objects) {
    object.position = {depth - object.position[1], object.position[0], object.position[2]};
    object.rotation_deg = normalized_degrees(object.rotation_deg + 90);
  }
  for (PlacedRelation& placed : layout.relations) turned::turn(placed.relation);
  return layout;
}

inline Layout mirrored(Layout layout) {
  const Mm width = turned::greatest(layout.room, &Point::x);
  turned::mirror(layout.room);
  for (PlacedObject& object : layout.objects) {
    object.position[0] = width - object.position[0];
    object.rotation_deg = normalized_degrees(-object.rotation_deg);
    turned::mirror_spaces(object.spaces);
    for (Side& side : object.used_sides) side = turned::other_side(side);
  }
  for (PlacedRelation& placed : layout.relations) turned::mirror(placed.relation);
  return layout;
}

// REQUIRES of the following: a scene with its walls (normalised).
inline SceneGraph quarter_turned(SceneGraph scene) {
  const Mm depth = turned::greatest(scene.room, &Point::y);
  turned::turn(scene.room);
  for (SceneObject& object : scene.objects) {
    if (auto& at = object.hint.position) at = {depth - (*at)[1], (*at)[0], (*at)[2]};
    if (auto& turn = object.hint.rotation_deg) turn = normalized_degrees(*turn + 90);
  }
  for (Relation& relation : scene.relations) turned::turn(relation);
  return scene;
}

// Furniture whose spaces are the catalogue's stays as it is: an L of a sofa keeps its hand.
inline SceneGraph mirrored(SceneGraph scene) {
  const Mm width = turned::greatest(scene.room, &Point::x);
  turned::mirror(scene.room);
  for (SceneObject& object : scene.objects) {
    if (auto& at = object.hint.position) (*at)[0] = width - (*at)[0];
    if (auto& turn = object.hint.rotation_deg) turn = normalized_degrees(-*turn);
    turned::mirror_spaces(object.spaces);
    if (object.used_sides) {
      for (Side& side : *object.used_sides) side = turned::other_side(side);
    }
  }
  for (Relation& relation : scene.relations) turned::mirror(relation);
  return scene;
}

inline SceneGraph shifted(SceneGraph scene, Mm dx, Mm dy) {
  turned::shift(scene.room, dx, dy);
  for (SceneObject& object : scene.objects) {
    if (auto& at = object.hint.position) (*at)[0] += dx, (*at)[1] += dy;
  }
  return scene;
}

}  // namespace layoutbox
