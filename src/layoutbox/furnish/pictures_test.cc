// What pictures show: by their own words, else by their room.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "layoutbox/furnish/decor.h"
#include "layoutbox/furnish/decor_data.h"
#include "layoutbox/furnish/families/picture_sheet.h"
#include "layoutbox/furnish/mesh_checks.h"
#include "layoutbox/furnish/picture_subjects.h"
#include "layoutbox/furnish/test_pieces.h"

namespace layoutbox {
namespace {

using Looks = std::multiset<std::array<int, 3>>;

// The colours of a picture, by which what it shows can be told from another.
Looks looks(const Model& model) {
  Looks all;
  for (const Surface& s : model.surfaces)
    all.insert({static_cast<int>(s.base.r * 1000), static_cast<int>(s.base.g * 1000), static_cast<int>(s.base.b * 1000)});
  return all;
}

Model picture_of(std::string_view kind, std::string name, std::string id = "picture_1") {
  PlacedObject object = object_of(kind);
  object.name = std::move(name);
  object.id = std::move(id);
  return furnished(object);
}

Model picture_in(std::string prompt, std::string type = "bedroom") {
  Layout layout;
  layout.room.type = std::move(type);
  layout.room.polygon = {{0, 0}, {4000, 0}, {4000, 4000}, {0, 4000}};
  layout.prompt = std::move(prompt);
  layout.objects.push_back(object_of("poster"));
  const Result<Model> model = furnish(layout, catalog(), {});
  EXPECT_TRUE(model);
  return model ? *model : Model{};
}

std::size_t triangles_of(const Model& model, std::string_view category) {
  std::size_t triangles = 0;
  for (const Node& node : model.nodes) {
    if (node.category != category) continue;
    for (const Part& part : node.parts) triangles += part.mesh.indices.size() / 3;
  }
  return triangles;
}

std::string subject(std::string_view text) {
  const std::string padded = " " + std::string(text) + " ";
  return picture_subject([&](std::string_view word) { return padded.find(" " + std::string(word) + " ") != std::string::npos; });
}

void expect_sound(const Node& node, const PlacedObject& object) {
  const kit::Box b = mesh_checks::bounds_of(node);
  const double w = object.size.width / 2000.0, d = object.size.depth / 2000.0, h = object.size.height / 1000.0;
  for (const double gap : {b.min.x + w, w - b.max.x, b.min.y + d, d - b.max.y, b.min.z, h - b.max.z})
    EXPECT_GE(gap, -0.0001) << object.name;
  for (const Part& part : node.parts) {
    EXPECT_EQ(mesh_checks::open_edges(part.mesh), 0) << object.name;
    EXPECT_GT(mesh_checks::volume(part.mesh), 0) << object.name;
  }
}

TEST(Pictures, ShowWhatTheirOwnWordsSay) {
  EXPECT_EQ(subject("painting of mountains"), "mountains");
  EXPECT_EQ(subject("seascape"), "sea");
  EXPECT_EQ(subject("family portrait"), "family");
  EXPECT_EQ(subject("oil portrait abstract"), "forebear");
  EXPECT_EQ(subject("portrait of woman"), "portrait");
  EXPECT_EQ(subject("poster gaming"), "gaming");
  EXPECT_EQ(subject("painting of bird chinese"), "bird");
  EXPECT_EQ(subject("star wars poster"), "film");
  EXPECT_EQ(subject("abstract painting"), "abstract");
  EXPECT_EQ(subject("painting"), "");
}

TEST(Pictures, ThoseOfDifferentThingsDiffer) {
  std::set<Looks> seen;
  for (const char* name : {"painting of the sea", "portrait", "painting of mountains", "flower painting", "horse painting", "city skyline"})
    EXPECT_TRUE(seen.insert(looks(picture_of("painting", name))).second) << name;
}

TEST(Pictures, TwoOfTheSameDiffer) {
  for (const char* name : {"car poster", "film poster", "gaming poster", "football poster", "dinosaur poster", "mountain painting"})
    EXPECT_NE(looks(picture_of("poster", name, "poster_1")), looks(picture_of("poster", name, "poster_2"))) << name;
}

TEST(Pictures, HaveTheThemeOfTheirRoom) {
  EXPECT_EQ(picture_theme("A dinosaur bedroom with a bed and two posters."), "dinosaur");
  EXPECT_EQ(picture_theme("A bedroom for my son. He loves dinosaurs."), "dinosaur");
  EXPECT_EQ(picture_theme("A space-themed nursery with a crib."), picture_theme("A bedroom for an astronaut."));
  EXPECT_NE(picture_theme("A haunted Victorian drawing room.").find("forebear"), std::string::npos);
  EXPECT_EQ(picture_theme("A playroom that looks like a castle.", true).find("forebear"), std::string::npos);
  EXPECT_EQ(picture_theme("A bedroom with a toy dinosaur on the shelf."), "");
  EXPECT_EQ(picture_theme("A living room with space for a sofa."), "");
}

TEST(Pictures, OfADinosaurBedroomAreNotThoseOfAPlainOne) {
  EXPECT_NE(triangles_of(picture_in("A dinosaur bedroom with a poster."), "poster"),
            triangles_of(picture_in("A bedroom with a poster."), "poster"));
}

TEST(Pictures, TapestriesShowTheirSubjectAsWell) {
  EXPECT_NE(looks(picture_of("tapestry", "unicorn tapestry")), looks(picture_of("tapestry", "tapestry")));
  EXPECT_NE(looks(picture_of("tapestry", "macrame wall hanging")), looks(picture_of("tapestry", "tapestry")));
}

TEST(Pictures, WhatADataRowNamesIsDrawn) {
  for (const char* list : {"picture_words", "picture_themes"}) {
    for (const auto& row : decor_data().at(list)) {
      for (const std::string& name : names_in(row.at("show").get<std::string>() + " " + row.value("for_children", "")))
        EXPECT_TRUE(kit::pictures::drawings().contains(name)) << name;
    }
  }
  for (const auto& [rooms, names] : decor_data().at("pictures").items()) {
    for (const std::string& name : names_in(names.get<std::string>())) EXPECT_TRUE(kit::pictures::drawings().contains(name)) << name;
  }
}

// Every subject, thin and thick, upright and wide: closed, within its body.
TEST(Pictures, AreSoundAndStayWithinTheirFrames) {
  for (const auto& row : decor_data().at("picture_words")) {
    const std::string word = row.at("says").front().get<std::string>();
    for (const char* kind : {"poster", "painting", "tapestry"}) {
      for (const bool upright : {true, false}) {
        PlacedObject object = object_of(kind);
        object.name = word + " " + kind;
        if (upright == (object.size.width > object.size.height)) std::swap(object.size.width, object.size.height);
        for (const Node& node : furnished(object).nodes) expect_sound(node, object);
      }
    }
  }
}

}  // namespace
}  // namespace layoutbox
