// Judges a layout by geometry of its own: shares the types, the catalogue and the relation table with solve, and no arithmetic.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox {

struct VerifyOptions {
  double collision_tolerance_m = 0.005;  // quality.md
  double support_tolerance_m = 0.005;
  double mount_tolerance_m = 0.010;
  double relation_slack_m = 0.005;  // a relation "just held" on the grid must not fail by rounding
};

struct Check {
  std::string name;     // "collision", "outOfBounds", "support", "openingClearance", "doorSwing", "relation", "navigability"…
  std::string subject;  // "bed_1 / desk_1", "c3", "door1"
  bool passed = true;
  bool required = true;  // a required check that fails makes the report fail; others warn
  double value = 0;      // the figure measured
  std::string unit;
  std::string message;               // one sentence for a person
  std::string pointer;               // place in layout.json: "/objects/3"
  std::optional<double> limit = {};  // the figure at which the verdict turns, in `unit`; empty where it is no one number
};

struct Report {
  bool passed = true;
  std::vector<Check> checks;              // every check made, passed or not
  std::map<std::string, double> metrics;  // collisions, outOfBounds, support, navigability, accessibility, openingClearance, relationsHeld
};

// Never fails on a readable layout; what is wrong with it stands in the report.
Report verify(const Layout& layout, const Catalog& catalog, const VerifyOptions& options = {});

std::string write_report(const Report& report);  // report.json

}  // namespace layoutbox
