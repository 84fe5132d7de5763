// What the text says of a thing that cannot all be true.
#include <algorithm>

#include "layoutbox/plan/offline/knowledge.h"
#include "layoutbox/plan/offline/relation_builder_parts.h"

namespace layoutbox::offline {

using R = RelationType;

void RelationBuilder::note_contradictions() {
  for (const SceneObject& object : scene_.objects) {
    const Relation *wall = nullptr, *middle = nullptr;
    for (const Relation& relation : scene_.relations) {
      if (std::find(relation.targets.begin(), relation.targets.end(), object.id) == relation.targets.end()) continue;
      const bool at_wall = relation.type == R::kAgainstWall || relation.type == R::kCorner || relation.type == R::kCenteredOnWall;
      if (at_wall && wall != nullptr && relation.type == R::kAgainstWall && wall->type == R::kAgainstWall && !relation.references.empty() &&
          !wall->references.empty() && relation.references != wall->references && !opposite_ok(relation, *wall)) {
        scene_.notes.push_back(
            {"contradiction", "\"" + object.name + "\" cannot be \"" + wall->why + "\" and \"" + relation.why + "\"", "prompt"});
      }
      if (at_wall) wall = &relation;
      if (relation.type == R::kCenterOfRoom) middle = &relation;
    }
    if (wall != nullptr && middle != nullptr) {
      scene_.notes.push_back(
          {"contradiction", "\"" + object.name + "\" cannot be \"" + wall->why + "\" and \"" + middle->why + "\"", "prompt"});
    }
  }
}

bool RelationBuilder::opposite_ok(const Relation& a, const Relation& b) {
  const auto side = [](const std::string& w) { return w == "left" || w == "right"; };
  return side(a.references.front()) != side(b.references.front());
}

}  // namespace layoutbox::offline
