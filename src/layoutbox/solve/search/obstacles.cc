#include "layoutbox/solve/search/obstacles.h"

#include "layoutbox/solve/model/slanted.h"
#include "layoutbox/solve/model/whole_division.h"

namespace layoutbox::placement {
namespace {

constexpr int kLinesAcross = 14;    // of a region that is cut slantwise
constexpr Mm kBetweenOpenings = 2;  // openings have no depth

GridBox around(const GridBox& a, const GridBox& b) {
  GridBox both;
  for (int k = 0; k < 3; ++k) both.lo[k] = std::min(a.lo[k], b.lo[k]), both.hi[k] = std::max(a.hi[k], b.hi[k]);
  return both;
}

// Some position of the region lies inside the box.
bool concerns(const GridBox& inside, const Region& region) {
  for (int k = 0; k < 3; ++k) {
    if (inside.lo[k] >= region.hi[k] || region.lo[k] >= inside.hi[k]) return false;
  }
  return true;
}

// What of the line the checks of the region leave; false: nothing.
bool narrow(const Region& region, int b, const Vec3& at, Mm& from, Mm& to) {
  for (const Reduced* one : region.cases) {
    for (const Partial& check : one->checks) {  // coefficient · x + rest ≥ 0
      Vec3 start = at;
      start[b] = 0;
      const std::int64_t rest = check.at(start), by = check.coefficient[b];
      if (by == 0 && rest < 0) return false;
      if (by > 0) from = static_cast<Mm>(std::max<std::int64_t>(from, ceil_div(-rest, by)));
      if (by < 0) to = static_cast<Mm>(std::min<std::int64_t>(to, floor_div(rest, -by)));
      if (from > to) return false;
    }
  }
  return true;
}

}  // namespace

Obstacles::Obstacles(const PlacementModel& model, const RegionFinder& regions) : model_(model), regions_(regions) {
  for (const Item& item : model.items) {
    first_state_.push_back(reach_.size());
    for (const State& state : item.states) {
      GridBox all{{0, 0, 0}, state.extent};
      for (const GridBox& clear : state.clear) all = around(all, clear);
      reach_.push_back(all);
    }
  }
}

bool Obstacles::within_stripes(const Forbidden& f, const Vec3& at) const {
  const auto stripes = stripes_of(f);
  return std::all_of(stripes.begin(), stripes.end(),
                     [&](const Stripe& s) { return std::abs(2 * (s.x * at[0] + s.y * at[1]) + s.constant) < s.half; });
}

bool Obstacles::is_free(const Vec3& at) const {
  return std::none_of(forbidden_.begin(), forbidden_.end(), [&](const Forbidden& f) { return holds(f, at); });
}

std::span<const Obstacles::Forbidden* const> Obstacles::across(const Vec3& at) {
  if (!across_known_ || across_y_ != at[1] || across_z_ != at[2]) {
    across_known_ = true, across_y_ = at[1], across_z_ = at[2];
    across_.clear();
    for (const Forbidden& f : forbidden_) {
      if (f.lo[1] < at[1] && at[1] < f.hi[1] && f.lo[2] < at[2] && at[2] < f.hi[2]) across_.push_back(&f);
    }
  }
  return across_;
}

void Obstacles::add_stripes(Forbidden& f, const Placements& placements, ItemId item, int state, const Piece& mine, const Piece& theirs) {
  const Placement& there = placements[f.owner];
  const auto reach_of_piece = [&](ItemId of, int in, const Piece& piece, int heading) {
    const Item& owner = model_.items[of];
    return owner.is_opening() ? reach_of(piece.box, model_.headings[heading]) : reach_of(model_, owner, in, piece.solid, heading);
  };
  f.first_stripe = static_cast<int>(stripes_.size());
  for (std::size_t k = 0; k < model_.headings.size(); ++k) {
    const Heading& h = model_.headings[k];
    const Reach a = reach_of_piece(item, state, mine, static_cast<int>(k));
    const Reach b = reach_of_piece(f.owner, there.state, theirs, static_cast<int>(k));
    const std::int64_t middle = 2 * (std::int64_t{h.x} * there.at[0] + std::int64_t{h.y} * there.at[1]) + b.middle2;
    stripes_.push_back({h.x, h.y, a.middle2 - middle, a.span + b.span});
    ++f.stripes;
  }
}

void Obstacles::add_pair(const Placements& placements, ItemId item, int state, ItemId other, const Region& region) {
  const PairRule rule = model_.pair(item, other);
  const Item &self = model_.items[item], &them = model_.items[other];
  if (rule == PairRule::kFree || (self.fixed && them.fixed)) return;
  const Placement& there = placements[other];
  const State &own = self.states[state], &theirs = them.states[there.state];
  const bool any_opening = self.is_opening() || them.is_opening();
  const bool turned = rule != PairRule::kOpenings && !model_.headings.empty() && (!is_quarter(own) || !is_quarter(theirs));
  // Both from the low corner of who owns them.
  const auto add = [&](const Piece& mine, const Piece& theirs_there, Mm more) {
    Forbidden f;
    const GridBox body = theirs_there.box.shifted(there.at);
    for (int k = 0; k < 3; ++k) f.lo[k] = body.lo[k] - mine.box.hi[k], f.hi[k] = body.hi[k] - mine.box.lo[k];
    for (int k = 0; k < 2; ++k) f.lo[k] -= more, f.hi[k] += more;
    if (!concerns({f.lo, f.hi}, region)) return;
    f.owner = other;
    if (turned) add_stripes(f, placements, item, state, mine, theirs_there);
    forbidden_.push_back(f);
  };
  const Piece whole{{{0, 0, 0}, own.extent}}, box{{{0, 0, 0}, theirs.extent}};
  if (rule == PairRule::kOpenings) {
    add(whole, box, kBetweenOpenings);
  } else if (any_opening) {
    if (regions_.clearance_off(self) || regions_.clearance_off(them)) return;
    for (const GridBox& clear : own.clear) add({clear}, box, 0);
    for (const GridBox& clear : theirs.clear) add(whole, {clear}, 0);
  } else if (rule == PairRule::kBoxes) {
    add(whole, box, 0);
  } else {
    for (std::size_t i = 0; i < own.solids.size(); ++i) {
      for (std::size_t j = 0; j < theirs.solids.size(); ++j)
        add({own.solids[i], static_cast<int>(i)}, {theirs.solids[j], static_cast<int>(j)}, 0);
    }
  }
}

void Obstacles::gather(const Placements& placements, ItemId item, int state, const Region& region) {
  forbidden_.clear();
  stripes_.clear();
  across_known_ = false;
  const Item& self = model_.items[item];
  if (!self.is_opening() && !self.fixed) {
    const Vec3& e = self.states[state].extent;
    for (const GridBox& outside : model_.off_limits) {
      const GridBox inside{{outside.lo[0] - e[0], outside.lo[1] - e[1], outside.lo[2] - e[2]}, outside.hi};
      if (concerns(inside, region)) forbidden_.push_back({inside.lo, inside.hi});
    }
  }
  GridBox whole = reach(item, state);  // wherever in the region it is
  for (int k = 0; k < 3; ++k) {
    const Mm more = k < 2 ? kBetweenOpenings : 1;
    whole.lo[k] += region.lo[k] - more, whole.hi[k] += region.hi[k] + more;
  }
  for (const ItemId other : placements.ids()) {
    const Placement& there = placements[other];
    if (there.state < 0 || other == item || !overlap(whole, reach(other, there.state).shifted(there.at))) continue;
    add_pair(placements, item, state, other, region);
  }
}

// What of the line along axis `b` lies in it, open at both ends; false: nothing.
bool Obstacles::along(const Forbidden& f, int b, Mm line, Mm& from, Mm& to) const {
  const int a = 1 - b;
  if (!(f.lo[a] < line && line < f.hi[a])) return false;
  from = f.lo[b], to = f.hi[b];
  for (const Stripe& stripe : stripes_of(f)) {  // −half < 2·p·x + q < half
    const std::int64_t p = 2 * (b == 0 ? stripe.x : stripe.y), q = 2 * (a == 0 ? stripe.x : stripe.y) * line + stripe.constant;
    if (p == 0) {
      if (std::abs(q) >= stripe.half) return false;
      continue;
    }
    const std::int64_t first = p > 0 ? -stripe.half - q : q - stripe.half, last = p > 0 ? stripe.half - q : q + stripe.half,
                       by = std::abs(p);
    from = static_cast<Mm>(std::max<std::int64_t>(from, floor_div(first, by)));
    to = static_cast<Mm>(std::min<std::int64_t>(to, ceil_div(last, by)));
  }
  return from + 1 < to;
}

// Along one line: from its beginning past everything that is in the way.
bool Obstacles::sweep_line(const Region& region, const Sweep& how, Vec3& at) const {
  const int a = how.outer, b = 1 - a;
  const bool down = how.down[1];
  Mm first = region.lo[b], last = region.hi[b];
  if (!narrow(region, b, at, first, last)) return false;
  at[b] = down ? last : first;
  for (bool moved = true; moved;) {
    moved = false;
    for (const Forbidden* f : near_) {
      Mm from = f->lo[b], to = f->hi[b];
      const bool inside = f->stripes == 0 ? f->lo[a] < at[a] && at[a] < f->hi[a] : along(*f, b, at[a], from, to);
      if (!inside || !(from < at[b] && at[b] < to)) continue;
      at[b] = down ? from : to;
      moved = true;
    }
    if (at[b] < first || at[b] > last) return false;
  }
  return true;
}

// Notes what is in the way at that height, and the lines worth trying: the edges of all that.
void Obstacles::line_up(const Region& region, const Sweep& how, Mm z) {
  const int a = how.outer;
  near_.clear();
  lines_.assign({region.lo[a], region.hi[a]});
  for (const Forbidden& f : forbidden_) {
    if (!(f.lo[2] < z && z < f.hi[2])) continue;
    near_.push_back(&f);
    for (const Mm line : {f.lo[a], f.hi[a]}) {
      if (line > region.lo[a] && line < region.hi[a]) lines_.push_back(line);
    }
  }
  const bool slantwise = std::any_of(region.cases.begin(), region.cases.end(), [](const Reduced* one) { return !one->checks.empty(); });
  for (int k = 1; slantwise && k < kLinesAcross; ++k)
    lines_.push_back(region.lo[a] + static_cast<Mm>(std::int64_t{region.hi[a] - region.lo[a]} * k / kLinesAcross));
  std::sort(lines_.begin(), lines_.end());
  lines_.erase(std::unique(lines_.begin(), lines_.end()), lines_.end());
  if (how.down[0]) std::reverse(lines_.begin(), lines_.end());
}

bool Obstacles::sweep(const Region& region, const Sweep& how, Vec3& at, Budget& budget) {
  Sweep lines = how;
  const auto flat = [&](int axis) { return region.lo[axis] == region.hi[axis]; };
  if (flat(1 - lines.outer) && !flat(lines.outer)) lines.outer = 1 - lines.outer;  // one line instead of many points
  for (const Mm z : {region.lo[2], region.hi[2]}) {
    at[2] = z;
    line_up(region, lines, z);
    for (const Mm line : lines_) {
      at[lines.outer] = line;
      budget.count(1 + static_cast<std::int64_t>(near_.size()) / 16);
      if (sweep_line(region, lines, at)) return true;
    }
    if (region.hi[2] == region.lo[2]) break;
  }
  return false;
}

}  // namespace layoutbox::placement
