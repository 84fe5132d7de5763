#include <gmock/gmock.h>

#include "layoutbox/catalog/test_kinds.h"

namespace layoutbox {
namespace {

using test_kinds::object;
using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::Not;

SceneGraph with_things(std::vector<SceneObject> objects, bool window) {
  SceneGraph scene = test_kinds::scene_of(std::move(objects));
  scene.room.openings_given = true;
  if (window) {
    scene.room.openings.emplace_back();
    scene.room.openings.back().id = "window1";
    scene.room.openings.back().type = OpeningType::kWindow;
  }
  return scene;
}

SceneGraph normal(const SceneGraph& scene) {
  auto made = normalize_scene(scene, Catalog::builtin());
  EXPECT_TRUE(made) << made.error().message;
  return made ? *made : SceneGraph{};
}

auto misses_a_window(const std::string& id) {
  return Contains(AllOf(Field(&Note::code, "contradiction"), Field(&Note::message, HasSubstr("no window for \"" + id + "\""))));
}

TEST(NormalizeCurtains, SaysWhereThereIsNoWindow) {
  for (const char* kind : {"curtain", "sheer_curtain", "blackout_curtain", "blind"}) {
    const SceneGraph scene = normal(with_things({object("bed1", "bed"), object("c1", kind)}, false));
    EXPECT_THAT(scene.notes, misses_a_window("c1")) << kind;
    EXPECT_THAT(normal(with_things({object("bed1", "bed"), object("c1", kind)}, true)).notes, Not(misses_a_window("c1"))) << kind;
    const auto once = std::ranges::count(normal(scene).notes, "contradiction", &Note::code);
    EXPECT_EQ(once, std::ranges::count(scene.notes, "contradiction", &Note::code)) << "said again";
  }
}

TEST(NormalizeCurtains, SaysNothingOfThoseThatHangElsewhere) {
  for (const char* kind : {"shower_curtain", "privacy_curtain"}) {
    EXPECT_THAT(normal(with_things({object("tub1", "bathtub"), object("c1", kind)}, false)).notes, Not(misses_a_window("c1"))) << kind;
  }
  SceneGraph stage = with_things({object("c1", "curtain")}, false);
  stage.relations = {test_kinds::relation(RelationType::kOnWall, {"c1"}, {"back"})};
  EXPECT_THAT(normal(stage).notes, Not(misses_a_window("c1"))) << "the wall is named";
}

}  // namespace
}  // namespace layoutbox
