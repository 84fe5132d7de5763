// What was asked of a model, kept.
#pragma once

#include <string>
#include <vector>

#include "layoutbox/plan/llm/conversation.h"

namespace layoutbox::llm {

// run.json's list of what was asked of a model: an object for each attempt.
std::string write_attempts(const std::vector<Attempt>& attempts);

}  // namespace layoutbox::llm
