// What makers of rooms for the figures share: chance that is alike on every machine, relations, and the finished scene.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "layoutbox/catalog/normalize.h"

namespace layoutbox::bench {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15u + 77) {}
  int number(int low, int high) { return low + static_cast<int>(next() % static_cast<std::uint64_t>(high - low + 1)); }
  std::uint64_t next() {  // splitmix64
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

 private:
  std::uint64_t state_;
};

inline Relation relation(SceneGraph& scene, RelationType type, std::vector<std::string> targets, std::vector<std::string> references) {
  Relation r;
  r.id = "c" + std::to_string(scene.relations.size() + 1);
  r.type = type, r.targets = std::move(targets), r.references = std::move(references);
  return r;
}

inline void add(SceneGraph& scene, RelationType type, std::vector<std::string> targets, std::vector<std::string> references,
                RelationParameters parameters = {}) {
  scene.relations.push_back(relation(scene, type, std::move(targets), std::move(references)));
  scene.relations.back().parameters = std::move(parameters);
}

inline SceneGraph normalised(SceneGraph scene) {
  NormalizeOptions options;
  options.default_openings = false;
  auto out = normalize_scene(std::move(scene), Catalog::builtin(), options);
  return out ? *std::move(out) : SceneGraph{};
}

}  // namespace layoutbox::bench
