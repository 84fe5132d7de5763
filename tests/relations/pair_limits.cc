// Two objects: just held, and the move that breaks them.
#include "limits.h"

namespace layoutbox::checks {

std::vector<Limit> pair_limits() {
  return {
      {"leftOf",
       Type::kLeftOf,
       [](TestRoom& r) {
         bed(r).add("stand", "nightstand", kStand, {1.5, 3.8}).relation(Type::kLeftOf, {"stand"}, {"bed"});
       },
       {"stand", {0.02, 0}}},
      {"leftOf, in line",
       Type::kLeftOf,
       [](TestRoom& r) {
         bed(r).add("stand", "nightstand", kStand, {1.4, 2.04}).relation(Type::kLeftOf, {"stand"}, {"bed"});
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
         r.door("door1", "wall1", 2).add("mat", "rug", {0.6, 0.4, 0.01}, {2.84, 0.3}).relation(Type::kInFrontOf, {"mat"}, {"door1"});
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
             .add("lamp", "pendant_lamp", kStand, {2.5, 3, 2.1}, "ceiling")
             .relation(Type::kDistance, {"lamp"}, {"bed"}, with([](auto& p) { p.max = 1600; }));
       },
       {"lamp", {0, 0, 0.02}},
       false},
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
                                                                          p.edge = Edge::kBack;
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
      {"opposite as a group: nobody behind another",
       Type::kOpposite,
       [](TestRoom& r) {
         r.add("s", "sofa", {2, 0.9, 0.8}, {2.5, 3.5})
             .add("a", "armchair", kChair, {2.5 - kChair[0] / 2, 1.2, 0, 180})
             .add("b", "armchair", kChair, {2.5 + kChair[0] / 2, 1.2, 0, 180})
             .relation(Type::kOpposite, {"a", "b"}, {"s"});
       },
       {"a", {0.02, -0.8}}},
      {"opposite as a group: before the middle",
       Type::kOpposite,
       [](TestRoom& r) {
         r.add("s", "sofa", {2, 0.9, 0.8}, {2.5, 3.5})
             .add("a", "armchair", kChair, {2.5 + kChair[0] / 2, 1.2, 0, 180})
             .add("b", "armchair", kChair, {2.6 + 3 * kChair[0] / 2, 1.2, 0, 180})
             .relation(Type::kOpposite, {"a", "b"}, {"s"});
       },
       {"a", {0.02, 0}}},
      {"opposite as a group: turned away",
       Type::kOpposite,
       [](TestRoom& r) {
         r.add("s", "sofa", {2, 0.9, 0.8}, {2.5, 3.5})
             .add("a", "armchair", kChair, {1.9, 1.2, 0, 180})
             .add("b", "armchair", kChair, {3.1, 1.2, 0, 180})
             .relation(Type::kOpposite, {"a", "b"}, {"s"});
       },
       {"b", {0, 0, 0, 60}}},
      {"opposite a door",
       Type::kOpposite,
       [](TestRoom& r) {
         r.door("door1", "wall1", 2).add("a", "armchair", kChair, {2.86, 1.7}).relation(Type::kOpposite, {"a"}, {"door1"});
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
         bed(r).add("stand", "nightstand", kStand, {1.4, 3.334}).relation(Type::kAtHeadOf, {"stand"}, {"bed"});
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
  };
}

}  // namespace layoutbox::checks
