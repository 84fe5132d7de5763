#include "layoutbox/dress/free_room.h"

#include <algorithm>
#include <cmath>

#include "layoutbox/catalog/trait_table.h"

namespace layoutbox::dressing {
namespace {

constexpr double kTouch = 1;           // mm: what overlaps by less only touches
constexpr double kBeforeWindow = 500;  // mm, above its sill: as verify has it
constexpr double kBeforeDoor = 100;    // mm more than its leaf is wide
constexpr double kRug = 30;            // mm: what is lower is walked over

bool spans_overlap(double a0, double a1, double b0, double b1) { return a0 < b1 - kTouch && b0 < a1 - kTouch; }

std::array<double, 2> corner_of(const Point& p) { return {double(p.x), double(p.y)}; }

// Does the edge from a to b pass through the box of the plan, not only along its rim?
bool passes(const Point& a, const Point& b, const RoomBox& box) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  double first = 0, last = 1;
  const auto clip = [&](double from, double step, double low, double high) {
    if (std::abs(step) < 1e-9) return from > low && from < high;
    double t0 = (low - from) / step, t1 = (high - from) / step;
    if (t0 > t1) std::swap(t0, t1);
    first = std::max(first, t0), last = std::min(last, t1);
    return first < last;
  };
  return clip(a.x, dx, box.x0 + kTouch, box.x1 - kTouch) && clip(a.y, dy, box.y0 + kTouch, box.y1 - kTouch);
}

bool contains(const std::vector<Point>& polygon, double x, double y) {
  bool in = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const auto [ax, ay] = corner_of(polygon[i]);
    const auto [bx, by] = corner_of(polygon[j]);
    if ((ay > y) != (by > y) && x < (bx - ax) * (y - ay) / (by - ay) + ax) in = !in;
  }
  return in;
}

DressedWall frame_of(const Wall& wall) {
  DressedWall frame{&wall, wall.start};
  const double dx = wall.end.x - wall.start.x, dy = wall.end.y - wall.start.y;
  frame.length = std::hypot(dx, dy);
  if (std::abs(dy) < kTouch) frame.along_x = dx > 0 ? 1 : -1;
  if (std::abs(dx) < kTouch) frame.along_y = dy > 0 ? 1 : -1;
  // The front looks into the room, which is to the left of the wall's way.
  frame.turn_deg = frame.along_x > 0 ? 180 : frame.along_x < 0 ? 0 : frame.along_y > 0 ? 270 : 90;
  return frame;
}

}  // namespace

bool overlap(const RoomBox& a, const RoomBox& b) {
  return spans_overlap(a.x0, a.x1, b.x0, b.x1) && spans_overlap(a.y0, a.y1, b.y0, b.y1) && spans_overlap(a.z0, a.z1, b.z0, b.z1);
}

RoomBox box_round(const PlacedObject& object) {
  const double turn = radians_from_degrees(object.rotation_deg), c = std::abs(std::cos(turn)), s = std::abs(std::sin(turn));
  const double w = (object.size.width * c + object.size.depth * s) / 2, d = (object.size.width * s + object.size.depth * c) / 2;
  const auto& [x, y, z] = object.position;
  return {x - w, y - d, z, x + w, y + d, z + object.size.height};
}

RoomBox DressedWall::box(Span along, Span off, Span height) const {
  const auto a = point(along.low, off.low, height.low), b = point(along.high, off.high, height.high);
  return {std::min(a[0], b[0]), std::min(a[1], b[1]), height.low, std::max(a[0], b[0]), std::max(a[1], b[1]), height.high};
}

Span DressedWall::along(const RoomBox& box) const {
  const double a = (box.x0 - start.x) * along_x + (box.y0 - start.y) * along_y,
               b = (box.x1 - start.x) * along_x + (box.y1 - start.y) * along_y;
  return {std::min(a, b), std::max(a, b)};
}

Span DressedWall::off(const RoomBox& box) const {
  const double a = (box.y0 - start.y) * along_x - (box.x0 - start.x) * along_y,
               b = (box.y1 - start.y) * along_x - (box.x1 - start.x) * along_y;
  return {std::min(a, b), std::max(a, b)};
}

std::array<double, 3> DressedWall::point(double along, double off, double height) const {
  return {start.x + along * along_x - off * along_y, start.y + along * along_y + off * along_x, height};
}

FreeRoom::FreeRoom(const Layout& layout, const Catalog& catalog, std::string_view but) : layout_(&layout) {
  for (const Wall& wall : layout.room.walls) {
    const DressedWall frame = frame_of(wall);
    if (frame.along_x != 0 || frame.along_y != 0) walls_.push_back(frame);
  }
  take_openings();
  for (const PlacedObject& object : layout.objects) {
    if (object.id != but) take(object, catalog.entry_or_nearest(object.category));
  }
}

void FreeRoom::take_openings() {
  for (const Opening& opening : layout_->room.openings) {
    const auto wall = std::ranges::find_if(walls_, [&](const DressedWall& frame) { return frame.wall->id == opening.wall; });
    if (wall == walls_.end() || !opening.offset) continue;
    const Span along{double(*opening.offset), double(*opening.offset) + opening.width};
    const bool window = opening.type == OpeningType::kWindow;
    const Span height{double(opening.sill), double(opening.sill) + opening.height};
    taken_.push_back({wall->box(along, {-kBeforeDoor, window ? kBeforeWindow : opening.width + kBeforeDoor}, height),
                      window ? Taken::What::kWindow : Taken::What::kDoorway});
  }
}

void FreeRoom::take(const PlacedObject& object, const CatalogEntry& entry) {
  if (entry.thin && object.size.height <= kRug) return;
  const bool stands = object.mount != Mount::kWall && object.mount != Mount::kCeiling;
  taken_.push_back({box_round(object), stands ? Taken::What::kStands : Taken::What::kHangs, object.id});
}

const DressedWall* FreeRoom::next(const DressedWall& wall) const {
  const auto follows = [&](const DressedWall& other) {
    return other.start == wall.wall->end && wall.along_x * other.along_y - wall.along_y * other.along_x == 1;
  };
  const auto found = std::ranges::find_if(walls_, follows);
  return found == walls_.end() ? nullptr : &*found;
}

const DressedWall* FreeRoom::previous(const DressedWall& wall) const {
  const auto leads_to = [&](const DressedWall& other) { return next(other) == &wall; };
  const auto found = std::ranges::find_if(walls_, leads_to);
  return found == walls_.end() ? nullptr : &*found;
}

const DressedWall* FreeRoom::opposite(const DressedWall& wall) const {
  const DressedWall* beside = next(wall);
  return beside == nullptr ? nullptr : next(*beside);
}

const DressedWall* FreeRoom::behind(const PlacedObject& object, double reach) const {
  const RoomBox box = box_round(object);
  for (const DressedWall& wall : walls_) {
    const Span along = wall.along(box), off = wall.off(box);
    const bool turned = std::abs(normalized_degrees(object.rotation_deg - wall.turn_deg)) < 1;
    if (turned && off.low > -kRug && off.low <= reach && along.high > 0 && along.low < wall.length) return &wall;
  }
  return nullptr;
}

bool FreeRoom::inside(const RoomBox& box) const {
  const std::vector<Point>& polygon = layout_->room.polygon;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (passes(polygon[i], polygon[(i + 1) % polygon.size()], box)) return false;
  }
  return contains(polygon, (box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2) && box.z1 <= layout_->room.height;
}

bool FreeRoom::is_free(const RoomBox& box, bool window) const {
  const auto in_the_way = [&](const Taken& taken) { return !(window && taken.what == Taken::What::kWindow) && overlap(taken.box, box); };
  return inside(box) && std::ranges::none_of(taken_, in_the_way);
}

bool FreeRoom::is_free(const RoomBox& box, const std::vector<std::string>& but) const {
  const auto in_the_way = [&](const Taken& taken) { return std::ranges::find(but, taken.id) == but.end() && overlap(taken.box, box); };
  return inside(box) && std::ranges::none_of(taken_, in_the_way);
}

bool FreeRoom::counts(Taken::What what, Count count) {
  if (count == Count::kThings) return what == Taken::What::kStands || what == Taken::What::kHangs;
  return count == Count::kAll || what == Taken::What::kStands || what == Taken::What::kDoorway;
}

std::vector<Span> FreeRoom::free_along(const DressedWall& wall, Span off, Span height, Count count) const {
  std::vector<Span> blocked;
  const RoomBox strip = wall.box({0, wall.length}, off, height);
  for (const Taken& taken : taken_) {
    if (counts(taken.what, count) && overlap(taken.box, strip)) blocked.push_back(wall.along(taken.box));
  }
  const std::vector<Point>& polygon = layout_->room.polygon;
  for (std::size_t i = 0; i < polygon.size(); ++i) {  // where the room is narrower
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if (passes(a, b, strip))
      blocked.push_back(wall.along(
          {double(std::min(a.x, b.x)), double(std::min(a.y, b.y)), 0, double(std::max(a.x, b.x)), double(std::max(a.y, b.y)), 0}));
  }
  std::ranges::sort(blocked, {}, &Span::low);
  std::vector<Span> free;
  double from = 0;
  for (const Span& span : blocked) {
    if (span.low > from + kTouch) free.push_back({from, std::min(span.low, wall.length)});
    from = std::max(from, span.high);
  }
  if (wall.length > from + kTouch) free.push_back({from, wall.length});
  return free;
}

std::vector<Span> without(const std::vector<Span>& spans, const Span& gap) {
  std::vector<Span> rest;
  for (const Span& span : spans) {
    if (span.low < gap.low) rest.push_back({span.low, std::min(span.high, gap.low)});
    if (span.high > gap.high) rest.push_back({std::max(span.low, gap.high), span.high});
  }
  return rest;
}

std::vector<Span> shared(const std::vector<Span>& a, const std::vector<Span>& b) {
  std::vector<Span> both;
  for (const Span& one : a) {
    for (const Span& other : b) {
      const Span span{std::max(one.low, other.low), std::min(one.high, other.high)};
      if (span.length() > kTouch) both.push_back(span);
    }
  }
  return both;
}

}  // namespace layoutbox::dressing
