// The moves of an improvement, and what they gain.
#include "layoutbox/solve/objective/cost.h"
#include "layoutbox/solve/search/search.h"

namespace layoutbox::placement {
namespace {

constexpr std::int64_t kNoiseOfShaking = 400;   // points
constexpr std::int64_t kShaken = 3;             // things at once, at most
constexpr std::int64_t kPushing = 60 * kPoint;  // what it takes to push another thing away

// What any of them is told to face, then those that face it, then the others.
std::vector<std::string> in_facing_order(const SceneGraph& scene, const std::vector<std::string>& ids) {
  std::vector<std::string> order;
  const auto add = [&](const std::string& id) {
    if (std::find(order.begin(), order.end(), id) == order.end()) order.push_back(id);
  };
  const auto is_member = [&](const std::string& id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); };
  for (const bool faced : {true, false}) {
    for (const Relation& r : scene.relations) {
      if (r.type != RelationType::kFacing || r.targets.empty() || !is_member(r.targets[0])) continue;
      for (const std::string& id : faced ? r.references : r.targets) {
        if (!faced || !is_member(id)) add(id);
      }
    }
  }
  for (const std::string& id : ids) add(id);
  return order;
}

}  // namespace

bool Search::move(const std::vector<ItemId>& group, std::int64_t noise, Budget& budget) {
  const Placements before = placements_;
  for (const ItemId member : group) placements_[member] = {};
  bool all = true;
  for (const ItemId member : group) all = all && !budget.stopped && place(member, noise, budget);
  if (all && is_better(before, group, budget)) return true;
  placements_ = before;
  return false;
}

// Whether what moved since is worth it.
bool Search::is_better(const Placements& before, const std::vector<ItemId>& moved, Budget& budget, std::int64_t least_gain) {
  if (placements_ == before) return false;
  const std::int64_t gain = known_.gain(model_, {before, placements_, moved}, least_gain);
  budget.count(100);
  // Only for what is better, or nearly as good, without what is costly to measure.
  if (gain <= least_gain) return false;
  budget.count(900);
  const std::int64_t late_after = late_cost(model_, placements_, gain + late_);
  if (late_after >= gain + late_) return false;
  late_ = late_after;
  return true;
}

// An item goes where it is best though others stand there; those look for new places.
bool Search::push(ItemId item, Budget& budget) {
  const Placements before = placements_;
  std::vector<ItemId> moved;
  take_out(item, moved);
  ById<ItemId, std::int64_t> price(model_.items.size());
  for (const ItemId i : price.ids()) price[i] = stays(model_.items[i]) ? -1 : kPushing;
  CandidateOptions options;
  options.eject_price = &price;
  options.noise = kPushing * (1 + random_.below(3));
  options.random = &random_;
  options.most_size_step = most_size_step_;
  const std::vector<Candidate> found = finder_.find(placements_, item, options, budget);
  bool all = !found.empty();
  if (all) {
    placements_[item] = found[0].placement;
    for (const ItemId other : found[0].hit) take_out(other, moved);
    all = placements_[item].state >= 0;  // else it hung on what it pushed out
  }
  for (std::size_t i = 0; i < moved.size() && all; ++i) all = moved[i] == item || place(moved[i], 0, budget);
  if (all && is_better(before, moved, budget)) return true;
  placements_ = before;
  return false;
}

// Rows and grids, each with what they look at and all that hangs on them: bound to one another, they can only move together.
std::vector<std::vector<ItemId>> Search::formations() const {
  constexpr std::size_t kMany = 4;
  std::vector<std::vector<ItemId>> found;
  for (const Relation& r : model_.scene->relations) {
    if ((r.type != RelationType::kGrid && r.type != RelationType::kRow) || r.targets.size() < kMany) continue;
    std::vector<ItemId> group;
    bool movable = true;
    for (const std::string& id : in_facing_order(*model_.scene, r.targets)) {
      std::vector<ItemId> more;
      const ItemId item = model_.find_item(id);
      if (!item.exists() || placements_[item].state < 0) continue;
      group_of(dependencies_, placements_, item, more);
      for (const ItemId m : more) {
        movable = movable && !stays(model_.items[m]);
        if (std::find(group.begin(), group.end(), m) == group.end()) group.push_back(m);
      }
    }
    if (movable && group.size() >= kMany) found.push_back(std::move(group));
  }
  return found;
}

std::vector<ItemId> Search::movable() const {
  std::vector<ItemId> found;
  for (const ItemId i : model_.items.ids()) {
    if (placements_[i].state >= 0 && !stays(model_.items[i])) found.push_back(i);
  }
  return found;
}

bool Search::shake(Budget& budget) {
  const std::vector<ItemId> all = movable();
  if (all.empty()) return false;
  const Placements before = placements_;
  std::vector<ItemId> out;
  for (std::int64_t k = random_.below(kShaken); k >= 0; --k)
    take_out(all[static_cast<std::size_t>(random_.below(static_cast<std::int64_t>(all.size())))], out);
  const std::int64_t noise = kPoint * (1 + random_.below(kNoiseOfShaking));
  for (const ItemId item : order(bonus_)) {
    if (placements_[item].state >= 0 || (!budget.stopped && place(item, noise, budget))) continue;
    placements_ = before;
    return false;
  }
  return true;
}

}  // namespace layoutbox::placement
