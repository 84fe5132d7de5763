// Habits of what lies on the floor: rugs, runners and mats.
#include "layoutbox/catalog/groups.h"
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kRugBeyondFoot = 500;

}  // namespace

// A rug lies under what stands in the middle of things, else in the middle of the room; a bed would hide it, so there it shows at
// both sides and beyond the foot.
void Habits::lie_under(ItemId item) {
  if (const std::vector<ItemId> by = items_of_kinds(model_.items[item].entry->beside, item); !by.empty()) {
    lie_before_use(item, by[static_cast<std::size_t>(rank_of(item)) % by.size()]);
    return;
  }
  std::vector<ItemId> over =
      items_of_kinds(Groups::usual_at(Groups::builtin().lies, *model_.catalog, *model_.items[item].entry, Mount::kFloor), item);
  const auto beds = std::count_if(over.begin(), over.end(), [&](ItemId i) { return model_.items[i].is(Trait::kBed); });
  std::erase_if(over, [&](ItemId i) {
    if (model_.items[i].is(Trait::kBed)) return beds > 1 || !model_.items[i].is(Trait::kCenterPiece);
    return model_.items[i].is(Trait::kTable) && model_.items[i].entry->back_to_wall;
  });
  Formula f;
  if (!over.empty() && model_.items[over[rank_of(item) % static_cast<int>(over.size())]].is(Trait::kBed)) {
    lie_at_foot(item, over[rank_of(item) % static_cast<int>(over.size())]);
    return;
  }
  if (!over.empty() && model_.items[over[rank_of(item) % static_cast<int>(over.size())]].is(Trait::kCenterPiece)) {
    lie_before(item, over[rank_of(item) % static_cast<int>(over.size())]);
    return;
  }
  Case& c = f.add();
  std::vector<ItemId> hosts;
  if (!over.empty()) hosts.push_back(over[rank_of(item) % static_cast<int>(over.size())]);
  for (int axis = 0; axis < 2; ++axis) c.wish(mid2(item, axis) - (hosts.empty() ? room_mid2(model_, axis) : mid2(hosts[0], axis)), kRug, 2);
  habit("rug", item, kRug, std::move(f), hosts);
}

// A runner lies along a narrow room: down the aisle of a galley, along a hall.
void Habits::lie_lengthwise(ItemId item) {
  const Item& self = model_.items[item];
  const Size& size = self.states[0].size;
  const Mm across = model_.room.extent(0), deep = model_.room.extent(1);
  const bool is_runner = size.width >= 2 * size.depth && std::max(across, deep) * 4 >= std::min(across, deep) * 5;
  const bool free = std::ranges::all_of(model_.scene->relations, [&](const Relation& r) {
    return r.type == RelationType::kCenterOfRoom || std::ranges::find(r.targets, self.id) == r.targets.end();
  });
  if (!is_runner || !free) return;
  Formula f;
  f.add().when(item, states_with_width_along(self, across > deep ? 0 : 1));
  habit("lengthwise", item, kRug, std::move(f));
}

// "A rug next to the bed" shows: it lies at a side, not under it.
void Habits::lie_beside(ItemId item) {
  for (const Relation& r : model_.scene->relations) {
    const bool of_item = std::ranges::find(r.targets, model_.items[item].id) != r.targets.end();
    const ItemId host =
        of_item && r.type == RelationType::kNextTo && r.references.size() == 1 ? model_.find_item(r.references.front()) : ItemId();
    if (!host.exists() || model_.items[host].thin || model_.items[host].mount != Mount::kFloor) continue;
    Formula f;
    for (int axis = 0; axis < 2; ++axis) {
      for (const int sign : {1, -1}) {
        Case& c = f.add();
        c.wish(gap_towards(item, host, {axis, sign}), kRug);
        c.wish(mid2(item, 1 - axis) - mid2(host, 1 - axis), kRug, 2);
      }
    }
    habit("rug", item, kRug, std::move(f), {host});
  }
}

void Habits::lie_at_foot(ItemId item, ItemId bed) {
  // Most of it shows.
  const Mm beyond = std::max(kRugBeyondFoot, model_.items[item].states[0].size.depth * 3 / 5);
  Formula f;
  for_each_turn(model_.items[bed], [&](int turn, std::uint64_t states) {
    const Direction foot = side_direction(model_.items[bed], Side::kFront, turn);
    Case& c = f.add().when(bed, states);
    if (const std::uint64_t along = model_.items[item].states_at(turn)) c.when(item, along);
    c.wish(mid2(item, across(foot)) - mid2(bed, across(foot)), kRug, 2);
    c.wish(reach(item, foot) - reach(bed, foot) - Linear(beyond), kRug);
  });
  habit("rug", item, kRug, std::move(f), {bed});
}

// Before a sofa without a table, its front legs on it.
void Habits::lie_before(ItemId item, ItemId sofa) {
  constexpr Mm kUnderFeet = 250;
  Formula f;
  for_each_turn(model_.items[sofa], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction front = side_direction(model_.items[sofa], Side::kFront, turn);
    Case& c = f.add().when(sofa, states).when(item, states_with_width_along(model_.items[item], across(front)));
    c.wish(mid2(item, across(front)) - mid2(sofa, across(front)), kRug, 2);
    c.wish(gap_towards(item, sofa, front) + Linear(kUnderFeet), kRug);
  });
  habit("rug", item, kRug, std::move(f), {sofa});
}

// A mat lies where one steps out, or stands before the basin.
void Habits::lie_before_use(ItemId item, ItemId host) {
  constexpr Mm kOff = 80;
  const Item& ref = model_.items[host];
  const std::vector<Side> used = used_sides(ref);
  Formula f;
  for_each_turn(ref, [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    for (const Side side : used) {
      const Direction before = side_direction(ref, side, turn);
      Case& c = f.add().when(host, states).when(item, states_with_width_along(model_.items[item], across(before)));
      c.wish(mid2(item, across(before)) - mid2(host, across(before)), kRug, 2);
      c.wish(gap_towards(item, host, before) - Linear(kOff), kRug);
    }
  });
  if (!f.cases.empty()) habit("mat", item, kRug, std::move(f), {host});
}

}  // namespace layoutbox::placement
