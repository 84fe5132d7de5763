// Every relation at its limit: held, held after a move of less than the slack, broken after a move of more; and the same in the room
// turned by quarter turns and mirrored.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "layoutbox/verify/test_room.h"

namespace layoutbox::judge {
namespace {

using Type = RelationType;

// A move of `who` in metres and degrees by which the relation breaks; a fraction of it is within the slack.
struct Break {
  std::string who;
  Place by;
};

struct Limit {
  std::string name;
  Type type;
  std::function<void(TestRoom&)> furnish;  // the relation is its only one, and just holds
  Break breaks;
  bool turns = true;  // means the same in a turned room (false: it speaks of the room's own axes in words that turning does not keep)
};

void PrintTo(const Limit& limit, std::ostream* out) { *out << limit.name; }

RelationParameters with(std::function<void(RelationParameters&)> set) {
  RelationParameters parameters;
  set(parameters);
  return parameters;
}

RelationParameters with_max(Mm max) {
  return with([&](RelationParameters& p) { p.max = max; });
}

RelationParameters with_axis(Axis axis) {
  return with([&](RelationParameters& p) { p.axis = axis; });
}

constexpr std::array<double, 3> kBed{1.6, 2.0, 0.5}, kStand{0.4, 0.4, 0.5}, kChair{0.4, 0.4, 0.8};

// A bed with its head at the back wall, its centre at (2.5, 3.0): x from 1.7 to 3.3, y from 2.0 to 4.0.
TestRoom& bed(TestRoom& room) { return room.add("bed", "bed", kBed, {2.5, 3.0}); }
// A table of 1.6 × 0.8 m in the middle of the room, free below.
TestRoom& table(TestRoom& room) {
  return room.add("table", "dining_table", {1.6, 0.8, 0.75}, {2.5, 2.0}).space("below", {-0.8, -0.4, 0}, {0.8, 0.4, 0.69}, false);
}

const std::vector<Limit>& limits() {
  static const std::vector<Limit> kLimits{
      {"offset",
       Type::kOffset,
       [](TestRoom& r) {
         bed(r).add("desk", "desk", {1, 0.6, 0.75}, {1.1, 0.8}).relation(Type::kOffset, {"desk"}, {"bed"}, with([](auto& p) {
                                                                           p.axis = Axis::kY, p.distance = 900;
                                                                         }));
       },
       {"desk", {0, 0.02}}},
      {"offset from a wall",
       Type::kOffset,
       [](TestRoom& r) {
         r.add("desk", "desk", {1, 0.6, 0.75}, {0.8, 1}).relation(Type::kOffset, {"desk"}, {"wall4"}, with([](auto& p) {
                                                                    p.distance = 300;
                                                                  }));
       },
       {"desk", {0.02, 0}}},
      {"offset from the end of a wall",
       Type::kOffset,
       [](TestRoom& r) {
         r.add("desk", "desk", {1, 0.6, 0.75}, {1, 1.6}).relation(Type::kOffset, {"desk"}, {"wall2"}, with([](auto& p) {
                                                                    p.axis = Axis::kY, p.distance = 1300;
                                                                  }));
       },
       {"desk", {0, 0.02}}},
      {"align",
       Type::kAlign,
       [](TestRoom& r) {
         bed(r).add("desk", "desk", {1, 0.6, 0.75}, {2.5, 1}).relation(Type::kAlign, {"desk"}, {"bed"}, with_axis(Axis::kX));
       },
       {"desk", {0.02, 0}}},
      {"align by edge",
       Type::kAlign,
       [](TestRoom& r) {
         bed(r).add("desk", "desk", {1, 0.6, 0.75}, {2.2, 1}).relation(Type::kAlign, {"desk", "bed"}, {}, with([](auto& p) {
                                                                         p.edge = "left";
                                                                       }));
       },
       {"desk", {0.02, 0}},
       false},
      {"inside",
       Type::kInside,
       [](TestRoom& r) {
         r.add("rug", "rug", {2, 1.4, 0.01}, {2, 2}).add("chair", "chair", kChair, {2.8, 2}).relation(Type::kInside, {"chair"}, {"rug"});
       },
       {"chair", {0.02, 0}}},
      {"inside the room",
       Type::kInside,
       [](TestRoom& r) {
         r.add("chair", "chair", kChair, {0.203, 2}).relation(Type::kInside, {"chair"});
       },
       {"chair", {-0.02, 0}}},
      {"groupAlign",
       Type::kGroupAlign,
       [](TestRoom& r) {
         r.add("a", "chair", kChair, {1, 1}).add("b", "chair", kChair, {2, 1}).add("c", "chair", kChair, {3, 1});
         r.relation(Type::kGroupAlign, {"a", "b", "c"}, {}, with_axis(Axis::kY));
       },
       {"b", {0, 0.02}}},
      {"againstWall",
       Type::kAgainstWall,
       [](TestRoom& r) {
         r.add("bed", "bed", kBed, {2, 2.98}).relation(Type::kAgainstWall, {"bed"}, {"wall3"});
       },
       {"bed", {0, -0.02}}},
      {"againstWall, turned",
       Type::kAgainstWall,
       [](TestRoom& r) {
         r.add("bed", "bed", kBed, {2, 3}).relation(Type::kAgainstWall, {"bed"});
       },
       {"bed", {0, 0, 0, 4}}},
      {"againstWall, along it",
       Type::kAgainstWall,
       [](TestRoom& r) {
         r.add("bed", "bed", kBed, {0, 3}).relation(Type::kAgainstWall, {"bed"}, {"wall3"});
       },
       {"bed", {-0.02, 0}},
       false},
      {"sideAgainstWall",
       Type::kSideAgainstWall,
       [](TestRoom& r) {
         r.add("bed", "bed", kBed, {0.82, 2}).relation(Type::kSideAgainstWall, {"bed"}, {"wall4"}, with([](auto& p) {
                                                         p.side = Side::kLeft;
                                                       }));
       },
       {"bed", {0.02, 0}}},
      {"corner",
       Type::kCorner,
       [](TestRoom& r) {
         r.add("plant", "plant", {0.4, 0.4, 1}, {0.7, 3.5}).relation(Type::kCorner, {"plant"});
       },
       {"plant", {0.02, 0}}},
      {"corner of two walls",
       Type::kCorner,
       [](TestRoom& r) {
         r.add("plant", "plant", {0.4, 0.4, 1}, {4.7, 3.3}).relation(Type::kCorner, {"plant"}, {"wall2", "wall3"});
       },
       {"plant", {0, -0.02}}},
      {"centerOfRoom",
       Type::kCenterOfRoom,
       [](TestRoom& r) {
         r.add("table", "table", {1, 1, 0.7}, {2.55, 2}).relation(Type::kCenterOfRoom, {"table"});
       },
       {"table", {0.02, 0}}},
      {"centeredOnWall",
       Type::kCenteredOnWall,
       [](TestRoom& r) { bed(r).relation(Type::kCenteredOnWall, {"bed"}, {"wall3"}); },
       {"bed", {0.02, 0}}},
      {"inRegion",
       Type::kInRegion,
       [](TestRoom& r) {
         r.add("desk", "desk", {1, 0.6, 0.7}, {2.5, 3}).relation(Type::kInRegion, {"desk"}, {}, with([](auto& p) { p.region = "left"; }));
       },
       {"desk", {0.02, 0}}},
      {"inRegion, middle",
       Type::kInRegion,
       [](TestRoom& r) {
         r.add("desk", "desk", {1, 0.6, 0.7}, {2.5 + 5.0 / 6, 2}).relation(Type::kInRegion, {"desk"}, {}, with([](auto& p) {
                                                                             p.region = "middle";
                                                                           }));
       },
       {"desk", {0.02, 0}}},
      {"onWall",
       Type::kOnWall,
       [](TestRoom& r) {
         r.add("picture", "painting", {0.8, 0.04, 0.6}, {2, 3.98, 1.4}, "wall3")
             .relation(Type::kOnWall, {"picture"}, {"wall3"}, with([](auto& p) { p.height = 1400; }));
       },
       {"picture", {0, 0, 0.02}}},
      {"onWall, past its end",
       Type::kOnWall,
       [](TestRoom& r) {
         r.add("picture", "painting", {0.8, 0.04, 0.6}, {0.4, 3.98, 1.4}, "wall3").relation(Type::kOnWall, {"picture"});
       },
       {"picture", {-0.02, 0}}},
      {"onCeiling",
       Type::kOnCeiling,
       [](TestRoom& r) {
         r.add("lamp", "pendant_lamp", {0.4, 0.4, 0.5}, {2, 2, 2.095}, "ceiling").relation(Type::kOnCeiling, {"lamp"});
       },
       {"lamp", {0, 0, -0.02}}},
      {"awayFromWall",
       Type::kAwayFromWall,
       [](TestRoom& r) {
         r.add("sofa", "sofa", {2, 0.9, 0.8}, {1.5, 2}).relation(Type::kAwayFromWall, {"sofa"});
       },
       {"sofa", {-0.02, 0}}},
      {"underWindow",
       Type::kUnderWindow,
       [](TestRoom& r) {
         r.window("window1", "wall3", 2).add("desk", "desk", {1.2, 0.6, 0.7}, {2.4, 3.4}).relation(Type::kUnderWindow, {"desk"});
       },
       {"desk", {0, -0.02}}},
      {"underWindow, too tall",
       Type::kUnderWindow,
       [](TestRoom& r) {
         r.window("window1", "wall3", 2)
             .add("box", "box", {1.2, 0.6, 0.2}, {2.4, 3.7, 0.8})
             .relation(Type::kUnderWindow, {"box"}, {"window1"});
       },
       {"box", {0, 0, 0.02}}},
      {"nearDoor",
       Type::kNearDoor,
       [](TestRoom& r) {
         r.door("door1", "wall1", 2).add("rack", "chest", {0.4, 0.4, 1}, {2.4, 1.7}).relation(Type::kNearDoor, {"rack"});
       },
       {"rack", {0, 0.02}}},
      {"nearWindow",
       Type::kNearWindow,
       [](TestRoom& r) {
         r.window("window1", "wall3", 2)
             .add("chair", "chair", {0.4, 0.4, 1}, {2.4, 2.3})
             .relation(Type::kNearWindow, {"chair"}, {"window1"});
       },
       {"chair", {0, -0.02}}},
      {"farFromDoor",
       Type::kFarFromDoor,
       [](TestRoom& r) {
         r.door("door1", "wall1", 2).add("rack", "chest", {0.4, 0.4, 1}, {2.4, 2.2}).relation(Type::kFarFromDoor, {"rack"});
       },
       {"rack", {0, -0.02}}},
      {"farFromWindow",
       Type::kFarFromWindow,
       [](TestRoom& r) {
         r.window("window1", "wall3", 2).add("tv", "tv", {0.4, 0.4, 1.5}, {2.4, 1.8}).relation(Type::kFarFromWindow, {"tv"});
       },
       {"tv", {0, 0.02}}},
      {"notBlocking a door",
       Type::kNotBlocking,
       [](TestRoom& r) {
         r.door("door1", "wall1", 2).add("box", "chest", {0.4, 0.4, 1}, {2.4, 1.1}).relation(Type::kNotBlocking, {"box"});
       },
       {"box", {0, -0.02}}},
      {"notBlocking a window",
       Type::kNotBlocking,
       [](TestRoom& r) {
         r.window("window1", "wall3", 2)
             .add("box", "wardrobe", {0.4, 0.4, 2}, {2.4, 3.3})
             .relation(Type::kNotBlocking, {"box"}, {"window1"});
       },
       {"box", {0, 0.02}}},
      {"leftOf",
       Type::kLeftOf,
       [](TestRoom& r) {
         bed(r).add("stand", "nightstand", kStand, {1.5, 3.8}).relation(Type::kLeftOf, {"stand"}, {"bed"});
       },
       {"stand", {0.02, 0}}},
      {"leftOf, in line",
       Type::kLeftOf,
       [](TestRoom& r) {
         bed(r).add("stand", "nightstand", kStand, {1.4, 2.0}).relation(Type::kLeftOf, {"stand"}, {"bed"});
       },
       {"stand", {0, -0.02}}},
      {"rightOf",
       Type::kRightOf,
       [](TestRoom& r) {
         bed(r).add("stand", "nightstand", kStand, {4.0, 3.8}).relation(Type::kRightOf, {"stand"}, {"bed"}, with_max(500));
       },
       {"stand", {0.02, 0}}},
      {"inFrontOf",
       Type::kInFrontOf,
       [](TestRoom& r) {
         bed(r).add("chest", "chest", kStand, {2.5, 0.3}).relation(Type::kInFrontOf, {"chest"}, {"bed"});
       },
       {"chest", {0, -0.02}}},
      {"inFrontOf a door",
       Type::kInFrontOf,
       [](TestRoom& r) {
         r.door("door1", "wall1", 2).add("mat", "rug", {0.6, 0.4, 0.01}, {2.9, 0.3}).relation(Type::kInFrontOf, {"mat"}, {"door1"});
       },
       {"mat", {0.02, 0}}},
      {"behind",
       Type::kBehind,
       [](TestRoom& r) {
         r.add("sofa", "sofa", {2, 1, 0.8}, {2.5, 2})
             .add("lamp", "floor_lamp", {0.4, 0.4, 1.6}, {2.5, 2.7})
             .relation(Type::kBehind, {"lamp"}, {"sofa"});
       },
       {"lamp", {0, -0.02}}},
      {"nextTo",
       Type::kNextTo,
       [](TestRoom& r) {
         bed(r).add("stand", "nightstand", kStand, {1.0, 3.8}).relation(Type::kNextTo, {"stand"}, {"bed"});
       },
       {"stand", {-0.02, 0}}},
      {"nextTo a wall",
       Type::kNextTo,
       [](TestRoom& r) {
         r.add("stand", "nightstand", kStand, {1.0, 3.3}).relation(Type::kNextTo, {"stand"}, {"wall3"});
       },
       {"stand", {0, -0.02}}},
      {"near",
       Type::kNear,
       [](TestRoom& r) {
         bed(r).add("stand", "nightstand", kStand, {1.0, 3.8}).relation(Type::kNear, {"stand"}, {"bed"});
       },
       {"stand", {0.02, 0}}},
      {"far",
       Type::kFar,
       [](TestRoom& r) {
         r.add("a", "chest", kStand, {0.3, 2}).add("b", "chest", kStand, {4.7, 2}).relation(Type::kFar, {"a"}, {"b"});
       },
       {"a", {0.02, 0}}},
      {"distance",
       Type::kDistance,
       [](TestRoom& r) {
         bed(r).add("tv", "tv", {1, 0.2, 0.6}, {2.5, 0.4}).relation(Type::kDistance, {"tv"}, {"bed"}, with([](auto& p) {
                                                                      p.min = 1000, p.max = 1500;
                                                                    }));
       },
       {"tv", {0, -0.02}}},
      {"distance, in height",
       Type::kDistance,
       [](TestRoom& r) {
         bed(r)
             .add("lamp", "pendant_lamp", kStand, {2.5, 3, 1.5}, "ceiling")
             .relation(Type::kDistance, {"lamp"}, {"bed"}, with([](auto& p) { p.max = 1000; }));
       },
       {"lamp", {0, 0, 0.02}}},
      {"touching",
       Type::kTouching,
       [](TestRoom& r) {
         bed(r).add("bench", "bench", {1.2, 0.4, 0.4}, {2.5, 1.8}).relation(Type::kTouching, {"bench"}, {"bed"});
       },
       {"bench", {0, -0.02}}},
      {"edgeAlign",
       Type::kEdgeAlign,
       [](TestRoom& r) {
         bed(r).add("stand", "nightstand", kStand, {1.4, 3.8}).relation(Type::kEdgeAlign, {"stand"}, {"bed"}, with([](auto& p) {
                                                                          p.edge = "back";
                                                                        }));
       },
       {"stand", {0, -0.02}}},
      {"facing",
       Type::kFacing,  // 2 m ahead, 15° are 0.536 m to the side
       [](TestRoom& r) {
         r.add("chair", "chair", kChair, {2, 3}).add("tv", "tv", {0.4, 0.2, 1}, {2.531, 0.9}).relation(Type::kFacing, {"chair"}, {"tv"});
       },
       {"tv", {0.02, 0}}},
      {"facing something wide",
       Type::kFacing,  // the ray from its middle along its front just meets it
       [](TestRoom& r) {
         r.add("chair", "chair", kChair, {2, 1}).add("tv", "tv", {2, 0.2, 1}, {2.97, 0.7}).relation(Type::kFacing, {"chair"}, {"tv"});
       },
       {"tv", {0.1, 0}}},
      {"facing a wall",
       Type::kFacing,
       [](TestRoom& r) {
         r.add("chair", "chair", kChair, {0.2, 3.8, 0, 7}).relation(Type::kFacing, {"chair"}, {"wall1"});
       },
       {"chair", {0, 0, 0, 150}}},
      {"facing the room",
       Type::kFacing,
       [](TestRoom& r) {
         r.add("chair", "chair", kChair, {2.5, 3.5, 0, 14.9}).relation(Type::kFacing, {"chair"}, {"room"});
       },
       {"chair", {0, 0, 0, 0.5}}},
      {"opposite",
       Type::kOpposite,
       [](TestRoom& r) {
         r.add("a", "armchair", kChair, {2, 3.5}).add("b", "armchair", kChair, {2, 1.6, 0, 180}).relation(Type::kOpposite, {"a"}, {"b"});
       },
       {"a", {0, -0.02}}},
      {"opposite, turned away",
       Type::kOpposite,
       [](TestRoom& r) {
         r.add("a", "armchair", kChair, {2, 3.7})
             .add("b", "armchair", kChair, {2, 1.6, 0, 180 + 12})
             .relation(Type::kOpposite, {"a"}, {"b"});
       },
       {"b", {0, 0, 0, 5}}},
      {"opposite a door",
       Type::kOpposite,
       [](TestRoom& r) {
         r.door("door1", "wall1", 2).add("a", "armchair", kChair, {2.9, 1.7}).relation(Type::kOpposite, {"a"}, {"door1"});
       },
       {"a", {0.02, 0}}},
      {"parallel",
       Type::kParallel,
       [](TestRoom& r) {
         bed(r).add("desk", "desk", {1, 0.6, 0.7}, {1, 1, 0, 180.7}).relation(Type::kParallel, {"desk"}, {"bed"});
       },
       {"desk", {0, 0, 0, 1}}},
      {"perpendicular",
       Type::kPerpendicular,
       [](TestRoom& r) {
         bed(r).add("desk", "desk", {1, 0.6, 0.7}, {1, 1, 0, 90.7}).relation(Type::kPerpendicular, {"desk"}, {"bed"});
       },
       {"desk", {0, 0, 0, 1}}},
      {"perpendicular to a wall",
       Type::kPerpendicular,
       [](TestRoom& r) {
         r.add("desk", "desk", {1, 0.6, 0.7}, {1, 1, 0, 270.7}).relation(Type::kPerpendicular, {"desk"}, {"wall3"});
       },
       {"desk", {0, 0, 0, 1}}},
      {"parallel, a square without a front",
       Type::kParallel,
       [](TestRoom& r) {
         bed(r).add("t", "dining_table", {1, 1, 0.7}, {1, 1, 0, 90.7}).relation(Type::kParallel, {"t"}, {"bed"});
       },
       {"t", {0, 0, 0, 1}}},
      {"sameOrientation",
       Type::kSameOrientation,
       [](TestRoom& r) {
         bed(r).add("desk", "desk", {1, 0.6, 0.7}, {1, 1, 0, 0.7}).relation(Type::kSameOrientation, {"desk"}, {"bed"});
       },
       {"desk", {0, 0, 0, 1}}},
      {"centeredOn, standing on it",
       Type::kCenteredOn,
       [](TestRoom& r) {
         table(r).add("vase", "vase", {0.2, 0.2, 0.3}, {2.5, 2, 0.75}, "table").relation(Type::kCenteredOn, {"vase"}, {"table"});
       },
       {"vase", {0.02, 0}}},
      {"centeredOn, on a wall",
       Type::kCenteredOn,
       [](TestRoom& r) {
         bed(r).add("picture", "painting", {0.8, 0.04, 0.5}, {2.5, 3.98, 1.2}, "wall3").relation(Type::kCenteredOn, {"picture"}, {"bed"});
       },
       {"picture", {0.02, 0}}},
      {"centeredOn, one way",
       Type::kCenteredOn,
       [](TestRoom& r) {
         bed(r).add("bench", "bench", {1.2, 0.4, 0.4}, {2.5, 1.5}).relation(Type::kCenteredOn, {"bench"}, {"bed"});
       },
       {"bench", {0.02, 0}}},
      {"atFootOf",
       Type::kAtFootOf,
       [](TestRoom& r) {
         bed(r).add("bench", "bench", {1.2, 0.4, 0.4}, {2.5, 1.3}).relation(Type::kAtFootOf, {"bench"}, {"bed"});
       },
       {"bench", {0, -0.02}}},
      {"atHeadOf",
       Type::kAtHeadOf,
       [](TestRoom& r) {
         bed(r).add("stand", "nightstand", kStand, {1.4, 2 + 4.0 / 3}).relation(Type::kAtHeadOf, {"stand"}, {"bed"});
       },
       {"stand", {0, -0.02}}},
      {"alongSide",
       Type::kAlongSide,
       [](TestRoom& r) {
         bed(r).add("bench", "bench", {1.2, 0.4, 0.4}, {1.0, 3, 0, 90}).relation(Type::kAlongSide, {"bench"}, {"bed"});
       },
       {"bench", {-0.02, 0}}},
      {"tuckedUnder",
       Type::kTuckedUnder,
       [](TestRoom& r) {
         table(r).add("chair", "chair", kChair, {2.5, 1.45, 0, 180}).relation(Type::kTuckedUnder, {"chair"}, {"table"});
       },
       {"chair", {0, -0.02}}},
      {"on",
       Type::kOn,
       [](TestRoom& r) {
         table(r).add("vase", "vase", {0.2, 0.2, 0.3}, {2.5, 2.4, 0.75}, "table").relation(Type::kOn, {"vase"}, {"table"});
       },
       {"vase", {0, 0, 0.02}}},
      {"on the left part",
       Type::kOn,
       [](TestRoom& r) {
         r.add("desk", "desk", {1.2, 0.6, 0.75}, {2, 3.7}).add("lamp", "table_lamp", {0.2, 0.2, 0.4}, {2.0, 3.7, 0.75}, "desk");
         r.relation(Type::kOn, {"lamp"}, {"desk"}, with([](auto& p) { p.part = "left"; }));
       },
       {"lamp", {0.02, 0}}},
      {"on the left corner",
       Type::kOn,
       [](TestRoom& r) {
         r.add("desk", "desk", {1.2, 0.6, 0.75}, {2, 3.7}).add("lamp", "table_lamp", {0.2, 0.2, 0.4}, {1.8, 3.8, 0.75}, "desk");
         r.relation(Type::kOn, {"lamp"}, {"desk"}, with([](auto& p) { p.part = "left corner"; }));
       },
       {"lamp", {0.02, 0}}},
      {"on a rug",
       Type::kOn,  // half extents 1.0 and 0.5: middles at most 1.0 − 0.25 apart
       [](TestRoom& r) {
         r.add("rug", "rug", {2, 1.4, 0.01}, {2, 2})
             .add("table", "coffee_table", {1, 0.6, 0.4}, {2.75, 2})
             .relation(Type::kOn, {"table"}, {"rug"});
       },
       {"table", {0.02, 0}}},
      {"on the floor", Type::kOn, [](TestRoom& r) { bed(r).relation(Type::kOn, {"bed"}, {"floor"}); }, {"bed", {0, 0, 0.02}}},
      {"on a sill",
       Type::kOn,
       [](TestRoom& r) {
         r.window("window1", "wall3", 2)
             .add("pot", "plant", {0.2, 0.2, 0.3}, {2.4, 3.9, 0.9}, "window1")
             .relation(Type::kOn, {"pot"}, {"window1"});
       },
       {"pot", {0, 0, 0.02}}},
      {"under",
       Type::kUnder,
       [](TestRoom& r) {
         table(r).add("rug", "rug", {2.4, 1.6, 0.01}, {3.3, 2}).relation(Type::kUnder, {"rug"}, {"table"});
       },
       {"rug", {0.02, 0}}},
      {"above",
       Type::kAbove,
       [](TestRoom& r) {
         bed(r)
             .add("picture", "painting", {0.8, 0.04, 0.5}, {2.5, 3.98, 1.2}, "wall3")
             .relation(Type::kAbove, {"picture"}, {"bed"}, with([](auto& p) { p.gap = 700; }));
       },
       {"picture", {0, 0, 0.02}}},
      {"above, off to the side",
       Type::kAbove,  // half extents 0.9 and 0.4: middles at most 0.7 apart
       [](TestRoom& r) {
         bed(r).add("picture", "painting", {0.8, 0.04, 0.5}, {3.2, 3.98, 1.2}, "wall3").relation(Type::kAbove, {"picture"}, {"bed"});
       },
       {"picture", {0.02, 0}}},
      {"in",
       Type::kIn,
       [](TestRoom& r) {
         r.add("shelf", "bookshelf", {1.0, 0.3, 1.8}, {2, 3.85})
             .space("middle", {-0.48, -0.15, 0.8}, {0.48, 0.14, 1.2})
             .add("book", "book", {0.2, 0.2, 0.25}, {2, 3.8, 0.8}, "shelf");
         r.relation(Type::kIn, {"book"}, {"shelf"}, with([](auto& p) { p.part = "middle"; }));
       },
       {"book", {0, -0.02}}},
      {"stacked",
       Type::kStacked,
       [](TestRoom& r) {
         r.add("a", "box", kStand, {2, 2})
             .add("b", "box", {0.3, 0.3, 0.3}, {2, 2, 0.5}, "a")
             .add("c", "box", {0.2, 0.2, 0.2}, {2, 2, 0.8}, "b");
         r.relation(Type::kStacked, {"a", "b", "c"});
       },
       {"c", {0, 0, 0.02}}},
      {"around",
       Type::kAround,
       [](TestRoom& r) {
         table(r)
             .add("a", "chair", kChair, {2.5, 0.9, 0, 180})
             .add("b", "chair", kChair, {2.5, 2.7})
             .add("c", "chair", kChair, {1.4, 2, 0, 90});
         r.relation(Type::kAround, {"a", "b", "c"}, {"table"});
       },
       {"a", {0, -0.02}}},
      {"eachSideOf",
       Type::kEachSideOf,
       [](TestRoom& r) {
         bed(r).add("a", "nightstand", kStand, {1.5, 3.8}).add("b", "nightstand", kStand, {3.5, 3.8});
         r.relation(Type::kEachSideOf, {"a", "b"}, {"bed"});
       },
       {"a", {0.02, 0}}},
      {"between",
       Type::kBetween,
       [](TestRoom& r) {
         r.add("a", "armchair", kChair, {1, 2}).add("b", "armchair", kChair, {3, 2}).add("lamp", "floor_lamp", kStand, {1.4, 2});
         r.relation(Type::kBetween, {"lamp"}, {"a", "b"});
       },
       {"lamp", {-0.02, 0}}},
      {"between, off the way",
       Type::kBetween,
       [](TestRoom& r) {
         r.add("a", "armchair", kChair, {1, 2}).add("b", "armchair", kChair, {3, 2}).add("lamp", "floor_lamp", kStand, {2, 2.2});
         r.relation(Type::kBetween, {"lamp"}, {"a", "b"});
       },
       {"lamp", {0, 0.02}}},
      {"row",
       Type::kRow,
       [](TestRoom& r) {
         r.add("a", "stool", kStand, {1, 2}).add("b", "stool", kStand, {1.6, 2}).add("c", "stool", kStand, {2.2, 2});
         r.relation(Type::kRow, {"a", "b", "c"}, {}, with([](auto& p) { p.axis = Axis::kX, p.gap = 200; }));
       },
       {"c", {0.02, 0}}},
      {"row by its backs",
       Type::kRow,
       [](TestRoom& r) {
         r.add("a", "cabinet", {0.6, 0.6, 1}, {1, 3.7})
             .add("b", "cabinet", {0.6, 0.4, 1}, {1.6, 3.8})
             .add("c", "cabinet", {0.6, 0.3, 1}, {2.2, 3.85});
         r.relation(Type::kRow, {"a", "b", "c"});
       },
       {"b", {0, -0.02}}},
      {"grid",
       Type::kGrid,
       [](TestRoom& r) {
         for (int i = 0; i < 5; ++i) r.add("d" + std::to_string(i), "desk", {0.6, 0.6, 0.7}, {1 + 1.0 * (i % 3), 1 + 1.2 * (i / 3)});
         r.relation(Type::kGrid, {"d0", "d1", "d2", "d3", "d4"}, {}, with([](auto& p) { p.columns = 3; }));
       },
       {"d4", {0, 0.04}},
       false},
      {"column",
       Type::kColumn,
       [](TestRoom& r) {
         r.add("a", "bench", {1, 0.4, 0.4}, {2, 1}).add("b", "bench", {1, 0.4, 0.4}, {2, 2}).relation(Type::kColumn, {"a", "b"});
       },
       {"b", {0.02, 0}},
       false},
      {"evenlySpaced",
       Type::kEvenlySpaced,
       [](TestRoom& r) {
         r.add("a", "stool", kStand, {1, 2}).add("b", "bench", {0.8, 0.4, 0.4}, {2.0, 2.3}).add("c", "stool", kStand, {3.0, 1.5});
         r.relation(Type::kEvenlySpaced, {"a", "b", "c"});
       },
       {"b", {0.02, 0}}},
      {"symmetricAbout",
       Type::kSymmetricAbout,
       [](TestRoom& r) {
         bed(r)
             .add("a", "nightstand", kStand, {1.2, 3.8})
             .add("b", "nightstand", kStand, {3.8, 3.8})
             .relation(Type::kSymmetricAbout, {"a", "b"}, {"bed"});
       },
       {"b", {0.02, 0}}},
      {"surround",
       Type::kSurround,  // three: neighbours at most 180° apart
       [](TestRoom& r) {
         r.add("table", "table", {1, 1, 0.7}, {2.5, 2})
             .add("a", "chair", kChair, {3.3, 2, 0, 270})
             .add("b", "chair", kChair, {2.5, 2.8})
             .add("c", "chair", kChair, {1.7, 1.99, 0, 90});
         r.relation(Type::kSurround, {"a", "b", "c"}, {"table"});
       },
       {"c", {0, 0.1}}},
      {"pairedWith",
       Type::kPairedWith,
       [](TestRoom& r) {
         r.add("d1", "desk", {1, 0.6, 0.7}, {1, 3})
             .add("d2", "desk", {1, 0.6, 0.7}, {3.5, 3})
             .add("c1", "chair", kChair, {1, 2.4})
             .add("c2", "chair", kChair, {3.5, 2.0});
         r.relation(Type::kPairedWith, {"c1", "c2"}, {"d1", "d2"});
       },
       {"c2", {0, -0.02}}},
      {"clearance",
       Type::kClearance,
       [](TestRoom& r) {
         r.add("wardrobe", "wardrobe", {1.2, 0.6, 2}, {2, 3.7}).add("chest", "chest", kStand, {2.5, 2.3});
         r.relation(Type::kClearance, {"wardrobe"}, {}, with([](auto& p) { p.depth = 900; }));
       },
       {"chest", {0, 0.02}}},
      {"reachable",
       Type::kReachable,  // a gap of 0.6 m between two wardrobes
       [](TestRoom& r) {
         r.door("door1", "wall1", 2)
             .add("a", "wardrobe", {2.2, 0.6, 2}, {1.1, 2})
             .add("b", "wardrobe", {2.2, 0.6, 2}, {3.9, 2})
             .add("desk", "desk", {1, 0.6, 0.7}, {2.5, 3.7})
             .used({Side::kFront});
         r.relation(Type::kReachable, {"desk"});
       },
       {"a", {0.08, 0}}},
      {"keepClear",
       Type::kKeepClear,
       [](TestRoom& r) {
         bed(r).add("plant", "plant", kStand, {0.9, 3}).relation(Type::kKeepClear, {"plant"}, {"bed"});
       },
       {"plant", {0.02, 0}}},
      {"keepClear of a region",
       Type::kKeepClear,
       [](TestRoom& r) {
         r.add("sofa", "sofa", {2, 0.8, 0.8}, {2.5, 4.0 / 3 - 0.4}).relation(Type::kKeepClear, {"sofa"}, {}, with([](auto& p) {
                                                                               p.region = "middle";
                                                                             }));
       },
       {"sofa", {0, 0.02}}},
      {"keepClear of a door",
       Type::kKeepClear,
       [](TestRoom& r) {
         r.door("door1", "wall1", 2)
             .add("sofa", "sofa", {2, 0.8, 0.8}, {2.5, 1.4})
             .relation(Type::kKeepClear, {"sofa"}, {"door1"}, with([](auto& p) { p.depth = 1000; }));
       },
       {"sofa", {0, -0.02}}},
  };
  return kLimits;
}

Layout furnished(const Limit& limit, double share) {
  TestRoom room;
  limit.furnish(room);
  PlacedObject& object = room.object(limit.breaks.who);
  const Place& by = limit.breaks.by;
  object.position[0] += by.x * 1000 * share;
  object.position[1] += by.y * 1000 * share;
  object.position[2] += by.z * 1000 * share;
  object.rotation_deg += by.rotation * share;
  return room.layout;
}

const Check& relation_check(const Report& report) { return *find_check(report, "relation"); }

class RelationLimit : public testing::TestWithParam<Limit> {};

void expect_limit(const Limit& limit, const std::function<Layout(Layout)>& change, const std::string& how) {
  struct Step {
    double share;
    bool held;
  };
  for (const Step step : {Step{0, true}, Step{0.2, true}, Step{1, false}}) {
    const Report report = verify(change(furnished(limit, step.share)), Catalog::builtin());
    EXPECT_EQ(relation_check(report).passed, step.held) << how << ", moved by " << step.share << ": " << relation_check(report).message;
  }
}

TEST_P(RelationLimit, HeldJustHeldJustBroken) {
  expect_limit(
      GetParam(), [](Layout layout) { return layout; }, "as written");
}

TEST_P(RelationLimit, InATurnedRoom) {
  if (!GetParam().turns) GTEST_SKIP() << "speaks of the room's own axes";
  expect_limit(
      GetParam(), [](Layout layout) { return quarter_turned(std::move(layout)); }, "90 degrees");
  expect_limit(
      GetParam(), [](Layout layout) { return quarter_turned(quarter_turned(std::move(layout))); }, "180 degrees");
  expect_limit(
      GetParam(), [](Layout layout) { return quarter_turned(quarter_turned(quarter_turned(std::move(layout)))); }, "270 degrees");
}

TEST_P(RelationLimit, InAMirroredRoom) {
  expect_limit(
      GetParam(), [](Layout layout) { return mirrored(std::move(layout)); }, "mirrored");
}

TEST_P(RelationLimit, TheMessageHasFigures) {
  const Report report = verify(furnished(GetParam(), 1), Catalog::builtin());
  EXPECT_THAT(relation_check(report).message, testing::StartsWith(std::string(relation_row(GetParam().type).name) + " does not hold: "));
}

std::string test_name(const testing::TestParamInfo<Limit>& info) {
  std::string name = info.param.name;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, RelationLimit, testing::ValuesIn(limits()), test_name);

TEST(RelationLimits, CoverTheWholeTable) {
  std::set<Type> tested;
  for (const Limit& limit : limits()) tested.insert(limit.type);
  for (const RelationRow& row : relation_table()) EXPECT_TRUE(tested.contains(row.type)) << row.name;
}

}  // namespace
}  // namespace layoutbox::judge
