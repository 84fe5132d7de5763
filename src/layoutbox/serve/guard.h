// Who may ask: only this machine's own pages and programs, unless a token says otherwise.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "layoutbox/serve/calls.h"

namespace layoutbox::serve {

struct GuardOptions {
  int port = 0;          // that the service listens at
  bool loopback = true;  // it is reached from this machine alone
  std::string token;     // empty: none is needed. REQUIRES: not empty unless loopback.
};

// A header's value by its name in lower case; empty where there is none.
using Headers = std::function<std::string(std::string_view name)>;

// Why a request is refused (401, 403), or nothing. Checks against pages of other origins (Origin, Sec-Fetch-Site), host names bound to this
// machine from outside (Host), and callers without the token (Authorization: Bearer …, or the cookie that the page gets).
struct Refusal {
  int status = 403;
  Error error;
};
std::optional<Refusal> refusal(const GuardOptions& options, std::string_view method, const Headers& headers);

// Reached from this machine alone.
bool is_own_address(std::string_view address);

// True where both have the same bytes; takes as long for any two of one length.
bool same_secret(std::string_view a, std::string_view b);

// The cookie that carries the token for the page.
inline constexpr std::string_view kTokenCookie = "layoutbox_token";

}  // namespace layoutbox::serve
