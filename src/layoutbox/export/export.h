// Layout to other tools' files.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/furnish/model.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox {

// Binary glTF 2.0: y up, metres, a node per object named by its id, its category and relations in `extras`.
Result<std::string> write_glb(const Model& model, const Layout& layout);

// A part of the floor that is pointed out, with a word beside it.
struct PlanMark {
  std::vector<std::array<double, 2>> corners;  // mm
  std::string label;
};

struct FloorPlanOptions {
  bool names = true, sizes = true, scale_bar = true;
  // A sheet of paper with title, lengths, names and a key; else (of SVG) the room alone, drawn small, for pages that show many.
  bool sheet = true;
  double dots_per_inch = 200;   // of PNG. REQUIRES: 10…2000
  std::vector<PlanMark> marks;  // drawn over all else, in red
};

// An SVG floor plan, seen from above, x to the right, y up the page.
std::string write_floor_plan_svg(const Layout& layout, const Catalog& catalog, const FloorPlanOptions& options = {});

// The same page as PDF, to scale on A4, and as PNG. Errors: kIo where the library Cairo is missing.
Result<std::string> write_floor_plan_pdf(const Layout& layout, const Catalog& catalog, const FloorPlanOptions& options = {});
Result<std::string> write_floor_plan_png(const Layout& layout, const Catalog& catalog, const FloorPlanOptions& options = {});

}  // namespace layoutbox
