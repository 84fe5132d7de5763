// How much work each part of a solve may do: from the effort, once.
#pragma once

#include <algorithm>
#include <cstdint>

namespace layoutbox::placement {

// Steps (see Budget) of a first search, and the fewest that any gets.
inline constexpr std::int64_t kFirstSteps = 400'000, kLeastSteps = 60'000;

struct Budgets {
  std::int64_t search = 0;       // steps of the longest search for something legal
  std::int64_t first = 0;        // of the first of each kind
  std::int64_t trial = 0;        // of the question whether something fits without something else
  std::int64_t finding = 0;      // of all searches together until something legal is found
  std::int64_t improvement = 0;  // of making the layout better
  double proof = 0;              // of all questions to CP-SAT together, before the improvement; its deterministic time
  double best_proof = 0;         // of the question whether there is a better layout; 0: it is not asked
};

// `things`: objects and openings.
inline Budgets budgets_for(std::int64_t effort, std::size_t things) {
  constexpr std::int64_t kStepsPerUnit = 5000;  // candidate positions tried in about a quarter of a millisecond
  constexpr std::int64_t kThingsPerEffort = 11, kThingsOfStart = 8, kMany = 30, kLessOfMany = 5, kLeastWeighed = 32, kHundreds = 200;
  constexpr std::int64_t kFindingPerUnit = 80'000, kLeastFinding = 4'000'000;
  constexpr double kProofPerUnit = 0.005, kLeastProof = 0.1, kMostProof = 20;
  constexpr std::int64_t kLeastEffortForBest =
      400;  // who asks for no more than the usual waits for no proof, which takes ten times as long
  constexpr double kBestProofPerUnit = 0.0005;
  const std::int64_t steps = effort * kStepsPerUnit;
  Budgets budgets;
  budgets.search = steps / 2;
  budgets.first = std::max(std::min(budgets.search, kFirstSteps), kLeastSteps);
  budgets.trial = std::max(steps / 4, kLeastSteps);
  // The more things, the more moves it takes to bring all to their places, of many not quite so many; a start costs something in any room.
  const auto count = static_cast<std::int64_t>(things);
  const std::int64_t weighed = std::max(kLeastWeighed, count + kThingsOfStart - std::max<std::int64_t>(0, count - kMany) / kLessOfMany);
  budgets.finding = std::max(effort * kFindingPerUnit, kLeastFinding) * weighed / kLeastWeighed;
  // Of hundreds each step takes the longer the more there are: in all, not more time than so many take.
  const std::int64_t hundreds = std::max(kHundreds, count);
  budgets.improvement = 2 * steps * weighed / kThingsPerEffort * kHundreds / hundreds;
  budgets.proof = std::clamp(static_cast<double>(effort) * kProofPerUnit, kLeastProof, kMostProof);
  if (effort >= kLeastEffortForBest) budgets.best_proof = kBestProofPerUnit * static_cast<double>(effort);
  return budgets;
}

}  // namespace layoutbox::placement
