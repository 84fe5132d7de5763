// The forms in which a model's server can be asked, for the help of --provider.
#pragma once

#include <string>

#include "layoutbox/chat/provider.h"

namespace layoutbox::cli {

// "openai or anthropic"
inline std::string provider_names() {
  std::string names;
  for (const chat::Provider* one : chat::providers()) {
    if (!names.empty()) names += " or ";
    names += one->facts().name;
  }
  return names;
}

}  // namespace layoutbox::cli
