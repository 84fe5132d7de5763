#include "layoutbox/serve/site.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

#include "layoutbox/serve/http.h"

namespace layoutbox::serve {
namespace {

int places(const ServeOptions& options) {
  return options.workers > 0 ? options.workers : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

}  // namespace

Site::Site(const Surroundings& surroundings, const ServeOptions& options, Store& kept, Jobs& work)
    : around(surroundings), store(kept), jobs(work), gate(places(options), options.longest_queue), page(options.page) {
  guard.loopback = is_own_address(options.address);
  guard.token = options.token;
}

std::optional<nlohmann::json> Site::read_body(const std::string& operation, const httplib::Request& request,
                                              httplib::Response& response) const {
  if (!request.get_header_value("Content-Type").starts_with("application/json")) {
    put_error(response, 415, {ErrorCode::kUsage, "the body must be JSON", "Content-Type", "send Content-Type: application/json", {}});
    return std::nullopt;
  }
  auto body = schemas.read(operation, request.body);
  if (body) return *std::move(body);
  put_error(response, body.error());
  return std::nullopt;
}

bool Site::ending() const { return ended || (around.stop != nullptr && around.stop->load()); }

bool Site::gives_token(const httplib::Request& request) const {
  return !guard.token.empty() && request.method == "GET" && request.path == "/" && request.has_param("token") &&
         same_secret(request.get_param_value("token"), guard.token);
}

}  // namespace layoutbox::serve
