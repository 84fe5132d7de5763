#include "layoutbox/chat/prices.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "layoutbox/embedded/models.h"

namespace layoutbox::chat {
namespace {

using Json = nlohmann::json;

bool is_price(const Json& value) {
  const auto good = [&](const char* key) { return value.contains(key) && value[key].is_number() && value[key].get<double>() >= 0; };
  return value.is_object() && good("question") && good("answer");
}

Status add(std::string_view text, std::map<std::string, Price, std::less<>>& prices) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return fail(ErrorCode::kParse, "the list of prices is no JSON");
  if (!json.is_object() || !json.contains("models") || !json["models"].is_object()) {
    return fail(ErrorCode::kSchema, "the list of prices has no member \"models\"", {},
                R"(write {"models": {"NAME": {"question": 2.5, "answer": 10}}})");
  }
  for (const auto& [name, price] : json["models"].items()) {
    if (!is_price(price)) {
      return fail(ErrorCode::kSchema, fmt::format("the price of {} is no pair of numbers", name), "/models/" + name,
                  R"(write {"question": 2.5, "answer": 10}: US dollars for a million tokens)");
    }
    prices[name] = {price["question"].get<double>(), price["answer"].get<double>()};
  }
  return {};
}

}  // namespace

const Prices& Prices::builtin() {
  static const Prices prices = [] {
    Prices made;
    (void)add(embedded::prices_json, made.prices_);  // a test holds that it can be read
    return made;
  }();
  return prices;
}

Result<Prices> Prices::with(std::string_view json) {
  Prices prices = builtin();
  LAYOUTBOX_CHECK(add(json, prices.prices_));
  return prices;
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
  return (price.question * static_cast<double>(usage.question_tokens) + price.answer * static_cast<double>(usage.answer_tokens)) / 1e6;
}

}  // namespace layoutbox::chat
