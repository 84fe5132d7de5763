#include "layoutbox/chat/sse.h"

namespace layoutbox::chat {
namespace {

using Json = nlohmann::json;

void append(Json& object, const char* key, const Json& piece) {
  const auto found = piece.find(key);
  if (found == piece.end() || !found->is_string()) return;
  if (!object.contains(key) || !object[key].is_string()) object[key] = "";
  object[key].get_ref<std::string&>() += found->get_ref<const std::string&>();
}

// A piece of a call goes to the call of its index; without one to a new call where it has a name, else to the last.
void append_call(Json& calls, const Json& piece) {
  if (!piece.is_object() || !piece.contains("function") || !piece["function"].is_object()) return;
  constexpr std::size_t kMostCalls = 64;
  const Json& function = piece["function"];
  const bool named = function.contains("name") && function["name"].is_string() && !function["name"].get_ref<const std::string&>().empty();
  std::size_t index = named || calls.empty() ? calls.size() : calls.size() - 1;
  if (const auto said = piece.find("index"); said != piece.end() && said->is_number_unsigned()) index = said->get<std::size_t>();
  if (index >= kMostCalls) return;
  while (calls.size() <= index) calls.push_back({{"function", {{"name", ""}, {"arguments", ""}}}});
  append(calls[index]["function"], "name", function);
  append(calls[index]["function"], "arguments", function);
}

}  // namespace

std::vector<std::string> events_of(std::string_view body) {
  std::vector<std::string> events;
  std::string data;
  bool any = false;
  const auto end_event = [&] {
    if (any) events.push_back(std::move(data));
    data.clear();
    any = false;
  };
  if (body.starts_with("\xEF\xBB\xBF")) body.remove_prefix(3);
  while (!body.empty()) {
    const std::size_t end = body.find_first_of("\r\n");
    const std::string_view line = body.substr(0, end);
    if (end == std::string_view::npos) {
      body = {};
    } else {
      const bool two = body[end] == '\r' && end + 1 < body.size() && body[end + 1] == '\n';
      body.remove_prefix(end + (two ? 2 : 1));
    }
    if (line.empty()) {
      end_event();
    } else if (line.starts_with("data:")) {
      std::string_view value = line.substr(5);
      if (value.starts_with(' ')) value.remove_prefix(1);
      if (any) data += '\n';
      data += value;
      any = true;
    }
  }
  end_event();
  return events;
}

bool is_event_stream(std::string_view content_type, std::string_view body) {
  return content_type.starts_with("text/event-stream") || body.starts_with("data:") || body.starts_with("event:") || body.starts_with(": ");
}

StreamedResponse join_event_stream(std::string_view body) {
  StreamedResponse streamed;
  Json message{{"content", ""}}, finish, calls = Json::array();
  bool any = false, broken = false;
  for (const std::string& event : events_of(body)) {
    if (broken) {  // it went on after a piece that is no JSON, so that was not where it was cut
      streamed.valid = false;
      return streamed;
    }
    if (event == "[DONE]") {
      streamed.ended = true;
      break;
    }
    const Json piece = Json::parse(event, nullptr, false);
    if (!piece.is_object()) {
      broken = true;
      continue;
    }
    if (piece.contains("error") && !piece["error"].is_null()) {
      streamed.message = piece;
      return streamed;
    }
    if (piece.contains("usage") && piece["usage"].is_object()) streamed.message["usage"] = piece["usage"];
    if (!piece.contains("choices") || !piece["choices"].is_array() || piece["choices"].empty() || !piece["choices"][0].is_object())
      continue;
    const Json& choice = piece["choices"][0];
    any = true;
    if (choice.contains("finish_reason") && choice["finish_reason"].is_string()) finish = choice["finish_reason"], streamed.ended = true;
    if (!choice.contains("delta") || !choice["delta"].is_object()) continue;
    const Json& delta = choice["delta"];
    for (const char* key : {"content", "refusal"}) append(message, key, delta);
    if (delta.contains("tool_calls") && delta["tool_calls"].is_array()) {
      for (const Json& call : delta["tool_calls"]) append_call(calls, call);
    }
  }
  if (any) {
    if (!calls.empty()) message["tool_calls"] = std::move(calls);
    streamed.message["choices"] = Json::array({{{"message", std::move(message)}, {"finish_reason", std::move(finish)}}});
  }
  return streamed;
}

}  // namespace layoutbox::chat
