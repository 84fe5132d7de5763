#include "layoutbox/solve/model/slanted.h"

namespace layoutbox::placement {
namespace {

// Turned with a slanted wall they may be apart although the boxes around them are not.
bool apart_turned(const PlacementModel& model, const BodyPart& a, const BodyPart& b) {
  const auto odd = [](const BodyPart& part) { return !is_quarter(part.item->states[part.placement->state]); };
  return !model.headings.empty() && (odd(a) || odd(b)) && apart_along_headings(model, a, b);
}

bool bodies_overlap(const PlacementModel& model, const BodyPart& a, const BodyPart& b) {
  const State &sa = a.item->states[a.placement->state], &sb = b.item->states[b.placement->state];
  for (std::size_t i = 0; i < sa.solids.size(); ++i) {
    const GridBox here = sa.solids[i].shifted(a.placement->at);
    for (std::size_t j = 0; j < sb.solids.size(); ++j) {
      if (!overlap(here, sb.solids[j].shifted(b.placement->at))) continue;
      if (!apart_turned(model, {a.item, a.placement, static_cast<int>(i)}, {b.item, b.placement, static_cast<int>(j)})) return true;
    }
  }
  return false;
}

bool enters_clear(const PlacementModel& model, const Item& owner, const Placement& p, const Item& item, const Placement& body) {
  const std::vector<GridBox>& clear = owner.states[p.state].clear;
  return std::any_of(clear.begin(), clear.end(), [&](const GridBox& box) { return overlaps_box(model, item, body, box.shifted(p.at)); });
}

}  // namespace

bool overlaps_box(const PlacementModel& model, const Item& item, const Placement& body, const GridBox& box) {
  if (!overlap(box, box_of(item, body))) return false;
  const bool turned = !model.headings.empty() && !item.is_opening() && !is_quarter(item.states[body.state]);
  return !turned || !apart_along_headings(model, {&item, &body, -1}, box);
}

std::int64_t value_of(const PlacementModel& model, const Linear& form, const Placements& placements) {
  std::int64_t sum = form.constant;
  for (const Term& term : form.terms) sum += term.coefficient * value_of(model.items[term.item], placements[term.item], term.quantity);
  return sum;
}

bool all_placed(const Formula& formula, const Placements& placements) {
  return std::all_of(formula.items.begin(), formula.items.end(), [&](ItemId item) { return placements[item].state >= 0; });
}

bool all_placed(const Constraint& constraint, const Placements& placements) {
  return std::all_of(constraint.formulas.begin(), constraint.formulas.end(), [&](const Formula& f) { return all_placed(f, placements); });
}

std::int64_t miss_of(const PlacementModel& model, const Formula& formula, const Placements& placements) {
  std::int64_t least = std::numeric_limits<std::int64_t>::max() / 4;
  for (const Case& one : formula.cases) {
    std::int64_t miss = 0;
    for (const StateLiteral& literal : one.states) {
      if (!(literal.states >> placements[literal.item].state & 1)) miss = std::max(miss, kStateMiss);
    }
    for (const Linear& form : one.at_least_zero) {
      if (miss >= least) break;
      miss = std::max(miss, missing(value_of(model, form, placements), form.scale));
    }
    least = std::min(least, miss);
    if (least == 0) break;
  }
  return least;
}

std::int64_t miss_of(const PlacementModel& model, const Constraint& constraint, const Placements& placements) {
  std::int64_t worst = 0;
  for (const Formula& formula : constraint.formulas) worst = std::max(worst, miss_of(model, formula, placements));
  return worst;
}

Direction side_direction(const Item& item, Side side, int turn) {
  Direction d{1, -1};
  if (side == Side::kBack) d = {1, 1};
  if (side == Side::kLeft) d = {0, -1};
  if (side == Side::kRight) d = {0, 1};
  return item.has_front ? turned(d, ((turn + 45) / 90 * 90) % 360) : d;
}

bool collide(const PlacementModel& model, ItemId a, const Placement& pa, ItemId b, const Placement& pb, bool clear_boxes) {
  const PairRule rule = model.pair(a, b);
  if (rule == PairRule::kFree) return false;
  const Item &item_a = model.items[a], &item_b = model.items[b];
  const GridBox box_a = box_of(item_a, pa), box_b = box_of(item_b, pb);
  if (rule == PairRule::kOpenings) {
    GridBox grown = box_a;  // openings have no depth
    for (int k = 0; k < 2; ++k) grown.lo[k] -= 1, grown.hi[k] += 1;
    return overlap(grown, {{box_b.lo[0] - 1, box_b.lo[1] - 1, box_b.lo[2]}, {box_b.hi[0] + 1, box_b.hi[1] + 1, box_b.hi[2]}});
  }
  if (item_a.is_opening() || item_b.is_opening()) {
    if (!clear_boxes) return false;
    return item_a.is_opening() ? enters_clear(model, item_a, pa, item_b, pb) : enters_clear(model, item_b, pb, item_a, pa);
  }
  if (!overlap(box_a, box_b)) return false;
  const BodyPart whole_a{&item_a, &pa, -1}, whole_b{&item_b, &pb, -1};
  if (apart_turned(model, whole_a, whole_b)) return false;
  return rule == PairRule::kBoxes || bodies_overlap(model, whole_a, whole_b);
}

}  // namespace layoutbox::placement
