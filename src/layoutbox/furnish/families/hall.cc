// Hallway things, screens, and parts of the building itself.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

void umbrella_stand(Piece& p) {
  const int metal = p.main("black_metal"), handle_surface = p.named("walnut");
  const double r = std::min(p.w, p.d) / 2, tall = p.open_above() != nullptr ? p.h : p.h * 0.62;
  vessel(p, metal, {{r * 0.92, 0}, {r, tall}}, 0.006, 0.02, 26);
  if (p.open_above() != nullptr && (!p.may_show_contents() || p.open_above()->held)) return;
  static constexpr Color kCloth[] = {{0.20, 0.28, 0.42}, {0.62, 0.22, 0.22}, {0.18, 0.19, 0.2}};
  for (int i = 0; i < 3; ++i) {
    const double a = 2.1 * i + 0.4, out = r * 0.45;
    const Vec low{std::cos(a) * out * 0.5, std::sin(a) * out * 0.5, 0.06}, high{std::cos(a) * out, std::sin(a) * out, p.h * 0.86};
    p.add(p.tinted("cotton", kCloth[i]), cone({0, 0, 0}, r * 0.08, r * 0.2, length(high - low), 10), aimed(low, high - low));
    p.add(handle_surface,
          tube(curve({high, high + Vec{0, 0, p.h * 0.1}, high + Vec{r * 0.18, 0, p.h * 0.135}, high + Vec{r * 0.3, 0, p.h * 0.08}}, 4),
               r * 0.06, 6));
  }
  if (p.spaces.empty()) p.fit();
}

void coat_rack(Piece& p) {
  const int wood = p.main("walnut");
  if (p.mount() == Mount::kWall) {
    p.add(wood, box(sides(-p.w / 2, p.w / 2, p.d / 2 - std::min(0.025, p.d * 0.4), p.d / 2, p.h * 0.3, p.h), 0.005));
    const int n = std::max(2, static_cast<int>(p.w / 0.16));
    for (int i = 0; i < n; ++i) {
      const double x = -p.w / 2 + p.w * (i + 0.5) / n;
      p.add(p.named("brass"),
            tube(curve({{x, p.d / 2 - 0.02, p.h * 0.6}, {x, -p.d * 0.3, p.h * 0.1}, {x, -p.d / 2 + 0.008, p.h * 0.4}}, 4), 0.007, 7));
    }
    p.fit();
    return;
  }
  const double r = std::min(p.w, p.d) / 2;
  p.add(wood, lathe({{0, 0.06}, {0.03, 0.06}, {0.022, p.h * 0.3}, {0.02, p.h * 0.9}, {0.03, p.h * 0.97}, {0, p.h}}, 14));
  for (int i = 0; i < 4; ++i) {
    const double a = kPi / 2 * i + kPi / 4, c = std::cos(a), s = std::sin(a);
    p.add(wood, tube(curve({{c * r, s * r, 0.015}, {c * r * 0.5, s * r * 0.5, 0.12}, {0, 0, 0.16}}, 4), 0.016, 8));
    p.add(wood,
          tube(curve({{0, 0, p.h * 0.86}, {c * r * 0.6, s * r * 0.6, p.h * 0.86}, {c * r * 0.8, s * r * 0.8, p.h * 0.95}}, 4), 0.011, 8));
    p.add(wood,
          tube(curve({{0, 0, p.h * 0.74}, {-s * r * 0.5, c * r * 0.5, p.h * 0.76}, {-s * r * 0.6, c * r * 0.6, p.h * 0.8}}, 4), 0.009, 8));
  }
  // One coat, so that one sees what it is for.
  const int coat = p.tinted("wool", p.accent());
  p.add(coat, lathe({{0, 0}, {0.11, 0}, {0.12, 0.02}, {0.1, 0.5}, {0.06, 0.62}, {0, 0.66}}, 14, 0.6),
        moved(r * 0.5, -r * 0.5, p.h * 0.86 - 0.62) * turned_z(-45));
  p.fit();
}

void hanger(Piece& p) {
  const double t = std::min(0.006, p.d / 2.1);
  const int wood = p.main("oak");
  p.add(wood,
        tube(curve({{-p.w / 2 + t, 0, t}, {-p.w * 0.2, 0, p.h * 0.38}, {0, 0, p.h * 0.52}, {p.w * 0.2, 0, p.h * 0.38}, {p.w / 2 - t, 0, t}},
                   4),
             t, 8));
  p.add(wood, rod({-p.w / 2 + t, 0, t}, {p.w / 2 - t, 0, t}, t * 0.7, 8));
  p.add(p.named("chrome"),
        tube(curve({{0, 0, p.h * 0.5}, {0, 0, p.h * 0.72}, {p.h * 0.12, 0, p.h * 0.86}, {0, 0, p.h - t}, {-p.h * 0.1, 0, p.h * 0.88}}, 4),
             t * 0.5, 6));
  p.fit();
}

void shoe_rack(Piece& p) {
  family_or_generic("rack")(p);
  if (!p.may_show_contents()) return;
  static constexpr Color kShoes[] = {{0.30, 0.20, 0.15}, {0.86, 0.86, 0.84}, {0.20, 0.28, 0.42}, {0.62, 0.24, 0.2}};
  int n = 0;
  for (const FreeSpace& s : p.spaces) {
    if (!s.carries || s.held || s.box.size().z < 0.12 || s.box.max.z > p.h - 0.005) continue;
    for (double x = s.box.min.x + 0.05; x + 0.22 < s.box.max.x; x += 0.27, ++n) {
      const int leather = p.tinted("leather", kShoes[n % 4]);
      for (const double dx : {0.0, 0.11}) {
        const double y0 = s.box.min.y + 0.03, y1 = std::min(s.box.max.y - 0.005, y0 + 0.27);
        p.add(leather, rounded_box(sides(x + dx, x + dx + 0.085, y0, y1, s.box.min.z, s.box.min.z + 0.05), 0.02, 2));
        p.add(leather, rounded_box(sides(x + dx + 0.01, x + dx + 0.075, y0 + (y1 - y0) * 0.55, y1, s.box.min.z + 0.02, s.box.min.z + 0.095),
                                   0.025, 2));
      }
    }
  }
}

// Panels at three sides round a desk top.
void cubicle(Piece& p) {
  const int cloth = p.main_accent("linen"), top = p.named("lacquer"), metal = p.named("steel");
  double t = side_room(p, 0.05), level = 0.75, under = 0.7;
  for (const FreeSpace& s : p.spaces) (s.carries ? level : under) = s.carries ? s.box.min.z : s.box.max.z;
  for (const double s : {-1.0, 1.0})
    p.add(cloth, box(sides(s > 0 ? p.w / 2 - t : -p.w / 2, s > 0 ? p.w / 2 : -p.w / 2 + t, -p.d / 2, p.d / 2, 0.05, p.h - 0.02), 0.004));
  p.add(cloth, box(sides(-p.w / 2 + t, p.w / 2 - t, p.d / 2 - t, p.d / 2, 0.05, p.h - 0.02), 0.004));
  for (const double s : {-1.0, 1.0}) {
    for (const auto& [z0, z1] : {std::pair{0.0, 0.05}, {p.h - 0.02, p.h}})
      p.add(metal, box(sides(s > 0 ? p.w / 2 - t : -p.w / 2, s > 0 ? p.w / 2 : -p.w / 2 + t, -p.d / 2, p.d / 2, z0, z1), 0.002));
  }
  p.add(top, box(sides(-p.w / 2 + t, p.w / 2 - t, -p.d / 2 + p.d * 0.4, p.d / 2 - t, level - std::min(0.03, level - under), level), 0.004));
}

void screen_divider(Piece& p) {
  if (!p.spaces.empty()) return cubicle(p);
  const int frame = p.frame("walnut"), paper = p.main("paper");
  const int n = std::max(2, p.count("panels", static_cast<int>(std::lround(p.w / 0.5))));
  const double each = p.w / n, t = std::min(0.022, p.d * 0.3);
  for (int i = 0; i < n; ++i) {
    const double x0 = -p.w / 2 + each * i, y0 = (i % 2 == 0 ? -1 : 1) * (p.d - t) / 2, y1 = -y0;
    const Vec a{x0 + 0.004, y0, 0}, b{x0 + each - 0.004, y1, 0};
    const double len = length(b - a);
    const Pose pose{unit(b - a), {-unit(b - a).y, unit(b - a).x, 0}, {0, 0, 1}, a};
    const double bar = std::min(0.03, len * 0.1);
    p.add(frame, box(sides(0, bar, -t / 2, t / 2, 0, p.h), 0.003), pose);
    p.add(frame, box(sides(len - bar, len, -t / 2, t / 2, 0, p.h), 0.003), pose);
    for (const double z : {0.06, p.h * 0.5, p.h - bar}) p.add(frame, box(sides(bar, len - bar, -t / 2, t / 2, z, z + bar), 0.003), pose);
    p.add(paper, box(sides(bar, len - bar, -t * 0.2, t * 0.2, 0.06 + bar, p.h - bar), 0), pose);
  }
  p.fit();
}

void pillar(Piece& p) {
  const int stone = p.main("plaster");
  const double r = p.w / 2, cap = std::min(0.12, p.h * 0.06);
  if (p.word("top", "rect") == "round" || p.says("round") || p.says("column")) {
    p.add(stone, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, cap), 0.008));
    p.add(stone,
          lathe({{0, cap}, {r * 0.92, cap}, {r * 0.86, cap * 1.6}, {r * 0.8, p.h - cap * 1.8}, {r * 0.92, p.h - cap}, {0, p.h - cap}}, 32),
          scaled(1, p.d / p.w, 1));
    p.add(stone, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, p.h - cap, p.h), 0.008));
    return;
  }
  p.add(stone, box(p.body(), 0.008));
}

void stairs(Piece& p) {
  const int step = p.main("oak"), side = p.frame("oak");
  const int n = std::max(2, static_cast<int>(std::lround(p.h / 0.18)));
  for (int i = 0; i < n; ++i) {
    const double y0 = -p.d / 2 + p.d * i / n, z = p.h * (i + 1) / n;
    p.add(step, box(sides(-p.w / 2, p.w / 2, y0, p.d / 2 - p.d * (n - 1 - i) / n + (i + 1 < n ? 0.02 : 0), z - 0.04, z), 0.006));
    p.add(side, box(sides(-p.w / 2 + 0.03, p.w / 2 - 0.03, y0 + 0.02, p.d / 2, z - p.h / n, z - 0.04), 0));
  }
}

// A leaf or a sash that is an object of its own.
void door(Piece& p) {
  const int leaf_surface = p.main("oak");
  const double t = std::min(0.045, p.d * 0.7), out = (p.d - t) / 2;
  p.add(leaf_surface, box(sides(-p.w / 2, p.w / 2, -t / 2, t / 2, 0, p.h), 0.004));
  for (const double s : {-1.0, 1.0}) {
    for (const auto& [z0, z1] : {std::pair{0.1, 0.42}, {0.5, 0.94}})
      p.add(leaf_surface, box(sides(-p.w * 0.34, p.w * 0.34, s > 0 ? t / 2 - 0.002 : -t / 2 - std::min(0.006, out),
                                    s > 0 ? t / 2 + std::min(0.006, out) : -t / 2 + 0.002, p.h * z0, p.h * z1),
                              0.003));
    p.add(p.named("steel"), rod({p.w * 0.42, s * t / 2, p.h * 0.49}, {p.w * 0.42, s * p.d / 2, p.h * 0.49}, 0.012, 10));
  }
}

void window(Piece& p) {
  const int frame = p.main("lacquer");
  const double t = std::min({0.06, p.w * 0.15, p.h * 0.15}), y = p.d / 2;
  const auto bar = [&](double x0, double x1, double z0, double z1) { p.add(frame, box(sides(x0, x1, -y, y, z0, z1), 0.004)); };
  bar(-p.w / 2, p.w / 2, 0, t);
  bar(-p.w / 2, p.w / 2, p.h - t, p.h);
  bar(-p.w / 2, -p.w / 2 + t, t, p.h - t);
  bar(p.w / 2 - t, p.w / 2, t, p.h - t);
  if (p.category() == "stained_glass") {
    // Panes in lead: a sun over hills, as rays and bands.
    static constexpr Color kPanes[] = {{0.92, 0.72, 0.26}, {0.80, 0.34, 0.24}, {0.26, 0.46, 0.66},
                                       {0.36, 0.58, 0.40}, {0.58, 0.36, 0.56}, {0.86, 0.54, 0.30}};
    const double x0 = -p.w / 2 + t * 0.9, z0 = t * 0.9, wide = p.w - 1.8 * t, tall = p.h - 1.8 * t;
    const int columns = std::max(2, static_cast<int>(wide / 0.14)), rows = std::max(3, static_cast<int>(tall / 0.16));
    const int lead = p.named("black_metal");
    for (int i = 0; i < columns; ++i) {
      for (int k = 0; k < rows; ++k) {
        const double px = x0 + wide * i / columns, pz = z0 + tall * k / rows, cx = px + wide / columns / 2, cz = pz + tall / rows / 2;
        const double dx = cx / wide, dz = (cz - p.h / 2) / tall;
        const int color = dx * dx + dz * dz < 0.06 ? 0 : (static_cast<int>(4 + 3 * dz + 2 * std::abs(dx)) + i * k) % 5 + 1;
        p.add(p.tinted("frosted_glass", kPanes[color]),
              box(sides(px + 0.004, px + wide / columns - 0.004, -y * 0.3, y * 0.3, pz + 0.004, pz + tall / rows - 0.004), 0));
      }
    }
    for (int i = 0; i <= columns; ++i)
      p.add(lead, box(sides(x0 + wide * i / columns - 0.004, x0 + wide * i / columns + 0.004, -y * 0.5, y * 0.5, z0, z0 + tall), 0));
    for (int k = 0; k <= rows; ++k)
      p.add(lead, box(sides(x0, x0 + wide, -y * 0.48, y * 0.48, z0 + tall * k / rows - 0.004, z0 + tall * k / rows + 0.004), 0));
    return;
  }
  if (p.w > 0.7) bar(-t * 0.3, t * 0.3, t, p.h - t);
  p.add(p.named("glass"), box(sides(-p.w / 2 + t * 0.8, p.w / 2 - t * 0.8, -0.003, 0.003, t * 0.8, p.h - t * 0.8), 0));
}

}  // namespace

void add_hall(Families& to) {
  to["umbrella_stand"] = umbrella_stand;
  to["coat_rack"] = coat_rack;
  to["hanger"] = hanger;
  to["shoe_rack"] = shoe_rack;
  to["screen_divider"] = screen_divider;
  to["pillar"] = pillar;
  to["stairs"] = stairs;
  to["door"] = door;
  to["window"] = window;
}

}  // namespace layoutbox::kit
