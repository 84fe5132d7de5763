// What a failed request means: whether to ask again, how to ask otherwise, and what to tell the user.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/chat/endpoint.h"
#include "layoutbox/chat/provider.h"
#include "layoutbox/chat/retry.h"

namespace layoutbox::chat {

struct Problem {
  TryOutcome outcome = TryOutcome::kFinal;
  std::string message;  // "the server is busy (503: try later)"
  std::string hint;
  std::optional<double> retry_after_s;
};

Problem problem_of(const HttpFailure& failure, const Endpoint& endpoint);
Problem problem_of(const HttpResponse& response, const ServerError& error, const Endpoint& endpoint);
// Of a status 2xx whose body is no answer.
Problem problem_of(const ReadResponse& read, const HttpResponse& response, const Endpoint& endpoint);

// The error after the last try.
Error final_error(const Problem& problem, int retries, double seconds);

// How to ask instead, where the server's words say that it does not know a parameter or a way of asking; empty where they do not.
// `asked_tokens`: what was asked for, question and answer together; for servers that say no more than "too long".
std::optional<Capabilities> change_for(int status, const ServerError& error, const Capabilities& capabilities,
                                       std::int64_t asked_tokens = 0);

// How to ask instead, where an answer came that is in words although a call or JSON was asked for: the server leaves the choice to the
// model. Empty where it is as asked, or where there is no other way.
std::optional<Capabilities> change_for(const Response& answer, const Capabilities& capabilities);

// Every way of asking, the present one first.
std::vector<Capabilities> all_ways(const Capabilities& capabilities);

}  // namespace layoutbox::chat
