// Small changes to a scene that has no layout, each of which gives it one. The solver has tried them.
#pragma once

#include <string>
#include <vector>

#include "layoutbox/pipeline/generate.h"

namespace layoutbox {

struct WayOut {
  std::string sentence;  // "put the wardrobe against the left wall instead"
  std::string patch;     // RFC 6902, for the document
};

struct WaysOutOptions {
  std::size_t most = 3;         // how many are enough
  std::size_t most_tries = 60;  // layouts that are tried
  double time_limit_s = 60;     // of all tries, the safety net: what is found is decided by counted work. REQUIRES: > 0
  bool room_may_grow = true;    // nobody gave the room's size
};

// `document`: the scene as JSON, before normalisation; `layout`: what solve() made of it, with its conflicts. The smallest changes first;
// each alone is enough. Empty where none was found in time.
std::vector<WayOut> find_ways_out(const std::string& document, const Layout& layout, const Catalog& catalog, const GenerateOptions& options,
                                  const WaysOutOptions& limits = {});

// True where something was given up that the scene asks for: a hard relation that is not ours, or an object.
bool gives_up_what_was_asked(const Layout& layout, const SceneGraph& scene);

}  // namespace layoutbox
