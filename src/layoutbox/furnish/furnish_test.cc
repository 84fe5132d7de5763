#include "layoutbox/furnish/furnish.h"

#include <gtest/gtest.h>

#include <set>

#include "layoutbox/catalog/toppled.h"
#include "layoutbox/furnish/mesh_checks.h"
#include "layoutbox/furnish/piece.h"
#include "layoutbox/furnish/test_pieces.h"

namespace layoutbox {
namespace {

kit::Box metres(const Space& space) {
  return {{space.min[0] / 1000, space.min[1] / 1000, space.min[2] / 1000}, {space.max[0] / 1000, space.max[1] / 1000, space.max[2] / 1000}};
}

// Every entry of the catalogue at its least, usual and greatest size.
template <class Check>
void for_every_piece(Check check) {
  for (const CatalogEntry& entry : catalog().entries()) {
    for (const Size& size : {entry.size.least, entry.size.usual, entry.size.greatest}) {
      SCOPED_TRACE(entry.id + " " + std::to_string(size.width) + "x" + std::to_string(size.depth) + "x" + std::to_string(size.height));
      check(object_of(entry, size));
    }
  }
}

// Every entry as each of its variants: "round" dining table, "king" bed.
template <class Check>
void for_every_variant(Check check) {
  for (const CatalogEntry& entry : catalog().entries()) {
    for (const SizeVariant& variant : entry.variants) {
      for (const std::string& word : variant.words) {
        SceneObject said;
        said.attributes = {word};
        said.category = entry.id;
        said.name = entry.name;
        for (const Size& size : {variant.size.least, variant.size.usual, variant.size.greatest}) {
          PlacedObject object = object_of(entry, size);
          object.attributes = {word};
          object.spaces = spaces_of(said, entry, size);
          SCOPED_TRACE(word + " " + entry.id + " " + std::to_string(size.width) + "x" + std::to_string(size.depth));
          check(object);
        }
      }
    }
  }
}

TEST(Furnish, EveryPieceTouchesItsBoxOnAllSides) {
  FurnishOptions empty;
  empty.contents = false;
  for_every_piece([&](const PlacedObject& object) {
    const kit::Box b = mesh_checks::bounds_of(furnished(object, empty).nodes.at(0));
    const double w = object.size.width / 2000.0, d = object.size.depth / 2000.0, h = object.size.height / 1000.0;
    for (const double gap : {b.min.x + w, w - b.max.x, b.min.y + d, d - b.max.y, b.min.z, h - b.max.z}) {
      EXPECT_GE(gap, -0.0005);
      EXPECT_LE(gap, 0.005);
    }
  });
}

TEST(Furnish, NothingOfAPieceIsInItsSpaces) {
  FurnishOptions empty;
  empty.contents = false;
  for_every_piece([&](const PlacedObject& object) {
    const Model model = furnished(object, empty);
    for (const Space& space : object.spaces) EXPECT_EQ(mesh_checks::intrusion(model.nodes.at(0), metres(space), 0.0015), "") << space.name;
  });
}

TEST(Furnish, EveryVariantFillsItsBoxAndKeepsOutOfItsSpaces) {
  FurnishOptions empty;
  empty.contents = false;
  for_every_variant([&](const PlacedObject& object) {
    const Model model = furnished(object, empty);
    const kit::Vec size = mesh_checks::bounds_of(model.nodes.at(0)).size();
    EXPECT_NEAR(size.x, object.size.width / 1000.0, 0.005);
    EXPECT_NEAR(size.y, object.size.depth / 1000.0, 0.005);
    EXPECT_NEAR(size.z, object.size.height / 1000.0, 0.005);
    for (const Space& space : object.spaces) EXPECT_EQ(mesh_checks::intrusion(model.nodes.at(0), metres(space), 0.0015), "") << space.name;
  });
}

// A counter with a bin under it: what is solid by itself stands on legs.
TEST(Furnish, WhatIsRaisedLeavesTheSpaceUnderItFree) {
  FurnishOptions empty;
  empty.contents = false;
  for (const char* id : {"counter", "exam_table", "sideboard", "berth", "bookshelf", "workbench", "kitchen_sink"}) {
    SCOPED_TRACE(id);
    SceneObject said;
    said.raised = 180;
    PlacedObject object = object_of(id);
    object.spaces = spaces_of(said, *catalog().find(id), object.size);
    ASSERT_EQ(object.spaces.back().name, kSpaceUnderIt);
    EXPECT_EQ(object.spaces.back().max[2], 180);
    const Node node = furnished(object, empty).nodes.at(0);
    const kit::Vec size = mesh_checks::bounds_of(node).size();
    EXPECT_NEAR(size.x, object.size.width / 1000.0, 0.005);
    EXPECT_NEAR(size.y, object.size.depth / 1000.0, 0.005);
    EXPECT_NEAR(size.z, object.size.height / 1000.0, 0.005);
    for (const Space& space : object.spaces) EXPECT_EQ(mesh_checks::intrusion(node, metres(space), 0.0015), "") << space.name;
  }
}

TEST(Furnish, EveryMeshIsClosedFacesOutwardsAndIsOfSensibleSize) {
  for_every_piece([&](const PlacedObject& object) {
    const Model model = furnished(object);
    EXPECT_LT(mesh_checks::triangles_of(model.nodes.at(0)), 7500U);
    for (const Part& part : model.nodes.at(0).parts) {
      const std::string& surface = model.surfaces.at(static_cast<std::size_t>(part.surface)).name;
      EXPECT_EQ(mesh_checks::open_edges(part.mesh), 0) << surface;
      EXPECT_GT(mesh_checks::volume(part.mesh), 0) << surface;
    }
  });
}

TEST(Furnish, RoomsOfTwentyThingsHaveFewTriangles) {
  for (const RoomKind& room : catalog().rooms()) {
    std::size_t things = 0, triangles = 0;
    for (const auto& [id, count] : room.usual) {
      const CatalogEntry* entry = catalog().find(id);
      ASSERT_NE(entry, nullptr) << id;
      things += static_cast<std::size_t>(count);
      triangles += static_cast<std::size_t>(count) * mesh_checks::triangles_of(furnished(object_of(*entry, entry->size.usual)).nodes.at(0));
    }
    EXPECT_LT(20 * triangles, 50'000U * std::max<std::size_t>(1, things)) << room.id;
  }
}

TEST(Furnish, ContentsStayWithinTheBoxAndOutOfWhatIsHeld) {
  Layout layout;
  PlacedObject shelf = object_of("bookshelf");
  PlacedObject vase = object_of("vase");
  ASSERT_GE(shelf.spaces.size(), 3U);
  vase.size = {100, 100, 200};
  vase.spaces.clear();
  vase.position = {0, 0, shelf.spaces[1].min[2]};
  vase.supported_by = shelf.id;
  layout.objects = {shelf, vase};
  const Result<Model> model = furnish(layout, catalog());
  ASSERT_TRUE(model);
  EXPECT_EQ(mesh_checks::intrusion(model->nodes.at(0), metres(shelf.spaces[1]), 0.0015), "");
  EXPECT_NE(mesh_checks::intrusion(model->nodes.at(0), metres(shelf.spaces[2]), 0.0015), "") << "the other shelves keep their books";
}

// An overturned chair fills the box of one that lies on its side.
TEST(Furnish, WhatWasKnockedOverLies) {
  for (const char* kind : {"chair", "table", "floor_lamp"}) {
    PlacedObject object = object_of(kind);
    const Size upright = object.size;
    object.attributes = {"overturned"};
    object.size = toppled(catalog().entry_or_nearest(kind), upright);
    EXPECT_NE(object.size.height, upright.height) << kind;
    kit::Box all{{9, 9, 9}, {-9, -9, -9}};
    const Model model = furnished(object);  // outlives the loop
    for (const Part& part : model.nodes.at(0).parts) {
      const kit::Box b = kit::bounds(part.mesh);
      all.min.x = std::min(all.min.x, b.min.x), all.min.y = std::min(all.min.y, b.min.y), all.min.z = std::min(all.min.z, b.min.z);
      all.max.x = std::max(all.max.x, b.max.x), all.max.y = std::max(all.max.y, b.max.y), all.max.z = std::max(all.max.z, b.max.z);
    }
    EXPECT_NEAR(all.min.z, 0, 0.006) << kind;
    EXPECT_NEAR(all.size().x, m_from_mm(object.size.width), 0.012) << kind;
    EXPECT_NEAR(all.size().y, m_from_mm(object.size.depth), 0.012) << kind;
    EXPECT_NEAR(all.size().z, m_from_mm(object.size.height), 0.012) << kind;
  }
}

// A sword on a wall is flat on it, whichever way its kind lies on a table.
TEST(Furnish, WhatLiesByNatureHangsFlat) {
  for (const char* kind : {"sword", "tennis_racket"}) {
    PlacedObject object = object_of(kind);
    object.mount = Mount::kWall;
    object.size = hung_flat(catalog().entry_or_nearest(kind), object.size);
    EXPECT_LT(object.size.depth, std::min(object.size.width, object.size.height)) << kind;
    kit::Box all{{9, 9, 9}, {-9, -9, -9}};
    const Model model = furnished(object);  // outlives the loop
    for (const Part& part : model.nodes.at(0).parts) {
      const kit::Box b = kit::bounds(part.mesh);
      all.min.x = std::min(all.min.x, b.min.x), all.min.y = std::min(all.min.y, b.min.y), all.min.z = std::min(all.min.z, b.min.z);
      all.max.x = std::max(all.max.x, b.max.x), all.max.y = std::max(all.max.y, b.max.y), all.max.z = std::max(all.max.z, b.max.z);
    }
    EXPECT_NEAR(all.min.z, 0, 0.006) << kind;
    EXPECT_NEAR(all.size().x, m_from_mm(object.size.width), 0.012) << kind;
    EXPECT_NEAR(all.size().y, m_from_mm(object.size.depth), 0.012) << kind;
    EXPECT_NEAR(all.size().z, m_from_mm(object.size.height), 0.012) << kind;
  }
}

// The door of an open machine is before it, over free floor.
TEST(Furnish, OpenMachinesShowTheirInside) {
  for (const char* kind : {"dishwasher", "oven", "fridge", "locker", "wardrobe", "cabinet"}) {
    const auto front = [&](std::vector<std::string> words) {
      PlacedObject object = object_of(kind);
      object.attributes = std::move(words);
      double y = 0;
      const Model model = furnished(object);
      for (const Part& part : model.nodes.at(0).parts) y = std::min(y, kit::bounds(part.mesh).min.y);
      return y;
    };
    EXPECT_LT(front({"open"}), front({}) - 0.35) << kind;
  }
}

TEST(Furnish, LampsGiveLightWithinThemselves) {
  for (const char* id : {"floor_lamp", "table_lamp", "pendant_lamp"}) {
    const PlacedObject lamp = object_of(id);
    const Node node = furnished(lamp).nodes.at(0);
    ASSERT_FALSE(node.lights.empty()) << id;
    EXPECT_GT(node.lights[0].watts, 0) << id;
  }
}

TEST(Furnish, TheSameObjectAlwaysLooksTheSame) {
  const PlacedObject shelf = object_of("bookshelf");
  const Model a = furnished(shelf), b = furnished(shelf);
  ASSERT_EQ(a.nodes[0].parts.size(), b.nodes[0].parts.size());
  for (std::size_t i = 0; i < a.nodes[0].parts.size(); ++i)
    EXPECT_EQ(a.nodes[0].parts[i].mesh.positions, b.nodes[0].parts[i].mesh.positions);
  PlacedObject other = shelf;
  other.id = "bookshelf_2";
  EXPECT_NE(mesh_checks::triangles_of(furnished(other).nodes[0]), mesh_checks::triangles_of(a.nodes[0])) << "another shelf has other books";
}

TEST(Furnish, AnUnknownThingIsDrawnAtItsSize) {
  PlacedObject thing;
  thing.id = "thing_1";
  thing.category = "flux_capacitor";
  thing.name = "flux capacitor";
  thing.size = {500, 400, 900};
  const kit::Box b = mesh_checks::bounds_of(furnished(thing).nodes.at(0));
  EXPECT_NEAR(b.max.z, 0.9, 0.005);
  EXPECT_NEAR(b.max.x, 0.25, 0.005);
}

TEST(Furnish, ASizeOfNothingIsAnError) {
  PlacedObject thing = object_of("chair");
  thing.size.depth = 0;
  const Result<Model> model = furnish_object(thing, catalog());
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().pointer, "chair_1");
}

}  // namespace
}  // namespace layoutbox
