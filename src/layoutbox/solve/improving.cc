// A legal layout made better, from several starts.
#include <algorithm>
#include <utility>

#include "layoutbox/solve/objective/terms.h"
#include "layoutbox/solve/search/quick.h"
#include "layoutbox/solve/search/search.h"
#include "layoutbox/solve/solving.h"

namespace layoutbox::placement {
namespace {

constexpr int kStarts = 4, kIdleShakes = 40;
constexpr std::int64_t kShortPatience = 1, kPatienceShaken = 4;  // moves in vain a thing
constexpr std::int64_t kShareOfLast = 4;
// A cost (a score of 0.5), above which so many times the effort is worth it, in rooms of so few things.
constexpr std::int64_t kPoor = 1'000'000, kMoreForPoor = 2;
constexpr std::size_t kFewItems = 40;
constexpr std::int64_t kShareOfStarts = 8;

}  // namespace

std::int64_t Solver::cost() const { return total_cost(model_, placements_); }

// Another layout to improve; to look for it takes a part of the effort, and leaves the rest for making it better. The first is built at
// the cheapest places, the next otherwise, now and then without a look at costs.
bool Solver::begin(Search& search, int start, Budget& budget) {
  Budget part{0, std::max(kLeastSteps, (budget.limit - budget.steps) / kShareOfStarts), budget.stop, false};
  bool found = start == 0 ? search.construct(1, part) : search.construct_unlike(part);
  if (!found && start == 0) search.adopt(placements_), found = true;
  if (!found && !part.stopped) {
    const Dependencies dependencies(model_);
    Placements other(model_.items.size());
    QuickSearch quick(model_, dependencies, scope_, options_.seed + kSeedStep * static_cast<std::uint64_t>(start), size_limit_);
    found = quick.complete(other, part);
    if (found) search.adopt(other);
  }
  budget.count(part.steps);
  return found;
}

// From unlike starts a short improvement each; then the best is shaken and improved again and again, until that brings nothing more or the
// effort is spent. The best of all is kept.
void Solver::improve() {
  Budget budget{0, budgets_.improvement, {}, false};
  budget.stop = [this, &budget] {
    if (options_.on_progress) options_.on_progress(std::min(1.0, static_cast<double>(budget.steps) / static_cast<double>(budget.limit)));
    return must_stop();
  };
  Search search(model_, scope_, options_.seed, size_limit_);
  search.skip_dear_regions();
  std::int64_t least = cost();
  const auto take_if_better = [&] {
    Placements other = search.placements();
    std::swap(placements_, other);
    const std::int64_t now = cost();
    if (now < least) {
      least = now;
      return true;
    }
    std::swap(placements_, other);
    return false;
  };
  if (!model_.start.empty()) {
    search.adopt(placements_);
    search.improve(budget, kPatience);
    take_if_better();
    return;
  }
  int idle = 0;  // since the last that brought something
  bool more = model_.items.size() <= kFewItems;
  for (int start = 0; idle < kIdleShakes; ++start, ++idle) {
    if (budget.spent()) {
      if (!std::exchange(more, false) || least < kPoor || budget.stopped) break;
      budget.limit += kMoreForPoor * budgets_.improvement;
    }
    if (start < kStarts && begin(search, start, budget)) {
      search.form_up(budget);
      search.improve(budget, kShortPatience);
    } else {
      search.adopt(placements_);
      search.shake(budget);
      search.improve(budget, kPatienceShaken, false);
    }
    if (take_if_better()) idle = 0;
  }
  if (budget.stopped) return;
  // The best of all gets a share of its own: each thing is looked at once more, however much was spent on the way.
  Budget last{0, std::max(budgets_.improvement / kShareOfLast, budget.limit - budget.steps), budget.stop, false};
  search.adopt(placements_);
  search.form_up(last);
  search.improve(last, kPatience);
  take_if_better();
}

}  // namespace layoutbox::placement
