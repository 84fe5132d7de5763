// Carpets and benches as large as what stands on them, or what they are pushed under, needs.
#include <gtest/gtest.h>

#include "layoutbox/catalog/test_kinds.h"

namespace layoutbox {
namespace {

using namespace test_kinds;

TEST(NormalizeCarpets, OneThatManyBedsStandOnIsAsLargeAsTheyAre) {
  const auto area = [](int beds) {
    std::vector<SceneObject> objects{object("rug_1", "rug")};
    std::vector<Relation> relations;
    for (int i = 0; i < beds; ++i) {
      objects.push_back(object("bed_" + std::to_string(i), "folding_bed"));
      relations.push_back(relation(RelationType::kOn, {objects.back().id}, {"rug_1"}));
    }
    const Size size = with_whole_catalogue(scene_of(objects, relations)).find_object("rug_1")->size->usual;
    return 1e-6 * size.width * size.depth;
  };
  EXPECT_EQ(area(1), area(0));
  EXPECT_GT(area(6), 6 * 0.85 * 1.95 + 6);  // and ways between them
}

TEST(NormalizeCarpets, ATableclothCoversItsTable) {
  const SceneGraph scene = with_whole_catalogue(scene_of({object("table_1", "dining_table"), object("cloth_1", "tablecloth")},
                                                         {relation(RelationType::kOn, {"cloth_1"}, {"table_1"})}));
  const Size &top = scene.find_object("table_1")->size->usual, &cloth = scene.find_object("cloth_1")->size->usual;
  EXPECT_GT(cloth.width, top.width * 9 / 10);
  EXPECT_GT(cloth.depth, top.depth * 9 / 10);
  EXPECT_LT(cloth.width, top.width);
}

TEST(NormalizeWorktops, AWorkbenchAlongAWallIsLong) {
  const auto width = [](const char* why) {
    Relation at = relation(RelationType::kAgainstWall, {"bench_1"}, {"back"});
    at.why = why;
    SceneGraph scene = scene_of({object("bench_1", "workbench")}, {at});
    scene.room.polygon = {{0, 0}, {9000, 0}, {9000, 6000}, {0, 6000}};
    return with_whole_catalogue(scene).find_object("bench_1")->size->usual.width;
  };
  EXPECT_GT(width("along the back wall"), 2500);
  EXPECT_LT(width("on the back wall"), 2000);
}

TEST(NormalizeGuests, ABenchUnderADeskIsNoWiderThanTheKneesHaveRoom) {
  const auto width = [](const char* table) {
    return with_whole_catalogue(scene_of({object("table_1", table), object("bench_1", "bench")},
                                         {relation(RelationType::kTuckedUnder, {"bench_1"}, {"table_1"})}))
        .find_object("bench_1")
        ->size->usual.width;
  };
  EXPECT_LT(width("school_desk"), 650);
  EXPECT_EQ(width("dining_table"), 1200);
}

}  // namespace
}  // namespace layoutbox
