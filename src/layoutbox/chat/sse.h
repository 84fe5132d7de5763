// A streamed answer (server-sent events), put together again.
#pragma once

#include <nlohmann/json.hpp>
#include <string_view>

namespace layoutbox::chat {

bool is_event_stream(std::string_view content_type, std::string_view body);

struct StreamedAnswer {
  nlohmann::json message;  // as if it had not been streamed: choices[0].message, finish_reason, usage; or an error object
  bool ended = false;      // it said that it was at its end
  bool valid = true;       // every piece was JSON
};

// Lines end in LF, CR or CRLF, comments and other fields are left out, an event may have several data lines.
StreamedAnswer join_event_stream(std::string_view body);

}  // namespace layoutbox::chat
