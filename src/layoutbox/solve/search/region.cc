#include "layoutbox/solve/search/region.h"

#include "layoutbox/solve/model/whole_division.h"
#include "layoutbox/solve/objective/cost.h"

namespace layoutbox::placement {
namespace {

constexpr std::size_t kMostRegions = 48;
constexpr int kMostNodes = 4000;
constexpr int kNarrowings = 2;
constexpr std::size_t kLongCase = 32;               // forms
constexpr std::int64_t kMostNarrowing = 2'000'000;  // cases and forms; domains are only bounds, and wider ones are bounds too

// The greatest value of a term over all places and states of its item.
std::int64_t most_of(const Item& item, const Domain& domain, const Term& term) {
  const std::int64_t c = term.coefficient;
  if (term.quantity < kExtentX) return c * (c > 0 ? domain.hi[term.quantity] : domain.lo[term.quantity]);
  if (term.quantity < kFirstConstant) {
    const int axis = term.quantity - kExtentX;
    return c * (c > 0 ? domain.greatest[axis] : domain.least[axis]);
  }
  std::int64_t most = std::numeric_limits<std::int64_t>::min();
  for (const State& state : item.states) most = std::max(most, c * state.constants[term.quantity - kFirstConstant]);
  return most;
}

}  // namespace

Partial partial_of(const PlacementModel& model, const Placements& placements, const ById<ItemId, Domain>& domains, const Linear& form,
                   ItemId item, int state) {
  Partial p;
  p.constant = form.constant;
  p.scale = form.scale;
  for (const Term& term : form.terms) {
    if (term.item == item) {
      if (term.quantity < kExtentX) {
        p.coefficient[term.quantity] += term.coefficient;
      } else {
        p.constant += std::int64_t{term.coefficient} * value_of(model.items[item], Placement{state, {}}, term.quantity);
      }
    } else if (placements[term.item].state < 0) {
      p.unknown = true;
      p.constant += most_of(model.items[term.item], domains[term.item], term);
    } else {
      p.constant += std::int64_t{term.coefficient} * value_of(model.items[term.item], placements[term.item], term.quantity);
    }
  }
  return p;
}

RegionFinder::RegionFinder(const PlacementModel& model, Scope scope, int most_size_step)
    : model_(model), scope_(std::move(scope)), most_size_step_(most_size_step) {
  share_out();
  for (const Item& item : model_.items) domains_.push_back(widest_domain(item));
}

void RegionFinder::watch(Budget* budget) {
  budget_ = budget;
  if (budget_ != nullptr && !std::exchange(narrowed_, true)) narrow_domains();
}

// A formula with one case is a list of demands, each of which is looked at when the last thing it speaks of is placed: a grid of hundreds.
void RegionFinder::share_out() {
  for (const ConstraintId c : model_.constraints.ids()) {
    if (!enforced(c)) continue;
    const std::vector<Formula>& formulas = model_.constraints[c].formulas;
    for (std::size_t f = 0; f < formulas.size(); ++f) {
      if (formulas[f].cases.size() != 1 || formulas[f].cases[0].at_least_zero.size() < kLongCase) continue;
      const Case& one = formulas[f].cases[0];
      Shares& shares = shares_[{c, static_cast<int>(f)}];
      shares.forms.resize(model_.items.size());
      shares.wishes.resize(model_.items.size());
      const auto note = [](const Linear& form, std::size_t number, ById<ItemId, std::vector<std::size_t>>& by_item) {
        for (const Term& term : form.terms) {
          std::vector<std::size_t>& own = by_item[term.item];
          if (own.empty() || own.back() != number) own.push_back(number);
        }
      };
      for (std::size_t i = 0; i < one.at_least_zero.size(); ++i) note(one.at_least_zero[i], i, shares.forms);
      for (std::size_t i = 0; i < one.wishes.size(); ++i) note(one.wishes[i].form, i, shares.wishes);
    }
  }
}

// False: enough of it.
bool RegionFinder::toil(std::size_t more) {
  if (budget_ == nullptr) return true;
  budget_->toil(static_cast<std::int64_t>(more));
  return !budget_->stopped;
}

// Something that must hold speaks of it and of something else.
bool RegionFinder::is_linked(ItemId item) const {
  if (model_.items[item].fixed) return false;
  return std::any_of(model_.touching[item].begin(), model_.touching[item].end(), [&](ConstraintId c) {
    const auto& formulas = model_.constraints[c].formulas;
    return enforced(c) && std::any_of(formulas.begin(), formulas.end(), [](const Formula& f) { return f.items.size() > 1; });
  });
}

// What the room alone leaves.
Domain RegionFinder::widest_domain(const Item& item) const {
  Domain d;
  d.least = d.greatest = item.states[0].extent;
  for (const State& state : item.states) {
    for (int k = 0; k < 3; ++k) {
      d.least[k] = std::min(d.least[k], state.extent[k]);
      d.greatest[k] = std::max(d.greatest[k], state.extent[k]);
    }
  }
  for (int k = 0; k < 3; ++k) {
    d.lo[k] = item.fixed ? item.fixed_at[k] : model_.room.lo[k];
    d.hi[k] = item.fixed ? item.fixed_at[k] : model_.room.hi[k] - d.least[k];
  }
  return d;
}

// What the constraints leave while nothing stands; as before where they leave nothing.
Domain RegionFinder::narrower_domain(ItemId item, const Placements& nowhere) {
  Domain all = domains_[item];
  bool any = false;
  const std::vector<State>& states = model_.items[item].states;
  for (std::size_t s = 0; s < states.size(); ++s) {
    if (states[s].size_step > most_size_step_) continue;
    for (const Region& region : find(nowhere, item, static_cast<int>(s), false)) {
      for (int k = 0; k < 3; ++k) {
        all.lo[k] = any ? std::min(all.lo[k], region.lo[k]) : region.lo[k];
        all.hi[k] = any ? std::max(all.hi[k], region.hi[k]) : region.hi[k];
      }
      any = true;
    }
  }
  return all;
}

// Bounds that follow from the constraints, found by going over all items a few times, whatever is left out. It is no part of the work of
// the search, but ends with it.
void RegionFinder::narrow_domains() {
  const Placements nowhere(model_.items.size());
  Budget own{0, 0, budget_->stop, budget_->stopped};
  Budget* const of_search = std::exchange(budget_, &own);
  ById<ItemId, char> left_out = std::exchange(scope_.left_out, {});
  for (int round = 0; round < kNarrowings; ++round) {
    for (const ItemId i : domains_.ids()) {
      if (own.work > kMostNarrowing || own.stopped) break;
      if (is_linked(i)) domains_[i] = narrower_domain(i, nowhere);
    }
  }
  scope_.left_out = std::move(left_out);
  budget_ = of_search;
  budget_->work += own.work;
  budget_->stopped = budget_->stopped || own.stopped;
}

bool RegionFinder::enforced(ConstraintId constraint) const {
  return !scope_.gives_up(constraint) && model_.constraints[constraint].firmness != Firmness::kSoft;
}

bool RegionFinder::reduce(const Placements& placements, const Case& one, ItemId item, int state, bool with_wishes, const Shares* shares,
                          Reduced& out) const {
  out.price = one.price * kPoint;
  for (const StateLiteral& literal : one.states) {
    if (scope_.leaves_out(literal.item)) return false;
    const int s = literal.item == item ? state : placements[literal.item].state;
    if (s >= 0 && !(literal.states >> s & 1)) return false;
  }
  const auto is_out = [&](const Term& term) { return scope_.leaves_out(term.item); };
  const std::vector<std::size_t>* forms = shares ? &shares->forms[item] : nullptr;
  for (std::size_t i = 0; i < (forms ? forms->size() : one.at_least_zero.size()); ++i) {
    const Linear& form = one.at_least_zero[forms ? (*forms)[i] : i];
    if (std::any_of(form.terms.begin(), form.terms.end(), is_out)) return false;
    const Partial p = partial_of(model_, placements, domains_, form, item, state);
    const int axis = p.axis();
    if (axis == -1) {
      if (p.constant < 0) return false;
      continue;
    }
    if (axis < 0) {
      out.checks.push_back(p);
      continue;
    }
    const std::int64_t a = p.coefficient[axis];  // a·x + constant ≥ 0
    if (a > 0) {
      out.lo[axis] = static_cast<Mm>(std::clamp<std::int64_t>(ceil_div(-p.constant, a), out.lo[axis], 1 << 30));
    } else {
      out.hi[axis] = static_cast<Mm>(std::clamp<std::int64_t>(floor_div(p.constant, -a), -(1 << 30), out.hi[axis]));
    }
    if (out.lo[axis] > out.hi[axis]) return false;
  }
  if (!with_wishes) return true;
  const std::vector<std::size_t>* wishes = shares ? &shares->wishes[item] : nullptr;
  for (std::size_t i = 0; i < (wishes ? wishes->size() : one.wishes.size()); ++i) {
    const Preference& wish = one.wishes[wishes ? (*wishes)[i] : i];
    const Partial p = partial_of(model_, placements, domains_, wish.form, item, state);
    if (!p.unknown) out.wishes.push_back({p, wish.weight, wish.scale});
  }
  return true;
}

std::vector<Reduced>& RegionFinder::next_pool() {
  if (pools_ == pool_.size()) pool_.emplace_back();
  pool_[pools_].clear();
  return pool_[pools_];
}

const std::vector<Region>& RegionFinder::find(const Placements& placements, ItemId item, int state, bool with_wishes) {
  pools_ = 0;
  regions_.clear();
  for (const ConstraintId c : model_.touching[item]) {
    if (!enforced(c)) continue;
    for (std::size_t f = 0; f < model_.constraints[c].formulas.size(); ++f) {
      const Formula& formula = model_.constraints[c].formulas[f];
      const bool speaks = formula.cases.empty() || std::find(formula.items.begin(), formula.items.end(), item) != formula.items.end();
      if (!speaks) continue;
      const auto found = shares_.find({c, static_cast<int>(f)});
      const Shares* shares = found == shares_.end() ? nullptr : &found->second;
      if (!toil(shares ? 1 + shares->forms[item].size() : formula.cases.size())) return regions_;
      std::vector<Reduced>& cases = next_pool();
      for (const Case& one : formula.cases) {
        if (!reduce(placements, one, item, state, with_wishes, shares, cases.emplace_back())) cases.pop_back();
      }
      if (cases.empty()) return regions_;
      const auto cheaper = [](const Reduced& a, const Reduced& b) { return a.price < b.price; };
      if (!std::is_sorted(cases.begin(), cases.end(), cheaper)) std::stable_sort(cases.begin(), cases.end(), cheaper);
      ++pools_;
    }
  }
  by_size_.clear();
  for (std::size_t i = 0; i < pools_; ++i) {
    const auto smaller = [](const auto* a, const auto* b) { return a->size() < b->size(); };
    by_size_.insert(std::upper_bound(by_size_.begin(), by_size_.end(), &pool_[i], smaller), &pool_[i]);
  }
  Region whole;
  const Item& self = model_.items[item];
  for (int k = 0; k < 3; ++k) {
    whole.lo[k] = model_.room.lo[k];
    whole.hi[k] = model_.room.hi[k] - self.states[state].extent[k];
  }
  if (self.fixed) whole.lo = whole.hi = self.fixed_at;
  int nodes = 0;
  chosen_.clear();
  if (!whole.empty()) descend(0, whole, nodes);
  toil(static_cast<std::size_t>(nodes));
  return regions_;
}

void RegionFinder::descend(std::size_t depth, const Region& region, int& nodes) {
  if (regions_.size() >= kMostRegions || ++nodes > kMostNodes) return;
  if (depth == by_size_.size()) {
    regions_.push_back(region);
    regions_.back().cases = chosen_;
    return;
  }
  for (const Reduced& one : *by_size_[depth]) {
    Region next;
    for (int k = 0; k < 3; ++k) {
      next.lo[k] = std::max(region.lo[k], one.lo[k]);
      next.hi[k] = std::min(region.hi[k], one.hi[k]);
    }
    if (next.empty()) continue;
    const bool speaks = !one.checks.empty() || !one.wishes.empty();
    next.price = region.price + one.price;
    if (speaks) chosen_.push_back(&one);
    descend(depth + 1, next, nodes);
    if (speaks) chosen_.pop_back();
  }
}

}  // namespace layoutbox::placement
