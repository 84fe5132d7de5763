// What files of others say in their own words: names of things, numbers, points, facts of models.
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "layoutbox/base/words.h"
#include "layoutbox/judge/readers/found_room.h"

namespace layoutbox::readers {

std::string words_in(std::string_view identifier) {
  std::string text(identifier.substr(0, identifier.find('(')));
  std::string words;
  bool was_lower = false;
  for (const char c : text) {
    const bool upper = c >= 'A' && c <= 'Z', lower = c >= 'a' && c <= 'z';
    if (upper && was_lower) words += ' ';
    words += upper ? static_cast<char>(c - 'A' + 'a') : lower || static_cast<unsigned char>(c) > 127 ? c : (c >= '0' && c <= '9') ? c : ' ';
    was_lower = lower;
  }
  std::string kept;
  for (const std::string& word : words_of(words)) {
    if (word.find_first_not_of("0123456789") == std::string::npos) continue;  // a number only tells them apart
    kept += (kept.empty() ? "" : " ") + word;
  }
  return kept.empty() ? "object" : kept;
}

std::optional<double> number(const nlohmann::json& value) { return value.is_number() ? std::optional(value.get<double>()) : std::nullopt; }

std::string text_of(const nlohmann::json& value, const char* key) {
  if (!value.is_object()) return {};
  const auto found = value.find(key);
  if (found == value.end()) return {};
  return found->is_string() ? found->get<std::string>() : found->is_number() ? found->dump() : std::string{};
}

std::optional<std::array<double, 3>> point_of(const nlohmann::json& value) {
  std::array<double, 3> point{};
  if (value.is_array()) {
    for (std::size_t i = 0; i < std::min<std::size_t>(3, value.size()); ++i) {
      const auto part = number(value[i]);
      if (!part) return std::nullopt;
      point[i] = *part;
    }
    return value.size() >= 2 ? std::optional(point) : std::nullopt;
  }
  if (!value.is_object()) return std::nullopt;
  constexpr std::array<const char*, 3> kKeys{"x", "y", "z"};
  int read = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto found = value.find(kKeys[i]);
    if (found == value.end()) continue;
    const auto part = number(*found);
    if (!part) return std::nullopt;
    point[i] = *part;
    ++read;
  }
  return read >= 2 ? std::optional(point) : std::nullopt;
}

std::optional<ModelFacts> model_facts(const nlohmann::json& models, const std::string& id) {
  if (!models.is_object()) return std::nullopt;
  const nlohmann::json& list = models.contains("assets") && models.at("assets").is_object() ? models.at("assets") : models;
  auto found = list.find(id);
  // "objaverse.chair-1" is listed as chair-1 as well.
  if (found == list.end() && id.find('.') != std::string::npos) found = list.find(id.substr(id.find('.') + 1));
  if (found == list.end() || !found->is_object()) return std::nullopt;
  ModelFacts facts;
  for (const char* key : {"category", "name", "object_name", "description"}) {
    if (facts.name.empty()) facts.name = text_of(*found, key);
  }
  if (const auto size = found->find("size"); size != found->end()) facts.size = point_of(*size);
  const auto metadata = found->find("assetMetadata");
  if (!facts.size && metadata != found->end() && metadata->is_object() && metadata->contains("boundingBox")) {
    facts.size = point_of(metadata->at("boundingBox"));
  }
  return facts;
}

}  // namespace layoutbox::readers
