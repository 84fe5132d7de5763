// A room of which nobody says how large it is, solved in a size that holds what is asked for.
#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "layoutbox/pipeline/generate.h"
#include "layoutbox/plan/planner.h"

namespace layoutbox {

struct FittedRoom {
  std::vector<Layout> layouts;       // variants, the best first
  std::optional<SceneGraph> larger;  // the scene they are of, where it is not the given one
};

// The scene's room was guessed too small where not all that is asked for has a place in it, or only things smaller than they usually are:
// then larger ones are tried, all within the one limit of time since `started`. `plan`: what the scene was made of; null: it stays as it
// is.
Result<FittedRoom> solve_where_it_fits(const SceneGraph& scene, const Plan* plan, const Catalog& catalog, const GenerateOptions& options,
                                       std::chrono::steady_clock::time_point started);

}  // namespace layoutbox
