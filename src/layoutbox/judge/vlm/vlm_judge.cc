#include "layoutbox/judge/vlm/vlm_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "layoutbox/judge/vlm/asking.h"
#include "layoutbox/judge/vlm/written.h"
#include "layoutbox/scene/layout_scene.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox::vlm {
namespace {

constexpr std::string_view kAnswerSchema = R"({"type": "object", "properties": {
  "answer": {"type": "string", "enum": ["yes", "no", "unsure"], "description": "what the picture shows"},
  "reason": {"type": "string", "maxLength": 400, "description": "one sentence, or empty"}},
  "required": ["answer", "reason"], "additionalProperties": false})";
constexpr std::string_view kScoreSchema = R"({"type": "object", "properties": {
  "score": {"type": "number", "minimum": 0, "maximum": 1, "description": "0.0: nothing is as described, 1.0: everything is"},
  "reason": {"type": "string", "maxLength": 400, "description": "one sentence, or empty"}},
  "required": ["score", "reason"], "additionalProperties": false})";
constexpr std::string_view kTask =
    "You judge a picture of a furnished room. Many statements that you are asked about are deliberately false; say what the picture shows.";

chat::Request request_for_room(const std::vector<Picture>& pictures, const std::string& text, bool score, int repeat,
                               const JudgeOptions& options) {
  const std::string shown = pictures.size() > 1 ? "The pictures show one room: " + views_of(pictures) + ".\n" : "";
  Asking asking{kTask, shown + text, {}, {}, static_cast<std::uint64_t>(repeat)};
  for (const Picture& picture : pictures) asking.pictures.push_back(&picture);
  asking.function = score ? chat::Function{"score", "The score of the picture", std::string(kScoreSchema), true}
                          : chat::Function{"answer", "The answer to the question", std::string(kAnswerSchema), true};
  return request_for(std::move(asking), options);
}

// A word of its own: "Yes.", "no, it is not". Anything else is neither.
YesNo verdict_in(std::string_view text) {
  std::string word;
  for (const char c : text) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (!letter && !word.empty()) break;
    if (letter) word += static_cast<char>(c | 0x20);
  }
  return word == "yes" ? YesNo::kYes : word == "no" ? YesNo::kNo : YesNo::kNeither;
}

std::string_view word_for(YesNo verdict) { return verdict == YesNo::kYes ? "yes" : verdict == YesNo::kNo ? "no" : "neither"; }

std::string scene_text(const Layout& layout) { return write_scene(scene_of(layout)); }

Result<Said> ask_once(const std::string& text, int repeat, const std::vector<Picture>& pictures, chat::ChatClient& client,
                      const JudgeOptions& options) {
  LAYOUTBOX_ASSIGN(const chat::Response response, client.ask(request_for_room(pictures, text, false, repeat, options)));
  const nlohmann::json document = document_of(response);
  Said said;
  said.repeat = repeat;
  said.text = member_text(document, "answer");
  if (said.text.empty()) said.text = response.content;
  said.verdict = verdict_in(said.text);
  if (options.reasons) said.reason = member_text(document, "reason");
  return said;
}

Result<Score> score_once(const std::string& against, const std::string& text, int repeat, const std::vector<Picture>& pictures,
                         chat::ChatClient& client, const JudgeOptions& options) {
  LAYOUTBOX_ASSIGN(const chat::Response response, client.ask(request_for_room(pictures, text, true, repeat, options)));
  const nlohmann::json document = document_of(response);
  Score score{against, std::nullopt, options.reasons ? member_text(document, "reason") : std::string(), repeat};
  if (document.is_object() && document.contains("score") && document.at("score").is_number()) {
    const double value = document.at("score").get<double>();
    if (std::isfinite(value) && value >= 0 && value <= 1) score.value = value;
  }
  return score;
}

double share_right(const RoomAnswers& room) {
  int right = 0, all = 0;
  for (const AskedQuestion& asked : room.questions) {
    for (const Said& said : asked.said) {
      ++all;
      right += said.verdict == (asked.question.truth ? YesNo::kYes : YesNo::kNo);
    }
  }
  return all == 0 ? 0 : right / static_cast<double>(all);
}

std::optional<double> scene_score(const RoomAnswers& room) {
  double sum = 0;
  int count = 0;
  for (const Score& score : room.scores) {
    if (score.against != "scene" || !score.value) continue;
    sum += *score.value;
    ++count;
  }
  return count == 0 ? std::nullopt : std::optional(sum / count);
}

using Json = nlohmann::ordered_json;

Json estimate_json(const std::optional<Estimate>& estimate) {
  const auto rounded = [](double value) { return std::round(value * 1e6) / 1e6; };
  if (!estimate) return nullptr;
  return {{"value", rounded(estimate->value)}, {"low", rounded(estimate->low)}, {"high", rounded(estimate->high)}};
}

Json figures_json(const AnswerFigures& f) {
  return {{"answers", f.answers},
          {"neither", f.neither},
          {"trueYes", f.true_yes},
          {"falseYes", f.false_yes},
          {"trueNo", f.true_no},
          {"falseNo", f.false_no},
          {"accuracy", estimate_json(f.accuracy)},
          {"precision", estimate_json(f.precision)},
          {"recall", estimate_json(f.recall)},
          {"kappa", estimate_json(f.kappa)},
          {"neitherRate", estimate_json(f.neither_rate)}};
}

Json question_json(const AskedQuestion& asked, const JudgeOptions& options, bool by_model) {
  Json hops = Json::array(), said = Json::array();
  for (const Hop& hop : asked.question.hops) {
    Json item{{"sentence", hop.sentence}, {"holds", hop.holds}, {"why", hop.why}};
    if (hop.in_blend) item["inBlend"] = {{"holds", *hop.in_blend}, {"why", hop.why_in_blend}};
    hops.push_back(std::move(item));
  }
  for (const Said& one : asked.said) {
    Json item{{"repeat", one.repeat}, {"verdict", word_for(one.verdict)}, {"text", one.text}};
    if (!one.reason.empty()) item["reason"] = one.reason;
    said.push_back(std::move(item));
  }
  return {{"id", asked.question.id},
          {"kind", name_of(asked.question.kind)},
          {"question", asked.question.text},
          {"writtenBy", asked.question.written ? "model" : "program"},
          {"saw", !by_model            ? "layout"
                  : options.with_scene ? "picture and scene"
                                       : "picture"},
          {"truth", asked.question.truth},
          {"hops", std::move(hops)},
          {"answers", std::move(said)}};
}

std::string estimate_text(const std::optional<Estimate>& estimate) {
  return estimate ? fmt::format("{:6.3f}  [{:.3f}, {:.3f}]", estimate->value, estimate->low, estimate->high) : "   n/a";
}

std::string figures_text(std::string_view about, const AnswerFigures& f) {
  return fmt::format(
      "{:8} {} answers: yes to {} that are so and {} that are not, no to {} that are so and {} that are not, neither {}\n"
      "  accuracy  {}\n  precision {}\n  recall    {}\n  kappa     {}\n",
      about, f.answers, f.true_yes, f.false_yes, f.false_no, f.true_no, f.neither, estimate_text(f.accuracy), estimate_text(f.precision),
      estimate_text(f.recall), estimate_text(f.kappa));
}

}  // namespace

RoomAnswers answer_by_geometry(const std::string& name, const Layout& layout, const Catalog& catalog, const JudgeOptions& options) {
  RoomAnswers room;
  room.name = name;
  for (RoomQuestion& question : draw_questions(layout, catalog, options.questions)) {
    const YesNo verdict = question.truth ? YesNo::kYes : YesNo::kNo;
    room.questions.push_back({std::move(question), {{verdict, std::string(word_for(verdict)), {}, 1}}});
  }
  return room;
}

Result<RoomAnswers> answer_by_model(const std::string& name, const Layout& layout, const Catalog& catalog,
                                    const std::vector<Picture>& pictures, chat::ChatClient& client, const JudgeOptions& options) {
  RoomAnswers room;
  room.name = name;
  const std::string scene = scene_text(layout);
  std::vector<RoomQuestion> questions = draw_questions(layout, catalog, options.questions);
  if (options.written) LAYOUTBOX_CHECK(write_questions(questions, scene, client, options));
  for (RoomQuestion& question : questions) {
    AskedQuestion asked{std::move(question), {}};
    std::string text = asked.question.text + " Answer yes or no.";
    if (options.with_scene) text = "The room as it was meant, in JSON:\n" + scene + "\n" + text;
    for (int repeat = 1; repeat <= options.repeats; ++repeat) {
      LAYOUTBOX_ASSIGN(Said said, ask_once(text, repeat, pictures, client, options));
      asked.said.push_back(std::move(said));
    }
    room.questions.push_back(std::move(asked));
  }
  std::map<std::string, std::string> wanted{
      {"scene", "How well does the picture show this room, from 0.0 to 1.0? The room in JSON:\n" + scene}};
  if (!layout.prompt.empty())
    wanted["prompt"] = "How well does the picture show what was asked for, from 0.0 to 1.0? It was:\n" + layout.prompt;
  for (const auto& [against, text] : wanted) {
    for (int repeat = 1; repeat <= options.repeats; ++repeat) {
      LAYOUTBOX_ASSIGN(Score score, score_once(against, text, repeat, pictures, client, options));
      room.scores.push_back(std::move(score));
    }
  }
  return room;
}

void measure_in_blend(RoomAnswers& room, const Layout& layout, const Layout& read_back, const Catalog& catalog) {
  std::vector<RoomQuestion> questions;
  for (const AskedQuestion& asked : room.questions) questions.push_back(asked.question);
  measure_in_blend(questions, layout, read_back, catalog);
  for (std::size_t i = 0; i < questions.size(); ++i) room.questions[i].question = std::move(questions[i]);
}

PanelFigures figures_of_rooms(const std::vector<RoomAnswers>& rooms) {
  std::vector<Answered> all, single, multi;
  std::vector<double> scores, right;
  int unsteady = 0, questions = 0;
  double sum = 0;
  for (const RoomAnswers& room : rooms) {
    for (const AskedQuestion& asked : room.questions) {
      for (const Said& said : asked.said) {
        all.push_back({asked.question.truth, said.verdict});
        (asked.question.kind == QuestionKind::kSingle ? single : multi).push_back(all.back());
      }
      if (asked.said.size() < 2) continue;
      ++questions;
      unsteady +=
          std::any_of(asked.said.begin(), asked.said.end(), [&](const Said& said) { return said.verdict != asked.said[0].verdict; });
    }
    if (const std::optional<double> score = scene_score(room)) {
      scores.push_back(*score);
      right.push_back(share_right(room));
      sum += *score;
    }
  }
  PanelFigures figures{figures_of(all), figures_of(single),        figures_of(multi), share_of(unsteady, questions),
                       std::nullopt,    correlation(scores, right)};
  if (!scores.empty()) figures.mean_score = sum / static_cast<double>(scores.size());
  return figures;
}

std::string answers_text(const std::vector<RoomAnswers>& rooms, bool reasons) {
  std::string text;
  for (const RoomAnswers& room : rooms) {
    if (!reasons) break;
    text += fmt::format("# {}\n", room.name);
    for (const AskedQuestion& asked : room.questions) {
      for (const Said& said : asked.said) {
        text += fmt::format("  {:9} {} ({}): {}{}{}\n", asked.question.id, asked.question.text, asked.question.truth ? "so" : "not so",
                            word_for(said.verdict), said.reason.empty() ? "" : ", ", said.reason);
      }
    }
    for (const Score& score : room.scores) {
      text += fmt::format("  score against the {}: {} {}\n", score.against, score.value ? fmt::format("{:.2f}", *score.value) : "none",
                          score.reason);
    }
  }
  const PanelFigures figures = figures_of_rooms(rooms);
  text += figures_text("all", figures.all) + figures_text("single", figures.single) + figures_text("multi", figures.multi);
  text += fmt::format("answers that are neither yes nor no {}\n", estimate_text(figures.all.neither_rate));
  int in_blend = 0, alike = 0;
  for (const RoomAnswers& room : rooms) {
    for (const AskedQuestion& asked : room.questions) {
      for (const Hop& hop : asked.question.hops) in_blend += hop.in_blend.has_value(), alike += hop.in_blend == hop.holds;
    }
  }
  if (in_blend > 0) text += fmt::format("relations that the .blend has alike  {} of {}\n", alike, in_blend);
  if (figures.unsteady) text += fmt::format("questions whose repeats differ       {}\n", estimate_text(figures.unsteady));
  if (figures.mean_score) text += fmt::format("score against the scene, mean        {:6.3f}\n", *figures.mean_score);
  if (figures.score_and_answers) text += fmt::format("score and right answers, correlation {:6.3f}\n", *figures.score_and_answers);
  text.pop_back();
  return text;
}

std::string answers_json(const std::vector<RoomAnswers>& rooms, const std::string& judge, const JudgeOptions& options) {
  const bool by_model = judge != "geometry";
  Json list = Json::array();
  for (const RoomAnswers& room : rooms) {
    Json questions = Json::array(), scores = Json::array();
    for (const AskedQuestion& asked : room.questions) questions.push_back(question_json(asked, options, by_model));
    for (const Score& score : room.scores) {
      Json item{{"against", score.against}, {"repeat", score.repeat}, {"score", score.value ? Json(*score.value) : Json(nullptr)}};
      if (!score.reason.empty()) item["reason"] = score.reason;
      scores.push_back(std::move(item));
    }
    list.push_back({{"name", room.name}, {"questions", std::move(questions)}, {"scores", std::move(scores)}});
  }
  const PanelFigures figures = figures_of_rooms(rooms);
  const auto or_null = [](const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); };
  const Json document{{"format", "layoutbox/answers@1"},
                      {"judge", judge},
                      {"repeats", options.repeats},
                      {"temperature", or_null(options.temperature)},
                      {"figures",
                       {{"all", figures_json(figures.all)},
                        {"single", figures_json(figures.single)},
                        {"multi", figures_json(figures.multi)},
                        {"unsteady", estimate_json(figures.unsteady)},
                        {"meanScore", or_null(figures.mean_score)},
                        {"scoreAndAnswers", or_null(figures.score_and_answers)}}},
                      {"rooms", std::move(list)}};
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace layoutbox::vlm
