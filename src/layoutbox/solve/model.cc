#include "layoutbox/solve/model.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "layoutbox/solve/compile.h"
#include "layoutbox/solve/guide.h"

namespace layoutbox::placement {
namespace {

constexpr std::size_t kMostObjects = 500;
constexpr Mm kWindowDepth = 500;  // kept free before a window, above its sill
constexpr Mm kOpeningDepth = 0;   // an opening is a box of no depth in the wall's inner face
constexpr Mm kThin = 30;          // rugs and mats up to this height are walked on
constexpr Mm kStripGap = 50, kStripDepth = 200;

int turn_of_wall(int along, int inward) { return along == 0 ? (inward < 0 ? 0 : 180) : (inward > 0 ? 90 : 270); }

RoomWall room_wall(const Wall& wall) {
  RoomWall out;
  out.id = wall.id;
  const Point a = wall.start, b = wall.end;
  out.straight = a.x == b.x || a.y == b.y;
  out.along = std::abs(b.x - a.x) >= std::abs(b.y - a.y) ? 0 : 1;
  const Mm from = out.along == 0 ? a.x : a.y, to = out.along == 0 ? b.x : b.y;
  out.at = out.along == 0 ? a.y : a.x;
  out.lo = std::min(from, to), out.hi = std::max(from, to);
  out.runs_up = to > from;
  // Counter-clockwise: the room lies to the left of the wall's direction.
  out.inward = out.along == 0 ? (out.runs_up ? 1 : -1) : (out.runs_up ? -1 : 1);
  out.turn = turn_of_wall(out.along, out.inward);
  return out;
}

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

// An object's own box with its origin under the middle of the footprint; odd lengths put the extra millimetre on the high side.
Box own_box(const Size& size) {
  return {{-(size.width / 2), -(size.depth / 2), 0}, {size.width - size.width / 2, size.depth - size.depth / 2, size.height}};
}

// A box in the object's frame as it lies in the turned box, from its low corner.
Box in_turned(const Box& own, const Box& box, int turn) {
  const Box whole = turned(own, turn);
  return turned(box, turn).shifted({-whole.lo[0], -whole.lo[1], -whole.lo[2]});
}

// Free floor at a side of an own box: `from` to `to` off it.
Box beside(const Box& own, Side side, Mm from, Mm to, Mm height) {
  Box strip = own;
  strip.lo[2] = 0, strip.hi[2] = height;
  switch (side) {
    case Side::kFront: strip.hi[1] = own.lo[1] - from, strip.lo[1] = own.lo[1] - to; break;
    case Side::kBack: strip.lo[1] = own.hi[1] + from, strip.hi[1] = own.hi[1] + to; break;
    case Side::kLeft: strip.hi[0] = own.lo[0] - from, strip.lo[0] = own.lo[0] - to; break;
    default: strip.lo[0] = own.hi[0] + from, strip.hi[0] = own.hi[0] + to; break;
  }
  return strip;
}

bool is_not_in_plan(Side side) { return side == Side::kTop || side == Side::kBottom; }

// Spaces are free lengths in a mesh: whole millimetres that lie within them.
Box box_of_space(const Space& space, const Box& own) {
  Box box;
  for (int k = 0; k < 3; ++k) {
    box.lo[k] = std::max(own.lo[k], static_cast<Mm>(std::ceil(space.min[k] - 1e-6)));
    box.hi[k] = std::min(own.hi[k], static_cast<Mm>(std::floor(space.max[k] + 1e-6)));
    // Odd sizes have their sides at half millimetres: what is open to a side stays open.
    if (std::abs(space.min[k] - own.lo[k]) < 1.5) box.lo[k] = own.lo[k];
    if (std::abs(space.max[k] - own.hi[k]) < 1.5) box.hi[k] = own.hi[k];
  }
  return box;
}

State make_state(const SceneObject& object, const CatalogEntry& entry, const Size& size, int step, int turn,
                 std::vector<ItemSpace>* describe) {
  State state;
  state.turn = turn, state.size_step = step, state.size = size;
  const Box own = own_box(size);
  const Box whole = turned(own, turn);
  for (int k = 0; k < 3; ++k) state.extent[k] = whole.extent(k);
  const std::vector<Space> spaces = object.spaces_given ? object.spaces : spaces_at(entry, size);
  std::vector<Box> holes;
  for (const Space& space : spaces) {
    const Box hole = box_of_space(space, own);
    if (!hole.empty()) holes.push_back(hole);
    const Box here = in_turned(own, hole, turn);
    if (describe) {
      describe->push_back(
          {space.name, space.carries, hole.hi[2] >= size.height, kFirstConstant + static_cast<int>(state.constants.size())});
    }
    state.constants.insert(state.constants.end(), here.lo.begin(), here.lo.end());
    state.constants.insert(state.constants.end(), here.hi.begin(), here.hi.end());
  }
  for (const Box& solid : less(own, holes)) state.solids.push_back(in_turned(own, solid, turn));
  const std::vector<Side> used = object.used_sides.value_or(entry.used_sides);
  for (const Side side : used) {
    if (!is_not_in_plan(side)) state.strips.push_back(in_turned(own, beside(own, side, kStripGap, kStripGap + kStripDepth, 1800), turn));
  }
  for (const auto& [side, depth] : entry.clearance) {
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

// Seats around something may stand at odd angles.
bool sits_around(const SceneGraph& scene, const std::string& id) {
  return std::any_of(scene.relations.begin(), scene.relations.end(), [&](const Relation& r) {
    const bool around = r.type == RelationType::kAround || r.type == RelationType::kSurround;
    return around && r.targets.size() >= 5 && std::find(r.targets.begin(), r.targets.end(), id) != r.targets.end();
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
    const bool rests = r.type == RelationType::kOn || r.type == RelationType::kIn || r.type == RelationType::kStacked;
    const auto at = std::find(r.targets.begin(), r.targets.end(), id);
    if (!rests || at == r.targets.end()) return false;
    const auto is_object = [&](const std::string& reference) { return scene.find_object(reference) || scene.find_opening(reference); };
    return (r.type == RelationType::kStacked && at != r.targets.begin()) ||
           std::any_of(r.references.begin(), r.references.end(), is_object);
  });
}

bool holds_others(const SceneGraph& scene, const std::string& id) {
  return std::any_of(scene.relations.begin(), scene.relations.end(), [&](const Relation& r) {
    const bool holds = r.type == RelationType::kOn || r.type == RelationType::kIn;
    return holds && std::find(r.references.begin(), r.references.end(), id) != r.references.end();
  });
}

Item object_item(const SceneGraph& scene, const SceneObject& object, const Catalog& catalog, const ModelOptions& options) {
  Item item;
  item.id = object.id;
  item.object = &object;
  item.entry = &catalog.entry_or_nearest(object.category);
  item.mount = mount_of(scene, object, *item.entry);
  item.usual_mount = object.mount.value_or(item.entry->mount);
  item.has_front = item.entry->has_front;
  item.thin = item.entry->thin && object.size->usual.height <= kThin && item.mount == Mount::kFloor && !rests_on_others(scene, object.id);
  item.curtain =
      catalog.is_a(object.category, "curtain") || catalog.is_a(object.category, "blinds") || catalog.is_a(object.category, "blind");
  item.fixed = object.fixed && object.hint.position.has_value();
  const bool odd = sits_around(scene, object.id);
  auto sizes = sizes_of(*object.size, item.fixed ? 0 : odd ? 1 : options.size_steps, !item.fixed && !odd && holds_others(scene, object.id));
  std::vector<int> turns = turns_of(item, object, odd);
  if (!item.fixed) add_earlier_pose(options, item, sizes, turns);
  for (const auto& [size, step] : sizes) {
    for (const int turn : turns) {
      const bool first = item.states.empty();
      item.states.push_back(make_state(object, *item.entry, size, step, turn, first ? &item.spaces : nullptr));
    }
  }
  if (item.fixed) {
    const auto& at = *object.hint.position;
    const Vec3& e = item.states[0].extent;
    for (int k = 0; k < 3; ++k) item.fixed_at[k] = static_cast<Mm>(std::lround(at[k] - (k < 2 ? e[k] / 2.0 : 0)));
  }
  return item;
}

// The wall at an angle in which an opening is: the one it names, the longest where no wall of the room runs along x or y; else null.
// An opening there does not move: it is where its offset says, in the middle of the wall where it says nothing.
const Wall* angled_wall_of(const Opening& opening, const Room& room) {
  const Wall* found = nullptr;
  double longest = 0;
  for (const Wall& wall : room.walls) {
    const double length = std::hypot(wall.end.x - wall.start.x, wall.end.y - wall.start.y);
    const bool straight = room_wall(wall).straight;
    if (wall.id == opening.wall) return straight ? nullptr : &wall;
    if (straight && opening.wall.empty()) return nullptr;
    if (opening.wall.empty() && length > longest) longest = length, found = &wall;
  }
  return found;
}

int turn_of_angled(const Wall& wall) {
  const double turn = std::atan2(wall.start.y - wall.end.y, wall.start.x - wall.end.x) * 180 / kPi;
  return static_cast<int>(std::lround(normalized_degrees(turn))) % 360;
}

// The low corner of the box around an opening in such a wall.
std::array<Mm, 2> place_in_angled(const Wall& wall, const Opening& opening, const Vec3& extent, const Box& room) {
  const double dx = wall.end.x - wall.start.x, dy = wall.end.y - wall.start.y, length = std::hypot(dx, dy);
  const double middle = (opening.offset ? *opening.offset + opening.width / 2.0 : length / 2) / length;
  const double at[2] = {wall.start.x + dx * middle, wall.start.y + dy * middle};
  std::array<Mm, 2> low{};
  for (int k = 0; k < 2; ++k) {
    low[k] = static_cast<Mm>(std::lround(at[k] - extent[k] / 2.0));
    low[k] = std::max(room.lo[k], std::min(low[k], room.hi[k] - extent[k]));
  }
  return low;
}

Item opening_item(const Opening& opening, const Room& room, const std::vector<RoomWall>& walls) {
  Item item;
  item.id = opening.id;
  item.opening = &opening;
  item.mount = Mount::kWall;
  std::set<int> turns;
  for (const RoomWall& wall : walls) {
    if (wall.straight && (opening.wall.empty() || wall.id == opening.wall)) turns.insert(wall.turn);
  }
  if (const Wall* angled = angled_wall_of(opening, room)) turns = {turn_of_angled(*angled)};
  const Mm depth = opening.type == OpeningType::kWindow ? kWindowDepth : opening.width;
  for (const int turn : turns) {
    State state;
    state.turn = turn;
    state.size = {opening.width, kOpeningDepth, opening.height};
    const Box own = own_box(state.size);
    const Box whole = turned(own, turn);
    for (int k = 0; k < 3; ++k) state.extent[k] = whole.extent(k);
    state.clear.push_back(in_turned(own, beside(own, Side::kFront, 0, depth, opening.height), turn));
    item.states.push_back(std::move(state));
  }
  return item;
}

// Where an opening may be: in one of the walls it fits, where it is when that is given.
Constraint opening_place(const Model& model, int index) {
  const Item& item = model.items[index];
  const Opening& opening = *item.opening;
  Constraint out;
  out.name = "place of " + item.id;
  out.firmness = Firmness::kAlways;
  Formula& f = out.formulas.emplace_back();
  if (const Wall* angled = angled_wall_of(opening, model.scene->room)) {
    Case& c = f.add();
    const auto low = place_in_angled(*angled, opening, item.states[0].extent, model.room);
    for (int k = 0; k < 2; ++k) c.require_small(lo(index, k) - Linear(low[k]), 0);
    c.require_small(lo(index, 2) - Linear(opening.sill), 0);
  }
  for (const RoomWall& wall : model.walls) {
    if (!wall.straight || (!opening.wall.empty() && wall.id != opening.wall)) continue;
    Case& c = f.add();
    c.when(index, item.states_at(wall.turn));
    c.require_small(lo(index, wall.normal()) - Linear(wall.at), 0).require_small(lo(index, 2) - Linear(opening.sill), 0);
    if (opening.offset) {
      const Mm low = wall.runs_up ? wall.lo + *opening.offset : wall.hi - *opening.offset - opening.width;
      c.require_small(lo(index, wall.along) - Linear(low), 0);
      continue;
    }
    const Mm margin = std::min<Mm>(100, std::max<Mm>(0, (wall.hi - wall.lo - opening.width) / 2));
    c.require(lo(index, wall.along) - Linear(wall.lo + margin)).require(Linear(wall.hi - margin) - hi(index, wall.along));
  }
  return out;
}

Constraint opening_clearance(const Item& item) {
  Constraint out;
  out.name = (item.opening->type == OpeningType::kWindow ? "free space before " : "door swing of ") + item.id;
  out.firmness = Firmness::kImplied;
  out.weight = 1;
  return out;
}

// Which pairs are so close that their spaces count.
std::set<std::pair<int, int>> close_pairs(const Model& model) {
  std::set<std::pair<int, int>> pairs;
  const auto add = [&](int a, int b) {
    if (a >= 0 && b >= 0 && a != b) pairs.insert({std::min(a, b), std::max(a, b)});
  };
  for (const Relation& relation : model.scene->relations) {
    for (const std::string& target : relation.targets) {
      for (const std::string& reference : relation.references) add(model.find_item(target), model.find_item(reference));
    }
    for (std::size_t i = 1; i < relation.targets.size(); ++i) {
      if (relation.type == RelationType::kStacked) add(model.find_item(relation.targets[i - 1]), model.find_item(relation.targets[i]));
    }
  }
  for (std::size_t i = 0; i < model.items.size(); ++i) {
    const Item& item = model.items[i];
    if (item.is_opening()) continue;
    for (const SupportOption& support : item.supports) {
      if (support.kind == SupportOption::Kind::kItem) add(static_cast<int>(i), support.index);
    }
    for (std::size_t j = 0; j < model.items.size(); ++j) {
      const auto goes_with = [&](const std::string& kind) { return model.is_a(static_cast<int>(j), kind); };
      if (j != i && std::any_of(item.entry->beside.begin(), item.entry->beside.end(), goes_with))
        add(static_cast<int>(i), static_cast<int>(j));
    }
  }
  return pairs;
}

void set_pair_rules(Model& model) {
  const std::size_t n = model.items.size();
  model.pairs.assign(n * n, PairRule::kBoxes);
  const auto rule_of = [&](const Item& a, const Item& b) {
    if (a.thin || b.thin) return PairRule::kFree;
    if (a.is_opening() && b.is_opening()) return PairRule::kOpenings;
    const bool window =
        (a.is_opening() && a.opening->type == OpeningType::kWindow) || (b.is_opening() && b.opening->type == OpeningType::kWindow);
    if (window && (a.curtain || b.curtain)) return PairRule::kFree;
    return PairRule::kBoxes;
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i; j < n; ++j) {
      model.set_pair(static_cast<int>(i), static_cast<int>(j), i == j ? PairRule::kFree : rule_of(model.items[i], model.items[j]));
    }
  }
  for (const auto& [a, b] : close_pairs(model)) {
    if (model.pair(a, b) == PairRule::kBoxes && !model.items[a].is_opening() && !model.items[b].is_opening())
      model.set_pair(a, b, PairRule::kSolids);
  }
  for (std::size_t i = 0; i < n; ++i) {  // what stands on a sill may be before the window
    for (const SupportOption& support : model.items[i].supports) {
      if (support.kind == SupportOption::Kind::kSill) model.set_pair(static_cast<int>(i), support.index, PairRule::kFree);
    }
  }
}

std::vector<int> items_of(const std::vector<Case>& cases) {
  std::set<int> items;
  for (const Case& one : cases) {
    for (const StateLiteral& literal : one.states) items.insert(literal.item);
    for (const Linear& form : one.at_least_zero) {
      for (const Term& term : form.terms) items.insert(term.item);
    }
    for (const Preference& wish : one.wishes) {
      for (const Term& term : wish.form.terms) items.insert(term.item);
    }
  }
  return {items.begin(), items.end()};
}

void index_constraints(Model& model) {
  model.touching.assign(model.items.size(), {});
  for (std::size_t c = 0; c < model.constraints.size(); ++c) {
    std::set<int> items;
    for (Formula& formula : model.constraints[c].formulas) {
      formula.items = items_of(formula.cases);
      items.insert(formula.items.begin(), formula.items.end());
    }
    for (const int item : items) model.touching[item].push_back(static_cast<int>(c));
  }
}

Status add_relations(Model& model) {
  const SceneGraph& scene = *model.scene;
  for (std::size_t i = 0; i < scene.relations.size(); ++i) {
    const Relation& relation = scene.relations[i];
    Constraint constraint;
    constraint.name = relation.id;
    constraint.relation = static_cast<int>(i);
    constraint.firmness = relation.hard ? Firmness::kHard : Firmness::kSoft;
    constraint.weight = relation.hard ? relation.weight : 4 * relation.weight;
    LAYOUTBOX_CHECK(compile_relation(model, relation, fmt::format("/constraints/{}", i), constraint));
    model.constraints.push_back(std::move(constraint));
  }
  return {};
}

}  // namespace

std::uint64_t Item::states_at(int turn) const {
  std::uint64_t mask = 0;
  for (std::size_t s = 0; s < states.size(); ++s) {
    if (states[s].turn == turn) mask |= std::uint64_t{1} << s;
  }
  return mask;
}

Mm Item::least_extent(int axis) const {
  Mm least = states.empty() ? 0 : states[0].extent[axis];
  for (const State& state : states) least = std::min(least, state.extent[axis]);
  return least;
}

void Model::set_pair(int a, int b, PairRule rule) {
  pairs[static_cast<std::size_t>(a) * items.size() + b] = rule;
  pairs[static_cast<std::size_t>(b) * items.size() + a] = rule;
}

int Model::find_item(std::string_view id) const {
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].id == id) return static_cast<int>(i);
  }
  return -1;
}

int Model::find_wall(std::string_view id) const {
  const Wall* wall = scene->find_wall(id);
  return wall ? static_cast<int>(wall - scene->room.walls.data()) : -1;
}

bool Model::is_a(int item, std::string_view kind) const {
  const SceneObject* object = items[item].object;
  return object && (catalog->is_a(object->category, kind) || catalog->is_a(items[item].entry->id, kind));
}

Result<Model> build_model(const SceneGraph& scene, const Catalog& catalog, const ModelOptions& options) {
  if (scene.objects.size() > kMostObjects) {
    return fail(ErrorCode::kTooLarge, fmt::format("{} objects are more than the {} that can be placed", scene.objects.size(), kMostObjects),
                "/furniture");
  }
  Model model;
  model.scene = &scene;
  model.catalog = &catalog;
  const std::vector<Point>& polygon = scene.room.polygon;
  model.room = {{polygon[0].x, polygon[0].y, 0}, {polygon[0].x, polygon[0].y, scene.room.height}};
  for (const Point& p : polygon) {
    model.room.lo[0] = std::min(model.room.lo[0], p.x), model.room.hi[0] = std::max(model.room.hi[0], p.x);
    model.room.lo[1] = std::min(model.room.lo[1], p.y), model.room.hi[1] = std::max(model.room.hi[1], p.y);
  }
  model.outside = outside_of(polygon, 0, scene.room.height, 100);
  for (const Wall& wall : scene.room.walls) model.walls.push_back(room_wall(wall));
  for (const SceneObject& object : scene.objects) model.items.push_back(object_item(scene, object, catalog, options));
  for (const Opening& opening : scene.room.openings) model.items.push_back(opening_item(opening, scene.room, model.walls));
  for (Item& item : model.items) {
    item.all_states = item.states.size() >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << item.states.size()) - 1;
  }
  for (std::size_t i = 0; i < model.items.size(); ++i) {
    Item& item = model.items[i];
    item.support_constraint = static_cast<int>(model.constraints.size());
    model.constraints.push_back(item.is_opening() ? opening_place(model, static_cast<int>(i))
                                                  : compile_support(model, static_cast<int>(i)));
    if (item.is_opening()) {
      item.clearance_constraint = static_cast<int>(model.constraints.size());
      model.constraints.push_back(opening_clearance(item));
    }
  }
  set_pair_rules(model);
  LAYOUTBOX_CHECK(add_relations(model));
  LAYOUTBOX_CHECK(find_starts(model, options));
  add_habits(model);
  add_stays(model);
  add_differences(model, options.unlike);
  index_constraints(model);
  return model;
}

std::int64_t value_of(const Model& model, const Linear& form, const Placements& placements) {
  std::int64_t sum = form.constant;
  for (const Term& term : form.terms) sum += term.coefficient * value_of(model.items[term.item], placements[term.item], term.quantity);
  return sum;
}

bool all_placed(const Formula& formula, const Placements& placements) {
  return std::all_of(formula.items.begin(), formula.items.end(), [&](int item) { return placements[item].state >= 0; });
}

std::int64_t miss_of(const Model& model, const Formula& formula, const Placements& placements) {
  std::int64_t least = std::numeric_limits<std::int64_t>::max() / 4;
  for (const Case& one : formula.cases) {
    std::int64_t miss = 0;
    for (const StateLiteral& literal : one.states) {
      if (!(literal.states >> placements[literal.item].state & 1)) miss = std::max(miss, kStateMiss);
    }
    for (const Linear& form : one.at_least_zero) {
      if (miss >= least) break;
      miss = std::max(miss, -value_of(model, form, placements));
    }
    least = std::min(least, miss);
    if (least == 0) break;
  }
  return least;
}

std::int64_t miss_of(const Model& model, const Constraint& constraint, const Placements& placements) {
  std::int64_t worst = 0;
  for (const Formula& formula : constraint.formulas) worst = std::max(worst, miss_of(model, formula, placements));
  return worst;
}

Direction side_direction(const Item& item, Side side, int turn) {
  Direction d{1, -1};
  if (side == Side::kBack) d = {1, 1};
  if (side == Side::kLeft) d = {0, -1};
  if (side == Side::kRight) d = {0, 1};
  return item.has_front ? turned(d, ((turn + 45) / 90 * 90) % 360) : d;
}

namespace {

bool bodies_overlap(const State& a, const Vec3& at_a, const State& b, const Vec3& at_b) {
  for (const Box& x : a.solids) {
    const Box here = x.shifted(at_a);
    for (const Box& y : b.solids) {
      if (overlap(here, y.shifted(at_b))) return true;
    }
  }
  return false;
}

bool enters_clear(const State& owner, const Vec3& at, const Box& body) {
  return std::any_of(owner.clear.begin(), owner.clear.end(), [&](const Box& clear) { return overlap(clear.shifted(at), body); });
}

}  // namespace

bool collide(const Model& model, int a, const Placement& pa, int b, const Placement& pb, bool clear_boxes) {
  const PairRule rule = model.pair(a, b);
  if (rule == PairRule::kFree) return false;
  const Item &item_a = model.items[a], &item_b = model.items[b];
  const State &sa = item_a.states[pa.state], &sb = item_b.states[pb.state];
  const Box box_a = box_of(item_a, pa), box_b = box_of(item_b, pb);
  if (rule == PairRule::kOpenings) {
    Box grown = box_a;  // openings have no depth
    for (int k = 0; k < 2; ++k) grown.lo[k] -= 1, grown.hi[k] += 1;
    return overlap(grown, {{box_b.lo[0] - 1, box_b.lo[1] - 1, box_b.lo[2]}, {box_b.hi[0] + 1, box_b.hi[1] + 1, box_b.hi[2]}});
  }
  if (item_a.is_opening() || item_b.is_opening()) {
    if (!clear_boxes) return false;
    return item_a.is_opening() ? enters_clear(sa, pa.at, box_b) : enters_clear(sb, pb.at, box_a);
  }
  if (!overlap(box_a, box_b)) return false;
  return rule == PairRule::kBoxes || bodies_overlap(sa, pa.at, sb, pb.at);
}

}  // namespace layoutbox::placement
