#include "layoutbox/solve/compile/phrases.h"

#include <bit>
#include <cmath>

#include "layoutbox/solve/slanted.h"

namespace layoutbox::placement {
namespace {

constexpr int kNormalise = 1000;  // directions at odd angles are whole numbers in thousandths
// tan 15° as a fraction; within what the verifier calls 15°.
constexpr std::int32_t kLookAcross = 100000, kLookAhead = 26794;

constexpr Mm kKnees = 300;           // how high what is free below must be for legs
constexpr Mm kFlush = 3;             // off a slanted wall, that some whole millimetre may be there
constexpr double kSameAngle = 0.01;  // degrees

bool quarter(int turn) { return turn % 90 == 0; }

Direction front_at(const Item& item, int turn) { return side_direction(item, Side::kFront, turn); }

// Wishes that things beside one another look as if meant: flush backs beside, centred before and behind.
void wish_alignment(Case& c, const Item& ref, int t, int r, Side side, int turn, Direction d) {
  if (side == Side::kLeft || side == Side::kRight) {
    const Direction back = side_direction(ref, Side::kBack, turn);
    c.wish(reach(t, back) - reach(r, back), 60);
  } else {
    c.wish(mid2(t, across(d)) - mid2(r, across(d)), 120, 2);
  }
}

// The height of the underside where it cannot be anywhere else.
std::optional<Mm> underside_of(const Item& item) {
  if (item.is_opening()) return item.opening->sill;
  return floor_only(item) ? std::optional<Mm>(0) : std::nullopt;
}

Mm gap_in_height(Mm low_a, Mm height_a, Mm low_b, Mm height_b) { return std::max({0, low_a - low_b - height_b, low_b - low_a - height_a}); }

Mm greatest_extent(const Item& item, int axis) {
  Mm greatest = 0;
  for (const State& state : item.states) greatest = std::max(greatest, state.extent[axis]);
  return greatest;
}

// What the distance in height leaves of a distance for the plan; no value: heights are not known beforehand.
struct Heights {
  bool known = false;
  Mm gap = 0;                                // for proving the least, for placing of the states below
  std::uint64_t states = ~std::uint64_t{0};  // of t
};

Heights heights_between(const Model& model, int t, const Place& r, Mm most, Purpose purpose) {
  Heights h;
  if (r.item < 0) return {true, 0, ~std::uint64_t{0}};  // walls go from floor to ceiling
  const Item &a = model.items[t], &b = model.items[r.item];
  const auto low_a = underside_of(a), low_b = underside_of(b);
  if (!low_a || !low_b) return h;
  h.known = true;
  const auto gaps = [&](const State& s) {
    std::pair<Mm, Mm> least_and_most{1 << 29, 0};
    for (const State& other : b.states) {
      const Mm gap = gap_in_height(*low_a, s.extent[2], *low_b, other.extent[2]);
      least_and_most = {std::min(least_and_most.first, gap), std::max(least_and_most.second, gap)};
    }
    return least_and_most;
  };
  if (purpose == Purpose::kProving) {
    h.gap = 1 << 29;
    for (const State& state : a.states) h.gap = std::min(h.gap, gaps(state).first);
    return h;
  }
  h.gap = gaps(a.states[0]).second;
  if (h.gap * 10 > most * 9) {
    for (const State& state : a.states) h.gap = std::min(h.gap, gaps(state).second);
  }
  h.states = 0;
  for (std::size_t s = 0; s < a.states.size(); ++s) {
    if (gaps(a.states[s]).second <= h.gap) h.states |= std::uint64_t{1} << s;
  }
  return h;
}

}  // namespace

Place place_of(int item) {
  Place place;
  place.item = item;
  for (int axis = 0; axis < 3; ++axis) place.lo[axis] = lo(item, axis), place.hi[axis] = hi(item, axis);
  return place;
}

Place place_of(const Model& model, const RoomWall& wall) {
  Place place;
  place.lo[wall.along] = wall.lo, place.hi[wall.along] = wall.hi;
  place.lo[wall.normal()] = place.hi[wall.normal()] = wall.at;
  place.lo[2] = model.room.lo[2], place.hi[2] = model.room.hi[2];
  return place;
}

bool has_knee_room(const Item& item) {
  return std::any_of(item.spaces.begin(), item.spaces.end(), [&](const ItemSpace& s) {
    return !s.carries && item.states[0].constants[static_cast<std::size_t>(s.quantity - kFirstConstant) + 5] >= kKnees;
  });
}

Side used_side(const Item& item) {
  const std::vector<Side> used = item.object->used_sides.value_or(item.entry->used_sides);
  return used.empty() ? Side::kFront : used[0];
}

void for_each_turn(const Item& item, const std::function<void(int, std::uint64_t)>& visit) {
  std::vector<int> seen;
  for (const State& state : item.states) {
    if (std::find(seen.begin(), seen.end(), state.turn) != seen.end()) continue;
    seen.push_back(state.turn);
    visit(state.turn, item.states_at(state.turn));
  }
}

Linear gap_towards(const Place& t, const Place& r, Direction d) {
  return d.sign > 0 ? t.lo[d.axis] - r.hi[d.axis] : r.lo[d.axis] - t.hi[d.axis];
}

Linear gap_towards(int t, const Place& r, Direction d) { return gap_towards(place_of(t), r, d); }

bool floor_only(const Item& item) {
  return !item.is_opening() && item.supports.size() == 1 && item.supports[0].kind == SupportOption::Kind::kFloor;
}

std::uint64_t states_at_angle(const Item& item, double angle, double period) {
  std::uint64_t mask = 0;
  for (std::size_t s = 0; s < item.states.size(); ++s) {
    if (std::abs(std::remainder(item.states[s].angle - angle, period)) < kSameAngle) mask |= std::uint64_t{1} << s;
  }
  return mask;
}

std::optional<SignedHeading> signed_heading(const Model& model, double degrees) {
  for (std::size_t k = 0; k < model.headings.size(); ++k) {
    const double off = std::remainder(degrees - model.headings[k].angle, 360);
    if (std::abs(off) < kSameAngle) return SignedHeading{static_cast<int>(k), 1};
    if (std::abs(std::abs(off) - 180) < kSameAngle) return SignedHeading{static_cast<int>(k), -1};
  }
  return std::nullopt;
}

std::vector<Part> parts_of(const Model& model, int index) {
  const Item& item = model.items[index];
  std::vector<Part> parts;
  if (quarter_states(item)) parts.push_back({place_of(index), quarter_states(item)});
  if (item.odd_states == 0) return parts;
  const auto constant = [&](int k) { return constant_of(index, item.footprint + k); };
  Part within{place_of(index), item.odd_states};
  for (int axis = 0; axis < 2; ++axis) {
    within.place.lo[axis] = lo(index, axis) + constant(axis);
    within.place.hi[axis] = lo(index, axis) + constant(2 + axis);
  }
  parts.push_back(within);
  for (int corner = 0; corner < 4; ++corner) {
    Part point = within;
    point.corner = true;
    for (int axis = 0; axis < 2; ++axis) point.place.lo[axis] = point.place.hi[axis] = lo(index, axis) + constant(4 + 2 * corner + axis);
    parts.push_back(point);
  }
  return parts;
}

namespace {

struct Pair {
  Part t, r;
};

// Pairs of places within t and r, one of which is as near as need be: corners meet what is no corner.
std::vector<Pair> pairs_of_parts(const Model& model, int t, const Place& r, std::uint64_t t_states) {
  const std::vector<Part> references = r.item >= 0 ? parts_of(model, r.item) : std::vector<Part>{{r, 0}};
  std::vector<Pair> pairs;
  for (const Part& own : parts_of(model, t)) {
    for (const Part& other : references) {
      if ((own.states & t_states) && !(own.corner && other.corner)) pairs.push_back({own, other});
    }
  }
  return pairs;
}

}  // namespace

void add_within(std::vector<Case>& cases, Case base, const Model& model, int t, const Place& r, Mm most, Purpose purpose,
                std::uint64_t t_states) {
  const Heights heights = heights_between(model, t, r, most, purpose);
  std::int64_t left = most;  // what the difference in height leaves for the plan
  if (heights.known) {
    if (heights.gap > most) return;
    if (purpose == Purpose::kPlacing && heights.states != model.items[t].all_states && r.item >= 0) base.when(t, heights.states);
    const double squared = static_cast<double>(most) * most - static_cast<double>(heights.gap) * heights.gap;
    left = static_cast<std::int64_t>(std::floor(std::sqrt(squared) + (purpose == Purpose::kProving ? 1 : 0)));
  }
  const bool proving = purpose == Purpose::kProving;
  const bool odd = model.items[t].odd_states != 0 || (r.item >= 0 && model.items[r.item].odd_states != 0);
  const auto add = [&](const Case& from, const Place& own, const Place& other) {
    const auto limit = [&](Case& c, int axis, std::int64_t length) {
      for (const int sign : {1, -1}) c.require(Linear(length) - gap_towards(own, other, {axis, sign}));
    };
    for (int axis = 0; axis < 2 && !proving; ++axis) {
      Case straight = from;
      limit(straight, axis, left);
      limit(straight, 1 - axis, 0);
      if (!heights.known) limit(straight, 2, 0);
      cases.push_back(std::move(straight));
    }
    Case round = from;
    const int axes = heights.known ? 2 : 3;
    for (int axis = 0; axis < axes; ++axis) limit(round, axis, proving ? left : heights.known ? left * 92 / 100 : left * 8 / 10);
    const std::int64_t pair = proving ? left * 14143 / 10000 + 1 : heights.known ? left * 13 / 10 : left * 11 / 10;
    for (int first = 0; first < axes; ++first) {
      for (int second = first + 1; second < axes; ++second) {
        for (const int s1 : {1, -1}) {
          for (const int s2 : {1, -1})
            round.require(Linear(pair) - gap_towards(own, other, {first, s1}) - gap_towards(own, other, {second, s2}));
        }
      }
    }
    cases.push_back(std::move(round));
  };
  if (proving || !odd) {  // the box around a turned body is no farther than the body
    add(base, place_of(t), r);
    return;
  }
  for (const Pair& pair : pairs_of_parts(model, t, r, t_states)) {
    Case c = base;
    if (pair.t.states != model.items[t].all_states) c.when(t, pair.t.states);
    if (r.item >= 0 && pair.r.states != model.items[r.item].all_states) c.when(r.item, pair.r.states);
    add(c, pair.t.place, pair.r.place);
  }
}

// An axis along which they are `least` apart is enough, and so is a sum over two axes of √2 times that. Needed is one of: 92 % along an
// axis, or a sum over two or three of 1.31 times.
void add_apart(std::vector<Case>& cases, const Model& model, int t, const Place& r, Mm least, Purpose purpose) {
  const bool proving = purpose == Purpose::kProving;
  const bool flat = heights_between(model, t, r, least, purpose).known && heights_between(model, t, r, least, purpose).gap == 0;
  const int axes = flat ? 2 : 3;
  const std::int64_t along = proving ? std::int64_t{least} * 92 / 100 : least;
  const std::int64_t sum = proving ? std::int64_t{least} * 131 / 100 : std::int64_t{least} * 1415 / 1000;
  for (int axis = 0; axis < axes; ++axis) {
    for (const int sign : {1, -1}) cases.emplace_back().require(gap_towards(t, r, {axis, sign}) - Linear(along));
  }
  if (least <= 0) return;
  for (const int sx : {1, -1}) {
    for (const int sy : {1, -1}) {
      const Linear plan = gap_towards(t, r, {0, sx}) + gap_towards(t, r, {1, sy});
      cases.emplace_back().require(plan - Linear(sum));
      if (!proving || flat) continue;
      for (const int sz : {1, -1}) cases.emplace_back().require(plan + gap_towards(t, r, {2, sz}) - Linear(sum));
    }
  }
  if (!proving || flat) return;
  for (const int axis : {0, 1}) {
    for (const int s1 : {1, -1}) {
      for (const int sz : {1, -1}) cases.emplace_back().require(gap_towards(t, r, {axis, s1}) + gap_towards(t, r, {2, sz}) - Linear(sum));
    }
  }
}

void add_band(Formula& f, const Model& model, int t, const Place& r, Mm least, std::optional<Mm> most, Mm wished) {
  f.exact = false;
  for (const Purpose purpose : {Purpose::kPlacing, Purpose::kProving}) {
    std::vector<Case> apart;
    const auto odd_states = [&](int item) { return item >= 0 ? model.items[item].odd_states : 0; };
    if (least > 0) {
      add_apart(apart, model, t, r, least, purpose);
      // What is turned may be farther than the box around it.
      for (const int item : {t, r.item}) {
        if (purpose == Purpose::kProving && odd_states(item)) apart.emplace_back().when(item, odd_states(item));
      }
    } else {
      apart.emplace_back();
    }
    std::vector<Case>& out = purpose == Purpose::kPlacing ? f.cases : f.outer;
    for (Case& in : apart) {
      if (purpose == Purpose::kPlacing && r.item >= 0) {
        for (int axis = 0; axis < 2; ++axis) in.wish(mid2(t, axis) - mid2(r.item, axis), wished > 500 ? 4 : 15, 2);
      }
      if (most) {
        add_within(out, std::move(in), model, t, r, *most, purpose);
      } else {
        out.push_back(std::move(in));
      }
    }
  }
}

void require_near_wall(Case& c, const Model& model, int t, const RoomWall& wall, Mm most) {
  c.require(Linear(most) - gap_towards(t, place_of(model, wall), {wall.normal(), wall.inward}));
  c.require(hi(t, wall.along) - Linear(wall.lo)).require(Linear(wall.hi) - lo(t, wall.along));
}

void require_near_slanted_wall(Case& c, const Model& model, int t, const RoomWall& wall, Mm most) {
  const std::int64_t millimetre = 2 * kHeading;
  const auto length = static_cast<std::int64_t>(std::hypot(wall.end.x - wall.start.x, wall.end.y - wall.start.y));
  const Linear along = along_wall2(model, t, wall);
  c.require(Linear(millimetre * most) - slanted_gap2(model, t, wall), millimetre);
  c.require(along, millimetre).require(Linear(millimetre * length) - along, millimetre);
}

void wish_middle_of_wall(Case& c, const Model& model, int t, const RoomWall& wall, int weight) {
  if (wall.straight) {
    c.wish(mid2(t, wall.along) - Linear(std::int64_t{wall.lo} + wall.hi), weight, 2);
    return;
  }
  const double length = std::hypot(wall.end.x - wall.start.x, wall.end.y - wall.start.y);
  c.wish(along_wall2(model, t, wall) - Linear(static_cast<std::int64_t>(kHeading * length)), weight, 2 * kHeading);
}

void wish_beside_on_wall(Case& c, const Model& model, int t, int r, const RoomWall& wall, int weight) {
  if (wall.straight) {
    c.wish(mid2(t, wall.along) - mid2(r, wall.along), weight, 2);
    c.wish(mid2(t, wall.normal()) - mid2(r, wall.normal()), weight / 2, 2);
    return;
  }
  c.wish(along2(model, t, wall.along_heading) - along2(model, r, wall.along_heading), weight, 2 * kHeading);
  c.wish(along2(model, t, wall.normal_heading) - along2(model, r, wall.normal_heading), weight / 2, 2 * kHeading);
}

std::vector<Case> away_from_angled(const Model& model, int t, const RoomWall& wall, Mm least) {
  std::vector<Case> cases;
  const Place box = place_of(model, wall);  // the least that is surely enough: away from the box around it
  Place around = box;
  const Wall& drawn = model.scene->room.walls[static_cast<std::size_t>(&wall - model.walls.data())];
  around.lo[0] = std::min(drawn.start.x, drawn.end.x), around.hi[0] = std::max(drawn.start.x, drawn.end.x);
  around.lo[1] = std::min(drawn.start.y, drawn.end.y), around.hi[1] = std::max(drawn.start.y, drawn.end.y);
  add_apart(cases, model, t, around, least, Purpose::kPlacing);
  return cases;
}

std::vector<Case> in_line(const Case& base, const Model& model, int t, const Place& r, int axis) {
  const Linear off = mid2(t, axis) - r.lo[axis] - r.hi[axis];
  const auto within = [&](const Linear& length) {
    Case c = base;
    c.require(length - off).require(length + off);
    return c;
  };
  const Linear length = r.hi[axis] - r.lo[axis];
  const Item& item = model.items[t];
  const Mm shortest = r.item >= 0 ? model.items[r.item].least_extent(axis) : static_cast<Mm>(length.constant);
  const Mm longest = r.item >= 0 ? greatest_extent(model.items[r.item], axis) : static_cast<Mm>(length.constant);
  std::vector<Case> cases;
  if (item.least_extent(axis) < longest) cases.push_back(within(length));
  if (greatest_extent(item, axis) >= shortest || cases.empty()) cases.push_back(within(extent(t, axis)));
  return cases;
}

namespace {

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

void add_beside(Formula& f, const Model& model, int t, int r, Side side, const Beside& how) {
  const Item& ref = model.items[r];
  const Place place = place_of(r);
  const Heights heights = heights_between(model, t, place, how.most, Purpose::kPlacing);
  const bool level = how.in_plan_only || (heights.known && heights.gap == 0);
  const std::uint64_t odd = model.items[t].odd_states;
  for_each_turn(ref, [&](int turn, std::uint64_t all) {
    const std::uint64_t states = all & how.ref_states;
    if (!states || (!quarter(turn) && ref.spans >= 0)) return;
    const Direction d = side_direction(ref, side, turn);
    const Linear gap = gap_towards(t, r, d);
    Case base;
    base.when(r, states);
    if (how.may_reach_under) {
      base.require(reach(t, d) - reach(r, d));
      base.require(-2 * reach(t, opposite(d)) - d.sign * mid2(r, d.axis));  // its near edge not past the middle of r
    } else {
      base.require(gap);
    }
    // In line, so the distance is that along d and the one in height.
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

void add_looks_at(Formula& f, const Model& model, int t, int r) {
  const Item& item = model.items[t];
  if (!item.has_front) {
    f.add().wish(Linear(0), 1);
    return;
  }
  for_each_turn(item, [&](int turn, std::uint64_t states) {
    if (!quarter(turn)) {
      const double angle = radians_from_degrees(item.states[static_cast<std::size_t>(std::countr_zero(states))].angle);
      const auto nx = static_cast<std::int32_t>(std::lround(std::sin(angle) * kNormalise));
      const auto ny = static_cast<std::int32_t>(std::lround(-std::cos(angle) * kNormalise));
      const Linear dx = mid2(r, 0) - mid2(t, 0), dy = mid2(r, 1) - mid2(t, 1);
      const Linear ahead = nx * dx + ny * dy, aside = nx * dy - ny * dx;
      Case& c = f.add().when(t, states);  // within 7.6°: tan = 2/15
      c.require(2 * ahead - 15 * aside).require(2 * ahead + 15 * aside);
      c.wish(aside, 100, 2 * kNormalise);
      return;
    }
    const Direction d = front_at(item, turn);
    const int a = across(d);
    const Linear off = mid2(t, a) - mid2(r, a);
    const Linear ahead = reach(r, d) - reach(t, d);
    // Its whole front looks at r, or r's near edge is within 15°, or the ray from its middle meets r.
    Case& whole = f.add().when(t, states).require(ahead);
    whole.require(lo(t, a) - lo(r, a)).require(hi(r, a) - hi(t, a)).wish(off, 100, 2);
    Case& cone = f.add().when(t, states).require(ahead);
    const Linear distance2 = Linear(0) - 2 * reach(r, opposite(d)) - d.sign * mid2(t, d.axis);
    cone.require(kLookAhead * distance2 - kLookAcross * off).require(kLookAhead * distance2 + kLookAcross * off).wish(off, 100, 2);
    Case& middle = f.add().when(t, states).require(ahead);
    middle.require(extent(r, a) - off).require(extent(r, a) + off).wish(off, 100, 2);
    middle.price = 80;
  });
  const bool odd = std::any_of(item.states.begin(), item.states.end(), [](const State& s) { return !quarter(s.turn); });
  if (!odd) return;
  f.outer = f.cases;
  f.exact = false;
  for_each_turn(item, [&](int turn, std::uint64_t states) {
    if (!quarter(turn)) f.outer.emplace_back().when(t, states);
  });
}

void add_looks_at_wall(Formula& f, const Model& model, int t, const RoomWall& wall) {
  const Item& item = model.items[t];
  if (!item.has_front) {
    f.add();
    return;
  }
  if (!model.outside.empty()) f.exact = false;  // past the end of a wall there may be more room, from where it can be seen
  const Direction towards{wall.normal(), -wall.inward};
  for_each_turn(item, [&](int turn, std::uint64_t states) {
    if (!wall.straight || !quarter(turn) || !(front_at(item, turn) == towards)) return;
    f.add()
        .when(t, states)
        .require(mid2(t, wall.along) - Linear(2 * wall.lo))
        .require(Linear(2 * wall.hi) - mid2(t, wall.along))
        .require(Linear(std::int64_t{towards.sign} * wall.at) - reach(t, towards));
  });
}

void add_looks_at_point(Formula& f, const Model& model, int t, Point point) {
  const Item& item = model.items[t];
  for_each_turn(item, [&](int turn, std::uint64_t states) {
    if (!item.has_front || !quarter(turn)) return;
    const Direction d = front_at(item, turn);
    const std::int64_t at = std::int64_t{d.sign} * (d.axis == 0 ? point.x : point.y);
    const Linear ahead2 = Linear(2 * at) - d.sign * mid2(t, d.axis);
    const Linear off2 = mid2(t, across(d)) - Linear(2 * (across(d) == 0 ? point.x : point.y));
    Case& c = f.add().when(t, states).require(Linear(at) - reach(t, d));
    c.require(kLookAhead * ahead2 - kLookAcross * off2).require(kLookAhead * ahead2 + kLookAcross * off2).wish(off2, 50, 2);
  });
  if (!item.has_front) f.add();
}

std::uint64_t states_with_back_to(const Item& item, const RoomWall& wall) { return states_with_side_to(item, wall, Side::kBack); }

std::uint64_t states_where(const Item& r, Side one, Side meant) {
  if (meant != Side::kLong && meant != Side::kShort) return one == meant ? r.all_states : 0;
  std::uint64_t mask = 0;
  for (std::size_t s = 0; s < r.states.size(); ++s) {
    const State& state = r.states[s];
    const Direction d = side_direction(r, one, state.turn);
    const Mm length = state.extent[across(d)], other = state.extent[d.axis];
    if (length == other || (length > other) == (meant == Side::kLong)) mask |= std::uint64_t{1} << s;
  }
  return mask;
}

std::uint64_t states_with_side_to(const Item& item, const RoomWall& wall, Side side) {
  if (!wall.straight) {
    std::uint64_t mask = 0;
    const double quarters = side == Side::kBack    ? 0
                            : side == Side::kFront ? 180
                            : side == Side::kLeft  ? 270
                            : side == Side::kRight ? 90
                                                   : -1;
    if (item.has_front) return quarters < 0 ? 0 : states_at_angle(item, wall.angle + quarters, 360);
    for (std::size_t s = 0; s < item.states.size(); ++s) {  // any side, or that which is the longer or shorter
      const State& state = item.states[s];
      const bool along = std::abs(std::remainder(state.angle - wall.angle, 180)) < kSameAngle;
      const bool across = std::abs(std::remainder(state.angle - wall.angle - 90, 180)) < kSameAngle;
      const bool longer = along ? state.size.width >= state.size.depth : state.size.depth >= state.size.width;
      const bool shorter = along ? state.size.width <= state.size.depth : state.size.depth <= state.size.width;
      const bool meant = side == Side::kLong ? longer : side != Side::kShort || shorter;
      if ((along || across) && meant) mask |= std::uint64_t{1} << s;
    }
    return mask;
  }
  const Direction towards{wall.normal(), -wall.inward};
  const bool by_length = side == Side::kLong || side == Side::kShort;
  std::uint64_t mask = 0;
  for (const Side one : {Side::kFront, Side::kBack, Side::kLeft, Side::kRight}) {
    if (item.has_front && !by_length && one != side) continue;
    const std::uint64_t meant = by_length ? states_where(item, one, side) : item.all_states;
    for_each_turn(item, [&](int turn, std::uint64_t states) {
      if (quarter(turn) && side_direction(item, one, turn) == towards) mask |= states & meant;
    });
  }
  return mask;
}

void add_against_slanted(Formula& f, const Model& model, int t, std::uint64_t states, const RoomWall& wall, Mm gap) {
  f.exact = false;
  if (!states || model.items[t].spans < 0) return;
  const Linear off = slanted_gap2(model, t, wall), along = along_wall2(model, t, wall), half = span(model, t, wall.along_heading);
  const std::int64_t millimetre = 2 * kHeading;
  Case& c = f.add().when(t, states);
  // Its place is in whole millimetres: nothing is nearer than one of them allows.
  c.require(off, millimetre).require(Linear(millimetre * std::max(gap, kFlush)) - off, millimetre).wish(off, 400, millimetre);
  const double length = std::hypot(wall.end.x - wall.start.x, wall.end.y - wall.start.y);
  c.require(along - half, millimetre);
  c.require(Linear(static_cast<std::int64_t>(millimetre * length)) - along - half, millimetre);
}

void add_against(Formula& f, const Model& model, int t, std::uint64_t states, const RoomWall& wall, Mm gap, bool whole) {
  if (!wall.straight) {
    add_against_slanted(f, model, t, states, wall, gap);
    return;
  }
  if (!states) return;
  const Item& item = model.items[t];
  const Direction out{wall.normal(), wall.inward};
  Case c;
  if (states != item.all_states) c.when(t, states);
  const Linear off = Linear(0) - reach(t, opposite(out)) - Linear(std::int64_t{wall.inward} * wall.at);
  c.require(off).require(Linear(gap) - off).wish(off, 400);
  const bool open_ends = wall.lo > model.room.lo[wall.along] || wall.hi < model.room.hi[wall.along];
  if (!whole && open_ends) {  // half of it before the wall will do
    for (Case& loose : in_line(c, model, t, place_of(model, wall), wall.along)) {
      loose.price += 200;
      f.cases.push_back(std::move(loose));
    }
  }
  c.require(lo(t, wall.along) - Linear(wall.lo)).require(Linear(wall.hi) - hi(t, wall.along));
  f.cases.push_back(std::move(c));
}

std::vector<Case> cover(const Case& base, const Model& model, int t, int r, Mm grow) {
  // |mid(t) − mid(r)| ≤ max(half) − min(half)/2 along both axes: one case for each that may be the greater.
  const Item &a = model.items[t], &b = model.items[r];
  std::vector<Case> cases{base};
  for (int axis = 0; axis < 2; ++axis) {
    const Linear off = mid2(t, axis) - mid2(r, axis);
    std::vector<Case> next;
    for (const Case& c : cases) {
      if (b.least_extent(axis) + 2 * grow < greatest_extent(a, axis)) {  // t may be the greater
        const Linear bound2 = 2 * extent(t, axis) - extent(r, axis) - Linear(2 * grow);
        next.push_back(c);
        next.back().require(bound2 - 2 * off).require(bound2 + 2 * off);
      }
      if (greatest_extent(b, axis) + 2 * grow >= a.least_extent(axis)) {
        const Linear bound2 = 2 * extent(r, axis) + Linear(4 * grow) - extent(t, axis);
        next.push_back(c);
        next.back().require(bound2 - 2 * off).require(bound2 + 2 * off);
      }
    }
    cases = std::move(next);
  }
  return cases;
}

std::uint64_t states_with_width_along(const Item& item, int axis) {
  std::uint64_t mask = 0;
  for (std::size_t s = 0; s < item.states.size(); ++s) {
    const int turn = item.states[s].turn;
    if (quarter(turn) && (turn % 180 == 0) == (axis == 0)) mask |= std::uint64_t{1} << s;
  }
  return mask;
}

std::vector<std::vector<int>> orders_of(const Model& model, const Relation& relation, std::vector<int> things) {
  if (things.size() < 2) return {things};
  // Alike: one kind, one size, nothing said of one that is not said of the others in this very relation.
  const auto is_alone = [&](int t) {
    const std::string& id = model.items[t].id;
    const auto speaks = [&](const Relation& r) {
      const auto has = [&](const std::vector<std::string>& ids) { return std::find(ids.begin(), ids.end(), id) != ids.end(); };
      return &r != &relation && (has(r.targets) || has(r.references));
    };
    return !model.items[t].fixed && std::none_of(model.scene->relations.begin(), model.scene->relations.end(), speaks);
  };
  const Item& first = model.items[things[0]];
  const bool alike = std::all_of(things.begin(), things.end(), [&](int t) {
    const Item& item = model.items[t];
    return item.entry == first.entry && item.mount == first.mount && item.states.size() == first.states.size() &&
           item.states[0].size == first.states[0].size && is_alone(t);
  });
  if (alike) return {things};
  if (things.size() > 4) return {};
  std::vector<std::vector<int>> orders;
  std::sort(things.begin(), things.end());
  do {
    orders.push_back(things);
  } while (std::next_permutation(things.begin(), things.end()));
  return orders;
}

}  // namespace layoutbox::placement
