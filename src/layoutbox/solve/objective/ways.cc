// Ways to walk, measured on a raster of the floor.
#include <bit>

#include "layoutbox/solve/objective/access.h"
#include "layoutbox/solve/objective/cost.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kHalfPerson = 100;
constexpr Mm kWideWay = 600;             // what building codes and handbooks ask of a way within a room
constexpr Mm kBesideStrip = 200;         // from the strip at a used side to where somebody's middle is
constexpr std::int64_t kGreat = 400000;  // mm²: seats and bedside tables have their own ways
constexpr Mm kArmLength = 150;           // how near one must come to a door or a thing

// The floor in cells; which of those free for somebody's middle hang together is found by runs of them, row by row. Rows that are alike
// are one band: what blocks the floor has straight sides, so there are few bands, however fine the cells.
class WalkRaster {
 public:
  // `whole`: everything that begins below standing height is in the way, else only what has its middle there.
  WalkRaster(const PlacementModel& model, const Placements& placements, Mm half_person, bool whole = false, Mm finest = 25)
      : model_(model), half_(half_person) {
    const Mm longest = std::max(model.room.extent(0), model.room.extent(1));
    step_ = std::max<Mm>(finest, longest * finest / 4000);
    columns_ = model.room.extent(0) / step_ + 1, rows_ = model.room.extent(1) / step_ + 1;
    words_ = static_cast<std::size_t>(columns_) / kBits + 1;
    blocked_.reserve(4 + model.outside.size() + model.items.size());
    const GridBox& r = model.room;
    block({{r.lo[0] - 1000, r.lo[1] - 1000, 0}, {r.lo[0], r.hi[1] + 1000, 0}});
    block({{r.hi[0], r.lo[1] - 1000, 0}, {r.hi[0] + 1000, r.hi[1] + 1000, 0}});
    block({{r.lo[0], r.lo[1] - 1000, 0}, {r.hi[0], r.lo[1], 0}});
    block({{r.lo[0], r.hi[1], 0}, {r.hi[0], r.hi[1] + 1000, 0}});
    for (const GridBox& outside : model.outside) block(outside);
    for (const ItemId i : model.items.ids()) {
      if (placements[i].state < 0) continue;
      const GridBox box = box_of(model.items[i], placements[i]);
      const Item& item = model.items[i];
      if (whole ? !item.is_opening() && !item.thin && box.lo[2] < kBodyReach : blocks_floor(item, box)) block(box);
    }
    cut_into_bands();
    join();
  }

  // Is there a way from one of the places `from` to one of `to`? Empty `from`: from anywhere.
  bool way(const std::vector<GridBox>& from, const std::vector<GridBox>& to) {
    if (from.empty()) std::fill(walked_.begin(), walked_.end(), 1);
    walk_from(from);
    return std::any_of(to.begin(), to.end(), [&](const GridBox& place) { return !untouched(place); });
  }

  // Notes all that can be walked to from these places; `untouched` then tells whether a place is none of it.
  void walk_from(const std::vector<GridBox>& places) {
    for (const GridBox& place : places) {
      for_runs_in(place, [&](int run) { walked_[part_of(run)] = 1; });
    }
  }
  bool untouched(const GridBox& place) {
    bool touched = false;
    for_runs_in(place, [&](int run) { touched = touched || walked_[part_of(run)] != 0; });
    return !touched;
  }

  int largest_permille() {
    std::int64_t total = 0, largest = 0;
    std::vector<std::int64_t> sizes(runs_.size(), 0);
    for (std::size_t band = 0; band + 1 < first_row_.size(); ++band) {
      const int rows = first_row_[band + 1] - first_row_[band];
      for (std::size_t i = first_run_[band]; i < first_run_[band + 1]; ++i) {
        const int cells = rows * (runs_[i].last - runs_[i].first + 1);
        std::int64_t& size = sizes[part_of(static_cast<int>(i))];
        total += cells, size += cells;
        largest = std::max(largest, size);
      }
    }
    return total == 0 ? 0 : static_cast<int>(largest * 1000 / total);
  }

 private:
  static constexpr int kBits = 64;
  struct Run {
    int first = 0, last = 0;  // columns
  };
  struct Cells {
    int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
  };

  int cell(Mm along, bool up) const { return up ? (along + step_ - 1 + 100 * step_) / step_ - 100 : (along + 100 * step_) / step_ - 100; }

  // The cells whose points lie in the box grown by so much.
  Cells cells_in(const GridBox& box, Mm grown) const {
    const Vec3& o = model_.room.lo;
    return {std::max(0, cell(box.lo[0] - grown - o[0], true)), std::min(columns_ - 1, cell(box.hi[0] + grown - o[0], false)),
            std::max(0, cell(box.lo[1] - grown - o[1], true)), std::min(rows_ - 1, cell(box.hi[1] + grown - o[1], false))};
  }

  void block(const GridBox& box) {
    const Cells c = cells_in(box, half_);
    if (c.x0 <= c.x1 && c.y0 <= c.y1) blocked_.push_back(c);
  }

  // A band begins wherever something begins or ends to be in the way.
  void cut_into_bands() {
    first_row_.reserve(2 * blocked_.size() + 2);
    first_row_.assign({0, rows_});
    for (const Cells& c : blocked_) first_row_.push_back(c.y0), first_row_.push_back(c.y1 + 1);
    std::sort(first_row_.begin(), first_row_.end());
    first_row_.erase(std::unique(first_row_.begin(), first_row_.end()), first_row_.end());
    free_.assign(words_ * (first_row_.size() - 1), ~std::uint64_t{0});
    for (const Cells& c : blocked_) {
      for (std::size_t band = band_of(c.y0); first_row_[band] <= c.y1; ++band) take_away(c, &free_[band * words_]);
    }
  }

  std::size_t band_of(int row) const {
    return static_cast<std::size_t>(std::upper_bound(first_row_.begin(), first_row_.end(), row) - first_row_.begin()) - 1;
  }

  static void take_away(const Cells& c, std::uint64_t* row) {
    const int first = c.x0 / kBits, last = c.x1 / kBits;
    for (int word = first; word <= last; ++word) {
      std::uint64_t in = ~std::uint64_t{0};
      if (word == first) in &= ~std::uint64_t{0} << (c.x0 % kBits);
      if (word == last) in &= ~std::uint64_t{0} >> (kBits - 1 - c.x1 % kBits);
      row[word] &= ~in;
    }
  }

  // The next column from `x` on that is free, or that is not.
  int next(std::size_t band, int x, bool free) const {
    while (x < columns_) {
      std::uint64_t bits = free_[band * words_ + static_cast<std::size_t>(x) / kBits];
      if (!free) bits = ~bits;
      bits >>= x % kBits;
      if (bits != 0) return std::min(columns_, x + std::countr_zero(bits));
      x += kBits - x % kBits;
    }
    return columns_;
  }

  void join() {
    const std::size_t bands = first_row_.size() - 1;
    first_run_.reserve(bands + 1), runs_.reserve(4 * bands), parent_.reserve(4 * bands);
    for (std::size_t band = 0; band < bands; ++band) {
      std::size_t below = band > 0 ? first_run_[band - 1] : 0;
      const std::size_t start = runs_.size();
      first_run_.push_back(start);
      for (int x = next(band, 0, true); x < columns_;) {
        const int end = next(band, x, false);
        const int run = static_cast<int>(runs_.size());
        runs_.push_back({x, end - 1});
        parent_.push_back(run);
        while (below < start && runs_[below].last < x) ++below;
        for (std::size_t k = below; k < start && runs_[k].first < end; ++k) parent_[part_of(static_cast<int>(k))] = part_of(run);
        x = next(band, end, true);
      }
    }
    first_run_.push_back(runs_.size());
    walked_.assign(runs_.size(), 0);
  }

  // Runs that hang together have the same.
  std::size_t part_of(int run) {
    while (parent_[run] != run) run = parent_[run] = parent_[parent_[run]];
    return static_cast<std::size_t>(run);
  }

  template <typename Visit>
  void for_runs_in(const GridBox& box, const Visit& visit) const {
    const Cells c = cells_in(box, 0);
    if (c.y0 > c.y1) return;
    for (std::size_t band = band_of(c.y0); band + 1 < first_row_.size() && first_row_[band] <= c.y1; ++band) {
      for (std::size_t k = first_run_[band]; k < first_run_[band + 1]; ++k) {
        if (runs_[k].first <= c.x1 && c.x0 <= runs_[k].last) visit(static_cast<int>(k));
      }
    }
  }

  const PlacementModel& model_;
  Mm half_;
  Mm step_ = 25;
  int columns_ = 0, rows_ = 0;
  std::size_t words_ = 0;
  std::vector<Cells> blocked_;          // what is in the way
  std::vector<int> first_row_;          // of each band, and the end
  std::vector<std::uint64_t> free_;     // a bit a cell of a band's rows, bands of whole words
  std::vector<Run> runs_;               // of free cells, band by band
  std::vector<std::size_t> first_run_;  // of each band, and the end
  std::vector<int> parent_;
  std::vector<char> walked_;  // by the first of the runs that hang together
};

}  // namespace

int walk_permille(const PlacementModel& model, const Placements& placements) {
  return WalkRaster(model, placements, kHalfPerson).largest_permille();
}

namespace {

// Where somebody stands who uses that side: as wide as it is, at most `off` away.
GridBox place_before(const GridBox& body, Direction side, Mm off) {
  GridBox place = body;
  (side.sign > 0 ? place.lo : place.hi)[side.axis] = (side.sign > 0 ? body.hi : body.lo)[side.axis];
  (side.sign > 0 ? place.hi : place.lo)[side.axis] += side.sign * off;
  return place;
}

std::vector<GridBox> places_before_doors(const PlacementModel& model, const Placements& placements, Mm near) {
  std::vector<GridBox> doors;
  for (const ItemId i : model.items.ids()) {
    const Item& door = model.items[i];
    if (!door.is_opening() || door.opening->type == OpeningType::kWindow || placements[i].state < 0) continue;
    doors.push_back(
        place_before(box_of(door, placements[i]), side_direction(door, Side::kFront, door.states[placements[i].state].turn), near));
  }
  return doors;
}

// Of the greater things that stand on the floor: how many have no used side to which a way of full width leads from a door.
int without_wide_way(const PlacementModel& model, const Placements& placements) {
  const std::vector<GridBox> doors = places_before_doors(model, placements, kWideWay / 2 + kArmLength);
  if (doors.empty()) return 0;
  WalkRaster raster(model, placements, kWideWay / 2, false, 50);
  raster.walk_from(doors);
  int count = 0;
  for (const ItemId i : model.items.ids()) {
    const Item& item = model.items[i];
    const Placement& p = placements[i];
    if (p.state < 0 || item.is_opening() || item.thin || p.at[2] > 50) continue;
    const State& state = item.states[p.state];
    if (state.strips.empty() || std::int64_t{state.size.width} * state.size.depth < kGreat) continue;
    count += std::all_of(state.strips.begin(), state.strips.end(), [&](const GridBox& strip) {
      GridBox near = strip.shifted(p.at);
      for (int k = 0; k < 2; ++k) near.lo[k] -= kBesideStrip, near.hi[k] += kBesideStrip;
      return raster.untouched(near);
    });
  }
  return count;
}

}  // namespace

bool reachable(const PlacementModel& model, ItemId item, Mm width, const Placements& placements) {
  if (placements[item].state < 0) return false;
  const Mm near = width / 2 + kArmLength;
  const std::vector<GridBox> doors = places_before_doors(model, placements, near);
  std::vector<GridBox> sides;
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

std::int64_t ways_cost(const PlacementModel& model, const Placements& placements, std::int64_t enough) {
  if (enough <= 0) return 0;
  std::int64_t cost = kPoint * kCostWeights.walk * std::max(0, 998 - walk_permille(model, placements));
  if (cost < enough) cost += kPoint * kCostWeights.narrow * without_wide_way(model, placements);
  for (const Constraint& constraint : model.constraints) {
    for (const auto& [item, width] : constraint.reach) {
      if (cost >= enough) return cost;
      if (!reachable(model, item, width, placements)) cost += kPoint * kCostWeights.unreached;
    }
  }
  return cost;
}

}  // namespace layoutbox::placement
