// Each pass over a text against its own example.
#include "layoutbox/plan/offline/text_passes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/plan/planner.h"
#include "layoutbox/scene/relation_table.h"

namespace layoutbox::offline {
namespace {

// What a text asks for: things by name and relations by the names of what they join, in no order.
std::string asked_for(const std::string& text) {
  static const std::unique_ptr<Planner> kPlanner = make_offline_planner(Catalog::builtin());
  const auto plan = kPlanner->plan(text, {});
  if (!plan) return plan.error().message;
  const SceneGraph& scene = plan->scene;
  std::vector<std::string> lines;
  const auto name_of = [&](const std::string& id) {
    const auto object = std::ranges::find(scene.objects, id, &SceneObject::id);
    return object == scene.objects.end() ? id : object->category;
  };
  for (const SceneObject& object : scene.objects) lines.push_back(object.category);
  for (const Relation& relation : scene.relations) {
    if (relation.origin == Origin::kAssumed) continue;
    std::string line{relation_row(relation.type).name};
    for (const std::string& id : relation.targets) line += " " + name_of(id);
    line += " >";
    for (const std::string& id : relation.references) line += " " + name_of(id);
    lines.push_back(line);
  }
  std::ranges::sort(lines);
  std::string all;
  for (const std::string& line : lines) all += line + "\n";
  return all;
}

template <class Pass>
void expect_examples_read_as_plain(std::span<const Pass> passes) {
  for (const Pass& pass : passes) {
    EXPECT_EQ(asked_for(std::string(pass.example)), asked_for(std::string(pass.plain))) << pass.name << ": " << pass.example;
    EXPECT_NE(pass.example, pass.plain) << pass.name;
  }
}

TEST(TextPasses, WordPassesReadTheirExamplesAsThePlainText) { expect_examples_read_as_plain(word_passes()); }

TEST(TextPasses, PhrasePassesReadTheirExamplesAsThePlainText) { expect_examples_read_as_plain(phrase_passes()); }

TEST(TextPasses, EachHasANameOfItsOwn) {
  std::vector<std::string_view> names;
  for (const WordPass& pass : word_passes()) names.push_back(pass.name);
  for (const PhrasePass& pass : phrase_passes()) names.push_back(pass.name);
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

}  // namespace
}  // namespace layoutbox::offline
