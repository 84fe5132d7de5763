#include <cmath>
#include <nlohmann/json.hpp>

#include "layoutbox/verify/verify.h"

namespace layoutbox {
namespace {

using Json = nlohmann::ordered_json;

// To the micrometre: what is below it is noise of the machine's arithmetic, and must not change the bytes.
double rounded(double value) {
  if (!std::isfinite(value)) return 0;
  const double millionths = std::round(value * 1e6);
  return std::abs(millionths) < 1e15 ? millionths / 1e6 + 0.0 : value;
}

Json to_json(const Check& check) {
  Json json{{"name", check.name},         {"subject", check.subject},      {"passed", check.passed},
            {"required", check.required}, {"value", rounded(check.value)}, {"unit", check.unit},
            {"message", check.message},   {"pointer", check.pointer}};
  if (check.limit) json["limit"] = rounded(*check.limit);
  return json;
}

}  // namespace

std::string write_report(const Report& report) {
  Json document;
  document["format"] = "layoutbox/report@1";
  document["passed"] = report.passed;
  document["metrics"] = Json::object();
  for (const auto& [name, value] : report.metrics) document["metrics"][name] = rounded(value);
  document["checks"] = Json::array();
  for (const Check& check : report.checks) document["checks"].push_back(to_json(check));
  // Ids may hold any bytes that a file had; what is not UTF-8 is replaced, never thrown.
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace layoutbox
