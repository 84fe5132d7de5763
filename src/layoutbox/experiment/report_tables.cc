#include "layoutbox/experiment/report_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "layoutbox/judge/report_html.h"

namespace layoutbox::experiment {
namespace {

std::string percent(const std::optional<vlm::Estimate>& estimate) {
  if (!estimate) return "n/a";
  return fmt::format("{:.1f} % <small>[{:.0f}, {:.0f}]</small>", estimate->value * 100, estimate->low * 100, estimate->high * 100);
}

std::string two_places(const std::optional<vlm::Estimate>& estimate) {
  if (!estimate) return "n/a";
  return fmt::format("{:.2f} <small>[{:.2f}, {:.2f}]</small>", estimate->value, estimate->low, estimate->high);
}

std::string two_places(const std::optional<double>& value) { return value ? fmt::format("{:.2f}", *value) : "n/a"; }

std::string cell(const std::string& text) { return "<td class=n>" + text + "</td>"; }

std::string named(const std::string& name) { return "<tr><th>" + escaped_html(name) + "</th>"; }

std::string claim(std::string_view what, const std::string& method, const std::string& measured) {
  return fmt::format("<tr><td>{}</td><td>{}</td>{}</tr>\n", what, escaped_html(method), cell(measured));
}

// What a vision model's answers say of the paper's claims.
std::string claims_of_judge(const std::string& name, const Records& records) {
  std::string rows;
  const FourOver over = four_over(records);
  if (over.rooms == 0) return rows;
  rows += claim("right answers to questions over one relation", name, percent(over.single.accuracy));
  rows += claim("right answers to questions over several relations", name, percent(over.multi.accuracy));
  rows += claim("answers that are neither yes nor no", name, percent(over.all.neither_rate));
  const Records both = judged_both_ways(records);
  if (both.empty()) return rows;
  const FourOver open = four_over(both), walled = four_over(both, true);
  rows += claim("right answers on pictures with walls cut away", name, percent(open.all.accuracy));
  rows += claim("right answers on the same rooms with all walls", name, percent(walled.all.accuracy));
  rows += claim("score against the scene, walls cut away", name, two_places(open.scene_score));
  rows += claim("score against the scene, all walls", name, two_places(walled.scene_score));
  return rows;
}

}  // namespace

std::string methods_table(const MethodGroups& groups) {
  std::string head = "<tr><th>method</th><th class=n>rooms</th><th class=n>failed</th><th class=n>everything met</th>", rows;
  for (const MeasureRow& row : measure_rows()) head += fmt::format("<th class=n title=\"{}\">{}</th>", escaped_html(row.meaning), row.name);
  for (const auto& [name, records] : groups) {
    const auto failed = std::count_if(records.begin(), records.end(), [](const RunRecord* record) { return record->outcome == "failed"; });
    const Method* method = find_method(name.substr(0, name.find('@')));
    rows += fmt::format("<tr><th title=\"{}\">{}</th>", method ? method->about : "", escaped_html(name));
    rows += cell(std::to_string(records.size())) + cell(std::to_string(failed)) + cell(percent(everything_over(records)));
    for (const MeasureRow& row : measure_rows()) rows += cell(percent(measure_over(records, std::string(row.name))));
    rows += "</tr>\n";
  }
  return "<div class=wide><table>" + head + "</tr>\n" + rows + "</table></div>\n";
}

std::string cost_table(const MethodGroups& groups) {
  std::set<std::string> stages;
  for (const auto& [name, records] : groups) {
    for (const auto& [stage, seconds] : median_by_stage(records)) stages.insert(stage);
  }
  std::string head = "<tr><th>method</th><th class=n>time in all</th>", rows;
  for (const std::string& stage : stages) head += "<th class=n>" + escaped_html(stage) + "</th>";
  head += "<th class=n>answers</th><th class=n>tokens asked</th><th class=n>tokens answered</th><th class=n>US dollars</th></tr>\n";
  for (const auto& [name, records] : groups) {
    const std::map<std::string, double> medians = median_by_stage(records);
    rows += named(name) + cell(fmt::format("{:.0f} ms", median_seconds(records) * 1000));
    for (const std::string& stage : stages) {
      const auto found = medians.find(stage);
      rows += cell(found == medians.end() ? "" : fmt::format("{:.0f} ms", found->second * 1000));
    }
    const Spent spent = spent_over(records);
    rows += cell(std::to_string(spent.requests)) + cell(std::to_string(spent.request_tokens)) +
            cell(std::to_string(spent.response_tokens)) + cell(spent.cost_known ? fmt::format("{:.4g}", spent.cost) : "unknown") +
            "</tr>\n";
  }
  return "<div class=wide><table>" + head + rows + "</table></div>\n";
}

std::string size_table(const MethodGroups& groups) {
  std::string rows;
  for (const auto& [name, records] : groups) {
    rows += "<tr><th>" + escaped_html(name) + "</th>";
    for (const Bucket& bucket : by_size(records)) {
      rows += cell(bucket.records.empty()
                       ? "n/a"
                       : percent(everything_over(bucket.records)) + fmt::format(" <small>of {}</small>", bucket.records.size()));
    }
    rows += "</tr>\n";
  }
  return "<table><tr><th>method</th><th class=n>up to 4 objects</th><th class=n>5 to 8</th><th class=n>9 to 12</th><th class=n>more than "
         "12</th></tr>\n" +
         rows + "</table>\n";
}

// A column for each failure that any method has.
std::string failures_table(const MethodGroups& groups) {
  std::map<std::string, int> all;
  for (const auto& [name, records] : groups) all.merge(failures_of(records));
  if (all.empty()) return "<p>No room is impossible.</p>\n";
  std::string head = "<tr><th>method</th><th class=n>rooms</th>", rows;
  for (const auto& [failure, count] : all) head += "<th class=n>" + escaped_html(failure) + "</th>";
  for (const auto& [name, records] : groups) {
    std::map<std::string, int> counts = failures_of(records);
    rows += "<tr><th>" + escaped_html(name) + "</th>" + cell(std::to_string(records.size()));
    for (const auto& [failure, count] : all) rows += cell(std::to_string(counts[failure]));
    rows += "</tr>\n";
  }
  return "<table>" + head + "</tr>\n" + rows + "</table>\n";
}

std::string four_table(const MethodGroups& groups) {
  std::set<std::string> judges;
  std::string rows;
  for (const auto& [name, records] : groups) {
    const FourOver over = four_over(records);
    if (over.rooms == 0) continue;
    for (const RunRecord* record : records) {
      if (record->picture.cut_away) judges.insert(record->picture.judge + ", shown the " + record->picture.shown);
    }
    rows += named(name) + cell(std::to_string(over.rooms)) + cell(percent(over.single.accuracy)) + cell(percent(over.multi.accuracy)) +
            cell(two_places(over.scene_score)) + cell(two_places(over.prompt_score)) + cell(two_places(over.all.kappa)) +
            cell(percent(over.all.neither_rate)) + cell(two_places(over.score_and_answers)) + "</tr>\n";
  }
  if (rows.empty()) return "<p class=skipped>No vision model judged the pictures: n/a.</p>\n";
  std::string who;
  for (const std::string& judge : judges) who += (who.empty() ? "" : "; ") + escaped_html(judge);
  return "<p>Judge: " + who +
         ".</p>\n<div class=wide><table><tr><th>method</th><th class=n>rooms</th><th class=n>single-relation questions right</th>"
         "<th class=n>multi-relation questions right</th><th class=n>score against the scene</th><th class=n>score against the prompt</th>"
         "<th class=n>kappa</th><th class=n>neither yes nor no</th><th class=n>score and right answers, correlation</th></tr>\n" +
         rows + "</table></div>\n";
}

std::string claims_table(const MethodGroups& groups) {
  std::string rows;
  for (const auto& [name, records] : groups) {
    const Sameness same = same_structure(records);
    if (same.prompts > 0) {
      rows += claim("identical structure for the same prompt", name, fmt::format("{} of {} prompts", same.same, same.prompts));
    }
    for (int attempts = 1; attempts <= 8; ++attempts) {
      const auto share = made_within(records, attempts);
      if (!share) continue;
      rows += claim(fmt::format("a layout within {} answer{} of the model", attempts, attempts == 1 ? "" : "s"), name, percent(share));
    }
    rows += claims_of_judge(name, records);
  }
  return rows.empty() ? "<p>Nothing was repeated, and no model was asked.</p>\n"
                      : "<table><tr><th>claim</th><th>method</th><th class=n>measured</th></tr>\n" + rows + "</table>\n";
}

std::string ratings_part(const MethodGroups& groups, const std::vector<Rating>& ratings, std::size_t unknown) {
  if (ratings.empty()) return {};
  std::set<std::string> raters;
  for (const Rating& rating : ratings) raters.insert(rating.rater);
  Records all;
  std::string rows, links;
  for (const auto& [name, records] : groups) {
    all.insert(all.end(), records.begin(), records.end());
    const auto rated = std::count_if(records.begin(), records.end(), [](const RunRecord* record) { return !record->ratings.empty(); });
    if (rated > 0) rows += named(name) + cell(std::to_string(rated)) + cell(two_places(rating_over(records))) + "</tr>\n";
  }
  for (const RatingLink& link : rating_links(all)) {
    links +=
        named(link.name) + cell(std::to_string(link.rooms)) + cell(two_places(link.pearson)) + cell(two_places(link.spearman)) + "</tr>\n";
  }
  const std::optional<double> agreement = agreement_of(ratings);
  return fmt::format("<h2>Ratings by people</h2>\n<p>{} ratings, 1 to 10, in {} file{}{}{}.</p>\n", ratings.size(), raters.size(),
                     raters.size() == 1 ? "" : "s", unknown == 0 ? "" : fmt::format(", {} of rooms that are not here", unknown),
                     agreement ? fmt::format("; raters agree with {:.2f} (rank correlation)", *agreement) : "") +
         "<table><tr><th>method</th><th class=n>rooms rated</th><th class=n>mean</th></tr>\n" + rows +
         "</table>\n<p>How they go with what else is known of the same rooms, 1 to −1; COL and OOB are faults.</p>\n"
         "<table><tr><th>figure</th><th class=n>rooms</th><th class=n>correlation</th><th class=n>of ranks</th></tr>\n" +
         links + "</table>\n";
}

}  // namespace layoutbox::experiment
