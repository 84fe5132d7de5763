#include "layoutbox/dress/dresser.h"

#include <algorithm>
#include <cmath>

#include "layoutbox/catalog/size_words.h"
#include "layoutbox/render/render.h"

namespace layoutbox::dressing {

double on_grid(double length) { return std::round(length / kGridMm) * kGridMm; }

Dresser::Dresser(Layout& layout, const Catalog& catalog, const Spoken& spoken)
    : layout_(layout), catalog_(catalog), spoken_(spoken), room_(layout, catalog) {
  const Corner corner = best_corner(layout, catalog);
  toward_x_ = corner == Corner::kNorthEast || corner == Corner::kSouthEast ? 1 : -1;
  toward_y_ = corner == Corner::kNorthEast || corner == Corner::kNorthWest ? 1 : -1;
}

bool Dresser::is_shown(const DressedWall& wall) const { return wall.along_x * toward_y_ - wall.along_y * toward_x_ > 0; }

bool Dresser::is_one_of(const PlacedObject& object, const std::vector<std::string>& kinds) const {
  return std::ranges::any_of(kinds, [&](const std::string& kind) { return catalog_.is_a(object.category, kind); });
}

bool Dresser::is_there(const std::string& kind) const {
  return std::ranges::any_of(layout_.objects, [&](const PlacedObject& object) { return catalog_.is_a(object.category, kind); });
}

std::vector<std::size_t> Dresser::things(const std::vector<std::string>& kinds) const {
  std::vector<std::size_t> found;
  for (const std::string& kind : kinds) {
    for (std::size_t i = 0; i < layout_.objects.size(); ++i) {
      const bool is_it = catalog_.is_a(layout_.objects[i].category, kind);
      if (is_it && std::ranges::find(found, i) == found.end()) found.push_back(i);
    }
  }
  return found;
}

Size Dresser::size_of(const Dressing& row) const {
  const Size usual = size_by_words(catalog_.entry_or_nearest(row.adds), row.words).usual;
  const auto given = [](Mm side, Mm otherwise) { return side > 0 ? side : otherwise; };
  return {given(row.size.width, usual.width), given(row.size.depth, usual.depth), given(row.size.height, usual.height)};
}

std::string Dresser::add(const std::string& kind, const std::vector<std::string>& words, const Size& size, const DressedPose& pose) {
  const CatalogEntry& entry = catalog_.entry_or_nearest(kind);
  PlacedObject object;
  int number = 0;
  do {
    object.id = entry.id + "_" + std::to_string(++number);
  } while (layout_.find_object(object.id) != nullptr);
  object.category = entry.id;
  object.name = entry.name;
  object.attributes = words;
  object.size = size;
  object.position = pose.at;
  object.rotation_deg = pose.turn_deg;
  object.mount = entry.mount;
  object.supported_by = pose.holder;
  object.used_sides = entry.used_sides;
  object.spaces = spaces_at(entry, size);
  object.origin = Origin::kAdded;
  room_.take(object, entry);
  added_.push_back(object.id);
  layout_.objects.push_back(std::move(object));
  return added_.back();
}

std::string Dresser::add_at_wall(const std::string& kind, const std::vector<std::string>& words, const Size& size, const DressedWall& wall,
                                 double along, double height) {
  DressedPose pose{wall.point(along + size.width / 2.0, size.depth / 2.0, height), wall.turn_deg};
  if (catalog_.entry_or_nearest(kind).mount == Mount::kWall) pose.holder = wall.wall->id;
  return add(kind, words, size, pose);
}

std::string Dresser::add_on(const std::string& kind, const std::vector<std::string>& words, const Size& size, const std::string& host,
                            double x, double y, double level, double turned_deg) {
  const PlacedObject& below = *layout_.find_object(host);
  const double turn = below.rotation_deg + turned_deg, top = below.position[2] + level;
  // Whole millimetres: what a file says is what is drawn.
  std::string id = add(kind, words, size, {{std::round(x), std::round(y), top}, turn, host});
  Relation on;
  on.id = "on " + id;
  on.type = RelationType::kOn;
  on.targets = {id};
  on.references = {host};
  on.why = "dresses the room";
  on.origin = Origin::kAdded;
  layout_.relations.push_back({std::move(on), true});
  return id;
}

void Dresser::use_from_no_side(const std::string& id) {
  for (PlacedObject& object : layout_.objects) {
    if (object.id == id) object.used_sides.clear();
  }
}

void Dresser::remove(std::vector<std::string> ids) {
  const auto goes = [&](const std::string& id) { return std::ranges::find(ids, id) != ids.end(); };
  for (std::size_t before = 0; before != ids.size();) {
    before = ids.size();
    for (const PlacedObject& object : layout_.objects) {
      if (goes(object.supported_by) && !goes(object.id)) ids.push_back(object.id);
    }
  }
  std::erase_if(layout_.objects, [&](const PlacedObject& object) { return goes(object.id); });
  std::erase_if(layout_.relations, [&](const PlacedRelation& placed) { return std::ranges::any_of(placed.relation.targets, goes); });
  std::erase_if(added_, goes);
  room_ = FreeRoom(layout_, catalog_);
}

}  // namespace layoutbox::dressing
