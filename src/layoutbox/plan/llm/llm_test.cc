#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "layoutbox/plan/llm/draft.h"
#include "layoutbox/plan/llm/loose_json.h"
#include "layoutbox/plan/llm/prompt.h"
#include "layoutbox/plan/llm/strict_schema.h"
#include "layoutbox/scene/relation_table.h"
#include "layoutbox/scene/schema_check.h"

namespace layoutbox::llm {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;

// A value of the schema with every member null that may be, and one item in each list.
json example_of(const json& schema) {
  const json& type = schema.at("type");
  if (type.is_array()) return nullptr;
  if (schema.contains("enum")) return schema["enum"][0];
  if (type == "object") {
    json out = json::object();
    for (const auto& [name, member] : schema.at("properties").items()) out[name] = example_of(member);
    return out;
  }
  if (type == "array") return json::array({example_of(schema.at("items"))});
  if (type == "string") return "bed_1";
  return type == "boolean" ? json(true) : json(1);
}

TEST(StrictSchema, HasRoomForTwiceWhatTheTextNames) {
  const auto most = [](std::size_t objects) {
    return json::parse(strict_scene_schema_for(objects))["properties"]["furniture"]["maxItems"];
  };
  EXPECT_EQ(most(3), 12);
  EXPECT_EQ(most(10), 25);
  EXPECT_EQ(most(80), 100);
  EXPECT_EQ(strict_scene_schema_for(0), strict_scene_schema());
}

TEST(StrictSchema, what_follows_it_is_a_scene) {
  json scene = example_of(json::parse(strict_scene_schema()));
  scene["room"] = json::object();
  scene["constraints"] = json::array({{{"id", "c1"}, {"type", "againstWall"}, {"targets", {"bed_1"}}}});
  const Reading reading = read_document(scene.dump(), Catalog::builtin(), {}, Leniency::kNormal);
  EXPECT_THAT(reading.faults, IsEmpty()) << reading.faults[0].message;
}

TEST(StrictSchema, has_every_relation) {
  const json names = json::parse(strict_scene_schema())["properties"]["constraints"]["items"]["properties"]["type"]["enum"];
  EXPECT_EQ(names.size(), relation_table().size());
}

TEST(StrictSchema, asks_for_no_file_and_no_place_that_holds) {
  for (const char* name : {"\"mesh\"", "\"tex\"", "\"fixed\"", "\"spaces\"", "\"notes\""}) {
    EXPECT_THAT(strict_scene_schema(), testing::Not(HasSubstr(name)));
  }
}

TEST(Prompt, holds_the_table_and_what_matters) {
  SceneGraph read;
  read.objects.resize(1);
  read.objects[0].category = "bed";
  const SystemPrompt prompt = make_system_prompt(Catalog::builtin(), {"A room with a bed.", &read, {4000, 3000, 2500}, nullptr, 0});
  for (const RelationRow& row : relation_table()) EXPECT_THAT(prompt.text, HasSubstr(std::string(row.name) + " ("));
  EXPECT_THAT(prompt.text, HasSubstr("\nbed: "));
  EXPECT_THAT(prompt.text, HasSubstr("4 x 3 x 2.5"));
  EXPECT_LT(prompt.entries_shown, Catalog::builtin().entries().size() / 2);
}

TEST(LooseJson, keeps_what_texts_hold) {
  std::vector<Note> notes;
  const auto read = parse_loose_json(R"(Sure: {'a': "it's // no comment, True", b: [1e3, -2.5,], c: None, /* x */ "d": .5e0e})", notes);
  EXPECT_FALSE(read);  // ".5e0e" is no number in any language
  const auto good = parse_loose_json(R"(Sure: {'a': "it's // no comment, True", b: [1e3, -2.5,], c: None, /* x */ "d": True})", notes);
  ASSERT_TRUE(good) << good.error().message;
  EXPECT_EQ(*good, json::parse(R"({"a": "it's // no comment, True", "b": [1000.0, -2.5], "c": null, "d": true})"));
}

TEST(Draft, patches_apply_to_the_scene_before) {
  const std::string before =
      R"({"room":{},"furniture":[{"id":"bed_1","category":"bed"}],"constraints":[{"id":"c1","type":"againstWall","targets":["bed_1"],"relativeTo":"wall3"}]})";
  chat::Answer answer;
  answer.calls = {{"patch_scene", R"({"patch":[{"op":"replace","path":"/constraints/0/relativeTo","value":"wall4"}]})"}};
  const auto reading = read_draft(answer, Catalog::builtin(), before);
  ASSERT_TRUE(reading && reading->draft);
  EXPECT_THAT(reading->draft->scene.relations[0].references, testing::ElementsAre("wall4"));
  answer.calls = {{"patch_scene", R"({"patch":[{"op":"remove","path":"/furniture/7"}]})"}};
  const auto wrong = read_draft(answer, Catalog::builtin(), before);
  ASSERT_TRUE(wrong);
  EXPECT_FALSE(wrong->draft);
  EXPECT_THAT(wrong->faults[0].message, HasSubstr("do not fit"));
}

TEST(Draft, no_answer_makes_it_throw) {
  const std::string scene =
      R"({"metadata":{"units":3},"room":{"dims":[4,"x",null],"openings":{"a":1}},"furniture":[{"id":{},"category":[],"dims":{"w":[]}},7,null,"bed"],"constraints":[null,{"type":[],"targets":{}},{"type":"on","targets":[1],"relativeTo":[{}]}]})";
  for (std::size_t cut = 0; cut <= scene.size(); ++cut) {
    chat::Answer answer;
    answer.content = scene.substr(0, cut);
    for (const Leniency leniency : {Leniency::kNormal, Leniency::kSalvage}) (void)read_draft(answer, Catalog::builtin(), {}, leniency);
  }
}

}  // namespace
}  // namespace layoutbox::llm
