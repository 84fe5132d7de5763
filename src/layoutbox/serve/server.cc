#include "layoutbox/serve/server.h"

#include <fmt/format.h>
#include <httplib.h>

#include <chrono>
#include <thread>

#include "layoutbox/base/files.h"
#include "layoutbox/serve/http.h"
#include "layoutbox/serve/methods.h"
#include "layoutbox/serve/site.h"

namespace layoutbox::serve {
namespace {

constexpr int kThreads = 32;  // connections at a time: event streams hold one each

void set_limits(httplib::Server& server, const ServeOptions& options) {
  server.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
  server.set_payload_max_length(options.largest_body);
  server.set_keep_alive_max_count(1000);
  server.set_tcp_nodelay(true);
  server.set_socket_options([](socket_t socket) {  // not SO_REUSEPORT, by which two services would share a port
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
}

// The body of a request that is refused is not read: it must not be taken for the next request of the same connection.
void end_connection(httplib::Response& response) { response.set_header("Connection", "close"); }

// The library reads bodies of the other methods only.
bool leaves_body(const httplib::Request& request) {
  const bool is_without = request.method == "GET" || request.method == "HEAD" || request.method == "OPTIONS";
  return is_without && (request.has_header("Content-Length") || request.has_header("Transfer-Encoding"));
}

void put_foreign_method(const std::string& allowed, httplib::Response& response) {
  response.set_header("Allow", allowed.empty() ? "GET, HEAD, POST, DELETE" : allowed);
  end_connection(response);
  put_error(response, 405,
            {ErrorCode::kUsage, "this address does not know this method", {}, "GET /api/openapi.json lists what there is", {}});
}

void add_guard(httplib::Server& server, Site& site) {
  server.set_pre_routing_handler([&site](const httplib::Request& request, httplib::Response& response) {
    set_headers(response);
    if (leaves_body(request)) end_connection(response);
    if (site.gives_token(request)) return httplib::Server::HandlerResponse::Unhandled;
    const auto refused =
        refusal(site.guard, request.method, [&](std::string_view name) { return request.get_header_value(std::string(name).c_str()); });
    if (const std::string allowed = allowed_methods(request.path); !refused && !allowed.empty() && !is_allowed(request.method, allowed)) {
      put_foreign_method(allowed, response);
      return httplib::Server::HandlerResponse::Handled;
    }
    if (!refused) return httplib::Server::HandlerResponse::Unhandled;
    end_connection(response);
    put_error(response, refused->status, refused->error);
    site.metrics.add("refused", refused->status, 0);
    return httplib::Server::HandlerResponse::Handled;
  });
  server.set_error_handler([](const httplib::Request& request, httplib::Response& response) {
    set_headers(response);
    if (!response.body.empty()) return;
    // Methods that the library does not know are refused by it before they come to the guard.
    if (response.status == 400 && !request.method.empty() && request.path.empty()) {
      put_foreign_method({}, response);
    } else if (response.status == 413) {
      end_connection(response);
      put_error(response, 413, {ErrorCode::kTooLarge, "the request is too large", {}, {}, {}});
    } else if (response.status == 404) {
      put_nothing_there(response);
    } else {
      end_connection(response);
      put_error(response, response.status, {ErrorCode::kParse, "the request cannot be read", {}, {}, {}});
    }
  });
  server.set_exception_handler([](const httplib::Request&, httplib::Response& response, std::exception_ptr) {
    put_error(response, 500, {ErrorCode::kInternal, "a bug in the service; please report it", {}, {}, {}});
  });
}

// The port that it listens at.
Result<int> bind(httplib::Server& server, const ServeOptions& options) {
  const int port = options.port == 0 ? server.bind_to_any_port(options.address.c_str()) : options.port;
  const bool bound = options.port == 0 ? port > 0 : server.bind_to_port(options.address.c_str(), options.port);
  if (bound) return port;
  return fail(ErrorCode::kIo, fmt::format("{}:{} cannot be listened at", options.address, options.port), "--port",
              "another program may be there: choose another port, or 0 for any that is free");
}

Status run(Site& site, const ServeOptions& options) {
  httplib::Server server;
  set_limits(server, options);
  add_guard(server, site);
  add_call_routes(server, site);
  add_job_routes(server, site);
  add_room_routes(server, site);
  add_status_routes(server, site);
  add_page_routes(server, site);
  LAYOUTBOX_ASSIGN(site.guard.port, bind(server, options));
  std::thread watch([&] {
    while (!site.ending()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    server.stop();
  });
  const std::string host = options.address == "::1" ? "[::1]" : options.address;
  if (options.on_ready) options.on_ready(fmt::format("http://{}:{}/", host, site.guard.port));
  server.listen_after_bind();
  site.ended = true;
  watch.join();
  return {};
}

}  // namespace

Status serve(const Surroundings& around, const ServeOptions& options) {
  if (!is_own_address(options.address) && options.token.empty()) {
    return fail(ErrorCode::kUsage, fmt::format("anybody who reaches {} could use the service", options.address), "--address",
                "give a token in the environment variable LAYOUTBOX_TOKEN, or listen at 127.0.0.1");
  }
  LAYOUTBOX_CHECK(make_folder(options.folder / "jobs"));
  LAYOUTBOX_ASSIGN(Store store, Store::open(options.folder / "service.db"));
  Jobs jobs(store, around.catalog, options.folder / "jobs", options.longest_queue);
  Site site(around, options, store, jobs);
  return run(site, options);
}

}  // namespace layoutbox::serve
