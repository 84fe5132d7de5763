// The furniture as it is drawn, judged beside its boxes: a body's mesh may be where its box is not, and the other way round.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/verify/verify.h"

namespace layoutbox {

struct Point3 {
  double x = 0, y = 0, z = 0;
};
using Triangle = std::array<Point3, 3>;

// A thing of the layout with its triangles in the room, in metres.
struct DrawnObject {
  std::string id;
  std::vector<Triangle> triangles;
};

// Adds what verify() measures of boxes, measured of what is drawn: `drawnCollision`, `drawnOutOfBounds`, `drawnSupport`, `drawnDoorSwing`,
// `drawnOpeningClearance`, `drawnNavigability`, `drawnAccessibility`, `drawnReachability`, which warn, and their metrics. What is not in
// the layout, or has no triangle, is passed over.
void verify_drawn(const Layout& layout, const Catalog& catalog, const std::vector<DrawnObject>& drawn, const VerifyOptions& options,
                  Report& report);

// Adds `visibility`, which warns, from the index of an object mask (mask.json, docs/render.md): what is hidden in the picture.
// Errors: kParse, kSchema.
Status verify_seen(const Layout& layout, std::string_view mask_index, Report& report);

}  // namespace layoutbox
