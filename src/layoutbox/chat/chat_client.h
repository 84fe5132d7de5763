// Asks a model: finds out how its server wants to be asked, asks again where that helps, keeps answers, counts tokens and money.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "layoutbox/base/result.h"
#include "layoutbox/chat/cache_folder.h"
#include "layoutbox/chat/chat.h"
#include "layoutbox/chat/endpoint.h"
#include "layoutbox/chat/prices.h"
#include "layoutbox/chat/purse.h"
#include "layoutbox/chat/retry.h"

namespace layoutbox::chat {

struct ChatOptions {
  Endpoint endpoint;
  RetryOptions retry;
  double request_limit_s = 300;     // of one request. DEFAULT: 300, for models on slow machines
  bool stream = false;              // ask for the answer in pieces; one that only repeats itself is then left off
  std::int64_t context_tokens = 0;  // what the model can hold, question and answer together; 0: found out
  // Where answers and what is known of servers are kept. Empty: nowhere.
  std::filesystem::path cache = cache_folder();
  bool use_cached_answers = true;
  Prices prices = Prices::builtin();
  // The limits of cost and tokens: of all clients whose options are copies of these. May be null, for none.
  std::shared_ptr<Purse> purse = std::make_shared<Purse>();
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const std::string&)> on_wait;  // told before each wait: "the server is busy (503), again in 2 s"
};

class ChatClient {
 public:
  explicit ChatClient(ChatOptions options);

  // Errors: kNetwork (no key, no server, refused, given up after retries: the reason and what to do), kNotFound (the limits of cost or
  // tokens would be passed), kInterrupted. Cached answers need neither key nor network.
  Result<Answer> ask(const Question& question);

  // What would be sent, without sending it: method and address, headers (the key only as set or not), body.
  std::string describe_request(const Question& question) const;

  // So far.
  Usage usage() const { return usage_; }
  std::optional<double> cost() const { return cost_known_ ? std::optional(cost_) : std::nullopt; }
  const Endpoint& endpoint() const { return options_.endpoint; }

 private:
  struct Exchange;
  std::optional<Answer> from_cache(const Question& question) const;
  Result<Answer> from_server(const Question& question);
  Result<Answer> exchange(const Question& question, Exchange& so_far);
  Result<Amount> set_aside(const Question& question) const;
  void count(Answer& answer);
  bool adapt(int status, const ServerError& error, const Question& question);
  HttpRequest http_request(const Exchange& so_far) const;
  Status wait(double seconds, const std::string& why) const;
  std::string safe(std::string text) const { return without_key(std::move(text), options_.endpoint); }
  std::string url() const { return options_.endpoint.base_url + "/chat/completions"; }

  ChatOptions options_;
  AnswerCache cache_;
  Habits habits_;
  HttpClient http_;
  Usage usage_;
  double cost_ = 0;
  bool cost_known_ = true;
};

}  // namespace layoutbox::chat
