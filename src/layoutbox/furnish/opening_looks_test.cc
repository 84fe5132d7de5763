// Doors and windows of every look: sound meshes, and what tells one look from another.
#include <gtest/gtest.h>

#include "layoutbox/catalog/word_lists.h"
#include "layoutbox/furnish/furnish.h"
#include "layoutbox/furnish/mesh_checks.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox {
namespace {

Opening opening_of(OpeningType type, std::vector<std::string> words, Swing swing = Swing::kInLeft) {
  Opening opening;
  opening.id = "opening1";
  opening.type = type;
  opening.wall = "wall1";
  opening.offset = 1500;
  opening.attributes = std::move(words);
  opening.swing = type == OpeningType::kDoor ? swing : Swing::kNone;
  if (type == OpeningType::kWindow) opening.width = 1000, opening.height = 1000, opening.sill = 900;
  return opening;
}

Model furnished(const Opening& opening) {
  Layout layout;
  layout.room.height = 2800;
  layout.room.polygon = {{0, 0}, {5000, 0}, {5000, 4000}, {0, 4000}};
  layout.room.walls = walls_along(layout.room.polygon);
  layout.room.openings = {opening};
  const Result<Model> model = furnish(layout, Catalog::builtin());
  EXPECT_TRUE(model);
  return model ? *model : Model{};
}

const Node& opening_node(const Model& model) {
  return *std::ranges::find_if(model.nodes, [](const Node& node) { return node.kind == NodeKind::kOpening; });
}

bool has_surface(const Model& model, std::string_view start) {
  return std::ranges::any_of(opening_node(model).parts, [&](const Part& part) {
    return model.surfaces[static_cast<std::size_t>(part.surface)].name.starts_with(start);
  });
}

TEST(OpeningLooks, EveryWordOfTheTableMakesASoundMesh) {
  for (const OpeningType type : {OpeningType::kDoor, OpeningType::kWindow}) {
    for (const WordList::Member row : word_list("words_openings").at(name_of(type))) {
      for (const WordList::Member phrase : row.value.at("words")) {
        for (const Swing swing : {Swing::kInRight, Swing::kOutLeft, Swing::kSliding, Swing::kNone}) {
          const Model model = furnished(opening_of(type, {std::string(phrase.value.text())}, swing));
          for (const Part& part : opening_node(model).parts) {
            EXPECT_EQ(mesh_checks::open_edges(part.mesh), 0) << phrase.value.text();
            EXPECT_GT(mesh_checks::volume(part.mesh), 0) << phrase.value.text();
          }
        }
      }
    }
  }
}

TEST(OpeningLooks, LeavesAreOfWhatIsSaid) {
  EXPECT_TRUE(has_surface(furnished(opening_of(OpeningType::kDoor, {})), "oak"));
  EXPECT_TRUE(has_surface(furnished(opening_of(OpeningType::kDoor, {"french"})), "glass"));
  EXPECT_TRUE(has_surface(furnished(opening_of(OpeningType::kDoor, {"shoji"}, Swing::kSliding)), "paper"));
  EXPECT_TRUE(has_surface(furnished(opening_of(OpeningType::kDoor, {"steel"})), "steel"));
  const Model red = furnished(opening_of(OpeningType::kDoor, {"red"}));
  EXPECT_FALSE(has_surface(red, "oak"));
  EXPECT_TRUE(has_surface(furnished(opening_of(OpeningType::kWindow, {"frosted"})), "frosted_glass"));
  EXPECT_TRUE(has_surface(furnished(opening_of(OpeningType::kWindow, {"crittall"})), "black_metal"));
}

// A round window leaves of its square what is outside the circle to the wall.
TEST(OpeningLooks, ARoundWindowIsRound) {
  const Model model = furnished(opening_of(OpeningType::kWindow, {"round"}));
  const int wall = std::ranges::find(model.nodes, "wall1", &Node::id)->parts.front().surface;
  const auto piece = std::ranges::find(opening_node(model).parts, wall, &Part::surface);
  ASSERT_NE(piece, opening_node(model).parts.end());
  EXPECT_NEAR(mesh_checks::volume(piece->mesh), (1 - kPi / 4) * 0.1, 1e-3);
}

TEST(OpeningLooks, ABarnDoorHangsInTheRoom) {
  const kit::Box b = mesh_checks::bounds_of(opening_node(furnished(opening_of(OpeningType::kDoor, {"barn"}, Swing::kSliding))));
  EXPECT_GT(b.max.y, 0.05);
  EXPECT_GT(b.size().x, 1.6);  // the rail
}

}  // namespace
}  // namespace layoutbox
