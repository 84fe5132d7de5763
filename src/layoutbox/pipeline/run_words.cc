#include "layoutbox/pipeline/run_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "layoutbox/base/words.h"

namespace layoutbox {

std::string scene_in_words(const SceneGraph& scene) {
  return counted(scene.objects.size(), "object") + ", " + counted(scene.relations.size(), "relation");
}

std::string solved_in_words(const Layout& layout) {
  const auto held = std::count_if(layout.relations.begin(), layout.relations.end(), [](const auto& r) { return r.held; });
  const std::string given_up = layout.relaxed.empty() ? "" : fmt::format(", {} given up", layout.relaxed.size());
  return fmt::format("{} of {} held{} ({})", held, counted(layout.relations.size(), "relation"), given_up, layout.stats.solver);
}

std::string verified_in_words(const Report& report) {
  const auto failed = std::count_if(report.checks.begin(), report.checks.end(), [](const Check& c) { return c.required && !c.passed; });
  return failed == 0 ? fmt::format("all {} checks passed or warned", report.checks.size())
                     : counted(static_cast<std::size_t>(failed), "check") + " failed";
}

}  // namespace layoutbox
