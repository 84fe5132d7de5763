// How the quick search pushes out what is in the way.
#include "layoutbox/solve/search/quick.h"

namespace layoutbox::placement {
namespace {

constexpr std::size_t kMostCoordinates = 14;

}  // namespace

// What it costs to push others out of the way, asked for as it is needed.
class QuickSearch::Prices {
 public:
  Prices(const QuickSearch& search, ItemId item) : search_(search), prices_(search.placements_.size(), kUnknown) {
    for (const ItemId other : search.all_hosts(item)) prices_[other] = kNever;
  }

  // Less than 0: it is not to be pushed.
  int of(ItemId other) {
    int& price = prices_[other];
    if (price != kUnknown) return price;
    price = kNever;
    if (stays(search_.model_.items[other])) return price;
    group_of(search_.dependencies_, search_.placements_, other, group_);
    price = 0;
    for (const ItemId member : group_) price += 1 + search_.weight_[member];
    return price;
  }

 private:
  static constexpr int kUnknown = -2, kNever = -1;
  const QuickSearch& search_;
  ById<ItemId, int> prices_;
  std::vector<ItemId> group_;
};

// The cheapest place to push others from, so far.
struct QuickSearch::Push {
  Placement best;
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  std::vector<ItemId> hit, best_hit;
  ById<ItemId, int> seen;  // the position at which it was counted last
  int stamp = 0;
};

// The coordinates of an axis at which a region is tried: its ends, and the edges of what is in the way.
void QuickSearch::coordinates_of(const Region& region, int axis, std::vector<Mm>& tried) {
  tried.assign({region.lo[axis]});
  if (region.hi[axis] > region.lo[axis]) tried.push_back(region.hi[axis]);
  for (const Obstacles::Forbidden& f : obstacles_.all()) {
    for (const Mm value : {f.lo[axis], f.hi[axis]}) {
      if (axis < 2 && value > region.lo[axis] && value < region.hi[axis]) tried.push_back(value);
    }
  }
  while (tried.size() > kMostCoordinates) {
    tried[static_cast<std::size_t>(random_.below(static_cast<std::int64_t>(tried.size())))] = tried.back();
    tried.pop_back();
  }
}

// Takes that place where what stands in it is pushed at the least price.
void QuickSearch::try_to_push(const Region& region, int state, const Vec3& at, Prices& prices, Push& push) {
  ++push.stamp;
  push.hit.clear();
  std::int64_t sum = random_.below(2);  // of equals now this one, now that
  for (const Obstacles::Forbidden& f : obstacles_.all()) {
    if (!obstacles_.holds(f, at) || (f.owner.exists() && push.seen[f.owner] == push.stamp)) continue;
    if (!f.owner.exists() || prices.of(f.owner) < 0) return;
    push.seen[f.owner] = push.stamp;
    push.hit.push_back(f.owner);
    sum += 2 * std::int64_t{prices.of(f.owner)};
    if (sum >= push.least) return;
  }
  if (sum >= push.least || !holds_at(region, at)) return;
  push.least = sum, push.best = {state, at}, push.best_hit = push.hit;
}

// Where it pushes out what has failed least often.
bool QuickSearch::push_out(ItemId item, std::vector<ItemId>& pending, Budget& budget) {
  Prices prices(*this, item);
  Push push;
  push.seen.assign(placements_.size(), 0);
  std::array<std::vector<Mm>, 3> tried;
  for (const int state : states_in_turn(item)) {
    for (const Region& region : regions_.find(placements_, item, state, false)) {
      obstacles_.gather(placements_, item, state, region);
      for (int k = 0; k < 3; ++k) coordinates_of(region, k, tried[k]);
      for (const Mm z : tried[2]) {
        for (const Mm y : tried[1]) {
          budget.count(static_cast<std::int64_t>(1 + tried[0].size() * obstacles_.all().size() / 32));
          if (budget.stopped) return false;
          for (const Mm x : tried[0]) try_to_push(region, state, {x, y, z}, prices, push);
        }
      }
    }
  }
  if (push.best.state < 0) return false;
  placements_[item] = push.best;
  for (const ItemId other : push.best_hit) take_out(other, pending);
  return true;
}

// What it refers to stands where it cannot follow: that looks for another place, before it.
bool QuickSearch::take_hosts(ItemId item, std::vector<ItemId>& pending) {
  bool any = false;
  const std::vector<ItemId> hosts = random_.below(2) == 0 ? dependencies_.hosts[item] : all_hosts(item);
  pending.push_back(item);
  for (const ItemId host : hosts) {
    if (placements_[host].state < 0 || stays(model_.items[host])) continue;
    ++weight_[host];
    take_out(host, pending);
    any = true;
  }
  if (!any) pending.pop_back();
  return any;
}

}  // namespace layoutbox::placement
