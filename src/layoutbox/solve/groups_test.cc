// Relations of groups: several things opposite one, seats along a counter; and distances in a narrow ring.
#include <gtest/gtest.h>

#include <algorithm>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

TEST(Opposite, TwoArmchairsStandSideBySideBeforeTheSofa) {
  for (const char* wall : {"wall1", "wall2", "wall3", "wall4"}) {
    const auto layout = solve(SceneMaker(5000, 4500)
                                  .add("sofa")
                                  .add("armchair", 2)
                                  .add("coffee_table")
                                  .relate("againstWall", {"sofa_1"}, {wall})
                                  .relate("opposite", {"armchair_1", "armchair_2"}, {"sofa_1"})
                                  .relate("inFrontOf", {"coffee_table_1"}, {"sofa_1"})
                                  .make(),
                              Catalog::builtin());
    ASSERT_TRUE(layout) << layout.error().message;
    expect_sound(*layout);
    EXPECT_EQ(layout->status, LayoutStatus::kSolved) << wall;
    const PlacedObject &sofa = *layout->find_object("sofa_1"), &one = *layout->find_object("armchair_1"),
                       &two = *layout->find_object("armchair_2");
    const TestPoint a = in_frame_of(sofa, {one.position[0], one.position[1], 0}),
                    b = in_frame_of(sofa, {two.position[0], two.position[1], 0});
    EXPECT_GE(std::abs(a.x - b.x), one.size.width - 1) << "one behind the other";
    EXPECT_NEAR(a.x + b.x, 0, 300) << "not before the middle of the sofa";
    EXPECT_LT(std::abs(a.y - b.y), 300);
  }
}

TEST(Opposite, AGroupOfManyMayStandInRows) {
  const auto layout = solve(SceneMaker(9000, 9000)
                                .add("podium")
                                .add("chair", 6)
                                .relate("opposite", {"chair_1", "chair_2", "chair_3", "chair_4", "chair_5", "chair_6"}, {"podium_1"})
                                .make(),
                            Catalog::builtin());
  ASSERT_TRUE(layout);
  expect_sound(*layout);
  EXPECT_EQ(layout->status, LayoutStatus::kSolved);
}

// Where the octagons that stand for circles have no room between them.
TEST(Distance, NarrowRingsAreFound) {
  const struct {
    Mm width, depth, least, most;
  } rooms[] = {{5550, 3760, 4800, 4800}, {4000, 4000, 3500, 3520}, {3000, 5000, 4000, 4030}, {4500, 3500, 2600, 2600}};
  for (const auto& room : rooms) {
    RelationParameters apart;
    apart.min = room.least, apart.max = room.most;
    const auto layout =
        solve(SceneMaker(room.width, room.depth).add("pouf").add("plant").relate("distance", {"pouf_1"}, {"plant_1"}, apart).make(),
              Catalog::builtin());
    ASSERT_TRUE(layout) << layout.error().message;
    expect_sound(*layout);
    EXPECT_EQ(layout->status, LayoutStatus::kSolved) << room.least;
  }
}

// Twenty-four desks in groups of four, each with its chair: blocks with ways between them, everybody at a desk.
TEST(Habit, GroupsOfDesksStandInBlocks) {
  constexpr int kGroups = 6, kDesks = 4;
  SceneMaker maker(12'000, 10'000);
  maker.add("desk", kGroups * kDesks).add("chair", kGroups * kDesks);
  RelationParameters close;
  close.gap = 0, close.columns = 2;
  const auto name = [](const char* kind, int group, int k) { return kind + std::to_string(group * kDesks + k + 1); };
  for (int g = 0; g < kGroups; ++g) {
    maker.relate("grid", {name("desk_", g, 0), name("desk_", g, 1), name("desk_", g, 2), name("desk_", g, 3)}, {}, close);
    for (int k = 0; k < kDesks; ++k) {
      maker.relate("behind", {name("desk_", g, k)}, {name("desk_", g, (k + 2) % kDesks)});
      maker.relate("nextTo", {name("chair_", g, k)}, {name("desk_", g, k)});
    }
  }
  const auto layout = solve(maker.make(), Catalog::builtin());
  ASSERT_TRUE(layout) << layout.error().message;
  expect_sound(*layout);
  EXPECT_EQ(layout->status, LayoutStatus::kSolved);
  EXPECT_EQ(layout->objects.size(), std::size_t{2} * kGroups * kDesks);
  const auto middle = [&](int g) {
    const auto &one = *layout->find_object(name("desk_", g, 0)), &last = *layout->find_object(name("desk_", g, 3));
    return TestPoint{(one.position[0] + last.position[0]) / 2, (one.position[1] + last.position[1]) / 2, 0};
  };
  for (int g = 0; g < kGroups; ++g) {
    for (int other = 0; other < g; ++other) {
      const TestPoint a = middle(g), b = middle(other);
      EXPECT_GT(std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)), 1900) << g << " and " << other << " are in one heap";
    }
  }
}

TEST(Habit, EightStoolsAlongALongCounterInALine) {
  SceneMaker maker(8000, 5000);
  maker.add("counter").add("bar_stool", 8);
  for (int i = 1; i <= 8; ++i) {
    const std::string stool = "bar_stool_" + std::to_string(i);
    maker.relate("inFrontOf", {stool}, {"counter_1"}).relate("facing", {stool}, {"counter_1"});
  }
  const auto layout = solve(maker.make(), Catalog::builtin());
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->status, LayoutStatus::kSolved);
  const PlacedObject& counter = *layout->find_object("counter_1");
  std::vector<double> across;
  for (const PlacedObject& o : layout->objects) {
    if (o.category == "bar_stool") across.push_back(in_frame_of(counter, {o.position[0], o.position[1], 0}).y);
  }
  ASSERT_EQ(across.size(), 8u);
  const auto [low, high] = std::minmax_element(across.begin(), across.end());
  EXPECT_LT(*high - *low, 150) << "not in a line";
}

// The first to sit down leaves the others room on the circle: none is left standing in the table's legs.
TEST(Groups, ManyRoundTablesWithEightChairsEach) {
  SceneMaker maker(14800, 11800);
  maker.add("table", 12).add("chair", 96);
  for (SceneObject& object : maker.raw().objects) {
    if (object.category == "table")
      object.name = "round table", object.size = SizeRange{{1700, 1700, 750}, {1700, 1700, 750}, {1700, 1700, 750}};
  }
  for (int table = 0; table < 12; ++table) {
    std::vector<std::string> chairs;
    for (int chair = 1; chair <= 8; ++chair) chairs.push_back("chair_" + std::to_string(8 * table + chair));
    maker.relate("surround", chairs, {"table_" + std::to_string(table + 1)});
  }
  SolveOptions options;
  options.improve = false;
  for (const std::uint64_t seed : {1, 2, 3}) {
    options.seed = seed;
    const auto layout = solve(maker.make(true), Catalog::builtin(), options);
    ASSERT_TRUE(layout) << layout.error().message;
    EXPECT_EQ(layout->status, LayoutStatus::kSolved) << layout->relaxed.size() << " given up";
    EXPECT_EQ(layout->stats.solver, "search");
    expect_sound(*layout);
  }
}

// What has no front may stand turned: the circle is round its longer sides then too.
TEST(Groups, ACircleAroundWhatStandsEitherWay) {
  const struct {
    const char *middle, *seat;
    int seats;
  } rings[] = {{"coffin", "candelabra", 6}, {"wood_stove", "floor_cushion", 3}};
  for (const auto& ring : rings) {
    for (const std::uint64_t seed : {1, 2, 3}) {
      SceneMaker maker(5000, 4500);
      maker.add(ring.middle).add(ring.seat, ring.seats);
      std::vector<std::string> seats;
      for (int seat = 1; seat <= ring.seats; ++seat) seats.push_back(ring.seat + ("_" + std::to_string(seat)));
      maker.relate("surround", seats, {ring.middle + std::string("_1")});
      SolveOptions options;
      options.seed = seed;
      const auto layout = solve(maker.make(), Catalog::builtin(), options);
      ASSERT_TRUE(layout) << layout.error().message;
      EXPECT_EQ(layout->status, LayoutStatus::kSolved) << ring.middle;
      expect_sound(*layout);
    }
  }
}

}  // namespace
}  // namespace layoutbox::placement
