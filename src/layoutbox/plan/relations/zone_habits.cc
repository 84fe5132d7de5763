// What belongs to a named part of the room stands together there.
#include <algorithm>

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/plan/phrases/knowledge.h"
#include "layoutbox/plan/relations/relation_builder_parts.h"

namespace layoutbox::offline {

using R = RelationType;

// The one that the others stand by: what children sit round on the floor, else the greatest that is no chair, easy seats before the low
// table between them; -1: none.
int RelationBuilder::heart_of(const Zone& zone) const {
  int greatest = -1, rug = -1;
  bool looks = false;
  const auto area = [&](int item) {
    const CatalogEntry* entry = noun_of_item(item).entry;
    const Size& size = entry->size.usual;
    return entry->is(Trait::kCoffeeTable) ? 0 : double(size.width) * size.depth;
  };
  for (const int item : zone.items) {
    const CatalogEntry* entry = noun_of_item(item).entry;
    if (entry == nullptr || entry->mount != Mount::kFloor) continue;
    if (entry->thin) {
      if (rug < 0) rug = item;
      continue;
    }
    looks |= entry->is(Trait::kEasySeat) || entry->is(Trait::kCenterPiece) || entry->is(Trait::kTable) || entry->is(Trait::kDeskLike);
    if (!entry->is(Trait::kTableSeat) && (greatest < 0 || area(item) > area(greatest))) greatest = item;
  }
  return rug >= 0 && !looks ? rug : greatest;
}

void RelationBuilder::keep_zones() {
  for (const Zone& zone : document_.zones) {
    const int heart = heart_of(zone);
    if (heart < 0) continue;
    bool placed = false;
    for (const std::size_t r : relations_of(id(heart))) {
      const Relation& relation = scene_.relations[r];
      placed |= relation.references.empty() || object_of(relation.references.front()) == nullptr;
    }
    if (zone.corner && !placed) add_habit(R::kCorner, {id(heart)}, {}, kTogether, "what such a corner is for is in a corner");
    for (const int item : zone.items) {
      if (item != heart) keep_in_zone(zone, item, heart);
    }
    seat_in_zone(zone);
  }
}

// "a dining area with a table and six chairs on a rug": at the table.
void RelationBuilder::seat_in_zone(const Zone& zone) {
  const auto is_such = [&](int item, auto&& fits) {
    const CatalogEntry* entry = noun_of_item(item).entry;
    return entry != nullptr && entry->mount == Mount::kFloor && fits(*entry);
  };
  const auto table = std::ranges::find_if(zone.items, [&](int item) {
    return is_such(item, [&](const CatalogEntry& e) {
      return is_table(catalog_, noun_of_item(item)) && !e.is(Trait::kCoffeeTable) && !e.is(Trait::kDeskLike);
    });
  });
  if (table == zone.items.end()) return;
  std::vector<std::string> seats;
  for (const int item : zone.items) {
    if (!is_such(item, [](const CatalogEntry& e) { return e.is(Trait::kTableSeat); })) continue;
    const bool at_it = std::ranges::any_of(scene_.relations, [&](const Relation& r) {
      return std::ranges::find(r.targets, id(item)) != r.targets.end() && std::ranges::find(r.references, id(*table)) != r.references.end();
    });
    if (!at_it) seats.push_back(id(item));
  }
  if (seats.size() < 2) return;
  // … and what the rug is under is the table.
  for (Relation& r : scene_.relations) {
    if (r.type != R::kOn || r.targets.size() != 1 || r.references.size() != 1) continue;
    const SceneObject* under = object_of(r.references[0]);
    const CatalogEntry* rug = under == nullptr ? nullptr : catalog_.find(under->category);
    if (rug != nullptr && rug->thin && std::ranges::find(seats, r.targets[0]) != seats.end()) r.targets = {id(*table)};
  }
  conclude(R::kAround, seats, {id(*table)}, "those who sit in such a part of the room sit at its table");
}

// What looks at the heart of a group, is looked at from there, or lies under it stands as such things do.
bool RelationBuilder::has_usual_place(const CatalogEntry& entry, const CatalogEntry& heart) const {
  const auto sees = [&](const CatalogEntry& one, const CatalogEntry& other) {
    return std::ranges::any_of(one.faces, [&](const std::string& kind) { return catalog_.is_a(other.id, kind); });
  };
  const bool over_rug = heart.is(Trait::kTable) || heart.is(Trait::kCenterPiece) || heart.is(Trait::kBed);
  return (entry.thin && over_rug) || sees(heart, entry) || (!heart.is(Trait::kCoffeeTable) && sees(entry, heart));
}

// By the heart of the zone, unless words put it by something else there; the corner of the room is that one's.
void RelationBuilder::keep_in_zone(const Zone& zone, int item, int heart) {
  const CatalogEntry* entry = noun_of_item(item).entry;
  if (entry == nullptr) return;
  const bool rug = noun_of_item(heart).entry->thin;
  const bool lies = rug && (entry->is(Trait::kSeat) || entry->is(Trait::kEasySeat) || entry->mount == Mount::kSurface);
  const auto in_zone = [&](const std::string& other) {
    return std::ranges::any_of(zone.items, [&](int member) { return id(member) == other; });
  };
  bool tied = false;
  for (const std::size_t r : relations_of(id(item))) {
    Relation& relation = scene_.relations[r];
    tied |= std::ranges::any_of(relation.references, in_zone);
    if (relation.type != R::kCorner || relation.targets.size() != 1) continue;
    relation.type = lies ? R::kOn : R::kNextTo;
    relation.references = {id(heart)};
    relation.hard = lies && entry->mount == Mount::kSurface;
    relation.weight = kTogether;
    tied = true;
  }
  if (tied || entry->mount == Mount::kWall || entry->mount == Mount::kCeiling) return;
  const bool loose = entry->mount == Mount::kSurface && !lies;  // it stands on something
  const bool at_table = entry->is(Trait::kTableSeat) && std::ranges::any_of(zone.items, [&](int member) {
                          const CatalogEntry* table = noun_of_item(member).entry;
                          return table != nullptr && !table->is(Trait::kCoffeeTable) && is_table(catalog_, noun_of_item(member));
                        });
  if (loose || at_table || has_usual_place(*entry, *noun_of_item(heart).entry)) return;
  of_target_[id(item)].push_back(scene_.relations.size());
  add_habit(lies ? R::kOn : R::kNextTo, {id(item)}, {id(heart)}, kTogether, "what belongs to one corner stands together");
  scene_.relations.back().hard = lies && entry->mount == Mount::kSurface;
}

}  // namespace layoutbox::offline
