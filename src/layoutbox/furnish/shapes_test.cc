// catalog/shapes.json against the families themselves: each is there, and each of its numbers and words changes what is drawn.
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

// Everything that is drawn of the piece: corners, and the surfaces they are of. Its name says nothing.
std::string drawing_of(CatalogEntry entry, const std::string& word, const std::optional<std::string>& value, bool hollow) {
  entry.shape.words.erase(word);
  if (value) entry.shape.words[word] = *value;
  PlacedObject object;
  object.id = object.category = entry.id;
  object.name = "thing";
  object.size = entry.size.usual;
  object.mount = entry.mount;
  if (hollow) object.spaces = spaces_at(entry, object.size);
  const auto model = furnish_object(object, Catalog({entry}, {}));
  std::string drawing;
  if (!model) return drawing;
  for (const Node& node : model->nodes) {
    for (const Part& part : node.parts) {
      drawing += model->surfaces.at(static_cast<std::size_t>(part.surface)).name + ":";
      for (const Vec3f& c : part.mesh.positions) drawing.append(reinterpret_cast<const char*>(c.data()), sizeof c);
    }
  }
  return drawing;
}

TEST(Shapes, EveryWordChangesTheDrawingAndHasItsDefault) {
  for (const auto& [name, family] : shapes().families) {
    for (const auto& [word, spec] : family.words) {
      for (const std::string& value : spec.values) {
        SCOPED_TRACE(name + "." + word + " = " + value);
        bool changes = false;
        for (const CatalogEntry& entry : Catalog::builtin().entries()) {
          if (entry.shape.family != name || changes) continue;
          for (const bool hollow : {true, false})
            changes = changes || drawing_of(entry, word, value, hollow) != drawing_of(entry, word, {}, hollow);
        }
        EXPECT_EQ(changes, value != spec.usual) << "nothing reads it, or it is not the default";
      }
    }
  }
}

TEST(Shapes, MaterialsAndColoursOfTheCatalogueAreKnown) {
  for (const CatalogEntry& entry : Catalog::builtin().entries()) {
    for (const auto& [word, value] : entry.shape.words) {
      if (word != "material" && word != "color") continue;
      const SurfaceWish wish = read_wish(value);
      EXPECT_TRUE(wish.color || !wish.materials.empty()) << entry.id << ": " << value;
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

TEST(Shapes, CurtainsThatShareAWindowAreDrawnApart) {
  const CatalogEntry& entry = *Catalog::builtin().find("curtain");
  Layout layout;
  layout.room.polygon = {{0, 0}, {4000, 0}, {4000, 4000}, {0, 4000}};
  layout.room.height = 2600;
  for (const double x : {1600.0, 2400.0}) {
    PlacedObject object;
    object.id = x < 2000 ? "left" : "right";
    object.category = object.name = "curtain";
    object.mount = entry.mount;
    object.size = entry.size.usual;
    object.size.width = 800;
    object.position = {x, 3950, 100};
    layout.objects.push_back(object);
  }
  const auto model = furnish(layout, Catalog::builtin());
  ASSERT_TRUE(model);
  for (const Node& node : model->nodes) {
    if (node.kind != NodeKind::kObject) continue;
    double least = 1, most = -1;  // of the cloth, along the rod
    for (const Part& part : node.parts) {
      if (!model->surfaces.at(static_cast<std::size_t>(part.surface)).name.starts_with("linen")) continue;
      for (const Vec3f& c : part.mesh.positions) least = std::min<double>(least, c[0]), most = std::max<double>(most, c[0]);
    }
    const bool left = node.id == "left";
    EXPECT_LT(most - least, 0.45) << node.id;
    EXPECT_TRUE(left ? least < -0.3 : most > 0.3) << node.id;
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

// Things drawn alike may share a family, but nothing is drawn as what it is not.
TEST(Shapes, ABoxingRingHasRopesAndACribHasNone) {
  for (const CatalogEntry& entry : Catalog::builtin().entries()) {
    if (entry.shape.family == "crib") {
      EXPECT_TRUE(Catalog::builtin().is_a(entry.id, "crib") || entry.id == "playpen") << entry.id;
    }
  }
  const CatalogEntry& ring = *Catalog::builtin().find("boxing_ring");
  const auto corners = [&](double ropes) { return corners_of(with_number(ring, "ropes", ropes), true).size(); };
  EXPECT_EQ(corners(4) - corners(3), corners(3) - corners(2)) << "each rope adds as much";
  EXPECT_GT(corners(3), corners(2));
  EXPECT_FALSE(shapes().families.at("crib").numbers.contains("ropes"));
}

}  // namespace
}  // namespace layoutbox
