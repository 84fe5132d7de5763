// Absurd scenes, large ones, being stopped, and rooms that differ only in how they lie.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <limits>
#include <random>
#include <thread>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

using testing::HasSubstr;

// Either nothing, with a reason, or a sound layout that names what does not hold.
void expect_honest(const SceneGraph& scene, const std::string& about) {
  for (const OnConflict choice : {OnConflict::kRelax, OnConflict::kFail}) {
    SolveOptions options;
    options.on_conflict = choice;
    options.time_limit_s = 10;
    const auto layout = solve(scene, Catalog::builtin(), options);
    if (!layout) {
      EXPECT_EQ(choice, OnConflict::kFail) << layout.error().message;
      EXPECT_THAT(layout.error().message, HasSubstr(about));
      continue;
    }
    expect_sound(*layout);
    EXPECT_EQ(layout->status, LayoutStatus::kRelaxed);
    ASSERT_FALSE(layout->conflicts.empty());
    EXPECT_THAT(layout->conflicts[0].sentence, HasSubstr(about));
  }
}

TEST(Absurd, ThingsThatContainOneAnother) {
  expect_honest(SceneMaker(4000, 4000).add("box", 2).relate("in", {"box_1"}, {"box_2"}).relate("in", {"box_2"}, {"box_1"}).make(), "box");
}

// Sizes that no file can have and normalize_scene lets nobody have: an error all the same.
TEST(Absurd, SizesThatAreNone) {
  for (const Size size : {Size{0, 0, 0}, Size{-500, 500, 500}, Size{500, 500, -1}, Size{2'000'000'000, 500, 500}}) {
    SceneGraph scene = SceneMaker(4000, 4000).add("chair").add("box").make();
    scene.objects[1].size = SizeRange{size, size, size};
    const auto layout = solve(scene, Catalog::builtin());
    ASSERT_FALSE(layout);
    EXPECT_EQ(layout.error().code, ErrorCode::kSchema);
    EXPECT_THAT(layout.error().message, HasSubstr("box"));
  }
}

TEST(Absurd, PlacesThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  for (const double x : {nan, infinite, 1e12}) {
    SceneGraph scene = SceneMaker(4000, 4000).add("chair").at(1000, 1000, 0, 0, true).make();
    scene.objects[0].hint.position = {x, 1000, 0};
    EXPECT_FALSE(solve(scene, Catalog::builtin()));
    scene.objects[0].hint = {std::array<double, 3>{1000, 1000, 0}, x};
    EXPECT_FALSE(solve(scene, Catalog::builtin()));
  }
}

// What is fixed where it cannot be is never passed over in silence.
TEST(Absurd, FixedThingsThatOverlap) {
  expect_honest(SceneMaker(4000, 4000)
                    .add("box", 2)
                    .sized(800, 800, 800)
                    .at(1500, 1500, 0, 0, true)
                    .add("chest")
                    .sized(800, 800, 800)
                    .at(1900, 1500, 0, 0, true)
                    .make(),
                "overlap, by 0.40 × 0.80 m");
}

TEST(Absurd, FixedOutsideTheRoom) {
  expect_honest(SceneMaker(4000, 4000).add("chair").add("chest").sized(800, 800, 800).at(3900, 1500, 0, 0, true).make(),
                "reaches 0.30 m out of the room");
}

TEST(Absurd, FixedInTheAir) {
  expect_honest(SceneMaker(4000, 4000).add("chair").add("chest").sized(800, 800, 800).at(1500, 1500, 900, 0, true).make(),
                "nothing holds the chest up");
}

TEST(Absurd, ABedLargerThanTheRoomAndNothingElse) {
  const auto layout = solve(SceneMaker(2000, 1500).add("bed").sized(2600, 2600, 500).make(), Catalog::builtin());
  ASSERT_TRUE(layout) << layout.error().message;
  EXPECT_TRUE(layout->objects.empty());
  ASSERT_EQ(layout->conflicts.size(), 1u);
  EXPECT_THAT(layout->conflicts[0].sentence, HasSubstr("does not fit into the room"));
}

TEST(Absurd, AnEmptyRoom) {
  const auto layout = solve(SceneMaker(3000, 3000).make(), Catalog::builtin());
  ASSERT_TRUE(layout);
  EXPECT_TRUE(layout->objects.empty());
  EXPECT_EQ(layout->status, LayoutStatus::kSolved);
}

TEST(Without, AProofTheSearchHasTheLastWord) {
  SolveOptions options;
  options.on_conflict = OnConflict::kFail;
  options.prove = false;
  const auto maker = [] { return SceneMaker(5000, 4000).add("bed").add("armchair").relate("nextTo", {"armchair_1"}, {"bed_1"}); };
  const auto layout = solve(maker().make(), Catalog::builtin(), options);
  ASSERT_TRUE(layout) << layout.error().message;
  EXPECT_EQ(layout->stats.solver, "search");
  const auto none = solve(maker().relate("inFrontOf", {"armchair_1"}, {"bed_1"}).relate("behind", {"armchair_1"}, {"bed_1"}).make(),
                          Catalog::builtin(), options);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::kNotFound);
}

TEST(Large, FiveHundredObjectsEndWithAnHonestAnswer) {
  SceneMaker maker(22000, 20000);
  for (int i = 0; i < 500; ++i) maker.add("box").sized(300 + 20 * (i % 30), 300 + 20 * (i % 17), 400);
  SolveOptions options;
  options.improve = false;
  options.time_limit_s = 20;
  const auto layout = solve(maker.make(), Catalog::builtin(), options);
  ASSERT_TRUE(layout) << layout.error().message;
  EXPECT_EQ(layout->objects.size(), 500u);
  for (std::size_t i = 0; i < layout->objects.size(); ++i) {
    const PlacedObject& a = layout->objects[i];
    const auto extent = [](const PlacedObject& o, int axis) {
      const bool across = std::lround(o.rotation_deg / 90) % 2 != 0;
      return (axis == 0) != across ? o.size.width : o.size.depth;
    };
    for (std::size_t j = i + 1; j < layout->objects.size(); ++j) {
      const PlacedObject& b = layout->objects[j];
      bool apart = false;
      for (int k = 0; k < 2; ++k) apart = apart || std::abs(a.position[k] - b.position[k]) * 2 >= extent(a, k) + extent(b, k) - 1;
      EXPECT_TRUE(apart) << a.id << " and " << b.id;
    }
  }
}

// As many wishes as nobody can grant: CP-SAT's model would take gigabytes, and is not built.
TEST(Limits, MemoryOfAnOversizedSceneStaysBounded) {
  const std::vector<std::string> kinds{"chair", "table", "plant", "bookshelf", "desk", "sofa"},
      types{"nextTo", "leftOf", "behind", "facing"};
  std::mt19937 random(1);
  SceneMaker maker(24000, 24000);
  for (int i = 0; i < 300; ++i) maker.add(kinds[random() % kinds.size()]);
  const std::vector<SceneObject> objects = maker.raw().objects;
  for (int k = 0; k < 1000; ++k) {
    const std::size_t a = random() % objects.size(), b = random() % objects.size();
    if (a != b) maker.relate(types[random() % types.size()], {objects[a].id}, {objects[b].id});
  }
  SolveOptions options;
  options.time_limit_s = 2;
  const auto layout = solve(maker.make(), Catalog::builtin(), options);
  if (!layout) {
    EXPECT_EQ(layout.error().code, ErrorCode::kNotFound) << layout.error().message;
  } else {
    EXPECT_FALSE(layout->relaxed.empty());
  }
#ifndef __SANITIZE_ADDRESS__  // which keeps what is freed for a while
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  EXPECT_LT(used.ru_maxrss, 600'000) << "kB";
#endif
}

TEST(Limits, TheClockEndsTheSearchAndIsNamed) {
  SolveOptions options;
  options.effort = 10'000'000;
  options.time_limit_s = 0.05;  // the search itself ends after some 0.2 s
  const auto layout = solve(SceneMaker(7000, 6000).add("bed").add("desk").add("wardrobe").add("sofa").add("armchair", 4).make(true),
                            Catalog::builtin(), options);
  ASSERT_TRUE(layout);
  expect_sound(*layout);
  EXPECT_TRUE(layout->stats.stopped_by_clock);
}

TEST(Limits, StoppedFromAnotherThreadTheBestSoFarIsKept) {
  std::atomic<bool> stop = false;
  SolveOptions options;
  options.effort = 10'000'000;
  options.time_limit_s = 600;
  options.stop = &stop;
  const SceneGraph scene = SceneMaker(7000, 6000).add("bed").add("desk").add("wardrobe").add("sofa").add("armchair", 4).make(true);
  std::thread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    stop = true;
  });
  const auto layout = solve(scene, Catalog::builtin(), options);
  other.join();
  if (layout) {
    expect_sound(*layout);
    EXPECT_FALSE(layout->stats.stopped_by_clock);
  } else {
    EXPECT_EQ(layout.error().code, ErrorCode::kInterrupted);
  }
}

// The same room as it is, mirrored, turned and shifted.
double score_of(const std::vector<Point>& polygon, const std::string& door_wall, Mm door, const std::string& bed_wall) {
  SceneMaker maker(polygon, 2700);
  maker.opening(OpeningType::kDoor, door_wall, door).add("bed").add("nightstand", 2).add("wardrobe").add("desk").add("chair");
  maker.relate("againstWall", {"bed_1"}, {bed_wall}).relate("eachSideOf", {"nightstand_1", "nightstand_2"}, {"bed_1"});
  SolveOptions options;
  options.effort = 300;
  const auto layout = solve(maker.make(), Catalog::builtin(), options);
  EXPECT_TRUE(layout);
  if (!layout) return 0;
  EXPECT_EQ(layout->status, LayoutStatus::kSolved);
  return layout->score;
}

TEST(Alike, MirroredTurnedAndShiftedRoomsGetEquallyGoodLayouts) {
  const Mm w = 4600, d = 3800, door = 300, width = 900;
  const double plain = score_of({{0, 0}, {w, 0}, {w, d}, {0, d}}, "wall1", door, "wall3");
  EXPECT_GT(plain, 0.5);
  EXPECT_NEAR(score_of({{0, 0}, {w, 0}, {w, d}, {0, d}}, "wall1", w - door - width, "wall3"), plain, 0.06) << "mirrored";
  EXPECT_NEAR(score_of({{0, 0}, {w, 0}, {w, d}, {0, d}}, "wall3", door, "wall1"), plain, 0.06) << "turned by half";
  EXPECT_NEAR(score_of({{0, 0}, {d, 0}, {d, w}, {0, w}}, "wall2", door, "wall4"), plain, 0.06) << "turned by a quarter";
  EXPECT_NEAR(score_of({{1230, 2340}, {w + 1230, 2340}, {w + 1230, d + 2340}, {1230, d + 2340}}, "wall1", door, "wall3"), plain, 0.06)
      << "shifted";
}

}  // namespace
}  // namespace layoutbox::placement
