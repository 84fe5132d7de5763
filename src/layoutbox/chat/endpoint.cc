#include "layoutbox/chat/endpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "layoutbox/base/plain_text.h"

namespace layoutbox::chat {
namespace {

constexpr const char* kDefaultAddress = "https://api.openai.com/v1";
constexpr const char* kDefaultModel = "gpt-4o";

std::string from_environment(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr ? value : "";
}

std::string trimmed(std::string text) {
  const auto is_blank = [](unsigned char c) { return c <= ' '; };
  text.erase(text.begin(), std::ranges::find_if_not(text, is_blank));
  while (!text.empty() && is_blank(static_cast<unsigned char>(text.back()))) text.pop_back();
  return text;
}

bool is_printable(std::string_view text) {
  return std::ranges::all_of(text, [](unsigned char c) { return c > ' ' && c < 0x7F; });
}

// "https://user:secret@host:8080/v1" → "user:secret@host:8080".
std::string_view authority_of(std::string_view url) {
  const std::size_t begin = url.find("://") + 3;
  return url.substr(begin, std::min(url.find_first_of("/?#", begin), url.size()) - begin);
}

std::string_view host_of(std::string_view url) {
  const std::string_view authority = authority_of(url);
  if (authority.starts_with('[')) return authority.substr(1, authority.find(']') - 1);
  return authority.substr(0, authority.find(':'));
}

}  // namespace

Result<Endpoint> find_endpoint(const EndpointChoice& choice) {
  Endpoint endpoint;
  const bool own_address = choice.base_url.empty();
  endpoint.base_url = trimmed(own_address ? from_environment("OPENAI_BASE_URL") : choice.base_url);
  if (endpoint.base_url.empty()) endpoint.base_url = kDefaultAddress;
  while (endpoint.base_url.ends_with('/')) endpoint.base_url.pop_back();
  const char* const where = own_address ? "OPENAI_BASE_URL" : "--base-url";
  const std::string_view url = endpoint.base_url;
  if (!is_printable(url) || !(url.starts_with("http://") || url.starts_with("https://")) || host_of(url).empty()) {
    return fail(ErrorCode::kUsage, fmt::format("'{}' is no address of a server", one_line(url, 100)), where,
                "write it as http://127.0.0.1:8080/v1");
  }
  if (authority_of(url).find('@') != std::string_view::npos) {
    return fail(ErrorCode::kUsage, "an address must not hold a name or a password", where, "give the key in OPENAI_API_KEY");
  }
  endpoint.model = trimmed(choice.model.empty() ? from_environment("LAYOUTBOX_MODEL") : choice.model);
  if (endpoint.model.empty()) endpoint.model = kDefaultModel;
  endpoint.key = trimmed(from_environment("OPENAI_API_KEY"));
  if (!is_printable(endpoint.key)) {  // the key itself is never shown
    return fail(ErrorCode::kUsage, "the key holds characters that no key has", "OPENAI_API_KEY", "give the key alone, on one line");
  }
  return endpoint;
}

bool is_local(const Endpoint& endpoint) {
  const std::string_view host = host_of(endpoint.base_url);
  return host == "localhost" || host.starts_with("127.") || host == "::1";
}

Status check_key(const Endpoint& endpoint) {
  if (!endpoint.key.empty() || host_of(endpoint.base_url) != host_of(kDefaultAddress)) return {};
  return fail(ErrorCode::kNetwork, fmt::format("{} wants a key, and none is set", host_of(kDefaultAddress)), "OPENAI_API_KEY",
              "set OPENAI_API_KEY; or OPENAI_BASE_URL to a server of your own; or leave out --planner llm");
}

std::string without_key(std::string text, const Endpoint& endpoint) {
  constexpr std::string_view kInstead = "[key]";
  if (endpoint.key.size() < kShortestSecret) return text;
  for (std::size_t at = text.find(endpoint.key); at != std::string::npos; at = text.find(endpoint.key, at + kInstead.size())) {
    text.replace(at, endpoint.key.size(), kInstead);
  }
  return text;
}

std::string one_line(std::string_view text, std::size_t most) {
  std::string line;
  for (const char c : plain_text(text)) {
    const auto byte = static_cast<unsigned char>(c);
    const bool begins = (byte & 0xC0) != 0x80;
    if (line.size() >= most && begins) {
      line += "…";
      break;
    }
    if (byte > ' ') {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  while (line.ends_with(' ')) line.pop_back();
  return line;
}

}  // namespace layoutbox::chat
