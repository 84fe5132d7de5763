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
#include "layoutbox/chat/provider.h"
#include "layoutbox/chat/retry.h"
#include "layoutbox/chat/spend_limit.h"

namespace layoutbox::chat {

struct ChatOptions {
  Endpoint endpoint;
  RetryOptions retry;
  double request_limit_s = 300;     // of one request. DEFAULT: 300, for models on slow machines
  bool stream = false;              // ask for the answer in pieces; one that only repeats itself is then left off
  bool plain_json = false;          // never by function calling, the schema in the text. DEFAULT: false, the best that the server has
  std::int64_t context_tokens = 0;  // what the model can hold, question and answer together; 0: found out
  // Where answers and what is known of servers are kept. Empty: nowhere.
  std::filesystem::path cache = cache_folder();
  bool use_cached_answers = true;
  Prices prices = Prices::builtin();
  // The limits of cost and tokens: of all clients whose options are copies of these. May be null, for none.
  std::shared_ptr<SpendLimit> spend_limit = std::make_shared<SpendLimit>();
  const std::atomic<bool>* stop = nullptr;
  std::function<void(const std::string&)> on_wait;  // told before each wait: "the server is busy (503), again in 2 s"
};

class ChatClient {
 public:
  explicit ChatClient(ChatOptions options);

  // Errors: kNetwork (no key, no server, refused, given up after retries: the reason and what to do), kNotFound (the limits of cost or
  // tokens would be passed), kInterrupted. Cached answers need neither key nor network.
  Result<Response> ask(const Request& question);

  // What would be sent, without sending it: method and address, headers (the key only as set or not), body.
  std::string describe_request(const Request& question) const;

  // So far.
  Usage usage() const { return usage_; }
  std::optional<double> cost() const { return cost_known_ ? std::optional(cost_) : std::nullopt; }
  // The month in which the price was looked up; empty where none is known or said.
  std::string price_date() const;
  const Endpoint& endpoint() const { return options_.endpoint; }

 private:
  struct Exchange;
  std::optional<Response> from_cache(const Request& question) const;
  Result<Response> from_server(const Request& question);
  Result<Response> exchange(const Request& question, Exchange& so_far);
  Result<Amount> set_aside(const Request& question) const;
  void count(Response& answer);
  bool adapt(int status, const ServerError& error, const Request& question);
  HttpRequest http_request(const Exchange& so_far) const;
  Status wait(double seconds, const std::string& why) const;
  std::string safe(std::string text) const { return without_key(std::move(text), options_.endpoint); }
  std::string safe_json(std::string text) const;
  ServerError safe(ServerError error) const;
  bool clean(Response& answer) const;
  const Provider& provider() const { return *options_.endpoint.provider; }
  std::string url() const { return provider().url(options_.endpoint); }
  std::string written(const Request& request, const Capabilities& capabilities) const {
    return provider().write_request(request, options_.endpoint.model, capabilities, options_.stream);
  }
  // As it is kept and shown.
  std::string recorded(std::string body, const Request& request) const { return safe(without_images(std::move(body), request)); }

  ChatOptions options_;
  ResponseCache cache_;
  Capabilities capabilities_;
  HttpClient http_;
  Usage usage_;
  double cost_ = 0;
  bool cost_known_ = true;
};

}  // namespace layoutbox::chat
