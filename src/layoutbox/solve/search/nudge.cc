// Neighbours that can only move together: what touches a thing goes with it, in ever smaller steps.
#include "layoutbox/solve/search/search.h"

namespace layoutbox::placement {
namespace {

constexpr Mm kTouching = 20;
constexpr Mm kLongest = 512;  // mm
constexpr std::int64_t kStepsOfNudge = 10;

bool touch(const Box& a, const Box& b) {
  for (int k = 0; k < 3; ++k) {
    if (a.lo[k] - kTouching > b.hi[k] || b.lo[k] - kTouching > a.hi[k]) return false;
  }
  return true;
}

}  // namespace

// The thing, some of those that touch it, and all that hangs on them.
std::vector<int> Search::cluster_of(int item) {
  std::vector<int> cluster, more;
  group_of(dependencies_, placements_, item, cluster);
  const Box box = box_of(model_.items[item], placements_[item]);
  for (std::size_t j = 0; j < model_.items.size(); ++j) {
    const int other = static_cast<int>(j);
    const bool apart = placements_[j].state < 0 || model_.items[j].is_opening() || model_.pair(item, other) == PairRule::kFree;
    if (apart || stays(model_.items[j]) || !touch(box, box_of(model_.items[j], placements_[j])) || random_.below(2) == 0) continue;
    group_of(dependencies_, placements_, other, more);
    for (const int m : more) {
      if (std::find(cluster.begin(), cluster.end(), m) == cluster.end()) cluster.push_back(m);
    }
  }
  return cluster;
}

// True: it is better there.
bool Search::shift(const std::vector<int>& cluster, int axis, Mm by, Budget& budget) {
  const Placements before = placements_;
  for (const int member : cluster) placements_[member].at[axis] += by;
  budget.count(kStepsOfNudge * static_cast<std::int64_t>(cluster.size()));
  const auto stays_right = [&](int member) { return may_stay(member, placements_[member]); };
  if (std::all_of(cluster.begin(), cluster.end(), stays_right) && is_better(before, cluster, budget)) return true;
  placements_ = before;
  return false;
}

bool Search::nudge(int item, Budget& budget) {
  const std::vector<int> cluster = cluster_of(item);
  if (std::any_of(cluster.begin(), cluster.end(), [&](int m) { return stays(model_.items[m]); })) return false;
  bool any = false;
  for (Mm by = kLongest; by > 0; by /= 2) {
    for (const int axis : {0, 1}) any = shift(cluster, axis, by, budget) || shift(cluster, axis, -by, budget) || any;
  }
  return any;
}

}  // namespace layoutbox::placement
