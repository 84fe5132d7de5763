// One HTTP request at a time, by libcurl, which is opened when the first request is made.
//
// Certificates are always checked, redirects never followed (so the key goes to the one server that was named), proxies taken from the
// environment (http_proxy, HTTPS_PROXY, NO_PROXY), certificates of one's own from SSL_CERT_FILE.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"

namespace layoutbox::chat {

struct HttpRequest {
  std::string url;
  std::vector<std::string> headers;  // "Name: value"
  std::string body;
  std::string method = "POST";       // or PUT
  double time_limit_s = 300;         // of the whole exchange. REQUIRES: > 0
  std::size_t max_bytes = 8u << 20;  // of the answer; a longer one is refused as soon as that is seen
  // Asked now and then while the answer comes: true where what has come is enough, and the rest is not waited for. May be empty.
  std::function<bool(std::string_view so_far)> enough;
};

struct HttpResponse {
  int status = 0;
  std::string content_type;
  std::string location;                 // where a redirect leads
  std::optional<double> retry_after_s;  // Retry-After or retry-after-ms
  std::string body;
  bool left_off = false;  // `enough` ended it
};

// Why there is no answer.
enum class HttpFault {
  kNoLibrary,  // libcurl is not there
  kResolve,    // the name of the server has no address
  kConnect,    // refused, unreachable
  kTls,        // no safe connection: certificate, protocol
  kCut,        // reset, or ended before it was whole
  kTimeout,
  kTooLarge,
  kStopped,  // `stop` was set
  kOther,
};

struct HttpFailure {
  HttpFault fault = HttpFault::kOther;
  std::string message;  // one sentence part: "the connection was refused"
};

class HttpClient {
 public:
  HttpClient();
  ~HttpClient();
  HttpClient(const HttpClient&) = delete;
  HttpClient& operator=(const HttpClient&) = delete;

  // Answers within a fifth of a second to `stop`, which may be null. A connection is kept for the next request.
  tl::expected<HttpResponse, HttpFailure> post(const HttpRequest& request, const std::atomic<bool>* stop);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Is libcurl there? Its version, or why not (kNetwork).
Result<std::string> describe_http_library();

}  // namespace layoutbox::chat
