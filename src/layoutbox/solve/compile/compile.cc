#include "layoutbox/solve/compile.h"

#include <fmt/format.h>

#include <array>

#include "layoutbox/solve/compile/phrases.h"

namespace layoutbox::placement {
namespace {

using CompileFunction = void (*)(Compilation&);

constexpr std::array kFunctions{
#define LAYOUTBOX_RELATION(name, json_name, group, arity, kinds, parameters, sentence) CompileFunction{&compile_##name},
#include "layoutbox/scene/relation_list.inc"
#undef LAYOUTBOX_RELATION
};

Result<Reference> resolve(const Model& model, const std::string& id, std::string_view pointer) {
  if (id == "room" || id == "floor" || id == "ceiling") return Reference{Reference::Kind::kRoom, -1};
  if (const int item = model.find_item(id); item >= 0) return Reference{Reference::Kind::kItem, item};
  if (const int wall = model.find_wall(id); wall >= 0) return Reference{Reference::Kind::kWall, wall};
  return fail(ErrorCode::kReference, fmt::format("a relation speaks of \"{}\", which is not in the scene", id), std::string(pointer));
}

}  // namespace

Mm Compilation::length(const std::optional<Mm>& given, std::string_view parameter, Mm fallback) const {
  if (given) return *given;
  const auto usual = relation_default(relation.type, parameter);
  return usual ? mm_from_m(*usual) : fallback;
}

Place Compilation::place(const Reference& reference) const {
  if (reference.kind == Reference::Kind::kItem) return place_of(reference.index);
  if (reference.kind == Reference::Kind::kWall) return place_of(model, model.walls[reference.index]);
  Place room;
  for (int axis = 0; axis < 3; ++axis) room.lo[axis] = model.room.lo[axis], room.hi[axis] = model.room.hi[axis];
  return room;
}

std::vector<int> Compilation::reference_items() const {
  std::vector<int> found;
  for (const Reference& r : references) {
    if (r.kind == Reference::Kind::kItem) found.push_back(r.index);
  }
  return found;
}

std::vector<int> Compilation::walls() const {
  std::vector<int> found;
  for (const Reference& r : references) {
    if (r.kind == Reference::Kind::kWall) found.push_back(r.index);
  }
  const auto named = [](const Reference& r) { return r.kind != Reference::Kind::kRoom; };
  if (std::any_of(references.begin(), references.end(), named)) return found;
  for (std::size_t w = 0; w < model.walls.size(); ++w) found.push_back(static_cast<int>(w));
  return found;
}

Status compile_relation(const Model& model, const Relation& relation, std::string_view pointer, Constraint& out) {
  Compilation c{model, relation, {}, {}, out};
  for (const std::string& id : relation.targets) {
    LAYOUTBOX_ASSIGN(const Reference target, resolve(model, id, pointer));
    if (target.kind != Reference::Kind::kItem) {
      return fail(ErrorCode::kReference, fmt::format("\"{}\" is not an object that can be placed", id), std::string(pointer));
    }
    c.targets.push_back(target.index);
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
  // Openings in walls at an angle are known by the box around them only.
  const auto angled = [&](const Reference& r) {
    return r.kind == Reference::Kind::kItem && !model.items[r.index].states.empty() && model.items[r.index].is_opening() &&
           model.items[r.index].states[0].turn % 90 != 0;
  };
  if (std::any_of(c.references.begin(), c.references.end(), angled)) {
    const bool far = relation.type == RelationType::kFar || relation.type == RelationType::kFarFromDoor ||
                     relation.type == RelationType::kFarFromWindow || relation.type == RelationType::kNotBlocking;
    for (Formula& formula : out.formulas) {
      formula.exact = false;
      formula.outer.clear();
      if (!far) formula.cases.clear();  // not placed, and not said to be impossible
    }
  }
  // What cannot be said of such references (in front of the room) does not hold; without any, it holds of all there are.
  if (out.formulas.empty() && out.reach.empty() && !relation.references.empty()) c.never();
  return {};
}

}  // namespace layoutbox::placement
