#include "layoutbox/solve/compile/support.h"

#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {
namespace {

constexpr int kSillDepthUsed = 200;
constexpr Mm kStillUnder = 50;  // off the floor

// Prices: "on" a bed is on its upper mattress rather than the lower one; on a tray is in it rather than on its rim.
constexpr int kLowPlace = 250, kUnlikelyTop = 300;
// On the floor although things of its kind hang: only where what was asked of it cannot be otherwise.
constexpr int kUnlikeItsKind = 8000;

// Its floor lies below the middle of the item's height.
bool is_low(const Item& item, const ItemSpace& space) {
  const State& state = item.states[0];
  return 2 * state.constants[static_cast<std::size_t>(space.quantity - kFirstConstant) + 2] < state.extent[2];
}

// Does some state of t fit in plan into some state's surface of that size?
bool fits(const Item& t, Mm width, Mm depth) {
  return std::any_of(t.states.begin(), t.states.end(), [&](const State& s) {
    return (s.extent[0] <= width && s.extent[1] <= depth) || (s.extent[0] <= depth && s.extent[1] <= width);
  });
}

// Eye and hand height suits most things; the tops of tall cupboards do not.
int price_of_height(Mm z) { return std::abs(z - 900) / 25 + (z > 1700 ? 120 : 0); }

// Between those edges; where it cannot be, its middle is. Needed is the middle alone.
void add_over(Case& placing, Case& proving, ItemId t, int axis, const Linear& low, const Linear& high, bool fits) {
  proving.require(mid2(t, axis) - 2 * low).require(2 * high - mid2(t, axis));
  if (fits) {
    placing.require(lo(t, axis) - low).require(high - hi(t, axis));
  } else {
    placing.require(mid2(t, axis) - 2 * low).require(2 * high - mid2(t, axis)).wish(mid2(t, axis) - low - high, 100, 2);
  }
}

void add_top(Formula& f, const PlacementModel& model, ItemId t, ItemId r) {
  const Item &item = model.items[t], &ref = model.items[r];
  Case c, outer;
  c.require_small(lo(t, 2) - hi(r, 2), 0);
  outer.require_small(lo(t, 2) - hi(r, 2), 0);
  const Size& size = ref.states[0].size;
  const bool within = fits(item, size.width, size.depth);
  for (int axis = 0; axis < 2; ++axis) {
    // Turned, it carries nothing in the corners of the box around it.
    const bool odd = ref.odd_states != 0;
    const Linear low = odd ? lo(r, axis) + constant_of(r, ref.footprint + axis) : lo(r, axis);
    const Linear high = odd ? lo(r, axis) + constant_of(r, ref.footprint + 2 + axis) : hi(r, axis);
    add_over(c, outer, t, axis, low, high, within);
  }
  c.price = price_of_height(size.height);
  f.cases.push_back(std::move(c));
  f.add_outer() = std::move(outer);
}

void add_space(Formula& f, const PlacementModel& model, ItemId t, ItemId r, const ItemSpace& space, bool inside) {
  const Item &item = model.items[t], &ref = model.items[r];
  Linear low[3], high[3];
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = lo(r, axis) + constant_of(r, space.quantity + axis);
    high[axis] = lo(r, axis) + constant_of(r, space.quantity + 3 + axis);
  }
  Case c, outer;
  for (Case* one : {&c, &outer}) {
    one->require_small(lo(t, 2) - low[2], 0);
    if (!space.open_above) one->require(high[2] - hi(t, 2));
    if (!inside) continue;  // more than half of it below the top, and no wider than its host
    one->require(5 * hi(r, 2) - 5 * lo(t, 2) - 3 * extent(t, 2));
    for (int axis = 0; axis < 2; ++axis) one->require(lo(t, axis) - lo(r, axis)).require(hi(r, axis) - hi(t, axis));
  }
  const std::vector<Mm>& sides = ref.states[0].constants;
  const int first = space.quantity - kFirstConstant;
  const bool within = fits(item, sides[first + 3] - sides[first], sides[first + 4] - sides[first + 1]);
  for (int axis = 0; axis < 2; ++axis) add_over(c, outer, t, axis, low[axis], high[axis], within);
  c.price = price_of_height(sides[first + 2]);
  f.cases.push_back(std::move(c));
  f.add_outer() = std::move(outer);
}

// Items that relations say t stands on or in.
std::vector<ItemId> hosts_named(const PlacementModel& model, ItemId t) {
  std::vector<ItemId> hosts;
  const auto add = [&](std::string_view id) {
    const ItemId host = model.find_item(id);
    if (host.exists() && model.items[host].is_opening() && model.items[host].opening->type != OpeningType::kWindow) return;  // no sill
    if (host.exists() && host != t && std::find(hosts.begin(), hosts.end(), host) == hosts.end()) hosts.push_back(host);
  };
  for (const Relation& relation : model.scene->relations) {
    const auto at = std::find(relation.targets.begin(), relation.targets.end(), model.items[t].id);
    if (at == relation.targets.end()) continue;
    if (traits_of(relation.type).rests) {
      for (const std::string& id : relation.references) add(id);
    }
    if (relation.type != RelationType::kStacked) continue;
    if (at != relation.targets.begin()) {
      add(*(at - 1));
    } else {
      for (const std::string& id : relation.references) add(id);
    }
  }
  return hosts;
}

// What is under a bench with compartments down to the floor is in one of these.
void add_compartments_above(Formula& f, const PlacementModel& model, ItemId t, ItemId r) {
  const Item& ref = model.items[r];
  if (ref.is_opening() || ref.states.empty()) return;
  for (const ItemSpace& s : ref.spaces) {
    const Mm floor = ref.states[0].constants[static_cast<std::size_t>(s.quantity - kFirstConstant) + 2];
    if (s.carries && floor <= kStillUnder) add_space(f, model, t, r, s, true);
  }
}

// Items that relations say t is under.
std::vector<ItemId> covers_named(const PlacementModel& model, ItemId t) {
  std::vector<ItemId> covers;
  for (const Relation& relation : model.scene->relations) {
    const auto& targets = relation.targets;
    if (relation.type != RelationType::kUnder || std::find(targets.begin(), targets.end(), model.items[t].id) == targets.end()) continue;
    for (const std::string& id : relation.references) {
      if (const ItemId r = model.find_item(id); r.exists() && r != t) covers.push_back(r);
    }
  }
  return covers;
}

std::vector<ItemId> usual_hosts(const PlacementModel& model, ItemId t) {
  std::vector<ItemId> hosts;
  for (const std::string& kind : model.items[t].entry->stands_on) {
    for (const ItemId i : model.items.ids()) {
      if (i != t && model.is_a(i, kind)) hosts.push_back(i);
    }
  }
  return hosts;
}

// What hard relations say that a thing stands directly on or in.
std::vector<std::string> holders_said(const SceneGraph& scene, const std::string& id) {
  std::vector<std::string> holders;
  for (const Relation& r : scene.relations) {
    const auto at = std::find(r.targets.begin(), r.targets.end(), id);
    if (!r.hard || at == r.targets.end()) continue;
    const bool first = r.type == RelationType::kStacked && at == r.targets.begin();
    if (traits_of(r.type).rests || first)
      holders.insert(holders.end(), r.references.begin(), r.references.end());
    else if (r.type == RelationType::kStacked)
      holders.push_back(*(at - 1));
  }
  return holders;
}

constexpr int kMostStoreys = 8;

bool rests_said(const SceneGraph& scene, const std::string& id, const std::string& holder, int storeys) {
  if (storeys > kMostStoreys) return false;
  const std::vector<std::string> holders = holders_said(scene, id);
  return std::any_of(holders.begin(), holders.end(), [&](const std::string& between) {
    return between == holder ? storeys > 0 : between != id && scene.find_object(between) && rests_said(scene, between, holder, storeys + 1);
  });
}

}  // namespace

bool rests_by_way_of_others(const SceneGraph& scene, const std::string& id, const std::string& holder) {
  return rests_said(scene, id, holder, 0);
}

void add_resting(Formula& f, const PlacementModel& model, ItemId t, ItemId r, const std::string& space, Resting how) {
  const Item& ref = model.items[r];
  if (model.items[t].mount == Mount::kHung && how == Resting::kOn) {
    add_hanging(f, model, t, r);
    return;
  }
  if (how != Resting::kTop) {
    for (const ItemSpace& s : ref.spaces) {
      if (!((space.empty() && s.carries) || s.name == space)) continue;
      add_space(f, model, t, r, s, how == Resting::kIn);
      if (how == Resting::kOn && !ref.is(Trait::kShelving) && is_low(ref, s)) f.cases.back().price += kLowPlace;
    }
  }
  if (how == Resting::kIn) return;
  const bool open_place = std::any_of(ref.spaces.begin(), ref.spaces.end(), [](const ItemSpace& s) { return s.carries && s.open_above; });
  if (how == Resting::kOn && !space.empty() && !f.cases.empty()) return;
  add_top(f, model, t, r);
  // The back of a sofa is no place to put things while there is a seat.
  if (how == Resting::kOn && open_place && !ref.entry->top_carries) f.cases.back().price += kUnlikelyTop;
}

void add_on_sill(Formula& f, const PlacementModel& model, ItemId t, ItemId window) {
  const Item& item = model.items[window];
  for_each_turn(item, [&](int turn, std::uint64_t states) {
    const Direction in = side_direction(item, Side::kFront, turn);
    Case& c = f.add().when(window, states);
    c.require_small(lo(t, 2) - lo(window, 2), 0);
    const Mm depth = item.opening->sill_depth > 0 ? item.opening->sill_depth : kSillDepthUsed;
    // Its centre over the sill, and its back not in the wall.
    c.require(gap_towards(t, window, in)).require(Linear(2 * depth) - in.sign * mid2(t, in.axis) + 2 * reach(window, in));
    c.require(lo(t, across(in)) - lo(window, across(in))).require(hi(window, across(in)) - hi(t, across(in)));
    c.wish(gap_towards(t, window, in), 100);
  });
}

Constraint compile_support(PlacementModel& model, ItemId t) {
  Item& item = model.items[t];
  Constraint out;
  out.name = "support of " + item.id;
  out.firmness = Firmness::kAlways;
  Formula& f = out.formulas.emplace_back();
  std::size_t outer_before = 0;
  const auto note = [&](SupportOption option, int price) {
    const bool exact = f.outer.size() == outer_before;  // what was added just now is meant exactly
    while (item.supports.size() < f.cases.size()) {
      f.cases[item.supports.size()].price += price;
      if (exact) f.outer.push_back(f.cases[item.supports.size()]);
      item.supports.push_back(option);
    }
    outer_before = f.outer.size();
  };
  using Kind = SupportOption::Kind;
  std::vector<ItemId> hosts = hosts_named(model, t);
  const bool on_rug_only = !hosts.empty() && std::all_of(hosts.begin(), hosts.end(), [&](ItemId h) { return model.items[h].thin; });
  if (on_rug_only) hosts.clear();
  const bool named = !hosts.empty();
  if (!named && (item.mount == Mount::kSurface || item.mount == Mount::kHung)) hosts = usual_hosts(model, t);
  for (const ItemId host : hosts) {
    if (model.items[host].thin) continue;
    if (model.items[host].is_opening()) {
      add_on_sill(f, model, t, host);
      note({Kind::kSill, host, {}, false}, 0);
    } else {
      add_resting(f, model, t, host, "", Resting::kOn);
      note({Kind::kItem, host, {}, item.mount != Mount::kHung}, 0);
    }
    if (!named || model.items[host].is_opening()) continue;
    // Also where only "on its top" was meant; and what usually hangs may lie in it.
    add_resting(f, model, t, host, "", item.mount == Mount::kHung ? Resting::kIn : Resting::kTop);
    note({Kind::kItem, host, {}, true}, 400);
  }
  for (const ItemId cover : covers_named(model, t)) {
    const std::size_t known = f.cases.size();
    add_compartments_above(f, model, t, cover);
    if (f.cases.size() > known) note({Kind::kItem, cover, {}, true}, 0);
  }
  const int otherwise = named ? 4000 : hosts.empty() ? 0 : 1500;
  const auto add_mount = [&](Mount mount, int price) {
    if (mount == Mount::kWall) {
      for (const WallId w : model.walls.ids()) {
        add_against(f, model, t, states_with_back_to(item, model.walls[w]), model.walls[w], 0, true);
        note({Kind::kWall, {}, w, false}, price);
      }
    } else if (mount == Mount::kCeiling) {
      f.add().require_small(hi(t, 2) - Linear(model.room.hi[2]), 0);
      note({Kind::kCeiling, {}, {}, false}, price);
    } else {
      f.add().require_small(lo(t, 2) - Linear(model.room.lo[2]), 0);
      note({Kind::kFloor, {}, {}, false}, price);
    }
  };
  add_mount(item.mount, otherwise);
  // What only a relation hangs up stands as usual once that is given up.
  if (item.usual_mount != item.mount) add_mount(item.usual_mount, 4000);
  const bool hangs = item.mount == Mount::kWall || item.mount == Mount::kCeiling;
  if (hangs && item.usual_mount == item.mount && item.object->mount_assumed) add_mount(Mount::kFloor, kUnlikeItsKind);
  f.exact = false;
  return out;
}

}  // namespace layoutbox::placement
