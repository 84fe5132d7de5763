// A layout changed by words: the text is read into steps, the steps change the scene, and the solver follows the earlier layout.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/plan/edit.h"
#include "layoutbox/scene/layout.h"
#include "layoutbox/solve/solver.h"

namespace layoutbox {

// What became of one object.
struct ObjectChange {
  std::string id;
  std::vector<std::string> what;  // "added", "removed", "moved", "turned", "resized", "reshaped", "recolored", "renamed"
  double metres = 0;              // by how much its centre moved
  double degrees = 0;             // by how much it turned, counter-clockwise, −180…180
  bool asked = false;             // the text speaks of it; else it had to make room, or stood on what went
};

struct EditOutcome {
  SceneGraph scene;  // normalised; its relations are those that are asked for now
  Layout layout;
  std::vector<ObjectChange> changes;
  std::vector<Relation> dropped;  // what was asked for earlier and the edit takes back
  std::vector<Note> notes;
};

// Applies `text` to `layout`. All that it does not speak of stays as near to its place as can be; earlier wishes about where a thing
// stands hold on where they can, and are dropped where the edit contradicts them. What stands on a thing that goes, goes with it.
// `solve.from`, `locked`, `freed` and `on_conflict` are set here.
// Errors: those of plan_edit(); kGeometry (a size out of all bounds, an up that leads nowhere); kInfeasible and kNotFound where what is
// asked for cannot be, with the conflicts as details.
Result<EditOutcome> edit_layout(std::string_view text, const Layout& layout, const Catalog& catalog, SolveOptions solve = {});

}  // namespace layoutbox
