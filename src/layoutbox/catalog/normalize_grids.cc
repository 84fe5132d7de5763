// How many stand in a row of a grid, where nobody says so: as suits the room.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "layoutbox/catalog/normalize_steps.h"
#include "layoutbox/catalog/trait_table.h"

namespace layoutbox {
namespace {

constexpr Point kApart{500, 800}, kSeatsApart{80, 700}, kShelvesApart{0, 1200};
constexpr double kForStage = 2000, kAtEnds = 600;
constexpr double kNotFull = 0.4;  // share of the room that a last row which is not full may cost

Point gaps_between(const CatalogEntry& entry) {
  if (entry.is(Trait::kSeat)) return kSeatsApart;
  return entry.is(Trait::kShelving) ? kShelvesApart : kApart;
}

class GridSettler {
 public:
  explicit GridSettler(NormalizeContext& context) : context_(context), scene_(context.scene) {
    for (const Point corner : scene_.room.polygon) width_ = std::max(width_, double(corner.x)), depth_ = std::max(depth_, double(corner.y));
  }

  // "24 chairs, all facing the whiteboard on the front wall": rows look straight at that wall, not askew past it. "Eight rows of pews on
  // each side of the aisle, the altar at the east wall": pews look at it, though no word says so.
  void look_at_walls() {
    constexpr std::ptrdiff_t kCrowd = 4;
    if (scene_.prompt.empty()) return;
    std::vector<std::pair<std::string, std::string>> looks;  // who leads, the wall
    for (const Relation& r : scene_.relations) {
      if (r.type != RelationType::kFacing || r.targets.size() != 1 || r.references.size() != 1) continue;
      const auto follows = [&](const Relation& other) {
        return other.type == RelationType::kSameOrientation && other.references == r.targets;
      };
      const std::string wall = wall_of(r.references[0]);
      if (!wall.empty() && std::ranges::count_if(scene_.relations, follows) >= kCrowd) looks.emplace_back(r.targets[0], wall);
    }
    for (const Relation& grid : scene_.relations) {
      const std::string wall = wall_they_face(grid);
      if (!wall.empty()) looks.emplace_back(grid.targets[0], wall);
    }
    for (const auto& [leader, wall] : looks) look_straight(leader, wall);
  }

  void settle(Relation& relation) {
    const SceneObject* first = relation.targets.empty() ? nullptr : scene_.find_object(relation.targets[0]);
    if (first == nullptr || !first->size || relation.parameters.gap || width_ <= 0 || depth_ <= 0) return;
    if (relation.parameters.columns)
      lay_along(relation, *first);
    else
      choose(relation, *first);
  }

 private:
  bool told(const Relation& grid, std::initializer_list<RelationType> types) const {
    return std::ranges::any_of(scene_.relations, [&](const Relation& r) {
      return std::ranges::find(types, r.type) != types.end() &&
             std::ranges::any_of(grid.targets, [&](const std::string& id) { return names(r.targets, id); });
    });
  }

  void look_straight(const std::string& leader, const std::string& wall) {
    const auto is_told = [&](const Relation& r) {
      return r.type == RelationType::kFacing && names(r.targets, leader) && r.references == std::vector<std::string>{wall};
    };
    if (std::ranges::any_of(scene_.relations, is_told)) return;
    turn_grids(leader, wall);
    Relation straight;
    straight.id = unused_id(scene_, leader + "_looks_at_" + wall);
    straight.type = RelationType::kFacing;
    straight.targets = {leader};
    straight.references = {wall};
    straight.why = "rows look straight at the wall of what they look at";
    straight.origin = Origin::kConcluded;
    context_.scene.relations.push_back(std::move(straight));
  }

  // Where what such seats look at by their kind is, of a grid that nobody turned; empty: nowhere that is known.
  std::string wall_they_face(const Relation& grid) const {
    const bool turned = told(grid, {RelationType::kFacing, RelationType::kSameOrientation});
    const SceneObject* first =
        grid.type != RelationType::kGrid || turned || grid.targets.empty() ? nullptr : scene_.find_object(grid.targets[0]);
    if (first == nullptr || !grid.parameters.columns || grid.parameters.gap == Mm{0}) return {};  // desks that are pushed together
    const std::vector<std::string>& kinds = context_.catalog.entry_or_nearest(first->category).faces;
    const auto is_faced = [&](const SceneObject& object) {
      return !wall_of(object.id).empty() &&
             std::ranges::any_of(kinds, [&](const std::string& kind) { return context_.catalog.is_a(object.category, kind); });
    };
    const auto faced = std::ranges::find_if(scene_.objects, is_faced);
    return faced == scene_.objects.end() ? std::string{} : wall_of(faced->id);
  }

  // The one wall on which it is said to be; empty: none.
  std::string wall_of(const std::string& object) const {
    for (const Relation& r : scene_.relations) {
      const bool at = r.type == RelationType::kOnWall || r.type == RelationType::kAgainstWall || r.type == RelationType::kCenteredOnWall;
      if (at && r.references.size() == 1 && names(r.targets, object) && scene_.find_object(r.references[0]) == nullptr)
        return r.references[0];
    }
    return {};
  }

  // "in rows of three": abreast, wherever they look.
  void turn_grids(const std::string& leader, const std::string& wall) {
    const auto end = std::ranges::find(scene_.room.walls, wall, &Wall::id);
    if (end == scene_.room.walls.end() || end->start.x != end->end.x) return;
    for (Relation& grid : context_.scene.relations) {
      if (grid.type != RelationType::kGrid || !grid.parameters.columns || *grid.parameters.columns < 1) continue;
      const auto at_it = [&](const Relation& r) {
        return names(r.targets, leader) && r.references.size() == 1 && names(grid.targets, r.references[0]);
      };
      const int n = static_cast<int>(grid.targets.size()), columns = *grid.parameters.columns;
      if (n % columns == 0 && (names(grid.targets, leader) || std::ranges::any_of(scene_.relations, at_it))) transpose(grid, columns);
    }
  }

  // Who is in the middle of a row stays there, as the rows run along the room's depth now.
  static void transpose(Relation& grid, int columns) {
    const std::vector<std::string> before = grid.targets;
    const std::size_t abreast = static_cast<std::size_t>(columns), rows = before.size() / abreast;
    for (std::size_t at = 0; at < before.size(); ++at) grid.targets[at] = before[at % rows * abreast + at / rows];
    grid.parameters.columns = static_cast<int>(rows);
  }

  // Rows of what looks nowhere, or has its back to the walls, run along the longer side of the room, whatever words call a row.
  void lay_along(Relation& grid, const SceneObject& first) const {
    const int n = static_cast<int>(grid.targets.size()), columns = *grid.parameters.columns;
    const CatalogEntry& entry = context_.catalog.entry_or_nearest(first.category);
    const bool at_walls = entry.back_to_wall && told(grid, {RelationType::kAgainstWall});
    if (scene_.prompt.empty() || columns < 1 || n % columns != 0 || (entry.has_front && !at_walls)) return;
    const int rows = n / columns;
    if (rows < 2 || columns < 2 || rows == columns || (columns > rows) == (width_ >= depth_)) return;
    grid.parameters.columns = rows;
    context_.note("filled", fmt::format("the rows of {} run along the longer side of the room", grid.id), "/relations");
  }

  void choose(Relation& grid, const SceneObject& first) {
    const CatalogEntry& entry = context_.catalog.entry_or_nearest(first.category);
    const bool looks = entry.has_front && told(grid, {RelationType::kFacing, RelationType::kSameOrientation});
    const int n = static_cast<int>(grid.targets.size());
    const auto suited = [&](double across, double deep) { return in_row(n, first.size->usual, gaps_between(entry), across, deep); };
    int columns = suited(width_, looks ? depth_ - kForStage : depth_), leader = (columns - 1) / 2;
    // Who looks at something looks along the room.
    if (looks && width_ > depth_) {
      const int abreast = suited(depth_, width_ - kForStage);
      if (abreast > 0 && n % abreast == 0) columns = n / abreast, leader = (abreast - 1) / 2 * columns;
    }
    if (columns == 0) return;
    grid.parameters.columns = columns;
    if (looks) let_lead(grid, grid.targets[static_cast<std::size_t>(leader)]);
  }

  // The one by whom all of them look at something is in the middle: from there it is straight ahead.
  void let_lead(const Relation& grid, const std::string& leader) {
    std::string before;
    for (const Relation& r : scene_.relations) {
      if (r.type != RelationType::kFacing || r.targets.size() != 1 || !names(grid.targets, r.targets[0])) continue;
      if (!before.empty()) return;  // each by itself
      before = r.targets[0];
    }
    if (before.empty() || before == leader) return;
    for (Relation& r : context_.scene.relations) {
      const bool turned = r.type == RelationType::kSameOrientation && r.references == std::vector<std::string>{before};
      if (turned) r.references = {leader};
      if (turned && r.targets == std::vector<std::string>{leader}) r.targets = {before};
      if (r.type == RelationType::kFacing && r.targets == std::vector<std::string>{before}) r.targets = {leader};
    }
  }

  // Shares of the room that they take along both sides should be alike, and rows be full; 0: they do not fit.
  static int in_row(int n, const Size& size, Point gaps, double across, double deep) {
    int best = 0;
    double best_price = 0;
    for (int columns = 1; columns <= n; ++columns) {
      const int rows = (n + columns - 1) / columns;
      const double w = (columns * double(size.width + gaps.x) - gaps.x + kAtEnds) / across,
                   d = (rows * double(size.depth + gaps.y) - gaps.y + kAtEnds) / deep;
      if (w > 1 || d > 1 || (n > 3 && (rows < 2 || columns < 2))) continue;
      const double price = std::abs(w - d) + (n % columns != 0 ? kNotFull : 0);
      if (best == 0 || price < best_price) best = columns, best_price = price;
    }
    return best;
  }

  NormalizeContext& context_;
  const SceneGraph& scene_;
  double width_ = 0, depth_ = 0;
};

}  // namespace

void normalize_grids(NormalizeContext& context) {
  GridSettler settler(context);
  settler.look_at_walls();
  for (Relation& relation : context.scene.relations) {
    if (relation.type == RelationType::kGrid) settler.settle(relation);
  }
}

}  // namespace layoutbox
