// Which methods the addresses of the OpenAPI document know.
#pragma once

#include <string>
#include <string_view>

namespace layoutbox::serve {

// "GET, HEAD, POST" for the path of a request ("/api/rooms/00ff"), as an Allow header has it; empty for a path that the document does not
// have.
std::string allowed_methods(std::string_view path);

// Whether a method is one of those, or one that every address answers (OPTIONS).
bool is_allowed(std::string_view method, std::string_view allowed);

}  // namespace layoutbox::serve
