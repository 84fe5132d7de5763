#include "layoutbox/verify/room_view.h"

#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/scene/relation_traits.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace layoutbox::checks {
namespace {

// Numbers of a readable layout may be absurd; beyond this they only have to stay numbers.
constexpr double kFarthest = 1e7;  // m

// Exactly the number that stands in the file: reading has turned 2.45 into 2450.0000000000005.
double metres(double millimetres) {
  if (!std::isfinite(millimetres)) return kFarthest;
  return std::round(std::clamp(millimetres, -kFarthest * 1000, kFarthest * 1000) * 1e4) / 1e7;
}

Vec2d metres(Point point) { return {metres(point.x), metres(point.y)}; }

Hollow hollow_of(const Body& body, const Space& space) {
  const auto corner = [&](double x, double y) { return body.shape.center + body.own_frame.x * metres(x) + body.own_frame.y * metres(y); };
  return {space.name,
          {corner(space.min[0], space.min[1]), corner(space.max[0], space.min[1]), corner(space.max[0], space.max[1]),
           corner(space.min[0], space.max[1])},
          {body.underside() + metres(space.min[2]), body.underside() + metres(space.max[2])},
          space.carries};
}

}  // namespace

Shape space_before(const Face& opening) {
  constexpr double kMostBeforeDoor = 1.2;  // as deep as it is wide, but for gates
  return space_before(opening, opening.is_window() ? kWindowDepth : std::min(opening.length, kMostBeforeDoor));
}

Shape space_before(const Face& opening, double depth) {
  return make_box(opening.shape.center + opening.inward * (depth / 2), opening.length, depth, opening.shape.heights, opening.shape.frame);
}

namespace {

constexpr double kAtEdges = 0.005;  // m: at the two straight edges it is no intrusion

// Where a leaf that opens inwards hangs, and the way from there along the wall to its free edge.
struct HingedLeaf {
  Vec2d hinge, towards;
};

std::optional<HingedLeaf> leaf_of(const Face& door) {
  if (door.opening == nullptr) return std::nullopt;
  const Swing swing = door.opening->swing;
  if (door.opening->type != OpeningType::kDoor || (swing != Swing::kInLeft && swing != Swing::kInRight)) return std::nullopt;
  // Looking at the wall from the room, the wall's direction (floor on its left hand) runs to the left.
  const bool at_left_end = swing == Swing::kInLeft;
  const bool end_is_left = dot(door.along, door.shape.frame.x) < 0;
  if (at_left_end == end_is_left) return HingedLeaf{door.end, door.along * -1};
  return HingedLeaf{door.start, door.along};
}

}  // namespace

double swing_intrusion(const Face& door, const Body& body) {
  const std::optional<HingedLeaf> leaf = leaf_of(door);
  if (!leaf || overlap(body.shape.heights, door.shape.heights) <= kAtEdges + kTiny) return 0;
  Polygon swept = clip_half_plane(body.shape.plan, leaf->hinge + leaf->towards * kAtEdges, leaf->towards);
  swept = clip_half_plane(swept, leaf->hinge + door.inward * kAtEdges, door.inward);
  if (swept.size() < 3) return 0;
  return std::max(0.0, door.length - distance(swept, leaf->hinge));
}

Polygon swing_of(const Face& door) {
  constexpr int kSteps = 16;
  const std::optional<HingedLeaf> leaf = leaf_of(door);
  if (!leaf || door.length <= 2 * kAtEdges) return {};
  const Vec2d corner = leaf->hinge + (leaf->towards + door.inward) * kAtEdges;
  Polygon disc{corner};
  for (int i = 0; i <= kSteps; ++i) {
    const double turn = std::acos(-1.0) / 2 * i / kSteps;
    disc.push_back(corner + (leaf->towards * std::cos(turn) + door.inward * std::sin(turn)) * (door.length - kAtEdges));
  }
  if (signed_area(disc) < 0) std::reverse(disc.begin(), disc.end());
  return disc;
}

BodySide side_of(const Body& body, Side side) {
  const Frame& frame = body.own_frame;
  switch (side) {
    case Side::kBack: return {frame.y, frame.x, body.depth / 2, body.width / 2};
    case Side::kLeft: return {frame.x * -1, frame.y, body.width / 2, body.depth / 2};
    case Side::kRight: return {frame.x, frame.y, body.width / 2, body.depth / 2};
    default: return {frame.y * -1, frame.x, body.depth / 2, body.width / 2};
  }
}

RoomView::RoomView(const Layout& of_layout, const Catalog& with_catalog, const VerifyOptions& with_options)
    : layout(of_layout), catalog(with_catalog), options(with_options) {
  height = metres(layout.room.height);
  read_floor();
  read_faces();
  read_bodies();
}

void RoomView::read_floor() {
  for (const Point& point : layout.room.polygon) floor.push_back(metres(point));
  const double area = signed_area(floor);
  if (area < 0) std::reverse(floor.begin(), floor.end());
  if (std::abs(area) < kTiny) floor.clear();
  if (floor.empty()) return;
  const Shape shape{floor, {}, {}, {}};
  floor_x = extent(shape, {1, 0});
  floor_y = extent(shape, {0, 1});
}

void RoomView::read_faces() {
  const auto make_face = [](Vec2d start, Vec2d end, Vec2d inward, Interval heights) {
    Face face;
    face.start = start, face.end = end, face.inward = inward;
    face.length = length(end - start);
    face.along = (end - start) * (1 / face.length);
    const Vec2d out = inward * -1;
    face.shape = {{start, end}, (start + end) * 0.5, heights, {{out.y, -out.x}, out}};
    return face;
  };
  const std::vector<Wall>& all = layout.room.walls;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Vec2d start = metres(all[i].start), end = metres(all[i].end);
    if (length(end - start) < kTiny) continue;
    const Vec2d way = (end - start) * (1 / length(end - start)), left{-way.y, way.x};
    const bool floor_on_left = floor.empty() || contains(floor, (start + end) * 0.5 + left * 0.05);
    walls.push_back(make_face(start, end, floor_on_left ? left : left * -1, {0, height}));
    walls.back().index = i;
    walls.back().id = all[i].id;
  }
  const std::vector<Opening>& holes = layout.room.openings;
  for (std::size_t i = 0; i < holes.size(); ++i) {
    const Face* wall = find_wall(holes[i].wall);
    if (wall == nullptr || holes[i].width <= 0 || !holes[i].offset) {
      unplaced_openings.push_back(holes[i].id);
      continue;
    }
    const Vec2d start = wall->start + wall->along * metres(*holes[i].offset);
    const double sill = metres(holes[i].sill);
    openings.push_back(
        make_face(start, start + wall->along * metres(holes[i].width), wall->inward, {sill, sill + metres(holes[i].height)}));
    openings.back().index = i;
    openings.back().id = holes[i].id;
    openings.back().opening = &holes[i];
    openings.back().wall = wall;
  }
}

void RoomView::read_bodies() {
  for (std::size_t i = 0; i < layout.objects.size(); ++i) {
    const PlacedObject& object = layout.objects[i];
    Body body;
    body.index = i;
    body.object = &object;
    body.entry = &catalog.entry_or_nearest(object.category);
    body.own_frame = frame_at(std::isfinite(object.rotation_deg) ? object.rotation_deg : 0);
    body.width = metres(object.size.width), body.depth = metres(object.size.depth);
    const double underside = metres(object.position[2]);
    body.shape = make_box({metres(object.position[0]), metres(object.position[1])}, body.width, body.depth,
                          {underside, underside + metres(object.size.height)}, body.own_frame);
    body.has_front = body.entry->has_front;
    for (const Space& space : object.spaces) body.hollows.push_back(hollow_of(body, space));
    if (!body.has_front) body.shape.frame = Frame{};
    body.rug = body.entry->thin && metres(object.size.height) <= kRugHeight + kTiny && underside <= kRugHeight;
    body.curtain = body.entry->is(Trait::kCurtain);
    bodies.push_back(std::move(body));
  }
}

const Body* RoomView::find_body(std::string_view id) const {
  const auto found = std::find_if(bodies.begin(), bodies.end(), [&](const Body& body) { return body.id() == id; });
  return found == bodies.end() ? nullptr : &*found;
}

const Face* RoomView::find_wall(std::string_view id_or_word) const {
  const Wall* wall = layout.find_wall(id_or_word);
  for (const Face& face : walls) {
    if (wall == &layout.room.walls[face.index]) return &face;
  }
  return nullptr;
}

const Face* RoomView::find_opening(std::string_view id) const {
  const auto found = std::find_if(openings.begin(), openings.end(), [&](const Face& face) { return face.id == id; });
  return found == openings.end() ? nullptr : &*found;
}

bool RoomView::belongs_to(const Body& other, const Body& body) const {
  const auto names = [](const std::vector<std::string>& ids, const std::string& id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
  };
  return std::any_of(layout.relations.begin(), layout.relations.end(), [&](const PlacedRelation& placed) {
    return traits_of(placed.relation.type).brings && names(placed.relation.targets, other.id()) &&
           names(placed.relation.references, body.id());
  });
}

}  // namespace layoutbox::checks
