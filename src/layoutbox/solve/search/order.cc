#include "layoutbox/solve/search/order.h"

#include <functional>
#include <tuple>

namespace layoutbox::placement {
namespace {

bool may_rest_on(const Item& item, ItemId host) {
  return std::any_of(item.supports.begin(), item.supports.end(),
                     [&](const SupportOption& support) { return support.kind == SupportOption::Kind::kItem && support.item == host; });
}

std::vector<ItemId> hosts_of(const PlacementModel& model, ItemId item) {
  std::vector<ItemId> found;
  const auto add = [&](ItemId other) {
    if (other != item && other.exists() && std::find(found.begin(), found.end(), other) == found.end()) found.push_back(other);
  };
  for (const SupportOption& support : model.items[item].supports) {
    if (support.kind == SupportOption::Kind::kItem || support.kind == SupportOption::Kind::kSill) add(support.item);
  }
  for (const ConstraintId c : model.touching[item]) {
    const Constraint& constraint = model.constraints[c];
    for (const ItemId other : constraint.hosts) {  // a desk waits for no screen that the keyboard on it lies before
      if (!may_rest_on(model.items[other], item)) add(other);
    }
    if (!constraint.relation.exists()) continue;
    const Relation& relation = model.relation(constraint.relation);
    if (std::find(relation.targets.begin(), relation.targets.end(), model.items[item].id) == relation.targets.end()) continue;
    for (const std::string& id : relation.references) add(model.find_item(id));
  }
  return found;
}

// Hard relations that tie an item to things of another kind: of a row or grid, those go first and the others follow them.
int anchors_of(const PlacementModel& model, ItemId item) {
  int anchors = 0;
  for (const ConstraintId c : model.touching[item]) {
    const Constraint& constraint = model.constraints[c];
    if (!constraint.relation.exists() || constraint.firmness != Firmness::kHard) continue;
    const Relation& relation = model.relation(constraint.relation);
    if (std::find(relation.targets.begin(), relation.targets.end(), model.items[item].id) == relation.targets.end()) continue;
    anchors += std::any_of(relation.references.begin(), relation.references.end(), [&](const std::string& id) {
      const ItemId other = model.find_item(id);
      return other.exists() && model.items[other].entry != model.items[item].entry;
    });
  }
  return anchors;
}

}  // namespace

bool stays(const Item& item) { return item.fixed || item.locked || (item.is_opening() && item.opening->offset); }

Dependencies::Dependencies(const PlacementModel& model) : hosts(model.items.size()), tenants(model.items.size()) {
  for (const ItemId i : model.items.ids()) {
    hosts[i] = hosts_of(model, i);
    for (const ItemId host : hosts[i]) tenants[host].push_back(i);
  }
}

std::vector<ItemId> placing_order(const PlacementModel& model, const Dependencies& dependencies, const Scope& scope,
                                  const ById<ItemId, int>& bonus) {
  struct Key {
    ItemId item;
    int bonus, group, anchors;
    std::int64_t area;
  };
  std::vector<Key> keys;
  for (const ItemId i : model.items.ids()) {
    const Item& item = model.items[i];
    if (scope.leaves_out(i)) continue;
    Key key{i, bonus[i], 3, anchors_of(model, i), 0};
    const Vec3& e = item.states[0].extent;
    key.area = std::int64_t{e[0]} * e[1];
    bool at_wall_by_relation = false;
    for (const ConstraintId c : model.touching[i]) {
      const Constraint& constraint = model.constraints[c];
      if (!constraint.relation.exists() || constraint.firmness != Firmness::kHard) continue;
      at_wall_by_relation |= relation_row(model.relation(constraint.relation).type).group == RelationGroup::kRoomGroup;
    }
    if (stays(item)) {
      key.group = 0;
    } else if (at_wall_by_relation && item.mount == Mount::kFloor) {
      key.group = 1;
    } else if (item.is_opening()) {
      key.group = 2;
    } else if (item.thin) {
      key.group = 5;
    } else if (item.mount != Mount::kFloor) {
      key.group = 4;
    }
    keys.push_back(key);
  }
  std::stable_sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
    return std::tuple(a.group != 0, -a.bonus, a.group, -a.area, -a.anchors, a.item) <
           std::tuple(b.group != 0, -b.bonus, b.group, -b.area, -b.anchors, b.item);
  });
  std::vector<ItemId> out;
  ById<ItemId, char> seen(model.items.size(), 0);
  const std::function<void(ItemId)> emit = [&](ItemId item) {
    if (seen[item] || scope.leaves_out(item)) return;
    seen[item] = 1;
    for (const ItemId other : dependencies.hosts[item]) emit(other);
    out.push_back(item);
  };
  for (const Key& key : keys) emit(key.item);
  return out;
}

void group_of(const Dependencies& dependencies, const Placements& placements, ItemId item, std::vector<ItemId>& group) {
  group.assign(1, item);
  for (std::size_t i = 0; i < group.size(); ++i) {
    for (const ItemId tenant : dependencies.tenants[group[i]]) {
      if (placements[tenant].state >= 0 && std::find(group.begin(), group.end(), tenant) == group.end()) group.push_back(tenant);
    }
  }
}

}  // namespace layoutbox::placement
