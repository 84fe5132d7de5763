#include "layoutbox/serve/calls.h"

#include <algorithm>
#include <array>

#include "layoutbox/edit/edit.h"
#include "layoutbox/embedded/openapi.h"
#include "layoutbox/pipeline/variants.h"
#include "layoutbox/scene/json_text.h"
#include "layoutbox/scene/layout_scene.h"
#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/serve/call_parts.h"

namespace layoutbox::serve {
namespace {

struct CallRow {
  std::string_view operation;
  CallFunction call;
};

constexpr std::array kCalls{
    CallRow{"generate", generate_call}, CallRow{"plan", plan_call},   CallRow{"solve", solve_call},
    CallRow{"edit", edit_call},         CallRow{"drag", drag_call},   CallRow{"verify", verify_call},
    CallRow{"export", export_call},     CallRow{"judge", judge_call}, CallRow{"remedies", remedies_call},
};

// The scene of a request, planned or given, with everything filled in; the words where it was planned.
struct AskedRoom {
  SceneGraph scene;
  std::vector<WordReading> words;
};

Result<const Planner*> planner_for(const Json& request, const Surroundings& around) {
  if (request.value("planner", "offline") != "llm") return &around.planner;
  if (around.by_model != nullptr) return around.by_model;
  return fail(ErrorCode::kUsage, "this service asks no language model", "/planner",
              "start it with --planner llm, or leave the planner out");
}

Result<AskedRoom> asked_room(const Json& request, const GenerateOptions& options, const Surroundings& around) {
  if (request.contains("prompt") == request.contains("scene")) {
    return fail(ErrorCode::kUsage, "a room is made from a prompt or from a scene", {}, "give exactly one of \"prompt\" and \"scene\"");
  }
  if (request.contains("scene")) {
    LAYOUTBOX_ASSIGN(SceneGraph given, scene_of_request(request));
    LAYOUTBOX_ASSIGN(SceneGraph scene, prepare_scene(std::move(given), around.catalog, options));
    return AskedRoom{std::move(scene), {}};
  }
  LAYOUTBOX_ASSIGN(const Planner* planner, planner_for(request, around));
  LAYOUTBOX_ASSIGN(Plan plan, planner->plan(request.at("prompt").get<std::string>(), options.plan));
  LAYOUTBOX_ASSIGN(SceneGraph scene, prepare_plan(plan, around.catalog, options));
  return AskedRoom{std::move(scene), std::move(plan.readings)};
}

std::vector<std::string> texts_of(const std::vector<Layout>& layouts) {
  std::vector<std::string> texts;
  for (const Layout& layout : layouts) texts.push_back(write_layout(layout));
  return texts;
}

}  // namespace

std::string_view openapi_text() { return embedded::openapi_json; }

RequestSchemas::RequestSchemas() {
  const Json document = Json::parse(openapi_text());
  for (const auto& [path, methods] : document.at("paths").items()) {
    for (const auto& [method, operation] : methods.items()) {
      if (!operation.contains("requestBody")) continue;
      Json schema = operation.at("requestBody").at("content").at("application/json").at("schema");
      schema["components"] = document.at("components");
      schemas_.emplace(operation.at("operationId").get<std::string>(), JsonSchema(std::move(schema)));
    }
  }
}

Result<Json> RequestSchemas::read(std::string_view operation, std::string_view body) const {
  LAYOUTBOX_ASSIGN(Json request, parse_json(body));
  const auto schema = schemas_.find(operation);
  if (schema == schemas_.end()) return fail(ErrorCode::kInternal, "an operation without a schema");
  auto violations = schema->second.check(request);
  if (violations.empty()) return request;
  Error error = violations.front();
  if (violations.size() > 1) error.details = std::move(violations);
  return Failure(std::move(error));
}

CallFunction find_call(std::string_view operation) {
  const auto found = std::find_if(kCalls.begin(), kCalls.end(), [&](const CallRow& row) { return row.operation == operation; });
  return found == kCalls.end() ? nullptr : found->call;
}

Result<Answer> generate_call(const Json& request, const Surroundings& around) {
  LAYOUTBOX_ASSIGN(const GenerateOptions options, generate_options(request, around));
  const auto begin = [&](std::string_view stage) {
    if (around.on_stage) around.on_stage(stage);
  };
  Stopwatch watch;
  begin("plan");
  LAYOUTBOX_ASSIGN(const AskedRoom asked, asked_room(request, options, around));
  const double plan_ms = watch.lap();
  begin("solve");
  LAYOUTBOX_ASSIGN(const std::vector<Layout> layouts, solve_variants(asked.scene, around.catalog, options.solve, options.variants));
  const double solve_ms = watch.lap();
  begin("verify");
  const Report report = verify(layouts.front(), around.catalog);
  JsonText answer;
  answer.add_written("scene", write_scene(asked.scene))
      .add_written("layouts", texts_of(layouts))
      .add_written("report", write_report(report));
  answer.add("notes", json_of_notes(asked.scene.notes)).add("asAsked", as_asked(layouts.front(), report));
  answer.add("milliseconds", {{"plan", plan_ms}, {"solve", solve_ms}, {"verify", watch.lap()}});
  if (!asked.words.empty()) answer.add("words", json_of_words(asked.words));
  return answer.answer();
}

Result<Answer> plan_call(const Json& request, const Surroundings& around) {
  LAYOUTBOX_ASSIGN(const GenerateOptions options, generate_options(request, around));
  LAYOUTBOX_ASSIGN(const AskedRoom asked, asked_room(request, options, around));
  JsonText answer;
  answer.add_written("scene", write_scene(asked.scene));
  return answer.add("words", json_of_words(asked.words)).add("notes", json_of_notes(asked.scene.notes)).answer();
}

Result<Answer> solve_call(const Json& request, const Surroundings& around) {
  LAYOUTBOX_ASSIGN(GenerateOptions options, generate_options(request, around));
  LAYOUTBOX_ASSIGN(SceneGraph given, scene_of_request(request));
  LAYOUTBOX_ASSIGN(const SceneGraph scene, prepare_scene(std::move(given), around.catalog, options));
  std::optional<Layout> from;
  if (request.contains("from")) {
    LAYOUTBOX_ASSIGN(from, layout_of(request, "from"));
    options.solve.from = &*from;
  }
  if (around.on_stage) around.on_stage("solve");
  LAYOUTBOX_ASSIGN(const std::vector<Layout> layouts, solve_variants(scene, around.catalog, options.solve, options.variants));
  return JsonText().add_written("layouts", texts_of(layouts)).answer();
}

Result<Answer> edit_call(const Json& request, const Surroundings& around) {
  LAYOUTBOX_ASSIGN(const Layout layout, layout_of(request));
  LAYOUTBOX_ASSIGN(const EditOutcome edited,
                   edit_layout(request.at("text").get<std::string>(), layout, around.catalog, solve_options(request, around)));
  const Report report = verify(edited.layout, around.catalog);
  Json changes = Json::array(), dropped = Json::array();
  for (const ObjectChange& change : edited.changes) {
    changes.push_back(
        {{"id", change.id}, {"what", change.what}, {"metres", change.metres}, {"degrees", change.degrees}, {"asked", change.asked}});
  }
  for (const Relation& relation : edited.dropped) {
    dropped.push_back(relation.why.empty() ? std::string(relation_row(relation.type).name) : relation.why);
  }
  JsonText answer;
  answer.add_written("layout", write_layout(edited.layout)).add_written("report", write_report(report));
  answer.add("changes", changes).add("dropped", dropped).add("notes", json_of_notes(edited.notes));
  return answer.add("asAsked", as_asked(edited.layout, report)).answer();
}

Result<Answer> verify_call(const Json& request, const Surroundings& around) {
  LAYOUTBOX_ASSIGN(const Layout layout, layout_of(request));
  return Answer{200, "application/json", write_report(verify(layout, around.catalog))};
}

Answer relations_answer() {
  Json rows = Json::array();
  for (const RelationRow& row : relation_table())
    rows.push_back({{"name", row.name}, {"sentence", row.sentence}, {"unnamed", unnamed_reference(row.type)}});
  return json_answer({{"relations", std::move(rows)}});
}

}  // namespace layoutbox::serve
