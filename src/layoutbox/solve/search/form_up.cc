// Things that stand in formation go to their places all at once: one by one they are in one another's way.
#include <array>
#include <bit>
#include <map>
#include <optional>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/solve/objective/cost.h"
#include "layoutbox/solve/search/search.h"

namespace layoutbox::placement {
namespace {

constexpr std::int64_t kStepsOfPlace = 10;

// By formation, the constraints that say the places of its members.
std::map<ItemId, std::vector<ConstraintId>> places_by_formation(const PlacementModel& model) {
  std::map<ItemId, std::vector<ConstraintId>> places;
  for (const ConstraintId c : model.constraints.ids()) {
    if (model.constraints[c].formation.exists()) places[model.constraints[c].formation].push_back(c);
  }
  return places;
}

// Where a wish that speaks of nothing but the item's own place along one axis is met.
void meet(const Preference& wish, const Item& item, ItemId index, Placement& placement) {
  std::int64_t slope = 0, rest = wish.form.constant;
  int axis = -1;
  for (const Term& term : wish.form.terms) {
    if (term.item != index) return;
    if (term.quantity == kPositionX || term.quantity == kPositionY) {
      axis = term.quantity;
      slope += term.coefficient;
    } else {
      rest += term.coefficient * value_of(item, placement, term.quantity);
    }
  }
  if (axis >= 0 && slope != 0) placement.at[axis] = static_cast<Mm>(-rest / slope);
}

}  // namespace

// All members in the places that their constraints say for that way to look, where nothing else is yet; false: they cannot all be there.
bool Search::form_from_nothing(const std::vector<ConstraintId>& places, std::size_t way) {
  for (const ConstraintId place : places) {
    const Constraint& c = model_.constraints[place];
    if (way >= c.formulas[0].cases.size() || stays(model_.items[c.member])) return false;
    const Case& here = c.formulas[0].cases[way];
    Placement placement;
    placement.state = 0;
    for (const StateLiteral& literal : here.states) {
      if (literal.item != c.member || literal.states == 0) return false;
      placement.state = std::countr_zero(literal.states);
    }
    for (const Preference& wish : here.wishes) meet(wish, model_.items[c.member], c.member, placement);
    placements_[c.member] = placement;
  }
  return std::ranges::all_of(places, [&](ConstraintId place) {
    const ItemId member = model_.constraints[place].member;
    return may_stay(member, placements_[member]);
  });
}

// The formations of so many members at least, in the way of that number; false: none of them stands.
bool Search::form_all(std::size_t fewest, std::size_t way) {
  std::fill(placements_.begin(), placements_.end(), Placement{});
  failed_.clear();
  bool any = false;
  for (const auto& [first, places] : places_by_formation(model_)) {
    const auto is_gone = [&](ConstraintId c) { return is_out(model_.constraints[c].member); };
    const std::size_t ways = model_.constraints[places[0]].formulas[0].cases.size();
    if (places.size() < fewest || ways == 0 || std::ranges::any_of(places, is_gone)) continue;
    const bool formed = form_from_nothing(places, way % ways);
    any |= formed;
    for (const ConstraintId c : places) {
      if (!formed) placements_[model_.constraints[c].member] = {};
    }
  }
  return any;
}

bool Search::construct_formed(std::size_t fewest, Budget& budget) {
  constexpr std::size_t kWays = 4;  // quarter turns
  std::optional<std::pair<std::int64_t, Placements>> best;
  for (std::size_t way = 0; way < kWays; ++way) {
    if (!form_all(fewest, way)) continue;
    for (const ItemId item : order(bonus_)) {
      if (placements_[item].state < 0 && (budget.stopped || !place(item, 0, budget))) failed_.push_back(item);
    }
    if (!failed_.empty() && !repair(budget)) continue;
    const std::int64_t cost = total_cost(model_, placements_);
    if (!best || cost < best->first) best = {cost, placements_};
  }
  if (best) placements_ = std::move(best->second);
  return best.has_value();
}

// What rests on it and who sits there, but for members; what it is looked at from or looks at stays.
std::vector<ItemId> Search::followers_of(ItemId item, const std::vector<ItemId>& members) const {
  std::vector<ItemId> group{item};
  for (std::size_t i = 0; i < group.size(); ++i) {
    for (const ItemId tenant : dependencies_.tenants[group[i]]) {
      const bool known = std::ranges::find(group, tenant) != group.end() || std::ranges::find(members, tenant) != members.end();
      if (known || placements_[tenant].state < 0 || model_.items[tenant].is_opening()) continue;
      const Item& other = model_.items[tenant];
      const bool rests = std::ranges::any_of(other.supports, [&](const SupportOption& support) {
        return support.kind == SupportOption::Kind::kItem && support.item == group[i];
      });
      const bool sits = other.mount == Mount::kFloor && (other.is(Trait::kSeat) || other.is(Trait::kEasySeat));
      if (rests || sits) group.push_back(tenant);
    }
  }
  group.erase(group.begin());
  return group;
}

// One member in the place that its constraint says for that way to look. What hangs on it comes along, or, where it is turned, is loose.
bool Search::step_into_place(ConstraintId constraint, const Way& way, const std::vector<ItemId>& members, std::vector<ItemId>& moved,
                             std::vector<ItemId>& loose) {
  const Constraint& c = model_.constraints[constraint];
  const ItemId index = c.member;
  const Item& item = model_.items[index];
  if (stays(item) || placements_[index].state < 0 || way.looking >= c.formulas[0].cases.size()) return false;
  const Case& here = c.formulas[0].cases[way.looking];
  const Placement before = placements_[index];
  Placement after = before;
  for (const StateLiteral& literal : here.states) {
    if (literal.item == index) {
      const bool may_stay_so = (literal.states >> before.state & 1) != 0;
      if (literal.states == 0) return false;
      if (!may_stay_so) after.state = std::countr_zero(literal.states);
    } else if (placements_[literal.item].state < 0 || (literal.states >> placements_[literal.item].state & 1) == 0) {
      return false;
    }
  }
  for (const Preference& wish : here.wishes) meet(wish, item, index, after);
  for (int axis = 0; axis < 2; ++axis) after.at[axis] += way.off[axis];
  for (const ItemId follower : followers_of(index, members)) {
    if (std::ranges::find(moved, follower) != moved.end() || std::ranges::find(loose, follower) != loose.end()) continue;
    if (stays(model_.items[follower])) return false;
    if (after.state != before.state) {
      loose.push_back(follower);
      continue;
    }
    for (int axis = 0; axis < 2; ++axis) placements_[follower].at[axis] += after.at[axis] - before.at[axis];
    moved.push_back(follower);
  }
  placements_[index] = after;
  moved.push_back(index);
  return true;
}

bool Search::form_up(const std::vector<ConstraintId>& places, const Way& way, Budget& budget) {
  const Placements before = placements_;
  std::vector<ItemId> members, moved, queue;
  for (const ConstraintId c : places) members.push_back(model_.constraints[c].member);
  bool all = std::ranges::all_of(places, [&](ConstraintId c) { return step_into_place(c, way, members, moved, queue); });
  for (const ItemId item : queue) placements_[item] = {};
  ById<ItemId, std::int64_t> price(model_.items.size(), kPoint);
  for (const ItemId i : price.ids()) {
    if (stays(model_.items[i]) || std::ranges::find(moved, i) != moved.end()) price[i] = -1;
  }
  std::vector<ItemId> hit;
  for (std::size_t i = 0; i < moved.size() && all && !budget.stopped; ++i) {
    // What was taken out may have taken one of them along.
    all = placements_[moved[i]].state >= 0 && finder_.collisions(placements_, moved[i], placements_[moved[i]], price, hit);
    for (const ItemId other : hit) {
      if (all && placements_[other].state >= 0) take_out(other, queue);
    }
    budget.count(kStepsOfPlace);
    budget.heed(static_cast<std::int64_t>(model_.items.size()));
  }
  all = all && std::ranges::all_of(moved, [&](ItemId item) { return placements_[item].state >= 0; }) && may_stay(moved, budget);
  for (std::size_t i = 0; i < queue.size() && all; ++i) all = placements_[queue[i]].state >= 0 || place(queue[i], 0, budget);
  moved.insert(moved.end(), queue.begin(), queue.end());
  if (all && is_better(before, moved, budget)) return true;
  placements_ = before;
  return false;
}

// At its places, whichever way all look; where that is no better, a little off them, the way they look now.
void Search::form_up(Budget& budget) {
  constexpr std::array<Mm, 4> kOff{150, -150, 300, -300};
  late_ = late_cost(model_, placements_);
  for (const auto& [first, places] : places_by_formation(model_)) {
    const std::vector<Case>& cases = model_.constraints[places[0]].formulas[0].cases;
    bool formed = false;
    for (std::size_t way = 0; way < cases.size() && !budget.spent(); ++way) formed = form_up(places, {way, {}}, budget) || formed;
    for (std::size_t way = 0; way < cases.size() && !formed; ++way) {
      const bool looks_so = std::ranges::all_of(cases[way].states, [&](const StateLiteral& literal) {
        return placements_[literal.item].state >= 0 && (literal.states >> placements_[literal.item].state & 1) != 0;
      });
      for (int axis = 0; axis < 2 && looks_so; ++axis) {
        for (const Mm off : kOff) {
          std::array<Mm, 2> by{};
          by[axis] = off;
          if (!budget.spent()) form_up(places, {way, by}, budget);
        }
      }
    }
  }
}

}  // namespace layoutbox::placement
