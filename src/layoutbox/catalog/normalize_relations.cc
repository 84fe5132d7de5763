#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/kin.h"
#include "layoutbox/catalog/normalize_steps.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/scene/relation_traits.h"

namespace layoutbox {
namespace {

// Ids for relations that have none, or one that another has: c1, c1_2, c1_3… In time linear in the scene.
void settle_relation_ids(SceneGraph& scene) {
  std::unordered_set<std::string> taken{"room", "floor", "ceiling"};
  const auto take_all = [&](const auto& items) {
    for (const auto& item : items) taken.insert(key_of(item.id));
  };
  take_all(scene.objects), take_all(scene.room.walls), take_all(scene.room.openings), take_all(scene.relations);
  std::unordered_set<std::string> used;
  std::string candidate = "c1";
  int next = 2;
  for (Relation& relation : scene.relations) {
    if (!relation.id.empty() && used.insert(relation.id).second) continue;
    while (!taken.insert(key_of(candidate)).second) candidate = fmt::format("c1_{}", next++);
    relation.id = candidate;
    used.insert(candidate);
  }
}

// The id that a reference means, or empty.
std::string settled_reference(const SceneGraph& scene, const std::string& reference) {
  if (scene.find_object(reference) != nullptr || scene.find_opening(reference) != nullptr) return reference;
  if (reference == "room" || reference == "floor" || reference == "ceiling") return reference;
  if (const Wall* wall = scene.find_wall(reference)) return wall->id;
  for (const SceneObject& object : scene.objects) {
    if (same_name(object.id, reference)) return object.id;
  }
  for (const Opening& opening : scene.room.openings) {
    if (same_name(opening.id, reference)) return opening.id;
  }
  for (const Opening& opening : scene.room.openings) {
    if (same_name(name_of(opening.type), reference)) return opening.id;
  }
  return {};
}

class SupportChooser {
 public:
  SupportChooser(NormalizeContext& context, SceneObject& object) : context_(context), scene_(context.scene), object_(object) {
    for (const SceneObject& one : scene_.objects) ++alike_[one.category];
  }

  bool is_supported() const {
    return std::ranges::any_of(scene_.relations, [&](const Relation& relation) {
      return traits_of(relation.type).supports && names(relation.targets, object_.id) &&
             (!relation.references.empty() || relation.type == RelationType::kStacked);
    });
  }

  // The paper's `inside` an object says what a thing stands on; else the habit of its kind; else whatever carries things.
  const SceneObject* choose() const {
    if (const SceneObject* around = inside_of()) return around;
    if (const SceneObject* there = in_same_region()) return there;
    // A single globe stands on none of twenty pupils' desks, where there is something else for it.
    const SceneObject* apart = alike(object_) == 1 ? choose_of([&](const SceneObject& o) { return alike(o) < kCrowd; }) : nullptr;
    return apart != nullptr ? apart : choose_of([](const SceneObject&) { return true; });
  }

 private:
  static constexpr int kCrowd = 4;

  int alike(const SceneObject& object) const { return alike_.at(object.category); }

  // "a counter and a coffee machine at the back": on what the text puts in the same part of the room.
  const SceneObject* in_same_region() const {
    const std::optional<RoomRegion> own = region_of(object_);
    if (!own || entry(object_).hang_height > 0) return nullptr;
    return freest([&](const SceneObject& o) {
      return entry(o).top_carries && o.mount == Mount::kFloor && !entry(o).is(Trait::kSeat) && region_of(o) == own;
    });
  }

  template <class Predicate>
  const SceneObject* choose_of(Predicate allowed) const {
    for (const std::string& id : entry(object_).stands_on) {
      const auto is_such = [&](const SceneObject& o) {
        return allowed(o) && context_.catalog.is_a(entry(o).id, id) &&
               !(context_.catalog.is_a(entry(o).id, kForClothes) && watched_from_sofa());
      };
      // A kettle rather stands on a cabinet than in the sink, which is a counter as well.
      if (const SceneObject* found = freest([&](const SceneObject& o) { return is_such(o) && entry(o).top_carries; })) return found;
      if (entry(object_).hang_height > 0) continue;  // a television is in no wardrobe
      if (const SceneObject* found = freest(is_such)) return found;
    }
    if (entry(object_).hang_height > 0) return nullptr;  // a television rather hangs than stands on the coffee table
    // Coats hang on no cupboard's top, boots stand on none, and hobs are no part of other tops than worktops.
    if (object_.mount == Mount::kHung || entry(object_).is(Trait::kKeptLow) || entry(object_).is(Trait::kHob)) return nullptr;
    const auto carries = [&](const SceneObject& o) { return allowed(o) && entry(o).top_carries && o.mount == Mount::kFloor; };
    // Where one sits nothing stands as long as there is another top.
    if (const SceneObject* found = freest([&](const SceneObject& o) { return carries(o) && !entry(o).is(Trait::kSeat); })) return found;
    return freest(carries);
  }

  // A television that a sofa is for is not put on the chest of drawers by the bed: it hangs before the sofa.
  static constexpr std::string_view kForClothes = "dresser";
  bool watched_from_sofa() const {
    return entry(object_).hang_height > 0 && std::ranges::any_of(scene_.objects, [&](const SceneObject& o) {
             return o.mount == Mount::kFloor && context_.catalog.is_a(o.category, "sofa");
           });
  }

  const CatalogEntry& entry(const SceneObject& object) const { return context_.catalog.entry_or_nearest(object.category); }

  const SceneObject* inside_of() const {
    for (const Relation& relation : scene_.relations) {
      if (relation.type != RelationType::kInside || !names(relation.targets, object_.id)) continue;
      for (const std::string& id : relation.references) {
        if (const SceneObject* found = scene_.find_object(id)) return found;
      }
    }
    return nullptr;
  }

  // The candidate with the most free top for its load; the first of equals.
  template <class Predicate>
  const SceneObject* freest(Predicate wanted) const {
    const SceneObject* best = nullptr;
    double best_load = 0;
    for (const SceneObject& candidate : scene_.objects) {
      const bool alike = !object_.name.empty() && candidate.name == object_.name;  // two loudspeakers do not stand on each other
      if (candidate.id == object_.id || alike || !wanted(candidate) || stands_apart_from(candidate) || rests_on(candidate, object_))
        continue;
      const double area = double(candidate.size->usual.width) * candidate.size->usual.depth;
      const double load = (loaded_area(candidate) + footprint(object_)) / area;
      if (load > 1 && !folds_on(candidate) && object_.mount != Mount::kHung) continue;  // a rail is thin, and carries many coats
      if (best == nullptr || load < best_load) {
        best = &candidate;
        best_load = load;
      }
    }
    return best;
  }

  // A blanket that is wider than the armchair lies on it folded.
  bool folds_on(const SceneObject& candidate) const {
    SceneObject thing = object_;
    fold_over_seat(context_.catalog, candidate, thing);
    return thing.size->usual.width < object_.size->usual.width && loaded_area(candidate) == 0;
  }

  static double footprint(const SceneObject& object) { return double(object.size->usual.width) * object.size->usual.depth; }

  double loaded_area(const SceneObject& candidate) const {
    double area = 0;
    for (const Relation& relation : scene_.relations) {
      if (!traits_of(relation.type).supports || !names(relation.references, candidate.id)) continue;
      for (const std::string& id : relation.targets) {
        if (const SceneObject* above = scene_.find_object(id)) area += footprint(*above);
      }
    }
    return area;
  }

  // The part of the room that the text puts it in.
  std::optional<RoomRegion> region_of(const SceneObject& object) const {
    for (const Relation& relation : scene_.relations) {
      if (relation.type == RelationType::kInRegion && names(relation.targets, object.id)) return relation.parameters.region;
    }
    return std::nullopt;
  }

  // A relation puts the two side by side or one under the other ("a lamp to the right of the desk"), or in two parts of the room.
  bool stands_apart_from(const SceneObject& candidate) const {
    const std::optional<RoomRegion> own = region_of(object_), its = own ? region_of(candidate) : std::nullopt;
    if (its && own != its) return true;
    return std::ranges::any_of(scene_.relations, [&](const Relation& relation) {
      const bool related = (names(relation.targets, object_.id) && names(relation.references, candidate.id)) ||
                           (names(relation.targets, candidate.id) && names(relation.references, object_.id));
      if (!related) return false;
      const RelationGroup group = relation_row(relation.type).group;
      return relation.type != RelationType::kCenteredOn && relation.type != RelationType::kFacing &&
             (group == RelationGroup::kPairGroup || group == RelationGroup::kGroupGroup || group == RelationGroup::kHeightGroup);
    });
  }

  bool rests_on(const SceneObject& upper, const SceneObject& lower, int depth = 0) const {
    if (depth > 20) return true;
    for (const Relation& relation : scene_.relations) {
      if (!traits_of(relation.type).supports || !names(relation.targets, upper.id)) continue;
      if (names(relation.references, lower.id)) return true;
      for (const std::string& id : relation.references) {
        const SceneObject* between = scene_.find_object(id);
        if (between != nullptr && rests_on(*between, lower, depth + 1)) return true;
      }
    }
    return false;
  }

  NormalizeContext& context_;
  SceneGraph& scene_;
  SceneObject& object_;
  std::unordered_map<std::string, int> alike_;  // by category: how many there are
};

// A lamp that must stand on the floor is a floor lamp, where the catalogue has one and nobody said how large it is.
void become_floor_kind(NormalizeContext& context, SceneObject& object, const std::string& pointer) {
  const CatalogEntry* kind = kind_at(context.catalog, object.category, KinPlace::kOnFloor);
  if (kind == nullptr || kind->mount != Mount::kFloor || object.size_source != SizeSource::kCatalog) return;
  context.note("guessed", fmt::format("\"{}\" stands on the floor: it is taken as a {}", object.id, kind->name), pointer + "/category");
  object.category = kind->id;
  object.size = kind->size;
  object.used_sides = kind->used_sides;
}

// A lamp of 1.5 m is none for a table, whatever its kind stands on.
bool outgrows_hosts(const NormalizeContext& context, const SceneObject& object) {
  const bool given = object.size_source == SizeSource::kUser || object.size_source == SizeSource::kInferred;
  const Mm greatest = context.catalog.entry_or_nearest(object.category).size.greatest.height;
  return given && object.mount_assumed && 2 * object.size->least.height > 3 * greatest;
}

// Nothing to stand on.
void settle_without_support(NormalizeContext& context, SceneObject& object, const std::string& pointer) {
  const bool hangs = object.mount == Mount::kHung || context.catalog.entry_or_nearest(object.category).hang_height > 0;
  object.mount = hangs ? Mount::kWall : Mount::kFloor;
  context.note("guessed", fmt::format("there is nothing that \"{}\" could be on: it goes on {}", object.id, hangs ? "a wall" : "the floor"),
               pointer + "/mount");
  if (!hangs) become_floor_kind(context, object, pointer);
}

void support_object(NormalizeContext& context, SceneObject& object, const std::string& pointer) {
  const SupportChooser chooser(context, object);
  if (object.fixed || chooser.is_supported()) return;
  const SceneObject* support = outgrows_hosts(context, object) ? nullptr : chooser.choose();
  if (support == nullptr) return settle_without_support(context, object, pointer);
  Relation relation;
  relation.id = unused_id(context.scene, fmt::format("{}_on_{}", object.id, support->id));
  relation.type = RelationType::kOn;
  relation.targets = {object.id};
  relation.references = {support->id};
  relation.why = fmt::format("a {} stands on something", object.name);
  relation.origin = Origin::kAssumed;
  fold_over_seat(context.catalog, *support, object);
  context.note("guessed", fmt::format("what \"{}\" stands on is not said: \"{}\" is taken", object.id, support->id), pointer);
  context.scene.relations.push_back(std::move(relation));
}

// Written z is the underside where that leaves the thing on a surface, else the centre of the body.
void settle_heights(NormalizeContext& context) {
  constexpr double kOnSurface = 15;
  std::vector<double> surfaces{0};
  for (const SceneObject& object : context.scene.objects) {
    if (object.mount == Mount::kFloor) surfaces.push_back(object.size->usual.height);
  }
  for (std::size_t i = 0; i < context.scene.objects.size(); ++i) {
    SceneObject& object = context.scene.objects[i];
    if (!object.hint.z_may_be_centre || !object.hint.position) continue;
    object.hint.z_may_be_centre = false;
    double& z = (*object.hint.position)[2];
    const double height = object.size->usual.height;
    const bool on_surface =
        std::ranges::any_of(surfaces, [&](double s) { return std::abs(z - s) <= kOnSurface && !(s == height && s != 0); });
    const bool at_ceiling = object.mount == Mount::kCeiling && std::abs(z + height - context.scene.room.height) <= kOnSurface;
    if (on_surface || at_ceiling) continue;
    z -= height / 2;
    context.note("converted", fmt::format("the z of \"{}\" is read as the centre of its body", object.id),
                 fmt::format("/furniture/{}/xform/pos/2", i));
  }
}

}  // namespace

void normalize_relations(NormalizeContext& context) {
  SceneGraph& scene = context.scene;
  std::vector<Relation> kept;
  for (std::size_t i = 0; i < scene.relations.size(); ++i) {
    Relation relation = std::move(scene.relations[i]);
    const std::string pointer = fmt::format("/constraints/{}", i);
    std::string unknown;
    for (const std::string& target : relation.targets) {
      if (scene.find_object(target) == nullptr) unknown = target;
    }
    // A group keeps its relation when a member is missing.
    std::erase_if(relation.targets, [&](const std::string& target) { return scene.find_object(target) == nullptr; });
    if (!relation.targets.empty()) unknown.clear();
    for (std::string& reference : relation.references) {
      const std::string id = settled_reference(scene, reference);
      if (id.empty())
        unknown = reference;
      else
        reference = id;
    }
    if (!unknown.empty()) {
      context.note("ignored",
                   fmt::format("the relation \"{}\" names \"{}\", which the scene does not have: it is left out", relation.id, unknown),
                   pointer);
      continue;
    }
    kept.push_back(std::move(relation));
  }
  scene.relations = std::move(kept);
  settle_relation_ids(scene);
}

void normalize_support(NormalizeContext& context) {
  for (std::size_t i = 0; i < context.scene.objects.size(); ++i) {
    SceneObject& object = context.scene.objects[i];
    if (object.mount == Mount::kSurface || object.mount == Mount::kHung) support_object(context, object, fmt::format("/furniture/{}", i));
  }
  settle_heights(context);
}

}  // namespace layoutbox
