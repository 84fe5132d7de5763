// The rooms of an experiment side by side, for the report's page.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "layoutbox/experiment/experiment.h"
#include "layoutbox/experiment/suite.h"

namespace layoutbox::experiment {

// How things are drawn, said once: most of a plan's bytes would else say it again and again.
class PlanStyles {
 public:
  // The plan with a class in the place of each element's own fill and stroke.
  std::string shared(const std::string& svg);
  std::string css() const;

 private:
  std::map<std::string, std::size_t> classes_;
};

// For each prompt the first repetition of each method: picture, plan, what is missing. Methods that made the same room share one.
std::string rooms_side_by_side(const Suite& suite, const ExperimentOutcome& outcome, const std::filesystem::path& folder,
                               PlanStyles& styles);

}  // namespace layoutbox::experiment
