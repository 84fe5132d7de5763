#include "layoutbox/chat/endpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "layoutbox/base/bytes.h"
#include "layoutbox/base/plain_text.h"
#include "layoutbox/base/utf8.h"
#include "layoutbox/chat/provider.h"

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

// Where a secret that begins at `begin` ends, blanks and line ends within it left out of account; 0 where none does.
std::size_t end_of_secret(std::string_view text, std::size_t begin, std::string_view secret) {
  std::size_t at = begin, matched = 0;
  for (; at < text.size() && matched < secret.size(); ++at) {
    if (text[at] == secret[matched]) {
      ++matched;
    } else if (matched == 0 || static_cast<unsigned char>(text[at]) > ' ') {
      return 0;
    }
  }
  return matched == secret.size() ? at : 0;
}

std::string without_secret(std::string text, std::string_view secret) {
  constexpr std::string_view kInstead = "[key]";
  for (std::size_t at = text.find(secret.front()); at != std::string::npos; at = text.find(secret.front(), at)) {
    const std::size_t end = end_of_secret(text, at, secret);
    if (end == 0) {
      ++at;
      continue;
    }
    text.replace(at, end - at, kInstead);
    at += kInstead.size();
  }
  return text;
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
  const std::string& key = endpoint.key;
  if (key.size() < kShortestSecret) return text;
  text = without_secret(std::move(text), key);
  for (std::size_t before = 0; before < 3; ++before) {  // bytes of a group of three that stand before it
    const std::string encoded = base64(std::string(before, '\0') + key);
    const std::size_t begin = (before * 8 + 5) / 6, end = (before + key.size()) * 8 / 6;
    text = without_secret(std::move(text), std::string_view(encoded).substr(begin, end - begin));
  }
  return text;
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
