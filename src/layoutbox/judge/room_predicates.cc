// An object and the room.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "layoutbox/judge/predicates.h"
#include "layoutbox/judge/rays.h"
#include "layoutbox/judge/vocabulary.h"

namespace layoutbox::scoring {
namespace {

using checks::Face;

double gap_to(const Block& block, const Face& face) { return checks::gap(block.shape, face.shape); }

// Share of the body straight in front of the face, on the room's side.
double share_before(const Block& block, const Face& face) {
  std::size_t held = 0;
  for (const Point3& point : block.points) {
    const Vec2d off = Vec2d{point.x, point.y} - face.start;
    const double along = dot(off, face.along);
    held += along >= -kTiny && along <= face.length + kTiny && dot(off, face.inward) >= -kTiny &&
            point.z >= face.shape.heights.lo - kTiny && point.z <= face.shape.heights.hi + kTiny;
  }
  return static_cast<double>(held) / static_cast<double>(block.points.size());
}

// Overlap along the wall over the shorter of the two.
double share_along(const Block& block, const Face& face) {
  const checks::Interval own = checks::extent(block.shape, face.along);
  const double start = dot(face.start, face.along);
  const double overlap = std::min(own.hi - start, face.length) - std::max(own.lo - start, 0.0);
  return std::max(0.0, overlap / std::min(own.length(), face.length));
}

Scored near_face(const Block& block, const Face& face, double low, double high) {
  const double gap = gap_to(block, face);
  return {band(gap, low, high), fmt::format("distance {:.2f} m (band {:g} to {:g} m)", gap, low, high), {}};
}

Scored attached(const Block& block, const Face& face, double high, double spread) {
  const double gap = gap_to(block, face), share = share_before(block, face);
  return {share * band(gap, 0, high, spread),
          fmt::format("gap {:.3f} m (at most {:g} m), {:.0f} % in front of the wall", gap, high, share * 100),
          {}};
}

Scored before(const Block& block, const Face& face, double high, double spread, bool below) {
  const double gap = checks::distance(block.shape.plan, face.shape.plan), share = share_along(block, face);
  const bool low = !below || (block.low() < face.shape.heights.lo && block.middle() < face.shape.heights.mid());
  return {low ? std::min(share, 1.0) * band(gap, 0, high, spread) : 0,
          fmt::format("gap {:.2f} m (at most {:g} m), {:.0f} % in line with it{}", gap, high, share * 100, low ? "" : ", too high"),
          {}};
}

Scored looks_at_face(const Block& block, const Face& face) { return faces(block, block_of(checks::space_before(face, 0.01))); }

using FaceCheck = Scored (*)(const Block&, const Face&);
struct FaceRow {
  std::string_view name;
  FaceCheck check;
};
constexpr double kNoEnd = std::numeric_limits<double>::infinity();
constexpr std::array kFaceChecks{
    FaceRow{"near", [](const Block& b, const Face& f) { return near_face(b, f, 0, 1.5); }},
    FaceRow{"next", [](const Block& b, const Face& f) { return near_face(b, f, 0, 0.5); }},
    FaceRow{"across", [](const Block& b, const Face& f) { return near_face(b, f, 1.5, 4); }},
    FaceRow{"far", [](const Block& b, const Face& f) { return near_face(b, f, 4, kNoEnd); }},
    FaceRow{"front", [](const Block& b, const Face& f) { return before(b, f, 1.5, 0.25, false); }},
    FaceRow{"face", &looks_at_face},
    FaceRow{"under", [](const Block& b, const Face& f) { return before(b, f, 0.5, 0.25, true); }},
    FaceRow{"against", [](const Block& b, const Face& f) { return attached(b, f, 0.3, 0.1); }},
    FaceRow{"on", [](const Block& b, const Face& f) { return attached(b, f, 0.01, 0.01); }},
    FaceRow{"before", [](const Block& b, const Face& f) { return before(b, f, 0.3, 0.1, false); }},
};

double floor_share(const Block& block, const MeasuredRoom& room) {
  if (room.view.floor.empty()) return 0;
  std::size_t inside = 0;
  for (const Point3& point : block.points) inside += checks::contains(room.view.floor, {point.x, point.y});
  return static_cast<double>(inside) / static_cast<double>(block.points.size());
}

Scored in_middle(const Block& block, const MeasuredRoom& room) {
  const Vec2d middle{room.view.floor_x.mid(), room.view.floor_y.mid()};
  const double off = checks::length(block.center() - middle), extent = 2 * std::max(block.half[0], block.half[1]);
  const double spread = 0.5 * extent + 1 - extent / ((room.view.floor_x.length() + room.view.floor_y.length()) / 2);
  const double score = spread > 0 ? std::exp(-off * off / (2 * spread * spread)) : off < kTiny;
  return {score, fmt::format("{:.2f} m from the middle of the room (limit {:.2f} m)", off, std::max(spread, 0.0) * 1.177), {}};
}

// Within 0.8 m of two walls that stand square to each other as seen from the object.
Scored in_corner(const Block& block, const MeasuredRoom& room) {
  if (floor_share(block, room) < 0.5) return {0, "not in the room", {}};
  struct Seen {
    Vec2d way;
    double score, gap;
    const Face* wall;
  };
  std::vector<Seen> seen;
  for (const Face& wall : room.view.walls) {
    Vec2d sum;
    for (const Point3& point : block.points) {
      const Vec2d at{point.x, point.y};
      sum = sum + wall.start + wall.along * std::clamp(dot(at - wall.start, wall.along), 0.0, wall.length) - at;
    }
    const Vec2d way = sum * (1.0 / static_cast<double>(block.points.size()));
    const double gap = gap_to(block, wall);
    seen.push_back({way * (1 / std::max(checks::length(way), 1e-9)), band(gap, 0, 0.8), gap, &wall});
  }
  Scored best{0, "no two walls square to each other", {}};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (std::size_t j = i + 1; j < seen.size(); ++j) {
      const Seen &a = seen[i], &b = seen[j];
      if (std::abs(dot(a.way, b.way)) >= 0.15 || a.score * b.score <= best.score) continue;
      best = {
          a.score * b.score, fmt::format("{:.2f} m from {}, {:.2f} m from {} (at most 0.8 m)", a.gap, a.wall->id, b.gap, b.wall->id), {}};
    }
  }
  return best;
}

// The word's check in a list, or in those that hold for every face.
std::string_view face_check(std::string_view word, std::string_view list) {
  const std::string_view own = check_for(word, list);
  return own.empty() ? check_for(word, "faces") : own;
}

std::optional<Scored> score_faces(std::string_view word, std::string_view element, const Block& target, const MeasuredRoom& room) {
  const bool wall = element == "wall";
  const std::string_view name = face_check(word, wall ? "wall" : "opening");
  const auto row = std::find_if(kFaceChecks.begin(), kFaceChecks.end(), [&](const FaceRow& r) { return r.name == name; });
  if (row == kFaceChecks.end()) return std::nullopt;
  Scored best{0, fmt::format("the room has no {}", element), std::string(element)};
  bool any = false;
  for (const Face& face : wall ? room.view.walls : room.view.openings) {
    if (!wall && face.is_window() != (element == "window")) continue;
    Scored scored = row->check(target, face);
    if (any && scored.score <= best.score) continue;
    best = std::move(scored);
    best.place = face.id;
    any = true;
  }
  return best;
}

}  // namespace

std::optional<Scored> score_room(std::string_view word, std::string_view element, const Block& target, const MeasuredRoom& room) {
  if (element == "wall" || element == "door" || element == "window") return score_faces(word, element, target, room);
  if (element == "ceiling") {
    if (check_for(word, "ceiling").empty()) return std::nullopt;
    const double gap = std::abs(room.view.height - target.high());
    return Scored{band(gap, 0, 0.01, 0.03), fmt::format("top {:.3f} m from the ceiling", gap), "ceiling"};
  }
  if (element == "floor") {
    if (check_for(word, "floor").empty()) return std::nullopt;
    return Scored{std::abs(target.low()) <= 0.01 + kTiny ? 1.0 : 0.0, fmt::format("underside {:.3f} m above the floor", target.low()),
                  "floor"};
  }
  const std::string_view check = check_for(word, "room");
  if (check.empty()) return std::nullopt;
  Scored scored;
  if (check == "corner") {
    scored = in_corner(target, room);
  } else if (check == "middle") {
    scored = in_middle(target, room);
  } else {
    const double share = floor_share(target, room);
    scored = {share, fmt::format("{:.0f} % over the floor", share * 100), {}};
  }
  scored.place = std::string(element);
  return scored;
}

}  // namespace layoutbox::scoring
