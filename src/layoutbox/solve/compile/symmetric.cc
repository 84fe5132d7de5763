// Things as mirror images of one another.
#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {
namespace {

// All ways to pair things up, each with another or with itself.
void add_pairings(std::vector<std::size_t>& partner, std::vector<std::vector<std::size_t>>& out) {
  const auto free = std::find(partner.begin(), partner.end(), partner.size());
  if (free == partner.end()) {
    out.push_back(partner);
    return;
  }
  const auto i = static_cast<std::size_t>(free - partner.begin());
  for (std::size_t j = i; j < partner.size(); ++j) {
    if (partner[j] != partner.size()) continue;
    partner[i] = j, partner[j] = i;
    add_pairings(partner, out);
    partner[i] = partner[j] = partner.size();
  }
}

std::vector<std::vector<std::size_t>> pairings(std::size_t n) {
  std::vector<std::vector<std::size_t>> out;
  if (n > 5) {  // first with last, and so on
    std::vector<std::size_t>& one = out.emplace_back(n);
    for (std::size_t i = 0; i < n; ++i) one[i] = n - 1 - i;
    return out;
  }
  std::vector<std::size_t> partner(n, n);
  add_pairings(partner, out);
  return out;
}

// The pairs of one way lie as mirror images about the middle of a place, so far off at most.
Case mirrored(const Compilation& c, Case in, const std::vector<std::size_t>& partner, const Place& place, int axis, Mm off) {
  for (std::size_t i = 0; i < partner.size(); ++i) {
    const ItemId a = c.targets[i], b = c.targets[partner[i]];
    if (partner[i] < i) continue;
    in.require_small(mid2(a, axis) + mid2(b, axis) - 2 * (place.lo[axis] + place.hi[axis]), off);
    if (a != b) in.require_small(mid2(a, 1 - axis) - mid2(b, 1 - axis), off);
  }
  return in;
}

void add_mirrored(Formula& f, const Compilation& c, const Case& base, const Place& place, int axis) {
  constexpr Mm kPlacing = 14, kProving = 40;
  const std::size_t n = c.targets.size();
  for (const std::vector<std::size_t>& partner : pairings(n)) {
    f.cases.push_back(mirrored(c, base, partner, place, axis, kPlacing));
    if (n <= 2) f.outer.push_back(mirrored(c, base, partner, place, axis, kProving));
  }
}

}  // namespace

void compile_SymmetricAbout(Compilation& c) {
  const bool along_y = c.relation.parameters.axis == Axis::kY;
  for (const Reference& r : c.references) {
    Formula& f = c.formula();
    if (r.kind == Reference::Kind::kRoom) continue;
    f.exact = false;  // two may share one mirror image
    const Place place = c.place(r);
    if (r.kind == Reference::Kind::kWall) {
      const RoomWall& wall = c.model.walls[r.wall];
      if (wall.straight) add_mirrored(f, c, {}, place, along_y ? wall.normal() : wall.along);
      continue;
    }
    const Side along = along_y ? Side::kBack : Side::kRight;
    for_each_turn(c.item(r.item), [&](int turn, std::uint64_t states) {
      Case base;
      base.when(r.item, states);
      add_mirrored(f, c, base, place, side_direction(c.item(r.item), along, turn).axis);
    });
  }
}

}  // namespace layoutbox::placement
