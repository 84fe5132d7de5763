#include "layoutbox/catalog/normalize.h"

#include <fmt/format.h>

#include <algorithm>

#include "layoutbox/catalog/normalize_steps.h"

namespace layoutbox {

void NormalizeContext::note(std::string code, std::string message, std::string pointer) {
  scene.notes.push_back({std::move(code), std::move(message), std::move(pointer)});
}

void NormalizeContext::error(ErrorCode code, std::string message, std::string pointer, std::string hint) {
  errors.push_back({code, std::move(message), std::move(pointer), std::move(hint), {}});
}

std::string metres_text(double mm) { return fmt::format("{:.4g} m", mm / 1000); }

std::string unused_id(const SceneGraph& scene, const std::string& base) {
  const auto taken = [&](const std::string& id) {
    const auto same = [&](const auto& item) { return same_name(item.id, id); };
    return std::any_of(scene.objects.begin(), scene.objects.end(), same) ||
           std::any_of(scene.room.walls.begin(), scene.room.walls.end(), same) ||
           std::any_of(scene.room.openings.begin(), scene.room.openings.end(), same) ||
           std::any_of(scene.relations.begin(), scene.relations.end(), same) || id == "room" || id == "floor" || id == "ceiling";
  };
  if (!taken(base)) return base;
  for (int n = 2;; ++n) {
    if (const std::string id = fmt::format("{}_{}", base, n); !taken(id)) return id;
  }
}

Result<SceneGraph> normalize_scene(SceneGraph scene, const Catalog& catalog, const NormalizeOptions& options) {
  NormalizeContext context{scene, catalog, options, {}, {}};
  hang_curtains_at_windows(context);
  hang_shelves_under_mirrors(context);
  normalize_objects(context);
  normalize_hosts(context);
  normalize_guests(context);
  normalize_carpets(context);
  normalize_room(context);
  normalize_curtains(context);
  if (context.errors.empty()) normalize_slopes(context);
  if (context.errors.empty()) {
    normalize_distances(context);
    normalize_relations(context);
    normalize_worktops(context);
    check_parts(context);
    normalize_grids(context);
    normalize_visitors(context);
    normalize_support(context);
    normalize_screens(context);
  }
  if (!context.errors.empty()) {
    Error all = context.errors.front();
    if (context.errors.size() > 1) all.details = std::move(context.errors);
    return Failure(std::move(all));
  }
  return scene;
}

}  // namespace layoutbox
