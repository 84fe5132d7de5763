// Collision, bounds and support of what is drawn.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "layoutbox/verify/checks.h"
#include "layoutbox/verify/drawn.h"
#include "layoutbox/verify/mesh.h"

namespace layoutbox {
namespace checks {
namespace {

constexpr double kMostDepth = 0.5;  // m: deeper is not measured

using Meshes = std::map<std::string, BodyMesh, std::less<>>;

void check_drawn_collisions(const RoomView& view, const Meshes& meshes, Report& report) {
  const double tolerance = view.options.collision_tolerance_m;
  std::map<std::string, BodyMesh, std::less<>> smaller;
  for (const auto& [id, mesh] : meshes) smaller.emplace(id, mesh.inset(tolerance / 2));
  std::map<std::string, bool, std::less<>> hit;
  for (std::size_t i = 0; i < view.bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < view.bodies.size(); ++j) {
      const Body &a = view.bodies[i], &b = view.bodies[j];
      const auto mesh_a = smaller.find(a.id()), mesh_b = smaller.find(b.id());
      if (a.rug || b.rug || mesh_a == smaller.end() || mesh_b == smaller.end() || !meet(mesh_a->second, mesh_b->second)) continue;
      hit[a.id()] = hit[b.id()] = true;
      const double depth = 2 * depth_of_meeting(meshes.at(a.id()), meshes.at(b.id()), kMostDepth);
      report.checks.push_back({"drawnCollision", a.id() + " / " + b.id(), false, false, depth, "m",
                               fmt::format("{} and {} as drawn go {} m into each other, at most {:.3f} m", a.id(), b.id(),
                                           figure_beside(depth, tolerance), tolerance),
                               object_pointer(b), tolerance});
    }
  }
  if (hit.empty()) {
    report.checks.push_back(
        {"drawnCollision", "all objects", true, false, 0, "m", "no two objects as drawn go into each other", "/objects", tolerance});
  }
  report.metrics["drawnCollisions"] = static_cast<double>(hit.size());
}

void check_drawn_bounds(const RoomView& view, const Meshes& meshes, Report& report) {
  int bad = 0;
  for (const Body& body : view.bodies) {
    const auto mesh = meshes.find(body.id());
    if (mesh == meshes.end()) continue;
    const double off = share_off(mesh->second, view.floor), through = mesh->second.box().z.hi - view.height;
    const bool outside = off > kOutsideShare, too_high = through > kCeilingReach + kTiny;
    bad += outside || too_high;
    Check check{"drawnOutOfBounds", body.id(), !outside && !too_high, false, off, "share", {}, object_pointer(body), kOutsideShare};
    check.message = outside ? fmt::format("{:.1f} % of the surface of {} as drawn is off the floor, at most 1 %", off * 100, body.id())
                            : fmt::format("{} as drawn is within the room", body.id());
    if (too_high && !outside) {
      check.value = through, check.unit = "m", check.limit = kCeilingReach;
      check.message = fmt::format("the top of {} as drawn is {} m above the ceiling", body.id(), figure_beside(through, 0));
    }
    report.checks.push_back(std::move(check));
  }
  report.metrics["drawnOutOfBounds"] = bad;
}

double gap_to_wall(const BodyMesh& mesh, const Face& wall) {
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& triangle : mesh.triangles()) {
    for (const Point3& p : triangle) least = std::min(least, distance_to_segment({p.x, p.y}, wall.start, wall.end));
  }
  return least;
}

// How far down, or out, a thing would have to go to touch what holds it.
double gap_to_body(const Body& body, const BodyMesh& mesh, const BodyMesh& holder, double tolerance) {
  const bool hung = body.object->mount == Mount::kHung;
  const auto touches = [&](double by) { return meet(hung ? mesh.inset(-by) : mesh.lowered(by), holder); };
  if (touches(tolerance)) return 0;
  // In steps, since far enough down it may have passed through a thin top.
  constexpr double kStep = 0.01;
  double near = tolerance + kStep;
  while (near < kMostDepth && !touches(near)) near += kStep;
  if (near >= kMostDepth) return kMostDepth;
  double apart = near - kStep;
  while (near - apart > 0.001) {
    const double half = (near + apart) / 2;
    (touches(half) ? near : apart) = half;
  }
  return near;
}

struct Held {
  std::string by;
  double gap = 0, tolerance = 0;
};

// Empty where the layout does not say it, or nothing drawn is there to hold it.
std::optional<Held> drawn_hold(const RoomView& view, const Meshes& meshes, const Body& body, const BodyMesh& mesh) {
  const std::string& by = body.object->supported_by;
  const double stands = view.options.support_tolerance_m, hangs = view.options.mount_tolerance_m;
  const MeshBox& box = mesh.box();
  if (by == "floor") return Held{by, std::abs(box.z.lo), stands};
  if (by == "ceiling") return Held{by, std::abs(view.height - box.z.hi), hangs};
  if (const Face* wall = view.find_wall(by)) return Held{by, gap_to_wall(mesh, *wall), hangs};
  if (const Face* window = view.find_opening(by)) return Held{by, std::abs(box.z.lo - window->shape.heights.lo), stands};
  const auto holder = meshes.find(by);
  if (holder == meshes.end()) return std::nullopt;
  const double tolerance = body.object->mount == Mount::kHung ? hangs : stands;
  return Held{by, gap_to_body(body, mesh, holder->second, tolerance), tolerance};
}

void check_drawn_support(const RoomView& view, const Meshes& meshes, Report& report) {
  int held = 0, all = 0;
  for (const Body& body : view.bodies) {
    const auto mesh = meshes.find(body.id());
    if (mesh == meshes.end()) continue;
    const std::optional<Held> hold = drawn_hold(view, meshes, body, mesh->second);
    if (!hold) continue;
    const bool good = hold->gap <= hold->tolerance + kTiny;
    ++all, held += good;
    report.checks.push_back(
        {"drawnSupport", body.id(), good, false, hold->gap, "m",
         good ? fmt::format("{} as drawn is held by {}", body.id(), hold->by)
              : fmt::format("{} as drawn is {} m from {}, which holds it", body.id(), figure_beside(hold->gap, hold->tolerance), hold->by),
         object_pointer(body), hold->tolerance});
  }
  report.metrics["drawnSupport"] = all == 0 ? 1.0 : held / static_cast<double>(all);
}

// An upright prism as a mesh: what comes into it meets it.
BodyMesh prism(const Polygon& plan, Interval heights) {
  std::vector<Triangle> faces;
  const auto at = [&](std::size_t i, double z) { return Point3{plan[i % plan.size()].x, plan[i % plan.size()].y, z}; };
  for (std::size_t i = 0; i < plan.size(); ++i) {
    faces.push_back({at(i, heights.lo), at(i + 1, heights.lo), at(i + 1, heights.hi)});
    faces.push_back({at(i, heights.lo), at(i + 1, heights.hi), at(i, heights.hi)});
    if (i == 0 || i + 1 == plan.size()) continue;
    for (const double z : {heights.lo, heights.hi}) faces.push_back({at(0, z), at(i, z), at(i + 1, z)});
  }
  return BodyMesh(std::move(faces), Frame{});
}

// What is drawn within a space that is to stay free; its share of the checks.
void check_space(const RoomView& view, const Meshes& meshes, const char* name, const Face& opening, const BodyMesh& space, Report& report,
                 int& clear) {
  const double tolerance = view.options.collision_tolerance_m;
  std::string blockers;
  for (const Body& body : view.bodies) {
    const auto mesh = meshes.find(body.id());
    if (mesh == meshes.end() || body.rug || (opening.is_window() && body.curtain)) continue;
    if (meet(mesh->second.inset(tolerance), space)) blockers += (blockers.empty() ? "" : ", ") + body.id();
  }
  clear += blockers.empty();
  report.checks.push_back({name, opening.id, blockers.empty(), false, blockers.empty() ? 0.0 : 1.0, "",
                           blockers.empty() ? fmt::format("nothing drawn is in the way of {}", opening.id)
                                            : fmt::format("{} as drawn in the way of {}", blockers, opening.id),
                           fmt::format("/room/openings/{}", opening.index)});
}

void check_drawn_openings(const RoomView& view, const Meshes& meshes, Report& report) {
  int clear = 0, openings = 0, swings = 0, doors = 0;
  for (const Face& opening : view.openings) {
    const Shape space = space_before(opening);
    ++openings;
    check_space(view, meshes, "drawnOpeningClearance", opening, prism(space.plan, space.heights), report, clear);
    if (opening.opening->type != OpeningType::kDoor) continue;
    const Polygon swing = swing_of(opening);
    ++doors;
    if (swing.size() < 3) {
      ++swings;
      continue;
    }
    check_space(view, meshes, "drawnDoorSwing", opening, prism(swing, opening.shape.heights), report, swings);
  }
  const auto share = [](int part, int whole) { return whole == 0 ? 1.0 : part / static_cast<double>(whole); };
  report.metrics["drawnOpeningClearance"] = share(clear, openings);
  report.metrics["drawnDoorSwing"] = share(swings, doors);
}

std::string drawn_name(const std::string& name) {
  return "drawn" + std::string(1, static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])))) + name.substr(1);
}

// Ways on the floor that what is drawn leaves free.
void check_drawn_ways(RoomView& view, const Meshes& meshes, Report& report) {
  for (Body& body : view.bodies) {
    if (const auto mesh = meshes.find(body.id()); mesh != meshes.end()) body.drawn = &mesh->second.triangles();
  }
  Report found;
  check_ways(view, found);
  for (Check& check : found.checks) {
    if (check.name == "navigability") check.limit = kLeastNavigability;
    if (check.name == "accessibility") check.limit = kLeastAccess;
    check.name = drawn_name(check.name);
    check.message += " (as drawn)";
    report.checks.push_back(std::move(check));
  }
  for (const auto& [name, value] : found.metrics) report.metrics[drawn_name(name)] = value;
}

}  // namespace
}  // namespace checks

void verify_drawn(const Layout& layout, const Catalog& catalog, const std::vector<DrawnObject>& drawn, const VerifyOptions& options,
                  Report& report) {
  checks::RoomView view(layout, catalog, options);
  checks::Meshes meshes;
  for (const DrawnObject& object : drawn) {
    const checks::Body* body = view.find_body(object.id);
    if (body != nullptr && !object.triangles.empty()) meshes.emplace(object.id, checks::BodyMesh(object.triangles, body->own_frame));
  }
  checks::check_drawn_collisions(view, meshes, report);
  checks::check_drawn_bounds(view, meshes, report);
  checks::check_drawn_support(view, meshes, report);
  checks::check_drawn_openings(view, meshes, report);
  checks::check_drawn_ways(view, meshes, report);
}

}  // namespace layoutbox
