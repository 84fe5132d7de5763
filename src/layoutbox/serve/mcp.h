// The calls for clients of language models: Model Context Protocol, JSON-RPC 2.0 in lines.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "layoutbox/serve/calls.h"

namespace layoutbox::serve {

// One session; knows nothing of stdin and stdout.
class McpSession {
 public:
  explicit McpSession(const Surroundings& around) : around_(around) {}
  // The answer to one message, as one line without its break; nothing where none is due (notifications, answers).
  std::optional<std::string> answer(std::string_view line) const;

 private:
  nlohmann::json result_of(const std::string& method, const nlohmann::json& parameters) const;
  nlohmann::json call_tool(const nlohmann::json& parameters) const;

  Surroundings around_;
  RequestSchemas schemas_;
};

}  // namespace layoutbox::serve
