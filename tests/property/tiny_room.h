// Rooms so tiny that every layout of theirs can be tried, in cells of half a metre.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "layoutbox/scene/layout.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox::placement {

struct Cell {
  int x, y, turn;
};

// What two pieces, or a piece and wall `a` (front, right, back, left), may have to do with one another.
enum class Kind { kBackToWall, kOffWall, kOffsetX, kOffsetY, kParallel, kPerpendicular, kSameTurn, kAlignLeft, kAlignBack, kCount };

struct TinyRelation {
  Kind kind = Kind::kParallel;
  int target = 0, reference = 0, a = 0;  // a: a wall, or so many cells
  bool of_wall() const { return kind == Kind::kBackToWall || kind == Kind::kOffWall; }
};

struct TinyRoom {
  int width = 0, depth = 0;
  std::vector<std::pair<int, int>> sizes;
  std::vector<TinyRelation> relations;
};

// Some of the pieces and some of the relations.
struct Part {
  std::vector<char> pieces, relations;
};

inline bool names(const std::vector<std::string>& ids, const std::string& id) { return std::ranges::find(ids, id) != ids.end(); }

TinyRoom random_room(std::uint64_t seed);
SceneGraph as_scene(const TinyRoom& s);

Part all_of(const TinyRoom& s);
// Is there a layout of that part? All are tried.
bool exists(const TinyRoom& s, const Part& part);

// The conflict is impossible as it is, and possible without any one of its members, which are counted.
void expect_smallest(const TinyRoom& s, const Conflict& conflict, int& members);

}  // namespace layoutbox::placement
