// What was given up before something else was, and no longer needs to be.
#include "layoutbox/solve/quick.h"
#include "layoutbox/solve/solving.h"

namespace layoutbox::placement {

// Nobody has shown that it cannot be, or others of what it clashed with were given up as well.
bool Solver::may_come_back(const std::string& name, const std::string& why) const {
  const auto conflict = std::find_if(conflicts_.begin(), conflicts_.end(), [&](const Conflict& c) { return c.sentence == why; });
  if (conflict == conflicts_.end()) return false;
  const auto gone = [&](const std::string& other) { return other != name && is_relaxed(other); };
  return !conflict->minimal || std::any_of(conflict->relations.begin(), conflict->relations.end(), gone);
}

// True: there is a layout that holds it beside all that is held so far.
bool Solver::take_back(const std::string& name) {
  std::vector<char> given_up = given_up_;
  for (std::size_t c = 0; c < given_up.size(); ++c) {
    if (model_.constraints[c].name == name) given_up[c] = 0;
  }
  const Dependencies dependencies(model_);
  Placements placements(model_.items.size());
  Budget budget{0, kLeastSteps, [this] { return must_stop(); }, false};
  // A wish is no demand to the search: for the question it is one again.
  const auto demand = [&](bool again) {
    for (std::size_t c = 0; c < given_up.size(); ++c) {
      Constraint& constraint = model_.constraints[c];
      if (constraint.name != name || constraint.firmness == Firmness::kImplied) continue;
      constraint.firmness = again ? Firmness::kHard : Firmness::kSoft;
      constraint.weight = again ? constraint.weight / kStillWished : constraint.weight * kStillWished;
    }
  };
  demand(true);
  if (!QuickSearch(model_, dependencies, given_up, options_.seed, kAllSizes).complete(placements, left_out_, budget)) {
    demand(false);
    return false;
  }
  given_up_ = given_up, placements_ = placements, size_limit_ = kAllSizes;
  return true;
}

// The weightiest first; what nobody asked for last. A conflict of which everything holds in the end was none.
void Solver::take_back() {
  if (relaxed_.empty() || !model_.start.empty() || must_stop()) return;
  const auto weight = [&](const std::string& name) {
    for (const Constraint& c : model_.constraints) {
      if (c.name == name) return c.firmness == Firmness::kImplied || c.relation < 0 ? 0 : c.weight;
    }
    return 0;
  };
  std::vector<std::pair<std::string, std::string>> given_up = relaxed_;
  std::stable_sort(given_up.begin(), given_up.end(), [&](const auto& a, const auto& b) { return weight(a.first) > weight(b.first); });
  for (const auto& [name, why] : given_up) {
    if (must_stop() || !may_come_back(name, why) || !take_back(name)) continue;
    std::erase_if(relaxed_, [&](const auto& r) { return r.first == name; });
    std::erase_if(conflicts_, [&](const Conflict& c) {
      return !c.minimal && c.objects.size() + c.relations.size() > 0 &&
             std::none_of(c.relations.begin(), c.relations.end(), [&](const std::string& r) { return is_relaxed(r); }) && c.sentence == why;
    });
  }
}

}  // namespace layoutbox::placement
