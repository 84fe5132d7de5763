#include "layoutbox/chat/script_answer.h"

#include <nlohmann/json.hpp>

namespace layoutbox::chat {
namespace {

constexpr const char* kSchema = R"({"type": "object", "properties": {
  "script": {"type": "string", "description": "the whole script, Python for Blender"}},
  "required": ["script"], "additionalProperties": false})";

}  // namespace

Function script_function() { return {"write_script", "The script that builds the room", kSchema, true}; }

std::string script_in(const Response& response) {
  const std::string& text = response.calls.empty() ? response.content : response.calls[0].arguments;
  const auto document = nlohmann::json::parse(text, nullptr, false);
  if (document.is_object() && document.contains("script") && document["script"].is_string()) return document["script"].get<std::string>();
  const std::size_t fence = text.find("```");
  if (fence == std::string::npos) return text;
  const std::size_t begin = text.find('\n', fence), end = text.find("```", fence + 3);
  return begin == std::string::npos ? std::string() : text.substr(begin + 1, end == std::string::npos ? end : end - begin - 1);
}

}  // namespace layoutbox::chat
