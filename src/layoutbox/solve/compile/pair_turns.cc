// Relations between two objects: how they are turned to one another, and whose edges are in line.
#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {
namespace {

// After how many degrees it looks the same again: without a front after half a turn, and where it is square after a quarter.
int period_of(const Item& item, const State& state) {
  if (item.is_opening()) return 180;
  if (item.has_front) return 360;
  return state.size.width == state.size.depth ? 90 : 180;
}

// The states of t that are turned by `first` degrees, or by that and a multiple of `step`, against something that looks the same after
// `period` and is turned by `ref_turn`.
std::uint64_t states_turned(const Item& t, int ref_turn, int period, int first, int step) {
  std::uint64_t mask = 0;
  for (std::size_t s = 0; s < t.states.size(); ++s) {
    const int modulus = std::min({step, period, period_of(t, t.states[s])});
    if ((t.states[s].turn - ref_turn - first) % modulus == 0) mask |= std::uint64_t{1} << s;
  }
  return mask;
}

void turned_each(Compilation& c, int first, int step) {
  for (const ItemId t : c.targets) {
    for (const Reference& r : c.references) {
      Formula& f = c.formula();
      if (r.kind == Reference::Kind::kWall) {
        const RoomWall& wall = c.model.walls[r.wall];
        if (!wall.straight) f.exact = false;
        const std::uint64_t mask = wall.straight ? states_turned(c.item(t), wall.turn, 180, first, step)
                                                 : states_at_angle(c.item(t), wall.angle + first, std::min(step, 180));
        if (mask) f.add().when(t, mask);
      }
      if (r.kind != Reference::Kind::kItem) continue;
      const Item& ref = c.item(r.item);
      for (std::size_t s = 0; s < ref.states.size(); ++s) {
        const std::uint64_t mask = states_turned(c.item(t), ref.states[s].turn, period_of(ref, ref.states[s]), first, step);
        if (!mask) continue;
        // Cases of one mask are one case.
        const auto same = std::find_if(f.cases.begin(), f.cases.end(), [&](const Case& one) { return one.states[1].states == mask; });
        if (same != f.cases.end()) {
          same->states[0].states |= std::uint64_t{1} << s;
        } else {
          f.add().when(r.item, std::uint64_t{1} << s).when(t, mask);
        }
      }
    }
  }
}

// Of a thing's own frame; none for the middles, and for edges that scenes may not name here.
std::optional<Side> side_of(Edge edge) {
  switch (edge) {
    case Edge::kFront: return Side::kFront;
    case Edge::kBack: return Side::kBack;
    case Edge::kLeft: return Side::kLeft;
    case Edge::kRight: return Side::kRight;
    default: return std::nullopt;
  }
}

}  // namespace

void compile_EdgeAlign(Compilation& c) {
  const Edge edge = or_default(c.relation, &RelationParameters::edge);
  const std::optional<Side> side = side_of(edge);
  for (const ItemId t : c.targets) {
    for (const ItemId r : c.reference_items()) {
      Formula& f = c.formula();
      if (!side && edge != Edge::kCenter) continue;  // nothing has such an edge
      for_each_turn(c.item(r), [&](int turn, std::uint64_t states) {
        Case& in = f.add().when(r, states);
        if (edge == Edge::kCenter) {
          const int axis = side_direction(c.item(r), Side::kRight, turn).axis;
          in.require_small(mid2(t, axis) - mid2(r, axis), 1);
          return;
        }
        const Direction d = side_direction(c.item(r), *side, turn);
        in.require_small(reach(t, d) - reach(r, d), 0);
      });
    }
  }
}

void compile_Facing(Compilation& c) {
  for (const ItemId t : c.targets) {
    const Side eyes = looking_side(c.model, t);
    for (const Reference& r : c.references) {
      Formula& f = c.formula();
      if (r.kind == Reference::Kind::kItem) add_looks_at(f, c.model, t, r.item, eyes);
      if (r.kind == Reference::Kind::kWall) add_looks_at_wall(f, c.model, t, c.model.walls[r.wall], eyes);
      const GridBox& room = c.model.room;
      if (r.kind == Reference::Kind::kRoom) {
        add_looks_at_point(f, c.model, t, {(room.lo[0] + room.hi[0]) / 2, (room.lo[1] + room.hi[1]) / 2}, eyes);
      }
      if (!c.item(t).entry->has_front) f.exact = false, f.outer.clear();  // its long side should look there and need not
    }
  }
}

void compile_Parallel(Compilation& c) { turned_each(c, 0, 180); }
void compile_Perpendicular(Compilation& c) { turned_each(c, 90, 180); }
void compile_SameOrientation(Compilation& c) { turned_each(c, 0, 360); }

}  // namespace layoutbox::placement
