#include "layoutbox/judge/vlm/written.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "layoutbox/judge/vlm/asking.h"
#include "layoutbox/scene/layout_scene.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox::vlm {
namespace {

constexpr std::string_view kWrittenTask =
    "You write questions about a picture of a furnished room for somebody who sees only the picture. "
    "Of each numbered statement you make one question that is answered by yes where all of the statement is so and by no where not. "
    "Some statements are deliberately false: do not mend them, and do not hint at the answer. Name things by words, not by their ids.";

// Lists and texts are bounded, so that a small model cannot run away.
std::string schema_for(std::size_t count) {
  return fmt::format(R"({{"type": "object", "properties": {{"questions": {{"type": "array", "maxItems": {0}, "items": {{
    "type": "object", "properties": {{
      "number": {{"type": "integer", "minimum": 1, "maximum": {0}, "description": "of the statement"}},
      "question": {{"type": "string", "maxLength": 400, "description": "a yes-no question"}}}},
    "required": ["number", "question"], "additionalProperties": false}}}}}},
    "required": ["questions"], "additionalProperties": false}})",
                     count);
}

std::string statement(const RoomQuestion& question) {
  std::string text;
  for (const Hop& hop : question.hops) text += (text.empty() ? "" : ", and ") + hop.sentence;
  return text;
}

}  // namespace

Status write_questions(std::vector<RoomQuestion>& questions, const std::string& scene, chat::ChatClient& client,
                       const JudgeOptions& options) {
  if (questions.empty()) return {};
  std::string text = "The room as it was meant, in JSON:\n" + scene + "\nThe statements:\n";
  for (std::size_t i = 0; i < questions.size(); ++i) text += fmt::format("{}. {}\n", i + 1, statement(questions[i]));
  Asking asking{kWrittenTask, std::move(text), {}, {"write_questions", "The questions", schema_for(questions.size()), true}};
  chat::Request request = request_for(std::move(asking), options);
  request.max_response_tokens = 200 + 100 * static_cast<int>(questions.size());
  LAYOUTBOX_ASSIGN(const chat::Response response, client.ask(request));
  const nlohmann::json document = document_of(response);
  if (!document.is_object() || !document.contains("questions") || !document.at("questions").is_array()) return {};
  for (const nlohmann::json& item : document.at("questions")) {
    const std::string words = member_text(item, "question");
    if (words.empty() || !item.contains("number") || !item.at("number").is_number_unsigned()) continue;
    const std::size_t number = item.at("number").get<std::size_t>();
    if (number < 1 || number > questions.size()) continue;
    questions[number - 1].text = words;
    questions[number - 1].written = true;
  }
  return {};
}

Status write_questions(RoomAnswers& room, const Layout& layout, chat::ChatClient& client, const JudgeOptions& options) {
  std::vector<RoomQuestion> questions;
  for (const AskedQuestion& asked : room.questions) questions.push_back(asked.question);
  LAYOUTBOX_CHECK(write_questions(questions, write_scene(scene_of(layout)), client, options));
  for (std::size_t i = 0; i < questions.size(); ++i) room.questions[i].question = std::move(questions[i]);
  return {};
}

}  // namespace layoutbox::vlm
