// Habits of what stands on something else.
#include <algorithm>

#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kFromBack = 40;    // from the back of a desk to what stands there
constexpr Mm kFromEdge = 60;    // from the used edge of a desk to the keyboard
constexpr Mm kBesideKeys = 40;  // from the keyboard to the mouse
constexpr int kAtHand = 80, kSpot = 40, kScreensInLine = 150;

}  // namespace

// The side farthest from who uses what stands there, and the one to their right: of a desk that is sat behind the farthest is its front.
std::pair<Side, Side> Habits::sides_on(ItemId host, bool screen) const {
  if (screen && model_.items[host].has_front && is_sat_behind(host)) return {Side::kFront, Side::kLeft};
  return {Side::kBack, Side::kRight};
}

// What stands on something looks the way that looks; screens stand in its middle, the rest is spread over it.
void Habits::sit_on_host(ItemId item) {
  const Item& self = model_.items[item];
  const bool screen = self.is(Trait::kScreen);
  for (const SupportOption& support : self.supports) {
    if (support.kind != SupportOption::Kind::kItem) continue;
    const Item& host = model_.items[support.item];
    const std::optional<Spot> spot = screen ? spot_of_screen(item, support.item) : spot_on(item, support.item);
    const ItemId user = self.is(Trait::kMonitor) ? seat_told_to_be_at(support.item, rank_of(item)) : ItemId();
    if (user.exists()) look_at_user(item, user);
    const std::pair<Side, Side> sides = sides_on(support.item, screen);
    Formula f;
    for_each_turn(host, [&](int turn, std::uint64_t states) {
      Case& c = f.add().when(support.item, states);
      // A till, a scale, a coffee machine are for who serves.
      const bool for_staff = is_served_over(support.item);
      const bool towards_seat = for_staff || (screen && (used_side(host) == Side::kBack || is_sat_behind(support.item)));
      if (self.has_front && !user.exists()) c.when(item, self.states_at((turn + (towards_seat ? 180 : 0)) % 360));
      const Direction back = side_direction(host, sides.first, turn), right = side_direction(host, sides.second, turn);
      if (spot) c.wish(mid2(item, right.axis) - mid2(support.item, right.axis) - Linear(right.sign * spot->right2), screen ? 80 : kSpot, 2);
      if (spot && spot->back2) {
        c.wish(mid2(item, back.axis) - mid2(support.item, back.axis) - Linear(back.sign * *spot->back2), kSpot, 2);
      } else if (host.has_front) {
        stand_at_back(c, item, support.item, back);
      }
    });
    if (!lie_at_hand(item, support.item)) habit("sits", item, kSits, std::move(f), screen_before(item, support.item));
    return;
  }
}

// Is it the words "on" or "in" that alone say where on its host something is?
bool Habits::lies_free(ItemId item, ItemId host) const {
  const std::string& id = model_.items[item].id;
  return rests_on(item, host) && !model_.items[item].is(Trait::kScreen) && !model_.items[item].is(Trait::kKeyboard) &&
         !model_.items[item].is(Trait::kMouse) && std::ranges::none_of(model_.scene->relations, [&](const Relation& r) {
           if (std::ranges::find(r.targets, id) == r.targets.end()) return false;
           const RelationParameters& p = r.parameters;
           return !traits_of(r.type).rests || !p.part.empty() || p.edge || p.region;
         });
}

// What lies free on one thing is spread over it in rows, in the order of the words, one thing alone in the middle; what is placed by its
// neighbours goes with these. At the back of what is deep and has a front, at the front of shelves; nothing where there are too many for
// even rows.
std::optional<Habits::Spot> Habits::spot_on(ItemId item, ItemId host) const {
  constexpr Mm kApart = 30, kLeastApart = 4, kDeep = 500, kWorkingHeight = 600, kFromShelfEdge = 30;
  if (!lies_free(item, host)) return {};
  const Item& below = model_.items[host];
  Mm widest = 0, screens = 0;  // widths
  std::int64_t before = 0, all = 0;
  for (const ItemId i : model_.items.ids()) {
    const Size& size = model_.items[i].states[0].size;
    if (model_.items[i].is(Trait::kScreen) && rests_on(i, host)) screens += size.width;
    if (!lies_free(i, host)) continue;
    widest = std::max({widest, size.width, size.depth});
    before += i < item;
    ++all;
  }
  const Size& top = below.states[0].size;
  const bool deep_at_back = below.has_front && top.depth > kDeep && top.height >= kWorkingHeight;
  if (screens > 0 && below.has_front) return spot_beside_screens(top.width, screens, widest, before, all, deep_at_back);
  const bool across = below.has_front || top.width >= top.depth;  // rows run along the width
  const Mm length = across ? top.width : top.depth, breadth = across ? top.depth : top.width;
  const auto in_row_of = [&](Mm apart) { return std::clamp<std::int64_t>(length / (widest + apart), 1, all); };
  const auto fit = [&](Mm apart) { return (all + in_row_of(apart) - 1) / in_row_of(apart) * (widest + apart) <= breadth; };
  const std::int64_t in_row = in_row_of(all <= in_row_of(kApart) || fit(kApart) ? kApart : kLeastApart);
  const std::int64_t rows = (all + in_row - 1) / in_row;
  if (rows > 1 && rows * (widest + kLeastApart) > breadth) return {};
  const std::int64_t columns = (all + rows - 1) / rows, row = before / columns, column = before % columns;
  const std::int64_t here = row + 1 < rows ? columns : all - row * columns;  // in this row
  const std::int64_t along = (2 * column + 1 - here) * length / columns, away = (rows - 1 - 2 * row) * breadth / rows;
  if (!across) return Spot{away, along};
  if (rows == 1 && deep_at_back) return Spot{along, {}};
  // On a shelf at its front edge: farther in, the board above hides it.
  if (rows == 1 && below.has_front && below.is(Trait::kShelving)) {
    const Mm own = model_.items[item].states[0].size.depth;
    return Spot{along, std::min<std::int64_t>(0, own + 2 * kFromShelfEdge - top.depth)};
  }
  return Spot{along, away};
}

// Beside the screens in the middle, half of the things at either side: the lamp is not between the laptop and who sits there.
std::optional<Habits::Spot> Habits::spot_beside_screens(Mm length, Mm screens, Mm widest, std::int64_t before, std::int64_t all,
                                                        bool at_back) {
  const std::int64_t at_left = (all + 1) / 2;
  const bool left = before < at_left;
  const std::int64_t here = left ? at_left : all - at_left, place = left ? before : before - at_left;
  const Mm room = (length - screens) / 2;
  if (here * widest > room) return {};
  const std::int64_t off2 = screens + (2 * place + 1) * room / here;
  const std::int64_t along = left ? -off2 : off2;
  if (at_back) return Spot{along, {}};
  return Spot{along, 0};
}

// Screens on one desk stand side by side; one alone on something small in its middle.
Habits::Spot Habits::spot_of_screen(ItemId item, ItemId host) const {
  constexpr Mm kApart = 20;
  std::int64_t riders = 0, screens = 0, before = 0;
  for (const ItemId i : model_.items.ids()) {
    if (!rests_on(i, host)) continue;
    ++riders;
    if (model_.items[i].entry != model_.items[item].entry) continue;
    before += i < item;
    ++screens;
  }
  const Mm width = model_.items[item].states[0].size.width, has = model_.items[host].states[0].size.width;
  if (riders == 1 && has < 3 * width) return {0, 0};
  const std::int64_t pitch = std::min<std::int64_t>(width + kApart, has / screens);
  return {(2 * before - (screens - 1)) * pitch, {}};
}

// At the back of its host; of several screens the others in line with the first, wherever that is.
void Habits::stand_at_back(Case& c, ItemId item, ItemId host, Direction back) const {
  if (const std::vector<ItemId> first = screen_before(item, host); !first.empty())
    c.wish(reach(item, back) - reach(first.front(), back), kScreensInLine);
  else
    c.wish(reach(item, back) - reach(host, back) + Linear(kFromBack), model_.items[item].is(Trait::kScreen) ? 100 : 25);
}

// The first of its kind on that host, where a screen is not that itself; else none.
std::vector<ItemId> Habits::screen_before(ItemId item, ItemId host) const {
  if (!model_.items[item].is(Trait::kScreen)) return {};
  for (const ItemId i : ids_before(item)) {
    if (model_.items[i].entry == model_.items[item].entry && rests_on(i, host)) return {i};
  }
  return {};
}

bool Habits::rests_on(ItemId item, ItemId host) const {
  const std::vector<SupportOption>& supports = model_.items[item].supports;
  return std::any_of(supports.begin(), supports.end(),
                     [&](const SupportOption& s) { return s.kind == SupportOption::Kind::kItem && s.item == host; });
}

// The first such thing that stands on the host, if any.
ItemId Habits::rider_that_is(Trait trait, ItemId host) const {
  for (const ItemId i : model_.items.ids()) {
    if (model_.items[i].is(trait) && rests_on(i, host)) return i;
  }
  return {};
}

// A keyboard lies at the used edge of its desk before the screen, a mouse to the right of the keyboard. False: it is neither.
bool Habits::lie_at_hand(ItemId item, ItemId host) {
  const bool mouse = model_.items[item].is(Trait::kMouse);
  if (!mouse && !model_.items[item].is(Trait::kKeyboard)) return false;
  const Item& desk = model_.items[host];
  if (!desk.has_front) return false;
  const Side used = used_side(desk) == Side::kBack || is_sat_behind(host) ? Side::kBack : Side::kFront;
  const ItemId keys = mouse ? rider_that_is(Trait::kKeyboard, host) : ItemId(), screen = rider_that_is(Trait::kMonitor, host);
  Formula f;
  for_each_turn(desk, [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction edge = side_direction(desk, used, turn);
    const Direction right = side_direction(desk, used == Side::kBack ? Side::kLeft : Side::kRight, turn);
    Case& c = f.add().when(host, states);
    c.when(item, model_.items[item].states_at((turn + (used == Side::kBack ? 180 : 0)) % 360));
    c.wish(reach(item, edge) - reach(host, edge) + Linear(kFromEdge), kAtHand);
    if (keys.exists()) {
      c.wish(gap_towards(item, keys, right) - Linear(kBesideKeys), kAtHand);
    } else {
      const ItemId before = screen.exists() ? screen : host;
      c.wish(mid2(item, right.axis) - mid2(before, right.axis) - Linear(mouse ? right.sign * 500 : 0), kAtHand, 2);
    }
  });
  habit("at hand", item, kSits, std::move(f),
        keys.exists()     ? std::vector<ItemId>{keys}
        : screen.exists() ? std::vector<ItemId>{screen}
                          : std::vector<ItemId>{});
  return true;
}

}  // namespace layoutbox::placement
