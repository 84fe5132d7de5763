// Random scenes and layouts for tests and benchmarks: everything that the types can hold, with values that the files keep exactly.
#pragma once

#include <random>

#include "layoutbox/scene/layout.h"

namespace layoutbox {

class RandomScenes {
 public:
  explicit RandomScenes(std::uint64_t seed) : random_(seed) {}

  // A valid scene; sizes, places and walls may be missing.
  SceneGraph scene();
  // A valid layout.
  Layout layout();

 private:
  bool coin() { return number(0, 1) == 1; }
  int number(int least, int most) { return std::uniform_int_distribution<int>(least, most)(random_); }
  double tenths(int least_mm, int most_mm) { return number(least_mm * 10, most_mm * 10) / 10.0; }
  std::string text();
  std::array<double, 3> place(int most_mm) { return {tenths(-most_mm, most_mm), tenths(-most_mm, most_mm), tenths(0, most_mm)}; }
  Size size() { return {number(10, 3000), number(10, 3000), number(10, 3000)}; }
  std::vector<Space> spaces();
  std::vector<Side> sides();
  Room room();
  SceneObject object(int index);
  PlacedObject placed_object(int index);
  Relation relation(int index, const std::vector<std::string>& objects);
  std::vector<Material> materials();

  std::mt19937_64 random_;
};

}  // namespace layoutbox
