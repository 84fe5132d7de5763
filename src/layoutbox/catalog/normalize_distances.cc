// Distances that words ask for, and the room they need.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "layoutbox/catalog/normalize_steps.h"
#include "layoutbox/catalog/size_words.h"

namespace layoutbox {
namespace {

// Where words give no number.
const Mm kFar = relation_row(RelationType::kFar).defaults.min.value_or(0);
const Mm kOpposite = relation_row(RelationType::kOpposite).defaults.min.value_or(0);
constexpr Mm kRoomToSpare = 100;
constexpr double kBody = 1800;  // two things at the ends
constexpr double kStep = 1.02, kMostGrowth = 1.6;
constexpr double kLongest = 1.7;  // times the shorter side: a room is not made longer than that for what is to be far apart

// What it takes of the floor's two sides, in a corner or at a wall.
std::optional<Point> footprint_of(const SceneGraph& scene, const std::string& id) {
  constexpr Mm kFromCorner = 150;
  if (const SceneObject* object = scene.find_object(id); object != nullptr && object->size)
    return Point{object->size->usual.width, object->size->usual.depth};
  for (const Opening& opening : scene.room.openings) {
    if (opening.id == id) return Point{opening.width + kFromCorner, 0};
  }
  constexpr Point kOrdinaryDoor{1050, 0}, kOrdinaryWindow{1350, 0};  // that nobody has made yet
  if (id.starts_with("door")) return kOrdinaryDoor;
  if (id.starts_with("window")) return kOrdinaryWindow;
  return std::nullopt;
}

// Visits each two things that a relation speaks of.
template <typename Visit>
void for_pairs(const SceneGraph& scene, const Relation& relation, const Visit& visit) {
  for (const std::string& target : relation.targets) {
    for (const std::string& reference : relation.references) {
      const auto a = footprint_of(scene, target), b = footprint_of(scene, reference);
      if (a && b) visit(*a, *b);
    }
  }
}

// How far apart the two can be at most, in opposite corners.
double farthest(Point a, Point b, double width, double depth) {
  double most = 0;
  for (const Point one : {a, Point{a.y, a.x}}) {
    for (const Point other : {b, Point{b.y, b.x}})
      most = std::max(most, std::hypot(std::max(0.0, width - one.x - other.x), std::max(0.0, depth - one.y - other.y)));
  }
  return most;
}

Mm least_distance(const Relation& relation) {
  if (relation.type == RelationType::kFar) return or_default(relation, &RelationParameters::min);
  return relation.type == RelationType::kDistance ? relation.parameters.min.value_or(0) : 0;
}

// A room that grows, to kMostGrowth times each of its sides.
class GrowingFloor {
 public:
  explicit GrowingFloor(FloorSides sides) : sides_(sides), most_{sides.width * kMostGrowth, sides.depth * kMostGrowth} {}
  const FloorSides& sides() const { return sides_; }

  // Until `is_enough` or it grows no more: its longer side first.
  template <typename Enough>
  void lengthen_until(const Enough& is_enough) {
    while (!is_enough(sides_)) {
      const bool wide = sides_.width >= sides_.depth;
      double &longer = wide ? sides_.width : sides_.depth, &shorter = wide ? sides_.depth : sides_.width;
      const double longest = wide ? most_.width : most_.depth, shortest = wide ? most_.depth : most_.width;
      if (longer < std::min(longest, kLongest * shorter)) {
        longer = std::min(longer * kStep, longest);
      } else if (shorter < shortest) {
        shorter = std::min(shorter * kStep, shortest);
      } else {
        return;
      }
    }
  }
  void grow_longer_to(double length) {
    lengthen_until([&](const FloorSides& s) { return std::max(s.width, s.depth) >= length; });
  }
  // Both sides.
  void grow_both_to(double length) {
    sides_.width = std::max(sides_.width, std::min(length, most_.width));
    sides_.depth = std::max(sides_.depth, std::min(length, most_.depth));
  }

 private:
  FloorSides sides_, most_;
};

bool at_named_wall(const SceneGraph& scene, const std::string& id) {
  return std::ranges::any_of(scene.relations, [&](const Relation& r) {
    const bool wall = relation_row(r.type).group == RelationGroup::kRoomGroup && !r.references.empty();
    return wall && std::ranges::find(r.targets, id) != r.targets.end();
  });
}

bool stands_sideways(const SceneGraph& scene, const std::string& id) {
  return std::ranges::any_of(scene.relations, [&](const Relation& r) {
    return r.type == RelationType::kSideAgainstWall && std::ranges::find(r.targets, id) != r.targets.end();
  });
}

// What it takes of the way from its wall to the other.
Mm depth_at_wall(const SceneGraph& scene, const SceneObject& object) {
  const Size& size = object.size->usual;
  return stands_sideways(scene, object.id) ? size.width : size.depth;
}

// From one wall to the other: a bed, the room between, a dressing table.
void grow_for_opposite(const SceneGraph& scene, const Relation& relation, GrowingFloor& floor) {
  const Mm between = or_default(relation, &RelationParameters::min);
  for (const std::string& reference : relation.references) {
    const SceneObject* ref = scene.find_object(reference);
    if (ref == nullptr || !ref->size || ref->mount != Mount::kFloor) continue;
    const bool in_middle = std::ranges::any_of(scene.relations, [&](const Relation& other) {
      return other.type == RelationType::kCenterOfRoom && other.targets == relation.references;
    });
    if (in_middle) floor.grow_longer_to(2.0 * between + 1.4 * kBody);
    for (const std::string& target : relation.targets) {
      const SceneObject* object = scene.find_object(target);
      if (object == nullptr || !object->size || object->mount != Mount::kFloor) continue;
      const double span = double(depth_at_wall(scene, *object)) + depth_at_wall(scene, *ref) + between + kRoomToSpare;
      const bool named = at_named_wall(scene, target) || at_named_wall(scene, reference);
      named ? floor.grow_both_to(span) : floor.grow_longer_to(span);
    }
  }
}

// The room has that size, whoever gave it: where two things cannot be far apart in it they are as far as it goes.
void settle_far(NormalizeContext& context, Relation& relation, double width, double depth) {
  constexpr double kShare = 0.85;
  constexpr Mm kRounded = 100;
  if (relation.type != RelationType::kFar || relation.parameters.min) return;
  double most = kFar + kRoomToSpare;
  for_pairs(context.scene, relation, [&](Point a, Point b) { most = std::min(most, farthest(a, b, width, depth)); });
  if (most >= kFar + kRoomToSpare) return;
  relation.parameters.min = static_cast<Mm>(kShare * most) / kRounded * kRounded;
  context.note("filled", fmt::format("in so small a room {} is far", metres_text(*relation.parameters.min)));
}

// The extent of the room across from the wall that a thing is named at; of no named one the longer.
double extent_across(const SceneGraph& scene, const std::vector<std::string>& ids, double width, double depth) {
  for (const Relation& r : scene.relations) {
    if (r.type != RelationType::kAgainstWall || r.references.size() != 1) continue;
    const bool here = std::ranges::any_of(ids, [&](const std::string& id) { return std::ranges::find(r.targets, id) != r.targets.end(); });
    const Wall* wall = here ? scene.find_wall(r.references.front()) : nullptr;
    if (wall != nullptr) return wall->start.x == wall->end.x ? width : depth;
  }
  return std::max(width, depth);
}

// A bed and the wardrobe opposite it in a room that is too narrow for the usual way between them: what way there is.
void settle_opposite(NormalizeContext& context, Relation& relation, double width, double depth) {
  constexpr Mm kLeast = 500, kRounded = 50;
  const SceneGraph& scene = context.scene;
  const bool across = relation.type == RelationType::kDistance && relation.parameters.min == kOpposite && relation.parameters.max;
  if ((relation.type != RelationType::kOpposite && !across) || relation.targets.size() != 1 || relation.references.size() != 1) return;
  const SceneObject *object = scene.find_object(relation.targets.front()), *ref = scene.find_object(relation.references.front());
  if (object == nullptr || ref == nullptr || !object->size || !ref->size || object->mount != Mount::kFloor || ref->mount != Mount::kFloor)
    return;
  const double left = extent_across(scene, {object->id, ref->id}, width, depth) - object->size->usual.depth - ref->size->usual.depth;
  if (left >= or_default(relation, &RelationParameters::min) || left < kLeast) return;
  relation.parameters.min = static_cast<Mm>(left) / kRounded * kRounded;
}

// A mirror above a washstand hangs, though such mirrors stand elsewhere, and ends below the ceiling.
void settle_height_above(NormalizeContext& context, const Relation& relation) {
  constexpr double kLeastShare = 0.5;  // of its least height
  constexpr Mm kFlat = 100;
  if (relation.type != RelationType::kAbove || relation.references.size() != 1) return;
  const SceneObject* host = context.scene.find_object(relation.references.front());
  if (host == nullptr || !host->size || host->mount != Mount::kFloor) return;
  const Mm room = context.scene.room.height - host->size->usual.height - kRoomToSpare;
  for (SceneObject& object : context.scene.objects) {
    const bool named = std::ranges::find(relation.targets, object.id) != relation.targets.end();
    if (named && object.size && object.mount == Mount::kFloor && object.mount_assumed && object.size->usual.depth <= kFlat)
      object.mount = Mount::kWall;
    if (!named || !object.size || object.size_source != SizeSource::kCatalog || !object.catalog_id.empty()) continue;
    if (object.size->usual.height <= room || room < kLeastShare * object.size->least.height) continue;
    object.size->usual.height = room;
    object.size->least.height = std::min(object.size->least.height, room);
    context.note("filled", fmt::format("\"{}\" is {} high, so that it finds room above \"{}\"", object.id, metres_text(room), host->id));
  }
}

// "floor-to-ceiling bookshelves" are as high as the room, where such things stand at walls and nobody gave their height.
void settle_full_height(NormalizeContext& context) {
  constexpr Mm kJoint = 20, kMost = 3200;
  const Mm full = std::min(context.scene.room.height - kJoint, kMost) / kGridMm * kGridMm;
  for (SceneObject& object : context.scene.objects) {
    const CatalogEntry* entry = context.catalog.find(object.category);
    if (entry == nullptr || !entry->back_to_wall || entry->mount != Mount::kFloor || object.mount != Mount::kFloor || !object.size ||
        object.size_source != SizeSource::kCatalog || !object.catalog_id.empty() || object.size->usual.height >= full)
      continue;
    const std::vector<std::string> said = words_said_of(object);
    if (std::ranges::none_of(kFullHeight, [&](std::string_view words) { return says(said, words); })) continue;
    object.size->least.height = object.size->usual.height = object.size->greatest.height = full;
  }
}

}  // namespace

FloorSides grown_for_distances(const NormalizeContext& context, FloorSides sides) {
  constexpr double kDiagonal = 1.3;  // of an ordinary room, by its longer side
  const SceneGraph& scene = context.scene;
  GrowingFloor floor(sides);
  for (const Relation& relation : scene.relations) {
    if (relation.type == RelationType::kOpposite) grow_for_opposite(scene, relation, floor);
    const Mm least = least_distance(relation);
    if (least <= 0) continue;
    floor.grow_longer_to((least + kBody) / kDiagonal);
    for_pairs(scene, relation, [&](Point a, Point b) {
      floor.lengthen_until([&](const FloorSides& s) { return farthest(a, b, s.width, s.depth) >= least + kRoomToSpare; });
    });
  }
  return floor.sides();
}

void normalize_distances(NormalizeContext& context) {
  settle_full_height(context);
  Point low{1 << 30, 1 << 30}, high{-(1 << 30), -(1 << 30)};
  for (const Point corner : context.scene.room.polygon) {
    low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
    high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
  }
  for (Relation& relation : context.scene.relations) {
    settle_far(context, relation, double(high.x) - low.x, double(high.y) - low.y);
    settle_opposite(context, relation, double(high.x) - low.x, double(high.y) - low.y);
    settle_height_above(context, relation);
  }
}

}  // namespace layoutbox
