// What relation_traits.cc says of relations holds by the verifier: weaker ones follow, inverse and symmetric ones hold the other way round.
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <utility>
#include <vector>

#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/verify/test_room.h"

namespace layoutbox::checks {
namespace {

constexpr int kRooms = 200;

double within(std::mt19937& random, double low, double high) { return low + (high - low) * static_cast<double>(random() % 1000) / 999; }

// What chance seldom brings about: the sofa looks at the cabinet near it, or hangs on the wall.
TestRoom arranged_room(std::mt19937& random, bool hangs) {
  TestRoom room(6, 5);
  const double x = within(random, 2, 4), gap = within(random, 0.02, 0.45);
  if (hangs)
    room.add("a", "sofa", {2, 0.9, 0.85}, {x, 4.55, 1}, "wall3");
  else
    room.add("a", "sofa", {2, 0.9, 0.85}, {x, 3});
  room.add("b", "cabinet", {0.8, 0.4, 1}, {x + within(random, -0.2, 0.2), 3 - 0.65 - gap});
  return room;
}

// A sofa and a cabinet somewhere in a room, near each other more often than not; the second turned like the first if `alike`.
TestRoom some_room(std::mt19937& random, bool alike) {
  const auto within = [&](double low, double high) { return checks::within(random, low, high); };
  constexpr std::array kTurns{0.0, 90.0, 180.0, 270.0};
  TestRoom room(6, 5);
  room.window("window1", "wall3", 2).door("door1", "wall1", 2);
  const double x = within(1, 5), y = within(1, 4);
  const bool on_wall = random() % 4 == 0;
  const double turn = on_wall ? 0 : kTurns[random() % 4], other = alike ? turn : kTurns[random() % 4];
  room.add("a", "sofa", {2, 0.9, 0.85}, {on_wall ? 3 : x, on_wall ? 4.55 : y, 0, turn});
  const bool on_top = random() % 4 == 0, flush = random() % 4 == 0;
  room.add("b", "cabinet", {0.8, 0.4, 1}, {flush ? x + 1.4 : x + within(-2, 2), flush ? y : y + within(-2, 2), on_top ? 0.85 : 0, other},
           on_top ? "a" : "floor");
  return room;
}

bool holds(TestRoom room, RelationType type, const std::string& target, const std::string& reference) {
  const bool of_room = relation_row(type).group == RelationGroup::kRoomGroup;
  room.layout.relations.clear();
  room.relation(type, {target}, of_room ? std::vector<std::string>{} : std::vector<std::string>{reference});
  return passes(room.judge(), "relation", "c1");
}

// References may be single things, and nothing else has to be said; of groups the one thing is all of them.
bool is_judged_alone(RelationType type) {
  const RelationRow& row = relation_row(type);
  const bool pair = row.group == RelationGroup::kPairGroup || row.group == RelationGroup::kHeightGroup;
  return (pair || traits_of(type).around) && (row.reference_kinds & kObject) != 0 && row.arity != RelationArity::kNone;
}

TEST(RelationTraits, WeakerOnesFollow) {
  std::mt19937 random(1);
  std::map<std::pair<RelationType, RelationType>, int> checked;
  for (int n = 0; n < kRooms; ++n) {
    const TestRoom room = n % 4 == 3 ? arranged_room(random, n % 8 == 3) : some_room(random, n % 2 == 0);
    for (const RelationRow& row : relation_table()) {
      const bool asks = row.group == RelationGroup::kRoomGroup || is_judged_alone(row.type);
      for (const auto& [target, reference] : {std::pair{"a", "b"}, {"b", "a"}}) {
        if (!asks || !holds(room, row.type, target, reference)) continue;
        for (const RelationRow& weak : relation_table()) {
          if (!traits_of(row.type).weaker.has(weak.type)) continue;
          EXPECT_TRUE(holds(room, weak.type, target, reference)) << row.name << " without " << weak.name << " in room " << n;
          ++checked[{row.type, weak.type}];
        }
      }
    }
  }
  for (const RelationRow& row : relation_table()) {
    for (const RelationRow& weak : relation_table()) {
      if (!traits_of(row.type).weaker.has(weak.type)) continue;
      EXPECT_GT((checked[{row.type, weak.type}]), 0) << "in no room " << row.name << " held, from which " << weak.name << " follows";
    }
  }
}

TEST(RelationTraits, OpposedOnesNeverHoldTogether) {
  std::mt19937 random(3);
  int held = 0;
  for (int n = 0; n < kRooms / 4; ++n) {
    const TestRoom room = n % 4 == 3 ? arranged_room(random, n % 8 == 3) : some_room(random, n % 2 == 0);
    std::vector<RelationType> holding;
    for (const RelationRow& row : relation_table()) {
      if (is_judged_alone(row.type) && holds(room, row.type, "a", "b")) holding.push_back(row.type);
    }
    for (const RelationType one : holding) {
      for (const RelationType other : holding) {
        if (one == other) continue;
        EXPECT_FALSE(are_opposed(one, other)) << relation_row(one).name << " and " << relation_row(other).name << " in room " << n;
      }
    }
    held += static_cast<int>(holding.size());
  }
  EXPECT_GT(held, kRooms / 4);
}

TEST(RelationTraits, SymmetricAndInverseOnesHoldTheOtherWayRound) {
  std::mt19937 random(2);
  int checked = 0;
  for (int n = 0; n < kRooms; ++n) {
    const bool alike = n % 2 == 0;
    const TestRoom room = some_room(random, alike);
    for (const RelationRow& row : relation_table()) {
      const RelationTraits& traits = traits_of(row.type);
      if (!is_judged_alone(row.type) || !(traits.symmetric || (alike && traits.inverse)) || !holds(room, row.type, "a", "b")) continue;
      const RelationType back = traits.symmetric ? row.type : *traits.inverse;
      EXPECT_TRUE(holds(room, back, "b", "a")) << row.name << " but not " << relation_row(back).name << " in room " << n;
      ++checked;
    }
  }
  EXPECT_GT(checked, kRooms / 2);
}

TEST(RelationTraits, InversesAreInverse) {
  for (const RelationRow& row : relation_table()) {
    const RelationTraits& traits = traits_of(row.type);
    if (traits.inverse) {
      EXPECT_EQ(traits_of(*traits.inverse).inverse, row.type) << row.name;
    }
    EXPECT_FALSE(traits.weaker.has(row.type)) << row.name;
    EXPECT_FALSE(traits.said_by.has(row.type)) << row.name;
    EXPECT_NE(traits.instead, row.type) << row.name;
  }
}

TEST(RelationTraits, NarrowerOnesAreOfTheWider) {
  for (const RelationRow& row : relation_table()) {
    const RelationTraits& traits = traits_of(row.type);
    EXPECT_TRUE(!traits.rests || traits.supports) << row.name;
    EXPECT_TRUE(!traits.looks || traits.turns) << row.name;
    EXPECT_TRUE(!traits.sideways || traits.placing == Placing::kSide) << row.name;
    EXPECT_FALSE(traits.close_by && traits.keeps_off) << row.name;
    EXPECT_EQ(relations_that<&RelationTraits::rests>().has(row.type), traits.rests) << row.name;
  }
}

}  // namespace
}  // namespace layoutbox::checks
