// Which language a text is written in, where it is not English.
#pragma once

#include <optional>
#include <string>

#include "layoutbox/plan/offline/document.h"

namespace layoutbox::offline {

// The name of the other language whose small words make up much of the text; none for English, and for texts too short to tell.
std::optional<std::string> foreign_language(const Document& document);

}  // namespace layoutbox::offline
