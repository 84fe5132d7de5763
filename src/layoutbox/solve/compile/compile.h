// Relations to formulas: one function each. A row in relation_list.inc without a function here does not link.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/solve/model/model.h"

namespace layoutbox::placement {

// What a relation's reference turned out to be.
struct Reference {
  enum class Kind { kItem, kWall, kRoom } kind = Kind::kItem;
  ItemId item;
  WallId wall;
};

// Where a reference stands: an item's box, a wall's face from floor to ceiling, the room's box.
struct Place {
  std::array<Linear, 3> lo, hi;
  ItemId item;  // none: a wall or the room
};

// One relation on its way into the small form.
struct Compilation {
  const PlacementModel& model;
  const Relation& relation;
  std::vector<ItemId> targets;  // items
  std::vector<Reference> references;
  Constraint& out;

  // As given, else the table's default; 0 where there is neither.
  Mm length(std::optional<Mm> RelationFigures::*parameter) const { return or_default(relation, parameter); }
  Formula& formula() { return out.formulas.emplace_back(); }
  void never() { out.formulas.emplace_back(); }
  const Item& item(ItemId index) const { return model.items[index]; }
  Place place(const Reference& reference) const;
  std::vector<ItemId> reference_items() const;
  // The walls named; all straight walls where none is.
  std::vector<WallId> walls() const;
};

#define LAYOUTBOX_RELATION(name, json_name, group, arity, kinds, parameters, sentence) void compile_##name(Compilation& c);
#include "layoutbox/scene/relation_list.inc"
#undef LAYOUTBOX_RELATION

// Dispatches on the type. Errors: kReference, a target or reference that is not there.
Status compile_relation(const PlacementModel& model, const Relation& relation, std::string_view pointer, Constraint& out);

// The cases of an item's support (what holds it up), in the order of item.supports, which it fills.
Constraint compile_support(PlacementModel& model, ItemId item);

// Soft constraints for what the catalogue knows: backs to walls, chairs at their tables, sofas to televisions.
void add_habits(PlacementModel& model);

}  // namespace layoutbox::placement
