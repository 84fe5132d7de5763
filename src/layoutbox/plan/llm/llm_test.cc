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

SchemaWanted wanted(bool brief, bool articles, std::size_t objects) {
  SchemaWanted made;
  made.brief = brief, made.articles = articles, made.objects = objects;
  return made;
}

// What every list, text and number of a schema is bounded by.
void expect_bounded(const json& schema, const std::string& place) {
  const json& type = schema.at("type");
  const auto is = [&](const char* name) {
    return type == name || (type.is_array() && std::ranges::any_of(type, [&](const json& one) { return one == name; }));
  };
  EXPECT_TRUE(!is("string") || schema.contains("enum") || schema.contains("pattern")) << place;
  EXPECT_TRUE(!(is("number") || is("integer")) || schema.contains("maximum")) << place;
  if (is("array")) {
    EXPECT_TRUE(schema.contains("maxItems")) << place;
    expect_bounded(schema.at("items"), place + "/items");
  }
  if (!is("object")) return;
  EXPECT_EQ(schema.at("additionalProperties"), false) << place;
  for (const auto& [name, member] : schema.at("properties").items()) expect_bounded(member, place + "/" + name);
}

TEST(StrictSchema, all_is_bounded) {
  for (const bool brief : {false, true}) expect_bounded(json::parse(scene_schema(wanted(brief, true, 3))), brief ? "brief" : "strict");
}

TEST(StrictSchema, a_brief_one_asks_for_less) {
  const json brief = json::parse(scene_schema(wanted(true, false, 3)));
  EXPECT_LT(brief.dump().size() * 2, scene_schema({}).size());
  EXPECT_EQ(brief["required"], json::parse(R"(["room","furniture"])"));
  EXPECT_FALSE(brief["properties"]["furniture"]["items"]["properties"].contains("catalogId"));
  EXPECT_TRUE(json::parse(scene_schema(wanted(true, true, 3)))["properties"]["furniture"]["items"]["properties"].contains("catalogId"));
  EXPECT_LT(answer_tokens(wanted(true, false, 3)), answer_tokens(wanted(false, false, 3)));
}

TEST(StrictSchema, HasRoomForTwiceWhatTheTextNames) {
  const auto most = [](std::size_t objects) {
    return json::parse(scene_schema(wanted(false, false, objects)))["properties"]["furniture"]["maxItems"];
  };
  EXPECT_EQ(most(3), 12);
  EXPECT_EQ(most(10), 25);
  EXPECT_EQ(most(80), 100);
  EXPECT_EQ(most(0), 100);
}

TEST(StrictSchema, what_follows_it_is_a_scene) {
  for (const bool brief : {false, true}) {
    json scene = example_of(json::parse(scene_schema(wanted(brief, true, 0))));
    scene["room"] = json::object();
    scene["constraints"] = json::array({{{"type", "againstWall"}, {"targets", {"bed_1"}}}});
    const Reading reading = read_document(scene.dump(), Catalog::builtin(), {}, Leniency::kNormal);
    EXPECT_THAT(reading.faults, IsEmpty()) << reading.faults[0].message;
  }
}

TEST(StrictSchema, has_every_relation) {
  const json names = json::parse(scene_schema(wanted(false, true, 0)))["properties"]["constraints"]["items"]["properties"]["type"]["enum"];
  EXPECT_EQ(names.size(), relation_table().size());
}

TEST(StrictSchema, asks_for_no_file_and_no_place_that_holds) {
  for (const char* name : {"\"mesh\"", "\"tex\"", "\"fixed\"", "\"spaces\"", "\"notes\""}) {
    EXPECT_THAT(scene_schema(wanted(false, true, 0)), testing::Not(HasSubstr(name)));
  }
}

TEST(Prompt, holds_the_table_and_what_matters) {
  SceneGraph read;
  read.objects.resize(1);
  read.objects[0].category = "bed";
  const SystemPrompt prompt = make_system_prompt(Catalog::builtin(), {"A room with a bed.", &read, {4000, 3000, 2500}, nullptr, 0});
  for (const RelationRow& row : relation_table()) EXPECT_THAT(prompt.text, HasSubstr("\n" + std::string(row.name) + " "));
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

TEST(LooseJson, keeps_what_is_whole_of_a_cut_answer) {
  const std::string text = R"({"room":{"dims":{"w":4}},"furniture":[{"id":"a","dims":{"w":1}},{"id":"b","dims":{"w":2},"xform":{"pos":[1,)";
  const auto whole = parse_cut_json(text);
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_EQ(*whole, json::parse(R"({"room":{"dims":{"w":4}},"furniture":[{"id":"a","dims":{"w":1}}]})"));
  EXPECT_FALSE(parse_cut_json(R"({"furniture":[{"id":"a","dims":{"w":1})"));  // no thing is whole
  EXPECT_FALSE(parse_cut_json(R"({"room":{}})"));                             // nor cut
  for (std::size_t cut = 0; cut < text.size(); ++cut) {
    const auto part = parse_cut_json(text.substr(0, cut));
    EXPECT_TRUE(!part || part->value("furniture", json::array()).size() <= 1) << cut;
  }
}

TEST(Draft, a_cut_answer_counts_where_it_holds_what_is_named) {
  chat::Response answer;
  answer.finish_reason = "length";
  answer.calls = {
      {"create_scene",
       R"({"room":{},"furniture":[{"id":"bed_1","category":"bed"},{"id":"desk_1","category":"desk"}],"constraints":[{"type":"on")"}};
  const auto enough = read_draft(answer, Catalog::builtin(), {{}, 2});
  ASSERT_TRUE(enough && enough->draft);
  EXPECT_EQ(enough->draft->scene.objects.size(), 2u);
  EXPECT_THAT(enough->draft->scene.notes[0].message, HasSubstr("cut off; 2 things"));
  const auto too_few = read_draft(answer, Catalog::builtin(), {{}, 3});
  ASSERT_TRUE(too_few);
  EXPECT_THAT(too_few->faults.at(0).message, HasSubstr("cut off after"));
  const auto salvaged = read_draft(answer, Catalog::builtin(), {{}, 3}, Leniency::kSalvage);
  EXPECT_TRUE(salvaged && salvaged->draft);
}

TEST(Draft, what_is_no_thing_and_no_door_is_left_out) {
  const Reading reading = read_document(
      R"({"room":{"dims":{"d":4,"h":2.5},"openings":[{"id":"bed_1","type":"door"},{"id":"door_1","type":"door"},{"id":"door_1"}]},
          "furniture":[{"id":"bed_1","category":"bed"},{"id":"2","category":"desk_2"},{"id":"3","category":"furniture"},{"id":"4","category":"item_4"}]})",
      Catalog::builtin(), {}, Leniency::kNormal);
  ASSERT_TRUE(reading.draft) << reading.faults.at(0).message;
  const SceneGraph& scene = reading.draft->scene;
  ASSERT_EQ(scene.objects.size(), 2u);
  EXPECT_EQ(scene.objects[1].category, "desk");
  ASSERT_EQ(scene.room.openings.size(), 2u);
  EXPECT_EQ(scene.room.openings[1].id, "door_1_2");
}

TEST(Draft, places_are_read_as_meant_or_left_out) {
  const json scene = {{"room", json::object()},
                      {"furniture", {{{"id", "desk_1"}, {"category", "desk"}}, {{"id", "lamp_1"}, {"category", "table_lamp"}}}},
                      {"constraints",
                       {{{"type", "inRegion"}, {"targets", {"desk_1"}}, {"region", "the back-left corner"}},
                        {{"type", "on"}, {"targets", {"lamp_1"}}, {"relativeTo", "desk_1"}, {"part", "left corner"}},
                        {{"type", "edgeAlign"}, {"targets", {"lamp_1"}}, {"relativeTo", "desk_1"}, {"edge", "zzzzzzzz"}},
                        {{"type", "on"}, {"targets", {"lamp_1", "desk_1"}}, {"relativeTo", "floor"}, {"part", "xyz"}}}}};
  const Reading reading = read_document(scene.dump(), Catalog::builtin(), {}, Leniency::kNormal);
  ASSERT_THAT(reading.faults, IsEmpty()) << reading.faults[0].message;
  ASSERT_TRUE(reading.draft);
  const std::vector<Relation>& relations = reading.draft->scene.relations;
  ASSERT_GE(relations.size(), 4u);
  EXPECT_EQ(relations[0].parameters.region, RoomRegion::kBackLeft);
  EXPECT_TRUE(relations[1].parameters.part.has(PartWord::kCorner));
  EXPECT_FALSE(relations[2].parameters.edge);
  EXPECT_TRUE(relations[3].parameters.part.empty());
}

TEST(Draft, a_room_of_the_size_of_a_desk_is_none) {
  const auto width_of = [](const std::string& dims) {
    const std::string scene = R"({"room":{"dims":)" + dims + R"(},"furniture":[{"id":"bed_1","category":"bed"}]})";
    const Reading reading = read_document(scene, Catalog::builtin(), {}, Leniency::kNormal);
    if (!reading.draft || reading.draft->scene.room.polygon.size() < 3) return Mm{0};
    return reading.draft->scene.room.polygon[2].x;
  };
  EXPECT_EQ(width_of(R"({"w":1.2,"d":0.6,"h":0.75})"), 0);
  EXPECT_EQ(width_of(R"({"w":1.2,"d":2.6,"h":1.2})"), 0);
  EXPECT_EQ(width_of(R"({"w":1.2,"d":2.6,"h":2.4})"), 1200);
  EXPECT_EQ(width_of(R"({"w":1.2,"d":2.6})"), 1200);
}

TEST(Draft, names_hold_nothing_that_turns_or_hides_text) {
  const Reading reading = read_document(
      R"({"room":{},"furniture":[{"id":"bed\u202e_1","category":"bed","name":"a\u202eb\u200bc\u0085d\u2066e\ufefff\u2028g"},{"id":"d","category":"desk","name":"Größe 📐 书桌"}]})",
      Catalog::builtin(), {}, Leniency::kNormal);
  ASSERT_TRUE(reading.draft);
  EXPECT_EQ(reading.draft->scene.objects[0].name, "a b c d e f g");
  EXPECT_EQ(reading.draft->scene.objects[0].id, "bed__1");
  EXPECT_EQ(reading.draft->scene.objects[1].name, "Größe 📐 书桌");
}

TEST(Draft, patches_apply_to_the_scene_before) {
  const std::string before =
      R"({"room":{},"furniture":[{"id":"bed_1","category":"bed"}],"constraints":[{"id":"c1","type":"againstWall","targets":["bed_1"],"relativeTo":"wall3"}]})";
  chat::Response answer;
  answer.calls = {{"patch_scene", R"({"patch":[{"op":"replace","path":"/constraints/0/relativeTo","value":"wall4"}]})"}};
  const auto reading = read_draft(answer, Catalog::builtin(), {before, 0});
  ASSERT_TRUE(reading && reading->draft);
  EXPECT_THAT(reading->draft->scene.relations[0].references, testing::ElementsAre("wall4"));
  answer.calls = {{"patch_scene", R"({"patch":[{"op":"remove","path":"/furniture/7"}]})"}};
  const auto wrong = read_draft(answer, Catalog::builtin(), {before, 0});
  ASSERT_TRUE(wrong);
  EXPECT_FALSE(wrong->draft);
  EXPECT_THAT(wrong->faults[0].message, HasSubstr("do not fit"));
}

TEST(Draft, no_answer_makes_it_throw) {
  const std::string scene =
      R"({"metadata":{"units":3},"room":{"dims":[4,"x",null],"openings":{"a":1}},"furniture":[{"id":{},"category":[],"dims":{"w":[]}},7,null,"bed"],"constraints":[null,{"type":[],"targets":{}},{"type":"on","targets":[1],"relativeTo":[{}]}]})";
  for (std::size_t cut = 0; cut <= scene.size(); ++cut) {
    chat::Response answer;
    answer.content = scene.substr(0, cut);
    for (const Leniency leniency : {Leniency::kNormal, Leniency::kSalvage}) (void)read_draft(answer, Catalog::builtin(), {{}, 1}, leniency);
  }
}

}  // namespace
}  // namespace layoutbox::llm
