// The room that is dressed, and the one way to add to it.
#pragma once

#include <string>
#include <vector>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/catalog/dressing.h"
#include "layoutbox/dress/free_room.h"
#include "layoutbox/plan/spoken.h"
#include "layoutbox/scene/layout.h"

namespace layoutbox::dressing {

// Where a thing goes.
struct DressedPose {
  std::array<double, 3> at{};  // mm; x, y: centre of the footprint, z: underside
  double turn_deg = 0;
  std::string holder = "floor";  // floor, ceiling, a wall's id or an object's
};

class Dresser {
 public:
  // REQUIRES: all outlive it.
  Dresser(Layout& layout, const Catalog& catalog, const Spoken& spoken);

  const Layout& layout() const { return layout_; }
  const Catalog& catalog() const { return catalog_; }
  const Spoken& spoken() const { return spoken_; }
  const FreeRoom& room() const { return room_; }

  // Does the usual picture show it? The others are cut away there.
  bool is_shown(const DressedWall& wall) const;

  bool is_there(const std::string& kind) const;
  bool is_one_of(const PlacedObject& object, const std::vector<std::string>& kinds) const;
  // Places in the layout's objects: those of the kinds, the first kind first.
  std::vector<std::size_t> things(const std::vector<std::string>& kinds) const;
  const CatalogEntry& entry_of(const PlacedObject& object) const { return catalog_.entry_or_nearest(object.category); }

  // The usual size of what the row adds, by its words; sides that the row gives are so.
  Size size_of(const Dressing& row) const;
  // Returns the id.
  std::string add(const std::string& kind, const std::vector<std::string>& words, const Size& size, const DressedPose& pose);
  // With its back to a wall, from there along it; millimetres from the floor to its underside.
  std::string add_at_wall(const std::string& kind, const std::vector<std::string>& words, const Size& size, const DressedWall& wall,
                          double along, double height);
  // On a thing, so high above its underside, turned against it.
  std::string add_on(const std::string& kind, const std::vector<std::string>& words, const Size& size, const std::string& host, double x,
                     double y, double level, double turned_deg = 0);

  // What stands in a corner of a run is used from none of its sides.
  void use_from_no_side(const std::string& id);
  // Takes things out again, with what stands on them.
  void remove(std::vector<std::string> ids);
  const std::vector<std::string>& added() const { return added_; }

 private:
  Layout& layout_;
  const Catalog& catalog_;
  const Spoken& spoken_;
  FreeRoom room_;
  int toward_x_ = 1, toward_y_ = -1;  // the camera
  std::vector<std::string> added_;
};

// Lengths in whole grid steps (1 cm).
double on_grid(double length);

}  // namespace layoutbox::dressing
