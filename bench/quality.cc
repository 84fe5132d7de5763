#include "quality.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numeric>

#include "layoutbox/catalog/normalize.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/solve/solver.h"
#include "rooms.h"

namespace layoutbox::bench {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

double share_at(std::vector<double>& values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

double milliseconds(const std::function<void()>& what) {
  const double start = cpu_seconds();
  what();
  return 1000 * (cpu_seconds() - start);
}

std::vector<fs::path> scene_files(const std::vector<std::string>& places) {
  std::vector<fs::path> files;
  for (const std::string& place : places) {
    if (fs::is_regular_file(place)) files.emplace_back(place);
    if (!fs::is_directory(place)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(place)) {
      if (entry.path().filename() == "scene.json") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

Result<SceneGraph> scene_in(const fs::path& file) {
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  LAYOUTBOX_ASSIGN(SceneGraph scene, read_scene(text));
  return normalize_scene(std::move(scene), Catalog::builtin());
}

// A layout that gives less up is better; of equals the score counts.
struct Reached {
  std::size_t given_up = 0;
  double score = 0, ms = 0;
};

Reached reach(const SceneGraph& scene, std::int64_t effort) {
  SolveOptions options;
  options.effort = effort;
  options.time_limit_s = 1e6;
  Reached reached;
  reached.ms = milliseconds([&] {
    const auto layout = solve(scene, Catalog::builtin(), options);
    if (layout) reached.given_up = layout->relaxed.size(), reached.score = layout->score;
  });
  return reached;
}

Json read_json(const std::string& file) {
  std::ifstream in(file);
  Json known = in ? Json::parse(in, nullptr, false) : Json::object();
  return known.is_object() ? known : Json::object();
}

}  // namespace

int quality(const QualityOptions& options) {
  Json known = read_json(options.best);
  std::vector<double> shares, times;
  double sum = 0;
  int good = 0, less_given_up = 0, index = 0;
  for (const fs::path& file : scene_files(options.scenes)) {
    if (index++ % std::max(1, options.every) != 0) continue;
    const auto scene = scene_in(file);
    if (!scene) {
      fmt::print("{}: {}\n", file.string(), scene.error().message);
      return 1;
    }
    const Reached usual = reach(*scene, SolveOptions{}.effort);
    Json& best = known[file.string()];
    if (best.is_null()) {
      const Reached more = reach(*scene, SolveOptions{}.effort * options.times);
      best = {{"givenUp", more.given_up}, {"score", more.score}};
    }
    const std::size_t fewest = best["givenUp"];
    if (usual.given_up < fewest || (usual.given_up == fewest && usual.score > best["score"].get<double>()))
      best = {{"givenUp", usual.given_up}, {"score", usual.score}};
    less_given_up += usual.given_up > fewest;
    const double score = best["score"];
    const double share = score > 0 ? std::min(1.0, usual.score / score) : 1;
    shares.push_back(share), times.push_back(usual.ms);
    sum += share, good += share >= 0.9;
    if (share < options.worst || usual.given_up > fewest)
      fmt::print("  {}: {:.3f} of {:.3f}, {:.0f} %{}\n", file.string(), usual.score, score, 100 * share,
                 usual.given_up > fewest ? fmt::format("; {} given up, {} with more effort", usual.given_up, fewest) : "");
    if (!options.best.empty() && shares.size() % 16 == 0) std::ofstream(options.best) << known.dump(1);
    std::fflush(stdout);
  }
  if (!options.best.empty()) std::ofstream(options.best) << known.dump(1);
  const auto count = static_cast<double>(std::max<std::size_t>(1, shares.size()));
  fmt::print("{} scenes: {:.1f} % of the best score on average, at least 90 % in {:.1f} %; {} give up more than need be\n", shares.size(),
             100 * sum / count, 100 * good / count, less_given_up);
  fmt::print("processor time: median {:.0f}, 95 % {:.0f}, most {:.0f} ms; in all {:.1f} s\n", share_at(times, 0.5), share_at(times, 0.95),
             share_at(times, 1), std::accumulate(times.begin(), times.end(), 0.0) / 1000);
  return 0;
}

void whole_solves(const std::vector<int>& sizes, int rooms, int first_room) {
  for (const int n : sizes) {
    std::vector<double> times;
    double score = 0;
    int given_up = 0;
    for (int seed = first_room; seed < first_room + rooms; ++seed) {
      const SceneGraph scene = furnished_scene(n, static_cast<std::uint64_t>(seed));
      times.push_back(milliseconds([&] {
        const auto layout = solve(scene, Catalog::builtin());
        if (layout) score += layout->score, given_up += !layout->relaxed.empty();
      }));
    }
    fmt::print(
        "{} objects, {} rooms, whole default solve: median {:.1f}, 95 % {:.1f}, most {:.1f} ms; mean score {:.3f}, {} gave something up\n",
        n, rooms, share_at(times, 0.5), share_at(times, 0.95), share_at(times, 1), score / rooms, given_up);
    std::fflush(stdout);
  }
}

void dragging(const std::vector<int>& sizes, int rooms, int first_room) {
  constexpr int kSteps = 40;
  constexpr double kStep = 50;  // mm
  for (const int n : sizes) {
    for (const bool give_way : {false, true}) {
      std::vector<double> times, in_vain;
      for (int seed = first_room; seed < first_room + rooms; ++seed) {
        const SceneGraph scene = furnished_scene(n, static_cast<std::uint64_t>(seed));
        auto layout = solve(scene, Catalog::builtin());
        if (!layout) continue;
        const std::size_t held = static_cast<std::size_t>(seed) % layout->objects.size();
        SolveOptions options;
        options.improve = false, options.prove = false, options.on_conflict = OnConflict::kFail, options.effort = 10;
        for (const PlacedObject& object : layout->objects) {
          if (give_way ? object.id == layout->objects[held].id : object.id != layout->objects[held].id) options.locked.push_back(object.id);
        }
        for (int step = 0; step < kSteps; ++step) {
          Layout wished = *layout;
          wished.objects[held].position[static_cast<std::size_t>(seed % 2)] += (step < kSteps / 2 ? kStep : -kStep) * (step % 20 + 1);
          options.from = &wished;
          bool found = false;
          const double ms = milliseconds([&] { found = solve(scene, Catalog::builtin(), options).has_value(); });
          (found ? times : in_vain).push_back(ms);
        }
      }
      fmt::print(
          "{} objects, one dragged, the others {}: median {:.2f}, 95 % {:.2f}, most {:.2f} ms; where it cannot go: {}, 95 % {:.2f} ms\n", n,
          give_way ? "give way" : "fixed", share_at(times, 0.5), share_at(times, 0.95), share_at(times, 1), in_vain.size(),
          share_at(in_vain, 0.95));
      std::fflush(stdout);
    }
  }
}

}  // namespace layoutbox::bench
