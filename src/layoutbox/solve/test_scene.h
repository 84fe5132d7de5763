// Scenes for tests and benches in a few words: SceneMaker(4000, 3200).add("bed").relate("againstWall", {"bed_1"}, {"wall3"}).
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "layoutbox/catalog/normalize.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox::placement {

class SceneMaker {
 public:
  SceneMaker(Mm width, Mm depth, Mm height = 2800) {
    scene_.room.polygon = {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
    scene_.room.height = height;
  }
  explicit SceneMaker(std::vector<Point> polygon, Mm height = 2800) {
    scene_.room.polygon = std::move(polygon);
    scene_.room.height = height;
  }

  // An object of that kind, named kind_1, kind_2…
  SceneMaker& add(const std::string& kind, int count = 1) {
    for (int i = 0; i < count; ++i) {
      SceneObject object;
      object.category = object.name = kind;
      int rank = 1;
      for (const SceneObject& other : scene_.objects) rank += other.category == kind;
      object.id = kind + "_" + std::to_string(rank);
      scene_.objects.push_back(object);
    }
    return *this;
  }
  // The last object's exact size.
  SceneMaker& sized(Mm width, Mm depth, Mm height) {
    const Size size{width, depth, height};
    scene_.objects.back().size = SizeRange{size, size, size};
    scene_.objects.back().size_source = SizeSource::kUser;
    return *this;
  }
  SceneMaker& mounted(Mount mount) { return scene_.objects.back().mount = mount, *this; }
  SceneMaker& at(double x, double y, double z, double turn, bool fixed) {
    SceneObject& object = scene_.objects.back();
    object.hint = {std::array{x, y, z}, turn};
    object.fixed = fixed;
    return *this;
  }
  SceneMaker& relate(const std::string& type, std::vector<std::string> targets, std::vector<std::string> references = {},
                     RelationParameters parameters = {}) {
    Relation relation;
    relation.id = "c" + std::to_string(scene_.relations.size() + 1);
    relation.type = find_relation(type)->type;
    relation.targets = std::move(targets);
    relation.references = std::move(references);
    relation.parameters = std::move(parameters);
    scene_.relations.push_back(relation);
    return *this;
  }
  SceneMaker& soft() { return scene_.relations.back().hard = false, *this; }
  SceneMaker& opening(OpeningType type, const std::string& wall, std::optional<Mm> offset, Mm width = 900, Mm sill = 0, Mm height = 2000) {
    Opening opening;
    opening.type = type;
    opening.wall = wall, opening.offset = offset, opening.width = width, opening.sill = sill, opening.height = height;
    opening.id = std::string(name_of(type)) + std::to_string(scene_.room.openings.size() + 1);
    scene_.room.openings.push_back(opening);
    return *this;
  }

  SceneGraph& raw() { return scene_; }
  SceneGraph make(bool default_openings = false) const {
    NormalizeOptions options;
    options.default_openings = default_openings;
    auto scene = normalize_scene(scene_, Catalog::builtin(), options);
    EXPECT_TRUE(scene) << scene.error().message;
    return scene ? *scene : SceneGraph{};
  }

 private:
  SceneGraph scene_;
};

}  // namespace layoutbox::placement
