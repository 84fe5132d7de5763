// Against brute force on tiny rooms, and on random scenes against a judge that shares no code.
#include <gtest/gtest.h>

#include <random>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

// ------------------------------------------------------------------------------------- brute force, in cells of half a metre

struct Cell {
  int x, y, turn;
};

struct TinyRelation {
  int kind = 0;  // 0 back against wall `a`; 1 offset of `a` cells along x; 2 along y; 3 parallel; 4 aligned low edges along x
  int target = 0, reference = 0, a = 0;
};

struct TinyScene {
  int width = 0, depth = 0;
  std::vector<std::pair<int, int>> sizes;
  std::vector<TinyRelation> relations;
};

struct Rectangle {
  int x0, y0, x1, y1;
};

Rectangle rectangle(const TinyScene& s, int i, const Cell& c) {
  const bool across = c.turn % 2 == 1;
  const int w = across ? s.sizes[i].second : s.sizes[i].first, d = across ? s.sizes[i].first : s.sizes[i].second;
  return {c.x, c.y, c.x + w, c.y + d};
}

bool holds(const TinyScene& s, const TinyRelation& r, const std::vector<Cell>& at) {
  const Rectangle t = rectangle(s, r.target, at[r.target]), o = rectangle(s, r.reference, at[r.reference]);
  const auto gap = [](int lo, int hi, int lo2, int hi2) { return std::max(lo - hi2, lo2 - hi); };
  switch (r.kind) {
    case 0: {
      const int turns[4] = {2, 3, 0, 1};  // front, right, back, left wall
      const bool touches[4] = {t.y0 == 0, t.x1 == s.width, t.y1 == s.depth, t.x0 == 0};
      return at[r.target].turn == turns[r.a] && touches[r.a];
    }
    case 1: return gap(t.x0, t.x1, o.x0, o.x1) == r.a;
    case 2: return gap(t.y0, t.y1, o.y0, o.y1) == r.a;
    case 3: return (at[r.target].turn - at[r.reference].turn) % 2 == 0;
    default: return t.x0 == o.x0;
  }
}

bool exists(const TinyScene& s, std::vector<Cell>& at) {
  const int i = static_cast<int>(at.size());
  if (i == static_cast<int>(s.sizes.size())) return true;
  for (int turn = 0; turn < 4; ++turn) {
    for (int x = 0; x <= s.width; ++x) {
      for (int y = 0; y <= s.depth; ++y) {
        at.push_back({x, y, turn});
        const Rectangle r = rectangle(s, i, at.back());
        bool good = r.x1 <= s.width && r.y1 <= s.depth;
        for (int j = 0; j < i && good; ++j) {
          const Rectangle o = rectangle(s, j, at[j]);
          good = r.x1 <= o.x0 || o.x1 <= r.x0 || r.y1 <= o.y0 || o.y1 <= r.y0;
        }
        for (const TinyRelation& relation : s.relations) {
          if (good && std::max(relation.target, relation.reference) == i) good = holds(s, relation, at);
        }
        if (good && exists(s, at)) return true;
        at.pop_back();
      }
    }
  }
  return false;
}

SceneGraph as_scene(const TinyScene& s) {
  SceneMaker maker(s.width * 500, s.depth * 500);
  for (const auto& [w, d] : s.sizes) {
    maker.add("wardrobe").sized(w * 500, d * 500, 2000);
    maker.raw().objects.back().spaces_given = true;
  }
  const auto id = [](int i) { return "wardrobe_" + std::to_string(i + 1); };
  for (const TinyRelation& r : s.relations) {
    RelationParameters p;
    switch (r.kind) {
      case 0: p.gap = 0, maker.relate("againstWall", {id(r.target)}, {"wall" + std::to_string(r.a + 1)}, p); break;
      case 1: p.axis = Axis::kX, p.distance = r.a * 500, maker.relate("offset", {id(r.target)}, {id(r.reference)}, p); break;
      case 2: p.axis = Axis::kY, p.distance = r.a * 500, maker.relate("offset", {id(r.target)}, {id(r.reference)}, p); break;
      case 3: maker.relate("parallel", {id(r.target)}, {id(r.reference)}); break;
      default: p.axis = Axis::kX, p.edge = "min", maker.relate("align", {id(r.target)}, {id(r.reference)}, p); break;
    }
  }
  return maker.make();
}

TEST(BruteForce, AgreesOnTinyRooms) {
  if (!describe_cp_sat_library()) GTEST_SKIP() << "no CP-SAT library: run scripts/setup.sh";
  std::mt19937 random(20240607);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  int possible = 0, impossible = 0;
  for (int round = 0; round < 600; ++round) {
    TinyScene s;
    s.width = 3 + below(3), s.depth = 2 + below(3);
    const int n = 2 + below(2);
    for (int i = 0; i < n; ++i) s.sizes.push_back({1 + below(3), 1 + below(2)});
    for (int i = 0; i < n; ++i) {
      TinyRelation r;
      r.kind = below(5), r.target = i, r.reference = (i + 1 + below(n - 1)) % n, r.a = r.kind == 0 ? below(4) : below(2);
      s.relations.push_back(r);
    }
    std::vector<Cell> at;
    const bool expected = exists(s, at);
    (expected ? possible : impossible)++;
    SolveOptions options;
    options.on_conflict = OnConflict::kFail;
    options.improve = false;
    const auto layout = solve(as_scene(s), Catalog::builtin(), options);
    if (expected) {
      EXPECT_TRUE(layout) << "round " << round << ": " << layout.error().message;
      if (layout) expect_sound(*layout);
    } else {
      ASSERT_FALSE(layout) << "round " << round << " has no layout";
      EXPECT_EQ(layout.error().code, ErrorCode::kInfeasible) << "round " << round << ": " << layout.error().message;
    }
  }
  EXPECT_GT(possible, 100);
  EXPECT_GT(impossible, 100);
}

// ------------------------------------------------------------------------------------------------------------- random scenes

TEST(RandomScenes, AreSoundAndClaimTruly) {
  const std::vector<std::string> kinds{"bed",   "desk",  "chair",    "sofa",       "wardrobe", "bookshelf",
                                       "plant", "table", "armchair", "nightstand", "rug",      "floor_lamp"};
  const std::vector<std::string> pairs{"leftOf", "rightOf", "inFrontOf", "nextTo", "near", "behind", "parallel", "facing", "perpendicular"};
  const std::vector<std::string> rooms{"againstWall", "corner", "inRegion"};
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const auto below = [&](std::size_t n) { return random() % n; };
    SceneMaker maker(static_cast<Mm>(3000 + 100 * below(40)), static_cast<Mm>(2500 + 100 * below(30)));
    for (std::size_t i = 0, n = 2 + below(8); i < n; ++i) maker.add(kinds[below(kinds.size())]);
    const std::vector<SceneObject> objects = maker.raw().objects;
    for (std::size_t i = 0; i < objects.size(); ++i) {
      RelationParameters p;
      p.region = below(2) ? "left" : "back";
      if (below(3) == 0) maker.relate(rooms[below(rooms.size())], {objects[i].id}, {}, p);
      if (i > 0 && below(2) == 0) maker.relate(pairs[below(pairs.size())], {objects[i].id}, {objects[below(i)].id});
    }
    SolveOptions options;
    options.seed = seed;
    const auto layout = solve(maker.make(true), Catalog::builtin(), options);
    ASSERT_TRUE(layout) << "seed " << seed << ": " << layout.error().message;
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_sound(*layout);
    std::size_t given_up = 0;
    for (const PlacedRelation& r : layout->relations) given_up += r.relation.hard && !r.held;
    EXPECT_LE(given_up, layout->relaxed.size()) << "a relation that does not hold is not listed";
    if (layout->status == LayoutStatus::kSolved) {
      EXPECT_EQ(layout->objects.size(), objects.size());
    }
  }
}

TEST(ManyObjects, AHundredChairsInAHall) {
  const auto layout = solve(SceneMaker(14000, 12000).add("chair", 100).make(true), Catalog::builtin());
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->objects.size(), 100u);
}

TEST(OtherRooms, AnLShapeKeepsItsNotchFree) {
  const auto layout = solve(SceneMaker(std::vector<Point>{{0, 0}, {5000, 0}, {5000, 2500}, {2500, 2500}, {2500, 4500}, {0, 4500}})
                                .add("bed")
                                .add("sofa")
                                .add("wardrobe")
                                .add("desk")
                                .add("plant", 3)
                                .relate("corner", {"plant_1"})
                                .make(true),
                            Catalog::builtin());
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->status, LayoutStatus::kSolved);
  for (const PlacedObject& o : layout->objects) {
    for (const TestPoint& p : points_of(o, 6)) EXPECT_FALSE(p.x > 2501 && p.y > 2501) << o.id << " stands in the notch";
  }
}

// A round room as a polygon: windows and doors in its walls at an angle are kept free.
TEST(OtherRooms, OpeningsInWallsAtAnAngle) {
  const std::vector<Point> octagon{{1500, 0}, {3500, 0}, {5000, 1500}, {5000, 3500}, {3500, 5000}, {1500, 5000}, {0, 3500}, {0, 1500}};
  for (const std::optional<Mm> offset : {std::optional<Mm>(300), std::optional<Mm>()}) {
    const auto layout = solve(SceneMaker(octagon)
                                  .opening(OpeningType::kWindow, "wall2", offset, 1000, 900, 1200)
                                  .opening(OpeningType::kDoor, "wall4", offset)
                                  .add("bed")
                                  .add("wardrobe")
                                  .add("desk")
                                  .make(true),
                              Catalog::builtin());
    ASSERT_TRUE(layout);
    EXPECT_EQ(layout->status, LayoutStatus::kSolved);
    ASSERT_EQ(layout->room.openings.size(), 2u);
    for (const Opening& opening : layout->room.openings) EXPECT_TRUE(opening.offset) << opening.id;
    EXPECT_EQ(layout->room.openings[1].wall, "wall4");
  }
  // Where no wall runs along x or y, openings without a place take one all the same.
  const auto diamond = solve(SceneMaker(std::vector<Point>{{3000, 0}, {6000, 3000}, {3000, 6000}, {0, 3000}})
                                 .opening(OpeningType::kDoor, "", std::nullopt)
                                 .add("table")
                                 .make(true),
                             Catalog::builtin());
  ASSERT_TRUE(diamond);
  EXPECT_FALSE(diamond->room.openings[0].wall.empty());
}

}  // namespace
}  // namespace layoutbox::placement
