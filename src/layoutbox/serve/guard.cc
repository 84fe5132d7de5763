#include "layoutbox/serve/guard.h"

#include <fmt/format.h>

#include <array>

namespace layoutbox::serve {
namespace {

Refusal forbidden(std::string message, std::string hint) {
  return {403, Error{ErrorCode::kUsage, std::move(message), {}, std::move(hint), {}}};
}

// "localhost:8080" is ours; a name of somebody else's that leads to this machine is not.
bool is_own_host(const GuardOptions& options, std::string_view host) {
  for (const std::string_view name : {"localhost", "127.0.0.1", "[::1]"}) {
    if (host == fmt::format("{}:{}", name, options.port) || (options.port == 80 && host == name)) return true;
  }
  return false;
}

std::string cookie_value(std::string_view cookies, std::string_view name) {
  while (!cookies.empty()) {
    const std::size_t end = std::min(cookies.find(';'), cookies.size());
    std::string_view one = cookies.substr(0, end);
    while (!one.empty() && one.front() == ' ') one.remove_prefix(1);
    if (one.size() > name.size() && one.starts_with(name) && one[name.size()] == '=') return std::string(one.substr(name.size() + 1));
    cookies.remove_prefix(std::min(end + 1, cookies.size()));
  }
  return {};
}

bool has_token(const GuardOptions& options, const Headers& headers) {
  const std::string given = headers("authorization");
  constexpr std::string_view kBearer = "Bearer ";
  if (given.starts_with(kBearer)) return same_secret(std::string_view(given).substr(kBearer.size()), options.token);
  return same_secret(cookie_value(headers("cookie"), kTokenCookie), options.token);
}

}  // namespace

bool is_own_address(std::string_view address) { return address == "127.0.0.1" || address == "localhost" || address == "::1"; }

bool same_secret(std::string_view a, std::string_view b) {
  unsigned difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  }
  return difference == 0;
}

std::optional<Refusal> refusal(const GuardOptions& options, std::string_view method, const Headers& headers) {
  const std::string host = headers("host"), origin = headers("origin"), site = headers("sec-fetch-site");
  if (options.loopback && !is_own_host(options, host)) {
    return forbidden(fmt::format("this service does not go by the name \"{}\"", host), fmt::format("ask 127.0.0.1:{}", options.port));
  }
  if (!origin.empty() && origin != "http://" + host && origin != "https://" + host) {
    return forbidden("another site's page asks", "use the page that this service serves");
  }
  if (site == "cross-site" && method != "GET") return forbidden("another site's page asks", "use the page that this service serves");
  if (options.token.empty() || has_token(options, headers)) return std::nullopt;
  return Refusal{401, Error{ErrorCode::kUsage,
                            "a token is needed",
                            {},
                            "send \"Authorization: Bearer TOKEN\", or open the address that the service printed",
                            {}}};
}

}  // namespace layoutbox::serve
