#include "layoutbox/furnish/families/parts.h"

#include <algorithm>
#include <cmath>

namespace layoutbox::kit {

void slab(Piece& p, int surface, const Box& b, std::string_view top, double bevel) {
  if (top != "round" && top != "oval") {
    p.add(surface, box(b, bevel));
    return;
  }
  const Vec c = b.center(), s = b.size();
  const double r = s.x / 2, e = std::min(bevel, s.z * 0.3);
  p.add(surface, lathe({{0, 0}, {r - e, 0}, {r, e}, {r, s.z - e}, {r - e, s.z}, {0, s.z}}, 40), moved(c.x, c.y, b.min.z) * scaled(1, s.y / s.x, 1));
}

void handle(Piece& p, int surface, Handle kind, Vec at, double size, double out) {
  if (kind == Handle::kNone) return;
  if (kind == Handle::kKnob) {
    const double r = std::min(0.014, size / 2);
    p.add(surface, lathe({{0, 0}, {r * 0.5, 0}, {r * 0.5, out * 0.4}, {r, out * 0.6}, {r * 0.8, out}, {0, out}}, 12), aimed(at, {0, -1, 0}));
    return;
  }
  const double half = size / 2, t = std::min(0.01, out / 2), foot = half * 0.8;
  const bool up = kind == Handle::kVertical;
  const auto piece = [&](double a0, double a1, double y0, double y1) {
    const double k = t / 2;
    p.add(surface, up ? box(sides(at.x - k, at.x + k, y0, y1, at.z + a0, at.z + a1), 0.002) : box(sides(at.x + a0, at.x + a1, y0, y1, at.z - k, at.z + k), 0.002));
  };
  piece(-half, half, at.y - out, at.y - out + t);
  piece(-foot - t / 2, -foot + t / 2, at.y - out + t, at.y);
  piece(foot - t / 2, foot + t / 2, at.y - out + t, at.y);
}

void fronts(Piece& p, int surface, int handle_surface, const Fronts& f) {
  const double gap = 0.003, cw = (f.x1 - f.x0) / f.columns, rh = (f.z1 - f.z0) / f.rows;
  for (int i = 0; i < f.columns; ++i) {
    for (int j = 0; j < f.rows; ++j) {
      const double x0 = f.x0 + cw * i + gap / 2, x1 = f.x0 + cw * (i + 1) - gap / 2;
      const double z0 = f.z0 + rh * j + gap / 2, z1 = f.z0 + rh * (j + 1) - gap / 2;
      p.add(surface, box(sides(x0, x1, f.y, f.y + f.thick, z0, z1), 0.003));
      if (f.doors) {
        const bool opens_right = f.columns == 1 ? false : i % 2 == 1;
        const double hx = opens_right ? x0 + 0.03 : x1 - 0.03, size = std::min(0.16, (z1 - z0) * 0.4);
        // Hands reach down to low doors and up to hanging ones.
        const double hz = z0 > 1.1 ? z0 + size : z1 > 1.4 ? std::clamp(1.05, z0 + size, z1 - size) : z1 - size * 0.9 - 0.02;
        handle(p, handle_surface, Handle::kVertical, {hx, f.y, hz}, size, f.out);
      } else {
        const double width = x1 - x0;
        handle(p, handle_surface, width < 0.3 || z1 - z0 < 0.05 ? Handle::kKnob : Handle::kHorizontal, {(x0 + x1) / 2, f.y, (z0 + z1) / 2},
               std::min({0.16, width * 0.35, 2 * (z1 - z0)}), f.out);
      }
    }
  }
}

namespace {

struct Cell {
  double x0, x1, z0, z1;
};

// The parts of a front that no space opens, as few rectangles: upright ones that reach from bottom to top first, then level ones.
std::vector<Cell> closed_cells(const Box& b, const std::vector<Box>& open) {
  std::vector<double> xs{b.min.x, b.max.x}, zs{b.min.z, b.max.z};
  for (const Box& o : open) {
    xs.insert(xs.end(), {std::clamp(o.min.x, b.min.x, b.max.x), std::clamp(o.max.x, b.min.x, b.max.x)});
    zs.insert(zs.end(), {std::clamp(o.min.z, b.min.z, b.max.z), std::clamp(o.max.z, b.min.z, b.max.z)});
  }
  for (auto* v : {&xs, &zs}) {
    std::sort(v->begin(), v->end());
    v->erase(std::unique(v->begin(), v->end(), [](double a, double c) { return c - a < 0.001; }), v->end());
  }
  const std::size_t nx = xs.size() - 1, nz = zs.size() - 1;
  std::vector<std::vector<int>> state(nx, std::vector<int>(nz, 0));  // 0 closed, 1 open or taken
  for (std::size_t i = 0; i < nx; ++i) {
    for (std::size_t j = 0; j < nz; ++j) {
      const double x = (xs[i] + xs[i + 1]) / 2, z = (zs[j] + zs[j + 1]) / 2;
      state[i][j] = std::any_of(open.begin(), open.end(), [&](const Box& o) { return x > o.min.x && x < o.max.x && z > o.min.z && z < o.max.z; });
    }
  }
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < nx; ++i) {
    if (std::any_of(state[i].begin(), state[i].end(), [](int s) { return s != 0; })) continue;
    std::size_t last = i;
    while (last + 1 < nx && std::none_of(state[last + 1].begin(), state[last + 1].end(), [](int s) { return s != 0; })) ++last;
    cells.push_back({xs[i], xs[last + 1], b.min.z, b.max.z});
    for (std::size_t k = i; k <= last; ++k) std::fill(state[k].begin(), state[k].end(), 1);
  }
  for (std::size_t j = 0; j < nz; ++j) {
    for (std::size_t i = 0; i < nx; ++i) {
      if (state[i][j] != 0) continue;
      std::size_t right = i, top = j;
      while (right + 1 < nx && state[right + 1][j] == 0) ++right;
      const auto free_row = [&](std::size_t row) {
        for (std::size_t k = i; k <= right; ++k) {
          if (state[k][row] != 0) return false;
        }
        return true;
      };
      while (top + 1 < nz && free_row(top + 1)) ++top;
      for (std::size_t k = i; k <= right; ++k) std::fill(state[k].begin() + static_cast<std::ptrdiff_t>(j), state[k].begin() + static_cast<std::ptrdiff_t>(top) + 1, 1);
      cells.push_back({xs[i], xs[right + 1], zs[j], zs[top + 1]});
    }
  }
  return cells;
}

void closed_part(Piece& p, const Carcass& c, const Cell& cell, double front) {
  const double width = cell.x1 - cell.x0, height = cell.z1 - cell.z0, face = front + 0.018;
  p.add(c.body, box(sides(cell.x0, cell.x1, face, c.box.max.y, cell.z0, cell.z1), 0.003));
  Fronts f{cell.x0 + 0.006, cell.x1 - 0.006, cell.z0 + 0.006, cell.z1 - 0.006, front};
  f.out = c.out;
  const bool drawers = c.drawers > 0 || (height < 0.3 && width > height);
  f.rows = drawers ? std::max(1, c.drawers > 0 ? std::min(c.drawers, static_cast<int>(height / 0.07)) : 1) : 1;
  f.columns = drawers ? std::max(1, static_cast<int>(std::lround(width / 0.8))) : std::max(1, c.doors > 0 ? c.doors : static_cast<int>(std::lround(width / 0.5)));
  f.doors = !drawers;
  fronts(p, c.front, c.handles, f);
}

}  // namespace

void carcass(Piece& p, const Carcass& c) {
  std::vector<Box> open;
  double deepest = c.box.min.y;
  for (const FreeSpace& space : p.spaces) {
    const Box& s = space.box;
    const bool within = s.max.x > c.box.min.x + 0.001 && s.min.x < c.box.max.x - 0.001 && s.max.z > c.box.min.z + 0.001 && s.min.z < c.box.max.z - 0.001;
    if (!within) continue;
    open.push_back(s);
    deepest = std::max(deepest, s.max.y);
  }
  const double front = c.box.min.y + c.out;
  // Boards end at the front of what they frame; the room for handles stays free only where there are fronts.
  for (const Cell& cell : closed_cells(c.box, open)) {
    const bool board = std::min(cell.x1 - cell.x0, cell.z1 - cell.z0) < 0.085;
    if (board || !c.closed_fronts) {
      p.add(c.body, box(sides(cell.x0, cell.x1, open.empty() ? front : c.box.min.y, c.box.max.y, cell.z0, cell.z1), 0.003));
    } else {
      closed_part(p, c, cell, front);
    }
  }
  for (const Box& s : open) {
    if (s.max.y > c.box.max.y - 0.002) continue;
    p.add(c.body, box(sides(std::max(s.min.x, c.box.min.x), std::min(s.max.x, c.box.max.x), s.max.y, c.box.max.y, std::max(s.min.z, c.box.min.z),
                            std::min(s.max.z, c.box.max.z)),
                      0));
  }
}

void books(Piece& p, const Box& room) {
  static constexpr Color kSpines[] = {{0.72, 0.25, 0.22}, {0.22, 0.40, 0.62}, {0.25, 0.50, 0.36}, {0.90, 0.87, 0.80}, {0.85, 0.62, 0.27},
                                      {0.20, 0.23, 0.30}, {0.80, 0.46, 0.35}, {0.55, 0.62, 0.68}, {0.46, 0.30, 0.42}, {0.93, 0.92, 0.90}};
  const Vec size = room.size();
  double x = room.min.x + 0.004;
  const double stop = room.min.x + size.x * p.random(0.55, 0.98);
  const double depth = std::min(size.y * 0.85, 0.19);
  while (x < stop) {
    const double thick = p.random(0.022, 0.05), tall = std::min(size.z * 0.94, p.random(0.19, 0.29));
    if (x + thick > room.max.x - 0.003) break;
    const double setback = p.random(0, std::min(0.02, size.y - depth)), deep = depth * p.random(0.85, 1.0);
    const double y0 = room.min.y + std::min(0.015, size.y - depth) + setback * 0.5;
    p.add(p.tinted("paper", kSpines[p.pick(static_cast<int>(std::size(kSpines)))]),
          box(sides(x, x + thick, y0, std::min(room.max.y, y0 + deep), room.min.z, room.min.z + tall), 0.002));
    x += thick + 0.001 + (p.random() < 0.06 ? 0.05 : 0);
  }
}

void cushions(Piece& p, int surface, const Box& room, int n, double radius) {
  const double each = room.size().x / std::max(1, n);
  for (int i = 0; i < n; ++i) {
    Box b = room;
    b.min.x = room.min.x + each * i + 0.003;
    b.max.x = room.min.x + each * (i + 1) - 0.003;
    p.add(surface, cushion(b, radius));
  }
}

}  // namespace layoutbox::kit
