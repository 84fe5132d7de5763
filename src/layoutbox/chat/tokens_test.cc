#include "layoutbox/chat/tokens.h"

#include <gmock/gmock.h>

#include <memory>
#include <string>

#include "layoutbox/chat/runaway.h"

namespace layoutbox::chat {
namespace {

// What a tokenizer of 49,000 words (SmolLM2) makes of them.
TEST(Tokens, EstimatesAreNotTooLow) {
  EXPECT_GE(estimated_tokens("Counts are exact. Add nothing that is not asked for."), 12);
  EXPECT_GE(estimated_tokens("bed: 1.6 x 2.08 x 1"), 14);
  EXPECT_GE(estimated_tokens(R"({"id":"bed_1","category":"bed","dims":{"w":1.6,"d":2.08,"h":null}})"), 30);
  EXPECT_GE(estimated_tokens("一个有床和书桌的卧室，台灯放在书桌上。"), 31);
  EXPECT_LE(estimated_tokens("Counts are exact. Add nothing that is not asked for."), 24);
}

TEST(Capacity, IsReadFromTheWordsOfServers) {
  const auto context = [](std::string_view words) { return capacity_told(words, 0).context; };
  EXPECT_EQ(context("request (5889 tokens) exceeds the available context size (4096 tokens), try increasing it"), 4096);
  EXPECT_EQ(context("this model's maximum context length is 8,192 tokens. however, you requested 14267 tokens"), 8192);
  EXPECT_EQ(context("requested tokens (5889) exceed context window of 2048"), 2048);
  EXPECT_EQ(context("prompt contains 40000 tokens, too large for model with 32768 maximum context length"), 32768);
  EXPECT_EQ(context("please reduce the length of the messages"), 0);
  EXPECT_EQ(context("context length is 99999999999999999999999"), 0);
  EXPECT_EQ(capacity_told("", 4096).context, 4096);
  EXPECT_EQ(capacity_told("max_tokens is too large: 8000. this model supports at most 4096 completion tokens", 0).response, 4096);
}

Request question(std::size_t words, int answer) {
  Request made;
  std::string text;
  for (std::size_t i = 0; i < words; ++i) text += "word ";
  made.messages = {{"user", text}};
  made.max_response_tokens = answer;
  return made;
}

TEST(Capacity, AShorterQuestionIsTakenWhereTheLongOneDoesNotFit) {
  Request asked = question(3000, 4000);
  asked.shorter = std::make_shared<const Request>(question(500, 800));
  const auto taken = [&](std::int64_t context, std::int64_t answer = 0, bool cuts = false) {
    return fitted(asked, {context, answer, cuts});
  };
  EXPECT_EQ(taken(0).max_response_tokens, 4000);
  EXPECT_EQ(taken(8000).max_response_tokens, 4000);
  EXPECT_EQ(taken(4096).max_response_tokens, 800);
  EXPECT_LT(taken(1000).max_response_tokens, 500);           // what is left
  EXPECT_EQ(taken(1000, 0, true).max_response_tokens, 800);  // the server cuts by itself
  EXPECT_EQ(taken(0, 1000).max_response_tokens, 1000);
}

TEST(Runaway, SeesWhatRepeatsItself) {
  std::string same, numbered, blanks = "{";
  for (int i = 0; i < 60; ++i) {
    same += "The bedroom should have a bed. ";
    numbered += "{\"id\":\"chair_" + std::to_string(i) + "\",\"category\":\"chair\"},";
  }
  blanks.append(400, ' ');
  EXPECT_TRUE(runs_away("Here it is: " + same));
  EXPECT_TRUE(runs_away(blanks));
  EXPECT_FALSE(runs_away(numbered));
  EXPECT_FALSE(runs_away(same.substr(0, 500)));  // too early to tell
  EXPECT_FALSE(runs_away(""));
}

}  // namespace
}  // namespace layoutbox::chat
