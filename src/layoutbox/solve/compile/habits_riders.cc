// Habits of what stands on something else.
#include "layoutbox/solve/compile/habits.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kFromEdge = 60;    // from the used edge of a desk to the keyboard
constexpr Mm kBesideKeys = 40;  // from the keyboard to the mouse
constexpr int kAtHand = 80;

}  // namespace

// What stands on something looks the way that looks; screens in its middle, the rest rather at its back.
void Habits::sit_on_host(int item) {
  const Item& self = model_.items[item];
  const bool screen = self.is(Trait::kScreen);
  for (const SupportOption& support : self.supports) {
    if (support.kind != SupportOption::Kind::kItem) continue;
    const Item& host = model_.items[support.index];
    Formula f;
    for_each_turn(host, [&](int turn, std::uint64_t states) {
      Case& c = f.add().when(support.index, states);
      const bool towards_seat = screen && used_side(host) == Side::kBack;
      if (self.has_front) c.when(item, self.states_at((turn + (towards_seat ? 180 : 0)) % 360));
      const Direction back = side_direction(host, Side::kBack, turn), right = side_direction(host, Side::kRight, turn);
      const bool small_host = host.states[0].size.width < 3 * self.states[0].size.width && riders_of(support.index) == 1;
      if (screen || small_host) {
        const Linear off_middle = mid2(item, right.axis) - mid2(support.index, right.axis);
        c.wish(off_middle - Linear(right.sign * place_among_screens(item, support.index)), 80, 2);
      }
      if (host.has_front && !small_host) c.wish(reach(item, back) - reach(support.index, back) + Linear(40), screen ? 60 : 25);
      if (small_host) c.wish(mid2(item, back.axis) - mid2(support.index, back.axis), 60, 2);
    });
    if (!lie_at_hand(item, support.index)) habit("sits", item, kSits, std::move(f));
    return;
  }
}

// Screens on one desk stand side by side: twice what this one is off the desk's middle, towards the desk's right.
std::int64_t Habits::place_among_screens(int item, int host) const {
  constexpr Mm kApart = 20;
  std::int64_t screens = 0, before = 0;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    if (model_.items[i].entry != model_.items[item].entry || !rests_on(static_cast<int>(i), host)) continue;
    before += static_cast<int>(i) < item;
    ++screens;
  }
  const Mm pitch = model_.items[item].states[0].size.width + kApart;
  if (screens * pitch > model_.items[host].states[0].size.width + kApart) return 0;
  return (2 * before - (screens - 1)) * pitch;
}

bool Habits::rests_on(int item, int host) const {
  const std::vector<SupportOption>& supports = model_.items[item].supports;
  return std::any_of(supports.begin(), supports.end(),
                     [&](const SupportOption& s) { return s.kind == SupportOption::Kind::kItem && s.index == host; });
}

int Habits::riders_of(int host) const {
  int riders = 0;
  for (std::size_t i = 0; i < model_.items.size(); ++i) riders += rests_on(static_cast<int>(i), host);
  return riders;
}

// The first such thing that stands on the host, or -1.
int Habits::rider_that_is(Trait trait, int host) const {
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    if (model_.items[i].is(trait) && rests_on(static_cast<int>(i), host)) return static_cast<int>(i);
  }
  return -1;
}

// A keyboard lies at the used edge of its desk before the screen, a mouse to the right of the keyboard. False: it is neither.
bool Habits::lie_at_hand(int item, int host) {
  const bool mouse = model_.items[item].is(Trait::kMouse);
  if (!mouse && !model_.items[item].is(Trait::kKeyboard)) return false;
  const Item& desk = model_.items[host];
  if (!desk.has_front) return false;
  const Side used = used_side(desk) == Side::kBack ? Side::kBack : Side::kFront;
  const int keys = mouse ? rider_that_is(Trait::kKeyboard, host) : -1, screen = rider_that_is(Trait::kMonitor, host);
  Formula f;
  for_each_turn(desk, [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction edge = side_direction(desk, used, turn);
    const Direction right = side_direction(desk, used == Side::kBack ? Side::kLeft : Side::kRight, turn);
    Case& c = f.add().when(host, states);
    c.when(item, model_.items[item].states_at((turn + (used == Side::kBack ? 180 : 0)) % 360));
    c.wish(reach(item, edge) - reach(host, edge) + Linear(kFromEdge), kAtHand);
    if (keys >= 0) {
      c.wish(gap_towards(item, keys, right) - Linear(kBesideKeys), kAtHand);
    } else {
      const int before = screen >= 0 ? screen : host;
      c.wish(mid2(item, right.axis) - mid2(before, right.axis) - Linear(mouse ? right.sign * 500 : 0), kAtHand, 2);
    }
  });
  habit("at hand", item, kSits, std::move(f),
        keys >= 0     ? std::vector<int>{keys}
        : screen >= 0 ? std::vector<int>{screen}
                      : std::vector<int>{});
  return true;
}

}  // namespace layoutbox::placement
