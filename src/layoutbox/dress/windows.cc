// Curtains and blinds.
#include <algorithm>
#include <array>

#include "layoutbox/catalog/opening_look.h"
#include "layoutbox/dress/places.h"

namespace layoutbox::dressing {
namespace {

constexpr double kBeyondHead = 150;  // mm of a curtain above the window
constexpr double kBelowSill = 120;   // … and below it, where it is short
constexpr double kOffFloor = 20, kOverCurtain = 40;
constexpr double kBlindBeyond = 50;  // mm of a blind at either side of the window and above it
constexpr std::array kBeyond{200.0, 120.0, 60.0};

// The place of a window on its wall.
struct Pane {
  const DressedWall* wall;
  Span along, height;
  bool open_to_view = false;  // a wall of glass, a bay
};

std::vector<Pane> panes(const Dresser& dresser) {
  std::vector<Pane> found;
  const auto& walls = dresser.room().walls();
  for (const Opening& window : dresser.layout().room.openings) {
    const auto wall = std::ranges::find_if(walls, [&](const DressedWall& frame) { return frame.wall->id == window.wall; });
    if (window.type != OpeningType::kWindow || !window.offset || wall == walls.end()) continue;
    const double from = *window.offset, sill = window.sill;
    const OpeningLook look = look_of(window);
    found.push_back({&*wall, {from, from + window.width}, {sill, sill + window.height}, look.whole || look.bay});
  }
  return found;
}

bool hang_before(Dresser& dresser, const Dressing& row, const DressedWall& wall, Span along, Span height) {
  const Mm depth = dresser.size_of(row).depth;
  if (along.low < 0 || along.high > wall.length || height.low < 0) return false;
  if (!dresser.room().is_free(wall.box(along, {0, double(depth)}, height), true)) return false;
  dresser.add_at_wall(row.adds, row.words, {static_cast<Mm>(along.length()), depth, static_cast<Mm>(height.length())}, wall, along.low,
                      height.low);
  return true;
}

}  // namespace

// Down to the floor where nothing stands there, else down to the sill; as far beyond the window as the wall is free.
void hang_at_windows(Dresser& dresser, const Dressing& row) {
  int left = row.most;
  for (const Pane& pane : panes(dresser)) {
    if (pane.open_to_view) continue;
    const double top = std::min(pane.height.high + kBeyondHead, dresser.layout().room.height - kOverCurtain);
    if (left == 0 || top <= pane.height.high) continue;
    const auto hangs = [&](double from) {
      return std::ranges::any_of(kBeyond, [&](double beyond) {
        return hang_before(dresser, row, *pane.wall, {pane.along.low - beyond, pane.along.high + beyond}, {from, top});
      });
    };
    if (hangs(kOffFloor) || hangs(pane.height.low - kBelowSill) || hangs(pane.height.low - kOffFloor)) --left;
  }
}

// Drawn up: so much of the window from its head down as the row says.
void hang_on_window_tops(Dresser& dresser, const Dressing& row) {
  int left = row.most;
  for (const Pane& pane : panes(dresser)) {
    const double top = std::min(pane.height.high + kBlindBeyond, double(dresser.layout().room.height));
    const Span along{pane.along.low - kBlindBeyond, pane.along.high + kBlindBeyond};
    if (left > 0 && hang_before(dresser, row, *pane.wall, along, {top - dresser.size_of(row).height, top})) --left;
  }
}

}  // namespace layoutbox::dressing
