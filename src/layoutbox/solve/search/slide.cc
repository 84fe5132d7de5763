// Near an earlier layout things are best pushed: an item goes nearer to its place, and what is in its way slides on, as far as need be.
#include "layoutbox/solve/objective/cost.h"
#include "layoutbox/solve/search/search.h"

namespace layoutbox::placement {
namespace {

constexpr std::int64_t kPushed = 300 * kPoint;
constexpr std::size_t kTried = 6, kMostPushed = 14;

// The least way along x or y that brings `box` out of `from` and keeps it in the room; {0, 0, 0} where there is none.
Vec3 way_out(const GridBox& box, const GridBox& from, const GridBox& room) {
  Vec3 best{};
  Mm least = std::numeric_limits<Mm>::max();
  for (int axis = 0; axis < 2; ++axis) {
    for (const Mm by : {from.hi[axis] - box.lo[axis], from.lo[axis] - box.hi[axis]}) {
      if (std::abs(by) >= least || box.lo[axis] + by < room.lo[axis] || box.hi[axis] + by > room.hi[axis]) continue;
      least = std::abs(by);
      best = {};
      best[axis] = by;
    }
  }
  return best;
}

}  // namespace

// Pushes everything that `moved` stands in out of its way, and so on. False: something does not give way.
bool Search::push_away(std::vector<ItemId>& moved, std::vector<ItemId> in_way, const ById<ItemId, std::int64_t>& price) {
  std::vector<ItemId> group, hit;
  for (std::size_t k = 0; k < in_way.size(); ++k) {
    const ItemId other = in_way[k];
    if (k >= kMostPushed || placements_[other].state < 0) return false;
    const GridBox box = box_of(model_.items[other], placements_[other]);
    Vec3 by{};
    for (const ItemId pusher : moved) {
      if (pusher == other || !collide(model_, pusher, placements_[pusher], other, placements_[other], true)) continue;
      by = way_out(box, box_of(model_.items[pusher], placements_[pusher]), model_.room);
      if (by == Vec3{}) return false;
      break;
    }
    if (by == Vec3{}) continue;  // it has been pushed on already
    group_of(dependencies_, placements_, other, group);
    for (const ItemId member : group) {  // what hangs on it goes with it
      if (stays(model_.items[member])) return false;
      for (int axis = 0; axis < 2; ++axis) placements_[member].at[axis] += by[axis];
      if (std::find(moved.begin(), moved.end(), member) == moved.end()) moved.push_back(member);
    }
    for (const ItemId member : group) {
      if (!finder_.collisions(placements_, member, placements_[member], price, hit)) return false;
      in_way.insert(in_way.end(), hit.begin(), hit.end());
    }
  }
  return std::all_of(moved.begin(), moved.end(), [&](ItemId item) { return may_stay(item, placements_[item]); });
}

bool Search::slide(ItemId item, Budget& budget) {
  const Placements before = placements_;
  ById<ItemId, std::int64_t> price(model_.items.size(), kPushed);
  for (const ItemId i : price.ids()) {
    if (stays(model_.items[i]) || model_.items[i].is_opening()) price[i] = -1;
  }
  CandidateOptions options;
  options.most = kTried;
  options.eject_price = &price;
  options.most_size_step = most_size_step_;
  placements_[item] = {};
  const std::vector<Candidate> found = finder_.find(placements_, item, options, budget);
  for (const Candidate& candidate : found) {
    placements_ = before;
    placements_[item] = candidate.placement;
    std::vector<ItemId> moved;
    group_of(dependencies_, before, item, moved);
    if (moved.size() > 1 && candidate.placement.state != before[item].state) continue;
    for (std::size_t k = 1; k < moved.size(); ++k) {  // what hangs on it goes with it
      for (int axis = 0; axis < 2; ++axis) placements_[moved[k]].at[axis] += candidate.placement.at[axis] - before[item].at[axis];
    }
    if (candidate.hit.empty() || !push_away(moved, candidate.hit, price)) continue;
    if (known_.gain(model_, {before, placements_, moved}, 0) <= 0) continue;
    late_ = late_cost(model_, placements_);
    budget.count(900);
    return true;
  }
  placements_ = before;
  return false;
}

}  // namespace layoutbox::placement
