#include "layoutbox/export/plan_pen.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "layoutbox/base/units.h"

namespace layoutbox {

Pen::Pen(Canvas& page, const PlanScale& scale, const PlacedObject& object, std::string_view family)
    : page_(page), scale_(scale), object_(object), family_(family) {
  const double turn = radians_from_degrees(object.rotation_deg);
  cos_ = std::cos(turn);
  sin_ = std::sin(turn);
}

PaperPoint Pen::at(double x, double y) const {
  return scale_.at(object_.position[0] + cos_ * x - sin_ * y, object_.position[1] + sin_ * x + cos_ * y);
}

void Pen::box(double x0, double x1, double y0, double y1) { page_.polygon({at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)}, style); }

void Pen::cushion(double x0, double x1, double y0, double y1, double radius) {
  radius = std::min({radius, (x1 - x0) / 2, (y1 - y0) / 2});
  std::vector<PaperPoint> points;
  const std::array<std::array<double, 3>, 4> corners{
      {{x1 - radius, y1 - radius, 0}, {x0 + radius, y1 - radius, 90}, {x0 + radius, y0 + radius, 180}, {x1 - radius, y0 + radius, 270}}};
  for (const auto& [x, y, start] : corners) {
    for (int i = 0; i <= 8; ++i) {
      const double angle = radians_from_degrees(start + 11.25 * i);
      points.push_back(at(x + radius * std::cos(angle), y + radius * std::sin(angle)));
    }
  }
  page_.polygon(points, style);
}

void Pen::ellipse(double x, double y, double rx, double ry) {
  std::vector<PaperPoint> points;
  for (int i = 0; i < 48; ++i) points.push_back(at(x + rx * std::cos(i * kPi / 24), y + ry * std::sin(i * kPi / 24)));
  page_.polygon(points, style);
}

void Pen::shape(const std::vector<PaperPoint>& corners) {
  std::vector<PaperPoint> points;
  points.reserve(corners.size());
  for (const PaperPoint& p : corners) points.push_back(at(p.x, p.y));
  page_.polygon(points, style);
}

void Pen::line(double x0, double y0, double x1, double y1) { page_.line(at(x0, y0), at(x1, y1), style); }

bool is_called_round(const PlacedObject& object) {
  constexpr std::string_view kRound[] = {"round", "circular", "oval"};
  const auto says = [&](std::string_view text) {
    return std::any_of(std::begin(kRound), std::end(kRound), [&](std::string_view word) { return text.find(word) != text.npos; });
  };
  return says(object.name) || says(object.category) ||
         std::any_of(object.attributes.begin(), object.attributes.end(),
                     [&](const std::string& said) { return std::find(std::begin(kRound), std::end(kRound), said) != std::end(kRound); });
}

}  // namespace layoutbox
