#include "layoutbox/chat/wire.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "layoutbox/chat/endpoint.h"
#include "layoutbox/chat/sse.h"

namespace layoutbox::chat {
namespace {

using Json = nlohmann::json;
using Ordered = nlohmann::ordered_json;

// Schemas are written by this program, so they parse.
Ordered schema_of(const Function& function) { return Ordered::parse(function.parameters, nullptr, false); }

Ordered tool_of(const Function& function, Mode mode) {
  Ordered description{{"name", function.name}, {"description", function.description}};
  if (mode == Mode::kStrictTools && function.strict) description["strict"] = true;
  description["parameters"] = schema_of(function);
  return {{"type", "function"}, {"function", std::move(description)}};
}

void add_tools(Ordered& body, const Question& question, const Habits& habits) {
  for (const Function& function : question.functions) body["tools"].push_back(tool_of(function, habits.mode));
  if (habits.without.contains("tool_choice")) return;
  // By name it is one call and no other; "required" is for the choice between two, and for servers (llama.cpp) that know words alone.
  if (question.functions.size() == 1 && habits.mode == Mode::kStrictTools && !habits.without.contains("named_tool")) {
    body["tool_choice"] = {{"type", "function"}, {"function", {{"name", question.functions[0].name}}}};
  } else {
    body["tool_choice"] = "required";
  }
}

void add_response_format(Ordered& body, const Question& question, const Habits& habits) {
  if (habits.without.contains("response_format")) return;
  if (habits.mode == Mode::kJson) {
    body["response_format"] = {{"type", "json_object"}};
    return;
  }
  const Function& function = question.functions[0];
  body["response_format"] = {{"type", "json_schema"},
                             {"json_schema", {{"name", function.name}, {"strict", function.strict}, {"schema", schema_of(function)}}}};
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

Call call_of(const Json& function) {
  Call call{text_of(function, "name"), {}};
  const auto arguments = function.find("arguments");
  if (arguments == function.end()) return call;
  call.arguments = arguments->is_string() ? arguments->get<std::string>() : arguments->dump();
  return call;
}

void read_message(const Json& message, Answer& answer) {
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

std::int64_t count_of(const Json& usage, const char* key) {
  const auto found = usage.find(key);
  constexpr double kMost = 1e12;  // beyond is nonsense, and no integer
  return found != usage.end() && found->is_number() ? static_cast<std::int64_t>(std::clamp(found->get<double>(), 0.0, kMost)) : 0;
}

bool is_page(const HttpResponse& response) {
  const std::size_t begin = response.body.find_first_not_of(" \t\r\n");
  return begin != std::string::npos && response.body[begin] == '<';
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
    error.context = count_of(*object, "n_ctx");
    if (error.message.empty()) error.message = object->dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  return error;
}

ReadAnswer broken(std::string why) {
  ReadAnswer read;
  read.error.message = std::move(why);
  return read;
}

}  // namespace

const char* name_of(Mode mode) {
  switch (mode) {
    case Mode::kStrictTools: return "strict function";
    case Mode::kTools: return "function";
    case Mode::kJsonSchema: return "JSON schema";
    case Mode::kJson: return "plain JSON";
  }
  return "";
}

std::string write_request(const Question& asked, const std::string& model, const Habits& habits, bool stream) {
  const Question question = fitted(asked, habits.capacity);
  Ordered body{{"model", model}, {"messages", Ordered::array()}};
  for (const Message& message : question.messages) body["messages"].push_back({{"role", message.role}, {"content", message.content}});
  if (habits.mode == Mode::kStrictTools || habits.mode == Mode::kTools) {
    add_tools(body, question, habits);
  } else {
    add_response_format(body, question, habits);
    if (habits.mode == Mode::kJson && !body["messages"].empty()) {
      std::string& text = body["messages"][0]["content"].get_ref<std::string&>();
      text += "\n\nAnswer with one JSON object and nothing else. It follows this JSON Schema:\n" + schema_of(question.functions[0]).dump();
    }
  }
  if (!habits.without.contains("temperature")) body["temperature"] = question.temperature;
  if (!habits.without.contains("seed")) body["seed"] = question.seed;
  body[habits.without.contains("max_completion_tokens") ? "max_tokens" : "max_completion_tokens"] = question.max_answer_tokens;
  if (stream) {
    body["stream"] = true;
    if (!habits.without.contains("stream_options")) body["stream_options"] = {{"include_usage", true}};
  }
  return body.dump(-1, ' ', false, Ordered::error_handler_t::replace);
}

ServerError read_error(std::string_view body) {
  const Json json = Json::parse(body, nullptr, false);
  if (json.is_object()) return error_from(json);
  const std::size_t begin = body.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  return body[begin] == '<' ? ServerError{"a web page", {}, {}} : ServerError{one_line(body.substr(begin), 200), {}, {}};
}

ReadAnswer read_answer(const HttpResponse& response) {
  if (response.body.find_first_not_of(" \t\r\n") == std::string::npos) return broken("the answer is empty");
  Json body;
  bool stream_ended = true;
  if (is_event_stream(response.content_type, response.body)) {
    StreamedAnswer streamed = join_event_stream(response.body);
    if (!streamed.valid) return broken("a piece of the streamed answer is no JSON");
    body = std::move(streamed.message);
    stream_ended = streamed.ended;
  } else {
    body = Json::parse(response.body, nullptr, false);
    if (body.is_discarded() && is_page(response)) {
      ReadAnswer read;
      read.kind = ReadAnswer::Kind::kPage;
      return read;
    }
    if (body.is_discarded()) return broken("the answer is broken: no JSON in UTF-8");
  }
  ReadAnswer read;
  if (body.is_object() && body.contains("error") && !body["error"].is_null()) {
    read.kind = ReadAnswer::Kind::kError;
    read.error = error_from(body);
    return read;
  }
  if (!stream_ended && !response.left_off) {
    read.kind = ReadAnswer::Kind::kCut;
    return read;
  }
  const Json* choice = nullptr;
  if (body.is_object() && body.contains("choices") && body["choices"].is_array() && !body["choices"].empty()) choice = &body["choices"][0];
  if (choice == nullptr || !choice->is_object() || !choice->contains("message") || !(*choice)["message"].is_object()) {
    return broken("the answer holds no message");
  }
  read.kind = ReadAnswer::Kind::kAnswer;
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

}  // namespace layoutbox::chat
