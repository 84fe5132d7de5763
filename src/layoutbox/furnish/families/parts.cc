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
  p.add(surface, lathe({{0, 0}, {r - e, 0}, {r, e}, {r, s.z - e}, {r - e, s.z}, {0, s.z}}, 40),
        moved(c.x, c.y, b.min.z) * scaled(1, s.y / s.x, 1));
}

double side_room(const Piece& p, double most) {
  double room = most;
  for (const FreeSpace& s : p.spaces) room = std::min({room, p.w / 2 - s.box.max.x, s.box.min.x + p.w / 2});
  return std::max(0.004, room);
}

Seat seat_of(const Piece& p, double level, double arm, double back) {
  if (const FreeSpace* s = p.open_above()) return {s->box.min.z, s->box.min.x, s->box.max.x, s->box.max.y};
  return {std::min(level, p.h * 0.6), -p.w / 2 + arm, p.w / 2 - arm, p.d / 2 - back};
}

void handle(Piece& p, int surface, Handle kind, Vec at, double size, double out) {
  if (kind == Handle::kNone) return;
  if (kind == Handle::kKnob) {
    const double r = std::min(0.014, size / 2);
    p.add(surface, lathe({{0, 0}, {r * 0.5, 0}, {r * 0.5, out * 0.4}, {r, out * 0.6}, {r * 0.8, out}, {0, out}}, 12),
          aimed(at, {0, -1, 0}));
    return;
  }
  const double half = size / 2, t = std::min(0.01, out / 2), foot = half * 0.8;
  const bool up = kind == Handle::kVertical;
  const auto piece = [&](double a0, double a1, double y0, double y1) {
    const double k = t / 2;
    p.add(surface, up ? box(sides(at.x - k, at.x + k, y0, y1, at.z + a0, at.z + a1), 0.002)
                      : box(sides(at.x + a0, at.x + a1, y0, y1, at.z - k, at.z + k), 0.002));
  };
  piece(-half, half, at.y - out, at.y - out + t);
  piece(-foot - t / 2, -foot + t / 2, at.y - out + t, at.y);
  piece(foot - t / 2, foot + t / 2, at.y - out + t, at.y);
}

void fronts(Piece& p, int surface, int handle_surface, const Fronts& f) {
  // Knobs in some rooms, bars in others, the same for all fronts of a kind.
  const bool knobs = p.is_style("traditional") || p.is_style("rustic") || (!p.is_style("modern") && p.variant(3) == 0);
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
        handle(p, handle_surface, knobs ? Handle::kKnob : Handle::kVertical, {hx, f.y, hz}, size, f.out);
      } else {
        const double width = x1 - x0;
        handle(p, handle_surface, knobs || width < 0.3 || z1 - z0 < 0.05 ? Handle::kKnob : Handle::kHorizontal,
               {(x0 + x1) / 2, f.y, (z0 + z1) / 2}, std::min({0.16, width * 0.35, 2 * (z1 - z0)}), f.out);
      }
    }
  }
}

namespace {

struct ClosedCell {
  double x0, x1, z0, z1;
};

// The parts of a front that no space opens, as few rectangles: top and bottom boards first, then upright parts that reach from one to the
// other, then level ones.
class ClosedCells {
 public:
  ClosedCells(const Box& b, const std::vector<Box>& open) {
    double low = b.max.z, high = b.min.z;
    for (const Box& o : open) low = std::min(low, o.min.z), high = std::max(high, o.max.z);
    double z0 = b.min.z, z1 = b.max.z;
    if (!open.empty() && b.max.z - high > 0.006)
      cells.push_back({b.min.x, b.max.x, z1 - std::min(0.022, b.max.z - high), z1}), z1 = cells.back().z0;
    if (!open.empty() && low - b.min.z > 0.006)
      cells.push_back({b.min.x, b.max.x, z0, z0 + std::min(0.022, low - b.min.z)}), z0 = cells.back().z1;
    xs_ = {b.min.x, b.max.x};
    zs_ = {z0, z1};
    for (const Box& o : open) {
      xs_.insert(xs_.end(), {std::clamp(o.min.x, b.min.x, b.max.x), std::clamp(o.max.x, b.min.x, b.max.x)});
      zs_.insert(zs_.end(), {std::clamp(o.min.z, z0, z1), std::clamp(o.max.z, z0, z1)});
    }
    for (auto* v : {&xs_, &zs_}) {
      std::sort(v->begin(), v->end());
      v->erase(std::unique(v->begin(), v->end(), [](double p, double q) { return q - p < 0.001; }), v->end());
    }
    nx_ = xs_.size() - 1;
    nz_ = zs_.size() - 1;
    if (zs_.size() < 2 || xs_.size() < 2) return;
    taken_.assign(nx_ * nz_, false);
    for (std::size_t i = 0; i < nx_; ++i) {
      for (std::size_t j = 0; j < nz_; ++j) {
        const double x = (xs_[i] + xs_[i + 1]) / 2, z = (zs_[j] + zs_[j + 1]) / 2;
        taken_[i * nz_ + j] =
            std::any_of(open.begin(), open.end(), [&](const Box& o) { return x > o.min.x && x < o.max.x && z > o.min.z && z < o.max.z; });
      }
    }
    take_columns();
    take_rows();
  }

  std::vector<ClosedCell> cells;

 private:
  bool free(std::size_t i0, std::size_t i1, std::size_t j0, std::size_t j1) const {
    for (std::size_t i = i0; i <= i1; ++i) {
      for (std::size_t j = j0; j <= j1; ++j) {
        if (taken_[i * nz_ + j]) return false;
      }
    }
    return true;
  }

  void take(std::size_t i0, std::size_t i1, std::size_t j0, std::size_t j1) {
    cells.push_back({xs_[i0], xs_[i1 + 1], zs_[j0], zs_[j1 + 1]});
    for (std::size_t i = i0; i <= i1; ++i) {
      for (std::size_t j = j0; j <= j1; ++j) taken_[i * nz_ + j] = true;
    }
  }

  void take_columns() {
    for (std::size_t i = 0; i < nx_; ++i) {
      std::size_t last = i;
      if (!free(i, i, 0, nz_ - 1)) continue;
      while (last + 1 < nx_ && free(last + 1, last + 1, 0, nz_ - 1)) ++last;
      take(i, last, 0, nz_ - 1);
    }
  }

  void take_rows() {
    for (std::size_t j = 0; j < nz_; ++j) {
      for (std::size_t i = 0; i < nx_; ++i) {
        if (taken_[i * nz_ + j]) continue;
        std::size_t right = i, top = j;
        while (right + 1 < nx_ && free(right + 1, right + 1, j, j)) ++right;
        while (top + 1 < nz_ && free(i, right, top + 1, top + 1)) ++top;
        take(i, right, j, top);
      }
    }
  }

  std::vector<double> xs_, zs_;
  std::size_t nx_ = 0, nz_ = 0;
  std::vector<bool> taken_;
};

// Doors or drawers over a rectangle, in the depth from `front` (handles) back to `face`.
void close_front(Piece& p, const Carcass& c, const ClosedCell& cell, double front, double face) {
  const double width = cell.x1 - cell.x0, height = cell.z1 - cell.z0, deep = face - front;
  const bool drawers = c.drawers > 0 || (height < 0.45 && width > height * 1.5);
  Fronts f{cell.x0 + 0.004, cell.x1 - 0.004, cell.z0 + 0.004, cell.z1 - 0.004, front + deep / 2};
  f.out = deep / 2;
  f.thick = deep / 2;
  f.doors = !drawers;
  if (drawers) {
    f.columns = std::max(1, static_cast<int>(std::lround(width / 0.62)));
    f.rows = std::clamp((c.drawers + f.columns - 1) / f.columns, 1, std::max(1, static_cast<int>(height / 0.07)));
  } else {
    const int by_width = std::max(1, static_cast<int>(std::lround(width / 0.5)));
    f.columns = c.doors > 0 && width > 0.6 * c.box.size().x ? c.doors : by_width;
  }
  fronts(p, c.front, c.handles, f);
}

}  // namespace

int worktop(Piece& p) {
  if (p.says("marble")) return p.named("marble");
  if (p.says("wood") || p.says("wooden") || p.says("oak")) return p.named("oak");
  return p.part("worktops", "granite");
}

void carcass(Piece& p, const Carcass& c) {
  std::vector<Box> open;
  std::vector<ClosedCell> behind_doors;
  const double front = c.box.min.y;
  for (const FreeSpace& space : p.spaces) {
    const Box& s = space.box;
    const bool within = s.max.y > c.box.min.y + 0.001 && s.min.y < c.box.max.y - 0.001 && s.max.x > c.box.min.x + 0.001 &&
                        s.min.x < c.box.max.x - 0.001 && s.max.z > c.box.min.z + 0.001 && s.min.z < c.box.max.z - 0.001;
    if (!within) continue;
    open.push_back(s);
    // A space that begins behind the front has a door before it, which is left out when something is in it that should be seen.
    if (c.closed_fronts && s.min.y > front + 0.012 && !space.held) behind_doors.push_back({s.min.x, s.max.x, s.min.z, s.max.z});
  }
  const bool closed_inside = !behind_doors.empty();
  double face = front + c.out * 2;
  for (const Box& s : open) {
    if (c.closed_fronts && s.min.y > front + 0.012) face = std::min(face, s.min.y);
  }
  // Boards end at the front of what they frame; only where there are doors and drawers does the body stand back for them.
  for (const ClosedCell& cell : ClosedCells(c.box, open).cells) {
    const bool board = std::min(cell.x1 - cell.x0, cell.z1 - cell.z0) < 0.085;
    const bool plain = board || !c.closed_fronts;
    p.add(c.body,
          box(sides(cell.x0, cell.x1, plain && !(open.empty() || closed_inside) ? front : face, c.box.max.y, cell.z0, cell.z1), 0.003));
    if (!plain) close_front(p, c, cell, front, face);
  }
  for (const Box& s : open) {
    if (s.max.y > c.box.max.y - 0.002) continue;
    p.add(c.body, box(sides(std::max(s.min.x, c.box.min.x), std::min(s.max.x, c.box.max.x), s.max.y, c.box.max.y,
                            std::max(s.min.z, c.box.min.z), std::min(s.max.z, c.box.max.z)),
                      0));
  }
  if (!closed_inside) return;
  // One set of doors over all that lies behind them, out to the body's edges.
  ClosedCell all = behind_doors.front();
  for (const ClosedCell& cell : behind_doors)
    all = {std::min(all.x0, cell.x0), std::max(all.x1, cell.x1), std::min(all.z0, cell.z0), std::max(all.z1, cell.z1)};
  Carcass doors = c;
  if (behind_doors.size() == 1 || all.z1 - all.z0 > 0.4) doors.drawers = 0;
  close_front(p, doors,
              {std::max(c.box.min.x, all.x0 - 0.018), std::min(c.box.max.x, all.x1 + 0.018), std::max(c.box.min.z, all.z0 - 0.012),
               std::min(c.box.max.z, all.z1 + 0.012)},
              front, face);
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
          box(sides(x, x + thick, y0, std::min(room.max.y, y0 + deep), room.min.z, room.min.z + tall), 0));
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

void open_box(Piece& p, int surface, const Box& b, double wall, double bevel) {
  Box in = sides(b.min.x + wall, b.max.x - wall, b.min.y + wall, b.max.y - wall, b.min.z + wall, b.max.z);
  if (const FreeSpace* s = p.open_above()) in = s->box;
  p.add(surface, box(sides(b.min.x, b.max.x, b.min.y, b.max.y, b.min.z, in.min.z), bevel));
  const double low = in.min.z - std::min(0.002, in.min.z - b.min.z);
  p.add(surface, box(sides(b.min.x, in.min.x, b.min.y, b.max.y, low, b.max.z), bevel));
  p.add(surface, box(sides(in.max.x, b.max.x, b.min.y, b.max.y, low, b.max.z), bevel));
  p.add(surface, box(sides(in.min.x - bevel, in.max.x + bevel, b.min.y, in.min.y, low, b.max.z), bevel));
  p.add(surface, box(sides(in.min.x - bevel, in.max.x + bevel, in.max.y, b.max.y, low, b.max.z), bevel));
}

void vessel(Piece& p, int surface, std::span<const Vec2> outside, double wall, double floor, int sides_round) {
  std::vector<Vec2> profile{{0, outside.front().y}};
  profile.insert(profile.end(), outside.begin(), outside.end());
  for (std::size_t i = outside.size(); i-- > 0;) {
    if (outside[i].y < floor) break;
    if (outside[i].x > wall) profile.push_back({outside[i].x - wall, outside[i].y});
  }
  profile.push_back({std::max(0.0, profile.back().x * 0.9), floor});
  profile.push_back({0, floor});
  p.add(surface, lathe(profile, sides_round), scaled(1, p.d / p.w, 1));
}

void vessel(Piece& p, int surface, std::initializer_list<Vec2> outside, double wall, double floor, int sides_round) {
  vessel(p, surface, std::span<const Vec2>(outside.begin(), outside.size()), wall, floor, sides_round);
}

void machine_body(Piece& p, int surface, const Box& b, double bevel) {
  const double foot = std::min(0.06, b.size().z * 0.08);
  p.add(surface, box({{b.min.x, b.min.y, b.min.z + foot}, b.max}, bevel));
  p.add(p.named("black_plastic"),
        box(sides(b.min.x + 0.02, b.max.x - 0.02, b.min.y + 0.03, b.max.y - 0.01, b.min.z, b.min.z + foot), 0.002));
}

void dial(Piece& p, int surface, Vec at, double radius, double thick, int sides_round) {
  p.add(surface, lathe({{0, 0}, {radius, 0}, {radius, thick * 0.8}, {radius * 0.92, thick}, {0, thick}}, sides_round),
        aimed(at, {0, -1, 0}));
}

}  // namespace layoutbox::kit
