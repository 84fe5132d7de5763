// How good the default effort's layouts are, how long a whole solve takes, and a hand that drags: parts of solve_bench.
#pragma once

#include <string>
#include <vector>

namespace layoutbox::bench {

// Scenes of files: of each folder all `scene.json` below it, or a file by itself; in the order of their paths, one in `every`.
struct QualityOptions {
  std::vector<std::string> scenes;
  int every = 1;
  int times = 100;     // the effort compared with
  double worst = 0.9;  // scenes below this share of the best score are listed
  std::string best;    // file of the best scores known, read and written: what is there is not searched for again
};

// The mean share of the best score known that the default effort reaches, and of how many scenes it is 90 %. Fails on scenes it cannot
// read.
int quality(const QualityOptions& options);

// Processor time of whole default solves of furnished rooms: improvement, verdict and all.
void whole_solves(const std::vector<int>& sizes, int rooms, int first_room);

// Processor time of one step of a hand that drags one of so many things, the others fixed, or giving way.
void dragging(const std::vector<int>& sizes, int rooms, int first_room);

}  // namespace layoutbox::bench
