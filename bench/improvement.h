// How fast layouts get better.
#pragma once

#include <vector>

namespace layoutbox::bench {

// Of the way from the first legal layout to the best known (after `best_known` seconds), how much do 100 ms of processor time bring?
void improvement(const std::vector<int>& sizes, int rooms, int first_room, double limit, double best_known);

}  // namespace layoutbox::bench
