// Lengths inside the program are integer millimetres; metres and degrees appear only in JSON, in meshes and in Blender.
#pragma once

#include <cmath>
#include <cstdint>

namespace layoutbox {

using Mm = std::int32_t;  // a length in millimetres

// Free positions move on this grid (the paper's 1 cm). Sizes and pinned positions are exact to the millimetre.
inline constexpr Mm kGridMm = 10;

// Nearest millimetre. REQUIRES: |metres| < 2e6.
inline Mm mm_from_m(double metres) { return static_cast<Mm>(std::lround(metres * 1000.0)); }

inline double m_from_mm(double millimetres) { return millimetres / 1000.0; }

inline constexpr double kPi = 3.14159265358979323846;

inline double radians_from_degrees(double degrees) { return degrees * (kPi / 180.0); }

// The same direction in [0, 360).
inline double normalized_degrees(double degrees) {
  const double turned = std::fmod(degrees, 360.0);
  return turned < 0 ? turned + 360.0 : turned;
}

// A point or a vector in the plan, in millimetres.
struct Point {
  Mm x = 0;
  Mm y = 0;
  friend bool operator==(const Point&, const Point&) = default;
};

// Width (along x), depth (along y) and height (along z) of an object at rotation 0, in millimetres.
struct Size {
  Mm width = 0;
  Mm depth = 0;
  Mm height = 0;
  friend bool operator==(const Size&, const Size&) = default;
};

}  // namespace layoutbox
