#include "layoutbox/chat/http_client.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <mutex>

#include "layoutbox/chat/curl_library.h"

namespace layoutbox::chat {
namespace {

constexpr int kPollMs = 100;
constexpr long kConnectSeconds = 15;
constexpr double kLongestRetryAfter = 1e6;
constexpr std::size_t kFirstLook = 16384;

using HttpResult = tl::expected<HttpResponse, HttpFailure>;

struct Exchange {
  HttpResponse response;
  const HttpRequest& request;
  std::size_t next_look = kFirstLook;
  bool too_large = false;
};

// Each look reads the whole, so they grow apart.
bool is_enough(Exchange& exchange) {
  const std::string& body = exchange.response.body;
  if (!exchange.request.enough || body.size() < exchange.next_look) return false;
  exchange.next_look = body.size() + std::max(kFirstLook, body.size() / 8);
  return exchange.request.enough(body);
}

std::size_t on_body(char* data, std::size_t size, std::size_t count, void* user) {
  auto& exchange = *static_cast<Exchange*>(user);
  const std::size_t bytes = size * count;
  if (exchange.response.body.size() + bytes > exchange.request.max_bytes) {
    exchange.too_large = true;
    return 0;
  }
  exchange.response.body.append(data, bytes);
  exchange.response.left_off = is_enough(exchange);
  return exchange.response.left_off ? 0 : bytes;
}

bool same_word(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](char x, char y) { return (x | 0x20) == (y | 0x20); });
}

// Seconds, or a date of HTTP.
std::optional<double> seconds_from(std::string_view value) {
  double seconds = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), seconds);
  if (error == std::errc{} && end == value.data() + value.size()) return std::clamp(seconds, 0.0, kLongestRetryAfter);
  std::tm date{};
  if (strptime(std::string(value).c_str(), "%a, %d %b %Y %H:%M:%S GMT", &date) == nullptr) return std::nullopt;
  return std::clamp(std::difftime(timegm(&date), std::time(nullptr)), 0.0, kLongestRetryAfter);
}

std::size_t on_header(char* data, std::size_t size, std::size_t count, void* user) {
  auto& response = static_cast<Exchange*>(user)->response;
  const std::size_t bytes = size * count;
  const std::string_view line(data, bytes);
  const std::size_t colon = line.find(':');
  if (line.starts_with("HTTP/")) response.retry_after_s.reset();
  if (colon == std::string_view::npos) return bytes;
  const std::string_view name = line.substr(0, colon);
  std::string_view value = line.substr(colon + 1);
  while (!value.empty() && value.front() == ' ') value.remove_prefix(1);
  while (!value.empty() && static_cast<unsigned char>(value.back()) <= ' ') value.remove_suffix(1);
  if (same_word(name, "content-type")) response.content_type = value;
  if (same_word(name, "location")) response.location = value;
  if (same_word(name, "retry-after") && !response.retry_after_s) response.retry_after_s = seconds_from(value);
  if (same_word(name, "retry-after-ms")) {
    if (const auto ms = seconds_from(value)) response.retry_after_s = *ms / 1000;
  }
  return bytes;
}

HttpFault fault_of(CURLcode code) {
  switch (code) {
    case CURLE_COULDNT_RESOLVE_HOST:
    case CURLE_COULDNT_RESOLVE_PROXY: return HttpFault::kResolve;
    case CURLE_COULDNT_CONNECT: return HttpFault::kConnect;
    case CURLE_SSL_CONNECT_ERROR:
    case CURLE_PEER_FAILED_VERIFICATION:
    case CURLE_SSL_CACERT_BADFILE:
    case CURLE_SSL_CERTPROBLEM:
    case CURLE_SSL_CIPHER:
    case CURLE_USE_SSL_FAILED: return HttpFault::kTls;
    case CURLE_OPERATION_TIMEDOUT: return HttpFault::kTimeout;
    case CURLE_FILESIZE_EXCEEDED: return HttpFault::kTooLarge;
    case CURLE_PARTIAL_FILE:
    case CURLE_RECV_ERROR:
    case CURLE_SEND_ERROR:
    case CURLE_GOT_NOTHING:
    case CURLE_HTTP2:
    case CURLE_HTTP2_STREAM: return HttpFault::kCut;
    default: return HttpFault::kOther;
  }
}

HttpFailure failure_of(CURLcode code, const Exchange& exchange, const HttpRequest& request, const char* details) {
  if (exchange.too_large || code == CURLE_FILESIZE_EXCEEDED) {
    return {HttpFault::kTooLarge, fmt::format("the answer is larger than {} MB", request.max_bytes >> 20)};
  }
  if (code == CURLE_OPERATION_TIMEDOUT)
    return {HttpFault::kTimeout, fmt::format("no whole answer came within {:g} s", request.time_limit_s)};
  return {fault_of(code), details};
}

}  // namespace

// A handle that is given up while a name is looked up would wait for that; it is kept to the end of the process instead.
struct HttpClient::State {
  const CurlLibrary* curl = nullptr;
  CURLM* multi = nullptr;
  CURL* easy = nullptr;

  void release() {
    if (curl == nullptr) return;
    if (easy != nullptr) curl->easy_cleanup(easy);
    if (multi != nullptr) curl->multi_cleanup(multi);
    easy = nullptr, multi = nullptr;
  }

  void abandon() {
    static std::mutex mutex;
    static std::vector<void*> abandoned;
    const std::lock_guard lock(mutex);
    abandoned.insert(abandoned.end(), {easy, multi});
    easy = nullptr, multi = nullptr;
  }
};

HttpClient::HttpClient() : state_(std::make_unique<State>()) {}
HttpClient::~HttpClient() { state_->release(); }

HttpResult HttpClient::post(const HttpRequest& request, const std::atomic<bool>* stop) {
  const auto library = CurlLibrary::get();
  if (!library) return tl::unexpected(HttpFailure{HttpFault::kNoLibrary, library.error().message});
  const CurlLibrary& curl = **library;
  State& state = *state_;
  state.curl = &curl;
  if (state.multi == nullptr) state.multi = curl.multi_init();
  if (state.easy == nullptr) state.easy = curl.easy_init();
  if (state.multi == nullptr || state.easy == nullptr) return tl::unexpected(HttpFailure{HttpFault::kOther, "libcurl cannot start"});

  CURL* const easy = state.easy;
  Exchange exchange{{}, request};
  char details[CURL_ERROR_SIZE] = "";
  curl_slist* headers = nullptr;
  for (const std::string& header : request.headers) headers = curl.slist_append(headers, header.c_str());
  curl.easy_reset(easy);  // the connection stays
  curl.easy_setopt(easy, CURLOPT_URL, request.url.c_str());
  curl.easy_setopt(easy, CURLOPT_PROTOCOLS_STR, "http,https");
  curl.easy_setopt(easy, CURLOPT_FOLLOWLOCATION, 0L);
  curl.easy_setopt(easy, CURLOPT_SSL_VERIFYPEER, 1L);
  curl.easy_setopt(easy, CURLOPT_SSL_VERIFYHOST, 2L);
  if (const char* file = std::getenv("SSL_CERT_FILE"); file != nullptr && *file != '\0') curl.easy_setopt(easy, CURLOPT_CAINFO, file);
  curl.easy_setopt(easy, CURLOPT_NOSIGNAL, 1L);
  curl.easy_setopt(easy, CURLOPT_NETRC, static_cast<long>(CURL_NETRC_IGNORED));
  curl.easy_setopt(easy, CURLOPT_CONNECTTIMEOUT, kConnectSeconds);
  curl.easy_setopt(easy, CURLOPT_TIMEOUT_MS, std::max(1L, static_cast<long>(request.time_limit_s * 1000)));
  curl.easy_setopt(easy, CURLOPT_MAXFILESIZE_LARGE, static_cast<curl_off_t>(request.max_bytes));
  curl.easy_setopt(easy, CURLOPT_HTTPHEADER, headers);
  curl.easy_setopt(easy, CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(request.body.size()));
  curl.easy_setopt(easy, CURLOPT_POSTFIELDS, request.body.data());
  curl.easy_setopt(easy, CURLOPT_CUSTOMREQUEST, request.method.c_str());
  curl.easy_setopt(easy, CURLOPT_WRITEFUNCTION, &on_body);
  curl.easy_setopt(easy, CURLOPT_WRITEDATA, &exchange);
  curl.easy_setopt(easy, CURLOPT_HEADERFUNCTION, &on_header);
  curl.easy_setopt(easy, CURLOPT_HEADERDATA, &exchange);
  curl.easy_setopt(easy, CURLOPT_ERRORBUFFER, details);
  curl.multi_add_handle(state.multi, easy);

  CURLcode code = CURLE_OK;
  bool done = false;
  while (!done) {
    if (stop != nullptr && stop->load()) {
      state.abandon();  // with its headers, which libcurl may still read
      return tl::unexpected(HttpFailure{HttpFault::kStopped, "stopped"});
    }
    int running = 0, left = 0;
    curl.multi_perform(state.multi, &running);
    while (const CURLMsg* message = curl.multi_info_read(state.multi, &left)) {
      if (message->msg == CURLMSG_DONE) done = true, code = message->data.result;
    }
    if (!done) curl.multi_poll(state.multi, nullptr, 0, kPollMs, nullptr);
  }
  long status = 0;
  curl.easy_getinfo(easy, CURLINFO_RESPONSE_CODE, &status);
  curl.multi_remove_handle(state.multi, easy);
  curl.easy_setopt(easy, CURLOPT_ERRORBUFFER, nullptr);
  curl.slist_free_all(headers);
  exchange.response.status = static_cast<int>(status);
  if (code == CURLE_OK || exchange.response.left_off) return std::move(exchange.response);
  const char* const words = details[0] != '\0' ? details : curl.easy_strerror(code);
  return tl::unexpected(failure_of(code, exchange, request, words));
}

Result<std::string> describe_http_library() {
  LAYOUTBOX_ASSIGN(const CurlLibrary* curl, CurlLibrary::get());
  return std::string(curl->version());
}

}  // namespace layoutbox::chat
