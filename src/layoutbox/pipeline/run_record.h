// run.json: what a run was asked, what it used, what it took, and what it noted on the way.
#pragma once

#include <string>

#include "layoutbox/pipeline/generate.h"

namespace layoutbox {

// `failure` is the error that ended the run, or null. Pretty-printed JSON.
std::string write_run_record(std::string_view prompt, const GenerateOptions& options, const GenerateOutcome& outcome, const Error* failure);

}  // namespace layoutbox
