// What is proposed where things cannot all hold.
#include "layoutbox/pipeline/scene_changes.h"

#include <gmock/gmock.h>

#include "layoutbox/pipeline/generate.h"
#include "layoutbox/scene/scene_json.h"

namespace layoutbox {
namespace {

using Json = nlohmann::json;
using testing::Contains;
using testing::Field;
using testing::HasSubstr;
using testing::Not;

// Two things and what is said of them; all of it is in conflict.
std::vector<SceneChange> changes_for(const Json& constraints) {
  const Json document = {
      {"room", {{"dims", {{"w", 4}, {"d", 3}, {"h", 2.5}}}}},
      {"furniture", {{{"id", "chair_1"}, {"category", "chair"}}, {{"id", "table_1"}, {"category", "table"}}}},
      {"constraints", constraints},
  };
  const SceneGraph scene = prepare_scene(read_scene(document.dump()).value(), Catalog::builtin(), {}).value();
  Layout layout;
  Conflict conflict;
  for (const Json& relation : constraints) conflict.relations.push_back(relation.at("id").get<std::string>());
  layout.conflicts.push_back(conflict);
  return propose_changes({document, scene, layout, Catalog::builtin(), false});
}

Json relation(const char* id, const char* type, const char* target, const char* reference) {
  return {{"id", id}, {"type", type}, {"targets", {target}}, {"relativeTo", reference}, {"hard", true}};
}

const auto kOtherSide = [](const char* words) { return Contains(Field(&SceneChange::sentence, HasSubstr(words))); };

TEST(SceneChanges, TheOtherSideIsProposed) {
  EXPECT_THAT(changes_for(Json::array({relation("c1", "leftOf", "chair_1", "table_1")})), kOtherSide("be rightOf instead of leftOf"));
}

TEST(SceneChanges, WhatIsSaidAlreadyIsNoFurtherWayOut) {
  EXPECT_THAT(changes_for(Json::array({relation("c1", "leftOf", "chair_1", "table_1"), relation("c2", "rightOf", "chair_1", "table_1")})),
              Not(kOtherSide("instead of")));
  EXPECT_THAT(changes_for(Json::array({relation("c1", "behind", "chair_1", "table_1"), relation("c2", "inFrontOf", "chair_1", "table_1")})),
              Not(kOtherSide("instead of")));
}

TEST(SceneChanges, NorIsWhatIsSaidFromTheOtherThing) {
  EXPECT_THAT(changes_for(Json::array({relation("c1", "leftOf", "chair_1", "table_1"), relation("c2", "leftOf", "table_1", "chair_1")})),
              Not(kOtherSide("instead of")));
}

TEST(SceneChanges, WhatIsSaidOfOtherThingsDoesNotCount) {
  EXPECT_THAT(changes_for(Json::array({relation("c1", "leftOf", "chair_1", "table_1"), relation("c2", "rightOf", "table_1", "chair_1")})),
              kOtherSide("be rightOf instead of leftOf"));
}

}  // namespace
}  // namespace layoutbox
