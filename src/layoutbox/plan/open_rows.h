// What lines walls and counters, where the text leaves open how many there are: as many as there is room for. What is counted and told to
// be along the walls is shared out over them.
#pragma once

#include <string>
#include <vector>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/plan/planner.h"

namespace layoutbox {

// The counter that a seat is told to be before or along; null: none.
const SceneObject* counter_of(const SceneGraph& scene, const Catalog& catalog, const std::string& seat);

// Adds to the scene of a plan what fills its walls and rows (marked as concluded: it gives way), and says for those told to be along the
// walls at which of them. REQUIRES: `sized` is the plan's scene normalised. Returns how many things were added.
std::size_t fill_rows(SceneGraph& scene, const SceneGraph& sized, const std::vector<Lining>& linings, const Catalog& catalog);

}  // namespace layoutbox
