// Questions about rooms, to a vision model or to geometry: the second half of `judge`.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "layoutbox/cli/console.h"
#include "layoutbox/judge/judge.h"
#include "layoutbox/judge/report_html.h"
#include "layoutbox/judge/vlm/vlm_judge.h"
#include "layoutbox/pipeline/generate.h"

namespace layoutbox::cli {

void add_publish_to(CLI::App& command, std::string& publish, const char* group);

// What rooms are asked about, of `judge` and `verify`; parts of it of `generate` and `experiment`.
struct QuestionFlags {
  std::string by = "geometry";
  bool questions = false;          // geometry answers them too
  bool pairwise = false;           // each two rooms are compared
  bool faults = false;             // each room is compared with itself with a fault planted
  std::vector<std::string> views;  // what the model is shown: "plan", or a view of render.h; empty: the room's picture, else its plan
  std::string model, base_url, provider;
  std::string blend;           // of the only room: each relation of a question is measured in it too
  bool blend_is_ours = false;  // it was written in this run, and may be opened without a sandbox where there is none
  std::string publish;         // by whom pictures reach the model: a name of make_publisher(); empty: they are sent along
  std::optional<double> max_cost;
  double timeout_s = 300;
  bool no_cache = false;
  vlm::JudgeOptions options;
  // `many_rooms`: they can be compared with one another.
  void add_to(CLI::App& command, bool many_rooms);
  // Of these what is asked of a room: how many questions, which, in whose words.
  void add_asking_to(CLI::App& command);
  // Errors: those of find_endpoint(), of the prices.
  Result<chat::ChatOptions> chat_options(const Console& console) const;
  bool shows_pictures() const { return by == "vlm" || pairwise || faults; }
  bool wanted() const { return questions || shows_pictures(); }
};

// Asks about each room that could be read and prints the answers, or writes them to `output`; returns the exit status. Rooms without a
// picture are shown by their floor plan.
int answer_questions(const QuestionFlags& flags, const std::vector<Judgement>& rooms, const std::map<std::string, RoomPicture>& pictures,
                     const std::string& output, const Console& console);

// The last stage of the paper, after `generate` has made the room in `folder`: a vision model judges its picture; the answers go into
// answers.json there, their sum is told. Errors: kNoBlender (no picture was made), those of asking and publishing.
Status judge_generated(const QuestionFlags& flags, const GenerateOutcome& outcome, const std::string& folder, const Console& console);

}  // namespace layoutbox::cli
