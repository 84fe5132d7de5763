#include "layoutbox/catalog/kin.h"

#include <gtest/gtest.h>

namespace layoutbox {
namespace {

std::string kin(std::string_view noun) {
  const CatalogEntry* entry = kin_of(Catalog::builtin(), noun);
  return entry == nullptr ? "" : entry->id;
}

TEST(Kin, IsTheNearestKnownKind) {
  EXPECT_EQ(kin("walrus"), "pet");
  EXPECT_EQ(kin("walruses"), "pet");
  EXPECT_EQ(kin("soup tureen"), "bowl");
  EXPECT_EQ(kin("bassoon"), "instrument");
  EXPECT_EQ(kin("happiness"), "");
  EXPECT_EQ(kin("xyzzy"), "");
  EXPECT_EQ(kin(""), "");
}

TEST(Kin, PlacesPartsAndStuffAreNoThings) {
  const Catalog& catalog = Catalog::builtin();
  for (const char* word : {"darkroom", "conservatoire", "driveways", "monastery", "hem", "keyhole", "subway", "hand"})
    EXPECT_TRUE(is_no_thing(catalog, word)) << word;
  for (const char* word : {"walrus", "engraving", "secateurs", "bassoon", "wok", "sofa", "heron", "ammonite", "xyzzy"})
    EXPECT_FALSE(is_no_thing(catalog, word)) << word;
  EXPECT_EQ(kin("botanical engraving"), "painting");
  EXPECT_EQ(kin("secateurs"), "scissors");
}

TEST(Kin, ACompoundIsLikeWhatItsHeadUsuallyIs) {
  EXPECT_EQ(kin("demonstration board"), "bulletin_board");
  EXPECT_EQ(kin("cardboard tubes"), "cylinder");
  EXPECT_EQ(kin("board"), "");
}

TEST(Kin, AWordBeforeTheNounMaySayMore) {
  EXPECT_EQ(kin("plush walrus"), "teddy_bear");
  EXPECT_EQ(kin("stuffed heron"), "bird");
  EXPECT_EQ(kin("stuffed walrus"), "teddy_bear");
  EXPECT_TRUE(is_kin_modifier("plush"));
  EXPECT_FALSE(is_kin_modifier("old"));
}

TEST(Kin, SizesAndMountsOfWhatTheCatalogueLacks) {
  const Catalog& catalog = Catalog::builtin();
  EXPECT_EQ(catalog.entry_or_nearest("plush_walrus").id, "teddy_bear");
  EXPECT_EQ(catalog.entry_or_nearest("bassoon").mount, Mount::kSurface);
  EXPECT_EQ(catalog.entry_or_nearest("xyzzy").id, "object");
}

// What is like an entry keeps its own word, and is what the entry is.
TEST(Kin, LikeWordsLeadToTheirEntry) {
  const Catalog& catalog = Catalog::builtin();
  EXPECT_EQ(catalog.find_by_words("wok"), nullptr);
  EXPECT_EQ(liked_entry("Woks"), "");
  EXPECT_EQ(liked_entry("Wok"), "pan");
  for (const auto& [word, id] : like_words()) {
    EXPECT_NE(catalog.find(id), nullptr) << id;
    EXPECT_EQ(catalog.entry_or_nearest(word).id, id) << word;
  }
  EXPECT_EQ(catalog.entry_or_nearest("wok").id, "pan");
  EXPECT_TRUE(catalog.is_a("wok", "pan"));
  EXPECT_FALSE(catalog.is_a("wok", "pot"));
}

TEST(Kin, WhatIsElsewhereThanMostlyIsOfAnotherKind) {
  const auto at = [](std::string_view id, KinPlace place) {
    const CatalogEntry* kind = kind_at(Catalog::builtin(), id, place);
    return kind == nullptr ? std::string("as it is") : kind->id;
  };
  EXPECT_EQ(at("bookshelf", KinPlace::kOnWall), "wall_bookshelf");
  EXPECT_EQ(at("coat_rack", KinPlace::kOnWall), "hook_rail");
  EXPECT_EQ(at("pillow", KinPlace::kOnFloor), "floor_cushion");
  EXPECT_EQ(at("lamp", KinPlace::kOnCeiling), "ceiling_lamp");
  EXPECT_EQ(at("plant", KinPlace::kOnThing), "small_plant");
  EXPECT_EQ(at("table", KinPlace::kBetweenSeats), "side_table");
  EXPECT_EQ(at("table", KinPlace::kBetweenSofas), "coffee_table");
  EXPECT_EQ(at("lantern", KinPlace::kOnCeiling), "hanging_lantern");
  EXPECT_EQ(at("curtain_rod", KinPlace::kAroundBed), "privacy_curtain");
  EXPECT_EQ(at("sink", KinPlace::kSetIn), "inset_sink");
  EXPECT_EQ(at("grab_rail", KinPlace::kAtSides), "fold_down_rail");
  EXPECT_EQ(at("sofa", KinPlace::kOnWall), "as it is");
  EXPECT_EQ(kind_at(Catalog({}, {}), "sink", KinPlace::kSetIn), nullptr);
}

}  // namespace
}  // namespace layoutbox
