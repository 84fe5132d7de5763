#include "layoutbox/verify/verify.h"

#include <algorithm>

#include "layoutbox/verify/checks.h"

namespace layoutbox {
namespace {

// Relations bring theirs along.
void add_limits(Report& report, const VerifyOptions& options) {
  for (Check& check : report.checks) {
    if (check.name == "collision" || check.name == "doorSwing" || check.name == "openingClearance")
      check.limit = options.collision_tolerance_m;
    if (check.name == "support") check.limit = options.support_tolerance_m;
    if (check.name == "outOfBounds") check.limit = check.unit == "m" ? judge::kCeilingReach : judge::kOutsideShare;
    if (check.name == "navigability") check.limit = judge::kLeastNavigability;
    if (check.name == "accessibility") check.limit = judge::kLeastAccess;
  }
}

}  // namespace

Report verify(const Layout& layout, const Catalog& catalog, const VerifyOptions& options) {
  const judge::RoomView view(layout, catalog, options);
  Report report;
  if (view.floor.empty()) {
    report.checks.push_back({"room", "room", false, true, 0, "m2", "the room's polygon has no area", "/room/polygon"});
  }
  judge::check_collisions(view, report);
  judge::check_bounds(view, report);
  judge::check_support(view, report);
  judge::check_openings(view, report);
  judge::check_relations(view, report);
  judge::check_ways(view, report);
  add_limits(report, options);
  report.passed =
      std::all_of(report.checks.begin(), report.checks.end(), [](const Check& check) { return check.passed || !check.required; });
  return report;
}

}  // namespace layoutbox
