#include "layoutbox/solve/solver.h"

#include <chrono>
#include <cmath>

#include "layoutbox/solve/cp_sat/library.h"
#include "layoutbox/solve/model/repeated.h"
#include "layoutbox/solve/solving.h"

namespace layoutbox {

Result<Layout> solve(const SceneGraph& scene, const Catalog& catalog, const SolveOptions& options) {
  if (options.effort <= 0 || !(options.time_limit_s > 0)) return fail(ErrorCode::kUsage, "effort and time limit must be positive");
  const auto started = std::chrono::steady_clock::now();
  placement::ModelOptions guides;
  guides.from = options.from, guides.locked = options.locked, guides.freed = options.freed, guides.unlike = options.unlike;
  const std::optional<SceneGraph> fewer = placement::without_repeats(scene);
  const SceneGraph& said_once = fewer ? *fewer : scene;
  LAYOUTBOX_ASSIGN(placement::PlacementModel model, placement::build_model(said_once, catalog, guides));
  auto layout = placement::Solver(said_once, catalog, options, std::move(model), started).run();
  if (layout && fewer) placement::add_repeats(scene, *layout);
  return layout;
}

Movement movement_between(const Layout& from, const Layout& to) {
  constexpr double kSame = 0.6;  // mm, degrees
  Movement sum;
  for (const PlacedObject& now : to.objects) {
    const PlacedObject* was = from.find_object(now.id);
    if (was == nullptr) continue;
    const double way = std::hypot(now.position[0] - was->position[0], now.position[1] - was->position[1]);
    const bool turned = std::abs(std::remainder(now.rotation_deg - was->rotation_deg, 360)) > kSame;
    sum.moved += way > kSame || turned || std::abs(now.position[2] - was->position[2]) > kSame;
    sum.metres += way / 1000;
  }
  return sum;
}

Result<std::string> describe_cp_sat_library() {
  LAYOUTBOX_ASSIGN(const placement::CpSatLibrary* library, placement::CpSatLibrary::get());
  return "OR-Tools " + library->version() + ", " + library->path();
}

}  // namespace layoutbox
