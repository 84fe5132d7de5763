#include "layoutbox/verify/walks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "layoutbox/verify/checks.h"

namespace layoutbox::checks {
namespace {

constexpr double kReachSlack = 0.02;  // m, half a pixel of a large room
constexpr int kReachResolution = 384;
constexpr double kStandsOff = 0.15;  // m, between who uses a thing, or comes in, and its side or the door
constexpr double kWalker = 0.6;      // m, width of who walks in `reachability`, as in the relation `reachable`

}  // namespace

Walks::Walks(const RoomView& view, double width) : view_(view), width_(width), bare_(view, 0, kReachResolution), usual_{bare_, {}} {
  if (view.floor.empty()) return;
  bare_.keep_from_edges(view.floor, width / 2 - kReachSlack);
  usual_ = floor_for(nullptr);
}

Walks::Floor Walks::floor_for(const Body* body) const {
  Floor floor{bare_, {}};
  std::vector<const Body*> others;
  for (const Body& other : view_.bodies) {
    if (other.rug || other.underside() >= kBodyReach || (body != nullptr && view_.belongs_to(other, *body))) continue;
    others.push_back(&other);
  }
  floor.plan.block(others, width_ / 2 - kReachSlack);
  walk_from_doors(floor);
  return floor;
}

void Walks::walk_from_doors(Floor& floor) const {
  const FloorPixels& plan = floor.plan;
  const std::vector<int> part = plan.parts();
  const double near_enough = width_ / 2 + kStandsOff;
  std::set<int> from_door;
  bool any_door = false;
  for (const Face& door : view_.openings) {
    if (!door.is_door()) continue;
    any_door = true;
    const auto [x0, x1, y0, y1] = plan.around((door.start + door.end) * 0.5, door.length / 2 + near_enough);
    for (int row = y0; row < y1; ++row) {
      for (int column = x0; column < x1; ++column) {
        const Vec2d way = plan.point(column, row) - door.start;
        const double along = dot(way, door.along), off = dot(way, door.inward);
        if (along >= 0 && along <= door.length && off >= 0 && off <= near_enough) from_door.insert(part[plan.index(column, row)]);
      }
    }
  }
  floor.walked.resize(part.size());
  for (std::size_t i = 0; i < part.size(); ++i) floor.walked[i] = part[i] != 0 && (!any_door || from_door.contains(part[i]));
}

std::vector<Side> Walks::reached(const Body& body, const std::vector<Side>& sides) const {
  if (view_.floor.empty()) return {};
  const bool has_belongings =
      std::any_of(view_.bodies.begin(), view_.bodies.end(), [&](const Body& other) { return view_.belongs_to(other, body); });
  std::optional<Floor> own;
  if (has_belongings) own = floor_for(&body);
  const Floor& floor = own ? *own : usual_;
  const double near_enough = width_ / 2 + kStandsOff;
  const auto [x0, x1, y0, y1] = floor.plan.around(body.shape.center, std::hypot(body.width, body.depth) / 2 + near_enough);
  std::vector<Side> found;
  for (const Side which : sides) {
    const BodySide side = side_of(body, which);
    const auto at_side = [&](Vec2d point) {
      const Vec2d way = point - body.shape.center;
      const double off = dot(way, side.outward) - side.reach;
      return off >= 0 && off <= near_enough && std::abs(dot(way, side.along)) <= side.half_width;
    };
    bool stands = false;
    for (int row = y0; row < y1 && !stands; ++row) {
      for (int column = x0; column < x1 && !stands; ++column) {
        stands = floor.walked[floor.plan.index(column, row)] != 0 && at_side(floor.plan.point(column, row));
      }
    }
    if (stands) found.push_back(which);
  }
  return found;
}

bool reachable(const RoomView& view, const Body& body, double width) {
  std::vector<Side> sides = sides_to_reach(body);
  if (sides.empty()) sides = {Side::kFront, Side::kBack, Side::kLeft, Side::kRight};
  return !Walks(view, width).reached(body, sides).empty();
}

namespace {

void check_access(const RoomView& view, Report& report) {
  const FloorPixels plan = plan_for_access(view);
  double sum = 0;
  int count = 0;
  for (const Body& body : view.bodies) {
    const std::optional<double> access = accessibility(body, plan);
    if (!access) continue;
    sum += *access;
    ++count;
    report.checks.push_back({"accessibility", body.id(), *access >= kLeastAccess, false, *access, "share",
                             fmt::format("{:.0f} % of the strip at the best side of {} is free, at least 90 %", *access * 100, body.id()),
                             object_pointer(body)});
  }
  report.metrics["accessibility"] = count == 0 ? 1.0 : sum / count;
}

// A bed at a wall is used from its other sides: one that is reached is enough, the figure counts all of them.
void check_reach(const RoomView& view, Report& report) {
  std::optional<Walks> walks;
  std::size_t reached = 0, wanted = 0;
  for (const Body& body : view.bodies) {
    const std::vector<Side> sides = sides_to_reach(body);
    if (sides.empty()) continue;
    if (!walks) walks.emplace(view, kWalker);
    const std::vector<Side> found = walks->reached(body, sides);
    reached += found.size(), wanted += sides.size();
    std::string cut_off;
    for (const Side side : sides) {
      if (std::find(found.begin(), found.end(), side) != found.end()) continue;
      cut_off += (cut_off.empty() ? "" : ", ") + std::string(name_of(side));
    }
    const std::string message =
        cut_off.empty()
            ? fmt::format("a person {} m wide walks from the door to every used side of {}", figure(kWalker), body.id())
            : fmt::format("a person {} m wide cannot walk from the door to the {} side of {}", figure(kWalker), cut_off, body.id());
    report.checks.push_back({"reachability", body.id(), !found.empty(), false,
                             static_cast<double>(found.size()) / static_cast<double>(sides.size()), "share", message,
                             object_pointer(body)});
  }
  report.metrics["reachability"] = wanted == 0 ? 1.0 : static_cast<double>(reached) / static_cast<double>(wanted);
}

}  // namespace

void check_ways(const RoomView& view, Report& report) {
  const double way = navigability(view);
  report.metrics["navigability"] = way;
  report.checks.push_back({"navigability", "room", way >= kLeastNavigability, false, way, "share",
                           fmt::format("{:.1f} % of the free floor hangs together, at least 99 %", way * 100), "/room"});
  check_access(view, report);
  check_reach(view, report);
}

}  // namespace layoutbox::checks
