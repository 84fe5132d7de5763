#include "layoutbox/judge/vlm/planted.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "layoutbox/base/random.h"
#include "layoutbox/verify/verify.h"

namespace layoutbox::vlm {
namespace {

constexpr double kThroughWall = 400, kInTheAir = 600, kLeastStep = 300;  // mm

bool on_floor(const PlacedObject& object) { return object.supported_by == "floor"; }

// What stands on an object goes where it goes.
void move(Layout& layout, std::size_t i, double dx, double dy, double dz) {
  const std::string id = layout.objects[i].id;
  layout.objects[i].position[0] += dx, layout.objects[i].position[1] += dy, layout.objects[i].position[2] += dz;
  for (std::size_t j = 0; j < layout.objects.size(); ++j) {
    if (layout.objects[j].supported_by == id) move(layout, j, dx, dy, dz);
  }
}

bool turn(Layout& layout, std::size_t i) {
  if (!on_floor(layout.objects[i])) return false;
  layout.objects[i].rotation_deg = std::fmod(layout.objects[i].rotation_deg + 90, 360.0);
  return true;
}

// Each keeps its turn, as if somebody had mixed them up.
bool swap_with_next(Layout& layout, std::size_t i) {
  const std::size_t j = (i + 1) % layout.objects.size();
  const PlacedObject a = layout.objects[i], b = layout.objects[j];
  const double dx = b.position[0] - a.position[0], dy = b.position[1] - a.position[1];
  if (!on_floor(a) || !on_floor(b) || a.category == b.category || std::hypot(dx, dy) < kLeastStep) return false;
  move(layout, i, dx, dy, 0);
  move(layout, j, -dx, -dy, 0);
  return true;
}

bool into_next(Layout& layout, std::size_t i) {
  const std::size_t j = (i + 1) % layout.objects.size();
  const PlacedObject &a = layout.objects[i], &b = layout.objects[j];
  if (i == j || !on_floor(a) || !on_floor(b)) return false;
  move(layout, i, (b.position[0] - a.position[0]) * 0.8, (b.position[1] - a.position[1]) * 0.8, 0);
  return true;
}

bool through_wall(Layout& layout, std::size_t i) {
  const PlacedObject& object = layout.objects[i];
  if (!on_floor(object)) return false;
  const double turned = object.rotation_deg * 3.14159265358979 / 180;
  const double half = (object.size.width * std::abs(std::cos(turned)) + object.size.depth * std::abs(std::sin(turned))) / 2;
  double left = object.position[0];
  for (const Point& corner : layout.room.polygon) left = std::min(left, static_cast<double>(corner.x));
  move(layout, i, left + half - kThroughWall - object.position[0], 0, 0);
  return true;
}

bool hang(Layout& layout, std::size_t i) {
  if (!on_floor(layout.objects[i])) return false;
  move(layout, i, 0, 0, kInTheAir);
  return true;
}

struct PlantedKind {
  const char* name;
  bool (*plant)(Layout& layout, std::size_t object);
};
constexpr std::array kKinds{PlantedKind{"turned", &turn}, PlantedKind{"swapped", &swap_with_next},
                            PlantedKind{"moved into another", &into_next}, PlantedKind{"through a wall", &through_wall},
                            PlantedKind{"hung in the air", &hang}};

// What a required check says; empty where the room passes.
std::string fault_in(const Layout& layout, const Catalog& catalog) {
  for (const Check& check : verify(layout, catalog).checks) {
    if (check.required && !check.passed) return check.message;
  }
  return {};
}

}  // namespace

std::vector<PlantedFault> plant_faults(const Layout& sound, const Catalog& catalog, std::uint64_t seed) {
  std::vector<PlantedFault> faults;
  if (sound.objects.empty() || !fault_in(sound, catalog).empty()) return faults;
  std::vector<std::size_t> order(sound.objects.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  Random(seed).shuffle(order);
  for (const PlantedKind& kind : kKinds) {
    for (const std::size_t i : order) {
      Layout layout = sound;
      if (!kind.plant(layout, i)) continue;
      std::string why = fault_in(layout, catalog);
      if (why.empty()) continue;
      faults.push_back({kind.name, sound.objects[i].id, std::move(why), std::move(layout)});
      break;
    }
  }
  return faults;
}

}  // namespace layoutbox::vlm
