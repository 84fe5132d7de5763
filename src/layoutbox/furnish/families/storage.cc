// Storage: everything that is a body of boards with compartments, doors and drawers.
#include <algorithm>
#include <cmath>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// Body on feet (or a plinth), with a top board where `overhang` is wanted.
struct CabinetStyle {
  std::string_view body, front, handles;
  double feet;
  int drawers;
  int doors;
  bool worktop = false;  // the board on top is one
};

// The doors of an open cupboard: the outer ones stand at a right angle to its front, as wide as one of them.
void swung_doors(Piece& p, const Carcass& c) {
  constexpr double kLeaf = 0.02, kHandle = 0.012;
  const double face = c.box.min.y, wide = c.box.size().x / std::max(c.doors, 1);
  for (const double side : {-1.0, 1.0}) {
    if (side > 0 && c.doors < 2) continue;
    const double hinge = side < 0 ? c.box.min.x : c.box.max.x, inner = hinge - side * kLeaf, held = face - wide + 0.06;
    p.add(c.front, box(sides(std::min(hinge, inner), std::max(hinge, inner), face - wide, face, c.box.min.z, c.box.max.z), 0.003));
    const double z = (c.box.min.z + c.box.max.z) / 2;
    p.add(c.handles, rod({hinge + side * kHandle, held, z - 0.06}, {hinge + side * kHandle, held, z + 0.06}, 0.006, 8));
  }
}

void cabinet_of(Piece& p, const CabinetStyle& style) {
  const int body = p.painted_frame(style.body);
  const int front = p.color_asked() ? p.main(style.front) : style.front == style.body ? body : p.frame(style.front);
  double feet = p.number("feet", style.feet);
  const bool mid_century = p.is_style("mid-century") && p.h < 1.3;
  if (mid_century && feet > 0.04) feet = std::clamp(p.h * 0.2 - 0.02, feet, 0.18);
  const double under = p.clear_below(0);
  bool open_below = false;
  for (const FreeSpace& s : p.spaces) open_below = open_below || (s.box.min.z < feet + 0.01 && s.carries);
  if (under > 0 && !open_below) feet = under;
  if (open_below || p.h < feet * 3) feet = 0;
  if (feet > 0.04) {
    p.legs(p.named(style.body == "lacquer" ? "oak" : "walnut"), feet, 0.035, mid_century ? 0.08 : 0.03, true, mid_century ? 0.4 : 0.6);
  } else if (feet > 0) {
    p.add(body, box(sides(-p.w / 2 + 0.02, p.w / 2 - 0.02, -p.d / 2 + 0.05, p.d / 2, 0, feet), 0.003));
  }
  Carcass c{sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, feet, p.h), body, front, p.part("handles", style.handles)};
  c.drawers = p.count("drawers", style.drawers);
  c.doors = p.count("doors", style.doors);
  const bool has_spaces = std::any_of(p.spaces.begin(), p.spaces.end(), [&](const FreeSpace& s) { return s.box.max.z > feet + 0.01; });
  const double board = std::min(0.025, (p.h - feet) * 0.2);
  if (!has_spaces) {
    // A top board that stands over the fronts.
    const int top = style.worktop ? worktop(p) : body;
    p.add(top, box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, p.h - board, p.h), 0.004));
    c.box.max.z -= board;
    c.box.min.x += 0.004;
    c.box.max.x -= 0.004;
  }
  const bool open = has_spaces && p.says("open") && c.doors > 0 && c.drawers == 0;
  c.closed_fronts = c.closed_fronts && !open;
  carcass(p, c);
  if (open) swung_doors(p, c);
}

void nightstand(Piece& p) { cabinet_of(p, {"oak", "oak", "brass", 0.1, p.count("doors", 0) > 0 ? 0 : 2, 0}); }
void chest(Piece& p) { cabinet_of(p, {"oak", "oak", "brass", 0.08, p.h > 1.1 ? 5 : p.h > 0.7 ? 4 : 3, 0}); }
void cabinet(Piece& p) { cabinet_of(p, {"oak", "oak", "black_metal", p.h > 1.4 ? 0.06 : 0.12, 0, 0}); }
void wardrobe(Piece& p) { cabinet_of(p, {"oak", "lacquer", "steel", 0.06, 0, std::max(2, static_cast<int>(std::lround(p.w / 0.5)))}); }
void kitchen_unit(Piece& p) { cabinet_of(p, {"lacquer", "lacquer", "steel", 0.03, 0, 0, true}); }

// What a shelf shows where it holds nothing of the layout. Shelves other than those for books are left as they are once something
// was asked for on them, unless the text says what they are full of: it would not be seen among what nobody asked for.
void shelf_contents(Piece& p) {
  const ShelfContents contents = contents_of(p);
  const bool holds = std::ranges::any_of(p.spaces, &FreeSpace::held);
  if (!p.may_show_contents() || contents == nullptr || (holds && p.word("contents", "") != "books" && p.said_contents().empty())) return;
  for (const FreeSpace& s : p.spaces) {
    if (!s.carries || s.held || s.box.size().z <= 0.15 || s.box.max.z >= p.h - 0.005) continue;
    contents(p, s.box);
  }
}

// Shelves: boards round the compartments; books or goods where a compartment holds nothing.
void shelf(Piece& p) {
  const int wood = p.main("walnut");
  if (p.spaces.empty()) {
    const int n = std::max(2, static_cast<int>(p.h / 0.36));
    const double t = 0.02, back = p.d / 2 - 0.008;
    const ShelfContents contents = contents_of(p);
    for (const double x : {-1.0, 1.0})
      p.add(wood, box(sides(x > 0 ? p.w / 2 - t : -p.w / 2, x > 0 ? p.w / 2 : -p.w / 2 + t, -p.d / 2, p.d / 2, 0, p.h), 0.003));
    p.add(wood, box(sides(-p.w / 2 + t, p.w / 2 - t, back, p.d / 2, 0, p.h), 0));
    for (int i = 0; i <= n; ++i) {
      const double z = 0.04 + (p.h - 0.04 - t) * i / n;
      p.add(wood, box(sides(-p.w / 2 + t, p.w / 2 - t, -p.d / 2 + 0.002, back, z, z + t), 0.003));
      if (i < n && contents != nullptr)
        contents(p, sides(-p.w / 2 + t, p.w / 2 - t, -p.d / 2 + 0.01, back, z + t, z + (p.h - 0.04 - t) / n));
    }
    return;
  }
  Carcass c{p.body(), wood, wood, p.named("brass")};
  const bool two_sided = std::any_of(p.spaces.begin(), p.spaces.end(), [](const FreeSpace& s) { return s.box.min.y > -0.001; });
  if (two_sided) {
    // Open to the front and to the back, with a wall in the middle.
    double front = 0, back = 0;
    for (const FreeSpace& s : p.spaces) (s.box.min.y > -0.001 ? back : front) = s.box.min.y > -0.001 ? s.box.min.y : s.box.max.y;
    c.closed_fronts = false;
    p.add(wood, box(sides(-p.w / 2 + 0.002, p.w / 2 - 0.002, front, back, 0, p.h - 0.002), 0));
    c.box.max.y = front;
    carcass(p, c);
    c.box = sides(-p.w / 2, p.w / 2, back, p.d / 2, 0, p.h);
  }
  carcass(p, c);
  shelf_contents(p);
}

// A rod between brackets on a wall, for towels, clothes or curtains.
void rail(Piece& p) {
  const int metal = p.main("steel");
  if (p.category() == "toilet_paper_holder") {
    const double y0 = -p.d / 2, roll = std::min(p.h, p.d * 0.9) / 2, mid = y0 + roll;
    p.add(
        p.named("paper"),
        lathe({{roll * 0.36, -p.w * 0.4}, {roll, -p.w * 0.4}, {roll, p.w * 0.4}, {roll * 0.36, p.w * 0.4}, {roll * 0.36, -p.w * 0.4}}, 32),
        aimed({0, mid, p.h / 2}, {1, 0, 0}));
    p.add(metal, rod({-p.w / 2, mid, p.h / 2}, {p.w / 2, mid, p.h / 2}, roll * 0.16, 12));
    p.add(metal, rod({-p.w * 0.47, mid, p.h / 2}, {-p.w * 0.47, p.d / 2, p.h / 2}, roll * 0.16, 12));
    p.add(metal, box(sides(-p.w / 2, -p.w * 0.34, p.d / 2 - 0.01, p.d / 2, p.h * 0.25, p.h * 0.75), 0.003));
    p.fit();
    return;
  }
  const int n = std::max(1, std::min(p.count("rails", 1), static_cast<int>(p.h / 0.06)));
  const double r = std::min({0.012, p.d * 0.3, p.h * 0.4}), y = -p.d / 2 + r;
  for (int i = 0; i < n; ++i) {
    const double z = p.h - r - (p.h - 2 * r) * i / std::max(1, n - 1) * (n > 1 ? 1 : 0);
    p.add(metal, rod({-p.w / 2, y, z}, {p.w / 2, y, z}, r, 12));
  }
  for (const double x : {-1.0, 1.0}) {
    const double x0 = x > 0 ? p.w / 2 - std::min(0.05, p.w * 0.2) : -p.w / 2 + std::min(0.03, p.w * 0.1), wide = std::min(0.02, p.w * 0.1);
    p.add(metal, box(sides(x0, x0 + wide, y, p.d / 2 - 0.004, p.h - std::min(p.h, 2 * r), p.h), 0.002));
    p.add(metal, box(sides(x0 - wide * 0.25, x0 + wide * 1.25, p.d / 2 - 0.008, p.d / 2, 0, p.h), 0.002));
  }
}

// Clothes on a rail, side by side; only where nothing else hangs there.
void garments(Piece& p, const FreeSpace& room) {
  static constexpr Color kCloth[] = {{0.30, 0.40, 0.54}, {0.86, 0.82, 0.74}, {0.62, 0.30, 0.28},
                                     {0.36, 0.44, 0.38}, {0.24, 0.25, 0.28}, {0.78, 0.62, 0.40}};
  const Box& b = room.box;
  const int metal = p.named("steel");
  for (double x = b.min.x + 0.06; x < b.max.x - 0.06; x += p.random(0.07, 0.12)) {
    const double top = b.max.z - 0.05, low = top - std::min(b.size().z * 0.9, p.random(0.6, 1.0)), half = b.size().y * p.random(0.36, 0.46);
    const int cloth = p.tinted("cotton", kCloth[p.pick(6)]);
    p.add(cloth, taper({x, 0, low}, {0.022, half}, {x, 0, top - 0.05}, {0.018, half * 0.9}));
    p.add(cloth, taper({x, 0, top - 0.052}, {0.018, half * 0.9}, {x, 0, top}, {0.01, 0.03}));
    p.add(metal, rod({x, 0, top - 0.005}, {x, 0, b.max.z}, 0.002, 5));
  }
}

// A rack: posts at the corners and boards between them.
void rack(Piece& p) {
  if (p.word("kind", "") == "rail" || (p.mount() == Mount::kWall && p.spaces.empty())) return rail(p);
  const int metal = p.frame("black_metal"), board = p.main("oak");
  constexpr double kBay = 2.7;  // what is longer has posts between
  const double t = side_room(p, std::min({0.025, p.w * 0.05, p.d * 0.15}));
  const int bays = std::max(1, static_cast<int>(std::ceil(p.w / kBay)));
  for (int bay = 0; bay <= bays; ++bay) {
    const double x = 2.0 * bay / bays - 1;
    for (const double y : {-1.0, 1.0}) {
      const double cx = x * (p.w / 2 - t / 2), cy = y * (p.d / 2 - t / 2);
      p.add(metal, box(sides(cx - t / 2, cx + t / 2, cy - t / 2, cy + t / 2, 0, p.h), 0.003));
    }
    const double cx = x * (p.w / 2 - t / 2);
    for (const double z : {p.h - t, p.h * 0.5})
      p.add(metal, box(sides(cx - t * 0.4, cx + t * 0.4, -p.d / 2 + t, p.d / 2 - t, z, z + t * 0.9), 0.002));
  }
  if (p.word("kind", "") == "garment" && !p.spaces.empty()) {
    const auto room = std::ranges::find_if(p.spaces, &FreeSpace::carries);  // where clothes hang; shoes stand below
    p.add(metal, rod({-p.w / 2, 0, p.h - t}, {p.w / 2, 0, p.h - t}, t * 0.6, 12));
    if (room != p.spaces.end() && p.may_show_contents() && !room->held) garments(p, *room);
  }
  std::vector<double> levels;
  for (const FreeSpace& s : p.spaces) {
    if (s.carries) levels.push_back(s.box.min.z);
  }
  if (levels.empty()) {
    const int n = std::max(2, static_cast<int>(p.h / 0.4));
    for (int i = 0; i < n; ++i) levels.push_back(0.1 + (p.h - 0.1) * (i + 1) / n);
  }
  // Boards are as thick as the spaces above and below leave them.
  const auto lift = [&](double z) {
    double room = std::min(0.02, z - 0.001);
    for (const FreeSpace& s : p.spaces) {
      if (s.box.max.z < z + 0.001) room = std::min(room, z - s.box.max.z);
    }
    return std::max(room, 0.002);
  };
  for (const double z : levels) {
    p.add(board, box(sides(-p.w / 2 + 0.003, p.w / 2 - 0.003, -p.d / 2 + 0.003, p.d / 2 - 0.003, z - lift(z), z), 0.003));
  }
}

}  // namespace

void add_storage(Families& to) {
  to["nightstand"] = nightstand;
  to["chest_of_drawers"] = chest;
  to["cabinet"] = cabinet;
  to["wardrobe"] = wardrobe;
  to["kitchen_unit"] = kitchen_unit;
  to["shelf"] = shelf;
  to["rack"] = rack;
}

}  // namespace layoutbox::kit
