// What hangs on walls: over things, and on blank stretches.
#include <algorithm>
#include <cmath>

#include "layoutbox/catalog/measures.h"
#include "layoutbox/dress/places.h"

namespace layoutbox::dressing {
namespace {

constexpr double kOfWidth = 0.6;     // a single picture's share of what it hangs over
constexpr double kOfStretch = 0.38;  // … of its stretch of wall
constexpr double kBasin = 1000;      // what hangs lower is like what stands

Size within(const CatalogEntry& entry, Size size, double scale) {
  const auto held = [&](Mm side, Mm least, Mm most) {
    return static_cast<Mm>(on_grid(std::clamp(side * scale, double(least), double(most))));
  };
  size.width = held(size.width, entry.size.least.width, entry.size.greatest.width);
  size.height = held(size.height, entry.size.least.height, entry.size.greatest.height);
  return size;
}

// Its usual height on the wall, with its middle at the height of the eyes where it is a picture; higher over what stands there.
double height_for(const Dresser& dresser, const Dressing& row, const Size& size, double top) {
  const CatalogEntry& entry = dresser.catalog().entry_or_nearest(row.adds);
  const double usual = entry.hang_height + (entry.size.usual.height - size.height) / 2.0;
  return on_grid(std::max(usual, top + measures().picture_over_top));
}

// Stretches where something so flat hangs in full view; what stands or hangs before it hides it, a door does not.
std::vector<Span> seen_stretches(const Dresser& dresser, const DressedWall& wall, double depth, Span height) {
  return shared(dresser.room().free_along(wall, {0, depth}, height),
                dresser.room().free_along(wall, {0, double(measures().seen_from)}, height, FreeRoom::Count::kThings));
}

bool fits(const Dresser& dresser, const DressedWall& wall, Span along, double depth, Span height) {
  if (height.high > dresser.layout().room.height - measures().picture_to_ceiling) return false;
  const auto holds = [&](const Span& free) {
    return free.low <= along.low - measures().around_picture && free.high >= along.high + measures().around_picture;
  };
  return std::ranges::any_of(seen_stretches(dresser, wall, depth, height), holds);
}

// A row of them, centred there; the first that is hindered hinders all.
bool hang(Dresser& dresser, const Dressing& row, const DressedWall& wall, double middle, double top, const Size& size, int count) {
  const double whole = count * size.width + (count - 1) * measures().between_pictures, from = middle - whole / 2;
  const double height = height_for(dresser, row, size, top);
  if (!fits(dresser, wall, {from, from + whole}, size.depth, {height, height + size.height})) return false;
  for (int k = 0; k < count; ++k)
    dresser.add_at_wall(row.adds, row.words, size, wall, from + k * (size.width + measures().between_pictures), height);
  return true;
}

}  // namespace

// One as large as suits what stands below; where the row says how wide, as many of these as go over it, up to three.
void hang_over_things(Dresser& dresser, const Dressing& row) {
  const CatalogEntry& entry = dresser.catalog().entry_or_nearest(row.adds);
  int left = row.most;
  for (const std::size_t i : dresser.things(row.of)) {
    const PlacedObject below = dresser.layout().objects[i];
    const bool low = below.mount == Mount::kFloor || (below.mount == Mount::kWall && below.position[2] + below.size.height < kBasin);
    const DressedWall* wall = low ? dresser.room().behind(below, measures().behind_it) : nullptr;
    if (wall == nullptr || left == 0 || below.size.width < row.stretch) continue;
    Size size = dresser.size_of(row);
    int count = 1;
    if (row.size.width > 0) {
      count = std::clamp(static_cast<int>((below.size.width + measures().between_pictures) / (size.width + measures().between_pictures)), 1,
                         std::min(3, left));
    } else {
      size = within(entry, size, below.size.width * kOfWidth / size.width);
    }
    const RoomBox box = box_round(below);
    if (hang(dresser, row, *wall, wall->along(box).middle(), box.z1, size, count)) left -= count;
  }
}

// On walls that the picture shows first, the longest blank stretch of these; one on a wall.
void hang_on_walls(Dresser& dresser, const Dressing& row) {
  const CatalogEntry& entry = dresser.catalog().entry_or_nearest(row.adds);
  struct Blank {
    const DressedWall* wall;
    Span span;
  };
  std::vector<Blank> blanks;
  const Size usual = dresser.size_of(row);
  const double low = height_for(dresser, row, usual, 0);
  for (const DressedWall& wall : dresser.room().walls()) {
    const std::vector<Span> free = seen_stretches(dresser, wall, usual.depth, {low, low + usual.height});
    const auto longest = std::ranges::max_element(free, {}, &Span::length);
    if (longest != free.end() && longest->length() >= row.stretch) blanks.push_back({&wall, *longest});
  }
  std::ranges::stable_sort(blanks, std::greater{},
                           [&](const Blank& blank) { return std::pair(dresser.is_shown(*blank.wall), blank.span.length()); });
  int left = row.most;
  for (const auto& [wall, span] : blanks) {
    if (left == 0) return;
    const double scale = row.size.width > 0 ? 1 : span.length() * kOfStretch / usual.width;
    if (hang(dresser, row, *wall, on_grid(span.middle()), 0, within(entry, usual, scale), 1)) --left;
  }
}

}  // namespace layoutbox::dressing
