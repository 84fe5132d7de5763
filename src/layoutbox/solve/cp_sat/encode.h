// The small form as a CP-SAT model: one Boolean per state and per case, half-reified linear constraints, and for every pair of bodies
// a Boolean per side on which they may pass. Each relation and each object hangs on an assumption literal, so that a proof that
// nothing exists names who takes part.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "layoutbox/solve/cp_sat/wire.h"
#include "layoutbox/solve/model/model.h"
#include "layoutbox/solve/model/scope.h"

namespace layoutbox::placement {

// A bound that no sum of lengths reaches.
inline constexpr std::int64_t kNoBound = std::numeric_limits<std::int64_t>::max() / 4;

// What can be asked to hold or not: a constraint of the model or the presence of an item.
struct Demand {
  ConstraintId constraint;
  ItemId item;  // where there is no constraint

  static Demand of(ConstraintId constraint) { return {constraint, {}}; }
  static Demand of_item(ItemId item) { return {{}, item}; }
  bool is_item() const { return !constraint.exists(); }
  int number() const { return is_item() ? item.number() : constraint.number(); }  // among those of its kind
  friend bool operator==(const Demand&, const Demand&) = default;
};

class Encoding {
 public:
  // Items of constraints that are given up are not bound by them.
  // kPlacing: every solution is a layout. kProving: every layout is a solution, so that what has none has no layout; free spaces count
  // between all bodies then, not only between those that belong together.
  Encoding(const PlacementModel& model, const Scope& scope, Purpose purpose = Purpose::kPlacing);

  // The model with exactly these demands assumed (by their index in `demands()`); all others are free.
  std::string bytes(const std::vector<char>& demanded);
  const std::vector<Demand>& demands() const { return demands_; }
  std::size_t variable_count() const { return cp_.variable_count(); }
  // The demands whose literals are in a core.
  std::vector<std::size_t> demands_in(const std::vector<CpLiteral>& core) const;

  // Only layouts that cost at most so much, in thousandths of a point; of the terms that are not linear those of floor that is wanted free
  // count where it is said, ways never.
  void bound_cost(std::int64_t most, bool with_access);

  void hint(const Placements& placements);
  Placements placements_of(const std::vector<std::int64_t>& values) const;

 private:
  struct ItemVariables {
    std::array<std::int32_t, 3> position{};
    std::vector<CpLiteral> states;  // empty where there is only one
    CpLiteral present = 0;
    bool used = false;
  };
  // Σ terms + constant ≥ 0.
  struct Expanded {
    std::vector<CpTerm> terms;
    std::int64_t constant = 0;
  };

  void add_item(ItemId item);
  void add_constraint(ConstraintId constraint, CpLiteral when);
  void require_present(const Case& one, CpLiteral when);
  void add_case(const Case& one, std::span<const CpLiteral> when);
  void add_pair(ItemId a, ItemId b);
  void add_outside(ItemId item);
  void add_size_costs(std::vector<CpTerm>& total);
  void add_wish_costs(std::int64_t most, std::vector<CpTerm>& total);
  void add_case_cost(const Constraint& constraint, const Case& one, std::int32_t cost, std::int64_t most, CpLiteral when);
  void add_access_cost(ItemId item, std::int64_t most, std::vector<CpTerm>& total);
  std::int32_t blocked_share(ItemId item, const std::vector<GridBox>& strip);
  std::int32_t shared_length(ItemId item, const std::vector<GridBox>& strip, ItemId body, int axis);
  // The bodies (or clear boxes) a and b, given by their state-dependent offsets, do not share room.
  // `headings`: they may also pass along a slanted wall.
  void add_disjoint(ItemId a, const std::vector<GridBox>& part_a, ItemId b, const std::vector<GridBox>& part_b,
                    const std::vector<CpLiteral>& when, bool headings = false);
  Expanded expand(const Linear& form) const;
  void add_offset(Expanded& out, ItemId item, std::int64_t factor, const std::vector<GridBox>& parts, int axis, bool high) const;
  void require(const Expanded& form, std::span<const CpLiteral> when);
  CpLiteral always() const { return always_; }

  const PlacementModel& model_;
  Purpose purpose_;
  CpModel cp_;
  CpLiteral always_ = 0;
  ById<ItemId, ItemVariables> items_;
  std::vector<Demand> demands_;
  std::vector<CpLiteral> demand_literals_;
};

}  // namespace layoutbox::placement
