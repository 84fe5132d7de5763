#include "layoutbox/edit/changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "layoutbox/catalog/word_lists.h"

namespace layoutbox {
namespace {

constexpr double kLittle = 300;

// The point of an object, opening or wall that lies nearest to (x, y), and how far apart the two then are for a body of that radius.
std::optional<std::array<double, 2>> place_of(const Layout& layout, const std::string& id, double x, double y) {
  if (const PlacedObject* object = layout.find_object(id)) return std::array<double, 2>{object->position[0], object->position[1]};
  const Opening* opening = layout.find_opening(id);
  const Wall* wall = layout.find_wall(opening != nullptr ? opening->wall : id);
  if (wall == nullptr) return std::nullopt;
  const double dx = wall->end.x - wall->start.x, dy = wall->end.y - wall->start.y, length = std::max(std::hypot(dx, dy), 1.0);
  double along = ((x - wall->start.x) * dx + (y - wall->start.y) * dy) / length;
  if (opening != nullptr && opening->offset) along = *opening->offset + opening->width / 2.0;
  along = std::clamp(along, 0.0, length);
  return std::array<double, 2>{wall->start.x + dx / length * along, wall->start.y + dy / length * along};
}

// "round", "oval": a word for the form, where the others say colour and material.
bool is_form(const std::string& attribute) {
  for (const WordList::Member word : word_list("words_attributes").at("shape")) {
    if (word.value.text() == attribute) return true;
  }
  return false;
}

// Those for the form, or the others.
std::set<std::string> words_of(const std::vector<std::string>& attributes, bool form) {
  std::set<std::string> words;
  for (const std::string& attribute : attributes) {
    if (is_form(attribute) == form) words.insert(attribute);
  }
  return words;
}

bool differs(double a, double b) { return std::abs(a - b) > 0.5; }

// The room, its doors and windows.
std::vector<ObjectChange> changes_of_room(const Layout& before, const Layout& after, const std::set<std::string>& asked) {
  std::vector<ObjectChange> changes;
  const std::string room(kEditRoom);
  const bool same_shape = before.room.height == after.room.height &&
                          std::equal(before.room.polygon.begin(), before.room.polygon.end(), after.room.polygon.begin(),
                                     after.room.polygon.end(), [](const Point& a, const Point& b) { return a.x == b.x && a.y == b.y; });
  if (!same_shape) changes.push_back({room, {"resized"}, 0, 0, asked.contains(room)});
  const auto painted = [&](std::string_view part, bool is) {
    const std::string id(part);
    if (is) changes.push_back({id, {"recolored"}, 0, 0, asked.contains(id)});
  };
  bool walls = before.room.wall_material != after.room.wall_material;
  for (const Wall& now : after.room.walls) {
    const Wall* was = before.find_wall(now.id);
    const bool differs = was != nullptr && was->material != now.material;
    painted(now.id, differs && asked.contains(now.id));
    walls = walls || (differs && !asked.contains(now.id));
  }
  painted(kEditWalls, walls);
  painted(kEditFloor, before.room.floor_material != after.room.floor_material);
  painted(kEditCeiling, before.room.ceiling_material != after.room.ceiling_material);
  for (const Opening& now : after.room.openings) {
    ObjectChange change{now.id, {}, 0, 0, asked.contains(now.id)};
    const Opening* was = before.find_opening(now.id);
    if (was == nullptr) {
      change.what = {"added"};
      changes.push_back(std::move(change));
      continue;
    }
    const auto from = place_of(before, was->id, 0, 0), to = place_of(after, now.id, 0, 0);
    if (from && to) change.metres = m_from_mm(std::hypot((*to)[0] - (*from)[0], (*to)[1] - (*from)[1], now.sill - was->sill));
    if (change.metres > 0.0005) change.what.emplace_back("moved");
    if (now.width != was->width || now.height != was->height) change.what.emplace_back("resized");
    if (!change.what.empty()) changes.push_back(std::move(change));
  }
  for (const Opening& was : before.room.openings) {
    if (after.find_opening(was.id) == nullptr) changes.push_back({was.id, {"removed"}, 0, 0, asked.contains(was.id)});
  }
  return changes;
}

}  // namespace

Result<std::array<double, 3>> way_of(const PlacedObject& placed, const EditShift& shift, const Layout& layout, bool placed_before) {
  using Way = EditShift::Way;
  if (!placed_before) return fail(ErrorCode::kGeometry, fmt::format("{} has no place yet that it could be moved from", placed.id), "text");
  const double distance = shift.distance ? *shift.distance : kLittle;
  switch (shift.way) {
    case Way::kLeft: return std::array<double, 3>{-distance, 0, 0};
    case Way::kRight: return std::array<double, 3>{distance, 0, 0};
    case Way::kFront: return std::array<double, 3>{0, -distance, 0};
    case Way::kBack: return std::array<double, 3>{0, distance, 0};
    case Way::kUp:
    case Way::kDown:
      if (placed.mount != Mount::kWall) {
        return fail(ErrorCode::kGeometry, fmt::format("{} does not hang on a wall, and can go neither up nor down", placed.id), "text");
      }
      return std::array<double, 3>{0, 0, shift.way == Way::kUp ? distance : -distance};
    case Way::kTowards:
    case Way::kAway: break;
  }
  const auto to = place_of(layout, shift.reference, placed.position[0], placed.position[1]);
  if (!to || shift.reference == placed.id)
    return fail(ErrorCode::kReference, fmt::format("{} is nothing to go towards", shift.reference), "text");
  const double dx = (*to)[0] - placed.position[0], dy = (*to)[1] - placed.position[1], far = std::hypot(dx, dy);
  if (far < 1) return fail(ErrorCode::kGeometry, fmt::format("{} is there already", placed.id), "text");
  double step = shift.way == Way::kTowards ? distance : -distance;
  if (!shift.distance && shift.way == Way::kTowards) step = far / 2;
  return std::array<double, 3>{dx / far * step, dy / far * step, 0};
}

void take_place(PlacedObject& placed, const PlacedObject& other) {
  // The back's middle is the centre and half the depth against the front's direction (the front looks to −y at rotation 0).
  const double turn = radians_from_degrees(other.rotation_deg);
  const double more = (other.size.depth - placed.size.depth) / 2.0;
  placed.position = {other.position[0] - std::sin(turn) * more, other.position[1] + std::cos(turn) * more, other.position[2]};
  placed.rotation_deg = other.rotation_deg;
  placed.supported_by = other.supported_by;
  placed.mount = other.mount;
}

std::optional<Side> side_looked_at(double rotation_deg) {
  const double turn = normalized_degrees(rotation_deg);
  constexpr std::array<Side, 4> kSides = {Side::kFront, Side::kRight, Side::kBack, Side::kLeft};
  const double quarter = std::round(turn / 90);
  if (std::abs(turn - quarter * 90) > 0.01) return std::nullopt;
  return kSides[static_cast<std::size_t>(quarter) % 4];
}

std::vector<ObjectChange> changes_between(const Layout& before, const Layout& after, const std::set<std::string>& asked) {
  std::vector<ObjectChange> changes = changes_of_room(before, after, asked);
  for (const PlacedObject& now : after.objects) {
    ObjectChange change;
    change.id = now.id;
    change.asked = asked.contains(now.id);
    const PlacedObject* was = before.find_object(now.id);
    if (was == nullptr) {
      change.what = {"added"};
      changes.push_back(std::move(change));
      continue;
    }
    double square = 0;
    bool moved = false;
    for (std::size_t i = 0; i < 3; ++i) {
      square += (now.position[i] - was->position[i]) * (now.position[i] - was->position[i]);
      moved = moved || differs(now.position[i], was->position[i]);
    }
    change.metres = m_from_mm(std::sqrt(square));
    change.degrees = normalized_degrees(now.rotation_deg - was->rotation_deg);
    if (change.degrees > 180) change.degrees -= 360;
    if (moved) change.what.emplace_back("moved");
    if (std::abs(change.degrees) > 0.01) change.what.emplace_back("turned");
    if (!(now.size == was->size)) change.what.emplace_back("resized");
    if (words_of(now.attributes, true) != words_of(was->attributes, true)) change.what.emplace_back("reshaped");
    if (words_of(now.attributes, false) != words_of(was->attributes, false) || now.material != was->material)
      change.what.emplace_back("recolored");
    if (now.name != was->name) change.what.emplace_back("renamed");
    if (!change.what.empty()) changes.push_back(std::move(change));
  }
  for (const PlacedObject& was : before.objects) {
    if (after.find_object(was.id) == nullptr) changes.push_back({was.id, {"removed"}, 0, 0, asked.contains(was.id)});
  }
  return changes;
}

}  // namespace layoutbox
