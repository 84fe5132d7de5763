// Anthropic's Messages, version 2023-06-01.
#include <map>
#include <nlohmann/json.hpp>

#include "layoutbox/chat/provider_json.h"
#include "layoutbox/chat/sse.h"

namespace layoutbox::chat {
namespace {

using Json = nlohmann::json;
using Ordered = nlohmann::ordered_json;

Ordered blocks_of(const Message& message) {
  if (message.images.empty()) return message.content;
  Ordered blocks = Ordered::array();
  for (const Image& image : message.images) {
    blocks.push_back(
        {{"type", "image"},
         {"source", image.url.empty() ? Ordered{{"type", "base64"}, {"media_type", image.media_type}, {"data", base64(image.bytes)}}
                                      : Ordered{{"type", "url"}, {"url", image.url}}}});
  }
  blocks.push_back({{"type", "text"}, {"text", message.content}});
  return blocks;
}

void add_functions(Ordered& body, const Request& request, const Capabilities& capabilities) {
  for (const Function& function : request.functions) {
    body["tools"].push_back({{"name", function.name}, {"description", function.description}, {"input_schema", schema_of(function)}});
  }
  if (capabilities.without.contains("tool_choice")) return;
  if (request.functions.size() == 1) {
    body["tool_choice"] = {{"type", "tool"}, {"name", request.functions[0].name}};
  } else {
    body["tool_choice"] = {{"type", "any"}};
  }
}

// "stop_reason" in the words of the other form, which the program uses.
std::string finish_reason_of(const std::string& stop_reason) {
  static const std::map<std::string, std::string, std::less<>> kWords = {{"end_turn", "stop"},
                                                                         {"stop_sequence", "stop"},
                                                                         {"tool_use", "tool_calls"},
                                                                         {"max_tokens", "length"},
                                                                         {"model_context_window_exceeded", "length"},
                                                                         {"refusal", "content_filter"}};
  const auto found = kWords.find(stop_reason);
  return found != kWords.end() ? found->second : stop_reason;
}

void read_block(const Json& block, Response& response) {
  const std::string type = text_of(block, "type");
  if (type == "text") response.content += text_of(block, "text");
  if (type != "tool_use") return;
  const auto input = block.find("input");
  if (input == block.end()) return;
  response.calls.push_back({text_of(block, "name"), input->is_string() ? input->get<std::string>() : input->dump()});
}

Usage usage_of(const Json& body) {
  const auto usage = body.find("usage");
  if (usage == body.end() || !usage->is_object()) return {0, 0, true};
  const std::int64_t read =
      count_of(*usage, "input_tokens") + count_of(*usage, "cache_creation_input_tokens") + count_of(*usage, "cache_read_input_tokens");
  return {read, count_of(*usage, "output_tokens"), false};
}

void add_piece(Json& block, const Json& delta) {
  if (const std::string text = text_of(delta, "text"); !text.empty()) block["text"] = text_of(block, "text") + text;
  const std::string json = text_of(delta, "partial_json");
  if (json.empty()) return;
  if (!block.contains("input") || !block["input"].is_string()) block["input"] = "";  // what came with the start is empty
  block["input"].get_ref<std::string&>() += json;
}

// Events of a stream, put together as if it had not been streamed.
class EventReader {
 public:
  // False where the stream is over.
  bool take(const Json& event) {
    const std::string type = text_of(event, "type");
    if (type == "error") {
      streamed_.message = event;
      return false;
    }
    if (type == "message_start" && event.contains("message") && event["message"].is_object()) streamed_.message.update(event["message"]);
    if (type == "content_block_start" && event.contains("content_block")) block_of(event) = event["content_block"];
    if (type == "content_block_delta" && event.contains("delta") && event["delta"].is_object()) add_piece(block_of(event), event["delta"]);
    if (type == "message_delta") end_message(event);
    if (type == "message_stop") streamed_.ended = true;
    return type != "message_stop";
  }

  StreamedResponse result() {
    if (streamed_.message.contains("error")) return std::move(streamed_);
    Json content = Json::array();
    for (auto& [index, block] : blocks_) content.push_back(std::move(block));
    streamed_.message["content"] = std::move(content);
    return std::move(streamed_);
  }

 private:
  Json& block_of(const Json& event) {
    constexpr std::int64_t kMostBlocks = 64;
    Json& block = blocks_[std::min(count_of(event, "index"), kMostBlocks)];
    if (!block.is_object()) block = Json::object();
    return block;
  }

  void end_message(const Json& event) {
    if (event.contains("delta") && event["delta"].is_object()) streamed_.message.update(event["delta"]);
    if (!event.contains("usage") || !event["usage"].is_object()) return;
    Json& usage = streamed_.message["usage"];
    if (!usage.is_object()) usage = Json::object();
    usage.update(event["usage"]);  // the tokens that came in were told at the start
  }

  StreamedResponse streamed_{Json::object(), false, true};
  std::map<std::int64_t, Json> blocks_;
};

StreamedResponse join_messages_stream(std::string_view body) {
  EventReader reader;
  bool broken_before = false, valid = true;
  for (const std::string& text : events_of(body)) {
    valid = valid && !broken_before;  // it went on after a piece that is no JSON, so that was not where it was cut
    const Json event = Json::parse(text, nullptr, false);
    broken_before = !event.is_object();
    if (!broken_before && !reader.take(event)) break;
  }
  StreamedResponse streamed = reader.result();
  streamed.valid = valid;
  return streamed;
}

class AnthropicProvider final : public Provider {
 public:
  const Facts& facts() const override {
    static constexpr Facts kFacts{"anthropic",          "https://api.anthropic.com", "claude-sonnet-4-5",
                                  "ANTHROPIC_BASE_URL", "ANTHROPIC_API_KEY",         "the address is without /v1/messages"};
    return kFacts;
  }
  std::span<const Mode> modes() const override {
    static constexpr Mode kModes[] = {Mode::kTools, Mode::kJson};
    return kModes;
  }
  // With or without /v1, since the other form's addresses have it.
  std::string url(const Endpoint& endpoint) const override {
    return endpoint.base_url + (endpoint.base_url.ends_with("/v1") ? "/messages" : "/v1/messages");
  }
  std::vector<std::string> headers(const Endpoint& endpoint) const override {
    std::vector<std::string> headers = {"anthropic-version: 2023-06-01"};
    if (!endpoint.key.empty()) headers.push_back("x-api-key: " + endpoint.key);
    return headers;
  }

  std::string write_request(const Request& asked, const std::string& model, const Capabilities& capabilities, bool stream) const override {
    const Request request = fitted(asked, capabilities.capacity);
    Ordered body{{"model", model}, {"max_tokens", request.max_response_tokens}};
    std::string system;
    Ordered messages = Ordered::array();
    for (const Message& message : request.messages) {
      if (message.role == "system") {
        system += (system.empty() ? "" : "\n\n") + message.content;
      } else {
        messages.push_back({{"role", message.role}, {"content", blocks_of(message)}});
      }
    }
    if (capabilities.mode == Mode::kJson) system += plain_json_wish(request.functions[0]);
    if (!system.empty()) body["system"] = system;
    body["messages"] = std::move(messages);
    if (capabilities.mode != Mode::kJson) add_functions(body, request, capabilities);
    if (request.temperature && !capabilities.without.contains("temperature"))
      body["temperature"] = *request.temperature;  // it knows no seed
    if (stream) body["stream"] = true;
    return body.dump(-1, ' ', false, Ordered::error_handler_t::replace);
  }

  ReadResponse read_response(const HttpResponse& response) const override {
    ReadResponse read;
    const std::optional<Json> body = body_of(response, join_messages_stream, read);
    if (!body) return read;
    const auto content = body->is_object() ? body->find("content") : body->end();
    if (content == body->end() || !content->is_array()) return broken("the answer holds no message");
    read.kind = ReadResponse::Kind::kResponse;
    for (const Json& block : *content) {
      if (block.is_object()) read_block(block, read.answer);
    }
    read.answer.finish_reason = response.left_off ? "length" : finish_reason_of(text_of(*body, "stop_reason"));
    if (read.answer.finish_reason == "content_filter") {
      read.answer.refusal = read.answer.content.empty() ? "it gives no reason" : read.answer.content;
    }
    read.answer.usage = usage_of(*body);
    return read;
  }
};

}  // namespace

const Provider& anthropic_provider() {
  static const AnthropicProvider provider;
  return provider;
}

}  // namespace layoutbox::chat
