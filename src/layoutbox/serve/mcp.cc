#include "layoutbox/serve/mcp.h"

#include <algorithm>
#include <array>

#include "layoutbox/base/bytes.h"
#include "layoutbox/pipeline/generate.h"
#include "layoutbox/scene/json_text.h"
#include "layoutbox/serve/call_parts.h"

namespace layoutbox::serve {
namespace {

constexpr std::string_view kNewestProtocol = "2025-06-18";
constexpr std::array<std::string_view, 3> kProtocols{"2024-11-05", "2025-03-26", kNewestProtocol};

// Codes of JSON-RPC 2.0.
constexpr int kNotJson = -32700, kNotARequest = -32600, kNoSuchMethod = -32601, kWrongParameters = -32602;

struct Tool {
  std::string_view name, operation, description;
};

// What a client is offered: calls of the OpenAPI document under names that say what they are for.
constexpr std::array kTools{
    Tool{"generate_room", "generate",
         "Text (or a scene) to a furnished, checked room: scene graph, layouts, report. Relations that cannot all hold are in the layout's "
         "\"conflicts\" with the reason, what was given up in \"relaxed\"."},
    Tool{"plan_scene", "plan", "Text to a scene graph alone, and how each word was understood."},
    Tool{"solve_scene", "solve",
         "A scene graph to layouts. With onConflict \"fail\" the error explains the smallest set of relations that cannot all hold."},
    Tool{"edit_room", "edit", "Changes a layout by words (\"move the desk under the window\") and says what changed."},
    Tool{"move_object", "drag", "Puts one object of a layout elsewhere, turns or resizes it: what gives way, or why it cannot be."},
    Tool{"verify_room", "verify", "Checks a layout by geometry: collisions, support, doors, ways to walk, every relation."},
    Tool{"settle_conflict", "remedies",
         "For a scene whose layout has conflicts: small changes, each tried and enough, in words and as the changed scene. "
         "Give the scene and the layout that was made of it."},
    Tool{"judge_room", "judge", "The measures of a layout, against the scene that was asked for: what is there, held, possible."},
    Tool{"look_at_room", "export", "A layout as a picture of its floor plan (format png), or as svg, glb, pdf, json or blender.py."},
};

struct RpcError {
  int code;
  std::string message;
};

const Tool* find_tool(std::string_view name) {
  const auto found = std::find_if(kTools.begin(), kTools.end(), [&](const Tool& tool) { return tool.name == name; });
  return found == kTools.end() ? nullptr : &*found;
}

// The schema without references, which not every client follows.
Json without_references(const Json& node, const Json& document) {
  if (node.is_object() && node.contains("$ref")) {
    return without_references(document.at(Json::json_pointer(node.at("$ref").get<std::string>().substr(1))), document);
  }
  if (!node.is_structured()) return node;
  Json copy = node.is_array() ? Json::array() : Json::object();
  for (const auto& [key, value] : node.items()) {
    if (node.is_array()) {
      copy.push_back(without_references(value, document));
    } else {
      copy[key] = without_references(value, document);
    }
  }
  return copy;
}

Json list_of_tools() {
  const Json document = Json::parse(openapi_text());
  Json tools = Json::array();
  for (const Tool& tool : kTools) {
    const Json& body = document.at("paths").at("/api/" + std::string(tool.operation)).at("post").at("requestBody");
    tools.push_back({{"name", tool.name},
                     {"description", tool.description},
                     {"inputSchema", without_references(body.at("content").at("application/json").at("schema"), document)}});
  }
  return {{"tools", std::move(tools)}};
}

Json text_content(std::string text) { return {{"type", "text"}, {"text", std::move(text)}}; }

// A failure that the model can read and act on.
Json failed(const Error& error) { return {{"content", {text_content(write_error(error))}}, {"isError", true}}; }

Json content_of(const Answer& answer) {
  if (answer.type.starts_with("image/png")) return {{"type", "image"}, {"data", base64(answer.body)}, {"mimeType", "image/png"}};
  if (answer.type.starts_with("application/json") || answer.type.starts_with("text/") || answer.type.starts_with("image/svg")) {
    return text_content(answer.body);
  }
  return {{"type", "resource"}, {"resource", {{"uri", "layoutbox://room"}, {"mimeType", answer.type}, {"blob", base64(answer.body)}}}};
}

std::string line_of(const Json& message) { return message.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string error_line(const Json& id, const RpcError& error) {
  return line_of({{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", error.code}, {"message", error.message}}}});
}

Json hello(const Json& parameters) {
  const std::string asked = parameters.value("protocolVersion", std::string(kNewestProtocol));
  const bool known = std::find(kProtocols.begin(), kProtocols.end(), asked) != kProtocols.end();
  return {
      {"protocolVersion", known ? asked : std::string(kNewestProtocol)},
      {"capabilities", {{"tools", Json::object()}}},
      {"serverInfo", {{"name", "layoutbox"}, {"version", program_version()}}},
      {"instructions", "Rooms in metres and degrees; x to the right, y away from the viewer. A layout goes from call to call as a whole."}};
}

}  // namespace

Json McpSession::call_tool(const Json& parameters) const {
  const Tool* tool = find_tool(parameters.value("name", ""));
  if (tool == nullptr) throw RpcError{kWrongParameters, "there is no tool \"" + parameters.value("name", "") + "\""};
  const auto request = schemas_.read(tool->operation, parameters.value("arguments", Json::object()).dump());
  if (!request) return failed(request.error());
  const auto answer = find_call(tool->operation)(*request, around_);
  if (!answer) return failed(answer.error());
  return {{"content", {content_of(*answer)}}};
}

Json McpSession::result_of(const std::string& method, const Json& parameters) const {
  if (method == "initialize") return hello(parameters);
  if (method == "ping") return Json::object();
  if (method == "tools/list") return list_of_tools();
  if (method == "tools/call") return call_tool(parameters);
  throw RpcError{kNoSuchMethod, "there is no method \"" + method + "\""};
}

std::optional<std::string> McpSession::answer(std::string_view line) const {
  const auto message = parse_json(line);
  if (!message) return error_line(nullptr, {kNotJson, message.error().message});
  if (!message->is_object() || !message->contains("method") || !message->at("method").is_string()) {
    if (message->is_object() && (message->contains("result") || message->contains("error"))) return std::nullopt;
    return error_line(nullptr, {kNotARequest, "a message has a method"});
  }
  if (!message->contains("id")) return std::nullopt;
  const Json parameters = message->value("params", Json::object());
  const Json& id = message->at("id");
  if (!parameters.is_object()) return error_line(id, {kWrongParameters, "params must be an object"});
  try {
    return line_of({{"jsonrpc", "2.0"}, {"id", id}, {"result", result_of(message->at("method").get<std::string>(), parameters)}});
  } catch (const RpcError& error) {
    return error_line(id, error);
  } catch (const Json::exception& error) {
    return error_line(id, {kWrongParameters, error.what()});
  }
}

}  // namespace layoutbox::serve
