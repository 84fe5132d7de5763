#include "layoutbox/experiment/methods.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "layoutbox/base/bytes.h"
#include "layoutbox/base/files.h"
#include "layoutbox/base/random.h"
#include "layoutbox/experiment/script_methods.h"
#include "layoutbox/judge/room_file.h"
#include "layoutbox/plan/llm/conversation.h"
#include "layoutbox/plan/planner.h"
#include "layoutbox/scene/json_text.h"
#include "layoutbox/scene/layout_scene.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/solve/solver.h"
#include "layoutbox/verify/verify.h"

namespace layoutbox::experiment {
namespace {

class StageTimer {
 public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

struct Planned {
  SceneGraph scene;  // normalised
  double seconds = 0;
};

Result<Planned> plan_offline(const MethodInput& input, const Catalog& catalog) {
  const StageTimer clock;
  const auto planner = make_offline_planner(catalog);
  LAYOUTBOX_ASSIGN(const Plan plan, planner->plan(input.prompt, input.options.plan));
  LAYOUTBOX_ASSIGN(SceneGraph scene, prepare_plan(plan, catalog, input.options));
  return Planned{std::move(scene), clock.seconds()};
}

// Runs the offline planner and the solver, with options of the method's own.
Result<MethodResult> plan_and_solve(MethodInput input, const Catalog& catalog) {
  LAYOUTBOX_ASSIGN(const Planned planned, plan_offline(input, catalog));
  input.options.solve.seed = input.seed;
  const StageTimer clock;
  LAYOUTBOX_ASSIGN(Layout layout, solve(planned.scene, catalog, input.options.solve));
  MethodResult result{
      std::move(layout), {}, content_key(write_scene(planned.scene)), {{"plan", planned.seconds}, {"solve", clock.seconds()}}, {}};
  result.outcome = name_of(result.layout.status);
  return result;
}

Result<MethodResult> pipeline(const MethodInput& input, const Catalog& catalog) { return plan_and_solve(input, catalog); }

Result<MethodResult> without_improving(const MethodInput& input, const Catalog& catalog) {
  MethodInput changed = input;
  changed.options.solve.improve = false;
  return plan_and_solve(std::move(changed), catalog);
}

Result<MethodResult> without_proofs(const MethodInput& input, const Catalog& catalog) {
  MethodInput changed = input;
  changed.options.solve.prove = false;
  return plan_and_solve(std::move(changed), catalog);
}

Result<MethodResult> without_companions(const MethodInput& input, const Catalog& catalog) {
  MethodInput changed = input;
  changed.options.companions = false;
  return plan_and_solve(std::move(changed), catalog);
}

// Everything that was planned, in sizes that are usual, anywhere on the floor and turned by quarters: what chance alone gives.
Result<MethodResult> at_random(const MethodInput& input, const Catalog& catalog) {
  LAYOUTBOX_ASSIGN(const Planned planned, plan_offline(input, catalog));
  SceneGraph scene = planned.scene;
  Random random(input.seed);
  const auto between = [&](double low, double high) { return low + (high - low) * random.fraction(); };
  Mm right = 0, back = 0;
  for (const Point& corner : scene.room.polygon) right = std::max(right, corner.x), back = std::max(back, corner.y);
  for (SceneObject& object : scene.objects) {
    const double turn = static_cast<double>(random.below(4)) * 90;
    const Size size = object.size ? object.size->usual : Size{500, 500, 500};
    const bool across = turn == 90 || turn == 270;
    const double w = (across ? size.depth : size.width) / 2.0, d = (across ? size.width : size.depth) / 2.0;
    object.hint.position = {between(std::min(w, right / 2.0), std::max(right - w, right / 2.0)),
                            between(std::min(d, back / 2.0), std::max(back - d, back / 2.0)), 0};
    if (object.mount == Mount::kCeiling) (*object.hint.position)[2] = scene.room.height - size.height;
    object.hint.rotation_deg = turn;
    object.hint.z_may_be_centre = false;
  }
  LAYOUTBOX_ASSIGN(RoomFile room, read_room_file(write_scene(scene), catalog, {"scene", {}}));
  MethodResult result{std::move(room.layout), "placed", content_key(write_scene(planned.scene)), {{"plan", planned.seconds}}, {}};
  return result;
}

Failure no_model() {
  return fail(ErrorCode::kNetwork, "this method asks a model, and none is at hand", {},
              "set OPENAI_API_KEY, or OPENAI_BASE_URL for a server at home");
}

// A run that came to no room, with what was asked of the model all the same, as its record has it.
Result<MethodResult> without_room(const Error& error, const std::filesystem::path& folder, double seconds) {
  const auto record = read_file(folder / "run.json");
  const auto document = record ? parse_json(*record) : Result<nlohmann::json>(Failure(record.error()));
  if (error.code == ErrorCode::kInterrupted || !document || !document->contains("modelRequests")) return Failure(error);
  MethodResult result;
  result.seconds = {{"plan", seconds}};
  result.requests = document->at("modelRequests").dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  result.failure = "no scene", result.error = error.message;
  return result;
}

Result<MethodResult> by_model(const MethodInput& input, const Catalog& catalog, const std::function<void(GenerateOptions&)>& change) {
  if (input.model == nullptr) return no_model();
  GenerateOptions options = input.options;
  options.pictures = false;
  options.solve.seed = input.seed;
  options.plan.seed = input.seed;
  change(options);
  LAYOUTBOX_ASSIGN(const TemporaryFolder folder, TemporaryFolder::make("experiment"));
  const StageTimer clock;
  auto outcome = generate(input.prompt, *input.model, catalog, folder.path(), options);
  if (!outcome) return without_room(outcome.error(), folder.path(), clock.seconds());
  MethodResult result{std::move(outcome->layout), {}, content_key(write_scene(outcome->scene)), {}, std::move(outcome->model_requests)};
  result.outcome = name_of(result.layout.status);
  for (const StageTime& stage : outcome->stages) result.seconds[stage.stage] += stage.seconds;
  return result;
}

Result<MethodResult> model_pipeline(const MethodInput& input, const Catalog& catalog) {
  return by_model(input, catalog, [](GenerateOptions&) {});
}
Result<MethodResult> model_as_paper(const MethodInput& input, const Catalog& catalog) {
  return by_model(input, catalog, [](GenerateOptions& options) {
    options.repair.paper_retries = true;
    options.solve.on_conflict = OnConflict::kOriginal;
  });
}
Result<MethodResult> model_without_repair(const MethodInput& input, const Catalog& catalog) {
  return by_model(input, catalog, [](GenerateOptions& options) {
    options.repair.max_attempts = 1;
    options.repair.repair_attempts = 0;
  });
}

// What is impossible in a room or not as its scene says, for the model; empty where nothing is.
std::string faults_of(const Layout& layout, const Catalog& catalog) {
  std::string text;
  for (const Check& check : verify(layout, catalog).checks) {
    if (!check.passed && check.required) text += "- " + check.message + "\n";
  }
  return text.empty() ? text : "Move, turn and resize what is at the wrong place. With your numbers the room is not possible:\n" + text;
}

// The model's own numbers, as they are; up to `most` answers, each after the first with what is wrong with the numbers before.
Result<MethodResult> by_numbers(const MethodInput& input, const Catalog& catalog, int most) {
  if (input.model == nullptr) return no_model();
  PlanOptions options = input.options.plan;
  options.seed = input.seed;
  const StageTimer clock;
  const std::unique_ptr<Planning> planning = input.model->begin(input.prompt, options, {});
  if (planning == nullptr) return no_model();
  std::optional<MethodResult> last;
  LAYOUTBOX_ASSIGN(Proposal proposal, planning->propose());
  for (std::string faults;;) {
    if (proposal.scene) {
      const std::string scene = write_scene(*proposal.scene);
      LAYOUTBOX_ASSIGN(RoomFile room, read_room_file(scene, catalog, {"scene", {}}));
      faults = faults_of(room.layout, catalog);
      last = MethodResult{std::move(room.layout), "placed", content_key(scene), {}, {}};
      planning->note({faults.empty() ? "possible" : "impossible", {}, {}});
    }
    const bool again = proposal.scene ? planning->attempts() < most && !faults.empty() && !proposal.repeated
                                      : planning->attempts() < input.options.repair.max_attempts;
    if (!again) break;
    const Feedback wrong = proposal.scene ? Feedback{Feedback::Kind::kFailure, faults, {}, {}, 0}
                                          : Feedback{Feedback::Kind::kFaults, {}, proposal.faults, {}, 0};
    LAYOUTBOX_ASSIGN(proposal, planning->revise(wrong));
  }
  if (!last) {
    const std::optional<Proposal> rest = planning->salvage();
    if (!rest || !rest->scene) return Failure(planning->no_usable_scene());
    const std::string scene = write_scene(*rest->scene);
    LAYOUTBOX_ASSIGN(RoomFile room, read_room_file(scene, catalog, {"scene", {}}));
    last = MethodResult{std::move(room.layout), "placed", content_key(scene), {}, {}};
  }
  last->seconds = {{"plan", clock.seconds()}};
  last->requests = planning->record();
  return *std::move(last);
}

Result<MethodResult> model_positions(const MethodInput& input, const Catalog& catalog) { return by_numbers(input, catalog, 1); }

Result<MethodResult> model_positions_again(const MethodInput& input, const Catalog& catalog) {
  return by_numbers(input, catalog, input.options.repair.max_attempts);
}

// The model plans as ever, but is asked in plain JSON instead of by function calling.
Result<MethodResult> model_plain_json(const MethodInput& input, const Catalog& catalog) {
  if (input.chat == nullptr) return no_model();
  chat::ChatOptions chat = *input.chat;
  chat.plain_json = true;
  const RepairOptions& repair = input.options.repair;
  llm::ConversationOptions conversation;
  conversation.max_attempts = repair.max_attempts;
  conversation.pause_s = repair.pause_s;
  const auto planner = llm::make_model_planner(catalog, std::move(chat), std::move(conversation));
  MethodInput changed = input;
  changed.model = planner.get();
  return model_pipeline(changed, catalog);
}

// The model's own numbers, cleaned up by the least movement.
Result<MethodResult> model_positions_cleaned(const MethodInput& input, const Catalog& catalog) {
  LAYOUTBOX_ASSIGN(MethodResult result, model_positions(input, catalog));
  LAYOUTBOX_CHECK(clean_up(result, input, catalog));
  return result;
}

constexpr std::array kMethods{
    Method{"pipeline", "the offline planner and the solver", false, &pipeline},
    Method{"no-improve", "the same with the first legal layout, unimproved", false, &without_improving},
    Method{"no-proofs", "the same by search alone, without CP-SAT", false, &without_proofs},
    Method{"no-companions", "the same without what the use of named things needs", false, &without_companions},
    Method{"random", "what the offline planner read, placed at random", false, &at_random},
    Method{"model", "the model plans, the solver solves, conflicts go back with reasons", true, &model_pipeline},
    Method{"model-paper", "the same with the paper's plain notice and its fallback to the model's positions", true, &model_as_paper},
    Method{"model-no-repair", "the same with one answer of the model", true, &model_without_repair},
    Method{"model-plain-json", "the same asked in plain JSON instead of by function calling", true, &model_plain_json},
    Method{"model-positions", "the model's own positions, no solver", true, &model_positions},
    Method{"model-moves", "the same, told what is impossible: the model moves its numbers, again and again", true, &model_positions_again},
    Method{"model-cleaned", "the model's own positions, cleaned up by the solver with the least movement", true, &model_positions_cleaned},
    Method{"one-step", "the model writes Blender's Python in one answer: no scene graph, no solver, no rerun", true, &one_step},
    Method{"one-step-cleaned", "the same, cleaned up by the solver with the least movement", true, &one_step_cleaned},
    Method{"one-step-again", "the same, told what failed and asked again", true, &one_step_again},
};

}  // namespace

std::span<const Method> methods() { return kMethods; }

const Method* find_method(std::string_view name) {
  const auto found = std::find_if(kMethods.begin(), kMethods.end(), [&](const Method& method) { return method.name == name; });
  return found == kMethods.end() ? nullptr : &*found;
}

}  // namespace layoutbox::experiment
