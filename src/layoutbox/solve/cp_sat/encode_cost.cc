// What makes rooms good, as far as it is linear or a product, for the question whether a better layout exists. Every layout of the search
// costs at least what it costs here, so that what is not found here is not there.
#include <numeric>

#include "layoutbox/solve/cp_sat/encode.h"
#include "layoutbox/solve/objective/access.h"
#include "layoutbox/solve/objective/cost.h"
#include "layoutbox/solve/objective/terms.h"

namespace layoutbox::placement {
namespace {

bool costs_nothing(const Constraint& constraint, const Case& one) {
  const bool soft = constraint.firmness == Firmness::kSoft;
  return one.wishes.empty() && one.price == 0 && !(soft && (!one.at_least_zero.empty() || !one.states.empty()));
}

bool speaks_only_of_used(const Formula& formula, const ById<ItemId, char>& used) {
  return std::all_of(formula.items.begin(), formula.items.end(), [&](ItemId item) { return used[item] != 0; });
}

}  // namespace

void Encoding::bound_cost(std::int64_t most, bool with_access) {
  std::vector<CpTerm> total;
  for (const CostTerm& term : cost_terms()) {
    switch (term.kind) {
      case TermKind::kSizes: add_size_costs(total); break;
      case TermKind::kWishes: add_wish_costs(most, total); break;
      case TermKind::kAccess:
        for (const ItemId i : items_.ids()) {
          if (with_access && items_[i].used) add_access_cost(i, most, total);
        }
        break;
      case TermKind::kWays: break;  // how floor hangs together is nothing linear: they cost what they may
    }
  }
  cp_.add_linear(total, -kNoBound, most);
}

void Encoding::add_size_costs(std::vector<CpTerm>& total) {
  for (const ItemId i : items_.ids()) {
    if (!items_[i].used) continue;
    for (std::size_t s = 0; s < items_[i].states.size(); ++s) {
      const std::int64_t cost = size_cost(model_.items[i].states[s]);
      if (cost > 0) total.push_back({items_[i].states[s], cost});
    }
  }
}

void Encoding::add_wish_costs(std::int64_t most, std::vector<CpTerm>& total) {
  ById<ItemId, char> used;
  for (const ItemVariables& v : items_) used.push_back(v.used);
  for (const Constraint& constraint : model_.constraints) {
    const auto free = [&](const Case& c) { return costs_nothing(constraint, c); };
    const bool placed =
        std::all_of(constraint.formulas.begin(), constraint.formulas.end(), [&](const Formula& f) { return speaks_only_of_used(f, used); });
    for (const Formula& formula : constraint.formulas) {
      if (!placed || formula.cases.empty()) continue;
      if (constraint.firmness == Firmness::kSoft && std::any_of(formula.cases.begin(), formula.cases.end(), free)) continue;
      if (std::all_of(formula.cases.begin(), formula.cases.end(), free)) continue;
      total.push_back({cp_.add_variable(0, most), 1});
      std::vector<CpLiteral> chosen;
      for (const Case& one : formula.cases) {
        chosen.push_back(cp_.add_boolean());
        add_case_cost(constraint, one, total.back().variable, most, chosen.back());
      }
      cp_.add_or(chosen);
    }
  }
}

void Encoding::add_case_cost(const Constraint& constraint, const Case& one, std::int32_t cost, std::int64_t most, CpLiteral when) {
  const std::array<CpLiteral, 1> if_chosen{when};
  std::vector<CpTerm> sum;
  std::int64_t unit = 1;  // the cost counts so often in the sum
  for (const Preference& wish : one.wishes) unit = std::lcm(unit, std::int64_t{wish.scale});
  sum.push_back({cost, unit});
  std::int64_t least = unit * one.price * kPoint;
  if (constraint.firmness != Firmness::kSoft) {
    add_case(one, if_chosen);
  } else if (!one.states.empty() || !one.at_least_zero.empty()) {
    const std::int32_t miss = cp_.add_variable(0, most / constraint.weight + 1);
    sum.push_back({miss, -unit * constraint.weight});
    for (const Linear& form : one.at_least_zero) {
      Expanded short_of = expand(form);
      short_of.terms.push_back({miss, form.scale});
      require(short_of, if_chosen);
    }
    for (const StateLiteral& literal : one.states) {
      const CpLiteral other = cp_.add_boolean();  // it stands otherwise
      Case here;
      here.states.push_back(literal);
      add_case(here, std::array{when, cp_not(other)});
      cp_.add_linear(std::array{CpTerm{miss, 1}}, kStateMiss, kNoBound, std::array{other});
    }
  }
  for (const Preference& wish : one.wishes) {
    const std::int32_t off = cp_.add_variable(0, (most + 1) * wish.scale / wish.weight + wish.scale);
    for (const int sign : {1, -1}) {
      Expanded within = expand(sign * wish.form);
      within.terms.push_back({off, 1});
      require(within, if_chosen);
    }
    sum.push_back({off, -wish.weight * (unit / wish.scale)});
    if (wish.scale > 1) least -= unit;  // what is rounded off
  }
  cp_.add_linear(sum, least, kNoBound, if_chosen);
}

// How far the strip of an item and a body share an axis, at least.
std::int32_t Encoding::shared_length(ItemId item, const std::vector<GridBox>& strip, ItemId body, int axis) {
  const std::int32_t length = cp_.add_variable(0, model_.room.extent(axis));
  const std::vector<GridBox> whole = [&] {
    std::vector<GridBox> boxes;
    for (const State& state : model_.items[body].states) boxes.push_back({{0, 0, 0}, state.extent});
    return boxes;
  }();
  std::vector<CpLiteral> ends;
  const auto at_least = [&](ItemId high_of, const std::vector<GridBox>& high, ItemId low_of, const std::vector<GridBox>& low) {
    Expanded form;  // length − (high − low) ≥ 0
    form.terms.push_back({length, 1});
    add_offset(form, high_of, -1, high, axis, true);
    add_offset(form, low_of, 1, low, axis, false);
    ends.push_back(cp_.add_boolean());
    require(form, std::array{ends.back()});
  };
  at_least(item, strip, item, strip);
  at_least(item, strip, body, whole);
  at_least(body, whole, item, strip);
  at_least(body, whole, body, whole);
  cp_.add_or(ends);
  return length;
}

// The blocked share of a strip in thousandths, at least.
std::int32_t Encoding::blocked_share(ItemId item, const std::vector<GridBox>& strip) {
  const ItemVariables& v = items_[item];
  std::vector<CpTerm> blocked;  // areas, in thousandths
  std::int32_t inside[2];
  for (int axis = 0; axis < 2; ++axis) {  // how much of it lies in the room, at most
    inside[axis] = cp_.add_variable(0, model_.room.extent(axis));
    const auto at_most = [&](bool high, bool low) {
      Expanded form;  // high − low − inside ≥ 0
      form.terms.push_back({inside[axis], -1});
      if (high) add_offset(form, item, 1, strip, axis, true);
      if (!high) form.constant += model_.room.hi[axis];
      if (low) add_offset(form, item, -1, strip, axis, false);
      if (!low) form.constant -= model_.room.lo[axis];
      require(form, {});
    };
    at_most(true, true), at_most(true, false), at_most(false, true);
  }
  const std::int64_t room = std::int64_t{model_.room.extent(0)} * model_.room.extent(1);
  const auto product = [&](std::int32_t a, std::int32_t b) {
    const std::int32_t area = cp_.add_variable(0, room);
    cp_.add_product(area, a, b);
    return area;
  };
  blocked.push_back({product(inside[0], inside[1]), -1000});
  for (const ItemId other : items_.ids()) {
    if (!items_[other].used || other == item || !surely_blocks(model_, other, item)) continue;
    blocked.push_back({product(shared_length(item, strip, other, 0), shared_length(item, strip, other, 1)), 1000});
  }
  const std::int32_t share = cp_.add_variable(0, 1000);
  const CpLiteral all = cp_.add_boolean();
  cp_.add_linear(std::array{CpTerm{share, 1}}, 1000, 1000, std::array{all});
  for (std::size_t s = 0; s < strip.size(); ++s) {  // share · area ≥ 1000 · (area + blocked) − area
    const std::int64_t area = floor_area(strip[s]);
    std::vector<CpTerm> sum{{share, area}};
    for (const CpTerm& term : blocked) sum.push_back({term.variable, -term.coefficient});
    std::vector<CpLiteral> when{cp_not(all)};
    if (!v.states.empty()) when.push_back(v.states[s]);
    cp_.add_linear(sum, 1000 * area - (area - 1), kNoBound, when);
  }
  return share;
}

void Encoding::add_access_cost(ItemId index, std::int64_t most, std::vector<CpTerm>& total) {
  const Item& item = model_.items[index];
  const bool on_floor = item.supports.size() == 1 && item.supports[0].kind == SupportOption::Kind::kFloor;
  if (item.is_opening() || item.thin || !on_floor) return;  // it costs what it may
  const auto nth = [&](std::vector<GridBox> State::*member, std::size_t k) {
    std::vector<GridBox> boxes;
    for (const State& state : item.states) boxes.push_back((state.*member)[k]);
    return boxes;
  };
  const State& first = item.states[0];
  if (!first.strips.empty()) {  // the best of them
    const std::int32_t cost = cp_.add_variable(0, most);
    total.push_back({cost, 1});
    std::vector<CpLiteral> chosen;
    for (std::size_t k = 0; k < first.strips.size(); ++k) {
      chosen.push_back(cp_.add_boolean());
      const std::array<CpTerm, 2> sum{CpTerm{cost, 1}, CpTerm{blocked_share(index, nth(&State::strips, k)), -kCostWeights.access}};
      cp_.add_linear(sum, 0, kNoBound, std::array{chosen.back()});
    }
    cp_.add_or(chosen);
  }
  for (std::size_t k = 0; k < first.wanted.size(); ++k)
    total.push_back({blocked_share(index, nth(&State::wanted, k)), kCostWeights.wanted});
}

}  // namespace layoutbox::placement
