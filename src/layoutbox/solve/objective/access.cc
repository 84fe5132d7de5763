#include "layoutbox/solve/objective/access.h"
#include "layoutbox/catalog/trait_table.h"

#include "layoutbox/solve/objective/cost.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kStandsOnFloor = 50;
constexpr Mm kFar = 1 << 28;

// Seats round a table that is used from all sides are not in its way: they are how it is used. Nor is the loft bed in the way of who sits
// at the desk below.
bool leaves_way_to(const PlacementModel& model, ItemId body, ItemId owner) {
  if (model.pair(body, owner) != PairRule::kSolids) return false;
  return model.items[body].stood_under || (model.items[body].is_seat && model.items[owner].takes_seats);
}

// Is there room below it for who sits there, over most of its floor?
bool has_room_below(const Item& item) {
  constexpr Mm kSitting = 1100, kPosts = 200;
  const State& usual = item.states[0];
  return std::any_of(item.spaces.begin(), item.spaces.end(), [&](const ItemSpace& space) {
    const auto side = [&](int k) { return usual.constants[static_cast<std::size_t>(space.quantity - kFirstConstant + k)]; };
    const bool low = side(2) == 0 && side(5) >= kSitting;
    return low && side(0) <= kPosts && side(1) <= kPosts && side(3) >= usual.extent[0] - kPosts && side(4) >= usual.extent[1] - kPosts;
  });
}

std::int64_t shared_floor(const GridBox& a, const GridBox& b) {
  const Mm x = std::min(a.hi[0], b.hi[0]) - std::max(a.lo[0], b.lo[0]), y = std::min(a.hi[1], b.hi[1]) - std::max(a.lo[1], b.lo[1]);
  return x <= 0 || y <= 0 ? 0 : std::int64_t{x} * y;
}

// Of a floor rectangle: what lies beyond the room's edge.
std::int64_t beyond_room(const PlacementModel& model, const GridBox& floor) {
  std::int64_t area = floor_area(floor) - shared_floor(floor, model.room);
  for (const GridBox& wall : model.outside) area += shared_floor(floor, wall);
  return area;
}

std::int64_t permille(std::int64_t blocked, std::int64_t area) {
  return area == 0 ? 0 : std::min<std::int64_t>(1000, blocked * 1000 / area);
}

std::int64_t blocked_permille(const PlacementModel& model, const GridBox& floor, const Placements& placements, ItemId owner) {
  std::int64_t blocked = beyond_room(model, floor);
  for (const ItemId other : model.items.ids()) {
    if (other == owner || placements[other].state < 0) continue;
    const GridBox body = box_of(model.items[other], placements[other]);
    if (!overlap_in_plan(floor, body) || !blocks_floor(model.items[other], body) || leaves_way_to(model, other, owner)) continue;
    blocked += shared_floor(floor, body);
  }
  return permille(blocked, floor_area(floor));
}

bool wants_floor(const Item& item, const Vec3& at) { return !item.is_opening() && !item.thin && at[2] <= kStandsOnFloor; }

// From how much of each strip and of each wanted floor is blocked.
template <typename Blocked>
std::int64_t cost_of_claims(std::size_t strips, const Blocked& strip_blocked, std::size_t wanted, const Blocked& wanted_blocked) {
  std::int64_t cost = 0, best = 1000;  // of the strips the best counts
  for (std::size_t k = 0; k < strips; ++k) best = std::min<std::int64_t>(best, strip_blocked(k));
  if (strips > 0) cost += best * kCostWeights.access;
  for (std::size_t k = 0; k < wanted; ++k) cost += wanted_blocked(k) * kCostWeights.wanted;
  return cost;
}

}  // namespace

void note_floor_use(Item& item) {
  if (item.entry != nullptr) {
    item.is_seat = item.is(Trait::kSeat);
    item.stood_under = item.is(Trait::kClimbedInto) && has_room_below(item);
    item.takes_seats = (!item.entry->back_to_wall || item.is(Trait::kDeskLike)) &&
                       std::any_of(item.spaces.begin(), item.spaces.end(), [](const ItemSpace& space) { return !space.carries; });
  }
  for (State& state : item.states) {
    GridBox& around = state.claims;
    around = {{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
    for (const auto* floors : {&state.strips, &state.wanted, &state.clear}) {
      for (const GridBox& floor : *floors) {
        for (int k = 0; k < 3; ++k) around.lo[k] = std::min(around.lo[k], floor.lo[k]), around.hi[k] = std::max(around.hi[k], floor.hi[k]);
      }
    }
  }
}

bool blocks_floor(const Item& item, const GridBox& box) {
  const bool carried = item.mount == Mount::kSurface && box.lo[2] > kStandsOnFloor;  // what carries it is in the way already
  return !carried && !item.is_opening() && !item.thin && (box.lo[2] + box.hi[2]) / 2 <= kBodyReach;
}

bool surely_blocks(const PlacementModel& model, ItemId body, ItemId owner) {
  const Item& item = model.items[body];
  const bool on_floor = item.supports.size() == 1 && item.supports[0].kind == SupportOption::Kind::kFloor;
  const auto low = [](const State& state) { return state.extent[2] <= 2 * kBodyReach; };
  return on_floor && !item.is_opening() && !item.thin && !leaves_way_to(model, body, owner) &&
         std::all_of(item.states.begin(), item.states.end(), low);
}

Mm intrusion_of(const PlacementModel& model, ItemId opening, const Placements& placements) {
  const Placement& p = placements[opening];
  Mm deepest = 0;
  for (const GridBox& clear : model.items[opening].states[p.state].clear) {
    const GridBox here = clear.shifted(p.at);
    for (const ItemId other : model.items.ids()) {
      if (placements[other].state < 0 || model.items[other].is_opening() || model.pair(opening, other) == PairRule::kFree) continue;
      const GridBox shared = intersection(here, box_of(model.items[other], placements[other]));
      if (overlaps_box(model, model.items[other], placements[other], here))
        deepest = std::max(deepest, std::min({shared.extent(0), shared.extent(1), shared.extent(2)}));
    }
  }
  return deepest;
}

std::int64_t access_cost_of(const PlacementModel& model, ItemId item, const Placements& placements) {
  const Item& self = model.items[item];
  const Placement& p = placements[item];
  if (self.is_opening()) return std::int64_t{intrusion_of(model, item, placements)} * kCostWeights.swing;
  if (!wants_floor(self, p.at)) return 0;
  const State& state = self.states[p.state];
  const auto blocked_of = [&](const std::vector<GridBox>& floors) {
    return [&](std::size_t k) { return blocked_permille(model, floors[k].shifted(p.at), placements, item); };
  };
  return cost_of_claims(state.strips.size(), blocked_of(state.strips), state.wanted.size(), blocked_of(state.wanted));
}

std::vector<ItemId> access_touched(const PlacementModel& model, const Placements& before, const Placements& after,
                                   const std::vector<ItemId>& group) {
  std::vector<GridBox> bodies;
  for (const ItemId member : group) {
    for (const Placements* placements : {&before, &after}) bodies.push_back(box_of(model.items[member], (*placements)[member]));
  }
  std::vector<ItemId> touched;
  for (const ItemId item : model.items.ids()) {
    if (after[item].state < 0) continue;
    const GridBox claims = model.items[item].states[after[item].state].claims.shifted(after[item].at);
    const auto reaches = [&](const GridBox& body) { return overlap_in_plan(claims, body); };
    if (std::any_of(bodies.begin(), bodies.end(), reaches) || std::find(group.begin(), group.end(), item) != group.end())
      touched.push_back(item);
  }
  return touched;
}

void AccessProbe::start(const Placements& placements, ItemId item) {
  placements_ = &placements;
  item_ = item;
  bodies_.clear();
  for (const ItemId other : placements.ids()) {
    claims_[other].known = false;
    if (other == item || placements[other].state < 0) continue;
    const GridBox box = box_of(model_.items[other], placements[other]);
    if (blocks_floor(model_.items[other], box)) bodies_.push_back({other, box});
  }
}

void AccessProbe::focus(int state, const Vec3& lo, const Vec3& hi) {
  state_ = state;
  near_bodies_.clear();
  near_owners_.clear();
  const State& own = model_.items[item_].states[state];
  const auto swept = [&](GridBox box) {
    for (int k = 0; k < 3; ++k) box.lo[k] += lo[k], box.hi[k] += hi[k];
    return box;
  };
  const GridBox body = swept({{0, 0, 0}, own.extent}), floor = swept(own.claims);
  for (const Body& other : bodies_) {
    if (overlap_in_plan(floor, other.box) && !leaves_way_to(model_, other.item, item_)) near_bodies_.push_back(other);
  }
  for (const ItemId other : placements_->ids()) {
    const Placement& there = (*placements_)[other];
    if (other == item_ || there.state < 0 || !wants_floor(model_.items[other], there.at)) continue;
    const GridBox& claims = model_.items[other].states[there.state].claims;
    if (overlap_in_plan(body, claims.shifted(there.at)) && !leaves_way_to(model_, item_, other)) near_owners_.push_back(other);
  }
}

AccessProbe::Claim AccessProbe::claim_of(const GridBox& floor, ItemId owner, const std::vector<Body>& bodies) const {
  Claim claim{floor, floor_area(floor), beyond_room(model_, floor)};
  for (const Body& body : bodies) {
    if (body.item == owner || !overlap_in_plan(floor, body.box) || leaves_way_to(model_, body.item, owner)) continue;
    claim.blocked += shared_floor(floor, body.box);
  }
  return claim;
}

const AccessProbe::Claims& AccessProbe::claims_of(ItemId owner) {
  Claims& claims = claims_[owner];
  if (claims.known) return claims;
  const Placement& there = (*placements_)[owner];
  const State& state = model_.items[owner].states[there.state];
  claims.known = true;
  claims.strips.clear();
  claims.wanted.clear();
  for (const GridBox& strip : state.strips) claims.strips.push_back(claim_of(strip.shifted(there.at), owner, bodies_));
  for (const GridBox& wanted : state.wanted) claims.wanted.push_back(claim_of(wanted.shifted(there.at), owner, bodies_));
  const auto blocked_of = [&](const std::vector<Claim>& floors) {
    return [&](std::size_t k) { return permille(floors[k].blocked, floors[k].area); };
  };
  claims.cost = cost_of_claims(claims.strips.size(), blocked_of(claims.strips), claims.wanted.size(), blocked_of(claims.wanted));
  return claims;
}

std::int64_t AccessProbe::cost_at(const Vec3& at, std::int64_t enough) {
  const Item& self = model_.items[item_];
  const State& own = self.states[state_];
  std::int64_t cost = 0;
  if (wants_floor(self, at)) {
    const auto blocked_of = [&](const std::vector<GridBox>& floors) {
      return [&](std::size_t k) {
        const Claim claim = claim_of(floors[k].shifted(at), item_, near_bodies_);
        return permille(claim.blocked, claim.area);
      };
    };
    cost += cost_of_claims(own.strips.size(), blocked_of(own.strips), own.wanted.size(), blocked_of(own.wanted));
  }
  const GridBox body = box_of(self, {state_, at});
  if (!blocks_floor(self, body)) return cost;
  for (const ItemId owner : near_owners_) {
    if (cost >= enough) return cost;
    const Placement& there = (*placements_)[owner];
    if (!overlap_in_plan(body, model_.items[owner].states[there.state].claims.shifted(there.at))) continue;
    const Claims& claims = claims_of(owner);
    const auto blocked_of = [&](const std::vector<Claim>& floors) {
      return [&](std::size_t k) { return permille(floors[k].blocked + shared_floor(floors[k].floor, body), floors[k].area); };
    };
    cost += cost_of_claims(claims.strips.size(), blocked_of(claims.strips), claims.wanted.size(), blocked_of(claims.wanted)) - claims.cost;
  }
  return cost;
}

}  // namespace layoutbox::placement
