#include "layoutbox/pipeline/generate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "layoutbox/base/files.h"
#include "layoutbox/base/words.h"
#include "layoutbox/judge/drawn_room.h"
#include "layoutbox/pipeline/artefacts.h"
#include "layoutbox/pipeline/fitted_room.h"
#include "layoutbox/pipeline/repair.h"
#include "layoutbox/pipeline/run_folder.h"
#include "layoutbox/pipeline/run_pictures.h"
#include "layoutbox/pipeline/run_record.h"
#include "layoutbox/pipeline/run_variants.h"
#include "layoutbox/pipeline/run_words.h"
#include "layoutbox/pipeline/variants.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox {
namespace {

// One run: holds the folder, the clock and what has been made so far.
class RoomRun {
 public:
  RoomRun(std::string_view prompt, const Catalog& catalog, std::filesystem::path folder, const GenerateOptions& options)
      : prompt_(prompt), catalog_(catalog), folder_(std::move(folder)), options_(options) {
    options_.plan.stop = options_.stop;
    options_.solve.stop = options_.stop;
    options_.render.stop = options_.stop;
  }

  // The layout is this one; nothing is solved.
  void use(Layout layout) { given_ = std::move(layout); }

  // Plans (when there is no scene yet), runs all stages, and writes run.json whatever happens after the folder is ours.
  Result<GenerateOutcome> operator()(const Planner* planner, SceneGraph scene) {
    if (planner)
      planning_ = planner->begin(prompt_, options_.plan, {options_.normalize.room_size, options_.shell ? &*options_.shell : nullptr});
    // A text that says nothing touches no folder.
    LAYOUTBOX_CHECK(planning_ ? plan_with_repair() : planner ? plan(*planner) : given_ ? take(std::move(scene)) : adopt(std::move(scene)));
    LAYOUTBOX_CHECK(folder_.open());
    Status status = run_stages();
    while (status && picture_may_be_mended()) status = run_stages_again();
    const Error* failure = status ? nullptr : &status.error();
    const Status recorded = record(failure);
    if (failure) return Failure(*failure);
    if (!recorded) return Failure(recorded.error());
    return std::move(outcome_);
  }

 private:
  using Clock = std::chrono::steady_clock;

  void begin() { started_ = Clock::now(); }

  void finish(std::string stage, std::string summary) {
    outcome_.stages.push_back({std::move(stage), std::chrono::duration<double>(Clock::now() - started_).count(), std::move(summary)});
    if (options_.on_stage) options_.on_stage(outcome_.stages.back());
  }

  Status record(const Error* failure) {
    if (planning_) outcome_.model_requests = planning_->record();
    outcome_.files = folder_.files();
    LAYOUTBOX_CHECK(folder_.write("run.json", write_run_record(prompt_, options_, outcome_, failure)));
    outcome_.files = folder_.files();
    return {};
  }

  RoomSoFar room() const { return {catalog_, outcome_.scene, outcome_.layout, model_, outcome_.report, options_}; }

  Status plan(const Planner& planner) {
    begin();
    LAYOUTBOX_ASSIGN(plan_, planner.plan(prompt_, options_.plan));
    LAYOUTBOX_ASSIGN(outcome_.scene, prepare_plan(*plan_, catalog_, options_));
    finish("plan", scene_in_words(outcome_.scene));
    return {};
  }

  Status plan_with_repair() {
    begin();
    loop_.emplace(*planning_, catalog_, options_);
    auto room = loop_->run();
    if (!room) {
      record_failure(room.error());
      return Failure(room.error());
    }
    take_room(std::move(*room));
    return {};
  }

  void take_room(PlannedRoom room) {
    outcome_.scene = std::move(room.scene);
    given_ = std::move(room.layout);
    finish("plan", scene_in_words(outcome_.scene) + "; " + planning_->cost_in_words());
  }

  // What was asked in vain is worth keeping, but not in the place of an earlier run.
  void record_failure(const Error& error) {
    if (planning_->attempts() == 0 || folder_.holds_a_run()) return;
    if (folder_.open()) (void)record(&error);  // the first error is the one that counts
  }

  // A script or a picture that failed is told the planner while attempts are left; a Blender that is missing is not its fault.
  bool picture_may_be_mended() const {
    return loop_ && outcome_.picture_error && outcome_.picture_error->code == ErrorCode::kRenderFailed && !given_up_on_picture_ &&
           loop_->has_attempts_left();
  }

  Status run_stages_again() {
    begin();
    auto room = loop_->run_again("The scene has a layout, but its picture failed: " + outcome_.picture_error->message);
    if (!room) {
      given_up_on_picture_ = true;
      return room.error().code == ErrorCode::kInterrupted ? Status(Failure(room.error())) : Status{};
    }
    take_room(std::move(*room));
    folder_.forget_files();
    outcome_.picture_error.reset();
    return run_stages();
  }

  Status adopt(SceneGraph scene) {
    begin();
    return normalize(std::move(scene));
  }

  Status take(SceneGraph scene) {
    begin();
    outcome_.scene = std::move(scene);
    finish("plan", scene_in_words(outcome_.scene));
    return {};
  }

  Status normalize(SceneGraph scene) {
    LAYOUTBOX_ASSIGN(outcome_.scene, prepare_scene(std::move(scene), catalog_, options_));
    finish("plan", scene_in_words(outcome_.scene));
    return {};
  }

  Status run_stages() {
    LAYOUTBOX_CHECK(folder_.write_artefacts(Stage::kPlan, room()));
    LAYOUTBOX_CHECK(check_stopped(options_.stop));
    LAYOUTBOX_CHECK(solve_scene());
    LAYOUTBOX_CHECK(check_stopped(options_.stop));
    LAYOUTBOX_CHECK(dress_layouts());
    LAYOUTBOX_CHECK(furnish_layout());
    LAYOUTBOX_CHECK(verify_layout());
    LAYOUTBOX_CHECK(check_stopped(options_.stop));
    LAYOUTBOX_CHECK(make_variants());
    if (!options_.pictures) return {};
    LAYOUTBOX_CHECK(render(0));
    return render_variants();
  }

  Status make_variants() {
    if (outcome_.more_layouts.empty()) return {};
    begin();
    LAYOUTBOX_CHECK(write_variants(folder_, room(), outcome_.more_layouts));
    finish("variants", counted(outcome_.more_layouts.size(), "more layout") + " furnished, exported and verified");
    return {};
  }

  // What the picture of one of them costs is not asked of the others again.
  Status render_variants() {
    for (std::size_t k = 1; k <= outcome_.more_layouts.size() && !outcome_.picture_error; ++k) {
      LAYOUTBOX_CHECK(check_stopped(options_.stop));
      LAYOUTBOX_CHECK(render(k));
    }
    return {};
  }

  // The scene gets what the first layout gets; what dresses the others is in their layouts alone. All are written again.
  Status dress_layouts() {
    if (!plan_ || !comes_with_more(*plan_, options_)) return {};
    begin();
    const SceneGraph undressed = outcome_.scene;
    const auto swings = [&] {
      std::vector<Swing> all;
      for (const Opening& opening : outcome_.layout.room.openings) all.push_back(opening.swing);
      return all;
    };
    const std::vector<Swing> before = swings();
    const std::size_t added = dress_room(*plan_, outcome_.scene, outcome_.layout, catalog_, options_);
    for (Layout& layout : outcome_.more_layouts) {
      SceneGraph scene = undressed;
      dress_room(*plan_, scene, layout, catalog_, options_);
    }
    if (added == 0 && before == swings() && outcome_.more_layouts.empty()) return {};
    folder_.forget_files();
    LAYOUTBOX_CHECK(folder_.write_artefacts(Stage::kPlan, room()));
    LAYOUTBOX_CHECK(write_variant_layouts(folder_, room(), outcome_.more_layouts));
    LAYOUTBOX_CHECK(folder_.write_artefacts(Stage::kSolve, room()));
    finish("dress", counted(added, "thing") + " where it was free");
    return {};
  }

  Status solve_scene() {
    begin();
    std::string others;
    if (given_) {
      outcome_.layout = *std::exchange(given_, std::nullopt);
    } else {
      LAYOUTBOX_ASSIGN(FittedRoom fitted, solve_where_it_fits(outcome_.scene, plan_ ? &*plan_ : nullptr, catalog_, options_, started_));
      if (fitted.larger) {
        outcome_.scene = std::move(*fitted.larger);
        LAYOUTBOX_CHECK(folder_.write_artefacts(Stage::kPlan, room()));
      }
      std::vector<Layout>& layouts = fitted.layouts;
      for (std::size_t k = 1; k < layouts.size(); ++k) others += fmt::format("; variant {}: {}", k + 1, variant_in_words(layouts, k));
      outcome_.layout = std::move(layouts[0]);
      outcome_.more_layouts.assign(std::make_move_iterator(layouts.begin() + 1), std::make_move_iterator(layouts.end()));
      LAYOUTBOX_CHECK(write_variant_layouts(folder_, room(), outcome_.more_layouts));
    }
    const Layout& layout = outcome_.layout;
    if (loop_) started_ = Clock::now() - std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(layout.stats.seconds));
    LAYOUTBOX_CHECK(folder_.write_artefacts(Stage::kSolve, room()));
    finish("solve", solved_in_words(layout) + others);
    return {};
  }

  Status furnish_layout() {
    begin();
    LAYOUTBOX_ASSIGN(model_, furnish(outcome_.layout, catalog_, options_.furnish));
    finish("furnish", counted(model_.nodes.size(), "piece"));
    begin();
    LAYOUTBOX_ASSIGN(std::string names, folder_.write_artefacts(Stage::kExport, room()));
    finish("export", std::move(names));
    return {};
  }

  Status verify_layout() {
    begin();
    outcome_.report = verify_with_furniture(outcome_.layout, model_, catalog_, options_.verify);
    LAYOUTBOX_CHECK(folder_.write_artefacts(Stage::kVerify, room()));
    finish("verify", verified_in_words(outcome_.report));
    return {};
  }

  // A missing or failing Blender costs the picture only: the error is kept beside the outcome.
  Status render(std::size_t variant) {
    begin();
    auto drawn = draw_pictures(folder_, variant, options_);
    if (!drawn) return keep_picture_error(drawn.error());
    if (variant == 0) {
      outcome_.blender_version = drawn->blender_version;
      LAYOUTBOX_CHECK(verify_picture());
    }
    finish("render", std::move(drawn->summary));
    return {};
  }

  // What the picture hides, where there is a mask that tells it: the report has it too.
  Status verify_picture() {
    if (!options_.render.object_mask) return {};
    LAYOUTBOX_ASSIGN(const std::string mask, read_file(folder_.path() / "mask.json"));
    LAYOUTBOX_CHECK(verify_seen(outcome_.layout, mask, outcome_.report));
    return write_file(folder_.path() / "report.json", write_report(outcome_.report));
  }

  Status keep_picture_error(const Error& error) {
    if (error.code == ErrorCode::kInterrupted) return Failure(error);
    outcome_.picture_error = error;
    finish("render", "no picture: " + error.message);
    return {};
  }

  std::string prompt_;
  const Catalog& catalog_;
  RunFolder folder_;
  GenerateOptions options_;
  Clock::time_point started_;
  GenerateOutcome outcome_;
  std::optional<Layout> given_;
  Model model_;
  std::optional<Plan> plan_;            // where a text was planned without a model
  std::unique_ptr<Planning> planning_;  // where the planner can be told what is wrong
  std::optional<RepairLoop> loop_;
  bool given_up_on_picture_ = false;
};

}  // namespace

Result<GenerateOutcome> generate(std::string_view prompt, const Planner& planner, const Catalog& catalog,
                                 const std::filesystem::path& folder, const GenerateOptions& options) {
  return RoomRun(prompt, catalog, folder, options)(&planner, {});
}

Result<GenerateOutcome> generate_from_scene(SceneGraph scene, const Catalog& catalog, const std::filesystem::path& folder,
                                            const GenerateOptions& options) {
  const std::string prompt = scene.prompt;
  return RoomRun(prompt, catalog, folder, options)(nullptr, std::move(scene));
}

Result<GenerateOutcome> generate_from_layout(SceneGraph scene, Layout layout, const Catalog& catalog, const std::filesystem::path& folder,
                                             const GenerateOptions& options) {
  const std::string prompt = scene.prompt;
  RoomRun run(prompt, catalog, folder, options);
  run.use(std::move(layout));
  return run(nullptr, std::move(scene));
}

}  // namespace layoutbox
