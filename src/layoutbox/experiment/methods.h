// The ways from a prompt to a room that are compared.
#pragma once

#include <map>
#include <span>
#include <string>

#include "layoutbox/chat/chat_client.h"
#include "layoutbox/pipeline/generate.h"

namespace layoutbox::experiment {

struct MethodInput {
  std::string prompt;
  std::uint64_t seed = 1;
  const Planner* model = nullptr;           // null: no model is at hand
  const chat::ChatOptions* chat = nullptr;  // how it is asked, for methods that are no planner's
  bool unsafe_scripts = false;              // run what a model wrote although there is no sandbox
  GenerateOptions options;                  // of the run: efforts, attempts
};

struct MethodResult {
  Layout layout;
  std::string outcome;                    // "solved", "relaxed", "fallback", "placed" (nobody promises anything)
  std::string structure;                  // a key of the scene graph: the same for the same structure
  std::map<std::string, double> seconds;  // by stage, of the wall clock
  std::string requests;                   // what was asked of a model, as a JSON list; empty: nothing
  // Why there is no layout although the method ran: "syntax", "run-time", "limit", "no script", "no room", "no scene"; and in words. Else
  // empty.
  std::string failure = {}, error = {};
};

struct Method {
  std::string_view name, about;
  bool needs_model;
  Result<MethodResult> (*run)(const MethodInput& input, const Catalog& catalog);
};

std::span<const Method> methods();
const Method* find_method(std::string_view name);

}  // namespace layoutbox::experiment
