// What furnish draws is where the layout says: nothing that warns in furnished rooms, each fault of a mesh found.
#include "layoutbox/judge/drawn_room.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "layoutbox/furnish/furnish.h"
#include "layoutbox/verify/test_room.h"

namespace layoutbox::checks {
namespace {

TestRoom bedroom() {
  TestRoom room;
  room.door("door1", "wall1", 3.5).window("window1", "wall3", 2);
  room.add("bed_1", "bed", {1.6, 2, 0.5}, {1, 3})
      .add("nightstand_1", "nightstand", {0.45, 0.4, 0.5}, {2.05, 3.8})
      .add("lamp_1", "table_lamp", {0.25, 0.25, 0.4}, {2.05, 3.8, 0.5}, "nightstand_1")
      .add("wardrobe_1", "wardrobe", {1.2, 0.6, 2}, {4.7, 2, 0, 270})
      .add("painting_1", "painting", {0.6, 0.03, 0.4}, {0.015, 1, 1.4, 90}, "wall4")
      .add("pendant_1", "pendant_lamp", {0.4, 0.4, 0.6}, {2.5, 2, 2}, "ceiling");
  return room;
}

std::vector<DrawnObject> drawn(const Layout& layout) {
  const auto model = furnish(layout, Catalog::builtin());
  EXPECT_TRUE(model);
  return model ? drawn_objects(*model) : std::vector<DrawnObject>{};
}

std::vector<std::string> warnings(const Layout& layout, const std::vector<DrawnObject>& objects) {
  Report report;
  verify_drawn(layout, Catalog::builtin(), objects, {}, report);
  std::vector<std::string> found;
  for (const Check& check : report.checks) {
    if (!check.passed) found.push_back(check.name + " " + check.subject);
  }
  return found;
}

void move(std::vector<DrawnObject>& objects, const std::string& id, Point3 by) {
  for (DrawnObject& object : objects) {
    for (Triangle& triangle : object.triangles) {
      for (Point3& p : triangle) {
        if (object.id == id) p = {p.x + by.x, p.y + by.y, p.z + by.z};
      }
    }
  }
}

TEST(DrawnRoom, SoundRoomsDoNotWarn) {
  const TestRoom room = bedroom();
  EXPECT_THAT(warnings(room.layout, drawn(room.layout)), testing::IsEmpty());
}

TEST(DrawnRoom, MeshesThatAreElsewhereAreFound) {
  const TestRoom room = bedroom();
  const auto sound = drawn(room.layout);
  const auto moved = [&](const std::string& id, Point3 by) {
    auto objects = sound;
    move(objects, id, by);
    return warnings(room.layout, objects);
  };
  using testing::Contains;
  EXPECT_THAT(moved("lamp_1", {0, 0, 0.025}), Contains("drawnSupport lamp_1"));
  EXPECT_THAT(moved("lamp_1", {0, 0, -0.025}), Contains("drawnCollision nightstand_1 / lamp_1"));
  EXPECT_THAT(moved("bed_1", {0, 0, 0.025}), Contains("drawnSupport bed_1"));
  EXPECT_THAT(moved("nightstand_1", {-0.04, 0, 0}), Contains("drawnCollision bed_1 / nightstand_1"));
  EXPECT_THAT(moved("painting_1", {0.03, 0, 0}), Contains("drawnSupport painting_1"));
  EXPECT_THAT(moved("wardrobe_1", {0.1, 0, 0}), Contains("drawnOutOfBounds wardrobe_1"));
  EXPECT_THAT(moved("pendant_1", {0, 0, -0.03}), Contains("drawnSupport pendant_1"));
}

}  // namespace
}  // namespace layoutbox::checks
