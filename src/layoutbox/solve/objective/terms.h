// The terms that a layout's cost is the sum of, in one list: search, proof, score and the table in docs/solve.md all go through it.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "layoutbox/solve/model/model.h"
#include "layoutbox/solve/model/reduced.h"

namespace layoutbox::placement {

inline constexpr std::int64_t kAllOfIt = std::numeric_limits<std::int64_t>::max();

// Two arrangements of which only these items differ, which are placed in both.
struct Change {
  const Placements& before;
  const Placements& after;
  const std::vector<ItemId>& moved;
};

// One item in one state somewhere in a region, while all else stays.
struct Standing {
  const State& state;
  const Region& region;
  std::span<const SoftFormula> soft;  // what is wished for and speaks of the item
};

// By which the proof knows how a term is written down for CP-SAT.
enum class TermKind { kSizes, kWishes, kAccess, kWays };

struct CostTerm {
  // Under which a share is entered in a layout's score; what is not scored counts while a layout is looked for.
  struct Account {
    std::string_view name;
    bool scored = true;
  };
  // So many points for each of that.
  struct Price {
    int points = 0;
    std::string_view of;
  };

  TermKind kind;
  std::string_view meaning;
  std::span<const Price> prices;      // none: each share has its own
  std::span<const Account> accounts;  // of which the first is that of all shares where `account` is null
  bool late = false;                  // costly to measure: only for what is better without it
  // A term is a sum of so many shares, most of which a move does not touch.
  std::size_t (*shares)(const PlacementModel& model) = nullptr;
  // Where it comes to `enough`, perhaps less than all of it, but so much. Nothing for what is not placed.
  std::int64_t (*evaluate)(const PlacementModel& model, std::size_t share, const Placements& placements, std::int64_t enough) = nullptr;
  // All shares that the change may have made dearer or cheaper, each once.
  void (*touched)(const PlacementModel& model, const Change& change, std::vector<std::size_t>& shares) = nullptr;
  // The shares that speak of the item cost at least so much together; from `enough` on perhaps more. Null: nothing is known.
  std::int64_t (*lower_bound)(const Standing& standing, std::int64_t enough) = nullptr;
  std::size_t (*account)(const PlacementModel& model, std::size_t share) = nullptr;
};

// What takes longest comes last.
std::span<const CostTerm> cost_terms();

std::int64_t evaluate(const CostTerm& term, const PlacementModel& model, const Placements& placements, std::int64_t enough = kAllOfIt);
// How much more the term costs after the change.
std::int64_t delta(const CostTerm& term, const PlacementModel& model, const Change& change);

// Of all terms together.
std::int64_t total_cost(const PlacementModel& model, const Placements& placements);
// Of those that are late; 0 where `enough` is not above 0.
std::int64_t late_cost(const PlacementModel& model, const Placements& placements, std::int64_t enough = kAllOfIt);
// What all together cost at least; from `enough` on perhaps more.
std::int64_t least_cost(const Standing& standing, std::int64_t enough);
// What is entered under each account that is scored.
std::map<std::string_view, std::int64_t> scored_costs(const PlacementModel& model, const Placements& placements);

}  // namespace layoutbox::placement
