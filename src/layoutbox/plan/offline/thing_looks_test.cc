// What things look like by what is said before and behind them.
#include <gtest/gtest.h>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/plan/planner.h"

namespace layoutbox {
namespace {

struct LookCase {
  std::string text, thing;
  std::vector<std::string> look;
};

std::vector<std::string> look_of(const std::string& text, const std::string& thing) {
  static const auto planner = make_offline_planner(Catalog::builtin());
  const Result<Plan> plan = planner->plan(text, {});
  if (!plan) return {"not read"};
  for (const SceneObject& object : plan->scene.objects) {
    if (object.name == thing) return object.attributes;
  }
  return {"not there"};
}

TEST(ThingLooks, AreSaidBehindThem) {
  for (const LookCase& c : std::vector<LookCase>{
           {"A sofa in navy blue and a rug in ochre.", "sofa", {"navy blue"}},
           {"A sofa in navy blue and a rug in ochre.", "rug", {"ochre"}},
           {"An armchair in mustard velvet by the window.", "armchair", {"mustard", "velvet"}},
           {"A chair covered in red leather.", "chair", {"red", "leather"}},
           {"A cabinet painted duck-egg blue.", "cabinet", {"duck-egg blue"}},
           {"A rug in black and white under the table.", "rug", {"black", "white"}},
           {"A table in dark walnut with four chairs.", "table", {"dark walnut"}},
           {"A lamp in a deep green.", "lamp", {"deep green"}},
           {"A sofa in teal velvet, walnut TV unit and a lamp.", "sofa", {"teal", "velvet"}},
           {"A mirror framed in gold.", "mirror", {"gold"}},
           {"A vase in a glass cabinet.", "vase", {}},
       })
    EXPECT_EQ(look_of(c.text, c.thing), c.look) << c.text;
}

TEST(ThingLooks, AreThoseOfThePartsThatShow) {
  for (const LookCase& c : std::vector<LookCase>{
           {"A chair with a red seat and chrome legs.", "chair", {"red"}},
           {"A bed with a blue headboard.", "bed", {"blue"}},
           {"A bed with a headboard in navy velvet.", "bed", {"navy", "velvet"}},
           {"A white desk with a black top.", "desk", {"white"}},
           {"A table with black legs.", "table", {}},
       })
    EXPECT_EQ(look_of(c.text, c.thing), c.look) << c.text;
}

// Two words of which the first is a thing elsewhere are one color; and what a color has its name from is there where nothing has the color.
TEST(ThingLooks, ColorsThatAreCalledAfterThings) {
  EXPECT_EQ(look_of("A pistachio green sofa.", "sofa"), std::vector<std::string>{"pistachio green"});
  EXPECT_EQ(look_of("A mushroom armchair.", "armchair"), std::vector<std::string>{"mushroom"});
  EXPECT_EQ(look_of("A thistle in a vase on the table.", "thistle"), std::vector<std::string>{});
  EXPECT_EQ(look_of("Two chairs, one red and one blue.", "blue"), std::vector<std::string>{"not there"});
}

}  // namespace
}  // namespace layoutbox
