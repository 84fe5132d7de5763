#include "layoutbox/solve/search.h"

#include <tuple>

#include "layoutbox/solve/cost.h"

namespace layoutbox::placement {
namespace {

constexpr std::int64_t kNoCost = std::numeric_limits<std::int64_t>::max() / 4;
constexpr std::int64_t kPoint = 1000;
constexpr std::size_t kMostDomains = 48;
constexpr std::size_t kMostCoordinates = 40;
constexpr std::size_t kWatchedTries = 32;

// A linear form in which only the position of one item is free.
struct Partial {
  std::int64_t constant = 0;
  std::array<std::int32_t, 3> coefficient{};
  bool unknown = false;  // speaks of something else that is not placed

  bool is_constant() const { return coefficient[0] == 0 && coefficient[1] == 0 && coefficient[2] == 0; }
  std::int64_t at(const Vec3& p) const {
    return constant + std::int64_t{coefficient[0]} * p[0] + std::int64_t{coefficient[1]} * p[1] + std::int64_t{coefficient[2]} * p[2];
  }
  // The only axis with a coefficient, or −1.
  int single_axis() const {
    int found = -1;
    for (int k = 0; k < 3; ++k) {
      if (coefficient[k] == 0) continue;
      if (found >= 0) return -1;
      found = k;
    }
    return found;
  }
};

std::int64_t floor_div(std::int64_t a, std::int64_t b) { return a / b - ((a % b != 0) && ((a < 0) != (b < 0))); }
std::int64_t ceil_div(std::int64_t a, std::int64_t b) { return -floor_div(-a, b); }

}  // namespace

struct Search::Reduced {
  Vec3 lo{std::numeric_limits<Mm>::min() / 2, std::numeric_limits<Mm>::min() / 2, std::numeric_limits<Mm>::min() / 2};
  Vec3 hi{std::numeric_limits<Mm>::max() / 2, std::numeric_limits<Mm>::max() / 2, std::numeric_limits<Mm>::max() / 2};
  std::vector<Partial> checks;  // over more than one axis
  std::vector<std::tuple<Partial, std::int32_t, std::int32_t>> wishes;  // form, weight, scale
  std::int64_t price = 0;
  bool state_fits = true;
  bool unknown = false;
  std::vector<Partial> bounds;  // every single-axis and constant form, for soft costs

  bool empty() const { return lo[0] > hi[0] || lo[1] > hi[1] || lo[2] > hi[2]; }
  std::int64_t wish_cost(const Vec3& at) const {
    std::int64_t cost = price;
    for (const auto& [form, weight, scale] : wishes) cost += std::abs(form.at(at)) * weight / scale;
    return cost;
  }
};

struct Search::Domain {
  Vec3 lo{}, hi{};
  std::vector<const Reduced*> cases;
  std::int64_t price = 0;
  bool empty() const { return lo[0] > hi[0] || lo[1] > hi[1] || lo[2] > hi[2]; }
};

struct Search::Sketch {
  struct SoftFormula {
    std::int64_t weight = 0;
    std::vector<Reduced> cases;
  };
  std::vector<SoftFormula> soft;
};

namespace {

Partial partial_of(const Model& model, const Placements& placements, const Linear& form, int item, int state) {
  Partial p;
  p.constant = form.constant;
  for (const Term& term : form.terms) {
    if (term.item == item) {
      if (term.quantity < kExtentX) {
        p.coefficient[term.quantity] += term.coefficient;
      } else {
        p.constant += std::int64_t{term.coefficient} * value_of(model.items[item], Placement{state, {}}, term.quantity);
      }
    } else if (placements[term.item].state < 0) {
      p.unknown = true;
    } else {
      p.constant += std::int64_t{term.coefficient} * value_of(model.items[term.item], placements[term.item], term.quantity);
    }
  }
  return p;
}

}  // namespace

Search::Search(const Model& model, std::vector<char> given_up, std::uint64_t seed, int most_size_step)
    : model_(model), given_up_(std::move(given_up)), random_(seed), most_size_step_(most_size_step), placements_(model.items.size()),
      left_out_(model.items.size(), 0), bonus_(model.items.size(), 0), depends_(model.items.size()), dependents_(model.items.size()) {
  given_up_.resize(model.constraints.size(), 0);
  for (std::size_t i = 0; i < model.items.size(); ++i) {
    depends_[i] = depends_on(static_cast<int>(i));
    for (const int other : depends_[i]) dependents_[other].push_back(static_cast<int>(i));
  }
}

bool Search::enforced(int constraint) const {
  return !given_up_[constraint] && model_.constraints[constraint].firmness != Firmness::kSoft;
}

std::vector<int> Search::depends_on(int item) const {
  std::vector<int> found;
  const auto add = [&](int other) {
    if (other != item && other >= 0 && std::find(found.begin(), found.end(), other) == found.end()) found.push_back(other);
  };
  for (const SupportOption& support : model_.items[item].supports) {
    if (support.kind == SupportOption::Kind::kItem || support.kind == SupportOption::Kind::kSill) add(support.index);
  }
  for (const int c : model_.touching[item]) {
    const Constraint& constraint = model_.constraints[c];
    if (constraint.relation < 0) continue;
    const Relation& relation = model_.scene->relations[constraint.relation];
    if (std::find(relation.targets.begin(), relation.targets.end(), model_.items[item].id) == relation.targets.end()) continue;
    for (const std::string& id : relation.references) add(model_.find_item(id));
  }
  return found;
}

std::vector<int> Search::order() const {
  struct Key {
    int item, bonus, group;
    std::int64_t area;
  };
  std::vector<Key> keys;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const Item& item = model_.items[i];
    if (left_out_[i]) continue;
    Key key{static_cast<int>(i), bonus_[i], 3, 0};
    const Vec3& e = item.states[0].extent;
    key.area = std::int64_t{e[0]} * e[1];
    bool at_wall_by_relation = false;
    for (const int c : model_.touching[i]) {
      const Constraint& constraint = model_.constraints[c];
      if (constraint.relation < 0 || constraint.firmness != Firmness::kHard) continue;
      at_wall_by_relation |= relation_row(model_.scene->relations[constraint.relation].type).group == RelationGroup::kRoomGroup;
    }
    if (item.fixed || (item.is_opening() && item.opening->offset)) {
      key.group = 0;
    } else if (at_wall_by_relation && item.mount == Mount::kFloor) {
      key.group = 1;
    } else if (item.is_opening()) {
      key.group = 2;
    } else if (item.thin) {
      key.group = 5;
    } else if (item.mount != Mount::kFloor) {
      key.group = 4;
    }
    keys.push_back(key);
  }
  std::stable_sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
    return std::tuple(a.group != 0, -a.bonus, a.group, -a.area, a.item) < std::tuple(b.group != 0, -b.bonus, b.group, -b.area, b.item);
  });
  std::vector<int> out;
  std::vector<char> seen(model_.items.size(), 0);
  const std::function<void(int)> emit = [&](int item) {
    if (seen[item] || left_out_[item]) return;
    seen[item] = 1;
    for (const int other : depends_[item]) emit(other);
    out.push_back(item);
  };
  for (const Key& key : keys) emit(key.item);
  return out;
}

bool Search::reduce(const Case& one, int item, int state, Reduced& out) const {
  out.price = one.price * kPoint;
  for (const StateLiteral& literal : one.states) {
    if (literal.item == item) {
      if (!(literal.states >> state & 1)) return false;
    } else if (placements_[literal.item].state < 0) {
      out.unknown = true;
    } else if (!(literal.states >> placements_[literal.item].state & 1)) {
      return false;
    }
  }
  for (const Linear& form : one.at_least_zero) {
    const Partial p = partial_of(model_, placements_, form, item, state);
    if (p.unknown) {
      out.unknown = true;
      continue;
    }
    if (p.is_constant()) {
      if (p.constant < 0) return false;
      continue;
    }
    const int axis = p.single_axis();
    if (axis < 0) {
      out.checks.push_back(p);
      continue;
    }
    const std::int64_t a = p.coefficient[axis];  // a·x + constant ≥ 0
    if (a > 0) {
      out.lo[axis] = static_cast<Mm>(std::max<std::int64_t>(out.lo[axis], ceil_div(-p.constant, a)));
    } else {
      out.hi[axis] = static_cast<Mm>(std::min<std::int64_t>(out.hi[axis], floor_div(p.constant, -a)));
    }
  }
  if (out.empty()) return false;
  for (const Preference& wish : one.wishes) {
    const Partial p = partial_of(model_, placements_, wish.form, item, state);
    if (!p.unknown) out.wishes.emplace_back(p, wish.weight, wish.scale);
  }
  return true;
}

void Search::domains(int item, int state, std::vector<Domain>& out) const {
  // Reduced cases live as long as the domains: one static pool per call.
  static thread_local std::vector<std::vector<Reduced>> pool;
  pool.clear();
  for (const int c : model_.touching[item]) {
    if (!enforced(c)) continue;
    for (const Formula& formula : model_.constraints[c].formulas) {
      std::vector<Reduced> cases;
      bool speaks_of_item = false;
      for (const Case& one : formula.cases) {
        const auto mentions = [&](const Linear& form) {
          return std::any_of(form.terms.begin(), form.terms.end(), [&](const Term& t) { return t.item == item; });
        };
        speaks_of_item = speaks_of_item || std::any_of(one.at_least_zero.begin(), one.at_least_zero.end(), mentions) ||
                         std::any_of(one.states.begin(), one.states.end(), [&](const StateLiteral& l) { return l.item == item; });
        Reduced reduced;
        if (reduce(one, item, state, reduced)) cases.push_back(std::move(reduced));
      }
      if (!speaks_of_item && !formula.cases.empty()) continue;
      if (cases.empty()) return;
      std::stable_sort(cases.begin(), cases.end(), [](const Reduced& a, const Reduced& b) { return a.price < b.price; });
      pool.push_back(std::move(cases));
    }
  }
  std::stable_sort(pool.begin(), pool.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
  Domain whole;
  const Item& self = model_.items[item];
  for (int k = 0; k < 3; ++k) {
    whole.lo[k] = model_.room.lo[k];
    whole.hi[k] = model_.room.hi[k] - self.states[state].extent[k];
  }
  if (self.fixed) whole.lo = whole.hi = self.fixed_at;
  if (whole.empty()) return;
  int nodes = 0;
  const std::function<void(std::size_t, const Domain&)> descend = [&](std::size_t at, const Domain& domain) {
    if (out.size() >= kMostDomains || ++nodes > 4000) return;
    if (at == pool.size()) {
      out.push_back(domain);
      return;
    }
    for (const Reduced& one : pool[at]) {
      Domain next = domain;
      for (int k = 0; k < 3; ++k) {
        next.lo[k] = std::max(next.lo[k], one.lo[k]);
        next.hi[k] = std::min(next.hi[k], one.hi[k]);
      }
      if (next.empty()) continue;
      next.cases.push_back(&one);
      next.price += one.price;
      descend(at + 1, next);
    }
  };
  descend(0, whole);
}

void Search::collect_soft(int item, int state, Sketch& sketch) const {
  for (const int c : model_.touching[item]) {
    const Constraint& constraint = model_.constraints[c];
    if (constraint.firmness != Firmness::kSoft) continue;
    for (const Formula& formula : constraint.formulas) {
      if (!all_placed(formula, [&] {
            static thread_local Placements probe;
            probe = placements_;
            probe[item].state = state;
            return std::cref(probe);
          }())) {
        continue;
      }
      Sketch::SoftFormula soft{constraint.weight, {}};
      for (const Case& one : formula.cases) {
        Reduced reduced;
        reduced.price = one.price * kPoint;
        for (const StateLiteral& literal : one.states) {
          const int s = literal.item == item ? state : placements_[literal.item].state;
          reduced.state_fits = reduced.state_fits && (literal.states >> s & 1);
        }
        for (const Linear& form : one.at_least_zero) reduced.bounds.push_back(partial_of(model_, placements_, form, item, state));
        for (const Preference& wish : one.wishes) {
          const Partial p = partial_of(model_, placements_, wish.form, item, state);
          if (!p.unknown) reduced.wishes.emplace_back(p, wish.weight, wish.scale);
        }
        soft.cases.push_back(std::move(reduced));
      }
      sketch.soft.push_back(std::move(soft));
    }
  }
}

std::int64_t Search::soft_cost(const Sketch& sketch, const Vec3& at) const {
  std::int64_t sum = 0;
  for (const Sketch::SoftFormula& formula : sketch.soft) {
    std::int64_t best = kNoCost;
    for (const Reduced& one : formula.cases) {
      std::int64_t miss = one.state_fits ? 0 : kStateMiss;
      if (miss * formula.weight + one.price >= best) continue;
      for (const Partial& form : one.bounds) miss = std::max(miss, -form.at(at));
      const std::int64_t cost = one.price + miss * formula.weight;
      if (cost >= best) continue;
      best = std::min(best, cost - one.price + one.wish_cost(at));
    }
    if (best < kNoCost) sum += best;
  }
  return sum;
}

void Search::coordinates(int item, int state, const Domain& domain, const Sketch& sketch, std::array<std::vector<Mm>, 3>& out) const {
  const Item& self = model_.items[item];
  const State& own = self.states[state];
  const auto offer = [&](int axis, std::int64_t value) {
    if (value >= domain.lo[axis] && value <= domain.hi[axis]) out[axis].push_back(static_cast<Mm>(value));
  };
  const auto offer_zero = [&](const Partial& form) {
    const int axis = form.single_axis();
    if (axis < 0) return;
    const std::int64_t value = floor_div(-form.constant, form.coefficient[axis]);
    offer(axis, std::clamp<std::int64_t>(value, domain.lo[axis], domain.hi[axis]));
  };
  for (int axis = 0; axis < 3; ++axis) {
    out[axis].clear();
    offer(axis, domain.lo[axis]);
    offer(axis, domain.hi[axis]);
    if (axis < 2) offer(axis, domain.lo[axis] + (domain.hi[axis] - domain.lo[axis]) / 2);
  }
  for (const Reduced* one : domain.cases) {
    for (const auto& [form, weight, scale] : one->wishes) offer_zero(form);
  }
  for (const Sketch::SoftFormula& formula : sketch.soft) {
    for (const Reduced& one : formula.cases) {
      if (!one.state_fits) continue;
      for (const auto& [form, weight, scale] : one.wishes) offer_zero(form);
      for (const Partial& form : one.bounds) {
        const int axis = form.single_axis();
        if (axis < 0 || out[axis].size() > kMostCoordinates) continue;
        const std::int64_t a = form.coefficient[axis];
        offer(axis, a > 0 ? ceil_div(-form.constant, a) : floor_div(form.constant, -a));
      }
    }
  }
  // Beside what already stands.
  const auto beside = [&](const Box& body, const Box& mine) {
    for (int axis = 0; axis < 2; ++axis) {
      offer(axis, std::int64_t{body.hi[axis]} - mine.lo[axis]);
      offer(axis, std::int64_t{body.lo[axis]} - mine.hi[axis]);
    }
  };
  const Box mine{{0, 0, 0}, own.extent};
  for (const Box& outside : model_.outside) beside(outside, mine);
  for (std::size_t j = 0; j < model_.items.size(); ++j) {
    const int other = static_cast<int>(j);
    if (placements_[j].state < 0 || other == item) continue;
    const PairRule rule = model_.pair(item, other);
    if (rule == PairRule::kFree) continue;
    const State& theirs = model_.items[j].states[placements_[j].state];
    beside(box_of(model_.items[j], placements_[j]), mine);
    for (const Box& clear : theirs.clear) beside(clear.shifted(placements_[j].at), mine);
    for (const Box& clear : own.clear) beside(box_of(model_.items[j], placements_[j]), clear);
    if (rule != PairRule::kSolids) continue;
    for (const Box& body : theirs.solids) {
      for (const Box& part : own.solids) beside(body.shifted(placements_[j].at), part);
    }
  }
  for (std::vector<Mm>& values : out) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    if (values.size() <= kMostCoordinates) continue;
    std::vector<Mm> fewer;  // evenly over all of them, both ends kept
    for (std::size_t i = 0; i < kMostCoordinates; ++i) fewer.push_back(values[i * (values.size() - 1) / (kMostCoordinates - 1)]);
    values = std::move(fewer);
  }
}

bool Search::legal(int item, const Placement& placement) const {
  const Box box = box_of(model_.items[item], placement);
  if (!model_.items[item].is_opening()) {
    for (const Box& outside : model_.outside) {
      if (overlap(outside, box)) return false;
    }
  }
  for (std::size_t j = 0; j < model_.items.size(); ++j) {
    const int other = static_cast<int>(j);
    if (placements_[j].state < 0 || other == item) continue;
    const auto off = [&](const Item& i) { return i.clearance_constraint >= 0 && given_up_[i.clearance_constraint]; };
    const bool clear_boxes = !off(model_.items[j]) && !off(model_.items[item]);
    if (model_.items[item].fixed && model_.items[j].fixed) continue;
    if (collide(model_, item, placement, other, placements_[j], clear_boxes)) return false;
  }
  return true;
}

std::int64_t Search::access_cost(int item, const Placement& placement) const {
  const Item& self = model_.items[item];
  if (self.is_opening() || self.thin) return 0;
  static thread_local Placements probe;
  probe = placements_;
  probe[item] = placement;
  std::int64_t cost = access_cost_of(model_, item, probe);
  const Box body = box_of(self, placement);
  if (!blocks_floor(self, body)) return cost;
  for (std::size_t j = 0; j < model_.items.size(); ++j) {
    const int other = static_cast<int>(j);
    if (other == item || probe[j].state < 0) continue;
    const State& state = model_.items[j].states[probe[j].state];
    const auto touched = [&](const Box& strip) { return overlap_in_plan(strip.shifted(probe[j].at), body); };
    if (!std::any_of(state.strips.begin(), state.strips.end(), touched) && !std::any_of(state.wanted.begin(), state.wanted.end(), touched)) continue;
    cost += access_cost_of(model_, other, probe) - access_cost_of(model_, other, probe, item);
  }
  return cost;
}

std::vector<Candidate> Search::candidates(int item, std::size_t most, bool any, Budget& budget) {
  std::vector<Candidate> best;
  const Item& self = model_.items[item];
  std::vector<Domain> regions;
  std::array<std::vector<Mm>, 3> values;
  const auto worst = [&] { return best.size() < most ? kNoCost : best.back().cost; };
  for (std::size_t s = 0; s < self.states.size(); ++s) {
    const int state = static_cast<int>(s);
    if (self.states[s].size_step > most_size_step_) continue;
    regions.clear();
    domains(item, state, regions);
    if (regions.empty()) continue;
    Sketch sketch;
    collect_soft(item, state, sketch);
    const std::int64_t size_cost = kPoint * kCostWeights.size_step * self.states[s].size_step;
    for (const Domain& region : regions) {
      coordinates(item, state, region, sketch, values);
      for (const Mm z : values[2]) {
        for (const Mm y : values[1]) {
          for (const Mm x : values[0]) {
            if ((++budget.steps & 1023) == 0 && budget.stop && budget.stop()) budget.stopped = true;
            if (budget.stopped) return best;
            const Vec3 at{x, y, z};
            std::int64_t cost = size_cost;
            bool holds = true;
            for (const Reduced* one : region.cases) {
              for (const Partial& check : one->checks) holds = holds && check.at(at) >= 0;
              if (!holds) break;
              cost += one->wish_cost(at);
              if (cost >= worst()) holds = false;
            }
            if (!holds) continue;
            cost += soft_cost(sketch, at);
            if (noise_ > 0) cost += random_.below(noise_);
            const Placement placement{state, at};
            if (cost >= worst() || !legal(item, placement)) continue;
            if (!any) cost += access_cost(item, placement);
            if (cost >= worst()) continue;
            const auto place = std::upper_bound(best.begin(), best.end(), cost, [](std::int64_t c, const Candidate& k) { return c < k.cost; });
            best.insert(place, {placement, cost});
            if (best.size() > most) best.pop_back();
            if (any) return best;
          }
        }
      }
    }
  }
  return best;
}

bool Search::watched_fit(int item, Budget& budget) {
  for (const int dependent : dependents_[item]) {
    if (bonus_[dependent] == 0 || placements_[dependent].state >= 0 || left_out_[dependent]) continue;
    if (candidates(dependent, 1, true, budget).empty()) return false;
  }
  return true;
}

bool Search::place(int item, Budget& budget) {
  const bool watched = std::any_of(dependents_[item].begin(), dependents_[item].end(), [&](int d) { return bonus_[d] > 0; });
  const std::vector<Candidate> found = candidates(item, watched ? kWatchedTries : 1, false, budget);
  for (const Candidate& candidate : found) {
    placements_[item] = candidate.placement;
    if (!watched || watched_fit(item, budget)) return true;
  }
  placements_[item] = {};
  return false;
}

bool Search::try_order(const std::vector<int>& order, Budget& budget, int& failed) {
  std::fill(placements_.begin(), placements_.end(), Placement{});
  failed_.clear();
  for (const int item : order) {
    if (!place(item, budget)) failed_.push_back(item);
  }
  failed = failed_.empty() ? -1 : failed_[0];
  return failed_.empty();
}

bool Search::construct(const std::vector<char>& left_out, int restarts, Budget& budget) {
  left_out_ = left_out;
  left_out_.resize(model_.items.size(), 0);
  Placements best;
  std::vector<int> best_failed;
  for (int attempt = 0; attempt <= restarts; ++attempt) {
    int failed = -1;
    noise_ = attempt < 3 ? 0 : 60 * kPoint * (attempt - 2);
    if (try_order(order(), budget, failed)) {
      noise_ = 0;
      return true;
    }
    if (best.empty() || failed_.size() < best_failed.size()) best = placements_, best_failed = failed_;
    if (budget.spent()) break;
    bonus_[failed] += 1 + attempt / 4;
  }
  noise_ = 0;
  placements_ = std::move(best);
  failed_ = std::move(best_failed);
  return false;
}

std::int64_t Search::total_cost() {
  std::int64_t sum = 0;
  for (const auto& [name, cost] : cost_terms(model_, placements_)) sum += cost;
  return sum;
}

bool Search::move_group(int item, Budget& budget) {
  const Placements before = placements_;
  const std::int64_t cost_before = total_cost();
  std::vector<int> group{item};
  for (std::size_t i = 0; i < group.size(); ++i) {
    for (const int dependent : dependents_[group[i]]) {
      if (placements_[dependent].state >= 0 && std::find(group.begin(), group.end(), dependent) == group.end()) group.push_back(dependent);
    }
  }
  for (const int member : group) placements_[member] = {};
  noise_ = random_.below(3) == 0 ? 0 : 100 * kPoint;
  bool all = true;
  for (const int member : group) all = all && place(member, budget);
  noise_ = 0;
  if (all && total_cost() < cost_before) return true;
  placements_ = before;
  return false;
}

void Search::improve(Budget& budget) {
  std::vector<int> movable;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    const Item& item = model_.items[i];
    if (placements_[i].state >= 0 && !item.fixed && !(item.is_opening() && item.opening->offset)) movable.push_back(static_cast<int>(i));
  }
  if (movable.empty()) return;
  int idle = 0;
  while (!budget.spent() && idle < 40 * static_cast<int>(movable.size())) {
    const int item = movable[random_.below(static_cast<std::int64_t>(movable.size()))];
    idle = move_group(item, budget) ? 0 : idle + 1;
  }
}

}  // namespace layoutbox::placement
