#include "rooms.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>

#include "room_parts.h"

namespace layoutbox::bench {
namespace {

constexpr Mm kGrid = 20;  // sizes are whole multiples: middles and edges lie on a grid of 1 cm

struct Spot {
  Mm x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

bool meet(const Spot& a, const Spot& b) { return a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1; }

// Somewhere in the room; at its wall; in line with an earlier box. False: it sticks out.
bool put(const PlainRoom& room, const PlainBox& box, const std::vector<Spot>& placed, Random& random, Spot& spot) {
  Mm x = 10 * random.number(0, (room.width - box.width) / 10), y = 10 * random.number(0, (room.depth - box.depth) / 10);
  if (box.align >= 0) {
    const Spot& other = placed[box.align];
    if (box.axis == 0) x = (other.x0 + other.x1 - box.width) / 2;
    if (box.axis == 1) y = (other.y0 + other.y1 - box.depth) / 2;
  }
  if (box.wall == 0) y = 0;
  if (box.wall == 1) x = room.width - box.width;
  if (box.wall == 2) y = room.depth - box.depth;
  if (box.wall == 3) x = 0;
  spot = {x, y, x + box.width, y + box.depth};
  return x >= 0 && y >= 0 && spot.x1 <= room.width && spot.y1 <= room.depth;
}

constexpr std::size_t kMostAtWalls = 100;

bool plant(PlainRoom& room, Random& random) {
  std::vector<Spot> placed;
  for (std::size_t i = 0; i < room.boxes.size(); ++i) {
    PlainBox& box = room.boxes[i];
    bool found = false;
    // Of very many the half finds no room at the walls, which grow with the root of their number: there the later ones stand free.
    const int attempts = room.boxes.size() > kMostAtWalls ? 800 : 400;
    for (int attempt = 0; attempt < attempts && !found; ++attempt) {
      box.wall = i % 2 == 0 && attempt < 400 ? random.number(0, 3) : -1;
      box.align = i > 0 && i % 3 == 1 ? random.number(0, static_cast<int>(i) - 1) : -1;
      box.axis = box.wall >= 0 ? (box.wall % 2 == 0 ? 0 : 1) : random.number(0, 1);
      Spot spot;
      if (!put(room, box, placed, random, spot)) continue;
      found = std::none_of(placed.begin(), placed.end(), [&](const Spot& s) { return meet(s, spot); });
      if (found) placed.push_back(spot);
    }
    if (!found) return false;
  }
  return true;
}

std::string id_of(std::size_t box) { return "box_" + std::to_string(box + 1); }

SceneGraph raw_scene(const PlainRoom& room) {
  SceneGraph scene;
  scene.room.polygon = {{0, 0}, {room.width, 0}, {room.width, room.depth}, {0, room.depth}};
  scene.room.height = 2600;
  scene.room.openings_given = true;
  for (std::size_t i = 0; i < room.boxes.size(); ++i) {
    const PlainBox& box = room.boxes[i];
    SceneObject& object = scene.objects.emplace_back();
    object.id = id_of(i), object.category = object.name = "object";
    const Size size{box.width, box.depth, 800};
    object.size = SizeRange{size, size, size};
    object.size_source = SizeSource::kUser;
    object.mount = Mount::kFloor;
    RelationParameters p;
    if (box.wall >= 0) {
      p.distance = 0;
      add(scene, RelationType::kOffset, {id_of(i)}, {"wall" + std::to_string(box.wall + 1)}, p);
    }
    if (box.align >= 0) {
      p = {};
      p.axis = box.axis == 0 ? Axis::kX : Axis::kY;
      p.edge = Edge::kCenter;
      add(scene, RelationType::kAlign, {id_of(i)}, {id_of(static_cast<std::size_t>(box.align))}, p);
    }
  }
  return scene;
}

}  // namespace

PlainRoom plain_room(int boxes, std::uint64_t seed) {
  for (std::uint64_t attempt = 0;; ++attempt) {
    Random random(seed * 1000 + attempt);
    PlainRoom room;
    double area = 0;
    for (int i = 0; i < boxes; ++i) {
      PlainBox box;
      box.width = kGrid * random.number(15, 90), box.depth = kGrid * random.number(15, 45);
      if (random.number(0, 1) == 1) std::swap(box.width, box.depth);
      area += double(box.width) * box.depth;
      room.boxes.push_back(box);
    }
    std::sort(room.boxes.begin(), room.boxes.end(),
              [](const PlainBox& a, const PlainBox& b) { return a.width * a.depth > b.width * b.depth; });
    const double aspect = random.number(100, 160) / 100.0;
    room.width = kGrid * static_cast<Mm>(std::lround(std::sqrt(area / 0.35 * aspect) / kGrid));
    room.depth = kGrid * static_cast<Mm>(std::lround(area / 0.35 / room.width / kGrid));
    const bool fits = std::all_of(room.boxes.begin(), room.boxes.end(),
                                  [&](const PlainBox& b) { return b.width <= room.width && b.depth <= room.depth; });
    if (fits && plant(room, random)) return room;
  }
}

SceneGraph scene_of(const PlainRoom& room) { return normalised(raw_scene(room)); }

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

const char* clash_kind_in_words(int kind) {
  constexpr const char* kWords[kClashKinds] = {"left of one another",
                                               "three in a ring, left of the next",
                                               "four offsets that do not add up",
                                               "centred on the same wall",
                                               "too wide for a wall",
                                               "too much for the floor"};
  return kWords[kind];
}

SceneGraph impossible_scene(int kind, std::uint64_t seed) {
  PlainRoom room = plain_room(15, seed);
  const auto box = [&](int k) { return id_of(static_cast<std::size_t>((seed * 3 + static_cast<std::uint64_t>(k) * 4 + 1) % 15)); };
  if (kind == 5) {
    for (PlainBox& b : room.boxes) b.width = b.width * 3 / 2 / kGrid * kGrid, b.depth = b.depth * 2;
    for (PlainBox& b : room.boxes) b.width = std::min(b.width, room.width), b.depth = std::min(b.depth, room.depth), b.wall = b.align = -1;
  }
  SceneGraph scene = raw_scene(room);
  RelationParameters p;
  switch (kind) {
    case 0:
      add(scene, RelationType::kLeftOf, {box(0)}, {box(1)});
      add(scene, RelationType::kLeftOf, {box(1)}, {box(0)});
      break;
    case 1:
      for (int k = 0; k < 3; ++k) add(scene, RelationType::kLeftOf, {box(k)}, {box((k + 1) % 3)});
      break;
    case 2:
      p.axis = Axis::kX;
      for (int k = 0; k < 3; ++k) p.distance = 300 + 100 * k, add(scene, RelationType::kOffset, {box(k + 1)}, {box(k)}, p);
      p.distance = 50, p.axis = Axis::kX;
      add(scene, RelationType::kOffset, {box(3)}, {box(0)}, p);
      p.edge = Edge::kCenter, p.distance.reset();
      add(scene, RelationType::kAlign, {box(0)}, {box(3)}, p);
      break;
    case 3:
      add(scene, RelationType::kCenteredOnWall, {box(0)}, {"wall3"});
      add(scene, RelationType::kCenteredOnWall, {box(1)}, {"wall3"});
      break;
    case 4: {
      Mm sum = 0;
      for (std::size_t i = 0; i < room.boxes.size() && sum <= room.width; ++i) {
        // Whatever way they are turned, and with the corners shared with no other wall.
        sum += std::min(room.boxes[i].width, room.boxes[i].depth);
        add(scene, RelationType::kAgainstWall, {id_of(i)}, {"wall3"});
      }
      break;
    }
    default: break;
  }
  return normalised(std::move(scene));
}

}  // namespace layoutbox::bench
