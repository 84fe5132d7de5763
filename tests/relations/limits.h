// Every relation at its limit, as layouts: for the verifier, which must see each side of it, and for the solver, which must claim the one
// and never the other.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "layoutbox/verify/test_room.h"

namespace layoutbox::checks {

using Type = RelationType;

// A move of `who` in metres and degrees by which the relation breaks; a fifth of it is within the slack (5 mm, 1°): 20 mm.
struct Break {
  std::string who;
  TestPlace by;
};

struct Limit {
  std::string name;
  Type type;
  std::function<void(TestRoom&)> furnish;  // the relation is its only one, and just holds
  Break breaks;
  // The solver claims it as well when everything is fixed there. Not where something reaches out of the room or stands where only a
  // relation could put it, and not at the very limit of what the solver takes a little tighter (docs/solve.md, "Enough and needed").
  bool solver = true;
};

inline void PrintTo(const Limit& limit, std::ostream* out) { *out << limit.name; }

inline RelationParameters with(const std::function<void(RelationParameters&)>& set) {
  RelationParameters parameters;
  set(parameters);
  return parameters;
}
inline RelationParameters with_max(Mm max) {
  return with([&](RelationParameters& p) { p.max = max; });
}
inline RelationParameters with_axis(Axis axis) {
  return with([&](RelationParameters& p) { p.axis = axis; });
}

inline constexpr std::array<double, 3> kBed{1.6, 2.0, 0.5}, kStand{0.4, 0.4, 0.5}, kChair{0.4, 0.4, 0.8};

// A bed with its head at the back wall, its centre at (2.5, 3.0): x from 1.7 to 3.3, y from 2.0 to 4.0.
inline TestRoom& bed(TestRoom& room) { return room.add("bed", "bed", kBed, {2.5, 3.0}); }
// A table of 1.6 × 0.8 m in the middle of the room, free below.
inline TestRoom& table(TestRoom& room) {
  return room.add("table", "dining_table", {1.6, 0.8, 0.75}, {2.5, 2.0}).space("below", {-0.8, -0.4, 0}, {0.8, 0.4, 0.69}, false);
}

// One file a family.
std::vector<Limit> paper_limits();
std::vector<Limit> room_limits();
std::vector<Limit> opening_limits();
std::vector<Limit> pair_limits();
std::vector<Limit> height_limits();
std::vector<Limit> group_limits();
std::vector<Limit> space_limits();

// All of them.
const std::vector<Limit>& limits();

// The room of that limit after that share of the breaking move.
Layout furnished(const Limit& limit, double share);

// For names of test cases.
std::string test_name(std::string words);

}  // namespace layoutbox::checks
