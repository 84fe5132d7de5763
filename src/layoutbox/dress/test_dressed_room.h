// A room that tests furnish by hand and have dressed.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "layoutbox/dress/dress.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/scene/shell.h"
#include "layoutbox/verify/verify.h"

namespace layoutbox {

inline const Catalog& catalog() { return Catalog::builtin(); }

// A rectangle with a door at the left end of its front wall, and things that are put where the test wants them; metres.
class DressedRoom {
 public:
  DressedRoom(const std::string& type, double width, double depth, const std::string& prompt = {}) {
    const Mm w = mm_from_m(width), d = mm_from_m(depth);
    Room& room = layout_.room;
    room.type = type;
    room.polygon = {{0, 0}, {w, 0}, {w, d}, {0, d}};
    room.walls = walls_along(room.polygon);
    room.height = 2700;
    layout_.prompt = scene_.prompt = prompt;
    opening(OpeningType::kDoor, "wall1", 0.1, 0.9, 2.0, 0);
  }

  DressedRoom& opening(OpeningType type, const std::string& wall, double offset, double width, double height, double sill) {
    Opening one;
    one.id = name_of(type) + std::to_string(layout_.room.openings.size() + 1);
    one.type = type, one.wall = wall, one.offset = mm_from_m(offset);
    one.width = mm_from_m(width), one.height = mm_from_m(height), one.sill = mm_from_m(sill);
    layout_.room.openings.push_back(one);
    return *this;
  }
  DressedRoom& window(const std::string& wall, double offset) { return opening(OpeningType::kWindow, wall, offset, 1.2, 1.2, 0.9); }

  // Of its usual size; x, y: the centre.
  DressedRoom& put(const std::string& kind, double x, double y, double turn, Origin origin = Origin::kAsked) {
    const CatalogEntry& entry = *catalog().find(kind);
    PlacedObject object;
    object.id = kind + "_" + std::to_string(layout_.objects.size() + 1);
    object.category = kind, object.name = entry.name, object.size = entry.size.usual, object.mount = entry.mount;
    object.position = {x * 1000, y * 1000, 0}, object.rotation_deg = turn;
    object.used_sides = entry.used_sides, object.spaces = spaces_at(entry, object.size), object.origin = origin;
    SceneObject asked;
    asked.id = object.id, asked.category = kind, asked.name = entry.name, asked.origin = origin;
    scene_.objects.push_back(asked);
    layout_.objects.push_back(object);
    return *this;
  }
  DressedRoom& unwanted(const std::string& kind) {
    unwanted_.push_back(kind);
    return *this;
  }

  // On a wall, its underside at z; `where`: a wall that the text names.
  DressedRoom& hang(const std::string& kind, double x, double y, double z, double turn, const std::string& wall,
                    const std::string& where = {}) {
    put(kind, x, y, turn);
    PlacedObject& object = layout_.objects.back();
    object.position[2] = z * 1000, object.supported_by = wall;
    Relation on;
    on.id = "on " + object.id, on.type = RelationType::kOnWall, on.targets = {object.id};
    if (!where.empty()) on.references = {where};
    layout_.relations.push_back({std::move(on), true});
    return *this;
  }

  // Dresses it; what must hold for every room is checked here. Returns the kinds that came.
  std::vector<std::string> dress() {
    scene_.room = layout_.room;
    const Layout before = layout_;
    const std::set<std::string> faults = failed(layout_);
    Layout again = layout_;
    SceneGraph scene_again = scene_;
    const Spoken spoken(scene_, unwanted_, catalog());
    const std::size_t count = layoutbox::dress(scene_, layout_, catalog(), spoken);
    layoutbox::dress(scene_again, again, catalog(), spoken);
    EXPECT_EQ(write_layout(layout_), write_layout(again)) << "the same bytes each time";
    const auto hangs_elsewhere = [&](std::size_t i) {
      return before.objects[i].mount == Mount::kWall && layout_.objects[i].position != before.objects[i].position;
    };
    std::size_t moved = 0;
    for (std::size_t i = 0; i < before.objects.size(); ++i) moved += hangs_elsewhere(i) ? 1 : 0;
    EXPECT_EQ(layout_.objects.size() + moved, before.objects.size() + count);
    EXPECT_EQ(scene_.objects.size(), layout_.objects.size()) << "the scene has the same";
    for (std::size_t i = 0; i < before.objects.size(); ++i) {
      EXPECT_EQ(layout_.objects[i].id, before.objects[i].id);
      EXPECT_TRUE(hangs_elsewhere(i) || layout_.objects[i].position == before.objects[i].position) << "nothing that stands moves";
    }
    for (const std::string& fault : failed(layout_)) {
      const bool worktop_in_corner = fault.starts_with("accessibility counter");  // another's end is before a part of it
      EXPECT_TRUE(worktop_in_corner || faults.contains(fault)) << fault;
    }
    std::vector<std::string> kinds;
    for (std::size_t i = before.objects.size(); i < layout_.objects.size(); ++i) {
      EXPECT_EQ(layout_.objects[i].origin, Origin::kAdded);
      kinds.push_back(layout_.objects[i].category);
    }
    return kinds;
  }

  const Layout& layout() const { return layout_; }
  std::vector<PlacedObject> of(const std::string& kind) const {
    std::vector<PlacedObject> found;
    std::ranges::copy_if(layout_.objects, std::back_inserter(found), [&](const PlacedObject& o) { return o.category == kind; });
    return found;
  }

 private:
  static std::set<std::string> failed(const Layout& layout) {
    std::set<std::string> faults;
    for (const Check& check : verify(layout, catalog()).checks) {
      if (!check.passed) faults.insert(check.name + " " + check.subject);
    }
    return faults;
  }
  static std::string name_of(OpeningType type) { return type == OpeningType::kWindow ? "window" : "door"; }

  SceneGraph scene_;
  Layout layout_;
  std::vector<std::string> unwanted_;
};

}  // namespace layoutbox
