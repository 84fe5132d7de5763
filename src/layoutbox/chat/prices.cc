#include "layoutbox/chat/prices.h"

#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "layoutbox/base/files.h"
#include "layoutbox/embedded/models.h"

namespace layoutbox::chat {
namespace {

using Json = nlohmann::json;

bool is_price(const Json& value) {
  const auto good = [&](const char* key) { return value.contains(key) && value[key].is_number() && value[key].get<double>() >= 0; };
  return value.is_object() && good("request") && good("response");
}

}  // namespace

const Prices& Prices::builtin() {
  static const Prices prices = [] {
    Prices made;
    (void)made.add(embedded::prices_json);  // a test holds that it can be read
    return made;
  }();
  return prices;
}

Result<Prices> Prices::of_user() {
  Prices prices = builtin();
  const std::filesystem::path file = prices_file();
  std::error_code ignored;
  if (file.empty() || !std::filesystem::exists(file, ignored)) return prices;
  LAYOUTBOX_ASSIGN(const std::string text, read_file(file));
  if (Status added = prices.add(text); !added) {
    added.error().pointer = file.string() + (added.error().pointer.empty() ? "" : "#" + added.error().pointer);
    return Failure(added.error());
  }
  return prices;
}

Status Prices::add(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return fail(ErrorCode::kParse, "the list of prices is no JSON");
  if (!json.is_object() || !json.contains("models") || !json["models"].is_object()) {
    return fail(ErrorCode::kSchema, "the list of prices has no member \"models\"", {},
                R"(write {"models": {"NAME": {"request": 2.5, "response": 10}}})");
  }
  std::map<std::string, Price, std::less<>> added;
  for (const auto& [name, price] : json["models"].items()) {
    if (!is_price(price)) {
      return fail(ErrorCode::kSchema, fmt::format("the price of {} is no pair of numbers", name), "/models/" + name,
                  R"(write {"request": 2.5, "response": 10, "asOf": "2025-08"}: US dollars for a million tokens)");
    }
    const bool dated = price.contains("asOf") && price["asOf"].is_string();
    added[name] = {price["request"].get<double>(), price["response"].get<double>(), dated ? price["asOf"].get<std::string>() : ""};
  }
  for (auto& [name, price] : added) prices_[name] = std::move(price);
  return {};
}

std::filesystem::path prices_file() {
  const char* const named = std::getenv("XDG_CONFIG_HOME");
  if (named != nullptr && std::filesystem::path(named).is_absolute()) return std::filesystem::path(named) / "layoutbox/prices.json";
  const char* const home = std::getenv("HOME");
  return home != nullptr && *home != '\0' ? std::filesystem::path(home) / ".config/layoutbox/prices.json" : std::filesystem::path();
}

std::optional<Price> Prices::find(std::string_view model) const {
  if (const std::size_t slash = model.rfind('/'); slash != std::string_view::npos) {  // "openai/gpt-4o"
    if (const auto exact = prices_.find(model); exact != prices_.end()) return exact->second;
    model.remove_prefix(slash + 1);
  }
  std::optional<Price> best;
  std::size_t longest = 0;
  for (const auto& [name, price] : prices_) {
    const bool fits = model.starts_with(name) && (model.size() == name.size() || model[name.size()] == '-' || model[name.size()] == ':');
    if (fits && name.size() >= longest) best = price, longest = name.size();
  }
  return best;
}

double cost_of(const Price& price, const Usage& usage) {
  return (price.request * static_cast<double>(usage.request_tokens) + price.response * static_cast<double>(usage.response_tokens)) / 1e6;
}

}  // namespace layoutbox::chat
