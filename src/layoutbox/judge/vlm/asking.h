// How a vision model is asked: what it is told of its task, its pictures, the function that it calls with its answer.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/judge/vlm/vlm_judge.h"

namespace layoutbox::vlm {

// "its floor plan, seen from its door"
std::string views_of(const std::vector<Picture>& pictures);

struct Asking {
  std::string_view task;  // what it judges, and by what; how sides are meant is said to all alike
  std::string text;       // the question
  std::vector<const Picture*> pictures;
  chat::Function function;  // of one answer
  std::uint64_t seed = 1;   // of a repeat
};
chat::Request request_for(Asking asking, const JudgeOptions& options);

// The arguments of the call, or the text as JSON where there is no call; null where it is neither.
nlohmann::json document_of(const chat::Response& response);
// Empty where there is none, or no text.
std::string member_text(const nlohmann::json& document, const char* key);

}  // namespace layoutbox::vlm
