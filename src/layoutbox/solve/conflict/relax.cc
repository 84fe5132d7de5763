#include "layoutbox/solve/conflict/relax.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/solve/conflict/floor_sum.h"

namespace layoutbox::placement {
namespace {

// By origin: asked, concluded, added, assumed.
constexpr std::int64_t kRelations[] = {100'000, 70'000, 2'000, 1'000}, kObjects[] = {20'000'000, 90'000, 40'000, 20'000};
constexpr std::int64_t kWindowFloor = 3'000, kDoorFloor = 60'000, kLock = 30'000'000, kFixed = 40'000'000;
constexpr std::int64_t kWeight = 10, kRank = 100, kRanks = 100;  // asked relations by weight; objects by their place among those of a kind

bool has(const std::vector<std::string>& ids, const std::string& id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); }

const Relation* relation_of(const PlacementModel& model, const Demand& demand) {
  if (demand.is_item()) return nullptr;
  const RelationId relation = model.constraints[demand.constraint].relation;
  return relation.exists() ? &model.relation(relation) : nullptr;
}

// Its place among those of its kind, from 0.
int rank_of(const PlacementModel& model, ItemId item) {
  int rank = 0;
  for (const ItemId i : ids_before(item)) {
    const Item& other = model.items[i];
    rank += !other.is_opening() && other.object->category == model.items[item].object->category;
  }
  return rank;
}

std::int64_t footprint(const Item& item) { return std::int64_t{item.states[0].extent[0]} * item.states[0].extent[1]; }

}  // namespace

std::int64_t price_of(const PlacementModel& model, const Demand& demand) {
  if (demand.is_item()) {
    const Item& item = model.items[demand.item];
    if (item.is_opening() || item.fixed || item.locked) return kFixed;
    return kObjects[static_cast<int>(item.object->origin)] - kRank * std::min<std::int64_t>(rank_of(model, demand.item), kRanks);
  }
  if (const Relation* relation = relation_of(model, demand))
    return kRelations[static_cast<int>(relation->origin)] + (relation->asked() ? kWeight * relation->weight : 0);
  if (model.constraints[demand.constraint].firmness != Firmness::kImplied) return kLock;
  const auto is_window = [&](const Item& item) {
    return item.clearance_constraint == demand.constraint && item.opening->type == OpeningType::kWindow;
  };
  return std::any_of(model.items.begin(), model.items.end(), is_window) ? kWindowFloor : kDoorFloor;
}

bool is_assumption(const PlacementModel& model, const Constraint& constraint) {
  if (constraint.firmness == Firmness::kImplied) return true;
  return constraint.relation.exists() && !model.relation(constraint.relation).asked();
}

std::vector<ItemId> least_missed_first(const PlacementModel& model, std::vector<ItemId> items) {
  std::erase_if(items, [&](ItemId i) { return model.items[i].is_opening() || model.items[i].fixed || model.items[i].locked; });
  const auto key = [&](ItemId i) {
    const Item& item = model.items[i];
    return std::tuple(-static_cast<int>(item.object->origin), rank_of(model, i) == 0, footprint(item), -i.number());
  };
  std::stable_sort(items.begin(), items.end(), [&](ItemId a, ItemId b) { return key(a) < key(b); });
  return items;
}

std::vector<ItemId> objects_to_blame(const PlacementModel& model, const Clash& clash) {
  std::vector<ItemId> items;
  for (const Demand& demand : clash.demands) {
    if (relation_of(model, demand) != nullptr) return {};
    if (demand.is_item()) items.push_back(demand.item);
  }
  return least_missed_first(model, std::move(items));
}

LessScene without_objects(const SceneGraph& scene, const std::vector<std::string>& ids) {
  LessScene less{scene, {}};
  std::erase_if(less.scene.objects, [&](const SceneObject& o) { return has(ids, o.id); });
  std::vector<Relation> kept;
  for (Relation& relation : less.scene.relations) {
    if (take_out(relation, ids)) {
      kept.push_back(std::move(relation));
    } else {
      less.lost.push_back(relation.id);
    }
  }
  less.scene.relations = std::move(kept);
  return less;
}

std::string too_much_in_words(const PlacementModel& model, const Scope& scope) {
  const auto m2 = [](std::int64_t area) { return static_cast<double>(area) / 1e6; };
  const FloorSum floor = floor_sum(model, scope);
  const auto things = std::ranges::count_if(model.items, [](const Item& item) { return !item.is_opening(); });
  const std::string before = floor.door.exists() ? fmt::format(", {:.2f} m² stay free before the door", m2(floor.before_door)) : "";
  return fmt::format(
      "no layout was found for all {} objects together: they cover at least {:.2f} m² of floor{}, and the room has {:.2f} m²", things,
      m2(floor.covered), before, m2(floor.room));
}

}  // namespace layoutbox::placement
