// Textiles: curtains, blinds, cushions, blankets, towels.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

void curtain(Piece& p) {
  const int cloth = p.main_accent("linen"), metal = p.named("black_metal");
  const double r = std::min({0.012, p.d * 0.2, p.h * 0.05}), z = p.h - r;
  p.add(metal, rod({-p.w / 2, 0, z}, {p.w / 2, 0, z}, r, 12));
  for (const double x : {-p.w / 2 + 0.03, p.w / 2 - 0.03}) p.add(metal, box(sides(x - r / 2, x + r / 2, 0, p.d / 2, z - r, z), 0));
  // Two halves drawn to the sides, so that the window shows; one alone where it is narrow, and one of a pair hangs away from the other.
  // They fall clear of the sill.
  const double part = p.twin != 0 ? std::min(p.w * 0.5, 0.7)
                      : p.w > 0.9 ? p.w * 0.3
                                  : p.w - 0.02,
               back = p.d / 2 - std::min(0.034, p.d * 0.42);
  const auto half = [&](double x0) {
    p.add(cloth, waves(sides(x0, x0 + part, -p.d / 2, back, 0, p.h - 2 * r - 0.004), std::max(2, static_cast<int>(part / 0.09)),
                       std::min(0.006, p.d * 0.15)));
  };
  if (p.twin >= 0) half(-p.w / 2 + 0.01);
  if (p.twin < 0 || (p.twin == 0 && p.w > 0.9)) half(p.w / 2 - 0.01 - part);
}

void blind(Piece& p) {
  const int cloth = p.main("lacquer");
  p.add(cloth, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, p.h - std::min(0.05, p.h * 0.1), p.h), 0.004));
  const double pitch = 0.045, thick = std::min(0.003, p.d * 0.1);
  const int n = std::max(2, static_cast<int>((p.h - 0.06) / pitch));
  for (int i = 0; i <= n; ++i) {
    const double z = std::min(0.008, p.h * 0.02) + (p.h - 0.07) * i / n, t = i == 0 ? 0.01 : thick;
    p.add(cloth, box(sides(-p.w / 2 + 0.005, p.w / 2 - 0.005, -p.d * 0.42, p.d * 0.42, z - std::min(z, t / 2), z + t / 2), 0));
  }
}

// Lying, or upright against a back.
void cushion_piece(Piece& p) {
  const int cloth = p.main_accent("linen");
  if (p.h <= p.d * 1.2) return p.add(cloth, pillow(p.body(), 12));
  const Pose upright{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, p.h / 2}};
  p.add(cloth, pillow(sides(-p.w / 2, p.w / 2, -p.h / 2, p.h / 2, -p.d / 2, p.d / 2), 12), upright);
}

// A throw laid over a seat: a long strip with bands across its ends and a fringe at each, in a fold or two.
void throw_over(Piece& p) {
  const int cloth = p.main_accent("wool"), band = p.tinted("wool", {0.93, 0.90, 0.83});
  const double fringe = p.d * 0.08, y0 = -p.d / 2 + fringe, y1 = p.d / 2 - fringe, low = p.h * 0.55;
  p.add(cloth, rounded_box(sides(-p.w / 2, p.w / 2, y0, y1, 0, low), low * 0.4, 2));
  p.add(cloth, rounded_box(sides(-p.w / 2, p.w * 0.12, y0 + 0.01, y1 - 0.02, low * 0.6, p.h), low * 0.4, 2));
  for (const double s : {-1.0, 1.0}) {
    for (const double share : {0.30, 0.36})
      p.add(band, rounded_box(sides(-p.w / 2 - 0.001 + 0.002, p.w / 2 - 0.001, s * p.d * share - 0.012, s * p.d * share + 0.012, 0.001,
                                    low + 0.002),
                              low * 0.4, 2));
    const int threads = std::max(4, static_cast<int>(p.w / 0.02));
    for (int i = 0; i < threads; ++i) {
      const double x = -p.w / 2 + p.w * (i + 0.5) / threads;
      const double from = s < 0 ? -p.d / 2 : y1 - 0.004, to = s < 0 ? y0 + 0.004 : p.d / 2;
      p.add(cloth, box(sides(x - 0.004, x + 0.004, from, to, 0, std::min(0.008, low * 0.5)), 0));
    }
  }
}

void blanket(Piece& p) {
  if (p.h < 0.07 && p.d > p.w * 1.3) return throw_over(p);
  const int cloth = p.main_accent("wool"), n = p.h > 0.06 ? std::clamp(static_cast<int>(p.h / 0.03), 2, 6) : 1;
  for (int i = 0; i < n; ++i) {
    const double in = i == 0 ? 0 : 0.006;
    p.add(cloth, rounded_box(sides(-p.w / 2 + in, p.w / 2 - in, -p.d / 2, p.d / 2 - in, p.h * i / n, p.h * (i + 1) / n),
                             std::min(0.02, p.h / n * 0.5), 3));
  }
}

void towel(Piece& p) {
  if (p.mount() == Mount::kWall || p.h > p.d) {
    const double t = std::min(0.01, p.d * 0.2), z = p.h - t;
    p.add(p.named("chrome"), rod({-p.w / 2, 0, z - t}, {p.w / 2, 0, z - t}, t, 12));
    p.add(p.named("chrome"), box(sides(-0.01, 0.01, 0, p.d / 2, z - 2 * t, z), 0.002));
    p.add(p.main_accent("wool"),
          rounded_box(sides(-p.w / 2 + 0.02, p.w / 2 - 0.02, -p.d / 2, p.d * 0.2, 0, p.h), std::min(0.02, p.d * 0.3), 3));
    return;
  }
  blanket(p);
}

}  // namespace

void add_textiles(Families& to) {
  to["rug"] = rug;
  to["curtain"] = curtain;
  to["blind"] = blind;
  to["cushion"] = cushion_piece;
  to["blanket"] = blanket;
  to["towel"] = towel;
}

}  // namespace layoutbox::kit
