// What the catalogue knows of good rooms, as soft constraints in the same small form as the relations.
#include <cmath>
#include <optional>

#include "layoutbox/solve/compile/formation.h"
#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {
namespace {

// Points per metre missed; docs/solve.md says where they come from.
constexpr int kBackToWall = 900, kBeside = 500, kFaces = 600, kAtWall = 150, kRug = 300, kHint = 800, kOpeningPlace = 80, kHangs = 200,
              kSits = 400, kCurtain = 900, kMiddle = 40, kLight = 25, kFormation = 300;

constexpr Mm kRugBeyondFoot = 500;
constexpr std::size_t kMany = 4;
constexpr std::int64_t kManySize = 3'000'000;  // mm²: larger things are no crowd

const std::vector<std::string> kUnderPictures{"fireplace", "bed",  "sofa",     "sideboard", "console_table",
                                              "dresser",   "desk", "tv_stand", "cabinet"};
const std::vector<std::string> kUnderMirrors{"sink", "vanity", "dresser", "console_table", "sideboard"};
const std::vector<std::string> kUnderLamps{"dining_table", "kitchen_island", "conference_table", "table", "coffee_table", "bed"};
const std::vector<std::string> kOnRugs{"coffee_table", "dining_table", "bed", "crib", "table", "sofa", "desk"};

bool has_family(const Item& item, std::initializer_list<std::string_view> families) {
  return item.entry && std::find(families.begin(), families.end(), item.entry->shape.family) != families.end();
}

bool is_table_seat(const Item& item) { return has_family(item, {"chair", "office_chair", "stool"}); }
bool is_easy_chair(const Item& item) { return has_family(item, {"armchair", "recliner"}); }

std::int64_t area_of(const Item& item) { return std::int64_t{item.states[0].size.width} * item.states[0].size.depth; }

// Twice the middle of the floor's extent.
Linear room_mid2(const Model& model, int axis) { return {std::int64_t{model.room.lo[axis]} + model.room.hi[axis]}; }

class Habits {
 public:
  explicit Habits(Model& model) : model_(model) {}

  void add(int index) {
    const Item& item = model_.items[index];
    if (item.is_opening()) {
      open_well(index);
      return;
    }
    if (item.fixed) return;
    keep_hint(index);
    switch (item.mount) {
      case Mount::kCeiling: hang_from_ceiling(index); return;
      case Mount::kWall: hang_on_wall(index); return;
      case Mount::kSurface: sit_on_host(index); return;
      case Mount::kHung: return;
      case Mount::kFloor: break;
    }
    if (item.thin) {
      if (!placed_by_relation(index) && !stand_in_formation(index)) lie_under(index);
      return;
    }
    stand(index);
  }

 private:
  void stand(int index) {
    const Item& item = model_.items[index];
    sit_on_host(index);
    if (stand_in_formation(index)) return;
    const bool with_host = stand_beside(index);
    if (!with_host || !is_table_seat(item)) look_at(index);
    if (item.entry->back_to_wall) {
      back_to_wall(index);
    } else if (!with_host && !placed_by_relation(index)) {
      if (used_sides(item).size() >= 4) {
        stand_in_middle(index);
      } else {
        stand_at_wall(index);
      }
    }
    if (model_.is_a(index, "desk")) near_light(index);
  }

  Constraint& habit(const std::string& what, int item, int weight, Formula formula, std::vector<int> hosts = {}) {
    Constraint& c = model_.constraints.emplace_back();
    c.name = what + ": " + model_.items[item].id;
    c.firmness = Firmness::kSoft;
    c.weight = weight;
    c.formulas.push_back(std::move(formula));
    c.hosts = std::move(hosts);
    return c;
  }

  static std::vector<Side> used_sides(const Item& item) { return item.object->used_sides.value_or(item.entry->used_sides); }

  std::vector<int> items_of_kinds(const std::vector<std::string>& kinds, int except) const {
    std::vector<int> found;
    for (const std::string& kind : kinds) {
      for (std::size_t i = 0; i < model_.items.size(); ++i) {
        const int index = static_cast<int>(i);
        if (index != except && model_.is_a(index, kind) && std::find(found.begin(), found.end(), index) == found.end())
          found.push_back(index);
      }
    }
    return found;
  }

  // The how-manieth of its kind this is.
  int rank_of(int item) const {
    int rank = 0;
    for (int i = 0; i < item; ++i) rank += model_.items[i].entry == model_.items[item].entry;
    return rank;
  }

  // Does a relation of the scene already say how these two stand to each other?
  bool related(int a, int b) const {
    const auto has = [](const std::vector<std::string>& ids, const std::string& id) {
      return std::find(ids.begin(), ids.end(), id) != ids.end();
    };
    const std::string &x = model_.items[a].id, &y = model_.items[b].id;
    return std::any_of(model_.scene->relations.begin(), model_.scene->relations.end(), [&](const Relation& r) {
      return (has(r.targets, x) && has(r.references, y)) || (has(r.targets, y) && has(r.references, x));
    });
  }

  bool only_related_by(int a, int b, std::initializer_list<RelationType> types) const {
    const auto has = [](const std::vector<std::string>& ids, const std::string& id) {
      return std::find(ids.begin(), ids.end(), id) != ids.end();
    };
    const std::string &x = model_.items[a].id, &y = model_.items[b].id;
    return std::none_of(model_.scene->relations.begin(), model_.scene->relations.end(), [&](const Relation& r) {
      const bool both = (has(r.targets, x) && has(r.references, y)) || (has(r.targets, y) && has(r.references, x));
      return both && std::find(types.begin(), types.end(), r.type) == types.end();
    });
  }

  // What a relation leaves open between things that belong together: a chair stands close to its desk, a bench along the bed's foot.
  void come_near(int item, int host) {
    const Item &self = model_.items[item], &ref = model_.items[host];
    const bool at_desk = is_table_seat(self) && has_knee_room(ref) && ref.has_front && used_side(ref) == Side::kFront &&
                         only_related_by(item, host, {RelationType::kInFrontOf, RelationType::kFacing, RelationType::kCenteredOn});
    const bool at_foot = only_related_by(item, host, {RelationType::kAtFootOf, RelationType::kParallel});
    const bool before =
        before_its_host(item) && ref.has_front && only_related_by(item, host, {RelationType::kInFrontOf, RelationType::kCenteredOn});
    if (!at_desk && !at_foot && !before) return;
    Formula f;
    for_each_turn(ref, [&](int turn, std::uint64_t states) {
      if (turn % 90 != 0) return;
      const Direction front = side_direction(ref, Side::kFront, turn);
      Case& c = f.add().when(host, states).wish(gap_towards(item, host, front) - Linear(before ? 400 : at_foot ? 50 : 10), kBeside);
      if (at_foot || before) c.when(item, states_with_width_along(self, across(front)));
    });
    habit("near", item, kBeside, std::move(f), {host});
  }

  bool placed_by_relation(int item) const {
    return std::any_of(model_.scene->relations.begin(), model_.scene->relations.end(), [&](const Relation& r) {
      return std::find(r.targets.begin(), r.targets.end(), model_.items[item].id) != r.targets.end();
    });
  }

  void back_to_wall(int item) {
    Formula f;
    const bool heart = has_family(model_.items[item], {"bed", "sofa"});  // what the room is about stands rather in the middle of its wall
    for (const RoomWall& wall : model_.walls) {
      const std::size_t known = f.cases.size();
      add_against(f, model_, item, states_with_back_to(model_.items[item], wall), wall, 20, true);
      for (std::size_t i = known; heart && i < f.cases.size(); ++i)
        f.cases[i].wish(mid2(item, wall.along) - Linear(std::int64_t{wall.lo} + wall.hi), kMiddle, 2);
    }
    habit("back to wall", item, kBackToWall, std::move(f));
  }

  // Small things at walls, best in corners; a plant in the middle of a room is in the way.
  void stand_at_wall(int item) {
    Formula f;
    for (std::size_t i = 0; i < model_.walls.size(); ++i) {
      const RoomWall &a = model_.walls[i], &b = model_.walls[(i + 1) % model_.walls.size()];
      if (!a.straight) continue;
      require_near_wall(f.add(), model_, item, a, 100);
      f.cases.back().price = 60;
      if (!b.straight || a.along == b.along) continue;
      Case& corner = f.add();
      require_near_wall(corner, model_, item, a, 150);
      require_near_wall(corner, model_, item, b, 150);
    }
    habit("at a wall", item, kAtWall, std::move(f));
  }

  void stand_in_middle(int item) {
    Formula f;
    Case& c = f.add();
    for (int axis = 0; axis < 2; ++axis) c.wish(mid2(item, axis) - room_mid2(model_, axis), kMiddle, 2);
    habit("in the middle", item, kMiddle, std::move(f));
  }

  void near_light(int item) {
    Formula f;
    std::vector<int> windows;
    for (std::size_t i = 0; i < model_.items.size(); ++i) {
      const Item& other = model_.items[i];
      if (!other.is_opening() || other.opening->type != OpeningType::kWindow) continue;
      Case& c = f.add();
      windows.push_back(static_cast<int>(i));
      for (int axis = 0; axis < 2; ++axis) c.wish(mid2(item, axis) - mid2(windows.back(), axis), kLight, 2);
    }
    if (!windows.empty()) habit("near light", item, kLight, std::move(f));
  }

  // By one of the greater things it goes with: a seat at its table, a nightstand beside its bed, a table before its sofa.
  bool stand_beside(int item) {
    const Item& self = model_.items[item];
    std::vector<int> hosts = items_of_kinds(self.entry->beside, item);
    std::erase_if(hosts, [&](int h) { return model_.items[h].thin || area_of(model_.items[h]) <= area_of(self); });
    if (hosts.empty()) return false;
    for (const int h : hosts) {
      if (related(item, h) && !only_related_by(item, h, {RelationType::kBetween})) {
        come_near(item, h);
        return true;
      }
    }
    if (is_easy_chair(self)) {
      const std::vector<int> seen = items_of_kinds(self.entry->faces, item);
      const auto low_table = std::find_if(seen.begin(), seen.end(), [&](int i) { return model_.is_a(i, "coffee_table"); });
      if (low_table != seen.end() && !related(item, *low_table)) {
        sit_round_low_table(item, *low_table);
        return true;
      }
    }
    // Hosts of the best kind only: a lamp by the sofa rather than by the desk.
    std::erase_if(hosts, [&](int h) { return model_.items[h].entry != model_.items[hosts[0]].entry; });
    const int host = hosts[rank_of(item) % static_cast<int>(hosts.size())];
    const Item& ref = model_.items[host];
    Formula f;
    if (is_table_seat(self) && has_knee_room(ref)) {
      const std::vector<int> seats = seats_at(item, host, static_cast<int>(hosts.size()));
      const auto k = std::find(seats.begin(), seats.end(), item) - seats.begin();
      add_seat_place(f, model_, item, host, static_cast<int>(k), static_cast<int>(seats.size()), kBeside);
      habit("at table", item, kBeside, std::move(f), {host});
      return true;
    }
    if (before_its_host(item)) {
      add_beside(f, model_, item, host, Side::kFront, {.most = 600, .wished_gap = model_.is_a(item, "coffee_table") ? 400 : 100});
    } else {
      add_beside(f, model_, item, host, Side::kLeft, {.most = 500, .wished_gap = 60});
      add_beside(f, model_, item, host, Side::kRight, {.most = 500, .wished_gap = 60});
      if (!ref.has_front) {
        add_beside(f, model_, item, host, Side::kFront, {.most = 500, .wished_gap = 60});
        add_beside(f, model_, item, host, Side::kBack, {.most = 500, .wished_gap = 60});
      }
    }
    // Near is what makes them belong together; the free floor wanted at the host's sides would push them off.
    for (Case& c : f.cases) {
      if (!c.wishes.empty()) c.wishes[0].weight = kBeside;
    }
    habit("beside", item, kBeside, std::move(f), {host});
    if (before_its_host(item)) stand_before_middle(item, host);
    if (ref.has_front && !before_its_host(item) && !is_table_seat(self)) flank(item, host, static_cast<int>(hosts.size()));
    return true;
  }

  // Easy chairs make a talking group: at the ends of the coffee table, looking at it, two of them face to face.
  void sit_round_low_table(int item, int table) {
    Formula f;
    add_beside(f, model_, item, table, Side::kLeft, {.most = 700, .wished_gap = 350});
    add_beside(f, model_, item, table, Side::kRight, {.most = 700, .wished_gap = 350});
    const std::size_t ends = f.cases.size();
    add_beside(f, model_, item, table, Side::kFront, {.most = 700, .wished_gap = 350});
    add_beside(f, model_, item, table, Side::kBack, {.most = 700, .wished_gap = 350});
    for (std::size_t i = ends; i < f.cases.size(); ++i) f.cases[i].price += 150;  // there it may stand before the television
    for (Case& c : f.cases) {
      if (!c.wishes.empty()) c.wishes[0].weight = kBeside;
    }
    habit("round the low table", item, kBeside, std::move(f), {table});
    flank(item, table, 1);
  }

  void stand_before_middle(int item, int host) {
    Formula f;
    for_each_turn(model_.items[host], [&](int turn, std::uint64_t states) {
      const int along = side_direction(model_.items[host], Side::kRight, turn).axis;
      f.add()
          .when(host, states)
          .when(item, states_with_width_along(model_.items[item], along))
          .wish(mid2(item, along) - mid2(host, along), kBeside, 2);
    });
    habit("before the middle", item, kBeside, std::move(f), {host});
  }

  // Two of a kind by the same host stand one at each side: nightstands, speakers, plants.
  void flank(int item, int host, int hosts) {
    const int rank = rank_of(item);
    if (rank / hosts % 2 == 0) return;
    int twin = 0;
    while (model_.items[twin].entry != model_.items[item].entry || rank_of(twin) != rank - hosts) ++twin;
    if (model_.items[twin].fixed || related(twin, host)) return;
    Formula f;
    for_each_turn(model_.items[host], [&](int turn, std::uint64_t states) {
      const Direction right = side_direction(model_.items[host], Side::kRight, turn);
      for (const int sign : {1, -1}) {
        const auto beyond = [&](int one, int towards) { return towards * (mid2(one, right.axis) - mid2(host, right.axis)); };
        f.add().when(host, states).require(beyond(item, sign)).require(beyond(twin, -sign));
      }
    });
    habit("other side", item, kBeside, std::move(f), {host, twin});
  }

  // All of the item's kind that no relation ties to the host and that share it.
  std::vector<int> seats_at(int item, int host, int hosts) const {
    std::vector<int> seats;
    for (std::size_t i = 0; i < model_.items.size(); ++i) {
      const int other = static_cast<int>(i);
      if (model_.items[i].entry == model_.items[item].entry && rank_of(other) % hosts == rank_of(item) % hosts && !related(other, host))
        seats.push_back(other);
    }
    return seats;
  }

  // The things of a kind that stand in formation: asked for as a grid, or many that nobody placed.
  struct Group {
    std::vector<int> members;
    int columns = 0;
  };
  std::optional<Group> formation_with(int item) const {
    for (const Relation& r : model_.scene->relations) {
      if (r.type != RelationType::kGrid || std::find(r.targets.begin(), r.targets.end(), model_.items[item].id) == r.targets.end())
        continue;
      Group group{{}, r.parameters.columns.value_or(static_cast<int>(std::ceil(std::sqrt(static_cast<double>(r.targets.size())))))};
      for (const std::string& id : r.targets) group.members.push_back(model_.find_item(id));
      return group;
    }
    const Item& self = model_.items[item];
    if (self.mount != Mount::kFloor || self.entry->back_to_wall || area_of(self) > kManySize) return std::nullopt;
    if (!self.entry->beside.empty() && !has_knee_room(self)) return std::nullopt;
    Group group;
    for (std::size_t i = 0; i < model_.items.size(); ++i) {
      const int other = static_cast<int>(i);
      if (model_.items[i].entry == self.entry && !model_.items[i].fixed && !placed_besides_facing(other)) group.members.push_back(other);
    }
    if (group.members.size() < kMany || std::find(group.members.begin(), group.members.end(), item) == group.members.end())
      return std::nullopt;
    return group;
  }

  // Does a relation say where it stands, not only which way it looks?
  bool placed_besides_facing(int item) const {
    return std::any_of(model_.scene->relations.begin(), model_.scene->relations.end(), [&](const Relation& r) {
      const bool turns_only =
          r.type == RelationType::kFacing || r.type == RelationType::kSameOrientation || r.type == RelationType::kParallel;
      return !turns_only && std::find(r.targets.begin(), r.targets.end(), model_.items[item].id) != r.targets.end();
    });
  }

  void turn_as(int item, int other) {
    Formula f;
    for_each_turn(model_.items[item], [&](int turn, std::uint64_t states) {
      if (const std::uint64_t same = model_.items[other].states_at(turn)) f.add().when(item, states).when(other, same);
    });
    habit("turned alike", item, kFaces, std::move(f), {other});
  }

  bool stand_in_formation(int item) {
    const std::optional<Group> group = formation_with(item);
    if (!group) return false;
    const int k = static_cast<int>(std::find(group->members.begin(), group->members.end(), item) - group->members.begin());
    Formula f;
    add_formation_place(f, model_, group->members, k, group->columns, kFormation);
    if (f.cases.empty()) return false;
    habit("in formation", item, kFormation, std::move(f));
    if (k == 0) {
      look_at(item, true);
    } else if (model_.items[item].has_front) {
      turn_as(item, group->members[0]);
    }
    return true;
  }

  bool before_its_host(int item) const {
    return model_.is_a(item, "coffee_table") || model_.is_a(item, "ottoman") || model_.is_a(item, "bench") || model_.is_a(item, "pouf");
  }

  // Its front to what it is for: sofas to screens, easy chairs to the table between.
  void look_at(int item, bool leads = false) {
    const Item& self = model_.items[item];
    if (!self.has_front) return;
    const std::vector<int> seen = items_of_kinds(self.entry->faces, item);
    for (const int other : seen) {
      if (model_.items[other].mount != Mount::kFloor && model_.items[other].mount != Mount::kWall && seen.size() > 1 && other != seen[0])
        continue;
      Formula f;
      add_looks_at(f, model_, item, other);
      if (is_easy_chair(self) && !related(item, other)) {
        for (Case& c : f.cases) {  // near enough to put a cup down
          for (int axis = 0; axis < 2; ++axis) c.wish(mid2(item, axis) - mid2(other, axis), 60, 2);
        }
      }
      habit("faces", item, kFaces, std::move(f), is_easy_chair(self) || leads ? std::vector<int>{other} : std::vector<int>{});
      return;
    }
  }

  // A rug lies under what stands in the middle of things, else in the middle of the room; a bed would hide it, so there it shows at
  // both sides and beyond the foot.
  void lie_under(int item) {
    std::vector<int> over = items_of_kinds(kOnRugs, item);
    const auto beds = std::count_if(over.begin(), over.end(), [&](int i) { return model_.is_a(i, "bed"); });
    std::erase_if(over, [&](int i) {
      if (model_.is_a(i, "bed")) return beds > 1 || !has_family(model_.items[i], {"bed"});
      return model_.is_a(i, "table") && !model_.is_a(i, "desk") && model_.items[i].entry->back_to_wall;
    });
    Formula f;
    if (!over.empty() && has_family(model_.items[over[rank_of(item) % static_cast<int>(over.size())]], {"bed"})) {
      lie_at_foot(item, over[rank_of(item) % static_cast<int>(over.size())]);
      return;
    }
    Case& c = f.add();
    std::vector<int> hosts;
    if (!over.empty()) hosts.push_back(over[rank_of(item) % static_cast<int>(over.size())]);
    for (int axis = 0; axis < 2; ++axis)
      c.wish(mid2(item, axis) - (hosts.empty() ? room_mid2(model_, axis) : mid2(hosts[0], axis)), kRug, 2);
    habit("rug", item, kRug, std::move(f), hosts);
  }

  void lie_at_foot(int item, int bed) {
    Formula f;
    for_each_turn(model_.items[bed], [&](int turn, std::uint64_t states) {
      const Direction foot = side_direction(model_.items[bed], Side::kFront, turn);
      Case& c = f.add().when(bed, states);
      if (const std::uint64_t along = model_.items[item].states_at(turn)) c.when(item, along);
      c.wish(mid2(item, across(foot)) - mid2(bed, across(foot)), kRug, 2);
      c.wish(reach(item, foot) - reach(bed, foot) - Linear(kRugBeyondFoot), kRug);
    });
    habit("rug", item, kRug, std::move(f), {bed});
  }

  void hang_from_ceiling(int item) {
    const std::vector<int> below = items_of_kinds(kUnderLamps, item);
    Formula f;
    Case& c = f.add();
    std::vector<int> hosts;
    if (!below.empty() && !placed_by_relation(item)) hosts.push_back(below[0]);
    for (int axis = 0; axis < 2; ++axis)
      c.wish(mid2(item, axis) - (hosts.empty() ? room_mid2(model_, axis) : mid2(hosts[0], axis)), kHangs, 2);
    habit("hangs", item, kHangs, std::move(f), hosts);
  }

  // At its usual height; a curtain at its window, a picture over something, else in the middle of a wall.
  void hang_on_wall(int item) {
    const Item& self = model_.items[item];
    Formula height;
    const Mm wished = self.entry->hang_height > 0 ? self.entry->hang_height : 1200;
    height.add().wish(lo(item, 2) - Linear(wished), 100);
    habit("height", item, 100, std::move(height));
    if (self.curtain) {
      cover_window(item);
      return;
    }
    if (stand_beside(item)) return;
    look_at(item);
    if (placed_by_relation_besides_walls(item)) return;
    const std::vector<int> under = items_of_kinds(model_.is_a(item, "mirror") ? kUnderMirrors : kUnderPictures, item);
    Formula f;
    std::vector<int> hosts;
    if (static_cast<std::size_t>(rank_of(item)) < under.size()) {
      hosts.push_back(under[rank_of(item)]);
      for (const RoomWall& wall : model_.walls) {
        if (!wall.straight) continue;
        Case& c = f.add().when(item, states_facing(item, wall));
        c.wish(mid2(item, wall.along) - mid2(hosts[0], wall.along), kHangs, 2);
        c.wish(mid2(item, wall.normal()) - mid2(hosts[0], wall.normal()), kHangs / 2, 2);
        c.require(lo(item, 2) - hi(hosts[0], 2) - Linear(120));
      }
    } else {
      for (const RoomWall& wall : model_.walls) {
        if (!wall.straight) continue;
        Case& c = f.add().when(item, states_facing(item, wall));
        c.wish(mid2(item, wall.along) - Linear(std::int64_t{wall.lo} + wall.hi), kHangs / 4, 2);
        // The picture cuts away the front and the right wall: hung there, nobody sees it.
        c.price = wall.turn == 180 || wall.turn == 270 ? 60 : 0;
      }
    }
    habit("hangs", item, kHangs, std::move(f), hosts);
  }

  std::uint64_t states_facing(int item, const RoomWall& wall) const {
    const std::uint64_t states = model_.items[item].states_at(wall.turn);
    return states ? states : model_.items[item].all_states;
  }

  bool placed_by_relation_besides_walls(int item) const {
    return std::any_of(model_.scene->relations.begin(), model_.scene->relations.end(), [&](const Relation& r) {
      const bool target = std::find(r.targets.begin(), r.targets.end(), model_.items[item].id) != r.targets.end();
      return target && r.type != RelationType::kOnWall && r.type != RelationType::kAgainstWall;
    });
  }

  void cover_window(int item) {
    std::vector<int> windows;
    for (std::size_t i = 0; i < model_.items.size(); ++i) {
      if (model_.items[i].is_opening() && model_.items[i].opening->type == OpeningType::kWindow) windows.push_back(static_cast<int>(i));
    }
    if (windows.empty()) return;
    const int window = windows[rank_of(item) % static_cast<int>(windows.size())];
    Formula f;
    for_each_turn(model_.items[window], [&](int turn, std::uint64_t states) {
      Case& c = f.add().when(window, states).when(item, model_.items[item].states_at(turn));
      for (int axis = 0; axis < 2; ++axis) c.wish(mid2(item, axis) - mid2(window, axis), kCurtain, 2);
    });
    habit("at its window", item, kCurtain, std::move(f), {window});
  }

  // What stands on something looks the way that looks; screens in its middle, the rest rather at its back.
  void sit_on_host(int item) {
    const Item& self = model_.items[item];
    const bool screen = has_family(self, {"tv", "monitor", "laptop", "computer"});
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
        if (screen || small_host) c.wish(mid2(item, right.axis) - mid2(support.index, right.axis), 80, 2);
        if (host.has_front && !small_host) c.wish(reach(item, back) - reach(support.index, back) + Linear(40), screen ? 60 : 25);
        if (small_host) c.wish(mid2(item, back.axis) - mid2(support.index, back.axis), 60, 2);
      });
      habit("sits", item, kSits, std::move(f));
      return;
    }
  }

  int riders_of(int host) const {
    int riders = 0;
    for (const Item& item : model_.items) {
      riders += std::any_of(item.supports.begin(), item.supports.end(),
                            [&](const SupportOption& s) { return s.kind == SupportOption::Kind::kItem && s.index == host; });
    }
    return riders;
  }

  void keep_hint(int item) {
    const SceneObject& object = *model_.items[item].object;
    if (!model_.start.empty() && model_.start[item].state >= 0) return;  // an earlier layout says more
    Formula f;
    Case& c = f.add();
    if (object.hint.rotation_deg) {
      const int turn = static_cast<int>(std::lround(normalized_degrees(*object.hint.rotation_deg))) % 360;
      if (const std::uint64_t states = model_.items[item].states_at(turn)) c.when(item, states);
    }
    if (object.hint.position) {
      for (int axis = 0; axis < 2; ++axis) {
        c.wish(mid2(item, axis) - Linear(std::lround(2 * (*object.hint.position)[axis])), kHint, 2);
      }
    }
    if (object.hint.rotation_deg || object.hint.position) habit("hint", item, kHint, std::move(f));
  }

  // Doors near a corner, the front wall first; windows in the middle of a wall that the picture shows.
  void open_well(int item) {
    const Opening& opening = *model_.items[item].opening;
    if (opening.offset) return;
    Formula f;
    for (const RoomWall& wall : model_.walls) {
      if (!wall.straight || (!opening.wall.empty() && wall.id != opening.wall)) continue;
      const std::uint64_t states = model_.items[item].states_at(wall.turn);
      if (opening.type == OpeningType::kWindow) {
        Case& c = f.add().when(item, states).wish(mid2(item, wall.along) - Linear(std::int64_t{wall.lo} + wall.hi), kOpeningPlace, 2);
        c.price = std::max(0, 3000 - (wall.hi - wall.lo)) / 40 + (wall.turn == 180 || wall.turn == 270 ? 40 : 0);
        continue;
      }
      for (const bool low : {true, false}) {
        Case& c = f.add().when(item, states);
        c.wish(low ? lo(item, wall.along) - Linear(wall.lo + 100) : Linear(wall.hi - 100) - hi(item, wall.along), kOpeningPlace);
        c.price = wall.turn == 180 ? 0 : wall.turn == 270 ? 10 : 30;
      }
    }
    habit("place", item, kOpeningPlace, std::move(f));
  }

  Model& model_;
};

}  // namespace

void add_habits(Model& model) {
  Habits habits(model);
  for (std::size_t i = 0; i < model.items.size(); ++i) habits.add(static_cast<int>(i));
}

}  // namespace layoutbox::placement
