// Why there is no layout: sums that cannot fit, and smallest sets of relations and objects that clash, by CP-SAT's assumptions.
#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "layoutbox/scene/layout.h"
#include "layoutbox/solve/cp_sat/encode.h"
#include "layoutbox/solve/cp_sat/library.h"
#include "layoutbox/solve/model/model.h"

namespace layoutbox::placement {

// Some demands that cannot all hold.
struct Clash {
  std::vector<Demand> demands;
  bool minimal = true;
  bool proven = true;    // else nothing was found, and no proof either
  std::string sentence;  // empty: describe_clash says it
};

struct ProofLimits {
  std::uint64_t seed = 1;
  double deterministic_time = 0.5;  // of one question to CP-SAT
  double seconds = 30;              // wall clock, the safety net
  const std::atomic<bool>* stop = nullptr;
};

struct Proof {
  enum class Outcome { kLayout, kClash, kUnknown } outcome = Outcome::kUnknown;
  Placements placements;  // kLayout
  Clash clash;            // kClash
  double deterministic_time = 0;
};

// Finds a layout or proves that there is none. `hint`: where the search had things (states of −1: nowhere).
Result<Proof> decide(const PlacementModel& model, const CpSatLibrary& library, const Scope& scope, const Placements& hint,
                     const ProofLimits& limits);

// Sums that show at once that something cannot be: an object larger than the room, more width at a wall than it has, more floor
// covered than there is.
std::vector<Clash> clashes_by_sums(const PlacementModel& model, const Scope& scope);

// One English sentence with numbers.
std::string describe_clash(const PlacementModel& model, const Clash& clash);

// "1.20 m".
std::string metres(Mm length);
// "the bed", "the nightstand 2".
std::string object_in_words(const PlacementModel& model, ItemId item);
// "the 3 beds and 2 of the 3 desks".
std::string things_in_words(const PlacementModel& model, const std::vector<ItemId>& items);
// The relation's own sentence from the table, filled in.
std::string relation_in_words(const PlacementModel& model, const Relation& relation);

}  // namespace layoutbox::placement
