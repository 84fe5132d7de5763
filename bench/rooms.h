// Rooms for the solver's figures: boxes alone, as the paper's model knows them, and rooms that cannot be.
#pragma once

#include <cstdint>
#include <vector>

#include "layoutbox/scene/scene_graph.h"

namespace layoutbox::bench {

// Of this process: everything measured runs in one thread, and other work on the machine does not count.
double cpu_seconds();

struct PlainBox {
  Mm width = 0, depth = 0;
  int wall = -1;   // index of the wall it stands at: 0 front, 1 right, 2 back, 3 left; −1: none
  int align = -1;  // the box whose middle it shares…
  int axis = 0;    // …along this axis
};

// A planted room: 35 % of the floor covered, half of the boxes at walls, a third aligned with another.
struct PlainRoom {
  Mm width = 0, depth = 0;
  std::vector<PlainBox> boxes;
};

PlainRoom plain_room(int boxes, std::uint64_t seed);

// The same as a scene: `offset` 0 from walls and `align`.
SceneGraph scene_of(const PlainRoom& room);

// Furniture in groups with the relations that prompts have (beds between nightstands, chairs round tables, screens faced, things on and
// in things), doors and windows, 35 % of the floor covered; turns and sizes are free.
SceneGraph furnished_scene(int objects, std::uint64_t seed);

// A planted room of 15 boxes with something added that cannot be; `kind` 0 … kClashKinds − 1.
inline constexpr int kClashKinds = 6;
SceneGraph impossible_scene(int kind, std::uint64_t seed);
const char* clash_kind_in_words(int kind);

}  // namespace layoutbox::bench
