// The experiment's page, and its lines for a terminal.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "layoutbox/experiment/charts.h"
#include "layoutbox/experiment/report_tables.h"
#include "layoutbox/experiment/rooms_page.h"
#include "layoutbox/judge/report_html.h"

namespace layoutbox::experiment {
namespace {

constexpr std::string_view kStyle = R"(body{font:15px/1.45 system-ui,sans-serif;margin:2rem auto;max-width:1500px;padding:0 1rem;color:#222}
h1{margin-bottom:.2rem}h2{margin-top:2.2rem}h3{margin:2rem 0 .2rem;border-top:1px solid #ddd;padding-top:1rem}p{max-width:60rem}
.wide{overflow-x:auto}table{border-collapse:collapse;margin:.8rem 0;font-size:13px}td,th{padding:.3rem .6rem;text-align:left;border-bottom:1px solid #e4e4e4;vertical-align:top;white-space:nowrap}
td.n,th.n{text-align:right;font-variant-numeric:tabular-nums}td small{display:block}small,.skipped{color:#666}.bad{color:#b00000}.good{color:#186a1e}
.chart{width:100%;max-width:1330px;height:auto;font:13px system-ui,sans-serif}.axis{font-size:10px;fill:#777}
.rooms{display:grid;grid-template-columns:repeat(auto-fill,minmax(18rem,1fr));gap:1.2rem 1rem}.rooms svg,.rooms img{width:100%;height:auto;max-height:18rem;border:1px solid #ddd;background:#fff}.rooms svg{stroke-linejoin:round}.rooms svg text{font-size:4px}
.rooms small{display:block;overflow-wrap:anywhere;line-height:1.3;margin-top:.2rem})";

// Those that were not run for one reason, in one line.
std::string skipped_text(const std::vector<std::string>& skipped) {
  std::map<std::string, std::string> by_reason;
  for (const std::string& line : skipped) {
    const std::size_t colon = line.find(": ");
    std::string& names = by_reason[colon == std::string::npos ? "" : line.substr(colon + 2)];
    names += (names.empty() ? "" : ", ") + line.substr(0, colon);
  }
  std::string text;
  for (const auto& [reason, names] : by_reason) {
    text +=
        fmt::format("<p class=skipped>Not run{}{}: {}.</p>\n", reason.empty() ? "" : ", as ", escaped_html(reason), escaped_html(names));
  }
  return text;
}

std::string options_text(const ExperimentOptions& options) {
  std::string models;
  for (const ModelAtHand& model : options.models) models += (models.empty() ? "" : ", ") + model.name;
  return fmt::format(
      "{} repetition{} (the repetition's number is the seed), effort {}, {} answers of a model at most, {} of these after a scene without "
      "a layout; model: {}.",
      options.repeats, options.repeats == 1 ? "" : "s", options.generate.solve.effort, options.generate.repair.max_attempts,
      options.generate.repair.repair_attempts, models.empty() ? "none" : models);
}

}  // namespace

std::string experiment_html(const Suite& suite, const ExperimentOutcome& outcome, const ExperimentOptions& options,
                            const std::filesystem::path& folder) {
  const MethodGroups groups = by_method(outcome);
  PlanStyles styles;
  const std::string rooms = rooms_side_by_side(suite, outcome, folder, styles);
  std::string page = fmt::format(
      "<!doctype html>\n<html lang=en><head><meta charset=utf-8><meta name=viewport content=\"width=device-width\"><title>Experiment "
      "{}</title><style>{}\n{}</style></head><body>\n",
      escaped_html(suite.name), kStyle, styles.css());
  page += fmt::format("<h1>Experiment: {}</h1>\n<p>{} prompts. {}</p>\n", escaped_html(suite.name), suite.scenes.size(),
                      escaped_html(options_text(options)));
  page += skipped_text(outcome.skipped);
  if (!outcome.no_pictures.empty()) page += fmt::format("<p class=skipped>No pictures: {}.</p>\n", escaped_html(outcome.no_pictures));
  page +=
      "<h2>Methods</h2>\n<p>Shares with 95 % intervals: Wilson's for rooms, resampled rooms for the rest. COL and OOB: less is "
      "better.</p>\n";
  page += shares_chart(groups) + methods_table(groups);
  page += "<ul>";
  for (const auto& [name, records] : groups) {
    if (const Method* method = find_method(name.substr(0, name.find('@'))))
      page += fmt::format("<li><b>{}</b>: {}</li>", escaped_html(name), method->about);
  }
  page += "</ul>\n<h2>Everything met, by the number of objects in the room</h2>\n" + size_table(groups);
  page += "<h2>Rooms that cannot be, by what is wrong</h2>\n" + failures_table(groups);
  page += "<h2>Four judgements of a vision model</h2>\n" + four_table(groups);
  page += ratings_part(groups, options.ratings, outcome.unknown_ratings);
  page += "<h2>Time and cost</h2>\n<p>Medians of the wall clock by stage; what answers took, over all rooms.</p>\n" + cost_table(groups);
  page += "<h2>Claims of the paper</h2>\n" + claims_table(groups);
  page += "<h2>Rooms side by side</h2>\n<p>What failed, or only warns, is drawn in red; pointing at a thing says its name.</p>\n" + rooms;
  return page + "</body></html>\n";
}

std::string experiment_text(const ExperimentOutcome& outcome) {
  std::string text;
  for (const auto& [name, records] : by_method(outcome)) {
    const auto share = [&](const char* measure) {
      const auto estimate = measure_over(records, measure);
      return estimate ? fmt::format("{:5.1f} %", estimate->value * 100) : std::string("    n/a");
    };
    const auto met = everything_over(records);
    std::string failures;
    for (const auto& [failure, count] : failures_of(records))
      failures += fmt::format("{}{} {}", failures.empty() ? "   " : ", ", failure, count);
    const FourOver four = four_over(records);
    std::string said;
    if (four.rooms > 0) {
      const auto right = [](const vlm::AnswerFigures& f) { return f.accuracy ? fmt::format("{:.1f} %", f.accuracy->value * 100) : "n/a"; };
      const auto mean = [](const std::optional<vlm::Estimate>& score) { return score ? fmt::format("{:.2f}", score->value) : "n/a"; };
      said = fmt::format(" single {} multi {} scene {} prompt {}", right(four.single), right(four.multi), mean(four.scene_score),
                         mean(four.prompt_score));
    }
    text += fmt::format("{:16} everything {:5.1f} % of {:3}   CNT {} OOR {} OAR {} COL {} OOB {} SUP {}{}{}\n", name,
                        met ? met->value * 100 : 0.0, records.size(), share("CNT"), share("OOR"), share("OAR"), share("COL"), share("OOB"),
                        share("SUP"), said, failures);
  }
  if (!text.empty()) text.pop_back();
  return text;
}

}  // namespace layoutbox::experiment
