// What runs add up to: shares with intervals by resampling whole rooms, since the entries of one room go together.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "layoutbox/experiment/experiment.h"
#include "layoutbox/judge/vlm/figures.h"

namespace layoutbox::experiment {

using Records = std::vector<const RunRecord*>;

// By method, in the order of the records.
std::vector<std::pair<std::string, Records>> by_method(const ExperimentOutcome& outcome);

// A measure over the rooms: sum of parts over sum of wholes, with the 95 % interval of 1,000 resamples of rooms, always the same ones.
std::optional<vlm::Estimate> measure_over(const Records& records, const std::string& measure);
std::optional<vlm::Estimate> everything_over(const Records& records);  // Wilson's interval

// Rooms with everything met by how many objects they ask for: up to 4, 5–8, 9–12, more.
struct Bucket {
  std::string name;
  Records records;
};
std::vector<Bucket> by_size(const Records& records);

// Of prompts that were planned more than once: how many came out with one structure.
struct Sameness {
  int same = 0, prompts = 0;
};
Sameness same_structure(const Records& records);

// How many rooms have each failure; a room may have two.
std::map<std::string, int> failures_of(const Records& records);

// Rooms that had their layout within so many answers of a model; only runs that asked one count.
std::optional<vlm::Estimate> made_within(const Records& records, int attempts);

double median_seconds(const Records& records);
// By stage, of the records that have it.
std::map<std::string, double> median_by_stage(const Records& records);

// All that was spent on them.
Spent spent_over(const Records& records);

// A mean over rooms with the 95 % interval of 1,000 resamples of them. Empty for none.
std::optional<vlm::Estimate> mean_over(const std::vector<double>& values);

// The four judgements over rooms: answers added up, scores' means.
struct FourOver {
  int rooms = 0;
  vlm::AnswerFigures single, multi, all;
  std::optional<vlm::Estimate> scene_score, prompt_score;
  std::optional<double> score_and_answers;  // correlation, over rooms, of the score against the scene with the share of right answers
};
FourOver four_over(const Records& records, bool walled = false);
// Those that were judged both with walls cut away and with all of them.
Records judged_both_ways(const Records& records);

// The mean of people's ratings of each room.
std::optional<vlm::Estimate> rating_over(const Records& records);

// How people's ratings go with something else that is known of the same rooms.
struct RatingLink {
  std::string name;
  int rooms = 0;
  std::optional<double> pearson, spearman;
};
std::vector<RatingLink> rating_links(const Records& records);
// How raters agree, each two over the rooms that both rated: the mean of their rank correlations.
std::optional<double> agreement_of(const std::vector<Rating>& ratings);

}  // namespace layoutbox::experiment
