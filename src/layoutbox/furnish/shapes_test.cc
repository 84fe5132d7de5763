// catalog/shapes.json against the families themselves: each is there, and each of its numbers changes the mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "layoutbox/base/files.h"
#include "layoutbox/catalog/catalog_json.h"
#include "layoutbox/furnish/furnish.h"
#include "layoutbox/furnish/piece.h"

namespace layoutbox {
namespace {

const CatalogData& shapes() {
  static const CatalogData data = [] {
    CatalogData read;
    const auto text = read_file(LAYOUTBOX_SOURCE_FOLDER "/catalog/shapes.json");
    EXPECT_TRUE(text && read_checked_catalog_data(*text, read));
    return read;
  }();
  return data;
}

// The positions of all corners of the piece.
std::vector<Vec3f> corners_of(const CatalogEntry& entry, bool hollow) {
  PlacedObject object;
  object.id = object.category = entry.id;
  object.name = entry.name;
  object.size = entry.size.usual;
  object.mount = entry.mount;
  if (hollow) object.spaces = spaces_at(entry, object.size);
  const auto model = furnish_object(object, Catalog({entry}, {}));
  std::vector<Vec3f> corners;
  if (!model) return corners;
  for (const Node& node : model->nodes) {
    for (const Part& part : node.parts) corners.insert(corners.end(), part.mesh.positions.begin(), part.mesh.positions.end());
  }
  return corners;
}

CatalogEntry with_number(CatalogEntry entry, const std::string& name, std::optional<double> value) {
  value ? entry.shape.numbers[name] = *value : entry.shape.numbers.erase(name);
  return entry;
}

TEST(Shapes, AreTheFamiliesThereAre) {
  for (const auto& [name, family] : shapes().families) EXPECT_TRUE(kit::families().contains(name)) << name;
  for (const auto& [name, family] : kit::families()) EXPECT_TRUE(shapes().families.contains(std::string(name))) << name;
}

TEST(Shapes, EveryNumberChangesTheMeshAndHasItsDefault) {
  for (const auto& [name, family] : shapes().families) {
    for (const auto& [number, range] : family.numbers) {
      SCOPED_TRACE(name + "." + number);
      bool changes = false;
      for (const CatalogEntry& entry : Catalog::builtin().entries()) {
        if (entry.shape.family != name) continue;
        for (const bool hollow : {true, false}) {
          const auto left_out = corners_of(with_number(entry, number, {}), hollow);
          if (range.usual) {
            EXPECT_EQ(left_out, corners_of(with_number(entry, number, range.usual), hollow)) << entry.id;
          }
          for (const double value : {range.least, range.most})
            changes = changes || corners_of(with_number(entry, number, value), hollow) != left_out;
        }
      }
      EXPECT_TRUE(changes) << "nothing reads it";
    }
  }
}

// Corners on the floor, by the leg that they are of: those less than a hand apart belong together.
std::vector<std::vector<Vec3f>> feet_of(const std::vector<Vec3f>& corners) {
  std::vector<std::vector<Vec3f>> feet;
  for (const Vec3f& c : corners) {
    if (c[2] > 0.005F) continue;
    const auto near = [&](const std::vector<Vec3f>& foot) { return std::hypot(foot[0][0] - c[0], foot[0][1] - c[1]) < 0.1F; };
    const auto found = std::find_if(feet.begin(), feet.end(), near);
    found == feet.end() ? feet.push_back({c}) : found->push_back(c);
  }
  return feet;
}

std::vector<Vec3f> builtin_corners(const std::string& id, const std::string& name) {
  CatalogEntry entry = *Catalog::builtin().find(id);
  entry.name = name;
  return corners_of(entry, true);
}

TEST(Shapes, StoolsHaveThreeLegsWhereTheTextSaysSo) {
  EXPECT_EQ(feet_of(builtin_corners("stool", "stool")).size(), 4U);
  EXPECT_EQ(feet_of(builtin_corners("stool", "three-legged stool")).size(), 3U);
}

TEST(Shapes, PostsOfBunksAreAsThickAsPosts) {
  for (const char* id : {"loft_bed", "bunk_bed"}) {
    for (const auto& foot : feet_of(builtin_corners(id, id))) {
      const auto [least, most] = std::minmax_element(foot.begin(), foot.end());
      // Those at the head: at the foot there is a ladder too.
      if ((*least)[1] > 0) {
        EXPECT_GT((*most)[0] - (*least)[0], 0.04F) << id;
      }
    }
  }
}

TEST(Shapes, EaselsShowAPaintingWhereContentsAreDrawn) {
  const CatalogEntry& entry = *Catalog::builtin().find("easel");
  PlacedObject object;
  object.id = object.category = object.name = "easel";
  object.size = entry.size.usual;
  object.spaces = spaces_at(entry, object.size);
  FurnishOptions bare;
  bare.contents = false;
  const auto with = furnish_object(object, Catalog::builtin()), without = furnish_object(object, Catalog::builtin(), bare);
  ASSERT_TRUE(with && without);
  EXPECT_GT(with->nodes.front().parts.size(), without->nodes.front().parts.size());
}

}  // namespace
}  // namespace layoutbox
