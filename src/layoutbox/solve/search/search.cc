#include "layoutbox/solve/search/search.h"

#include "layoutbox/solve/objective/cost.h"

namespace layoutbox::placement {
namespace {

constexpr std::size_t kWatchedTries = 160;
constexpr int kFirst = 2;                                           // things that are placed first in an unlike start
constexpr std::int64_t kNoiseOfStart = 500, kNoiseOfShaking = 400;  // points
constexpr std::int64_t kShaken = 3;                                 // things at once, at most
constexpr int kEjectionsPerItem = 6;
constexpr std::int64_t kPushing = 60 * kPoint;  // what it takes to push another thing away

// What any of them is told to face, then those that face it, then the others.
std::vector<std::string> in_facing_order(const SceneGraph& scene, const std::vector<std::string>& ids) {
  std::vector<std::string> order;
  const auto add = [&](const std::string& id) {
    if (std::find(order.begin(), order.end(), id) == order.end()) order.push_back(id);
  };
  const auto is_member = [&](const std::string& id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); };
  for (const bool faced : {true, false}) {
    for (const Relation& r : scene.relations) {
      if (r.type != RelationType::kFacing || r.targets.empty() || !is_member(r.targets[0])) continue;
      for (const std::string& id : faced ? r.references : r.targets) {
        if (!faced || !is_member(id)) add(id);
      }
    }
  }
  for (const std::string& id : ids) add(id);
  return order;
}

}  // namespace

void KnownCosts::are_of(const PlacementModel& model, const Placements& placements) {
  if (of == placements && constraints.size() == model.constraints.size()) return;
  std::vector<int> moved;
  bool fresh = constraints.size() != model.constraints.size();
  for (std::size_t i = 0; i < placements.size() && !fresh; ++i) {
    if (of[i] == placements[i]) continue;
    moved.push_back(static_cast<int>(i));
    fresh = of[i].state < 0 || placements[i].state < 0;
  }
  if (fresh) {
    constraints.assign(model.constraints.size(), std::nullopt);
    access.assign(model.items.size(), std::nullopt);
  } else {
    for (const int item : moved) {
      for (const int c : model.touching[item]) constraints[static_cast<std::size_t>(c)].reset();
    }
    for (const int item : access_touched(model, of, placements, moved)) access[static_cast<std::size_t>(item)].reset();
  }
  of = placements;
}

Search::Search(const PlacementModel& model, Scope scope, std::uint64_t seed, int most_size_step)
    : model_(model),
      finder_(model, std::move(scope)),
      random_(seed),
      most_size_step_(most_size_step),
      placements_(model.items.size()),
      bonus_(model.items.size(), 0),
      dependencies_(model) {}

bool Search::watched_fit(int item, Budget& budget) {
  CandidateOptions options;
  options.first_legal = true;
  options.most_size_step = most_size_step_;
  for (const int dependent : dependencies_.tenants[item]) {
    if (bonus_[dependent] == 0 || placements_[dependent].state >= 0 || is_out(dependent)) continue;
    if (finder_.find(placements_, dependent, options, budget).empty()) return false;
  }
  return true;
}

bool Search::place(int item, std::int64_t noise, Budget& budget) {
  const bool watched =
      std::any_of(dependencies_.tenants[item].begin(), dependencies_.tenants[item].end(), [&](int d) { return bonus_[d] > 0; });
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

bool Search::try_order(const std::vector<int>& order, std::int64_t noise, Budget& budget) {
  std::fill(placements_.begin(), placements_.end(), Placement{});
  failed_.clear();
  for (const int item : order) {
    if (budget.stopped || !place(item, noise, budget)) failed_.push_back(item);
  }
  return failed_.empty();
}

bool Search::is_free(int item, const Placement& placement) const {
  const GridBox box = box_of(model_.items[item], placement);
  if (!model_.items[item].is_opening() && !(intersection(box, model_.room) == box)) return false;
  return finder_.legal(placements_, item, placement);
}

// The same of several where they stand; what they share is looked at once.
bool Search::may_stay(const std::vector<int>& group, Budget& budget) const {
  std::vector<int> constraints;
  for (const int item : group) {
    budget.heed(static_cast<std::int64_t>(model_.items.size()));
    if (budget.stopped || !is_free(item, placements_[item])) return false;
    constraints.insert(constraints.end(), model_.touching[item].begin(), model_.touching[item].end());
  }
  std::ranges::sort(constraints);
  const auto repeated = std::ranges::unique(constraints);
  constraints.erase(repeated.begin(), repeated.end());
  return std::ranges::all_of(constraints, [&](int c) {
    return !finder_.enforced(c) || std::ranges::all_of(model_.constraints[c].formulas, [&](const Formula& formula) {
      return !formula.cases.empty() && !(all_placed(formula, placements_) && miss_of(model_, formula, placements_) > 0);
    });
  });
}

// Is the room there free, and does all that is asked of it hold, as far as the others are placed?
bool Search::may_stay(int item, const Placement& placement) const {
  if (!is_free(item, placement)) return false;
  Placements probe = placements_;
  probe[item] = placement;
  for (const int c : model_.touching[item]) {
    if (!finder_.enforced(c)) continue;
    for (const Formula& formula : model_.constraints[c].formulas) {
      if (formula.cases.empty()) return false;
      if (all_placed(formula, probe) && miss_of(model_, formula, probe) > 0) return false;
    }
  }
  return true;
}

// What can stay where an earlier layout had it stays; then everything else looks for a place near.
bool Search::try_start(const std::vector<int>& order, Budget& budget) {
  std::fill(placements_.begin(), placements_.end(), Placement{});
  failed_.clear();
  std::vector<int> rest;
  for (const int item : order) {
    if (model_.start[item].state >= 0 && may_stay(item, model_.start[item])) {
      placements_[item] = model_.start[item];
    } else {
      rest.push_back(item);
    }
  }
  for (const int item : rest) {
    if (budget.stopped || !place(item, 0, budget)) failed_.push_back(item);
  }
  return failed_.empty();
}

// Takes an item and what hangs on it out, and puts them in the queue, hosts first.
void Search::take_out(int item, std::vector<int>& queue) {
  std::vector<int> group;
  group_of(dependencies_, placements_, item, group);
  for (const int member : group) {
    if (model_.items[member].fixed || model_.items[member].locked) continue;
    placements_[member] = {};
    if (std::find(queue.begin(), queue.end(), member) == queue.end()) queue.push_back(member);
  }
}

// What found no place pushes others out, who look for a new one; who is pushed out often becomes dear to push.
bool Search::repair(Budget& budget) {
  std::vector<int> queue = failed_;
  std::vector<std::int64_t> price(model_.items.size());
  for (std::size_t i = 0; i < price.size(); ++i) {
    const Item& item = model_.items[i];
    price[i] = stays(item) ? -1 : kPoint * (100 + std::int64_t{item.states[0].extent[0]} * item.states[0].extent[1] / 10000);
  }
  const Placements before = placements_;
  const int limit = kEjectionsPerItem * static_cast<int>(model_.items.size()) + 20;
  for (int step = 0; step < limit && !queue.empty() && !budget.spent(); ++step) {
    const int item = queue.front();
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
      for (const int other : found[0].hit) {
        price[other] += price[other] / 2 + 50 * kPoint;
        take_out(other, queue);
      }
      if (placements_[item].state < 0) continue;  // it hung on what it pushed out
      price[item] += 100 * kPoint;
      continue;
    }
    // What it refers to stands where it cannot follow.
    std::vector<int> again;
    for (const int other : dependencies_.hosts[item]) {
      if (price[other] >= 0 && placements_[other].state >= 0) take_out(other, again);
    }
    if (again.empty()) break;
    if (std::find(again.begin(), again.end(), item) == again.end()) again.push_back(item);
    for (const int other : queue) {
      if (std::find(again.begin(), again.end(), other) == again.end()) again.push_back(other);
    }
    queue = std::move(again);
  }
  bool all = true;
  for (std::size_t i = 0; i < placements_.size(); ++i) all = all && (is_out(static_cast<int>(i)) || placements_[i].state >= 0);
  if (all) failed_.clear();
  if (!all) placements_ = before;
  return all;
}

bool Search::construct(int restarts, Budget& budget) {
  Placements best;
  std::vector<int> best_failed;
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
  std::vector<int> first(model_.items.size(), 0);
  for (int k = 0; k < kFirst; ++k) ++first[static_cast<std::size_t>(random_.below(static_cast<std::int64_t>(first.size())))];
  const std::int64_t noise = kPoint * (1 + random_.below(kNoiseOfStart));
  return try_order(order(first), noise, budget) || repair(budget);
}

// How much less what touches the group costs than before it moved; ways to walk apart. No more than `least_gain`: perhaps not all of the
// loss, but so much.
std::int64_t Search::gain_since(const Placements& before, const std::vector<int>& group, std::int64_t least_gain) {
  known_.are_of(model_, before);
  std::vector<int> constraints;
  for (const int item : group) constraints.insert(constraints.end(), model_.touching[item].begin(), model_.touching[item].end());
  std::sort(constraints.begin(), constraints.end());
  constraints.erase(std::unique(constraints.begin(), constraints.end()), constraints.end());
  const std::vector<int> reached = access_touched(model_, before, placements_, group);
  std::int64_t gain = 0;
  for (const int item : group) {
    const std::vector<State>& states = model_.items[item].states;
    gain += kPoint * kCostWeights.size_step * (states[before[item].state].size_step - states[placements_[item].state].size_step);
  }
  // All that it cost before, known for the most part, then what it costs now, as long as that may be worth it.
  for (const int c : constraints) gain += known_.of_constraint(model_, c);
  for (const int item : reached) gain += known_.of_access(model_, item);
  for (std::size_t i = 0; i < constraints.size() && gain > least_gain; ++i)
    gain -= constraint_cost(model_, model_.constraints[constraints[i]], placements_);
  for (std::size_t i = 0; i < reached.size() && gain > least_gain; ++i) gain -= access_cost_of(model_, reached[i], placements_);
  return gain;
}

bool Search::move(const std::vector<int>& group, std::int64_t noise, Budget& budget) {
  const Placements before = placements_;
  for (const int member : group) placements_[member] = {};
  bool all = true;
  for (const int member : group) all = all && !budget.stopped && place(member, noise, budget);
  if (all && is_better(before, group, budget)) return true;
  placements_ = before;
  return false;
}

// Whether what moved since is worth it.
bool Search::is_better(const Placements& before, const std::vector<int>& moved, Budget& budget, std::int64_t least_gain) {
  if (placements_ == before) return false;
  const std::int64_t gain = gain_since(before, moved, least_gain);
  budget.count(100);
  // The ways are costly to measure: only for what is better, or nearly as good, without them.
  if (gain <= least_gain) return false;
  budget.count(900);
  const std::int64_t ways_after = ways_cost(model_, placements_, gain + ways_);
  if (ways_after >= gain + ways_) return false;
  ways_ = ways_after;
  return true;
}

// An item goes where it is best though others stand there; those look for new places.
bool Search::push(int item, Budget& budget) {
  const Placements before = placements_;
  std::vector<int> moved;
  take_out(item, moved);
  std::vector<std::int64_t> price(model_.items.size());
  for (std::size_t i = 0; i < price.size(); ++i) price[i] = stays(model_.items[i]) ? -1 : kPushing;
  CandidateOptions options;
  options.eject_price = &price;
  options.noise = kPushing * (1 + random_.below(3));
  options.random = &random_;
  options.most_size_step = most_size_step_;
  const std::vector<Candidate> found = finder_.find(placements_, item, options, budget);
  bool all = !found.empty();
  if (all) {
    placements_[item] = found[0].placement;
    for (const int other : found[0].hit) take_out(other, moved);
    all = placements_[item].state >= 0;  // else it hung on what it pushed out
  }
  for (std::size_t i = 0; i < moved.size() && all; ++i) all = moved[i] == item || place(moved[i], 0, budget);
  if (all && is_better(before, moved, budget)) return true;
  placements_ = before;
  return false;
}

// Rows and grids, each with what they look at and all that hangs on them: bound to one another, they can only move together.
std::vector<std::vector<int>> Search::formations() const {
  constexpr std::size_t kMany = 4;
  std::vector<std::vector<int>> found;
  for (const Relation& r : model_.scene->relations) {
    if ((r.type != RelationType::kGrid && r.type != RelationType::kRow) || r.targets.size() < kMany) continue;
    std::vector<int> group;
    bool movable = true;
    for (const std::string& id : in_facing_order(*model_.scene, r.targets)) {
      std::vector<int> more;
      const int item = model_.find_item(id);
      if (item < 0 || placements_[item].state < 0) continue;
      group_of(dependencies_, placements_, item, more);
      for (const int m : more) {
        movable = movable && !stays(model_.items[m]);
        if (std::find(group.begin(), group.end(), m) == group.end()) group.push_back(m);
      }
    }
    if (movable && group.size() >= kMany) found.push_back(std::move(group));
  }
  return found;
}

std::vector<int> Search::movable() const {
  std::vector<int> found;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    if (placements_[i].state >= 0 && !stays(model_.items[i])) found.push_back(static_cast<int>(i));
  }
  return found;
}

bool Search::shake(Budget& budget) {
  const std::vector<int> all = movable();
  if (all.empty()) return false;
  const Placements before = placements_;
  std::vector<int> out;
  for (std::int64_t k = random_.below(kShaken); k >= 0; --k)
    take_out(all[static_cast<std::size_t>(random_.below(static_cast<std::int64_t>(all.size())))], out);
  const std::int64_t noise = kPoint * (1 + random_.below(kNoiseOfShaking));
  for (const int item : order(bonus_)) {
    if (placements_[item].state >= 0 || (!budget.stopped && place(item, noise, budget))) continue;
    placements_ = before;
    return false;
  }
  return true;
}

}  // namespace layoutbox::placement
