// The slope of a roof, as its rafters: what stands under it is seen in the picture, where ceilings are left out.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

constexpr double kRafter = 0.08, kThick = 0.09, kApart = 0.85;

// A strip of the slope from x0 to x1 and from y0 to y1: it falls from the front's top to the back's bottom.
Mesh strip(const Piece& p, double x0, double x1, double y0, double y1, double thick) {
  const auto under = [&](double y) { return (p.h - thick) * (p.d / 2 - y) / p.d; };
  const std::vector<Vec2> outline{{y0, under(y0)}, {y1, under(y1)}, {y1, under(y1) + thick}, {y0, under(y0) + thick}};
  return posed(prism(outline, x0, x1), Pose{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {}});
}

void roof_slope(Piece& p) {
  const int wood = p.main("pine");
  const double w = p.w / 2, d = p.d / 2, half = std::min(kRafter / 2, w / 4);
  const int fields = std::max(1, static_cast<int>(std::lround((p.w - 2 * half) / kApart)));
  for (int i = 0; i <= fields; ++i) {
    const double x = -w + half + (p.w - 2 * half) * i / fields;
    const bool free = std::ranges::none_of(p.spaces, [&](const FreeSpace& space) {
      return space.name.starts_with("window") && x + half > space.box.min.x && x - half < space.box.max.x;
    });
    if (free) p.add(wood, strip(p, x - half, x + half, -d, d, kThick));
  }
  const double edge = std::min(0.12, p.d / 6);
  for (const double y : {-d, d - edge}) p.add(wood, strip(p, -w, w, y, y + edge, std::min(kThick, p.h / 6)));
}

void roof_window(Piece& p) {
  const double w = p.w / 2, d = p.d / 2, bar = std::min({0.07, w / 3, d / 3}), thick = std::min(0.06, p.h / 4);
  const int frame = p.main("lacquer");
  for (const double x : {-w, w - bar}) p.add(frame, strip(p, x, x + bar, -d, d, thick));
  for (const double y : {-d, d - bar}) p.add(frame, strip(p, -w + bar, w - bar, y, y + bar, thick));
  p.add(p.named("glass"), strip(p, -w + bar, w - bar, -d + bar, d - bar, thick / 2));
}

}  // namespace

void add_roofs(Families& to) {
  to["roof_slope"] = roof_slope;
  to["roof_window"] = roof_window;
}

}  // namespace layoutbox::kit
