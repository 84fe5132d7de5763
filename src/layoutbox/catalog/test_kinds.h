// Scenes of a few plain kinds, for the tests of what fills them in.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "layoutbox/catalog/normalize.h"

namespace layoutbox::test_kinds {

// A catalogue of a few plain kinds, so that these tests do not follow the data.
inline const Catalog& catalog() {
  static const Catalog value = Catalog::from_json(R"({"entries": [
    {"id": "bed", "name": "bed", "size": {"w": [0.9, 1.6, 2.0], "d": [1.9, 2.0, 2.2], "h": [0.4, 0.5, 1.2]}, "usedSides": ["front", "left", "right"],
     "variants": [{"words": ["king", "king size"], "size": {"w": [1.8, 1.9, 2.0]}}], "backToWall": true, "shape": {"family": "bed"}},
    {"id": "desk", "name": "desk", "synonyms": ["writing desk"], "size": {"w": [1.0, 1.2, 1.6], "d": [0.5, 0.6, 0.8], "h": 0.75}, "usedSides": ["front"],
     "topCarries": true, "shape": {"family": "desk"}},
    {"id": "nightstand", "name": "nightstand", "size": {"w": 0.4, "d": 0.4, "h": 0.5}, "topCarries": true, "shape": {"family": "cabinet"}},
    {"id": "lamp", "name": "lamp", "mount": "surface", "size": {"w": [0.2, 0.3, 0.4], "d": [0.2, 0.3, 0.4], "h": [0.3, 0.4, 0.6]}, "hasFront": false,
     "standsOn": ["nightstand", "desk"], "shape": {"family": "lamp"}},
    {"id": "floor_lamp", "name": "floor lamp", "kindOf": "lamp", "size": {"w": 0.4, "d": 0.4, "h": [1.3, 1.6, 1.8]}, "shape": {"family": "lamp"}},
    {"id": "book", "name": "book", "mount": "surface", "size": {"w": 0.2, "d": 0.15, "h": 0.03}, "shape": {"family": "book"}},
    {"id": "jar", "name": "jar", "traits": ["vessel"], "mount": "surface", "size": {"w": 0.12, "d": 0.12, "h": 0.2}, "shape": {"family": "jar"}},
    {"id": "towel", "name": "towel", "mount": "hung", "size": {"w": 0.5, "d": 0.05, "h": 0.7}, "shape": {"family": "cloth"}},
    {"id": "rug", "name": "rug", "thin": true, "size": {"w": 2.0, "d": 1.4, "h": 0.02}, "shape": {"family": "rug"}},
    {"id": "plant", "name": "plant", "size": {"w": 0.4, "d": 0.4, "h": [0.3, 0.8, 1.5]}, "hasFront": false, "shape": {"family": "plant"}},
    {"id": "tv", "name": "TV", "mount": "surface", "hangHeight": 1.0, "size": {"w": 1.2, "d": 0.1, "h": 0.7}, "standsOn": ["nightstand"], "shape": {"family": "tv"}},
    {"id": "workbench", "name": "workbench", "size": {"w": 1.5, "d": 0.7, "h": 0.9}, "topCarries": true, "shape": {"family": "desk"},
     "spaces": [{"name": "shelf", "min": ["-w/2+0.06", "-d/2+0.06", "0.18"], "max": ["w/2-0.06", "d/2-0.06", "h-0.06"]}]},
    {"id": "wardrobe", "name": "wardrobe", "size": {"w": [0.8, 1.5, 2.4], "d": 0.6, "h": [1.8, 2.0, 2.4]}, "backToWall": true, "shape": {"family": "cabinet"}}
  ]})",
                                                  R"({"rooms": [{"id": "bedroom", "name": "bedroom", "synonyms": ["master bedroom"],
    "size": {"w": 4.0, "d": 3.5, "h": 2.6}, "usual": [["bed", 1]]}]})")
                                   .value();
  return value;
}

inline SceneObject object(std::string id, std::string category) {
  SceneObject out;
  out.id = std::move(id);
  out.category = std::move(category);
  return out;
}

inline Relation relation(RelationType type, std::vector<std::string> targets, std::vector<std::string> references) {
  Relation out;
  out.type = type;
  out.targets = std::move(targets);
  out.references = std::move(references);
  return out;
}

inline SceneGraph scene_of(std::vector<SceneObject> objects, std::vector<Relation> relations = {}) {
  SceneGraph scene;
  scene.room.type = "bedroom";
  scene.objects = std::move(objects);
  scene.relations = std::move(relations);
  return scene;
}

inline SceneGraph normalized(SceneGraph scene, const NormalizeOptions& options = {}) {
  auto result = normalize_scene(std::move(scene), catalog(), options);
  if (!result) ADD_FAILURE() << result.error().message;
  return result.value_or(SceneGraph{});
}

inline SceneGraph with_whole_catalogue(const SceneGraph& scene) {
  auto normal = normalize_scene(scene, Catalog::builtin());
  EXPECT_TRUE(normal);
  return normal ? *normal : SceneGraph{};
}

inline Error error_of(SceneGraph scene) {
  const auto result = normalize_scene(std::move(scene), catalog());
  EXPECT_FALSE(result);
  return result ? Error{} : result.error();
}

inline std::vector<std::string> supports_of(const SceneGraph& scene, const std::string& id) {
  std::vector<std::string> out;
  for (const Relation& item : scene.relations) {
    if (item.type == RelationType::kOn && item.targets == std::vector{id}) out.push_back(item.references.at(0));
  }
  return out;
}

}  // namespace layoutbox::test_kinds
