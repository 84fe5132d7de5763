// The list of terms: shares and bounds agree with the whole, and docs/solve.md has them all.
#include "layoutbox/solve/objective/terms.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>

#include "layoutbox/solve/objective/known_costs.h"
#include "layoutbox/solve/search/search.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

constexpr unsigned kScenes = 40, kMoves = 40;
constexpr std::int64_t kSteps = 60'000;
constexpr std::int64_t kNoLoss = std::numeric_limits<std::int64_t>::min();

class ShuffledRoom {
 public:
  explicit ShuffledRoom(unsigned seed) : random_(seed) {
    const std::vector<std::string> kinds{"bed",   "desk",  "chair",    "sofa",       "wardrobe", "bookshelf", "table_lamp",
                                         "plant", "table", "armchair", "nightstand", "rug",      "painting",  "ceiling_lamp"};
    const std::vector<std::string> pairs{"leftOf", "nextTo", "near", "behind", "facing", "reachable"};
    SceneMaker maker(static_cast<Mm>(3000 + 100 * below(40)), static_cast<Mm>(2500 + 100 * below(30)));
    for (std::size_t i = 0, n = 3 + below(8); i < n; ++i) maker.add(kinds[below(kinds.size())]);
    const std::vector<SceneObject> objects = maker.raw().objects;
    for (std::size_t i = 1; i < objects.size(); ++i) {
      if (below(2) == 0) continue;
      const std::string& type = pairs[below(pairs.size())];
      maker.relate(type, {objects[i].id}, type == "reachable" ? std::vector<std::string>{} : std::vector{objects[below(i)].id});
      if (below(2) == 0) maker.soft();
    }
    scene_ = maker.make(true);
    auto model = build_model(scene_, Catalog::builtin());
    EXPECT_TRUE(model) << model.error().message;
    if (model) model_ = std::move(*model);
  }

  std::size_t below(std::size_t n) { return random_() % n; }
  const PlacementModel& model() const { return model_; }

  // Legal or not: costs are asked of any arrangement.
  Placement anywhere(ItemId item) {
    const Item& self = model_.items[item];
    Placement p{static_cast<int>(below(self.states.size())), {}};
    for (int k = 0; k < 3; ++k) {
      const Mm free = std::max(0, model_.room.extent(k) - self.states[p.state].extent[k]);
      p.at[k] = model_.room.lo[k] + (k == 2 && below(4) != 0 ? 0 : static_cast<Mm>(below(static_cast<std::size_t>(free) + 1)));
    }
    return p;
  }
  Placements all_anywhere() {
    Placements placements;
    for (const ItemId i : model_.items.ids()) placements.push_back(anywhere(i));
    return placements;
  }
  // After a few of them have moved.
  std::pair<Placements, std::vector<ItemId>> some_moved(const Placements& before) {
    Placements after = before;
    std::vector<ItemId> moved;
    for (std::size_t n = 1 + below(3); n > 0; --n) {
      const ItemId item(below(after.size()));
      if (std::ranges::find(moved, item) != moved.end()) continue;
      after[item] = anywhere(item);
      moved.push_back(item);
    }
    return {after, moved};
  }

 private:
  std::mt19937 random_;
  SceneGraph scene_;
  PlacementModel model_;
};

TEST(Terms, DeltasAddUp) {
  for (unsigned seed = 1; seed <= kScenes; ++seed) {
    ShuffledRoom room(seed);
    KnownCosts known;
    Placements before = room.all_anywhere();
    for (unsigned move = 0; move < kMoves; ++move) {
      const auto [after, moved] = room.some_moved(before);
      const Change change{before, after, moved};
      std::int64_t all = 0, early = 0;
      for (const CostTerm& term : cost_terms()) {
        const std::int64_t more = delta(term, room.model(), change);
        EXPECT_EQ(more, evaluate(term, room.model(), after) - evaluate(term, room.model(), before))
            << "seed " << seed << ": " << term.meaning;
        all += more;
        if (!term.late) early += more;
      }
      EXPECT_EQ(all, total_cost(room.model(), after) - total_cost(room.model(), before));
      EXPECT_EQ(known.gain(room.model(), change, kNoLoss), -early) << "seed " << seed;
      if (move % 2 == 0) before = after;
    }
  }
}

TEST(Terms, AGainThatIsNotWorthItIsSaidToBeNone) {
  ShuffledRoom room(1);
  const Placements before = room.all_anywhere();
  for (unsigned move = 0; move < kMoves; ++move) {
    const auto [after, moved] = room.some_moved(before);
    KnownCosts fresh, known;
    const std::int64_t gain = fresh.gain(room.model(), {before, after, moved}, kNoLoss);
    const std::int64_t asked = known.gain(room.model(), {before, after, moved}, 0);
    EXPECT_EQ(std::max<std::int64_t>(0, asked), std::max<std::int64_t>(0, gain));
  }
}

TEST(Terms, WhatIsScoredIsTheWholeButForStaying) {
  for (unsigned seed = 1; seed <= kScenes; ++seed) {
    ShuffledRoom room(seed);
    const Placements placements = room.all_anywhere();
    std::int64_t sum = 0;
    for (const auto& [name, cost] : scored_costs(room.model(), placements)) sum += cost;
    EXPECT_EQ(sum, total_cost(room.model(), placements)) << "seed " << seed;  // nothing is there to stay where it was
  }
}

// The shares that speak of an item: what all cost with it less what they cost without.
std::int64_t cost_of_placing(const PlacementModel& model, Placements placements, ItemId item) {
  std::int64_t cost = 0;
  for (const CostTerm& term : cost_terms()) {
    if (!term.late) cost += evaluate(term, model, placements);
  }
  placements[item] = {};
  for (const CostTerm& term : cost_terms()) {
    if (!term.late) cost -= evaluate(term, model, placements);
  }
  return cost;
}

// The cheapest place of one item while all else stays; nothing where there is none.
std::optional<Candidate> cheapest(const PlacementModel& model, const Placements& others, ItemId item, bool skips) {
  CandidateFinder finder(model, {});
  if (skips) finder.skip_dear_regions();
  Budget budget{0, kSteps, {}, false};
  const std::vector<Candidate> found = finder.find(others, item, {}, budget);
  return found.empty() ? std::nullopt : std::optional(found[0]);
}

TEST(Terms, CandidatesCostWhatTheTermsSay) {
  unsigned checked = 0;
  for (unsigned seed = 1; seed <= kScenes; ++seed) {
    ShuffledRoom room(seed);
    Search search(room.model(), {}, seed, 0);
    Budget budget{0, kSteps, {}, false};
    if (!search.construct(2, budget)) continue;
    for (const ItemId item : room.model().items.ids()) {
      Placements placements = search.placements();
      placements[item] = {};
      const std::optional<Candidate> best = cheapest(room.model(), placements, item, false);
      const std::optional<Candidate> by_bounds = cheapest(room.model(), placements, item, true);
      ASSERT_TRUE(best && by_bounds) << "it stood somewhere";
      EXPECT_EQ(best->cost, by_bounds->cost) << "a bound was no bound";
      placements[item] = best->placement;
      EXPECT_EQ(best->cost, cost_of_placing(room.model(), placements, item)) << "seed " << seed << ": " << item.number();
      ++checked;
    }
  }
  EXPECT_GT(checked, 100u);
}

// A row of the table in docs/solve.md.
std::string row_of(const CostTerm& term) {
  std::string names, prices;
  for (const CostTerm::Account& account : term.accounts) names += fmt::format("{}`{}`", names.empty() ? "" : ", ", account.name);
  for (const CostTerm::Price& price : term.prices) prices += fmt::format("{}{} for {}", prices.empty() ? "" : "; ", price.points, price.of);
  return fmt::format("| {} | {} | {} |", names, term.meaning, prices.empty() ? "each its own, in the table below" : prices);
}

TEST(Terms, AreAllInTheDocs) {
  std::ifstream file(LAYOUTBOX_SOURCE_FOLDER "/docs/solve.md");
  std::stringstream text;
  text << file.rdbuf();
  for (const CostTerm& term : cost_terms()) EXPECT_NE(text.str().find(row_of(term)), std::string::npos) << row_of(term);
}

}  // namespace
}  // namespace layoutbox::placement
