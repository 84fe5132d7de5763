// Whatever is asked for, something legal stands there: all that is asked becomes a wish, and what finds no place then is left out.
#include <fmt/format.h>

#include "layoutbox/solve/conflict/relax.h"
#include "layoutbox/solve/search/quick.h"
#include "layoutbox/solve/search/search.h"
#include "layoutbox/solve/solving.h"

namespace layoutbox::placement {
namespace {

constexpr double kGrace = 0.15;  // seconds past the time limit for a search that looks at wishes

// Does one of the cases hold, of those that speak of nothing but what is placed?
bool holds_of_placed(const PlacementModel& model, const Formula& formula, const Placements& placements) {
  return std::any_of(formula.cases.begin(), formula.cases.end(), [&](const Case& one) {
    const auto there = [&](ItemId item) { return placements[item].state >= 0; };
    const auto known = [&](const Linear& form) {
      return std::all_of(form.terms.begin(), form.terms.end(), [&](const Term& term) { return there(term.item); });
    };
    if (!std::all_of(one.states.begin(), one.states.end(), [&](const StateLiteral& l) { return there(l.item); })) return false;
    if (!std::all_of(one.at_least_zero.begin(), one.at_least_zero.end(), known)) return false;
    Formula alone;
    alone.cases = {one};
    return miss_of(model, alone, placements) == 0;
  });
}

}  // namespace

// What was to stand on something that found no place stands nowhere.
void Solver::drop_what_hangs_in_the_air() {
  for (bool again = true; again;) {
    again = false;
    for (const ItemId i : model_.items.ids()) {
      if (placements_[i].state < 0 || model_.items[i].is_opening() || model_.items[i].fixed) continue;
      const auto& formulas = model_.constraints[model_.items[i].support_constraint].formulas;
      const bool held_up =
          std::all_of(formulas.begin(), formulas.end(), [&](const Formula& f) { return holds_of_placed(model_, f, placements_); });
      if (held_up) continue;
      placements_[i] = {};
      again = true;
    }
  }
}

// Without its door there is no room: where one found no place, doors and windows take theirs first, and what then overlaps goes.
void Solver::place_openings_first(const PlacementModel& trial, const Scope& scope) {
  Scope openings = scope;
  bool all = true;
  for (const ItemId i : trial.items.ids()) {
    if (trial.items[i].is_opening())
      all = all && placements_[i].state >= 0;
    else
      openings.left_out[i] = 1;
  }
  if (all) return;
  Placements now(trial.items.size());
  const Dependencies dependencies(trial);
  QuickSearch quick(trial, dependencies, openings, options_.seed, kAllSizes);
  Budget budget{0, kLeastSteps, [this] { return interrupted(); }, false};  // few things: no look at the clock, or there were no room
  quick.complete(now, budget);
  for (const ItemId i : trial.items.ids()) {
    if (trial.items[i].is_opening() || placements_[i].state < 0) continue;
    const auto leaves_free = [&](ItemId o) {
      return !trial.items[o].is_opening() || now[o].state < 0 || !collide(trial, i, placements_[i], o, now[o], true);
    };
    const bool free = std::ranges::all_of(trial.items.ids(), leaves_free);
    if (free) now[i] = placements_[i];
  }
  placements_ = std::move(now);
}

// Everything where it goes, as far as it goes; what finds no place has none.
void Solver::place_what_fits(const PlacementModel& trial, const Scope& scope, std::uint64_t seed, double until) {
  Search search(trial, scope, seed, kAllSizes);
  Budget budget{0, kLeastSteps, [this, until] { return interrupted() || seconds() > until; }, false};
  const bool all = search.construct(0, budget);
  placements_ = search.placements();
  if (!all && !interrupted()) {  // the rest without a look at what is wished for: these steps are few
    const double moment = seconds() + kGrace;
    const Dependencies dependencies(trial);
    QuickSearch quick(trial, dependencies, scope, seed, kAllSizes);
    Budget more{0, kLeastSteps, [this, moment] { return interrupted() || seconds() > moment; }, false};
    quick.complete(placements_, more);
  }
  if (interrupted()) return;
  place_openings_first(trial, scope);
  drop_what_hangs_in_the_air();
}

// With what was asked for in its place: as many companions as fit beside it without any of that going.
void Solver::let_companions_in(const PlacementModel& trial, const Scope& scope) {
  const auto placed = [&](const Placements& placements) {
    std::ptrdiff_t count = 0;
    for (const ItemId i : placements.ids()) count += placements[i].state >= 0 && !is_companion(i);
    return count;
  };
  const Placements without = placements_;
  const Dependencies dependencies(trial);
  QuickSearch quick(trial, dependencies, scope, options_.seed, kAllSizes);
  Budget budget{0, kLeastSteps, [this] { return must_stop(); }, false};
  quick.complete(placements_, budget);
  drop_what_hangs_in_the_air();
  if (placed(placements_) < placed(without)) placements_ = without;
  std::vector<std::string> gone = left_out_ids_;
  for (const ItemId i : placements_.ids()) {
    if (placements_[i].state < 0) gone.push_back(model_.items[i].id);
  }
  for (const std::string& id : companions_left_alone(asked_, catalog_, gone)) {
    const ItemId item = model_.find_item(id);
    if (item.exists() && is_companion(item)) placements_[item] = {};
  }
  drop_what_hangs_in_the_air();
}

// Errors: kInterrupted; kNotFound where a door has no place.
Status Solver::take_what_fits() {
  constexpr int kTries = 6;  // from unlike starts: with which most finds a place
  const bool late = stopped_by_clock_;
  PlacementModel trial = model_;
  const Scope whole = all_wished(trial);
  const double until = late ? seconds() + kGrace : options_.time_limit_s + kGrace;
  const Placements before = placements_;
  Scope first = whole;  // companions wait
  for (const ItemId item : companions()) first.left_out[item] = 1;
  const std::ptrdiff_t all = std::ranges::count(first.left_out, 0);
  Placements best;
  std::ptrdiff_t most = -1;
  for (int t = 0; t < (late ? 1 : kTries) && (best.empty() || seconds() < options_.time_limit_s); ++t) {
    placements_ = before;
    place_what_fits(trial, first, options_.seed + static_cast<std::uint64_t>(t), until);
    if (interrupted()) return fail(ErrorCode::kInterrupted, "stopped");
    const auto placed = std::ranges::count_if(placements_, [](const Placement& p) { return p.state >= 0; });
    if (placed > most) most = placed, best = placements_;
    if (placed == all) break;
  }
  placements_ = std::move(best);
  if (first.left_out != whole.left_out) let_companions_in(trial, whole);
  return note_what_is_missing();
}

// What found no place is left out, and what does not hold is given up. Errors: kNotFound where a door has no place.
Status Solver::note_what_is_missing() {
  std::vector<ItemId> gone;
  for (const ItemId i : model_.items.ids()) {
    if (placements_[i].state >= 0 || scope_.left_out[i]) continue;
    if (model_.items[i].is_opening()) return fail(ErrorCode::kNotFound, "no place was found for " + object_in_words(model_, i));
    gone.push_back(i);
  }
  const std::string because = stopped_by_clock_ ? "no layout of all that is asked for was found before the time was up"
                                                : "no layout was found in which all that is asked for holds together";
  std::vector<ItemId> dear;
  std::ranges::copy_if(gone, std::back_inserter(dear), [&](ItemId i) { return !is_companion(i); });
  Clash clash;
  clash.proven = clash.minimal = false;
  clash.sentence = too_little_floor(dear).value_or(because);
  bool asked = false;
  for (const ItemId item : gone) {
    scope_.left_out[item] = 1;
    asked = asked || is_asked(item);
    if (!is_companion(item)) clash.demands.push_back(Demand::of_item(item));
    reasons_.push_back({model_.items[item].id, 0, "", object_in_words(model_, item) + " is left out: " + clash.sentence});
  }
  std::vector<std::string> missed;
  for (const ConstraintId c : model_.constraints.ids()) {
    const Constraint& constraint = model_.constraints[c];
    if (constraint.firmness != Firmness::kHard || scope_.given_up[c]) continue;
    if (all_placed(constraint, placements_) && miss_of(model_, constraint, placements_) == 0) continue;
    missed.push_back(constraint.name);
    asked = asked || !is_assumption(model_, constraint);
    clash.demands.push_back(Demand::of(c));
  }
  if (clash.demands.empty()) return {};
  LAYOUTBOX_ASSIGN(const bool relaxing, note_conflict(clash, asked));
  for (const std::string& name : missed) {
    if (relaxing) relax(name, because);
  }
  return {};
}

// What is hard becomes a wish of the model; what need not hold in it.
Scope Solver::all_wished(PlacementModel& trial) const {
  Scope scope = scope_;
  for (const ConstraintId c : trial.constraints.ids()) {
    Constraint& constraint = trial.constraints[c];
    if (constraint.firmness != Firmness::kHard || scope.given_up[c]) continue;
    constraint.firmness = Firmness::kSoft;
    constraint.weight *= kStillWished;
    scope.given_up[c] = 1;
  }
  return scope;
}

}  // namespace layoutbox::placement
