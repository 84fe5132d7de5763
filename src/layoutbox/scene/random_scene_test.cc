#include "layoutbox/scene/random_scene.h"

#include <gtest/gtest.h>

#include <random>

#include "layoutbox/scene/scene_json.h"

namespace layoutbox {
namespace {

// Files are the same when they were written from the same value, so that text compares whole values and shows what differs.
TEST(RandomFiles, ScenesComeBackAsTheyWere) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const SceneGraph scene = RandomScenes(seed).scene();
    const std::string text = write_scene(scene);
    const auto again = read_scene(text);
    ASSERT_TRUE(again) << "seed " << seed << ": " << again.error().message << " " << again.error().pointer << "\n" << text;
    ASSERT_EQ(write_scene(*again), text) << "seed " << seed;
    ASSERT_EQ(again->objects.size(), scene.objects.size());
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      const SceneObject &a = scene.objects[i], &b = again->objects[i];
      ASSERT_EQ(a.size, b.size) << "seed " << seed;
      ASSERT_EQ(a.mount, b.mount);
      ASSERT_EQ(a.mount_assumed, b.mount_assumed);
      ASSERT_EQ(a.origin, b.origin);
      ASSERT_EQ(a.used_sides, b.used_sides);
      ASSERT_EQ(a.fixed, b.fixed);
      ASSERT_EQ(a.name, b.name);
      ASSERT_EQ(a.hint.rotation_deg, b.hint.rotation_deg);
      ASSERT_EQ(a.hint.position.has_value(), b.hint.position.has_value());
      for (std::size_t k = 0; a.hint.position && k < 3; ++k) ASSERT_NEAR((*a.hint.position)[k], (*b.hint.position)[k], 1e-6);
    }
    ASSERT_EQ(again->room.polygon, scene.room.polygon);
    ASSERT_EQ(again->room.openings.size(), scene.room.openings.size());
  }
}

TEST(RandomFiles, LayoutsComeBackAsTheyWere) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Layout layout = RandomScenes(seed).layout();
    const std::string text = write_layout(layout);
    const auto again = read_layout(text);
    ASSERT_TRUE(again) << "seed " << seed << ": " << again.error().message << " " << again.error().pointer << "\n" << text;
    ASSERT_EQ(write_layout(*again), text) << "seed " << seed;
    ASSERT_EQ(again->objects.size(), layout.objects.size());
    for (std::size_t i = 0; i < layout.objects.size(); ++i) {
      const PlacedObject &a = layout.objects[i], &b = again->objects[i];
      ASSERT_EQ(a.size, b.size) << "seed " << seed;
      ASSERT_EQ(a.supported_by, b.supported_by);
      ASSERT_EQ(a.origin, b.origin);
      ASSERT_EQ(a.used_sides, b.used_sides);
      ASSERT_EQ(a.spaces.size(), b.spaces.size());
      for (std::size_t k = 0; k < 3; ++k) ASSERT_NEAR(a.position[k], b.position[k], 1e-6);
      ASSERT_NEAR(a.rotation_deg, b.rotation_deg, 1e-9);
    }
    ASSERT_EQ(again->relations.size(), layout.relations.size());
    for (std::size_t i = 0; i < layout.relations.size(); ++i) {
      ASSERT_EQ(again->relations[i].relation.type, layout.relations[i].relation.type);
      ASSERT_EQ(again->relations[i].held, layout.relations[i].held);
      ASSERT_EQ(again->relations[i].relation.origin, layout.relations[i].relation.origin);
      ASSERT_EQ(again->relations[i].relation.parameters.distance, layout.relations[i].relation.parameters.distance);
    }
    ASSERT_EQ(again->status, layout.status);
    ASSERT_EQ(again->gave_way.size(), layout.gave_way.size());
    ASSERT_EQ(again->stats.proven, layout.stats.proven);
  }
}

// Bytes changed, cut out and doubled anywhere: whatever comes back, it comes back, and an error says something.
TEST(RandomFiles, BrokenFilesNeverDoHarm) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    std::mt19937_64 random(seed);
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    const bool is_scene = seed % 2 == 0;
    std::string text = is_scene ? write_scene(RandomScenes(seed).scene()) : write_layout(RandomScenes(seed).layout());
    static constexpr std::string_view kBits[] = {"null", "{}", "[]",       "-1",   "1e300", "\"x\"", "true", "0",
                                                 ",",    "}",  "\"id\": ", "[[[[", "\xFF",  "NaN",   "4.5",  "\"wall1\""};
    for (std::size_t change = 1 + below(4); change > 0; --change) {
      const std::size_t place = below(text.size());
      const std::size_t length = std::min(below(12), text.size() - place);
      switch (below(3)) {
        case 0: text.replace(place, length, kBits[below(std::size(kBits))]); break;
        case 1: text.insert(place, text.substr(below(text.size()), below(60))); break;
        default: {
          // A whole value: the text after a colon, up to the comma.
          const std::size_t colon = text.find(": ", place), comma = text.find_first_of(",}]", colon);
          if (colon != std::string::npos && comma != std::string::npos)
            text.replace(colon + 2, comma - colon - 2, kBits[below(std::size(kBits))]);
        }
      }
    }
    const auto check = [&](const auto& result) {
      if (result) return;
      EXPECT_FALSE(result.error().message.empty()) << "seed " << seed;
      EXPECT_NE(result.error().code, ErrorCode::kInternal) << "seed " << seed << ": " << result.error().message << "\n" << text;
    };
    check(read_scene(text));
    check(read_layout(text));
    check(read_room(text));
    check(kind_of_document(text));
  }
}

}  // namespace
}  // namespace layoutbox
