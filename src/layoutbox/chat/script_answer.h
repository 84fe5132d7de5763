// Scripts as answers of a model.
#pragma once

#include <string>

#include "layoutbox/chat/chat.h"

namespace layoutbox::chat {

// write_script(script), by which a model hands over Python for Blender.
Function script_function();

// The script of an answer: of the call, of JSON, of a fenced block, else all that was said.
std::string script_in(const Response& response);

}  // namespace layoutbox::chat
