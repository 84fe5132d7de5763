// What nobody asked for gives way to what was: hosts and places that are assumed, free floor before openings.
#include <fmt/format.h>

#include "layoutbox/solve/conflict/relax.h"
#include "layoutbox/solve/objective/access.h"
#include "layoutbox/solve/objective/cost.h"
#include "layoutbox/solve/solving.h"

namespace layoutbox::placement {

// Demands that nobody asked for and that have not given way.
std::vector<ConstraintId> Solver::assumptions_left() const {
  std::vector<ConstraintId> left;
  const bool things_went = asked_things_went();
  for (const ConstraintId c : model_.constraints.ids()) {
    const Constraint& constraint = model_.constraints[c];
    const bool demanded = constraint.firmness == Firmness::kHard || constraint.firmness == Firmness::kImplied;
    if (demanded && !scope_.given_up[c] && is_assumption(model_, constraint) && !(things_went && is_door_floor(c))) left.push_back(c);
  }
  return left;
}

// Something that was asked for has been left out for want of floor: then another thing goes rather than that a door is blocked.
bool Solver::asked_things_went() const {
  return std::any_of(left_out_ids_.begin(), left_out_ids_.end(), [&](const std::string& id) {
    const SceneObject* object = asked_.find_object(id);
    return object != nullptr && object->asked();
  });
}

bool Solver::is_door_floor(ConstraintId constraint) const {
  return std::any_of(model_.items.begin(), model_.items.end(), [&](const Item& item) {
    return item.is_opening() && item.clearance_constraint == constraint && item.opening->type != OpeningType::kWindow;
  });
}

bool Solver::search_without_assumptions() {
  const std::vector<ConstraintId> assumptions = assumptions_left();
  if (assumptions.empty()) return false;
  Scope less = scope_;
  for (const ConstraintId c : assumptions) less.given_up[c] = 1;
  const std::vector<ItemId> failed = failed_;
  const bool found = search(less);
  failed_ = failed;
  return found;
}

// By the layout at hand.
bool Solver::is_missed(ConstraintId constraint) const {
  for (const ItemId i : model_.items.ids()) {
    if (model_.items[i].is_opening() && model_.items[i].clearance_constraint == constraint)
      return placements_[i].state >= 0 && intrusion_of(model_, i, placements_) != 0;
  }
  return miss_of(model_, model_.constraints[constraint], placements_) != 0;
}

// What nobody asked for gives way: where a layout was found without it, what that misses and no other holds beside the rest; else all of
// it, to come back in the end where it can.
Status Solver::yield_assumptions(bool found) {
  std::vector<ConstraintId> missed = assumptions_left();
  if (found) {
    std::erase_if(missed, [&](ConstraintId c) { return !is_missed(c); });
    keep_what_can_be(missed);
  }
  std::vector<std::string> companions;
  for (const ConstraintId c : missed) {
    const Constraint& constraint = model_.constraints[c];
    if (const std::vector<std::string> ids = companions_placed_by(constraint); !ids.empty()) {
      companions.insert(companions.end(), ids.begin(), ids.end());
      continue;
    }
    Clash clash;
    clash.proven = clash.minimal = false;
    clash.demands = {Demand::of(c)};
    clash.sentence = constraint.relation.exists()
                         ? fmt::format("no layout was found that holds all that was asked for and in which {}",
                                       relation_in_words(model_, model_.relation(constraint.relation)))
                         : fmt::format("no layout was found that holds all that was asked for and leaves the {} free", constraint.name);
    LAYOUTBOX_CHECK(give_up(clash));
  }
  return leave_out_companions(companions);
}

// Objects that nobody asked for, where all the rest finds its place without them.
std::vector<ItemId> Solver::extras_in_the_way() {
  std::vector<ItemId> extras;
  std::vector<std::string> ids;
  for (const ItemId i : model_.items.ids()) {
    const Item& item = model_.items[i];
    if (item.is_opening() || item.fixed || item.locked || item.object->asked()) continue;
    extras.push_back(i);
    ids.push_back(item.id);
  }
  if (extras.empty() || unplaced_without(ids) > 0) return {};
  return least_missed_first(model_, std::move(extras));
}

bool Solver::is_asked(ItemId item) const { return model_.items[item].is_opening() || model_.items[item].object->asked(); }

// Too much for the floor as long as that before doors and windows stays free, and nobody's words ask for that: it does not where all that
// was asked for finds a place on it. Where it is too little even so, an object has to go, and then the rest leaves the floor free.
bool Solver::floor_gives_way(const Clash& clash, const std::vector<ItemId>& objects) {
  const auto is_floor = [](const Demand& d) { return !d.is_item(); };
  if (asked_things_went() || !is_asked(objects.front()) || std::none_of(clash.demands.begin(), clash.demands.end(), is_floor)) return false;
  return search_without(Firmness::kImplied);
}

}  // namespace layoutbox::placement
