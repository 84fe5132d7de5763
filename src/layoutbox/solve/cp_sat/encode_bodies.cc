// That bodies do not share room, in CP-SAT's terms.
#include "layoutbox/solve/cp_sat/encode.h"
#include "layoutbox/solve/model/items.h"
#include "layoutbox/solve/model/slanted.h"

namespace layoutbox::placement {
namespace {

// The box of the item in each of its states, from its low corner. To prove something: what of it is surely body, turned as it is.
std::vector<GridBox> whole_boxes(const Item& item, Purpose purpose) {
  std::vector<GridBox> boxes;
  for (const State& state : item.states) {
    const bool within = purpose == Purpose::kProving && !is_quarter(state);
    boxes.push_back(within ? within_turned(own_box(state.size), own_box(state.size), state.angle) : GridBox{{0, 0, 0}, state.extent});
  }
  return boxes;
}

GridBox part_of(const State& state, std::vector<GridBox> State::*member, std::size_t k, Purpose purpose) {
  const bool within = purpose == Purpose::kProving && member == &State::solids && !is_quarter(state);
  return within ? within_turned(own_box(state.size), state.own_solids[k], state.angle) : (state.*member)[k];
}

std::vector<std::vector<GridBox>> parts_of(const Item& item, std::vector<GridBox> State::*member, Purpose purpose) {
  std::vector<std::vector<GridBox>> parts;
  std::size_t least = (item.states[0].*member).size(), count = 0;
  for (const State& state : item.states) {
    least = std::min(least, (state.*member).size());
    count = std::max(count, (state.*member).size());
  }
  if (least == 0 && count > 0) return {whole_boxes(item, purpose)};
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<GridBox> boxes;  // where a state is cut into fewer parts, its first stands in: said twice is still true
    for (const State& state : item.states) boxes.push_back(part_of(state, member, k < (state.*member).size() ? k : 0, purpose));
    parts.push_back(std::move(boxes));
  }
  return parts;
}

}  // namespace

void Encoding::add_offset(Expanded& out, ItemId item, std::int64_t factor, const std::vector<GridBox>& parts, int axis, bool high) const {
  const ItemVariables& v = items_[item];
  const auto edge = [&](const GridBox& box) { return std::int64_t{high ? box.hi[axis] : box.lo[axis]}; };
  out.terms.push_back({v.position[axis], factor});
  if (v.states.empty()) {
    out.constant += factor * edge(parts[0]);
    return;
  }
  for (std::size_t s = 0; s < v.states.size(); ++s) {
    if (edge(parts[s]) != 0) out.terms.push_back({v.states[s], factor * edge(parts[s])});
  }
}

void Encoding::add_disjoint(ItemId a, const std::vector<GridBox>& part_a, ItemId b, const std::vector<GridBox>& part_b,
                            const std::vector<CpLiteral>& when, bool headings) {
  std::vector<CpLiteral> sides;
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool a_first : {true, false}) {
      // Two things on the floor pass one another in the plan only.
      const bool both_on_floor = model_.items[a].supports.size() == 1 && model_.items[b].supports.size() == 1 &&
                                 model_.items[a].supports[0].kind == SupportOption::Kind::kFloor &&
                                 model_.items[b].supports[0].kind == SupportOption::Kind::kFloor;
      const auto at_floor = [](const GridBox& part) { return part.lo[2] == 0; };
      if (axis == 2 && both_on_floor && std::all_of(part_a.begin(), part_a.end(), at_floor) &&
          std::all_of(part_b.begin(), part_b.end(), at_floor))
        continue;
      Expanded form;  // low edge of the second − high edge of the first ≥ 0
      add_offset(form, a_first ? b : a, 1, a_first ? part_b : part_a, axis, false);
      add_offset(form, a_first ? a : b, -1, a_first ? part_a : part_b, axis, true);
      sides.push_back(cp_.add_boolean());
      require(form, std::array{sides.back()});
    }
  }
  if (headings) {  // or along a slanted wall
    for (std::size_t k = 0; k < model_.headings.size(); ++k) {
      const int heading = static_cast<int>(k);
      const Linear between = along2(model_, b, heading) - along2(model_, a, heading);
      const Linear spans = span(model_, a, heading) + span(model_, b, heading);
      for (const int sign : {1, -1}) {
        sides.push_back(cp_.add_boolean());
        require(expand(sign * between - spans), std::array{sides.back()});
      }
    }
  }
  cp_.add_or(sides, when);
}

void Encoding::add_pair(ItemId a, ItemId b) {
  const Item &x = model_.items[a], &y = model_.items[b];
  const PairRule rule = model_.pair(a, b);
  if (rule == PairRule::kFree || (x.fixed && y.fixed)) return;
  std::vector<CpLiteral> when{items_[a].present, items_[b].present};
  if (rule == PairRule::kOpenings) {
    std::vector<GridBox> grown = whole_boxes(x, purpose_);  // openings have no depth
    for (GridBox& box : grown) {
      for (int k = 0; k < 2; ++k) box.lo[k] -= 2, box.hi[k] += 2;
    }
    add_disjoint(a, grown, b, whole_boxes(y, purpose_), when);
    return;
  }
  if (x.is_opening() || y.is_opening()) {
    const ItemId opening = x.is_opening() ? a : b, body = x.is_opening() ? b : a;
    if (purpose_ == Purpose::kProving && model_.items[opening].odd_states) return;  // its box is more than what is to be free
    const ConstraintId clearance = model_.items[opening].clearance_constraint;
    const auto demand = std::find(demands_.begin(), demands_.end(), Demand::of(clearance));
    if (demand == demands_.end()) return;
    when.push_back(demand_literals_[static_cast<std::size_t>(demand - demands_.begin())]);
    for (const std::vector<GridBox>& clear : parts_of(model_.items[opening], &State::clear, purpose_)) {
      add_disjoint(opening, clear, body, whole_boxes(model_.items[body], purpose_), when);
    }
    return;
  }
  const bool odd = x.odd_states != 0 || y.odd_states != 0;
  const bool hollow = x.states[0].solids.size() > 1 || y.states[0].solids.size() > 1;
  if (rule == PairRule::kBoxes && (purpose_ == Purpose::kPlacing || !hollow)) {
    add_disjoint(a, whole_boxes(x, purpose_), b, whole_boxes(y, purpose_), when, odd);
    return;
  }
  for (const std::vector<GridBox>& part_a : parts_of(x, &State::solids, purpose_)) {
    for (const std::vector<GridBox>& part_b : parts_of(y, &State::solids, purpose_)) add_disjoint(a, part_a, b, part_b, when, odd);
  }
}

void Encoding::add_outside(ItemId index) {
  if (model_.items[index].is_opening() || model_.items[index].fixed) return;
  if (purpose_ == Purpose::kProving && model_.items[index].odd_states) return;  // its box is more than its body
  for (const GridBox& outside : model_.off_limits) {
    std::vector<CpLiteral> sides;
    for (int axis = 0; axis < 2; ++axis) {
      sides.push_back(cp_.add_boolean());
      require(expand(lo(index, axis) - Linear(outside.hi[axis])), std::array{sides.back()});
      sides.push_back(cp_.add_boolean());
      require(expand(Linear(outside.lo[axis]) - hi(index, axis)), std::array{sides.back()});
    }
    cp_.add_or(sides, std::array{items_[index].present});
  }
}

}  // namespace layoutbox::placement
