// The calls of the service that answer at once: JSON in, JSON or a file out. They know nothing of HTTP.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/plan/planner.h"
#include "layoutbox/scene/schema_check.h"

namespace layoutbox::serve {

struct Answer {
  int status = 200;
  std::string type = "application/json";
  std::string body;
};

// What a call works with. Everything outlives it.
struct Surroundings {
  const Catalog& catalog;
  const Planner& planner;
  const std::atomic<bool>* stop = nullptr;  // ends what is being worked at (kInterrupted)
  // Told as a stage begins: "plan", "solve", "verify". May be empty.
  std::function<void(std::string_view stage)> on_stage = {};
  const Planner* by_model = nullptr;                   // the planner that asks a language model, where the service has one
  std::function<void(double share)> on_progress = {};  // told now and then how much of the solving is done, 0 … 1. May be empty.
};

// The OpenAPI document of web/openapi.json as it is served.
std::string_view openapi_text();

// The operations of the document that take a JSON body, by operationId, each with the schema that its body must follow.
class RequestSchemas {
 public:
  RequestSchemas();
  // The body read and checked. Errors: kParse, kSchema with every violation as a detail, kTooLarge.
  Result<nlohmann::json> read(std::string_view operation, std::string_view body) const;

 private:
  std::map<std::string, JsonSchema, std::less<>> schemas_;
};

// One function for each; `request` follows its schema. Errors: those of the stages.
using CallFunction = Result<Answer> (*)(const nlohmann::json& request, const Surroundings& around);

// By operationId; null where there is none.
CallFunction find_call(std::string_view operation);

Result<Answer> generate_call(const nlohmann::json& request, const Surroundings& around);
Result<Answer> plan_call(const nlohmann::json& request, const Surroundings& around);
Result<Answer> solve_call(const nlohmann::json& request, const Surroundings& around);
Result<Answer> edit_call(const nlohmann::json& request, const Surroundings& around);
Result<Answer> drag_call(const nlohmann::json& request, const Surroundings& around);
Result<Answer> verify_call(const nlohmann::json& request, const Surroundings& around);
Result<Answer> export_call(const nlohmann::json& request, const Surroundings& around);
Result<Answer> judge_call(const nlohmann::json& request, const Surroundings& around);
Result<Answer> remedies_call(const nlohmann::json& request, const Surroundings& around);

// Articles that match `search` (all where it is empty), best first.
Answer catalog_answer(const Catalog& catalog, std::string_view search, std::size_t limit);
// The rows of the relation table.
Answer relations_answer();

}  // namespace layoutbox::serve
