// The solver against brute force on tiny rooms, in cells of half a metre: what can be is found, what cannot be is proven, and what is named
// as a conflict is one, and a smallest.
//
//   LAYOUTBOX_RANDOM_ROUNDS  a fourth of the rooms (default 100)
//   LAYOUTBOX_RANDOM_SEED    of the first room (default 1)
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_judge.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

struct Cell {
  int x, y, turn;
};

// What two pieces, or a piece and wall `a` (front, right, back, left), may have to do with one another.
enum class Kind { kBackToWall, kOffWall, kOffsetX, kOffsetY, kParallel, kPerpendicular, kSameTurn, kAlignLeft, kAlignBack, kCount };

struct TinyRelation {
  Kind kind = Kind::kParallel;
  int target = 0, reference = 0, a = 0;  // a: a wall, or so many cells
  bool of_wall() const { return kind == Kind::kBackToWall || kind == Kind::kOffWall; }
};

struct TinyRoom {
  int width = 0, depth = 0;
  std::vector<std::pair<int, int>> sizes;
  std::vector<TinyRelation> relations;
};

struct Rectangle {
  int x0, y0, x1, y1;
};

Rectangle rectangle(const TinyRoom& s, int i, const Cell& c) {
  const bool across = c.turn % 2 == 1;
  const int w = across ? s.sizes[i].second : s.sizes[i].first, d = across ? s.sizes[i].first : s.sizes[i].second;
  return {c.x, c.y, c.x + w, c.y + d};
}

bool holds(const TinyRoom& s, const TinyRelation& r, const std::vector<Cell>& at) {
  const Rectangle t = rectangle(s, r.target, at[r.target]), o = rectangle(s, r.reference, at[r.reference]);
  const int turn = at[r.target].turn - at[r.reference].turn;
  const auto gap = [](int lo, int hi, int lo2, int hi2) { return std::max(lo - hi2, lo2 - hi); };
  const int off_wall[4] = {t.y0, s.width - t.x1, s.depth - t.y1, t.x0};
  switch (r.kind) {
    case Kind::kBackToWall: {
      const int turns[4] = {2, 3, 0, 1};
      return at[r.target].turn == turns[r.a] && off_wall[r.a] == 0;
    }
    case Kind::kOffWall: return off_wall[r.a] == 1;
    case Kind::kOffsetX: return gap(t.x0, t.x1, o.x0, o.x1) == r.a;
    case Kind::kOffsetY: return gap(t.y0, t.y1, o.y0, o.y1) == r.a;
    case Kind::kParallel: return turn % 2 == 0;
    case Kind::kPerpendicular: return turn % 2 != 0;
    case Kind::kSameTurn: return turn == 0;
    case Kind::kAlignLeft: return t.x0 == o.x0;
    default: return t.y1 == o.y1;
  }
}

// Some of the pieces and some of the relations.
struct Part {
  std::vector<char> pieces, relations;
};

// Is there a layout of that part?
bool exists(const TinyRoom& s, const Part& part, std::vector<Cell>& at) {
  const int i = static_cast<int>(at.size());
  if (i == static_cast<int>(s.sizes.size())) return true;
  if (!part.pieces[i]) {
    at.push_back({0, 0, 0});
    const bool found = exists(s, part, at);
    at.pop_back();
    return found;
  }
  for (int turn = 0; turn < 4; ++turn) {
    for (int x = 0; x <= s.width; ++x) {
      for (int y = 0; y <= s.depth; ++y) {
        at.push_back({x, y, turn});
        const Rectangle r = rectangle(s, i, at.back());
        bool good = r.x1 <= s.width && r.y1 <= s.depth;
        for (int j = 0; j < i && good; ++j) {
          const Rectangle o = rectangle(s, j, at[j]);
          good = !part.pieces[j] || r.x1 <= o.x0 || o.x1 <= r.x0 || r.y1 <= o.y0 || o.y1 <= r.y0;
        }
        for (std::size_t k = 0; k < s.relations.size() && good; ++k) {
          const TinyRelation& relation = s.relations[k];
          if (part.relations[k] && std::max(relation.target, relation.reference) == i) good = holds(s, relation, at);
        }
        const bool found = good && exists(s, part, at);
        at.pop_back();
        if (found) return true;
      }
    }
  }
  return false;
}

bool exists(const TinyRoom& s, const Part& part) {
  std::vector<Cell> at;
  return exists(s, part, at);
}

Part all_of(const TinyRoom& s) { return {std::vector<char>(s.sizes.size(), 1), std::vector<char>(s.relations.size(), 1)}; }

std::string id_of(int i) { return "wardrobe_" + std::to_string(i + 1); }

SceneGraph as_scene(const TinyRoom& s) {
  SceneMaker maker(s.width * 500, s.depth * 500);
  for (const auto& [w, d] : s.sizes) {
    maker.add("wardrobe").sized(w * 500, d * 500, 2000);
    maker.raw().objects.back().spaces_given = true;
  }
  for (const TinyRelation& r : s.relations) {
    const std::string t = id_of(r.target), o = r.of_wall() ? "wall" + std::to_string(r.a + 1) : id_of(r.reference);
    RelationParameters p;
    switch (r.kind) {
      case Kind::kBackToWall: p.gap = 0, maker.relate("againstWall", {t}, {o}, p); break;
      case Kind::kOffWall: p.distance = 500, maker.relate("offset", {t}, {o}, p); break;
      case Kind::kOffsetX: p.axis = Axis::kX, p.distance = r.a * 500, maker.relate("offset", {t}, {o}, p); break;
      case Kind::kOffsetY: p.axis = Axis::kY, p.distance = r.a * 500, maker.relate("offset", {t}, {o}, p); break;
      case Kind::kParallel: maker.relate("parallel", {t}, {o}); break;
      case Kind::kPerpendicular: maker.relate("perpendicular", {t}, {o}); break;
      case Kind::kSameTurn: maker.relate("sameOrientation", {t}, {o}); break;
      case Kind::kAlignLeft: p.axis = Axis::kX, p.edge = Edge::kMin, maker.relate("align", {t}, {o}, p); break;
      default: p.axis = Axis::kY, p.edge = Edge::kMax, maker.relate("align", {t}, {o}, p); break;
    }
  }
  return maker.make();
}

TinyRoom random_room(std::uint64_t seed) {
  std::mt19937 random(static_cast<unsigned>(seed * 7919 + 20240607));
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  TinyRoom s;
  s.width = 3 + below(3), s.depth = 2 + below(3);
  const int n = 2 + below(2);
  for (int i = 0; i < n; ++i) s.sizes.push_back({1 + below(3), 1 + below(2)});
  for (int i = 0, count = n + below(2); i < count; ++i) {
    TinyRelation r;
    r.kind = static_cast<Kind>(below(static_cast<int>(Kind::kCount)));
    r.target = i % n, r.reference = (r.target + 1 + below(n - 1)) % n;
    r.a = r.of_wall() ? below(4) : below(2);
    if (r.of_wall()) r.reference = r.target;
    s.relations.push_back(r);
  }
  return s;
}

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* value = std::getenv(name);
  return value != nullptr ? std::strtoull(value, nullptr, 10) : otherwise;
}

bool names(const std::vector<std::string>& ids, const std::string& id) { return std::find(ids.begin(), ids.end(), id) != ids.end(); }

// The conflict's own members, less the one named, with the pieces that its relations speak of.
Part part_of(const TinyRoom& s, const Conflict& conflict, const std::string& without) {
  Part part{std::vector<char>(s.sizes.size(), 0), std::vector<char>(s.relations.size(), 0)};
  for (std::size_t i = 0; i < s.sizes.size(); ++i) part.pieces[i] = names(conflict.objects, id_of(static_cast<int>(i)));
  for (std::size_t k = 0; k < s.relations.size(); ++k) {
    if (!names(conflict.relations, "c" + std::to_string(k + 1))) continue;
    part.relations[k] = true;
    part.pieces[s.relations[k].target] = part.pieces[s.relations[k].reference] = true;
  }
  for (std::size_t i = 0; i < s.sizes.size(); ++i) {
    if (id_of(static_cast<int>(i)) == without) part.pieces[i] = false;
  }
  for (std::size_t k = 0; k < s.relations.size(); ++k) {
    const bool there = part.pieces[s.relations[k].target] && part.pieces[s.relations[k].reference];
    if ("c" + std::to_string(k + 1) == without || !there) part.relations[k] = false;
  }
  return part;
}

// Impossible as it is, and possible without any one of its members.
void expect_smallest(const TinyRoom& s, const Conflict& conflict, int& members) {
  EXPECT_FALSE(exists(s, part_of(s, conflict, ""))) << conflict.sentence << ": alone it can be";
  if (!conflict.minimal) return;
  for (const auto* ids : {&conflict.relations, &conflict.objects}) {
    for (const std::string& id : *ids) {
      ++members;
      EXPECT_TRUE(exists(s, part_of(s, conflict, id))) << conflict.sentence << ": cannot be without " << id << " either";
    }
  }
}

TEST(PropertyBruteForce, AgreesOnTinyRooms) {
  if (!describe_cp_sat_library()) GTEST_SKIP() << "no CP-SAT library: run scripts/setup.sh";
  const std::uint64_t rounds = 4 * from_environment("LAYOUTBOX_RANDOM_ROUNDS", 100), first = from_environment("LAYOUTBOX_RANDOM_SEED", 1);
  int possible = 0, impossible = 0, conflicts = 0, minimal = 0, members = 0;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const TinyRoom s = random_room(seed);
    const SceneGraph scene = as_scene(s);
    const bool expected = exists(s, all_of(s));
    (expected ? possible : impossible)++;
    SolveOptions options;
    options.improve = false;
    const auto layout = solve(scene, Catalog::builtin(), options);
    ASSERT_TRUE(layout) << layout.error().message;
    EXPECT_EQ(layout->status == LayoutStatus::kSolved, expected) << (layout->conflicts.empty() ? "" : layout->conflicts[0].sentence);
    if (seed % 8 == 0) expect_sound(*layout);
    if (expected) continue;
    ASSERT_FALSE(layout->conflicts.empty());
    // The first is of the scene as it is; those after it are of what is left of it, and smallest in that.
    const Conflict& conflict = layout->conflicts[0];
    ++conflicts, minimal += conflict.minimal;
    expect_smallest(s, conflict, members);
    options.on_conflict = OnConflict::kFail;
    const auto refused = solve(scene, Catalog::builtin(), options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::kInfeasible) << refused.error().message;
  }
  std::printf("%d rooms with a layout, %d without; %d conflicts, %d of them smallest, of %d members\n", possible, impossible, conflicts,
              minimal, members);
  EXPECT_GT(possible, static_cast<int>(rounds) / 6);
  EXPECT_GT(impossible, static_cast<int>(rounds) / 6);
  EXPECT_GE(minimal * 10, conflicts * 9) << "conflicts are hardly ever shown to be smallest";
}

// Rooms with nothing but too many pieces: what is named is too many, and no fewer would be.
TEST(PropertyBruteForce, CrowdsAreSmallest) {
  if (!describe_cp_sat_library()) GTEST_SKIP() << "no CP-SAT library: run scripts/setup.sh";
  const std::uint64_t rounds = from_environment("LAYOUTBOX_RANDOM_ROUNDS", 100), first = from_environment("LAYOUTBOX_RANDOM_SEED", 1);
  int conflicts = 0, minimal = 0, members = 0;
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(static_cast<unsigned>(seed * 104729 + 7));
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    TinyRoom s;
    s.width = 3 + below(2), s.depth = 2 + below(2);
    for (int i = 0, n = 3 + below(2); i < n; ++i) s.sizes.push_back({1 + below(3), 1 + below(2)});
    if (exists(s, all_of(s))) continue;
    SolveOptions options;
    options.improve = false;
    options.on_conflict = seed % 2 == 0 ? OnConflict::kFail : OnConflict::kRelax;
    const auto layout = solve(as_scene(s), Catalog::builtin(), options);
    if (options.on_conflict == OnConflict::kFail) {
      ASSERT_FALSE(layout);
      EXPECT_EQ(layout.error().code, ErrorCode::kInfeasible) << layout.error().message;
      continue;
    }
    ASSERT_TRUE(layout) << layout.error().message;
    ASSERT_FALSE(layout->conflicts.empty());
    ++conflicts, minimal += layout->conflicts[0].minimal;
    expect_smallest(s, layout->conflicts[0], members);
  }
  std::printf("%d crowds, %d of them smallest, of %d members\n", conflicts, minimal, members);
  EXPECT_GT(conflicts, static_cast<int>(rounds) / 10);
  EXPECT_EQ(minimal, conflicts) << "a crowd is said to be no more than enough";
}

// One by a size, one by a sum of widths, one by a proof.
TEST(PropertyConflicts, ThreeKindsAreAllNamed) {
  if (!describe_cp_sat_library()) GTEST_SKIP() << "no CP-SAT library: run scripts/setup.sh";
  SceneMaker maker(7000, 6000);
  maker.add("table").sized(7500, 6500, 700);
  maker.add("bed").sized(2600, 2000, 500).add("wardrobe").sized(4800, 600, 2000);
  maker.relate("againstWall", {"bed_1"}, {"wall3"}).relate("againstWall", {"wardrobe_1"}, {"wall3"});
  maker.add("sofa").add("plant").relate("leftOf", {"plant_1"}, {"sofa_1"}).relate("rightOf", {"plant_1"}, {"sofa_1"});
  const auto layout = solve(maker.make(), Catalog::builtin());
  ASSERT_TRUE(layout) << layout.error().message;
  ASSERT_EQ(layout->conflicts.size(), 3u);
  const auto named = [&](std::vector<std::string> relations, const std::string& object) {
    return std::any_of(layout->conflicts.begin(), layout->conflicts.end(), [&](const Conflict& c) {
      return c.minimal && c.relations == relations && (object.empty() || names(c.objects, object));
    });
  };
  EXPECT_TRUE(named({}, "table_1"));
  EXPECT_TRUE(std::any_of(layout->conflicts.begin(), layout->conflicts.end(), [&](const Conflict& c) {
    return c.minimal && names(c.relations, "c1") && names(c.relations, "c2") && names(c.objects, "wardrobe_1");
  }));
  EXPECT_TRUE(named({"c3", "c4"}, ""));
  SolveOptions options;
  options.on_conflict = OnConflict::kFail;
  const auto refused = solve(maker.make(), Catalog::builtin(), options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().details.size(), 3u);
}

// Pairs of pieces in one large room, each pair with an impossible wish of its own.
TEST(PropertyConflicts, IndependentOnesAreAllNamed) {
  if (!describe_cp_sat_library()) GTEST_SKIP() << "no CP-SAT library: run scripts/setup.sh";
  using Pair = std::pair<const char*, const char*>;
  const std::vector<Pair> kClashing{{"leftOf", "rightOf"}, {"inFrontOf", "behind"}, {"parallel", "perpendicular"},
                                    {"nextTo", "far"},     {"touching", "near"},    {"sameOrientation", "perpendicular"}};
  const std::uint64_t rounds = from_environment("LAYOUTBOX_RANDOM_ROUNDS", 100) / 10, first = from_environment("LAYOUTBOX_RANDOM_SEED", 1);
  for (std::uint64_t seed = first; seed < first + rounds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(static_cast<unsigned>(seed));
    const std::size_t count = 2 + random() % 3;
    SceneMaker maker(9000, 8000);
    std::vector<Pair> wishes;
    for (std::size_t k = 0; k < count; ++k) {
      const std::string a = "desk_" + std::to_string(k + 1), b = "sofa_" + std::to_string(k + 1);
      wishes.push_back(kClashing[random() % kClashing.size()]);
      maker.add("desk").add("sofa").relate(wishes.back().first, {a}, {b}).relate(wishes.back().second, {a}, {b});
    }
    SolveOptions options;
    options.improve = false;
    options.seed = seed;
    const auto layout = solve(maker.make(), Catalog::builtin(), options);
    ASSERT_TRUE(layout) << layout.error().message;
    EXPECT_EQ(layout->conflicts.size(), count);
    for (std::size_t k = 0; k < count; ++k) {
      const std::vector<std::string> both{"c" + std::to_string(2 * k + 1), "c" + std::to_string(2 * k + 2)};
      const bool named = std::any_of(layout->conflicts.begin(), layout->conflicts.end(), [&](const Conflict& conflict) {
        return conflict.minimal && std::is_permutation(both.begin(), both.end(), conflict.relations.begin(), conflict.relations.end());
      });
      EXPECT_TRUE(named) << wishes[k].first << " and " << wishes[k].second;
    }
    options.on_conflict = OnConflict::kFail;
    const auto refused = solve(maker.make(), Catalog::builtin(), options);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().details.size(), count) << "all of them are details of the error";
  }
}

}  // namespace
}  // namespace layoutbox::placement
