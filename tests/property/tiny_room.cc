#include "tiny_room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

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

std::string id_of(int i) { return "wardrobe_" + std::to_string(i + 1); }

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

}  // namespace

Part all_of(const TinyRoom& s) { return {std::vector<char>(s.sizes.size(), 1), std::vector<char>(s.relations.size(), 1)}; }

bool exists(const TinyRoom& s, const Part& part) {
  std::vector<Cell> at;
  return exists(s, part, at);
}

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

}  // namespace layoutbox::placement
