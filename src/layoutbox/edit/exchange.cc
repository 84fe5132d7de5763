// Things that take the places of others.
#include "layoutbox/edit/changes.h"
#include "layoutbox/edit/stepper.h"

namespace layoutbox {

using R = RelationType;

Status EditStepper::swap(const std::string& a, const std::string& b) {
  // Where they stand is swapped; what is said of other things by them stays.
  for (Relation& relation : scene_.relations) {
    const bool of_a = has_id(relation.targets, a), of_b = has_id(relation.targets, b);
    const bool by_a = has_id(relation.references, a), by_b = has_id(relation.references, b);
    if (of_a == of_b && !(of_a && by_b) && !(of_b && by_a)) continue;
    if (!says_where(relation.type) && !is_turn(relation.type)) continue;
    const auto exchange = [&](std::string& id) { id = id == a ? b : id == b ? a : id; };
    std::for_each(relation.targets.begin(), relation.targets.end(), exchange);
    if ((of_a && by_b) || (of_b && by_a)) std::for_each(relation.references.begin(), relation.references.end(), exchange);
    soften(relation);
  }
  PlacedObject *first = guide(a), *second = guide(b);
  SceneObject *first_object = object(a), *second_object = object(b);
  if (first == nullptr || second == nullptr || first_object == nullptr || second_object == nullptr) return {};
  const PlacedObject old = *first;
  take_place(*first, *second);
  take_place(*second, old);
  std::swap(first_object->mount, second_object->mount);
  return {};
}

// What was said of the one holds for the other, and it stands where that stood.
void EditStepper::take_over(const std::string& old_id, SceneObject& fresh) {
  const SceneObject* old = object(old_id);
  const CatalogEntry& entry = catalog_.entry_or_nearest(fresh.category);
  const bool same_mount = old != nullptr && old->mount == entry.mount;
  if (old != nullptr && (same_mount || old->mount == Mount::kSurface)) fresh.mount = old->mount;
  for (Relation& relation : scene_.relations) {
    for (Ids* ids : {&relation.targets, &relation.references}) {
      if (!has_id(*ids, old_id)) continue;
      std::replace(ids->begin(), ids->end(), old_id, fresh.id);
      if (!same_mount) soften(relation);
    }
  }
  const PlacedObject* place = guide(old_id);
  if (place == nullptr) return;
  PlacedObject placed = *place;
  placed.id = fresh.id;
  placed.size = fresh.size ? fresh.size->usual : entry.size.usual;
  placed.spaces.clear();
  take_place(placed, *place);
  guide_.objects.push_back(placed);
  for (PlacedObject& other : guide_.objects) {
    if (other.supported_by == old_id) other.supported_by = fresh.id;
  }
}

Status EditStepper::replace(const EditStep& step) {
  for (std::size_t i = 0; i < step.objects.size(); ++i) {
    SceneObject fresh = step.objects[i];
    if (i < step.targets.size()) {
      take_over(step.targets[i], fresh);
    } else {
      Relation beside;
      beside.type = R::kNextTo;
      beside.targets = {fresh.id};
      beside.references = {step.objects.front().id};
      beside.hard = false;
      beside.origin = Origin::kAssumed;
      beside.why = step.why;
      scene_.relations.push_back(std::move(beside));
    }
    scene_.objects.push_back(std::move(fresh));
  }
  return remove(step.targets);
}

}  // namespace layoutbox
