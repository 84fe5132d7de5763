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

namespace layoutbox::cli {

struct QuestionFlags {
  std::string by = "geometry";
  bool questions = false;  // geometry answers them too
  std::string model, base_url, provider;
  std::optional<double> max_cost;
  double timeout_s = 300;
  bool no_cache = false;
  vlm::JudgeOptions options;
  void add_to(CLI::App& command);
  bool wanted() const { return questions || by == "vlm"; }
};

// Asks about each room that could be read and prints the answers, or writes them to `output`; returns the exit status. Rooms without a
// picture are shown by their floor plan.
int answer_questions(const QuestionFlags& flags, const std::vector<Judgement>& rooms, const std::map<std::string, RoomPicture>& pictures,
                     const std::string& output, const Console& console);

}  // namespace layoutbox::cli
