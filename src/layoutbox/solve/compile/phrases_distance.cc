#include "layoutbox/solve/compile/phrases.h"

#include <cmath>

namespace layoutbox::placement {
namespace {

// The height of the underside where it cannot be anywhere else.
std::optional<Mm> underside_of(const Item& item) {
  if (item.is_opening()) return item.opening->sill;
  return floor_only(item) ? std::optional<Mm>(0) : std::nullopt;
}

Mm gap_in_height(Mm low_a, Mm height_a, Mm low_b, Mm height_b) { return std::max({0, low_a - low_b - height_b, low_b - low_a - height_a}); }

}  // namespace

Heights heights_between(const PlacementModel& model, ItemId t, const Place& r, Mm most, Purpose purpose) {
  Heights h;
  if (!r.item.exists()) return {true, 0, ~std::uint64_t{0}};  // walls go from floor to ceiling
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

namespace {

struct PartPair {
  PartPlace t, r;
};

// Pairs of places within t and r, one of which is as near as need be: corners meet what is no corner.
std::vector<PartPair> pairs_of_parts(const PlacementModel& model, ItemId t, const Place& r, std::uint64_t t_states) {
  const std::vector<PartPlace> references = r.item.exists() ? parts_of(model, r.item) : std::vector<PartPlace>{{r, 0}};
  std::vector<PartPair> pairs;
  for (const PartPlace& own : parts_of(model, t)) {
    for (const PartPlace& other : references) {
      if ((own.states & t_states) && !(own.corner && other.corner)) pairs.push_back({own, other});
    }
  }
  return pairs;
}

// What "at most so far off" leaves: for the plan where heights are known beforehand, else for all three axes.
struct Limit {
  bool level = false;  // heights are known
  std::int64_t left = 0;
  bool proving = false;

  void along(Case& c, const Place& own, const Place& other, int axis, std::int64_t length) const {
    for (const int sign : {1, -1}) c.require(Linear(length) - gap_towards(own, other, {axis, sign}));
  }

  // Exactly so far off, straight across.
  void add_straight(std::vector<Case>& cases, const Case& from, const Place& own, const Place& other) const {
    for (int axis = 0; axis < 2; ++axis) {
      Case straight = from;
      along(straight, own, other, axis, left);
      along(straight, own, other, 1 - axis, 0);
      if (!level) along(straight, own, other, 2, 0);
      cases.push_back(std::move(straight));
    }
  }

  // An octagon within the circle; around it for proving.
  void add_round(std::vector<Case>& cases, Case round, const Place& own, const Place& other) const {
    const int axes = level ? 2 : 3;
    const std::int64_t one = proving ? left : level ? left * 92 / 100 : left * 8 / 10;
    const std::int64_t two = proving ? left * 14143 / 10000 + 1 : level ? left * 13 / 10 : left * 11 / 10;
    for (int axis = 0; axis < axes; ++axis) along(round, own, other, axis, one);
    for (int first = 0; first < axes; ++first) {
      for (int second = first + 1; second < axes; ++second) require_sum(round, own, other, first, second, two);
    }
    cases.push_back(std::move(round));
  }

  void add(std::vector<Case>& cases, const Case& from, const Place& own, const Place& other) const {
    if (!proving) add_straight(cases, from, own, other);
    add_round(cases, from, own, other);
  }

 private:
  static void require_sum(Case& c, const Place& own, const Place& other, int first, int second, std::int64_t most) {
    for (const int s1 : {1, -1}) {
      for (const int s2 : {1, -1}) c.require(Linear(most) - gap_towards(own, other, {first, s1}) - gap_towards(own, other, {second, s2}));
    }
  }
};

}  // namespace

void add_within(std::vector<Case>& cases, Case base, const PlacementModel& model, ItemId t, const Place& r, Mm most, Purpose purpose,
                std::uint64_t t_states) {
  const Heights heights = heights_between(model, t, r, most, purpose);
  Limit limit{heights.known, most, purpose == Purpose::kProving};
  if (heights.known) {
    if (heights.gap > most) return;
    if (!limit.proving && heights.states != model.items[t].all_states && r.item.exists()) base.when(t, heights.states);
    const double squared = static_cast<double>(most) * most - static_cast<double>(heights.gap) * heights.gap;
    limit.left = static_cast<std::int64_t>(std::floor(std::sqrt(squared) + (limit.proving ? 1 : 0)));
  }
  const bool odd = model.items[t].odd_states != 0 || (r.item.exists() && model.items[r.item].odd_states != 0);
  if (limit.proving || !odd) {  // the box around a turned body is no farther than the body
    limit.add(cases, base, place_of(t), r);
    return;
  }
  for (const PartPair& pair : pairs_of_parts(model, t, r, t_states)) {
    Case c = base;
    if (pair.t.states != model.items[t].all_states) c.when(t, pair.t.states);
    if (r.item.exists() && pair.r.states != model.items[r.item].all_states) c.when(r.item, pair.r.states);
    limit.add(cases, c, pair.t.place, pair.r.place);
  }
}

// An axis along which they are `least` apart is enough, and so is a sum over two axes of √2 times that. Needed is one of: 92 % along an
// axis, or a sum over two or three of 1.31 times.
void add_apart(std::vector<Case>& cases, const PlacementModel& model, ItemId t, const Place& r, Mm least, Purpose purpose) {
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

namespace {

constexpr Mm kWithinSlack = 3;           // of the 5 mm that every length is allowed
constexpr int kMostSectors = 12;         // of a quadrant
constexpr std::int32_t kPlanar = 10000;  // directions are whole numbers of this length

// Where it stands if it stands as it is told to: on the floor, or on top of something there.
std::optional<Mm> told_underside(const PlacementModel& model, ItemId item) {
  const Item& self = model.items[item];
  if (const auto known = underside_of(self); known || self.is_opening()) return known;
  for (const Relation& r : model.scene->relations) {
    if (r.type != RelationType::kOn || r.references.size() != 1 || std::ranges::find(r.targets, self.id) == r.targets.end()) continue;
    const ItemId host = model.find_item(r.references[0]);
    if (host.exists() && floor_only(model.items[host])) return model.items[host].states[0].extent[2];
  }
  return std::nullopt;
}

// The heights that these things are told to have, which a case may count on that asks for them.
Heights told_heights(const PlacementModel& model, ItemId t, ItemId r, Case& asks) {
  Heights h;
  const auto low_t = told_underside(model, t), low_r = told_underside(model, r);
  if (!low_t || !low_r) return h;
  h.known = true;
  h.states = model.items[t].all_states;
  for (const State& a : model.items[t].states) {
    for (const State& b : model.items[r].states) h.gap = std::max(h.gap, gap_in_height(*low_t, a.extent[2], *low_r, b.extent[2]));
  }
  for (const auto& [item, low] : {std::pair{t, *low_t}, std::pair{r, *low_r}})
    asks.require(lo(item, 2) - Linear(low)).require(Linear(low) - lo(item, 2));
  return h;
}

// A ring too narrow for the octagons: pieces of it, one beside the other, beyond the corners of r.
void add_ring(std::vector<Case>& cases, const PlacementModel& model, ItemId t, const Place& r, Mm least, Mm most) {
  const bool odd = model.items[t].odd_states != 0 || (r.item.exists() && model.items[r.item].odd_states != 0);
  if (!r.item.exists() || odd || least <= 0 || most < least || most * 10 > least * 11 + 300) return;
  Heights heights = heights_between(model, t, r, most, Purpose::kPlacing);
  Case asks;
  if (!heights.known) heights = told_heights(model, t, r.item, asks);
  if (!heights.known || heights.gap >= least) return;
  // In plan. What is so far in plan is as far in all.
  most = static_cast<Mm>(std::floor(std::sqrt(static_cast<double>(most) * most - static_cast<double>(heights.gap) * heights.gap)));
  if (most < least) return;
  // From the middle of a piece on: so far out, so far to either side.
  const double out = least + std::max(1.0, (most - least) / 2.0), limit = most + kWithinSlack;
  const double aside = std::sqrt(limit * limit - out * out);
  const int sectors = std::clamp(static_cast<int>(std::ceil(kPi / 2 / (1.9 * std::atan(aside / out)))), 1, kMostSectors);
  for (const int sx : {1, -1}) {
    for (const int sy : {1, -1}) {
      const Linear x = gap_towards(t, r, {0, sx}), y = gap_towards(t, r, {1, sy});
      for (int k = 0; k < sectors; ++k) {
        const double angle = (k + 0.5) * kPi / 2 / sectors;
        const auto c = static_cast<std::int32_t>(std::lround(kPlanar * std::cos(angle))),
                   s = static_cast<std::int32_t>(std::lround(kPlanar * std::sin(angle)));
        const Linear ahead = c * x + s * y, across = c * y - s * x;
        const auto scaled = [](double length) { return Linear(static_cast<std::int64_t>(std::floor(length * kPlanar))); };
        Case& in = cases.emplace_back(asks);
        if (heights.states != model.items[t].all_states) in.when(t, heights.states);
        in.require(x).require(y).require(ahead - scaled(least), kPlanar).require(scaled(out) - ahead, kPlanar);
        in.require(scaled(aside) - across, kPlanar).require(scaled(aside) + across, kPlanar);
      }
    }
  }
}

}  // namespace

void add_band(Formula& f, const PlacementModel& model, ItemId t, const Place& r, Mm least, std::optional<Mm> most, Mm wished) {
  f.exact = false;
  for (const Purpose purpose : {Purpose::kPlacing, Purpose::kProving}) {
    std::vector<Case> apart;
    const auto odd_states = [&](ItemId item) { return item.exists() ? model.items[item].odd_states : 0; };
    if (least > 0) {
      add_apart(apart, model, t, r, least, purpose);
      // What is turned may be farther than the box around it.
      for (const ItemId item : {t, r.item}) {
        if (purpose == Purpose::kProving && odd_states(item)) apart.emplace_back().when(item, odd_states(item));
      }
    } else {
      apart.emplace_back();
    }
    std::vector<Case>& out = purpose == Purpose::kPlacing ? f.cases : f.outer;
    for (Case& in : apart) {
      if (purpose == Purpose::kPlacing && r.item.exists()) {
        for (int axis = 0; axis < 2; ++axis) in.wish(mid2(t, axis) - mid2(r.item, axis), wished > 500 ? 4 : 15, 2);
      }
      if (most) {
        add_within(out, std::move(in), model, t, r, *most, purpose);
      } else {
        out.push_back(std::move(in));
      }
    }
  }
  if (most) add_ring(f.cases, model, t, r, least, *most);
}

}  // namespace layoutbox::placement
