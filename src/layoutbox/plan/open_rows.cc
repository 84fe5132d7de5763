#include "layoutbox/plan/open_rows.h"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>

#include "layoutbox/catalog/close_rows.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox {
namespace {

constexpr Mm kDoorwayOfWall = 1200;  // with its leaf, where nobody says in which wall it is
constexpr std::size_t kMostAdded = 36;
constexpr Mm kSeatApart = 80;

class OpenRows {
 public:
  OpenRows(SceneGraph& scene, const SceneGraph& sized, const Catalog& catalog) : scene_(scene), sized_(sized), catalog_(catalog) {}

  std::size_t run(const std::vector<Lining>& linings) {
    const std::size_t before = scene_.objects.size();
    for (const Lining& lining : linings) {
      if (lining.ids.empty() || scene_.find_object(lining.ids.front()) == nullptr) continue;
      const SceneObject* counter = counter_of(scene_, catalog_, lining.ids.front());
      if (lining.open && counter != nullptr)
        fill_counter(lining, counter->id);
      else if (lining.open && names_walls(lining))
        fill_named_walls(lining);
      else
        spread(lining);
    }
    stand_rows();
    return scene_.objects.size() - before;
  }

 private:
  const Relation* at_wall(const std::string& id) const {
    const auto of_it = [&](const Relation& r) { return r.type == RelationType::kAgainstWall && r.targets == std::vector{id}; };
    const auto found = std::ranges::find_if(scene_.relations, of_it);
    return found == scene_.relations.end() ? nullptr : &*found;
  }

  const Wall* wall_of(const Relation& r) const { return r.references.empty() ? nullptr : sized_.find_wall(r.references.front()); }

  bool names_walls(const Lining& lining) const {
    return std::ranges::all_of(lining.ids, [&](const std::string& id) {
      const Relation* r = at_wall(id);
      return r != nullptr && wall_of(*r) != nullptr;
    });
  }

  Size size_of(const std::string& id) const {
    const SceneObject* object = sized_.find_object(id);
    const SceneObject* own = scene_.find_object(id);
    // What became longer for want of others along a wall is one of many here.
    const CatalogEntry* kind = object == nullptr ? nullptr : catalog_.find(object->category);
    const bool stretched =
        kind != nullptr && object->size && object->size->usual.width > kind->size.greatest.width && own != nullptr && !own->size;
    if (stretched && kind->is(Trait::kShelving)) return kind->size.usual;
    if (object != nullptr && object->size) return object->size->usual;
    return own == nullptr ? Size{} : catalog_.entry_or_nearest(own->category).size.usual;
  }

  // What of a wall is free for a row of it: no doorway, nothing else that was told to be there, a corner left to the next wall's row.
  Mm free_of(const Wall& wall, const std::vector<std::string>& row) const {
    Mm free = length_of(wall);
    bool door = false;
    for (const Opening& opening : sized_.room.openings) {
      if (sized_.find_wall(opening.wall) == &wall)
        free -= opening.width + (opening.type == OpeningType::kDoor ? kDoorwayOfWall - opening.width : 0);
      door |= opening.type == OpeningType::kDoor && !opening.wall.empty();
    }
    if (!door && wall_on_side(sized_.room.walls, Side::kFront) == &wall) free -= kDoorwayOfWall;
    for (const Relation& r : scene_.relations) {
      const auto in_row = [&](const std::string& id) { return std::ranges::find(row, id) != row.end(); };
      if (r.references.size() != 1 || sized_.find_wall(r.references.front()) != &wall || std::ranges::any_of(r.targets, in_row)) continue;
      for (const std::string& id : r.targets) {
        const SceneObject* other = sized_.find_object(id);
        if (other != nullptr && other->mount == Mount::kFloor) free -= size_of(id).width;
      }
    }
    return free - size_of(row.front()).depth;
  }

  // "bookshelves along both long walls": as many as each of them has room for.
  void fill_named_walls(const Lining& lining) {
    std::map<const Wall*, std::vector<std::string>> at;
    for (const std::string& id : lining.ids) at[wall_of(*at_wall(id))].push_back(id);
    for (const Wall& wall : sized_.room.walls) {
      const auto row = at.find(&wall);
      if (row == at.end()) continue;
      const Mm width = std::max<Mm>(size_of(row->second.front()).width, 100);
      const auto fit = static_cast<std::size_t>(std::max<Mm>(free_of(wall, lining.ids), 0) / width);
      for (std::size_t n = row->second.size(); n < fit && added_ < kMostAdded; ++n) twin_of(row->second.front());
    }
  }

  // "a long bar with stools in front": as many as sit there at ease.
  void fill_counter(const Lining& lining, const std::string& counter) {
    constexpr Mm kPlace = 700;
    constexpr std::size_t kMostAtCounter = 6;
    const std::size_t fit = std::min(kMostAtCounter, static_cast<std::size_t>(size_of(counter).width / kPlace));
    for (std::size_t n = lining.ids.size(); n < fit; ++n) twin_of(lining.ids.front());
  }

  // Another one of which the same is said.
  std::string twin_of(const std::string& id) {
    SceneObject twin = *scene_.find_object(id);
    int number = 1;
    while (scene_.find_object(twin.category + "_" + std::to_string(number)) != nullptr) ++number;
    twin.id = twin.category + "_" + std::to_string(number);
    twin.origin = Origin::kConcluded;
    std::vector<Relation> also;
    for (const Relation& r : scene_.relations) {
      if (r.targets != std::vector{id}) continue;
      also.push_back(r);
      also.back().id += "+" + twin.id;
      also.back().targets = {twin.id};
      also.back().origin = Origin::kConcluded;
    }
    scene_.objects.push_back(twin);
    scene_.relations.insert(scene_.relations.end(), also.begin(), also.end());
    ++added_;
    return twin.id;
  }

  // What is told to stand in one row stands at one wall.
  bool is_row(const std::vector<std::string>& ids) const {
    return std::ranges::any_of(scene_.relations, [&](const Relation& r) {
      return r.type == RelationType::kRow && r.hard && std::ranges::find(r.targets, ids.front()) != r.targets.end();
    });
  }

  // "ten chairs along the walls", "bookshelves lining the walls": shared out over those that have room for a few.
  void spread(const Lining& lining) {
    if (!lining.open && is_row(lining.ids)) return;
    const CatalogEntry& kind = catalog_.entry_or_nearest(scene_.find_object(lining.ids.front())->category);
    const Mm pitch = std::max<Mm>(size_of(lining.ids.front()).width, 100) + (kind.is(Trait::kSeat) ? kSeatApart : 0);
    struct Part {
      const Wall* wall;
      std::size_t room;
    };
    std::vector<Part> parts;
    for (const Side side : {Side::kBack, Side::kRight, Side::kLeft}) {
      const Wall* wall = wall_on_side(sized_.room.walls, side);
      if (wall != nullptr) parts.push_back({wall, static_cast<std::size_t>(std::max<Mm>(free_of(*wall, lining.ids), 0) / pitch)});
    }
    std::erase_if(parts, [](const Part& part) { return part.room < 2; });
    std::ranges::stable_sort(parts, std::greater{}, &Part::room);
    if (lining.one_wall && parts.size() > 1) parts.erase(parts.begin() + 1, parts.end());
    const auto all = [&] {
      return std::accumulate(parts.begin(), parts.end(), std::size_t{0}, [](auto n, const Part& p) { return n + p.room; });
    };
    // What is counted takes no more walls than it needs: the others are for what else stands in the room.
    while (!lining.open && parts.size() > 2 && (all() - parts.back().room) * 3 / 4 >= lining.ids.size()) parts.pop_back();
    if (parts.empty() || (parts.size() < 2 && !lining.one_wall) || (!lining.open && lining.ids.size() < 2 * parts.size())) return;
    std::vector<std::string> ids = lining.ids;
    while (lining.open && ids.size() < all() && added_ < kMostAdded) ids.push_back(twin_of(ids.front()));
    std::size_t next = 0, before = 0;
    for (const Part& part : parts) {
      before += part.room;
      for (const std::size_t until = ids.size() * before / all(); next < until; ++next) prefer(ids[next], *part.wall);
    }
  }

  // "twelve lockers in one row" stand along the wall that they fill best, where nobody says which.
  void stand_rows() {
    constexpr std::size_t kLong = 4;
    for (std::size_t i = 0; i < scene_.relations.size(); ++i) {
      const Relation row = scene_.relations[i];
      const SceneObject* first = row.targets.empty() ? nullptr : scene_.find_object(row.targets.front());
      if (row.type != RelationType::kRow || row.targets.size() < kLong || first == nullptr || row.parameters.axis) continue;
      const CatalogEntry& kind = catalog_.entry_or_nearest(first->category);
      const auto placed = [&](const Relation& r) { return r.id != row.id && std::ranges::find(r.targets, first->id) != r.targets.end(); };
      if (!stands_close(kind) || std::ranges::any_of(scene_.relations, placed)) continue;
      const Mm length = size_of(first->id).width * static_cast<Mm>(row.targets.size());
      const Wall* best = nullptr;
      for (const Side side : {Side::kBack, Side::kRight, Side::kLeft, Side::kFront}) {
        const Wall* wall = wall_on_side(sized_.room.walls, side);
        if (wall == nullptr || free_of(*wall, row.targets) < length) continue;
        if (best == nullptr || free_of(*wall, row.targets) < free_of(*best, row.targets)) best = wall;
      }
      for (const std::string& id : row.targets) {
        if (best != nullptr) prefer(id, *best);
      }
    }
  }

  void prefer(const std::string& id, const Wall& wall) {
    constexpr int kStrongly = 200;
    Relation relation;
    relation.id = "w" + id;
    relation.type = RelationType::kAgainstWall;
    relation.targets = {id};
    relation.references = {wall.id};
    relation.hard = false;
    relation.weight = kStrongly;
    relation.origin = Origin::kConcluded;
    relation.why = "shared out over the walls";
    scene_.relations.push_back(std::move(relation));
  }

  SceneGraph& scene_;
  const SceneGraph& sized_;
  const Catalog& catalog_;
  std::size_t added_ = 0;
};

}  // namespace

const SceneObject* counter_of(const SceneGraph& scene, const Catalog& catalog, const std::string& seat) {
  for (const Relation& r : scene.relations) {
    const bool along = r.type == RelationType::kInFrontOf || r.type == RelationType::kAlongSide;
    if (!along || r.references.size() != 1 || std::ranges::find(r.targets, seat) == r.targets.end()) continue;
    const SceneObject* counter = scene.find_object(r.references.front());
    if (counter != nullptr && catalog.entry_or_nearest(counter->category).is(Trait::kCounter)) return counter;
  }
  return nullptr;
}

std::size_t fill_rows(SceneGraph& scene, const SceneGraph& sized, const std::vector<Lining>& linings, const Catalog& catalog) {
  return OpenRows(scene, sized, catalog).run(linings);
}

}  // namespace layoutbox
