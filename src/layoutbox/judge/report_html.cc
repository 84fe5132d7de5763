#include "layoutbox/judge/report_html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "layoutbox/base/bytes.h"
#include "layoutbox/export/export.h"
#include "layoutbox/verify/room_view.h"

namespace layoutbox {
namespace {

constexpr std::string_view kStyle = R"(body{font:15px/1.45 system-ui,sans-serif;margin:2rem auto;max-width:1200px;padding:0 1rem;color:#222}
h1{font-size:1.5rem}h2{font-size:1.2rem;margin-top:2.5rem;border-top:1px solid #ccc;padding-top:1rem}
table{border-collapse:collapse;margin:.8rem 0}td,th{padding:.2rem .7rem;text-align:left;border-bottom:1px solid #e4e4e4;vertical-align:top}
td.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}.bad{color:#b00000;font-weight:600}.good{color:#186a1e}
.side{display:flex;gap:1rem;flex-wrap:wrap;align-items:flex-start}.side>*{flex:1 1 30rem;max-width:100%;height:auto}
.side svg,.side img{width:100%;height:auto;border:1px solid #ddd}.note{color:#666;font-size:.9em}summary{cursor:pointer})";

using Corners = std::vector<std::array<double, 2>>;

Corners corners_of(const checks::Polygon& polygon) {
  Corners corners;
  for (const checks::Vec2d& corner : polygon) corners.push_back({corner.x * 1000, corner.y * 1000});
  return corners;
}

const Check* number_of(const std::vector<const Check*>& failed, std::size_t i) { return i < failed.size() ? failed[i] : nullptr; }

std::vector<const Check*> failed_checks(const Report& report) {
  std::vector<const Check*> failed;
  for (const Check& check : report.checks) {
    if (!check.passed) failed.push_back(&check);
  }
  return failed;
}

// Where a failed check is on the floor: the shared part of two bodies, an object, the space before an opening. Empty: the whole room.
Corners place_of(const Check& check, const checks::RoomView& view) {
  if (check.name == "collision") {
    const std::size_t bar = check.subject.find(" / ");
    const checks::Body* a = view.find_body(check.subject.substr(0, bar));
    const checks::Body* b = bar == std::string::npos ? nullptr : view.find_body(check.subject.substr(bar + 3));
    if (a && b) return corners_of(checks::clip(a->shape.plan, b->shape.plan));
  }
  if (const checks::Body* body = view.find_body(check.subject)) return corners_of(body->shape.plan);
  if (const checks::Face* opening = view.find_opening(check.subject)) return corners_of(checks::space_before(*opening).plan);
  if (check.name != "relation") return {};
  for (const PlacedRelation& placed : view.layout.relations) {
    if (placed.relation.id != check.subject || placed.relation.targets.empty()) continue;
    if (const checks::Body* target = view.find_body(placed.relation.targets[0])) return corners_of(target->shape.plan);
  }
  return {};
}

std::string plan_of(const Judgement& judgement, const std::vector<const Check*>& failed, bool sheet = true) {
  const VerifyOptions options;
  const Catalog& catalog = Catalog::builtin();  // what is judged comes from files
  const checks::RoomView view(judgement.room.layout, catalog, options);
  FloorPlanOptions plan;
  plan.sheet = sheet;
  for (std::size_t i = 0; i < failed.size(); ++i) {
    Corners corners = place_of(*failed[i], view);
    if (corners.size() < 3) continue;
    const auto same = std::find_if(plan.marks.begin(), plan.marks.end(), [&](const PlanMark& mark) { return mark.corners == corners; });
    if (same == plan.marks.end()) {
      plan.marks.push_back({std::move(corners), std::to_string(i + 1)});
    } else {
      same->label += fmt::format(", {}", i + 1);
    }
  }
  std::string svg = write_floor_plan_svg(judgement.room.layout, catalog, plan);
  const std::size_t start = svg.find("<svg");
  return start == std::string::npos ? svg : svg.substr(start);
}

std::string share_cell(const Tally& tally) {
  if (tally.whole <= 0) return "<td class=n>n/a</td><td class=n></td>";
  const std::string part = tally.part == std::floor(tally.part) ? fmt::format("{:.0f}", tally.part) : fmt::format("{:.2f}", tally.part);
  return fmt::format("<td class=n>{:.1f} %</td><td class=n>{} / {:.0f}</td>", tally.share() * 100, part, tally.whole);
}

std::string measures_table(const std::map<std::string, Tally>& measures) {
  std::string rows;
  for (const MeasureRow& row : measure_rows()) {
    const auto found = measures.find(std::string(row.name));
    const Tally tally = found == measures.end() ? Tally{} : found->second;
    const bool bad = tally.whole > 0 && (row.more_is_better ? tally.share() < 0.9 : tally.part > 0);
    rows += fmt::format("<tr><th class={}>{}</th>{}<td>{}{}</td></tr>\n", bad ? "bad" : "good", row.name, share_cell(tally),
                        escaped_html(row.meaning), row.more_is_better ? "" : " (less is better)");
  }
  return "<table>\n" + rows + "</table>\n";
}

std::string checks_table(const Report& report, const std::vector<const Check*>& failed) {
  const auto row = [](const std::string& mark, const Check& check) {
    const auto shown = [&](double value) { return check.unit.empty() ? std::string() : fmt::format("{:.3f} {}", value, check.unit); };
    return fmt::format(
        "<tr><td class=n>{}</td><td>{}</td><td>{}</td><td class=n>{}</td><td class=n>{}</td><td "
        "class={}>{}</td><td>{}</td><td><code>{}</code></td></tr>\n",
        mark, escaped_html(check.name), escaped_html(check.subject), shown(check.value), check.limit ? shown(*check.limit) : "",
        check.passed ? "good" : "bad",
        check.passed     ? "passed"
        : check.required ? "failed"
                         : "warning",
        escaped_html(check.message), escaped_html(check.pointer));
  };
  const std::string head =
      "<tr><th></th><th>check</th><th>of</th><th>figure</th><th>limit</th><th>verdict</th><th></th><th>place</th></tr>\n";
  std::string wrong, right;
  for (std::size_t i = 0; const Check* check = number_of(failed, i); ++i) wrong += row(std::to_string(i + 1), *check);
  std::size_t passed = 0;
  for (const Check& check : report.checks) {
    if (!check.passed) continue;
    right += row("", check);
    ++passed;
  }
  std::string text;
  if (!wrong.empty()) text += "<h3>What is wrong</h3>\n<table>" + head + wrong + "</table>\n";
  return text + fmt::format("<details><summary>{} checks passed</summary><table>{}{}</table></details>\n", passed, head, right);
}

std::string entries_table(const std::vector<scoring::Verdict>& verdicts) {
  if (verdicts.empty()) return {};
  std::string rows;
  for (const scoring::Verdict& verdict : verdicts) {
    rows += fmt::format("<tr><td>{}</td><td><code>{}</code></td><td class={}>{}</td><td>{}</td></tr>\n", name_of(verdict.kind),
                        escaped_html(verdict.entry), verdict.holds ? "good" : "bad", verdict.holds ? "holds" : "does not hold",
                        escaped_html(verdict.why));
  }
  return "<h3>What was asked for</h3>\n<table><tr><th></th><th>entry</th><th></th><th>what was found</th></tr>\n" + rows + "</table>\n";
}

std::string room_section(const Judgement& judgement, const std::map<std::string, RoomPicture>& pictures) {
  std::string text = fmt::format("<h2>{} <span class={}>{}</span></h2>\n", escaped_html(judgement.name),
                                 judgement.everything ? "good" : "bad", judgement.everything ? "everything met" : "not all is met");
  if (!judgement.error.empty()) return text + fmt::format("<p class=bad>{}</p>\n", escaped_html(judgement.error));
  if (!judgement.room.layout.prompt.empty()) text += fmt::format("<p>{}</p>\n", escaped_html(judgement.room.layout.prompt));
  const std::vector<const Check*> failed = failed_checks(judgement.report);
  text += "<div class=side>";
  if (const auto picture = pictures.find(judgement.name); picture != pictures.end()) {
    text += fmt::format("<div><img alt=\"the room\" src=\"data:{};base64,{}\"></div>", picture->second.media_type,
                        base64(picture->second.bytes));
  }
  text += "<div>" + plan_of(judgement, failed) + "</div></div>\n";
  text += measures_table(judgement.measures) + entries_table(judgement.verdicts) + checks_table(judgement.report, failed);
  for (const Note& note : judgement.room.notes) {
    text += fmt::format("<p class=note>{}: {}</p>\n", escaped_html(note.code), escaped_html(note.message));
  }
  return text;
}

}  // namespace

std::string judged_plan(const Judgement& judgement, bool sheet) { return plan_of(judgement, failed_checks(judgement.report), sheet); }

std::string escaped_html(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t') out += c;
    }
  }
  return out;
}

std::string judgement_html(const std::vector<Judgement>& judgements, const std::map<std::string, RoomPicture>& pictures) {
  std::string page = fmt::format(
      "<!doctype html>\n<html lang=en><head><meta charset=utf-8><title>Rooms judged</title><style>{}</style></head><body>\n", kStyle);
  const auto met = std::count_if(judgements.begin(), judgements.end(), [](const Judgement& judgement) { return judgement.everything; });
  page += fmt::format("<h1>{} of {} rooms with everything met</h1>\n", met, judgements.size());
  if (judgements.size() > 1) page += measures_table(totals(judgements));
  for (const Judgement& judgement : judgements) page += room_section(judgement, pictures);
  return page + "</body></html>\n";
}

}  // namespace layoutbox
