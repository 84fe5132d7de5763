#include "layoutbox/solve/cp_sat/encode.h"

namespace layoutbox::placement {

Encoding::Encoding(const PlacementModel& model, const Scope& scope, Purpose purpose)
    : model_(model), purpose_(purpose), items_(model.items.size()) {
  always_ = cp_.add_variable(1, 1);
  for (const ItemId i : items_.ids()) {
    if (!scope.leaves_out(i)) add_item(i);
  }
  for (const ConstraintId c : model.constraints.ids()) {
    const Constraint& constraint = model.constraints[c];
    const bool soft = constraint.firmness == Firmness::kSoft;
    if (soft || scope.gives_up(c)) continue;
    if (constraint.firmness == Firmness::kAlways) continue;  // added with its item
    const CpLiteral literal = cp_.add_boolean();
    demands_.push_back(Demand::of(c));
    demand_literals_.push_back(literal);
    add_constraint(c, literal);
  }
  for (const ItemId i : items_.ids()) {
    if (!items_[i].used) continue;
    add_constraint(model.items[i].support_constraint, items_[i].present);
    if (model.items[i].within_constraint.exists()) add_constraint(model.items[i].within_constraint, items_[i].present);
    add_outside(i);
    for (const ItemId j : items_.ids_after(i)) {
      if (items_[j].used) add_pair(i, j);
    }
  }
}

void Encoding::add_item(ItemId index) {
  const Item& item = model_.items[index];
  ItemVariables& v = items_[index];
  v.used = true;
  v.present = cp_.add_boolean();
  demands_.push_back(Demand::of_item(index));
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
  const auto present = [&](ItemId item) {
    if (items_[item].present != when) cp_.add_or(std::array{items_[item].present}, std::array{when});
  };
  for (const StateLiteral& literal : one.states) present(literal.item);
  for (const Linear& form : one.at_least_zero) {
    for (const Term& term : form.terms) present(term.item);
  }
}

void Encoding::add_constraint(ConstraintId constraint, CpLiteral when) {
  for (const Formula& formula : model_.constraints[constraint].formulas) {
    // What is left out can neither break nor keep a relation.
    const auto is_there = [&](const Case& one) {
      const auto used = [&](ItemId item) { return items_[item].used; };
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
      if (model_.constraints[constraint].firmness == Firmness::kAlways) require_present(*cases[0], when);
      continue;
    }
    std::vector<CpLiteral> chosen;
    for (const Case* one : cases) {
      chosen.push_back(cp_.add_boolean());
      add_case(*one, std::array{chosen.back()});
      if (model_.constraints[constraint].firmness == Firmness::kAlways) require_present(*one, chosen.back());  // only what is there holds
    }
    cp_.add_or(chosen, std::array{when});
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
  for (const ItemId i : items_.ids()) {
    const ItemVariables& v = items_[i];
    if (!v.used || placements[i].state < 0) continue;
    for (int k = 0; k < 3; ++k) cp_.hint(v.position[k], placements[i].at[k]);
    for (std::size_t s = 0; s < v.states.size(); ++s) cp_.hint(v.states[s], static_cast<int>(s) == placements[i].state);
  }
}

Placements Encoding::placements_of(const std::vector<std::int64_t>& values) const {
  Placements placements(items_.size());
  for (const ItemId i : items_.ids()) {
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
