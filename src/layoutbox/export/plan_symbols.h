// The symbols of a floor plan: what a piece of furniture looks like from above, by its kind.
#pragma once

#include <string_view>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/export/canvas.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox {

// From the plan in millimetres (x right, y away) to the paper.
struct PlanScale {
  double left = 0, bottom = 0;  // where the plan's origin lies on the page
  double factor = 0.02;         // millimetres on paper per millimetre in the room
  PaperPoint at(double x, double y) const { return {left + x * factor, bottom - y * factor}; }
};

// How high up an object counts in the plan, in millimetres: what is higher is drawn over what is lower. Seats count with their seat, so
// that they slide under tables; what hangs from the ceiling comes last.
double plan_height(const PlacedObject& object, const Catalog& catalog);

// Whether there is a symbol of that name, as shapes in the catalogue have one.
bool has_symbol(std::string_view name);

// Draws the object's symbol at its place. Objects that hang from the ceiling are dashed.
void draw_symbol(Canvas& page, const PlanScale& scale, const PlacedObject& object, const Catalog& catalog);

}  // namespace layoutbox
