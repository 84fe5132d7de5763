// What came unasked for with another thing is the first to give way, and goes with what it came with.
#include <gmock/gmock.h>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

using testing::HasSubstr;
using testing::Not;

SceneMaker& added(SceneMaker& maker, const std::string& kind) {
  maker.add(kind).raw().objects.back().origin = Origin::kAdded;
  return maker;
}

SceneMaker& relate_added(SceneMaker& maker, const std::string& type, const std::string& target, const std::string& reference) {
  maker.relate(type, {target}, {reference}).raw().relations.back().origin = Origin::kAdded;
  return maker;
}

void with_lamp(SceneMaker& maker, const std::string& number) {
  added(added(maker, "nightstand"), "table_lamp");
  relate_added(maker, "on", "table_lamp_" + number, "nightstand_" + number);
}

TEST(Companions, GiveWayBeforeAnythingThatWasAskedFor) {
  SceneMaker maker(2000, 1600);
  maker.add("bed").add("wardrobe").add("desk");
  relate_added(added(maker, "office_chair"), "nextTo", "office_chair_1", "desk_1");
  with_lamp(maker, "1");
  const SceneGraph scene = maker.make(true);
  for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
    for (const bool prove : {true, false}) {
      SolveOptions options;
      options.seed = seed, options.prove = prove;
      const auto layout = solve(scene, Catalog::builtin(), options);
      ASSERT_TRUE(layout) << layout.error().message;
      expect_sound(*layout);
      EXPECT_EQ(layout->status, LayoutStatus::kSolved) << "seed " << seed;
      for (const char* asked : {"bed_1", "wardrobe_1", "desk_1"}) EXPECT_NE(layout->find_object(asked), nullptr) << asked;
    }
  }
}

TEST(Companions, ThoseThatFitAfterAllStay) {
  SceneMaker maker(3400, 3000);
  maker.add("bed").add("wardrobe").add("pool_table").sized(3300, 2800, 800);
  with_lamp(maker, "1");
  const auto layout = solve(maker.make(), Catalog::builtin());
  ASSERT_TRUE(layout) << layout.error().message;
  expect_sound(*layout);
  EXPECT_LT(layout->objects.size(), 5U);
  EXPECT_NE(layout->find_object("nightstand_1"), nullptr);
  EXPECT_NE(layout->find_object("table_lamp_1"), nullptr);
}

TEST(Companions, GoWithWhatTheyCameWith) {
  SceneMaker maker(2000, 2000);
  maker.add("desk").sized(1200, 600, 750);
  maker.add("piano").sized(2200, 1500, 1100);
  added(maker, "piano_stool");
  const auto layout = solve(maker.make(), Catalog::builtin());
  ASSERT_TRUE(layout) << layout.error().message;
  expect_sound(*layout);
  EXPECT_NE(layout->find_object("desk_1"), nullptr);
  EXPECT_EQ(layout->find_object("piano_stool_1"), nullptr);
}

TEST(Companions, AreNotSharedOutAmongThoseThatAreLeft) {
  SceneMaker maker(4000, 3000);
  maker.add("bed", 5).add("wardrobe", 5);
  for (const char* number : {"1", "2", "3", "4", "5"}) with_lamp(maker, number);
  const auto layout = solve(maker.make(true), Catalog::builtin());
  ASSERT_TRUE(layout) << layout.error().message;
  expect_sound(*layout);
  const auto count = [&](const std::string& kind) {
    return std::ranges::count_if(layout->objects, [&](const PlacedObject& o) { return o.category == kind; });
  };
  EXPECT_GE(count("bed") + count("wardrobe"), 8);
  EXPECT_LE(count("nightstand"), count("bed"));
  EXPECT_LE(count("table_lamp"), count("nightstand"));
}

TEST(TooMuch, TheSentenceSpeaksOfWhatWasAskedFor) {
  SceneMaker maker(3000, 3000);
  maker.add("sofa", 4).add("bed", 3).add("desk", 3).add("wardrobe", 3);
  for (const char* number : {"1", "2", "3"}) {
    with_lamp(maker, number);
    relate_added(added(maker, "office_chair"), "nextTo", std::string("office_chair_") + number, std::string("desk_") + number);
  }
  const auto layout = solve(maker.make(true), Catalog::builtin());
  ASSERT_TRUE(layout) << layout.error().message;
  expect_sound(*layout);
  ASSERT_EQ(layout->conflicts.size(), 1U);
  const std::string& sentence = layout->conflicts[0].sentence;
  for (const char* part : {"the 4 sofas", "the 3 beds", "need at least", "the room has 9.0 m²", "less", "without"})
    EXPECT_THAT(sentence, HasSubstr(part));
  EXPECT_THAT(sentence, Not(HasSubstr("nightstand")));
  EXPECT_THAT(sentence, Not(HasSubstr("chair")));
}

TEST(TooMuch, WhatOthersSlideUnderCountsToo) {
  const SceneGraph scene = SceneMaker(3000, 3000).add("sofa", 4).add("bed", 3).add("nightstand", 3).add("wardrobe", 3).make(true);
  const auto layout = solve(scene, Catalog::builtin());
  ASSERT_TRUE(layout) << layout.error().message;
  ASSERT_EQ(layout->conflicts.size(), 1U);
  for (const char* part : {"the 4 sofas", "the 3 beds", "need at least", "the room has 9.0 m²", "less", "without"})
    EXPECT_THAT(layout->conflicts[0].sentence, HasSubstr(part));
}

}  // namespace
}  // namespace layoutbox::placement
