#include <gmock/gmock.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "layoutbox/base/bytes.h"
#include "layoutbox/chat/endpoint.h"
#include "layoutbox/chat/prices.h"
#include "layoutbox/chat/provider.h"
#include "layoutbox/chat/retry.h"
#include "layoutbox/chat/server_errors.h"
#include "layoutbox/chat/spend_limit.h"
#include "layoutbox/chat/sse.h"

namespace layoutbox::chat {
namespace {

using nlohmann::json;

constexpr const char* kStream =
    ": hello\r\n\r\ndata: {\"choices\":[{\"delta\":{\"role\":\"assistant\",\"content\":\"\"}}]}\n\n"
    "event: x\ndata: "
    "{\"choices\":[{\"delta\":{\"tool_calls\":[{\"index\":0,\"function\":{\"name\":\"create_scene\",\"arguments\":\"{\\\"a\\\"\"}}]}}]}\n\n"
    "data: {\"choices\":[{\"delta\":{\"tool_calls\":[{\"index\":0,\"function\":{\"arguments\":\":1}\"}}]}}]}\n\n"
    "data: {\"choices\":[{\"delta\":{},\"finish_reason\":\"tool_calls\"}]}\n\n"
    "data: {\"choices\":[],\"usage\":{\"prompt_tokens\":7,\"completion_tokens\":3}}\n\ndata: [DONE]\n\n";

TEST(Stream, is_put_together) {
  const ReadResponse read = openai_provider().read_response({200, "text/event-stream", {}, {}, kStream});
  ASSERT_EQ(read.kind, ReadResponse::Kind::kResponse);
  ASSERT_EQ(read.answer.calls.size(), 1u);
  EXPECT_EQ(read.answer.calls[0].name, "create_scene");
  EXPECT_EQ(read.answer.calls[0].arguments, "{\"a\":1}");
  EXPECT_EQ(read.answer.finish_reason, "tool_calls");
  EXPECT_EQ(read.answer.usage.request_tokens, 7);
}

TEST(Stream, cut_anywhere_is_never_taken_for_whole) {
  const std::string whole = kStream;
  const std::size_t finished = whole.find("\"finish_reason\":\"tool_calls\"") + 30;
  for (std::size_t cut = 0; cut < finished - 2; ++cut) {
    const ReadResponse read = openai_provider().read_response({200, "text/event-stream", {}, {}, whole.substr(0, cut)});
    EXPECT_NE(read.kind, ReadResponse::Kind::kResponse) << "cut after " << cut << " bytes";
  }
}

TEST(Stream, a_broken_piece_in_the_middle_is_a_fault) {
  std::string broken = kStream;
  broken.replace(broken.find("{\"choices\":[{\"delta\":{\"tool_calls\""), 1, "(");
  EXPECT_EQ(openai_provider().read_response({200, "text/event-stream", {}, {}, broken}).kind, ReadResponse::Kind::kBroken);
}

TEST(Response, forms_of_content) {
  const auto content_of = [](const std::string& message) {
    return openai_provider()
        .read_response({200, "application/json", {}, {}, R"({"choices":[{"message":)" + message + R"(,"finish_reason":"stop"}]})"})
        .answer;
  };
  EXPECT_EQ(content_of(R"({"content":[{"type":"text","text":"a"},{"type":"text","text":"b"}]})").content, "ab");
  EXPECT_EQ(content_of(R"({"content":null,"refusal":"no"})").refusal, "no");
  EXPECT_TRUE(content_of(R"({"content":"x"})").usage.estimated);
}

TEST(Retry, doubles_and_never_undercuts_the_server) {
  for (std::uint64_t seed = 1; seed < 50; ++seed) {
    RetryPolicy policy({.max_retries = 5}, seed);
    double doubled = 0.5;
    for (int i = 0; i < 5; ++i, doubled *= 2) {
      const auto wait = policy.wait_after(TryOutcome::kBusy, std::nullopt, 0);
      ASSERT_TRUE(wait);
      EXPECT_GE(*wait, doubled * 0.75);
      EXPECT_LE(*wait, doubled * 1.25);
    }
    EXPECT_FALSE(policy.wait_after(TryOutcome::kBusy, std::nullopt, 0));
    EXPECT_GT(*RetryPolicy({}, seed).wait_after(TryOutcome::kBusy, 7.0, 0), 7.0);
  }
}

TEST(Retry, ends) {
  EXPECT_FALSE(RetryPolicy({}, 1).wait_after(TryOutcome::kFinal, std::nullopt, 0));
  EXPECT_FALSE(RetryPolicy({.total_s = 60}, 1).wait_after(TryOutcome::kBusy, 61.0, 0));
  EXPECT_FALSE(RetryPolicy({.total_s = 60}, 1).wait_after(TryOutcome::kBusy, std::nullopt, 60));
  RetryPolicy unclear({}, 1);
  EXPECT_TRUE(unclear.wait_after(TryOutcome::kUnclear, std::nullopt, 0));
  EXPECT_TRUE(unclear.wait_after(TryOutcome::kUnclear, std::nullopt, 0));
  EXPECT_FALSE(unclear.wait_after(TryOutcome::kUnclear, std::nullopt, 0));
}

TEST(Key, shows_nowhere) {
  const Endpoint endpoint{"https://x/v1", "m", "sk-12345"};
  EXPECT_EQ(without_key("a sk-12345 b sk-12345", endpoint), "a [key] b [key]");
  EXPECT_EQ(without_key("[key] [key]", {"https://x/v1", "m", "[key] [k"}), "[key]ey]") << "what stands instead is not read again";
}

TEST(Key, shows_neither_broken_nor_in_base64) {
  const Endpoint endpoint{"https://x/v1", "m", "sk-0123456789abcdef"};
  EXPECT_EQ(without_key("a sk-0123\n  456789abcdef b", endpoint), "a [key] b");
  for (const std::string before : {"", "x", "xy", "Bearer "}) {
    const std::string shown = without_key(base64(before + endpoint.key + ":pass"), endpoint);
    EXPECT_THAT(shown, testing::HasSubstr("[key]")) << before;
  }
  EXPECT_EQ(without_key("skill 0123-4567", endpoint), "skill 0123-4567");
}

TEST(Key, shows_neither_split_by_signs_nor_in_pieces) {
  const Endpoint endpoint{"https://x/v1", "m", "sk-0123456789abcdef_GHIJ+klmn"};
  for (const std::string shown : {"sk-0123-4567-89ab-cdef-GHIJ-klmn", "s k 0 1 2 3 4 5 6 7 8 9 a b c d e f G H I J k l m n",
                                  "sk0123\n456789\r\n\tabcdef/GHIJ.klmn", "sk\u00a001234\u200b56789abcdef\u2010GHIJklmn"}) {
    EXPECT_EQ(without_key("a <" + shown + "> b", endpoint), "a <[key]> b") << shown;
  }
  EXPECT_EQ(without_key("begins with sk-0123456789ab, ends in cdef_GHIJ+klmn", endpoint), "begins with [key], ends in [key]");
  EXPECT_EQ(without_key("begins with sk-0123, ends in klmn", endpoint), "begins with sk-0123, ends in klmn") << "servers say so";
  EXPECT_EQ(without_key("{\"x\": [0, 1, 2, 3, 4, 5, 6]}", endpoint), "{\"x\": [0, 1, 2, 3, 4, 5, 6]}");
}

TEST(Key, that_is_no_secret_is_left_alone) {
  EXPECT_EQ(without_key("a key in [key]", {"http://127.0.0.1/v1", "m", "k"}), "a key in [key]");
}

TEST(OneLine, cuts_between_characters) {
  EXPECT_EQ(one_line("a\n\tb"), "a b");
  EXPECT_EQ(one_line("ééé", 3), "é…");  // at most three bytes
}

TEST(Prices, by_the_longest_name) {
  EXPECT_EQ(Prices::builtin().find("gpt-4o-mini-2024-07-18")->request, 0.15);
  EXPECT_EQ(Prices::builtin().find("openai/gpt-4o")->request, 2.5);
  EXPECT_FALSE(Prices::builtin().find("gpt-4omega"));
  EXPECT_EQ(Prices::builtin().find("claude-sonnet-4-5-20250929")->response, 15);
}

TEST(Prices, say_when_they_were_looked_up) {
  for (const char* model : {"gpt-4o", "o3", "claude-haiku-4-5"}) EXPECT_EQ(Prices::builtin().find(model)->as_of.size(), 7u) << model;
}

TEST(Ways, where_a_model_talks_instead) {
  Response words;
  words.content = "Here is your room.";
  Capabilities capabilities;
  capabilities = *change_for(words, capabilities);
  EXPECT_EQ(capabilities.mode, Mode::kStrictTools);
  EXPECT_TRUE(capabilities.without.contains("named_tool"));
  for (const Mode expected : {Mode::kJsonSchema, Mode::kJson}) {
    capabilities = *change_for(words, capabilities);
    EXPECT_EQ(capabilities.mode, expected);
  }
  EXPECT_FALSE(change_for(words, capabilities));
  Response call;
  call.calls = {{"create_scene", "{"}};
  EXPECT_FALSE(change_for(call, Capabilities{}));
}

TEST(SpendLimit, sets_aside_and_takes_back) {
  SpendLimit spend_limit;
  spend_limit.max_cost = 1.0;
  EXPECT_EQ(spend_limit.set_aside({0.6, 10}, nullptr), SpendLimit::Draw::kDone);
  EXPECT_EQ(spend_limit.set_aside({1.1, 10}, nullptr), SpendLimit::Draw::kTooDear);
  const std::atomic<bool> stopped{true};
  EXPECT_EQ(spend_limit.set_aside({0.6, 10}, &stopped), SpendLimit::Draw::kStopped);  // it would have to wait for the first
  std::thread other([&] { spend_limit.settle({0.6, 10}, {0.1, 7}); });
  EXPECT_EQ(spend_limit.set_aside({0.6, 10}, nullptr), SpendLimit::Draw::kDone);
  other.join();
  spend_limit.settle({0.6, 10}, {0.6, 5});
  EXPECT_DOUBLE_EQ(spend_limit.spent().cost, 0.7);
  EXPECT_EQ(spend_limit.spent().tokens, 12);
  EXPECT_EQ(spend_limit.set_aside({0.4, 10}, nullptr), SpendLimit::Draw::kTooDear);
}

TEST(Ways, from_the_best_to_the_last) {
  Capabilities capabilities;
  for (const Mode expected : {Mode::kTools, Mode::kJsonSchema, Mode::kJson}) {
    const auto changed = change_for(400, {"bad request", {}, {}}, capabilities);
    ASSERT_TRUE(changed);
    EXPECT_EQ(changed->mode, expected);
    capabilities = *changed;
  }
  capabilities.known = true;
  EXPECT_FALSE(change_for(400, {"bad request", {}, {}}, capabilities));
  EXPECT_FALSE(change_for(400, {"maximum context length is 2048", {}, {}}, Capabilities{}));
  EXPECT_FALSE(change_for(401, {"tools", {}, {}}, Capabilities{}));
}

}  // namespace
}  // namespace layoutbox::chat
