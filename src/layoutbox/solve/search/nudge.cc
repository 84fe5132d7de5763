// Neighbours that can only move together: what touches a thing goes with it, in ever smaller steps.
#include "layoutbox/solve/search/search.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kTouching = 20;
constexpr Mm kLongest = 512;  // mm
constexpr std::int64_t kStepsOfNudge = 10;
constexpr std::int64_t kWhole = 6;  // one nudge in so many moves all that belongs together

bool touch(const GridBox& a, const GridBox& b) {
  for (int k = 0; k < 3; ++k) {
    if (a.lo[k] - kTouching > b.hi[k] || b.lo[k] - kTouching > a.hi[k]) return false;
  }
  return true;
}

}  // namespace

// The thing, some of those that touch it, and all that hangs on them.
std::vector<ItemId> Search::cluster_of(ItemId item) {
  std::vector<ItemId> cluster, more;
  group_of(dependencies_, placements_, item, cluster);
  const GridBox box = box_of(model_.items[item], placements_[item]);
  for (const ItemId other : model_.items.ids()) {
    const bool apart = placements_[other].state < 0 || model_.items[other].is_opening() || model_.pair(item, other) == PairRule::kFree;
    if (apart || stays(model_.items[other]) || !touch(box, box_of(model_.items[other], placements_[other])) || random_.below(2) == 0)
      continue;
    group_of(dependencies_, placements_, other, more);
    for (const ItemId m : more) {
      if (std::find(cluster.begin(), cluster.end(), m) == cluster.end()) cluster.push_back(m);
    }
  }
  return cluster;
}

// The thing and all that habits tie to it, directly or not: a sofa with its table, chairs, rug and television.
std::vector<ItemId> Search::company_of(ItemId item) const {
  std::vector<ItemId> company{item};
  for (std::size_t i = 0; i < company.size(); ++i) {
    for (const std::vector<ItemId>* others : {&dependencies_.hosts[company[i]], &dependencies_.tenants[company[i]]}) {
      for (const ItemId other : *others) {
        const bool apart = placements_[other].state < 0 || model_.items[other].is_opening() || stays(model_.items[other]);
        if (!apart && std::find(company.begin(), company.end(), other) == company.end()) company.push_back(other);
      }
    }
  }
  return company;
}

// True: it is better there.
bool Search::shift(const std::vector<ItemId>& cluster, int axis, Mm by, std::int64_t least_gain, Budget& budget) {
  const Placements before = placements_;
  for (const ItemId member : cluster) placements_[member].at[axis] += by;
  budget.count(kStepsOfNudge * static_cast<std::int64_t>(cluster.size()));
  if (may_stay(cluster, budget) && is_better(before, cluster, budget, least_gain)) return true;
  placements_ = before;
  return false;
}

bool Search::nudge(ItemId item, Budget& budget) {
  // Whole companies now and then; the ways, costly to measure, are looked at only where that gains something without them.
  const bool whole = random_.below(kWhole) == 0;
  const std::vector<ItemId> cluster = whole ? company_of(item) : cluster_of(item);
  return nudge_all(cluster, whole ? 1 : kLeastGain, budget);
}

// All of them together, to either side in ever smaller steps.
bool Search::nudge_all(const std::vector<ItemId>& cluster, std::int64_t least_gain, Budget& budget) {
  if (std::any_of(cluster.begin(), cluster.end(), [&](ItemId m) { return stays(model_.items[m]); })) return false;
  bool any = false;
  for (Mm by = kLongest; by > 0 && !budget.stopped; by /= 2) {
    for (const int axis : {0, 1})
      any = shift(cluster, axis, by, least_gain, budget) || shift(cluster, axis, -by, least_gain, budget) || any;
  }
  return any;
}

// Does a habit or a relation speak of some of both?
bool Search::are_tied(const std::vector<ItemId>& a, const std::vector<ItemId>& b) const {
  constexpr std::size_t kFew = 4;  // what speaks of all the room ties nobody
  return std::ranges::any_of(model_.constraints, [&](const Constraint& constraint) {
    return std::ranges::any_of(constraint.formulas, [&](const Formula& formula) {
      const auto speaks_of = [&](const std::vector<ItemId>& company) {
        return std::ranges::any_of(formula.items, [&](ItemId item) { return std::ranges::find(company, item) != company.end(); });
      };
      return formula.items.size() <= kFew && speaks_of(a) && speaks_of(b);
    });
  });
}

// Each company as a whole where it is best, and every two that have to do with each other: those round the sofa with the screen across
// from them. Chance seldom does that, as all but one of its many ways there are worse.
void Search::settle(Budget& budget) {
  std::vector<std::vector<ItemId>> companies;
  for (const ItemId item : movable()) {
    std::vector<ItemId> company = company_of(item);
    std::ranges::sort(company);
    if (model_.items[item].is_opening() || std::ranges::find(companies, company) != companies.end()) continue;
    companies.push_back(std::move(company));
  }
  for (std::size_t i = 0; i < companies.size() && !budget.stopped; ++i) {
    if (companies[i].size() > 1) nudge_all(companies[i], 1, budget);
    for (std::size_t j = 0; j < i && !budget.stopped; ++j) {
      if (!are_tied(companies[i], companies[j])) continue;
      std::vector<ItemId> both = companies[i];
      both.insert(both.end(), companies[j].begin(), companies[j].end());
      nudge_all(both, 1, budget);
    }
  }
}

}  // namespace layoutbox::placement
