#include "layoutbox/export/plan_dimensions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "layoutbox/base/units.h"

namespace layoutbox {
namespace {

constexpr double kInner = 3.6, kOuter = 9, kTick = 0.9, kGap = 0.8;  // on paper: lines of pieces and of the whole, ticks, free of the wall
constexpr std::size_t kMostWalls = 8;                                // more of them, and a room is measured as a whole

// A line of lengths: its stops along `direction` from `origin`; the ink for each stop begins at `from`, off the line (both in the room).
struct Chain {
  PlanVector origin, direction, out;
  double off = 0;  // of the line, in the room's millimetres along `out`
  std::vector<std::pair<double, double>> stops;
};

class Dimensions {
 public:
  Dimensions(Canvas& page, const PlanScale& scale, const Layout& layout, const PlanRoom& room)
      : page_(page), scale_(scale), layout_(layout), room_(room) {}

  void draw() {
    if (room_.walls.empty()) return;
    const bool straight = std::all_of(room_.walls.begin(), room_.walls.end(),
                                      [](const PlanWall& wall) { return std::abs(wall.along.x * wall.along.y) < 1e-6; });
    if (straight) {
      for (const PlanVector& out : {PlanVector{0, -1}, {-1, 0}, {0, 1}, {1, 0}}) draw_side(out, true);
    } else if (room_.walls.size() > kMostWalls) {
      draw_side({0, -1}, false);
      draw_side({-1, 0}, false);
    } else {
      for (std::size_t i = 0; i < room_.walls.size(); ++i) draw_wall(i);
    }
  }

 private:
  double paper_mm(double mm) const { return mm / scale_.factor; }

  // The pieces of a wall from its start: ends, openings.
  std::vector<double> stops_of(std::size_t wall) const {
    std::vector<double> stops{0, room_.walls[wall].length};
    for (const Opening& opening : layout_.room.openings) {
      if (wall_of(opening, layout_) != static_cast<int>(wall)) continue;
      stops.push_back(opening.offset.value_or(0));
      stops.push_back(opening.offset.value_or(0) + opening.width);
    }
    std::sort(stops.begin(), stops.end());
    return stops;
  }

  // One side of a room whose walls run along the axes: all walls that look that way in one line, the whole length in a second one.
  void draw_side(PlanVector out, bool with_pieces) {
    const PlanVector along{std::abs(out.y), std::abs(out.x)};
    const auto across_of = [&](PlanVector p) { return p.x * out.x + p.y * out.y; };
    const auto along_of = [&](PlanVector p) { return p.x * along.x + p.y * along.y; };
    double edge = -1e9, least = 1e9, most = -1e9;
    for (const PlanVector& corner : {PlanVector{room_.x0, room_.y0}, {room_.x1, room_.y1}}) edge = std::max(edge, across_of(corner));
    for (const PlanWall& wall : room_.walls) {
      least = std::min(least, along_of(wall.start));
      most = std::max(most, along_of(wall.start));
    }
    Chain pieces{{0, 0}, along, out, edge + paper_mm(kInner), {}};
    for (std::size_t i = 0; with_pieces && i < room_.walls.size(); ++i) {
      const PlanWall& wall = room_.walls[i];
      if (wall.out.x * out.x + wall.out.y * out.y < 0.9) continue;
      for (const double s : stops_of(i)) {
        const PlanVector face = wall.at(s, wall.thickness);
        add_stop(pieces, along_of(face), is_open(face, out, edge - across_of(face)) ? across_of(face) : edge);
      }
    }
    std::sort(pieces.stops.begin(), pieces.stops.end());
    const bool has_pieces = pieces.stops.size() > 2;
    if (has_pieces) draw_chain(pieces, 2.0);
    // Right and back repeat left and front.
    if (out.x + out.y > 0) return;
    draw_chain({{0, 0}, along, out, edge + paper_mm(has_pieces ? kOuter : kInner), {{least, edge}, {most, edge}}}, 2.4);
  }

  // Two walls that meet have one stop there; the line to it begins at the nearer of the two.
  static void add_stop(Chain& chain, double s, double from) {
    for (auto& [at, begin] : chain.stops) {
      if (std::abs(at - s) > 1) continue;
      begin = std::max(begin, from);
      return;
    }
    chain.stops.emplace_back(s, from);
  }

  // Is there nothing of the room on the way from a wall's face outwards?
  bool is_open(PlanVector face, PlanVector out, double distance) const {
    for (int i = 1; i <= 24; ++i) {
      const PlanVector p = face + (distance * i / 24) * out;
      bool inside = false;
      for (const PlanWall& wall : room_.walls) {
        const PlanVector a = wall.start, b = wall.at(wall.length, 0);
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
      }
      if (inside) return false;
    }
    return true;
  }

  void draw_wall(std::size_t number) {
    const PlanWall& wall = room_.walls[number];
    double clear = wall.thickness;
    for (const Opening& opening : layout_.room.openings) {
      if (wall_of(opening, layout_) != static_cast<int>(number)) continue;
      for (const auto& leaf : door_sweeps(wall, opening)) {
        for (const PlanVector& p : leaf) {
          clear = std::max(clear, (p.x - wall.start.x) * wall.out.x + (p.y - wall.start.y) * wall.out.y);
        }
      }
    }
    const auto chain = [&](const std::vector<double>& stops, double off) {
      Chain line{wall.start, wall.along, wall.out, clear + paper_mm(off), {}};
      for (const double s : stops) line.stops.emplace_back(s, wall.thickness);
      return line;
    };
    const std::vector<double> stops = stops_of(number);
    const bool has_pieces = stops.size() > 2;
    if (has_pieces) draw_chain(chain(stops, kInner), 2.0);
    draw_chain(chain({0, wall.length}, has_pieces ? kOuter : kInner), 2.4);
  }

  void draw_chain(const Chain& chain, double size) {
    const auto paper = [&](double s, double t) {
      const PlanVector p = chain.origin + s * chain.direction + t * chain.out;
      return scale_.at(p.x, p.y);
    };
    const DrawStyle thin{"none", "#888", 0.12, {}}, bold{"none", "#555", 0.3, {}};
    const double t = chain.off, tick = paper_mm(kTick);
    page_.line(paper(chain.stops.front().first, t), paper(chain.stops.back().first, t), thin);
    for (const auto& [s, from] : chain.stops) {
      page_.line(paper(s, from + paper_mm(kGap)), paper(s, t + tick), thin);
      page_.line(paper(s - tick / 1.5, t - tick / 1.5), paper(s + tick / 1.5, t + tick / 1.5), bold);
    }
    // Text along the line, never upside down, on the side that is above it as one reads it.
    double degrees = -std::atan2(chain.direction.y, chain.direction.x) * 180 / kPi;
    if (degrees > 89.5) degrees -= 180;
    if (degrees < -90.5) degrees += 180;
    const double turn = radians_from_degrees(degrees);
    const PaperPoint up{std::sin(turn), -std::cos(turn)};
    const double reach = paper_mm(1);
    for (std::size_t i = 0; i + 1 < chain.stops.size(); ++i) {
      const double a = chain.stops[i].first, b = chain.stops[i + 1].first;
      if (b - a < 0.5) continue;
      const std::string text = fmt::format("{:.2f}", (b - a) / 1000);
      const double width = text_width(text, size) + 0.8;
      double middle = (a + b) / 2, lift = 0.6;
      if (width > (b - a) * scale_.factor) {  // beside the line at its ends, else above the figures of its neighbours
        if (i == 0) {
          middle = a - reach - paper_mm(width) / 2;
        } else if (i + 2 == chain.stops.size()) {
          middle = b + reach + paper_mm(width) / 2;
        } else {
          lift += size;
        }
      }
      const PaperPoint at = paper(middle, t);
      page_.text({at.x + lift * up.x, at.y + lift * up.y}, size, text, TextAnchor::kMiddle, degrees, "#444");
    }
  }

  Canvas& page_;
  const PlanScale& scale_;
  const Layout& layout_;
  const PlanRoom& room_;
};

}  // namespace

void draw_dimensions(Canvas& page, const PlanScale& scale, const Layout& layout, const PlanRoom& room) {
  Dimensions(page, scale, layout, room).draw();
}

}  // namespace layoutbox
