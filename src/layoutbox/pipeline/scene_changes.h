// Changes to a scene that may settle why it has no layout; pipeline/ways_out.h tries them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox {

struct SceneChange {
  std::string sentence;
  std::string subject;   // of one subject and kind only one is shown
  nlohmann::json patch;  // RFC 6902, of the document
};

// What is to be changed. REQUIRES: all outlive the call.
struct Unsettled {
  const nlohmann::json& document;  // the scene as its planner wrote it
  const SceneGraph& scene;         // the same, normalised
  const Layout& layout;            // with its conflicts and what it gave up
  const Catalog& catalog;
  bool room_may_grow = false;
};

// The least first.
std::vector<SceneChange> propose_changes(const Unsettled& unsettled);

}  // namespace layoutbox
