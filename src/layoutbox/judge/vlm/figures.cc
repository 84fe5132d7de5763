#include "layoutbox/judge/vlm/figures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace layoutbox::vlm {
namespace {

constexpr double kZ = 1.959963984540054;  // 95 % of a normal distribution

// Cohen's, with its large-sample interval. Where one side never varies there is nothing beyond chance: 0.
Estimate kappa_of(const AnswerFigures& f) {
  const double n = f.true_yes + f.false_yes + f.true_no + f.false_no;
  const double agreed = (f.true_yes + f.true_no) / n;
  const double said_yes = (f.true_yes + f.false_yes) / n, is_yes = (f.true_yes + f.false_no) / n;
  const double chance = said_yes * is_yes + (1 - said_yes) * (1 - is_yes);
  if (chance >= 1) return {0, 0, 0};
  const double kappa = (agreed - chance) / (1 - chance);
  const double error = std::sqrt(agreed * (1 - agreed) / n) / (1 - chance);
  return {kappa, std::max(-1.0, kappa - kZ * error), std::min(1.0, kappa + kZ * error)};
}

}  // namespace

std::optional<Estimate> share_of(int successes, int tries) {
  if (tries <= 0) return std::nullopt;
  const double n = tries, p = successes / n, z2 = kZ * kZ;
  const double middle = (p + z2 / (2 * n)) / (1 + z2 / n);
  const double half = kZ * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n)) / (1 + z2 / n);
  return Estimate{p, std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

AnswerFigures figures_of(std::span<const Answered> answers) {
  AnswerFigures f;
  for (const Answered& answer : answers) {
    ++f.answers;
    if (answer.verdict == YesNo::kNeither) {
      ++f.neither;
    } else if (answer.verdict == YesNo::kYes) {
      ++(answer.truth ? f.true_yes : f.false_yes);
    } else {
      ++(answer.truth ? f.false_no : f.true_no);
    }
  }
  return figures_of_counts(f);
}

AnswerFigures figures_of_counts(AnswerFigures f) {
  f.accuracy = share_of(f.true_yes + f.true_no, f.answers);
  f.precision = share_of(f.true_yes, f.true_yes + f.false_yes);
  f.recall = share_of(f.true_yes, f.true_yes + f.false_no);
  f.neither_rate = share_of(f.neither, f.answers);
  if (f.answers > f.neither) f.kappa = kappa_of(f);
  return f;
}

std::vector<double> ranks_of(std::span<const double> values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<double> ranks(values.size());
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    while (end < order.size() && values[order[end]] == values[order[begin]]) ++end;
    for (std::size_t i = begin; i < end; ++i) ranks[order[i]] = static_cast<double>(begin + end + 1) / 2;
  }
  return ranks;
}

std::optional<double> correlation(std::span<const double> a, std::span<const double> b) {
  const std::size_t n = std::min(a.size(), b.size());
  if (n < 3) return std::nullopt;
  double mean_a = 0, mean_b = 0;
  for (std::size_t i = 0; i < n; ++i) mean_a += a[i] / static_cast<double>(n), mean_b += b[i] / static_cast<double>(n);
  double both = 0, own_a = 0, own_b = 0;
  for (std::size_t i = 0; i < n; ++i) {
    both += (a[i] - mean_a) * (b[i] - mean_b);
    own_a += (a[i] - mean_a) * (a[i] - mean_a);
    own_b += (b[i] - mean_b) * (b[i] - mean_b);
  }
  if (own_a < 1e-12 || own_b < 1e-12) return std::nullopt;
  return both / std::sqrt(own_a * own_b);
}

}  // namespace layoutbox::vlm
