// Sentences that change a room, and the steps they mean: edit_sentences_test.txt.
#include "layoutbox/plan/edit.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

namespace layoutbox {
namespace {

using testing::HasSubstr;

PlacedObject placed(const char* id, const char* category, const char* name, Size size, double x, double y, double z, double rotation,
                    const char* support, std::vector<std::string> attributes = {}) {
  PlacedObject object;
  object.id = id, object.category = category, object.name = name, object.size = size;
  object.position = {x, y, z};
  object.rotation_deg = rotation;
  object.supported_by = support;
  object.attributes = std::move(attributes);
  if (object.supported_by.starts_with("wall")) object.mount = Mount::kWall;
  if (z > 0 && object.mount == Mount::kFloor) object.mount = Mount::kSurface;
  return object;
}

// A bed-sitting room: what the sentences speak of.
Layout room() {
  Layout layout;
  layout.room.type = "bedroom";
  layout.room.polygon = {{0, 0}, {6000, 0}, {6000, 5000}, {0, 5000}};
  layout.room.height = 2700;
  layout.room.walls = {{"wall1", {0, 0}, {6000, 0}, 100, {}, {}},
                       {"wall2", {6000, 0}, {6000, 5000}, 100, {}, {}},
                       {"wall3", {6000, 5000}, {0, 5000}, 100, {}, {}},
                       {"wall4", {0, 5000}, {0, 0}, 100, {}, {}}};
  Opening door{"door1", OpeningType::kDoor, "wall1", 500};
  Opening window{"window1", OpeningType::kWindow, "wall3", 4000, 1200, 1200, 900};
  layout.room.openings = {door, window};
  layout.objects = {
      placed("bed_1", "bed", "bed", {1600, 2000, 500}, 3000, 4000, 0, 0, "floor", {"blue"}),
      placed("nightstand_1", "nightstand", "nightstand", {450, 400, 500}, 1900, 4780, 0, 0, "floor"),
      placed("nightstand_2", "nightstand", "nightstand", {450, 400, 500}, 4100, 4780, 0, 0, "floor"),
      placed("table_lamp_1", "table_lamp", "table lamp", {250, 250, 450}, 1900, 4780, 500, 0, "nightstand_1"),
      placed("table_lamp_2", "table_lamp", "table lamp", {250, 250, 450}, 4100, 4780, 500, 0, "nightstand_2"),
      placed("desk_1", "desk", "desk", {1400, 700, 750}, 350, 2000, 0, 90, "floor"),
      placed("desk_chair_1", "desk_chair", "office chair", {600, 600, 1000}, 1100, 2000, 0, 270, "floor"),
      placed("wardrobe_1", "wardrobe", "wardrobe", {1500, 600, 2000}, 5700, 4000, 0, 270, "floor"),
      placed("rug_1", "rug", "rug", {2000, 1400, 10}, 3000, 2300, 0, 0, "floor"),
      placed("armchair_1", "armchair", "armchair", {800, 850, 900}, 5300, 600, 0, 200, "floor", {"red"}),
      placed("coffee_table_1", "coffee_table", "coffee table", {900, 500, 420}, 4300, 1200, 0, 0, "floor"),
      placed("dining_table_1", "dining_table", "dining table", {1600, 900, 750}, 2400, 900, 0, 0, "floor"),
      placed("dining_chair_1", "dining_chair", "chair", {450, 500, 900}, 2000, 300, 0, 180, "floor"),
      placed("dining_chair_2", "dining_chair", "chair", {450, 500, 900}, 2800, 300, 0, 180, "floor"),
      placed("dining_chair_3", "dining_chair", "chair", {450, 500, 900}, 2000, 1500, 0, 0, "floor"),
      placed("dining_chair_4", "dining_chair", "chair", {450, 500, 900}, 2800, 1500, 0, 0, "floor"),
      placed("potted_plant_1", "potted_plant", "plant", {400, 400, 1000}, 300, 4700, 0, 0, "floor"),
      placed("picture_1", "picture", "picture", {600, 30, 400}, 15, 3000, 1500, 90, "wall4"),
  };
  return layout;
}

std::string joined(const std::vector<std::string>& all) {
  std::string text;
  for (const std::string& one : all) text += (text.empty() ? "" : "+") + one;
  return text;
}

std::string side_text(const EditResize::Side& side) {
  if (side.exact) return "=" + std::to_string(*side.exact);
  if (side.more != 0) return (side.more > 0 ? "+" : "") + std::to_string(side.more);
  if (side.factor == 1) return "-";
  std::ostringstream text;
  text << "x" << side.factor;
  return text.str();
}

std::string text_of(const EditOpeningPlace& place) {
  std::string text = " at " + (place.wall.empty() ? "any" : place.wall);
  if (place.near) text += " " + std::to_string(std::lround((*place.near)[0])) + " " + std::to_string(std::lround((*place.near)[1]));
  return text;
}

// " new vase_1,blue new window2 1200x1000".
std::string new_things(const EditStep& step) {
  std::string text;
  for (const SceneObject& object : step.objects) {
    text += " new " + object.id;
    for (const std::string& attribute : object.attributes) text += "," + attribute;
  }
  for (const Opening& opening : step.openings) {
    text += " new " + opening.id + " " + std::to_string(opening.width) + "x" + std::to_string(opening.height);
  }
  return text;
}

// " : underWindow desk_1 window1".
std::string text_of(const std::vector<Relation>& relations) {
  std::string text;
  for (const Relation& relation : relations) {
    if (relation.origin == Origin::kAssumed) continue;
    text += " : " + std::string(relation_row(relation.type).name) + " " + joined(relation.targets);
    if (!relation.references.empty()) text += " " + joined(relation.references);
  }
  return text;
}

// " left 500 desk_1".
std::string shift_text(const EditStep& step) {
  static constexpr const char* kWays[] = {"left", "right", "front", "back", "up", "down", "towards", "away"};
  if (!step.shift) return {};
  std::string text = std::string(" ") + kWays[static_cast<int>(step.shift->way)];
  if (step.shift->distance) text += " " + std::to_string(*step.shift->distance);
  if (!step.shift->reference.empty()) text += " " + step.shift->reference;
  return text;
}

std::string resize_text(const EditStep& step) {
  std::string text;
  if (step.kind != EditKind::kResize) return text;
  for (const auto& side : step.resize.sides) text += " " + side_text(side);
  return text + (step.resize.longer_side ? " longer" : "");
}

// "move desk_1: underWindow desk_1 window1", a step a part, with " | " between.
std::string text_of(const EditPlan& plan) {
  std::string text;
  for (const EditStep& step : plan.steps) {
    text += (text.empty() ? "" : " | ") + std::string(name_of(step.kind));
    if (!step.targets.empty()) text += " " + joined(step.targets);
    text += new_things(step);
    if (step.opening_place) text += text_of(*step.opening_place);
    text += text_of(step.relations) + shift_text(step);
    if (step.degrees != 0) text += " " + std::to_string(static_cast<int>(step.degrees));
    text += resize_text(step);
    for (const std::string& attribute : step.attributes) text += " " + attribute;
    if (!step.name.empty()) text += " \"" + step.name + "\"";
  }
  return text;
}

// "sentence => steps", or "sentence => ! words of the error".
TEST(EditSentences, MeanTheirSteps) {
  std::ifstream file(LAYOUTBOX_SOURCE_FOLDER "/src/layoutbox/plan/edit/edit_sentences_test.txt");
  ASSERT_TRUE(file);
  const Layout layout = room();
  std::string line;
  int sentences = 0;
  const bool show = std::getenv("LAYOUTBOX_SHOW") != nullptr;
  while (std::getline(file, line)) {
    const std::size_t arrow = line.find(" => ");
    if (line.starts_with("#") || arrow == std::string::npos) continue;
    ++sentences;
    const std::string sentence = line.substr(0, arrow), expected = line.substr(arrow + 4);
    const auto plan = plan_edit(sentence, layout, Catalog::builtin());
    const std::string got = plan ? text_of(*plan) : "! " + plan.error().message;
    if (show) {
      std::cout << sentence << " => " << got << "\n";
      continue;
    }
    if (expected.starts_with("! ")) {
      EXPECT_FALSE(plan) << sentence << "\n  " << got;
      EXPECT_THAT(got, HasSubstr(expected.substr(2))) << sentence;
    } else {
      EXPECT_EQ(got, expected) << sentence;
    }
  }
  EXPECT_GE(sentences, 60);
}

TEST(EditSentences, ErrorsSayWhichKindTheyAre) {
  const Layout layout = room();
  const auto code = [&](const char* text) { return plan_edit(text, layout, Catalog::builtin()).error().code; };
  EXPECT_EQ(code("  "), ErrorCode::kEmpty);
  EXPECT_EQ(code("Sing a song."), ErrorCode::kParse);
  EXPECT_EQ(code("Remove the piano."), ErrorCode::kReference);
  EXPECT_EQ(code(std::string(200'000, 'a').c_str()), ErrorCode::kTooLarge);
}

// "It", before anything is named, is what the edit before spoke of; where there was none, of a size: the room's.
TEST(EditSentences, GoOnFromTheEditBefore) {
  const auto read = [](const char* prompt, const char* text) {
    Layout layout = room();
    layout.prompt = prompt;
    const auto plan = plan_edit(text, layout, Catalog::builtin());
    return plan ? text_of(*plan) : "! " + plan.error().message;
  };
  EXPECT_EQ(read("A room.\nmove the desk under the window", "make it bigger"), "resize desk_1 x1.25 x1.25 x1.25");
  EXPECT_EQ(read("A room.\nAdd an armchair.", "Turn it around."), "turn armchair_1 180");
  EXPECT_EQ(read("A room.\npaint the nightstands red", "make them blue"), "recolor nightstand_1+nightstand_2 blue");
  EXPECT_EQ(read("A room.\nmake the dining table longer", "make it round"), "recolor dining_table_1 round");
  EXPECT_EQ(read("A room.\nmake the room wider", "Make it deeper."), "resize room - x1.25 -");
  EXPECT_EQ(read("A room with a bed.", "make it bigger"), "resize room x1.25 x1.25 x1.25");
  EXPECT_THAT(read("A room with a bed.", "make it round"), HasSubstr("! what \"it\" means"));
  EXPECT_THAT(read("A room.\nremove the piano", "make it bigger"), HasSubstr("! what \"it\" means"));
  EXPECT_THAT(read("A room.\nmove the chair", "make it bigger"), HasSubstr("! what \"it\" means")) << "there are four";
}

// Chairs for which a description would find a table stay where they are while something else is moved.
TEST(EditSentences, AskNothingOfWhatIsNotSpokenOf) {
  Layout layout = room();
  const auto gone = [](const PlacedObject& object) {
    return object.id == "desk_1" || object.id == "desk_chair_1" || object.id == "coffee_table_1";
  };
  std::erase_if(layout.objects, gone);
  for (const char* text :
       {"Turn the armchair towards the window.", "Move the bed to the left wall.", "Put the plant next to the wardrobe."}) {
    const auto plan = plan_edit(text, layout, Catalog::builtin());
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(plan->steps.size(), 1u) << text << "\n  " << text_of(*plan);
  }
}

TEST(EditSentences, NewThingsGetIdsOfTheirOwn) {
  const auto plan = plan_edit("Add two chairs and another bed.", room(), Catalog::builtin());
  ASSERT_TRUE(plan) << plan.error().message;
  std::vector<std::string> ids;
  for (const EditStep& step : plan->steps) {
    for (const SceneObject& object : step.objects) ids.push_back(object.id);
  }
  EXPECT_THAT(ids, testing::UnorderedElementsAre("chair_1", "chair_2", "bed_2"));
}

}  // namespace
}  // namespace layoutbox
