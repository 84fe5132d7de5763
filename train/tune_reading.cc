// tune_reading: a coordinate search for the weights of a reading (docs/reading-measured.md).
//
//   tune_reading [--halves] TARGETS.jsonl …     TARGETS: what reading_targets.py writes, a file a set
//
// A weight is changed where that finds more relations, with none of the sets losing any. --halves: tunes on every other description of each
// set and says what the rest gains by it.
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "layoutbox/plan/reading/weights.h"
#include "reading_measure.h"

namespace {

using namespace layoutbox;

struct Weight {
  const char* name;
  double* value;
};

std::vector<Weight> weights() {
  namespace w = offline::weight;
  return {
#define WEIGHT(name, value) {#name, &w::name},
#include "layoutbox/plan/reading/weights.inc"
#undef WEIGHT
  };
}

struct Set {
  std::string path;
  std::vector<reading::Description> descriptions;
};

class Tuner {
 public:
  explicit Tuner(std::vector<Set> sets) : sets_(std::move(sets)), planner_(make_offline_planner(Catalog::builtin())) {}

  // Relations found less those that are wrong, a figure a set; of the descriptions whose number has that remainder by two, or of all (−1).
  // Ends at the first set that has less than `least`.
  std::vector<double> score(int half, const std::vector<double>& least = {}) const {
    std::vector<double> all;
    for (const Set& set : sets_) {
      reading::Tally tally;
      for (std::size_t i = 0; i < set.descriptions.size(); ++i) {
        if (half >= 0 && static_cast<int>(i % 2) != half) continue;
        auto plan = planner_->plan(set.descriptions[i].prompt, {});
        reading::measure(Catalog::builtin(), set.descriptions[i], plan ? plan->scene : SceneGraph{}, tally, nullptr);
      }
      all.push_back(tally.found - tally.wrong);
      if (all.size() <= least.size() && all.back() < least[all.size() - 1]) break;
    }
    return all;
  }

  void tune(int half) {
    constexpr int kRounds = 1;
    std::vector<double> best = score(half);
    for (int round = 0; round < kRounds; ++round) {
      bool changed = false;
      for (const Weight& weight : weights()) {
        for (const double step : {0.5, -0.5}) {
          const double before = *weight.value;
          *weight.value = before + step * std::max(1.0, std::abs(before) / 2);
          const std::vector<double> now = score(half, best);
          if (better(now, best)) {
            std::printf("%-20s %6.2f -> %6.2f   %+.0f\n", weight.name, before, *weight.value, total(now) - total(best));
            std::fflush(stdout);
            best = now;
            changed = true;
            break;
          }
          *weight.value = before;
        }
      }
      if (!changed) break;
    }
  }

  void print(const char* title, const std::vector<double>& before, const std::vector<double>& after) const {
    std::printf("%s:", title);
    for (std::size_t s = 0; s < before.size(); ++s) std::printf(" %.0f>%.0f", before[s], after[s]);
    std::printf("   in all %.0f>%.0f\n", total(before), total(after));
  }

 private:
  static double total(const std::vector<double>& figures) {
    double sum = 0;
    for (const double figure : figures) sum += figure;
    return sum;
  }
  static bool better(const std::vector<double>& now, const std::vector<double>& before) {
    if (now.size() < before.size()) return false;
    for (std::size_t s = 0; s < now.size(); ++s) {
      if (now[s] < before[s]) return false;
    }
    return total(now) > total(before);
  }

  std::vector<Set> sets_;
  std::unique_ptr<Planner> planner_;
};

}  // namespace

int main(int count, char** arguments) {
  std::vector<Set> sets;
  bool halves = false;
  for (int i = 1; i < count; ++i) {
    const std::string path = arguments[i];
    if (path == "--halves")
      halves = true;
    else
      sets.push_back({path, reading::read_descriptions(path)});
  }
  Tuner tuner(std::move(sets));
  std::vector<double> defaults;
  for (const Weight& weight : weights()) defaults.push_back(*weight.value);
  for (int half = halves ? 0 : -1; half < (halves ? 2 : 0); ++half) {
    for (std::size_t w = 0; w < defaults.size(); ++w) *weights()[w].value = defaults[w];
    const std::vector<double> before = tuner.score(half), others = tuner.score(half < 0 ? -1 : 1 - half);
    tuner.tune(half);
    tuner.print("tuned on", before, tuner.score(half));
    if (half >= 0) tuner.print("the rest", others, tuner.score(1 - half));
  }
}
