// The table of providers, and what holds for all of them.
#include <fmt/format.h>

#include <array>

#include "layoutbox/base/bytes.h"
#include "layoutbox/chat/provider.h"
#include "layoutbox/chat/provider_json.h"

namespace layoutbox::chat {

std::span<const Provider* const> providers() {
  static const std::array all = {&openai_provider(), &anthropic_provider()};
  return all;
}

const Provider* find_provider(std::string_view name) {
  for (const Provider* one : providers()) {
    if (one->facts().name == name) return one;
  }
  return nullptr;
}

const char* name_of(Mode mode) {
  switch (mode) {
    case Mode::kStrictTools: return "strict function";
    case Mode::kTools: return "function";
    case Mode::kJsonSchema: return "JSON schema";
    case Mode::kJson: return "plain JSON";
  }
  return "";
}

ServerError Provider::read_error(std::string_view body) const {
  const nlohmann::json json = nlohmann::json::parse(body, nullptr, false);
  if (json.is_object()) return error_from(json);
  const std::size_t begin = body.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  return body[begin] == '<' ? ServerError{"a web page", {}, {}} : ServerError{one_line(body.substr(begin), 200), {}, {}};
}

std::string without_images(std::string body, const Request& request) {
  for (const Message& message : request.messages) {
    for (const Image& image : message.images) {
      // An address may be signed, which is nobody else's business, and anew for each run.
      const std::string data = image.url.empty() ? base64(image.bytes) : image.url;
      const std::size_t at = data.empty() ? std::string::npos : body.find(data);
      if (at == std::string::npos) continue;
      body.replace(at, data.size(),
                   fmt::format("[{}{} bytes, {}]", image.url.empty() ? "" : "by address, ", image.bytes.size(), content_key(image.bytes)));
    }
  }
  return body;
}

}  // namespace layoutbox::chat
