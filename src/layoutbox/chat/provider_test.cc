#include "layoutbox/chat/provider.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>

#include "layoutbox/chat/server_errors.h"

namespace layoutbox::chat {
namespace {

using nlohmann::json;
using testing::HasSubstr;

Request a_request() {
  Request request;
  request.messages = {{"system", "You place furniture."}, {"user", "A bedroom."}};
  request.functions = {{"create_scene", "Hands over the scene.", R"({"type":"object"})", true}};
  return request;
}

Capabilities all_of(const Provider& provider) {
  Capabilities capabilities;
  capabilities.modes = provider.modes();
  capabilities.mode = provider.modes().front();
  return capabilities;
}

json written(const Provider& provider, const Request& request, bool stream = false) {
  return json::parse(provider.write_request(request, "m", all_of(provider), stream));
}

TEST(Providers, are_found_by_name) {
  for (const Provider* provider : providers()) {
    EXPECT_EQ(find_provider(provider->facts().name), provider);
    EXPECT_FALSE(provider->modes().empty());
  }
  EXPECT_EQ(find_provider("nobody"), nullptr);
}

TEST(Providers, each_hears_of_the_function_and_the_text) {
  for (const Provider* provider : providers()) {
    const std::string body = written(*provider, a_request()).dump();
    for (const char* part : {"create_scene", "You place furniture.", "A bedroom.", "\"model\":\"m\""}) EXPECT_THAT(body, HasSubstr(part));
  }
}

TEST(Providers, each_asks_in_each_of_its_modes) {
  for (const Provider* provider : providers()) {
    Capabilities capabilities = all_of(*provider);
    for (const Mode mode : provider->modes()) {
      capabilities.mode = mode;
      const std::string body = provider->write_request(a_request(), "m", capabilities, false);
      EXPECT_TRUE(json::accept(body));
      for (const char* part : {"You place furniture.", "A bedroom.", "object"}) EXPECT_THAT(body, HasSubstr(part)) << name_of(mode);
    }
  }
}

TEST(Providers, each_leaves_out_what_a_server_does_not_take) {
  for (const Provider* provider : providers()) {
    Capabilities capabilities = all_of(*provider);
    capabilities.without = {"temperature", "seed", "tool_choice"};
    const json body = json::parse(provider->write_request(a_request(), "m", capabilities, false));
    for (const std::string& parameter : capabilities.without) EXPECT_FALSE(body.contains(parameter)) << provider->facts().name;
  }
}

TEST(Providers, each_says_that_it_wants_a_stream) {
  for (const Provider* provider : providers()) EXPECT_NE(written(*provider, a_request(), true), written(*provider, a_request()));
}

TEST(Providers, each_sees_images_in_its_own_form) {
  Request request = a_request();
  request.messages.back().images = {{"image/png", "\x89PNG"}};
  const json openai = written(openai_provider(), request)["messages"][1]["content"];
  EXPECT_EQ(openai[0], json::parse(R"({"type":"image_url","image_url":{"url":"data:image/png;base64,iVBORw=="}})"));
  EXPECT_EQ(openai[1], json::parse(R"({"type":"text","text":"A bedroom."})"));
  const json anthropic = written(anthropic_provider(), request)["messages"][0]["content"];
  EXPECT_EQ(anthropic[0], json::parse(R"({"type":"image","source":{"type":"base64","media_type":"image/png","data":"iVBORw=="}})"));
  EXPECT_EQ(anthropic[1], json::parse(R"({"type":"text","text":"A bedroom."})"));
}

TEST(Providers, a_record_names_images_and_does_not_hold_them) {
  Request request = a_request();
  request.messages.back().images = {{"image/png", std::string(3000, 'x')}};
  for (const Provider* provider : providers()) {
    const std::string body = provider->write_request(request, "m", all_of(*provider), false);
    const std::string record = without_images(body, request);
    EXPECT_LT(record.size() + 3000, body.size());
    EXPECT_THAT(record, HasSubstr("[3000 bytes, "));
    EXPECT_TRUE(json::accept(record));
  }
}

TEST(Anthropic, request) {
  const Endpoint endpoint{"https://api.anthropic.com", "m", "sk-ant-1", &anthropic_provider()};
  EXPECT_EQ(anthropic_provider().url(endpoint), "https://api.anthropic.com/v1/messages");
  EXPECT_EQ(anthropic_provider().url({"http://127.0.0.1:1/v1", "m", {}, &anthropic_provider()}), "http://127.0.0.1:1/v1/messages");
  EXPECT_THAT(anthropic_provider().headers(endpoint), testing::ElementsAre("anthropic-version: 2023-06-01", "x-api-key: sk-ant-1"));
  const json body = written(anthropic_provider(), a_request(), true);
  EXPECT_EQ(body["system"], "You place furniture.");
  EXPECT_EQ(body["messages"], json::parse(R"([{"role":"user","content":"A bedroom."}])"));
  EXPECT_EQ(body["tools"][0]["input_schema"], json::parse(R"({"type":"object"})"));
  EXPECT_EQ(body["tool_choice"], json::parse(R"({"type":"tool","name":"create_scene"})"));
  EXPECT_EQ(body["max_tokens"], 8000);
  EXPECT_EQ(body["stream"], true);
  EXPECT_FALSE(body.contains("seed"));
}

TEST(Anthropic, response) {
  const ReadResponse read = anthropic_provider().read_response(
      {200, "application/json", {}, {}, R"({"type":"message","role":"assistant","content":[{"type":"text","text":"Well."},
        {"type":"tool_use","id":"t","name":"create_scene","input":{"room":{}}}],"stop_reason":"tool_use",
        "usage":{"input_tokens":7,"cache_read_input_tokens":100,"output_tokens":3}})"});
  ASSERT_EQ(read.kind, ReadResponse::Kind::kResponse);
  EXPECT_EQ(read.answer.content, "Well.");
  ASSERT_EQ(read.answer.calls.size(), 1u);
  EXPECT_EQ(read.answer.calls[0].name, "create_scene");
  EXPECT_EQ(read.answer.calls[0].arguments, R"({"room":{}})");
  EXPECT_EQ(read.answer.finish_reason, "tool_calls");
  EXPECT_EQ(read.answer.usage.request_tokens, 107);
  EXPECT_EQ(read.answer.usage.response_tokens, 3);
}

TEST(Anthropic, what_is_no_message) {
  const auto kind_of = [](const char* body) { return anthropic_provider().read_response({200, "application/json", {}, {}, body}).kind; };
  EXPECT_EQ(kind_of("{}"), ReadResponse::Kind::kBroken);
  EXPECT_EQ(kind_of("[]"), ReadResponse::Kind::kBroken);
  EXPECT_EQ(kind_of("<html>"), ReadResponse::Kind::kPage);
  EXPECT_EQ(kind_of(R"({"content":[1,{"type":"tool_use"}]})"), ReadResponse::Kind::kResponse);
  EXPECT_EQ(kind_of(R"({"type":"error","error":{"type":"overloaded_error","message":"Overloaded"}})"), ReadResponse::Kind::kError);
}

constexpr const char* kStream =
    "event: message_start\ndata: "
    "{\"type\":\"message_start\",\"message\":{\"content\":[],\"usage\":{\"input_tokens\":7,\"output_tokens\":1}}}\n\n"
    "event: content_block_start\ndata: "
    "{\"type\":\"content_block_start\",\"index\":0,\"content_block\":{\"type\":\"text\",\"text\":\"\"}}\n\n"
    "event: ping\ndata: {\"type\":\"ping\"}\n\n"
    "event: content_block_delta\ndata: "
    "{\"type\":\"content_block_delta\",\"index\":0,\"delta\":{\"type\":\"text_delta\",\"text\":\"Hi\"}}\n\n"
    "event: content_block_start\ndata: "
    "{\"type\":\"content_block_start\",\"index\":1,\"content_block\":{\"type\":\"tool_use\",\"id\":\"t\",\"name\":\"create_scene\","
    "\"input\":{}}}\n\n"
    "event: content_block_delta\ndata: "
    "{\"type\":\"content_block_delta\",\"index\":1,\"delta\":{\"type\":\"input_json_delta\",\"partial_json\":\"{\\\"a\\\"\"}}\n\n"
    "event: content_block_delta\ndata: "
    "{\"type\":\"content_block_delta\",\"index\":1,\"delta\":{\"type\":\"input_json_delta\",\"partial_json\":\":1}\"}}\n\n"
    "event: message_delta\ndata: {\"type\":\"message_delta\",\"delta\":{\"stop_reason\":\"tool_use\"},\"usage\":{\"output_tokens\":15}}\n\n"
    "event: message_stop\ndata: {\"type\":\"message_stop\"}\n\n";

TEST(Anthropic, stream_is_put_together) {
  const ReadResponse read = anthropic_provider().read_response({200, "text/event-stream", {}, {}, kStream});
  ASSERT_EQ(read.kind, ReadResponse::Kind::kResponse);
  EXPECT_EQ(read.answer.content, "Hi");
  ASSERT_EQ(read.answer.calls.size(), 1u);
  EXPECT_EQ(read.answer.calls[0].arguments, R"({"a":1})");
  EXPECT_EQ(read.answer.finish_reason, "tool_calls");
  EXPECT_EQ(read.answer.usage.request_tokens, 7);
  EXPECT_EQ(read.answer.usage.response_tokens, 15);
}

TEST(Anthropic, a_stream_that_is_cut_anywhere_is_never_taken_for_whole) {
  const std::string whole = kStream;
  const std::size_t last = whole.find("event: message_stop");
  for (std::size_t cut = 1; cut < last; ++cut) {
    const ReadResponse read = anthropic_provider().read_response({200, "text/event-stream", {}, {}, whole.substr(0, cut)});
    EXPECT_NE(read.kind, ReadResponse::Kind::kResponse) << cut;
  }
}

TEST(Anthropic, errors) {
  const ServerError error = anthropic_provider().read_error(
      R"({"type":"error","error":{"type":"invalid_request_error","message":"temperature: not supported"}})");
  EXPECT_EQ(error.code, "invalid_request_error");
  EXPECT_TRUE(change_for(400, error, all_of(anthropic_provider()))->without.contains("temperature"));
  const auto limit = change_for(400, {"max_tokens: 64000 > 8192, which is the maximum allowed number of output tokens for m", {}, {}},
                                all_of(anthropic_provider()));
  EXPECT_EQ(limit->capacity.response, 8192);
  const auto longer = change_for(400, {"prompt is too long: 210000 tokens > 200000 maximum", {}, {}}, all_of(anthropic_provider()), 210000);
  EXPECT_LT(longer->capacity.context, 210000);
  EXPECT_EQ(change_for(400, {"tools: bad", {}, {}}, all_of(anthropic_provider()))->mode, Mode::kJson);
}

}  // namespace
}  // namespace layoutbox::chat
