#include "layoutbox/experiment/tables.h"

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <set>

namespace layoutbox::experiment {
namespace {

constexpr int kResamples = 1000;

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
  std::mt19937_64 random(1);
  std::array<double, kResamples> shares{};
  for (double& share : shares) {
    double p = 0, w = 0;
    for (std::size_t i = 0; i < tallies.size(); ++i) {
      const Tally& tally = tallies[random() % tallies.size()];
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
    if (record->requests == 0) continue;
    ++asked;
    made += counts_as_made(*record) && record->requests <= attempts;
  }
  return vlm::share_of(made, asked);
}

double median_seconds(const Records& records) {
  std::vector<double> totals;
  for (const RunRecord* record : records) {
    double total = 0;
    for (const auto& [stage, seconds] : record->seconds) total += seconds;
    if (record->outcome != "failed") totals.push_back(total);
  }
  if (totals.empty()) return 0;
  std::nth_element(totals.begin(), totals.begin() + static_cast<std::ptrdiff_t>(totals.size() / 2), totals.end());
  return totals[totals.size() / 2];
}

}  // namespace layoutbox::experiment
