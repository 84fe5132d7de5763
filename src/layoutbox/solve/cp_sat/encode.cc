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

Encoding::Encoding(const PlacementModel& model, const Scope& scope, Purpose purpose)
    : model_(model), purpose_(purpose), items_(model.items.size()) {
  always_ = cp_.add_variable(1, 1);
  const int count = static_cast<int>(model.items.size());
  for (int i = 0; i < count; ++i) {
    if (!scope.leaves_out(i)) add_item(i);
  }
  for (std::size_t c = 0; c < model.constraints.size(); ++c) {
    const Constraint& constraint = model.constraints[c];
    const bool soft = constraint.firmness == Firmness::kSoft;
    if (soft || scope.gives_up(static_cast<int>(c))) continue;
    if (constraint.firmness == Firmness::kAlways) continue;  // added with its item
    const CpLiteral literal = cp_.add_boolean();
    demands_.push_back({Demand::Kind::kConstraint, static_cast<int>(c)});
    demand_literals_.push_back(literal);
    add_constraint(static_cast<int>(c), literal);
  }
  for (int i = 0; i < count; ++i) {
    if (!items_[i].used) continue;
    add_constraint(model.items[i].support_constraint, items_[i].present);
    if (model.items[i].within_constraint >= 0) add_constraint(model.items[i].within_constraint, items_[i].present);
    add_outside(i);
    for (int j = i + 1; j < count; ++j) {
      if (items_[j].used) add_pair(i, j);
    }
  }
}

void Encoding::add_item(int index) {
  const Item& item = model_.items[index];
  ItemVariables& v = items_[index];
  v.used = true;
  v.present = cp_.add_boolean();
  demands_.push_back({Demand::Kind::kItem, index});
  demand_literals_.push_back(v.present);
  for (int k = 0; k < 3; ++k) {
    const Mm low = item.fixed ? item.fixed_at[k] : model_.room.lo[k];
    const Mm high = item.fixed ? item.fixed_at[k] : model_.room.hi[k];
    v.position[k] = cp_.add_variable(low, high);
  }
  if (item.states.size() > 1) {
    for (std::size_t s = 0; s < item.states.size(); ++s) v.states.push_back(cp_.add_boolean());
    cp_.add_exactly_one(v.states);
  }
  if (item.fixed) return;
  for (int k = 0; k < 3; ++k) {  // inside the room; an item that is not demanded may stick out
    const Linear form = Linear(model_.room.hi[k]) - hi(index, k);
    require(expand(form), std::array{v.present});
  }
}

Encoding::Expanded Encoding::expand(const Linear& form) const {
  Expanded out;
  out.constant = form.constant;
  for (const Term& term : form.terms) {
    const ItemVariables& v = items_[term.item];
    if (term.quantity < kExtentX) {
      out.terms.push_back({v.position[term.quantity], term.coefficient});
      continue;
    }
    const Item& item = model_.items[term.item];
    if (v.states.empty()) {
      out.constant += std::int64_t{term.coefficient} * value_of(item, Placement{0, {}}, term.quantity);
      continue;
    }
    for (std::size_t s = 0; s < v.states.size(); ++s) {
      const std::int64_t value = value_of(item, Placement{static_cast<int>(s), {}}, term.quantity);
      if (value != 0) out.terms.push_back({v.states[s], term.coefficient * value});
    }
  }
  return out;
}

void Encoding::require(const Expanded& form, std::span<const CpLiteral> when) {
  std::vector<CpTerm> merged;
  for (const CpTerm& term : form.terms) {
    const auto same = std::find_if(merged.begin(), merged.end(), [&](const CpTerm& t) { return t.variable == term.variable; });
    if (same == merged.end()) {
      merged.push_back(term);
    } else {
      same->coefficient += term.coefficient;
    }
  }
  std::erase_if(merged, [](const CpTerm& t) { return t.coefficient == 0; });
  cp_.add_linear(merged, -form.constant, kNoBound, when);
}

void Encoding::add_case(const Case& one, std::span<const CpLiteral> when) {
  for (const StateLiteral& literal : one.states) {
    const ItemVariables& v = items_[literal.item];
    std::vector<CpLiteral> allowed;
    if (v.states.empty()) {
      if (literal.states & 1) continue;
    } else {
      for (std::size_t s = 0; s < v.states.size(); ++s) {
        if (literal.states >> s & 1) allowed.push_back(v.states[s]);
      }
    }
    cp_.add_or(allowed, when);
  }
  for (const Linear& form : one.at_least_zero) require(expand(form), when);
}

void Encoding::require_present(const Case& one, CpLiteral when) {
  const auto present = [&](int item) {
    if (items_[item].present != when) cp_.add_or(std::array{items_[item].present}, std::array{when});
  };
  for (const StateLiteral& literal : one.states) present(literal.item);
  for (const Linear& form : one.at_least_zero) {
    for (const Term& term : form.terms) present(term.item);
  }
}

void Encoding::add_constraint(int index, CpLiteral when) {
  for (const Formula& formula : model_.constraints[index].formulas) {
    // What is left out can neither break nor keep a relation.
    const auto is_there = [&](const Case& one) {
      const auto used = [&](int item) { return items_[item].used; };
      return std::all_of(one.states.begin(), one.states.end(), [&](const StateLiteral& l) { return used(l.item); }) &&
             std::all_of(one.at_least_zero.begin(), one.at_least_zero.end(), [&](const Linear& form) {
               return std::all_of(form.terms.begin(), form.terms.end(), [&](const Term& t) { return used(t.item); });
             });
    };
    const bool outer = purpose_ == Purpose::kProving && !formula.exact;
    const std::vector<Case>& all = outer ? formula.outer : formula.cases;
    if (outer && all.empty()) continue;  // nothing is known to be necessary
    std::vector<const Case*> cases;
    for (const Case& one : all) {
      if (is_there(one)) cases.push_back(&one);
    }
    if (cases.size() < all.size() && (cases.empty() || outer)) continue;
    if (cases.size() == 1) {
      add_case(*cases[0], std::array{when});
      if (model_.constraints[index].firmness == Firmness::kAlways) require_present(*cases[0], when);
      continue;
    }
    std::vector<CpLiteral> chosen;
    for (const Case* one : cases) {
      chosen.push_back(cp_.add_boolean());
      add_case(*one, std::array{chosen.back()});
      if (model_.constraints[index].firmness == Firmness::kAlways) require_present(*one, chosen.back());  // only what is there holds
    }
    cp_.add_or(chosen, std::array{when});
  }
}

void Encoding::add_offset(Expanded& out, int item, std::int64_t factor, const std::vector<GridBox>& parts, int axis, bool high) const {
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

void Encoding::add_disjoint(int a, const std::vector<GridBox>& part_a, int b, const std::vector<GridBox>& part_b,
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

void Encoding::add_pair(int a, int b) {
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
    const int opening = x.is_opening() ? a : b, body = x.is_opening() ? b : a;
    if (purpose_ == Purpose::kProving && model_.items[opening].odd_states) return;  // its box is more than what is to be free
    const int clearance = model_.items[opening].clearance_constraint;
    const auto demand = std::find(demands_.begin(), demands_.end(), Demand{Demand::Kind::kConstraint, clearance});
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

void Encoding::add_outside(int index) {
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

std::string Encoding::bytes(const std::vector<char>& demanded) {
  cp_.clear_assumptions();
  for (std::size_t d = 0; d < demands_.size(); ++d) {
    if (demanded[d]) cp_.assume(demand_literals_[d]);
  }
  return cp_.bytes();
}

std::vector<std::size_t> Encoding::demands_in(const std::vector<CpLiteral>& core) const {
  std::vector<std::size_t> found;
  for (std::size_t d = 0; d < demands_.size(); ++d) {
    if (std::find(core.begin(), core.end(), demand_literals_[d]) != core.end()) found.push_back(d);
  }
  return found;
}

void Encoding::hint(const Placements& placements) {
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const ItemVariables& v = items_[i];
    if (!v.used || placements[i].state < 0) continue;
    for (int k = 0; k < 3; ++k) cp_.hint(v.position[k], placements[i].at[k]);
    for (std::size_t s = 0; s < v.states.size(); ++s) cp_.hint(v.states[s], static_cast<int>(s) == placements[i].state);
  }
}

Placements Encoding::placements_of(const std::vector<std::int64_t>& values) const {
  Placements placements(items_.size());
  for (std::size_t i = 0; i < items_.size(); ++i) {
    const ItemVariables& v = items_[i];
    if (!v.used) continue;
    placements[i].state = 0;
    for (std::size_t s = 0; s < v.states.size(); ++s) {
      if (values[v.states[s]] != 0) placements[i].state = static_cast<int>(s);
    }
    for (int k = 0; k < 3; ++k) placements[i].at[k] = static_cast<Mm>(values[v.position[k]]);
  }
  return placements;
}

}  // namespace layoutbox::placement
