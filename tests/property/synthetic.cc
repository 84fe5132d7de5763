#include "synthetic.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "layoutbox/catalog/normalize.h"
#include "synthetic_draft.h"

namespace layoutbox::synthetic {
namespace {

constexpr Mm kStep = 20;  // sizes are multiples: centres and edges then lie on the solver's 1 cm grid

Mm rounded(double length) { return std::max(kStep, static_cast<Mm>(std::lround(length / kStep)) * kStep); }

void add_opening(Draft& draft, const std::string& id, OpeningType type, Mm width, Mm height, Mm sill) {
  Opening opening;
  opening.id = id, opening.type = type, opening.width = width, opening.height = height, opening.sill = sill;
  opening.swing = type == OpeningType::kWindow
                      ? Swing::kNone
                      : draft.random.one_of(std::array{Swing::kInLeft, Swing::kInRight, Swing::kOutLeft, Swing::kSliding});
  if (!draft.options.planted && draft.random.chance(30)) {
    draft.scene.room.openings.push_back(opening);  // the solver finds its place
    return;
  }
  const Wall& wall = draft.random.one_of(draft.scene.room.walls);
  const Mm length = static_cast<Mm>(std::hypot(wall.end.x - wall.start.x, wall.end.y - wall.start.y));
  if (length < width + 100) return;
  opening.wall = wall.id;
  opening.offset = draft.random.number(0, (length - width) / 50) * 50;
  for (const Opening& other : draft.scene.room.openings) {
    if (other.wall == opening.wall && *opening.offset < *other.offset + other.width && *other.offset < *opening.offset + width) return;
  }
  draft.scene.room.openings.push_back(opening);
}

void make_room(Draft& draft) {
  const Mm width = draft.random.number(26, 70) * 100, depth = draft.random.number(26, 60) * 100;
  SceneGraph empty;
  empty.room.polygon = {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
  if (draft.random.chance(20)) {
    const Mm x = width * draft.random.number(4, 7) / 10 / 100 * 100, y = depth * draft.random.number(4, 7) / 10 / 100 * 100;
    empty.room.polygon = {{0, 0}, {width, 0}, {width, y}, {x, y}, {x, depth}, {0, depth}};
  }
  empty.room.height = draft.random.number(23, 32) * 100;
  NormalizeOptions normalize;
  normalize.default_openings = false;
  draft.scene.room = normalize_scene(empty, Catalog::builtin(), normalize)->room;
  if (draft.random.chance(85)) add_opening(draft, "door1", OpeningType::kDoor, 900, 2000, 0);
  if (draft.random.chance(70)) add_opening(draft, "window1", OpeningType::kWindow, 1200, 1200, 900);
  draft.layout.room = draft.scene.room;
}

void draw_object(Draft& draft) {
  const CatalogEntry& entry = draw_entry(draft.random);
  SceneObject object = object_of(draft.scene, entry);
  if (draft.random.chance(40)) object.size.reset(), object.size_source = SizeSource::kUnknown;
  if (draft.random.chance(10)) {
    object.hint.position = std::array<double, 3>{draft.random.number(0, 500) * 10.0, draft.random.number(0, 500) * 10.0, 0};
    object.hint.rotation_deg = draft.random.number(0, 3) * 90;
  }
  draft.scene.objects.push_back(std::move(object));
}

}  // namespace

const CatalogEntry& draw_entry(Random& random) {
  const CatalogEntry& drawn = random.one_of(Catalog::builtin().entries());
  return drawn.shape.family == "roof_slope" ? *Catalog::builtin().find("painting") : drawn;
}

SceneObject object_of(const SceneGraph& scene, const CatalogEntry& entry) {
  SceneObject object;
  object.category = entry.id, object.name = entry.name;
  object.id = entry.id + "_" + std::to_string(scene.objects.size() + 1);
  const Size usual{rounded(entry.size.usual.width), rounded(entry.size.usual.depth),
                   entry.thin ? entry.size.usual.height : rounded(entry.size.usual.height)};
  object.size = SizeRange{usual, usual, usual};
  object.size_source = SizeSource::kUser;
  object.mount = entry.mount;
  return object;
}

Scene make_scene(const SceneOptions& options) {
  Draft draft{options, Random(options.seed * 2 + options.planted), {}, {}};
  make_room(draft);
  const int wanted = options.objects.value_or(draft.random.number(3, 12));
  if (options.planted) {
    plant_objects(draft, wanted);
    read_relations(draft, options.relations.value_or(draft.random.number(1, wanted)));
  } else {
    for (int i = 0; i < wanted; ++i) draw_object(draft);
    for (int i = options.relations.value_or(draft.random.number(1, wanted + 2)); i > 0; --i)
      draft.scene.relations.push_back(draw_relation(draft, i));
  }
  NormalizeOptions normalize;
  normalize.default_openings = false;
  Result<SceneGraph> normalised = normalize_scene(draft.scene, Catalog::builtin(), normalize);
  Scene result;
  if (normalised) result.scene = *std::move(normalised);
  if (normalised && options.planted) result.planted = std::move(draft.layout);
  return result;
}

}  // namespace layoutbox::synthetic
