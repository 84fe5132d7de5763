// What the catalogue knows of good rooms: who has which habits, and what several of them ask.
#include <cmath>

#include "layoutbox/solve/compile/habits.h"

namespace layoutbox::placement {

void Habits::add(int index) {
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

void Habits::stand(int index) {
  const Item& item = model_.items[index];
  sit_on_host(index);
  lie_straight(index);
  if (stand_in_formation(index)) return;
  const bool with_host = stand_beside(index);
  if (!with_host || !is_table_seat(item)) look_at(index);
  if (item.entry->back_to_wall) {
    back_to_wall(index);
    stand_in_run(index);
    stand_as_twin(index);
  } else if (!with_host && !placed_by_relation(index)) {
    if (used_sides(item).size() >= 4) {
      stand_in_middle(index);
    } else {
      stand_at_wall(index);
    }
  }
  if (!item.entry->back_to_wall && has_family(item, {"counter"})) open_to_room(index);
  if (model_.is_a(index, "desk")) near_light(index);
}

Constraint& Habits::habit(const std::string& what, int item, int weight, Formula formula, std::vector<int> hosts) {
  Constraint& c = model_.constraints.emplace_back();
  c.name = what + ": " + model_.items[item].id;
  c.firmness = Firmness::kSoft;
  c.weight = weight;
  c.formulas.push_back(std::move(formula));
  c.hosts = std::move(hosts);
  return c;
}

std::vector<int> Habits::items_of_kinds(const std::vector<std::string>& kinds, int except) const {
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
int Habits::rank_of(int item) const {
  int rank = 0;
  for (int i = 0; i < item; ++i) rank += model_.items[i].entry == model_.items[item].entry;
  return rank;
}

// Does a relation of the scene already say how these two stand to each other?
bool Habits::related(int a, int b) const {
  const auto has = [](const std::vector<std::string>& ids, const std::string& id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  const std::string &x = model_.items[a].id, &y = model_.items[b].id;
  return std::any_of(model_.scene->relations.begin(), model_.scene->relations.end(), [&](const Relation& r) {
    return (has(r.targets, x) && has(r.references, y)) || (has(r.targets, y) && has(r.references, x));
  });
}

bool Habits::only_related_by(int a, int b, std::initializer_list<RelationType> types) const {
  const auto has = [](const std::vector<std::string>& ids, const std::string& id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  const std::string &x = model_.items[a].id, &y = model_.items[b].id;
  return std::none_of(model_.scene->relations.begin(), model_.scene->relations.end(), [&](const Relation& r) {
    const bool both = (has(r.targets, x) && has(r.references, y)) || (has(r.targets, y) && has(r.references, x));
    return both && std::find(types.begin(), types.end(), r.type) == types.end();
  });
}

bool Habits::related_as_target(int item, int reference, RelationType type) const {
  const std::string &x = model_.items[item].id, &y = model_.items[reference].id;
  return std::any_of(model_.scene->relations.begin(), model_.scene->relations.end(), [&](const Relation& r) {
    return r.type == type && std::find(r.targets.begin(), r.targets.end(), x) != r.targets.end() &&
           std::find(r.references.begin(), r.references.end(), y) != r.references.end();
  });
}

bool Habits::placed_by_relation(int item) const {
  return std::any_of(model_.scene->relations.begin(), model_.scene->relations.end(), [&](const Relation& r) {
    return std::find(r.targets.begin(), r.targets.end(), model_.items[item].id) != r.targets.end();
  });
}

// What stands on something looks the way that looks; screens in its middle, the rest rather at its back.
void Habits::sit_on_host(int item) {
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
      if (screen || small_host) {
        const Linear off_middle = mid2(item, right.axis) - mid2(support.index, right.axis);
        c.wish(off_middle - Linear(right.sign * place_among_screens(item, support.index)), 80, 2);
      }
      if (host.has_front && !small_host) c.wish(reach(item, back) - reach(support.index, back) + Linear(40), screen ? 60 : 25);
      if (small_host) c.wish(mid2(item, back.axis) - mid2(support.index, back.axis), 60, 2);
    });
    habit("sits", item, kSits, std::move(f));
    return;
  }
}

// Screens on one desk stand side by side: twice what this one is off the desk's middle, towards the desk's right.
std::int64_t Habits::place_among_screens(int item, int host) const {
  constexpr Mm kApart = 20;
  std::int64_t screens = 0, before = 0;
  for (std::size_t i = 0; i < model_.items.size(); ++i) {
    if (model_.items[i].entry != model_.items[item].entry || !rests_on(static_cast<int>(i), host)) continue;
    before += static_cast<int>(i) < item;
    ++screens;
  }
  const Mm pitch = model_.items[item].states[0].size.width + kApart;
  if (screens * pitch > model_.items[host].states[0].size.width + kApart) return 0;
  return (2 * before - (screens - 1)) * pitch;
}

bool Habits::rests_on(int item, int host) const {
  const std::vector<SupportOption>& supports = model_.items[item].supports;
  return std::any_of(supports.begin(), supports.end(),
                     [&](const SupportOption& s) { return s.kind == SupportOption::Kind::kItem && s.index == host; });
}

int Habits::riders_of(int host) const {
  int riders = 0;
  for (std::size_t i = 0; i < model_.items.size(); ++i) riders += rests_on(static_cast<int>(i), host);
  return riders;
}

void Habits::keep_hint(int item) {
  const SceneObject& object = *model_.items[item].object;
  if (!model_.start.empty() && model_.start[item].state >= 0) return;  // an earlier layout says more
  if (object.hint.rotation_deg) keep_turn(item, *object.hint.rotation_deg);
  if (!object.hint.position) return;
  Formula f;
  Case& c = f.add();
  for (int axis = 0; axis < 2; ++axis) {
    c.wish(mid2(item, axis) - Linear(std::lround(2 * (*object.hint.position)[axis])), kHint, 2);
  }
  habit("hint", item, kHint, std::move(f));
}

// The scene's own turn holds before everything that makes rooms good, unless what is asked for says otherwise; it is no part of the score.
void Habits::keep_turn(int item, double degrees) {
  const Item& self = model_.items[item];
  const bool square = self.states[0].size.width == self.states[0].size.depth;
  std::uint64_t states = 0;
  for (std::size_t s = 0; s < self.states.size(); ++s) {
    const double off = std::remainder(self.states[s].angle - degrees, self.has_front ? 360 : square ? 90 : 180);
    if (std::abs(off) < 0.5) states |= std::uint64_t{1} << s;
  }
  if (!states) return;
  Formula f;
  f.add().when(item, states);
  habit("hint of turn", item, kHintOfTurn, std::move(f)).stay = true;
}

void add_habits(Model& model) {
  Habits habits(model);
  for (std::size_t i = 0; i < model.items.size(); ++i) habits.add(static_cast<int>(i));
}

}  // namespace layoutbox::placement
