// What was given up before something else was, and no longer needs to be.
#include "layoutbox/solve/conflict/relax.h"
#include "layoutbox/solve/search/quick.h"
#include "layoutbox/solve/solving.h"

namespace layoutbox::placement {

// Nobody has shown that it cannot be, or others of what it clashed with were given up as well.
bool Solver::may_come_back(const std::string& name, const std::string& why) const {
  const auto noted = std::find_if(conflicts_.begin(), conflicts_.end(), [&](const Noted& n) { return n.conflict.sentence == why; });
  if (noted == conflicts_.end()) return false;
  const Conflict& conflict = noted->conflict;
  const auto gone = [&](const std::string& other) { return other != name && is_relaxed(other); };
  return !conflict.minimal || std::any_of(conflict.relations.begin(), conflict.relations.end(), gone);
}

// True: there is a layout that holds it beside all that is held so far.
bool Solver::take_back(const std::string& name) {
  Scope with = scope_;
  for (const ConstraintId c : with.given_up.ids()) {
    if (model_.constraints[c].name == name) with.given_up[c] = 0;
  }
  const Dependencies dependencies(model_);
  Placements placements(model_.items.size());
  Budget budget = part(kLeastSteps);
  // A wish is no demand to the search: for the question it is one again.
  const auto demand = [&](bool again) {
    for (const ConstraintId c : model_.constraints.ids()) {
      Constraint& constraint = model_.constraints[c];
      if (constraint.name != name || constraint.firmness == Firmness::kImplied) continue;
      constraint.firmness = again ? Firmness::kHard : Firmness::kSoft;
      constraint.weight = again ? constraint.weight / kStillWished : constraint.weight * kStillWished;
    }
  };
  demand(true);
  if (!QuickSearch(model_, dependencies, with, options_.seed, kAllSizes).complete(placements, budget)) {
    demand(false);
    return false;
  }
  scope_ = with, placements_ = placements, size_limit_ = kAllSizes;
  return true;
}

// The dearest first; what nobody asked for last. A conflict of which everything holds in the end was none.
void Solver::take_back() {
  if (relaxed_.empty() || !model_.start.empty() || must_stop()) return;
  const auto price = [&](const std::string& name) -> std::int64_t {
    for (const ConstraintId c : model_.constraints.ids()) {
      const Constraint& constraint = model_.constraints[c];
      const bool lock = constraint.firmness != Firmness::kImplied && !constraint.relation.exists();
      if (constraint.name == name) return lock ? 0 : price_of(model_, Demand::of(c));
    }
    return 0;
  };
  std::vector<std::pair<std::string, std::string>> given_up = relaxed_;
  std::stable_sort(given_up.begin(), given_up.end(), [&](const auto& a, const auto& b) { return price(a.first) > price(b.first); });
  for (const auto& [name, why] : given_up) {
    if (enough() || !may_come_back(name, why) || !take_back(name)) continue;
    std::erase_if(relaxed_, [&](const auto& r) { return r.first == name; });
    std::erase_if(conflicts_, [&](const Noted& noted) {
      const Conflict& c = noted.conflict;
      return !c.minimal && c.objects.size() + c.relations.size() > 0 &&
             std::none_of(c.relations.begin(), c.relations.end(), [&](const std::string& r) { return is_relaxed(r); }) && c.sentence == why;
    });
  }
}

}  // namespace layoutbox::placement
