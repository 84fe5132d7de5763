// A complete layout made better, step by step: each thing alone once, then groups of things taken out and placed again by chance.
#include <algorithm>
#include <optional>

#include "layoutbox/solve/objective/cost.h"
#include "layoutbox/solve/search/search.h"

namespace layoutbox::placement {
namespace {

constexpr int kFormationTries = 4;
constexpr std::int64_t kPushes = 4, kNudges = 8;  // one move in so many does
constexpr std::int64_t kLoads = 4;                // one group in so many is a thing with what rests on it
constexpr std::int64_t kStayingNoise = 40;        // an earlier layout makes every metre so much dearer

}  // namespace

// The item with what rests on it, and no more: a full bookcase, while what refers to it stays and says where it may go.
std::vector<ItemId> Search::load_of(ItemId item) const {
  std::vector<ItemId> load{item};
  for (std::size_t i = 0; i < load.size(); ++i) {
    for (const ItemId tenant : dependencies_.tenants[load[i]]) {
      if (placements_[tenant].state < 0 || stays(model_.items[tenant]) || std::ranges::find(load, tenant) != load.end()) continue;
      const bool rests = std::ranges::any_of(model_.items[tenant].supports, [&](const SupportOption& support) {
        return support.kind == SupportOption::Kind::kItem && support.item == load[i];
      });
      if (rests) load.push_back(tenant);
    }
  }
  return load;
}

// The item with what hangs on it, or with what rests on it alone, and sometimes a second one with what is its own, so that two can
// change places.
void Search::gather_group(ItemId item, const std::vector<ItemId>& movable, std::vector<ItemId>& group) {
  if (random_.below(kLoads) == 0) {
    group = load_of(item);
    return;
  }
  group_of(dependencies_, placements_, item, group);
  if (random_.below(3) != 0) return;
  const ItemId other = movable[random_.below(static_cast<std::int64_t>(movable.size()))];
  std::vector<ItemId> more;
  group_of(dependencies_, placements_, other, more);
  for (const ItemId m : more) {
    if (std::find(group.begin(), group.end(), m) == group.end()) group.push_back(m);
  }
}

// Each alone, where it costs least; what stays near an earlier place slides there.
bool Search::sweep_step(ItemId item, Budget& budget) {
  if (!model_.start.empty() && slide(item, budget)) return true;
  return move(load_of(item), 0, budget);
}

// One step of chance. Nothing: of a kind that says nothing of whether more of them are worth it.
std::optional<bool> Search::chance_step(ItemId item, const std::vector<ItemId>& movable, const std::vector<std::vector<ItemId>>& together,
                                        Budget& budget) {
  const bool fresh = model_.start.empty();
  if (!fresh && random_.below(3) == 0 && slide(item, budget)) return true;
  if (!together.empty() && random_.below(20) == 0) {
    const std::int64_t noise = kPoint * 50 * random_.below(4);
    const std::vector<ItemId>& formation = together[random_.below(static_cast<std::int64_t>(together.size()))];
    return move(formation, noise, budget) ? std::optional<bool>(true) : std::nullopt;
  }
  if (fresh && random_.below(kPushes) == 0) return push(item, budget);
  if (fresh && random_.below(kNudges) == 0) return nudge(item, budget);
  std::vector<ItemId> group;
  gather_group(item, movable, group);
  std::int64_t noise = random_.below(3) == 0 ? 0 : kPoint * (50 + 50 * random_.below(8));
  if (!fresh) noise *= kStayingNoise;
  return move(group, noise, budget);
}

void Search::improve(Budget& budget, std::int64_t patience, bool sweeps) {
  const std::vector<ItemId> movable = this->movable();
  if (movable.empty()) return;
  std::fill(bonus_.begin(), bonus_.end(), 0);  // what failed while it was built is looked after no longer
  late_ = late_cost(model_, placements_);
  const auto count = static_cast<std::int64_t>(movable.size());
  const std::vector<std::vector<ItemId>> together = model_.start.empty() ? formations() : std::vector<std::vector<ItemId>>{};
  for (const std::vector<ItemId>& formation : together) {
    for (int attempt = 0; attempt < kFormationTries && !budget.stopped && !move(formation, kPoint * 100 * attempt, budget); ++attempt) {
    }
  }
  std::int64_t idle = 0;
  for (std::int64_t turn = 0; !budget.spent() && idle < patience * count; ++turn) {
    const bool sweep = sweeps && turn < count;  // first everything once, alone
    const ItemId item = movable[sweep ? turn : random_.below(count)];
    const std::optional<bool> better = sweep ? sweep_step(item, budget) : chance_step(item, movable, together, budget);
    if (better) idle = *better ? 0 : idle + 1;
  }
  if (model_.start.empty()) settle(budget);
}

}  // namespace layoutbox::placement
