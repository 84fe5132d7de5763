#include "layoutbox/verify/verify.h"

#include <algorithm>
#include <utility>

#include "layoutbox/verify/checks.h"
#include "layoutbox/verify/standing.h"

namespace layoutbox {
namespace {

// Relations bring theirs along.
void add_limits(Report& report, const VerifyOptions& options) {
  for (Check& check : report.checks) {
    if (check.name == "collision" || check.name == "doorSwing" || check.name == "openingClearance")
      check.limit = options.collision_tolerance_m;
    if (check.name == "support") check.limit = options.support_tolerance_m;
    if (check.name == "outOfBounds") check.limit = check.unit == "m" ? checks::kCeilingReach : checks::kOutsideShare;
    if (check.name == "navigability") check.limit = checks::kLeastNavigability;
    if (check.name == "accessibility") check.limit = checks::kLeastAccess;
  }
}

Report standing(const checks::RoomView& view) {
  Report report;
  if (view.floor.empty()) {
    report.checks.push_back({"room", "room", false, true, 0, "m2", "the room's polygon has no area", "/room/polygon"});
  }
  checks::check_collisions(view, report);
  checks::check_bounds(view, report);
  checks::check_support(view, report);
  checks::check_openings(view, report);
  checks::check_relations(view, report);
  return report;
}

Report judged(Report report, const VerifyOptions& options) {
  add_limits(report, options);
  report.passed =
      std::all_of(report.checks.begin(), report.checks.end(), [](const Check& check) { return check.passed || !check.required; });
  return report;
}

}  // namespace

Report verify(const Layout& layout, const Catalog& catalog, const VerifyOptions& options) {
  const checks::RoomView view(layout, catalog, options);
  Report report = standing(view);
  checks::check_ways(view, report);
  return judged(std::move(report), options);
}

Report verify_standing(const Layout& layout, const Catalog& catalog, const VerifyOptions& options) {
  return judged(standing(checks::RoomView(layout, catalog, options)), options);
}

}  // namespace layoutbox
