#include <gmock/gmock.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "layoutbox/chat/endpoint.h"
#include "layoutbox/chat/prices.h"
#include "layoutbox/chat/purse.h"
#include "layoutbox/chat/retry.h"
#include "layoutbox/chat/server_errors.h"
#include "layoutbox/chat/sse.h"
#include "layoutbox/chat/wire.h"

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
  const ReadAnswer read = read_answer({200, "text/event-stream", {}, {}, kStream});
  ASSERT_EQ(read.kind, ReadAnswer::Kind::kAnswer);
  ASSERT_EQ(read.answer.calls.size(), 1u);
  EXPECT_EQ(read.answer.calls[0].name, "create_scene");
  EXPECT_EQ(read.answer.calls[0].arguments, "{\"a\":1}");
  EXPECT_EQ(read.answer.finish_reason, "tool_calls");
  EXPECT_EQ(read.answer.usage.question_tokens, 7);
}

TEST(Stream, cut_anywhere_is_never_taken_for_whole) {
  const std::string whole = kStream;
  const std::size_t finished = whole.find("\"finish_reason\":\"tool_calls\"") + 30;
  for (std::size_t cut = 0; cut < finished - 2; ++cut) {
    const ReadAnswer read = read_answer({200, "text/event-stream", {}, {}, whole.substr(0, cut)});
    EXPECT_NE(read.kind, ReadAnswer::Kind::kAnswer) << "cut after " << cut << " bytes";
  }
}

TEST(Stream, a_broken_piece_in_the_middle_is_a_fault) {
  std::string broken = kStream;
  broken.replace(broken.find("{\"choices\":[{\"delta\":{\"tool_calls\""), 1, "(");
  EXPECT_EQ(read_answer({200, "text/event-stream", {}, {}, broken}).kind, ReadAnswer::Kind::kBroken);
}

TEST(Answer, forms_of_content) {
  const auto content_of = [](const std::string& message) {
    return read_answer({200, "application/json", {}, {}, R"({"choices":[{"message":)" + message + R"(,"finish_reason":"stop"}]})"}).answer;
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
      const auto wait = policy.wait_after(Outcome::kBusy, std::nullopt, 0);
      ASSERT_TRUE(wait);
      EXPECT_GE(*wait, doubled * 0.75);
      EXPECT_LE(*wait, doubled * 1.25);
    }
    EXPECT_FALSE(policy.wait_after(Outcome::kBusy, std::nullopt, 0));
    EXPECT_GT(*RetryPolicy({}, seed).wait_after(Outcome::kBusy, 7.0, 0), 7.0);
  }
}

TEST(Retry, ends) {
  EXPECT_FALSE(RetryPolicy({}, 1).wait_after(Outcome::kFinal, std::nullopt, 0));
  EXPECT_FALSE(RetryPolicy({.total_s = 60}, 1).wait_after(Outcome::kBusy, 61.0, 0));
  EXPECT_FALSE(RetryPolicy({.total_s = 60}, 1).wait_after(Outcome::kBusy, std::nullopt, 60));
  RetryPolicy unclear({}, 1);
  EXPECT_TRUE(unclear.wait_after(Outcome::kUnclear, std::nullopt, 0));
  EXPECT_TRUE(unclear.wait_after(Outcome::kUnclear, std::nullopt, 0));
  EXPECT_FALSE(unclear.wait_after(Outcome::kUnclear, std::nullopt, 0));
}

TEST(Key, shows_nowhere) {
  const Endpoint endpoint{"https://x/v1", "m", "sk-12345"};
  EXPECT_EQ(without_key("a sk-12345 b sk-12345", endpoint), "a [key] b [key]");
  EXPECT_EQ(without_key("[key] [key]", {"https://x/v1", "m", "[key] [k"}), "[key]ey]") << "what stands instead is not read again";
}

TEST(Key, that_is_no_secret_is_left_alone) {
  EXPECT_EQ(without_key("a key in [key]", {"http://127.0.0.1/v1", "m", "k"}), "a key in [key]");
}

TEST(OneLine, cuts_between_characters) {
  EXPECT_EQ(one_line("a\n\tb"), "a b");
  EXPECT_EQ(one_line("ééé", 3), "éé…");
}

TEST(Prices, by_the_longest_name) {
  EXPECT_EQ(Prices::builtin().find("gpt-4o-mini-2024-07-18")->question, 0.15);
  EXPECT_EQ(Prices::builtin().find("openai/gpt-4o")->question, 2.5);
  EXPECT_FALSE(Prices::builtin().find("gpt-4omega"));
}

TEST(Ways, where_a_model_talks_instead) {
  Answer words;
  words.content = "Here is your room.";
  Habits habits;
  habits = *change_for(words, habits);
  EXPECT_EQ(habits.mode, Mode::kStrictTools);
  EXPECT_TRUE(habits.without.contains("named_tool"));
  for (const Mode expected : {Mode::kJsonSchema, Mode::kJson}) {
    habits = *change_for(words, habits);
    EXPECT_EQ(habits.mode, expected);
  }
  EXPECT_FALSE(change_for(words, habits));
  Answer call;
  call.calls = {{"create_scene", "{"}};
  EXPECT_FALSE(change_for(call, Habits{}));
}

TEST(Purse, sets_aside_and_takes_back) {
  Purse purse;
  purse.max_cost = 1.0;
  EXPECT_EQ(purse.set_aside({0.6, 10}, nullptr), Purse::Draw::kDone);
  EXPECT_EQ(purse.set_aside({1.1, 10}, nullptr), Purse::Draw::kTooDear);
  const std::atomic<bool> stopped{true};
  EXPECT_EQ(purse.set_aside({0.6, 10}, &stopped), Purse::Draw::kStopped);  // it would have to wait for the first
  std::thread other([&] { purse.settle({0.6, 10}, {0.1, 7}); });
  EXPECT_EQ(purse.set_aside({0.6, 10}, nullptr), Purse::Draw::kDone);
  other.join();
  purse.settle({0.6, 10}, {0.6, 5});
  EXPECT_DOUBLE_EQ(purse.spent().cost, 0.7);
  EXPECT_EQ(purse.spent().tokens, 12);
  EXPECT_EQ(purse.set_aside({0.4, 10}, nullptr), Purse::Draw::kTooDear);
}

TEST(Ways, from_the_best_to_the_last) {
  Habits habits;
  for (const Mode expected : {Mode::kTools, Mode::kJsonSchema, Mode::kJson}) {
    const auto changed = change_for(400, {"bad request", {}, {}}, habits);
    ASSERT_TRUE(changed);
    EXPECT_EQ(changed->mode, expected);
    habits = *changed;
  }
  habits.known = true;
  EXPECT_FALSE(change_for(400, {"bad request", {}, {}}, habits));
  EXPECT_FALSE(change_for(400, {"maximum context length is 2048", {}, {}}, Habits{}));
  EXPECT_FALSE(change_for(401, {"tools", {}, {}}, Habits{}));
}

}  // namespace
}  // namespace layoutbox::chat
