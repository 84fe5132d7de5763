// A carpet that many beds or desks stand on is as large as they are with ways between them.
#include <algorithm>

#include "layoutbox/catalog/measures.h"
#include "layoutbox/catalog/normalize_steps.h"

namespace layoutbox {
namespace {

constexpr std::size_t kManyOnCarpet = 3;
constexpr double kFurnitureArea = 0.7e6;  // mm²

// The furniture that stands on it: how many, and how wide and deep the largest are.
struct OnCarpet {
  std::size_t count = 0;
  Size each;
};

OnCarpet furniture_on(const SceneGraph& scene, const std::string& carpet) {
  OnCarpet on;
  for (const Relation& r : scene.relations) {
    if (r.type != RelationType::kOn || r.references != std::vector{carpet}) continue;
    for (const SceneObject& thing : scene.objects) {
      if (!names(r.targets, thing.id) || !thing.size) continue;
      const Size& size = thing.size->usual;
      if (1.0 * size.width * size.depth < kFurnitureArea) continue;
      ++on.count;
      on.each.width = std::max(on.each.width, size.width), on.each.depth = std::max(on.each.depth, size.depth);
    }
  }
  return on;
}

// In rows, each with room to get in and out at its long sides but those of the outermost.
bool stand_in_rows(const OnCarpet& on, const Size& carpet) {
  const Mm way = measures().getting_up;
  const auto places = [&](Mm width, Mm depth) {
    return static_cast<std::size_t>((width + way) / (on.each.width + way)) * static_cast<std::size_t>(depth / on.each.depth);
  };
  return std::max(places(carpet.width, carpet.depth), places(carpet.depth, carpet.width)) >= on.count;
}

// A tablecloth covers the table that it is on.
void spread_cloth(const NormalizeContext& context, SceneObject& cloth) {
  constexpr Mm kShort = 20;         // of the edge all round
  constexpr double kInRound = 0.7;  // of a round top's sides
  for (const Relation& r : context.scene.relations) {
    if (r.type != RelationType::kOn || r.references.size() != 1 || !names(r.targets, cloth.id)) continue;
    const auto table = std::ranges::find(context.scene.objects, r.references[0], &SceneObject::id);
    if (table == context.scene.objects.end() || !table->size || !context.catalog.is_a(table->category, "table")) continue;
    const bool round = std::ranges::any_of(table->attributes, [](const std::string& a) { return a == "round" || a == "oval"; });
    const auto spread = [&](Mm Size::*side) {
      const Mm top = table->size->usual.*side;
      const Mm length = round ? static_cast<Mm>(top * kInRound) : top - 2 * kShort;
      cloth.size->usual.*side = length;
      cloth.size->least.*side = std::min(cloth.size->least.*side, length);
      cloth.size->greatest.*side = std::max(cloth.size->greatest.*side, length);
    };
    spread(&Size::width);
    spread(&Size::depth);
    return;
  }
}

}  // namespace

void normalize_carpets(NormalizeContext& context) {
  for (SceneObject& cloth : context.scene.objects) {
    const bool ours = cloth.size && cloth.size_source == SizeSource::kCatalog;
    if (ours && context.catalog.is_a(cloth.category, "tablecloth")) spread_cloth(context, cloth);
  }
  constexpr int kSteps = 10, kMostSteps = 30;
  for (SceneObject& carpet : context.scene.objects) {
    if (!carpet.size || carpet.size_source != SizeSource::kCatalog || !context.catalog.entry_or_nearest(carpet.category).thin) continue;
    const OnCarpet on = furniture_on(context.scene, carpet.id);
    if (on.count < kManyOnCarpet) continue;
    Size& usual = carpet.size->usual;
    const Size before = usual;
    for (int step = 0; step < kMostSteps && !stand_in_rows(on, usual); ++step) {
      usual.width += before.width / kSteps;
      usual.depth += before.depth / kSteps;
    }
    Size& greatest = carpet.size->greatest;
    greatest.width = std::max(greatest.width, usual.width), greatest.depth = std::max(greatest.depth, usual.depth);
  }
}

}  // namespace layoutbox
