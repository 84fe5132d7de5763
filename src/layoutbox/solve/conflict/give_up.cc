#include "layoutbox/solve/solving.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "layoutbox/solve/conflict/relax.h"
#include "layoutbox/solve/objective/access.h"
#include "layoutbox/solve/objective/cost.h"
#include "layoutbox/solve/search/quick.h"
#include "layoutbox/solve/search/search.h"

namespace layoutbox::placement {
namespace {

constexpr int kMostKept = 30;  // questions whether one more relation can be held
constexpr int kOtherStarts = 12;
constexpr std::int64_t kShareOfOtherStarts = 3;  // of the work
constexpr int kGuesses = 2;  // relations given up one by one without a proof, before all that do not fit are given up at once

}  // namespace

// Nothing found and nothing proven: what, once it is given up, lets a layout be found? First what nobody asked for.
Result<bool> Solver::give_up_unproven(bool loose, const Placements& loosely) {
  if (search_from_elsewhere()) return true;
  if (!assumptions_left().empty()) {
    if (loose) placements_ = loosely;
    const std::vector<ConstraintId> left = assumptions_left();
    const bool blocks_door = std::ranges::any_of(left, [&](ConstraintId c) { return is_door_floor(c) && (!loose || is_missed(c)); });
    if (blocks_door && companions_are_in_the_way()) {
      LAYOUTBOX_CHECK(companions_make_way());
      return false;
    }
    const std::size_t before = left_out_ids_.size();
    LAYOUTBOX_CHECK(yield_assumptions(loose));
    return loose && left_out_ids_.size() == before;  // where companions went, the rest is placed anew
  }
  if (const std::vector<ItemId> extras = extras_in_the_way(); !extras.empty()) {
    LAYOUTBOX_CHECK(leave_out_least(extras));
    return false;
  }
  LAYOUTBOX_ASSIGN(const bool made_way, companions_make_way());
  if (made_way) return false;
  if (++unproven_ > kGuesses && demands_left(Firmness::kHard)) {
    LAYOUTBOX_ASSIGN(const bool settled, settle());
    if (settled) return true;
  }
  const bool relations = demands_left(Firmness::kHard);
  if (!relations || !search_without(Firmness::kHard)) {  // relations are not what is in the way
    LAYOUTBOX_CHECK(leave_out_least({}));
    return false;
  }
  LAYOUTBOX_CHECK(give_up(guess()));
  return false;
}

// Before anything is given up on a guess: some more starts, once.
bool Solver::search_from_elsewhere() {
  if (searched_elsewhere_ || !model_.start.empty()) return false;
  searched_elsewhere_ = true;
  const Dependencies dependencies(model_);
  const std::vector<ItemId> failed = failed_;
  const std::int64_t most = finding_.steps + finding_.limit / kShareOfOtherStarts;
  for (int start = 1; start <= kOtherStarts && finding_.steps < most && !enough(); ++start) {
    const int sizes = start % 2 == 0 || !any_other_size() ? 0 : kAllSizes;
    Budget budget = part(kFirstSteps);
    placements_.assign(model_.items.size(), {});
    QuickSearch quick(model_, dependencies, scope_, options_.seed + kSeedStep * static_cast<std::uint64_t>(start), sizes);
    if (!quick.complete(placements_, budget)) continue;
    size_limit_ = sizes;
    return true;
  }
  failed_ = failed;
  return false;
}

// All that is asked for becomes a wish; what the layout then misses, and no other layout found in a moment holds beside the rest, is given
// up, in one go.
Result<bool> Solver::settle() {
  PlacementModel trial = model_;
  const Scope scope = all_wished(trial);
  Budget budget = part(4 * kLeastSteps);
  Search search(trial, scope, options_.seed, kAllSizes);
  if (!search.construct(kRestarts, budget)) return false;
  budget.limit = budget.steps + 2 * kLeastSteps;
  search.improve(budget, kPatience);
  placements_ = search.placements();
  std::vector<ConstraintId> missed;
  for (const ConstraintId c : trial.constraints.ids()) {
    const bool asked = model_.constraints[c].firmness == Firmness::kHard && !scope_.given_up[c];
    if (asked && miss_of(trial, trial.constraints[c], placements_) != 0) missed.push_back(c);
  }
  keep_what_can_be(missed);
  for (const ConstraintId c : missed) {
    if (fallback_) break;
    Clash clash;
    clash.proven = clash.minimal = false;
    clash.demands = {Demand::of(c)};
    const RelationId relation = model_.constraints[c].relation;
    clash.sentence = relation.exists() ? fmt::format("no layout was found in which, beside all else, {}",
                                                     relation_in_words(model_, model_.relation(relation)))
                                       : std::string("no layout was found in which all relations hold together");
    LAYOUTBOX_CHECK(give_up(clash));
  }
  return true;
}

// Of what a layout misses, the weightiest first: is there another that holds it beside all that is held so far?
void Solver::keep_what_can_be(std::vector<ConstraintId>& missed) {
  Scope scope = scope_;
  for (const ConstraintId c : missed) scope.given_up[c] = 1;
  const auto price = [&](ConstraintId c) { return price_of(model_, Demand::of(c)); };
  std::stable_sort(missed.begin(), missed.end(), [&](ConstraintId a, ConstraintId b) { return price(a) > price(b); });
  const Dependencies dependencies(model_);
  int tries = 0;
  std::erase_if(missed, [&](ConstraintId c) {
    if (++tries > kMostKept || enough()) return false;
    scope.given_up[c] = 0;
    QuickSearch quick(model_, dependencies, scope, options_.seed, kAllSizes);
    Budget budget = part(kLeastSteps);
    Placements other(model_.items.size());
    const bool found = quick.complete(other, budget);
    if (found) placements_ = other;
    if (!found) scope.given_up[c] = 1;
    return found;
  });
  std::sort(missed.begin(), missed.end());
}

bool Solver::demands_left(Firmness firmness) const {
  for (const ConstraintId c : model_.constraints.ids()) {
    if (model_.constraints[c].firmness == firmness && !scope_.given_up[c]) return true;
  }
  return false;
}

// Is there a layout when all demands of that firmness are given up?
bool Solver::search_without(Firmness firmness) {
  if (!demands_left(firmness)) return false;
  Scope less = scope_;
  for (const ConstraintId c : model_.constraints.ids()) less.given_up[c] |= model_.constraints[c].firmness == firmness;
  const std::vector<ItemId> failed = failed_;
  const bool found = search(less);
  failed_ = failed;
  return found;
}

// Without a proof: what the first item that found no place asks for.
Clash Solver::guess() const {
  Clash clash;
  clash.proven = clash.minimal = false;
  const auto asks = [&](ItemId item) {
    for (const ConstraintId c : model_.touching[item]) {
      if (model_.constraints[c].firmness == Firmness::kHard && !scope_.given_up[c]) clash.demands.push_back(Demand::of(c));
    }
  };
  ItemId item;
  for (const ItemId failed : failed_) {  // the first that asks for something
    item = failed;
    asks(failed);
    if (!clash.demands.empty()) break;
  }
  for (const ItemId i : model_.items.ids()) {
    if (clash.demands.empty()) asks(item = i);
  }
  if (!item.exists()) return clash;
  clash.demands.push_back(Demand::of_item(item));
  clash.sentence = fmt::format("no place was found for {} where all that is asked of it holds", object_in_words(model_, item));
  return clash;
}

// How far a relation would be missed if it alone were given up; more than any distance where that does not help.
std::int64_t Solver::miss_without(ConstraintId constraint) {
  PlacementModel trial = model_;
  trial.constraints[constraint].firmness = Firmness::kSoft;
  trial.constraints[constraint].weight *= kStillWished;
  Scope scope = scope_;
  scope.given_up[constraint] = 1;
  Search search(trial, scope, options_.seed, size_limit_);
  Budget budget = part(kLeastSteps);
  if (!search.construct(2, budget)) return 1 << 30;
  budget.limit = budget.steps + kLeastSteps / 2;
  search.improve(budget, kPatience);
  return miss_of(trial, trial.constraints[constraint], search.placements());
}

// The least price; of equals the relation that is then missed by least, of those the last one said.
std::vector<Demand>::const_iterator Solver::cheapest_of(const Clash& clash) {
  const auto begin = clash.demands.begin(), end = clash.demands.end();
  const auto price = [&](const Demand& d) { return price_of(model_, d); };
  const auto cheapest = std::min_element(
      begin, end, [&](const Demand& a, const Demand& b) { return std::pair(price(a), -a.number()) < std::pair(price(b), -b.number()); });
  if (cheapest == end || cheapest->is_item() || options_.on_conflict != OnConflict::kRelax) return cheapest;
  auto best = cheapest;
  std::int64_t least = -1;
  for (auto it = begin; it != end; ++it) {
    if (price(*it) != price(*cheapest) || it->is_item()) continue;
    if (least < 0) {
      if (std::count_if(begin, end, [&](const Demand& d) { return price(d) == price(*cheapest); }) == 1) return cheapest;
      least = miss_without(cheapest->constraint);
    }
    if (it == cheapest) continue;
    const std::int64_t miss = miss_without(it->constraint);
    if (miss < least) least = miss, best = it;
  }
  return best;
}

// True: something is to be given up for it. False: the scene's own positions were taken. An error where that is asked for.
Result<bool> Solver::note_conflict(const Clash& clash, bool asked) {
  Conflict conflict;
  conflict.sentence = describe_clash(model_, clash);
  conflict.minimal = clash.minimal;
  for (const Demand& demand : clash.demands) {
    if (demand.is_item()) {
      conflict.objects.push_back(model_.items[demand.item].id);
    } else {
      conflict.relations.push_back(model_.constraints[demand.constraint].name);
    }
  }
  conflicts_.push_back({conflict, asked});
  // Where conflicts are errors, what could be given up is, only to see whether there are others.
  if (options_.on_conflict == OnConflict::kFail && asked) (clash.proven ? impossible_ : not_found_).push_back(conflict.sentence);
  if (options_.on_conflict == OnConflict::kOriginal && asked) {
    fall_back();
    return false;
  }
  return true;
}

Status Solver::give_up(const Clash& clash) {
  const std::vector<ItemId> objects = objects_to_blame(model_, clash);
  LAYOUTBOX_ASSIGN(const bool made_way, companions_make_way_for(objects));
  if (made_way) return {};
  if (!objects.empty() && !floor_gives_way(clash, objects)) return leave_out_least(objects, &clash);
  const auto cheapest = cheapest_of(clash);
  if (cheapest == clash.demands.cend()) return fail(ErrorCode::kNotFound, "no layout was found, and nothing is left to give up");
  const bool item = cheapest->is_item();
  const bool asked = item ? is_asked(cheapest->item) : !is_assumption(model_, model_.constraints[cheapest->constraint]);
  LAYOUTBOX_ASSIGN(const bool relaxing, note_conflict(clash, asked));
  if (!relaxing) return {};
  if (!item) {
    const std::vector<std::string> companions = companions_placed_by(model_.constraints[cheapest->constraint]);
    if (!companions.empty()) return leave_out_companions(companions);
  }
  const std::string& why = conflicts_.back().conflict.sentence;
  if (item) return leave_out(cheapest->item, why);
  relax(model_.constraints[cheapest->constraint].name, why);
  return {};
}

// All of another model but what is relaxed in this one.
Scope Solver::scope_in(const PlacementModel& model) const {
  Scope scope;
  for (const Constraint& constraint : model.constraints) scope.given_up.push_back(static_cast<char>(is_relaxed(constraint.name)));
  return scope;
}

// Given up, but still wished for.
void Solver::soften(const std::string& name) {
  for (const ConstraintId c : model_.constraints.ids()) {
    Constraint& constraint = model_.constraints[c];
    const bool demanded = constraint.firmness == Firmness::kHard || constraint.firmness == Firmness::kImplied;
    if (constraint.name != name || !demanded || scope_.given_up[c]) continue;
    scope_.given_up[c] = 1;
    if (constraint.firmness != Firmness::kHard) continue;
    constraint.firmness = Firmness::kSoft;
    constraint.weight *= kStillWished;
  }
}

// The paper's way out: the scene's own positions, or a metre from the corner.
void Solver::fall_back() {
  fallback_ = true;
  for (const ItemId i : model_.items.ids()) {
    const Item& item = model_.items[i];
    if (item.is_opening()) continue;
    const auto& hint = item.object->hint;
    Placement p{0, {}};
    const int turn = static_cast<int>(std::lround(normalized_degrees(hint.rotation_deg.value_or(0)))) % 360;
    if (const std::uint64_t states = item.states_at(turn)) p.state = std::countr_zero(states);
    const Vec3& e = item.states[p.state].extent;
    const std::array<double, 3> at = hint.position.value_or(std::array<double, 3>{1000, 1000, 0});
    for (int k = 0; k < 3; ++k) p.at[k] = static_cast<Mm>(std::lround(at[k] - (k < 2 ? e[k] / 2.0 : 0)));
    placements_[i] = p;
  }
}

}  // namespace layoutbox::placement
