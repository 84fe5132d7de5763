// The tables of an experiment's page.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "layoutbox/experiment/tables.h"

namespace layoutbox::experiment {

using MethodGroups = std::vector<std::pair<std::string, Records>>;

std::string methods_table(const MethodGroups& groups);
std::string cost_table(const MethodGroups& groups);  // time by stage, answers, tokens, money
std::string size_table(const MethodGroups& groups);
std::string failures_table(const MethodGroups& groups);
std::string four_table(const MethodGroups& groups);  // the vision model's judgements
std::string claims_table(const MethodGroups& groups);
// Empty where nothing was rated.
std::string ratings_part(const MethodGroups& groups, const std::vector<Rating>& ratings, std::size_t unknown);

}  // namespace layoutbox::experiment
