// Every relation: a scene in which it can hold gives a layout in which it holds, in four rooms that are the same room turned; and what
// the layout says is checked with the plain coordinates of the objects.
#include <gtest/gtest.h>

#include <algorithm>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

struct Example {
  const char* name;
  void (*fill)(SceneMaker&);
};

RelationParameters with(void (*set)(RelationParameters&)) {
  RelationParameters p;
  set(p);
  return p;
}

const std::vector<Example> kExamples{
    {"offset",
     [](SceneMaker& s) {
       s.add("desk").add("bed").relate("offset", {"desk_1"}, {"bed_1"}, with([](auto& p) { p.axis = Axis::kX, p.distance = 450; }));
     }},
    {"align",
     [](SceneMaker& s) { s.add("desk").add("bed").relate("align", {"desk_1"}, {"bed_1"}, with([](auto& p) { p.axis = Axis::kY; })); }},
    {"inside", [](SceneMaker& s) { s.add("rug").sized(2000, 2000, 10).add("chair").relate("inside", {"chair_1"}, {"rug_1"}); }},
    {"groupAlign",
     [](SceneMaker& s) {
       s.add("stool", 3).relate("groupAlign", {"stool_1", "stool_2", "stool_3"}, {}, with([](auto& p) { p.axis = Axis::kX; }));
     }},
    {"againstWall", [](SceneMaker& s) { s.add("bed").relate("againstWall", {"bed_1"}, {"wall2"}); }},
    {"sideAgainstWall",
     [](SceneMaker& s) { s.add("bed").relate("sideAgainstWall", {"bed_1"}, {"wall2"}, with([](auto& p) { p.side = Side::kLeft; })); }},
    {"corner",
     [](SceneMaker& s) {
       s.add("plant").relate("corner", {"plant_1"}, {"wall2", "wall3"});
     }},
    {"centerOfRoom", [](SceneMaker& s) { s.add("table").relate("centerOfRoom", {"table_1"}); }},
    {"centeredOnWall", [](SceneMaker& s) { s.add("wardrobe").relate("centeredOnWall", {"wardrobe_1"}, {"wall1"}); }},
    {"inRegion", [](SceneMaker& s) { s.add("desk").relate("inRegion", {"desk_1"}, {}, with([](auto& p) { p.region = "left"; })); }},
    {"onWall", [](SceneMaker& s) { s.add("mirror").mounted(Mount::kWall).relate("onWall", {"mirror_1"}, {"wall4"}); }},
    {"onCeiling", [](SceneMaker& s) { s.add("pendant_lamp").relate("onCeiling", {"pendant_lamp_1"}); }},
    {"awayFromWall", [](SceneMaker& s) { s.add("sofa").relate("awayFromWall", {"sofa_1"}); }},
    {"underWindow",
     [](SceneMaker& s) { s.opening(OpeningType::kWindow, "wall3", 1500, 1200, 900, 1200).add("desk").relate("underWindow", {"desk_1"}); }},
    {"nearDoor", [](SceneMaker& s) { s.opening(OpeningType::kDoor, "wall1", 300).add("coat_rack").relate("nearDoor", {"coat_rack_1"}); }},
    {"nearWindow",
     [](SceneMaker& s) {
       s.opening(OpeningType::kWindow, "wall2", 900, 1200, 900, 1200).add("armchair").relate("nearWindow", {"armchair_1"});
     }},
    {"farFromDoor", [](SceneMaker& s) { s.opening(OpeningType::kDoor, "wall1", 300).add("bed").relate("farFromDoor", {"bed_1"}); }},
    {"farFromWindow",
     [](SceneMaker& s) {
       s.opening(OpeningType::kWindow, "wall3", 900, 1200, 900, 1200).add("tv_stand").relate("farFromWindow", {"tv_stand_1"});
     }},
    {"notBlocking",
     [](SceneMaker& s) { s.opening(OpeningType::kDoor, "wall1", 300).add("wardrobe").relate("notBlocking", {"wardrobe_1"}, {"door1"}); }},
    {"leftOf", [](SceneMaker& s) { s.add("bed").add("nightstand").relate("leftOf", {"nightstand_1"}, {"bed_1"}); }},
    {"rightOf", [](SceneMaker& s) { s.add("sofa").add("floor_lamp").relate("rightOf", {"floor_lamp_1"}, {"sofa_1"}); }},
    {"inFrontOf", [](SceneMaker& s) { s.add("sofa").add("coffee_table").relate("inFrontOf", {"coffee_table_1"}, {"sofa_1"}); }},
    {"behind", [](SceneMaker& s) { s.add("sofa").add("console_table").relate("behind", {"console_table_1"}, {"sofa_1"}); }},
    {"nextTo", [](SceneMaker& s) { s.add("desk").add("chair").relate("nextTo", {"chair_1"}, {"desk_1"}); }},
    {"near", [](SceneMaker& s) { s.add("sofa").add("armchair").relate("near", {"armchair_1"}, {"sofa_1"}); }},
    {"far",
     [](SceneMaker& s) { s.add("chair").add("plant").relate("far", {"plant_1"}, {"chair_1"}, with([](auto& p) { p.min = 3000; })); }},
    {"distance",
     [](SceneMaker& s) {
       s.add("sofa").add("tv_stand").relate("distance", {"tv_stand_1"}, {"sofa_1"}, with([](auto& p) { p.min = 1800, p.max = 2200; }));
     }},
    {"touching", [](SceneMaker& s) { s.add("bed").add("bench").relate("touching", {"bench_1"}, {"bed_1"}); }},
    {"edgeAlign",
     [](SceneMaker& s) {
       s.add("bed").add("nightstand").relate("edgeAlign", {"nightstand_1"}, {"bed_1"}, with([](auto& p) { p.edge = "back"; }));
     }},
    {"facing", [](SceneMaker& s) { s.add("tv_stand").add("sofa").relate("facing", {"sofa_1"}, {"tv_stand_1"}); }},
    {"opposite", [](SceneMaker& s) { s.add("sofa").add("armchair").relate("opposite", {"armchair_1"}, {"sofa_1"}); }},
    {"parallel", [](SceneMaker& s) { s.add("desk").add("bed").relate("parallel", {"desk_1"}, {"bed_1"}); }},
    {"perpendicular", [](SceneMaker& s) { s.add("desk").add("bed").relate("perpendicular", {"desk_1"}, {"bed_1"}); }},
    {"sameOrientation", [](SceneMaker& s) { s.add("chair", 2).relate("sameOrientation", {"chair_1"}, {"chair_2"}); }},
    {"centeredOn", [](SceneMaker& s) { s.add("coffee_table").add("rug").relate("centeredOn", {"rug_1"}, {"coffee_table_1"}); }},
    {"atFootOf", [](SceneMaker& s) { s.add("bed").add("bench").relate("atFootOf", {"bench_1"}, {"bed_1"}); }},
    {"atHeadOf", [](SceneMaker& s) { s.add("bed").add("nightstand").relate("atHeadOf", {"nightstand_1"}, {"bed_1"}); }},
    {"alongSide", [](SceneMaker& s) { s.add("dining_table").add("bench").relate("alongSide", {"bench_1"}, {"dining_table_1"}); }},
    {"tuckedUnder", [](SceneMaker& s) { s.add("desk").add("chair").relate("tuckedUnder", {"chair_1"}, {"desk_1"}); }},
    {"on", [](SceneMaker& s) { s.add("desk").add("table_lamp").relate("on", {"table_lamp_1"}, {"desk_1"}); }},
    {"under", [](SceneMaker& s) { s.add("table").add("rug").relate("under", {"rug_1"}, {"table_1"}); }},
    {"above", [](SceneMaker& s) { s.add("sofa").add("painting").relate("above", {"painting_1"}, {"sofa_1"}); }},
    {"in", [](SceneMaker& s) { s.add("bookshelf").add("book").relate("in", {"book_1"}, {"bookshelf_1"}); }},
    {"stacked",
     [](SceneMaker& s) {
       s.add("box", 3).relate("stacked", {"box_1", "box_2", "box_3"});
     }},
    {"around",
     [](SceneMaker& s) {
       s.add("dining_table")
           .add("dining_chair", 4)
           .relate("around", {"dining_chair_1", "dining_chair_2", "dining_chair_3", "dining_chair_4"}, {"dining_table_1"});
     }},
    {"eachSideOf",
     [](SceneMaker& s) {
       s.add("bed").add("nightstand", 2).relate("eachSideOf", {"nightstand_1", "nightstand_2"}, {"bed_1"});
     }},
    {"between",
     [](SceneMaker& s) {
       s.add("armchair", 2).add("side_table").relate("between", {"side_table_1"}, {"armchair_1", "armchair_2"});
     }},
    {"row",
     [](SceneMaker& s) {
       s.add("stool", 3).relate("row", {"stool_1", "stool_2", "stool_3"});
     }},
    {"grid",
     [](SceneMaker& s) {
       s.add("stool", 6).relate("grid", {"stool_1", "stool_2", "stool_3", "stool_4", "stool_5", "stool_6"}, {}, with([](auto& p) {
                                  p.columns = 3;
                                }));
     }},
    {"column",
     [](SceneMaker& s) {
       s.add("stool", 3).relate("column", {"stool_1", "stool_2", "stool_3"});
     }},
    {"evenlySpaced",
     [](SceneMaker& s) {
       s.add("plant", 3).relate("evenlySpaced", {"plant_1", "plant_2", "plant_3"});
     }},
    {"symmetricAbout",
     [](SceneMaker& s) {
       s.add("bed").add("floor_lamp", 2).relate("symmetricAbout", {"floor_lamp_1", "floor_lamp_2"}, {"bed_1"});
     }},
    {"surround",
     [](SceneMaker& s) {
       s.add("table").add("chair", 3).relate("surround", {"chair_1", "chair_2", "chair_3"}, {"table_1"});
     }},
    {"pairedWith",
     [](SceneMaker& s) {
       s.add("desk", 2).add("chair", 2).relate("pairedWith", {"chair_1", "chair_2"}, {"desk_1", "desk_2"});
     }},
    {"clearance",
     [](SceneMaker& s) { s.add("wardrobe").add("bed").relate("clearance", {"wardrobe_1"}, {}, with([](auto& p) { p.depth = 900; })); }},
    {"reachable", [](SceneMaker& s) { s.opening(OpeningType::kDoor, "wall1", 300).add("bed").relate("reachable", {"bed_1"}); }},
    {"keepClear", [](SceneMaker& s) { s.add("sofa").relate("keepClear", {"sofa_1"}, {}, with([](auto& p) { p.region = "middle"; })); }},
};

class Relations : public testing::TestWithParam<Example> {};

TEST_P(Relations, HoldsWhereItCan) {
  SceneMaker maker(5200, 4200, 2700);
  GetParam().fill(maker);
  const SceneGraph scene = maker.make();
  const auto layout = solve(scene, Catalog::builtin());
  ASSERT_TRUE(layout) << layout.error().message;
  expect_sound(*layout);
  EXPECT_EQ(layout->status, LayoutStatus::kSolved);
  for (const PlacedRelation& r : layout->relations) EXPECT_TRUE(r.held) << relation_row(r.relation.type).name;
  EXPECT_EQ(layout->objects.size(), scene.objects.size());
}

INSTANTIATE_TEST_SUITE_P(All, Relations, testing::ValuesIn(kExamples), [](const auto& example) { return std::string(example.param.name); });

TEST(RelationExamples, ThereIsOneForEveryRow) {
  for (const RelationRow& row : relation_table()) {
    EXPECT_TRUE(std::any_of(kExamples.begin(), kExamples.end(), [&](const Example& e) { return e.name == row.name; })) << row.name;
  }
}

// ------------------------------------------------------------------------------------------- what it means, in plain coordinates

// The reference stands fixed, turned by quarters; the target must come to the side named in the reference's own frame.
class OwnFrame : public testing::TestWithParam<int> {};

TEST_P(OwnFrame, LeftIsTheLeftOfTheReference) {
  const int turn = GetParam();
  const struct {
    const char* relation;
    double x, y;  // where in the frame of the reference
  } sides[] = {{"leftOf", -1, 0}, {"rightOf", 1, 0}, {"inFrontOf", 0, -1}, {"behind", 0, 1}};
  for (const auto& side : sides) {
    const SceneGraph scene = SceneMaker(6000, 6000)
                                 .add("sofa")
                                 .at(3000, 3000, 0, turn, true)
                                 .add("plant")
                                 .sized(300, 300, 800)
                                 .relate(side.relation, {"plant_1"}, {"sofa_1"})
                                 .make();
    const auto layout = solve(scene, Catalog::builtin());
    ASSERT_TRUE(layout);
    const PlacedObject &sofa = *layout->find_object("sofa_1"), &plant = *layout->find_object("plant_1");
    const TestPoint p = in_frame_of(sofa, {plant.position[0], plant.position[1], 0});
    const double half[2] = {sofa.size.width / 2.0, sofa.size.depth / 2.0};
    if (side.x != 0) {
      EXPECT_GE(p.x * side.x, half[0] + 149) << side.relation << " at " << turn;
      EXPECT_LE(std::abs(p.y), half[1] + 1);
    } else {
      EXPECT_GE(p.y * side.y, half[1] + 149) << side.relation << " at " << turn;
      EXPECT_LE(std::abs(p.x), half[0] + 1);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Quarters, OwnFrame, testing::Values(0, 90, 180, 270));

TEST(AgainstWall, EachWallTurnsTheBackToIt) {
  const double turns[4] = {180, 270, 0, 90};  // front, right, back, left wall
  for (int w = 0; w < 4; ++w) {
    const auto layout =
        solve(SceneMaker(4000, 3000).add("wardrobe").relate("againstWall", {"wardrobe_1"}, {"wall" + std::to_string(w + 1)}).make(),
              Catalog::builtin());
    ASSERT_TRUE(layout);
    const PlacedObject& wardrobe = layout->objects[0];
    EXPECT_EQ(wardrobe.rotation_deg, turns[w]);
    const double gap[4] = {wardrobe.position[1], 4000 - wardrobe.position[0], 3000 - wardrobe.position[1], wardrobe.position[0]};
    EXPECT_NEAR(gap[w], wardrobe.size.depth / 2.0, 20.5);
  }
}

TEST(Around, ChairsLookAtTheTableAndAreSpread) {
  const auto layout = solve(
      SceneMaker(4500, 4000)
          .add("dining_table")
          .add("dining_chair", 6)
          .relate("around", {"dining_chair_1", "dining_chair_2", "dining_chair_3", "dining_chair_4", "dining_chair_5", "dining_chair_6"},
                  {"dining_table_1"})
          .make(),
      Catalog::builtin());
  ASSERT_TRUE(layout);
  const PlacedObject& table = *layout->find_object("dining_table_1");
  for (const PlacedObject& o : layout->objects) {
    if (o.category != "dining_chair") continue;
    const double dx = table.position[0] - o.position[0], dy = table.position[1] - o.position[1];
    const double a = o.rotation_deg * kPi / 180, fx = std::sin(a), fy = -std::cos(a);
    EXPECT_GT(dx * fx + dy * fy, 0) << o.id << " looks away";
  }
}

TEST(Impossible, IsSaidWithARelaxation) {
  const auto layout = solve(
      SceneMaker(3000, 3000).add("chair").add("plant").relate("far", {"plant_1"}, {"chair_1"}, with([](auto& p) { p.min = 6000; })).make(),
      Catalog::builtin());
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->status, LayoutStatus::kRelaxed);
  ASSERT_EQ(layout->relaxed.size(), 1u);
  EXPECT_EQ(layout->relaxed[0].relation, "c1");
  EXPECT_GT(layout->relaxed[0].by, 1);
  EXPECT_FALSE(layout->relations[0].held);
}

}  // namespace
}  // namespace layoutbox::placement
