#include "layoutbox/solve/solver.h"

#include <chrono>

#include "layoutbox/solve/cost.h"
#include "layoutbox/solve/cp_sat/library.h"
#include "layoutbox/solve/search.h"
#include "layoutbox/solve/to_layout.h"

namespace layoutbox {
namespace {

using namespace placement;

constexpr std::int64_t kStepsPerUnit = 2000;  // candidate positions tried in about a millisecond

}  // namespace

Result<Layout> solve(const SceneGraph& scene, const Catalog& catalog, const SolveOptions& options) {
  const auto started = std::chrono::steady_clock::now();
  LAYOUTBOX_ASSIGN(const Model model, build_model(scene, catalog));
  Budget budget;
  budget.limit = options.effort * kStepsPerUnit;
  Search search(model, std::vector<char>(model.constraints.size(), 0), options.seed, 0);
  std::vector<char> none(model.items.size(), 0);
  bool found = search.construct(none, 12, budget);
  if (found && options.improve) search.improve(budget);
  Layout layout = to_layout(model, search.placements());
  layout.status = found ? LayoutStatus::kSolved : LayoutStatus::kRelaxed;
  layout.stats.solver = "search";
  layout.stats.seed = options.seed;
  layout.stats.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  return layout;
}

Result<std::string> describe_cp_sat_library() {
  LAYOUTBOX_ASSIGN(const CpSatLibrary* library, CpSatLibrary::get());
  return "OR-Tools " + library->version() + ", " + library->path();
}

}  // namespace layoutbox
