#include "layoutbox/solve/objective/terms.h"

#include <algorithm>
#include <array>

#include "layoutbox/solve/objective/access.h"
#include "layoutbox/solve/objective/cost.h"

namespace layoutbox::placement {
namespace {

using Account = CostTerm::Account;
using Price = CostTerm::Price;
using Shares = std::vector<std::size_t>;

std::size_t count_items(const PlacementModel& model) { return model.items.size(); }
std::size_t count_constraints(const PlacementModel& model) { return model.constraints.size(); }
std::size_t count_one(const PlacementModel&) { return 1; }

// ---- sizes: a share an item
std::int64_t evaluate_size(const PlacementModel& model, std::size_t share, const Placements& placements, std::int64_t) {
  const ItemId item(share);
  const int state = placements[item].state;
  return state < 0 ? 0 : size_cost(model.items[item].states[state]);
}

void touched_sizes(const PlacementModel&, const Change& change, Shares& shares) {
  shares.clear();
  for (const ItemId item : change.moved) shares.push_back(item.index());
}

std::int64_t least_size(const Standing& standing, std::int64_t) { return size_cost(standing.state); }

// ---- wishes: a share a constraint
constexpr std::array<Account, 3> kWishAccounts{{{"habits"}, {"relations"}, {"stay", false}}};
enum WishAccount : std::size_t { kOfHabits, kOfRelations, kOfStaying };

std::size_t account_of_wish(const PlacementModel& model, std::size_t index) {
  const Constraint& constraint = model.constraints[ConstraintId(index)];
  if (constraint.stay || !constraint.words.empty()) return kOfStaying;
  return !constraint.relation.exists() ? kOfHabits : kOfRelations;
}

std::int64_t evaluate_wish(const PlacementModel& model, std::size_t constraint, const Placements& placements, std::int64_t) {
  return constraint_cost(model, model.constraints[ConstraintId(constraint)], placements);
}

void touched_wishes(const PlacementModel& model, const Change& change, Shares& shares) {
  shares.clear();
  for (const ItemId item : change.moved) {
    for (const ConstraintId c : model.touching[item]) shares.push_back(c.index());
  }
  std::sort(shares.begin(), shares.end());
  shares.erase(std::unique(shares.begin(), shares.end()), shares.end());
}

std::int64_t least_wishes(const Standing& standing, std::int64_t enough) { return least_wish_cost(standing.region, standing.soft, enough); }

// ---- access: a share an item
constexpr std::array<Account, 1> kAccessAccount{{{"access"}}};
constexpr std::array<Price, 3> kAccessPrices{
    {{kCostWeights.access, "a thing of whose used sides none has a free strip, 0.2 m deep and 0.05 m off"},
     {kCostWeights.wanted, "a side at which the catalogue's clearance is blocked"},
     {kCostWeights.swing, "a metre that something reaches into a door's swing that had to be given up"}}};

std::int64_t evaluate_access(const PlacementModel& model, std::size_t share, const Placements& placements, std::int64_t) {
  const ItemId item(share);
  return placements[item].state < 0 ? 0 : access_cost_of(model, item, placements);
}

void touched_access(const PlacementModel& model, const Change& change, Shares& shares) {
  shares.clear();
  for (const ItemId item : access_touched(model, change.before, change.after, change.moved)) shares.push_back(item.index());
}

// ---- ways: one share
constexpr std::array<Account, 1> kWaysAccount{{{"ways"}}};
constexpr std::array<Price, 3> kWaysPrices{
    {{kCostWeights.walk, "a thousandth of the free floor that is cut off for a person 0.2 m wide"},
     {kCostWeights.narrow, "a thing of 0.4 m² and more to none of whose used sides a way 0.6 m wide leads from a door"},
     {kCostWeights.unreached, "a relation `reachable` that does not hold"}}};

std::int64_t evaluate_ways(const PlacementModel& model, std::size_t, const Placements& placements, std::int64_t enough) {
  return ways_cost(model, placements, enough);
}

void touched_ways(const PlacementModel&, const Change&, Shares& shares) { shares.assign(1, 0); }

constexpr std::array<Account, 1> kSizesAccount{{{"sizes"}}};
constexpr std::array<Price, 1> kSizesPrices{{{kCostWeights.size_step, "a step below the usual size"}}};

constexpr std::array<CostTerm, 4> kTerms{{
    {TermKind::kSizes, "things have their usual size", kSizesPrices, kSizesAccount, false, count_items, evaluate_size, touched_sizes,
     least_size},
    {TermKind::kWishes,
     "what habits, relations and an earlier layout wish for",
     {},
     kWishAccounts,
     false,
     count_constraints,
     evaluate_wish,
     touched_wishes,
     least_wishes,
     account_of_wish},
    {TermKind::kAccess, "the floor at the used sides of things is free", kAccessPrices, kAccessAccount, false, count_items, evaluate_access,
     touched_access},
    {TermKind::kWays, "there are ways to walk", kWaysPrices, kWaysAccount, true, count_one, evaluate_ways, touched_ways},
}};

}  // namespace

std::span<const CostTerm> cost_terms() { return kTerms; }

std::int64_t evaluate(const CostTerm& term, const PlacementModel& model, const Placements& placements, std::int64_t enough) {
  std::int64_t cost = 0;
  for (std::size_t share = 0, count = term.shares(model); share < count && cost < enough; ++share)
    cost += term.evaluate(model, share, placements, enough - cost);
  return cost;
}

std::int64_t delta(const CostTerm& term, const PlacementModel& model, const Change& change) {
  Shares shares;
  term.touched(model, change, shares);
  std::int64_t more = 0;
  for (const std::size_t share : shares)
    more += term.evaluate(model, share, change.after, kAllOfIt) - term.evaluate(model, share, change.before, kAllOfIt);
  return more;
}

std::int64_t total_cost(const PlacementModel& model, const Placements& placements) {
  std::int64_t cost = 0;
  for (const CostTerm& term : kTerms) cost += evaluate(term, model, placements);
  return cost;
}

std::int64_t late_cost(const PlacementModel& model, const Placements& placements, std::int64_t enough) {
  std::int64_t cost = 0;
  for (const CostTerm& term : kTerms) {
    if (term.late) cost += evaluate(term, model, placements, enough - cost);
  }
  return cost;
}

std::int64_t least_cost(const Standing& standing, std::int64_t enough) {
  std::int64_t cost = 0;
  for (const CostTerm& term : kTerms) {
    if (term.lower_bound != nullptr) cost += term.lower_bound(standing, enough - cost);
  }
  return cost;
}

std::map<std::string_view, std::int64_t> scored_costs(const PlacementModel& model, const Placements& placements) {
  std::map<std::string_view, std::int64_t> costs;
  for (const CostTerm& term : kTerms) {
    for (const Account& account : term.accounts) {
      if (account.scored) costs[account.name] = 0;
    }
    for (std::size_t share = 0, count = term.shares(model); share < count; ++share) {
      const Account& account = term.accounts[term.account == nullptr ? 0 : term.account(model, share)];
      if (account.scored) costs[account.name] += term.evaluate(model, share, placements, kAllOfIt);
    }
  }
  return costs;
}

}  // namespace layoutbox::placement
