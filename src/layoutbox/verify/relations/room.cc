// Relations of an object and the room: walls, corners, the middle, regions, the ceiling.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "layoutbox/verify/checks.h"
#include "layoutbox/verify/relation_check.h"

namespace layoutbox::checks {
namespace {

constexpr double kMounted = 0.01;  // m: what hangs on a wall or ceiling is at most that far off

std::vector<Side> back_of(const Body& body) {
  if (!body.has_front) return {Side::kFront, Side::kBack, Side::kLeft, Side::kRight};
  return {Side::kBack};
}

double wall_gap(const RelationCase& c) { return c.metres(&RelationParameters::gap).value_or(0); }

// Walls that follow one another round the floor and form an inner corner.
bool meet_in_corner(const Face& a, const Face& b) {
  const auto follows = [](const Face& first, const Face& second) {
    return length(first.end - second.start) < 0.02 && cross(first.along, second.along) > 0.01;
  };
  return follows(a, b) || follows(b, a);
}

Interval common_extent(const RelationCase& c, Vec2d axis) {
  Interval common = extent(c.targets.front()->shape, axis);
  for (const Body* target : c.targets) common = hull(common, extent(target->shape, axis));
  return common;
}

Finding within_wall(const RelationCase& c, const Body& t, const Face& wall) {
  const Interval a = extent(t.shape, wall.along), b = extent(wall.shape, wall.along);
  return at_most(fmt::format("{} reaches past the end of {} by", t.id(), wall.id), std::max(b.lo - a.lo, a.hi - b.hi), 0, c.slack());
}

}  // namespace

Finding check_AgainstWall(const RelationCase& c) {
  return each_target(c, [&](const Body& t) {
    return any_wall(c, [&](const Face& wall) { return side_along_wall(c, t, wall, back_of(t), wall_gap(c)); });
  });
}

Finding check_SideAgainstWall(const RelationCase& c) {
  return each_target(c, [&](const Body& t) {
    const Side side = c.relation.parameters.side.value_or(Side::kLeft);
    const bool by_length = side == Side::kLong || side == Side::kShort;
    std::vector<Side> sides = sides_named(t, side);
    if (!c.relation.parameters.side) sides = {Side::kLeft, Side::kRight};
    if (!t.has_front && !by_length) sides = back_of(t);  // any of its sides
    return any_wall(c, [&](const Face& wall) { return side_along_wall(c, t, wall, sides, wall_gap(c)); });
  });
}

Finding check_Corner(const RelationCase& c) {
  const double max = c.metres(&RelationParameters::max).value_or(0);
  const auto is_wall = [](const Face& face) { return face.opening == nullptr; };
  const std::vector<const Face*> named = named_or_all(c, c.view.walls, is_wall);
  const bool all_walls = named.size() == c.view.walls.size();
  const auto is_named = [&](const Face& wall) { return std::find(named.begin(), named.end(), &wall) != named.end(); };
  return each_target(c, [&](const Body& t) {
    std::vector<Finding> corners;
    for (std::size_t i = 0; i < c.view.walls.size(); ++i) {
      for (std::size_t j = i + 1; j < c.view.walls.size(); ++j) {
        const Face &a = c.view.walls[i], &b = c.view.walls[j];
        if (!meet_in_corner(a, b)) continue;
        if (!all_walls && (named.size() == 1 ? !is_named(a) && !is_named(b) : !is_named(a) || !is_named(b))) continue;
        corners.push_back(
            all_of({at_most(fmt::format("distance between {} and {}", t.id(), a.id), gap(t.shape, a.shape), max, c.slack()),
                    at_most(fmt::format("distance between {} and {}", t.id(), b.id), gap(t.shape, b.shape), max, c.slack())}));
      }
    }
    return any_of(std::move(corners), "there is no such corner");
  });
}

Finding check_CenterOfRoom(const RelationCase& c) {
  const double max = c.metres(&RelationParameters::max).value_or(0);
  return all_of(
      {at_most("off the middle of the room along x by", std::abs(common_extent(c, {1, 0}).mid() - c.view.floor_x.mid()), max, c.slack()),
       at_most("off the middle of the room along y by", std::abs(common_extent(c, {0, 1}).mid() - c.view.floor_y.mid()), max, c.slack())});
}

Finding check_CenteredOnWall(const RelationCase& c) {
  return any_wall(c, [&](const Face& wall) {
    const Finding against = each_target(c, [&](const Body& t) { return side_along_wall(c, t, wall, back_of(t), wall_gap(c)); });
    const double off = std::abs(common_extent(c, wall.along).mid() - dot(wall.shape.center, wall.along));
    return all_of({at_most(fmt::format("off the middle of {} by", wall.id), off, 0, c.slack()), against});
  });
}

Finding check_InRegion(const RelationCase& c) {
  if (!c.relation.parameters.region) return condition(false, "inRegion names no region");
  const RoomRegion region = *c.relation.parameters.region;
  const Interval x = c.view.floor_x, y = c.view.floor_y;
  const auto has = [&](Side side) { return lies_at(region, side); };
  return each_target(c, [&](const Body& t) {
    const Vec2d at = t.shape.center;
    std::vector<Finding> findings;
    if (has(Side::kLeft)) findings.push_back(at_most(fmt::format("the centre of {} is at x", t.id()), at.x, x.mid(), c.slack()));
    if (has(Side::kRight)) findings.push_back(at_least(fmt::format("the centre of {} is at x", t.id()), at.x, x.mid(), c.slack()));
    if (has(Side::kFront)) findings.push_back(at_most(fmt::format("the centre of {} is at y", t.id()), at.y, y.mid(), c.slack()));
    if (has(Side::kBack)) findings.push_back(at_least(fmt::format("the centre of {} is at y", t.id()), at.y, y.mid(), c.slack()));
    if (region == RoomRegion::kMiddle) {
      findings.push_back(
          at_most(fmt::format("{} is off the middle along x by", t.id()), std::abs(at.x - x.mid()), x.length() / 6, c.slack()));
      findings.push_back(
          at_most(fmt::format("{} is off the middle along y by", t.id()), std::abs(at.y - y.mid()), y.length() / 6, c.slack()));
    }
    return all_of(std::move(findings));
  });
}

Finding check_OnWall(const RelationCase& c) {
  const std::optional<double> wanted = c.metres(&RelationParameters::height);
  return each_target(c, [&](const Body& t) {
    return any_wall(c, [&](const Face& wall) {
      const bool held = c.view.find_wall(t.object->supported_by) == &wall;
      std::vector<Finding> findings{condition(held, fmt::format("{} is held by {}, not by {}", t.id(), t.object->supported_by, wall.id)),
                                    side_along_wall(c, t, wall, back_of(t), kMounted), within_wall(c, t, wall)};
      if (wanted) findings.push_back(equal_to(fmt::format("the underside of {} is at", t.id()), t.underside(), *wanted, c.slack()));
      Finding finding = all_of(std::move(findings));
      if (finding.held) finding.message = fmt::format("{} hangs on {}", t.id(), wall.id);
      return finding;
    });
  });
}

Finding check_OnCeiling(const RelationCase& c) {
  return each_target(c, [&](const Body& t) {
    return at_most(fmt::format("distance between {} and the ceiling", t.id()), std::abs(c.view.height - t.top()), kMounted, 0);
  });
}

Finding check_AwayFromWall(const RelationCase& c) {
  const double min = c.metres(&RelationParameters::min).value_or(0);
  const auto walls = named_or_all(c, c.view.walls, [](const Face& face) { return face.opening == nullptr; });
  if (walls.empty()) return condition(false, "there is no such wall");
  return each_target(c, [&](const Body& t) {
    std::vector<Finding> findings;
    for (const Face* wall : walls) {
      findings.push_back(at_least(fmt::format("distance between {} and {}", t.id(), wall->id), gap(t.shape, wall->shape), min, c.slack()));
    }
    return all_of(std::move(findings));
  });
}

}  // namespace layoutbox::checks
