// What is said to be proven best: every layout of tiny rooms is looked at, on a grid, and none is better.
#include <cmath>

#include "layoutbox/solve/cp_sat/library.h"
#include "layoutbox/solve/objective/access.h"
#include "layoutbox/solve/objective/cost.h"
#include "layoutbox/solve/solver.h"
#include "layoutbox/solve/test_scene.h"

namespace layoutbox::placement {
namespace {

// The least cost of all layouts of things that stand on the floor, at places `step` apart and at the walls.
class Enumeration {
 public:
  Enumeration(const PlacementModel& model, Mm step)
      : model_(model), step_(step), placements_(model.items.size()), possible_(model.items.size()) {
    for (const ItemId i : model.items.ids()) try_item_alone(i);
    descend(ItemId(0));
  }
  std::int64_t least() const { return least_; }

 private:
  std::vector<Mm> places(Mm low, Mm high) const {
    std::vector<Mm> all;
    for (Mm at = low; at < high; at += step_) all.push_back(at);
    all.push_back(high);
    return all;
  }

  bool holds(ItemId item) const {
    for (const ConstraintId c : model_.touching[item]) {
      const Constraint& constraint = model_.constraints[c];
      if (constraint.firmness == Firmness::kSoft) continue;
      for (const Formula& f : constraint.formulas) {
        if (all_placed(f, placements_) && miss_of(model_, f, placements_) > 0) return false;
      }
    }
    return true;
  }

  // The places in which the item could be as far as it alone is concerned.
  void try_item_alone(ItemId item) {
    std::vector<Placement>& found = possible_[item];
    for (std::size_t s = 0; s < model_.items[item].states.size(); ++s) {
      const Vec3& e = model_.items[item].states[s].extent;
      for (const Mm x : places(0, model_.room.hi[0] - e[0])) {
        for (const Mm y : places(0, model_.room.hi[1] - e[1])) {
          const Mm z = model_.items[item].is_opening() ? model_.items[item].opening->sill : 0;
          placements_[item] = {static_cast<int>(s), {x, y, z}};
          if (holds(item)) found.push_back(placements_[item]);
        }
      }
    }
    placements_[item] = {};
  }

  void descend(ItemId item) {
    if (!model_.items.has(item)) {
      std::int64_t cost = 0;  // ways are costly to measure: last, where all else is better
      for (const Constraint& constraint : model_.constraints) cost += constraint_cost(model_, constraint, placements_);
      for (const ItemId i : model_.items.ids()) cost += access_cost_of(model_, i, placements_);
      if (cost < least_) least_ = std::min(least_, cost + ways_cost(model_, placements_));
      return;
    }
    for (const Placement& p : possible_[item]) {
      placements_[item] = p;
      bool free = holds(item);
      for (const ItemId j : ids_before(item)) free = free && !collide(model_, item, p, j, placements_[j], true);
      if (free) descend(ItemId(item.index() + 1));
    }
    placements_[item] = {};
  }

  const PlacementModel& model_;
  Mm step_;
  Placements placements_;
  ById<ItemId, std::vector<Placement>> possible_;
  std::int64_t least_ = std::numeric_limits<std::int64_t>::max();
};

// The effort from which on a proof is looked for.
SolveOptions thorough() {
  SolveOptions options;
  options.effort = 400;
  return options;
}

std::int64_t cost_of(const Layout& layout) { return std::llround((1 / layout.score - 1) * 1e6); }

void expect_best(const SceneMaker& maker, Mm step) {
  const SceneGraph scene = maker.make();
  const auto layout = solve(scene, Catalog::builtin(), thorough());
  ASSERT_TRUE(layout) << layout.error().message;
  EXPECT_TRUE(layout->stats.proven);
  const auto model = build_model(scene, Catalog::builtin());
  ASSERT_TRUE(model);
  const std::int64_t least = Enumeration(*model, step).least();
  EXPECT_GT(least + kPoint, cost_of(*layout));
  EXPECT_LT(least, std::numeric_limits<std::int64_t>::max());
}

TEST(Best, NoPlaceOfASingleThingIsBetter) {
  if (!CpSatLibrary::get()) GTEST_SKIP() << "no CP-SAT library: run scripts/setup.sh";
  expect_best(SceneMaker(1900, 1500).add("bed").sized(900, 1400, 500), 20);
  expect_best(SceneMaker(1500, 1400).add("desk").sized(1200, 600, 750), 20);
  expect_best(SceneMaker(1600, 1500).add("dining_table").sized(1000, 800, 750), 20);
}

TEST(Best, NoPlacesOfTwoThingsAreBetter) {
  if (!CpSatLibrary::get()) GTEST_SKIP() << "no CP-SAT library: run scripts/setup.sh";
  expect_best(SceneMaker(2300, 2100).add("bed").sized(900, 1400, 500).add("nightstand").sized(400, 400, 500), 100);
  expect_best(SceneMaker(2200, 2000).add("desk").sized(1000, 500, 750).add("wardrobe").sized(700, 500, 1900), 100);
  SceneMaker related(2200, 2000);
  related.add("sofa").sized(1200, 700, 800).add("plant").sized(300, 300, 900);
  expect_best(related.relate("leftOf", {"plant_1"}, {"sofa_1"}), 100);
}

TEST(Best, TinyRoomsOfOneToFourThingsAreProven) {
  if (!CpSatLibrary::get()) GTEST_SKIP() << "no CP-SAT library: run scripts/setup.sh";
  std::vector<SceneMaker> rooms;
  rooms.push_back(SceneMaker(4000, 3000).add("bed"));
  rooms.push_back(SceneMaker(4000, 3000).add("bed").add("wardrobe"));
  rooms.push_back(SceneMaker(4000, 3000).add("desk").add("chair").add("bookshelf"));
  rooms.push_back(SceneMaker(4000, 3000).add("bed").add("nightstand", 2).add("wardrobe"));
  rooms.push_back(SceneMaker(5000, 4000).add("sofa").add("coffee_table").add("tv_stand").add("rug"));
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    const auto layout = solve(rooms[i].make(true), Catalog::builtin(), thorough());
    ASSERT_TRUE(layout);
    EXPECT_TRUE(layout->stats.proven) << "room " << i;
  }
}

TEST(Best, NothingIsSaidWhereNothingIsImproved) {
  SolveOptions options = thorough();
  options.improve = false;
  const auto layout = solve(SceneMaker(4000, 3000).add("desk").add("chair").make(), Catalog::builtin(), options);
  ASSERT_TRUE(layout);
  EXPECT_FALSE(layout->stats.proven);
}

}  // namespace
}  // namespace layoutbox::placement
