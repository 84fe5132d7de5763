#include "layoutbox/pipeline/run_record.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "layoutbox/scene/json_text.h"

namespace layoutbox {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string_view name_of(OnConflict choice) {
  switch (choice) {
    case OnConflict::kFail: return "fail";
    case OnConflict::kRelax: return "relax";
    case OnConflict::kOriginal: return "original";
  }
  return "relax";
}

std::string_view name_of(Quality quality) {
  switch (quality) {
    case Quality::kDraft: return "draft";
    case Quality::kPreview: return "preview";
    case Quality::kFinal: return "final";
  }
  return "preview";
}

// Null where the scene says it.
OrderedJson json_of(const Size& size) {
  if (size.width == 0) return nullptr;
  return {m_from_mm(size.width), m_from_mm(size.depth), m_from_mm(size.height)};
}

OrderedJson names_of(const std::vector<View>& views) {
  OrderedJson json = OrderedJson::array();
  for (const View view : views) json.push_back(name_of(view));
  return json;
}

OrderedJson json_of(const GenerateOptions& options) {
  return OrderedJson{{"planner", options.planner},
                     {"room", json_of(options.normalize.room_size)},
                     {"companions", options.companions},
                     {"seed", options.solve.seed},
                     {"effort", options.solve.effort},
                     {"timeLimit", options.solve.time_limit_s},
                     {"variants", options.variants},
                     {"onConflict", name_of(options.solve.on_conflict)},
                     {"pictures", options.pictures},
                     {"quality", name_of(options.render.quality)},
                     {"size", {options.render.width, options.render.height}},
                     {"views", names_of(options.render.views)},
                     {"corner", name_of(options.render.corner)},
                     {"overlay", options.render.overlay},
                     {"mask", options.render.object_mask},
                     {"turntable", options.render.turntable},
                     {"detail", name_of(options.furnish.detail)},
                     {"maxAttempts", options.repair.max_attempts},
                     {"repairAttempts", options.repair.repair_attempts},
                     {"paperRetries", options.repair.paper_retries}};
}

OrderedJson json_of(const std::vector<InputFile>& inputs) {
  OrderedJson json = OrderedJson::array();
  for (const InputFile& input : inputs) json.push_back({{"option", input.option}, {"file", input.file}, {"key", input.key}});
  return json;
}

}  // namespace

std::string options_text(const GenerateOptions& options) {
  const OrderedJson json{{"version", program_version()}, {"options", json_of(options)}, {"inputs", json_of(options.inputs)}};
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

OrderedJson json_of_error(const Error& error) { return OrderedJson::parse(write_error(error)); }

std::optional<RunState> state_of_same_run(std::string_view record, std::string_view prompt, const GenerateOptions& options) {
  const auto json = parse_json(record);
  if (!json || !json->is_object() || json->contains("pictureError")) return std::nullopt;
  const auto is = [&json](const char* name, const nlohmann::json& value) { return json->value(name, nlohmann::json()) == value; };
  if (!is("prompt", std::string(prompt)) || !is("options", json_of(options)) || !is("inputs", json_of(options.inputs))) return std::nullopt;
  if (json->value("versions", nlohmann::json::object()).value("layoutbox", "") != program_version()) return std::nullopt;
  if (is("status", "done")) return RunState::kDone;
  if (is("status", "incomplete")) return RunState::kNotAsAsked;
  return std::nullopt;
}

std::string write_run_record(std::string_view prompt, const GenerateOptions& options, const GenerateOutcome& outcome,
                             const Error* failure) {
  OrderedJson json{{"format", "layoutbox/run@1"},
                   {"prompt", prompt},
                   {"status", failure             ? "failed"
                              : as_asked(outcome) ? "done"
                                                  : "incomplete"}};
  json["options"] = json_of(options);
  json["inputs"] = json_of(options.inputs);
  json["versions"] = {{"layoutbox", program_version()}};
  if (!outcome.blender_version.empty()) json["versions"]["blender"] = outcome.blender_version;
  json["stages"] = OrderedJson::array();
  for (const StageTime& stage : outcome.stages) {
    json["stages"].push_back({{"stage", stage.stage}, {"seconds", stage.seconds}, {"summary", stage.summary}});
  }
  json["notes"] = OrderedJson::array();
  for (const Note& note : outcome.scene.notes) {
    json["notes"].push_back({{"code", note.code}, {"message", note.message}, {"pointer", note.pointer}});
  }
  json["layout"] = {
      {"score", outcome.layout.score}, {"proven", outcome.layout.stats.proven}, {"stoppedByClock", outcome.layout.stats.stopped_by_clock}};
  for (const Layout& other : outcome.more_layouts) {
    const Difference difference = difference_between(outcome.layout, other);
    json["variants"].push_back({{"score", other.score}, {"meanDistance", difference.mean_m}, {"otherWall", difference.other_wall}});
  }
  json["files"] = outcome.files;
  json["modelRequests"] = outcome.model_requests.empty() ? OrderedJson::array() : OrderedJson::parse(outcome.model_requests);
  if (failure) json["error"] = json_of_error(*failure);
  if (outcome.picture_error) json["pictureError"] = json_of_error(*outcome.picture_error);
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

}  // namespace layoutbox
