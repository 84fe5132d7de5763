// catalog/shapes.json against the families themselves: each is there, and each of its numbers changes the mesh.
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace layoutbox
