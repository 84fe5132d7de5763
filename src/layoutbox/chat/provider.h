// The form in which a server is asked: a request to bytes, bytes to a response. One class a form, one row in providers.cc
// (docs/add-a-provider.md).
#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/chat/chat.h"
#include "layoutbox/chat/endpoint.h"
#include "layoutbox/chat/http_client.h"
#include "layoutbox/chat/tokens.h"

namespace layoutbox::chat {

// Every way of asking, best first.
inline constexpr Mode kAllModes[] = {Mode::kStrictTools, Mode::kTools, Mode::kJsonSchema, Mode::kJson};

// What is known of a server and a model: how it can be asked, which parameters it does not take, what it can hold.
struct Capabilities {
  Mode mode = Mode::kStrictTools;
  bool known = false;             // the mode has worked before
  Capacity capacity;              // what it can hold
  std::set<std::string> without;  // "temperature", "seed", "max_completion_tokens", "tool_choice", "named_tool", "response_format"
  std::span<const Mode> modes = kAllModes;  // those of the provider, best first; not kept
};

struct ServerError {
  std::string message, parameter, code;
  std::int64_t context = 0;  // tokens that the model can hold, where the error says so in a member of its own (llama.cpp)
};

// What came with status 2xx.
struct ReadResponse {
  enum class Kind {
    kResponse,
    kCut,     // a stream without its end
    kBroken,  // empty, no JSON, not UTF-8, or nothing in it that is an answer
    kPage,    // a web page: some other server answered
    kError,   // an error object in spite of the status
  } kind = Kind::kBroken;
  Response answer;
  ServerError error;  // kError; and what is wrong with a kBroken
};

class Provider {
 public:
  virtual ~Provider() = default;

  // Where it is and how it is named. All live as long as the program.
  struct Facts {
    std::string_view name;              // as in --provider
    std::string_view address, model;    // where none is said
    std::string_view address_variable;  // of the environment
    std::string_view key_variable;
    std::string_view address_hint;  // what such an address looks like: "the address usually ends in /v1"
  };
  virtual const Facts& facts() const = 0;
  // Best first. Never empty.
  virtual std::span<const Mode> modes() const { return kAllModes; }

  virtual std::string url(const Endpoint& endpoint) const = 0;
  // Those of the form and of the key: "Name: value".
  virtual std::vector<std::string> headers(const Endpoint& endpoint) const = 0;
  // The body of the request; of one that the model cannot hold a shorter form.
  virtual std::string write_request(const Request& asked, const std::string& model, const Capabilities& capabilities,
                                    bool stream) const = 0;
  // Of an answer with status 2xx, whole or streamed.
  virtual ReadResponse read_response(const HttpResponse& response) const = 0;
  // The error object of an answer that is none; the beginning of its text where it has no such object.
  virtual ServerError read_error(std::string_view body) const;
};

// OpenAI's chat completions, spoken by most servers at home and gateways too; and Anthropic's Messages.
const Provider& openai_provider();
const Provider& anthropic_provider();

// All of them, and the one of that name, or null.
std::span<const Provider* const> providers();
const Provider* find_provider(std::string_view name);

// A recorded request: each image by its kind, length and a key of its bytes, since they are long.
std::string without_images(std::string body, const Request& request);

}  // namespace layoutbox::chat
