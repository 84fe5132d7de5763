// What a piece looks like as it is said: colours, materials, wear.
#include <gtest/gtest.h>

#include <algorithm>

#include "layoutbox/furnish/mesh_checks.h"
#include "layoutbox/furnish/piece.h"
#include "layoutbox/furnish/test_pieces.h"

namespace layoutbox {
namespace {

const Surface* surface_named(const Model& model, const std::string& start) {
  for (const Surface& surface : model.surfaces) {
    if (surface.name.starts_with(start)) return &surface;
  }
  return nullptr;
}

TEST(Furnish, GivesTheAskedColourToTheMainPart) {
  PlacedObject bed = object_of("bed");
  bed.attributes = {"blue"};
  const Model model = furnished(bed);
  const bool blue = std::any_of(model.surfaces.begin(), model.surfaces.end(), [](const Surface& s) { return s.base.b > s.base.r + 0.2; });
  EXPECT_TRUE(blue);
}

// What an asked colour covers: the legs of a red chair, the frame as well as the cloth of a pink bed.
TEST(Furnish, AnAskedColourCoversTheFrame) {
  for (const char* kind : {"chair", "desk", "table", "bed"}) {
    PlacedObject object = object_of(kind);
    object.attributes = {"red"};
    const Model model = furnished(object);
    EXPECT_TRUE(std::ranges::none_of(model.surfaces, [](const Surface& s) { return s.texture == "wood"; })) << kind;
  }
}

TEST(Furnish, WickerAndRustAreSeen) {
  const auto uses = [&](const char* kind, const char* word, std::string_view surface) {
    PlacedObject object = object_of(kind);
    object.attributes = {word};
    const Model model = furnished(object);
    return std::ranges::any_of(model.surfaces, [&](const Surface& s) { return s.name == surface; });
  };
  for (const char* kind : {"chair", "armchair", "sofa"}) EXPECT_TRUE(uses(kind, "wicker", "rattan")) << kind;
  for (const char* kind : {"bed", "cabinet"}) EXPECT_TRUE(uses(kind, "rusty", "rusty_metal")) << kind;
}

// "a fridge with a glass door": only its door is of glass.
TEST(Furnish, AFridgeWithAGlassDoorIsNotSeenThrough) {
  PlacedObject fridge = object_of("display_fridge");
  const std::size_t plain = furnished(fridge).surfaces.size();
  fridge.attributes = {"glass"};
  EXPECT_EQ(furnished(fridge).surfaces.size(), plain);
}

TEST(Furnish, WornThingsAreDarkerThanNewOnes) {
  const auto brightness = [](const char* word) {
    PlacedObject object = object_of("workbench");
    object.attributes = {word};
    double sum = 0;
    const Model model = furnished(object);
    for (const Surface& s : model.surfaces) sum += (s.base.r + s.base.g + s.base.b) / static_cast<double>(model.surfaces.size());
    return sum;
  };
  EXPECT_LT(brightness("old"), brightness("large") - 0.05);
  EXPECT_LT(brightness("dirty"), brightness("old"));
}

TEST(Furnish, GivesTheAskedMaterialToTheFittingPart) {
  PlacedObject chair = object_of("armchair");
  chair.attributes = {"leather"};
  EXPECT_NE(surface_named(furnished(chair), "leather"), nullptr);
  PlacedObject table = object_of("dining_table");
  table.name = "walnut dining table";
  EXPECT_NE(surface_named(furnished(table), "walnut"), nullptr);
}

TEST(Furnish, ASceneMaterialWins) {
  Layout layout;
  Material own;
  own.id = "my_paint";
  own.color = Color{0.9, 0.1, 0.5};
  own.roughness = 0.25;
  layout.materials = {own};
  PlacedObject table = object_of("dining_table");
  table.material = "my_paint";
  layout.objects = {table};
  const Result<Model> model = furnish(layout, catalog());
  ASSERT_TRUE(model);
  const Surface* surface = surface_named(*model, "my_paint");
  ASSERT_NE(surface, nullptr);
  EXPECT_NEAR(surface->base.g, 0.1, 1e-9);
  EXPECT_NEAR(static_cast<double>(surface->roughness), 0.25, 1e-6);
}

}  // namespace
}  // namespace layoutbox
