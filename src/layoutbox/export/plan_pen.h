// What the symbols of a floor plan are drawn with: shapes in an object's own frame.
#pragma once

#include <string_view>
#include <vector>

#include "layoutbox/export/plan_symbols.h"

namespace layoutbox {

// Millimetres, origin at the centre of the footprint, front to −y.
class Pen {
 public:
  Pen(Canvas& page, const PlanScale& scale, const PlacedObject& object, std::string_view family);

  double w() const { return object_.size.width; }
  double d() const { return object_.size.depth; }
  // Of shapes, that the object's kind is drawn by.
  std::string_view family() const { return family_; }

  void box(double x0, double x1, double y0, double y1);
  // The same with round corners.
  void cushion(double x0, double x1, double y0, double y1, double radius);
  void ellipse(double x, double y, double rx, double ry);
  void shape(const std::vector<PaperPoint>& corners);
  void line(double x0, double y0, double x1, double y1);
  void outline() { box(-w() / 2, w() / 2, -d() / 2, d() / 2); }
  void oval() { ellipse(0, 0, w() / 2, d() / 2); }

  DrawStyle style;

 private:
  PaperPoint at(double x, double y) const;

  Canvas& page_;
  const PlanScale& scale_;
  const PlacedObject& object_;
  std::string_view family_;
  double cos_ = 1, sin_ = 0;
};

// Is the object called round or oval?
bool is_called_round(const PlacedObject& object);

}  // namespace layoutbox
