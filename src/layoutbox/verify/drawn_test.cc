// Meshes made of boxes, so that what is drawn can be told from the box of the layout.
#include "layoutbox/verify/drawn.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "layoutbox/verify/mesh.h"
#include "layoutbox/verify/test_room.h"

namespace layoutbox::checks {
namespace {

using testing::HasSubstr;

// Twelve triangles, counter-clockwise from outside.
std::vector<Triangle> block(Point3 low, Point3 high) {
  const auto corner = [&](int i) { return Point3{i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z}; };
  std::vector<Triangle> triangles;
  for (const auto& face : {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    triangles.push_back({corner(face[0]), corner(face[1]), corner(face[2])});
    triangles.push_back({corner(face[0]), corner(face[2]), corner(face[3])});
  }
  return triangles;
}

// A table of a top and four legs.
std::vector<Triangle> table(double x, double y, double w, double d, double h) {
  std::vector<Triangle> all = block({x, y, h - 0.04}, {x + w, y + d, h});
  for (const double lx : {x, x + w - 0.05}) {
    for (const double ly : {y, y + d - 0.05}) {
      for (const Triangle& triangle : block({lx, ly, 0}, {lx + 0.05, ly + 0.05, h - 0.04})) all.push_back(triangle);
    }
  }
  return all;
}

TestRoom room_with_chair(double x) {
  TestRoom room;
  room.add("table", "table", {1.2, 0.8, 0.75}, {1.6, 1.4}).add("chair", "stool", {0.4, 0.4, 0.45}, {x, 1.4});
  return room;
}

Report drawn(const TestRoom& room, std::vector<DrawnObject> objects) {
  Report report;
  verify_drawn(room.layout, Catalog::builtin(), objects, {}, report);
  return report;
}

TEST(Mesh, BlocksMeetCutOrWithin) {
  const BodyMesh unit(block({0, 0, 0}, {1, 1, 1}), {});
  EXPECT_TRUE(meet(unit, BodyMesh(block({0.99, 0.2, 0.2}, {1.5, 0.4, 0.4}), {})));
  EXPECT_FALSE(meet(unit, BodyMesh(block({1.01, 0.2, 0.2}, {1.5, 0.4, 0.4}), {})));
  EXPECT_TRUE(meet(unit, BodyMesh(block({0.3, 0.3, 0.3}, {0.5, 0.5, 0.5}), {})));
  EXPECT_FALSE(meet(unit.inset(0.01), BodyMesh(block({0.995, 0.2, 0.2}, {1.5, 0.4, 0.4}), {})));
}

TEST(Mesh, DepthToTheMillimetre) {
  const BodyMesh a(block({0, 0, 0}, {1, 1, 1}), frame_at(0)), b(block({0.9, 0, 0}, {1.9, 1, 1}), frame_at(0));
  EXPECT_NEAR(depth_of_meeting(a, b, 0.5), 0.05, 0.0015);  // each of them
}

TEST(Mesh, ShareOffTheFloor) {
  const Polygon square{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, notched{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
  EXPECT_EQ(share_off(BodyMesh(block({0, 0, 0}, {1, 1, 1}), {}), square), 0);
  // Of the cube's surface a fifth of four sides, and the whole of one.
  EXPECT_NEAR(share_off(BodyMesh(block({3.2, 1, 0}, {4.2, 2, 1}), {}), square), (4 * 0.2 + 1) / 6, 0.03);
  EXPECT_NEAR(share_off(BodyMesh(block({2.5, 2.5, 0}, {3.5, 3.5, 1}), {}), notched), 1, 1e-9);
  EXPECT_GT(share_off(BodyMesh(block({1.5, 1.5, 0}, {2.5, 2.5, 1}), {}), notched), 0.2);
}

TEST(Drawn, BetweenLegsIsNoCollisionInThemIs) {
  const auto table_mesh = table(1, 1, 1.2, 0.8, 0.75);
  const TestRoom tucked = room_with_chair(1.6);
  const Report free = drawn(tucked, {{"table", table_mesh}, {"chair", block({1.4, 1.2, 0}, {1.8, 1.6, 0.45})}});
  EXPECT_TRUE(passes(free, "drawnCollision"));
  EXPECT_EQ(free.metrics.at("drawnCollisions"), 0);
  const TestRoom stuck = room_with_chair(1.2);
  const Report hit = drawn(stuck, {{"table", table_mesh}, {"chair", block({0.9, 0.9, 0}, {1.3, 1.3, 0.45})}});
  EXPECT_FALSE(passes(hit, "drawnCollision", "table / chair"));
  EXPECT_EQ(hit.metrics.at("drawnCollisions"), 2);
  EXPECT_FALSE(find_check(hit, "drawnCollision", "table / chair")->required);
}

TEST(Drawn, FiveMillimetresAreForgiven) {
  TestRoom room;
  room.add("a", "bed", {1, 1, 1}, {1.5, 1.5}).add("b", "bed", {1, 1, 1}, {2.5, 1.5});
  const auto with = [&](double deep) {
    return drawn(room, {{"a", block({1, 1, 0}, {2, 2, 1})}, {"b", block({2 - deep, 1, 0}, {3 - deep, 2, 1})}});
  };
  EXPECT_TRUE(passes(with(0), "drawnCollision"));
  EXPECT_TRUE(passes(with(0.004), "drawnCollision"));
  const Report deep = with(0.02);
  EXPECT_NEAR(find_check(deep, "drawnCollision", "a / b")->value, 0.02, 0.003);
}

TEST(Drawn, WhatHoldsItIsTouched) {
  TestRoom room;
  room.add("shelf", "table", {1, 0.4, 0.8}, {2, 0.2})
      .add("lamp", "table_lamp", {0.2, 0.2, 0.4}, {2, 0.2, 0.8}, "shelf")
      .add("picture", "painting", {0.4, 0.03, 0.3}, {4, 3.985, 1.5}, "wall3")
      .add("pendant", "pendant_lamp", {0.3, 0.3, 0.5}, {2.5, 2, 2.1}, "ceiling");
  const auto with = [&](double up, double off, double below) {
    return drawn(room, {{"shelf", table(1.5, 0, 1, 0.4, 0.8)},
                        {"lamp", block({1.9, 0.1, 0.8 + up}, {2.1, 0.3, 1.2 + up})},
                        {"picture", block({3.8, 3.97 - off, 1.5}, {4.2, 4 - off, 1.8})},
                        {"pendant", block({2.35, 1.85, 2.1 - below}, {2.65, 2.15, 2.6 - below})}});
  };
  EXPECT_EQ(with(0.003, 0.008, 0.008).metrics.at("drawnSupport"), 1);
  const Report loose = with(0.03, 0.04, 0.05);
  EXPECT_EQ(loose.metrics.at("drawnSupport"), 0.25);
  EXPECT_NEAR(find_check(loose, "drawnSupport", "lamp")->value, 0.03, 0.0015);
  EXPECT_NEAR(find_check(loose, "drawnSupport", "picture")->value, 0.04, 1e-6);
  EXPECT_THAT(find_check(loose, "drawnSupport", "pendant")->message, HasSubstr("0.05 m from ceiling"));
}

TEST(Drawn, ThroughAWallOrTheCeiling) {
  TestRoom room;
  room.add("a", "bed", {1, 1, 1}, {0.5, 1.5}).add("b", "wardrobe", {1, 0.6, 2.6}, {3, 1});
  const Report report = drawn(room, {{"a", block({-0.1, 1, 0}, {0.9, 2, 1})}, {"b", block({2.5, 0.7, 0}, {3.5, 1.3, 2.65})}});
  EXPECT_EQ(report.metrics.at("drawnOutOfBounds"), 2);
  EXPECT_THAT(find_check(report, "drawnOutOfBounds", "b")->message, HasSubstr("above the ceiling"));
}

TEST(Drawn, WhatIsNoneOfTheLayoutIsPassedOver) {
  TestRoom room;
  room.add("a", "bed", {1, 1, 1}, {1, 1});
  const Report report = drawn(room, {{"a", {}}, {"stranger", block({0, 0, 0}, {9, 9, 9})}});
  for (const char* name : {"drawnOutOfBounds", "drawnSupport"}) EXPECT_EQ(find_check(report, name, "a"), nullptr) << name;
  EXPECT_EQ(report.metrics.at("drawnOutOfBounds"), 0);
}

// The box shuts off half of the room, what is drawn of it a corner; and the other way round.
TEST(Drawn, WaysAreThoseThatMeshesLeaveFree) {
  TestRoom room;
  room.door("d", "wall1", 0.5)
      .add("chest", "wardrobe", {4.98, 0.6, 1}, {2.5, 2})
      .add("desk", "desk", {1.2, 0.6, 0.75}, {2.5, 3.7})
      .used({Side::kFront});
  const std::vector<Triangle> small = block({0, 1.7, 0}, {1, 2.3, 1}), desk = block({1.9, 3.4, 0}, {3.1, 4, 0.75});
  const Report open = drawn(room, {{"chest", small}, {"desk", desk}});
  EXPECT_NEAR(open.metrics.at("drawnNavigability"), 1, 1e-9);
  EXPECT_TRUE(passes(open, "drawnReachability", "desk"));
  const Report shut = drawn(room, {{"chest", block({0.01, 1.7, 0}, {4.99, 2.3, 1})}, {"desk", desk}});
  EXPECT_LT(shut.metrics.at("drawnNavigability"), 0.6);
  EXPECT_FALSE(passes(shut, "drawnReachability", "desk"));
  EXPECT_EQ(find_check(shut, "drawnNavigability")->limit, 0.99);
  EXPECT_FALSE(find_check(shut, "drawnNavigability")->required);
}

// A box and a mesh that fills it are in the way alike, whichever way they are turned.
TEST(Drawn, AMeshThatFillsItsBoxMeasuresAsTheBox) {
  TestRoom room;
  room.door("d", "wall1", 0.5)
      .add("a", "bed", {1.6, 2, 0.5}, {3.5, 2.2})
      .used({Side::kLeft, Side::kRight})
      .add("b", "wardrobe", {1.2, 0.6, 2}, {0.8, 3.1})
      .used({Side::kFront});
  const Report boxes = verify(room.layout, Catalog::builtin());
  const Report meshes = drawn(room, {{"a", block({2.7, 1.2, 0}, {4.3, 3.2, 0.5})}, {"b", block({0.2, 2.8, 0}, {1.4, 3.4, 2})}});
  EXPECT_NEAR(meshes.metrics.at("drawnNavigability"), boxes.metrics.at("navigability"), 0.01);
  EXPECT_NEAR(meshes.metrics.at("drawnAccessibility"), boxes.metrics.at("accessibility"), 0.05);
  EXPECT_NEAR(meshes.metrics.at("drawnReachability"), boxes.metrics.at("reachability"), 1e-9);
}

TEST(Drawn, WhatIsBeforeADoorOrInItsSwing) {
  TestRoom room;
  room.door("d", "wall1", 1.0).add("a", "stool", {0.4, 0.4, 0.5}, {1.5, 0.5});
  const auto at = [&](double x, double y) { return drawn(room, {{"a", block({x, y, 0}, {x + 0.1, y + 0.1, 0.5})}}); };
  const Report before = at(1.4, 0.3);
  EXPECT_FALSE(passes(before, "drawnOpeningClearance", "d"));
  EXPECT_FALSE(passes(before, "drawnDoorSwing", "d"));
  EXPECT_EQ(before.metrics.at("drawnDoorSwing"), 0);
  const Report beside = at(2.2, 0.3);
  EXPECT_TRUE(passes(beside, "drawnOpeningClearance", "d"));
  EXPECT_TRUE(passes(beside, "drawnDoorSwing", "d"));
  // In a corner of the box that the leaf does not sweep.
  const Report corner = at(1.0, 0.79).metrics.at("drawnDoorSwing") == 1 ? at(1.0, 0.79) : at(1.8, 0.79);
  EXPECT_FALSE(passes(corner, "drawnOpeningClearance", "d"));
  EXPECT_TRUE(passes(corner, "drawnDoorSwing", "d"));
}

TEST(Seen, WhatIsHiddenInThePicture) {
  TestRoom room;
  room.add("bed", "bed", {1, 2, 0.5}, {1, 1}).add("stool", "stool", {0.3, 0.3, 0.4}, {3, 3}).add("clock", "clock", {0.3, 0.1, 0.3}, {1, 0});
  Report report;
  const Status read = verify_seen(room.layout, R"({"things": [], "visibility": {"objects": {"bed": {"visible": 0.9, "behind": []},
    "stool": {"visible": 0.0, "behind": ["bed"]}}, "behindWalls": 0, "leftOut": ["clock"]}})",
                                  report);
  ASSERT_TRUE(read);
  EXPECT_TRUE(passes(report, "visibility", "bed"));
  EXPECT_TRUE(passes(report, "visibility", "walls"));
  EXPECT_FALSE(passes(report, "visibility", "stool"));
  EXPECT_THAT(find_check(report, "visibility", "stool")->message, HasSubstr("behind bed"));
  EXPECT_EQ(find_check(report, "visibility", "clock"), nullptr);
  EXPECT_EQ(report.metrics.at("visibility"), 0.5);
  for (const char* broken : {"", "[]", "{}", R"({"visibility": []})", R"({"visibility": {"objects": []}})"})
    EXPECT_FALSE(verify_seen(room.layout, broken, report)) << broken;
}

}  // namespace
}  // namespace layoutbox::checks
