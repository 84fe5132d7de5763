// Several good layouts of one scene, and how different two are.
#include <cmath>

#include "layoutbox/solve/solver.h"

namespace layoutbox {
namespace {

// The wall nearest to its middle; "" where there is none.
std::string nearest_wall(const Layout& layout, const PlacedObject& object) {
  std::string nearest;
  double least = std::numeric_limits<double>::max();
  for (const Wall& wall : layout.room.walls) {
    const double dx = wall.end.x - wall.start.x, dy = wall.end.y - wall.start.y, length = std::hypot(dx, dy);
    if (length <= 0) continue;
    const double px = object.position[0] - wall.start.x, py = object.position[1] - wall.start.y;
    const double along = std::clamp((px * dx + py * dy) / length, 0.0, length);
    const double off = std::hypot(px - dx / length * along, py - dy / length * along);
    if (off < least - 0.5) least = off, nearest = wall.id;
  }
  return nearest;
}

}  // namespace

Difference difference_between(const Layout& a, const Layout& b) {
  Difference difference;
  int count = 0;
  for (const PlacedObject& one : a.objects) {
    const PlacedObject* other = b.find_object(one.id);
    if (other == nullptr) continue;
    ++count;
    difference.mean_m += std::hypot(one.position[0] - other->position[0], one.position[1] - other->position[1]) / 1000;
    difference.other_wall += nearest_wall(a, one) != nearest_wall(b, *other);
  }
  if (count > 0) difference.mean_m /= count;
  return difference;
}

Result<std::vector<Layout>> solve_variants(const SceneGraph& scene, const Catalog& catalog, const SolveOptions& options, int count) {
  if (count < 1) return fail(ErrorCode::kUsage, "at least one layout must be asked for");
  std::vector<Layout> layouts;
  layouts.reserve(static_cast<std::size_t>(count));  // those that are to be unlike are pointed to
  for (int k = 0; k < count; ++k) {
    SolveOptions one = options;
    one.seed = options.seed + static_cast<std::uint64_t>(k);
    if (options.on_progress) one.on_progress = [&options, k, count](double share) { options.on_progress((k + share) / count); };
    for (const Layout& earlier : layouts) one.unlike.push_back(&earlier);
    auto layout = solve(scene, catalog, one);
    if (!layout && !layouts.empty() && layout.error().code == ErrorCode::kInterrupted) break;  // those that are done are kept
    if (!layout) return Failure(std::move(layout).error());
    layouts.push_back(*std::move(layout));
  }
  return layouts;
}

}  // namespace layoutbox
