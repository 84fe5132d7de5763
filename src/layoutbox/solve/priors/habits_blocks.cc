// Habits of blocks: desks in groups of four and other small grids that are told to stand together, as one formation of blocks.
#include <algorithm>

#include "layoutbox/solve/priors/formation.h"
#include "layoutbox/solve/priors/habits.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kBetweenBlocks = 1100, kSitsBeside = 450;  // what the seats take at either side of a block

// Of which block of a formation a thing is, and where in it.
struct PlaceInBlock {
  std::vector<std::vector<ItemId>> blocks;  // in the order in which they were told
  int block = 0, columns = 0, row = 0, column = 0;
};

Linear middle_of_room(const PlacementModel& model, int axis) { return Linear(std::int64_t{model.room.lo[axis]} + model.room.hi[axis]); }

// Wishes for the place of the item, a case for each way in which it may look: of two rows the first has its back up the axis.
void add_block_place(Formula& f, const PlacementModel& model, ItemId item, const PlaceInBlock& of, int weight) {
  const Size& size = model.items[item].states[0].size;
  const int blocks = static_cast<int>(of.blocks.size()), rows = (static_cast<int>(of.blocks[0].size()) + of.columns - 1) / of.columns;
  const Size block{of.columns * size.width, rows * size.depth + 2 * kSitsBeside, size.height};
  for_each_turn(model.items[item], [&](int turn, std::uint64_t states) {
    if (turn % 90 != 0) return;
    const Direction back = side_direction(model.items[item], Side::kBack, turn);
    const bool faced = rows == 2 && model.items[item].has_front;
    if (faced && back.sign != (of.row == 0 ? 1 : -1)) return;
    const int along = across(back);
    if (along != 0 && rows > 1) return;  // rows of a grid run along x
    Formation form{0, 0, 0};
    for (int tenths = 10; tenths > 0 && form.columns == 0; tenths -= 3) {
      const Mm gap = kBetweenBlocks * tenths / 10;
      form = formation_of(blocks, block, gap, gap, model.room.extent(along), model.room.extent(back.axis));
    }
    if (form.columns == 0) return;
    const int lines = (blocks + form.columns - 1) / form.columns, line = of.block / form.columns, at = of.block % form.columns;
    const int here = line + 1 == lines ? blocks - line * form.columns : form.columns;
    // Twice the way from the room's middle: of the block, and of the thing in it.
    const std::int64_t beside =
        std::int64_t{form.across} * (2 * at - (here - 1)) + std::int64_t{size.width} * (2 * of.column - (of.columns - 1));
    const std::int64_t deep = std::int64_t{form.deep} * (2 * line - (lines - 1)) + std::int64_t{size.depth} * (2 * of.row - (rows - 1));
    Case& c = f.add().when(item, states);
    c.wish(mid2(item, along) - middle_of_room(model, along) - Linear(beside), weight, 2);
    c.wish(mid2(item, back.axis) - middle_of_room(model, back.axis) - Linear(deep), weight, 2);
  });
}

// Grids and rows without gaps, of as many things of that kind in as many columns each; nothing where there is but one.
std::optional<PlaceInBlock> place_in_block(const PlacementModel& model, ItemId item) {
  PlaceInBlock place;
  bool found = false;
  for (const Relation& r : model.scene->relations) {
    const bool row = r.type == RelationType::kRow;
    if ((r.type != RelationType::kGrid && !row) || r.parameters.gap != Mm{0} || r.targets.size() < 2) continue;
    std::vector<ItemId> members;
    for (const std::string& id : r.targets) members.push_back(model.find_item(id));
    const auto other_kind = [&](ItemId m) { return !m.exists() || model.items[m].entry != model.items[item].entry; };
    if (std::ranges::any_of(members, other_kind)) continue;
    if (!place.blocks.empty() && place.blocks[0].size() != members.size()) return std::nullopt;
    if (const auto at = std::ranges::find(members, item); at != members.end()) {
      const int k = static_cast<int>(at - members.begin());
      const int n = static_cast<int>(members.size());
      place.columns = row ? n : std::max(1, r.parameters.columns.value_or((n + 1) / 2));
      place.block = static_cast<int>(place.blocks.size());
      place.row = k / place.columns, place.column = k % place.columns;
      found = true;
    }
    place.blocks.push_back(std::move(members));
  }
  if (!found || place.blocks.size() < 2) return std::nullopt;
  return place;
}

}  // namespace

bool Habits::stand_in_blocks(ItemId item) {
  const std::optional<PlaceInBlock> place = place_in_block(model_, item);
  if (!place) return false;
  Formula f;
  add_block_place(f, model_, item, *place, kFormation);
  if (f.cases.empty()) return false;
  Constraint& constraint = habit("in a block", item, kFormation, std::move(f));
  const ItemId first = place->blocks[0][0];
  constraint.formation = first, constraint.member = item;
  if (place->columns < static_cast<int>(place->blocks[0].size()) || !model_.items[item].has_front) return true;
  std::vector<ItemId> all;
  for (const std::vector<ItemId>& block : place->blocks) all.insert(all.end(), block.begin(), block.end());
  if (item != first)
    turn_as(item, first);
  else if (!told_where_to_look(item))
    look_at(item, true, all);
  return true;
}

}  // namespace layoutbox::placement
