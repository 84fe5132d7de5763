// A vision model's judgement of rooms, as in the paper: a score, and answers to questions of which geometry knows the truth.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/chat/chat_client.h"
#include "layoutbox/judge/vlm/figures.h"
#include "layoutbox/judge/vlm/questions.h"

namespace layoutbox::vlm {

struct Said {
  YesNo verdict = YesNo::kNeither;
  std::string text, reason;  // as it was said; why, where reasons were asked for
  int repeat = 1;
};

struct AskedQuestion {
  RoomQuestion question;
  std::vector<Said> said;  // one for each repeat
};

struct Score {
  std::string against;  // "scene" (its JSON is shown beside the picture) or "prompt"
  std::optional<double> value;
  std::string reason;
  int repeat = 1;
};

struct RoomAnswers {
  std::string name;
  std::vector<AskedQuestion> questions;
  std::vector<Score> scores;
};

struct Picture {
  std::string media_type, bytes;
  std::string url = {};   // where the model can fetch it; empty: it is sent along
  std::string view = {};  // what it is, in words: "its floor plan"; may be empty
};

// Who is asked. `ask` sees the question's text alone beside the picture.
struct JudgeOptions {
  QuestionOptions questions;
  int repeats = 1;                        // the repeat's number is the request's seed, and so part of what answers are kept by
  std::optional<double> temperature = 0;  // empty: the model's own
  bool reasons = false;
  bool written = false;     // the model writes the questions' words first, from the scene's JSON
  bool with_scene = false;  // questions too are asked with the scene's JSON beside the picture
};

// By geometry: every question is answered by its truth, nothing is asked of anybody.
RoomAnswers answer_by_geometry(const std::string& name, const Layout& layout, const Catalog& catalog, const JudgeOptions& options);
// By a model, which sees all the pictures at once. REQUIRES: one at least. Errors: those of ChatClient::ask.
Result<RoomAnswers> answer_by_model(const std::string& name, const Layout& layout, const Catalog& catalog,
                                    const std::vector<Picture>& pictures, chat::ChatClient& client, const JudgeOptions& options);

// measure_in_blend() of what was asked.
void measure_in_blend(RoomAnswers& room, const Layout& layout, const Layout& read_back, const Catalog& catalog);

struct PanelFigures {
  AnswerFigures all, single, multi;
  std::optional<Estimate> unsteady;         // questions whose repeats do not agree
  std::optional<double> mean_score;         // of those against the scene
  std::optional<double> score_and_answers;  // correlation, over rooms, of the score with the share of right answers
};
PanelFigures figures_of_rooms(const std::vector<RoomAnswers>& rooms);

std::string answers_text(const std::vector<RoomAnswers>& rooms, bool reasons);
// layoutbox/answers@1; `judge` says who answered.
std::string answers_json(const std::vector<RoomAnswers>& rooms, const std::string& judge, const JudgeOptions& options);

}  // namespace layoutbox::vlm
