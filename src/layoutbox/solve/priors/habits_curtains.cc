// Habits of curtains: at a window, along a bed or a couch.
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {

// The bed or couch that it is told to hang next to, else where nothing is told the bed of its rank, if any.
ItemId Habits::curtained_by(ItemId item) const {
  constexpr Mm kLong = 1500;
  const auto longest_of = [&](ItemId host) {
    const Size& size = model_.items[host].states[0].size;
    return std::max(size.width, size.depth);
  };
  if (!model_.items[item].curtain) return {};
  for (const Relation* r : said_of(item)) {
    const ItemId host = r->type == RelationType::kNextTo && r->references.size() == 1 ? model_.find_item(r->references[0]) : ItemId();
    if (!host.exists() || !related_as_target(item, host, r->type) || model_.items[host].is_opening()) continue;
    if (model_.items[host].is(Trait::kBed) || longest_of(host) >= kLong) return host;
  }
  // A curtain for tubs hangs at one though nobody says so, and never at the window.
  const std::vector<ItemId> usual = items_of_kinds(model_.items[item].entry->beside, item);
  if (!usual.empty()) return usual.front();
  if (told_where_it_hangs(item)) return {};
  std::vector<ItemId> beds;
  for (const ItemId i : model_.items.ids()) {
    const Item& other = model_.items[i];
    if (!other.is_opening() && other.is(Trait::kBed) && other.mount == Mount::kFloor) beds.push_back(i);
  }
  return beds.empty() ? ItemId() : beds[static_cast<std::size_t>(rank_of(item)) % beds.size()];
}

void Habits::cover_window(ItemId item) {
  std::vector<ItemId> windows;
  for (const ItemId i : model_.items.ids()) {
    if (model_.items[i].is_opening() && model_.items[i].opening->type == OpeningType::kWindow) windows.push_back(i);
  }
  if (windows.empty()) return;
  // Several at one window share its width: each is at the one that it is told to be at, the others by turns.
  std::ptrdiff_t rank = 0, k = 0, sharing = 0;
  ItemId window;
  std::vector<std::pair<ItemId, ItemId>> hung;  // curtain, window
  for (const ItemId other : model_.items.ids()) {
    if (!model_.items[other].curtain || model_.items[other].mount != Mount::kWall) continue;
    const auto told = std::ranges::find_if(windows, [&](ItemId w) { return related_as_target(other, w, RelationType::kNextTo); });
    const ItemId at = told != windows.end() ? *told : windows[static_cast<std::size_t>(rank) % windows.size()];
    ++rank;
    if (other == item) window = at;
    hung.emplace_back(other, at);
  }
  for (const auto& [other, at] : hung) {
    if (at != window) continue;
    k += other < item, ++sharing;
  }
  const Linear aside(std::int64_t{2 * k - (sharing - 1)} * model_.items[item].states[0].size.width);
  Formula f;
  for_each_turn(model_.items[window], [&](int turn, std::uint64_t states) {
    Case& c = f.add().when(window, states).when(item, model_.items[item].states_at(turn));
    const int along = across(side_direction(model_.items[window], Side::kFront, turn));
    for (int axis = 0; axis < 2; ++axis) {
      const Linear off = mid2(item, axis) - mid2(window, axis);
      c.wish(axis == along ? off - aside : off, kCurtain, 2);
    }
  });
  habit("at its window", item, kCurtain, std::move(f), {window});
}

}  // namespace layoutbox::placement
