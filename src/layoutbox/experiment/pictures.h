// Pictures of an experiment's rooms, and what a vision model says of them.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "layoutbox/judge/vlm/vlm_judge.h"
#include "layoutbox/render/render.h"

namespace layoutbox::experiment {

// The paper's four judgements of one picture: questions over one relation and over several, scores against the scene and the prompt.
struct FourJudgements {
  vlm::AnswerFigures single, multi;  // counts alone
  std::optional<double> scene_score, prompt_score;
};

struct PictureJudgement {
  std::string judge, shown;                        // who said it, of what: "picture" or "floor plan"; empty: nobody
  std::optional<FourJudgements> cut_away, walled;  // of the usual picture, and of the one that all walls stand in
};

struct PictureOptions {
  bool draw = false;                         // by Blender: the picture and the one with what does not hold drawn over it
  bool all_walls = false;                    // also one in which no wall is cut away, as in the paper
  const chat::ChatOptions* judge = nullptr;  // a vision model; null: none is asked
  std::string judge_name;
  vlm::JudgeOptions asking;
};

// How every room of an experiment is drawn: small, and from the paper's fixed azimuth of 45°, so that no method's rooms are shown better.
RenderOptions picture_options(bool all_walls);

// Draws one picture at a time, by one Blender for all rooms.
class Pictures {
 public:
  Pictures(const PictureOptions& options, const Catalog& catalog, const std::atomic<bool>* stop)
      : options_(options), catalog_(catalog), stop_(stop) {}

  // Draws what is wished and not there yet into `folder`, and asks what has not been said yet of `said`. A Blender that is missing or fails
  // costs the pictures: `why_not()` says so, and a floor plan is shown. Errors: those of ChatClient::ask, kInterrupted, kIo.
  Status look_at(const Layout& layout, const std::string& name, const std::filesystem::path& folder, PictureJudgement& said);
  std::string why_not();

 private:
  Status draw(const Layout& layout, const std::filesystem::path& folder);
  Status draw_once(const Layout& layout, const std::filesystem::path& folder, bool all_walls);
  Result<FourJudgements> ask(const Layout& layout, const std::string& name, vlm::Picture picture) const;

  const PictureOptions& options_;
  const Catalog& catalog_;
  const std::atomic<bool>* stop_;
  std::mutex drawing_;
  std::optional<Result<BlenderServer>> blender_;  // from the first picture on
  std::string why_not_;
};

}  // namespace layoutbox::experiment
