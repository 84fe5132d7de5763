// What styles, schemes of colours, bans and parts that a text names make of a room.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "layoutbox/furnish/decor.h"
#include "layoutbox/furnish/decor_colors.h"
#include "layoutbox/furnish/decor_data.h"
#include "layoutbox/furnish/decor_style.h"
#include "layoutbox/furnish/palette.h"
#include "layoutbox/furnish/room_look.h"

namespace layoutbox {
namespace {

Layout a_room(std::string type, std::string prompt, const std::vector<std::string>& things = {}) {
  Layout layout;
  layout.room.type = std::move(type);
  layout.prompt = std::move(prompt);
  for (const std::string& name : things) {
    PlacedObject object;
    object.name = name;
    object.size = {1000, 1000, 500};
    layout.objects.push_back(object);
  }
  return layout;
}

Decor decor_for(const std::string& prompt, const std::vector<std::string>& things = {}, const std::string& type = "living_room") {
  return decor_of(a_room(type, prompt, things), 1);
}

Color color_called(std::string_view words) { return *read_wish(words).color; }

TEST(DecorStyles, EveryStyleNamesKnownWoodsColoursAndFloors) {
  for (const auto& [words, style] : decor_data().at("styles").items()) {
    for (const auto& wood : style.at("woods")) EXPECT_EQ(named_surface(wood.get<std::string>()).kind, "wood") << words;
    EXPECT_EQ(named_surface(style.value("metal", "steel")).kind, "metal") << words;
    if (style.contains("floors")) {
      for (const auto& floor : style.at("floors")) EXPECT_FALSE(read_wish(floor.get<std::string>()).materials.empty()) << floor;
    }
    if (style.at("palette").is_number()) continue;
    for (const auto& color : style.at("palette")) EXPECT_TRUE(read_wish(color.get<std::string>()).color) << color;
  }
}

TEST(DecorStyles, StylesOfSeveralWordsAreKnown) {
  EXPECT_EQ(decor_for("An Art Deco living room with a sofa.").rug, "diamonds");
  EXPECT_EQ(decor_for("A log cabin living room.").wall_finish, "log walls");
  EXPECT_EQ(decor_for("A wabi-sabi living room.").metal, "bronze");
  EXPECT_EQ(decor_for("A modern farmhouse kitchen.", {}, "kitchen").parts.at("worktops").material->surface.name, "oak");
  EXPECT_EQ(decor_for("A mid-century modern lounge.").style, "mid-century");
  EXPECT_EQ(decor_for("A Moroccan living room.").floor, "cement tiles");
  EXPECT_EQ(decor_for("A 1950s kitchen.", {}, "kitchen").metal, "chrome");
}

TEST(DecorStyles, ShabbyChicIsNotWorn) {
  EXPECT_EQ(decor_for("A shabby chic bedroom with a bed.").wear, 0);
  EXPECT_GT(decor_for("A shabby bedroom with a bed.").wear, 0);
}

TEST(DecorStyles, WhatIsNotWantedIsNoStyle) {
  EXPECT_EQ(decor_for("A dining room, but please nothing grey and nothing modern.").style, "traditional");
  EXPECT_EQ(decor_for("A living room, not industrial, please.").style, "traditional");
  EXPECT_EQ(decor_for("A rustic living room, nothing modern.").style, "rustic");
  EXPECT_TRUE(decor_for("A lounge for a couple in their 60s.").style.empty());
}

TEST(DecorStyles, TheStyleOfOneThingIsNotTheRooms) {
  EXPECT_TRUE(decor_for("A living room with a Moroccan brass lantern and a sofa.", {"lantern", "sofa"}).style.empty());
  EXPECT_EQ(decor_for("A Moroccan living room with a lantern.", {"lantern"}).style, "traditional");
  EXPECT_EQ(decor_for("A room with an industrial table and industrial chairs.", {"table", "chair"}).style, "industrial");
}

TEST(DecorStyles, SchemesOfColoursAreSaidAnywhere) {
  using Colors = std::vector<Color>;
  EXPECT_EQ(room_look("A nursery with a crib. Sage green and cream, blackout curtains.").colors,
            (Colors{color_called("sage green"), color_called("cream")}));
  EXPECT_EQ(room_look("Two beds and a wardrobe for both. Yellow and white, nothing too babyish.").colors,
            (Colors{color_called("yellow"), color_called("white")}));
  const RoomLook clinic = room_look("A waiting room with eight chairs. Bright and calm, light wood and mint.");
  EXPECT_EQ(clinic.colors, Colors{color_called("mint")});
  EXPECT_EQ(clinic.woods, std::vector<std::string>{"birch"});
  EXPECT_EQ(room_look("My daughter wants a lavender and white bedroom with a bed.").colors,
            (Colors{color_called("lavender"), color_called("white")}));
  EXPECT_EQ(room_look("A laundry room. White and pale blue colour scheme, brick on one wall.").colors,
            (Colors{color_called("white"), color_called("pale blue")}));
  EXPECT_EQ(room_look("A lounge with a palette of terracotta, sand and cream.").colors.size(), 3U);
  EXPECT_EQ(room_look("A study with a desk, decorated in navy and brass.").metal, "brass");
  EXPECT_EQ(room_look("A bedroom with a bed. Only warm colours please.").colors.size(), 5U);
  EXPECT_TRUE(room_look("A bedroom with a bed, no bright colours.").colors.empty());
  EXPECT_TRUE(room_look("A living room with a red sofa, a blue rug and a white table.").colors.empty());
}

TEST(DecorStyles, BansReachAllShadesOfAColour) {
  const std::vector<Color> grey{color_called("grey")}, black{color_called("black")}, blue{color_called("blue")};
  EXPECT_TRUE(is_banned(named_surface("steel").surface.base, grey));
  EXPECT_TRUE(is_banned(color_called("charcoal"), grey));
  EXPECT_FALSE(is_banned(color_called("cream"), grey));
  EXPECT_TRUE(is_banned(named_surface("black_metal").surface.base, black));
  EXPECT_FALSE(is_banned(color_called("grey"), black));
  EXPECT_TRUE(is_banned(color_called("sky blue"), blue));
  EXPECT_FALSE(is_banned(color_called("terracotta"), blue));
  const Decor decor = decor_for("A living room with a sofa, no black please.");
  EXPECT_EQ(decor.others.at("black_metal"), "brass");
  for (const Color& color : decor.accents) EXPECT_FALSE(is_banned(color, decor.unwanted));
}

TEST(DecorStyles, AccessoriesThatAreNotWantedAreNoAccents) {
  EXPECT_FALSE(decor_for("A dining room. I don't want any black accessories.").parts.contains("accents"));
}

TEST(DecorStyles, APartHasTheLookThatIsSaidOfIt) {
  const Layout layout = a_room("living_room", "A sofa, a marble top coffee table with brass legs, a sideboard with cane doors.",
                               {"sofa", "coffee table", "sideboard"});
  const ThingParts parts = thing_parts(layout);
  EXPECT_EQ(parts.at("coffee table").at("top").material->surface.name, "marble");
  EXPECT_EQ(parts.at("coffee table").at("legs").material->surface.name, "brass");
  EXPECT_EQ(parts.at("sideboard").at("doors").material->surface.name, "rattan");
  EXPECT_FALSE(parts.contains("sofa"));
  const PartLook head = thing_parts(a_room("bedroom", "Art Deco bedroom, velvet headboard in emerald.", {"bed"})).at("bed").at("headboard");
  EXPECT_EQ(head.material->surface.name, "velvet");
  EXPECT_EQ(head.colors, std::vector<Color>{color_called("emerald")});
}

TEST(DecorStyles, FittingsAreOfTheMetalThatIsSaid) {
  const Decor decor = decor_for("A bathroom with black fixtures and a bathtub.", {"bathtub"}, "bathroom");
  EXPECT_EQ(decor.others.at("chrome"), "black_metal");
  EXPECT_EQ(decor_for("A bathroom with brass taps.", {}, "bathroom").others.at("chrome"), "brass");
}

TEST(DecorStyles, TheAccentsGoWithTheLargestColouredThing) {
  Layout layout = a_room("living_room", "A living room with a navy sofa.", {"sofa"});
  layout.objects.front().attributes = {"navy"};
  EXPECT_EQ(decor_of(layout, 1).accents.front(), color_called("navy"));
}

TEST(DecorStyles, SnowIsSeenBehindTheWindows) {
  EXPECT_EQ(decor_for("A cabin with snow outside the two windows.").view, "snow");
  EXPECT_TRUE(decor_for("A cabin with two windows.").view.empty());
}

}  // namespace
}  // namespace layoutbox
