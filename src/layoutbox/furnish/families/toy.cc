// Toys and children's things.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

constexpr Color kToyColors[] = {{0.84, 0.30, 0.26}, {0.26, 0.50, 0.76}, {0.95, 0.76, 0.28},
                                {0.36, 0.64, 0.40}, {0.90, 0.55, 0.24}, {0.58, 0.42, 0.68}};

void teddy(Piece& p) {
  const int fur = p.color_asked() ? p.main("fur") : p.tinted("fur", {0.66, 0.47, 0.30}), pale = p.tinted("fur", {0.86, 0.74, 0.58}),
            dark = p.named("black_plastic");
  p.add(fur, ellipsoid({0, 0, 0.3}, {0.24, 0.2, 0.26}, 18, 10));
  p.add(pale, ellipsoid({0, -0.08, 0.29}, {0.15, 0.14, 0.17}, 14, 8));
  p.add(fur, ellipsoid({0, -0.02, 0.68}, {0.22, 0.2, 0.2}, 18, 10));
  p.add(pale, ellipsoid({0, -0.19, 0.63}, {0.1, 0.08, 0.08}, 12, 6));
  p.add(dark, ellipsoid({0, -0.26, 0.66}, {0.03, 0.025, 0.022}, 8, 4));
  for (const double s : {-1.0, 1.0}) {
    p.add(fur, ellipsoid({s * 0.17, 0, 0.85}, {0.075, 0.04, 0.075}, 12, 6));
    p.add(dark, ellipsoid({s * 0.08, -0.195, 0.72}, {0.02, 0.02, 0.024}, 8, 4));
    p.add(fur, ellipsoid({s * 0.27, -0.08, 0.38}, {0.08, 0.1, 0.17}, 12, 8));
    p.add(fur, ellipsoid({s * 0.18, -0.25, 0.09}, {0.1, 0.2, 0.09}, 14, 8));
    p.add(pale, ellipsoid({s * 0.18, -0.43, 0.1}, {0.06, 0.025, 0.06}, 10, 6));
  }
  p.fit();
}

void ball(Piece& p) {
  const Vec r{p.w / 2, p.d / 2, p.h / 2};
  p.add(p.main_accent("plastic"), ellipsoid({0, 0, r.z}, r, 28, 16));
  p.add(p.named("plastic"), lathe({{0.985, -0.12}, {0.996, -0.12}, {1.003, 0}, {0.996, 0.12}, {0.985, 0.12}, {0.985, -0.12}}, 28),
        moved(0, 0, r.z) * scaled(r.x * 0.997, r.y * 0.997, r.z));
}

void toy_blocks(Piece& p) {
  const double s = std::min({p.w / 3.2, p.d / 2.2, p.h / 2});
  const Vec places[] = {{-1.05, -0.4, 0}, {0, -0.5, 0},     {1.05, -0.3, 0}, {-0.55, 0.6, 0},
                        {0.6, 0.62, 0},   {-0.5, -0.42, 1}, {0.52, -0.4, 1}};
  for (int i = 0; i < 7; ++i) {
    const double a = p.random(-14, 14);
    p.add(p.tinted("lacquer", kToyColors[i % 6]), box(sides(-s * 0.48, s * 0.48, -s * 0.48, s * 0.48, 0, s), s * 0.06),
          moved(places[i].x * s, places[i].y * s, places[i].z * s) * turned_z(a));
  }
  p.fit();
}

void toy_car(Piece& p) {
  const int paint = p.color_asked() ? p.main("plastic") : p.tinted("plastic", kToyColors[p.pick(6)]), dark = p.named("black_plastic");
  // Drives along the longer side.
  const bool along = p.w >= p.d;
  const Pose turn = along ? Pose{} : turned_z(90);
  p.add(paint, rounded_box(sides(-0.5, 0.5, -0.24, 0.24, 0.1, 0.3), 0.06, 3), turn);
  p.add(p.named("screen"), rounded_box(sides(-0.28, 0.22, -0.2, 0.2, 0.28, 0.46), 0.07, 3), turn);
  p.add(paint, box(sides(-0.2, 0.14, -0.19, 0.19, 0.44, 0.48), 0.02), turn);
  for (const double x : {-0.29, 0.29}) {
    for (const double y : {-1.0, 1.0}) {
      p.add(dark, rod({x, y * 0.18, 0.1}, {x, y * 0.26, 0.1}, 0.1, 18), turn);
      p.add(p.named("chrome"), rod({x, y * 0.25, 0.1}, {x, y * 0.265, 0.1}, 0.05, 12), turn);
    }
  }
  p.fit();
}

void doll_house(Piece& p) {
  const int wall = p.main_accent("lacquer"), roof = p.tinted("lacquer", {0.72, 0.34, 0.28}), floor_board = p.named("oak");
  const double eaves = p.h * 0.68, t = std::min(0.012, p.w * 0.03), y0 = -p.d / 2 + 0.002;
  for (const double s : {-1.0, 1.0})
    p.add(wall, box(sides(s > 0 ? (p.w / 2 - 0.005) - t : -(p.w / 2 - 0.005), s > 0 ? (p.w / 2 - 0.005) : -(p.w / 2 - 0.005) + t, y0,
                          p.d / 2 - 0.01, 0, eaves),
                    0.002));
  p.add(wall, box(sides(-(p.w / 2 - 0.005), (p.w / 2 - 0.005), p.d / 2 - 0.002 - t, p.d / 2 - 0.002, 0, eaves), 0.002));
  for (const double z : {0.0, eaves * 0.5 - t / 2, eaves - t})
    p.add(floor_board, box(sides(-(p.w / 2 - 0.005) + t, (p.w / 2 - 0.005) - t, y0, p.d / 2 - 0.01 - t, z, z + t), 0));
  const Pose upright{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, {}};
  p.add(wall, prism({{-(p.w / 2 - 0.005), eaves}, {(p.w / 2 - 0.005), eaves}, {0, p.h - 0.02}}, -p.d / 2 + 0.02, p.d / 2 - 0.02), upright);
  p.add(roof, prism({{p.w / 2, eaves - 0.02}, {p.w / 2, eaves + 0.01}, {0, p.h}, {0, p.h - 0.03}}, -p.d / 2, p.d / 2), upright);
  p.add(roof, prism({{-p.w / 2, eaves - 0.02}, {0, p.h - 0.03}, {0, p.h}, {-p.w / 2, eaves + 0.01}}, -p.d / 2, p.d / 2), upright);
  if (!p.may_show_contents()) return;
  for (const double x : {-0.24, 0.2}) {
    p.add(p.tinted("lacquer", kToyColors[1]),
          box(sides(x * p.w - p.w * 0.08, x * p.w + p.w * 0.08, 0, p.d * 0.2, t, t + eaves * 0.14), 0.004));
    p.add(p.tinted("lacquer", kToyColors[2]),
          box(sides(x * p.w - p.w * 0.05, x * p.w + p.w * 0.05, 0, p.d * 0.2, eaves * 0.5 + t / 2, eaves * 0.5 + t / 2 + eaves * 0.2),
              0.004));
  }
}

void tent(Piece& p) {
  const int cloth = p.main_accent("cotton"), pole = p.named("oak");
  const double x = p.w / 2, y = p.d / 2, top = p.h * 0.88;
  // A tipi: four cloth sides, the front one open in the middle, poles crossing at the top.
  const auto side = [&](Vec a, Vec b, Vec c) {
    const Vec n = unit(cross(b - a, c - a)), up = n * 0.004;
    Mesh mesh;
    const Vec q[] = {a, b, c, a - up, b - up, c - up};
    for (const Vec& v : q)
      mesh.positions.push_back({static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)}),
          mesh.uvs.push_back({static_cast<float>(v.x + v.y), static_cast<float>(v.z)});
    for (int i = 0; i < 6; ++i)
      mesh.normals.push_back(
          {static_cast<float>(i < 3 ? n.x : -n.x), static_cast<float>(i < 3 ? n.y : -n.y), static_cast<float>(i < 3 ? n.z : -n.z)});
    mesh.indices = {0, 1, 2, 5, 4, 3, 0, 3, 4, 0, 4, 1, 1, 4, 5, 1, 5, 2, 2, 5, 3, 2, 3, 0};
    p.add(cloth, mesh);
  };
  const Vec apex{0, 0, top};
  side({x, -y, 0}, {x, y, 0}, apex);
  side({x, y, 0}, {-x, y, 0}, apex);
  side({-x, y, 0}, {-x, -y, 0}, apex);
  side({-x, -y, 0}, {-x * 0.3, -y, 0}, apex);
  side({x * 0.3, -y, 0}, {x, -y, 0}, apex);
  for (const double s : {-1.0, 1.0}) {
    for (const double t : {-1.0, 1.0})
      p.add(pole, rod({s * (x - 0.012), t * (y - 0.012), 0}, {-s * x * 0.12, -t * y * 0.12, p.h}, 0.012, 8));
  }
  p.add(p.named("wool"), box(sides(-x * 0.8, x * 0.8, -y * 0.8, y * 0.8, 0, 0.015), 0.005));
  p.fit();
}

}  // namespace

void add_toys(Families& to) {
  to["teddy"] = teddy;
  to["ball"] = ball;
  to["toy_blocks"] = toy_blocks;
  to["toy_car"] = toy_car;
  to["doll_house"] = doll_house;
  to["tent"] = tent;
}

}  // namespace layoutbox::kit
