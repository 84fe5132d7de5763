#include "layoutbox/plan/offline/seat_kinds.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace layoutbox::offline {

void seat_children(const Catalog& catalog, SceneGraph& scene) {
  const auto is_kind = [&](const std::string& id, std::string_view kind) {
    return std::ranges::any_of(scene.objects, [&](const SceneObject& o) { return o.id == id && o.category == kind; });
  };
  for (const Relation& relation : scene.relations) {
    if (relation.references.size() != 1 || !is_kind(relation.references[0], "kids_table")) continue;
    for (SceneObject& object : scene.objects) {
      const bool at_it = std::ranges::find(relation.targets, object.id) != relation.targets.end();
      if (at_it && object.category == "chair" && catalog.find("kids_chair") != nullptr) object.category = "kids_chair";
    }
  }
}

}  // namespace layoutbox::offline
