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
