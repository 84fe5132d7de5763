#include "layoutbox/solve/compile/phrases.h"

#include <cmath>

#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/solve/model/slanted.h"

namespace layoutbox::placement {
namespace {

// Wishes that things beside one another look as if meant: flush backs beside, centred before and behind.
void wish_alignment(Case& c, const Item& ref, ItemId t, ItemId r, Side side, int turn, Direction d) {
  if (side == Side::kLeft || side == Side::kRight) {
    const Direction back = side_direction(ref, Side::kBack, turn);
    c.wish(reach(t, back) - reach(r, back), 60);
  } else {
    c.wish(mid2(t, across(d)) - mid2(r, across(d)), 120, 2);
  }
}

// Beside what is turned with a slanted wall: t is turned with it too (by quarters more or less), so that their distance is the gap
// between two parallel sides.
void add_beside_slanted(Formula& f, const PlacementModel& model, ItemId t, ItemId r, Side side, const Beside& how, bool level) {
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
    for (const ItemId shorter : {t, r}) {  // its middle faces the longer
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

ItemId frame_host(const PlacementModel& model, ItemId r) {
  const Item& ref = model.items[r];
  if (ref.is_opening() || ref.has_front) return {};
  ItemId host;
  for (const Relation& relation : model.scene->relations) {
    if (!traits_of(relation.type).rests || relation.targets.size() != 1 || relation.targets.front() != ref.id ||
        relation.references.size() != 1)
      continue;
    const ItemId named = model.find_item(relation.references.front());
    if (!named.exists() || model.items[named].is_opening() || model.items[named].thin || (host.exists() && host != named)) return {};
    host = named;
  }
  return host.exists() && model.items[host].has_front ? host : ItemId();
}

namespace {

// "All of t beyond that side of r, in line with it", on its way into a formula.
class BesideCases {
 public:
  BesideCases(Formula& f, const PlacementModel& model, ItemId t, ItemId r, Side side, const Beside& how)
      : f_(f),
        model_(model),
        t_(t),
        r_(r),
        side_(side),
        how_(how),
        framed_(how.frame.exists() ? how.frame : r),
        ref_(model.items[framed_]),
        place_(place_of(r)),
        odd_(model.items[t].odd_states) {
    const Heights heights = heights_between(model, t, place_, how.most, Purpose::kPlacing);
    level_ = how.in_plan_only || (heights.known && heights.gap == 0);
  }

  bool level() const { return level_; }

  // For one turn of what the side is meant of.
  void add(int turn, std::uint64_t all) {
    const std::uint64_t states = all & how_.ref_states;
    if (!states || (!quarter(turn) && (ref_.spans >= 0 || framed_ != r_))) return;
    turn_ = turn, d_ = side_direction(ref_, side_, turn);
    Case base;
    base.when(framed_, states);
    if (how_.may_reach_under) {
      base.require(reach(t_, d_) - reach(r_, d_));
      base.require(-2 * reach(t_, opposite(d_)) - d_.sign * mid2(r_, d_.axis));  // its near edge not past the middle of r
    } else {
      base.require(gap());
    }
    const std::vector<Case> lines = in_line(base, model_, t_, place_, across(d_));
    for (std::size_t k = 0; k < lines.size(); ++k) place(lines[k], k == 0, true);
    if (level_) return;
    f_.exact = false;
    for (std::size_t k = 0; k < lines.size(); ++k) place(lines[k], k == 0, false);
    for (const Case& line : lines) f_.outer.push_back(within(line, Way::kProving));
  }

 private:
  enum class Way { kStraight, kRound, kProving };

  Linear gap() const { return gap_towards(t_, r_, d_); }
  Linear share(std::int64_t percent) const { return Linear(how_.most * percent / 100); }

  // In line, so the distance is that along d and the one in height.
  Case within(Case c, Way way) const {
    c.require(share(way != Way::kRound || level_ ? 100 : 92) - gap());
    if (level_) return c;
    const Linear most_rise = way == Way::kProving ? Linear(how_.most) : way == Way::kStraight ? Linear(0) : share(92);
    const std::int64_t both = way == Way::kProving ? how_.most * 14143 / 10000 + 1 : how_.most * 13000 / 10000;
    for (const int up : {1, -1}) {
      const Linear rise = gap_towards(t_, r_, {2, up});
      c.require(most_rise - rise);
      if (way != Way::kStraight) c.require(Linear(both) - rise - gap());
    }
    return c;
  }

  void place(const Case& line, bool well_in_line, bool straight) {
    Case c = within(line, straight ? Way::kStraight : Way::kRound);
    if (!well_in_line) c.price = 150;
    if (!straight) c.price += 40;
    c.wish(gap() - Linear(std::min(how_.wished_gap, how_.most)), 100);
    wish_alignment(c, ref_, t_, r_, side_, turn_, d_);
    // Turned, it may reach less far than the box around it.
    if (odd_ && straight && !how_.in_plan_only) add_within(f_.cases, c, model_, t_, place_, how_.most, Purpose::kPlacing, odd_);
    if (odd_ && !how_.in_plan_only) c.when(t_, quarter_states(model_.items[t_]));
    f_.cases.push_back(std::move(c));
  }

  Formula& f_;
  const PlacementModel& model_;
  ItemId t_, r_;
  Side side_;
  const Beside& how_;
  ItemId framed_;  // in whose frame the side is meant
  const Item& ref_;
  Place place_;
  std::uint64_t odd_;
  bool level_ = false;
  int turn_ = 0;
  Direction d_{};
};

}  // namespace

void add_beside(Formula& f, const PlacementModel& model, ItemId t, ItemId r, Side side, const Beside& how) {
  const Item& ref = model.items[how.frame.exists() ? how.frame : r];
  BesideCases cases(f, model, t, r, side, how);
  for_each_turn(ref, [&](int turn, std::uint64_t states) { cases.add(turn, states); });
  if (ref.odd_states == 0) return;
  if (ref.spans < 0) {  // in the frame of what stands at an odd angle, whose reach nobody knows: not placed and not proven
    if (how.frame.exists()) f.exact = false, f.outer.clear();
    return;
  }
  if (f.exact) f.outer = f.cases;
  add_beside_slanted(f, model, t, r, side, how, cases.level());
}

}  // namespace layoutbox::placement
