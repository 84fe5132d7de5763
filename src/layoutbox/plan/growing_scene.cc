#include "layoutbox/plan/growing_scene.h"

#include <algorithm>
#include <utility>

#include "layoutbox/catalog/trait_table.h"

namespace layoutbox {

GrowingScene::GrowingScene(SceneGraph& scene, const SceneGraph& sized, const Catalog& catalog)
    : scene_(scene), sized_(sized), catalog_(catalog) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    by_id_.emplace(scene.objects[i].id, i);
    kinds_.insert(scene.objects[i].category);
  }
  for (std::size_t i = 0; i < sized.objects.size(); ++i) sized_by_id_.emplace(sized.objects[i].id, i);
  for (std::size_t i = 0; i < scene.relations.size(); ++i) note(i);
}

const SceneObject* GrowingScene::find(const std::string& id) const {
  const auto found = by_id_.find(id);
  return found == by_id_.end() ? nullptr : &scene_.objects[found->second];
}

const SceneObject* GrowingScene::sized(const std::string& id) const {
  const auto found = sized_by_id_.find(id);
  return found == sized_by_id_.end() ? nullptr : &sized_.objects[found->second];
}

bool GrowingScene::has_kind(const std::string& kind) const {
  return std::ranges::any_of(kinds_, [&](const std::string& there) { return catalog_.is_a(there, kind); });
}

const std::vector<std::size_t>& GrowingScene::relations_of(const std::string& id) const {
  static const std::vector<std::size_t> none;
  const auto found = relations_of_.find(id);
  return found == relations_of_.end() ? none : found->second;
}

std::string GrowingScene::add(const CatalogEntry& kind) {
  SceneObject object;
  object.category = kind.id;
  object.name = kind.name;
  object.origin = Origin::kAdded;
  int& number = last_number_[kind.id];
  do {
    object.id = kind.id + "_" + std::to_string(++number);
  } while (by_id_.contains(object.id));
  by_id_.emplace(object.id, scene_.objects.size());
  kinds_.insert(object.category);
  scene_.objects.push_back(std::move(object));
  return scene_.objects.back().id;
}

void GrowingScene::relate(RelationType type, std::vector<std::string> targets, const std::string& reference, std::optional<Mm> max) {
  Relation relation;
  relation.id = "a" + std::to_string(++relations_);
  relation.type = type;
  relation.targets = std::move(targets);
  relation.references = {reference};
  relation.parameters.max = max;
  relation.origin = Origin::kAdded;
  relation.why = "what its use needs";
  scene_.relations.push_back(std::move(relation));
  note(scene_.relations.size() - 1);
}

void GrowingScene::note(std::size_t relation) {
  const Relation& said = scene_.relations[relation];
  bool seats = false;
  for (const std::string& target : said.targets) {
    relations_of_[target].push_back(relation);
    const SceneObject* object = find(target);
    if (object == nullptr) continue;
    const CatalogEntry& kind = catalog_.entry_or_nearest(object->category);
    seats |= kind.is(Trait::kSeat) && !kind.is(Trait::kVisitorSeat);
  }
  if (seats) with_seat_.insert(said.references.begin(), said.references.end());
}

bool stands_on_floor(const Catalog& catalog, const SceneObject& object) {
  const CatalogEntry* entry = catalog.find(object.category);
  return entry != nullptr && object.mount.value_or(entry->mount) == Mount::kFloor && !entry->thin && !entry->is(Trait::kPet);
}

}  // namespace layoutbox
