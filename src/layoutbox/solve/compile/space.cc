// Relations about free floor. What is linear is posted; what is not (a way to walk) is checked on each layout (walk.h).
#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {

namespace {

// The scene says that the other stands at t: a chair under its desk.
bool belongs_to(const PlacementModel& model, ItemId other, ItemId t) {
  const auto has = [](const std::vector<std::string>& ids, const std::string& id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  return std::any_of(model.scene->relations.begin(), model.scene->relations.end(), [&](const Relation& r) {
    return traits_of(r.type).brings && has(r.targets, model.items[other].id) && has(r.references, model.items[t].id);
  });
}

bool may_rest_on(const Item& item, ItemId host) {
  return std::any_of(item.supports.begin(), item.supports.end(),
                     [&](const SupportOption& s) { return s.kind == SupportOption::Kind::kItem && s.item == host; });
}

constexpr Mm kStandingRoom = 2000;

// The floor beyond one side of t, in the states given.
void add_free_floor(Compilation& c, ItemId t, Side side, Mm depth, std::uint64_t in_states) {
  const Item& item = c.item(t);
  // The strip as edges: from the side outward, as wide as the side.
  const auto each_strip = [&](Formula& f, const std::function<void(const Case&, Direction)>& add) {
    if (in_states != item.all_states) f.add().when(t, item.all_states & ~in_states);
    for_each_turn(item, [&](int turn, std::uint64_t states) {
      Case c_turn;
      if (states & in_states) add(c_turn.when(t, states & in_states), side_direction(item, side, turn));
    });
  };
  Formula& room = c.formula();
  each_strip(room, [&](const Case& base, Direction d) {
    const Mm edge = d.sign > 0 ? c.model.room.hi[d.axis] : -c.model.room.lo[d.axis];
    Case one = base;
    room.cases.push_back(one.require(Linear(edge - depth) - reach(t, d)));
  });
  const auto keep_off = [&](const Place& other, bool high) {
    Formula& f = c.formula();
    each_strip(f, [&](const Case& base, Direction d) {
      const Direction across_it{across(d), 1};
      const auto add = [&](const Linear& form) {
        Case one = base;
        f.cases.push_back(one.require(form));
      };
      const auto near_edge = [&](Direction way) { return way.sign > 0 ? other.lo[way.axis] : -1 * other.hi[way.axis]; };
      const auto far_edge = [&](Direction way) { return way.sign > 0 ? other.hi[way.axis] : -1 * other.lo[way.axis]; };
      add(near_edge(d) - reach(t, d) - Linear(depth));
      add(reach(t, d) - far_edge(d));
      add(near_edge(across_it) - reach(t, across_it));
      add(near_edge(opposite(across_it)) - reach(t, opposite(across_it)));
      if (high) add(other.lo[2] - Linear(kStandingRoom));
    });
  };
  for (const GridBox& outside : c.model.outside) {
    Place wall;
    for (int axis = 0; axis < 3; ++axis) wall.lo[axis] = outside.lo[axis], wall.hi[axis] = outside.hi[axis];
    keep_off(wall, false);
  }
  for (const ItemId other : c.model.items.ids()) {
    const Item& body = c.item(other);
    if (other == t || body.is_opening() || body.thin || belongs_to(c.model, other, t)) continue;
    keep_off(place_of(other), true);
    if (may_rest_on(body, t)) c.out.formulas.back().exact = false;  // on t it does not count, even where it hangs over
  }
}

}  // namespace

void compile_Clearance(Compilation& c) {
  const Side named = or_default(c.relation, &RelationParameters::side);
  for (const ItemId t : c.targets) {
    const Item& item = c.item(t);
    for (const Side side : {Side::kFront, Side::kBack, Side::kLeft, Side::kRight}) {
      const std::uint64_t states = states_where(item, side, named);
      if (!states) continue;
      const auto usual = item.entry->clearance.find(side);
      const Mm otherwise = usual == item.entry->clearance.end() ? 600 : usual->second;
      add_free_floor(c, t, side, c.relation.parameters.depth.value_or(otherwise), states);
    }
  }
}

// Not linear: looked at on each layout (cost.h).
void compile_Reachable(Compilation& c) {
  for (const ItemId t : c.targets) c.out.reach.emplace_back(t, c.length(&RelationParameters::width));
}

void compile_KeepClear(Compilation& c) {
  const std::optional<RoomRegion>& region = c.relation.parameters.region;
  bool openings = false;
  for (const ItemId t : c.targets) {
    for (const Reference& r : c.references) {
      if (r.kind == Reference::Kind::kItem && c.item(r.item).is_opening()) {
        openings = true;
      } else if (r.kind != Reference::Kind::kRoom) {
        add_band(c.formula(), c.model, t, c.place(r), c.relation.parameters.depth.value_or(600), std::nullopt, 0);
      } else {
        c.never();
      }
    }
    if (!c.references.empty()) continue;
    Formula& f = c.formula();  // beside one of the edges of that part
    if (!region) continue;
    const bool middle = region == RoomRegion::kMiddle;
    for (int axis = 0; axis < 2; ++axis) {
      const std::int64_t from = c.model.room.lo[axis], span = c.model.room.extent(axis);
      const bool lower = lies_at(*region, axis == 0 ? Side::kLeft : Side::kFront);
      const bool upper = lies_at(*region, axis == 0 ? Side::kRight : Side::kBack);
      const std::int64_t first = middle || upper ? (middle ? 1 : 2) : 0, last = middle || lower ? (middle ? 2 : 1) : 3;
      f.add().require(3 * lo(t, axis) - Linear(3 * from + last * span));
      f.add().require(Linear(3 * from + first * span) - 3 * hi(t, axis));
    }
  }
  if (openings) compile_NotBlocking(c);
}

}  // namespace layoutbox::placement
