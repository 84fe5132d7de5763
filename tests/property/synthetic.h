// Random scenes for tests of the solver and the verifier together: rooms of several shapes, furniture of the whole catalogue, relations
// of the whole table. The same options give the same scene on every machine.
#pragma once

#include <cstdint>
#include <optional>

#include "layoutbox/scene/layout.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox::synthetic {

struct SceneOptions {
  std::uint64_t seed = 1;
  // Objects tried; in a planted scene those that find no place are left out. DEFAULT: 3–12, by the seed.
  std::optional<int> objects;
  // Relations wanted. DEFAULT: up to as many as objects, by the seed.
  std::optional<int> relations;
  // True: a layout is drawn first and the relations are read from it, so that one exists. False: relations are drawn freely and may clash.
  bool planted = true;
};

struct Scene {
  SceneGraph scene;               // normalised
  std::optional<Layout> planted;  // a layout in which every hard relation holds without slack
};

// Never fails: a scene may come out with few objects or none.
Scene make_scene(const SceneOptions& options);

}  // namespace layoutbox::synthetic
