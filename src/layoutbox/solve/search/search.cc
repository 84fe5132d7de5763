#include "layoutbox/solve/search/search.h"

#include "layoutbox/solve/objective/cost.h"

namespace layoutbox::placement {
namespace {

constexpr std::size_t kWatchedTries = 160;
constexpr int kFirst = 2;                    // things that are placed first in an unlike start
constexpr std::int64_t kNoiseOfStart = 500;  // points
constexpr int kEjectionsPerItem = 6;

}  // namespace

Search::Search(const PlacementModel& model, Scope scope, std::uint64_t seed, int most_size_step)
    : model_(model),
      finder_(model, std::move(scope)),
      random_(seed),
      most_size_step_(most_size_step),
      placements_(model.items.size()),
      bonus_(model.items.size(), 0),
      dependencies_(model) {}

bool Search::watched_fit(ItemId item, Budget& budget) {
  CandidateOptions options;
  options.first_legal = true;
  options.most_size_step = most_size_step_;
  for (const ItemId dependent : dependencies_.tenants[item]) {
    if (bonus_[dependent] == 0 || placements_[dependent].state >= 0 || is_out(dependent)) continue;
    if (finder_.find(placements_, dependent, options, budget).empty()) return false;
  }
  return true;
}

bool Search::place(ItemId item, std::int64_t noise, Budget& budget) {
  const bool watched =
      std::any_of(dependencies_.tenants[item].begin(), dependencies_.tenants[item].end(), [&](ItemId d) { return bonus_[d] > 0; });
  CandidateOptions options;
  options.most = watched ? kWatchedTries : 1;
  options.diverse = watched;
  options.noise = noise;
  options.random = &random_;
  options.most_size_step = most_size_step_;
  const std::vector<Candidate> found = finder_.find(placements_, item, options, budget);
  for (const Candidate& candidate : found) {
    placements_[item] = candidate.placement;
    if (!watched || watched_fit(item, budget)) return true;
  }
  placements_[item] = {};
  return false;
}

bool Search::try_order(const std::vector<ItemId>& order, std::int64_t noise, Budget& budget) {
  std::fill(placements_.begin(), placements_.end(), Placement{});
  failed_.clear();
  for (const ItemId item : order) {
    if (budget.stopped || !place(item, noise, budget)) failed_.push_back(item);
  }
  return failed_.empty();
}

bool Search::is_free(ItemId item, const Placement& placement) const {
  const GridBox box = box_of(model_.items[item], placement);
  if (!model_.items[item].is_opening() && !(intersection(box, model_.room) == box)) return false;
  return finder_.legal(placements_, item, placement);
}

// The same of several where they stand; what they share is looked at once.
bool Search::may_stay(const std::vector<ItemId>& group, Budget& budget) const {
  std::vector<ConstraintId> constraints;
  for (const ItemId item : group) {
    budget.heed(static_cast<std::int64_t>(model_.items.size()));
    if (budget.stopped || !is_free(item, placements_[item])) return false;
    constraints.insert(constraints.end(), model_.touching[item].begin(), model_.touching[item].end());
  }
  std::ranges::sort(constraints);
  const auto repeated = std::ranges::unique(constraints);
  constraints.erase(repeated.begin(), repeated.end());
  return std::ranges::all_of(constraints, [&](ConstraintId c) {
    return !finder_.enforced(c) || std::ranges::all_of(model_.constraints[c].formulas, [&](const Formula& formula) {
      return !formula.cases.empty() && !(all_placed(formula, placements_) && miss_of(model_, formula, placements_) > 0);
    });
  });
}

// Is the room there free, and does all that is asked of it hold, as far as the others are placed?
bool Search::may_stay(ItemId item, const Placement& placement) const {
  if (!is_free(item, placement)) return false;
  Placements probe = placements_;
  probe[item] = placement;
  for (const ConstraintId c : model_.touching[item]) {
    if (!finder_.enforced(c)) continue;
    for (const Formula& formula : model_.constraints[c].formulas) {
      if (formula.cases.empty()) return false;
      if (all_placed(formula, probe) && miss_of(model_, formula, probe) > 0) return false;
    }
  }
  return true;
}

// What can stay where an earlier layout had it stays; then everything else looks for a place near.
bool Search::try_start(const std::vector<ItemId>& order, Budget& budget) {
  std::fill(placements_.begin(), placements_.end(), Placement{});
  failed_.clear();
  std::vector<ItemId> rest;
  for (const ItemId item : order) {
    if (model_.start[item].state >= 0 && may_stay(item, model_.start[item])) {
      placements_[item] = model_.start[item];
    } else {
      rest.push_back(item);
    }
  }
  for (const ItemId item : rest) {
    if (budget.stopped || !place(item, 0, budget)) failed_.push_back(item);
  }
  return failed_.empty();
}

// Takes an item and what hangs on it out, and puts them in the queue, hosts first.
void Search::take_out(ItemId item, std::vector<ItemId>& queue) {
  std::vector<ItemId> group;
  group_of(dependencies_, placements_, item, group);
  for (const ItemId member : group) {
    if (model_.items[member].fixed || model_.items[member].locked) continue;
    placements_[member] = {};
    if (std::find(queue.begin(), queue.end(), member) == queue.end()) queue.push_back(member);
  }
}

// What found no place pushes others out, who look for a new one; who is pushed out often becomes dear to push.
bool Search::repair(Budget& budget) {
  std::vector<ItemId> queue = failed_;
  ById<ItemId, std::int64_t> price(model_.items.size());
  for (const ItemId i : price.ids()) {
    const Item& item = model_.items[i];
    price[i] = stays(item) ? -1 : kPoint * (100 + std::int64_t{item.states[0].extent[0]} * item.states[0].extent[1] / 10000);
  }
  const Placements before = placements_;
  const int limit = kEjectionsPerItem * static_cast<int>(model_.items.size()) + 20;
  for (int step = 0; step < limit && !queue.empty() && !budget.spent(); ++step) {
    const ItemId item = queue.front();
    queue.erase(queue.begin());
    if (place(item, 0, budget)) continue;
    ++bonus_[item];
    CandidateOptions options;
    options.eject_price = &price;
    options.noise = kPoint * 40;
    options.random = &random_;
    options.most_size_step = most_size_step_;
    const std::vector<Candidate> found = finder_.find(placements_, item, options, budget);
    if (!found.empty()) {
      placements_[item] = found[0].placement;
      for (const ItemId other : found[0].hit) {
        price[other] += price[other] / 2 + 50 * kPoint;
        take_out(other, queue);
      }
      if (placements_[item].state < 0) continue;  // it hung on what it pushed out
      price[item] += 100 * kPoint;
      continue;
    }
    // What it refers to stands where it cannot follow.
    std::vector<ItemId> again;
    for (const ItemId other : dependencies_.hosts[item]) {
      if (price[other] >= 0 && placements_[other].state >= 0) take_out(other, again);
    }
    if (again.empty()) break;
    if (std::find(again.begin(), again.end(), item) == again.end()) again.push_back(item);
    for (const ItemId other : queue) {
      if (std::find(again.begin(), again.end(), other) == again.end()) again.push_back(other);
    }
    queue = std::move(again);
  }
  bool all = true;
  for (const ItemId i : placements_.ids()) all = all && (is_out(i) || placements_[i].state >= 0);
  if (all) failed_.clear();
  if (!all) placements_ = before;
  return all;
}

bool Search::construct(int restarts, Budget& budget) {
  Placements best;
  std::vector<ItemId> best_failed;
  for (int attempt = 0; attempt <= restarts; ++attempt) {
    if ((model_.start.empty() ? try_order(order(bonus_), 0, budget) : try_start(order(bonus_), budget)) || repair(budget)) return true;
    if (best.empty() || failed_.size() < best_failed.size()) best = placements_, best_failed = failed_;
    if (budget.spent()) break;
    bonus_[failed_[0]] += 1 + attempt / 4;
  }
  placements_ = std::move(best);
  failed_ = std::move(best_failed);
  return false;
}

bool Search::construct_unlike(Budget& budget) {
  if (model_.items.empty()) return true;
  std::fill(bonus_.begin(), bonus_.end(), 0);
  ById<ItemId, int> first(model_.items.size(), 0);
  for (int k = 0; k < kFirst; ++k) ++first[ItemId(static_cast<std::size_t>(random_.below(static_cast<std::int64_t>(first.size()))))];
  const std::int64_t noise = kPoint * (1 + random_.below(kNoiseOfStart));
  return try_order(order(first), noise, budget) || repair(budget);
}

}  // namespace layoutbox::placement
