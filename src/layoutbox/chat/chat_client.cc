#include "layoutbox/chat/chat_client.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <thread>

#include "layoutbox/chat/runaway.h"
#include "layoutbox/chat/server_errors.h"
#include "layoutbox/chat/sse.h"
#include "layoutbox/chat/tokens.h"

namespace layoutbox::chat {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMostAdaptations = 8;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

void fill_estimates(const Question& question, Answer& answer) {
  if (!answer.usage.estimated) return;
  std::string text = answer.content;
  for (const Call& call : answer.calls) text += call.arguments;
  answer.usage.question_tokens = estimated_tokens(question);
  answer.usage.answer_tokens = estimated_tokens(text);
}

bool runs_away_streamed(std::string_view body) {
  const ReadAnswer read = read_answer({200, "text/event-stream", {}, {}, std::string(body), true});
  if (read.kind != ReadAnswer::Kind::kAnswer) return false;
  return runs_away(read.answer.calls.empty() ? read.answer.content : read.answer.calls.back().arguments);
}

// An answer cut off before its limit shows how much the model can hold.
Capacity capacity_seen(const Answer& answer, const Question& asked, Capacity known) {
  constexpr std::int64_t kSlack = 32;
  const bool cut = answer.finish_reason == "length" && !answer.usage.estimated && answer.usage.answer_tokens > 0;
  const std::int64_t all = answer.usage.question_tokens + answer.usage.answer_tokens;
  if (cut && answer.usage.answer_tokens + kSlack < asked.max_answer_tokens && all < known.context_or_any()) {
    known.context = all;
    known.cuts = true;
  }
  return known;
}

// Such an answer would come again, and a later run may read it.
bool worth_keeping(const Answer& answer) {
  return answer.refusal.empty() && answer.finish_reason != "length" && answer.finish_reason != "content_filter";
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
      habits_(load_habits(options_.cache, options_.endpoint.base_url, options_.endpoint.model)) {
  // Hosted servers know a function by name; those at home (llama.cpp, LM Studio) often but the word, and then let the model talk.
  if (!habits_.known && is_local(options_.endpoint)) habits_.without.insert("named_tool");
  if (options_.context_tokens > 0) habits_.capacity.context = options_.context_tokens;
}

Result<Answer> ChatClient::ask(const Question& question) {
  if (options_.use_cached_answers) {
    if (auto answer = from_cache(question)) return std::move(*answer);
  }
  LAYOUTBOX_CHECK(check_key(options_.endpoint));
  LAYOUTBOX_ASSIGN(const Amount aside, set_aside(question));
  Result<Answer> answer = from_server(question);
  if (answer) count(*answer);
  if (options_.purse != nullptr) {
    const Amount spent = answer ? Amount{answer->cost.value_or(0), answer->usage.question_tokens + answer->usage.answer_tokens} : Amount{};
    options_.purse->settle(aside, spent);
  }
  if (!answer) return answer;
  if (options_.use_cached_answers && worth_keeping(*answer)) cache_.store(options_.endpoint.base_url, answer->request, answer->body);
  return answer;
}

// In whichever way it was asked before.
std::optional<Answer> ChatClient::from_cache(const Question& question) const {
  for (const Habits& habits : all_ways(habits_)) {
    std::string request = safe(write_request(question, options_.endpoint.model, habits, options_.stream));
    auto body = cache_.find(options_.endpoint.base_url, request);
    if (!body) continue;
    ReadAnswer read = read_answer({200, {}, {}, {}, *body});
    if (read.kind != ReadAnswer::Kind::kAnswer) continue;
    read.answer.mode = habits.mode;
    read.answer.cached = true;
    read.answer.cost = 0;
    fill_estimates(question, read.answer);
    read.answer.request = std::move(request);
    read.answer.body = std::move(*body);
    return std::move(read.answer);
  }
  return std::nullopt;
}

Result<Answer> ChatClient::from_server(const Question& question) {
  Exchange so_far(options_.retry);
  Result<Answer> answer = exchange(question, so_far);
  if (!answer) {
    answer.error().message = safe(answer.error().message);
    return answer;
  }
  answer->mode = habits_.mode;
  answer->retries = so_far.policy.retries();
  answer->seconds = seconds_since(so_far.started);
  answer->own_seconds = answer->seconds - so_far.waited_s;
  answer->request = safe(so_far.request);
  const Question asked = fitted(question, habits_.capacity);
  const Capacity seen = capacity_seen(*answer, asked, habits_.capacity);
  if (seen.context != habits_.capacity.context) habits_.known = false;  // to be kept
  habits_.capacity = seen;
  fill_estimates(asked, *answer);
  if (auto other = change_for(*answer, habits_)) {  // the next question is asked so; it is remembered once it has worked
    habits_ = std::move(*other);
  } else if (!habits_.known) {
    habits_.known = true;
    save_habits(options_.cache, options_.endpoint.base_url, options_.endpoint.model, habits_);
  }
  return answer;
}

HttpRequest ChatClient::http_request(const Exchange& so_far) const {
  HttpRequest request;
  request.url = url();
  request.headers = {"Content-Type: application/json", "Accept: application/json, text/event-stream", "Expect:"};
  if (!options_.endpoint.key.empty()) request.headers.push_back("Authorization: Bearer " + options_.endpoint.key);
  request.body = so_far.request;
  request.time_limit_s = std::min(options_.request_limit_s, std::max(0.1, options_.retry.total_s - seconds_since(so_far.started)));
  if (options_.stream) request.enough = runs_away_streamed;
  return request;
}

// Asks until there is an answer or no more sense in asking.
Result<Answer> ChatClient::exchange(const Question& question, Exchange& so_far) {
  for (;;) {
    so_far.request = write_request(question, options_.endpoint.model, habits_, options_.stream);
    const Clock::time_point sent = Clock::now();
    const auto response = http_.post(http_request(so_far), options_.stop);
    so_far.waited_s += seconds_since(sent);

    Problem problem;
    if (!response) {
      if (response.error().fault == HttpFault::kStopped) return fail(ErrorCode::kInterrupted, "stopped");
      problem = problem_of(response.error(), options_.endpoint);
    } else if (response->status >= 200 && response->status < 300) {
      ReadAnswer read = read_answer(*response);
      if (read.kind == ReadAnswer::Kind::kAnswer) {
        read.answer.body = safe(response->body);
        return std::move(read.answer);
      }
      problem = problem_of(read, *response, options_.endpoint);
    } else {
      const ServerError error = read_error(response->body);
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
bool ChatClient::adapt(int status, const ServerError& error, const Question& question) {
  const auto request_by = [&](const Habits& habits) { return write_request(question, options_.endpoint.model, habits, options_.stream); };
  const Question asked = fitted(question, habits_.capacity);
  const auto change = change_for(status, error, habits_, estimated_tokens(asked) + asked.max_answer_tokens);
  if (!change || request_by(*change) == request_by(habits_)) return false;
  habits_ = *change;
  habits_.known = false;
  return true;
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

// What the question may take, out of the purse. Errors: kUsage (no price is known), kNotFound (too much), kInterrupted.
Result<Amount> ChatClient::set_aside(const Question& question) const {
  if (options_.purse == nullptr) return Amount{};
  Purse& purse = *options_.purse;
  const std::int64_t tokens = estimated_tokens(question);
  Amount most{0, tokens};
  if (purse.max_cost && !is_local(options_.endpoint)) {
    const auto price = options_.prices.find(options_.endpoint.model);
    if (!price) {
      return fail(ErrorCode::kUsage,
                  fmt::format("no price is known for the model {}, so its cost cannot be limited", options_.endpoint.model), "--max-cost",
                  "give its price by --prices FILE");
    }
    most.cost = cost_of(*price, {tokens, question.max_answer_tokens, true});
  }
  switch (purse.set_aside(most, options_.stop)) {
    case Purse::Draw::kDone: return most;
    case Purse::Draw::kStopped: return fail(ErrorCode::kInterrupted, "stopped");
    case Purse::Draw::kTooManyTokens:
      return fail(ErrorCode::kNotFound,
                  fmt::format("the limit of {} tokens is reached: {} are used and the next question has about {}", *purse.max_tokens,
                              purse.spent().tokens, tokens),
                  "--max-tokens", "raise --max-tokens, or take the offline planner");
    case Purse::Draw::kTooDear: break;
  }
  return fail(ErrorCode::kNotFound,
              fmt::format("the limit of ${:g} would be passed: ${:.4f} are spent and the next question may cost ${:.4f}", *purse.max_cost,
                          purse.spent().cost, most.cost),
              "--max-cost", "raise --max-cost, or take the offline planner");
}

void ChatClient::count(Answer& answer) {
  usage_.question_tokens += answer.usage.question_tokens;
  usage_.answer_tokens += answer.usage.answer_tokens;
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

std::string ChatClient::describe_request(const Question& question) const {
  std::string text = fmt::format("POST {}\nContent-Type: application/json\n", url());
  text += options_.endpoint.key.empty() ? "(no key is set)\n" : "Authorization: Bearer [key]\n";
  return text + "\n" + safe(write_request(question, options_.endpoint.model, habits_, options_.stream)) + "\n";
}

}  // namespace layoutbox::chat
