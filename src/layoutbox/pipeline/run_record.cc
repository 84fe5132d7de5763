#include "layoutbox/pipeline/run_record.h"

#include <nlohmann/json.hpp>

namespace layoutbox {
namespace {

using Json = nlohmann::ordered_json;

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

Json json_of(const GenerateOptions& options) {
  return Json{{"seed", options.solve.seed},
              {"effort", options.solve.effort},
              {"timeLimit", options.solve.time_limit_s},
              {"onConflict", name_of(options.solve.on_conflict)},
              {"pictures", options.pictures},
              {"quality", name_of(options.render.quality)},
              {"size", {options.render.width, options.render.height}}};
}

Json json_of(const Error& error) {
  Json json{{"code", error_code_name(error.code)}, {"message", error.message}, {"pointer", error.pointer}, {"hint", error.hint}};
  for (const Error& detail : error.details) json["details"].push_back(json_of(detail));
  return json;
}

}  // namespace

std::string write_run_record(std::string_view prompt, const GenerateOptions& options, const GenerateOutcome& outcome,
                             const Error* failure) {
  Json json{{"format", "layoutbox/run@1"}, {"prompt", prompt}, {"status", failure ? "failed" : as_asked(outcome) ? "done" : "incomplete"}};
  json["options"] = json_of(options);
  json["versions"] = {{"layoutbox", program_version()}};
  if (!outcome.blender_version.empty()) json["versions"]["blender"] = outcome.blender_version;
  json["stages"] = Json::array();
  for (const StageTime& stage : outcome.stages) {
    json["stages"].push_back({{"stage", stage.stage}, {"seconds", stage.seconds}, {"summary", stage.summary}});
  }
  json["notes"] = Json::array();
  for (const Note& note : outcome.scene.notes) {
    json["notes"].push_back({{"code", note.code}, {"message", note.message}, {"pointer", note.pointer}});
  }
  json["files"] = outcome.files;
  json["modelRequests"] = Json::array();  // the offline planner asks no model
  if (failure) json["error"] = json_of(*failure);
  if (outcome.picture_error) json["pictureError"] = json_of(*outcome.picture_error);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace layoutbox
