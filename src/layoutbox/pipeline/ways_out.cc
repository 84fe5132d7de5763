#include "layoutbox/pipeline/ways_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "layoutbox/pipeline/scene_changes.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox {
namespace {

using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr std::int64_t kTryEffort = 30;
constexpr int kMostRelaxed = 8;
constexpr int kDeepest = 4;  // changes in one way out, where one conflict hides another

class Searcher {
 public:
  Searcher(const Catalog& catalog, const GenerateOptions& options, const WaysOutOptions& limits)
      : catalog_(catalog), options_(options), limits_(limits), started_(Clock::now()) {
    options_.solve.improve = false;
    options_.solve.effort = std::min(options_.solve.effort, kTryEffort);
    options_.solve.from = nullptr;
    options_.solve.prove = false;
  }

  void search(const Json& document, const Layout& layout, const SceneChange& so_far, int depth) {
    const auto scene = prepared(document);
    if (!scene) return;
    SceneChange best;  // gives up the least of those that are not enough
    std::size_t least = layout.objects.empty() ? std::numeric_limits<std::size_t>::max() : layout.relaxed.size();
    std::optional<Layout> best_layout;
    for (SceneChange& change : propose_changes({document, *scene, layout, catalog_, limits_.room_may_grow})) {
      if (enough() || spent()) return;
      if (subjects_.contains(change.subject)) continue;
      Json changed;
      try {
        changed = document.patch(change.patch);
      } catch (const Json::exception&) {
        continue;
      }
      SceneChange whole = joined(so_far, change);
      if (is_enough(changed)) {
        subjects_.insert(change.subject);
        found_.push_back({whole.sentence, whole.patch.dump()});
        continue;
      }
      if (!found_.empty() || relaxed_tries_++ >= kMostRelaxed) continue;  // what is not enough matters only where nothing is
      auto tried = layout_of(changed);
      if (tried && tried->relaxed.size() < least) least = tried->relaxed.size(), best = std::move(whole), best_layout = std::move(*tried);
    }
    if (!found_.empty() || !best_layout || depth + 1 >= kDeepest) return;
    search(root_.patch(best.patch), *best_layout, best, depth + 1);  // it was applied before
  }

  void start(const Json& document) { root_ = document; }
  std::vector<WayOut> take() { return std::move(found_); }

 private:
  static SceneChange joined(const SceneChange& a, const SceneChange& b) {
    if (a.sentence.empty()) return b;
    SceneChange both{a.sentence + ", and " + b.sentence, a.subject + " " + b.subject, a.patch};
    for (const Json& operation : b.patch) both.patch.push_back(operation);
    return both;
  }

  bool enough() const { return found_.size() >= limits_.most; }
  double seconds() const { return std::chrono::duration<double>(Clock::now() - started_).count(); }
  bool spent() const {
    return tries_ >= limits_.most_tries || seconds() > limits_.time_limit_s || (options_.stop != nullptr && options_.stop->load());
  }

  std::optional<SceneGraph> prepared(const Json& document) const {
    auto read = read_scene(document.dump());
    if (!read) return std::nullopt;
    auto scene = prepare_scene(std::move(*read), catalog_, options_);
    return scene ? std::optional(std::move(*scene)) : std::nullopt;
  }

  // Is there a layout that gives up nothing?
  bool is_enough(const Json& document) {
    ++tries_;
    const auto scene = prepared(document);
    if (!scene) return false;
    const auto layout = solve(*scene, catalog_, solve_options(OnConflict::kFail));
    return layout && !gives_up_what_was_asked(*layout, *scene);
  }

  std::optional<Layout> layout_of(const Json& document) {
    const auto scene = prepared(document);
    if (!scene) return std::nullopt;
    auto layout = solve(*scene, catalog_, solve_options(OnConflict::kRelax));
    return layout ? std::optional(std::move(*layout)) : std::nullopt;
  }

  SolveOptions solve_options(OnConflict on_conflict) const {
    SolveOptions made = options_.solve;
    made.on_conflict = on_conflict;
    made.time_limit_s = std::max(limits_.time_limit_s - seconds(), 0.05);
    return made;
  }

  const Catalog& catalog_;
  GenerateOptions options_;
  WaysOutOptions limits_;
  Clock::time_point started_;
  Json root_;
  std::set<std::string> subjects_;
  std::vector<WayOut> found_;
  std::size_t tries_ = 0;
  int relaxed_tries_ = 0;
};

}  // namespace

std::vector<WayOut> find_ways_out(const std::string& document, const Layout& layout, const Catalog& catalog, const GenerateOptions& options,
                                  const WaysOutOptions& limits) {
  const Json json = Json::parse(document, nullptr, false);
  if (!json.is_object()) return {};
  Searcher searcher(catalog, options, limits);
  searcher.start(json);
  searcher.search(json, layout, {}, 0);
  return searcher.take();
}

bool gives_up_what_was_asked(const Layout& layout, const SceneGraph& scene) {
  if (layout.status == LayoutStatus::kSolved) return false;
  return std::ranges::any_of(layout.relaxed, [&](const Relaxation& relaxation) {
    if (scene.find_object(relaxation.relation) != nullptr) return true;
    return std::ranges::any_of(scene.relations, [&](const Relation& r) { return r.id == relaxation.relation && r.hard && r.asked(); });
  });
}

}  // namespace layoutbox
