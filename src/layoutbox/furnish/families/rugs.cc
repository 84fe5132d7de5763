// Rugs: woven in patterns, knotted, of fur, of puzzle tiles.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// Layers of a woven pattern, each a hair above the last, up to the rug's height.
struct Weave {
  Piece& p;
  double low, step;
  int next = 0;
  void add(int surface, const std::vector<Vec2>& outline) {
    ++next;
    p.add(surface, prism(outline, low - 0.0005, low + step * next));
  }
};

std::vector<Vec2> diamond(double x, double y, double rx, double ry) { return {{x + rx, y}, {x, y + ry}, {x - rx, y}, {x, y - ry}}; }
std::vector<Vec2> rectangle(double x, double y) { return {{-x, -y}, {x, -y}, {x, y}, {-x, y}}; }

// A field with a medallion and corners, within a wide border of small figures, fringes at the ends.
void persian_rug(Piece& p) {
  const bool of_room = p.colors_said() && !p.color_asked();
  const Color field = of_room ? p.accent() : Color{0.50, 0.18, 0.16}, pale = {0.86, 0.78, 0.62};
  const Color dark = of_room ? mixed(p.second_accent(), {0.25, 0.22, 0.20}, 0.3) : Color{0.16, 0.18, 0.28};
  const int red = p.color_asked() ? p.main("wool") : p.tinted("wool", field), navy = p.tinted("wool", dark), cream = p.tinted("wool", pale);
  const bool along = p.w >= p.d;
  const double fringe = 0.04, x = p.w / 2 - (along ? fringe : 0), y = p.d / 2 - (along ? 0 : fringe), in = std::min(x, y);
  const double ground = p.h * 0.7;
  p.add(red, box(sides(-x, x, -y, y, 0, ground), 0.002));
  p.add(cream, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, p.h * 0.2), 0));
  Weave weave{p, ground, (p.h - ground) / 7};
  const double border = in * 0.3;
  weave.add(cream, rectangle(x - in * 0.06, y - in * 0.06));
  weave.add(navy, rectangle(x - in * 0.09, y - in * 0.09));
  weave.add(cream, rectangle(x - border, y - border));
  weave.add(red, rectangle(x - border - in * 0.03, y - border - in * 0.03));
  const double fx = x - border - in * 0.03, fy = y - border - in * 0.03;
  weave.next = 4;
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      weave.next = 4;
      weave.add(navy, sx * sy > 0 ? std::vector<Vec2>{{sx * fx, sy * fy}, {sx * fx * 0.45, sy * fy}, {sx * fx, sy * fy * 0.3}}
                                  : std::vector<Vec2>{{sx * fx, sy * fy}, {sx * fx, sy * fy * 0.3}, {sx * fx * 0.45, sy * fy}});
    }
  }
  weave.next = 4;
  weave.add(navy, diamond(0, 0, fx * 0.6, fy * 0.75));
  weave.add(cream, diamond(0, 0, fx * 0.45, fy * 0.56));
  weave.add(red, diamond(0, 0, fx * 0.3, fy * 0.38));
  // Small figures along the border.
  const double mid = in * 0.09 + (border - in * 0.09) / 2, r = (border - in * 0.09) * 0.32;
  const auto figures = [&](double half, bool in_x, double at) {
    const int n = std::max(2, static_cast<int>(2 * half / (r * 3)));
    for (int i = 0; i < n; ++i) {
      const double u = -half + 2 * half * (i + 0.5) / n;
      weave.next = 2;
      weave.add(i % 2 == 0 ? cream : red, in_x ? diamond(u, at, r, r) : diamond(at, u, r, r));
    }
  };
  for (const double s : {-1.0, 1.0}) {
    figures(x - border * 0.4, true, s * (y - mid));
    figures(y - border * 1.2, false, s * (x - mid));
  }
}

// A fell: of uneven outline where it is a whole beast's, else with a ragged edge.
void fur_rug(Piece& p) {
  const bool hide = p.says("bearskin") || p.says("cowhide") || p.says("hide") || p.says("bear");
  const int fur = p.main(p.says("bearskin") || p.says("bear") ? "walnut" : "fur");
  std::vector<Vec2> outline;
  const int n = 48;
  for (int i = 0; i < n; ++i) {
    const double a = 2 * kPi * i / n, c = std::cos(a), s = std::sin(a);
    const double square = 1 / std::pow(std::pow(std::abs(c), 6) + std::pow(std::abs(s), 6), 1.0 / 6);
    const double legs = 0.72 + 0.38 * std::pow(std::abs(std::sin(2 * a)), 1.5) + 0.2 * std::pow(std::abs(c) > 0.9 ? std::abs(c) : 0, 4);
    const double k = hide ? legs : square * (i % 2 == 0 ? 1.0 : 0.965);
    outline.push_back({k * c, k * s});
  }
  p.add(fur, prism(outline, 0, p.h * 0.6));
  for (Vec2& v : outline) v = {v.x * 0.93, v.y * 0.93};
  p.add(fur, prism(outline, p.h * 0.6, p.h));
  p.fit();
}

// Tiles in four bright colours.
void puzzle_mat(Piece& p) {
  static constexpr Color kTiles[] = {{0.85, 0.27, 0.24}, {0.22, 0.47, 0.75}, {0.95, 0.78, 0.25}, {0.35, 0.65, 0.36}};
  const int nx = std::max(2, static_cast<int>(std::lround(p.w / 0.35))), ny = std::max(2, static_cast<int>(std::lround(p.d / 0.35)));
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j)
      p.add(p.tinted("plastic", kTiles[(i + 2 * j) % 4]), box(sides(-p.w / 2 + p.w * i / nx, -p.w / 2 + p.w * (i + 1) / nx,
                                                                    -p.d / 2 + p.d * j / ny, -p.d / 2 + p.d * (j + 1) / ny, 0, p.h),
                                                              0.002));
  }
}

// Two rings on a round or an oval.
void round_rug(Piece& p, int base, int stripe) {
  const double low = p.h * 0.8;
  slab(p, base, sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, low), "round", 0.003);
  const double r = p.w / 2, k = p.d / p.w;
  for (const auto& [outer, inner] : {std::pair{0.94, 0.88}, {0.55, 0.50}}) {
    p.add(stripe,
          lathe({{r * inner, low - 0.001}, {r * outer, low - 0.001}, {r * outer, p.h}, {r * inner, p.h}, {r * inner, low - 0.001}}, 40),
          scaled(1, k, 1));
  }
}

bool is_long_haired(const Piece& p) {
  return p.says("fluffy") || p.says("shaggy") || p.says("shag") || p.says("sheepskin") || p.says("fur");
}

// What is woven into a rug from `low` up, its longer side along u.
class RugPattern {
 public:
  RugPattern(Piece& p, int stripe, double low)
      : p_(p), stripe_(stripe), low_(low), along_(p.w >= p.d), a_((along_ ? p.w : p.d) / 2), b_((along_ ? p.d : p.w) / 2) {}

  void field(bool checks) {
    const int nu = std::clamp(static_cast<int>(std::lround(2 * a_ / 0.42)), 2, 12),
              nv = std::clamp(static_cast<int>(std::lround(2 * b_ / 0.42)), 2, 12);
    const double in = 0.06, su = 2 * (a_ - in) / nu, sv = 2 * (b_ - in) / nv;
    for (int i = 0; i < nu; ++i) {
      for (int j = 0; j < nv; ++j) {
        const double u = -a_ + in + su * (i + 0.5), v = -b_ + in + sv * (j + 0.5);
        if (!checks) {
          diamond(u, v, su * 0.36, sv * 0.36);
        } else if ((i + j) % 2 == 0) {
          band(stripe_, u - su * 0.5, u + su * 0.5, v - sv * 0.5, v + sv * 0.5);
        }
      }
    }
  }

  void border() {
    const double in = std::min(0.08, b_ * 0.2), t = std::min(0.05, b_ * 0.12);
    band(stripe_, -a_ + in, a_ - in, -b_ + in, -b_ + in + t);
    band(stripe_, -a_ + in, a_ - in, b_ - in - t, b_ - in);
    band(stripe_, -a_ + in, -a_ + in + t, -b_ + in + t, b_ - in - t);
    band(stripe_, a_ - in - t, a_ - in, -b_ + in + t, b_ - in - t);
  }

  // Bands both ways, each pair of them lying over the other.
  void plaid(int second) {
    for (const double v : {-0.6, 0.0, 0.6}) band(stripe_, -a_ + 0.003, a_ - 0.003, (v - 0.1) * b_, (v + 0.1) * b_);
    for (double u = -a_ + 0.2; u < a_ - 0.1; u += 0.45) band(second, u, u + 0.11, -b_ + 0.003, b_ - 0.003);
  }

  void bands(int second) {
    for (const double v : {-0.76, 0.76}) band(stripe_, -a_ + 0.003, a_ - 0.003, v * b_ - b_ * 0.045, v * b_ + b_ * 0.045);
    band(second, -a_ + 0.003, a_ - 0.003, -b_ * 0.03, b_ * 0.03);
  }

 private:
  void band(int surface, double u0, double u1, double v0, double v1) {
    p_.add(surface, along_ ? box(sides(u0, u1, v0, v1, low_ - 0.001, p_.h), 0.001) : box(sides(v0, v1, u0, u1, low_ - 0.001, p_.h), 0.001));
  }

  void diamond(double u, double v, double hu, double hv) {
    const std::vector<Vec2> outline = along_ ? std::vector<Vec2>{{u + hu, v}, {u, v + hv}, {u - hu, v}, {u, v - hv}}
                                             : std::vector<Vec2>{{v + hv, u}, {v, u + hu}, {v - hv, u}, {v, u - hu}};
    p_.add(stripe_, prism(outline, low_ - 0.001, p_.h));
  }

  Piece& p_;
  int stripe_;
  double low_;
  bool along_;
  double a_, b_;
};

// The pattern that is said of a rug, else that of its style or of chance.
std::string pattern_of(Piece& p) {
  for (const auto& [word, pattern] : {std::pair{"geometric", "diamonds"},
                                      {"diamond", "diamonds"},
                                      {"striped", "bands"},
                                      {"stripes", "bands"},
                                      {"plaid", "plaid"},
                                      {"tartan", "plaid"},
                                      {"checked", "checks"},
                                      {"checkered", "checks"},
                                      {"checkerboard", "checks"},
                                      {"moroccan", "diamonds"},
                                      {"bordered", "border"}}) {
    if (p.says(word)) return pattern;
  }
  constexpr const char* kPatterns[] = {"bands", "border", "diamonds", "checks"};
  const std::string of_style = p.rug_pattern();
  const int by_chance = std::min(p.w, p.d) > 0.9 ? p.pick(4) : p.pick(2);
  return p.word("pattern", of_style.empty() || of_style == "persian" ? kPatterns[by_chance] : of_style);
}

void weave(Piece& p, int stripe, const Color& accent) {
  const std::string pattern = pattern_of(p);
  RugPattern woven(p, stripe, p.h * 0.8);
  if (pattern == "diamonds" || pattern == "checks") return woven.field(pattern == "checks");
  if (pattern == "border") return woven.border();
  if (pattern == "plaid") return woven.plaid(p.tinted("wool", mixed(p.second_accent(), {0.2, 0.18, 0.16}, 0.4)));
  woven.bands(p.tinted("wool", mixed(accent, {0.45, 0.40, 0.34}, 0.35)));
}

}  // namespace

void rug(Piece& p) {
  const std::string kind = p.word("kind", "");
  const bool long_haired = is_long_haired(p);
  if (kind == "puzzle") return puzzle_mat(p);
  const bool round = p.says("round") || p.says("circular") || p.says("circle") || p.word("top", "rect") == "round";
  const bool oval = p.says("oval") || p.word("top", "rect") == "oval";
  const bool of_style = kind.empty() && p.rug_pattern() == "persian" && !p.color_asked() && std::min(p.w, p.d) > 0.9;
  if ((kind == "pattern" || of_style) && !round && !oval && !long_haired) return persian_rug(p);
  if ((kind == "hide" || long_haired) && !round && !oval) return fur_rug(p);
  const int base = p.colors_said() ? p.main_accent("wool") : p.main("wool");
  if (kind == "plain" || p.says("plain")) return p.add(base, box(p.body(), std::min(0.006, p.h * 0.4)));
  const Color accent = p.color_asked() || p.colors_said() ? p.second_accent() : p.accent();
  const int stripe = p.tinted("wool", accent);
  const double low = p.h * 0.8;
  if (round || oval) return round_rug(p, base, stripe);
  p.add(base, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, low), 0.003));
  weave(p, stripe, accent);
}

}  // namespace layoutbox::kit
