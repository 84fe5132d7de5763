// The planner that reads by itself, for tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/plan/planner.h"

namespace layoutbox {

class OfflinePlannerTest : public testing::Test {
 protected:
  Plan plan(std::string_view text) const {
    auto result = planner_->plan(text, {});
    EXPECT_TRUE(result.has_value()) << text;
    return result ? std::move(*result) : Plan{};
  }
  SceneGraph scene(std::string_view text) const { return plan(text).scene; }
  static bool notes(const SceneGraph& scene, std::string_view code) {
    return std::any_of(scene.notes.begin(), scene.notes.end(), [&](const Note& note) { return note.code == code; });
  }
  // The kinds of all that is asked for.
  static std::multiset<std::string> types_of(const SceneGraph& scene) {
    std::multiset<std::string> types;
    for (const SceneObject& object : scene.objects) types.insert(object.category);
    return types;
  }
  static std::vector<Point> rectangle(double w, double d) {
    return {{0, 0}, {mm_from_m(w), 0}, {mm_from_m(w), mm_from_m(d)}, {0, mm_from_m(d)}};
  }

  std::unique_ptr<Planner> planner_ = make_offline_planner(Catalog::builtin());
};

}  // namespace layoutbox
