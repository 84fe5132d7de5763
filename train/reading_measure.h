// How well scene graphs say what descriptions say: relations by kind and the names of things; nothing is solved.
#pragma once

#include <string>
#include <vector>

#include "layoutbox/plan/planner.h"

namespace layoutbox::reading {

// A relation that a description speaks of.
struct Wanted {
  std::vector<RelationType> any;  // each of these says it
  std::string subject, object;    // words for things; `object` empty: no matter what
  int count = 1;                  // of the subject
  bool both = false;              // holds the other way round as well
};

struct Description {
  std::string id, prompt;
  bool exact = false;  // `wanted` is all that it says
  std::vector<Wanted> wanted;
};

struct Tally {
  double wanted = 0, found = 0;  // relations spoken of, and those that the scene graph has
  double made = 0, wrong = 0;    // relations of exact descriptions that were asked for, and those that nothing speaks of
  double recall() const { return wanted > 0 ? 100 * found / wanted : 100; }
  double precision() const { return made > 0 ? 100 * (made - wrong) / made : 100; }
};

// What train/reading_targets.py writes; empty where the file cannot be read.
std::vector<Description> read_descriptions(const std::string& path);

// Adds to `tally`; `misses`: a line for each relation that is lacking or wrong, or null.
void measure(const Catalog& catalog, const Description& description, const SceneGraph& scene, Tally& tally,
             std::vector<std::string>* misses = nullptr);

}  // namespace layoutbox::reading
