#include "layoutbox/pipeline/edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "layoutbox/catalog/normalize.h"
#include "layoutbox/pipeline/edit_changes.h"
#include "layoutbox/scene/layout_scene.h"
#include "layoutbox/verify/verify.h"

namespace layoutbox {
namespace {

using Ids = std::vector<std::string>;
using R = RelationType;

bool has(const Ids& ids, const std::string& id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); }

bool is_support(R type) { return type == R::kOn || type == R::kIn || type == R::kStacked; }
bool is_turn(R type) { return type == R::kFacing || type == R::kParallel || type == R::kPerpendicular || type == R::kSameOrientation; }
// Says where its targets are, and not only which way they look or what stays free.
bool places(R type) {
  return !is_turn(type) && type != R::kClearance && type != R::kReachable && type != R::kKeepClear && type != R::kNotBlocking;
}

// What a factor or a new length makes of a side. A height that is said loosely keeps to what things of the kind have.
Result<Size> resized(const Size& size, const EditResize& resize, const CatalogEntry& entry, const std::string& id) {
  Size made = size;
  const bool swapped = resize.longer_side && size.depth > size.width;
  const std::array<Mm*, 3> sides = {swapped ? &made.depth : &made.width, swapped ? &made.width : &made.depth, &made.height};
  for (std::size_t i = 0; i < 3; ++i) {
    const EditResize::Side& side = resize.sides[i];
    const Mm before = *sides[i];
    *sides[i] = side.exact ? *side.exact : static_cast<Mm>(std::lround(before * side.factor)) + side.more;
    const bool loosely = resize.sides[0].factor != 1 && resize.sides[1].factor != 1;
    if (i == 2 && loosely) {
      *sides[i] = std::clamp(*sides[i], std::min(before, entry.size.least.height), std::max(before, entry.size.greatest.height));
    }
    if (*sides[i] < 5 || *sides[i] > 20'000) {
      return fail(ErrorCode::kGeometry, fmt::format("{} would have a side of {:.2f} m", id, m_from_mm(*sides[i])), "text",
                  "sides lie between 0.005 m and 20 m");
    }
  }
  return made;
}

// One edit: a scene that changes step by step, and a layout that guides the solver to the places.
class Edit {
 public:
  Edit(const Layout& before, const Catalog& catalog, SolveOptions solve)
      : before_(before), catalog_(catalog), solve_(std::move(solve)), scene_(scene_of(before)), guide_(before) {
    for (std::size_t i = 0; i < before.relations.size() && i < scene_.relations.size(); ++i) {
      // What was given up before is no reason to refuse now.
      if (before.relations[i].relation.hard && !before.relations[i].held) soften(scene_.relations[i]);
    }
  }

  Result<EditOutcome> run(std::string_view text) {
    LAYOUTBOX_ASSIGN(EditPlan plan, plan_edit(text, before_, catalog_));
    for (const EditStep& step : plan.steps) {
      for (const std::string& id : step.targets) asked_.insert(id);
      for (const SceneObject& object : step.objects) asked_.insert(object.id);
      LAYOUTBOX_CHECK(apply(step));
    }
    remove_what_stood_on_it();
    drop_relations_of_what_is_gone();
    if (!before_.prompt.empty()) scene_.prompt += "\n";
    scene_.prompt += text;
    number_relations();
    EditOutcome outcome;
    outcome.notes = std::move(plan.notes);
    LAYOUTBOX_ASSIGN(outcome.layout, place());
    settle(outcome);
    return outcome;
  }

 private:
  SceneObject* object(const std::string& id) {
    const auto found = std::find_if(scene_.objects.begin(), scene_.objects.end(), [&](const SceneObject& o) { return o.id == id; });
    return found == scene_.objects.end() ? nullptr : &*found;
  }
  PlacedObject* guide(const std::string& id) {
    const auto found = std::find_if(guide_.objects.begin(), guide_.objects.end(), [&](const PlacedObject& o) { return o.id == id; });
    return found == guide_.objects.end() ? nullptr : &*found;
  }

  void soften(Relation& relation) {
    if (relation.hard) softened_.insert(relation.id);
    relation.hard = false;
  }

  // What was asked for of a thing's place holds on as a wish.
  template <class Which>
  void soften_targets(const std::string& id, const Which& which) {
    for (Relation& relation : scene_.relations) {
      if (has(relation.targets, id) && which(relation.type)) soften(relation);
    }
  }

  void remove_support(const std::string& id) {
    for (std::size_t i = 0; i < scene_.relations.size();) {
      Relation& relation = scene_.relations[i];
      if (!is_support(relation.type) || !has(relation.targets, id) || relation.references.empty()) {
        ++i;
        continue;
      }
      std::erase(relation.targets, id);
      if (!relation.targets.empty()) {
        ++i;
        continue;
      }
      if (!relation.assumed) dropped_.push_back(scene_.relations[i]), dropped_.back().targets = {id};
      scene_.relations.erase(scene_.relations.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

  Status apply(const EditStep& step) {
    switch (step.kind) {
      case EditKind::kAdd: return add(step);
      case EditKind::kRemove: return remove(step.targets);
      case EditKind::kMove: return move(step);
      case EditKind::kShift: return shift(step);
      case EditKind::kSwap: return swap(step.targets[0], step.targets[1]);
      case EditKind::kReplace: return replace(step);
      case EditKind::kTurn: return step.relations.empty() ? turn(step) : face(step);
      case EditKind::kResize: return resize(step);
      case EditKind::kRecolor: return recolor(step);
      case EditKind::kRename:
        if (SceneObject* named = object(step.targets[0])) named->name = step.name;
        return {};
      case EditKind::kKeep: solve_.locked.insert(solve_.locked.end(), step.targets.begin(), step.targets.end()); return {};
    }
    return {};
  }

  Status add(const EditStep& step) {
    scene_.objects.insert(scene_.objects.end(), step.objects.begin(), step.objects.end());
    scene_.relations.insert(scene_.relations.end(), step.relations.begin(), step.relations.end());
    return {};
  }

  Status remove(const Ids& ids) {
    for (const std::string& id : ids) {
      std::erase_if(scene_.objects, [&](const SceneObject& o) { return o.id == id; });
      std::erase_if(guide_.objects, [&](const PlacedObject& o) { return o.id == id; });
    }
    return {};
  }

  Status move(const EditStep& step) {
    const bool carried = std::any_of(step.relations.begin(), step.relations.end(), [](const Relation& r) { return is_support(r.type); });
    const bool on_wall = std::any_of(step.relations.begin(), step.relations.end(), [](const Relation& r) { return r.type == R::kOnWall; });
    const bool turns = std::any_of(step.relations.begin(), step.relations.end(), [](const Relation& r) { return is_turn(r.type); });
    const bool only_turns = std::all_of(step.relations.begin(), step.relations.end(), [](const Relation& r) { return is_turn(r.type); });
    if (only_turns) return face(step);
    for (const std::string& id : step.targets) {
      SceneObject* moved = object(id);
      if (moved == nullptr) continue;
      soften_targets(id, [turns](R type) { return places(type) || (turns && is_turn(type)); });
      if (carried) {
        remove_support(id);
        moved->mount = Mount::kSurface;
      } else if (moved->mount == Mount::kSurface) {
        stand_beside(*moved, step.relations);
      }
      if (on_wall) moved->mount = Mount::kWall;
      solve_.freed.push_back(id);
    }
    scene_.relations.insert(scene_.relations.end(), step.relations.begin(), step.relations.end());
    return {};
  }

  // "Move the lamp next to the clock": on what the clock stands on; beside a thing on the floor it stands on the floor.
  void stand_beside(SceneObject& moved, const std::vector<Relation>& relations) {
    for (const Relation& relation : relations) {
      if (!has(relation.targets, moved.id) || relation.references.empty()) continue;
      const PlacedObject* neighbour = guide(relation.references.front());
      if (neighbour == nullptr || neighbour->id == before_support(moved.id)) continue;
      remove_support(moved.id);
      if (guide(neighbour->supported_by) != nullptr) {
        Relation on;
        on.type = R::kOn;
        on.targets = {moved.id};
        on.references = {neighbour->supported_by};
        on.assumed = true;
        on.why = relation.why;
        scene_.relations.push_back(std::move(on));
      } else {
        moved.mount = Mount::kFloor;
      }
      return;
    }
  }

  std::string before_support(const std::string& id) const {
    const PlacedObject* placed = before_.find_object(id);
    return placed == nullptr ? std::string() : placed->supported_by;
  }

  Status face(const EditStep& step) {
    for (const std::string& id : step.targets) {
      soften_targets(id,
                     [](R type) { return is_turn(type) || type == R::kAgainstWall || type == R::kCenteredOnWall || type == R::kCorner; });
    }
    scene_.relations.insert(scene_.relations.end(), step.relations.begin(), step.relations.end());
    return {};
  }

  Status shift(const EditStep& step) {
    for (const std::string& id : step.targets) {
      const PlacedObject* placed = guide(id);
      if (placed == nullptr) continue;
      LAYOUTBOX_ASSIGN(const auto way, way_of(*placed, *step.shift, guide_, has_place(id)));
      soften_targets(id, [](R type) { return places(type) && !is_support(type); });
      pins_.push_back({id, placed->position, way, placed->rotation_deg, !step.shift->distance});
    }
    return {};
  }

  bool has_place(const std::string& id) const { return before_.find_object(id) != nullptr; }

  Status turn(const EditStep& step) {
    for (const std::string& id : step.targets) {
      const PlacedObject* placed = guide(id);
      if (placed == nullptr) continue;
      if (placed->mount == Mount::kWall) {
        return fail(ErrorCode::kGeometry, fmt::format("{} hangs on a wall and looks away from it", id), "text", "move it to another wall");
      }
      soften_targets(id, [](R type) {
        return is_turn(type) || type == R::kAgainstWall || type == R::kCenteredOnWall || type == R::kCorner || type == R::kSideAgainstWall;
      });
      pins_.push_back({id, placed->position, {0, 0, 0}, normalized_degrees(placed->rotation_deg + step.degrees), false});
      pins_.back().may_move = true;
    }
    return {};
  }

  Status swap(const std::string& a, const std::string& b) {
    // Where they stand is swapped; what is said of other things by them stays.
    for (Relation& relation : scene_.relations) {
      const bool of_a = has(relation.targets, a), of_b = has(relation.targets, b);
      const bool by_a = has(relation.references, a), by_b = has(relation.references, b);
      if (of_a == of_b && !(of_a && by_b) && !(of_b && by_a)) continue;
      if (!places(relation.type) && !is_turn(relation.type)) continue;
      const auto exchange = [&](std::string& id) { id = id == a ? b : id == b ? a : id; };
      std::for_each(relation.targets.begin(), relation.targets.end(), exchange);
      if ((of_a && by_b) || (of_b && by_a)) std::for_each(relation.references.begin(), relation.references.end(), exchange);
      soften(relation);
    }
    PlacedObject *first = guide(a), *second = guide(b);
    SceneObject *first_object = object(a), *second_object = object(b);
    if (first == nullptr || second == nullptr || first_object == nullptr || second_object == nullptr) return {};
    const PlacedObject old = *first;
    take_place(*first, *second);
    take_place(*second, old);
    std::swap(first_object->mount, second_object->mount);
    return {};
  }

  Status replace(const EditStep& step) {
    for (std::size_t i = 0; i < step.objects.size(); ++i) {
      SceneObject fresh = step.objects[i];
      if (i < step.targets.size()) {
        const std::string& old_id = step.targets[i];
        const SceneObject* old = object(old_id);
        const CatalogEntry& entry = catalog_.entry_or_nearest(fresh.category);
        const bool same_mount = old != nullptr && old->mount == entry.mount;
        if (old != nullptr && (same_mount || old->mount == Mount::kSurface)) fresh.mount = old->mount;
        for (Relation& relation : scene_.relations) {
          for (Ids* ids : {&relation.targets, &relation.references}) {
            if (!has(*ids, old_id)) continue;
            std::replace(ids->begin(), ids->end(), old_id, fresh.id);
            if (!same_mount) soften(relation);
          }
        }
        if (const PlacedObject* place = guide(old_id)) {
          PlacedObject placed = *place;
          placed.id = fresh.id;
          placed.size = fresh.size ? fresh.size->usual : entry.size.usual;
          placed.spaces.clear();
          take_place(placed, *place);
          guide_.objects.push_back(placed);
          for (PlacedObject& other : guide_.objects) {
            if (other.supported_by == old_id) other.supported_by = fresh.id;
          }
        }
      } else {
        Relation beside;
        beside.type = R::kNextTo;
        beside.targets = {fresh.id};
        beside.references = {step.objects.front().id};
        beside.hard = false;
        beside.assumed = true;
        beside.why = step.why;
        scene_.relations.push_back(std::move(beside));
      }
      scene_.objects.push_back(std::move(fresh));
    }
    return remove(step.targets);
  }

  Status resize(const EditStep& step) {
    for (const std::string& id : step.targets) {
      SceneObject* changed = object(id);
      if (changed == nullptr || !changed->size) continue;
      LAYOUTBOX_ASSIGN(const Size size, resized(changed->size->usual, step.resize, catalog_.entry_or_nearest(changed->category), id));
      changed->size = SizeRange{size, size, size};
      changed->size_source = SizeSource::kUser;
      changed->spaces.clear();
      changed->spaces_given = false;
      if (PlacedObject* placed = guide(id)) {  // its back stays where it is
        PlacedObject grown = *placed;
        grown.size = size;
        grown.spaces.clear();
        take_place(grown, *placed);
        *placed = grown;
      }
    }
    return {};
  }

  Status recolor(const EditStep& step) {
    for (const std::string& id : step.targets) {
      std::string words;
      for (const std::string& attribute : step.attributes) words += (words.empty() ? "" : " ") + attribute;
      if (id == "walls") {
        scene_.room.wall_material = words;
        for (Wall& wall : scene_.room.walls) wall.material.clear();
      } else if (id == "floor") {
        scene_.room.floor_material = words + " floor";
      }
      SceneObject* changed = object(id);
      if (changed == nullptr) continue;
      std::erase_if(changed->attributes, [&](const std::string& a) { return has(step.dropped_attributes, a); });
      for (std::size_t i = 0; i < step.attributes.size(); ++i) {
        if (!has(changed->attributes, step.attributes[i])) changed->attributes.push_back(step.attributes[i]);
        if (step.attribute_class[i] == "size") {
          changed->size.reset();  // by its words, from the catalogue
          changed->size_source = SizeSource::kUnknown;
          changed->spaces.clear();
          changed->spaces_given = false;
        } else {
          changed->material.clear();
        }
      }
    }
    return {};
  }

  // A lamp goes with the table it stood on, unless the edit gives it another place.
  void remove_what_stood_on_it() {
    for (bool found = true; found;) {
      found = false;
      for (const PlacedObject& placed : before_.objects) {
        const std::string& support = placed.supported_by;
        if (object(placed.id) == nullptr || before_.find_object(support) == nullptr || object(support) != nullptr) continue;
        const PlacedObject* now = guide(placed.id);
        const bool elsewhere = (now != nullptr && now->supported_by != support) || has(solve_.freed, placed.id);
        if (elsewhere) continue;
        static_cast<void>(remove({placed.id}));
        found = true;
      }
    }
  }

  void drop_relations_of_what_is_gone() {
    const auto gone = [&](const std::string& id) { return before_.find_object(id) != nullptr && object(id) == nullptr; };
    std::vector<Relation> kept;
    for (Relation& relation : scene_.relations) {
      const bool referred = !relation.references.empty();
      const Relation whole = relation;
      std::erase_if(relation.targets, gone);
      std::erase_if(relation.references, gone);
      const bool alone =
          relation.targets.size() < 2 && whole.targets.size() >= 2 && relation_row(relation.type).arity == RelationArity::kNone &&
          (relation.type == R::kRow || relation.type == R::kGrid || relation.type == R::kColumn || relation.type == R::kEvenlySpaced);
      if (relation.targets.empty() || (referred && relation.references.empty()) || alone) {
        if (!whole.assumed) dropped_.push_back(whole);
        softened_.erase(whole.id);
        continue;
      }
      kept.push_back(std::move(relation));
    }
    scene_.relations = std::move(kept);
  }

  // New relations get ids that no earlier one has.
  void number_relations() {
    std::set<std::string> ids;
    for (const Relation& relation : scene_.relations) ids.insert(relation.id);
    int number = 0;
    for (Relation& relation : scene_.relations) {
      if (!relation.id.empty()) continue;
      do {
        relation.id = "e" + std::to_string(++number);
      } while (ids.contains(relation.id));
      ids.insert(relation.id);
    }
  }

  // A thing that is put exactly somewhere.
  struct Pin {
    std::string id;
    std::array<double, 3> from{}, way{};
    double rotation = 0;
    bool loose = false;     // a shorter way will do
    bool may_move = false;  // turned on the spot, or else beside it
  };

  // How an attempt differs from what is said: how much of a loose way is gone along x and y, how far what turns steps towards the middle
  // of the room, and whether it may step anywhere.
  struct Attempt {
    double share_x = 1, share_y = 1, step_in = 0;
    bool turn_free = false;
  };

  std::array<double, 2> middle() const {
    std::array<double, 2> sum{};
    for (const Point& corner : before_.room.polygon) sum[0] += corner.x, sum[1] += corner.y;
    const auto count = static_cast<double>(std::max<std::size_t>(before_.room.polygon.size(), 1));
    return {sum[0] / count, sum[1] / count};
  }

  std::array<double, 3> position_of(const Pin& pin, const Attempt& attempt) const {
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

  Result<Layout> solve_with(const Attempt& attempt) {
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
          facing.type = R::kFacing;
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
  Status check_pins(const Layout& layout) const {
    if (pins_.empty()) return {};
    const Report report = verify(layout, catalog_);
    for (const Check& check : report.checks) {
      if (check.passed || !check.required || check.name == "relation") continue;
      const auto concerned = [&](const Pin& pin) { return has(split(check.subject), pin.id); };
      if (std::any_of(pins_.begin(), pins_.end(), concerned)) {
        return fail(ErrorCode::kInfeasible, "it would not stand well there: " + check.message, "text", "say another way, or less of it");
      }
    }
    return {};
  }

  // "bed_1 / desk_1": both.
  static Ids split(const std::string& subject) {
    Ids ids(1);
    for (const char c : subject) {
      if (c == ' ' || c == '/') {
        if (!ids.back().empty()) ids.emplace_back();
      } else {
        ids.back() += c;
      }
    }
    return ids;
  }

  // A way of which nothing is left is no answer.
  bool something_moved(const Attempt& attempt) const {
    return std::all_of(pins_.begin(), pins_.end(), [&](const Pin& pin) { return pin.may_move || position_of(pin, attempt) != pin.from; });
  }

  // As exactly as it is said; a little less where that is loose.
  Result<Layout> place() {
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

  // What the outcome says: which wishes are dropped, what changed.
  void settle(EditOutcome& outcome) {
    Layout& layout = outcome.layout;
    std::vector<PlacedRelation> kept;
    for (PlacedRelation& placed : layout.relations) {
      if (placed.relation.id.starts_with("turned_")) continue;
      const bool was_soft = softened_.contains(placed.relation.id);
      const auto before = std::find_if(before_.relations.begin(), before_.relations.end(),
                                       [&](const PlacedRelation& r) { return r.relation.id == placed.relation.id; });
      const bool given_up_before = before != before_.relations.end() && !before->held;
      if (was_soft && !placed.held && !given_up_before) {
        dropped_.push_back(placed.relation);
        continue;
      }
      if (was_soft) placed.relation.hard = true;
      kept.push_back(std::move(placed));
    }
    layout.relations = std::move(kept);
    for (const Relaxation& relaxation : before_.relaxed) {
      const auto still = std::find_if(layout.relations.begin(), layout.relations.end(),
                                      [&](const PlacedRelation& r) { return r.relation.id == relaxation.relation && !r.held; });
      if (still != layout.relations.end()) layout.relaxed.push_back(relaxation);
    }
    if (!layout.relaxed.empty() && layout.status == LayoutStatus::kSolved) layout.status = LayoutStatus::kRelaxed;
    for (PlacedObject& placed : layout.objects) {
      const PlacedObject* was = before_.find_object(placed.id);
      placed.fixed = was != nullptr && was->fixed;
    }
    outcome.scene = outcome_scene_;
    outcome.scene.relations.clear();
    for (const PlacedRelation& placed : layout.relations) outcome.scene.relations.push_back(placed.relation);
    for (SceneObject& object : outcome.scene.objects) {
      const PlacedObject* was = before_.find_object(object.id);
      object.fixed = was != nullptr && was->fixed;
    }
    outcome.dropped = std::move(dropped_);
    outcome.changes = changes_between(before_, layout, asked_);
  }

  const Layout& before_;
  const Catalog& catalog_;
  SolveOptions solve_;
  SceneGraph scene_, outcome_scene_;
  Layout guide_;
  std::vector<Pin> pins_;
  std::set<std::string> asked_, softened_;
  std::vector<Relation> dropped_;
};

}  // namespace

Result<EditOutcome> edit_layout(std::string_view text, const Layout& layout, const Catalog& catalog, SolveOptions solve) {
  return Edit(layout, catalog, std::move(solve)).run(text);
}

}  // namespace layoutbox
