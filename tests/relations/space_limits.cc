// Space: just held, and the move that breaks them.
#include "limits.h"

namespace layoutbox::checks {

std::vector<Limit> space_limits() {
  return {
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
       {"a", {0.08, 0}},
       false},
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
                                                                               p.region = RoomRegion::kMiddle;
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
      {"reachable, with room to spare",
       Type::kReachable,  // a gap of 0.8 m
       [](TestRoom& r) {
         r.door("door1", "wall1", 2)
             .add("a", "wardrobe", {2.1, 0.6, 2}, {1.05, 2})
             .add("b", "wardrobe", {2.1, 0.6, 2}, {3.95, 2})
             .add("desk", "desk", {1, 0.6, 0.7}, {2.5, 3.7})
             .used({Side::kFront});
         r.relation(Type::kReachable, {"desk"});
       },
       {"a", {0.3, 0}}},
  };
}

}  // namespace layoutbox::checks
