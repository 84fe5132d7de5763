// One scene on its way to a layout: search, proof, giving up one thing after another until everything that is left fits, improvement.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "layoutbox/solve/conflict/conflict.h"
#include "layoutbox/solve/model/scope.h"
#include "layoutbox/solve/search/budgets.h"
#include "layoutbox/solve/search/candidates.h"
#include "layoutbox/solve/solver.h"

namespace layoutbox::placement {

// Tries of the constructive search; no limit to how far sizes may be
// from the usual ones.
inline constexpr int kRestarts = 8;
inline constexpr int kStillWished = 4;  // points a metre, per weight, of a relation that was given up
inline constexpr int kAllSizes = 1000;
inline constexpr std::uint64_t kSeedStep = 0x9e3779b97f4a7c15;  // golden ratio: no start of one seed is a start of the next

struct Dependencies;
class Search;

class Solver {
 public:
  // REQUIRES: scene, catalog and options outlive it. The time limit counts from `started`.
  Solver(const SceneGraph& scene, const Catalog& catalog, const SolveOptions& options, PlacementModel model,
         std::chrono::steady_clock::time_point started = std::chrono::steady_clock::now());

  Result<Layout> run();

 private:
  using Clock = std::chrono::steady_clock;

  void size_to_model();
  bool interrupted() const { return options_.stop && options_.stop->load(); }
  double seconds() const { return std::chrono::duration<double>(Clock::now() - started_).count(); }
  // Stopped, or out of time.
  bool must_stop();
  // That, or the work is done that may be done before something legal stands there.
  bool enough() { return must_stop() || finding_.steps >= finding_.limit; }
  // A part of that work.
  Budget part(std::int64_t steps) {
    Budget budget{0, steps, [this] { return enough(); }, false};
    budget.whole = &finding_;
    return budget;
  }
  const SceneGraph& scene() const { return *model_.scene; }
  // The options of a model with fewer objects; nothing locked is ever left out.
  ModelOptions guides() const {
    ModelOptions options;
    options.from = options_.from, options.locked = options_.locked, options.freed = options_.freed, options.unlike = options_.unlike;
    return options;
  }

  // ---- finding (solving.cc)
  // How a round of finding ended: something was given up; everything left has its place; no more can be done.
  enum class Round { kAgain, kPlaced, kEnd };
  Result<Round> settle_sums();
  Result<Round> settle_failed_search();
  Result<Round> settle_left_out();
  Status find_legal();
  enum class Early { kFound, kGivenUp, kUnknown };
  Result<Early> prove_early();
  bool any_other_size() const;
  bool search_formed(const Scope& scope, int sizes);
  bool search(const Scope& scope) { return search(scope, budgets_.first, options_.seed); }
  bool search(const Scope& scope, std::int64_t steps, std::uint64_t seed);
  Result<bool> prove();
  void look_for_more(const Clash& clash);
  Result<Proof> ask(const Scope& scope, const Placements& hint, double most);

  // ---- making it better (improving.cc), and whether it can be (best.cc)
  void improve();
  bool begin(Search& search, int start, Budget& budget);
  void prove_best();
  std::int64_t cost() const;

  // ---- what cannot be whatever else is asked for (impossible.cc)
  Result<bool> give_up_impossible();
  Result<bool> give_up_impossible(ConstraintId constraint, const Dependencies& dependencies);

  // ---- what nobody asked for gives way (assumptions.cc)
  std::vector<ConstraintId> assumptions_left() const;
  bool asked_things_went() const;
  bool is_door_floor(ConstraintId constraint) const;
  bool search_without_assumptions();
  bool is_missed(ConstraintId constraint) const;
  Status yield_assumptions(bool found);
  std::vector<ItemId> extras_in_the_way();
  bool is_asked(ItemId item) const;
  bool floor_gives_way(const Clash& clash, const std::vector<ItemId>& objects);

  // ---- what came unasked for with another thing (companions.cc)
  bool is_companion(ItemId item) const;
  std::vector<ItemId> companions() const;
  std::vector<std::string> companions_placed_by(const Constraint& constraint) const;
  Status leave_out_companions(std::vector<std::string> ids);
  Result<bool> companions_make_way();
  Result<bool> companions_make_way_for(const std::vector<ItemId>& items);
  bool companions_are_in_the_way();
  void leave_out_the_lonely();

  // ---- what is given up when not everything can hold (give_up.cc)
  bool demands_left(Firmness firmness) const;
  bool search_without(Firmness firmness);
  bool search_from_elsewhere();
  Result<bool> give_up_unproven(bool loose, const Placements& loosely);
  Result<bool> settle();
  Status take_what_fits();
  Status note_what_is_missing();
  void drop_what_hangs_in_the_air();
  void place_what_fits(const PlacementModel& trial, const Scope& scope, std::uint64_t seed, double until);
  void let_companions_in(const PlacementModel& trial, const Scope& scope);
  void place_openings_first(const PlacementModel& trial, const Scope& scope);
  Scope all_wished(PlacementModel& trial) const;
  void keep_what_can_be(std::vector<ConstraintId>& missed);
  Clash guess() const;
  Status give_up(const Clash& clash);
  std::vector<Demand>::const_iterator cheapest_of(const Clash& clash);
  std::int64_t miss_without(ConstraintId constraint);
  Result<bool> note_conflict(const Clash& clash, bool asked);
  void fall_back();
  Scope scope_in(const PlacementModel& model) const;
  bool is_relaxed(const std::string& name) const {
    return std::any_of(relaxed_.begin(), relaxed_.end(), [&](const auto& r) { return r.first == name; });
  }
  void relax(const std::string& name, const std::string& why) {
    relaxed_.push_back({name, why});
    soften(name);
  }
  void soften(const std::string& name);
  bool may_come_back(const std::string& name, const std::string& why) const;
  bool take_back(const std::string& name);
  void take_back();

  // ---- too much in too little room (leave_out.cc)
  Status leave_out_least(std::vector<ItemId> items, const Clash* clash = nullptr);
  std::size_t unplaced_without(const std::vector<std::string>& ids);
  bool each_is_needed(const Clash& clash);
  Result<Clash> smallest_crowd(Clash clash);
  Status leave_out(ItemId item, const std::string& why);
  void note_lost_by(ItemId item);
  void note_left_out(ItemId item, const std::string& why);
  // ---- far too much (shed.cc)
  std::vector<ItemId> surplus_items() const;
  Result<bool> shed(const std::vector<Clash>& sums);
  std::optional<std::string> too_little_floor(const std::vector<ItemId>& without) const;
  Status note_crowd(const std::vector<Clash>& sums);
  void sum_up_shedding();
  Status rebuild();
  std::vector<std::string> may_be_brought_back() const;
  Result<bool> bring_back();

  // ---- what is said of it in the end (outcome.cc)
  std::optional<Relaxation> relaxation_of(const std::string& name, const std::string& why) const;
  void list_what_is_missed(Layout& layout);
  bool lacks_a_way() const;
  Layout finish();

  const SceneGraph& asked_;
  const Catalog& catalog_;
  std::unique_ptr<SceneGraph> less_scene_;  // what the model is of, once something is left out
  PlacementModel model_;
  const SolveOptions& options_;
  Clock::time_point started_;
  Budgets budgets_;
  Budget finding_;
  Scope scope_;                                               // what is asked for still
  std::vector<std::pair<std::string, std::string>> relaxed_;  // constraints given up, and why
  std::vector<std::string> left_out_ids_, lost_;              // objects, and the relations that went with them
  std::map<std::string, std::string> lost_words_;             // by relation
  std::vector<Relaxation> reasons_;                           // of the objects left out
  struct Noted {
    Conflict conflict;
    bool asked;  // it cost something that was asked for: else nobody is to hear of a conflict
  };
  std::vector<Noted> conflicts_;
  std::vector<std::string> impossible_, not_found_;  // conflicts that are errors
  std::optional<Conflict> crowd_;                    // the fewest things that are too many, where some are shed
  std::set<std::string> looked_at_alone_;            // relations
  Placements placements_;
  Placements brought_;  // with what was left out and came back
  std::vector<ItemId> failed_;
  int size_limit_ = 0;
  double proof_time_ = 0;  // left of what CP-SAT may take
  double more_proof_ = 0;  // left of what is added to that for further conflicts
  int conflicts_proven_ = 0;
  int unproven_ = 0;          // rounds that ended without a layout and without a proof
  bool proven_best_ = false;  // no layout is better by a point
  bool used_cp_sat_ = false, fallback_ = false, stopped_by_clock_ = false, brought_back_ = false, searched_elsewhere_ = false,
       shed_ = false, made_way_ = false;
};

}  // namespace layoutbox::placement
