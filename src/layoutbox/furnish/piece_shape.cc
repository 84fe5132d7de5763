// A piece's meshes: solids that are added, parted by a hair, fitted to the box, raised on legs.
#include <algorithm>
#include <cmath>
#include <ranges>
#include <span>

#include "layoutbox/furnish/piece.h"

namespace layoutbox::kit {

void Piece::add(int surface, const Mesh& mesh) {
  Mesh& all = meshes_[surface];
  const std::size_t from = all.positions.size();
  append(all, mesh);
  solids_.push_back({surface, from, all.positions.size()});
}

// Faces that lie in one plane flicker, or are black: a solid is a hair smaller than those that were added after it, which are so to be
// seen.
void Piece::part_coincident_faces() {
  constexpr double kHair = 0.001, kOfThinnest = 0.004, kOfSide = 0.05;  // metres, shares
  const double hair = std::min(kHair, kOfThinnest * std::min({w, d, h}));
  for (std::size_t i = 0; i < solids_.size(); ++i) {
    const std::span<Vec3f> points =
        std::span(meshes_[solids_[i].surface].positions).subspan(solids_[i].from, solids_[i].to - solids_[i].from);
    const double less = hair * static_cast<double>(solids_.size() - 1 - i) / static_cast<double>(solids_.size());
    for (std::size_t axis = 0; axis < 3 && !points.empty(); ++axis) {
      const auto [least, most] =
          std::ranges::minmax(points | std::views::transform([axis](const Vec3f& v) { return static_cast<double>(v[axis]); }));
      const double side = most - least, middle = (least + most) / 2;
      const double share = side > 0 ? 1 - 2 * std::min(less, side * kOfSide) / side : 1;
      for (Vec3f& v : points) v[axis] = static_cast<float>(middle + (static_cast<double>(v[axis]) - middle) * share);
    }
  }
}

int Piece::turn(int n) const {
  const std::size_t digits = object_.id.find_last_not_of("0123456789") + 1;
  std::uint64_t number = 0;
  for (const char c : object_.id.substr(digits)) number = number * 10 + static_cast<std::uint64_t>(c - '0');
  return static_cast<int>(((kind_seed_ >> 7) + number) % static_cast<std::uint64_t>(n));
}

void Piece::light(Vec position, double watts, double radius) {
  Light light;
  light.position = {static_cast<float>(position.x), static_cast<float>(position.y), static_cast<float>(position.z)};
  light.watts = static_cast<float>(watts);
  light.radius = static_cast<float>(radius);
  // "A red emergency light", "blue neon": what is called a light shines in the colour that is said of it; a lamp has a shade of it.
  const std::string& name = object_.name;
  const bool shines =
      name.ends_with("light") || name.ends_with("lights") || name.ends_with("lighting") || name.find("neon") != std::string::npos;
  if (wish_.color && shines) {
    constexpr float kColored = 3;  // to be seen beside the daylight
    light.color = *wish_.color;
    light.watts *= kColored;
  }
  lights_.push_back(light);
}

void Piece::fit() {
  Box b{{1e9, 1e9, 1e9}, {-1e9, -1e9, -1e9}};
  for (const auto& [surface, mesh] : meshes_) {
    const Box m = bounds(mesh);
    b.min = {std::min(b.min.x, m.min.x), std::min(b.min.y, m.min.y), std::min(b.min.z, m.min.z)};
    b.max = {std::max(b.max.x, m.max.x), std::max(b.max.y, m.max.y), std::max(b.max.z, m.max.z)};
  }
  const Vec size = b.size(), c = b.center();
  const double kx = w / std::max(size.x, 1e-6), ky = d / std::max(size.y, 1e-6), kz = h / std::max(size.z, 1e-6);
  const Pose pose = scaled(kx, ky, kz) * moved(-c.x, -c.y, -b.min.z);
  for (auto& [surface, mesh] : meshes_) mesh = posed(std::move(mesh), pose);
  for (Light& light : lights_) {
    const Vec p = pose.point(
        {static_cast<double>(light.position[0]), static_cast<double>(light.position[1]), static_cast<double>(light.position[2])});
    light.position = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  }
}

void Piece::raise(double by) {
  constexpr double kLeg = 0.045, kFrame = 0.015;
  const Pose up = moved(0, 0, by);
  const auto most = std::ranges::max_element(meshes_, {}, [](const auto& m) { return m.second.indices.size(); });
  if (most == meshes_.end()) return;
  for (auto& [surface, mesh] : meshes_) mesh = posed(std::move(mesh), up);
  for (Light& light : lights_) light.position[2] += static_cast<float>(by);
  h += by;
  add(most->first, box({{-w / 2, -d / 2, by}, {w / 2, d / 2, by + kFrame}}));  // what is narrower below stands on it
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      const double x = sx * (w / 2 - kLeg / 2), y = sy * (d / 2 - kLeg / 2);
      add(most->first, box({{x - kLeg / 2, y - kLeg / 2, 0}, {x + kLeg / 2, y + kLeg / 2, by + 0.002}}));
    }
  }
}

void Piece::legs(int surface, double top, double thick, double inset, bool round, double taper_below) {
  if (top < 0.005) return;
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      // First towards the corner, then thinner, until the leg stands beside every space.
      double t = std::min({thick, w / 3, d / 3}), in = std::min({inset, w / 6, d / 6});
      const auto place = [&] {
        const double x = sx * (w / 2 - in - t / 2), y = sy * (d / 2 - in - t / 2);
        return Box{{x - t / 2, y - t / 2, 0}, {x + t / 2, y + t / 2, top}};
      };
      while (!is_free(place()) && in > 0) in = in > 0.004 ? in / 2 : 0;
      while (!is_free(place()) && t > 0.012) t *= 0.8;
      const Box b = place();
      const Vec c = b.center();
      if (round) {
        add(surface, cone({c.x, c.y, 0}, t / 2 * taper_below, t / 2, top, 14));
      } else if (taper_below < 1) {
        add(surface, taper({c.x, c.y, 0}, {t / 2 * taper_below, t / 2 * taper_below}, {c.x, c.y, top}, {t / 2, t / 2}));
      } else {
        add(surface, box(b));
      }
    }
  }
}

Node Piece::take_node() {
  part_coincident_faces();
  Node node;
  node.id = object_.id;
  node.kind = NodeKind::kObject;
  node.category = object_.category;
  node.name = object_.name;
  for (auto& [surface, mesh] : meshes_) {
    if (!mesh.indices.empty()) node.parts.push_back({std::move(mesh), surface});
  }
  node.lights = std::move(lights_);
  return node;
}

}  // namespace layoutbox::kit
