// Habits of what hangs from ceilings.
#include "layoutbox/catalog/groups.h"
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {
namespace {

constexpr int kStrewn = 6;  // on the ceiling

}  // namespace

bool Habits::told_where_it_hangs(ItemId item) const {
  return std::ranges::any_of(model_.scene->relations, [&](const Relation& r) {
    return r.type != RelationType::kOnCeiling && std::ranges::find(r.targets, model_.items[item].id) != r.targets.end();
  });
}

// Lamps over tables, else in the middle of the room.
void Habits::hang_from_ceiling(ItemId item) {
  // Above its thing, in its corner: the middle of the room would pull it off.
  if (hang_along(item) || share_length_of_table(item) || told_where_it_hangs(item)) return;
  const Item& self = model_.items[item];
  std::vector<ItemId> below =
      items_of_kinds(Groups::usual_at(Groups::builtin().hangs, *model_.catalog, *self.entry, Mount::kCeiling), item);
  if (self.is(Trait::kLamp))  // over no desk at a wall
    std::erase_if(below, [&](ItemId i) { return model_.items[i].entry->back_to_wall && !model_.items[i].is(Trait::kBed); });
  if (!below.empty()) std::erase_if(below, [&, kind = model_.items[below[0]].entry](ItemId i) { return model_.items[i].entry != kind; });
  // Several share the tables there are, and the length of each.
  std::vector<ItemId> peers;
  for (const ItemId other : model_.items.ids()) {
    if (model_.items[other].entry == self.entry && model_.items[other].mount == Mount::kCeiling && !told_where_it_hangs(other))
      peers.push_back(other);
  }
  const auto rank = std::ranges::find(peers, item) - peers.begin(), n = std::ssize(peers);
  const auto tables = std::max<std::ptrdiff_t>(1, std::ssize(below));
  const auto place = rank / tables, sharing = std::max<std::ptrdiff_t>(1, (n - rank % tables + tables - 1) / tables);
  const auto aside2 = [&](Mm length) { return Linear(std::int64_t{length} * (2 * place + 1 - sharing) / sharing); };
  Formula f;
  std::vector<ItemId> hosts;
  if (below.empty()) {
    const int along = model_.room.extent(0) >= model_.room.extent(1) ? 0 : 1;
    Case& c = f.add();
    c.wish(mid2(item, along) - room_mid2(model_, along) - aside2(model_.room.extent(along)), kHangs, 2);
    // Many small ones (stars, balloons) are strewn over all of it, not in one line.
    const Mm third = model_.room.extent(1 - along) / 3;
    const auto off = sharing >= kStrewn && !self.is(Trait::kLamp) ? 2 * third * (2 * place % 3 - 1) : 0;
    c.wish(mid2(item, 1 - along) - room_mid2(model_, 1 - along) - Linear(off), kHangs, 2);
  } else {
    hosts.push_back(below[static_cast<std::size_t>(rank % tables)]);
    const Size& size = model_.items[hosts[0]].states[0].size;
    f = hung_along_top(item, hosts[0], aside2(std::max(size.width, size.depth)));
  }
  habit("hangs", item, kHangs, std::move(f), hosts);
  if (hosts.empty()) hang_clear(item);
}

// Over the middle of a top, `aside2` off it along its length.
Formula Habits::hung_along_top(ItemId item, ItemId host, const Linear& aside2) const {
  Formula f;
  const Size& size = model_.items[host].states[0].size;
  for_each_turn(model_.items[host], [&](int turn, std::uint64_t states) {
    const int right = side_direction(model_.items[host], Side::kRight, turn).axis;
    const int along = size.width >= size.depth ? right : 1 - right;
    Case& c = f.add().when(host, states);
    c.wish(mid2(item, along) - mid2(host, along) - aside2, kHangs, 2);
    c.wish(mid2(item, 1 - along) - mid2(host, 1 - along), kHangs, 2);
  });
  return f;
}

// "two pendant lights above the island": of which no more is told, they share its length.
bool Habits::share_length_of_table(ItemId item) {
  const auto hung_over = [&](ItemId lamp) {
    ItemId over;
    int told = 0;
    for (const Relation& r : model_.scene->relations) {
      if (r.type == RelationType::kOnCeiling || std::ranges::find(r.targets, model_.items[lamp].id) == r.targets.end()) continue;
      ++told;
      if (r.type == RelationType::kAbove && r.references.size() == 1) over = model_.find_item(r.references[0]);
    }
    return told == 1 && over.exists() && model_.items[over].mount == Mount::kFloor ? over : ItemId();
  };
  const ItemId host = hung_over(item);
  if (!host.exists()) return false;
  std::vector<ItemId> peers;
  for (const ItemId other : model_.items.ids()) {
    if (model_.items[other].entry == model_.items[item].entry && model_.items[other].mount == Mount::kCeiling && hung_over(other) == host)
      peers.push_back(other);
  }
  const auto n = std::ssize(peers), rank = std::ranges::find(peers, item) - peers.begin();
  const Size& size = model_.items[host].states[0].size;
  const Linear aside2(std::int64_t{std::max(size.width, size.depth)} * (2 * rank + 1 - n) / n);
  habit("hangs", item, kHangs, hung_along_top(item, host, aside2), {host});
  return true;
}

// What hangs from the ceiling down to the floor beside a bed or a couch (a ward's curtain, a tub's) hangs along its long side.
bool Habits::hang_along(ItemId item) {
  constexpr Mm kOff = 120;
  const ItemId host = curtained_by(item);
  if (!host.exists()) return false;
  Formula f;
  for_each_turn(model_.items[host], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const bool wide = model_.items[host].states[0].size.width > model_.items[host].states[0].size.depth;  // a tub
    const int along = side_direction(model_.items[host], wide ? Side::kLeft : Side::kBack, turn).axis;
    for (const Side side : wide ? std::vector{Side::kFront} : std::vector{Side::kLeft, Side::kRight}) {
      const Direction d = side_direction(model_.items[host], side, turn);
      Case& c = f.add().when(host, states).when(item, states_with_width_along(model_.items[item], along));
      c.wish(gap_towards(item, host, d) - Linear(kOff), kHangs).wish(mid2(item, along) - mid2(host, along), kHangs, 2);
      c.require(gap_towards(item, host, d));
    }
  });
  habit("hangs along", item, kHangs, std::move(f), {host});
  return true;
}

// What hangs so low that one stands before it (a punching bag) hangs clear of what is on the floor, and of its like.
void Habits::hang_clear(ItemId item) {
  constexpr Mm kHeadroom = 1900, kAround = 700;
  constexpr int kClear = 600;  // points a metre
  if (model_.room.extent(2) - model_.items[item].states[0].size.height >= kHeadroom) return;
  for (const ItemId other : model_.items.ids()) {
    const Item& ref = model_.items[other];
    const bool alike = ref.entry == model_.items[item].entry && other < item;
    if (ref.is_opening() || ref.thin || !(alike || ref.mount == Mount::kFloor) || related(item, other)) continue;
    Formula f;
    for (const int axis : {0, 1}) {
      for (const int sign : {1, -1}) f.add().require(gap_towards(item, other, {axis, sign}) - Linear(kAround));
    }
    habit("hangs clear", item, kClear, std::move(f));
  }
}

}  // namespace layoutbox::placement
