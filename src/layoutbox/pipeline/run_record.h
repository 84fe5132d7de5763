// run.json: what a run was asked, what it used, what it took, and what it noted on the way.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "layoutbox/base/bytes.h"
#include "layoutbox/pipeline/generate.h"

namespace layoutbox {

// `failure` is the error that ended the run, or null. Pretty-printed JSON.
std::string write_run_record(std::string_view prompt, const GenerateOptions& options, const GenerateOutcome& outcome, const Error* failure);

// The options that a room depends on, its input files and the version, as text.
std::string options_text(const GenerateOptions& options);

enum class RunState { kDone, kNotAsAsked };

// How the run of a run.json ended, when it was this version's, of that prompt with those options and input files, and came to its end with
// all that was asked for (pictures too); else nothing.
std::optional<RunState> state_of_same_run(std::string_view record, std::string_view prompt, const GenerateOptions& options);

// {"code", "message", "pointer", "hint"[, "details"]}.
nlohmann::ordered_json json_of_error(const Error& error);

}  // namespace layoutbox
