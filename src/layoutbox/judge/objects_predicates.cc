// Two objects.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "layoutbox/judge/predicates.h"
#include "layoutbox/judge/rays.h"
#include "layoutbox/judge/vocabulary.h"

namespace layoutbox::scoring {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();
constexpr double kMargin = 0.25;   // of a side, beyond which things are no longer at it
constexpr double kRests = 0.010;   // m
constexpr double kHangGap = 0.02;  // m

struct ObjectPair {
  const Block& target;
  const Block& reference;
  const MeasuredRoom& room;
};
using PairCheck = Scored (*)(const ObjectPair&);

const std::string& category(const Block& block) {
  static const std::string none;
  return block.body ? block.body->object->category : none;
}

Scored distance_in(const ObjectPair& p, double low, double high) {
  const double gap = gap_between(p.target, p.reference);
  return {band(gap, low, high), fmt::format("distance {:.2f} m (band {:g} to {:g} m)", gap, low, high), {}};
}

Scored at_side(const ObjectPair& p, Way way, std::string_view word) {
  double share =
      std::max(side_share(p.target, p.reference, way, true, kMargin, false), beside_share(p.target, p.reference, way, p.reference.frame));
  const checks::Body* host = p.reference.body ? p.room.view.find_body(p.reference.body->object->supported_by) : nullptr;
  if (host) share = std::max(share, beside_share(p.target, p.reference, way, host->own_frame));
  return {share, fmt::format("{:.0f} % of it {} the other", share * 100, word), {}};
}

Scored in_half(const ObjectPair& p, Way way) {
  const double share = half_share(p.target, p.reference, way, way != Way::kBottom);
  return {share, fmt::format("{:.0f} % of it in that half", share * 100), {}};
}

bool over(const Block& below, Vec2d point) { return checks::contains(below.shape.plan, point); }

// Stands on or in the reference, directly or on a pile of things that does.
bool rests_on(const Block& target, const Block& reference, const MeasuredRoom& room, int depth = 3) {
  if (target.low() >= reference.low() - kTiny && target.low() <= reference.high() + kRests) return true;
  if (depth == 0) return false;
  return std::any_of(room.blocks.begin(), room.blocks.end(), [&](const Block& other) {
    return &other != &target && &other != &reference && std::abs(target.low() - other.high()) <= kRests && over(other, target.center()) &&
           rests_on(other, reference, room, depth - 1);
  });
}

Scored on_top(const ObjectPair& p) {
  const double above = side_share(p.target, p.reference, Way::kTop, false, 1e-9, true), inside = inside_share(p.target, p.reference);
  const double gap = gap_between(p.target, p.reference);
  if (is_hanger_like(category(p.reference)) && gap <= kHangGap && p.target.low() > 0.05) {
    return {1.0, fmt::format("hangs on it, gap {:.0f} mm", gap * 1000), {}};
  }
  const bool rests = rests_on(p.target, p.reference, p.room);
  const double share = rests ? std::max(above, is_shelf_like(category(p.reference)) ? inside : 0.0) : 0.0;
  return {share,
          fmt::format("{:.0f} % over it, {:.0f} % inside it, underside {:.2f} m, top of the other {:.2f} m{}", above * 100, inside * 100,
                      p.target.low(), p.reference.high(), rests ? "" : ", does not rest on it"),
          {}};
}

Scored top_half(const ObjectPair& p) {
  const double share = rests_on(p.target, p.reference, p.room) ? side_share(p.target, p.reference, Way::kTop, false, 0, true) : 0.0;
  return {share, fmt::format("{:.0f} % of it over the upper half", share * 100), {}};
}

Scored at_sides(const ObjectPair& p, bool along_long) {
  const double width = p.reference.half[0], depth = p.reference.half[1];
  if (std::abs(width - depth) <= 1e-5 * std::max(width, depth)) return {0, "the other is square: no long side", {}};
  const bool sideways = (width < depth) == along_long;
  const double share = std::max(side_share(p.target, p.reference, sideways ? Way::kLeft : Way::kFront, false, 1e-9, false),
                                side_share(p.target, p.reference, sideways ? Way::kRight : Way::kBack, false, 1e-9, false));
  return {share, fmt::format("{:.0f} % of it at a {} side", share * 100, along_long ? "long" : "short"), {}};
}

Scored above_it(const ObjectPair& p) {
  double share = side_share(p.target, p.reference, Way::kTop, true, kMargin, true);
  if (p.target.low() >= p.reference.high() - kRests) share = std::max(share, cover(p.target, p.reference, 0.1));
  return {share,
          fmt::format("{:.0f} % over it, underside {:.2f} m, top of the other {:.2f} m", share * 100, p.target.low(), p.reference.high()),
          {}};
}

Scored under_it(const ObjectPair& p) {
  double share = std::max(side_share(p.target, p.reference, Way::kBottom, true, kMargin, true),
                          half_share(p.target, p.reference, Way::kBottom, false));
  if (p.target.middle() < p.reference.middle() && p.target.low() <= p.reference.low() + 0.05) {
    share = std::max(share, cover(p.target, p.reference, p.target.high() <= p.reference.low() + kRests ? 0.1 : 0.0));
  }
  return {share,
          fmt::format("{:.0f} % under it, {:.2f} to {:.2f} m high, the other from {:.2f} m", share * 100, p.target.low(), p.target.high(),
                      p.reference.low()),
          {}};
}

Scored middle_of(const ObjectPair& p) {
  const double off = checks::length(p.target.center() - p.reference.center());
  return {std::exp(-off * off / (2 * 0.25 * 0.25)), fmt::format("centres {:.2f} m apart in the plan", off), {}};
}

Scored foot_of(const ObjectPair& p) {
  const Scored side = at_side(p, Way::kFront, "in front of"), near = distance_in(p, 0, 0.5);
  return {std::min(side.score, near.score), side.text + "; " + near.text, {}};
}

Scored inside_it(const ObjectPair& p, bool wanted) {
  const double share = inside_share(p.target, p.reference);
  return {wanted ? share : 1 - share, fmt::format("{:.0f} % of it inside", share * 100), {}};
}

struct CheckRow {
  std::string_view name;
  PairCheck check;
  bool symmetric;
};

constexpr std::array kChecks{
    CheckRow{"next", [](const ObjectPair& p) { return distance_in(p, 0, 0.5); }, true},
    CheckRow{"near", [](const ObjectPair& p) { return distance_in(p, 0, 1.5); }, true},
    CheckRow{"across", [](const ObjectPair& p) { return distance_in(p, 1.5, 4); }, true},
    CheckRow{"far", [](const ObjectPair& p) { return distance_in(p, 4, kForever); }, true},
    CheckRow{"apart", [](const ObjectPair& p) { return distance_in(p, 0.5, kForever); }, true},
    CheckRow{"left", [](const ObjectPair& p) { return at_side(p, Way::kLeft, "left of"); }, false},
    CheckRow{"right", [](const ObjectPair& p) { return at_side(p, Way::kRight, "right of"); }, false},
    CheckRow{"behind", [](const ObjectPair& p) { return at_side(p, Way::kBack, "behind"); }, false},
    CheckRow{"front", [](const ObjectPair& p) { return at_side(p, Way::kFront, "in front of"); }, false},
    CheckRow{"foot", &foot_of, false},
    CheckRow{"left_half", [](const ObjectPair& p) { return in_half(p, Way::kLeft); }, false},
    CheckRow{"right_half", [](const ObjectPair& p) { return in_half(p, Way::kRight); }, false},
    CheckRow{"front_half", [](const ObjectPair& p) { return in_half(p, Way::kFront); }, false},
    CheckRow{"back_half", [](const ObjectPair& p) { return in_half(p, Way::kBack); }, false},
    CheckRow{"top_half", &top_half, false},
    CheckRow{"bottom_half", [](const ObjectPair& p) { return in_half(p, Way::kBottom); }, false},
    CheckRow{"long_side", [](const ObjectPair& p) { return at_sides(p, true); }, false},
    CheckRow{"short_side", [](const ObjectPair& p) { return at_sides(p, false); }, false},
    CheckRow{"inside", [](const ObjectPair& p) { return inside_it(p, true); }, false},
    CheckRow{"outside", [](const ObjectPair& p) { return inside_it(p, false); }, false},
    CheckRow{"on", &on_top, false},
    CheckRow{"face", [](const ObjectPair& p) { return faces(p.target, p.reference); }, false},
    CheckRow{"above", &above_it, false},
    CheckRow{"under", &under_it, false},
    CheckRow{"middle", &middle_of, false},
};

const CheckRow* row_of(std::string_view check) {
  const auto found = std::find_if(kChecks.begin(), kChecks.end(), [&](const CheckRow& row) { return row.name == check; });
  return found == kChecks.end() ? nullptr : &*found;
}

}  // namespace

MeasuredRoom::MeasuredRoom(const checks::RoomView& of_view) : view(of_view) {
  blocks.reserve(view.bodies.size());
  for (const checks::Body& body : view.bodies) blocks.push_back(block_of(body));
}

Scored score_objects(std::string_view check, const Block& target, const Block& reference, const MeasuredRoom& room) {
  const CheckRow* row = row_of(check);
  return row ? row->check({target, reference, room}) : Scored{0, fmt::format("there is no check \"{}\"", check), {}};
}

bool is_symmetric(std::string_view check) {
  const CheckRow* row = row_of(check);
  return row != nullptr && row->symmetric;
}

Scored score_ring(std::span<const Block* const> targets, const Block& reference) {
  const std::size_t count = targets.size();
  std::vector<Point3> arms;
  std::vector<double> lengths;
  for (const Block* target : targets) {
    const Vec2d off = target->center() - reference.center();
    const double up = target->middle() - reference.middle(), length = std::max(std::sqrt(dot(off, off) + up * up), 1e-9);
    arms.push_back({off.x / length, off.y / length, up / length});
    lengths.push_back(length);
  }
  std::vector<double> sorted = lengths;
  std::sort(sorted.begin(), sorted.end());
  const double typical = std::max((sorted[(count - 1) / 2] + sorted[count / 2]) / 2, 1e-9);
  const double ideal = 2 * kPi / static_cast<double>(count);
  double total = 0;
  for (std::size_t i = 0; i < count; ++i) {
    double ahead = kForever, behind = -kForever;
    for (std::size_t j = 0; j < count; ++j) {
      if (i == j) continue;
      const double angle = std::acos(std::clamp(arms[i].x * arms[j].x + arms[i].y * arms[j].y + arms[i].z * arms[j].z, -1.0, 1.0));
      const bool is_ahead = arms[i].x * arms[j].y - arms[i].y * arms[j].x >= 0;
      if (is_ahead && angle > 0) ahead = std::min(ahead, angle);
      if (!is_ahead) behind = std::max(behind, -angle);
    }
    const double next = std::isfinite(ahead) ? ahead : std::isfinite(behind) ? behind : 0;
    const double off_distance = std::min(1.0, std::abs(lengths[i] - typical) / typical);
    const double off_angle = std::min(1.0, std::abs(next - ideal) / ideal);
    total += (0.5 * (1 - off_distance) * (1 - off_distance) + 0.5 * (1 - off_angle) * (1 - off_angle)) / static_cast<double>(count);
  }
  return {total, fmt::format("evenness {:.2f}", total), {}};
}

}  // namespace layoutbox::scoring
