#include "layoutbox/experiment/tables.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <set>

#include "layoutbox/base/random.h"

namespace layoutbox::experiment {
namespace {

constexpr int kResamples = 1000;

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

bool counts_as_made(const RunRecord& record) { return record.outcome == "solved" || record.outcome == "relaxed"; }

}  // namespace

std::vector<std::pair<std::string, Records>> by_method(const ExperimentOutcome& outcome) {
  std::vector<std::pair<std::string, Records>> groups;
  for (const RunRecord& record : outcome.records) {
    auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& item) { return item.first == record.method; });
    if (group == groups.end()) group = groups.insert(groups.end(), {record.method, {}});
    group->second.push_back(&record);
  }
  return groups;
}

std::optional<vlm::Estimate> measure_over(const Records& records, const std::string& measure) {
  std::vector<Tally> tallies;
  double part = 0, whole = 0;
  for (const RunRecord* record : records) {
    const auto found = record->judgement.measures.find(measure);
    if (found == record->judgement.measures.end() || found->second.whole <= 0) continue;
    tallies.push_back(found->second);
    part += found->second.part, whole += found->second.whole;
  }
  if (tallies.empty()) return std::nullopt;
  Random random(1);
  std::array<double, kResamples> shares{};
  for (double& share : shares) {
    double p = 0, w = 0;
    for (std::size_t i = 0; i < tallies.size(); ++i) {
      const Tally& tally = tallies[random.below(tallies.size())];
      p += tally.part, w += tally.whole;
    }
    share = p / w;
  }
  std::sort(shares.begin(), shares.end());
  return vlm::Estimate{part / whole, shares[24], shares[974]};
}

std::optional<vlm::Estimate> everything_over(const Records& records) {
  const auto met = std::count_if(records.begin(), records.end(), [](const RunRecord* record) { return record->judgement.everything; });
  return vlm::share_of(static_cast<int>(met), static_cast<int>(records.size()));
}

std::vector<Bucket> by_size(const Records& records) {
  std::vector<Bucket> buckets{{"up to 4", {}}, {"5 to 8", {}}, {"9 to 12", {}}, {"more than 12", {}}};
  for (const RunRecord* record : records) {
    const std::size_t objects = record->judgement.room.layout.objects.size();
    buckets[objects <= 4 ? 0 : objects <= 8 ? 1 : objects <= 12 ? 2 : 3].records.push_back(record);
  }
  return buckets;
}

Sameness same_structure(const Records& records) {
  std::map<std::string, std::vector<std::string>> keys;
  for (const RunRecord* record : records) {
    if (!record->structure.empty()) keys[record->scene].push_back(record->structure);
  }
  Sameness sameness;
  for (const auto& [scene, structures] : keys) {
    if (structures.size() < 2) continue;
    ++sameness.prompts;
    sameness.same += std::set(structures.begin(), structures.end()).size() == 1;
  }
  return sameness;
}

std::map<std::string, int> failures_of(const Records& records) {
  std::map<std::string, int> counts;
  for (const RunRecord* record : records) {
    std::string_view rest = record->failure;
    while (!rest.empty()) {
      const std::size_t comma = rest.find(", ");
      ++counts[std::string(rest.substr(0, comma))];
      rest = comma == std::string_view::npos ? std::string_view{} : rest.substr(comma + 2);
    }
  }
  return counts;
}

std::optional<vlm::Estimate> made_within(const Records& records, int attempts) {
  int made = 0, asked = 0;
  for (const RunRecord* record : records) {
    if (record->spent.requests == 0) continue;
    ++asked;
    made += counts_as_made(*record) && record->spent.requests <= attempts;
  }
  return vlm::share_of(made, asked);
}

double median_seconds(const Records& records) {
  std::vector<double> totals;
  for (const RunRecord* record : records) {
    if (record->outcome != "failed") totals.push_back(record->seconds_in_all());
  }
  return median(std::move(totals));
}

std::map<std::string, double> median_by_stage(const Records& records) {
  std::map<std::string, std::vector<double>> all;
  for (const RunRecord* record : records) {
    for (const auto& [stage, seconds] : record->seconds) all[stage].push_back(seconds);
  }
  std::map<std::string, double> medians;
  for (auto& [stage, seconds] : all) medians[stage] = median(std::move(seconds));
  return medians;
}

Spent spent_over(const Records& records) {
  Spent sum;
  for (const RunRecord* record : records) {
    const Spent& spent = record->spent;
    sum.requests += spent.requests;
    sum.request_tokens += spent.request_tokens, sum.response_tokens += spent.response_tokens;
    sum.cost += spent.cost;
    sum.cost_known = sum.cost_known && spent.cost_known;
  }
  return sum;
}

std::optional<vlm::Estimate> mean_over(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  const double count = static_cast<double>(values.size());
  Random random(1);
  std::array<double, kResamples> means{};
  for (double& mean : means) {
    for (std::size_t i = 0; i < values.size(); ++i) mean += values[random.below(values.size())] / count;
  }
  std::sort(means.begin(), means.end());
  return vlm::Estimate{std::accumulate(values.begin(), values.end(), 0.0) / count, means[24], means[974]};
}

namespace {

void add(vlm::AnswerFigures& sum, const vlm::AnswerFigures& f) {
  sum.answers += f.answers, sum.neither += f.neither;
  sum.true_yes += f.true_yes, sum.false_yes += f.false_yes, sum.true_no += f.true_no, sum.false_no += f.false_no;
}

std::optional<double> share_right(const FourJudgements& four) {
  const int all = four.single.answers + four.multi.answers;
  if (all == 0) return std::nullopt;
  return (four.single.true_yes + four.single.true_no + four.multi.true_yes + four.multi.true_no) / static_cast<double>(all);
}

}  // namespace

FourOver four_over(const Records& records, bool walled) {
  FourOver over;
  std::vector<double> of_scene, of_prompt, scores, right;
  for (const RunRecord* record : records) {
    const auto& four = walled ? record->picture.walled : record->picture.cut_away;
    if (!four) continue;
    ++over.rooms;
    add(over.single, four->single);
    add(over.multi, four->multi);
    if (four->scene_score) of_scene.push_back(*four->scene_score);
    if (four->prompt_score) of_prompt.push_back(*four->prompt_score);
    const std::optional<double> share = share_right(*four);
    if (four->scene_score && share) scores.push_back(*four->scene_score), right.push_back(*share);
  }
  add(over.all, over.single);
  add(over.all, over.multi);
  for (vlm::AnswerFigures* f : {&over.single, &over.multi, &over.all}) *f = vlm::figures_of_counts(*f);
  over.scene_score = mean_over(of_scene), over.prompt_score = mean_over(of_prompt);
  over.score_and_answers = vlm::correlation(scores, right);
  return over;
}

Records judged_both_ways(const Records& records) {
  Records both;
  std::copy_if(records.begin(), records.end(), std::back_inserter(both),
               [](const RunRecord* record) { return record->picture.cut_away && record->picture.walled; });
  return both;
}

std::optional<vlm::Estimate> rating_over(const Records& records) {
  std::vector<double> ratings;
  for (const RunRecord* record : records) {
    if (const auto rating = record->rating()) ratings.push_back(*rating);
  }
  return mean_over(ratings);
}

std::vector<RatingLink> rating_links(const Records& records) {
  using Figure = std::function<std::optional<double>(const RunRecord&)>;
  std::vector<std::pair<std::string, Figure>> figures;
  figures.emplace_back("everything met", [](const RunRecord& record) { return record.judgement.everything ? 1.0 : 0.0; });
  for (const MeasureRow& row : measure_rows()) {
    figures.emplace_back(row.name, [name = std::string(row.name)](const RunRecord& record) -> std::optional<double> {
      const auto found = record.judgement.measures.find(name);
      if (found == record.judgement.measures.end() || found->second.whole <= 0) return std::nullopt;
      return found->second.share();
    });
  }
  const auto of_four = [](auto figure) -> Figure {
    return [figure](const RunRecord& record) { return record.picture.cut_away ? figure(*record.picture.cut_away) : std::nullopt; };
  };
  figures.emplace_back("score against the scene", of_four([](const FourJudgements& four) { return four.scene_score; }));
  figures.emplace_back("score against the prompt", of_four([](const FourJudgements& four) { return four.prompt_score; }));
  figures.emplace_back("right answers", of_four(share_right));
  std::vector<RatingLink> links;
  for (const auto& [name, figure] : figures) {
    std::vector<double> ratings, values;
    for (const RunRecord* record : records) {
      const auto rating = record->rating(), value = figure(*record);
      if (rating && value) ratings.push_back(*rating), values.push_back(*value);
    }
    if (ratings.empty()) continue;
    links.push_back({name, static_cast<int>(ratings.size()), vlm::correlation(ratings, values),
                     vlm::correlation(vlm::ranks_of(ratings), vlm::ranks_of(values))});
  }
  return links;
}

std::optional<double> agreement_of(const std::vector<Rating>& ratings) {
  std::map<std::string, std::map<std::string, double>> by_rater;
  for (const Rating& rating : ratings) by_rater[rating.rater][rating.room] = rating.score;
  double sum = 0;
  int pairs = 0;
  for (auto a = by_rater.begin(); a != by_rater.end(); ++a) {
    for (auto b = std::next(a); b != by_rater.end(); ++b) {
      std::vector<double> first, second;
      for (const auto& [room, score] : a->second) {
        if (const auto other = b->second.find(room); other != b->second.end()) first.push_back(score), second.push_back(other->second);
      }
      const auto both = vlm::correlation(vlm::ranks_of(first), vlm::ranks_of(second));
      if (both) sum += *both, ++pairs;
    }
  }
  return pairs == 0 ? std::nullopt : std::optional(sum / pairs);
}

}  // namespace layoutbox::experiment
