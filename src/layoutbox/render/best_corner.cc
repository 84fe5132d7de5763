// From which corner of the room most fronts are seen and least is hidden: rays from sample points of every thing to the camera.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "layoutbox/render/render.h"
#include "layoutbox/render/slope_wall.h"

namespace layoutbox {
namespace {

constexpr std::array<std::string_view, 5> kCornerNames{"best", "NE", "NW", "SE", "SW"};  // in the order of Corner
constexpr int kSamples = 3;                                                              // along an edge of a face
constexpr std::size_t kMostThings = 250;                                                 // the largest; more hide nothing that matters
constexpr double kFrontWorth = 2, kMostFront = 2.5;  // a front counts more than a top; m² from which a larger one counts no more
constexpr double kWallWorth = 0.25;                  // of a wall with a look of its own, for each m²
constexpr double kOpeningWorth = 1;
constexpr double kHungWorth = 1.5;  // of what was told to hang on a wall: on one that is cut away it shows its back
constexpr double kBetter = 1.03;    // so much better than the usual corner is worth another
constexpr double kClear = 0.005;    // metres beyond a face where a ray starts

struct ViewVector {
  double x = 0, y = 0, z = 0;
};

// A thing as an upright box, turned about z; metres.
struct ShownThing {
  ViewVector at;  // the middle of its underside
  double half_width = 0, half_depth = 0, height = 0;
  ViewVector right, back;  // its own axes in the plan
  bool has_front = false;

  ViewVector point(double x, double y, double z) const {
    return {at.x + right.x * x + back.x * y, at.y + right.y * x + back.y * y, at.z + z};
  }
};

ShownThing thing_of(const PlacedObject& object) {
  const double turn = radians_from_degrees(object.rotation_deg);
  ShownThing thing;
  thing.at = {object.position[0] / 1000, object.position[1] / 1000, object.position[2] / 1000};
  thing.half_width = object.size.width / 2000.0, thing.half_depth = object.size.depth / 2000.0, thing.height = object.size.height / 1000.0;
  thing.right = {std::cos(turn), std::sin(turn), 0}, thing.back = {-std::sin(turn), std::cos(turn), 0};
  const auto uses = [&](Side side) { return std::ranges::find(object.used_sides, side) != object.used_sides.end(); };
  thing.has_front = uses(Side::kFront) && !(uses(Side::kBack) && uses(Side::kLeft) && uses(Side::kRight));
  return thing;
}

// Does the ray from p towards the camera pass through the box?
bool hides(const ShownThing& thing, const ViewVector& p, const ViewVector& toward) {
  const double dx = p.x - thing.at.x, dy = p.y - thing.at.y;
  const std::array<double, 3> from{dx * thing.right.x + dy * thing.right.y, dx * thing.back.x + dy * thing.back.y, p.z - thing.at.z};
  const std::array<double, 3> way{toward.x * thing.right.x + toward.y * thing.right.y, toward.x * thing.back.x + toward.y * thing.back.y,
                                  toward.z};
  const std::array<double, 3> low{-thing.half_width, -thing.half_depth, 0}, high{thing.half_width, thing.half_depth, thing.height};
  double first = 0, last = 1e9;
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::abs(way[k]) < 1e-9) {
      if (from[k] <= low[k] || from[k] >= high[k]) return false;
      continue;
    }
    const double a = (low[k] - from[k]) / way[k], b = (high[k] - from[k]) / way[k];
    first = std::max(first, std::min(a, b)), last = std::min(last, std::max(a, b));
  }
  return first < last - 1e-6;
}

// What is seen of fronts and tops, a front counting by its size.
double shown_from(const std::vector<ShownThing>& things, double azimuth_deg, double elevation_deg) {
  const double azimuth = radians_from_degrees(azimuth_deg), elevation = radians_from_degrees(elevation_deg);
  const ViewVector toward{std::cos(elevation) * std::sin(azimuth), -std::cos(elevation) * std::cos(azimuth), std::sin(elevation)};
  double shown = 0;
  for (const ShownThing& thing : things) {
    const auto seen = [&](const ViewVector& p) {
      return std::ranges::none_of(things, [&](const ShownThing& other) { return &other != &thing && hides(other, p, toward); });
    };
    int front = 0, top = 0;
    const bool turned_to_us = thing.has_front && -(thing.back.x * toward.x + thing.back.y * toward.y) > 0.1 * std::cos(elevation);
    for (int i = 0; i < kSamples; ++i) {
      for (int j = 0; j < kSamples; ++j) {
        const double u = (i + 0.5) / kSamples, v = (j + 0.5) / kSamples, x = (2 * u - 1) * thing.half_width;
        top += seen(thing.point(x, (2 * v - 1) * thing.half_depth, thing.height + kClear));
        front += turned_to_us && seen(thing.point(x, -thing.half_depth - kClear, v * thing.height));
      }
    }
    const double face = std::min(4 * thing.half_width * thing.height / 2, kMostFront), lid = 4 * thing.half_width * thing.half_depth;
    shown += (kFrontWorth * face * front + std::min(lid, kMostFront) * top) / (kSamples * kSamples);
  }
  return shown;
}

// What is seen of walls, doors and windows that the text gives a look of their own: on walls that do not turn their back on the camera.
double looks_shown_from(const Layout& layout, const Catalog& catalog, double azimuth_deg) {
  const Room& room = layout.room;
  const double azimuth = radians_from_degrees(azimuth_deg);
  double shown = 0;
  for (const Wall& wall : room.walls) {
    const double along_x = m_from_mm(wall.end.x - wall.start.x), along_y = m_from_mm(wall.end.y - wall.start.y);
    if (-along_y * std::sin(azimuth) - along_x * std::cos(azimuth) <= 0) continue;
    const bool own_look = !wall.material.empty() && wall.material != room.wall_material;
    if (own_look) shown += kWallWorth * std::hypot(along_x, along_y) * m_from_mm(room.height);
    for (const PlacedObject& object : layout.objects) {
      if (wall_of_slope(layout, object, catalog) == &wall)
        shown += kOpeningWorth * m_from_mm(object.size.width) * m_from_mm(object.size.height);
    }
    for (const Opening& opening : room.openings) {
      if (opening.wall == wall.id && !opening.attributes.empty())
        shown += kOpeningWorth * m_from_mm(opening.width) * m_from_mm(opening.height);
    }
  }
  return shown;
}

// … and of what hangs on walls and was asked for.
double hung_shown_from(const Layout& layout, double azimuth_deg) {
  const double azimuth = radians_from_degrees(azimuth_deg);
  double shown = 0;
  for (const PlacedObject& object : layout.objects) {
    const double turn = radians_from_degrees(object.rotation_deg);
    const bool faces_us = std::sin(turn) * std::sin(azimuth) + std::cos(turn) * std::cos(azimuth) > 0;
    if (object.mount == Mount::kWall && object.origin != Origin::kAdded && faces_us) shown += kHungWorth;
  }
  return shown;
}

double azimuth_of(Corner corner) {
  switch (corner) {
    case Corner::kNorthEast: return 135;
    case Corner::kNorthWest: return 225;
    case Corner::kSouthWest: return 315;
    case Corner::kSouthEast:
    case Corner::kBest: break;
  }
  return 45;
}

}  // namespace

std::string_view name_of(Corner corner) { return kCornerNames.at(static_cast<std::size_t>(corner)); }

std::optional<Corner> corner_from_name(std::string_view name) {
  for (std::size_t i = 0; i < kCornerNames.size(); ++i) {
    const auto alike = [](char a, char b) {
      return std::toupper(static_cast<unsigned char>(a)) == std::toupper(static_cast<unsigned char>(b));
    };
    if (std::ranges::equal(kCornerNames[i], name, alike)) return static_cast<Corner>(i);
  }
  return std::nullopt;
}

Corner best_corner(const Layout& layout, const Catalog& catalog, double elevation_deg) {
  std::vector<ShownThing> things;
  for (const PlacedObject& object : layout.objects) {
    if (object.origin != Origin::kAdded && wall_of_slope(layout, object, catalog) == nullptr)
      things.push_back(thing_of(object));  // what we add to a room does not turn it
  }
  const auto volume = [](const ShownThing& t) { return t.half_width * t.half_depth * t.height; };
  std::ranges::stable_sort(things, std::greater{}, volume);
  if (things.size() > kMostThings) things.resize(kMostThings);
  Corner best = Corner::kSouthEast;
  const auto shown_at = [&](Corner corner) {
    const double azimuth = azimuth_of(corner);
    return shown_from(things, azimuth, elevation_deg) + looks_shown_from(layout, catalog, azimuth) + hung_shown_from(layout, azimuth);
  };
  double most = shown_at(best) * kBetter;
  for (const Corner corner : {Corner::kSouthWest, Corner::kNorthEast, Corner::kNorthWest}) {
    const double shown = shown_at(corner);
    if (shown > most * (1 + 1e-9)) best = corner, most = shown;  // of equals the first, on every machine
  }
  return best;
}

double azimuth_from(const Layout& layout, const Catalog& catalog, const RenderOptions& options) {
  if (options.azimuth_deg) return *options.azimuth_deg;
  return azimuth_of(options.corner == Corner::kBest ? best_corner(layout, catalog, options.elevation_deg) : options.corner);
}

}  // namespace layoutbox
