// Relations between an object and doors or windows. An opening is an item: a box of no depth in the wall's inner face.
#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {
namespace {

std::vector<int> openings_meant(const Compilation& c, bool windows) {
  std::vector<int> found = c.reference_items();
  if (!found.empty()) return found;
  for (std::size_t i = 0; i < c.model.items.size(); ++i) {
    const Item& item = c.model.items[i];
    if (item.is_opening() && (item.opening->type == OpeningType::kWindow) == windows) found.push_back(static_cast<int>(i));
  }
  return found;
}

void near_one(Compilation& c, bool windows) {
  const Mm least = c.length(c.relation.parameters.min, "min", 0), most = c.length(c.relation.parameters.max, "max", 1500);
  for (const int t : c.targets) {
    Formula& f = c.formula();
    for (const int o : openings_meant(c, windows)) {
      if (least == 0) {
        Case in;
        for (int axis = 0; axis < 2; ++axis) in.wish(mid2(t, axis) - mid2(o, axis), 15, 2);
        add_within(f, std::move(in), c.model, t, o, most);
        continue;
      }
      Formula apart;
      add_apart(apart, t, o, least);
      for (Case& in : apart.cases) {
        add_within(f, std::move(in), c.model, t, o, most);
      }
    }
  }
}

void far_from_all(Compilation& c, bool windows) {
  const Mm least = c.length(c.relation.parameters.min, "min", 2000);
  for (const int t : c.targets) {
    for (const int o : openings_meant(c, windows)) add_apart(c.formula(), t, o, least);
  }
}

}  // namespace

void add_under_window(Formula& f, const Model& model, int t, int window, Mm most) {
  const Item& item = model.items[window];
  for_each_turn(item, [&](int turn, std::uint64_t states) {
    const Direction in = side_direction(item, Side::kFront, turn);
    Case& c = f.add().when(window, states);
    const Linear off = gap_towards(t, window, in);
    c.require(off).require(Linear(most) - off).wish(off, 100);
    require_in_line(c, t, window, across(in));
    c.wish(mid2(t, across(in)) - mid2(window, across(in)), 100, 2);
    c.require(2 * lo(window, 2) - mid2(t, 2) - Linear(20));
    c.require(lo(window, 2) - lo(t, 2) - Linear(1));
  });
}

void compile_UnderWindow(Compilation& c) {
  const Mm most = c.length(c.relation.parameters.max, "max", 300);
  for (const int t : c.targets) {
    Formula& f = c.formula();
    for (const int o : openings_meant(c, true)) add_under_window(f, c.model, t, o, most);
  }
}

void compile_NearDoor(Compilation& c) { near_one(c, false); }
void compile_NearWindow(Compilation& c) { near_one(c, true); }
void compile_FarFromDoor(Compilation& c) { far_from_all(c, false); }
void compile_FarFromWindow(Compilation& c) { far_from_all(c, true); }

void compile_NotBlocking(Compilation& c) {
  std::vector<int> openings = c.reference_items();
  if (openings.empty()) {
    openings = openings_meant(c, false);
    const std::vector<int> windows = openings_meant(c, true);
    openings.insert(openings.end(), windows.begin(), windows.end());
  }
  for (const int t : c.targets) {
    for (const int o : openings) {
      const Item& item = c.item(o);
      const bool window = item.opening && item.opening->type == OpeningType::kWindow;
      const Mm usual = !item.opening ? 600 : window ? 500 : item.opening->width;
      const Mm depth = c.relation.parameters.depth.value_or(usual);
      Formula& f = c.formula();
      for_each_turn(item, [&](int turn, std::uint64_t states) {
        const Direction in = side_direction(item, Side::kFront, turn), side{across(in), 1};
        f.add().when(o, states).require(gap_towards(t, o, in) - Linear(depth));
        f.add().when(o, states).require(gap_towards(t, o, side));
        f.add().when(o, states).require(gap_towards(t, o, opposite(side)));
        f.add().when(o, states).require(gap_towards(t, o, {2, -1}));
        f.add().when(o, states).require(gap_towards(t, o, {2, 1}));
      });
    }
  }
}

}  // namespace layoutbox::placement
