// What the files of EditReader share.
#pragma once

#include <algorithm>
#include <vector>

#include "layoutbox/plan/edit/edit_reader.h"

namespace layoutbox::edit {

inline constexpr const char* kWhatToSay =
    "say for example: move the desk under the window; remove the rug; add a lamp on the desk; make the sofa red; swap the bed and the desk";

inline bool has(const std::vector<int>& all, int one) { return std::find(all.begin(), all.end(), one) != all.end(); }

inline bool is_everything(const offline::NounPhrase& noun) {
  return noun.head == "everything" || noun.head == "furniture" || noun.name == "everything else" || noun.head == "anything";
}

// "the opposite wall", "the other wall": of the one that the thing stands at.
inline bool is_opposite_wall(const offline::NounPhrase& noun) {
  const auto& said = noun.attributes;
  return noun.kind == offline::NounKind::kWall && noun.wall_word.empty() &&
         (noun.determiner == offline::Determiner::kOther || noun.wall_relation == "opposite" ||
          std::find(said.begin(), said.end(), "opposite") != said.end());
}

inline bool only_turns(const EditStep& step) {
  return std::all_of(step.relations.begin(), step.relations.end(), [](const Relation& r) { return r.type == RelationType::kFacing; });
}

}  // namespace layoutbox::edit
