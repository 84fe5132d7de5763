#include "layoutbox/furnish/palette.h"

#include <gtest/gtest.h>

#include <set>

namespace layoutbox {
namespace {

const std::set<std::string> kTextures{"",         "wood",     "planks",  "parquet", "tiles",    "checker", "bricks", "marble",
                                      "terrazzo", "concrete", "plaster", "fabric",  "carpet",   "leather", "wicker", "stripes",
                                      "brushed",  "tatami",   "flags",   "flowers", "rosettes", "logs",    "glazed"};

TEST(Palette, SurfacesAreNamedOnceAndUseKnownTextures) {
  std::set<std::string> names;
  for (const NamedSurface& named : named_surfaces()) {
    EXPECT_TRUE(names.insert(named.surface.name).second) << named.surface.name;
    EXPECT_TRUE(kTextures.contains(named.surface.texture)) << named.surface.name << " " << named.surface.texture;
    EXPECT_GT(named.surface.scale, 0) << named.surface.name;
    for (const double c : {named.surface.base.r, named.surface.base.g, named.surface.base.b})
      EXPECT_TRUE(c >= 0 && c <= 1) << named.surface.name;
  }
  EXPECT_GE(names.size(), 40U);
}

TEST(Palette, ReadsColoursAndMaterials) {
  const SurfaceWish wish = read_wish("dark green velvet sofa");
  ASSERT_TRUE(wish.color);
  EXPECT_GT(wish.color->g, wish.color->r);
  ASSERT_EQ(wish.materials.size(), 1U);
  EXPECT_EQ(wish.materials[0]->surface.name, "velvet");
}

TEST(Palette, LongerPhrasesWin) {
  const SurfaceWish wish = read_wish("black metal");
  ASSERT_EQ(wish.materials.size(), 1U);
  EXPECT_EQ(wish.materials[0]->surface.name, "black_metal");
  EXPECT_FALSE(wish.color);
}

TEST(Palette, ModifiersMixColours) {
  const SurfaceWish plain = read_wish("green"), pale = read_wish("pale green");
  ASSERT_TRUE(plain.color && pale.color);
  const SurfaceWish alone = read_wish("pale sofa");
  ASSERT_TRUE(alone.color);
  EXPECT_GT(alone.color->g, 0.7F);
  EXPECT_FALSE(read_wish("pale oak").color);
  EXPECT_GT(pale.color->r, plain.color->r);
}

TEST(Palette, WordsOfTheThingsOwnNameAreNoWishes) {
  const std::vector<std::string> own{"coffee", "table"};
  EXPECT_FALSE(read_wish("coffee table", own).color);
  EXPECT_TRUE(read_wish("coffee table").color);
}

TEST(Palette, PhrasesDoNotReachOverCommas) { EXPECT_EQ(read_wish("black, metal").materials[0]->surface.name, "steel"); }

TEST(Palette, SoftWishesGoToSoftParts) {
  const SurfaceWish wish = read_wish("walnut and leather");
  EXPECT_EQ(wish.fitting(named_surface("linen"))->surface.name, "leather");
  EXPECT_EQ(wish.fitting(named_surface("oak"))->surface.name, "walnut");
}

TEST(Palette, ColourKeepsBrownWoodWoodenAndLacquersTheRest) {
  EXPECT_EQ(colored(named_surface("oak"), {0.43, 0.29, 0.20}).texture, "wood");
  EXPECT_EQ(colored(named_surface("oak"), {0.2, 0.3, 0.8}).texture, named_surface("lacquer").surface.texture);
}

TEST(Palette, KeepsEachSurfaceOnceUnderItsOwnName) {
  Palette palette;
  const int oak = palette.named("oak");
  EXPECT_EQ(palette.named("oak"), oak);
  Surface other = named_surface("oak").surface;
  other.roughness = 0.9F;
  EXPECT_NE(palette.add(other), oak);
  const std::vector<Surface> surfaces = palette.take();
  ASSERT_EQ(surfaces.size(), 2U);
  EXPECT_NE(surfaces[0].name, surfaces[1].name);
}

}  // namespace
}  // namespace layoutbox
