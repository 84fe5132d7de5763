#include "layoutbox/solve/compile/phrases.h"

#include <cmath>

#include "layoutbox/solve/model/slanted.h"

namespace layoutbox::placement {
namespace {

// Wishes that things beside one another look as if meant: flush backs beside, centred before and behind.
void wish_alignment(Case& c, const Item& ref, int t, int r, Side side, int turn, Direction d) {
  if (side == Side::kLeft || side == Side::kRight) {
    const Direction back = side_direction(ref, Side::kBack, turn);
    c.wish(reach(t, back) - reach(r, back), 60);
  } else {
    c.wish(mid2(t, across(d)) - mid2(r, across(d)), 120, 2);
  }
}

// Beside what is turned with a slanted wall: t is turned with it too (by quarters more or less), so that their distance is the gap
// between two parallel sides.
void add_beside_slanted(Formula& f, const Model& model, int t, int r, Side side, const Beside& how, bool level) {
  const Item &self = model.items[t], &ref = model.items[r];
  if (self.spans < 0 || ref.spans < 0 || !ref.has_front || how.may_reach_under) return;
  const double by = side == Side::kFront ? 270 : side == Side::kBack ? 90 : side == Side::kLeft ? 180 : 0;
  std::vector<double> seen;
  for (const State& state : ref.states) {
    if (is_quarter(state) || std::find(seen.begin(), seen.end(), state.angle) != seen.end()) continue;
    seen.push_back(state.angle);
    const std::uint64_t ref_states = states_at_angle(ref, state.angle, 360) & how.ref_states,
                        states = states_at_angle(self, state.angle, 90);
    const auto d = signed_heading(model, state.angle + by), u = signed_heading(model, state.angle + by + 90);
    if (!ref_states || !states || !d || !u) continue;
    const std::int64_t millimetre = 2 * kHeading;
    const Linear gap =
        d->sign * (along2(model, t, d->heading) - along2(model, r, d->heading)) - span(model, t, d->heading) - span(model, r, d->heading);
    const Linear off = u->sign * (along2(model, t, u->heading) - along2(model, r, u->heading));
    for (const int shorter : {t, r}) {  // its middle faces the longer
      const Linear length = span(model, shorter == t ? r : t, u->heading);
      Case& c = f.add().when(r, ref_states).when(t, states);
      c.require(gap, millimetre).require(Linear(millimetre * how.most) - gap, millimetre);
      c.require(length - off, millimetre).require(length + off, millimetre);
      c.turned = true;
      c.price = shorter == t ? 0 : 150;
      if (!level) c.require(hi(r, 2) - lo(t, 2)).require(hi(t, 2) - lo(r, 2));
      c.wish(gap - Linear(millimetre * std::min(how.wished_gap, how.most)), 100, millimetre);
      if (side == Side::kLeft || side == Side::kRight) {  // backs flush
        const int back = side == Side::kRight ? 1 : -1;
        c.wish(back * off + span(model, t, u->heading) - span(model, r, u->heading), 60, millimetre);
      } else {
        c.wish(off, 120, millimetre);
      }
    }
  }
  f.exact = false;
}

}  // namespace

int frame_host(const Model& model, int r) {
  const Item& ref = model.items[r];
  if (ref.is_opening() || ref.has_front) return -1;
  int host = -1;
  for (const Relation& relation : model.scene->relations) {
    if ((relation.type != RelationType::kOn && relation.type != RelationType::kIn) || relation.targets.size() != 1 ||
        relation.targets.front() != ref.id || relation.references.size() != 1)
      continue;
    const int named = model.find_item(relation.references.front());
    if (named < 0 || model.items[named].is_opening() || model.items[named].thin || (host >= 0 && host != named)) return -1;
    host = named;
  }
  return host >= 0 && model.items[host].has_front ? host : -1;
}

// NOLINTNEXTLINE(readability-function-cognitive-complexity): to be parted
void add_beside(Formula& f, const Model& model, int t, int r, Side side, const Beside& how) {
  const Item& ref = model.items[how.frame >= 0 ? how.frame : r];
  const int framed = how.frame >= 0 ? how.frame : r;
  const Place place = place_of(r);
  const Heights heights = heights_between(model, t, place, how.most, Purpose::kPlacing);
  const bool level = how.in_plan_only || (heights.known && heights.gap == 0);
  const std::uint64_t odd = model.items[t].odd_states;
  // NOLINTNEXTLINE(readability-function-cognitive-complexity): to be parted
  for_each_turn(ref, [&](int turn, std::uint64_t all) {
    const std::uint64_t states = all & how.ref_states;
    if (!states || (!quarter(turn) && ref.spans >= 0)) return;
    const Direction d = side_direction(ref, side, turn);
    const Linear gap = gap_towards(t, r, d);
    Case base;
    base.when(framed, states);
    if (how.may_reach_under) {
      base.require(reach(t, d) - reach(r, d));
      base.require(-2 * reach(t, opposite(d)) - d.sign * mid2(r, d.axis));  // its near edge not past the middle of r
    } else {
      base.require(gap);
    }
    // In line, so the distance is that along d and the one in height.
    // NOLINTNEXTLINE(readability-function-cognitive-complexity): to be parted
    const auto add = [&](std::vector<Case>& to, bool proving, bool straight) {
      const std::vector<Case> lines = in_line(base, model, t, place, across(d));
      for (std::size_t k = 0; k < lines.size(); ++k) {
        Case c = lines[k];
        const auto share = [&](std::int64_t percent) { return Linear(how.most * percent / 100); };
        c.require(share(proving || straight || level ? 100 : 92) - gap);
        for (const int up : {1, -1}) {
          if (level) continue;
          const Linear rise = gap_towards(t, r, {2, up});
          c.require((proving ? Linear(how.most) : straight ? Linear(0) : share(92)) - rise);
          if (proving || !straight) c.require(Linear(how.most * (proving ? 14143 : 13000) / 10000 + (proving ? 1 : 0)) - rise - gap);
        }
        if (!proving) {
          if (k > 0) c.price = 150;
          if (!straight) c.price += 40;
          c.wish(gap - Linear(std::min(how.wished_gap, how.most)), 100);
          wish_alignment(c, ref, t, r, side, turn, d);
          // Turned, it may reach less far than the box around it.
          if (odd && straight && !how.in_plan_only) add_within(to, c, model, t, place, how.most, Purpose::kPlacing, odd);
          if (odd && !how.in_plan_only) c.when(t, quarter_states(model.items[t]));
        }
        to.push_back(std::move(c));
      }
    };
    add(f.cases, false, true);
    if (level) return;
    f.exact = false;
    add(f.cases, false, false);
    add(f.outer, true, false);
  });
  if (ref.odd_states == 0 || ref.spans < 0) return;
  if (f.exact) f.outer = f.cases;
  add_beside_slanted(f, model, t, r, side, how, level);
}

}  // namespace layoutbox::placement
