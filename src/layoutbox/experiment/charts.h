// The measures of all methods as one picture, for the report's page.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "layoutbox/experiment/tables.h"

namespace layoutbox::experiment {

// An SVG: a row a method, a column a measure, in each a dot at the share and a line over its 95 % interval.
std::string shares_chart(const std::vector<std::pair<std::string, Records>>& groups);

}  // namespace layoutbox::experiment
