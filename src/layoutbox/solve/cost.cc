#include "layoutbox/solve/cost.h"

namespace layoutbox::placement {
namespace {

constexpr std::int64_t kPoint = 1000;
constexpr Mm kBodyReach = 2000;  // what begins higher is in nobody's way
constexpr Mm kHalfPerson = 100;
constexpr Mm kWideWay = 600;             // what building codes and handbooks ask of a way within a room
constexpr Mm kBesideStrip = 200;         // from the strip at a used side to where somebody's middle is
constexpr std::int64_t kGreat = 400000;  // mm²: seats and bedside tables have their own ways
constexpr Mm kArmLength = 150;           // how near one must come to a door or a thing

}  // namespace

std::int64_t constraint_cost(const Model& model, const Constraint& constraint, const Placements& placements) {
  const bool soft = constraint.firmness == Firmness::kSoft;
  std::int64_t sum = 0;
  for (const Formula& formula : constraint.formulas) {
    std::int64_t best = std::numeric_limits<std::int64_t>::max() / 4;
    for (const Case& one : formula.cases) {
      std::int64_t miss = 0;
      for (const StateLiteral& literal : one.states) {
        if (!(literal.states >> placements[literal.item].state & 1)) miss = kStateMiss;
      }
      for (const Linear& form : one.at_least_zero) miss = std::max(miss, missing(value_of(model, form, placements), form.scale));
      if (!soft && miss > 0) continue;
      std::int64_t cost = one.price * kPoint + miss * constraint.weight;
      for (const Preference& wish : one.wishes) {
        if (cost >= best) break;
        cost += std::abs(value_of(model, wish.form, placements)) * wish.weight / wish.scale;
      }
      best = std::min(best, cost);
    }
    if (best < std::numeric_limits<std::int64_t>::max() / 4) sum += best;
  }
  return sum;
}

bool blocks_floor(const Item& item, const Box& box) {
  return !item.is_opening() && !item.thin && (box.lo[2] + box.hi[2]) / 2 <= kBodyReach;
}

namespace {

// Seats round a table that is used from all sides are not in its way: they are how it is used.
bool sits_round(const Model& model, int seat, int table) {
  const Item &s = model.items[seat], &t = model.items[table];
  if (!s.entry || !t.entry || model.pair(seat, table) != PairRule::kSolids || t.entry->back_to_wall) return false;
  const std::string& family = s.entry->shape.family;
  const bool is_seat = family == "chair" || family == "office_chair" || family == "stool" || family == "armchair" || family == "bench";
  return is_seat && std::any_of(t.spaces.begin(), t.spaces.end(), [](const ItemSpace& space) { return !space.carries; });
}

}  // namespace

bool surely_blocks(const Model& model, int body, int owner) {
  const Item& item = model.items[body];
  const bool on_floor = item.supports.size() == 1 && item.supports[0].kind == SupportOption::Kind::kFloor;
  const auto low = [](const State& state) { return state.extent[2] <= 2 * kBodyReach; };
  return on_floor && !item.is_opening() && !item.thin && !sits_round(model, body, owner) &&
         std::all_of(item.states.begin(), item.states.end(), low);
}

std::int64_t blocked_permille(const Model& model, const Box& strip, const Placements& placements, int owner, int except) {
  const std::int64_t area = floor_area(strip);
  if (area == 0) return 0;
  std::int64_t blocked =
      area - floor_area(intersection(strip, {{model.room.lo[0], model.room.lo[1], 0}, {model.room.hi[0], model.room.hi[1], 1 << 20}}));
  const auto add = [&](const Box& body) {
    if (overlap_in_plan(strip, body))
      blocked += floor_area(intersection({{strip.lo[0], strip.lo[1], 0}, {strip.hi[0], strip.hi[1], 1}},
                                         {{body.lo[0], body.lo[1], 0}, {body.hi[0], body.hi[1], 1}}));
  };
  for (const Box& wall : model.outside) add(wall);
  for (std::size_t j = 0; j < model.items.size(); ++j) {
    const int other = static_cast<int>(j);
    if (other == owner || other == except || placements[j].state < 0 || sits_round(model, other, owner)) continue;
    const Box body = box_of(model.items[j], placements[j]);
    if (blocks_floor(model.items[j], body)) add(body);
  }
  return std::min<std::int64_t>(1000, blocked * 1000 / area);
}

Mm intrusion_of(const Model& model, int opening, const Placements& placements) {
  const Placement& p = placements[opening];
  Mm deepest = 0;
  for (const Box& clear : model.items[opening].states[p.state].clear) {
    const Box here = clear.shifted(p.at);
    for (std::size_t j = 0; j < model.items.size(); ++j) {
      const int other = static_cast<int>(j);
      if (placements[j].state < 0 || model.items[j].is_opening() || model.pair(opening, other) == PairRule::kFree) continue;
      const Box shared = intersection(here, box_of(model.items[j], placements[j]));
      if (overlaps_box(model, model.items[j], placements[j], here))
        deepest = std::max(deepest, std::min({shared.extent(0), shared.extent(1), shared.extent(2)}));
    }
  }
  return deepest;
}

std::int64_t access_cost_of(const Model& model, int item, const Placements& placements, int except) {
  const Item& self = model.items[item];
  const Placement& p = placements[item];
  if (self.is_opening()) return except >= 0 ? 0 : std::int64_t{intrusion_of(model, item, placements)} * kCostWeights.swing;
  if (self.thin || p.at[2] > 50) return 0;
  const State& state = self.states[p.state];
  std::int64_t cost = 0;
  if (!state.strips.empty()) {
    std::int64_t best = 1000;
    for (const Box& strip : state.strips) best = std::min(best, blocked_permille(model, strip.shifted(p.at), placements, item, except));
    cost += best * kCostWeights.access;
  }
  for (const Box& wanted : state.wanted)
    cost += blocked_permille(model, wanted.shifted(p.at), placements, item, except) * kCostWeights.wanted;
  return cost;
}

namespace {

class WalkRaster {
 public:
  // `whole`: everything that begins below standing height is in the way, else only what has its middle there.
  WalkRaster(const Model& model, const Placements& placements, Mm half_person, bool whole = false, Mm finest = 25)
      : model_(model), half_(half_person) {
    const Mm longest = std::max(model.room.extent(0), model.room.extent(1));
    step_ = std::max<Mm>(finest, longest * finest / 4000);
    columns_ = model.room.extent(0) / step_ + 1, rows_ = model.room.extent(1) / step_ + 1;
    free_.assign(static_cast<std::size_t>(columns_) * rows_, 1);
    const Box& r = model.room;
    block({{r.lo[0] - 1000, r.lo[1] - 1000, 0}, {r.lo[0], r.hi[1] + 1000, 0}});
    block({{r.hi[0], r.lo[1] - 1000, 0}, {r.hi[0] + 1000, r.hi[1] + 1000, 0}});
    block({{r.lo[0], r.lo[1] - 1000, 0}, {r.hi[0], r.lo[1], 0}});
    block({{r.lo[0], r.hi[1], 0}, {r.hi[0], r.hi[1] + 1000, 0}});
    for (const Box& outside : model.outside) block(outside);
    for (std::size_t i = 0; i < model.items.size(); ++i) {
      if (placements[i].state < 0) continue;
      const Box box = box_of(model.items[i], placements[i]);
      const Item& item = model.items[i];
      if (whole ? !item.is_opening() && !item.thin && box.lo[2] < kBodyReach : blocks_floor(item, box)) block(box);
    }
  }

  // A box grown by half a person; cells are points.
  void block(const Box& box) {
    const int x0 = cell(box.lo[0] - half_ - model_.room.lo[0], true), x1 = cell(box.hi[0] + half_ - model_.room.lo[0], false);
    const int y0 = cell(box.lo[1] - half_ - model_.room.lo[1], true), y1 = cell(box.hi[1] + half_ - model_.room.lo[1], false);
    for (int y = std::max(0, y0); y <= std::min(rows_ - 1, y1); ++y) {
      for (int x = std::max(0, x0); x <= std::min(columns_ - 1, x1); ++x) free_[static_cast<std::size_t>(y) * columns_ + x] = 0;
    }
  }

  // Is there a way from one of the places `from` to one of `to`? Empty `from`: from anywhere.
  bool way(const std::vector<Box>& from, const std::vector<Box>& to) {
    const std::vector<char> free = free_;
    std::vector<int> stack;
    for (const Box& box : from) {
      for (const int start : cells_in(box)) {
        if (free_[start]) flood(start, stack);
      }
    }
    for (const Box& box : to) {
      const std::vector<int> goal = cells_in(box);
      if (std::any_of(goal.begin(), goal.end(), [&](int at) { return free[at] && (from.empty() || !free_[at]); })) return true;
    }
    return false;
  }

  // Takes away all that can be walked to from these places; `untouched` then tells whether a place is none of it.
  void walk_from(const std::vector<Box>& places) {
    before_ = free_;
    std::vector<int> stack;
    for (const Box& box : places) {
      for (const int start : cells_in(box)) {
        if (free_[start]) flood(start, stack);
      }
    }
  }
  bool untouched(const Box& place) const {
    const std::vector<int> cells = cells_in(place);
    return std::none_of(cells.begin(), cells.end(), [&](int at) { return before_[at] && !free_[at]; });
  }

  int largest_permille() {
    int total = 0, largest = 0;
    for (const char f : free_) total += f;
    if (total == 0) return 0;
    std::vector<int> stack;
    for (std::size_t start = 0; start < free_.size(); ++start) {
      if (!free_[start]) continue;
      largest = std::max(largest, flood(static_cast<int>(start), stack));
    }
    return static_cast<int>(std::int64_t{largest} * 1000 / total);
  }

 private:
  int cell(Mm along, bool up) const { return up ? (along + step_ - 1 + 100 * step_) / step_ - 100 : (along + 100 * step_) / step_ - 100; }

  std::vector<int> cells_in(const Box& box) const {
    std::vector<int> cells;
    const int x0 = std::max(0, cell(box.lo[0] - model_.room.lo[0], true)),
              x1 = std::min(columns_ - 1, cell(box.hi[0] - model_.room.lo[0], false));
    const int y0 = std::max(0, cell(box.lo[1] - model_.room.lo[1], true)),
              y1 = std::min(rows_ - 1, cell(box.hi[1] - model_.room.lo[1], false));
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) cells.push_back(y * columns_ + x);
    }
    return cells;
  }

  int flood(int start, std::vector<int>& stack) {
    int size = 0;
    free_[start] = 0;
    stack.assign(1, start);
    while (!stack.empty()) {
      const int at = stack.back();
      stack.pop_back();
      ++size;
      const int x = at % columns_, y = at / columns_;
      const auto visit = [&](int nx, int ny) {
        if (nx < 0 || ny < 0 || nx >= columns_ || ny >= rows_) return;
        const int next = ny * columns_ + nx;
        if (!free_[next]) return;
        free_[next] = 0;
        stack.push_back(next);
      };
      visit(x - 1, y), visit(x + 1, y), visit(x, y - 1), visit(x, y + 1);
    }
    return size;
  }

  const Model& model_;
  Mm half_;
  Mm step_ = 25;
  int columns_ = 0, rows_ = 0;
  std::vector<char> free_, before_;
};

}  // namespace

int walk_permille(const Model& model, const Placements& placements) {
  return WalkRaster(model, placements, kHalfPerson).largest_permille();
}

namespace {

// Where somebody stands who uses that side: as wide as it is, at most `off` away.
Box place_before(const Box& body, Direction side, Mm off) {
  Box place = body;
  (side.sign > 0 ? place.lo : place.hi)[side.axis] = (side.sign > 0 ? body.hi : body.lo)[side.axis];
  (side.sign > 0 ? place.hi : place.lo)[side.axis] += side.sign * off;
  return place;
}

}  // namespace

namespace {

std::vector<Box> places_before_doors(const Model& model, const Placements& placements, Mm near) {
  std::vector<Box> doors;
  for (std::size_t i = 0; i < model.items.size(); ++i) {
    const Item& door = model.items[i];
    if (!door.is_opening() || door.opening->type == OpeningType::kWindow || placements[i].state < 0) continue;
    doors.push_back(
        place_before(box_of(door, placements[i]), side_direction(door, Side::kFront, door.states[placements[i].state].turn), near));
  }
  return doors;
}

// Of the greater things that stand on the floor: how many have no used side to which a way of full width leads from a door.
int without_wide_way(const Model& model, const Placements& placements) {
  const std::vector<Box> doors = places_before_doors(model, placements, kWideWay / 2 + kArmLength);
  if (doors.empty()) return 0;
  WalkRaster raster(model, placements, kWideWay / 2, false, 50);
  raster.walk_from(doors);
  int count = 0;
  for (std::size_t i = 0; i < model.items.size(); ++i) {
    const Item& item = model.items[i];
    const Placement& p = placements[i];
    if (p.state < 0 || item.is_opening() || item.thin || p.at[2] > 50) continue;
    const State& state = item.states[p.state];
    if (state.strips.empty() || std::int64_t{state.size.width} * state.size.depth < kGreat) continue;
    count += std::all_of(state.strips.begin(), state.strips.end(), [&](const Box& strip) {
      Box near = strip.shifted(p.at);
      for (int k = 0; k < 2; ++k) near.lo[k] -= kBesideStrip, near.hi[k] += kBesideStrip;
      return raster.untouched(near);
    });
  }
  return count;
}

}  // namespace

bool reachable(const Model& model, int item, Mm width, const Placements& placements) {
  if (placements[item].state < 0) return false;
  const Mm near = width / 2 + kArmLength;
  const std::vector<Box> doors = places_before_doors(model, placements, near);
  std::vector<Box> sides;
  const Item& self = model.items[item];
  std::vector<Side> used = self.object->used_sides.value_or(self.entry->used_sides);
  std::erase_if(used, [](Side side) { return side == Side::kTop || side == Side::kBottom; });
  if (used.empty() || self.thin || placements[item].at[2] > 50) used = {Side::kFront, Side::kBack, Side::kLeft, Side::kRight};
  const int turn = self.states[placements[item].state].turn;
  if (turn % 90 != 0) return false;
  for (const Side side : used) {
    Direction way{1, -1};  // in its own frame, front or not
    if (side == Side::kBack) way = {1, 1};
    if (side == Side::kLeft) way = {0, -1};
    if (side == Side::kRight) way = {0, 1};
    sides.push_back(place_before(box_of(self, placements[item]), turned(way, turn), near));
  }
  return WalkRaster(model, placements, width / 2, true).way(doors, sides);
}

std::int64_t ways_cost(const Model& model, const Placements& placements) {
  std::int64_t cost = kPoint * kCostWeights.walk * std::max(0, 998 - walk_permille(model, placements));
  cost += kPoint * kCostWeights.narrow * without_wide_way(model, placements);
  for (const Constraint& constraint : model.constraints) {
    for (const auto& [item, width] : constraint.reach) {
      if (!reachable(model, item, width, placements)) cost += kPoint * kCostWeights.unreached;
    }
  }
  return cost;
}

std::map<std::string, std::int64_t> cost_terms(const Model& model, const Placements& placements) {
  std::map<std::string, std::int64_t> terms{{"habits", 0}, {"relations", 0}, {"access", 0}, {"ways", 0}, {"sizes", 0}};
  for (const Constraint& constraint : model.constraints) {
    const bool placed =
        std::all_of(constraint.formulas.begin(), constraint.formulas.end(), [&](const Formula& f) { return all_placed(f, placements); });
    if (!placed) continue;
    const bool stay = constraint.stay || !constraint.words.empty();
    terms[stay ? "stay" : constraint.relation < 0 ? "habits" : "relations"] += constraint_cost(model, constraint, placements);
  }
  for (std::size_t i = 0; i < model.items.size(); ++i) {
    if (placements[i].state < 0) continue;
    terms["access"] += access_cost_of(model, static_cast<int>(i), placements);
    terms["sizes"] += std::int64_t{kPoint} * kCostWeights.size_step * model.items[i].states[placements[i].state].size_step;
  }
  terms["ways"] = ways_cost(model, placements);
  return terms;
}

}  // namespace layoutbox::placement
