// A streamed answer (server-sent events), put together again.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace layoutbox::chat {

bool is_event_stream(std::string_view content_type, std::string_view body);

// The data of each event. Lines end in LF, CR or CRLF, comments and other fields are left out, an event may have several data lines.
std::vector<std::string> events_of(std::string_view body);

struct StreamedResponse {
  nlohmann::json message;  // as if it had not been streamed; or an error object
  bool ended = false;      // it said that it was at its end
  bool valid = true;       // every piece was JSON
};

// Of OpenAI's form.
StreamedResponse join_event_stream(std::string_view body);

}  // namespace layoutbox::chat
