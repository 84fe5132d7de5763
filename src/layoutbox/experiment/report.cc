// The experiment's page, its table for spreadsheets, and its lines for a terminal.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "layoutbox/experiment/charts.h"
#include "layoutbox/experiment/tables.h"
#include "layoutbox/judge/report_html.h"

namespace layoutbox::experiment {
namespace {

constexpr std::string_view kStyle = R"(body{font:15px/1.45 system-ui,sans-serif;margin:2rem auto;max-width:1500px;padding:0 1rem;color:#222}
h1{margin-bottom:.2rem}h2{margin-top:2.2rem}h3{margin:2rem 0 .2rem;border-top:1px solid #ddd;padding-top:1rem}p{max-width:60rem}
.wide{overflow-x:auto}table{border-collapse:collapse;margin:.8rem 0;font-size:13px}td,th{padding:.3rem .6rem;text-align:left;border-bottom:1px solid #e4e4e4;vertical-align:top;white-space:nowrap}
td.n,th.n{text-align:right;font-variant-numeric:tabular-nums}td small{display:block}small,.skipped{color:#666}.bad{color:#b00000}.good{color:#186a1e}
.chart{width:100%;max-width:1330px;height:auto;font:13px system-ui,sans-serif}.axis{font-size:10px;fill:#777}
.rooms{display:grid;grid-template-columns:repeat(auto-fill,minmax(15rem,1fr));gap:1.2rem 1rem}.rooms svg{width:100%;height:15rem;border:1px solid #ddd;background:#fff}
.rooms small{display:block;overflow-wrap:anywhere;line-height:1.3;margin-top:.2rem})";

std::string percent(const std::optional<vlm::Estimate>& estimate) {
  if (!estimate) return "n/a";
  return fmt::format("{:.1f} % <small>[{:.0f}, {:.0f}]</small>", estimate->value * 100, estimate->low * 100, estimate->high * 100);
}

std::string cell(const std::string& text) { return "<td class=n>" + text + "</td>"; }

std::string methods_table(const std::vector<std::pair<std::string, Records>>& groups) {
  std::string head = "<tr><th>method</th><th class=n>rooms</th><th class=n>failed</th><th class=n>everything met</th>", rows;
  for (const MeasureRow& row : measure_rows()) head += fmt::format("<th class=n title=\"{}\">{}</th>", escaped_html(row.meaning), row.name);
  for (const auto& [name, records] : groups) {
    const auto failed = std::count_if(records.begin(), records.end(), [](const RunRecord* record) { return record->outcome == "failed"; });
    const Method* method = find_method(name);
    rows += fmt::format("<tr><th title=\"{}\">{}</th>", method ? method->about : "", escaped_html(name));
    rows += cell(std::to_string(records.size())) + cell(std::to_string(failed)) + cell(percent(everything_over(records)));
    for (const MeasureRow& row : measure_rows()) rows += cell(percent(measure_over(records, std::string(row.name))));
    rows += cell(fmt::format("{:.0f} ms", median_seconds(records) * 1000)) + "</tr>\n";
  }
  return "<div class=wide><table>" + head + "<th class=n>median time</th></tr>\n" + rows + "</table></div>\n";
}

std::string size_table(const std::vector<std::pair<std::string, Records>>& groups) {
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
std::string failures_table(const std::vector<std::pair<std::string, Records>>& groups) {
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

std::string claims_table(const std::vector<std::pair<std::string, Records>>& groups) {
  std::string rows;
  for (const auto& [name, records] : groups) {
    const Sameness same = same_structure(records);
    if (same.prompts > 0) {
      rows += fmt::format("<tr><td>identical structure for the same prompt</td><td>{}</td>{}</tr>\n", escaped_html(name),
                          cell(fmt::format("{} of {} prompts", same.same, same.prompts)));
    }
    for (int attempts = 1; attempts <= 8; ++attempts) {
      const auto share = made_within(records, attempts);
      if (!share) continue;
      rows += fmt::format("<tr><td>a layout within {} answer{} of the model</td><td>{}</td>{}</tr>\n", attempts, attempts == 1 ? "" : "s",
                          escaped_html(name), cell(percent(share)));
    }
  }
  return rows.empty() ? "<p>Nothing was repeated, and no model was asked.</p>\n"
                      : "<table><tr><th>claim</th><th>method</th><th class=n>measured</th></tr>\n" + rows + "</table>\n";
}

// What keeps a room from everything met: entries that do not hold, measures that are not as they should be.
std::string what_is_missing(const Judgement& judgement) {
  std::string text;
  for (const scoring::Verdict& verdict : judgement.verdicts) {
    if (!verdict.holds) text += fmt::format("<small>{} <code>{}</code></small>", name_of(verdict.kind), escaped_html(verdict.entry));
  }
  for (const MeasureRow& row : measure_rows()) {
    const auto found = judgement.measures.find(std::string(row.name));
    if (found == judgement.measures.end() || row.name == "CF" || row.name == "IB") continue;
    const double share = found->second.whole > 0 ? found->second.share() : (row.more_is_better ? 1 : 0);
    const double least = row.name == "ACC" ? 0.9 : row.name == "NAV" ? 0.99 : 1;
    const bool of_entries = row.name == "CNT" || row.name == "OOR" || row.name == "OAR";
    if (of_entries || (row.more_is_better ? share >= least : share == 0)) continue;
    text += fmt::format("<small>{} {:.0f} %: {}</small>", row.name, share * 100, escaped_html(row.meaning));
  }
  return text;
}

std::string rooms_of(const Suite& suite, const ExperimentOutcome& outcome) {
  std::string text;
  for (const scoring::Annotation& scene : suite.scenes) {
    text += fmt::format("<h3>{}</h3>\n<p>{}</p>\n<div class=rooms>\n", escaped_html(scene.id), escaped_html(scene.prompt));
    for (const RunRecord& record : outcome.records) {
      if (record.scene != scene.id || record.repeat != 1) continue;
      const Judgement& judgement = record.judgement;
      text += fmt::format("<div><b>{}</b> <span class={}>{}</span>{}{}</div>\n", escaped_html(record.method),
                          judgement.everything ? "good" : "bad",
                          judgement.everything         ? "everything met"
                          : record.outcome == "failed" ? escaped_html(record.error)
                                                       : "not all is met",
                          judgement.error.empty() ? judged_plan(judgement) : "", judgement.everything ? "" : what_is_missing(judgement));
    }
    text += "</div>\n";
  }
  return text;
}

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
  return fmt::format(
      "{} repetition{} (the repetition's number is the seed), effort {}, {} answers of a model at most, {} of these after a scene without "
      "a layout; model: {}.",
      options.repeats, options.repeats == 1 ? "" : "s", options.generate.solve.effort, options.generate.repair.max_attempts,
      options.generate.repair.repair_attempts, options.model_name.empty() ? "none" : options.model_name);
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c == '\n' ? ' ' : c);
  return out + "\"";
}

}  // namespace

std::string results_csv(const ExperimentOutcome& outcome) {
  std::string text = "scene,method,repeat,outcome,failure,everything,objects,requests,seconds";
  for (const MeasureRow& row : measure_rows()) text += fmt::format(",{}_part,{}_whole", row.name, row.name);
  text += ",error\n";
  for (const RunRecord& record : outcome.records) {
    double seconds = 0;
    for (const auto& [stage, time] : record.seconds) seconds += time;
    text += fmt::format("{},{},{},{},{},{},{},{},{:.4f}", quoted(record.scene), record.method, record.repeat, record.outcome,
                        quoted(record.failure), record.judgement.everything ? 1 : 0, record.judgement.room.layout.objects.size(),
                        record.requests, seconds);
    for (const MeasureRow& row : measure_rows()) {
      const auto found = record.judgement.measures.find(std::string(row.name));
      const Tally tally = found == record.judgement.measures.end() ? Tally{} : found->second;
      text += fmt::format(",{:.6g},{:.6g}", tally.part, tally.whole);
    }
    text += "," + quoted(record.error) + "\n";
  }
  return text;
}

std::string experiment_html(const Suite& suite, const ExperimentOutcome& outcome, const ExperimentOptions& options) {
  const auto groups = by_method(outcome);
  std::string page = fmt::format(
      "<!doctype html>\n<html lang=en><head><meta charset=utf-8><meta name=viewport content=\"width=device-width\"><title>Experiment "
      "{}</title><style>{}</style></head><body>\n",
      escaped_html(suite.name), kStyle);
  page += fmt::format("<h1>Experiment: {}</h1>\n<p>{} prompts. {}</p>\n", escaped_html(suite.name), suite.scenes.size(),
                      escaped_html(options_text(options)));
  page += skipped_text(outcome.skipped);
  page +=
      "<h2>Methods</h2>\n<p>Shares with 95 % intervals: Wilson's for rooms, resampled rooms for the rest. COL and OOB: less is "
      "better.</p>\n";
  page += shares_chart(groups) + methods_table(groups);
  page += "<ul>";
  for (const auto& [name, records] : groups) {
    if (const Method* method = find_method(name)) page += fmt::format("<li><b>{}</b>: {}</li>", method->name, method->about);
  }
  page += "</ul>\n<h2>Everything met, by the number of objects in the room</h2>\n" + size_table(groups);
  page += "<h2>Rooms that cannot be, by what is wrong</h2>\n" + failures_table(groups);
  page += "<h2>Claims of the paper</h2>\n" + claims_table(groups);
  page += "<h2>Rooms side by side</h2>\n<p>What failed, or only warns, is drawn in red.</p>\n" + rooms_of(suite, outcome);
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
    text += fmt::format("{:16} everything {:5.1f} % of {:3}   CNT {} OOR {} OAR {} COL {} OOB {} SUP {}{}\n", name,
                        met ? met->value * 100 : 0.0, records.size(), share("CNT"), share("OOR"), share("OAR"), share("COL"), share("OOB"),
                        share("SUP"), failures);
  }
  if (!text.empty()) text.pop_back();
  return text;
}

}  // namespace layoutbox::experiment
