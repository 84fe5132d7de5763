// What the catalogue knows of good rooms, as soft constraints in the same small form as the relations.
#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {
namespace {

// Points per metre missed.
constexpr int kBackToWall = 900, kBeside = 500, kFaces = 600, kAtWall = 150, kRug = 300, kHint = 800, kOpeningPlace = 80, kAbove = 200;

Constraint& habit(Model& model, std::string name, int weight) {
  Constraint& c = model.constraints.emplace_back();
  c.name = std::move(name);
  c.firmness = Firmness::kSoft;
  c.weight = weight;
  return c;
}

std::vector<int> items_of_kinds(const Model& model, const std::vector<std::string>& kinds, int except) {
  std::vector<int> found;
  for (const std::string& kind : kinds) {
    for (std::size_t i = 0; i < model.items.size(); ++i) {
      const int index = static_cast<int>(i);
      if (index != except && model.is_a(index, kind) && std::find(found.begin(), found.end(), index) == found.end()) found.push_back(index);
    }
  }
  return found;
}

// The how-manieth of its kind this is.
int rank_of(const Model& model, int item) {
  int rank = 0;
  for (int i = 0; i < item; ++i) rank += model.items[i].entry == model.items[item].entry;
  return rank;
}

// Does a relation of the scene already say where these two stand to each other?
bool related(const Model& model, int a, int b) {
  const auto has = [](const std::vector<std::string>& ids, const std::string& id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); };
  const std::string &x = model.items[a].id, &y = model.items[b].id;
  return std::any_of(model.scene->relations.begin(), model.scene->relations.end(), [&](const Relation& r) {
    return (has(r.targets, x) && has(r.references, y)) || (has(r.targets, y) && has(r.references, x));
  });
}

bool is_placed_by_relation(const Model& model, int item) {
  return std::any_of(model.scene->relations.begin(), model.scene->relations.end(), [&](const Relation& r) {
    return std::find(r.targets.begin(), r.targets.end(), model.items[item].id) != r.targets.end();
  });
}

bool is_seat(const Item& item) { return item.entry && item.entry->shape.family == "chair"; }

void stand_back_to_wall(Model& model, int item) {
  Formula f;
  for (const RoomWall& wall : model.walls) add_against(f, model, item, wall, Side::kBack, 20);
  habit(model, "back to wall: " + model.items[item].id, kBackToWall).formulas.push_back(std::move(f));
}

void stand_at_wall(Model& model, int item) {
  Formula f;
  for (const RoomWall& wall : model.walls) {
    if (wall.straight) require_within_wall(f.add(), item, wall, 100);
  }
  habit(model, "at a wall: " + model.items[item].id, kAtWall).formulas.push_back(std::move(f));
}

// By one of the things it goes with: a seat at its table, a nightstand beside its bed, a table before its sofa.
void stand_beside(Model& model, int item) {
  const std::vector<int> hosts = items_of_kinds(model, model.items[item].entry->beside, item);
  if (hosts.empty()) return;
  for (const int host : hosts) {
    if (related(model, item, host)) return;
  }
  const int host = hosts[rank_of(model, item) % hosts.size()];
  const Item& ref = model.items[host];
  if (ref.thin || ref.is_opening()) return;
  Formula f;
  if (is_seat(model.items[item]) && std::any_of(ref.spaces.begin(), ref.spaces.end(), [](const ItemSpace& s) { return !s.carries; })) {
    for (const Side side : {Side::kFront, Side::kBack, Side::kLeft, Side::kRight}) {
      if (side == Side::kFront || !ref.entry->back_to_wall) add_tucked(f, model, item, host, side, 50, 300);
    }
  } else if (model.is_a(item, "coffee_table") || model.is_a(item, "ottoman") || model.is_a(item, "bench")) {
    add_beyond(f, model, item, host, Side::kFront, 600, model.is_a(item, "coffee_table") ? 400 : 100);
  } else {
    add_beyond(f, model, item, host, Side::kLeft, 500, 60);
    add_beyond(f, model, item, host, Side::kRight, 500, 60);
    if (!ref.has_front) add_beyond(f, model, item, host, Side::kFront, 500, 60);
  }
  habit(model, "beside: " + model.items[item].id, kBeside).formulas.push_back(std::move(f));
}

void look_at(Model& model, int item) {
  const std::vector<int> seen = items_of_kinds(model, model.items[item].entry->faces, item);
  for (const int other : seen) {
    if (related(model, item, other) && !is_seat(model.items[item])) continue;
    Formula f;
    add_looks_at(f, model, item, other);
    habit(model, "faces: " + model.items[item].id, kFaces).formulas.push_back(std::move(f));
    return;
  }
}

// A rug lies under what stands in the middle of things, else in the middle of the room.
void lie_under(Model& model, int item) {
  const std::vector<int> over = items_of_kinds(model, {"coffee_table", "dining_table", "bed", "sofa", "table"}, item);
  Formula f;
  Case& c = f.add();
  for (int axis = 0; axis < 2; ++axis) {
    const Linear middle = over.empty() ? Linear(std::int64_t{model.room.lo[axis]} + model.room.hi[axis]) : mid2(over[0], axis);
    c.wish(mid2(item, axis) - middle, kRug, 2);
  }
  habit(model, "rug: " + model.items[item].id, kRug).formulas.push_back(std::move(f));
}

void hang_well(Model& model, int item) {
  const Item& self = model.items[item];
  if (self.mount == Mount::kWall) {
    const Mm wished = self.entry->hang_height > 0 ? self.entry->hang_height : 1200;
    Formula f;
    f.add().wish(lo(item, 2) - Linear(wished), 100);
    habit(model, "height: " + self.id, 100).formulas.push_back(std::move(f));
    return;
  }
  // From the ceiling: over the table, else in the middle.
  const std::vector<int> below = items_of_kinds(model, {"dining_table", "coffee_table", "table", "kitchen_island"}, item);
  Formula f;
  Case& c = f.add();
  for (int axis = 0; axis < 2; ++axis) {
    const Linear middle = below.empty() ? Linear(std::int64_t{model.room.lo[axis]} + model.room.hi[axis]) : mid2(below[0], axis);
    c.wish(mid2(item, axis) - middle, kAbove, 2);
  }
  habit(model, "hangs: " + self.id, kAbove).formulas.push_back(std::move(f));
}

void keep_hint(Model& model, int item) {
  const SceneObject& object = *model.items[item].object;
  if (model.items[item].fixed) return;
  Formula f;
  Case& c = f.add();
  if (object.hint.rotation_deg) {
    const int turn = static_cast<int>(std::lround(normalized_degrees(*object.hint.rotation_deg))) % 360;
    const std::uint64_t states = model.items[item].states_at(turn);
    if (states) c.when(item, states);
  }
  if (object.hint.position) {
    for (int axis = 0; axis < 2; ++axis) {
      c.wish(mid2(item, axis) - Linear(std::lround(2 * (*object.hint.position)[axis])), kHint, 2);
    }
  }
  if (object.hint.rotation_deg || object.hint.position) {
    habit(model, "hint: " + object.id, kHint).formulas.push_back(std::move(f));
  }
}

// Doors near a corner, windows in the middle of a wall, neither in the walls that the picture cuts away unless told.
void open_well(Model& model, int item) {
  const Opening& opening = *model.items[item].opening;
  if (opening.offset) return;
  Formula f;
  for (const RoomWall& wall : model.walls) {
    if (!wall.straight || (!opening.wall.empty() && wall.id != opening.wall)) continue;
    const std::uint64_t states = model.items[item].states_at(wall.turn);
    const int short_wall = std::max(0, 3000 - (wall.hi - wall.lo)) / 40;
    if (opening.type == OpeningType::kWindow) {
      Case& c = f.add().when(item, states).wish(mid2(item, wall.along) - Linear(std::int64_t{wall.lo} + wall.hi), kOpeningPlace, 2);
      c.price = short_wall;
      continue;
    }
    for (const bool low : {true, false}) {
      Case& c = f.add().when(item, states);
      c.wish(low ? lo(item, wall.along) - Linear(wall.lo + 100) : Linear(wall.hi - 100) - hi(item, wall.along), kOpeningPlace);
      c.price = wall.inward > 0 && wall.along == 0 ? 0 : 20;  // the front wall first
    }
  }
  habit(model, "place: " + opening.id, kOpeningPlace).formulas.push_back(std::move(f));
}

}  // namespace

void add_habits(Model& model) {
  for (std::size_t i = 0; i < model.items.size(); ++i) {
    const int index = static_cast<int>(i);
    const Item& item = model.items[index];
    if (item.is_opening()) {
      open_well(model, index);
      continue;
    }
    keep_hint(model, index);
    if (item.mount == Mount::kWall || item.mount == Mount::kCeiling) {
      hang_well(model, index);
      continue;
    }
    if (item.thin) {
      if (!is_placed_by_relation(model, index)) lie_under(model, index);
      continue;
    }
    const bool stands = item.mount == Mount::kFloor;
    if (stands && item.entry->back_to_wall) stand_back_to_wall(model, index);
    if (stands && !item.entry->back_to_wall && item.entry->beside.empty() && !is_placed_by_relation(model, index) &&
        item.object->used_sides.value_or(item.entry->used_sides).size() < 4) {
      stand_at_wall(model, index);
    }
    if (stands) stand_beside(model, index);
    if (stands) look_at(model, index);
  }
}

}  // namespace layoutbox::placement
