// What styles, schemes of colours, bans and parts that a text names make of a room.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

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

TEST(DecorStyles, EveryStyleHasWallsThatAreKnown) {
  const auto check = [](const std::string& words, const nlohmann::json& style) {
    for (const char* part : {"wall", "tiled_wall", "floors", "dry_floors"}) {
      if (!style.contains(part) || style.at(part).is_null()) continue;
      const nlohmann::json list = style.at(part).is_array() ? style.at(part) : nlohmann::json{style.at(part)};
      for (const auto& look : list) EXPECT_FALSE(read_wish(look.get<std::string>()).materials.empty()) << words << ": " << look;
    }
    for (const char* part : {"feature", "leather"}) {
      EXPECT_TRUE(!style.contains(part) || read_wish(style.at(part).get<std::string>()).color) << words << ": " << part;
    }
  };
  for (const auto& [words, style] : decor_data().at("styles").items()) {
    check(words, style);
    if (style.contains("plain")) check(words, style.at("plain"));
  }
}

TEST(DecorStyles, EveryPhraseIsOfOneStyle) {
  std::set<std::string> seen;
  for (const auto& [phrases, style] : decor_data().at("styles").items()) {
    std::istringstream words(phrases);
    for (std::string phrase; words >> phrase;) EXPECT_TRUE(seen.insert(phrase).second) << phrase;
  }
  for (const auto& era : decor_data().at("eras").at("of")) EXPECT_TRUE(seen.contains(era.at("style").get<std::string>())) << era;
}

// The walls and the floor of a theme go before what such rooms mostly have.
TEST(DecorStyles, AThemeIsCarriedThroughTheShell) {
  EXPECT_EQ(decor_for("A Roman triclinium with three couches.").wall_finish, "pompeian plaster");
  EXPECT_EQ(decor_for("The captain's cabin of an old wooden galleon.", {}, "ship_cabin").wall_finish, "ship planks");
  EXPECT_EQ(decor_for("The captain’s cabin with a bunk.", {}, "ship_cabin").floor, "ship planks");
  EXPECT_EQ(decor_for("The lighthouse keeper's room.").wall_finish, "whitewashed stone");
  EXPECT_EQ(decor_for("A Chinese dining room.", {}, "dining_room").wall_finish, "red lacquer panels");
  EXPECT_EQ(decor_for("A Japanese bedroom.", {}, "bedroom").floor, "tatami floor");
  EXPECT_EQ(decor_for("A Mexican kitchen.", {}, "kitchen").floor, "terracotta tiles");
  EXPECT_EQ(decor_for("An alchemist's workshop.", {}, "workshop").wall_finish, "sooty stone");
  EXPECT_LT(decor_for("A gaming room with a desk.", {}, "game_room").wall.r, 0.3);
  EXPECT_LT(decor_for("A room for a streamer with RGB lighting.").wall.r, 0.3);
  EXPECT_EQ(decor_for("A space themed bedroom for my son.", {}, "bedroom").wall_finish, "starry wallpaper");
  EXPECT_TRUE(decor_for("A bedroom with space for a desk.", {}, "bedroom").wall_finish.empty());
}

// Wallpaper and parquet are not for a kitchen of the same age.
TEST(DecorStyles, PlainRoomsHaveAStyleInTheirWay) {
  EXPECT_FALSE(decor_for("A Victorian parlour.").wall_finish.empty());
  const Decor kitchen = decor_for("A Victorian kitchen.", {}, "kitchen");
  EXPECT_TRUE(kitchen.wall_finish.empty());
  EXPECT_NE(kitchen.floor.find("tiles"), std::string::npos);
  EXPECT_TRUE(kitchen.parts.contains("fronts"));
  EXPECT_EQ(decor_for("A classroom around 1900.", {}, "classroom").floor.find("tiles"), std::string::npos);
  EXPECT_NE(decor_for("A Moroccan bathroom.", {}, "bathroom").wall_finish, decor_for("A bathroom.", {}, "bathroom").wall_finish);
}

TEST(DecorStyles, WhoseItIsMayNameAStyle) {
  EXPECT_EQ(decor_for("INT. DETECTIVE'S OFFICE - NIGHT, 1947. A desk.", {"desk"}, "office").style, "noir");
  EXPECT_NE(decor_for("A baker's office with a desk.", {"desk"}, "office").style, "noir");
}

// Colors that are told after a floor are its own, and what somebody likes is the room's.
TEST(DecorStyles, ColorsGoToWhatTheyAreSaidOf) {
  EXPECT_TRUE(room_look("A barber shop. Checkerboard floor, black and white, that has to stay.").colors.empty());
  EXPECT_EQ(room_look("A bedroom for my mother. She likes lilac.").colors, std::vector<Color>{color_called("lilac")});
}

TEST(DecorStyles, AYearIsOfAnAge) {
  EXPECT_EQ(decor_for("A parlour from 1890 with a sofa.").style, "victorian");
  EXPECT_EQ(decor_for("A parlour of the 1880's.").style, "victorian");
  EXPECT_EQ(decor_for("A kitchen like in the '50s.", {}, "kitchen").metal, "chrome");
  EXPECT_EQ(decor_for("A kitchen in 1943.", {}, "kitchen").parts.at("handles").material->surface.name, "black_metal");
  EXPECT_EQ(decor_for("A house at the turn of the century.").style, "victorian");
  EXPECT_EQ(decor_for("The early 1930s: a lounge.").style, "traditional");
  EXPECT_TRUE(decor_for("A room with a bed of 1900 mm.").style.empty());
  EXPECT_TRUE(decor_for("A room 1950 wide.").style.empty());
}

TEST(DecorStyles, AnOldStyleIsTraditional) {
  for (const char* text : {"An old style lounge.", "The lounge of an old house.", "An old-fashioned lounge.", "A lounge, nothing modern.",
                           "A lounge without modern things."})
    EXPECT_EQ(decor_for(text).style, "traditional") << text;
  EXPECT_EQ(decor_for("An old style Chinese lounge.").wall_finish, "red lacquer panels");
}

TEST(DecorStyles, ColoursThatAreSaidGoBeforeAThemesOwn) {
  const Decor decor = decor_for("A Mexican lounge. Green and white.");
  EXPECT_EQ(decor.accents.front(), color_called("green"));
  EXPECT_NE(decor.feature, std::optional(color_called("cobalt")));
  EXPECT_EQ(decor_for("A Mexican lounge.").feature, std::optional(color_called("cobalt")));
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
  EXPECT_TRUE(decor_for("A bedroom with a Turkish rug and a Japanese screen.", {"rug", "screen"}).style.empty());
  EXPECT_TRUE(decor_for("A lounge with an armchair from the 1930s.", {"armchair"}).style.empty());
  EXPECT_TRUE(decor_for("A bedroom with a poster of dinosaurs.", {"poster"}).style.empty());
  EXPECT_EQ(decor_for("A bedroom for a boy who loves dinosaurs.", {"bed"}).style, "dinosaur");
  EXPECT_TRUE(decor_for("A bedroom with a gaming desk and a gaming chair.", {"desk", "chair"}).style.empty());
  EXPECT_TRUE(decor_for("A bathroom with a shower cabin and roman blinds.", {}, "bathroom").style.empty());
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
