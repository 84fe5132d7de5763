#include "layoutbox/solve/solving.h"

#include "layoutbox/solve/conflict/relax.h"
#include "layoutbox/solve/model/to_layout.h"
#include "layoutbox/solve/objective/access.h"
#include "layoutbox/solve/objective/terms.h"

namespace layoutbox::placement {

// How far what was given up is from holding; nothing where it holds after all.
std::optional<Relaxation> Solver::relaxation_of(const std::string& name, const std::string& why) const {
  const auto found =
      std::find_if(model_.constraints.begin(), model_.constraints.end(), [&](const Constraint& c) { return c.name == name; });
  if (found == model_.constraints.end()) return std::nullopt;  // its objects are left out
  const Constraint& constraint = *found;
  const ConstraintId index = model_.constraints.id_of(constraint);
  Relaxation out{constraint.name, 0, "m", why};
  bool placed = all_placed(constraint, placements_);
  std::int64_t miss = placed ? miss_of(model_, constraint, placements_) : 0;
  for (const ItemId i : model_.items.ids()) {
    if (model_.items[i].clearance_constraint != index) continue;
    placed = placements_[i].state >= 0;
    if (placed) miss = intrusion_of(model_, i, placements_);
  }
  if (placed && miss == 0) return std::nullopt;
  if (!placed || miss > 100'000'000) return Relaxation{constraint.name, 0, "", why};  // it can never hold, or its object is left out
  out.by = static_cast<double>(miss) / 1000;
  return out;
}

// Is there none where one is asked for? The search knows nothing of ways, only the improvement does.
bool Solver::lacks_a_way() const {
  const auto asks = [](const Relation& r) { return r.type == RelationType::kReachable && r.hard; };
  if (std::ranges::none_of(scene().relations, asks)) return false;
  const Layout layout = to_layout(model_, placements_);
  return std::ranges::any_of(layout.relations, [&](const PlacedRelation& r) { return asks(r.relation) && !r.held; });
}

// What does not hold: what was asked for is given up, all else gave way.
void Solver::list_what_is_missed(Layout& layout) {
  const auto list = [&](bool asked, Relaxation item) { (asked ? layout.relaxed : layout.gave_way).push_back(std::move(item)); };
  const auto asks_for = [&](const std::string& name) {
    const auto is_it = [&](const Constraint& c) { return c.name == name; };
    const auto found = std::find_if(model_.constraints.begin(), model_.constraints.end(), is_it);
    return found == model_.constraints.end() || !is_assumption(model_, *found);
  };
  const auto asks_for_relation = [&](const std::string& id) {
    return std::any_of(asked_.relations.begin(), asked_.relations.end(), [&](const Relation& r) { return r.id == id && r.asked(); });
  };
  for (const auto& [name, why] : relaxed_) {
    if (const auto relaxation = relaxation_of(name, why)) list(asks_for(name), *relaxation);
  }
  for (const PlacedObject& placed : layout.objects) {
    const SceneObject* object = scene().find_object(placed.id);
    const bool hangs = object->mount == Mount::kWall || object->mount == Mount::kCeiling;
    if (!hangs || !object->mount_assumed || placed.supported_by != "floor") continue;
    const std::string words = object_in_words(model_, model_.find_item(placed.id));
    list(false, {"mount of " + placed.id, 0, "",
                 words + " stands on the floor, though things of its kind hang: else what was asked for would not hold"});
  }
  for (const Relaxation& reason : reasons_) {
    const SceneObject* object = asked_.find_object(reason.relation);
    list(object == nullptr || object->asked(), reason);
  }
  for (const std::string& id : lost_) list(asks_for_relation(id), {id, 0, "", lost_words_[id] + ": what it speaks of is left out"});
  for (const PlacedRelation& r : layout.relations) {  // what no proof knows of: ways to walk, two things that would hold one
    if (r.held || !r.relation.hard || layout.lists_as_given_up(r.relation.id)) continue;
    const bool way = r.relation.type == RelationType::kReachable;
    list(r.relation.asked(),
         {r.relation.id, 0, "",
          (way ? "no free way was found: " : "no layout was found such that ") + relation_in_words(model_, r.relation)});
  }
}

Layout Solver::finish() {
  Layout layout = to_layout(model_, placements_);
  sum_up_shedding();
  list_what_is_missed(layout);
  for (const Noted& noted : conflicts_) {
    if (noted.asked) layout.conflicts.push_back(noted.conflict);
  }
  layout.status = fallback_ ? LayoutStatus::kFallback : layout.relaxed.empty() ? LayoutStatus::kSolved : LayoutStatus::kRelaxed;
  if (layout.status == LayoutStatus::kSolved) layout.conflicts.clear();  // what seemed impossible was only not found
  double total = 0;
  for (const auto& [name, cost] : scored_costs(model_, placements_)) {
    layout.score_terms[std::string(name)] = 1.0 / (1.0 + static_cast<double>(cost) / 1e6);
    total += static_cast<double>(cost) / 1e6;
  }
  layout.score = 1.0 / (1.0 + total);
  layout.stats.solver = used_cp_sat_ ? "search+cp-sat" : "search";
  layout.stats.proven = proven_best_ && layout.status == LayoutStatus::kSolved;
  layout.stats.seed = options_.seed;
  layout.stats.stopped_by_clock = stopped_by_clock_;
  layout.stats.seconds = seconds();
  return layout;
}

}  // namespace layoutbox::placement
