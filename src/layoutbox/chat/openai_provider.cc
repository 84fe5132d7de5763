// OpenAI's chat completions.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "layoutbox/chat/provider_json.h"
#include "layoutbox/chat/sse.h"

namespace layoutbox::chat {
namespace {

using Json = nlohmann::json;
using Ordered = nlohmann::ordered_json;

Ordered tool_of(const Function& function, Mode mode) {
  Ordered description{{"name", function.name}, {"description", function.description}};
  if (mode == Mode::kStrictTools && function.strict) description["strict"] = true;
  description["parameters"] = schema_of(function);
  return {{"type", "function"}, {"function", std::move(description)}};
}

void add_tools(Ordered& body, const Request& question, const Capabilities& capabilities) {
  for (const Function& function : question.functions) body["tools"].push_back(tool_of(function, capabilities.mode));
  if (capabilities.without.contains("tool_choice")) return;
  // By name it is one call and no other; "required" is for the choice between two, and for servers (llama.cpp) that know words alone.
  if (question.functions.size() == 1 && capabilities.mode == Mode::kStrictTools && !capabilities.without.contains("named_tool")) {
    body["tool_choice"] = {{"type", "function"}, {"function", {{"name", question.functions[0].name}}}};
  } else {
    body["tool_choice"] = "required";
  }
}

void add_response_format(Ordered& body, const Request& question, const Capabilities& capabilities) {
  if (capabilities.without.contains("response_format")) return;
  if (capabilities.mode == Mode::kJson) {
    body["response_format"] = {{"type", "json_object"}};
    return;
  }
  const Function& function = question.functions[0];
  body["response_format"] = {{"type", "json_schema"},
                             {"json_schema", {{"name", function.name}, {"strict", function.strict}, {"schema", schema_of(function)}}}};
}

Call call_of(const Json& function) {
  Call call{text_of(function, "name"), {}};
  const auto arguments = function.find("arguments");
  if (arguments == function.end()) return call;
  call.arguments = arguments->is_string() ? arguments->get<std::string>() : arguments->dump();
  return call;
}

void read_message(const Json& message, Response& answer) {
  answer.content = text_of(message, "content");
  answer.refusal = text_of(message, "refusal");
  if (const auto calls = message.find("tool_calls"); calls != message.end() && calls->is_array()) {
    for (const Json& call : *calls) {
      if (call.is_object() && call.contains("function") && call["function"].is_object()) answer.calls.push_back(call_of(call["function"]));
    }
  }
  const auto old_form = message.find("function_call");
  if (answer.calls.empty() && old_form != message.end() && old_form->is_object()) answer.calls.push_back(call_of(*old_form));
}

// Plain text, or parts where there are images.
Ordered content_of(const Message& message) {
  if (message.images.empty()) return message.content;
  Ordered parts = Ordered::array();
  for (const Image& image : message.images) {
    const std::string url = image.url.empty() ? fmt::format("data:{};base64,{}", image.media_type, base64(image.bytes)) : image.url;
    parts.push_back({{"type", "image_url"}, {"image_url", {{"url", url}}}});
  }
  parts.push_back({{"type", "text"}, {"text", message.content}});
  return parts;
}

std::string completion_request(const Request& asked, const std::string& model, const Capabilities& capabilities, bool stream) {
  const Request question = fitted(asked, capabilities.capacity);
  Ordered body{{"model", model}, {"messages", Ordered::array()}};
  for (const Message& message : question.messages) body["messages"].push_back({{"role", message.role}, {"content", content_of(message)}});
  if (capabilities.mode == Mode::kStrictTools || capabilities.mode == Mode::kTools) {
    add_tools(body, question, capabilities);
  } else {
    add_response_format(body, question, capabilities);
    if (capabilities.mode == Mode::kJson && !body["messages"].empty()) {
      std::string& text = body["messages"][0]["content"].get_ref<std::string&>();
      text += plain_json_wish(question.functions[0]);
    }
  }
  if (question.temperature && !capabilities.without.contains("temperature")) body["temperature"] = *question.temperature;
  if (!capabilities.without.contains("seed")) body["seed"] = question.seed;
  body[capabilities.without.contains("max_completion_tokens") ? "max_tokens" : "max_completion_tokens"] = question.max_response_tokens;
  if (stream) {
    body["stream"] = true;
    if (!capabilities.without.contains("stream_options")) body["stream_options"] = {{"include_usage", true}};
  }
  return body.dump(-1, ' ', false, Ordered::error_handler_t::replace);
}

ReadResponse read_completion(const HttpResponse& response) {
  ReadResponse read;
  const std::optional<Json> whole = body_of(response, join_event_stream, read);
  if (!whole) return read;
  const Json& body = *whole;
  const Json* choice = nullptr;
  if (body.is_object() && body.contains("choices") && body["choices"].is_array() && !body["choices"].empty()) choice = &body["choices"][0];
  if (choice == nullptr || !choice->is_object() || !choice->contains("message") || !(*choice)["message"].is_object()) {
    return broken("the answer holds no message");
  }
  read.kind = ReadResponse::Kind::kResponse;
  read_message((*choice)["message"], read.answer);
  read.answer.finish_reason = response.left_off ? "length" : text_of(*choice, "finish_reason");
  const auto usage = body.find("usage");
  if (usage != body.end() && usage->is_object()) {
    read.answer.usage = {count_of(*usage, "prompt_tokens"), count_of(*usage, "completion_tokens"), false};
  } else {
    read.answer.usage.estimated = true;
  }
  return read;
}

class OpenAiProvider final : public Provider {
 public:
  const Facts& facts() const override {
    static constexpr Facts kFacts{"openai",         "https://api.openai.com/v1",      "gpt-4o", "OPENAI_BASE_URL",
                                  "OPENAI_API_KEY", "the address usually ends in /v1"};
    return kFacts;
  }
  std::string url(const Endpoint& endpoint) const override { return endpoint.base_url + "/chat/completions"; }
  std::vector<std::string> headers(const Endpoint& endpoint) const override {
    if (endpoint.key.empty()) return {};
    return {"Authorization: Bearer " + endpoint.key};
  }
  std::string write_request(const Request& asked, const std::string& model, const Capabilities& capabilities, bool stream) const override {
    return completion_request(asked, model, capabilities, stream);
  }
  ReadResponse read_response(const HttpResponse& response) const override { return read_completion(response); }
};

}  // namespace

const Provider& openai_provider() {
  static const OpenAiProvider provider;
  return provider;
}

}  // namespace layoutbox::chat
