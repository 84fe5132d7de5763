// Random scenes, solved and judged: nothing overlaps, nothing is out of bounds, nothing that is said to hold is broken, nothing asked for
// is dropped in silence, and the same seed gives the same bytes.
//
//   LAYOUTBOX_RANDOM_ROUNDS  scenes of each kind (default 100)
//   LAYOUTBOX_RANDOM_SEED    of the first scene (default 1)
//   LAYOUTBOX_FINDINGS       a folder for failing scenes, each made as small as it still fails
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>
#include <set>

#include "environment.h"
#include "layoutbox/base/files.h"
#include "layoutbox/catalog/normalize.h"
#include "layoutbox/scene/scene_json.h"
#include "layoutbox/solve/solver.h"
#include "layoutbox/verify/verify.h"
#include "synthetic.h"

namespace layoutbox::synthetic {
namespace {

SolveOptions options_for(std::uint64_t seed) {
  SolveOptions options;
  options.seed = seed;
  options.effort = 20;
  options.time_limit_s = 20;
  options.improve = seed % 4 == 0;
  return options;
}

std::string bytes_of(Layout layout) {
  layout.stats.seconds = 0;
  return write_layout(layout);
}

bool asked_and_hard(const Relation& relation) { return relation.hard && relation.asked(); }

// What is wrong with a solver's answer: the kind of fault, then the figures; empty when nothing is.
std::string fault_of(const SceneGraph& scene, const Result<Layout>& layout) {
  if (!layout) return layout.error().code == ErrorCode::kNotFound ? "" : "error: " + layout.error().message;
  if (layout->stats.stopped_by_clock) return "";
  const Report report = verify(*layout, Catalog::builtin());
  for (const Check& check : report.checks) {
    if (!check.passed && check.required) {
      const std::string kind = check.name == "relation" ? check.message.substr(0, check.message.find(' ')) : std::string();
      return check.name + " " + kind + ": " + check.subject + ": " + check.message;
    }
  }
  for (std::size_t i = 0; i < layout->relations.size(); ++i) {
    const PlacedRelation& placed = layout->relations[i];
    const auto check = std::find_if(report.checks.begin(), report.checks.end(),
                                    [&](const Check& c) { return c.pointer == "/relations/" + std::to_string(i); });
    if (placed.held && !check->passed)
      return "false claim " + check->message.substr(0, check->message.find(' ')) + ": " + check->subject + ": " + check->message;
  }
  for (const SceneObject& object : scene.objects) {
    const bool listed = std::any_of(layout->relaxed.begin(), layout->relaxed.end(),
                                    [&](const Relaxation& r) { return r.relation.find(object.id) != std::string::npos; });
    if (layout->find_object(object.id) == nullptr && !listed) return "object dropped in silence: " + object.id;
  }
  for (const Relation& relation : scene.relations) {
    const bool there = std::any_of(layout->relations.begin(), layout->relations.end(),
                                   [&](const PlacedRelation& placed) { return placed.relation.id == relation.id; });
    const bool listed =
        std::any_of(layout->relaxed.begin(), layout->relaxed.end(), [&](const Relaxation& r) { return r.relation == relation.id; });
    if (!there && !listed && asked_and_hard(relation)) return "relation dropped in silence: " + relation.id;
  }
  return "";
}

// The types of the relations that a conflict names, so that conflicts of one kind are counted together.
std::string types_of(const SceneGraph& scene, const Conflict& conflict) {
  std::set<std::string_view> types;
  for (const Relation& relation : scene.relations) {
    const auto& ids = conflict.relations;
    if (std::find(ids.begin(), ids.end(), relation.id) != ids.end()) types.insert(relation_row(relation.type).name);
  }
  std::string text;
  for (const std::string_view type : types) text += (text.empty() ? "" : ", ") + std::string(type);
  return text.empty() ? "objects" : text;
}

// In a planted scene a layout exists: nothing may be given up with a proof.
std::string fault_of_planted(const SceneGraph& scene, const Result<Layout>& layout) {
  if (std::string fault = fault_of(scene, layout); !fault.empty()) return fault;
  if (!layout) return "";
  for (const Conflict& conflict : layout->conflicts) {
    if (conflict.minimal) return "conflict of " + types_of(scene, conflict) + " proven where a layout exists: " + conflict.sentence;
  }
  return "";
}

using Judge = std::function<std::string(const SceneGraph&)>;

std::string kind_of(const std::string& fault) { return fault.substr(0, fault.find(':')); }

// Leaves out relations and objects as long as the same kind of fault remains.
SceneGraph made_small(SceneGraph scene, const Judge& judge, const std::string& kind) {
  const auto still_fails = [&](const SceneGraph& smaller) { return kind_of(judge(smaller)) == kind; };
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (std::size_t i = scene.relations.size(); i-- > 0;) {
      SceneGraph without = scene;
      without.relations.erase(without.relations.begin() + static_cast<std::ptrdiff_t>(i));
      if (still_fails(without)) scene = without, smaller = true;
    }
    for (std::size_t i = scene.objects.size(); i-- > 0;) {
      SceneGraph without = scene;
      const std::string id = scene.objects[i].id;
      without.objects.erase(without.objects.begin() + static_cast<std::ptrdiff_t>(i));
      std::erase_if(without.relations, [&](const Relation& relation) {
        const auto names = [&](const std::vector<std::string>& ids) { return std::find(ids.begin(), ids.end(), id) != ids.end(); };
        return names(relation.targets) || names(relation.references);
      });
      if (still_fails(without)) scene = without, smaller = true;
    }
  }
  return scene;
}

// Keeps one small scene of every kind of fault, where a folder is given for them.
void keep_finding(const std::string& name, const SceneGraph& scene, const Judge& judge, const std::string& fault) {
  const char* folder = std::getenv("LAYOUTBOX_FINDINGS");
  if (folder == nullptr) return;
  const SceneGraph small = made_small(scene, judge, kind_of(fault));
  const std::filesystem::path place = std::filesystem::path(folder) / name;
  (void)write_file(place.string() + ".scene.json", write_scene(small));
  (void)write_file(place.string() + ".txt", judge(small) + "\n");
}

// … and what was planted and not found again, with the layout that there is.
void keep_planted(std::uint64_t seed, const Scene& made) {
  const char* folder = std::getenv("LAYOUTBOX_FINDINGS");
  if (folder == nullptr || !made.planted) return;
  const std::string place = (std::filesystem::path(folder) / ("planted-" + std::to_string(seed))).string();
  (void)write_file(place + ".whole.json", write_scene(made.scene));
  (void)write_file(place + ".layout.json", write_layout(*made.planted));
}

struct Tally {
  int solved = 0, relaxed = 0, not_found = 0;
  std::map<std::string, int> faults;
};

constexpr std::uint64_t kFloorOfPlanted = 98;  // percent that are solved with nothing given up, at least

void run(bool planted, const std::function<std::string(const SceneGraph&, const Result<Layout>&)>& fault_of_answer) {
  const std::uint64_t rounds = from_environment("LAYOUTBOX_RANDOM_ROUNDS", 100), first = from_environment("LAYOUTBOX_RANDOM_SEED", 1);
  Tally tally;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    SceneOptions scene_options;
    scene_options.seed = seed;
    scene_options.planted = planted;
    const Scene made = make_scene(scene_options);
    const Judge judge = [&](const SceneGraph& scene) {
      return fault_of_answer(scene, solve(scene, Catalog::builtin(), options_for(seed)));
    };
    const Result<Layout> layout = solve(made.scene, Catalog::builtin(), options_for(seed));
    tally.solved += layout && layout->status == LayoutStatus::kSolved;
    tally.relaxed += layout && layout->status == LayoutStatus::kRelaxed;
    tally.not_found += !layout;
    if (planted && (!layout || layout->status != LayoutStatus::kSolved)) keep_planted(seed, made);
    const std::string fault = fault_of_answer(made.scene, layout);
    if (fault.empty()) continue;
    if (++tally.faults[kind_of(fault)] == 1) {
      ADD_FAILURE() << (planted ? "planted" : "free") << " scene, seed " << seed << ": " << fault;
      keep_finding((planted ? "planted-" : "free-") + std::to_string(seed), made.scene, judge, fault);
    }
  }
  std::printf("%s scenes from seed %llu: %d solved, %d relaxed, %d not found\n", planted ? "planted" : "free",
              static_cast<unsigned long long>(first), tally.solved, tally.relaxed, tally.not_found);
  if (planted) {
    EXPECT_GE(100 * static_cast<std::uint64_t>(tally.solved), kFloorOfPlanted * rounds) << "a layout exists, and things were given up";
  }
  for (const auto& [kind, count] : tally.faults) std::printf("  %d x %s\n", count, kind.c_str());
}

TEST(PropertyRandomScenes, Planted) { run(true, fault_of_planted); }

TEST(PropertyRandomScenes, Free) { run(false, fault_of); }

TEST(PropertyRandomScenes, SameSeedSameBytes) {
  const std::uint64_t rounds = from_environment("LAYOUTBOX_RANDOM_ROUNDS", 100) / 5, first = from_environment("LAYOUTBOX_RANDOM_SEED", 1);
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    SceneOptions scene_options;
    scene_options.seed = seed;
    scene_options.planted = seed % 2 == 0;
    const SceneGraph scene = make_scene(scene_options).scene;
    EXPECT_EQ(write_scene(scene), write_scene(make_scene(scene_options).scene)) << "the generator itself, seed " << seed;
    const Result<Layout> once = solve(scene, Catalog::builtin(), options_for(seed)),
                         again = solve(scene, Catalog::builtin(), options_for(seed));
    ASSERT_EQ(once.has_value(), again.has_value()) << "seed " << seed;
    if (!once || once->stats.stopped_by_clock || again->stats.stopped_by_clock) continue;
    EXPECT_EQ(bytes_of(*once), bytes_of(*again)) << "seed " << seed;
  }
}

// The generator itself: its planted layouts are what they promise to be.
TEST(PropertySyntheticScenes, PlantedLayoutsHold) {
  int objects = 0, relations = 0;
  std::map<RelationType, int> types;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SceneOptions options;
    options.seed = seed;
    const Scene made = make_scene(options);
    ASSERT_TRUE(made.planted) << "seed " << seed;
    const Report report = verify(*made.planted, Catalog::builtin());
    EXPECT_TRUE(report.passed) << "seed " << seed << write_report(report);
    objects += static_cast<int>(made.scene.objects.size());
    for (const PlacedRelation& placed : made.planted->relations) ++types[placed.relation.type], ++relations;
  }
  EXPECT_GT(objects, 300);
  EXPECT_GT(relations, 300);
  EXPECT_GT(types.size(), 40u) << "most of the vocabulary";
}

}  // namespace
}  // namespace layoutbox::synthetic
