#include "layoutbox/experiment/records.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "layoutbox/scene/json_text.h"

namespace layoutbox::experiment {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json counts_json(const vlm::AnswerFigures& f) { return {f.true_yes, f.false_yes, f.true_no, f.false_no, f.neither}; }

Json json_of(const FourJudgements& four) {
  return {{"single", counts_json(four.single)},
          {"multi", counts_json(four.multi)},
          {"sceneScore", or_null(four.scene_score)},
          {"promptScore", or_null(four.prompt_score)}};
}

std::optional<double> number_in(const nlohmann::json& document, const char* key) {
  if (!document.contains(key) || !document.at(key).is_number()) return std::nullopt;
  return document.at(key).get<double>();
}

vlm::AnswerFigures counts_in(const nlohmann::json& document, const char* key) {
  const auto counts = document.value(key, std::vector<int>(5, 0));
  vlm::AnswerFigures f;
  if (counts.size() != 5) return f;
  f.true_yes = counts[0], f.false_yes = counts[1], f.true_no = counts[2], f.false_no = counts[3], f.neither = counts[4];
  for (const int count : counts) f.answers += count;
  return vlm::figures_of_counts(f);
}

std::optional<FourJudgements> four_in(const nlohmann::json& document, const char* key) {
  if (!document.contains(key) || !document.at(key).is_object()) return std::nullopt;
  const nlohmann::json& four = document.at(key);
  return FourJudgements{counts_in(four, "single"), counts_in(four, "multi"), number_in(four, "sceneScore"), number_in(four, "promptScore")};
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c == '\n' ? ' ' : c);
  return out + "\"";
}

std::string figure(const std::optional<double>& value) { return value ? fmt::format("{:.4g}", *value) : std::string(); }

// The columns of a run's four judgements: answers that are right and all, of questions of each kind; scores.
std::string judgement_columns(const std::optional<FourJudgements>& four) {
  if (!four) return ",,,,,";
  const vlm::AnswerFigures &s = four->single, &m = four->multi;
  return fmt::format("{},{},{},{},{},{}", s.true_yes + s.true_no, s.answers, m.true_yes + m.true_no, m.answers, figure(four->scene_score),
                     figure(four->prompt_score));
}

}  // namespace

std::string line_of(const RunRecord& record) {
  Json measures = Json::object(), seconds = Json::object();
  for (const auto& [name, tally] : record.judgement.measures) measures[name] = {tally.part, tally.whole};
  for (const auto& [stage, time] : record.seconds) seconds[stage] = std::round(time * 1e4) / 1e4;
  Json line{{"key", record.key()},
            {"scene", record.scene},
            {"method", record.method},
            {"repeat", record.repeat},
            {"outcome", record.outcome},
            {"error", record.error},
            {"failure", record.failure},
            {"structure", record.structure},
            {"requests", record.spent.requests},
            {"tokens", {{"request", record.spent.request_tokens}, {"response", record.spent.response_tokens}}},
            {"cost", record.spent.cost_known ? Json(record.spent.cost) : Json(nullptr)},
            {"objects", record.judgement.room.layout.objects.size()},
            {"everything", record.judgement.everything},
            {"measures", std::move(measures)},
            {"seconds", std::move(seconds)}};
  if (!record.picture.judge.empty()) {
    Json said{{"judge", record.picture.judge}, {"shown", record.picture.shown}};
    if (record.picture.cut_away) said["wallsCutAway"] = json_of(*record.picture.cut_away);
    if (record.picture.walled) said["allWalls"] = json_of(*record.picture.walled);
    line["judged"] = std::move(said);
  }
  return line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void read_line(const nlohmann::json& line, RunRecord& record) {
  record.outcome = line.value("outcome", "");
  record.error = line.value("error", "");
  record.failure = line.value("failure", "");
  record.structure = line.value("structure", "");
  record.spent.requests = line.value("requests", 0);
  if (line.contains("tokens") && line.at("tokens").is_object()) {
    record.spent.request_tokens = line.at("tokens").value("request", std::int64_t{0});
    record.spent.response_tokens = line.at("tokens").value("response", std::int64_t{0});
  }
  const std::optional<double> cost = number_in(line, "cost");
  record.spent.cost = cost.value_or(0);
  record.spent.cost_known = cost.has_value();
  record.seconds = line.value("seconds", std::map<std::string, double>{});
  if (!line.contains("judged") || !line.at("judged").is_object()) return;
  const nlohmann::json& said = line.at("judged");
  record.picture = {said.value("judge", ""), said.value("shown", ""), four_in(said, "wallsCutAway"), four_in(said, "allWalls")};
}

Spent spent_on(const std::string& requests) {
  Spent spent;
  const auto list = parse_json(requests);
  if (!list || !list->is_array()) return spent;
  spent.requests = static_cast<int>(list->size());
  for (const nlohmann::json& request : *list) {
    if (!request.is_object() || !request.contains("tokens")) continue;  // nothing was sent
    spent.request_tokens += request.at("tokens").value("request", std::int64_t{0});
    spent.response_tokens += request.at("tokens").value("response", std::int64_t{0});
    const std::optional<double> cost = number_in(request, "cost");
    spent.cost += cost.value_or(0);
    spent.cost_known = spent.cost_known && cost.has_value();
  }
  return spent;
}

std::string results_csv(const ExperimentOutcome& outcome) {
  std::string text = "scene,method,repeat,outcome,failure,everything,objects,requests,request_tokens,response_tokens,cost,seconds";
  for (const MeasureRow& row : measure_rows()) text += fmt::format(",{}_part,{}_whole", row.name, row.name);
  text += ",single_right,single_answers,multi_right,multi_answers,scene_score,prompt_score,ratings,rating,error\n";
  for (const RunRecord& record : outcome.records) {
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{},{:.4f}", quoted(record.scene), quoted(record.method), record.repeat, record.outcome,
                    quoted(record.failure), record.judgement.everything ? 1 : 0, record.judgement.room.layout.objects.size(),
                    record.spent.requests, record.spent.request_tokens, record.spent.response_tokens,
                    record.spent.cost_known ? fmt::format("{:.6g}", record.spent.cost) : "", record.seconds_in_all());
    for (const MeasureRow& row : measure_rows()) {
      const auto found = record.judgement.measures.find(std::string(row.name));
      const Tally tally = found == record.judgement.measures.end() ? Tally{} : found->second;
      text += fmt::format(",{:.6g},{:.6g}", tally.part, tally.whole);
    }
    text += fmt::format(",{},{},{},{}\n", judgement_columns(record.picture.cut_away), record.ratings.size(), figure(record.rating()),
                        quoted(record.error));
  }
  return text;
}

}  // namespace layoutbox::experiment
