#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/solve/model/items.h"

#include <cmath>
#include <limits>
#include <map>

#include "layoutbox/catalog/toppled.h"
#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/solve/priors/guide.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kThin = 30;  // rugs and mats up to this height are walked on
constexpr std::size_t kManyWalls = 8;
constexpr double kAboutThere = 10;  // degrees
constexpr Mm kStripGap = 50, kStripDepth = 200;

Mm step_between(Mm usual, Mm least, int step, int steps) { return usual - static_cast<Mm>(std::int64_t{usual - least} * step / steps); }

// The sizes an object may have and how far each is from the usual one: steps down to the least; for what must hold others (`grows`),
// steps up to the greatest as well.
std::vector<std::pair<Size, int>> sizes_of(const SizeRange& range, int steps, bool grows) {
  std::vector<std::pair<Size, int>> sizes{{range.usual, 0}};
  const auto add = [&](const Size& towards, int step, int of) {
    const Size size{step_between(range.usual.width, towards.width, step, of), step_between(range.usual.depth, towards.depth, step, of),
                    step_between(range.usual.height, towards.height, step, of)};
    const bool known = std::any_of(sizes.begin(), sizes.end(), [&](const auto& s) { return s.first == size; });
    if (!known) sizes.emplace_back(size, step);
  };
  for (int step = 1; step <= steps; ++step) add(range.least, step, steps);
  for (int step = 1; grows && step <= 2; ++step) add(range.greatest, step, 2);
  return sizes;
}

bool is_not_in_plan(Side side) { return side == Side::kTop || side == Side::kBottom; }

// Spaces are free lengths in a mesh: whole millimetres that lie within them.
GridBox box_of_space(const Space& space, const GridBox& own) {
  GridBox box;
  for (int k = 0; k < 3; ++k) {
    box.lo[k] = std::max(own.lo[k], static_cast<Mm>(std::ceil(space.min[k] - 1e-6)));
    box.hi[k] = std::min(own.hi[k], static_cast<Mm>(std::floor(space.max[k] + 1e-6)));
    // Odd sizes have their sides at half millimetres: what is open to a side stays open.
    if (std::abs(space.min[k] - own.lo[k]) < 1.5) box.lo[k] = own.lo[k];
    if (std::abs(space.max[k] - own.hi[k]) < 1.5) box.hi[k] = own.hi[k];
  }
  return box;
}

// The floor that its use wants free, less what words give to something else: the back of a chair told to stand at a wall, a counter's
// front told to have stools, the sides of a bed told to be flanked.
std::map<Side, Mm> floor_wanted_at_sides(const SceneGraph& scene, const SceneObject& object, const CatalogEntry& entry,
                                         const Catalog& catalog) {
  std::map<Side, Mm> wanted = entry.clearance;
  for (const Relation& r : scene.relations) {
    const auto names = [&](const std::vector<std::string>& ids) { return std::find(ids.begin(), ids.end(), object.id) != ids.end(); };
    if ((r.type == RelationType::kAgainstWall || r.type == RelationType::kCorner) && names(r.targets)) wanted.erase(Side::kBack);
    if (r.type == RelationType::kEachSideOf && names(r.references)) wanted.erase(Side::kLeft), wanted.erase(Side::kRight);
    if (r.type != RelationType::kInFrontOf || !names(r.references)) continue;
    const SceneObject* seat = r.targets.empty() ? nullptr : scene.find_object(r.targets.front());
    if (seat && catalog.entry_or_nearest(seat->category).is(Trait::kTableSeat)) wanted.erase(Side::kFront);
  }
  return wanted;
}

State make_state(const SceneObject& object, const CatalogEntry& entry, const std::map<Side, Mm>& wanted, const Size& size, int step,
                 double turn, std::vector<ItemSpace>* describe) {
  State state;
  state.turn = nearest_turn(turn), state.angle = turn, state.size_step = step, state.size = size;
  const GridBox own = own_box(size);
  const GridBox whole = turned(own, turn);
  for (int k = 0; k < 3; ++k) state.extent[k] = whole.extent(k);
  const std::vector<Space> spaces = spaces_of(object, entry, size);
  std::vector<GridBox> holes;
  for (const Space& space : spaces) {
    const GridBox hole = box_of_space(space, own);
    if (!hole.empty()) holes.push_back(hole);
    const GridBox here = within_turned(own, hole, turn);
    if (describe) {
      describe->push_back(
          {space.name, space.carries, hole.hi[2] >= size.height, kFirstConstant + static_cast<int>(state.constants.size())});
    }
    state.constants.insert(state.constants.end(), here.lo.begin(), here.lo.end());
    state.constants.insert(state.constants.end(), here.hi.begin(), here.hi.end());
  }
  const std::vector<GridBox> solids = less(own, holes);
  for (const GridBox& solid : solids) state.solids.push_back(in_turned(own, solid, turn));
  if (!is_quarter(state)) state.own_solids = solids;
  const std::vector<Side> used = object.used_sides.value_or(entry.used_sides);
  for (const Side side : used) {
    if (!is_not_in_plan(side)) state.strips.push_back(in_turned(own, beside(own, side, kStripGap, kStripGap + kStripDepth, 1800), turn));
  }
  for (const auto& [side, depth] : wanted) {
    if (!is_not_in_plan(side) && depth > 0) state.wanted.push_back(in_turned(own, beside(own, side, 0, depth, 1800), turn));
  }
  return state;
}

// The turns an object may take.
std::vector<int> turns_of(const Item& item, const SceneObject& object, bool odd_angles) {
  if (item.fixed) return {static_cast<int>(std::lround(normalized_degrees(object.hint.rotation_deg.value_or(0)))) % 360};
  const bool hangs = item.mount == Mount::kCeiling && item.usual_mount == Mount::kCeiling;
  if (item.thin || (hangs && !item.has_front)) return {0, 90};
  const Size& size = object.size->usual;
  const bool wall = item.mount == Mount::kWall || item.mount == Mount::kHung;
  if (!item.has_front && !wall && size.width == size.depth) return {0};
  if (!item.has_front && !wall) return {0, 90};
  std::vector<int> turns{0, 90, 180, 270};
  for (int turn = 15; odd_angles && turn < 360; turn += 15) {
    if (turn % 90 != 0) turns.push_back(turn);
  }
  return turns;
}

// The walls at which it may stand: those that somebody's words name, else all.
std::vector<RoomWall> walls_for(const SceneGraph& scene, const std::string& id, std::span<const RoomWall> walls) {
  std::vector<RoomWall> named;
  for (const Relation& r : scene.relations) {
    const bool at_wall = says_too(r.type, RelationType::kAgainstWall);
    if (!at_wall || !r.hard || std::find(r.targets.begin(), r.targets.end(), id) == r.targets.end()) continue;
    for (const RoomWall& wall : walls) {
      if (std::find(r.references.begin(), r.references.end(), wall.id) != r.references.end()) named.push_back(wall);
    }
  }
  return named.empty() ? std::vector<RoomWall>(walls.begin(), walls.end()) : named;
}

// Where walls are slanted, what has a front may have its back to them or look at them; what has none lies along or across them.
void add_turns_at_walls(const Item& item, std::span<const RoomWall> walls, std::vector<double>& turns) {
  if (item.fixed || item.locked || item.mount == Mount::kCeiling) return;
  if (!item.has_front && !item.thin && (item.is(Trait::kRound) || item.mount != Mount::kFloor)) return;
  const bool hangs = item.mount == Mount::kWall || item.mount == Mount::kHung;
  const bool alike_behind = !hangs && (item.thin || !item.has_front);  // half a turn changes nothing
  const auto add = [&](double turn, double off) {
    turn = std::fmod(std::round(turn * 1e4) / 1e4, alike_behind ? 180 : 360);
    const auto same = [&](double known) { return std::abs(std::remainder(known - turn, 360)) <= off; };
    if (turns.size() < kMostStates && std::none_of(turns.begin(), turns.end(), same)) turns.push_back(turn);
  };
  for (const RoomWall& wall : walls) {
    if (!wall.straight) add(wall.angle, 0);
  }
  // Who looks at one of many walls, as in a round room, need not do so to a degree.
  const double off = walls.size() > kManyWalls ? kAboutThere : 0;
  for (const RoomWall& wall : walls) {
    if (!wall.straight && !hangs && !item.thin) add(wall.angle + (item.has_front ? 180 : 90), item.has_front ? off : 0);
  }
}

// So many sizes that the states are not too many: the usual one, the least, then those between.
void keep_few(std::vector<std::pair<Size, int>>& sizes, std::size_t most) {
  if (sizes.size() <= most) return;
  if (most < 2) {
    sizes.resize(1);
    return;
  }
  const auto least = std::min_element(sizes.begin() + 1, sizes.end(), [](const auto& a, const auto& b) {
    return std::int64_t{a.first.width} * a.first.depth < std::int64_t{b.first.width} * b.first.depth;
  });
  std::rotate(sizes.begin() + 1, least, least + 1);
  sizes.resize(most);
}

// The scene's own turn, where it is an odd one.
void add_hinted_turn(const Item& item, std::vector<double>& turns) {
  if (item.fixed || !item.has_front || item.mount != Mount::kFloor || !item.object->hint.rotation_deg) return;
  const double turn = std::round(normalized_degrees(*item.object->hint.rotation_deg) * 1e4) / 1e4;
  const auto same = [&](double known) { return std::abs(std::remainder(known - turn, 360)) < 0.5; };
  if (turns.size() < kMostStates && std::none_of(turns.begin(), turns.end(), same)) turns.push_back(turn);
}

// Seats around something may stand at odd angles, of other things where they are many.
bool sits_around(const SceneGraph& scene, const std::string& id, bool seat) {
  return std::any_of(scene.relations.begin(), scene.relations.end(), [&](const Relation& r) {
    const bool many = r.targets.size() >= 5 || (seat && r.targets.size() == 3);  // four stand square
    return traits_of(r.type).around && many && std::find(r.targets.begin(), r.targets.end(), id) != r.targets.end();
  });
}

// What a relation hangs on a wall or from the ceiling is mounted so, whatever its kind usually is.
Mount mount_of(const SceneGraph& scene, const SceneObject& object, const CatalogEntry& entry) {
  for (const Relation& r : scene.relations) {
    if (!r.hard || std::find(r.targets.begin(), r.targets.end(), object.id) == r.targets.end()) continue;
    if (r.type == RelationType::kOnWall) return Mount::kWall;
    if (r.type == RelationType::kOnCeiling) return Mount::kCeiling;
  }
  return object.mount.value_or(entry.mount);
}

// Words put it on or into something: a rug there is no longer one that is walked on.
bool rests_on_others(const SceneGraph& scene, const std::string& id) {
  return std::any_of(scene.relations.begin(), scene.relations.end(), [&](const Relation& r) {
    const bool rests = traits_of(r.type).supports;
    const auto at = std::find(r.targets.begin(), r.targets.end(), id);
    if (!rests || at == r.targets.end()) return false;
    const auto is_object = [&](const std::string& reference) { return scene.find_object(reference) || scene.find_opening(reference); };
    return (r.type == RelationType::kStacked && at != r.targets.begin()) ||
           std::any_of(r.references.begin(), r.references.end(), is_object);
  });
}

bool holds_others(const SceneGraph& scene, const std::string& id) {
  return std::any_of(scene.relations.begin(), scene.relations.end(), [&](const Relation& r) {
    const bool holds = traits_of(r.type).rests || r.type == RelationType::kUnder;
    return holds && std::find(r.references.begin(), r.references.end(), id) != r.references.end();
  });
}

}  // namespace

// "A bench faces the plinth", "two tables face the judge": the long side of what has no front of its own looks there.
bool told_to_look(const SceneGraph& scene, const Item& item) {
  if (item.mount != Mount::kFloor || item.entry->thin) return false;
  return std::ranges::any_of(scene.relations, [&](const Relation& r) {
    const bool told = r.type == RelationType::kFacing && r.hard && (r.origin == Origin::kAsked || !item.is(Trait::kRound));
    const bool at_things = std::ranges::any_of(r.references, [&](const std::string& id) { return scene.find_object(id) != nullptr; });
    return told && at_things && std::ranges::find(r.targets, item.id) != r.targets.end();
  });
}

// "The stool in front of the table, the dress form to its right": of what has no front they are meant as one looks into the room, so it
// lies as the room does, where there is the width for it and nothing says how it lies.
bool lies_as_the_room(const SceneGraph& scene, const Item& item) {
  if (item.has_front || item.mount != Mount::kFloor || item.entry->thin) return false;
  const auto is_side = [](RelationType type) { return traits_of(type).placing == Placing::kSide; };
  const auto has = [&](const std::vector<std::string>& ids) { return std::ranges::find(ids, item.id) != ids.end(); };
  const bool said =
      std::ranges::any_of(scene.relations, [&](const Relation& r) { return r.asked() && is_side(r.type) && has(r.references); });
  const bool placed = std::ranges::any_of(scene.relations, [&](const Relation& r) {
    return r.asked() && has(r.targets) && !is_side(r.type) && r.type != RelationType::kCenterOfRoom && r.type != RelationType::kInRegion;
  });
  if (!said || placed) return false;
  constexpr Mm kPassage = 800;
  Mm least = std::numeric_limits<Mm>::max(), greatest = std::numeric_limits<Mm>::min();
  for (const Point& corner : scene.room.polygon) least = std::min(least, corner.x), greatest = std::max(greatest, corner.x);
  return item.object->size->usual.width + kPassage <= greatest - least;
}

Item object_item(const SceneGraph& scene, const SceneObject& object, const Catalog& catalog, const ModelOptions& options,
                 std::span<const RoomWall> walls) {
  Item item;
  item.id = object.id;
  item.object = &object;
  item.entry = &catalog.entry_or_nearest(object.category);
  item.mount = mount_of(scene, object, *item.entry);
  item.toppled = is_toppled(object.attributes, item.mount);
  item.usual_mount = object.mount.value_or(item.entry->mount);
  item.has_front = item.entry->has_front || told_to_look(scene, item);
  item.thin = item.entry->thin && object.size->usual.height <= kThin && item.mount == Mount::kFloor && !rests_on_others(scene, object.id);
  item.curtain = item.is(Trait::kCurtain);
  item.fixed = object.fixed && object.hint.position.has_value();
  const bool odd = sits_around(scene, object.id, item.is(Trait::kSeat));
  auto sizes = sizes_of(*object.size, item.fixed ? 0 : odd ? 1 : options.size_steps, !item.fixed && !odd && holds_others(scene, object.id));
  std::vector<int> turns = lies_as_the_room(scene, item) ? std::vector<int>{0} : turns_of(item, object, odd);
  if (!item.fixed) add_earlier_pose(options, item, sizes, turns);
  std::vector<double> angles(turns.begin(), turns.end());
  add_turns_at_walls(item, walls_for(scene, object.id, walls), angles);
  add_hinted_turn(item, angles);
  keep_few(sizes, kMostStates / angles.size());
  const std::map<Side, Mm> wanted = floor_wanted_at_sides(scene, object, *item.entry, catalog);
  for (const auto& [size, step] : sizes) {
    for (const double turn : angles) {
      const bool first = item.states.empty();
      item.states.push_back(make_state(object, *item.entry, wanted, size, step, turn, first ? &item.spaces : nullptr));
    }
  }
  note_odd_states(item);
  if (item.fixed) {
    const auto& at = *object.hint.position;
    const Vec3& e = item.states[0].extent;
    for (int k = 0; k < 3; ++k) item.fixed_at[k] = static_cast<Mm>(std::lround(at[k] - (k < 2 ? e[k] / 2.0 : 0)));
  }
  return item;
}

}  // namespace layoutbox::placement
