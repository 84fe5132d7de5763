// The groups of checks that make up a report. Each adds its checks and metrics.
#pragma once

#include "layoutbox/verify/room_view.h"

namespace layoutbox::checks {

inline constexpr double kOutsideShare = 0.01;   // of a footprint may lie off the floor (quality.md)
inline constexpr double kCeilingReach = 0.010;  // m
inline constexpr double kLeastNavigability = 0.99, kLeastAccess = 0.9;

void check_collisions(const RoomView& view, Report& report);
void check_bounds(const RoomView& view, Report& report);
void check_support(const RoomView& view, Report& report);
void check_openings(const RoomView& view, Report& report);  // doorSwing, openingClearance
void check_ways(const RoomView& view, Report& report);      // navigability, accessibility
void check_relations(const RoomView& view, Report& report);

// True when one body's box reaches into the other's by more than the tolerance, where no space of either is (scene-format.md, `spaces`).
bool collide(const Body& a, const Body& b, double tolerance);

// Why an object is not held up by what it names, with the figure; an empty message when it is.
struct SupportFault {
  std::string message;
  double gap = 0;  // m
};
SupportFault support_fault(const RoomView& view, const Body& body);

// "/objects/3"
std::string object_pointer(const Body& body);

// Numbers in sentences: 0.62 for metres; 3 decimals where 2 would not tell the value from its limit.
std::string figure(double value);
std::string figure_beside(double value, double limit);

}  // namespace layoutbox::checks
