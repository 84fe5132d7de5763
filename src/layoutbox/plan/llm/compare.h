// The model's scene beside what the offline planner reads: counts, sizes and relations. The model is believed where the two differ, save
// in what is beyond doubt (evidence.h).
#pragma once

#include <set>
#include <string>
#include <vector>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/plan/llm/draft.h"
#include "layoutbox/plan/planner.h"

namespace layoutbox::llm {

// Whom to believe where the model's scene is not what the text says outright.
enum class Trust {
  kText,   // the text where it is beyond doubt: what is missing is added, what is too much left out, sizes are set right
  kModel,  // the model: differences are listed only
};

// What is set right after the text where that is beyond doubt; all else is listed only.
struct Settling {
  bool objects = true;
  bool room = true;
  bool room_may_grow = false;  // after a conflict: a larger room is a way out, and its doors and windows may change
  bool sizes_and_relations = true;
  // Categories of which things may be missing, and how many of all: the model was asked to choose.
  std::set<std::string> open;
  std::size_t may_be_missing = 0;
};

// One sentence for each difference; each is also a note of the scene, and its document follows what is settled.
// Nothing is compared that the offline planner only assumed or concluded.
std::vector<std::string> compare_with_text(const Plan& read_offline, const Catalog& catalog, const Settling& settling, Draft& draft);

}  // namespace layoutbox::llm
