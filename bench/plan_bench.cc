// How long a description takes to become a scene graph: each line of a file is one description.
//
//   plan_bench FILE [RUNS]
//
// Prints the median and the worst over the lines (each line's least time of RUNS), and the time of long texts made of all of them.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "layoutbox/plan/planner.h"

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(const layoutbox::Planner& planner, const std::string& text, int runs) {
  double least = 1e9;
  for (int run = 0; run < runs; ++run) {
    const auto start = Clock::now();
    const auto plan = planner.plan(text, {.seed = 1, .max_prompt_bytes = 100'000'000});
    least = std::min(least, std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  return least;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: plan_bench FILE [RUNS]\n");
    return 2;
  }
  const int runs = argc > 2 ? std::atoi(argv[2]) : 5;
  std::ifstream file(argv[1]);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty()) lines.push_back(line);
  }
  if (lines.empty()) {
    std::fprintf(stderr, "plan_bench: %s has no lines\n", argv[1]);
    return 2;
  }
  const auto start = Clock::now();
  const auto planner = layoutbox::make_offline_planner(layoutbox::Catalog::builtin());
  std::printf("start %.1f ms\n", std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  std::vector<std::pair<double, std::size_t>> times;
  for (std::size_t i = 0; i < lines.size(); ++i) times.emplace_back(milliseconds(*planner, lines[i], runs), i);
  std::sort(times.begin(), times.end());
  std::printf("%zu descriptions: median %.3f ms, worst %.3f ms (line %zu)\n", lines.size(), times[times.size() / 2].first,
              times.back().first, times.back().second + 1);
  for (const std::size_t words : {1000u, 10'000u, 100'000u}) {
    std::string text;
    std::size_t count = 0;
    for (std::size_t i = 0; count < words; i = (i + 1) % lines.size()) {
      text += lines[i] + "\n";
      count += static_cast<std::size_t>(std::count(lines[i].begin(), lines[i].end(), ' ')) + 1;
    }
    std::printf("%zu words: %.1f ms\n", count, milliseconds(*planner, text, 1));
  }
  return 0;
}
