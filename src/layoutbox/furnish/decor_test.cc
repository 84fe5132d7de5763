#include "layoutbox/furnish/decor.h"
#include "layoutbox/furnish/room_look.h"

#include <gmock/gmock.h>

#include "layoutbox/furnish/palette.h"

namespace layoutbox {
namespace {

Layout room(std::string type, std::string prompt) {
  Layout layout;
  layout.room.type = std::move(type);
  layout.prompt = std::move(prompt);
  return layout;
}

TEST(Decor, TheSameRoomAlwaysLooksTheSame) {
  const Decor a = decor_of(room("bedroom", "a bedroom"), 1), b = decor_of(room("bedroom", "a bedroom"), 1);
  EXPECT_EQ(a.floor, b.floor);
  EXPECT_EQ(a.woods, b.woods);
  EXPECT_EQ(a.wall, b.wall);
}

TEST(Decor, WhatAnEditAddsLeavesTheRoomsColours) {
  for (const std::string text : {"a bedroom", "a living room with a sofa", "an office for two"}) {
    const Decor a = decor_of(room("bedroom", text), 1), b = decor_of(room("bedroom", text + "\nremove the rug and add a lamp"), 1);
    EXPECT_EQ(a.floor, b.floor);
    EXPECT_EQ(a.woods, b.woods);
    EXPECT_EQ(a.wall, b.wall);
    EXPECT_EQ(decor_of(room("bedroom", text + "\nmake it a rustic bedroom"), 1).woods.front(), "reclaimed_wood");
  }
}

TEST(Decor, RoomsOfAKindDiffer) {
  std::vector<std::string> floors;
  for (int i = 0; i < 20; ++i) floors.push_back(decor_of(room("living_room", "room " + std::to_string(i)), 1).floor);
  std::sort(floors.begin(), floors.end());
  EXPECT_GE(std::unique(floors.begin(), floors.end()) - floors.begin(), 3);
}

TEST(Decor, FurnitureDoesNotVanishOnTheFloor) {
  for (int i = 0; i < 40; ++i) {
    const Decor decor = decor_of(room("bedroom", "room " + std::to_string(i)), 1);
    const std::string floor = read_wish(decor.floor).materials.front()->surface.name;
    ASSERT_FALSE(decor.woods.empty());
    EXPECT_NE(floor, decor.woods.front() + "_planks") << i;
  }
}

TEST(Decor, WetRoomsAreTiledAndWorkshopsHaveConcrete) {
  EXPECT_FALSE(decor_of(room("bathroom", "x"), 1).wall_finish.empty());
  EXPECT_TRUE(decor_of(room("bedroom", "x"), 1).wall_finish.empty());
  EXPECT_EQ(decor_of(room("workshop", "x"), 1).floor, "concrete");
}

TEST(Decor, WhatIsSaidOfTheWholeRoomDarkensAndWearsIt) {
  EXPECT_EQ(decor_of(room("bedroom", "A bedroom with a dark wardrobe."), 1).daylight, 1);
  EXPECT_EQ(decor_of(room("bedroom", "A bedroom with a dark wardrobe."), 1).wear, 0);
  EXPECT_LT(decor_of(room("bedroom", "A moody bedroom."), 1).daylight, 0.8);
  const Decor ward = decor_of(room("hospital_room", "An abandoned hospital ward with six beds."), 1);
  EXPECT_LT(ward.daylight, 0.9);
  EXPECT_GT(ward.wear, 0.3);
  EXPECT_EQ(decor_of(room("airport_terminal", "An airport gate lounge: three rows of seats and some abandoned luggage."), 1).wear, 0);
}

TEST(Decor, CellarsAndSpaceshipsHaveDoorsAndWindowsOfTheirOwn) {
  const Decor usual = decor_of(room("study", "A study."), 1), castle = decor_of(room("study", "A study in a castle."), 1);
  EXPECT_TRUE(usual.skirting);
  EXPECT_TRUE(usual.door.empty());
  EXPECT_FALSE(castle.skirting);
  EXPECT_NE(castle.door.find("plank"), std::string::npos);
  EXPECT_NE(decor_of(room("bedroom", "A spaceship with a bed."), 1).window.find("porthole"), std::string::npos);
}

TEST(Decor, PicturesSuitTheRoom) {
  EXPECT_EQ(decor_of(room("nursery", "x"), 1).pictures, "child");
  EXPECT_EQ(decor_of(room("bedroom", "A bedroom for my daughter."), 1).pictures, "child");
  EXPECT_EQ(decor_of(room("kids_room", "A room for my teenager."), 1).pictures, "");
  EXPECT_EQ(decor_of(room("clinic", "x"), 1).pictures, "chart");
  EXPECT_EQ(decor_of(room("bedroom", "x"), 1).pictures, "");
}

// A clause that names nothing but colours is about the whole room; colours of things are theirs alone.
TEST(Decor, ColoursSaidOfTheRoomAreItsCloths) {
  const auto accents = [](const std::string& prompt) { return decor_of(room("bedroom", prompt), 1).accents; };
  const Color pink = *read_wish("pink").color, pale = *read_wish("light blue").color;
  EXPECT_EQ(accents("A girl's bedroom with a bed and a desk. Pink and white").front(), pink);
  EXPECT_EQ(accents("A nursery with a crib. Colours: light blue and white.").front(), pale);
  EXPECT_EQ(accents("A bedroom with a pink bed. There is a rug."), accents("A bedroom with a pink bed. There is a rug."));
  EXPECT_GT(accents("A bedroom with a pink bed and a white desk.").size(), 2U);
}

// "Teal and white": furniture is white, and one wall is teal.
TEST(Decor, ANeutralColorSaidOfTheRoomIsWhatItsFurnitureIsPainted) {
  const Color teal = *read_wish("teal").color, white = *read_wish("white").color, black = *read_wish("black").color;
  const Decor clinic = decor_of(room("waiting_room", "A waiting room with eight chairs. Teal and white."), 1);
  EXPECT_EQ(clinic.paint, white);
  EXPECT_EQ(clinic.feature, teal);
  EXPECT_EQ(clinic.accents.front(), teal);
  EXPECT_EQ(decor_of(room("dining_room", "A black and gold dining room with a table."), 1).paint, black);
  EXPECT_EQ(decor_of(room("bedroom", "A bedroom with a bed. Pastel pink and white."), 1).paint, white);
  EXPECT_FALSE(decor_of(room("bedroom", "A bedroom with a bed. White and oak."), 1).paint.has_value());
  EXPECT_FALSE(decor_of(room("bedroom", "A bedroom with a bed. Sage green and mustard."), 1).paint.has_value());
}

TEST(Decor, ShelvesHoldWhatTheirRoomOrTheirNameSays) {
  EXPECT_EQ(decor_of(room("bedroom", "x"), 1).shelves, "");
  EXPECT_EQ(decor_of(room("kitchen", "x"), 1).shelves, "goods");
  EXPECT_EQ(decor_of(room("garage", "x"), 1).shelves, "boxes");
  EXPECT_EQ(shelf_contents_named("wine shelf"), "bottles");
  EXPECT_EQ(shelf_contents_named("shelf for towels"), "towels");
  EXPECT_EQ(shelf_contents_named("oak shelf"), "");
}

TEST(Decor, StyleWordsOfThePromptRule) {
  const Decor rustic = decor_of(room("dining_room", "A rustic dining room"), 1);
  EXPECT_EQ(rustic.woods.front(), "reclaimed_wood");
  EXPECT_EQ(decor_of(room("office", "An Industrial loft office"), 1).metal, "black_metal");
  EXPECT_EQ(decor_of_thing(decor_of(room("office", "an office"), 1), "scandinavian desk").woods.front(), "birch");
}

TEST(Decor, ADarkRoomHasDarkWalls) {
  EXPECT_LT(decor_of(room("bedroom", "A gamer's bedroom. Make it dark, with LED lights."), 1).wall.r, 0.3);
  EXPECT_GT(decor_of(room("bedroom", "A bedroom with a dark wardrobe."), 1).wall.r, 0.5);
}

TEST(Decor, EveryNamedMaterialAndFloorIsKnown) {
  for (const char* kind : {"", "bedroom", "kitchen", "bathroom", "office", "kids_room", "gym", "library", "clinic", "cafe", "shop",
                           "garage", "hallway", "sunroom", "game_room", "church", "yoga_studio"}) {
    for (int i = 0; i < 20; ++i) {
      const Decor decor = decor_of(room(kind, "x" + std::to_string(i)), 1);
      EXPECT_FALSE(read_wish(decor.floor).materials.empty()) << decor.floor;
      for (const std::string& wood : decor.woods) EXPECT_EQ(named_surface(wood).surface.name, wood);
      EXPECT_GE(decor.accents.size(), 3U);
    }
  }
}

Color named(std::string_view words) { return *read_wish(words).color; }

// Parts that are no things of their own look as the text says.
TEST(Decor, PartsAreOfTheirOwnColoursAndMaterials) {
  const PartLooks parts = part_looks("A kitchen with sage green shaker cabinets, brass handles and butcher block counters.");
  EXPECT_EQ(parts.at("fronts").colors, std::vector<Color>{named("sage green")});
  EXPECT_EQ(parts.at("handles").material->surface.name, "brass");
  EXPECT_EQ(parts.at("worktops").material->surface.name, "oak");
  EXPECT_EQ(part_looks("Worktops of marble, fronts: navy.").at("worktops").material->surface.name, "marble");
  EXPECT_EQ(part_looks("navy and mustard bedding").at("bedding").colors, (std::vector<Color>{named("navy"), named("mustard")}));
  EXPECT_EQ(part_looks("a dark green kitchen with an island").at("fronts").colors, std::vector<Color>{named("dark green")});
  EXPECT_TRUE(part_looks("a kitchen with cabinets, a white fridge and a table").empty());
  EXPECT_EQ(decor_of(room("bedroom", "a bedroom with green and gold touches"), 1).accents,
            (std::vector<Color>{named("green"), named("gold")}));
}

TEST(Decor, TheColourOfAKitchenIsThatOfItsFronts) {
  EXPECT_EQ(decor_of(room("kitchen", "an l-shaped kitchen, colour dark green"), 1).parts.at("fronts").colors.front(), named("dark green"));
  EXPECT_TRUE(decor_of(room("bedroom", "a bedroom, colours pink and white"), 1).parts.empty());
}

TEST(Decor, NamesOfThingsAreNoStyles) {
  EXPECT_TRUE(decor_of(room("bedroom", "a bedroom with a loft bed"), 1).style.empty());
  EXPECT_EQ(decor_of(room("bedroom", "a loft bedroom with a bed"), 1).style, "industrial");
}

TEST(Decor, ShelvesHoldWhatTheTextSays) {
  const auto said = [](const std::string& prompt) { return decor_of(room("bedroom", prompt), 1).shelves_said; };
  EXPECT_EQ(said("a shelf for my sneakers and a bookcase").at("shelf"), "shoes");
  EXPECT_EQ(said("shelves stacked with glass jars").at("shelf"), "jars");
  EXPECT_EQ(said("a shelf for his trophies above the desk").at("shelf"), "trophies");
  EXPECT_TRUE(said("a shelf above the toy box").empty());
}

}  // namespace
TEST(Decor, ColorsOfTheWholeRoomAreSaidInThePluralOrBeforeItsName) {
  const auto said = [](const char* text) {
    return decor_of(room("bedroom", text), 1).colors_said ? decor_of(room("bedroom", text), 1).accents : std::vector<Color>{};
  };
  EXPECT_EQ(said("A calm bedroom in soft greens with a bed and a rug.").front(), named("soft green"));
  EXPECT_EQ(said("A blue and white bedroom with a bed.").front(), named("blue"));
  EXPECT_EQ(said("A bedroom with a bed. Warm earth tones.").size(), 5U);
  EXPECT_TRUE(said("A bedroom with a blue rug and a white bed.").empty());
  EXPECT_TRUE(said("A kitchen with a bowl of greens.").empty());
}

TEST(Decor, LooksOfTheWholeRoomAreSaidOfAllOfIt) {
  const auto look = [](const char* text) { return room_look(text); };
  const std::vector<Color> pink_gold{named("pink"), named("gold")};
  EXPECT_EQ(look("A girl's bedroom in pink and gold with a bed, desk and chair.").colors, pink_gold);
  EXPECT_EQ(look("A study all in dark blue and oak: desk, chair, bookcase.").colors, std::vector<Color>{named("dark blue")});
  EXPECT_EQ(look("A study all in dark blue and oak: desk, chair, bookcase.").woods, std::vector<std::string>{"oak"});
  EXPECT_EQ(look("A bedroom with pale wood throughout, a bed and two nightstands.").woods, std::vector<std::string>{"birch"});
  EXPECT_EQ(look("Everything in the study is mahogany with green leather: desk, chair.").woods.size(), 1U);
  EXPECT_EQ(look("A goth bedroom, black everything with red accents, bed and dresser.").colors,
            (std::vector<Color>{named("black"), named("red")}));
  EXPECT_TRUE(look("The furniture should be black, walls white: sofa, table.").all);
  EXPECT_EQ(look("A bathroom with everything white and brass taps; tub, sink.").colors, std::vector<Color>{named("white")});
  EXPECT_EQ(look("All white kitchen, only the stools are red.").colors, std::vector<Color>{named("white")});
  EXPECT_EQ(look("A living room in shades of green with a sofa.").colors, std::vector<Color>{named("green")});
  EXPECT_TRUE(look("A room with a table; all the chairs are white.").colors.empty());
  EXPECT_TRUE(look("A bedroom with a bed in pink and a white desk.").colors.empty());
}

TEST(Decor, ColorsThatAreNotWantedGiveWay) {
  EXPECT_EQ(room_look("A living room, nothing beige, with a sofa and a rug.").unwanted, std::vector<Color>{named("beige")});
  EXPECT_EQ(room_look("A living room: mustard sofa, teal walls, no grey please.").unwanted, std::vector<Color>{named("grey")});
  EXPECT_EQ(room_look("A living room where nothing is black, a sofa.").unwanted, std::vector<Color>{named("black")});
  EXPECT_TRUE(room_look("A hall without white walls and no red chairs.").unwanted.empty());
  for (int seed = 0; seed < 20; ++seed) {
    for (const Color& color : decor_of(room("living_room", "a living room, nothing beige"), static_cast<std::uint64_t>(seed)).accents)
      EXPECT_FALSE(is_much_like(color, named("beige")));
  }
}

}  // namespace layoutbox
