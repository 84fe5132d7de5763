// Doors that open and windows that are not blocked.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "layoutbox/verify/checks.h"

namespace layoutbox::checks {
namespace {

std::string pointer_of(const Face& opening) { return fmt::format("/room/openings/{}", opening.index); }

void check_swing(const RoomView& view, const Face& door, Report& report, int& clear) {
  double deepest = 0;
  std::vector<std::string> blockers;
  for (const Body& body : view.bodies) {
    const double depth = body.rug ? 0 : swing_intrusion(door, body);
    if (depth <= view.options.collision_tolerance_m + kTiny) continue;
    deepest = std::max(deepest, depth);
    blockers.push_back(body.id());
  }
  clear += blockers.empty();
  const bool given_up = !blockers.empty() && view.layout.lists_as_given_up("door swing of " + door.id);
  report.checks.push_back({"doorSwing", door.id, blockers.empty(), !given_up, deepest, "m",
                           blockers.empty()
                               ? fmt::format("{} opens freely", door.id)
                               : fmt::format("{} cannot open fully: {} in its swing, {} m deep{}", door.id, fmt::join(blockers, ", "),
                                             figure_beside(deepest, 0), given_up ? " (given up, as listed)" : ""),
                           pointer_of(door)});
}

void check_clearance(const RoomView& view, const Face& opening, Report& report, int& clear) {
  const Shape space = space_before(opening);
  double deepest = 0;
  std::vector<std::string> blockers;
  for (const Body& body : view.bodies) {
    if (body.rug || (opening.is_window() && body.curtain)) continue;
    const double depth = penetration(body.shape, space);
    if (depth <= view.options.collision_tolerance_m + kTiny) continue;
    deepest = std::max(deepest, depth);
    blockers.push_back(body.id());
  }
  clear += blockers.empty();
  report.checks.push_back({"openingClearance", opening.id, blockers.empty(), false, deepest, "m",
                           blockers.empty() ? fmt::format("the space before {} is free", opening.id)
                                            : fmt::format("{} before {}", fmt::join(blockers, ", "), opening.id),
                           pointer_of(opening)});
}

}  // namespace

void check_openings(const RoomView& view, Report& report) {
  int clear = 0, swings = 0, doors = 0;
  for (const Face& opening : view.openings) {
    check_clearance(view, opening, report, clear);
    if (opening.opening->type != OpeningType::kDoor) continue;
    ++doors;
    check_swing(view, opening, report, swings);
  }
  for (const std::string& id : view.unplaced_openings) {
    report.checks.push_back(
        {"reference", id, false, true, 0, "", fmt::format("{} has no place on a wall that is there", id), "/room/openings"});
  }
  const auto share = [](int part, std::size_t whole) { return whole == 0 ? 1.0 : part / static_cast<double>(whole); };
  report.metrics["openingClearance"] = share(clear, view.openings.size());
  report.metrics["doorSwing"] = share(swings, static_cast<std::size_t>(doors));
}

}  // namespace layoutbox::checks
