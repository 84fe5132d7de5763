#include "layoutbox/serve/methods.h"

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <vector>

#include "layoutbox/serve/calls.h"

namespace layoutbox::serve {
namespace {

struct CallAddress {
  std::vector<std::string> segments;
  std::string allowed;
};

std::vector<std::string> segments_of(std::string_view path) {
  std::vector<std::string> segments;
  while (!path.empty()) {
    path.remove_prefix(1);
    const std::size_t end = std::min(path.find('/'), path.size());
    segments.emplace_back(path.substr(0, end));
    path.remove_prefix(end);
  }
  return segments;
}

bool is_known_method(const std::string& word) { return word == "get" || word == "post" || word == "delete" || word == "put"; }

std::vector<CallAddress> read_addresses() {
  std::vector<CallAddress> addresses;
  const auto document = nlohmann::json::parse(openapi_text());
  for (const auto& [path, operations] : document.at("paths").items()) {
    CallAddress address{segments_of(path), {}};
    for (const auto& [word, operation] : operations.items()) {
      if (!is_known_method(word)) continue;
      std::string method = word;
      std::ranges::transform(method, method.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
      address.allowed += (address.allowed.empty() ? "" : ", ") + (method == "GET" ? "GET, HEAD" : method);
    }
    addresses.push_back(std::move(address));
  }
  return addresses;
}

// "{id}" stands for anything.
bool fits(const std::vector<std::string>& pattern, const std::vector<std::string>& segments) {
  return std::ranges::equal(pattern, segments, [](const std::string& p, const std::string& s) { return p == s || p.starts_with('{'); });
}

}  // namespace

std::string allowed_methods(std::string_view path) {
  static const std::vector<CallAddress> addresses = read_addresses();
  const std::vector<std::string> segments = segments_of(path);
  const auto exact = std::ranges::find_if(addresses, [&](const CallAddress& a) { return a.segments == segments; });
  if (exact != addresses.end()) return exact->allowed;
  const auto found = std::ranges::find_if(addresses, [&](const CallAddress& a) { return fits(a.segments, segments); });
  return found == addresses.end() ? std::string{} : found->allowed;
}

bool is_allowed(std::string_view method, std::string_view allowed) {
  return method == "OPTIONS" || (", " + std::string(allowed) + ",").find(", " + std::string(method) + ",") != std::string::npos;
}

}  // namespace layoutbox::serve
