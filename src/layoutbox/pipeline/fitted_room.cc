#include "layoutbox/pipeline/fitted_room.h"

#include <algorithm>

#include "layoutbox/pipeline/repair.h"

namespace layoutbox {
namespace {

// Where relations contradict each other whatever the sizes are, no room is large enough.
bool lacks_room(const Layout& layout) {
  if (layout.status == LayoutStatus::kFallback || layout.relaxed.empty()) return false;
  return layout.conflicts.empty() || std::ranges::any_of(layout.conflicts, [](const Conflict& c) { return !c.objects.empty(); });
}

// Most rooms are made to fit their furniture, not the other way round.
bool is_cramped(const Layout& layout) {
  constexpr double kMostShrunk = 0.8;  // of the score for usual sizes: two steps below them and more
  const auto sizes = layout.score_terms.find("sizes");
  return layout.status != LayoutStatus::kFallback && sizes != layout.score_terms.end() && sizes->second < kMostShrunk;
}

bool has_more_room(const Layout& larger, const Layout& room) {
  if (larger.relaxed.size() != room.relaxed.size()) return larger.relaxed.size() < room.relaxed.size();
  return is_cramped(room) && larger.score > room.score;
}

}  // namespace

Result<FittedRoom> solve_where_it_fits(const SceneGraph& scene, const Plan* plan, const Catalog& catalog, const GenerateOptions& options,
                                       std::chrono::steady_clock::time_point started) {
  FittedRoom fitted;
  LAYOUTBOX_ASSIGN(fitted.layouts, solve_variants(scene, catalog, options.solve, options.variants));
  for (const double growth : {1.15, 1.3}) {
    SolveOptions rest = options.solve;
    rest.time_limit_s -= std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    const bool stopped = options.stop != nullptr && options.stop->load();
    const Layout& best = fitted.layouts.front();
    if (plan == nullptr || stopped || rest.time_limit_s <= 0 || (!lacks_room(best) && !is_cramped(best))) break;
    GenerateOptions larger = options;
    larger.normalize.room_growth = growth;
    auto made = prepare_plan(*plan, catalog, larger);
    const SceneGraph& now = fitted.larger ? *fitted.larger : scene;
    if (!made || made->room.polygon == now.room.polygon) break;
    auto again = solve_variants(*made, catalog, rest, options.variants);
    if (!again || !has_more_room(again->front(), best)) continue;
    fitted.larger = std::move(*made);
    fitted.layouts = std::move(*again);
  }
  return fitted;
}

}  // namespace layoutbox
