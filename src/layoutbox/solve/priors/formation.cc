#include "layoutbox/solve/priors/formation.h"

#include <algorithm>

#include "layoutbox/catalog/measures.h"
#include "layoutbox/solve/compile/phrases.h"
#include "layoutbox/solve/priors/habits.h"
#include "layoutbox/solve/priors/seating.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kBehindSeats = 300;        // left free behind and before rows of seats, and round mats
constexpr Mm kSeatRoom = 850;           // behind a desk: the chair, and somebody getting up
constexpr Mm kForSeveral = 1500;        // so wide a seat is for several: an aisle leads to its ends
constexpr Mm kRoundReception = 2100;    // behind a reception desk, with who sits there, and before it
constexpr Mm kRoundCounter = 1100;      // behind a counter, and before it
constexpr int kOneRow = 5;              // so few seats that look at something sit in one row
constexpr int kDesksInOneRow = 3;       // so few desks likewise, where all of them see it
constexpr int kNotAbreast = 200;        // points
constexpr std::int64_t kUneven = 400;   // thousandths of the room that a last row which is not full may cost
constexpr std::int64_t kUnseen = 1000;  // the same where not all see what they look at
constexpr int kSeatsToAisle = 8;        // so many seats of a row are parted by an aisle in the middle
constexpr Mm kAisle = 1000;
constexpr Mm kMostSpread = 2400;   // from middle to middle of a few that are shared out over a line through the room
constexpr Mm kBehindSitter = 600;  // from row to row of desks, beside the seats

// Gaps wanted between neighbours, along the rows and from row to row.
std::pair<Mm, Mm> gaps_of(const Item& item) {
  if (has_knee_room(item) || item.is(Trait::kDeskLike))
    return item.has_front ? std::pair<Mm, Mm>{500, kSeatRoom} : std::pair<Mm, Mm>{1300, 1300};
  if (item.thin) return {500, 400};
  if (item.has_front && item.is_seat && item.states[0].size.width >= kForSeveral) return {1000, 700};
  if (item.is(Trait::kShelving)) return {0, 1200};
  if (item.has_front) return item.is_seat ? std::pair<Mm, Mm>{80, 700} : std::pair<Mm, Mm>{100, 1200};
  return {500, 500};
}

}  // namespace

std::vector<PartOfRoom> parts_of_room(const PlacementModel& model, const std::vector<std::vector<ItemId>>& groups) {
  std::vector<PartOfRoom> parts(groups.size());
  if (groups.size() < 2) return parts;
  std::vector<std::int64_t> wanted;
  std::int64_t all = 0, before = 0;
  for (const std::vector<ItemId>& group : groups) {
    const Item& first = model.items[group[0]];
    const auto [across, deep] = gaps_of(first);
    const Size& size = first.states[0].size;
    wanted.push_back(static_cast<std::int64_t>(group.size()) * (size.width + across) * (size.depth + deep));
    all += wanted.back();
  }
  const int axis = model.room.extent(0) >= model.room.extent(1) ? 0 : 1;
  const auto edge = [&](std::int64_t share) {
    return model.room.lo[axis] + static_cast<Mm>(std::int64_t{model.room.extent(axis)} * (share / 1000) / (all / 1000));
  };
  for (std::size_t i = 0; i < groups.size(); ++i) {
    parts[i] = {axis, edge(before), edge(before + wanted[i])};
    before += wanted[i];
  }
  return parts;
}

Formation formation_of(int n, const Size& size, Mm gap_across, Mm gap_deep, Mm room_across, Mm room_deep, const FormationWays& ways) {
  const auto [columns, sides, ends, parted_from, in_view] = ways;
  // Each of two who share a desk gets out at its own side.
  const Mm beside = size.width >= measures().desk_for_two ? gap_across : kBetweenDesks;
  const auto fitted = [](int count, Mm one, Mm gap, Mm room, Mm around) -> Mm {  // from middle to middle; 0: does not fit
    if (count == 1) return one + gap;
    const Mm most = (room - 2 * around - one) / (count - 1);
    return most < one + gap * 6 / 10 ? 0 : std::min(one + gap, most);
  };
  Formation best{0, 0, 0};
  std::int64_t best_price = 0;
  for (int c = std::max(1, columns); c <= (columns > 0 ? columns : n); ++c) {
    const int rows = (n + c - 1) / c;
    const bool parted = parted_from > 0 && c >= parted_from && c % 2 == 0;
    if (parted_from > 0 && c >= parted_from && !parted && columns == 0) continue;
    const Mm aisle = parted ? kAisle : 0;
    const Mm apart = fitted(c, size.width, gap_across, room_across - aisle, sides);
    const Mm seen = in_view > 0 && c > 1 ? std::max(in_view / (c - 1), size.width + beside) : apart;
    const Mm across = std::min(apart, seen), deep = fitted(rows, size.depth, gap_deep, room_deep, ends);
    if (across == 0 || deep == 0) continue;
    // Shares of the room that it takes along both should be alike; full rows are better.
    const std::int64_t w = std::int64_t{1000} * (across * (c - 1) + size.width + aisle) / room_across,
                       d = std::int64_t{1000} * (deep * (rows - 1) + size.depth) / room_deep;
    const bool unseen = in_view > 0 && std::min(across, size.width + kBetweenDesks) * (c - 1) > in_view;
    const std::int64_t price = std::abs(w - d) + (n % c ? kUneven : 0) + (unseen ? kUnseen : 0);
    if (best.columns == 0 || price < best_price) best = {c, across, deep, aisle}, best_price = price;
  }
  return best;
}

namespace {

// The end of the room where the counter stands, which looks that way in those of its states.
struct CounterEnd {
  std::uint64_t states = 0;
  Direction front{0, 1};
  Mm depth = 0;
};

// The places of one member of a formation, a case for each way that it may look.
class FormationPlace {
 public:
  FormationPlace(Formula& formula, const PlacementModel& model, const FormationOf& of)
      : f_(formula), model_(model), of_(of), item_(of.group[of.k]), first_(model.items[of.group[0]]) {}

  // `ahead`: which way along the columns they look. `aside`: what the words call a column is a row to those who stand in it.
  void add(int row_axis, std::uint64_t states, int ahead, bool aside, const CounterEnd& taken = {}) {
    const int n = static_cast<int>(of_.group.size()), deep_axis = 1 - row_axis;
    const Mm deep = extent(deep_axis, taken), free = looks(ahead) ? std::min(of_.before, deep / 3) : 0;
    const Formation form = form_in(extent(row_axis, taken), deep - free, ahead, aside);
    if (form.columns == 0) return;
    const int rows = (n + form.columns - 1) / form.columns;
    // Twice the way of the middle of all from the room's: those who look at something are nearer to it than to the wall behind them, and
    // of a desk and its seat it is the desk that is spoken of.
    const Mm behind = looks(ahead) ? ends() : 0;
    const Mm slack = deep - free - behind - form.deep * (rows - 1) - first_.states[0].size.depth - of_.seats;
    const std::int64_t all = std::int64_t{ahead} * (looks(ahead) ? std::max(0, slack) / 3 + behind - free : 0) + ahead * of_.seats;
    // … and of one, along the row and along the column.
    const auto place_of = [&](int one) {
      // Who is told to look at something has the middle of a row: from there it is straight ahead.
      const int middle = (form.columns - 1) / 2, leader = of_.leader;
      const int at = leader < 0 ? one : one == leader ? middle : one == middle ? leader : one;
      const int row = aside ? at % of_.columns : at / form.columns, column = aside ? at / of_.columns : at % form.columns;
      // A last row that is not full stands about the middle, where no columns are asked for, and behind the others.
      const int in_last = n - (rows - 1) * form.columns;
      const bool parts = of_.columns == 0 && row + 1 == rows && (form.aisle == 0 || in_last % 2 == 0);
      const int here = parts ? in_last : form.columns, line = of_.columns == 0 && ahead > 0 ? rows - 1 - row : row;
      return std::pair{std::int64_t{form.across} * (2 * column - (here - 1)) + (2 * column < here ? -form.aisle : form.aisle),
                       std::int64_t{form.deep} * (2 * line - (rows - 1)) + all};
    };
    Case& c = f_.add();
    // Rather turned so that they have room for the one row.
    if (few_desks(ahead) && form.columns < n) c.price = kNotAbreast;
    if (states) c.when(item_, states);
    if (taken.states) c.when(of_.counter, taken.states);
    const auto wish_at = [&](int axis, std::int64_t twice) {
      if (axis == taken.front.axis) twice += std::int64_t{taken.front.sign} * taken.depth;
      c.wish(mid2(item_, axis) - Linear(std::int64_t{lo_of(model_, of_.part, axis)} + hi_of(model_, of_.part, axis) + twice), of_.weight,
             2);
    };
    const auto [along, back] = place_of(of_.k);
    wish_at(row_axis, along);
    wish_at(deep_axis, back);
    if (of_.k == 0) return;
    // … and in line with its neighbour: rather all of them a little off than one.
    const int neighbour = of_.k % form.columns > 0 ? of_.k - 1 : of_.k - form.columns;
    const auto [next_along, next_back] = place_of(neighbour);
    c.wish(mid2(item_, row_axis) - mid2(of_.group[neighbour], row_axis) - Linear(along - next_along), of_.in_line, 2);
    c.wish(mid2(item_, deep_axis) - mid2(of_.group[neighbour], deep_axis) - Linear(back - next_back), of_.in_line, 2);
  }

 private:
  bool looks(int ahead) const { return ahead != 0 && of_.before > 0; }
  bool seats() const { return first_.is_seat && first_.has_front; }
  Mm ends() const { return seats() || first_.thin || of_.seats > 0 ? kBehindSeats : kWayAround; }

  Mm extent(int axis, const CounterEnd& taken) const {
    return hi_of(model_, of_.part, axis) - lo_of(model_, of_.part, axis) - (axis == taken.front.axis ? taken.depth : 0);
  }

  bool few_desks(int ahead) const {
    const int n = static_cast<int>(of_.group.size());
    const bool all_see = of_.in_view == 0 || (first_.states[0].size.width + kBetweenDesks) * (n - 1) <= of_.in_view;
    return of_.seats > 0 && n <= kDesksInOneRow && all_see && looks(ahead) && of_.columns == 0;
  }

  // No columns: it has no room.
  Formation form_in(Mm across, Mm deep, int ahead, bool aside) const {
    const int n = static_cast<int>(of_.group.size());
    const int asked = aside ? (n + of_.columns - 1) / of_.columns : of_.columns;
    const Size& own = first_.states[0].size;
    const Size size{own.width, own.depth + of_.seats, own.height};
    if (const int pillars = asked > 0 ? asked : n % 2 == 0 ? 2 : 0; first_.is(Trait::kBearsCeiling) && pillars > 0) {
      const int rows = (n + pillars - 1) / pillars;  // spread over all of the room
      return {pillars, across / pillars, deep / rows};
    }
    const auto gaps = gaps_of(first_);
    const Mm spread = of_.spread ? std::min(kMostSpread, across / n) - own.width : 0;
    const Mm gap_across = std::max(gaps.first, spread), gap_deep = of_.seats > 0 ? kBehindSitter : gaps.second;
    // What is before the first row is left free already.
    FormationWays ways{asked, first_.thin ? kBehindSeats : kWayAround, looks(ahead) ? ends() / 2 : ends(),
                       seats() && own.width < kForSeveral && asked == 0 ? kSeatsToAisle : 0, of_.in_view};
    Formation form{0, 0, 0};
    const bool one_row = few_desks(ahead) || (seats() && n <= kOneRow && looks(ahead) && of_.columns == 0);
    for (const int in_row : {one_row ? n : asked, asked}) {
      ways.columns = in_row;
      // Closer in a small room; columns that are asked for stay apart where it is only too short.
      for (int wide = 10; wide > 0 && form.columns == 0; wide -= 3) {
        for (int tenths = in_row > 0 ? 10 : wide; tenths > 0 && form.columns == 0; tenths = in_row > 0 ? tenths - 3 : 0)
          form = formation_of(n, size, gap_across * wide / 10, gap_deep * tenths / 10, across, deep, ways);
      }
    }
    return form;
  }

  Formula& f_;
  const PlacementModel& model_;
  const FormationOf& of_;
  const ItemId item_;
  const Item& first_;
};

}  // namespace

void add_formation_place(Formula& f, const PlacementModel& model, const FormationOf& of) {
  const ItemId item = of.group[of.k];
  const Item& first = model.items[of.group[0]];
  FormationPlace places(f, model, of);
  if (!first.has_front && of.counter.exists()) {
    const Item& bar = model.items[of.counter];
    for_each_turn(bar, [&](int turn, std::uint64_t turned) {
      const std::uint64_t states = states_with_width_along(model.items[item], 0);
      if (quarter(turn))
        places.add(0, states, 0, false,
                   {turned, side_direction(bar, Side::kFront, turn), std::max(bar.states[0].size.depth + kRoundCounter, of.before)});
    });
    if (!f.cases.empty()) return;
  }
  if (first.is_seat && of.counter.exists()) {  // who waits looks at who serves
    for_each_turn(model.items[of.counter], [&](int turn, std::uint64_t turned) {
      const Item& desk = model.items[of.counter];
      if (!quarter(turn)) return;
      const Direction front = side_direction(desk, Side::kFront, turn);
      if (const std::uint64_t states = states_looking(model.items[item], opposite(front)))
        places.add(across(front), states, -front.sign, of.columns > 0 && across(front) == 1,
                   {turned, front, desk.states[0].size.depth + kRoundReception});
    });
    if (!f.cases.empty()) return;
  }
  if (!first.has_front) return places.add(0, states_with_width_along(model.items[item], 0), 0, false);
  const Side eyes = looking_side(model, item);
  // The places speak of nothing but the item itself, so that they hold whichever of the group comes first. Rows that words ask for run
  // along x.
  for_each_turn(model.items[item], [&](int turn, std::uint64_t states) {
    if (!quarter(turn)) return;
    const Direction ahead = side_direction(model.items[item], eyes, turn);
    places.add(across(ahead), states, ahead.sign, of.columns > 0 && across(ahead) == 1);
  });
}

}  // namespace layoutbox::placement
