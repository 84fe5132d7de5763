// Object and opening: just held, and the move that breaks them.
#include "limits.h"

namespace layoutbox::checks {

std::vector<Limit> opening_limits() {
  return {
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
             .add("chest", "chest", {1.2, 0.6, 0.8}, {2.4, 3.7})
             .add("box", "box", {1.2, 0.6, 0.2}, {2.4, 3.7, 0.8}, "chest")
             .relation(Type::kUnderWindow, {"box"}, {"window1"});
       },
       {"box", {0, 0, 0.02}},
       false},
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
  };
}

}  // namespace layoutbox::checks
