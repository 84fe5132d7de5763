// One request to a model and its response, in no provider's form.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace layoutbox::chat {

// How a server is made to answer in JSON, best first. Which of them it has is found out by asking once.
enum class Mode {
  kStrictTools,  // a function with `strict`, whose arguments follow the schema by force
  kTools,        // a function
  kJsonSchema,   // response_format with the schema
  kJson,         // response_format json_object, the schema in the text
};
const char* name_of(Mode mode);

struct Function {
  std::string name, description;
  std::string parameters;  // a JSON Schema, as text
  bool strict = false;     // the schema is in the strict form (every member required, none added)
};

struct Image {
  std::string media_type;  // "image/png", "image/jpeg"
  std::string bytes;       // the file's
  std::string url = {};    // where the server can fetch it; empty: it is sent along
};

struct Message {
  std::string role;  // "system", "user", "assistant"
  std::string content;
  std::vector<Image> images = {};  // before the content. REQUIRES: empty save for "user"
};

struct Request {
  std::vector<Message> messages;
  std::vector<Function> functions;        // the first is the one that plain JSON stands for. REQUIRES: at least one
  std::optional<double> temperature = 0;  // empty: the model's own, nothing is sent
  std::uint64_t seed = 1;
  int max_response_tokens = 8000;
  std::shared_ptr<const Request> shorter;  // the same in fewer words, for a model that cannot hold this one; may be null
};

struct Call {
  std::string name;
  std::string arguments;  // as the model wrote them: JSON or not
};

struct Usage {
  std::int64_t request_tokens = 0, response_tokens = 0;
  bool estimated = false;  // the server did not say
};

struct Response {
  std::vector<Call> calls;
  std::string content;
  std::string refusal;
  std::string finish_reason;  // "stop", "tool_calls", "length", "content_filter"…
  Usage usage;
  // How it was had.
  Mode mode = Mode::kStrictTools;
  bool cached = false;
  int retries = 0;
  double seconds = 0;          // all tries and waits
  double own_seconds = 0;      // of these not spent waiting for the server
  std::optional<double> cost;  // US dollars; empty where no price is known
  std::string request, body;   // what was sent and what came, without the key
};

}  // namespace layoutbox::chat
