// Whatever is asked for and however short the time, something legal stands there; and the time is kept.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "layoutbox/solve/search/order.h"
#include "layoutbox/solve/search/quick.h"
#include "layoutbox/solve/search/search.h"
#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

using testing::HasSubstr;

SceneGraph grid_of_chairs(int count, int columns) {
  SceneMaker maker(30000, 30000);
  maker.add("chair", count);
  std::vector<std::string> chairs;
  for (int i = 1; i <= count; ++i) chairs.push_back("chair_" + std::to_string(i));
  RelationParameters parameters;
  parameters.columns = columns;
  return maker.relate("grid", chairs, {}, parameters).make(true);
}

SceneGraph contradictions() {
  SceneMaker maker(3600, 3200);
  maker.add("bed").add("desk").add("wardrobe").add("sofa").add("armchair", 3).add("bookshelf");
  const std::vector<SceneObject> objects = maker.raw().objects;
  for (const SceneObject& a : objects) {
    for (const SceneObject& b : objects) {
      if (a.id != b.id) maker.relate("leftOf", {a.id}, {b.id}).relate("facing", {a.id}, {b.id});
    }
  }
  return maker.make(true);
}

// Of what is too much for the room as much stays as fits, whatever the seed: here three beds, two desks with their lamps or as good.
TEST(Always, AsMuchStaysAsFits) {
  SceneMaker maker(4000, 2000);
  maker.add("single_bed", 3).add("desk", 3).add("table_lamp", 3).add("bookshelf").add("plant");
  for (const char* n : {"1", "2", "3"}) maker.relate("on", {std::string("table_lamp_") + n}, {std::string("desk_") + n});
  const SceneGraph scene = maker.make(true);
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    SolveOptions options;
    options.seed = seed;
    const auto layout = solve(scene, Catalog::builtin(), options);
    ASSERT_TRUE(layout) << layout.error().message;
    expect_sound(*layout);
    EXPECT_GE(layout->objects.size(), 7U) << "seed " << seed;
  }
}

TEST(Always, TheClockNeverTurnsARoomIntoNone) {
  for (const double limit : {0.001, 0.05}) {
    SolveOptions options;
    options.time_limit_s = limit;
    const auto layout = solve(contradictions(), Catalog::builtin(), options);
    ASSERT_TRUE(layout) << layout.error().message;
    expect_sound(*layout);
    EXPECT_TRUE(layout->stats.stopped_by_clock);
    EXPECT_EQ(layout->status, LayoutStatus::kRelaxed);
    EXPECT_FALSE(layout->conflicts.empty());
    for (const PlacedRelation& r : layout->relations) EXPECT_TRUE(r.held || layout->lists_as_given_up(r.relation.id)) << r.relation.id;
  }
}

TEST(Always, ARelationSaidOftenIsSolvedOnceAndReportedAsOften) {
  SceneMaker maker(6000, 5000);
  maker.add("armchair").add("sofa");
  for (int i = 0; i < 5000; ++i) maker.relate("near", {"armchair_1"}, {"sofa_1"});
  const auto layout = solve(maker.make(true), Catalog::builtin());
  ASSERT_TRUE(layout) << layout.error().message;
  EXPECT_EQ(layout->status, LayoutStatus::kSolved);
  ASSERT_EQ(layout->relations.size(), 5000u);
  EXPECT_EQ(layout->relations[4999].relation.id, "c5000");
  EXPECT_TRUE(std::all_of(layout->relations.begin(), layout->relations.end(), [](const PlacedRelation& r) { return r.held; }));
}

// Steps and other work, counted from the moment the stop is known.
class AfterTheStop : public testing::Test {
 protected:
  // Of a search that is told to stop when it first asks.
  static std::int64_t work_of(const SceneGraph& scene, bool quickly) {
    auto model = build_model(scene, Catalog::builtin());
    EXPECT_TRUE(model);
    Budget budget{0, 1'000'000'000, [] { return true; }, false};
    if (quickly) {
      const Dependencies dependencies(*model);
      Placements placements(model->items.size());
      QuickSearch(*model, dependencies, {}, 1, 1000).complete(placements, budget);
    } else {
      Search search(*model, {}, 1, 1000);
      search.construct(8, budget);
      search.improve(budget, kPatience);
    }
    return budget.steps + budget.work;
  }
};

constexpr std::int64_t kMoment = 100'000;  // steps: some milliseconds

SceneGraph near_in_many_ways(int ways) {
  SceneMaker maker(6000, 5000);
  maker.add("armchair").add("sofa");
  for (Mm i = 0; i < ways; ++i) {
    RelationParameters band;
    band.min = 300 + i, band.max = 2500 + i;
    maker.relate("near", {"armchair_1"}, {"sofa_1"}, band);
  }
  return maker.make(true);
}

// Bounds of domains are looked for only as long as there is time.
TEST_F(AfterTheStop, DomainsStayAsWideAsTheyAre) {
  const SceneGraph scene = near_in_many_ways(200);
  const auto model = build_model(scene, Catalog::builtin());
  ASSERT_TRUE(model);
  Budget budget{0, 1'000'000'000, [] { return true; }, false};
  RegionFinder finder(*model, {});
  finder.watch(&budget);
  EXPECT_TRUE(budget.stopped);
  EXPECT_LT(budget.work, kMoment);
}

// Wherever in its moves the stop finds the improvement of a crowd.
TEST_F(AfterTheStop, ACrowdIsMovedNoMore) {
  const SceneGraph scene = grid_of_chairs(225, 15);
  const auto model = build_model(scene, Catalog::builtin());
  ASSERT_TRUE(model);
  Budget finding{0, 1'000'000'000, {}, false};
  Search search(*model, {}, 1, 0);
  ASSERT_TRUE(search.construct(1, finding));
  const Placements found = search.placements();
  for (int asks = 0; asks < 300; asks += 20) {
    int asked = 0;
    std::optional<std::int64_t> at;
    Budget budget{0, 1'000'000'000, {}, false};
    budget.stop = [&] {
      if (++asked > asks && !at) at = budget.steps + budget.work;
      return at.has_value();
    };
    search.adopt(found);
    search.improve(budget, kPatience, false);
    if (!at) continue;
    EXPECT_LT(budget.steps + budget.work - *at, kMoment / 4) << "after the stop was asked for " << asks << " times";
  }
}

TEST_F(AfterTheStop, NothingMuchIsDone) {
  const SceneGraph chairs = grid_of_chairs(400, 20);
  EXPECT_LT(work_of(chairs, true), kMoment);
  EXPECT_LT(work_of(chairs, false), kMoment);
  const SceneGraph near = near_in_many_ways(80);
  EXPECT_LT(work_of(near, true), kMoment);
  EXPECT_LT(work_of(near, false), kMoment);
}

TEST(Large, AGridOfHundredsIsFoundAtOnce) {
  SolveOptions options;
  options.improve = false;
  const auto layout = solve(grid_of_chairs(490, 22), Catalog::builtin(), options);
  ASSERT_TRUE(layout) << layout.error().message;
  EXPECT_EQ(layout->status, LayoutStatus::kSolved);
}

TEST(TooMuch, OneSentenceSaysWhatIsMissingAndWhatWouldHelp) {
  const auto layout =
      solve(SceneMaker(3000, 3000).add("sofa", 4).add("bed", 3).add("desk", 3).add("wardrobe", 3).make(true), Catalog::builtin());
  ASSERT_TRUE(layout) << layout.error().message;
  expect_sound(*layout);
  EXPECT_EQ(layout->status, LayoutStatus::kRelaxed);
  ASSERT_EQ(layout->conflicts.size(), 1u);
  const std::string& sentence = layout->conflicts[0].sentence;
  for (const char* part : {"the 4 sofas", "the 3 beds", "need at least", "the room has 9.0 m²", "less", "without", "all else fits"})
    EXPECT_THAT(sentence, HasSubstr(part));
  EXPECT_GE(layout->objects.size(), 4u);
  for (const Relaxation& r : layout->relaxed) EXPECT_THAT(r.why, HasSubstr(sentence));
}

}  // namespace
}  // namespace layoutbox::placement
