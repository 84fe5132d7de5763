// What the parts of a random scene's making share: the draft that they fill, and its chance.
#pragma once

#include <cstdint>
#include <iterator>

#include "layoutbox/catalog/catalog.h"
#include "synthetic.h"

namespace layoutbox::synthetic {

// A small generator of its own: the library's distributions differ between machines.
class Random {
 public:
  // Mixed: the streams of neighbouring seeds would else be one stream, begun at other places.
  explicit Random(std::uint64_t seed) : state_(mixed(seed * 0x9E3779B97F4A7C15u + 0x632BE59BD9B4E019u)) {}

  // In [low, high].
  int number(int low, int high) { return high <= low ? low : low + static_cast<int>(next() % static_cast<std::uint64_t>(high - low + 1)); }
  bool chance(int percent) { return number(1, 100) <= percent; }
  template <class Items>
  const auto& one_of(const Items& items) {
    return items[static_cast<std::size_t>(number(0, static_cast<int>(std::size(items)) - 1))];
  }

 private:
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  std::uint64_t next() { return mixed(state_ += 0x9E3779B97F4A7C15u); }  // splitmix64
  std::uint64_t state_;
};

struct Draft {
  SceneOptions options;
  Random random;
  SceneGraph scene;
  Layout layout;  // of a planted scene
};

// A kind of the catalogue, but no sloping ceiling: it is part of the room, and stands along a wall, however it is turned.
const CatalogEntry& draw_entry(Random& random);
// A thing of that kind and its usual size, that is not in the scene yet.
SceneObject object_of(const SceneGraph& scene, const CatalogEntry& entry);

// Draws objects and puts them where they can stand, as many of those wanted as find a place.
void plant_objects(Draft& draft, int wanted);

// A relation of any type between things of the scene, that may not hold.
Relation draw_relation(Draft& draft, int number);
// Draws relations until so many of them hold in the planted layout, without any slack.
void read_relations(Draft& draft, int wanted);

}  // namespace layoutbox::synthetic
