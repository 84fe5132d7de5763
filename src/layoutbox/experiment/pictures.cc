#include "layoutbox/experiment/pictures.h"

#include "layoutbox/base/files.h"
#include "layoutbox/chat/chat_client.h"
#include "layoutbox/export/export.h"
#include "layoutbox/furnish/furnish.h"

namespace layoutbox::experiment {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 560, kHeight = 440;
constexpr const char* kWalled = "scene-walls.png";

FourJudgements summed(const vlm::RoomAnswers& answers) {
  std::vector<vlm::Answered> single, multi;
  for (const vlm::AskedQuestion& asked : answers.questions) {
    for (const vlm::Said& said : asked.said) {
      (asked.question.kind == vlm::QuestionKind::kSingle ? single : multi).push_back({asked.question.truth, said.verdict});
    }
  }
  FourJudgements four{vlm::figures_of(single), vlm::figures_of(multi), std::nullopt, std::nullopt};
  for (const auto& [against, mean] : {std::pair{"scene", &four.scene_score}, std::pair{"prompt", &four.prompt_score}}) {
    double sum = 0;
    int count = 0;
    for (const vlm::Score& score : answers.scores) {
      if (score.against == against && score.value) sum += *score.value, ++count;
    }
    if (count > 0) *mean = sum / count;
  }
  return four;
}

}  // namespace

RenderOptions picture_options(bool all_walls) {
  RenderOptions render;
  render.quality = Quality::kDraft;
  render.width = kWidth, render.height = kHeight;
  render.corner = Corner::kSouthEast;
  render.save_blend = false;
  render.overlay = !all_walls;
  render.thumbnail = !all_walls;
  render.all_walls = all_walls;
  return render;
}

Status Pictures::draw_once(const Layout& layout, const fs::path& folder, bool all_walls) {
  RenderOptions render = picture_options(all_walls);
  render.stop = stop_;
  LAYOUTBOX_ASSIGN(const TemporaryFolder place, TemporaryFolder::make("experiment-picture"));
  LAYOUTBOX_ASSIGN(const Model model, furnish(layout, catalog_));
  LAYOUTBOX_CHECK(write_file(place.path() / "blender.py", write_blender_script(model, layout, catalog_, render)));
  LAYOUTBOX_ASSIGN(const RenderOutputs made, (*blender_)->render(place.path() / "blender.py", place.path(), render));
  for (const fs::path& file : made.files()) {
    LAYOUTBOX_ASSIGN(const std::string bytes, read_file(file, 64u << 20));
    LAYOUTBOX_CHECK(write_file(folder / (all_walls ? fs::path(kWalled) : file.filename()), bytes));
  }
  return {};
}

Status Pictures::draw(const Layout& layout, const fs::path& folder) {
  const std::lock_guard guard(drawing_);
  if (!why_not_.empty()) return {};
  if (!blender_) blender_ = find_blender().map([](Blender found) { return BlenderServer(std::move(found)); });
  if (!*blender_) {
    why_not_ = blender_->error().message;
    return {};
  }
  std::error_code error;
  for (const bool all_walls : {false, true}) {
    if ((all_walls && !options_.all_walls) || fs::exists(folder / (all_walls ? kWalled : "scene.png"), error)) continue;
    const Status made = draw_once(layout, folder, all_walls);
    if (!made && made.error().code == ErrorCode::kInterrupted) return Failure(made.error());
    if (!made && why_not_.empty()) why_not_ = folder.filename().string() + ": " + made.error().message;
  }
  return {};
}

std::string Pictures::why_not() {
  const std::lock_guard guard(drawing_);
  return why_not_;
}

Result<FourJudgements> Pictures::ask(const Layout& layout, const std::string& name, vlm::Picture picture) const {
  chat::ChatClient client(*options_.judge);
  LAYOUTBOX_ASSIGN(const vlm::RoomAnswers answers,
                   vlm::answer_by_model(name, layout, catalog_, {std::move(picture)}, client, options_.asking));
  return summed(answers);
}

Status Pictures::look_at(const Layout& layout, const std::string& name, const fs::path& folder, PictureJudgement& said) {
  if (options_.draw) LAYOUTBOX_CHECK(draw(layout, folder));
  if (options_.judge == nullptr) return {};
  if (said.judge != options_.judge_name) said = {};
  said.judge = options_.judge_name;
  std::error_code error;
  if (!said.cut_away) {
    vlm::Picture picture{"image/png", {}, {}, {}};
    said.shown = fs::exists(folder / "scene.png", error) ? "picture" : "floor plan";
    if (said.shown == "picture") {
      LAYOUTBOX_ASSIGN(picture.bytes, read_file(folder / "scene.png", 64u << 20));
    } else {
      FloorPlanOptions plan;
      plan.dots_per_inch = 120;
      LAYOUTBOX_ASSIGN(picture.bytes, write_floor_plan_png(layout, catalog_, plan));
      picture.view = "its floor plan";
    }
    LAYOUTBOX_ASSIGN(said.cut_away, ask(layout, name, std::move(picture)));
  }
  if (options_.all_walls && !said.walled && fs::exists(folder / kWalled, error)) {
    vlm::Picture picture{"image/png", {}, {}, {}};
    LAYOUTBOX_ASSIGN(picture.bytes, read_file(folder / kWalled, 64u << 20));
    LAYOUTBOX_ASSIGN(said.walled, ask(layout, name, std::move(picture)));
  }
  return {};
}

}  // namespace layoutbox::experiment
