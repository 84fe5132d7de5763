// What all publishers share: names, addresses, one request whose failure is told without credentials.
#pragma once

#include <atomic>
#include <string>

#include "layoutbox/chat/http_client.h"
#include "layoutbox/publish/publish.h"

namespace layoutbox::publish {

struct Address {
  std::string scheme, host, path;  // host with port; path without a slash at its end
};
// Errors: kUsage where it is no http(s) address, or carries a password. Plain http is for this machine alone.
Result<Address> read_address(const std::string& text, std::string_view setting);

// "0123456789abcdef.png".
std::string name_for(const File& file);

// Sends; the body of an answer with status 2xx. Errors: kNetwork, kInterrupted.
Result<std::string> send(const chat::HttpRequest& request, const Settings& settings, const std::atomic<bool>* stop);

// Now, as signatures have it: 20130524T000000Z; and in seconds.
std::string time_text();
std::string time_seconds();

}  // namespace layoutbox::publish
