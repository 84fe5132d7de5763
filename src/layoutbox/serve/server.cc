#include "layoutbox/serve/server.h"

#include <fmt/format.h>
#include <httplib.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "layoutbox/base/files.h"
#include "layoutbox/pipeline/generate.h"
#include "layoutbox/scene/json_text.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/serve/call_parts.h"
#include "layoutbox/serve/gate.h"
#include "layoutbox/serve/guard.h"
#include "layoutbox/serve/jobs.h"
#include "layoutbox/serve/page.h"
#include "layoutbox/serve/store.h"

namespace layoutbox::serve {
namespace {

constexpr int kThreads = 32;  // connections at a time: event streams hold one each
constexpr std::size_t kUsualArticles = 50;
constexpr auto kLongestEvent = std::chrono::seconds(15);

// Reached from this machine alone.
bool is_own_address(std::string_view address) { return address == "127.0.0.1" || address == "localhost" || address == "::1"; }

int status_of(const Error& error) {
  switch (error.code) {
    case ErrorCode::kParse: return 400;
    case ErrorCode::kSchema: return 400;
    case ErrorCode::kTooLarge: return 413;
    case ErrorCode::kInterrupted: return 503;
    case ErrorCode::kNoBlender:
    case ErrorCode::kNoSolver:
    case ErrorCode::kIo:
    case ErrorCode::kNetwork: return 503;
    default: return 422;
  }
}

void put(httplib::Response& response, const Answer& answer) {
  response.status = answer.status;
  response.set_content(answer.body, answer.type.c_str());
}

void put_error(httplib::Response& response, int status, const Error& error) {
  put(response, {status, "application/json", write_error(error)});
}

void put_error(httplib::Response& response, const Error& error) { put_error(response, status_of(error), error); }

const Error& nothing_there() {
  static const Error error{ErrorCode::kReference, "there is no such thing", {}, "GET /api/openapi.json lists what there is", {}};
  return error;
}

// Of every answer: nothing is read as something else, framed, or told to others.
void set_headers(httplib::Response& response) {
  response.set_header("X-Content-Type-Options", "nosniff");
  response.set_header("X-Frame-Options", "DENY");
  response.set_header("Referrer-Policy", "no-referrer");
  response.set_header("Cross-Origin-Resource-Policy", "same-origin");
  response.set_header("Cross-Origin-Opener-Policy", "same-origin");
  response.set_header("Content-Security-Policy",
                      "default-src 'self'; img-src 'self' data: blob:; worker-src 'self' blob:; connect-src 'self' blob: data:; "
                      "object-src 'none'; base-uri 'none'; form-action 'self'; frame-ancestors 'none'");
}

Json json_of_room(const RoomRecord& room, bool with_layout) {
  Json json{{"id", room.id}, {"name", room.name}, {"created", room.created}, {"prompt", room.prompt}};
  if (with_layout) json["layout"] = Json::parse(room.layout);
  return json;
}

class Service {
 public:
  Service(const Catalog& catalog, const Planner& planner, const ServeOptions& options, Store& store, Jobs& jobs)
      : options_(options),
        around_{catalog, planner, options.stop},
        store_(store),
        jobs_(jobs),
        gate_(options.workers > 0 ? options.workers : static_cast<int>(std::max(1u, std::thread::hardware_concurrency())),
              options.longest_queue) {
    guard_.loopback = is_own_address(options.address);
    guard_.token = options.token;
  }

  Status run() {
    server_.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    server_.set_payload_max_length(options_.largest_body);
    server_.set_keep_alive_max_count(1000);
    server_.set_tcp_nodelay(true);
    server_.set_socket_options([](socket_t socket) {  // not SO_REUSEPORT, by which two services would share a port
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    add_guard();
    for (const char* operation : {"generate", "plan", "solve", "edit", "drag", "verify", "export"}) add_call(operation);
    add_lists();
    add_jobs();
    add_rooms();
    add_page();
    guard_.port = options_.port == 0 ? server_.bind_to_any_port(options_.address.c_str()) : options_.port;
    const bool bound = options_.port == 0 ? guard_.port > 0 : server_.bind_to_port(options_.address.c_str(), options_.port);
    if (!bound) {
      return fail(ErrorCode::kIo, fmt::format("{}:{} cannot be listened at", options_.address, options_.port), "--port",
                  "another program may be there: choose another port, or 0 for any that is free");
    }
    std::thread watch([this] {
      while (!ended_ && (options_.stop == nullptr || !options_.stop->load())) std::this_thread::sleep_for(std::chrono::milliseconds(50));
      server_.stop();
    });
    const std::string host = options_.address == "::1" ? "[::1]" : options_.address;
    if (options_.on_ready) options_.on_ready(fmt::format("http://{}:{}/", host, guard_.port));
    server_.listen_after_bind();
    ended_ = true;
    watch.join();
    return {};
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

  void add_guard() {
    server_.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      set_headers(response);
      if (gives_token(request)) return httplib::Server::HandlerResponse::Unhandled;
      const auto refused =
          refusal(guard_, request.method, [&](std::string_view name) { return request.get_header_value(std::string(name).c_str()); });
      if (!refused) return httplib::Server::HandlerResponse::Unhandled;
      put_error(response, refused->status, refused->error);
      metrics_.add("refused", refused->status, 0);
      return httplib::Server::HandlerResponse::Handled;
    });
    server_.set_error_handler([](const httplib::Request&, httplib::Response& response) {
      set_headers(response);
      if (!response.body.empty()) return;
      if (response.status == 413) {
        put_error(response, 413, {ErrorCode::kTooLarge, "the request is too large", {}, {}, {}});
      } else if (response.status == 404) {
        put_error(response, 404, nothing_there());
      } else {
        put_error(response, response.status, {ErrorCode::kParse, "the request cannot be read", {}, {}, {}});
      }
    });
    server_.set_exception_handler([](const httplib::Request&, httplib::Response& response, std::exception_ptr) {
      put_error(response, 500, {ErrorCode::kInternal, "a bug in the service; please report it", {}, {}, {}});
    });
  }

  // The address that the service prints carries the token once; the page then has it as a cookie.
  bool gives_token(const httplib::Request& request) const {
    return !guard_.token.empty() && request.method == "GET" && request.path == "/" && request.has_param("token") &&
           same_secret(request.get_param_value("token"), guard_.token);
  }

  void add_call(const std::string& operation) {
    const Call call = find_call(operation);
    server_.Post("/api/" + operation, [this, operation, call](const httplib::Request& request, httplib::Response& response) {
      const auto begin = Clock::now();
      answer_call(operation, call, request, response);
      metrics_.add(operation, response.status, seconds_since(begin));
    });
  }

  // The body of a request, or the answer says why not.
  std::optional<Json> read_body(const std::string& operation, const httplib::Request& request, httplib::Response& response) const {
    if (!request.get_header_value("Content-Type").starts_with("application/json")) {
      put_error(response, 415, {ErrorCode::kUsage, "the body must be JSON", "Content-Type", "send Content-Type: application/json", {}});
      return std::nullopt;
    }
    auto body = schemas_.read(operation, request.body);
    if (body) return *std::move(body);
    put_error(response, body.error());
    return std::nullopt;
  }

  void answer_call(const std::string& operation, Call call, const httplib::Request& request, httplib::Response& response) {
    const auto body = read_body(operation, request, response);
    if (!body) return;
    if (!gate_.enter()) {
      put_error(response, 429, {ErrorCode::kTooLarge, "too much work is waiting", {}, "ask again in a second", {}});
      response.set_header("Retry-After", "1");
      return;
    }
    const auto answer = call(*body, around_);
    gate_.leave();
    if (answer) {
      put(response, *answer);
    } else {
      put_error(response, answer.error());
    }
  }

  void add_lists() {
    server_.Get("/api/catalog", [this](const httplib::Request& request, httplib::Response& response) {
      const std::string search = request.get_param_value("search"), limit = request.get_param_value("limit");
      const bool number =
          limit.size() <= 4 && std::all_of(limit.begin(), limit.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
      const std::size_t most = !number ? 0 : limit.empty() ? kUsualArticles : static_cast<std::size_t>(std::stoul(limit));
      if (most == 0 || search.size() > 100) {
        put_error(response, 400, {ErrorCode::kUsage, "limit is a number from 1 to 9999, and search at most 100 characters", {}, {}, {}});
        return;
      }
      put(response, catalog_answer(around_.catalog, search, most));
    });
    server_.Get("/api/relations", [](const httplib::Request&, httplib::Response& response) { put(response, relations_answer()); });
    server_.Get("/api/openapi.json", [](const httplib::Request&, httplib::Response& response) {
      put(response, {200, "application/json", std::string(openapi_text())});
    });
    server_.Get("/api/health", [this](const httplib::Request&, httplib::Response& response) {
      const JobCounts counts = jobs_.counts();
      put(response, json_answer({{"status", "ok"},
                                 {"version", program_version()},
                                 {"waiting", counts.waiting + gate_.waiting()},
                                 {"running", counts.running}}));
    });
    server_.Get("/metrics", [this](const httplib::Request&, httplib::Response& response) {
      const JobCounts counts = jobs_.counts();
      std::string text = metrics_.text() + "# TYPE layoutbox_jobs gauge\n";
      text +=
          fmt::format("layoutbox_jobs{{state=\"waiting\"}} {}\nlayoutbox_jobs{{state=\"running\"}} {}\n", counts.waiting, counts.running);
      text += fmt::format("# TYPE layoutbox_jobs_ended_total counter\nlayoutbox_jobs_ended_total{{state=\"done\"}} {}\n", counts.done);
      text += fmt::format("layoutbox_jobs_ended_total{{state=\"failed\"}} {}\n", counts.failed);
      text += fmt::format("layoutbox_jobs_ended_total{{state=\"cancelled\"}} {}\n", counts.cancelled);
      put(response, {200, "text/plain; version=0.0.4", std::move(text)});
    });
  }

  // Answers with the job, where there is one.
  static void put_job(httplib::Response& response, const Result<std::optional<JobView>>& job) {
    if (!job) {
      put_error(response, job.error());
    } else if (!*job) {
      put_error(response, 404, nothing_there());
    } else {
      put(response, {200, "application/json", write_job(**job)});
    }
  }

  void add_jobs() {
    constexpr const char* kJob = R"(/api/jobs/([0-9a-f]{16}))";
    server_.Post("/api/jobs", [this](const httplib::Request& request, httplib::Response& response) {
      const auto body = read_body("startJob", request, response);
      if (!body) return;
      const auto job = jobs_.start(*body);
      if (job) {
        put(response, {202, "application/json", write_job(*job)});
      } else if (job.error().code == ErrorCode::kTooLarge && job.error().pointer.empty()) {
        put_error(response, 429, job.error());
      } else {
        put_error(response, job.error());
      }
    });
    server_.Get(
        kJob, [this](const httplib::Request& request, httplib::Response& response) { put_job(response, jobs_.find(request.matches[1])); });
    server_.Delete(kJob, [this](const httplib::Request& request, httplib::Response& response) {
      put_job(response, jobs_.cancel(request.matches[1]));
    });
    server_.Get(std::string(kJob) + "/events",
                [this](const httplib::Request& request, httplib::Response& response) { stream_events(request.matches[1], response); });
    server_.Get(std::string(kJob) + R"(/files/([a-z0-9.-]{1,64}))", [this](const httplib::Request& request, httplib::Response& response) {
      const std::string name = request.matches[2];
      const auto bytes = jobs_.file(request.matches[1], name);
      if (!bytes) return put_error(response, 404, nothing_there());
      put(response, {200, name.ends_with(".png") ? "image/png" : "application/octet-stream", *bytes});
    });
  }

  void stream_events(const std::string& id, httplib::Response& response) {
    const auto job = jobs_.find(id);
    if (!job || !*job) return put_job(response, job);
    response.set_header("Cache-Control", "no-store");
    response.set_chunked_content_provider("text/event-stream", [this, id, seen = 0](std::size_t, httplib::DataSink& sink) mutable {
      const auto now = jobs_.wait(id, seen, kLongestEvent);
      if (!now || !*now || ended_ || (options_.stop != nullptr && options_.stop->load())) {
        sink.done();
        return true;
      }
      const JobView& view = **now;
      const std::string text = view.version == seen ? ": still here\n\n" : "data: " + write_job(view) + "\n\n";
      seen = view.version;
      if (!sink.write(text.data(), text.size())) return false;
      if (view.record.state != JobState::kWaiting && view.record.state != JobState::kRunning) sink.done();
      return true;
    });
  }

  void add_rooms() {
    constexpr const char* kRoom = R"(/api/rooms/([0-9a-f]{16}))";
    server_.Get("/api/rooms", [this](const httplib::Request&, httplib::Response& response) {
      const auto rooms = store_.rooms();
      if (!rooms) return put_error(response, rooms.error());
      Json list = Json::array();
      for (const RoomRecord& room : *rooms) list.push_back(json_of_room(room, false));
      put(response, json_answer({{"rooms", std::move(list)}}));
    });
    server_.Post("/api/rooms", [this](const httplib::Request& request, httplib::Response& response) {
      const auto body = read_body("keepRoom", request, response);
      if (!body) return;
      const auto layout = layout_of(*body);
      if (!layout) return put_error(response, layout.error());
      const RoomRecord room{new_id(), body->at("name").get<std::string>(), body->value("prompt", ""), time_text(),
                            body->at("layout").dump()};
      const Status kept = store_.put_room(room);
      if (!kept) return put_error(response, kept.error());
      put(response, json_answer(json_of_room(room, false), 201));
    });
    server_.Get(kRoom, [this](const httplib::Request& request, httplib::Response& response) {
      const auto room = store_.room(request.matches[1]);
      if (!room) return put_error(response, room.error());
      if (!*room) return put_error(response, 404, nothing_there());
      put(response, json_answer(json_of_room(**room, true)));
    });
    server_.Delete(kRoom, [this](const httplib::Request& request, httplib::Response& response) {
      const auto gone = store_.remove_room(request.matches[1]);
      if (!gone) return put_error(response, gone.error());
      if (!*gone) return put_error(response, 404, nothing_there());
      response.status = 204;
    });
  }

  void add_page() {
    server_.Get("/", [this](const httplib::Request& request, httplib::Response& response) {
      if (gives_token(request)) {
        response.set_header("Set-Cookie", fmt::format("{}={}; HttpOnly; SameSite=Strict; Path=/", kTokenCookie, guard_.token));
        return response.set_redirect("/");
      }
      put(response, page_.start());
    });
    server_.Get(R"(/([a-z0-9-]{1,64}\.[a-z0-9]{1,8}))", [this](const httplib::Request& request, httplib::Response& response) {
      const auto file = page_.file(request.matches[1].str());
      if (!file) return put_error(response, 404, nothing_there());
      put(response, *file);
    });
  }

  const ServeOptions& options_;
  Surroundings around_;
  Store& store_;
  Jobs& jobs_;
  Gate gate_;
  Metrics metrics_;
  GuardOptions guard_;
  RequestSchemas schemas_;
  Page page_{options_.page};
  httplib::Server server_;
  std::atomic<bool> ended_{false};
};

}  // namespace

Status serve(const Catalog& catalog, const Planner& planner, const ServeOptions& options) {
  if (!is_own_address(options.address) && options.token.empty()) {
    return fail(ErrorCode::kUsage, fmt::format("anybody who reaches {} could use the service", options.address), "--address",
                "give a token in the environment variable LAYOUTBOX_TOKEN, or listen at 127.0.0.1");
  }
  LAYOUTBOX_CHECK(make_folder(options.folder / "jobs"));
  LAYOUTBOX_ASSIGN(Store store, Store::open(options.folder / "service.db"));
  Jobs jobs(store, catalog, options.folder / "jobs", options.longest_queue);
  return Service(catalog, planner, options, store, jobs).run();
}

}  // namespace layoutbox::serve
