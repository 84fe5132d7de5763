// What the providers' forms have in common in JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "layoutbox/base/bytes.h"
#include "layoutbox/chat/provider.h"
#include "layoutbox/chat/sse.h"

namespace layoutbox::chat {

// Schemas are written by this program, so they parse.
nlohmann::ordered_json schema_of(const Function& function);

// What a model hears that has to answer in plain JSON.
std::string plain_json_wish(const Function& function);

// A text, a number or parts of a text; empty where there is none.
std::string text_of(const nlohmann::json& object, const char* key);
std::int64_t count_of(const nlohmann::json& usage, const char* key);
ServerError error_from(const nlohmann::json& body);

// A response that is none.
ReadResponse broken(std::string why);

// The JSON of a response, streamed ones put together by `join`. Empty where it is no answer; `read` then says why.
std::optional<nlohmann::json> body_of(const HttpResponse& response, StreamedResponse (*join)(std::string_view), ReadResponse& read);

}  // namespace layoutbox::chat
