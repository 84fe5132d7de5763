// Relations between an object and doors or windows. An opening is an item: a box of no depth in the wall's inner face.
#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {
namespace {

constexpr int kBeforeWindow = 300;  // points a metre: what is under a window is under its middle

std::vector<ItemId> openings_meant(const Compilation& c, bool windows) {
  std::vector<ItemId> found = c.reference_items();
  std::erase_if(found, [&](ItemId i) { return !c.item(i).is_opening(); });
  const auto named = [](const Reference& r) { return r.kind != Reference::Kind::kRoom; };
  if (std::any_of(c.references.begin(), c.references.end(), named)) return found;
  for (const ItemId i : c.model.items.ids()) {
    const Item& item = c.model.items[i];
    if (item.is_opening() && (item.opening->type == OpeningType::kWindow) == windows) found.push_back(i);
  }
  return found;
}

void near_one(Compilation& c, bool windows) {
  const Mm least = c.length(&RelationParameters::min), most = c.length(&RelationParameters::max);
  for (const ItemId t : c.targets) {
    Formula& f = c.formula();
    for (const ItemId o : openings_meant(c, windows)) add_band(f, c.model, t, place_of(o), least, most, (least + most) / 4);
  }
}

void far_from_all(Compilation& c, bool windows) {
  const Mm least = c.length(&RelationParameters::min);
  for (const ItemId t : c.targets) {
    for (const ItemId o : openings_meant(c, windows)) add_band(c.formula(), c.model, t, place_of(o), least, std::nullopt, 0);
  }
}

}  // namespace

void add_under_window(Formula& f, const PlacementModel& model, ItemId t, ItemId window, Mm most) {
  const Item& item = model.items[window];
  for_each_turn(item, [&](int turn, std::uint64_t states) {
    const Direction in = side_direction(item, Side::kFront, turn);
    Case c;
    c.when(window, states);
    const Linear off = gap_towards(t, window, in);
    c.require(off).require(Linear(most) - off).wish(off, 100);
    c.wish(mid2(t, across(in)) - mid2(window, across(in)), kBeforeWindow, 2);
    c.require(2 * lo(window, 2) - mid2(t, 2));
    for (Case& one : in_line(c, model, t, place_of(window), across(in))) f.cases.push_back(std::move(one));
  });
}

void compile_UnderWindow(Compilation& c) {
  const Mm most = c.length(&RelationParameters::max);
  for (const ItemId t : c.targets) {
    Formula& f = c.formula();
    for (const ItemId o : openings_meant(c, true)) add_under_window(f, c.model, t, o, most);
  }
}

void compile_NearDoor(Compilation& c) { near_one(c, false); }
void compile_NearWindow(Compilation& c) { near_one(c, true); }
void compile_FarFromDoor(Compilation& c) { far_from_all(c, false); }
void compile_FarFromWindow(Compilation& c) { far_from_all(c, true); }

void compile_NotBlocking(Compilation& c) {
  std::vector<ItemId> openings = c.reference_items();
  std::erase_if(openings, [&](ItemId o) { return !c.item(o).is_opening(); });
  if (c.references.empty()) {
    openings = openings_meant(c, false);
    const std::vector<ItemId> windows = openings_meant(c, true);
    openings.insert(openings.end(), windows.begin(), windows.end());
  }
  for (const ItemId t : c.targets) {
    for (const ItemId o : openings) {
      const Item& item = c.item(o);
      const bool window = item.opening->type == OpeningType::kWindow;
      const bool flat = c.item(t).thin && (window || !c.item(t).entry->lain_on);
      if (flat || (window && c.item(t).curtain)) {  // in nobody's way
        c.formula().add();
        continue;
      }
      const Mm depth = c.relation.parameters.depth.value_or(window ? 500 : item.opening->width);
      const bool swings =
          item.opening->type == OpeningType::kDoor && (item.opening->swing == Swing::kInLeft || item.opening->swing == Swing::kInRight);
      Formula& f = c.formula();
      const auto add = [&](std::vector<Case>& cases, Mm deep) {
        for_each_turn(item, [&](int turn, std::uint64_t states) {
          const Direction in = side_direction(item, Side::kFront, turn), side{across(in), 1};
          cases.emplace_back().when(o, states).require(gap_towards(t, o, in) - Linear(deep));
          cases.emplace_back().when(o, states).require(gap_towards(t, o, side));
          cases.emplace_back().when(o, states).require(gap_towards(t, o, opposite(side)));
          cases.emplace_back().when(o, states).require(gap_towards(t, o, {2, -1}));
          cases.emplace_back().when(o, states).require(gap_towards(t, o, {2, 1}));
        });
      };
      // The quarter disc that the door sweeps lies within the box as deep as the door is wide.
      add(f.cases, swings ? std::max(depth, item.opening->width) : depth);
      if (!swings || depth >= item.opening->width) continue;
      f.exact = false;
      add(f.outer, depth);
    }
  }
}

}  // namespace layoutbox::placement
