// How far things are from each other and from the parts of the room.
#include <algorithm>
#include <cmath>

#include "layoutbox/plan/edit/world.h"

namespace layoutbox::edit {
namespace {

using namespace offline;

double to_segment(double x, double y, const Point& a, const Point& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double t = square > 0 ? std::clamp(((x - a.x) * dx + (y - a.y) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(x - a.x - t * dx, y - a.y - t * dy);
}

}  // namespace

double World::distance(int a, int b) const {
  const PlacedObject *first = thing(a).placed, *second = thing(b).placed;
  if (first == nullptr || second == nullptr || a == b) return kUnknown;
  return std::hypot(first->position[0] - second->position[0], first->position[1] - second->position[1]);
}

double World::distance(int index, const NounPhrase& place) const {
  const PlacedObject* placed = thing(index).placed;
  if (placed == nullptr) return kUnknown;
  const double x = placed->position[0], y = placed->position[1];
  double best = kUnknown;
  const std::vector<Point>& corners = layout_->room.polygon;
  switch (place.kind) {
    case NounKind::kWindow:
    case NounKind::kDoor:
      for (const Opening* opening : openings_of(place)) {
        if (const auto center = center_of(*layout_, *opening)) best = std::min(best, std::hypot(x - (*center)[0], y - (*center)[1]));
      }
      return best;
    case NounKind::kWall:
      for (const Wall& wall : layout_->room.walls) {
        if (!place.wall_word.empty() && layout_->find_wall(place.wall_word) != &wall) continue;
        best = std::min(best, to_segment(x, y, wall.start, wall.end));
      }
      return best;
    case NounKind::kCorner:
      for (const Point& corner : corners) best = std::min(best, std::hypot(x - corner.x, y - corner.y));
      return best;
    case NounKind::kCenter: {
      double sum_x = 0, sum_y = 0;
      for (const Point& corner : corners) sum_x += corner.x, sum_y += corner.y;
      const auto count = static_cast<double>(std::max<std::size_t>(corners.size(), 1));
      return std::hypot(x - sum_x / count, y - sum_y / count);
    }
    default: return kUnknown;
  }
}

const Wall* World::wall_of(int index) const {
  const PlacedObject* placed = thing(index).placed;
  const Wall* nearest = nullptr;
  double best = kUnknown;
  if (placed == nullptr) return nullptr;
  for (const Wall& wall : layout_->room.walls) {
    const double far = to_segment(placed->position[0], placed->position[1], wall.start, wall.end);
    if (far < best) best = far, nearest = &wall;
  }
  return nearest;
}

std::string World::other_corner(int index, const NounPhrase& corner) const {
  const auto says = [&](std::string_view word) {
    return std::find(corner.attributes.begin(), corner.attributes.end(), word) != corner.attributes.end();
  };
  const bool opposite = says("opposite") || corner.wall_relation == "opposite";
  const bool other =
      corner.determiner == Determiner::kAnother || corner.determiner == Determiner::kOther || says("other") || says("different");
  const PlacedObject* placed = thing(index).placed;
  if (placed == nullptr || (!other && !opposite)) return {};
  Point least = layout_->room.polygon.front(), most = least;
  for (const Point& point : layout_->room.polygon) {
    least = {std::min(least.x, point.x), std::min(least.y, point.y)};
    most = {std::max(most.x, point.x), std::max(most.y, point.y)};
  }
  struct Corner {
    const char* word;
    Point at;
  };
  const Corner corners[] = {
      {"front left", least}, {"front right", {most.x, least.y}}, {"back left", {least.x, most.y}}, {"back right", most}};
  const auto far = [](const PlacedObject& object, const Point& at) {
    return std::hypot(object.position[0] - at.x, object.position[1] - at.y);
  };
  const Corner* own = &corners[0];
  for (const Corner& one : corners) {
    if (far(*placed, one.at) < far(*placed, own->at)) own = &one;
  }
  // Of the others the one that has most room, or the one across.
  const Corner* best = nullptr;
  double most_room = -1;
  for (const Corner& one : corners) {
    if (&one == own) continue;
    double room = opposite ? far(*placed, one.at) : kUnknown;
    for (const PlacedObject& object : layout_->objects) {
      if (!opposite && &object != placed && object.supported_by == "floor") room = std::min(room, far(object, one.at));
    }
    for (const Opening& opening : layout_->room.openings) {  // not behind a door
      const auto center = opening.type == OpeningType::kWindow || opposite ? std::nullopt : center_of(*layout_, opening);
      if (center) room = std::min(room, std::hypot((*center)[0] - one.at.x, (*center)[1] - one.at.y));
    }
    if (room > most_room) most_room = room, best = &one;
  }
  return best->word;
}

}  // namespace layoutbox::edit
