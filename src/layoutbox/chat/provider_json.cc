#include "layoutbox/chat/provider_json.h"

#include <algorithm>

namespace layoutbox::chat {

namespace {

using Json = nlohmann::json;
using Ordered = nlohmann::ordered_json;

bool is_web_page(std::string_view body) {
  const std::size_t begin = body.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && body[begin] == '<';
}

}  // namespace

Ordered schema_of(const Function& function) { return Ordered::parse(function.parameters, nullptr, false); }

std::string plain_json_wish(const Function& function) {
  return "\n\nAnswer with one JSON object and nothing else. It follows this JSON Schema:\n" + schema_of(function).dump();
}

std::string text_of(const Json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) return {};
  if (found->is_string()) return found->get<std::string>();
  if (found->is_number_integer()) return std::to_string(found->get<long long>());
  if (!found->is_array()) return {};
  std::string text;  // content in parts
  for (const Json& part : *found) {
    if (part.is_object()) text += text_of(part, "text");
  }
  return text;
}

std::int64_t count_of(const Json& usage, const char* key) {
  const auto found = usage.find(key);
  constexpr double kMost = 1e12;  // beyond is nonsense, and no integer
  return found != usage.end() && found->is_number() ? static_cast<std::int64_t>(std::clamp(found->get<double>(), 0.0, kMost)) : 0;
}

ServerError error_from(const Json& body) {
  ServerError error;
  const Json* object = &body;
  if (body.is_object() && body.contains("error")) object = &body["error"];
  if (object->is_string()) {
    error.message = object->get<std::string>();
  } else if (object->is_object()) {
    error.message = text_of(*object, "message");
    if (error.message.empty()) error.message = text_of(*object, "detail");
    error.parameter = text_of(*object, "param");
    error.code = text_of(*object, "code");
    if (error.code.empty()) error.code = text_of(*object, "type");
    error.context = count_of(*object, "n_ctx");
    if (error.message.empty()) error.message = object->dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  return error;
}

ReadResponse broken(std::string why) {
  ReadResponse read;
  read.error.message = std::move(why);
  return read;
}

std::optional<Json> body_of(const HttpResponse& response, StreamedResponse (*join)(std::string_view), ReadResponse& read) {
  if (response.body.find_first_not_of(" \t\r\n") == std::string::npos) {
    read = broken("the answer is empty");
    return std::nullopt;
  }
  Json body;
  bool ended = true;
  if (is_event_stream(response.content_type, response.body)) {
    StreamedResponse streamed = join(response.body);
    if (!streamed.valid) {
      read = broken("a piece of the streamed answer is no JSON");
      return std::nullopt;
    }
    body = std::move(streamed.message);
    ended = streamed.ended;
  } else {
    body = Json::parse(response.body, nullptr, false);
    if (body.is_discarded()) {
      read = broken("the answer is broken: no JSON in UTF-8");
      if (is_web_page(response.body)) read.kind = ReadResponse::Kind::kPage;
      return std::nullopt;
    }
  }
  if (body.is_object() && body.contains("error") && !body["error"].is_null()) {
    read.kind = ReadResponse::Kind::kError;
    read.error = error_from(body);
    return std::nullopt;
  }
  if (!ended && !response.left_off) {
    read.kind = ReadResponse::Kind::kCut;
    return std::nullopt;
  }
  return body;
}

}  // namespace layoutbox::chat
