// reading_score: how well descriptions are read, at the level of the scene graph (docs/reading-measured.md).
//
//   reading_score [--misses] TARGETS.jsonl …       TARGETS: what reading_targets.py writes
#include <cstdio>
#include <iostream>

#include "reading_measure.h"

int main(int count, char** arguments) {
  using namespace layoutbox;
  const Catalog& catalog = Catalog::builtin();
  const auto planner = make_offline_planner(catalog);
  bool list = false;
  for (int i = 1; i < count; ++i) {
    const std::string path = arguments[i];
    if (path == "--misses") {
      list = true;
      continue;
    }
    reading::Tally tally;
    for (const reading::Description& description : reading::read_descriptions(path)) {
      auto plan = planner->plan(description.prompt, {});
      std::vector<std::string> misses;
      reading::measure(catalog, description, plan ? plan->scene : SceneGraph{}, tally, &misses);
      if (!list || misses.empty()) continue;
      std::cout << "# " << description.id << ": " << description.prompt << "\n";
      for (const std::string& miss : misses) std::cout << "    " << miss << "\n";
    }
    std::printf("%-40s recall %5.1f (%.0f of %.0f)", path.c_str(), tally.recall(), tally.found, tally.wanted);
    if (tally.made > 0) std::printf("   precision %5.1f (%.0f of %.0f)", tally.precision(), tally.made - tally.wrong, tally.made);
    std::printf("\n");
  }
}
