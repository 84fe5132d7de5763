#include "layoutbox/scene/shell.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace layoutbox {
namespace {

std::string metres(double millimetres) { return fmt::format("{:.5g} m", millimetres / 1000); }
std::string text_of(Point p) { return fmt::format("({:g}, {:g})", p.x / 1000.0, p.y / 1000.0); }

double distance(Point a, Point b) { return std::hypot(double(a.x) - b.x, double(a.y) - b.y); }

std::int64_t cross(Point a, Point b, Point c) {
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) - (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

int sign(std::int64_t value) { return (value > 0) - (value < 0); }

bool between(Point a, Point b, Point p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

bool segments_meet(Point a, Point b, Point c, Point d) {
  const int s1 = sign(cross(a, b, c)), s2 = sign(cross(a, b, d)), s3 = sign(cross(c, d, a)), s4 = sign(cross(c, d, b));
  if (s1 != s2 && s3 != s4) return true;
  return (s1 == 0 && between(a, b, c)) || (s2 == 0 && between(a, b, d)) || (s3 == 0 && between(c, d, a)) || (s4 == 0 && between(c, d, b));
}

// The first pair of edges that share more than the corner between neighbours.
std::optional<std::pair<std::size_t, std::size_t>> crossing_edges(const std::vector<Point>& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = p[i], b = p[(i + 1) % n];
    if (const Point c = p[(i + 2) % n]; cross(a, b, c) == 0 && (between(a, b, c) || between(b, c, a))) return std::pair(i, (i + 1) % n);
    for (std::size_t j = i + 2; j < n; ++j) {
      if ((j + 1) % n != i && segments_meet(a, b, p[j], p[(j + 1) % n])) return std::pair(i, j);
    }
  }
  return std::nullopt;
}

std::size_t first_corner(const std::vector<Point>& polygon) {
  const auto nearer = [](Point a, Point b) { return a.y != b.y ? a.y < b.y : a.x < b.x; };
  return static_cast<std::size_t>(std::min_element(polygon.begin(), polygon.end(), nearer) - polygon.begin());
}

void turn(Wall& wall, std::vector<Opening>& openings) {
  std::swap(wall.start, wall.end);
  for (Opening& opening : openings) {
    if (same_name(opening.wall, wall.id) && opening.offset) opening.offset = length_of(wall) - *opening.offset - opening.width;
  }
}

std::vector<Point> corners_of(const std::vector<Wall>& walls) {
  std::vector<Point> corners;
  for (const Wall& wall : walls) corners.push_back(wall.start);
  return corners;
}

// The nearest end of walls[from…] to `corner`: its wall and how far it is.
struct NearestEnd {
  std::size_t wall = 0;
  double distance = std::numeric_limits<double>::infinity();
  bool at_start = true;
};
NearestEnd nearest_end(const std::vector<Wall>& walls, std::size_t from, Point corner) {
  NearestEnd best;
  for (std::size_t i = from; i < walls.size(); ++i) {
    if (const double d = distance(corner, walls[i].start); d < best.distance) best = {i, d, true};
    if (const double d = distance(corner, walls[i].end); d < best.distance) best = {i, d, false};
  }
  return best;
}

Failure collected(std::vector<Error> errors) {
  Error all = errors.front();
  if (errors.size() > 1) all.details = std::move(errors);
  return Failure(std::move(all));
}

}  // namespace

Mm length_of(const Wall& wall) { return static_cast<Mm>(std::lround(distance(wall.start, wall.end))); }

std::int64_t doubled_area(const std::vector<Point>& polygon) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    sum += std::int64_t{a.x} * b.y - std::int64_t{b.x} * a.y;
  }
  return sum;
}

Result<std::vector<Point>> tidy_polygon(std::vector<Point> polygon, std::string_view pointer) {
  const std::string where(pointer);
  if (polygon.size() > 1 && polygon.front() == polygon.back()) polygon.pop_back();
  polygon.erase(std::unique(polygon.begin(), polygon.end()), polygon.end());
  if (polygon.size() < 3) {
    return fail(ErrorCode::kGeometry, fmt::format("the room's outline has {} different corners", polygon.size()), where,
                "give at least three corners, in order round the room");
  }
  if (const auto edges = crossing_edges(polygon)) {
    const auto [i, j] = *edges;
    const std::size_t n = polygon.size();
    return fail(ErrorCode::kGeometry,
                fmt::format("the room's outline crosses or touches itself: the edge {} to {} and the edge {} to {}", text_of(polygon[i]),
                            text_of(polygon[(i + 1) % n]), text_of(polygon[j]), text_of(polygon[(j + 1) % n])),
                where, "list the corners in order round the room");
  }
  if (doubled_area(polygon) < 0) std::reverse(polygon.begin(), polygon.end());
  std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(first_corner(polygon)), polygon.end());
  return polygon;
}

Result<std::vector<Wall>> walls_in_ring(std::vector<Wall> walls, std::vector<Opening>& openings) {
  std::vector<Error> errors;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    if (length_of(walls[i]) <= kCornerToleranceMm) {
      errors.push_back({ErrorCode::kGeometry,
                        fmt::format("wall \"{}\" has no length: it starts and ends at {}", walls[i].id, text_of(walls[i].start)),
                        fmt::format("/room/walls/{}", i),
                        "give its start and end, two corners of the room",
                        {}});
    }
  }
  if (!errors.empty()) return collected(std::move(errors));
  if (walls.size() < 3) {
    return fail(ErrorCode::kGeometry, fmt::format("{} walls do not enclose a room", walls.size()), "/room/walls",
                "list all walls, or none and give dims or polygon");
  }

  std::vector<std::size_t> place(walls.size());  // where a wall stood in the file
  for (std::size_t i = 0; i < place.size(); ++i) place[i] = i;
  const auto gap_error = [&](const Wall& from, Point corner, const Wall& to, double gap, std::size_t index) {
    errors.push_back({ErrorCode::kGeometry,
                      fmt::format("wall \"{}\" ends at {} and meets no other wall; the nearest, \"{}\", is {} away", from.id,
                                  text_of(corner), to.id, metres(gap)),
                      fmt::format("/room/walls/{}", index),
                      "let each wall end where the next one starts",
                      {}});
  };
  const auto swap_walls = [&](std::size_t a, std::size_t b) {
    std::swap(walls[a], walls[b]);
    std::swap(place[a], place[b]);
  };
  std::vector<Opening> turned = openings;
  for (std::size_t i = 0; i + 1 < walls.size(); ++i) {
    const NearestEnd next = nearest_end(walls, i + 1, walls[i].end);
    if (next.distance > kCornerToleranceMm) gap_error(walls[i], walls[i].end, walls[next.wall], next.distance, place[i]);
    swap_walls(i + 1, next.wall);
    if (!next.at_start) turn(walls[i + 1], turned);
    if (next.distance <= kCornerToleranceMm) walls[i + 1].start = walls[i].end;
  }
  if (const double gap = distance(walls.back().end, walls.front().start); gap > kCornerToleranceMm) {
    gap_error(walls.back(), walls.back().end, walls.front(), gap, place.back());
  }
  if (!errors.empty()) return collected(std::move(errors));
  walls.back().end = walls.front().start;

  if (const auto edges = crossing_edges(corners_of(walls))) {
    const auto [i, j] = *edges;
    return fail(ErrorCode::kGeometry, fmt::format("the walls \"{}\" and \"{}\" cross or touch each other", walls[i].id, walls[j].id),
                fmt::format("/room/walls/{}", place[j]), "let walls meet at their ends only");
  }
  if (doubled_area(corners_of(walls)) < 0) {
    for (Wall& wall : walls) turn(wall, turned);
    std::reverse(walls.begin(), walls.end());
  }
  std::rotate(walls.begin(), walls.begin() + static_cast<std::ptrdiff_t>(first_corner(corners_of(walls))), walls.end());
  openings = std::move(turned);
  return walls;
}

bool complete_rectangle(Room& room) {
  if (room.walls.empty() || room.walls.size() >= 4) return false;
  Point low = room.walls.front().start, high = low;
  const auto include = [&](Point p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  };
  for (const Wall& wall : room.walls) {
    include(wall.start);
    include(wall.end);
  }
  for (const Point corner : room.polygon) include(corner);
  if (low.x == high.x || low.y == high.y || (!room.polygon.empty() && room.polygon.size() != 4)) return false;

  std::vector<Wall> sides = walls_along({low, {high.x, low.y}, high, {low.x, high.y}});
  const auto same_side = [](const Wall& a, const Wall& b) {
    const auto near = [](Point p, Point q) { return distance(p, q) <= kCornerToleranceMm; };
    return (near(a.start, b.start) && near(a.end, b.end)) || (near(a.start, b.end) && near(a.end, b.start));
  };
  std::vector<Wall> missing;
  for (Wall& side : sides) {
    if (std::none_of(room.walls.begin(), room.walls.end(), [&](const Wall& wall) { return same_side(wall, side); }))
      missing.push_back(side);
  }
  if (missing.size() + room.walls.size() != 4) return false;
  for (Wall& wall : missing) {
    while (std::any_of(room.walls.begin(), room.walls.end(), [&](const Wall& other) { return same_name(other.id, wall.id); }))
      wall.id += "_added";
    room.walls.push_back(std::move(wall));
  }
  return true;
}

std::vector<Wall> walls_along(const std::vector<Point>& polygon) {
  std::vector<Wall> walls;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    Wall wall;
    wall.id = fmt::format("wall{}", i + 1);
    wall.start = polygon[i];
    wall.end = polygon[(i + 1) % polygon.size()];
    walls.push_back(std::move(wall));
  }
  return walls;
}

std::vector<Error> check_openings(const Room& room) {
  std::vector<Error> errors;
  const auto add = [&](ErrorCode code, std::size_t index, std::string message, std::string hint) {
    errors.push_back({code, std::move(message), fmt::format("/room/openings/{}", index), std::move(hint), {}});
  };
  for (std::size_t i = 0; i < room.openings.size(); ++i) {
    const Opening& opening = room.openings[i];
    if (room.height > 0 && opening.sill + opening.height > room.height + kCornerToleranceMm) {
      add(ErrorCode::kGeometry, i,
          fmt::format("{} \"{}\" reaches up to {}, but the room is {} high", name_of(opening.type), opening.id,
                      metres(opening.sill + opening.height), metres(room.height)),
          "make it lower, or the room higher");
    }
    if (opening.wall.empty() || room.walls.empty()) continue;
    const auto same = std::find_if(room.walls.begin(), room.walls.end(), [&](const Wall& w) { return same_name(w.id, opening.wall); });
    const std::optional<Side> side = room_side_from_word(opening.wall);
    const Wall* wall = same != room.walls.end() ? &*same : side ? wall_on_side(room.walls, *side) : nullptr;
    if (wall == nullptr) {
      add(ErrorCode::kReference, i,
          fmt::format("{} \"{}\" is in the wall \"{}\", which the room does not have", name_of(opening.type), opening.id, opening.wall),
          fmt::format("name one of the room's walls, such as \"{}\"", room.walls.front().id));
      continue;
    }
    const Mm length = length_of(*wall);
    const Mm begin = opening.offset.value_or(0), end = begin + opening.width;
    if (begin < -kCornerToleranceMm || end > length + kCornerToleranceMm) {
      add(ErrorCode::kGeometry, i,
          fmt::format("{} \"{}\" spans {} to {} along wall \"{}\", which is {} long", name_of(opening.type), opening.id, metres(begin),
                      metres(end), wall->id, metres(length)),
          "offset is measured from the wall's start to the opening's nearer edge; change the offset or the width");
      continue;
    }
    for (std::size_t j = 0; j < i; ++j) {
      const Opening& other = room.openings[j];
      if (!opening.offset || !other.offset || !same_name(other.wall, opening.wall)) continue;
      const bool apart_along = *other.offset >= end || *other.offset + other.width <= begin;
      const bool apart_in_height = other.sill >= opening.sill + opening.height || opening.sill >= other.sill + other.height;
      if (!apart_along && !apart_in_height) {
        add(ErrorCode::kGeometry, i, fmt::format("the openings \"{}\" and \"{}\" overlap in wall \"{}\"", other.id, opening.id, wall->id),
            "move one of them along the wall");
      }
    }
  }
  return errors;
}

}  // namespace layoutbox
