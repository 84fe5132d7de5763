#include "layoutbox/solve/model/model.h"

#include "layoutbox/solve/objective/access.h"

#include <fmt/format.h>
#include <cmath>

#include <set>

#include "layoutbox/solve/compile/compile.h"
#include "layoutbox/solve/model/items.h"
#include "layoutbox/solve/model/slanted.h"
#include "layoutbox/solve/priors/guide.h"

namespace layoutbox::placement {
namespace {

constexpr std::size_t kMostObjects = 500;

std::vector<ItemId> items_of(const std::vector<Case>& cases) {
  std::set<ItemId> items;
  for (const Case& one : cases) {
    for (const StateLiteral& literal : one.states) items.insert(literal.item);
    for (const Linear& form : one.at_least_zero) {
      for (const Term& term : form.terms) items.insert(term.item);
    }
    for (const Preference& wish : one.wishes) {
      for (const Term& term : wish.form.terms) items.insert(term.item);
    }
  }
  return {items.begin(), items.end()};
}

void index_constraints(PlacementModel& model) {
  model.touching.assign(model.items.size(), {});
  for (const ConstraintId c : model.constraints.ids()) {
    std::set<ItemId> items;
    for (Formula& formula : model.constraints[c].formulas) {
      formula.items = items_of(formula.cases);
      items.insert(formula.items.begin(), formula.items.end());
    }
    for (const ItemId item : items) model.touching[item].push_back(c);
  }
}

Status add_relations(PlacementModel& model) {
  const SceneGraph& scene = *model.scene;
  for (std::size_t i = 0; i < scene.relations.size(); ++i) {
    const Relation& relation = scene.relations[i];
    Constraint constraint;
    constraint.name = relation.id;
    constraint.relation = RelationId(i);
    constraint.firmness = relation.hard ? Firmness::kHard : Firmness::kSoft;
    constraint.weight = relation.hard ? relation.weight : 4 * relation.weight;
    LAYOUTBOX_CHECK(compile_relation(model, relation, fmt::format("/constraints/{}", i), constraint));
    model.constraints.push_back(std::move(constraint));
  }
  return {};
}

}  // namespace

std::uint64_t Item::states_at(int turn) const {
  std::uint64_t mask = 0;
  for (std::size_t s = 0; s < states.size(); ++s) {
    if (states[s].turn == turn) mask |= std::uint64_t{1} << s;
  }
  return mask;
}

Mm Item::least_extent(int axis) const {
  Mm least = states.empty() ? 0 : states[0].extent[axis];
  for (const State& state : states) least = std::min(least, state.extent[axis]);
  return least;
}

void PlacementModel::set_pair(ItemId a, ItemId b, PairRule rule) {
  pairs[a.index() * items.size() + b.index()] = rule;
  pairs[b.index() * items.size() + a.index()] = rule;
}

ItemId PlacementModel::find_item(std::string_view id) const {
  for (const ItemId i : items.ids()) {
    if (items[i].id == id) return i;
  }
  return {};
}

WallId PlacementModel::find_wall(std::string_view id) const {
  const Wall* wall = scene->find_wall(id);
  return wall ? WallId(static_cast<std::size_t>(wall - scene->room.walls.data())) : WallId();
}

bool PlacementModel::is_a(ItemId item, std::string_view kind) const {
  const SceneObject* object = items[item].object;
  if (object == nullptr) return false;
  auto known = kinds.find(kind);
  if (known == kinds.end()) known = kinds.emplace(kind, ById<ItemId, signed char>()).first;
  if (known->second.size() != items.size()) known->second.assign(items.size(), -1);
  signed char& answer = known->second[item];
  if (answer < 0) {
    const std::string& entry = items[item].entry->id;
    answer = catalog->is_a(object->category, kind) || (entry != object->category && catalog->is_a(entry, kind)) ? 1 : 0;
  }
  return answer > 0;
}

namespace {

// A normalised scene has no others; who builds one by hand may err.
Status check_numbers(const SceneGraph& scene) {
  constexpr Mm kLongest = 100'000;
  const auto wrong = [](Mm length) { return length <= 0 || length > kLongest; };
  const auto far = [](double number) { return !(std::abs(number) <= 10.0 * kLongest); };
  if (scene.room.polygon.size() < 3) return fail(ErrorCode::kGeometry, "the room has no floor", "/room");
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& object = scene.objects[i];
    const std::string where = fmt::format("/furniture/{}", i);
    if (!object.size) return fail(ErrorCode::kSchema, fmt::format("\"{}\" has no size", object.id), where);
    for (const Size& size : {object.size->least, object.size->usual, object.size->greatest}) {
      if (!wrong(size.width) && !wrong(size.depth) && !wrong(size.height)) continue;
      return fail(ErrorCode::kSchema, fmt::format("\"{}\" measures {} × {} × {} mm", object.id, size.width, size.depth, size.height), where,
                  "give every side a length above 0 and at most 100 m");
    }
    const auto place = object.hint.position.value_or(std::array<double, 3>{});
    if (std::any_of(place.begin(), place.end(), far) || far(object.hint.rotation_deg.value_or(0)))
      return fail(ErrorCode::kSchema, fmt::format("\"{}\" has a place that is none", object.id), where);
  }
  return {};
}

}  // namespace

Result<PlacementModel> build_model(const SceneGraph& scene, const Catalog& catalog, const ModelOptions& options) {
  LAYOUTBOX_CHECK(check_numbers(scene));
  if (scene.objects.size() > kMostObjects) {
    return fail(ErrorCode::kTooLarge, fmt::format("{} objects are more than the {} that can be placed", scene.objects.size(), kMostObjects),
                "/furniture");
  }
  PlacementModel model;
  model.scene = &scene;
  model.catalog = &catalog;
  const std::vector<Point>& polygon = scene.room.polygon;
  model.room = {{polygon[0].x, polygon[0].y, 0}, {polygon[0].x, polygon[0].y, scene.room.height}};
  for (const Point& p : polygon) {
    model.room.lo[0] = std::min(model.room.lo[0], p.x), model.room.hi[0] = std::max(model.room.hi[0], p.x);
    model.room.lo[1] = std::min(model.room.lo[1], p.y), model.room.hi[1] = std::max(model.room.hi[1], p.y);
  }
  model.outside = outside_of(polygon, 0, scene.room.height, 100);
  for (const Wall& wall : scene.room.walls) model.walls.push_back(room_wall(wall));
  add_headings(model);
  model.off_limits = off_limits_of(model);
  for (const SceneObject& object : scene.objects) model.items.push_back(object_item(scene, object, catalog, options, model.walls.list()));
  for (const Opening& opening : scene.room.openings) model.items.push_back(opening_item(opening, scene.room, model.walls.list()));
  for (Item& item : model.items) {
    add_spans(model, item);
    note_floor_use(item);
    item.all_states = item.states.size() >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << item.states.size()) - 1;
  }
  for (const ItemId i : model.items.ids()) {
    Item& item = model.items[i];
    item.support_constraint = model.constraints.push_back(item.is_opening() ? opening_place(model, i) : compile_support(model, i));
    if (!model.headings.empty() && !item.is_opening() && !item.fixed) {
      item.within_constraint = model.constraints.push_back(within_walls(model, i));
    }
    if (item.is_opening()) {
      item.clearance_constraint = model.constraints.push_back(opening_clearance(item));
    }
  }
  set_pair_rules(model);
  LAYOUTBOX_CHECK(add_relations(model));
  LAYOUTBOX_CHECK(find_starts(model, options));
  add_habits(model);
  add_stays(model);
  add_differences(model, options.unlike);
  index_constraints(model);
  return model;
}

}  // namespace layoutbox::placement
