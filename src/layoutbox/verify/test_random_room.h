// For tests: furniture thrown into a room. Most of it collides, stands in the air or reaches through a wall.
#pragma once

#include <random>

#include "layoutbox/verify/test_room.h"

namespace layoutbox::checks {

class RandomRoom {
 public:
  explicit RandomRoom(unsigned seed) : random_(seed) {}

  Layout make() {
    TestRoom room(2 + 0.1 * number(0, 50), 2 + 0.1 * number(0, 40), 2.5);
    width_ = width_of(room.layout), depth_ = depth_of(room.layout);
    room.door("door1", "wall1", 0.4, 0.9).window("window1", "wall3", 0.3, 1.2, 0.9);
    if (number(0, 3) == 0) cut_corner(room.layout);
    const int count = number(1, 14);
    for (int i = 0; i < count; ++i) add(room, "o" + std::to_string(i));
    return room.layout;
  }

 private:
  struct Kind {
    const char* category;
    std::array<double, 3> size;
    std::vector<Side> used;  // as in the scorer's own table
  };

  int number(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }

  // An L: the far right quarter is missing.
  void cut_corner(Layout& layout) {
    const Mm x = width_ * 2 / 3, y = depth_ * 2 / 3;
    layout.room.polygon = {{0, 0}, {width_, 0}, {width_, y}, {x, y}, {x, depth_}, {0, depth_}};
    layout.room.walls.clear();
    for (std::size_t i = 0; i < 6; ++i) {
      Wall wall;
      wall.id = "wall" + std::to_string(i + 1);
      wall.start = layout.room.polygon[i], wall.end = layout.room.polygon[(i + 1) % 6];
      layout.room.walls.push_back(wall);
    }
    layout.room.openings[1].wall = "wall6";
    layout.room.openings[1].offset = 300;
  }

  void add(TestRoom& room, const std::string& id) {
    static const std::vector<Kind> kKinds{{"bed", {1.6, 2.0, 0.5}, {Side::kFront, Side::kLeft, Side::kRight}},
                                          {"desk", {1.2, 0.6, 0.75}, {Side::kFront}},
                                          {"wardrobe", {1.2, 0.6, 2.0}, {Side::kFront}},
                                          {"chair", {0.45, 0.45, 0.6}, {Side::kFront, Side::kBack, Side::kLeft, Side::kRight}},
                                          {"rug", {1.6, 1.2, 0.02}, {}},
                                          {"plant", {0.3, 0.3, 0.8}, {}},
                                          {"bookshelf", {0.8, 0.3, 1.8}, {Side::kFront}}};
    static constexpr std::array kTurns{0.0, 90.0, 180.0, 270.0, 0.0, 90.0, 33.0, 247.5};
    static constexpr std::array kLifts{0.0, 0.0, 0.0, 0.004, 0.02};
    const Kind& kind = kKinds[static_cast<std::size_t>(number(0, static_cast<int>(kKinds.size()) - 1))];
    TestPlace place{0.01 * number(0, width_ / 10), 0.01 * number(0, depth_ / 10), kLifts[static_cast<std::size_t>(number(0, 4))],
                    kTurns[static_cast<std::size_t>(number(0, 7))]};
    std::string on = "floor";
    if (!room.layout.objects.empty() && number(0, 3) == 0) {
      const PlacedObject& host = room.layout.objects[static_cast<std::size_t>(number(0, static_cast<int>(room.layout.objects.size()) - 1))];
      const double top = number(0, 1) == 0 || host.spaces.empty() ? host.size.height : host.spaces.front().min[2];
      place = {host.position[0] / 1000 + 0.01 * number(-40, 40), host.position[1] / 1000 + 0.01 * number(-20, 20),
               (host.position[2] + top) / 1000 + place.z, place.rotation};
      on = host.id;
      room.add(id, "book", {0.2, 0.15, 0.25}, place, on);
      return;
    }
    if (number(0, 6) == 0) {
      room.add(id, "painting", {0.6, 0.04, 0.5}, {0.01 * number(30, width_ / 10), depth_ / 1000.0 - 0.01 * number(1, 5), 1.5},
               room.layout.room.openings[1].wall);
      return;
    }
    room.add(id, kind.category, kind.size, place, on).used(kind.used);
    if (std::string(kind.category) == "desk") room.space("knees", {-0.55, -0.3, 0}, {0.55, 0.25, 0.68}, false);
    if (std::string(kind.category) == "bookshelf")
      room.space("low", {-0.38, -0.15, 0.1}, {0.38, 0.14, 0.9}).space("high", {-0.38, -0.15, 0.92}, {0.38, 0.14, 1.78});
  }

  std::mt19937 random_;
  Mm width_ = 0, depth_ = 0;
};

}  // namespace layoutbox::checks
