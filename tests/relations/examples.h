// Every relation in two scenes: one in which it can hold, and one in which it cannot.
#pragma once

#include <vector>

#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {

struct Example {
  const char* relation;             // its JSON name
  void (*possible)(SceneMaker&);    // a room of 5.2 × 4.2 × 2.7 m
  void (*impossible)(SceneMaker&);  // a room of 3.0 × 3.0 × 2.6 m; the relation has a part in what clashes
};

inline RelationParameters with(void (*set)(RelationParameters&)) {
  RelationParameters parameters;
  set(parameters);
  return parameters;
}

// One file a family.
std::vector<Example> paper_examples();
std::vector<Example> room_examples();
std::vector<Example> opening_examples();
std::vector<Example> pair_examples();
std::vector<Example> height_examples();
std::vector<Example> group_examples();
std::vector<Example> space_examples();

// All of them.
const std::vector<Example>& examples();

}  // namespace layoutbox::placement
