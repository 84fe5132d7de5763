#include "layoutbox/judge/readers/found_room.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "layoutbox/base/words.h"
#include "layoutbox/scene/shell.h"
#include "layoutbox/verify/geometry.h"

namespace layoutbox::readers {
namespace {

constexpr double kFarthest = 1000;  // m
constexpr std::size_t kMostObjects = 2000;
constexpr double kUsualHeight = 2.6;  // m
constexpr double kNear = 0.05;        // m: what is held so near is held by it
constexpr double kFromWall = 0.05;    // m

bool is_sane(double value) { return std::isfinite(value) && std::abs(value) <= kFarthest; }

Mm mm(double metres) { return mm_from_m(metres); }

Status check_numbers(const FoundRoom& found) {
  const auto bad = [](const std::string& of) {
    return fail(ErrorCode::kSchema, fmt::format("{} has a size or a place that is no number of at most {} m", of, kFarthest));
  };
  if (found.objects.size() > kMostObjects) {
    return fail(ErrorCode::kTooLarge, fmt::format("there are {} objects, at most {}", found.objects.size(), kMostObjects));
  }
  if (!is_sane(found.height)) return bad("the room");
  for (const auto& corner : found.polygon) {
    if (!is_sane(corner[0]) || !is_sane(corner[1])) return bad("the floor");
  }
  for (const FoundObject& object : found.objects) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (!is_sane(object.size[i]) || !is_sane(object.position[i])) return bad(object.name);
    }
    if (!std::isfinite(object.rotation_deg)) return bad(object.name);
  }
  for (const FoundOpening& opening : found.openings) {
    for (const double value : {opening.start[0], opening.start[1], opening.end[0], opening.end[1], opening.low, opening.high}) {
      if (!is_sane(value)) return bad("an opening");
    }
  }
  return {};
}

Status add_shell(const FoundRoom& found, std::array<double, 2> origin, Room& room) {
  for (const auto& corner : found.polygon) room.polygon.push_back({mm(corner[0] - origin[0]), mm(corner[1] - origin[1])});
  LAYOUTBOX_ASSIGN(room.polygon, tidy_polygon(std::move(room.polygon)));
  room.walls = walls_along(room.polygon);
  room.height = mm(found.height > 0 ? found.height : kUsualHeight);
  room.type = snake_case(found.type);
  room.openings_given = true;
  return {};
}

// The wall whose line the opening lies nearest to, and its place along it.
void add_opening(const FoundOpening& found, std::array<double, 2> origin, Room& room, std::vector<Note>& notes) {
  using checks::Vec2d;
  const Vec2d a{found.start[0] - origin[0], found.start[1] - origin[1]}, b{found.end[0] - origin[0], found.end[1] - origin[1]};
  const Wall* nearest = nullptr;
  double least = 0.5, offset = 0, width = 0;  // m: farther from every wall it is none of theirs
  for (const Wall& wall : room.walls) {
    const Vec2d start{wall.start.x / 1000.0, wall.start.y / 1000.0}, end{wall.end.x / 1000.0, wall.end.y / 1000.0};
    const double off = std::max(checks::distance_to_segment(a, start, end), checks::distance_to_segment(b, start, end));
    if (off >= least) continue;
    const Vec2d along = (end - start) * (1 / checks::length(end - start));
    const double from = dot(a - start, along), to = dot(b - start, along);
    const double low = std::max(0.0, std::min(from, to)), high = std::min(checks::length(end - start), std::max(from, to));
    if (high - low < 0.05) continue;
    least = off, offset = low, width = high - low, nearest = &wall;
  }
  if (nearest == nullptr) {
    notes.push_back({"ignored", fmt::format("the opening {} lies at no wall of the room", found.id), {}});
    return;
  }
  Opening opening;
  opening.id = found.id;
  opening.type = found.type;
  opening.wall = nearest->id;
  opening.offset = mm(offset);
  opening.width = mm(width);
  opening.sill = found.type == OpeningType::kDoor ? 0 : mm(std::max(0.0, found.low));
  opening.height = std::max(100, std::min(room.height, mm(found.high)) - opening.sill);
  opening.swing = found.swing;
  room.openings.push_back(std::move(opening));
}

std::string unique_id(std::string wanted, std::set<std::string>& taken) {
  if (wanted.empty()) wanted = "object";
  std::string id = wanted;
  for (int i = 2; !taken.insert(id).second; ++i) id = fmt::format("{}_{}", wanted, i);
  return id;
}

checks::Polygon footprint(const PlacedObject& object) {
  return checks::make_box({object.position[0], object.position[1]}, object.size.width, object.size.depth, {},
                          checks::frame_at(object.rotation_deg))
      .plan;
}

const Space* space_that_holds(const PlacedObject& below, const PlacedObject& object) {
  const checks::Frame frame = checks::frame_at(below.rotation_deg);
  const checks::Vec2d off = checks::Vec2d{object.position[0], object.position[1]} - checks::Vec2d{below.position[0], below.position[1]};
  const double x = dot(off, frame.x), y = dot(off, frame.y);
  for (const Space& space : below.spaces) {
    const bool over = x >= space.min[0] && x <= space.max[0] && y >= space.min[1] && y <= space.max[1];
    if (space.carries && over && std::abs(object.position[2] - below.position[2] - space.min[2]) <= kNear * 1000) return &space;
  }
  return nullptr;
}

// The object whose top, or a space of which, is right under this one's middle.
const PlacedObject* object_under(const Layout& layout, const PlacedObject& object) {
  const PlacedObject* best = nullptr;
  double least = kNear * 1000;
  for (const PlacedObject& below : layout.objects) {
    if (&below == &object || below.size.height <= 30) continue;
    if (!checks::contains(footprint(below), {object.position[0], object.position[1]})) continue;
    if (space_that_holds(below, object)) return &below;
    const double gap = std::abs(object.position[2] - below.position[2] - below.size.height);
    if (gap > least) continue;
    least = gap;
    best = &below;
  }
  return best;
}

const Wall* wall_at(const Layout& layout, const PlacedObject& object) {
  const checks::Polygon plan = footprint(object);
  const Wall* best = nullptr;
  double least = kFromWall * 1000;
  for (const Wall& wall : layout.room.walls) {
    const checks::Polygon face{{double(wall.start.x), double(wall.start.y)}, {double(wall.end.x), double(wall.end.y)}};
    const double off = checks::distance(plan, face);
    if (off > least) continue;
    least = off;
    best = &wall;
  }
  return best;
}

// Things held by nothing keep what their kind is held by, so that the fault is found.
void guess_support(const Layout& layout, const CatalogEntry& entry, PlacedObject& object) {
  const double under = object.position[2], over = layout.room.height - under - object.size.height;
  if (std::abs(under) <= kNear * 1000) {
    object.mount = Mount::kFloor;
    object.supported_by = "floor";
    return;
  }
  if (const PlacedObject* below = object_under(layout, object)) {
    object.mount = Mount::kSurface;
    object.supported_by = below->id;
    return;
  }
  if (entry.mount == Mount::kCeiling || std::abs(over) <= kNear * 1000) {
    object.mount = Mount::kCeiling;
    object.supported_by = "ceiling";
    return;
  }
  const Wall* wall = wall_at(layout, object);
  if (wall != nullptr || entry.mount == Mount::kWall) {
    object.mount = Mount::kWall;
    object.supported_by = wall ? wall->id : "wall";
    return;
  }
  object.mount = Mount::kFloor;
  object.supported_by = "floor";
}

PlacedObject placed(const FoundObject& found, std::array<double, 2> origin, const Catalog& catalog, std::set<std::string>& ids) {
  PlacedObject object;
  object.name = words_in(found.name);
  const CatalogEntry* known = catalog.find_by_words(object.name);
  object.category = known ? known->id : snake_case(object.name);
  object.id = unique_id(found.id.empty() ? snake_case(object.name) : found.id, ids);
  object.size = {std::max(1, mm(found.size[0])), std::max(1, mm(found.size[1])), std::max(1, mm(found.size[2]))};
  object.position = {(found.position[0] - origin[0]) * 1000, (found.position[1] - origin[1]) * 1000, found.position[2] * 1000};
  object.rotation_deg = normalized_degrees(found.rotation_deg);
  const CatalogEntry& entry = catalog.entry_or_nearest(object.category);
  object.used_sides = entry.used_sides;
  object.spaces = spaces_at(entry, object.size);
  return object;
}

}  // namespace

Result<RoomFile> settle(FoundRoom found, const Catalog& catalog, std::string format) {
  LAYOUTBOX_CHECK(check_numbers(found));
  if (found.polygon.size() < 3) return fail(ErrorCode::kGeometry, "the file says nothing of the room's floor");
  std::array<double, 2> origin = found.polygon[0];
  for (const auto& corner : found.polygon) origin = {std::min(origin[0], corner[0]), std::min(origin[1], corner[1])};
  RoomFile file;
  file.format = std::move(format);
  file.name = found.name;
  file.notes = std::move(found.notes);
  Layout& layout = file.layout;
  layout.prompt = found.prompt;
  LAYOUTBOX_CHECK(add_shell(found, origin, layout.room));
  if (found.height <= 0) {
    file.notes.push_back({"guessed", fmt::format("the height of the room is not said: {:.1f} m", kUsualHeight), {}});
  }
  for (FoundOpening& opening : found.openings) {
    if (opening.id.empty()) opening.id = fmt::format("opening{}", layout.room.openings.size() + 1);
    add_opening(opening, origin, layout.room, file.notes);
  }
  std::set<std::string> ids{"floor", "ceiling", "room", "wall"};
  for (const Wall& wall : layout.room.walls) ids.insert(wall.id);
  for (const Opening& opening : layout.room.openings) ids.insert(opening.id);
  for (const FoundObject& object : found.objects) layout.objects.push_back(placed(object, origin, catalog, ids));
  for (std::size_t i = 0; i < layout.objects.size(); ++i) {
    PlacedObject& object = layout.objects[i];
    if (const std::string& said = found.objects[i].supported_by; !said.empty()) {
      object.supported_by = said;
      object.mount = said == "floor"          ? Mount::kFloor
                     : said == "ceiling"      ? Mount::kCeiling
                     : layout.find_wall(said) ? Mount::kWall
                                              : Mount::kSurface;
    } else {
      guess_support(layout, catalog.entry_or_nearest(object.category), object);
    }
  }
  file.notes.push_back(
      {"guessed", "used sides and inner spaces are those of each object's kind; what holds an object is what is at it", {}});
  return file;
}

}  // namespace layoutbox::readers
