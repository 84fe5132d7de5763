// Judgements in words and as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "layoutbox/judge/judge.h"

namespace layoutbox {
namespace {

using Json = nlohmann::ordered_json;

std::string tally_text(const Tally& tally) {
  if (tally.whole <= 0) return "    n/a  (0/0)";
  const bool whole_number = tally.part == std::floor(tally.part);
  return fmt::format("{:7.1f} %  ({}/{:.0f})", tally.share() * 100,
                     whole_number ? fmt::format("{:.0f}", tally.part) : fmt::format("{:.2f}", tally.part), tally.whole);
}

std::string reasons_of(const Judgement& judgement) {
  std::string text;
  if (!judgement.error.empty()) return fmt::format("# {}: {}\n", judgement.name, judgement.error);
  for (const scoring::Verdict& verdict : judgement.verdicts) {
    if (!verdict.holds) text += fmt::format("  {}  {}\n       {}\n", name_of(verdict.kind), verdict.entry, verdict.why);
  }
  for (const Check& check : judgement.report.checks) {
    if (!check.passed && check.name != "relation") text += fmt::format("  {}  {}\n", check.name, check.message);
  }
  for (const Note& note : judgement.room.notes) text += fmt::format("  {}  {}\n", note.code, note.message);
  return text.empty() ? "" : fmt::format("# {}\n{}", judgement.name, text);
}

double rounded_share(double value) { return std::round(value * 1e6) / 1e6; }

Json measures_json(const std::map<std::string, Tally>& measures) {
  Json list = Json::object();
  for (const MeasureRow& row : measure_rows()) {
    const auto found = measures.find(std::string(row.name));
    if (found == measures.end()) continue;
    const Tally& tally = found->second;
    list[std::string(row.name)] = {{"part", rounded_share(tally.part)},
                                   {"whole", rounded_share(tally.whole)},
                                   {"share", tally.whole > 0 ? Json(rounded_share(tally.share())) : Json(nullptr)}};
  }
  return list;
}

Json room_json(const Judgement& judgement) {
  Json entries = Json::array(), checks = Json::array(), notes = Json::array();
  for (const scoring::Verdict& verdict : judgement.verdicts) {
    entries.push_back({{"kind", name_of(verdict.kind)}, {"entry", verdict.entry}, {"holds", verdict.holds}, {"why", verdict.why}});
  }
  for (const Check& check : judgement.report.checks) {
    if (check.passed) continue;
    checks.push_back({{"name", check.name},
                      {"subject", check.subject},
                      {"value", rounded_share(check.value)},
                      {"unit", check.unit},
                      {"message", check.message},
                      {"pointer", check.pointer}});
  }
  for (const Note& note : judgement.room.notes) notes.push_back({{"code", note.code}, {"message", note.message}});
  Json room{{"name", judgement.name}, {"format", judgement.room.format}};
  if (!judgement.error.empty()) room["error"] = judgement.error;
  room["everything"] = judgement.everything;
  room["objects"] = judgement.room.layout.objects.size();
  room["measures"] = measures_json(judgement.measures);
  room["entries"] = std::move(entries);
  room["failed"] = std::move(checks);
  room["notes"] = std::move(notes);
  return room;
}

std::size_t wholly_met(const std::vector<Judgement>& judgements) {
  return static_cast<std::size_t>(std::count_if(judgements.begin(), judgements.end(), [](const Judgement& j) { return j.everything; }));
}

}  // namespace

std::string judgement_text(const std::vector<Judgement>& judgements, bool reasons) {
  std::string text;
  if (reasons) {
    for (const Judgement& judgement : judgements) text += reasons_of(judgement);
    if (!text.empty()) text += "\n";
  }
  const std::map<std::string, Tally> sums = totals(judgements);
  for (const MeasureRow& row : measure_rows()) {
    const auto found = sums.find(std::string(row.name));
    text += fmt::format("{:10} {:26} {}{}\n", row.name, tally_text(found == sums.end() ? Tally{} : found->second), row.meaning,
                        row.more_is_better ? "" : " (less is better)");
  }
  const std::size_t met = wholly_met(judgements);
  text += fmt::format("{:10} {:26} rooms with everything met", "everything",
                      tally_text({static_cast<double>(met), static_cast<double>(judgements.size())}));
  return text;
}

std::string judgement_json(const std::vector<Judgement>& judgements) {
  Json rooms = Json::array();
  for (const Judgement& judgement : judgements) rooms.push_back(room_json(judgement));
  const Json document{{"format", "layoutbox/judgement@1"},
                      {"measures", measures_json(totals(judgements))},
                      {"everything", {{"part", wholly_met(judgements)}, {"whole", judgements.size()}}},
                      {"rooms", std::move(rooms)}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace layoutbox
