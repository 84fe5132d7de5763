// What a conflict promises: its members alone cannot be, and without any one of them the others can.
//
//   LAYOUTBOX_RANDOM_ROUNDS     scenes (a fifth of it; default 100)
//   LAYOUTBOX_RANDOM_SEED       of the first scene (default 1)
//   LAYOUTBOX_RANDOM_SENTENCES  print every sentence
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "environment.h"
#include "layoutbox/catalog/normalize.h"
#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_scene.h"
#include "synthetic.h"

namespace layoutbox::synthetic {
namespace {

bool has(const std::vector<std::string>& ids, const std::string& id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); }

bool speaks_of(const std::string& implied, const std::string& opening) {
  return implied == "door swing of " + opening || implied == "free space before " + opening;
}

// The scene with nothing but the members of the conflict, less one of them, and what they speak of.
SceneGraph alone(const SceneGraph& scene, const Conflict& conflict, const std::string& without) {
  SceneGraph out = scene;
  std::erase_if(out.relations, [&](const Relation& r) {
    return r.id == without || !has(conflict.relations, r.id) ||
           (has(conflict.objects, without) && (has(r.targets, without) || has(r.references, without)));
  });
  std::set<std::string> needed(conflict.objects.begin(), conflict.objects.end());
  for (const Relation& relation : scene.relations) {
    if (!has(conflict.relations, relation.id)) continue;
    needed.insert(relation.targets.begin(), relation.targets.end());
    needed.insert(relation.references.begin(), relation.references.end());
    const bool all_openings = relation_row(relation.type).reference_kinds & kOpening;
    if (!all_openings || !relation.references.empty()) continue;
    for (const Opening& opening : scene.room.openings) needed.insert(opening.id);
  }
  needed.erase(without);
  std::erase_if(out.objects, [&](const SceneObject& o) { return !needed.contains(o.id); });
  std::erase_if(out.room.openings, [&](const Opening& o) {
    const auto implied = [&](const std::string& r) { return r != without && speaks_of(r, o.id); };
    return !needed.contains(o.id) && std::none_of(conflict.relations.begin(), conflict.relations.end(), implied);
  });
  return out;
}

enum class Answer { kPossible, kImpossible, kUnknown };

// Can it be, whatever stands before doors and windows that the conflict does not speak of?
Answer ask(const SceneGraph& scene, const Conflict& conflict, const std::string& without, std::uint64_t seed) {
  SolveOptions options;
  options.seed = seed;
  options.improve = false;
  options.on_conflict = OnConflict::kFail;
  const Result<Layout> layout = solve(scene, Catalog::builtin(), options);
  if (!layout) return layout.error().code == ErrorCode::kInfeasible ? Answer::kImpossible : Answer::kUnknown;
  const auto apart = [&](const Relaxation& r) { return r.relation == without || !has(conflict.relations, r.relation); };
  const bool all = std::all_of(layout->relaxed.begin(), layout->relaxed.end(), apart) &&
                   std::all_of(layout->gave_way.begin(), layout->gave_way.end(), apart);
  return all ? Answer::kPossible : Answer::kUnknown;
}

struct Tally {
  std::size_t conflicts = 0, smallest = 0, members = 0, needless = 0;
};

void check(const SceneGraph& scene, const Conflict& conflict, std::uint64_t seed, Tally& tally) {
  EXPECT_NE(ask(alone(scene, conflict, ""), conflict, "", seed), Answer::kPossible)
      << "seed " << seed << ": " << conflict.sentence << ": but alone it can be";
  std::vector<std::string> members = conflict.relations;
  members.insert(members.end(), conflict.objects.begin(), conflict.objects.end());
  for (const std::string& member : members) {
    // A scene that does not say on what a thing stands knows of fewer places for it, and where no door is nothing is near one: without
    // these it may well be impossible for another reason.
    const auto holds_up = [&](const Relation& r) {
      const bool names = r.id == member || has(r.targets, member) || has(r.references, member);
      return names && (r.type == RelationType::kOn || r.type == RelationType::kIn || r.type == RelationType::kStacked);
    };
    if (std::any_of(scene.relations.begin(), scene.relations.end(), holds_up) || scene.find_opening(member) != nullptr) continue;
    ++tally.members;
    tally.needless += ask(alone(scene, conflict, member), conflict, member, seed) == Answer::kImpossible;
  }
}

TEST(PropertyConflicts, CannotBeAndAreSmallest) {
  if (!describe_cp_sat_library()) GTEST_SKIP() << "no CP-SAT library: run scripts/setup.sh";
  const std::uint64_t rounds = from_environment("LAYOUTBOX_RANDOM_ROUNDS", 100) / 5, first = from_environment("LAYOUTBOX_RANDOM_SEED", 1);
  const bool print = std::getenv("LAYOUTBOX_RANDOM_SENTENCES") != nullptr;
  Tally tally;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    SceneOptions scene_options;
    scene_options.seed = seed;
    scene_options.planted = false;
    const SceneGraph scene = make_scene(scene_options).scene;
    SolveOptions options;
    options.seed = seed;
    options.improve = false;
    const Result<Layout> layout = solve(scene, Catalog::builtin(), options);
    if (!layout) continue;
    for (const Conflict& conflict : layout->conflicts) {
      ++tally.conflicts;
      if (print) std::printf("  %s\n", conflict.sentence.c_str());
      // What follows from an object having been left out before is about what was left.
      const bool whole = std::none_of(layout->relaxed.begin(), layout->relaxed.end(),
                                      [](const Relaxation& r) { return r.why.find("left out") != std::string::npos; });
      if (!conflict.minimal || (!whole && &conflict != &layout->conflicts[0])) continue;
      ++tally.smallest;
      check(scene, conflict, seed, tally);
    }
    if (print) {
      for (const Relaxation& r : layout->relaxed) std::printf("    - %s\n", r.why.c_str());
    }
  }
  std::printf("%zu conflicts, %zu shown to be smallest; of %zu of their members %zu are not needed\n", tally.conflicts, tally.smallest,
              tally.members, tally.needless);
  EXPECT_GT(tally.conflicts, rounds / 4);
  EXPECT_LE(tally.needless * 10, tally.members + 10) << "what is called smallest is not";
}

}  // namespace
}  // namespace layoutbox::synthetic
