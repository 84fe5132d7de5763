// Where things are in the end: as exactly as the text says, a little less where that is loose.
#include <cmath>

#include "layoutbox/catalog/normalize.h"
#include "layoutbox/edit/changes.h"
#include "layoutbox/edit/placer.h"
#include "layoutbox/edit/stepper.h"
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

// An id for a relation that keeps the thing turned.
std::string unused_id(const SceneGraph& scene, const std::string& turned) {
  std::string id = "turned_" + turned;
  while (std::any_of(scene.relations.begin(), scene.relations.end(), [&](const Relation& r) { return r.id == id; })) id += "_";
  return id;
}

}  // namespace

EditPlacer::EditPlacer(const EditState& state, const Layout& before, const Catalog& catalog, SolveOptions solve)
    : state_(state), before_(before), catalog_(catalog), solve_(std::move(solve)) {
  solve_.freed.insert(solve_.freed.end(), state.freed.begin(), state.freed.end());
  solve_.locked.insert(solve_.locked.end(), state.locked.begin(), state.locked.end());
}

std::array<double, 2> EditPlacer::middle() const {
  std::array<double, 2> sum{};
  for (const Point& corner : before_.room.polygon) sum[0] += corner.x, sum[1] += corner.y;
  const auto count = static_cast<double>(std::max<std::size_t>(before_.room.polygon.size(), 1));
  return {sum[0] / count, sum[1] / count};
}

std::array<double, 3> EditPlacer::position_of(const EditPin& pin, const Attempt& attempt) const {
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

Result<Layout> EditPlacer::solve_with(const Attempt& attempt) {
  SceneGraph scene = state_.scene;
  Layout guide = state_.guide;
  for (const EditPin& pin : state_.pins) {
    for (SceneObject& object : scene.objects) {
      if (object.id != pin.id) continue;
      const std::array<double, 3> position = position_of(pin, attempt);
      const auto side = side_looked_at(pin.rotation);
      if (attempt.turn_free && pin.may_move && side) {  // which way it looks is what counts; it may step aside
        Relation facing;
        facing.id = unused_id(scene, pin.id);
        aids_.insert(facing.id);
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
Status EditPlacer::check_pins(const Layout& layout) const {
  if (state_.pins.empty()) return {};
  const Report report = verify(layout, catalog_);
  for (const Check& check : report.checks) {
    if (check.passed || !check.required || check.name == "relation") continue;
    const auto concerned = [&](const EditPin& pin) { return has_id(split(check.subject), pin.id); };
    if (std::any_of(state_.pins.begin(), state_.pins.end(), concerned)) {
      return fail(ErrorCode::kInfeasible, "it would not stand well there: " + check.message, "text", "say another way, or less of it");
    }
  }
  return {};
}

// A way of which nothing is left is no answer.
bool EditPlacer::something_moved(const Attempt& attempt) const {
  return std::all_of(state_.pins.begin(), state_.pins.end(),
                     [&](const EditPin& pin) { return pin.may_move || position_of(pin, attempt) != pin.from; });
}

// As exactly as it is said; a little less where that is loose.
Result<Layout> EditPlacer::place() {
  auto first = solve_with({});
  if (first || state_.pins.empty() || first.error().code == ErrorCode::kInterrupted || first.error().code == ErrorCode::kNoSolver)
    return first;
  std::vector<Attempt> attempts;
  if (std::any_of(state_.pins.begin(), state_.pins.end(), [](const EditPin& pin) { return pin.loose; })) {
    for (const double share : {1.0, 0.5, 0.2}) {
      for (const auto& [x, y] : {std::pair{share, share}, {share, 0.0}, {0.0, share}}) attempts.push_back({x, y, 0, false});
    }
    attempts.erase(attempts.begin());
  }
  const auto quarter = [](const EditPin& pin) { return pin.may_move && side_looked_at(pin.rotation); };
  const auto askew = [](const EditPin& pin) { return pin.may_move && !side_looked_at(pin.rotation); };
  if (std::any_of(state_.pins.begin(), state_.pins.end(), quarter)) attempts.push_back({1, 1, 0, true});
  if (std::any_of(state_.pins.begin(), state_.pins.end(), askew)) {
    for (const double step : {50.0, 100.0, 200.0, 400.0, 700.0, 1000.0}) attempts.push_back({1, 1, step, false});
  }
  for (const Attempt& attempt : attempts) {
    if (solve_.stop != nullptr && solve_.stop->load()) break;
    if (auto layout = solve_with(attempt); layout && something_moved(attempt)) return layout;
  }
  return first;
}

}  // namespace layoutbox
