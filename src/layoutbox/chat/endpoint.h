// Where a model is asked, in which form, and with which key.
#pragma once

#include <string>
#include <string_view>

#include "layoutbox/base/result.h"

namespace layoutbox::chat {

class Provider;
const Provider& openai_provider();

struct Endpoint {
  std::string base_url;  // without a slash at its end: "https://api.openai.com/v1"
  std::string model;
  std::string key;  // empty: none is sent
  const Provider* provider = &openai_provider();
};

// What was said on the command line; empty members come from LAYOUTBOX_PROVIDER, LAYOUTBOX_MODEL and the provider's own variable
// (OPENAI_BASE_URL, ANTHROPIC_BASE_URL), else from its defaults. The provider is that of OpenAI's form, save where the address is another's
// own. The key comes from the provider's variable alone (OPENAI_API_KEY, ANTHROPIC_API_KEY), so that it stands in no list of processes.
struct EndpointChoice {
  std::string base_url, model, provider = {};
};

// Errors: kUsage for a provider that is not there, an address that is none or carries a password, for a key that is no line of printable
// characters.
Result<Endpoint> find_endpoint(const EndpointChoice& choice = {});

// True where the address names this machine: no key is needed, nothing is paid.
bool is_local(const Endpoint& endpoint);

// kNetwork where the server will want a key and there is none.
Status check_key(const Endpoint& endpoint);

// Servers at home take any word for a key ("x", "none"): what is shorter than this is no secret.
inline constexpr std::size_t kShortestSecret = 8;

// The text without the key, however it stands in it (redaction.h). As it is where the key is no secret.
std::string without_key(std::string text, const Endpoint& endpoint);

// Text of a server for people: one line without control characters, at most `most` bytes, cut between characters.
std::string one_line(std::string_view text, std::size_t most = 300);

}  // namespace layoutbox::chat
