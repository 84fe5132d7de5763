// Relations of an object and doors or windows.
#include <fmt/format.h>

#include <algorithm>

#include "layoutbox/verify/relation_check.h"

namespace layoutbox::checks {
namespace {

bool any_opening(const Face& face) { return face.opening != nullptr; }

bool names_something(const RelationCase& c) {
  return std::any_of(c.references.begin(), c.references.end(), [](const RelationReference& r) { return !r.is_place(); });
}

Finding near_face(const RelationCase& c, const Body& t, const Face& face) {
  return in_band(fmt::format("distance between {} and {}", t.id(), face.id), gap(t.shape, face.shape), c.metres(&RelationParameters::min),
                 c.metres(&RelationParameters::max), c.slack());
}

Finding far_from_all(const RelationCase& c, const std::function<bool(const Face&)>& wanted) {
  const std::vector<const Face*> faces = named_or_all(c, c.view.openings, wanted);
  if (faces.empty() && names_something(c)) return condition(false, "names neither a door nor a window");
  return each_target(c, [&](const Body& t) {
    std::vector<Finding> findings;
    for (const Face* face : faces) findings.push_back(near_face(c, t, *face));
    return all_of(std::move(findings));
  });
}

}  // namespace

Finding check_UnderWindow(const RelationCase& c) {
  const double max = c.metres(&RelationParameters::max).value_or(0);
  return each_target(c, [&](const Body& t) { return any_window(c, [&](const Face& window) { return below_window(c, t, window, max); }); });
}

Finding check_NearDoor(const RelationCase& c) {
  return each_target(c, [&](const Body& t) { return any_door(c, [&](const Face& door) { return near_face(c, t, door); }); });
}

Finding check_NearWindow(const RelationCase& c) {
  return each_target(c, [&](const Body& t) { return any_window(c, [&](const Face& window) { return near_face(c, t, window); }); });
}

Finding check_FarFromDoor(const RelationCase& c) {
  return far_from_all(c, [](const Face& face) { return face.is_door(); });
}

Finding check_FarFromWindow(const RelationCase& c) {
  return far_from_all(c, [](const Face& face) { return face.is_window(); });
}

Finding check_NotBlocking(const RelationCase& c) {
  const std::optional<double> depth = c.metres(&RelationParameters::depth);
  const std::vector<const Face*> faces = named_or_all(c, c.view.openings, any_opening);
  if (faces.empty() && names_something(c)) return condition(false, "names neither a door nor a window");
  return each_target(c, [&](const Body& t) {
    std::vector<Finding> findings;
    for (const Face* face : faces) findings.push_back(keeps_out_of_opening(c, t, *face, depth));
    return all_of(std::move(findings));
  });
}

}  // namespace layoutbox::checks
