// Companions: what came unasked for with another thing is the first to give way, and goes with what it came with.
#include <fmt/format.h>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/solve/conflict/relax.h"
#include "layoutbox/solve/solving.h"

namespace layoutbox::placement {
namespace {

bool has(const std::vector<std::string>& ids, const std::string& id) { return std::ranges::find(ids, id) != ids.end(); }

bool came(const SceneObject& object) { return object.origin == Origin::kAdded; }

// What it stands at, on or behind though nobody said so.
std::vector<std::string> hosts_of(const SceneGraph& scene, const SceneObject& companion) {
  std::vector<std::string> hosts;
  for (const Relation& relation : scene.relations) {
    if (!relation.asked() && has(relation.targets, companion.id))
      hosts.insert(hosts.end(), relation.references.begin(), relation.references.end());
  }
  return hosts;
}

// Those of its kind share out what such things usually stand by: is none left for it?
bool has_no_share(const SceneGraph& scene, const Catalog& catalog, const SceneObject& companion, const std::vector<std::string>& gone) {
  const CatalogEntry* entry = catalog.find(companion.category);
  if (entry == nullptr) return false;
  std::size_t hosts = 0, hosts_left = 0, all = 0, before = 0, rank = 0;
  for (const SceneObject& object : scene.objects) {
    const bool left = !has(gone, object.id);
    if (object.category == companion.category) {
      if (!came(object) || !hosts_of(scene, object).empty()) continue;
      if (object.id == companion.id) rank = before;
      ++all, before += left;
    } else if (std::ranges::any_of(entry->beside, [&](const std::string& kind) { return catalog.is_a(object.category, kind); })) {
      ++hosts, hosts_left += left;
    }
  }
  return hosts > 0 && rank * hosts >= all * hosts_left;
}

}  // namespace

std::vector<std::string> companions_left_alone(const SceneGraph& scene, const Catalog& catalog, std::vector<std::string> gone) {
  std::vector<std::string> alone;
  for (bool again = true; again;) {
    again = false;
    for (const SceneObject& object : scene.objects) {
      if (!came(object) || has(gone, object.id)) continue;
      const std::vector<std::string> hosts = hosts_of(scene, object);
      const bool lost = hosts.empty() ? has_no_share(scene, catalog, object, gone)
                                      : std::ranges::all_of(hosts, [&](const std::string& host) { return has(gone, host); });
      if (!lost) continue;
      alone.push_back(object.id);
      gone.push_back(object.id);
      again = true;
    }
  }
  return alone;
}

bool Solver::is_companion(ItemId item) const {
  const Item& one = model_.items[item];
  return !one.is_opening() && !one.fixed && !one.locked && came(*one.object);
}

// The things that came unasked for with what they stand by, where that is what the constraint says; else none.
std::vector<std::string> Solver::companions_placed_by(const Constraint& constraint) const {
  if (!constraint.relation.exists()) return {};
  const Relation& relation = model_.relation(constraint.relation);
  const auto came_in = [&](const std::string& id) {
    const SceneObject* object = scene().find_object(id);
    return object != nullptr && came(*object);
  };
  if (relation.origin != Origin::kAdded || !std::ranges::all_of(relation.targets, came_in)) return {};
  return relation.targets;
}

// A chair that came with a desk and finds no place there is of no use elsewhere: it stays away.
Status Solver::leave_out_companions(std::vector<std::string> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  if (ids.empty()) return {};
  for (const std::string& id : ids) note_left_out(model_.find_item(id), "nobody asked for it, and no place was found where it is used");
  return rebuild();
}

std::vector<ItemId> Solver::companions() const {
  std::vector<ItemId> items;
  for (const ItemId i : model_.items.ids()) {
    if (is_companion(i)) items.push_back(i);
  }
  return items;
}

// Before anything that was asked for goes, all companions do, once, and come back in the end where they fit. False: there are none.
Result<bool> Solver::companions_make_way() {
  if (made_way_ || companions().empty()) return false;
  made_way_ = true;
  for (const ItemId item : companions()) note_left_out(item, "nobody asked for it, and what was asked for leaves no room for it");
  LAYOUTBOX_CHECK(rebuild());
  return true;
}

// Where one of these, which are to be left out, is dearer than companions are.
Result<bool> Solver::companions_make_way_for(const std::vector<ItemId>& items) {
  const auto is_dearer = [&](ItemId i) { return model_.items[i].object->origin < Origin::kAdded; };
  return std::ranges::any_of(items, is_dearer) ? companions_make_way() : Result<bool>(false);
}

// Does all else find its place without them?
bool Solver::companions_are_in_the_way() {
  if (made_way_) return false;
  std::vector<std::string> ids;
  for (const ItemId item : companions()) ids.push_back(model_.items[item].id);
  return !ids.empty() && unplaced_without(ids) == 0;
}

// What came with things that are left out goes with them.
void Solver::leave_out_the_lonely() {
  for (const std::string& id : companions_left_alone(asked_, catalog_, left_out_ids_)) {
    const ItemId item = model_.find_item(id);
    if (item.exists() && is_companion(item)) note_left_out(item, "so is what it came with");
  }
}

}  // namespace layoutbox::placement
