// Levels of detail: each keeps what the usual one promises.
#include <gtest/gtest.h>

#include "layoutbox/furnish/furnish.h"
#include "layoutbox/furnish/mesh_checks.h"
#include "layoutbox/furnish/test_pieces.h"

namespace layoutbox {
namespace {

Node furnished(const PlacedObject& object, Detail detail, bool contents = true) {
  FurnishOptions options;
  options.detail = detail;
  options.contents = contents;
  Result<Model> model = furnish_object(object, catalog(), options);
  EXPECT_TRUE(model) << object.id;
  return model ? std::move(model->nodes.at(0)) : Node{};
}

kit::Box metres(const Space& space) {
  return {{space.min[0] / 1000, space.min[1] / 1000, space.min[2] / 1000}, {space.max[0] / 1000, space.max[1] / 1000, space.max[2] / 1000}};
}

class Details : public ::testing::TestWithParam<Detail> {
 protected:
  // Every entry of the catalogue at its least, usual and greatest size.
  template <class Check>
  static void for_every_piece(Check check) {
    for (const CatalogEntry& entry : catalog().entries()) {
      for (const Size& size : {entry.size.least, entry.size.usual, entry.size.greatest}) {
        SCOPED_TRACE(entry.id + " " + std::to_string(size.width) + "x" + std::to_string(size.depth) + "x" + std::to_string(size.height));
        check(object_of(entry, size));
      }
    }
  }
};

TEST_P(Details, EveryPieceFillsItsBoxAndKeepsOutOfItsSpaces) {
  for_every_piece([](const PlacedObject& object) {
    const Node node = furnished(object, GetParam(), false);
    const kit::Box b = mesh_checks::bounds_of(node);
    const double w = object.size.width / 2000.0, d = object.size.depth / 2000.0, h = object.size.height / 1000.0;
    for (const double gap : {b.min.x + w, w - b.max.x, b.min.y + d, d - b.max.y, b.min.z, h - b.max.z}) {
      EXPECT_GE(gap, -0.0005);
      EXPECT_LE(gap, 0.005);
    }
    for (const Space& space : object.spaces) EXPECT_EQ(mesh_checks::intrusion(node, metres(space), 0.0015), "") << space.name;
  });
}

TEST_P(Details, EveryMeshIsClosedAndFacesOutwards) {
  for_every_piece([](const PlacedObject& object) {
    for (const Part& part : furnished(object, GetParam()).parts) {
      EXPECT_EQ(mesh_checks::open_edges(part.mesh), 0);
      EXPECT_GT(mesh_checks::volume(part.mesh), 0);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Furnish, Details, ::testing::Values(Detail::kLow, Detail::kHigh),
                         [](const auto& level) { return level.param == Detail::kLow ? "Low" : "High"; });

TEST(Detail, LevelsDifferInTriangles) {
  std::size_t low = 0, usual = 0, high = 0;
  for (const CatalogEntry& entry : catalog().entries()) {
    const PlacedObject object = object_of(entry, entry.size.usual);
    const std::size_t l = mesh_checks::triangles_of(furnished(object, Detail::kLow)),
                      u = mesh_checks::triangles_of(furnished(object, Detail::kUsual)),
                      h = mesh_checks::triangles_of(furnished(object, Detail::kHigh));
    EXPECT_LE(l, u) << entry.id;
    EXPECT_LE(u, h) << entry.id;
    low += l, usual += u, high += h;
  }
  RecordProperty("low", static_cast<int>(low));
  RecordProperty("usual", static_cast<int>(usual));
  RecordProperty("high", static_cast<int>(high));
  EXPECT_LT(low, usual / 2) << "of " << catalog().entries().size() << " entries";
  EXPECT_GT(high, usual * 3 / 2);
}

// A bed that is slept in looks it.
TEST(Detail, AnUnmadeBedIsNoMadeOne) {
  PlacedObject bed = object_of(*catalog().find("king_bed"), catalog().find("king_bed")->size.usual);
  const std::size_t made = mesh_checks::triangles_of(furnished(bed, Detail::kUsual));
  bed.attributes = {"unmade"};
  EXPECT_NE(mesh_checks::triangles_of(furnished(bed, Detail::kUsual)), made);
}

TEST(Detail, TheUsualLevelComesBack) {
  const PlacedObject chair = object_of(*catalog().find("chair"), catalog().find("chair")->size.usual);
  const std::size_t before = mesh_checks::triangles_of(furnished(chair, Detail::kUsual));
  furnished(chair, Detail::kLow);
  EXPECT_EQ(mesh_checks::triangles_of(furnished(chair, Detail::kUsual)), before);
}

}  // namespace
}  // namespace layoutbox
