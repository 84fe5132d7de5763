#include "layoutbox/solve/compile/compile.h"

#include <fmt/format.h>

#include <array>

#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {
namespace {

using CompileFunction = void (*)(Compilation&);

constexpr std::array kFunctions{
#define LAYOUTBOX_RELATION(name, json_name, group, arity, kinds, parameters, sentence) CompileFunction{&compile_##name},
#include "layoutbox/scene/relation_list.inc"
#undef LAYOUTBOX_RELATION
};

Result<Reference> resolve(const PlacementModel& model, const std::string& id, std::string_view pointer) {
  if (id == "room" || id == "floor" || id == "ceiling") return Reference{Reference::Kind::kRoom, {}, {}};
  if (const ItemId item = model.find_item(id); item.exists()) return Reference{Reference::Kind::kItem, item, {}};
  if (const WallId wall = model.find_wall(id); wall.exists()) return Reference{Reference::Kind::kWall, {}, wall};
  return fail(ErrorCode::kReference, fmt::format("a relation speaks of \"{}\", which is not in the scene", id), std::string(pointer));
}

// Where the cases do not see that an item is turned, they speak of its quarter turns only, and at the others nothing is known.
void allow_quarter_turns(Formula& f, ItemId item, const Item& self) {
  const auto speaks_of = [&](const Case& one) {
    if (one.turned) return false;
    const auto names = [&](const Term& term) { return term.item == item; };
    return std::any_of(one.states.begin(), one.states.end(), [&](const StateLiteral& l) { return l.item == item; }) ||
           std::any_of(one.at_least_zero.begin(), one.at_least_zero.end(),
                       [&](const Linear& form) { return std::any_of(form.terms.begin(), form.terms.end(), names); });
  };
  if (f.exact && std::none_of(f.cases.begin(), f.cases.end(), speaks_of)) return;
  if (f.exact) f.outer = f.cases;
  const bool known = f.exact || !f.outer.empty();
  f.exact = false;
  const std::uint64_t quarters = quarter_states(self);
  for (std::vector<Case>* cases : {&f.cases, &f.outer}) {
    for (Case& one : *cases) {
      if (speaks_of(one)) one.when(item, quarters);
    }
  }
  if (quarters == 0) std::erase_if(f.cases, speaks_of);
  if (known) f.outer.emplace_back().when(item, self.odd_states);
}

void allow_turned_only_where_exact(Compilation& c) {
  const RelationTraits& exact = traits_of(c.relation.type);
  const auto restrict = [&](ItemId item) {
    if (c.item(item).odd_states == 0) return;
    if (c.relation.type == RelationType::kOpposite && !c.item(item).is_opening()) return;  // they look at each other
    for (Formula& f : c.out.formulas) allow_quarter_turns(f, item, c.item(item));
  };
  if (!exact.targets_turned) std::for_each(c.targets.begin(), c.targets.end(), restrict);
  if (exact.references_turned) return;
  const std::vector<ItemId> references = c.reference_items();
  std::for_each(references.begin(), references.end(), restrict);
  if (!references.empty()) return;
  for (const ItemId i : c.model.items.ids()) {  // those that are meant where none is named
    if (c.model.items[i].is_opening()) restrict(i);
  }
}

}  // namespace

Place Compilation::place(const Reference& reference) const {
  if (reference.kind == Reference::Kind::kItem) return place_of(reference.item);
  if (reference.kind == Reference::Kind::kWall) return place_of(model, model.walls[reference.wall]);
  Place room;
  for (int axis = 0; axis < 3; ++axis) room.lo[axis] = model.room.lo[axis], room.hi[axis] = model.room.hi[axis];
  return room;
}

std::vector<ItemId> Compilation::reference_items() const {
  std::vector<ItemId> found;
  for (const Reference& r : references) {
    if (r.kind == Reference::Kind::kItem) found.push_back(r.item);
  }
  return found;
}

std::vector<WallId> Compilation::walls() const {
  std::vector<WallId> found;
  for (const Reference& r : references) {
    if (r.kind == Reference::Kind::kWall) found.push_back(r.wall);
  }
  const auto named = [](const Reference& r) { return r.kind != Reference::Kind::kRoom; };
  if (std::any_of(references.begin(), references.end(), named)) return found;
  for (const WallId wall : model.walls.ids()) found.push_back(wall);
  return found;
}

Status compile_relation(const PlacementModel& model, const Relation& relation, std::string_view pointer, Constraint& out) {
  Compilation c{model, relation, {}, {}, out};
  for (const std::string& id : relation.targets) {
    LAYOUTBOX_ASSIGN(const Reference target, resolve(model, id, pointer));
    if (target.kind != Reference::Kind::kItem) {
      return fail(ErrorCode::kReference, fmt::format("\"{}\" is not an object that can be placed", id), std::string(pointer));
    }
    c.targets.push_back(target.item);
  }
  for (const std::string& id : relation.references) {
    LAYOUTBOX_ASSIGN(const Reference reference, resolve(model, id, pointer));
    // An object in relation to itself can never hold; a group may well name its own members.
    if (reference.kind == Reference::Kind::kItem && relation.targets.size() == 1 && id == relation.targets[0]) {
      out.formulas.emplace_back();
      return {};
    }
    c.references.push_back(reference);
  }
  if (c.targets.empty()) return {};
  const RelationArity arity = relation_row(relation.type).arity;
  if (c.references.empty() && (arity == RelationArity::kOne || arity == RelationArity::kMany)) {  // to nobody
    c.never();
    return {};
  }
  kFunctions[static_cast<std::size_t>(relation.type)](c);
  allow_turned_only_where_exact(c);
  // What cannot be said of such references (in front of the room) does not hold; without any, it holds of all there are.
  if (out.formulas.empty() && out.reach.empty() && !relation.references.empty()) c.never();
  return {};
}

}  // namespace layoutbox::placement
