#include "layoutbox/solve/solving.h"

#include "layoutbox/solve/conflict/relax.h"
#include "layoutbox/solve/search/search.h"

namespace layoutbox::placement {
namespace {

constexpr std::size_t kMostTrials = 40;

}  // namespace

// Does a search place everything but these? How many it fails to place.
std::size_t Solver::unplaced_without(const std::vector<std::string>& ids) {
  const LessScene less = without_objects(scene(), ids);
  const Result<PlacementModel> model = build_model(less.scene, catalog_, guides());
  if (!model) return asked_.objects.size();
  Search search(*model, scope_in(*model), options_.seed, kAllSizes);
  Budget budget = part(budgets_.trial);
  return search.construct(kRestarts, budget) ? 0 : std::max<std::size_t>(1, search.failed().size());
}

// Leaves out the object (one of the items, of all where none are named) without which everything else finds a place; where one is not
// enough, the one that helps most. Of equals the one that is missed least.
Status Solver::leave_out_least(std::vector<ItemId> items, const Clash* clash) {
  if (items.empty()) {
    for (const ItemId i : model_.items.ids()) items.push_back(i);
    items = least_missed_first(model_, std::move(items));
  }
  // What nobody asked for goes first, even where more than one of it has to: what finds a place after all comes back.
  if (!items.empty() && !is_asked(items.front())) std::erase_if(items, [&](ItemId i) { return is_asked(i); });
  if (items.size() > kMostTrials) items.resize(kMostTrials);
  Clash found;
  if (clash != nullptr) {
    LAYOUTBOX_ASSIGN(found, smallest_crowd(*clash));
  }
  if (clash == nullptr) {
    found.proven = found.minimal = false;
    found.sentence = too_much_in_words(model_, scope_);
  }
  if (options_.on_conflict != OnConflict::kRelax) {  // no layout comes of it: which one goes only shows whether there are other conflicts
    LAYOUTBOX_ASSIGN(const bool relaxing, note_conflict(found, items.empty() || is_asked(items.front())));
    if (!relaxing) return {};
    if (items.empty()) return fail(ErrorCode::kNotFound, "no layout was found, and nothing is left to give up");
    return leave_out(items.front(), conflicts_.back().conflict.sentence);
  }
  ItemId best;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const ItemId item : items) {
    const std::size_t unplaced = items.size() == 1 ? 1 : unplaced_without({model_.items[item].id});
    if (unplaced < least) least = unplaced, best = item;
    if (least == 0 || enough()) break;
  }
  if (!best.exists()) return fail(ErrorCode::kNotFound, "no layout was found, and nothing is left to give up");
  LAYOUTBOX_ASSIGN(const bool relaxing, note_conflict(found, is_asked(best)));
  return relaxing ? leave_out(best, conflicts_.back().conflict.sentence) : Status{};
}

// The last that went first; companions after all that was asked for, and none where there is not even floor before a door.
std::vector<std::string> Solver::may_be_brought_back() const {
  std::vector<std::string> asked(left_out_ids_.rbegin(), left_out_ids_.rend()), added;
  if (made_way_) {
    for (const SceneObject& object : asked_.objects) {
      if (object.origin == Origin::kAdded && std::erase(asked, object.id) > 0) added.push_back(object.id);
    }
    for (const ConstraintId c : model_.constraints.ids()) {
      if (scope_.given_up[c] && is_door_floor(c)) added.clear();
    }
  }
  // Where one went after the other there was no layout without the last: that is why it went.
  if (!shed_ && !asked.empty()) asked.erase(asked.begin());
  asked.insert(asked.end(), added.begin(), added.end());
  return asked;
}

// What was left out before and finds a place now after all comes back.
Result<bool> Solver::bring_back() {
  constexpr int kMostInVain = 3;  // trials with companions of one kind
  bool any = false;
  std::map<std::string, int> in_vain;
  for (const std::string& back : may_be_brought_back()) {
    if (enough()) break;
    std::vector<std::string> fewer = left_out_ids_;
    std::erase(fewer, back);
    const SceneObject& object = *asked_.find_object(back);
    if (object.origin == Origin::kAdded) {
      const std::vector<std::string> alone = companions_left_alone(asked_, catalog_, fewer);
      if (std::ranges::find(alone, back) != alone.end() || in_vain[object.category]++ >= kMostInVain) continue;
    }
    const LessScene less = without_objects(asked_, fewer);
    const Result<PlacementModel> model = build_model(less.scene, catalog_, guides());
    if (!model) continue;
    Search search(*model, scope_in(*model), options_.seed, kAllSizes);
    Budget budget = part(budgets_.trial);
    if (!search.construct(kRestarts, budget)) continue;
    in_vain[object.category] = 0;
    left_out_ids_ = std::move(fewer);
    std::erase_if(reasons_, [&](const Relaxation& r) { return r.relation == back; });
    LAYOUTBOX_CHECK(rebuild());
    brought_ = search.placements();
    any = true;
  }
  return any;
}

// What its relations say, while that can still be said.
void Solver::note_lost_by(ItemId item) {
  const std::string& id = model_.items[item].id;
  for (const Relation& relation : scene().relations) {
    const auto names = [&](const std::vector<std::string>& ids) { return std::find(ids.begin(), ids.end(), id) != ids.end(); };
    if (names(relation.targets) || names(relation.references)) lost_words_[relation.id] = relation_in_words(model_, relation);
  }
}

// It goes with the next rebuild().
void Solver::note_left_out(ItemId item, const std::string& why) {
  note_lost_by(item);
  left_out_ids_.push_back(model_.items[item].id);
  reasons_.push_back({model_.items[item].id, 0, "", object_in_words(model_, item) + " is left out: " + why});
}

// The object goes; relations keep whom they still have.
Status Solver::leave_out(ItemId item, const std::string& why) {
  note_left_out(item, why);
  return rebuild();
}

// The model of what is left of the scene, with the same given up as before.
Status Solver::rebuild() {
  leave_out_the_lonely();
  LessScene less = without_objects(asked_, left_out_ids_);
  less_scene_ = std::make_unique<SceneGraph>(std::move(less.scene));
  lost_ = std::move(less.lost);
  LAYOUTBOX_ASSIGN(model_, build_model(*less_scene_, catalog_, guides()));
  size_to_model();
  for (const auto& [name, why] : relaxed_) soften(name);
  return {};
}

}  // namespace layoutbox::placement
