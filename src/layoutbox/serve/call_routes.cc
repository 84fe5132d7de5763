// The calls that answer at once.
#include <algorithm>
#include <cctype>
#include <chrono>
#include <nlohmann/json.hpp>

#include "layoutbox/serve/event_stream.h"
#include "layoutbox/serve/http.h"
#include "layoutbox/serve/site.h"

namespace layoutbox::serve {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kHungUp = 499;  // counted so, as elsewhere: who asked has gone
constexpr std::size_t kUsualArticles = 50, kMostArticles = 5000;

struct Named {
  std::string operation;
  CallFunction call;
};

// The answer, or the error's object with its status.
Answer work(Site& site, CallFunction call, const nlohmann::json& body, const Surroundings& around) {
  if (!site.gate.enter()) return error_answer(429, {ErrorCode::kTooLarge, "too much work is waiting", {}, "ask again in a second", {}});
  auto answer = call(body, around);
  site.gate.leave();
  return answer ? *std::move(answer) : error_answer(answer.error());
}

// For who wants to see it work: an event as each stage begins, how far the solver is, then the answer or the error. Where the far end
// hangs up, the work ends.
void stream_call(Site& site, const Named& named, nlohmann::json body, httplib::Response& response) {
  response.set_header("Cache-Control", "no-store");
  response.set_chunked_content_provider("text/event-stream", [&site, named, body = std::move(body)](std::size_t, httplib::DataSink& sink) {
    const auto begin = Clock::now();
    Surroundings around = site.around;
    bool sent = false;
    {
      EventStream events(sink, [&site] { return site.ending(); });
      around.stop = &events.stop();
      around.on_stage = [&](std::string_view stage) { events.send("stage", stage); };
      around.on_progress = [&](double share) { events.send_now_and_then("progress", share); };
      const Answer answer = work(site, named.call, body, around);
      const bool given_up = events.hung_up();
      site.metrics.add(named.operation, given_up ? kHungUp : answer.status, std::chrono::duration<double>(Clock::now() - begin).count());
      sent = !given_up && events.send(answer.status == 200 ? "answer" : "refusal", answer.body);
    }
    sink.done();
    return sent;
  });
}

void answer_call(Site& site, const Named& named, const httplib::Request& request, httplib::Response& response) {
  const auto begin = Clock::now();
  auto body = site.read_body(named.operation, request, response);
  if (body && request.get_header_value("Accept") == "text/event-stream") return stream_call(site, named, *std::move(body), response);
  if (body) put(response, work(site, named.call, *body, site.around));
  if (response.status == 429) response.set_header("Retry-After", "1");
  site.metrics.add(named.operation, response.status, std::chrono::duration<double>(Clock::now() - begin).count());
}

// 0: it is no number of articles.
std::size_t number_of_articles(const std::string& limit) {
  if (limit.empty()) return kUsualArticles;
  const bool number = limit.size() <= 4 && std::all_of(limit.begin(), limit.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  const std::size_t articles = number ? static_cast<std::size_t>(std::stoul(limit)) : 0;
  return articles <= kMostArticles ? articles : 0;
}

void answer_catalog(const Site& site, const httplib::Request& request, httplib::Response& response) {
  const std::string search = request.get_param_value("search");
  const std::size_t most = number_of_articles(request.get_param_value("limit"));
  if (most == 0 || search.size() > 100) {
    put_error(response, 400, {ErrorCode::kUsage, "limit is a number from 1 to 5000, and search at most 100 characters", {}, {}, {}});
    return;
  }
  put(response, catalog_answer(site.around.catalog, search, most));
}

}  // namespace

void add_call_routes(httplib::Server& server, Site& site) {
  for (const std::string operation : {"generate", "plan", "solve", "edit", "drag", "verify", "export", "judge", "remedies"}) {
    const Named named{operation, find_call(operation)};
    server.Post("/api/" + operation, [&site, named](const httplib::Request& request, httplib::Response& response) {
      answer_call(site, named, request, response);
    });
  }
  server.Get("/api/catalog",
             [&site](const httplib::Request& request, httplib::Response& response) { answer_catalog(site, request, response); });
  server.Get("/api/relations", [](const httplib::Request&, httplib::Response& response) { put(response, relations_answer()); });
}

}  // namespace layoutbox::serve
