#include "layoutbox/solve/search/quick.h"

namespace layoutbox::placement {
namespace {

constexpr int kPushesPerItem = 3, kPushesMore = 20, kLongerBy = 2;
constexpr int kTriesWhereWatched = 8;
constexpr std::int64_t kSlice = 1'000'000;  // steps

// 1, 1, 2, 1, 1, 2, 4, 1, …: of searches whose time has a long tail these lengths are nearly as good as the best that could be chosen.
std::int64_t luby(std::int64_t index) {
  std::int64_t size = 1, power = 0;
  while (size < index + 1) size = 2 * size + 1, ++power;
  while (size - 1 != index) {
    size = (size - 1) / 2, --power;
    index %= size;
  }
  return std::int64_t{1} << power;
}

bool same_body(const State& a, const State& b) {
  return a.size_step == b.size_step && is_quarter(a) && is_quarter(b) && a.extent == b.extent && a.constants == b.constants &&
         a.solids == b.solids && a.clear == b.clear;
}

// By state the set of those that cannot be told from it by room taken or by anything that must hold.
std::vector<std::uint64_t> alike_states(const PlacementModel& model, const RegionFinder& regions, ItemId item) {
  const std::vector<State>& states = model.items[item].states;
  std::vector<std::uint64_t> alike(states.size(), 0), masks;
  for (const ConstraintId c : model.touching[item]) {
    if (!regions.enforced(c)) continue;
    for (const Formula& formula : model.constraints[c].formulas) {
      for (const Case& one : formula.cases) {
        for (const StateLiteral& literal : one.states) {
          if (literal.item == item) masks.push_back(literal.states);
        }
      }
    }
  }
  const auto told_apart = [&](std::size_t a, std::size_t b) {
    return std::any_of(masks.begin(), masks.end(), [&](std::uint64_t mask) { return ((mask >> a ^ mask >> b) & 1) != 0; });
  };
  for (std::size_t a = 0; a < states.size(); ++a) {
    for (std::size_t b = 0; b < states.size(); ++b) {
      if (a == b || (same_body(states[a], states[b]) && !told_apart(a, b))) alike[a] |= std::uint64_t{1} << b;
    }
  }
  return alike;
}

}  // namespace

QuickSearch::QuickSearch(const PlacementModel& model, const Dependencies& dependencies, Scope scope, std::uint64_t seed, int most_size_step)
    : model_(model),
      dependencies_(dependencies),
      regions_(model, std::move(scope), most_size_step),
      random_(seed),
      most_size_step_(most_size_step),
      weight_(model.items.size(), 0),
      obstacles_(model, regions_) {
  for (const ItemId i : model.items.ids()) alike_.push_back(alike_states(model, regions_, i));
}

void QuickSearch::note_failed(const Placements& placements) {
  failed_.clear();
  for (const ItemId i : placements.ids()) {
    if (!regions_.scope().leaves_out(i) && placements[i].state < 0) failed_.push_back(i);
  }
}

bool QuickSearch::complete(Placements& placements, Budget& budget) {
  regions_.watch(&budget);
  Placements best = placements;
  std::size_t least = model_.items.size() + 1;
  std::int64_t slice = budget.steps + 2 * kSlice;
  for (std::int64_t slices = 0; !budget.spent();) {
    if (budget.steps > slice) {  // what has been learned leads nowhere: once more from nothing
      slice = budget.steps + kSlice * luby(slices++);
      std::fill(weight_.begin(), weight_.end(), 0);
      attempts_ = 0;
    }
    placements_ = placements;
    std::vector<ItemId> pending = placing_order(model_, dependencies_, regions_.scope(), weight_);
    std::erase_if(pending, [&](ItemId item) { return placements_[item].state >= 0; });
    std::reverse(pending.begin(), pending.end());  // the next is taken from the end
    const bool all = attempt(std::move(pending), budget);
    if (all || failed_.size() < least) best = placements_, least = failed_.size();
    if (all) break;
  }
  placements = std::move(best);
  note_failed(placements);
  return failed_.empty();
}

// The last one whose hosts have their places.
ItemId QuickSearch::next_of(std::vector<ItemId>& pending) const {
  std::size_t at = pending.size() - 1;
  for (std::size_t i = pending.size(); i-- > 0;) {
    const auto& hosts = dependencies_.hosts[pending[i]];
    const auto waits = [&](ItemId host) { return std::find(pending.begin(), pending.end(), host) != pending.end(); };
    if (std::any_of(hosts.begin(), hosts.end(), waits)) continue;
    at = i;
    break;
  }
  const ItemId item = pending[at];
  pending.erase(pending.begin() + static_cast<std::ptrdiff_t>(at));
  return item;
}

bool QuickSearch::attempt(std::vector<ItemId> pending, Budget& budget) {
  // Later attempts are longer.
  const int limit = (kPushesPerItem * static_cast<int>(model_.items.size()) + kPushesMore) * (kLongerBy + attempts_++) / kLongerBy;
  int pushes = 0;
  while (!pending.empty() && pushes < limit && !budget.spent()) {
    const ItemId item = next_of(pending);
    if (settle(item, budget)) continue;
    ++weight_[item], ++pushes;
    if (push_out(item, pending, budget) || take_hosts(item, pending)) continue;
    pending.push_back(item);
    break;
  }
  note_failed(placements_);
  return failed_.empty();
}

// Of states that differ in nothing the search sees one will do, now this one, now that.
const std::vector<int>& QuickSearch::states_in_turn(ItemId item) {
  const std::vector<State>& states = model_.items[item].states;
  turns_.clear();
  const auto first = static_cast<std::size_t>(random_.below(static_cast<std::int64_t>(states.size())));
  std::uint64_t seen = 0;
  for (std::size_t k = 0; k < states.size(); ++k) {
    const auto s = static_cast<int>((first + k) % states.size());
    if (states[s].size_step > most_size_step_ || (seen & alike_[item][s]) != 0) continue;
    seen |= std::uint64_t{1} << s;
    const auto nearer = [&](int a, int b) { return states[a].size_step < states[b].size_step; };
    turns_.insert(std::upper_bound(turns_.begin(), turns_.end(), s, nearer), s);
  }
  return turns_;
}

// Now and then a place that a sweep from the corners never comes to, for what has failed before or what hangs on it.
bool QuickSearch::somewhere(const Region& region, Vec3& at) {
  if (random_.below(2) == 0) return false;
  for (int k = 0; k < 3; ++k) at[k] = region.lo[k] + static_cast<Mm>(random_.below(std::int64_t{region.hi[k]} - region.lo[k] + 1));
  return obstacles_.is_free(at) && holds_at(region, at);
}

// Where what hangs on it and has failed before finds a place too, if a few tries come to such a place.
bool QuickSearch::settle(ItemId item, Budget& budget) {
  const auto waits = [&](ItemId tenant) { return weight_[tenant] > 0 && placements_[tenant].state < 0; };
  std::vector<ItemId> watched;
  std::copy_if(dependencies_.tenants[item].begin(), dependencies_.tenants[item].end(), std::back_inserter(watched), waits);
  for (int tries = watched.empty() ? 1 : kTriesWhereWatched; tries > 0; --tries) {
    if (!settle_once(item, budget)) return false;
    const auto fits = [&](ItemId tenant) {
      const bool found = settle_once(tenant, budget);
      placements_[tenant] = {};
      return found;
    };
    if (tries == 1 || std::all_of(watched.begin(), watched.end(), fits)) return true;
    placements_[item] = {};
  }
  return true;
}

// The first free position of a sweep from one of the region's corners.
bool QuickSearch::settle_once(ItemId item, Budget& budget) {
  const auto& tenants = dependencies_.tenants[item];
  const bool failed_before = weight_[item] > 0 || std::any_of(tenants.begin(), tenants.end(), [&](ItemId t) { return weight_[t] > 0; });
  const Obstacles::Sweep how{static_cast<int>(random_.below(2)), {random_.below(2) == 0, random_.below(2) == 0}};
  for (const int state : states_in_turn(item)) {
    const std::vector<Region>& regions = regions_.find(placements_, item, state, false);
    budget.count(40);
    for (const Region& region : regions) {
      Vec3 at;
      obstacles_.gather(placements_, item, state, region);
      if (!(failed_before && somewhere(region, at)) && !obstacles_.sweep(region, how, at, budget)) continue;
      placements_[item] = {state, at};
      return true;
    }
  }
  return false;
}

void QuickSearch::take_out(ItemId item, std::vector<ItemId>& pending) {
  std::vector<ItemId> group;
  group_of(dependencies_, placements_, item, group);
  for (std::size_t i = group.size(); i-- > 0;) {  // hosts last, so that they are taken up first
    if (stays(model_.items[group[i]])) continue;
    placements_[group[i]] = {};
    if (std::find(pending.begin(), pending.end(), group[i]) == pending.end()) pending.push_back(group[i]);
  }
}

// What it refers to, what that refers to, and so on.
std::vector<ItemId> QuickSearch::all_hosts(ItemId item) const {
  std::vector<ItemId> all = dependencies_.hosts[item];
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const ItemId host : dependencies_.hosts[all[i]]) {
      if (host != item && std::find(all.begin(), all.end(), host) == all.end()) all.push_back(host);
    }
  }
  return all;
}

}  // namespace layoutbox::placement
