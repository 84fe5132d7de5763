#include "layoutbox/judge/rays.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "layoutbox/base/units.h"
#include "layoutbox/catalog/trait_table.h"

namespace layoutbox::scoring {
namespace {

constexpr int kRaysAcross = 41, kRaysDeep = 5;  // rays

// Where a ray meets the box of that half size around the origin: from the outside where it enters, from the inside where it leaves.
std::optional<double> meets_box(Vec2d start, Vec2d step, double half_x, double half_y) {
  const auto steady = [](double value) { return std::abs(value) < 1e-12 ? 1e-12 : value; };
  const Vec2d s{steady(step.x), steady(step.y)};
  const Vec2d first{(-half_x - start.x) / s.x, (-half_y - start.y) / s.y}, second{(half_x - start.x) / s.x, (half_y - start.y) / s.y};
  const double enter = std::max(std::min(first.x, second.x), std::min(first.y, second.y));
  const double leave = std::min(std::max(first.x, second.x), std::max(first.y, second.y));
  if (leave < enter || leave < 0) return std::nullopt;
  return enter > 0 ? enter : leave;
}

}  // namespace

Scored look_at(const Block& target, const Block& reference, Vec2d front) {
  const auto into = [&](Vec2d v) { return Vec2d{dot(v, reference.frame.x), dot(v, reference.frame.y)}; };
  const Vec2d step = into(front);
  Vec2d sum;
  int hits = 0;
  for (int i = 0; i < kRaysAcross; ++i) {
    for (int j = 0; j < kRaysDeep; ++j) {
      const double x = (i + 0.5) / kRaysAcross * 2 - 1, y = (j + 0.5) / kRaysDeep * 2 - 1;
      const Vec2d at = target.center() + target.frame.x * (x * target.half[0]) + target.frame.y * (y * target.half[1]);
      const Vec2d start = into(at - reference.center());
      const auto reach = meets_box(start, step, reference.half[0], reference.half[1]);
      if (!reach) continue;
      sum = sum + start + step * *reach;
      ++hits;
    }
  }
  if (hits == 0) return {0, "its front does not look at the other", {}};
  const Vec2d mean = sum * (1.0 / hits);
  const Vec2d look = reference.center() + reference.frame.x * mean.x + reference.frame.y * mean.y - target.center();
  const double cosine = dot(look, front) / std::max(checks::length(look), 1e-9);
  const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / kPi;
  return {std::max(0.0, 1 - angle / 30), fmt::format("turned {:.0f} degrees from it (limit 15)", angle), {}};
}

Scored faces(const Block& target, const Block& reference) {
  Scored own = look_at(target, reference, target.frame.y * -1);
  const bool worked_at = target.body && target.body->entry->is(Trait::kDeskLike);
  if (!worked_at) return own;
  Scored user = look_at(target, reference, target.frame.y);
  return user.score > own.score ? user : own;
}

}  // namespace layoutbox::scoring
