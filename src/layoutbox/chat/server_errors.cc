#include "layoutbox/chat/server_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace layoutbox::chat {
namespace {

std::string lower(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return out;
}

bool says_any(std::string_view text, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view word) { return text.find(word) != std::string_view::npos; });
}

// ": the server's own words", or nothing.
std::string own_words(const ServerError& error) { return error.message.empty() ? "" : ": " + one_line(error.message, 250); }

bool is_about_money(const ServerError& error) {
  const std::string text = lower(error.code + " " + error.message);
  return says_any(text, {"insufficient_quota", "insufficient credits", "billing", "exceeded your current quota", "credit balance"});
}

bool is_about_length(std::string_view text) {
  return says_any(text, {"context length", "context_length", "context size", "context window", "maximum context", "too many tokens",
                         "reduce the length", "prompt is too long", "context limit"});
}

std::string not_this_form(const Endpoint& endpoint) {
  return fmt::format("check that it is a server of the form \"{}\" (--provider)", endpoint.provider->facts().name);
}

// The next way of asking that the provider has, from the best to the last.
std::optional<Mode> mode_after(const Capabilities& capabilities, Mode mode) {
  const auto next = std::ranges::find_if(capabilities.modes, [mode](Mode one) { return one > mode; });
  return next != capabilities.modes.end() ? std::optional(*next) : std::nullopt;
}

}  // namespace

Problem problem_of(const HttpFailure& failure, const Endpoint& endpoint) {
  Problem problem{outcome_of_fault(failure.fault), {}, {}, {}};
  const std::string& where = endpoint.base_url;
  const std::string_view variable = endpoint.provider->facts().address_variable;
  switch (failure.fault) {
    case HttpFault::kNoLibrary:
      problem.message = failure.message;
      problem.hint = "install the package libcurl4, or leave out --planner llm";
      break;
    case HttpFault::kResolve:
      problem.message = fmt::format("the name in {} has no address", where);
      problem.hint = fmt::format("check {} and the network", variable);
      break;
    case HttpFault::kConnect:
      problem.message = fmt::format("nothing answers at {}", where);
      problem.hint = fmt::format("start the server, or check {} and the network", variable);
      break;
    case HttpFault::kTls:
      problem.message = fmt::format("there is no safe connection to {}: {}", where, one_line(failure.message, 200));
      problem.hint = "certificates are always checked; name the file of an authority of your own in SSL_CERT_FILE";
      break;
    case HttpFault::kCut: problem.message = fmt::format("the connection to {} broke off before the answer was whole", where); break;
    case HttpFault::kTimeout:
      problem.message = fmt::format("{}: {}", where, failure.message);
      problem.hint = "raise --model-timeout for a slow model";
      break;
    case HttpFault::kTooLarge:
      problem.message = fmt::format("{}: {}, and no scene is", where, failure.message);
      problem.hint = fmt::format("check {}", variable);
      break;
    case HttpFault::kStopped:
    case HttpFault::kOther: problem.message = fmt::format("{} cannot be asked: {}", where, one_line(failure.message, 200)); break;
  }
  return problem;
}

Problem problem_of(const HttpResponse& response, const ServerError& error, const Endpoint& endpoint) {
  Problem problem{outcome_of_status(response.status), {}, {}, response.retry_after_s};
  const int status = response.status;
  const std::string words = own_words(error);
  const Provider::Facts& facts = endpoint.provider->facts();
  if (status == 401) {
    problem.message = fmt::format("{} does not accept the key (401{})", endpoint.base_url, words);
    problem.hint = fmt::format("{} {}", endpoint.key.empty() ? "set" : "check", facts.key_variable);
  } else if (status == 403) {
    problem.message = fmt::format("{} does not allow this (403{})", endpoint.base_url, words);
    problem.hint = "check what the key may be used for";
  } else if (status == 404) {
    problem.message = fmt::format("{} knows no model {}, or is no such server (404{})", endpoint.base_url, endpoint.model, words);
    problem.hint = fmt::format("check LAYOUTBOX_MODEL and {}; {}", facts.address_variable, facts.address_hint);
  } else if (status == 407) {
    problem.message = fmt::format("the proxy wants a password (407{})", words);
    problem.hint = "check HTTPS_PROXY";
  } else if (status >= 300 && status < 400) {
    problem.message = fmt::format("{} leads elsewhere ({} to {}), and a key is sent to the named server alone", endpoint.base_url, status,
                                  response.location.empty() ? "nowhere" : one_line(response.location, 150));
    problem.hint = fmt::format("set {} to the right address", facts.address_variable);
  } else if (is_about_money(error)) {
    problem.outcome = TryOutcome::kFinal;
    problem.message = fmt::format("nothing is left to pay with at {} ({}{})", endpoint.base_url, status, words);
    problem.hint = "check the account";
  } else if (problem.outcome == TryOutcome::kBusy) {
    problem.message = fmt::format("{} is busy or out of order ({}{})", endpoint.base_url, status, words);
    problem.hint = "try again later";
  } else if (is_about_length(lower(error.message)) || status == 413) {
    problem.message = fmt::format("the question is too long for the model {} ({}{})", endpoint.model, status, words);
    problem.hint = "take a model with a longer context, or start the server with one";
  } else {
    problem.message = fmt::format("{} refuses the question ({}{})", endpoint.base_url, status, words);
    problem.hint = not_this_form(endpoint);
  }
  return problem;
}

Problem problem_of(const ReadResponse& read, const HttpResponse& response, const Endpoint& endpoint) {
  Problem problem;
  const Provider::Facts& facts = endpoint.provider->facts();
  switch (read.kind) {
    case ReadResponse::Kind::kResponse: break;
    case ReadResponse::Kind::kCut:
      problem.outcome = TryOutcome::kBusy;
      problem.message = fmt::format("the answer of {} broke off before it was whole", endpoint.base_url);
      break;
    case ReadResponse::Kind::kBroken:
      problem.outcome = TryOutcome::kUnclear;
      problem.message = fmt::format("{}: {}", endpoint.base_url, read.error.message);
      problem.hint = not_this_form(endpoint);
      break;
    case ReadResponse::Kind::kPage:
      problem.message = fmt::format("{} answers with a web page, so some other server or a proxy stands there", endpoint.base_url);
      problem.hint = fmt::format("check {} and the proxy; {}", facts.address_variable, facts.address_hint);
      break;
    case ReadResponse::Kind::kError: {
      // Some gateways put the status of the server behind them into the error.
      int status = 0;
      if (read.error.code.size() == 3 && std::ranges::all_of(read.error.code, [](char c) { return c >= '0' && c <= '9'; })) {
        status = std::stoi(read.error.code);
      }
      HttpResponse inner = response;
      inner.status = status >= 400 ? status : 400;
      return problem_of(inner, read.error, endpoint);
    }
  }
  return problem;
}

Error final_error(const Problem& problem, int retries, double seconds) {
  std::string message = problem.message;
  if (problem.retry_after_s && problem.outcome == TryOutcome::kBusy)
    message += fmt::format("; it asks for {:g} s of patience", *problem.retry_after_s);
  if (retries > 0) message += fmt::format("; asked {} times in {:.0f} s", retries + 1, seconds);
  return {ErrorCode::kNetwork, message, {}, problem.hint, {}};
}

std::optional<Capabilities> change_for(int status, const ServerError& error, const Capabilities& capabilities, std::int64_t asked_tokens) {
  if (status != 400 && status != 413 && status != 404 && status != 405 && status != 415 && status != 422 && status != 500 && status != 501)
    return std::nullopt;
  const std::string text = lower(error.parameter + " " + error.message);
  Capabilities changed = capabilities;
  Capacity told = capacity_told(text, error.context);
  if (told.response > 0 && told.response < changed.capacity.response_or_any()) {
    changed.capacity.response = told.response;
    return changed;
  }
  if (is_about_length(text) || error.context > 0 || status == 413) {
    if (told.context == 0 || told.context >= std::min(asked_tokens, changed.capacity.context_or_any()))
      told.context = asked_tokens * 3 / 4;  // it says nothing, or counts otherwise
    if (told.context == 0 || told.context >= changed.capacity.context_or_any()) return std::nullopt;
    changed.capacity.context = told.context;
    changed.capacity.cuts = false;
    return changed;
  }
  for (const char* parameter : {"max_completion_tokens", "temperature", "seed", "stream_options"}) {
    if (text.find(parameter) != std::string::npos && changed.without.insert(parameter).second) return changed;
  }
  const bool tools = capabilities.mode == Mode::kStrictTools || capabilities.mode == Mode::kTools;
  const bool about_tools = says_any(text, {"tool", "function", "strict", "schema"});
  const bool about_format = says_any(text, {"response_format", "json_schema", "json_object", "schema", "grammar"});
  // A server that says no more than "bad request" may mean anything; the way that is known to work is not given up for it.
  const bool unclear = (status == 400 || status == 422) && !capabilities.known;
  if (tools && text.find("tool_choice") != std::string::npos && changed.without.insert("tool_choice").second) return changed;
  if (tools ? about_tools || unclear : about_format || unclear) {
    if (const auto next = mode_after(capabilities, capabilities.mode)) {
      changed.mode = *next;
      return changed;
    }
    if (about_format && changed.without.insert("response_format").second) return changed;
  }
  return std::nullopt;
}

std::optional<Capabilities> change_for(const Response& answer, const Capabilities& capabilities) {
  if (!answer.calls.empty() || !answer.refusal.empty() || answer.finish_reason == "content_filter") return std::nullopt;
  const bool tools = capabilities.mode == Mode::kStrictTools || capabilities.mode == Mode::kTools;
  if (!tools && (capabilities.mode == Mode::kJson || answer.content.find('{') != std::string::npos)) return std::nullopt;
  Capabilities changed = capabilities;
  changed.known = false;
  if (capabilities.mode == Mode::kStrictTools && !capabilities.without.contains("tool_choice") &&
      changed.without.insert("named_tool").second)
    return changed;
  const auto next = mode_after(capabilities, tools ? Mode::kTools : capabilities.mode);
  if (!next) return std::nullopt;
  changed.mode = *next;
  return changed;
}

std::vector<Capabilities> all_ways(const Capabilities& capabilities) {
  std::vector<Capabilities> ways = {capabilities};
  for (const Mode mode : capabilities.modes) {
    ways.push_back(capabilities);
    ways.back().mode = mode;
    ways.back().without.erase("named_tool");
    if (ways.back().mode != Mode::kStrictTools) continue;
    ways.push_back(ways.back());
    ways.back().without.insert("named_tool");
  }
  return ways;
}

}  // namespace layoutbox::chat
