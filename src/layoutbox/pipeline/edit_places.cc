// Where things are in the end: as exactly as the text says, a little less where that is loose.
#include <cmath>

#include "layoutbox/catalog/normalize.h"
#include "layoutbox/pipeline/edit_changes.h"
#include "layoutbox/pipeline/edit_work.h"
#include "layoutbox/verify/verify.h"

namespace layoutbox {
namespace {

// "bed_1 / desk_1": both.
std::vector<std::string> split(const std::string& subject) {
  std::vector<std::string> ids(1);
  for (const char c : subject) {
    if (c == ' ' || c == '/') {
      if (!ids.back().empty()) ids.emplace_back();
    } else {
      ids.back() += c;
    }
  }
  return ids;
}

}  // namespace

std::array<double, 2> Edit::middle() const {
  std::array<double, 2> sum{};
  for (const Point& corner : before_.room.polygon) sum[0] += corner.x, sum[1] += corner.y;
  const auto count = static_cast<double>(std::max<std::size_t>(before_.room.polygon.size(), 1));
  return {sum[0] / count, sum[1] / count};
}

std::array<double, 3> Edit::position_of(const Pin& pin, const Attempt& attempt) const {
  std::array<double, 3> position = pin.from;
  const std::array<double, 3> shares =
      pin.loose ? std::array<double, 3>{attempt.share_x, attempt.share_y, 1} : std::array<double, 3>{1, 1, 1};
  for (std::size_t i = 0; i < 3; ++i) position[i] += std::round(pin.way[i] * shares[i] / kGridMm) * kGridMm;
  if (pin.may_move && attempt.step_in > 0) {
    const auto center = middle();
    const double dx = center[0] - position[0], dy = center[1] - position[1], far = std::max(std::hypot(dx, dy), 1.0);
    position[0] += std::round(dx / far * attempt.step_in / kGridMm) * kGridMm;
    position[1] += std::round(dy / far * attempt.step_in / kGridMm) * kGridMm;
  }
  return position;
}

Result<Layout> Edit::solve_with(const Attempt& attempt) {
  SceneGraph scene = scene_;
  Layout guide = guide_;
  for (const Pin& pin : pins_) {
    for (SceneObject& object : scene.objects) {
      if (object.id != pin.id) continue;
      const std::array<double, 3> position = position_of(pin, attempt);
      const auto side = side_looked_at(pin.rotation);
      if (attempt.turn_free && pin.may_move && side) {  // which way it looks is what counts; it may step aside
        Relation facing;
        facing.id = "turned_" + pin.id;
        facing.type = RelationType::kFacing;
        facing.targets = {pin.id};
        facing.references = {wall_on_side(scene.room.walls, *side)->id};
        scene.relations.push_back(std::move(facing));
      } else {
        object.fixed = true;
        object.hint = {position, pin.rotation, false};
      }
      for (PlacedObject& placed : guide.objects) {
        if (placed.id == pin.id) placed.position = position, placed.rotation_deg = pin.rotation;
      }
    }
  }
  LAYOUTBOX_ASSIGN(outcome_scene_, normalize_scene(std::move(scene), catalog_));
  solve_.from = &guide;
  solve_.on_conflict = OnConflict::kFail;
  auto layout = solve(outcome_scene_, catalog_, solve_);
  solve_.from = nullptr;
  if (layout) LAYOUTBOX_CHECK(check_pins(*layout));
  return layout;
}

// What is fixed may stand anywhere as far as the solver is concerned: what the text puts exactly somewhere must be well there.
Status Edit::check_pins(const Layout& layout) const {
  if (pins_.empty()) return {};
  const Report report = verify(layout, catalog_);
  for (const Check& check : report.checks) {
    if (check.passed || !check.required || check.name == "relation") continue;
    const auto concerned = [&](const Pin& pin) { return has_id(split(check.subject), pin.id); };
    if (std::any_of(pins_.begin(), pins_.end(), concerned)) {
      return fail(ErrorCode::kInfeasible, "it would not stand well there: " + check.message, "text", "say another way, or less of it");
    }
  }
  return {};
}

// A way of which nothing is left is no answer.
bool Edit::something_moved(const Attempt& attempt) const {
  return std::all_of(pins_.begin(), pins_.end(), [&](const Pin& pin) { return pin.may_move || position_of(pin, attempt) != pin.from; });
}

// As exactly as it is said; a little less where that is loose.
Result<Layout> Edit::place() {
  auto first = solve_with({});
  if (first || pins_.empty() || first.error().code == ErrorCode::kInterrupted || first.error().code == ErrorCode::kNoSolver) return first;
  std::vector<Attempt> attempts;
  if (std::any_of(pins_.begin(), pins_.end(), [](const Pin& pin) { return pin.loose; })) {
    for (const double share : {1.0, 0.5, 0.2}) {
      for (const auto& [x, y] : {std::pair{share, share}, {share, 0.0}, {0.0, share}}) attempts.push_back({x, y, 0, false});
    }
    attempts.erase(attempts.begin());
  }
  const auto quarter = [](const Pin& pin) { return pin.may_move && side_looked_at(pin.rotation); };
  const auto askew = [](const Pin& pin) { return pin.may_move && !side_looked_at(pin.rotation); };
  if (std::any_of(pins_.begin(), pins_.end(), quarter)) attempts.push_back({1, 1, 0, true});
  if (std::any_of(pins_.begin(), pins_.end(), askew)) {
    for (const double step : {50.0, 100.0, 200.0, 400.0}) attempts.push_back({1, 1, step, false});
  }
  for (const Attempt& attempt : attempts) {
    if (solve_.stop != nullptr && solve_.stop->load()) break;
    if (auto layout = solve_with(attempt); layout && something_moved(attempt)) return layout;
  }
  return first;
}

}  // namespace layoutbox
