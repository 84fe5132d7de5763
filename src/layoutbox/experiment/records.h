// Runs as lines of results.jsonl and rows of results.csv.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "layoutbox/experiment/experiment.h"

namespace layoutbox::experiment {

std::string line_of(const RunRecord& record);
// What a line holds of a run; its room is judged anew.
void read_line(const nlohmann::json& line, RunRecord& record);

// What the answers took, of MethodResult::requests: a list of objects with `tokens` {question, answer} and `cost`.
Spent spent_on(const std::string& requests);

std::string results_csv(const ExperimentOutcome& outcome);

}  // namespace layoutbox::experiment
