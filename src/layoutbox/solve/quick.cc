#include "layoutbox/solve/quick.h"

#include "layoutbox/solve/slanted.h"

namespace layoutbox::placement {
namespace {

constexpr int kPushesPerItem = 3, kPushesMore = 20, kLongerBy = 2;
constexpr int kWatchedTries = 8;
constexpr std::size_t kMostCoordinates = 14;
constexpr int kLinesAcross = 14;  // of a region that is cut slantwise

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

std::int64_t floor_div(std::int64_t a, std::int64_t b) { return a / b - ((a % b != 0) && ((a < 0) != (b < 0))); }
std::int64_t ceil_div(std::int64_t a, std::int64_t b) { return -floor_div(-a, b); }

}  // namespace

QuickSearch::QuickSearch(const Model& model, const Dependencies& dependencies, std::vector<char> given_up, std::uint64_t seed,
                         int most_size_step)
    : model_(model),
      dependencies_(dependencies),
      regions_(model, std::move(given_up), most_size_step),
      random_(seed),
      most_size_step_(most_size_step),
      weight_(model.items.size(), 0) {}

bool QuickSearch::complete(Placements& placements, const std::vector<char>& left_out, Budget& budget) {
  regions_.leave_out(left_out);
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
    std::vector<int> pending = placing_order(model_, dependencies_, left_out, weight_);
    std::erase_if(pending, [&](int item) { return placements_[item].state >= 0; });
    std::reverse(pending.begin(), pending.end());  // the next is taken from the end
    const bool all = attempt(left_out, std::move(pending), budget);
    if (all || failed_.size() < least) best = placements_, least = failed_.size();
    if (all) break;
  }
  placements = std::move(best);
  failed_.clear();
  for (std::size_t i = 0; i < placements.size(); ++i) {
    if (!left_out[i] && placements[i].state < 0) failed_.push_back(static_cast<int>(i));
  }
  return failed_.empty();
}

// The last one whose hosts have their places.
int QuickSearch::next_of(std::vector<int>& pending) const {
  std::size_t at = pending.size() - 1;
  for (std::size_t i = pending.size(); i-- > 0;) {
    const auto& hosts = dependencies_.hosts[pending[i]];
    const auto waits = [&](int host) { return std::find(pending.begin(), pending.end(), host) != pending.end(); };
    if (std::any_of(hosts.begin(), hosts.end(), waits)) continue;
    at = i;
    break;
  }
  const int item = pending[at];
  pending.erase(pending.begin() + static_cast<std::ptrdiff_t>(at));
  return item;
}

bool QuickSearch::attempt(const std::vector<char>& left_out, std::vector<int> pending, Budget& budget) {
  // Later attempts are longer.
  const int limit = (kPushesPerItem * static_cast<int>(model_.items.size()) + kPushesMore) * (kLongerBy + attempts_++) / kLongerBy;
  int pushes = 0;
  while (!pending.empty() && pushes < limit && !budget.spent()) {
    const int item = next_of(pending);
    if (settle(item, budget)) continue;
    ++weight_[item], ++pushes;
    if (push_out(item, pending, budget) || take_hosts(item, pending)) continue;
    pending.push_back(item);
    break;
  }
  failed_.clear();
  for (std::size_t i = 0; i < placements_.size(); ++i) {
    if (!left_out[i] && placements_[i].state < 0) failed_.push_back(static_cast<int>(i));
  }
  return failed_.empty();
}

std::vector<int> QuickSearch::states_in_turn(int item) {
  const std::vector<State>& states = model_.items[item].states;
  std::vector<int> out;
  const auto first = static_cast<std::size_t>(random_.below(static_cast<std::int64_t>(states.size())));
  for (std::size_t k = 0; k < states.size(); ++k) {
    const auto s = static_cast<int>((first + k) % states.size());
    if (states[s].size_step <= most_size_step_) out.push_back(s);
  }
  std::stable_sort(out.begin(), out.end(), [&](int a, int b) { return states[a].size_step < states[b].size_step; });
  return out;
}

// Now and then a place that a sweep from the corners never comes to, for what has failed before or what hangs on it.
bool QuickSearch::somewhere(const Region& region, Vec3& at) {
  if (random_.below(2) == 0) return false;
  for (int k = 0; k < 3; ++k) at[k] = region.lo[k] + static_cast<Mm>(random_.below(std::int64_t{region.hi[k]} - region.lo[k] + 1));
  const auto in_way = [&](const Forbidden& f) { return f.holds(at); };
  return std::none_of(forbidden_.begin(), forbidden_.end(), in_way) && holds_at(region, at);
}

// Where what hangs on it and has failed before finds a place too, if a few tries come to such a place.
bool QuickSearch::settle(int item, Budget& budget) {
  const auto waits = [&](int tenant) { return weight_[tenant] > 0 && placements_[tenant].state < 0; };
  std::vector<int> watched;
  std::copy_if(dependencies_.tenants[item].begin(), dependencies_.tenants[item].end(), std::back_inserter(watched), waits);
  for (int tries = watched.empty() ? 1 : kWatchedTries; tries > 0; --tries) {
    if (!settle_once(item, budget)) return false;
    const auto fits = [&](int tenant) {
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
bool QuickSearch::settle_once(int item, Budget& budget) {
  const auto& tenants = dependencies_.tenants[item];
  const bool failed_before = weight_[item] > 0 || std::any_of(tenants.begin(), tenants.end(), [&](int t) { return weight_[t] > 0; });
  const Sweep how{static_cast<int>(random_.below(2)), {random_.below(2) == 0, random_.below(2) == 0}};
  for (const int state : states_in_turn(item)) {
    const std::vector<Region>& regions = regions_.find(placements_, item, state, false);
    budget.count(40);
    if (regions.empty()) continue;
    forbid(item, state);
    for (const Region& region : regions) {
      Vec3 at;
      if (!(failed_before && somewhere(region, at)) && !sweep(region, how, at, budget)) continue;
      placements_[item] = {state, at};
      return true;
    }
  }
  return false;
}

void QuickSearch::forbid_pair(int item, int state, int other) {
  const PairRule rule = model_.pair(item, other);
  const Item &self = model_.items[item], &them = model_.items[other];
  if (rule == PairRule::kFree || (self.fixed && them.fixed)) return;
  const State &own = self.states[state], &theirs = them.states[placements_[other].state];
  const Box box = box_of(them, placements_[other]);
  const bool turned = !model_.headings.empty() && (!is_quarter(own) || !is_quarter(theirs));
  const auto add = [&](const Box& mine, const Box& body, Mm more, int my_solid = -1, int their_solid = -1) {
    Forbidden f;
    for (int k = 0; k < 3; ++k) f.lo[k] = body.lo[k] - mine.hi[k], f.hi[k] = body.hi[k] - mine.lo[k];
    for (int k = 0; k < 2; ++k) f.lo[k] -= more, f.hi[k] += more;
    f.owner = other;
    for (std::size_t k = 0; turned && !self.is_opening() && !them.is_opening() && k < model_.headings.size(); ++k) {
      const Heading& h = model_.headings[k];
      const Reach a = reach_of(model_, self, state, my_solid, static_cast<int>(k));
      const Reach b = reach_of(model_, them, placements_[other].state, their_solid, static_cast<int>(k));
      const Vec3& at = placements_[other].at;
      const std::int64_t middle = 2 * (std::int64_t{h.x} * at[0] + std::int64_t{h.y} * at[1]) + b.middle2;
      f.stripes.push_back({h.x, h.y, a.middle2 - middle, a.span + b.span});
    }
    forbidden_.push_back(std::move(f));
  };
  const Box whole{{0, 0, 0}, own.extent};
  if (rule == PairRule::kOpenings) {
    add(whole, box, 2);  // openings have no depth
  } else if (self.is_opening() || them.is_opening()) {
    if (regions_.clearance_off(self) || regions_.clearance_off(them)) return;
    for (const Box& clear : own.clear) add(clear, box, 0);
    for (const Box& clear : theirs.clear) add(whole, clear.shifted(placements_[other].at), 0);
  } else if (rule == PairRule::kBoxes) {
    add(whole, box, 0);
  } else {
    for (std::size_t i = 0; i < own.solids.size(); ++i) {
      for (std::size_t j = 0; j < theirs.solids.size(); ++j)
        add(own.solids[i], theirs.solids[j].shifted(placements_[other].at), 0, static_cast<int>(i), static_cast<int>(j));
    }
  }
}

void QuickSearch::forbid(int item, int state) {
  forbidden_.clear();
  const Item& self = model_.items[item];
  if (!self.is_opening() && !self.fixed) {
    const Vec3& e = self.states[state].extent;
    for (const Box& outside : model_.off_limits) {
      forbidden_.push_back({{outside.lo[0] - e[0], outside.lo[1] - e[1], outside.lo[2] - e[2]}, outside.hi, -1});
    }
  }
  for (std::size_t j = 0; j < placements_.size(); ++j) {
    if (placements_[j].state >= 0 && static_cast<int>(j) != item) forbid_pair(item, state, static_cast<int>(j));
  }
}

bool QuickSearch::Forbidden::along(int b, Mm line, Mm& from, Mm& to) const {
  const int a = 1 - b;
  if (!(lo[a] < line && line < hi[a])) return false;
  from = lo[b], to = hi[b];
  for (const Stripe& stripe : stripes) {  // −half < 2·p·x + q < half
    const std::int64_t p = 2 * (b == 0 ? stripe.x : stripe.y), q = 2 * (a == 0 ? stripe.x : stripe.y) * line + stripe.constant;
    if (p == 0) {
      if (std::abs(q) >= stripe.half) return false;
      continue;
    }
    const std::int64_t first = p > 0 ? -stripe.half - q : q - stripe.half, last = p > 0 ? stripe.half - q : q + stripe.half,
                       by = std::abs(p);
    from = static_cast<Mm>(std::max<std::int64_t>(from, floor_div(first, by)));
    to = static_cast<Mm>(std::min<std::int64_t>(to, ceil_div(last, by)));
  }
  return from + 1 < to;
}

// What of the line the checks of the region leave; false: nothing.
bool QuickSearch::narrow(const Region& region, int b, const Vec3& at, Mm& from, Mm& to) const {
  for (const Reduced* one : region.cases) {
    for (const Partial& check : one->checks) {  // coefficient · x + rest ≥ 0
      Vec3 start = at;
      start[b] = 0;
      const std::int64_t rest = check.at(start), by = check.coefficient[b];
      if (by == 0 && rest < 0) return false;
      if (by > 0) from = static_cast<Mm>(std::max<std::int64_t>(from, ceil_div(-rest, by)));
      if (by < 0) to = static_cast<Mm>(std::min<std::int64_t>(to, floor_div(rest, -by)));
      if (from > to) return false;
    }
  }
  return true;
}

// Along one line: from its beginning past everything that is in the way.
bool QuickSearch::sweep_line(const Region& region, const Sweep& how, Vec3& at) const {
  const int a = how.outer, b = 1 - a;
  const bool down = how.down[1];
  Mm first = region.lo[b], last = region.hi[b];
  if (!narrow(region, b, at, first, last)) return false;
  at[b] = down ? last : first;
  for (bool moved = true; moved;) {
    moved = false;
    for (const Forbidden* f : near_) {
      Mm from = f->lo[b], to = f->hi[b];
      const bool inside = f->stripes.empty() ? f->lo[a] < at[a] && at[a] < f->hi[a] : f->along(b, at[a], from, to);
      if (!inside || !(from < at[b] && at[b] < to)) continue;
      at[b] = down ? from : to;
      moved = true;
    }
    if (at[b] < first || at[b] > last) return false;
  }
  return true;
}

bool QuickSearch::sweep(const Region& region, const Sweep& how, Vec3& at, Budget& budget) {
  const int a = how.outer;
  for (const Mm z : {region.lo[2], region.hi[2]}) {
    at[2] = z;
    near_.clear();
    lines_.assign({region.lo[a], region.hi[a]});
    for (const Forbidden& f : forbidden_) {
      if (!(f.lo[2] < z && z < f.hi[2])) continue;
      near_.push_back(&f);
      for (const Mm line : {f.lo[a], f.hi[a]}) {
        if (line > region.lo[a] && line < region.hi[a]) lines_.push_back(line);
      }
    }
    const bool slantwise = std::any_of(region.cases.begin(), region.cases.end(), [](const Reduced* one) { return !one->checks.empty(); });
    for (int k = 1; slantwise && k < kLinesAcross; ++k)
      lines_.push_back(region.lo[a] + static_cast<Mm>(std::int64_t{region.hi[a] - region.lo[a]} * k / kLinesAcross));
    std::sort(lines_.begin(), lines_.end());
    lines_.erase(std::unique(lines_.begin(), lines_.end()), lines_.end());
    if (how.down[0]) std::reverse(lines_.begin(), lines_.end());
    for (const Mm line : lines_) {
      at[a] = line;
      budget.count(1 + static_cast<std::int64_t>(near_.size()) / 16);
      if (sweep_line(region, how, at)) return true;
    }
    if (region.hi[2] == region.lo[2]) break;
  }
  return false;
}

void QuickSearch::take_out(int item, std::vector<int>& pending) {
  std::vector<int> group;
  group_of(dependencies_, placements_, item, group);
  for (std::size_t i = group.size(); i-- > 0;) {  // hosts last, so that they are taken up first
    if (stays(model_.items[group[i]])) continue;
    placements_[group[i]] = {};
    if (std::find(pending.begin(), pending.end(), group[i]) == pending.end()) pending.push_back(group[i]);
  }
}

// What it refers to, what that refers to, and so on.
std::vector<int> QuickSearch::all_hosts(int item) const {
  std::vector<int> all = dependencies_.hosts[item];
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const int host : dependencies_.hosts[all[i]]) {
      if (host != item && std::find(all.begin(), all.end(), host) == all.end()) all.push_back(host);
    }
  }
  return all;
}

// Where it pushes out what has failed least often.
bool QuickSearch::push_out(int item, std::vector<int>& pending, Budget& budget) {
  std::vector<int> price(placements_.size(), -1), group;  // −1: not to be pushed out
  std::vector<char> host(placements_.size(), 0);
  for (const int other : all_hosts(item)) host[other] = 1;
  for (std::size_t j = 0; j < price.size(); ++j) {
    if (placements_[j].state < 0 || host[j] || stays(model_.items[j])) continue;
    group_of(dependencies_, placements_, static_cast<int>(j), group);
    price[j] = 0;
    for (const int member : group) price[j] += 1 + weight_[member];
  }
  Placement best;
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  std::vector<int> hit, best_hit, seen(placements_.size(), 0);
  std::array<std::vector<Mm>, 3> tried;
  int stamp = 0;
  for (const int state : states_in_turn(item)) {
    const std::vector<Region>& regions = regions_.find(placements_, item, state, false);
    if (regions.empty()) continue;
    forbid(item, state);
    for (const Region& region : regions) {
      for (int k = 0; k < 3; ++k) {
        tried[k].assign({region.lo[k]});
        if (region.hi[k] > region.lo[k]) tried[k].push_back(region.hi[k]);
        for (const Forbidden& f : forbidden_) {
          for (const Mm value : {f.lo[k], f.hi[k]}) {
            if (k < 2 && value > region.lo[k] && value < region.hi[k]) tried[k].push_back(value);
          }
        }
        while (tried[k].size() > kMostCoordinates) {
          tried[k][static_cast<std::size_t>(random_.below(static_cast<std::int64_t>(tried[k].size())))] = tried[k].back();
          tried[k].pop_back();
        }
      }
      for (const Mm z : tried[2]) {
        for (const Mm y : tried[1]) {
          budget.count(static_cast<std::int64_t>(1 + tried[0].size() * forbidden_.size() / 32));
          if (budget.stopped) return false;
          for (const Mm x : tried[0]) {
            const Vec3 at{x, y, z};
            ++stamp;
            hit.clear();
            std::int64_t sum = random_.below(2);  // of equals now this one, now that
            for (const Forbidden& f : forbidden_) {
              if (!f.holds(at) || (f.owner >= 0 && seen[f.owner] == stamp)) continue;
              if (f.owner < 0 || price[f.owner] < 0) {
                sum = least;
                break;
              }
              seen[f.owner] = stamp;
              hit.push_back(f.owner);
              sum += 2 * std::int64_t{price[f.owner]};
              if (sum >= least) break;
            }
            if (sum >= least || !holds_at(region, at)) continue;
            least = sum, best = {state, at}, best_hit = hit;
          }
        }
      }
    }
  }
  if (best.state < 0) return false;
  placements_[item] = best;
  for (const int other : best_hit) take_out(other, pending);
  return true;
}

// What it refers to stands where it cannot follow: that looks for another place, before it.
bool QuickSearch::take_hosts(int item, std::vector<int>& pending) {
  bool any = false;
  const std::vector<int> hosts = random_.below(2) == 0 ? dependencies_.hosts[item] : all_hosts(item);
  pending.push_back(item);
  for (const int host : hosts) {
    if (placements_[host].state < 0 || stays(model_.items[host])) continue;
    ++weight_[host];
    take_out(host, pending);
    any = true;
  }
  if (!any) pending.pop_back();
  return any;
}

}  // namespace layoutbox::placement
