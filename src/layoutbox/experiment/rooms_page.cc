#include "layoutbox/experiment/rooms_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "layoutbox/base/bytes.h"
#include "layoutbox/base/files.h"
#include "layoutbox/experiment/tables.h"
#include "layoutbox/judge/report_html.h"

namespace layoutbox::experiment {
namespace {

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

std::string said_of(const RunRecord& record) {
  std::string text;
  if (const auto& four = record.picture.cut_away) {
    const auto score = [](const std::optional<double>& value) { return value ? fmt::format("{:.2f}", *value) : std::string("none"); };
    text += fmt::format(
        "<small>{} of {} single and {} of {} multi-relation answers right; score {} against the scene, {} against the prompt</small>",
        four->single.true_yes + four->single.true_no, four->single.answers, four->multi.true_yes + four->multi.true_no, four->multi.answers,
        score(four->scene_score), score(four->prompt_score));
  }
  if (const auto rating = record.rating()) text += fmt::format("<small>rated {:.1f} of 10</small>", *rating);
  return text;
}

std::string picture_of(const RunRecord& record, const std::filesystem::path& folder) {
  if (folder.empty()) return {};
  const auto bytes = read_file(folder / "runs" / record.folder() / "scene-small.jpg", 8u << 20);
  return bytes ? fmt::format("<img alt=\"the room\" src=\"data:image/jpeg;base64,{}\">", base64(*bytes)) : std::string();
}

// A room, and the methods that made it just so.
struct RoomCell {
  const RunRecord* record;
  std::string methods, plan;
};

std::vector<RoomCell> cells_of(const scoring::Annotation& scene, const ExperimentOutcome& outcome, PlanStyles& styles) {
  std::vector<RoomCell> cells;
  for (const RunRecord& record : outcome.records) {
    if (record.scene != scene.id || record.repeat != 1) continue;
    const std::string plan = record.judgement.error.empty() ? styles.shared(judged_plan(record.judgement, false)) : std::string();
    const auto same = std::find_if(cells.begin(), cells.end(), [&](const RoomCell& cell) {
      return !plan.empty() && cell.plan == plan && cell.record->judgement.everything == record.judgement.everything;
    });
    if (same == cells.end()) {
      cells.push_back({&record, escaped_html(record.method), plan});
    } else {
      same->methods += ", " + escaped_html(record.method);
    }
  }
  return cells;
}

}  // namespace

std::string PlanStyles::shared(const std::string& svg) {
  std::string text;
  text.reserve(svg.size());
  for (std::size_t at = 0; at < svg.size();) {
    const std::size_t end = std::min(svg.find('\n', at), svg.size() - 1) + 1;
    const std::string line = svg.substr(at, end - at);
    at = end;
    const std::size_t fill = line.starts_with("<text") ? std::string::npos : line.find(" fill=\""), close = line.rfind("/>");
    if (fill == std::string::npos || close == std::string::npos || close < fill) {
      text += line;
      continue;
    }
    const std::size_t number = classes_.emplace(line.substr(fill, close - fill), classes_.size()).first->second;
    text += fmt::format("{} class=k{} />\n", line.substr(0, fill), number);
  }
  return text;
}

std::string PlanStyles::css() const {
  std::string text;
  for (const auto& [attributes, number] : classes_) {
    text += fmt::format(".k{}{{", number);
    std::size_t at = 0;  // ` fill="#fff" stroke="#333"` → `fill:#fff;stroke:#333;`
    while ((at = attributes.find('"', at)) != std::string::npos) {
      const std::size_t blank = attributes.rfind(' ', at), end = attributes.find('"', at + 1);
      if (end == std::string::npos) break;
      text += attributes.substr(blank + 1, at - blank - 2) + ":" + attributes.substr(at + 1, end - at - 1) + ";";
      at = end + 1;
    }
    text += "}";
  }
  return text;
}

std::string rooms_side_by_side(const Suite& suite, const ExperimentOutcome& outcome, const std::filesystem::path& folder,
                               PlanStyles& styles) {
  std::string text;
  for (const scoring::Annotation& scene : suite.scenes) {
    text += fmt::format("<h3>{}</h3>\n<p>{}</p>\n<div class=rooms>\n", escaped_html(scene.id), escaped_html(scene.prompt));
    for (const RoomCell& cell : cells_of(scene, outcome, styles)) {
      const Judgement& judgement = cell.record->judgement;
      text += fmt::format("<div><b>{}</b> <span class={}>{}</span>{}{}{}{}</div>\n", cell.methods, judgement.everything ? "good" : "bad",
                          judgement.everything               ? "everything met"
                          : cell.record->outcome == "failed" ? escaped_html(cell.record->error)
                                                             : "not all is met",
                          picture_of(*cell.record, folder), cell.plan, said_of(*cell.record),
                          judgement.everything ? "" : what_is_missing(judgement));
    }
    text += "</div>\n";
  }
  return text;
}

}  // namespace layoutbox::experiment
