#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <tuple>
#include <utility>

#include "layoutbox/base/words.h"
#include "layoutbox/catalog/normalize_steps.h"
#include "layoutbox/catalog/size_words.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox {

std::vector<Point> room_outline(std::string_view shape, Mm w, Mm d) {
  const Mm x1 = w / 3 / kGridMm * kGridMm, x2 = w - x1, y1 = d / 2 / kGridMm * kGridMm;
  if (shape == "L") return {{0, 0}, {w, 0}, {w, y1}, {x2, y1}, {x2, d}, {0, d}};
  if (shape == "T") return {{x1, 0}, {x2, 0}, {x2, y1}, {w, y1}, {w, d}, {0, d}, {0, y1}, {x1, y1}};
  if (shape == "U") return {{0, 0}, {x1, 0}, {x1, y1}, {x2, y1}, {x2, 0}, {w, 0}, {w, d}, {0, d}};
  if (shape == "round") {  // eight walls: of a regular octagon each corner takes 1 − 1/√2 of a side
    constexpr double kCut = 0.2929;
    const Mm x = static_cast<Mm>(w * kCut) / kGridMm * kGridMm, y = static_cast<Mm>(d * kCut) / kGridMm * kGridMm;
    return {{x, 0}, {w - x, 0}, {w, y}, {w, d - y}, {w - x, d}, {x, d}, {0, d - y}, {0, y}};
  }
  return {{0, 0}, {w, 0}, {w, d}, {0, d}};
}

namespace {

constexpr Mm kSmallestRoom = 500, kLargestRoom = 100'000, kLowestRoom = 500, kHighestRoom = 50'000;
constexpr Size kOrdinaryRoom{4000, 3500, 2600};
constexpr Mm kUnderRidge = 2750;  // of rooms whose ceiling comes down somewhere
// Rooms that are said to be long or wide: the longer side to the shorter one, and how narrow they get.
constexpr double kLong = 2.2, kWide = 1.7, kNarrowest = 1900, kOfUsual = 0.75;

Mm rounded_up(double mm) { return static_cast<Mm>(std::ceil(mm / 100 - 1e-9) * 100); }

double share_of_box(std::string_view shape) {
  constexpr Mm kUnit = 60'000;
  return static_cast<double>(doubled_area(room_outline(shape, kUnit, kUnit))) / 2.0 / (double{kUnit} * kUnit);
}

class RoomNormalizer {
 public:
  explicit RoomNormalizer(NormalizeContext& context) : context_(context), room_(context.scene.room) {}

  void run() {
    const RoomKind* kind = room_.type.empty() ? nullptr : context_.catalog.find_room(room_.type);
    usual_ = kind != nullptr ? kind->usual_size : kOrdinaryRoom;
    if (kind != nullptr) room_.type = kind->id;
    settle_openings_walls();
    settle_outline();
    settle_height();
    if (!context_.errors.empty()) return;
    move_to_origin();
    check_extent();
    if (!context_.errors.empty()) return;
    settle_wall_looks();
    normalize_openings(context_);
  }

 private:
  // Openings name their wall by its id, so that a wall that is turned takes them with it.
  void settle_openings_walls() {
    for (Opening& opening : room_.openings) {
      if (const Wall* wall = context_.scene.find_wall(opening.wall); wall != nullptr && !opening.wall.empty()) opening.wall = wall->id;
    }
  }

  void settle_outline() {
    if (room_.shape == "round" && room_.walls.empty()) context_.note("filled", "a round room is made of eight walls", "/room/shape");
    if (context_.options.room_size.width > 0 && context_.options.room_size.depth > 0) {
      if (!room_.polygon.empty() || !room_.walls.empty())
        context_.note("contradiction", "the size given for the room replaces the scene's own", "/room");
      room_.walls.clear();
      room_.polygon = room_outline(room_.shape, context_.options.room_size.width, context_.options.room_size.depth);
    }
    if (!room_.walls.empty()) {
      outline_from_walls();
    } else {
      if (room_.polygon.empty()) room_.polygon = chosen_outline();
      auto polygon = tidy_polygon(room_.polygon);
      if (!polygon) {
        context_.errors.push_back(std::move(polygon).error());
        return;
      }
      room_.polygon = std::move(*polygon);
      room_.walls = walls_along(room_.polygon);
      for (Wall& wall : room_.walls) wall.id = free_wall_id(wall.id);
    }
  }

  // Walls that nobody named give way to a thing that is called so.
  std::string free_wall_id(std::string id) const {
    const auto taken = [&](const std::string& name) {
      return std::ranges::any_of(context_.scene.objects, [&](const SceneObject& object) { return same_name(object.id, name); }) ||
             std::ranges::any_of(room_.openings, [&](const Opening& opening) { return same_name(opening.id, name); });
    };
    while (taken(id)) id = "room_" + id;
    return id;
  }

  void outline_from_walls() {
    if (complete_rectangle(room_)) context_.note("filled", "walls are missing: the rectangle is completed", "/room/walls");
    auto walls = walls_in_ring(room_.walls, room_.openings);
    if (!walls) {
      Error error = std::move(walls).error();
      if (error.details.empty())
        context_.errors.push_back(std::move(error));
      else
        std::ranges::move(error.details, std::back_inserter(context_.errors));
      return;
    }
    room_.walls = std::move(*walls);
    const std::vector<Point> given = std::move(room_.polygon);
    room_.polygon.clear();
    for (const Wall& wall : room_.walls) room_.polygon.push_back(wall.start);
    if (!given.empty() && std::llabs(doubled_area(given)) != doubled_area(room_.polygon)) {
      context_.note("contradiction", "the walls and the room's dims or polygon differ: the walls are believed", "/room/walls");
    }
  }

  std::vector<Point> chosen_outline() {
    double w = usual_.width, d = usual_.depth;
    double share = share_of_box(room_.shape);
    if (!(share > 0)) share = 1;
    std::string reason = room_.type.empty() ? "an ordinary room" : fmt::format("an ordinary {}", room_.type);
    if (room_.area_m2 && *room_.area_m2 > 0) {
      const double factor = std::sqrt(*room_.area_m2 * 1e6 / (w * d * share));
      w = std::round(w * factor / kGridMm) * kGridMm;
      d = std::round(*room_.area_m2 * 1e6 / share / w / kGridMm) * kGridMm;
      reason = fmt::format("an area of {:.4g} m²", *room_.area_m2);
    } else {
      const double scale = std::sqrt(room_size_factor(room_.size_word));
      w *= scale;
      d *= scale;
      if (scale != 1) reason = fmt::format("\"{}\"", room_.size_word);
      const double grown = growth_for_furniture(context_, w * d * share, std::max(w, d));
      const FloorSides sides = grown_for_distances(context_, {w * grown, d * grown});
      const double more = context_.options.room_growth, factor = sides.width * sides.depth / (w * d) * more * more;
      if (factor > 1.001) reason += ", grown to hold its furniture";
      if (factor < 0.999) reason += ", smaller as little stands in it";
      w = rounded_up(sides.width * more);
      d = rounded_up(sides.depth * more);
    }
    std::tie(w, d) = formed(w, d);
    context_.note("filled", fmt::format("the room's size is not given: {} x {} for {}", metres_text(w), metres_text(d), reason),
                  "/room/dims");
    return room_outline(room_.shape, static_cast<Mm>(std::min(w, 1e6)), static_cast<Mm>(std::min(d, 1e6)));
  }

  // The same floor in the form that the room is said to have: long ones are entered at a narrow end.
  std::pair<double, double> formed(double w, double d) const {
    const double area = w * d, even = std::round(std::sqrt(area) / kGridMm) * kGridMm;
    if (room_.shape == "square" || room_.shape == "round") return {even, even};
    if (room_.shape != "long" && room_.shape != "wide") return {w, d};
    const double narrow = std::max(std::sqrt(area / (room_.shape == "long" ? kLong : kWide)),
                                   std::min({kNarrowest, even, kOfUsual * std::min(usual_.width, usual_.depth)}));
    const double shorter = std::round(narrow / kGridMm) * kGridMm, longer = std::round(area / shorter / kGridMm) * kGridMm;
    return room_.shape == "long" ? std::pair{shorter, longer} : std::pair{longer, shorter};
  }

  void settle_height() {
    if (context_.options.room_size.height > 0) room_.height = context_.options.room_size.height;
    if (room_.height != 0) return;
    room_.height = std::max(usual_.height, has_slopes() ? kUnderRidge : 0);
    context_.note("filled", fmt::format("the room's height is not given: {}", metres_text(room_.height)), "/room/dims/h");
  }

  bool has_slopes() const {
    return std::ranges::any_of(context_.scene.objects, [&](const SceneObject& object) {
      return context_.catalog.entry_or_nearest(object.category).is(Trait::kRoofSlope);
    });
  }

  // The frame's origin is the front-left corner of the box round the room.
  void move_to_origin() {
    Point low = room_.polygon.front();
    for (const Point corner : room_.polygon) low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
    if (low == Point{}) return;
    for (Point& corner : room_.polygon) corner = {corner.x - low.x, corner.y - low.y};
    for (Wall& wall : room_.walls) {
      wall.start = {wall.start.x - low.x, wall.start.y - low.y};
      wall.end = {wall.end.x - low.x, wall.end.y - low.y};
    }
    for (SceneObject& object : context_.scene.objects) {
      if (!object.hint.position) continue;
      (*object.hint.position)[0] -= low.x;
      (*object.hint.position)[1] -= low.y;
    }
    context_.note("converted",
                  fmt::format("the origin is moved to the room's front-left corner, by {} and {}", metres_text(low.x), metres_text(low.y)),
                  "/room");
  }

  void check_extent() {
    Point high = room_.polygon.front();
    for (const Point corner : room_.polygon) high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
    const auto check = [&](std::string_view name, Mm value, Mm least, Mm greatest) {
      if (value >= least && value <= greatest) return;
      context_.error(ErrorCode::kGeometry, fmt::format("the room's {} is {}", name, metres_text(value)), "/room",
                     fmt::format("give {} to {}; is the unit right?", metres_text(least), metres_text(greatest)));
    };
    check("width", high.x, kSmallestRoom, kLargestRoom);
    check("depth", high.y, kSmallestRoom, kLargestRoom);
    check("height", room_.height, kLowestRoom, kHighestRoom);
  }

  void settle_wall_looks() {
    for (const auto& [word, material] : room_.wall_looks) {
      const Wall* meant = context_.scene.find_wall(word);
      for (Wall& wall : room_.walls) {
        if (&wall == meant && wall.material.empty()) wall.material = material;
      }
    }
    room_.wall_looks.clear();
  }

  NormalizeContext& context_;
  Room& room_;
  Size usual_;
};

}  // namespace

void normalize_room(NormalizeContext& context) { RoomNormalizer(context).run(); }

}  // namespace layoutbox
