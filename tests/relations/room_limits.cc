// Object and room: just held, and the move that breaks them.
#include "limits.h"

namespace layoutbox::checks {

std::vector<Limit> room_limits() {
  return {
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
      {"againstWall, through it",
       Type::kAgainstWall,
       [](TestRoom& r) {
         r.add("bed", "bed", kBed, {2, 3}).relation(Type::kAgainstWall, {"bed"}, {"wall3"});
       },
       {"bed", {0, 0.02}},
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
         r.add("desk", "desk", {1, 0.6, 0.7}, {2.5, 3}).relation(Type::kInRegion, {"desk"}, {}, with([](auto& p) {
                                                                   p.region = RoomRegion::kLeft;
                                                                 }));
       },
       {"desk", {0.02, 0}}},
      {"inRegion, middle",
       Type::kInRegion,
       [](TestRoom& r) {
         r.add("desk", "desk", {1, 0.6, 0.7}, {2.5 + 5.0 / 6, 2}).relation(Type::kInRegion, {"desk"}, {}, with([](auto& p) {
                                                                             p.region = RoomRegion::kMiddle;
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
         r.add("lamp", "pendant_lamp", {0.4, 0.4, 0.5}, {2, 2, 2.1}, "ceiling").relation(Type::kOnCeiling, {"lamp"});
       },
       {"lamp", {0, 0, -0.02}}},
      {"awayFromWall",
       Type::kAwayFromWall,
       [](TestRoom& r) {
         r.add("sofa", "sofa", {2, 0.9, 0.8}, {1.5, 2}).relation(Type::kAwayFromWall, {"sofa"});
       },
       {"sofa", {-0.02, 0}}},
  };
}

}  // namespace layoutbox::checks
