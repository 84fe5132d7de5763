// A kitchen told by its units: what their middle, their ends and "above" mean where they stand in a run.
#include <algorithm>

#include "layoutbox/catalog/dressing.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/relation_builder_parts.h"
#include "layoutbox/plan/spoken.h"

namespace layoutbox::offline {

using R = RelationType;

// Does it stand in a kitchen's run? No island.
bool RelationBuilder::stands_in_run(const std::string& object) const {
  const SceneObject* unit = object_of(object);
  const CatalogEntry* entry = unit == nullptr ? nullptr : noun_of_object(*unit).entry;
  return entry != nullptr && entry->mount == Mount::kFloor && entry->back_to_wall && entry->is(Trait::kKitchenRun);
}

std::vector<std::string> RelationBuilder::units_of_run() const {
  std::vector<std::string> units;
  for (const SceneObject& object : scene_.objects) {
    if (stands_in_run(object.id)) units.push_back(object.id);
  }
  return units;
}

// "an oven below the hob": it is built in there, as high as the worktop, and carries the hob.
void RelationBuilder::build_in_ovens() {
  constexpr Mm kWorktop = 900;
  for (std::size_t r = 0; r < scene_.relations.size(); ++r) {
    Relation& under = scene_.relations[r];
    if (under.type != R::kUnder || under.targets.size() != 1 || under.references.size() != 1 || !stands_in_run(under.targets[0])) continue;
    const SceneObject* hob = object_of(under.references[0]);
    const CatalogEntry* entry = hob == nullptr ? nullptr : noun_of_object(*hob).entry;
    if (entry == nullptr || !entry->is(Trait::kHob) || entry->mount != Mount::kSurface) continue;
    std::swap(under.targets, under.references);
    under.type = R::kOn;
    of_target_[hob->id].push_back(r);
    std::erase(of_target_[under.references[0]], r);
    const std::size_t oven = objects_.at(under.references[0]);
    const NounPhrase& noun = noun_of_object(scene_.objects[oven]);
    if (noun.size.any() || scene_.objects[oven].size || noun.entry == nullptr) continue;
    SizeRange size = noun.entry->size;
    size.least.height = size.usual.height = size.greatest.height = kWorktop;
    scene_.objects[oven].size = size;
  }
}

// "fridge at the left end, sink in the middle, stove at the right end": of the run.
void RelationBuilder::place_in_run(Relation& relation, const std::vector<std::string>& units) {
  constexpr Mm kRun = 4000;  // how far off an end of it is
  if (relation.targets.size() != 1 || !relation.asked() || !stands_in_run(relation.targets[0])) return;
  const bool whole_room = relation.why.find("room") != std::string::npos || relation.why.find("kitchen") != std::string::npos;
  if (relation.type == R::kCenterOfRoom && !whole_room) relation.type = R::kCenteredOnWall;
  if (!relation.why.ends_with(" end")) return;
  const bool left = relation.why.find(" left") != std::string::npos, right = relation.why.find(" right") != std::string::npos;
  if (left == right) return;
  relation.references.clear();
  for (const std::string& unit : units) {
    const CatalogEntry& entry = *noun_of_object(*object_of(unit)).entry;
    if (unit != relation.targets[0] && entry.is(Trait::kWashUp)) relation.references = {unit};
  }
  relation.type = relation.references.empty() ? R::kInRegion : left ? R::kLeftOf : R::kRightOf;
  if (relation.references.empty())
    relation.parameters.region = left ? RoomRegion::kLeft : RoomRegion::kRight;
  else
    relation.parameters.max = kRun;
}

// "sink, stove and fridge, wall cabinets above": each over a low unit of its own.
void RelationBuilder::share_out_over_run(const std::vector<std::string>& units) {
  constexpr Mm kLow = 1150;
  std::vector<std::string> low;
  for (const bool worktop : {true, false}) {
    for (const std::string& unit : units) {
      const CatalogEntry& entry = *noun_of_object(*object_of(unit)).entry;
      const bool is_worktop = entry.is(Trait::kCounter) && entry.spaces.empty();
      if (entry.size.usual.height < kLow && !entry.is(Trait::kHob) && is_worktop == worktop) low.push_back(unit);
    }
  }
  std::size_t over = 0;
  for (Relation& above : scene_.relations) {
    const bool unsaid = above.type == R::kAbove && above.why == "above" && above.targets.size() == 1 && above.references.size() == 1;
    const SceneObject* cabinet = unsaid ? object_of(above.targets[0]) : nullptr;
    if (cabinet == nullptr || !catalog_.is_a(cabinet->category, "wall_cabinet") || !stands_in_run(above.references[0])) continue;
    if (over < low.size()) above.references = {low[over++]};
  }
}

void RelationBuilder::settle_kitchen() {
  build_in_ovens();
  const std::vector<std::string> units = units_of_run();
  if (units.size() < 2) return;
  for (Relation& relation : scene_.relations) place_in_run(relation, units);
  share_out_over_run(units);
  for (const KitchenForm& form : Dressings::builtin().kitchen_forms) {
    if (form.form != "one wall" || !Spoken(scene_, {}, catalog_).says_any(form.words)) continue;
    for (std::size_t i = 1; i < units.size(); ++i)
      add_habit(R::kSameOrientation, {units[i]}, {units[0]}, kTogether, "the units of the kitchen stand along one wall");
  }
}

}  // namespace layoutbox::offline
