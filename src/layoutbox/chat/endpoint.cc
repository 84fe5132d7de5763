#include "layoutbox/chat/endpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "layoutbox/base/plain_text.h"
#include "layoutbox/base/utf8.h"
#include "layoutbox/chat/provider.h"
#include "layoutbox/chat/redaction.h"

namespace layoutbox::chat {
namespace {

std::string from_environment(std::string_view name) {
  const char* const value = std::getenv(std::string(name).c_str());
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
  if (url.find("://") == std::string_view::npos) return {};
  const std::string_view authority = authority_of(url);
  if (authority.starts_with('[')) return authority.substr(1, authority.find(']') - 1);
  return authority.substr(0, authority.find(':'));
}

// The one that was named, else the one whose own address was, else OpenAI's.
Result<const Provider*> chosen_provider(const EndpointChoice& choice) {
  const std::string name = trimmed(choice.provider.empty() ? from_environment("LAYOUTBOX_PROVIDER") : choice.provider);
  if (name.empty()) {
    for (const Provider* one : providers()) {
      if (host_of(choice.base_url) == host_of(one->facts().address)) return one;
    }
    return &openai_provider();
  }
  if (const Provider* found = find_provider(name)) return found;
  std::string names;
  for (const Provider* one : providers()) names += fmt::format("{}{}", names.empty() ? "" : ", ", one->facts().name);
  return fail(ErrorCode::kUsage, fmt::format("there is no provider \"{}\"", one_line(name, 60)),
              choice.provider.empty() ? "LAYOUTBOX_PROVIDER" : "--provider", "use one of: " + names);
}

}  // namespace

Result<Endpoint> find_endpoint(const EndpointChoice& choice) {
  Endpoint endpoint;
  LAYOUTBOX_ASSIGN(endpoint.provider, chosen_provider(choice));
  const Provider::Facts& facts = endpoint.provider->facts();
  const bool own_address = choice.base_url.empty();
  endpoint.base_url = trimmed(own_address ? from_environment(facts.address_variable) : choice.base_url);
  if (endpoint.base_url.empty()) endpoint.base_url = facts.address;
  while (endpoint.base_url.ends_with('/')) endpoint.base_url.pop_back();
  const std::string where(own_address ? facts.address_variable : "--base-url");
  const std::string_view url = endpoint.base_url;
  if (!is_printable(url) || !(url.starts_with("http://") || url.starts_with("https://")) || host_of(url).empty()) {
    return fail(ErrorCode::kUsage, fmt::format("'{}' is no address of a server", one_line(url, 100)), where,
                "write it as http://127.0.0.1:8080/v1");
  }
  if (authority_of(url).find('@') != std::string_view::npos) {
    return fail(ErrorCode::kUsage, "an address must not hold a name or a password", where,
                fmt::format("give the key in {}", facts.key_variable));
  }
  endpoint.model = trimmed(choice.model.empty() ? from_environment("LAYOUTBOX_MODEL") : choice.model);
  if (endpoint.model.empty()) endpoint.model = facts.model;
  endpoint.key = trimmed(from_environment(facts.key_variable));
  if (!is_printable(endpoint.key)) {  // the key itself is never shown
    return fail(ErrorCode::kUsage, "the key holds characters that no key has", std::string(facts.key_variable),
                "give the key alone, on one line");
  }
  return endpoint;
}

bool is_local(const Endpoint& endpoint) {
  const std::string_view host = host_of(endpoint.base_url);
  return host == "localhost" || host.starts_with("127.") || host == "::1";
}

Status check_key(const Endpoint& endpoint) {
  const Provider::Facts& facts = endpoint.provider->facts();
  if (!endpoint.key.empty() || host_of(endpoint.base_url) != host_of(facts.address)) return {};
  return fail(ErrorCode::kNetwork, fmt::format("{} wants a key, and none is set", host_of(facts.address)), std::string(facts.key_variable),
              fmt::format("set {}; or {} to a server of your own; or leave out --planner llm", facts.key_variable, facts.address_variable));
}

std::string without_key(std::string text, const Endpoint& endpoint) {
  if (endpoint.key.size() < kShortestSecret) return text;
  return without_secret(text, endpoint.key);
}

std::string one_line(std::string_view text, std::size_t most) {
  std::string line;
  for (const char c : plain_text(text)) {
    if (c != ' ' || (!line.empty() && line.back() != ' ')) line += c;
  }
  while (line.ends_with(' ')) line.pop_back();
  if (line.size() > most) line = std::string(first_bytes(line, most)) + "…";
  return line;
}

}  // namespace layoutbox::chat
