// Habits of things that come in numbers.
#include <cmath>

#include "layoutbox/solve/compile/formation.h"
#include "layoutbox/solve/compile/habits.h"

namespace layoutbox::placement {
namespace {

constexpr std::size_t kMany = 4;
constexpr std::int64_t kManySize = 3'000'000;  // mm²: larger things are no crowd

}  // namespace

std::optional<Habits::Group> Habits::formation_with(int item) const {
  for (const Relation& r : model_.scene->relations) {
    if (r.type != RelationType::kGrid || std::find(r.targets.begin(), r.targets.end(), model_.items[item].id) == r.targets.end()) continue;
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
bool Habits::placed_besides_facing(int item) const {
  return std::any_of(model_.scene->relations.begin(), model_.scene->relations.end(), [&](const Relation& r) {
    const bool turns_only =
        r.type == RelationType::kFacing || r.type == RelationType::kSameOrientation || r.type == RelationType::kParallel;
    return !turns_only && std::find(r.targets.begin(), r.targets.end(), model_.items[item].id) != r.targets.end();
  });
}

void Habits::turn_as(int item, int other) {
  Formula f;
  for_each_turn(model_.items[item], [&](int turn, std::uint64_t states) {
    if (const std::uint64_t same = model_.items[other].states_at(turn)) f.add().when(item, states).when(other, same);
  });
  habit("turned alike", item, kFaces, std::move(f), {other});
}

bool Habits::stand_in_formation(int item) {
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

}  // namespace layoutbox::placement
