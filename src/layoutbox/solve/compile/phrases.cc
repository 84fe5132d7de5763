#include "layoutbox/solve/compile/phrases.h"

#include <cmath>
#include <optional>

namespace layoutbox::placement {
namespace {

constexpr int kNormalise = 1000;  // directions at odd angles are whole numbers in thousandths

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

}  // namespace

void for_each_turn(const Item& item, const std::function<void(int, std::uint64_t)>& visit) {
  std::vector<int> seen;
  for (const State& state : item.states) {
    if (std::find(seen.begin(), seen.end(), state.turn) != seen.end()) continue;
    seen.push_back(state.turn);
    visit(state.turn, item.states_at(state.turn));
  }
}

Linear gap_towards(int t, int r, Direction d) { return Linear(0) - reach(t, opposite(d)) - reach(r, d); }

namespace {

// The height of the underside where it cannot be anywhere else.
std::optional<Mm> underside_of(const Item& item) {
  if (item.is_opening()) return item.opening->sill;
  const bool floor_only = item.supports.size() == 1 && item.supports[0].kind == SupportOption::Kind::kFloor;
  return floor_only ? std::optional<Mm>(0) : std::nullopt;
}

Mm gap_in_height(Mm low_a, Mm height_a, Mm low_b, Mm height_b) { return std::max({0, low_a - low_b - height_b, low_b - low_a - height_a}); }

}  // namespace

void add_within(Formula& f, Case base, const Model& model, int t, int r, Mm most) {
  const Item &a = model.items[t], &b = model.items[r];
  const auto low_a = underside_of(a), low_b = underside_of(b);
  const bool heights_known = low_a && low_b;
  std::int64_t left = most;  // what the difference in height leaves for the plan
  if (heights_known) {
    // The states that come no farther apart in height than the first one does.
    const auto gap_of = [&](const State& s) { return gap_in_height(*low_a, s.extent[2], *low_b, b.states[0].extent[2]); };
    Mm up = gap_of(a.states[0]);
    if (up * 10 > most * 9) {
      for (const State& state : a.states) up = std::min(up, gap_of(state));
    }
    if (up > most) return;
    std::uint64_t fitting = 0;
    for (std::size_t s = 0; s < a.states.size(); ++s) {
      if (gap_of(a.states[s]) <= up) fitting |= std::uint64_t{1} << s;
    }
    if (fitting != a.all_states) base.when(t, fitting);
    left = static_cast<std::int64_t>(std::sqrt(static_cast<double>(most) * most - static_cast<double>(up) * up));
  }
  const auto limit = [&](Case& c, int axis, std::int64_t length) {
    for (const int sign : {1, -1}) c.require(Linear(length) - gap_towards(t, r, {axis, sign}));
  };
  for (int axis = 0; axis < 2; ++axis) {
    Case across = base;
    limit(across, axis, left);
    limit(across, 1 - axis, 0);
    if (!heights_known) limit(across, 2, 0);
    f.cases.push_back(std::move(across));
  }
  const int axes = heights_known ? 2 : 3;
  for (int axis = 0; axis < axes; ++axis) limit(base, axis, heights_known ? left * 92 / 100 : left * 8 / 10);
  const std::int64_t pair = heights_known ? left * 13 / 10 : left * 11 / 10;
  for (int first = 0; first < axes; ++first) {
    for (int second = first + 1; second < axes; ++second) {
      for (const int s1 : {1, -1}) {
        for (const int s2 : {1, -1}) base.require(Linear(pair) - gap_towards(t, r, {first, s1}) - gap_towards(t, r, {second, s2}));
      }
    }
  }
  f.cases.push_back(std::move(base));
}

void require_within_wall(Case& c, int t, const RoomWall& wall, Mm most) {
  const Direction out{wall.normal(), wall.inward};
  c.require(Linear(most) + reach(t, opposite(out)) + Linear(std::int64_t{wall.inward} * wall.at));
  c.require(hi(t, wall.along) - Linear(wall.lo));
  c.require(Linear(wall.hi) - lo(t, wall.along));
}

void add_apart(Formula& f, int t, int r, Mm least) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const int sign : {1, -1}) f.add().require(gap_towards(t, r, {axis, sign}) - Linear(least));
  }
  if (least == 0) return;
  for (const int sx : {1, -1}) {
    for (const int sy : {1, -1}) {
      f.add().require(gap_towards(t, r, {0, sx}) + gap_towards(t, r, {1, sy}) - Linear(std::int64_t{least} * 1415 / 1000));
    }
  }
}

void add_apart_from_wall(Formula& f, int t, const RoomWall& wall, Mm least) {
  const Direction out{wall.normal(), wall.inward};
  f.add().require(Linear(0) - reach(t, opposite(out)) - Linear(std::int64_t{wall.inward} * wall.at + least));
  f.add().require(lo(t, wall.along) - Linear(wall.hi + least));
  f.add().require(Linear(wall.lo - least) - hi(t, wall.along));
}

void require_in_line(Case& c, int t, int r, int axis) {
  const Linear off = mid2(t, axis) - mid2(r, axis);
  c.require(extent(r, axis) - off);
  c.require(extent(r, axis) + off);
}

namespace {

// The shared body of "beyond" and "at side": `near_limit` is what the near edge must not pass.
void add_side(Formula& f, const Model& model, int t, int r, Side side, Mm most, Mm wished_gap, bool may_reach_under,
              std::uint64_t ref_states) {
  const Item& ref = model.items[r];
  for_each_turn(ref, [&](int turn, std::uint64_t all) {
    const std::uint64_t states = all & ref_states;
    if (!states) return;
    const Direction d = side_direction(ref, side, turn);
    const int a = across(d);
    for (const bool longer : {false, true}) {  // the middle of the shorter faces the longer
      Case& c = f.add();
      c.when(r, states);
      if (may_reach_under) {
        c.require(reach(t, d) - reach(r, d));
        c.require(-2 * reach(t, opposite(d)) - d.sign * mid2(r, d.axis));  // its near edge not past the middle of r
      } else {
        c.require(gap_towards(t, r, d));
      }
      c.require(Linear(most) - gap_towards(t, r, d));
      c.require(Linear(most) - lo(t, 2) + hi(r, 2));
      c.require(Linear(most) - lo(r, 2) + hi(t, 2));
      const Linear off = mid2(t, a) - mid2(r, a);
      c.require(extent(longer ? t : r, a) - off);
      c.require(extent(longer ? t : r, a) + off);
      if (longer) c.price = 150;
      c.wish(gap_towards(t, r, d) - Linear(std::min(wished_gap, most)), 100);
      wish_alignment(c, ref, t, r, side, turn, d);
    }
  });
}

}  // namespace

void add_beyond(Formula& f, const Model& model, int t, int r, Side side, Mm most, Mm wished_gap) {
  add_side(f, model, t, r, side, most, wished_gap, false, ~std::uint64_t{0});
}

void add_at_side(Formula& f, const Model& model, int t, int r, Side side, Mm most, Mm wished_gap, std::uint64_t ref_states) {
  add_side(f, model, t, r, side, most, wished_gap, true, ref_states);
}

void add_looks_at(Formula& f, const Model& model, int t, int r) {
  const Item& item = model.items[t];
  if (!item.has_front) {
    f.add().wish(Linear(0), 1);
    return;
  }
  for_each_turn(item, [&](int turn, std::uint64_t states) {
    if (!quarter(turn)) {
      const double angle = radians_from_degrees(turn);
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
    // Its whole front looks at r, or r's at its front within about 11°, or the ray from its middle meets r.
    Case& whole = f.add().when(t, states).require(ahead);
    whole.require(lo(t, a) - lo(r, a)).require(hi(r, a) - hi(t, a)).wish(off, 100, 2);
    Case& narrow = f.add().when(t, states).require(ahead);
    const Linear distance2 = Linear(0) - 2 * reach(r, opposite(d)) - d.sign * mid2(t, d.axis);
    narrow.require(distance2 - 5 * off).require(distance2 + 5 * off).wish(off, 100, 2);
    Case& middle = f.add().when(t, states).require(ahead);
    middle.require(extent(r, a) - off).require(extent(r, a) + off).wish(off, 100, 2);
    middle.price = 80;
  });
}

void add_looks_at_wall(Formula& f, const Model& model, int t, const RoomWall& wall) {
  const Item& item = model.items[t];
  for_each_turn(item, [&](int turn, std::uint64_t states) {
    if (!quarter(turn) || (item.has_front && !(front_at(item, turn) == Direction{wall.normal(), -wall.inward}))) return;
    f.add().when(t, states).require(mid2(t, wall.along) - Linear(2 * wall.lo)).require(Linear(2 * wall.hi) - mid2(t, wall.along));
  });
}

void add_looks_at_point(Formula& f, const Model& model, int t, Point point) {
  const Item& item = model.items[t];
  for_each_turn(item, [&](int turn, std::uint64_t states) {
    if (!item.has_front || !quarter(turn)) return;
    const Direction d = front_at(item, turn);
    const Linear ahead2 = Linear(std::int64_t{2} * d.sign * (d.axis == 0 ? point.x : point.y)) - d.sign * mid2(t, d.axis);
    const Linear off2 = mid2(t, across(d)) - Linear(2 * (across(d) == 0 ? point.x : point.y));
    f.add().when(t, states).require(ahead2 - 4 * off2).require(ahead2 + 4 * off2).wish(off2, 50, 2);
  });
  if (!item.has_front) f.add();
}

void add_against(Formula& f, const Model& model, int t, const RoomWall& wall, Side side, Mm gap) {
  if (!wall.straight) return;
  const Item& item = model.items[t];
  const Direction out{wall.normal(), wall.inward};
  for_each_turn(item, [&](int turn, std::uint64_t states) {
    if (!quarter(turn)) return;
    if (item.has_front && !(side_direction(item, side, turn) == opposite(out))) return;
    Case& c = f.add().when(t, states);
    const Linear off = Linear(0) - reach(t, opposite(out)) - Linear(std::int64_t{wall.inward} * wall.at);
    c.require(off).require(Linear(gap) - off).wish(off, 400);
    const bool fits = item.least_extent(wall.along) <= wall.hi - wall.lo;
    if (fits) {
      c.require(lo(t, wall.along) - Linear(wall.lo)).require(Linear(wall.hi) - hi(t, wall.along));
    } else {
      c.require(mid2(t, wall.along) - Linear(2 * wall.lo)).require(Linear(2 * wall.hi) - mid2(t, wall.along));
    }
  });
}

void require_cover(Case& c, const Model& model, int t, int r, Mm grow) {
  // |mid(t) − mid(r)| ≤ max(half) − min(half)/2 without knowing which is greater: both ways round must hold for the box that is
  // surely greater; extents differ by state, so the bound is posted for t greater, for r greater, as the states' extents say.
  const Item &a = model.items[t], &b = model.items[r];
  for (int axis = 0; axis < 2; ++axis) {
    const Linear off = mid2(t, axis) - mid2(r, axis);
    const bool r_greater = a.least_extent(axis) <= b.least_extent(axis);
    const Linear bound2 = 2 * extent(r_greater ? r : t, axis) - extent(r_greater ? t : r, axis) + Linear(r_greater ? 4 * grow : 0);
    c.require(bound2 - 2 * off).require(bound2 + 2 * off);
  }
}

std::uint64_t states_with_width_along(const Item& item, int axis) {
  std::uint64_t mask = 0;
  for (std::size_t s = 0; s < item.states.size(); ++s) {
    const int turn = item.states[s].turn;
    if (turn % 90 == 0 && (turn % 180 == 0) == (axis == 0)) mask |= std::uint64_t{1} << s;
  }
  return mask;
}

}  // namespace layoutbox::placement
