// The solver's figures: docs/benchmarks.md has them and the commands. Every part writes a table, and with --json one object a line.
#include <fmt/format.h>
#include <sys/resource.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "improvement.h"
#include "layoutbox/solve/solver.h"
#include "other_models.h"
#include "quality.h"
#include "rooms.h"
#include "timing.h"

namespace layoutbox::bench {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string part, json;
  std::vector<int> sizes{5, 10, 20, 30, 50};
  std::vector<std::string> against;
  int rooms = 20, first_room = 1;
  double limit = 20, best_known = 20;
  QualityOptions quality;
};

struct Times {
  std::vector<double> ms;
  int asked = 0, found = 0;

  void add(double seconds, bool ok) { ms.push_back(seconds * 1000), ++asked, found += ok; }
  double at(double share) {
    if (ms.empty()) return 0;
    std::sort(ms.begin(), ms.end());
    return ms[std::min(ms.size() - 1, static_cast<std::size_t>(share * static_cast<double>(ms.size())))];
  }
};

class Report {
 public:
  explicit Report(const std::string& path) {
    if (!path.empty()) file_.open(path, std::ios::app);
  }
  void row(const std::string& what, const std::string& who, int objects, Times times) {
    fmt::print("{:<22}{:<18}{:>5} objects{:>6} of {:<5} found   median {:>9.2f}   p99 {:>9.2f}   most {:>9.2f} ms\n", what, who, objects,
               times.found, times.asked, times.at(0.5), times.at(0.99), times.at(1));
    std::fflush(stdout);
    if (file_)
      file_ << Json{{"what", what},          {"who", who},           {"objects", objects},
                    {"asked", times.asked},  {"found", times.found}, {"median", times.at(0.5)},
                    {"p99", times.at(0.99)}, {"most", times.at(1)}}
            << "\n";
  }

 private:
  std::ofstream file_;
};

bool find_first(const SceneGraph& scene, double limit, Times& times) {
  bool ok = false;
  std::string why;
  const double seconds = timed([&] {
    const auto layout = solve(scene, Catalog::builtin(), first_legal(limit));
    ok = layout && layout->status == LayoutStatus::kSolved;
    if (!ok)
      why = layout ? (layout->relaxed.empty() ? "?" : layout->relaxed[0].relation + " " + layout->relaxed[0].why) : layout.error().message;
  });
  if (!ok) fmt::print("  not found: {}\n", why);
  times.add(seconds, ok);
  return ok;
}

void boxes(const Options& options, Report& report) {
  const std::map<std::string, OtherModel> others{
      {"paper", OtherModel::kPaperCentres}, {"paper-boxes", OtherModel::kPaperBoxes}, {"highs", OtherModel::kBigM}};
  for (const int n : options.sizes) {
    Times ours;
    std::map<std::string, Times> theirs;
    for (int seed = options.first_room; seed < options.first_room + options.rooms; ++seed) {
      const PlainRoom room = plain_room(n, static_cast<std::uint64_t>(seed));
      if (!find_first(scene_of(room), options.limit, ours)) fmt::print("  not found: --sizes {} room {}\n", n, seed);
      for (const std::string& other : options.against) {
        const Outcome outcome = solve_otherwise(others.at(other), room, options.limit);
        if (!outcome.trouble.empty()) fmt::print("  {}: {}\n", other, outcome.trouble);
        theirs[other].add(outcome.seconds, outcome.found);
      }
    }
    report.row("boxes", "ours", n, ours);
    for (const auto& [name, times] : theirs) report.row("boxes", name, n, times);
  }
}

void furnished(const Options& options, Report& report) {
  for (const int n : options.sizes) {
    Times ours;
    for (int seed = options.first_room; seed < options.first_room + options.rooms; ++seed)
      find_first(furnished_scene(n, static_cast<std::uint64_t>(seed)), options.limit, ours);
    report.row("furnished", "ours", n, ours);
  }
}

void impossible(const Options& options, Report& report) {
  for (int kind = 0; kind < kClashKinds; ++kind) {
    Times times;
    int minimal = 0;
    std::string said;
    for (int seed = options.first_room; seed < options.first_room + options.rooms; ++seed) {
      const SceneGraph scene = impossible_scene(kind, static_cast<std::uint64_t>(seed));
      SolveOptions ask = first_legal(options.limit);
      ask.effort = SolveOptions{}.effort;
      bool proven = false;
      const double seconds = timed([&] {
        const auto layout = solve(scene, Catalog::builtin(), ask);
        proven = !layout && layout.error().code == ErrorCode::kInfeasible;
        said = layout ? "a layout was found" : layout.error().message;
      });
      times.add(seconds, proven);
      if (!proven) fmt::print("  room {}: {}\n", seed, said);
      // Whether it called the conflict minimal is said by the layout that gives something up.
      ask.on_conflict = OnConflict::kRelax;
      const auto relaxed = solve(scene, Catalog::builtin(), ask);
      minimal += relaxed && !relaxed->conflicts.empty() && relaxed->conflicts[0].minimal;
    }
    report.row(clash_kind_in_words(kind), fmt::format("minimal {}", minimal), 15, times);
    fmt::print("  {}\n", said);
  }
}

// How long after the flag was set does the answer come? Measured on the clock, in whatever the solver is busy with at that moment: the
// search, the improvement, or a proof.
void stop(const Options& options, Report& report) {
  using Clock = std::chrono::steady_clock;
  struct Busy {
    std::string what;
    std::function<SceneGraph(std::uint64_t)> scene;
    OnConflict on_conflict;
  };
  const std::vector<Busy> all{
      {"stop, improving", [](std::uint64_t seed) { return furnished_scene(30, seed); }, OnConflict::kRelax},
      {"stop, searching", [](std::uint64_t seed) { return scene_of(plain_room(200, seed)); }, OnConflict::kRelax},
      {"stop, proving", [](std::uint64_t seed) { return impossible_scene(4, seed); }, OnConflict::kFail},
  };
  for (const Busy& busy : all) {
    Times times;
    for (int seed = options.first_room; seed < options.first_room + options.rooms; ++seed) {
      const SceneGraph scene = busy.scene(static_cast<std::uint64_t>(seed));
      std::atomic<bool> flag = false;
      std::atomic<Clock::rep> set_at = 0;
      SolveOptions ask = first_legal(600);
      ask.improve = true, ask.effort = 10'000'000, ask.on_conflict = busy.on_conflict, ask.stop = &flag;
      std::thread other([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(20 + 7 * seed));
        set_at = Clock::now().time_since_epoch().count();
        flag = true;
      });
      (void)solve(scene, Catalog::builtin(), ask);
      const Clock::time_point ended = Clock::now();
      other.join();
      const double late = std::chrono::duration<double>(ended.time_since_epoch() - Clock::duration(set_at.load())).count();
      if (late >= 0) times.add(late, true);  // else it was done before
    }
    report.row(busy.what, "clock", 0, times);
  }
}

void memory(const Options& options, Report&) {
  for (const int n : options.sizes) {
    const SceneGraph scene = scene_of(plain_room(n, 1));
    SolveOptions ask = first_legal(options.limit);
    ask.improve = true, ask.effort = 1000;
    const auto layout = solve(scene, Catalog::builtin(), ask);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    fmt::print("{} objects: {}, at most {} MB\n", n, layout ? layout->stats.solver : layout.error().message, usage.ru_maxrss / 1024);
  }
}

int main_with(int argc, char** argv) {
  Options options;
  CLI::App app("Figures of the solver");
  app.add_option("part", options.part, "boxes, furnished, whole, drag, impossible, improvement, quality, stop, memory")->required();
  app.add_option("--sizes", options.sizes, "How many objects")->delimiter(',');
  app.add_option("--rooms", options.rooms, "How many rooms of each size");
  app.add_option("--first-room", options.first_room, "Seed of the first room");
  app.add_option("--against", options.against, "paper, paper-boxes, highs")->delimiter(',');
  app.add_option("--limit", options.limit, "Seconds a room at most");
  app.add_option("--best-known", options.best_known, "Seconds of the long run");
  app.add_option("--scenes", options.quality.scenes, "quality: folders with scene.json files in them");
  app.add_option("--every", options.quality.every, "quality: one scene in so many");
  app.add_option("--times", options.quality.times, "quality: so many times the effort to compare with");
  app.add_option("--best", options.quality.best, "quality: file of the best scores known, read and written");
  app.add_option("--json", options.json, "Append the rows to this file");
  CLI11_PARSE(app, argc, argv);
  Report report(options.json);
  const std::map<std::string, void (*)(const Options&, Report&)> parts{
      {"boxes", boxes},
      {"furnished", furnished},
      {"impossible", impossible},
      {"stop", stop},
      {"memory", memory},
      {"improvement", [](const Options& o, Report&) { improvement(o.sizes, o.rooms, o.first_room, o.limit, o.best_known); }},
      {"whole", [](const Options& o, Report&) { whole_solves(o.sizes, o.rooms, o.first_room); }},
      {"drag", [](const Options& o, Report&) { dragging(o.sizes, o.rooms, o.first_room); }}};
  if (options.part == "quality") return quality(options.quality);
  const auto part = parts.find(options.part);
  if (part == parts.end()) return 2;
  if (!describe_cp_sat_library()) fmt::print("without CP-SAT: {}\n", describe_cp_sat_library().error().message);  // and it is loaded now
  part->second(options, report);
  return 0;
}

}  // namespace
}  // namespace layoutbox::bench

int main(int argc, char** argv) { return layoutbox::bench::main_with(argc, argv); }
