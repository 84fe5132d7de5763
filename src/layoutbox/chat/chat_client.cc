#include "layoutbox/chat/chat_client.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "layoutbox/chat/runaway.h"
#include "layoutbox/chat/server_errors.h"
#include "layoutbox/chat/sse.h"
#include "layoutbox/chat/tokens.h"

namespace layoutbox::chat {
namespace {

using Clock = std::chrono::steady_clock;

constexpr Mode kPlainJson[] = {Mode::kJson};
constexpr int kMostAdaptations = 8;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

void fill_estimates(const Request& question, Response& answer) {
  if (!answer.usage.estimated) return;
  std::string text = answer.content;
  for (const Call& call : answer.calls) text += call.arguments;
  answer.usage.request_tokens = estimated_tokens(question);
  answer.usage.response_tokens = estimated_tokens(text);
}

bool runs_away_streamed(const Provider& provider, std::string_view body) {
  const ReadResponse read = provider.read_response({200, "text/event-stream", {}, {}, std::string(body), true});
  if (read.kind != ReadResponse::Kind::kResponse) return false;
  return runs_away(read.answer.calls.empty() ? read.answer.content : read.answer.calls.back().arguments);
}

// An answer cut off before its limit shows how much the model can hold.
Capacity capacity_seen(const Response& answer, const Request& asked, Capacity known) {
  constexpr std::int64_t kSlack = 32;
  const bool cut = answer.finish_reason == "length" && !answer.usage.estimated && answer.usage.response_tokens > 0;
  const std::int64_t all = answer.usage.request_tokens + answer.usage.response_tokens;
  if (cut && answer.usage.response_tokens + kSlack < asked.max_response_tokens && all < known.context_or_any()) {
    known.context = all;
    known.cuts = true;
  }
  return known;
}

// Such an answer would come again, and a later run may read it.
bool worth_keeping(const Response& answer) {
  return !answer.body.empty() && answer.refusal.empty() && answer.finish_reason != "length" && answer.finish_reason != "content_filter";
}

}  // namespace

// One question on its way.
struct ChatClient::Exchange {
  explicit Exchange(const RetryOptions& options) : policy(options, std::random_device{}()) {}
  RetryPolicy policy;
  Clock::time_point started = Clock::now();
  double waited_s = 0;  // for the server and between tries
  int adaptations = 0;
  std::string request;
};

ChatClient::ChatClient(ChatOptions options)
    : options_(std::move(options)),
      cache_(options_.cache),
      capabilities_(load_capabilities(options_.cache, options_.endpoint.base_url, options_.endpoint.model, provider().modes())) {
  // Hosted servers know a function by name; those at home (llama.cpp, LM Studio) often but the word, and then let the model talk.
  if (!capabilities_.known && is_local(options_.endpoint)) capabilities_.without.insert("named_tool");
  if (options_.plain_json) {
    capabilities_.mode = Mode::kJson;
    capabilities_.modes = kPlainJson;
    capabilities_.known = true;  // so that it is not kept as what the server can do
  }
  if (options_.context_tokens > 0) capabilities_.capacity.context = options_.context_tokens;
}

Result<Response> ChatClient::ask(const Request& question) {
  if (options_.use_cached_answers) {
    if (auto answer = from_cache(question)) return std::move(*answer);
  }
  LAYOUTBOX_CHECK(check_key(options_.endpoint));
  LAYOUTBOX_ASSIGN(const Amount aside, set_aside(question));
  Result<Response> answer = from_server(question);
  if (answer) count(*answer);
  if (options_.spend_limit != nullptr) {
    const Amount spent = answer ? Amount{answer->cost.value_or(0), answer->usage.request_tokens + answer->usage.response_tokens} : Amount{};
    options_.spend_limit->settle(aside, spent);
  }
  if (!answer) return answer;
  if (options_.use_cached_answers && worth_keeping(*answer)) cache_.store(options_.endpoint.base_url, answer->request, answer->body);
  return answer;
}

// In whichever way it was asked before.
std::optional<Response> ChatClient::from_cache(const Request& question) const {
  for (const Capabilities& capabilities : all_ways(capabilities_)) {
    std::string request = recorded(written(question, capabilities), question);
    auto body = cache_.find(options_.endpoint.base_url, request);
    if (!body) continue;
    ReadResponse read = provider().read_response({200, {}, {}, {}, *body});
    if (read.kind != ReadResponse::Kind::kResponse) continue;
    read.answer.mode = capabilities.mode;
    read.answer.cached = true;
    read.answer.cost = 0;
    fill_estimates(question, read.answer);
    read.answer.request = std::move(request);
    read.answer.body = std::move(*body);
    return std::move(read.answer);
  }
  return std::nullopt;
}

Result<Response> ChatClient::from_server(const Request& question) {
  Exchange so_far(options_.retry);
  Result<Response> answer = exchange(question, so_far);
  if (!answer) {
    answer.error().message = safe(answer.error().message);
    return answer;
  }
  answer->mode = capabilities_.mode;
  answer->retries = so_far.policy.retries();
  answer->seconds = seconds_since(so_far.started);
  answer->own_seconds = answer->seconds - so_far.waited_s;
  answer->request = recorded(so_far.request, question);
  const Request asked = fitted(question, capabilities_.capacity);
  const Capacity seen = capacity_seen(*answer, asked, capabilities_.capacity);
  if (seen.context != capabilities_.capacity.context) capabilities_.known = false;  // to be kept
  capabilities_.capacity = seen;
  fill_estimates(asked, *answer);
  if (auto other = change_for(*answer, capabilities_)) {  // the next question is asked so; it is remembered once it has worked
    capabilities_ = std::move(*other);
  } else if (!capabilities_.known) {
    capabilities_.known = true;
    save_capabilities(options_.cache, options_.endpoint.base_url, options_.endpoint.model, capabilities_);
  }
  return answer;
}

HttpRequest ChatClient::http_request(const Exchange& so_far) const {
  HttpRequest request;
  request.url = url();
  request.headers = provider().headers(options_.endpoint);
  for (const char* header : {"Content-Type: application/json", "Accept: application/json, text/event-stream", "Expect:"}) {
    request.headers.emplace_back(header);
  }
  request.body = so_far.request;
  request.time_limit_s = std::min(options_.request_limit_s, std::max(0.1, options_.retry.total_s - seconds_since(so_far.started)));
  if (options_.stream) request.enough = [this](std::string_view so_far_read) { return runs_away_streamed(provider(), so_far_read); };
  return request;
}

// Asks until there is an answer or no more sense in asking.
Result<Response> ChatClient::exchange(const Request& question, Exchange& so_far) {
  for (;;) {
    so_far.request = written(question, capabilities_);
    const Clock::time_point sent = Clock::now();
    auto response = http_.post(http_request(so_far), options_.stop);
    so_far.waited_s += seconds_since(sent);
    if (response) {  // some servers say the key back
      response->body = safe(std::move(response->body));
      response->location = safe(std::move(response->location));
    }

    Problem problem;
    if (!response) {
      if (response.error().fault == HttpFault::kStopped) return fail(ErrorCode::kInterrupted, "stopped");
      problem = problem_of(response.error(), options_.endpoint);
    } else if (response->status >= 200 && response->status < 300) {
      ReadResponse read = provider().read_response(*response);
      if (read.kind == ReadResponse::Kind::kResponse) {
        // What still held the key once it was read has it in escapes or in pieces of a stream: such a body is not kept.
        if (!clean(read.answer)) read.answer.body = std::move(response->body);
        return std::move(read.answer);
      }
      read.error = safe(std::move(read.error));
      problem = problem_of(read, *response, options_.endpoint);
    } else {
      const ServerError error = safe(provider().read_error(response->body));
      if (so_far.adaptations < kMostAdaptations && adapt(response->status, error, question)) {
        ++so_far.adaptations;
        continue;
      }
      problem = problem_of(*response, error, options_.endpoint);
    }
    const auto wait_s = so_far.policy.wait_after(problem.outcome, problem.retry_after_s, seconds_since(so_far.started));
    if (!wait_s) return Failure(final_error(problem, so_far.policy.retries(), seconds_since(so_far.started)));
    LAYOUTBOX_CHECK(wait(*wait_s, problem.message));
    so_far.waited_s += *wait_s;
  }
}

// A server that does not know a parameter or a way of asking is asked without it, and one that cannot hold the question is asked a shorter
// one, now and from now on.
bool ChatClient::adapt(int status, const ServerError& error, const Request& question) {
  const Request asked = fitted(question, capabilities_.capacity);
  const auto change = change_for(status, error, capabilities_, estimated_tokens(asked) + asked.max_response_tokens);
  if (!change || written(question, *change) == written(question, capabilities_)) return false;
  capabilities_ = *change;
  capabilities_.known = false;
  return true;
}

// JSON may write a key in escapes that are none once it is read.
std::string ChatClient::safe_json(std::string text) const {
  const auto json = nlohmann::ordered_json::parse(text, nullptr, false);
  if (json.is_discarded()) return safe(std::move(text));
  const std::string plain = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  const std::string clean = safe(plain);
  return clean == plain ? text : clean;
}

// Before a message is cut, which may leave half a key.
ServerError ChatClient::safe(ServerError error) const {
  error.message = safe(std::move(error.message));
  return error;
}

// Whether the answer held the key.
bool ChatClient::clean(Response& answer) const {
  bool held = false;
  const auto put = [&held](std::string& text, std::string cleaned) {
    held = held || cleaned != text;
    text = std::move(cleaned);
  };
  for (Call& call : answer.calls) put(call.arguments, safe_json(call.arguments));
  put(answer.content, safe_json(safe(answer.content)));
  put(answer.refusal, safe(answer.refusal));
  return held;
}

Status ChatClient::wait(double seconds, const std::string& why) const {
  if (options_.on_wait) options_.on_wait(safe(fmt::format("{}; asking again in {:.1f} s", why, seconds)));
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  while (Clock::now() < end) {
    if (options_.stop != nullptr && options_.stop->load()) return fail(ErrorCode::kInterrupted, "stopped");
    std::this_thread::sleep_for(std::min<std::chrono::duration<double>>(end - Clock::now(), std::chrono::milliseconds(50)));
  }
  return {};
}

// What the question may take, out of the spend_limit. Errors: kUsage (no price is known), kNotFound (too much), kInterrupted.
Result<Amount> ChatClient::set_aside(const Request& question) const {
  if (options_.spend_limit == nullptr) return Amount{};
  SpendLimit& spend_limit = *options_.spend_limit;
  const std::int64_t tokens = estimated_tokens(question);
  Amount most{0, tokens};
  if (spend_limit.max_cost && !is_local(options_.endpoint)) {
    const auto price = options_.prices.find(options_.endpoint.model);
    if (!price) {
      return fail(ErrorCode::kUsage,
                  fmt::format("no price is known for the model {}, so its cost cannot be limited", options_.endpoint.model), "--max-cost",
                  "give its price by --prices FILE");
    }
    most.cost = cost_of(*price, {tokens, question.max_response_tokens, true});
  }
  switch (spend_limit.set_aside(most, options_.stop)) {
    case SpendLimit::Draw::kDone: return most;
    case SpendLimit::Draw::kStopped: return fail(ErrorCode::kInterrupted, "stopped");
    case SpendLimit::Draw::kTooManyTokens:
      return fail(ErrorCode::kNotFound,
                  fmt::format("the limit of {} tokens is reached: {} are used and the next question has about {}", *spend_limit.max_tokens,
                              spend_limit.spent().tokens, tokens),
                  "--max-tokens", "raise --max-tokens, or take the offline planner");
    case SpendLimit::Draw::kTooDear: break;
  }
  return fail(ErrorCode::kNotFound,
              fmt::format("the limit of ${:g} would be passed: ${:.4f} are spent and the next question may cost ${:.4f}",
                          *spend_limit.max_cost, spend_limit.spent().cost, most.cost),
              "--max-cost", "raise --max-cost, or take the offline planner");
}

void ChatClient::count(Response& answer) {
  usage_.request_tokens += answer.usage.request_tokens;
  usage_.response_tokens += answer.usage.response_tokens;
  usage_.estimated = usage_.estimated || answer.usage.estimated;
  const auto price = options_.prices.find(options_.endpoint.model);
  if (is_local(options_.endpoint)) {
    answer.cost = 0;
  } else if (price) {
    answer.cost = cost_of(*price, answer.usage);
  }
  cost_ += answer.cost.value_or(0);
  cost_known_ = cost_known_ && answer.cost.has_value();
}

std::string ChatClient::price_date() const {
  const auto price = options_.prices.find(options_.endpoint.model);
  return price ? price->as_of : std::string();
}

std::string ChatClient::describe_request(const Request& question) const {
  std::string text = fmt::format("POST {}\nContent-Type: application/json\n", url());
  Endpoint shown = options_.endpoint;
  if (!shown.key.empty()) shown.key = "[key]";
  for (const std::string& header : provider().headers(shown)) text += header + "\n";
  if (shown.key.empty()) text += "(no key is set)\n";
  return text + "\n" + recorded(written(question, capabilities_), question) + "\n";
}

}  // namespace layoutbox::chat
