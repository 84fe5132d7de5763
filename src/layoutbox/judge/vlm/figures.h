// How good answers are: shares with their confidence intervals, agreement beyond chance, correlation.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace layoutbox::vlm {

struct Estimate {
  double value = 0;
  double low = 0, high = 0;  // 95 %
};

// A share of successes, with Wilson's interval. Empty for none of none.
std::optional<Estimate> share_of(int successes, int tries);

enum class YesNo { kYes, kNo, kNeither };

struct Answered {
  bool truth = false;
  YesNo verdict = YesNo::kNeither;
};

// Of yes-no answers against the truth. An answer that is neither counts as wrong for the accuracy, and is left out of the others.
struct AnswerFigures {
  int answers = 0, neither = 0;
  int true_yes = 0, false_yes = 0, true_no = 0, false_no = 0;
  std::optional<Estimate> accuracy, precision, recall, kappa, neither_rate;
};
AnswerFigures figures_of(std::span<const Answered> answers);
// The shares and kappa of counts that are there already (those of several rooms added up).
AnswerFigures figures_of_counts(AnswerFigures counts);

// Ranks from 1 on, equal values their mean: the correlation of ranks is Spearman's.
std::vector<double> ranks_of(std::span<const double> values);

// Pearson's; empty for fewer than three pairs or where one side does not vary.
std::optional<double> correlation(std::span<const double> a, std::span<const double> b);

}  // namespace layoutbox::vlm
