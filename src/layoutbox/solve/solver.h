// Scene graph to layout: exact positions for everything, every hard relation held, nothing overlapping; or the reason why not.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/scene/layout.h"
#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

// What to do when the hard relations cannot all hold. Objects never overlap, save in kOriginal, which says so.
enum class OnConflict {
  kFail,      // an Error (kInfeasible) whose details are the conflicts
  kRelax,     // give up the least that matters, each listed with how much
  kOriginal,  // the paper's fallback: the scene's own positions, (1.0 m, 1.0 m) where there are none
};

struct SolveOptions {
  // Which of the good layouts: the same seed gives the same bytes. DEFAULT: 1.
  std::uint64_t seed = 1;
  // Work in deterministic units (about half a millisecond each on a 2020s core) for a room of six things, doors and windows
  // counted; more of them get as much more. REQUIRES: > 0. DEFAULT: 100.
  std::int64_t effort = 100;
  // Wall-clock safety net in seconds; when it steps in, stats.stopped_by_clock is set. REQUIRES: > 0. DEFAULT: 30.
  double time_limit_s = 30;
  OnConflict on_conflict = OnConflict::kRelax;
  // Improve the soft score after the first legal layout. DEFAULT: true.
  bool improve = true;
  // Have CP-SAT look where the search finds nothing. Without: less is found, nothing is proven, and with kFail the search's word is the
  // last (kNotFound), which takes a fraction of the time. DEFAULT: true.
  bool prove = true;
  // An earlier layout, legal or not, that guides: everything it has, by id, stays as near to its place there as can be (the sum of
  // the ways things are moved counts before everything that makes rooms good), what stood on a thing stays in its place on that, and
  // sizes and turns stay where the scene allows. Openings stay where the scene leaves their place open. Kept by the caller; may be null.
  const Layout* from = nullptr;
  // Ids of what stays exactly where it was in `from` (where there is none: at the scene's xform.pos), given up last of all: rather is
  // another object left out.
  std::vector<std::string> locked;
  // Ids of what `from` has but shall look for a new place all the same.
  std::vector<std::string> freed;
  // Layouts that this one is to be unlike: its largest things rather stand elsewhere or otherwise. Kept by the caller.
  std::vector<const Layout*> unlike;
  // Set by another thread to stop; the best layout so far is returned if there is one, else Error kInterrupted. May be null.
  const std::atomic<bool>* stop = nullptr;
  // Told now and then, in the thread that solves, how much of the effort is spent on better layouts: 0 … 1. May be empty.
  std::function<void(double share)> on_progress = {};
};

// REQUIRES: a normalised scene (catalog/normalize.h).
// Errors: kUsage (options out of range), kReference (a locked id that is not there), kInfeasible (with conflicts as details), kNotFound
// (limits reached without layout or proof), kNoSolver, kInterrupted.
Result<Layout> solve(const SceneGraph& scene, const Catalog& catalog, const SolveOptions& options = {});

// How far things are from where `from` had them: how many stand elsewhere or otherwise, and the sum of their ways in metres.
struct Movement {
  int moved = 0;
  double metres = 0;
};
Movement movement_between(const Layout& from, const Layout& to);

// How different two layouts of one scene are: how far apart the two places of a thing are on average, and how many things have another
// wall nearest to them.
struct Difference {
  double mean_m = 0;
  int other_wall = 0;
};
Difference difference_between(const Layout& a, const Layout& b);

// So many good layouts, each with the next seed and unlike those before it; fewer when it is stopped after the first.
// REQUIRES: count > 0. Errors: as of solve.
Result<std::vector<Layout>> solve_variants(const SceneGraph& scene, const Catalog& catalog, const SolveOptions& options, int count);

// Is the CP-SAT library there and of the right version? A sentence with its path and version, or the reason why not (kNoSolver).
Result<std::string> describe_cp_sat_library();

}  // namespace layoutbox
