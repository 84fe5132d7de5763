// A layout drawn by chance in which everything stands where it can.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "layoutbox/verify/checks.h"
#include "synthetic_draft.h"

namespace layoutbox::synthetic {
namespace {

Relation relation_of(RelationType type, const std::string& target, const std::string& reference) {
  Relation relation;
  relation.id = "s" + target;
  relation.type = type, relation.targets = {target}, relation.references = {reference};
  return relation;
}

class Planter {
 public:
  explicit Planter(Draft& draft) : random_(draft.random), scene_(draft.scene), layout_(draft.layout) {}

  void run(int wanted) {
    std::vector<const CatalogEntry*> entries;
    for (int i = 0; i < wanted; ++i) entries.push_back(&draw_entry(random_));
    // What others stand on comes first.
    std::stable_sort(entries.begin(), entries.end(), [](const CatalogEntry* a, const CatalogEntry* b) { return a->mount < b->mount; });
    for (const CatalogEntry* entry : entries) {
      for (int attempt = 0; attempt < 40; ++attempt) {
        if (plant(*entry)) break;
      }
    }
    if (random_.chance(40)) seat_chairs();
  }

 private:
  // Chairs at the sides of something that has room below, pushed under it or a little off.
  void seat_chairs() {
    const CatalogEntry* chair = Catalog::builtin().find("chair");
    const std::vector<PlacedObject> hosts = layout_.objects;
    for (const PlacedObject& host : hosts) {
      const bool hollow = std::any_of(host.spaces.begin(), host.spaces.end(), [](const Space& space) { return !space.carries; });
      if (chair == nullptr || !hollow || host.mount != Mount::kFloor) continue;
      const int pushed_in = random_.number(-30, 20) * 10;
      for (int quarter = 0; quarter < 4; ++quarter) {
        if (random_.chance(60)) plant(*chair, [&](PlacedObject& placed) { return put_at_side(placed, host, quarter, pushed_in); });
      }
      return;
    }
  }

  bool put_at_side(PlacedObject& placed, const PlacedObject& host, int quarter, int pushed_in) {
    const checks::Frame frame = checks::frame_at(host.rotation_deg + 90.0 * quarter);
    const double reach = (quarter % 2 == 0 ? host.size.depth : host.size.width) / 2.0 + placed.size.depth / 2.0 - pushed_in;
    placed.rotation_deg = normalized_degrees(host.rotation_deg + 90.0 * quarter + 180);
    placed.position = {host.position[0] - frame.y.x * reach, host.position[1] - frame.y.y * reach, 0};
    return true;
  }

  // In line with an object that is there, at its left, right, front or back.
  bool put_beside(PlacedObject& placed) {
    const PlacedObject& other = random_.one_of(layout_.objects);
    if (other.mount != Mount::kFloor) return false;
    const int gap = random_.number(0, 8) * 100;
    const checks::Frame frame = checks::frame_at(other.rotation_deg);
    const bool sideways = random_.chance(60);
    const double reach = (sideways ? other.size.width + placed.size.width : other.size.depth + placed.size.depth) / 2.0 + gap;
    const checks::Vec2d way = (sideways ? frame.x : frame.y) * (random_.chance(50) ? reach : -reach);
    placed.rotation_deg = other.rotation_deg;
    placed.position = {other.position[0] + way.x, other.position[1] + way.y, 0};
    return true;
  }

  bool plant(const CatalogEntry& entry, const std::function<bool(PlacedObject&)>& put = {}) {
    const SceneObject object = object_of(scene_, entry);
    PlacedObject placed;
    placed.id = object.id, placed.category = object.category, placed.name = object.name;
    placed.size = object.size->usual, placed.mount = entry.mount, placed.used_sides = entry.used_sides;
    placed.spaces = spaces_at(entry, placed.size);
    std::optional<Relation> support;
    if (placed.size.height > layout_.room.height) return false;  // a climbing rope in a low room
    if (put && !put(placed)) return false;
    if (!put) switch (entry.mount) {
        case Mount::kFloor: put_on_floor(placed, entry); break;
        case Mount::kCeiling:
          put_on_floor(placed, entry);
          placed.position[2] = layout_.room.height - placed.size.height;
          placed.supported_by = "ceiling";
          break;
        case Mount::kWall:
          if (!put_on_wall(placed)) return false;
          support = relation_of(RelationType::kOnWall, placed.id, placed.supported_by);
          break;
        case Mount::kSurface:
          if (!put_on_host(placed)) return false;
          support = relation_of(stands_inside(placed) ? RelationType::kIn : RelationType::kOn, placed.id, placed.supported_by);
          break;
        case Mount::kHung: return false;
      }
    layout_.objects.push_back(placed);
    if (!possible()) {
      layout_.objects.pop_back();
      return false;
    }
    scene_.objects.push_back(object);
    if (support) scene_.relations.push_back(*support);
    return true;
  }

  static bool across(double rotation) { return rotation == 90 || rotation == 270; }

  Mm width_of_room() const {
    return largest([](Point p) { return p.x; });
  }
  Mm depth_of_room() const {
    return largest([](Point p) { return p.y; });
  }
  template <class Key>
  Mm largest(Key key) const {
    Mm most = 0;
    for (const Point p : layout_.room.polygon) most = std::max(most, key(p));
    return most;
  }

  // A place of the 1 cm grid at which a length fits into [0, whole], as a middle.
  double middle_within(Mm length, Mm whole) { return length / 2.0 + 10.0 * random_.number(0, std::max(0, (whole - length) / 10)); }

  void put_on_floor(PlacedObject& placed, const CatalogEntry& entry) {
    placed.rotation_deg = random_.number(0, 3) * 90;
    if (!layout_.objects.empty() && random_.chance(40) && put_beside(placed)) return;
    if (entry.back_to_wall || random_.chance(30)) {
      if (put_on_wall(placed)) placed.supported_by = "floor", placed.position[2] = 0;
      return;
    }
    const bool turned = across(placed.rotation_deg);
    placed.position = {middle_within(turned ? placed.size.depth : placed.size.width, width_of_room()),
                       middle_within(turned ? placed.size.width : placed.size.depth, depth_of_room()), 0};
  }

  bool put_on_wall(PlacedObject& placed) {
    const Wall& wall = random_.one_of(layout_.room.walls);
    const double dx = wall.end.x - wall.start.x, dy = wall.end.y - wall.start.y, length = std::hypot(dx, dy);
    if (length < placed.size.width) return false;
    const double along = middle_within(placed.size.width, static_cast<Mm>(length)), in = placed.size.depth / 2.0;
    const double ux = dx / length, uy = dy / length;
    placed.position = {wall.start.x + ux * along - uy * in, wall.start.y + uy * along + ux * in,
                       10.0 * random_.number(90, std::max(90, (layout_.room.height - placed.size.height) / 10))};
    // Its back looks out of the room, which lies on the wall's left: out is (uy, −ux), and the back of an unturned object (0, 1).
    placed.rotation_deg = normalized_degrees(std::round(std::atan2(-uy, -ux) * 180 / kPi));
    placed.supported_by = wall.id;
    return placed.mount != Mount::kWall || !before_opening(placed, wall);
  }

  bool before_opening(const PlacedObject& placed, const Wall& wall) const {
    const double at = std::hypot(placed.position[0] - wall.start.x, placed.position[1] - wall.start.y);
    return std::any_of(layout_.room.openings.begin(), layout_.room.openings.end(), [&](const Opening& opening) {
      return opening.wall == wall.id && at + placed.size.width > *opening.offset &&
             at - placed.size.width < *opening.offset + opening.width;
    });
  }

  bool put_on_host(PlacedObject& placed) {
    if (layout_.objects.empty()) return false;
    const PlacedObject host = random_.one_of(layout_.objects);
    if (host.mount != Mount::kFloor) return false;
    // The floor it gets, in the host's frame: its top, or the floor of one of its spaces.
    Space floor{"",
                {-host.size.width / 2.0, -host.size.depth / 2.0, 0.0 + host.size.height},
                {host.size.width / 2.0, host.size.depth / 2.0, 1e6},
                true};
    if (!host.spaces.empty() && random_.chance(60))
      floor = random_.one_of(host.spaces);
    else if (!Catalog::builtin().entry_or_nearest(host.category).top_carries)
      return false;
    const Mm width = static_cast<Mm>(floor.max[0] - floor.min[0]), depth = static_cast<Mm>(floor.max[1] - floor.min[1]);
    if (!floor.carries || placed.size.width > width || placed.size.depth > depth || placed.size.height > floor.max[2] - floor.min[2])
      return false;
    const double x = middle_within(placed.size.width, width) + floor.min[0], y = middle_within(placed.size.depth, depth) + floor.min[1];
    const checks::Frame frame = checks::frame_at(host.rotation_deg);
    placed.rotation_deg = host.rotation_deg;
    placed.position = {host.position[0] + frame.x.x * x + frame.y.x * y, host.position[1] + frame.x.y * x + frame.y.y * y,
                       host.position[2] + floor.min[2]};
    placed.supported_by = host.id;
    return true;
  }

  // Stands in a space of its host rather than on its top.
  bool stands_inside(const PlacedObject& placed) const {
    const PlacedObject* host = layout_.find_object(placed.supported_by);
    return host != nullptr && placed.position[2] < host->position[2] + host->size.height &&
           placed.position[2] + placed.size.height / 2.0 <= host->position[2] + host->size.height;
  }

  // On what one lies or kneels nothing stands, thin as it is: the solver keeps that free.
  bool lies_free() const {
    const auto half = [](const PlacedObject& o, int axis) {
      const bool turned = static_cast<int>(o.rotation_deg) % 180 == 90;
      return ((axis == 0) != turned ? o.size.width : o.size.depth) / 2.0;
    };
    const auto over = [&](const PlacedObject& one, const PlacedObject& other, int axis) {
      const auto at = static_cast<std::size_t>(axis);
      return std::abs(one.position[at] - other.position[at]) < half(one, axis) + half(other, axis);
    };
    return std::ranges::all_of(layout_.objects, [&](const PlacedObject& mat) {
      if (!Catalog::builtin().entry_or_nearest(mat.category).lain_on) return true;
      return std::ranges::none_of(layout_.objects, [&](const PlacedObject& other) {
        const bool stands = other.id != mat.id && other.mount == Mount::kFloor && other.supported_by == "floor";
        return stands && over(mat, other, 0) && over(mat, other, 1);
      });
    });
  }

  // Nothing overlaps, stands in the air, reaches out of the room or stands before an opening.
  bool possible() const {
    if (!lies_free()) return false;
    VerifyOptions strict;
    strict.collision_tolerance_m = strict.support_tolerance_m = 0;
    const checks::RoomView view(layout_, Catalog::builtin(), strict);
    Report report;
    checks::check_collisions(view, report);
    checks::check_bounds(view, report);
    checks::check_support(view, report);
    checks::check_openings(view, report);
    return std::all_of(report.checks.begin(), report.checks.end(),
                       [](const Check& check) { return check.passed && !(check.name == "outOfBounds" && check.value > 1e-9); });
  }

  Random& random_;
  SceneGraph& scene_;
  Layout& layout_;
};

}  // namespace

void plant_objects(Draft& draft, int wanted) { Planter(draft).run(wanted); }

}  // namespace layoutbox::synthetic
