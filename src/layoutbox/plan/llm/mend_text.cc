#include "layoutbox/plan/llm/mend_text.h"

#include <fmt/format.h>

#include <cctype>
#include <nlohmann/json.hpp>

#include "layoutbox/base/plain_text.h"
#include "layoutbox/base/utf8.h"

namespace layoutbox::llm {

using nlohmann::json;

namespace {

constexpr std::size_t kLongestName = 80;
constexpr std::string_view kMendedSigns = "<>&\"`\\/|$;{}[]*?";

}  // namespace

void note(Notes& notes, std::string message, std::string pointer) { notes.push_back({"mended", std::move(message), std::move(pointer)}); }

std::string text_of(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::string clean_id(std::string_view written) {
  std::string id;
  for (const char c : written) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 && static_cast<unsigned char>(c) < 0x80;
    if (id.size() >= 60) break;
    if (plain || c == '_' || c == '-') {
      id += c;
    } else if (!id.empty() && id.back() != '_') {
      id += '_';
    }
  }
  while (id.ends_with('_')) id.pop_back();
  return id;
}

std::string clean_name(std::string_view written) {
  std::string name;
  for (const char c : plain_text(written)) {
    if (c != ' ' && kMendedSigns.find(c) == std::string_view::npos) {
      name += c;
    } else if (!name.empty() && name.back() != ' ') {
      name += ' ';
    }
  }
  name = first_bytes(name, kLongestName);
  while (name.ends_with(' ')) name.pop_back();
  return name;
}

void clean_text(json& owner, const char* key, const std::string& at, Notes& notes) {
  const auto found = owner.find(key);
  if (found == owner.end() || !found->is_string()) return;
  const std::string written = found->get<std::string>(), cleaned = clean_name(written);
  if (written == cleaned) return;
  note(notes, fmt::format("\"{}\" holds signs that no name has, and was cleaned", key), at);
  if (cleaned.empty()) {
    owner.erase(key);
  } else {
    *found = cleaned;
  }
}

}  // namespace layoutbox::llm
