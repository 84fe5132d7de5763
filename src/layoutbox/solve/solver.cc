#include "layoutbox/solve/solver.h"

#include <fmt/format.h>

#include <bit>
#include <chrono>
#include <cmath>
#include <optional>

#include "layoutbox/solve/conflict.h"
#include "layoutbox/solve/cost.h"
#include "layoutbox/solve/cp_sat/library.h"
#include "layoutbox/solve/search.h"
#include "layoutbox/solve/to_layout.h"

namespace layoutbox {
namespace {

using namespace placement;
using Clock = std::chrono::steady_clock;

constexpr std::int64_t kStepsPerUnit = 5000;  // candidate positions tried in about a quarter of a millisecond
constexpr double kProofTimePerUnit = 0.04;    // of CP-SAT's deterministic time
constexpr double kLongestProof = 20, kShortProof = 0.3;
constexpr std::int64_t kLeastSteps = 60000;
constexpr int kIdleStarts = 8;
constexpr std::uint64_t kSeedStep = 0x9e3779b97f4a7c15;  // golden ratio: no start of one seed is a start of the next
constexpr int kRestarts = 8;
constexpr int kAllSizes = 1000;
constexpr int kStillWished = 4;  // points a metre, per weight, of a relation that was given up

class Solver {
 public:
  Solver(Model model, const SolveOptions& options)
      : model_(std::move(model)),
        options_(options),
        started_(Clock::now()),
        given_up_(model_.constraints.size(), 0),
        left_out_(model_.items.size(), 0),
        placements_(model_.items.size()) {
    budget_.limit = options.effort * kStepsPerUnit;
    budget_.stop = [this] { return must_stop(); };
    proof_time_ = std::clamp(static_cast<double>(options.effort) * kProofTimePerUnit, 0.1, kLongestProof);
  }

  Result<Layout> run() {
    if (const Status found = find_legal(); !found) return Failure(found.error());
    if (options_.improve && !fallback_) improve();
    return finish();
  }

 private:
  bool interrupted() const { return options_.stop && options_.stop->load(); }

  double seconds() const { return std::chrono::duration<double>(Clock::now() - started_).count(); }

  bool must_stop() {
    if (seconds() > options_.time_limit_s) stopped_by_clock_ = true;
    return stopped_by_clock_ || interrupted();
  }

  // Search, then proof, giving up one thing after another until everything that is left fits.
  Status find_legal() {
    for (std::size_t round = 0; round <= model_.constraints.size() + model_.items.size(); ++round) {
      if (interrupted()) return fail(ErrorCode::kInterrupted, "stopped");
      if (fallback_) return {};
      const std::vector<Clash> sums = clashes_by_sums(model_, given_up_, left_out_);
      if (!sums.empty()) {
        LAYOUTBOX_CHECK(give_up(sums[0]));  // one at a time: giving up the first may settle the others
        continue;
      }
      if (search(given_up_)) return {};
      LAYOUTBOX_ASSIGN(const bool found, prove());
      if (found) return {};
      if (stopped_by_clock_) break;
    }
    return fail(ErrorCode::kNotFound, "no layout was found within the limits, and no proof that there is none", {},
                "raise --effort or --time-limit");
  }

  bool search(const std::vector<char>& given_up) {
    for (const int sizes : {0, kAllSizes}) {
      Search search(model_, given_up, options_.seed, sizes);
      Budget budget{0, std::max<std::int64_t>(budget_.limit / 2, kLeastSteps), budget_.stop, false};
      const bool found = search.construct(left_out_, kRestarts, budget);
      placements_ = search.placements();
      failed_ = search.failed();
      size_limit_ = sizes;
      if (found) return true;
      if (must_stop()) return false;
    }
    return false;
  }

  // True: a layout was found. False: something was given up; try again.
  Result<bool> prove() {
    const bool loose = search_without_clearances();
    const auto library = CpSatLibrary::get();
    if (!library && options_.on_conflict == OnConflict::kFail) return Failure(library.error());
    Proof proof;
    if (library && proof_time_ > 0) {
      used_cp_sat_ = true;
      ProofLimits limits{options_.seed, loose || clearances_left() ? std::min(proof_time_, kShortProof) : proof_time_,
                         std::max(0.1, options_.time_limit_s - seconds()), options_.stop};
      LAYOUTBOX_ASSIGN(proof, decide(model_, **library, given_up_, left_out_, placements_, limits));
      proof_time_ -= proof.deterministic_time;
    }
    if (interrupted()) return fail(ErrorCode::kInterrupted, "stopped");
    switch (proof.outcome) {
      case Proof::Outcome::kLayout: placements_ = proof.placements; return true;
      case Proof::Outcome::kClash: LAYOUTBOX_CHECK(give_up(proof.clash)); return false;
      case Proof::Outcome::kUnknown: break;
    }
    must_stop();
    if (loose) {
      LAYOUTBOX_CHECK(give_up_clearances());
      return true;
    }
    LAYOUTBOX_CHECK(give_up(guess()));
    return false;
  }

  bool clearances_left() const {
    return std::any_of(model_.items.begin(), model_.items.end(),
                       [&](const Item& i) { return i.is_opening() && !given_up_[i.clearance_constraint]; });
  }

  // Door swings and the like are given up before anything else: is there a layout then?
  bool search_without_clearances() {
    std::vector<char> more = given_up_;
    bool any = false;
    for (std::size_t c = 0; c < model_.constraints.size(); ++c) {
      if (model_.constraints[c].firmness != Firmness::kImplied || more[c]) continue;
      more[c] = any = true;
    }
    return any && search(more);
  }

  // Those that the layout at hand breaks.
  Status give_up_clearances() {
    for (std::size_t i = 0; i < model_.items.size(); ++i) {
      const Item& item = model_.items[i];
      if (!item.is_opening() || placements_[i].state < 0 || given_up_[item.clearance_constraint]) continue;
      if (intrusion_of(model_, static_cast<int>(i), placements_) == 0) continue;
      Clash clash;
      clash.proven = clash.minimal = false;
      clash.demands = {{Demand::Kind::kConstraint, item.clearance_constraint}};
      clash.sentence =
          fmt::format("no layout was found that leaves the floor before {} free", object_in_words(model_, static_cast<int>(i)));
      LAYOUTBOX_CHECK(give_up(clash));
    }
    return {};
  }

  // Without a proof: what the first item that found no place asks for.
  Clash guess() const {
    Clash clash;
    clash.proven = clash.minimal = false;
    for (std::size_t i = 0; i < model_.items.size(); ++i) {  // doors and windows first
      const Item& item = model_.items[i];
      if (!item.is_opening() || left_out_[i] || given_up_[item.clearance_constraint]) continue;
      clash.demands = {{Demand::Kind::kConstraint, item.clearance_constraint}};
      clash.sentence =
          fmt::format("no layout was found that leaves the floor before {} free", object_in_words(model_, static_cast<int>(i)));
      return clash;
    }
    if (!failed_.empty()) {
      const int item = failed_[0];
      clash.demands.push_back({Demand::Kind::kItem, item});
      for (const int c : model_.touching[item]) {
        if (model_.constraints[c].firmness == Firmness::kHard && !given_up_[c]) clash.demands.push_back({Demand::Kind::kConstraint, c});
      }
      clash.sentence = fmt::format("no place was found for {}", object_in_words(model_, item));
    }
    return clash;
  }

  // The cheapest member of a clash: what is implied, then what was assumed, then the least weight; objects last.
  std::int64_t price_of(const Demand& demand) const {
    if (demand.kind == Demand::Kind::kItem) {
      const Item& item = model_.items[demand.index];
      if (item.is_opening()) return 3'000'000;
      std::int64_t rank = 0;
      for (int i = 0; i < demand.index; ++i) rank += model_.items[i].entry == item.entry;
      return (item.object->assumed ? 100'000 : 1'000'000) + (item.fixed ? 1'000'000 : 0) - 1000 * std::min<std::int64_t>(rank, 100);
    }
    const Constraint& constraint = model_.constraints[demand.index];
    if (constraint.firmness == Firmness::kImplied) return 1;
    const Relation& relation = model_.scene->relations[constraint.relation];
    return (relation.assumed ? 1'000 : 10'000) + constraint.weight * 10;
  }

  // How far a relation would be missed if it alone were given up; more than any distance where that does not help.
  std::int64_t miss_without(int constraint) {
    Model trial = model_;
    trial.constraints[constraint].firmness = Firmness::kSoft;
    trial.constraints[constraint].weight *= kStillWished;
    std::vector<char> given_up = given_up_;
    given_up[constraint] = 1;
    Search search(trial, given_up, options_.seed, size_limit_);
    Budget budget{0, kLeastSteps, budget_.stop, false};
    if (!search.construct(left_out_, 2, budget)) return 1 << 30;
    budget.limit = budget.steps + kLeastSteps / 2;
    search.improve(budget);
    return miss_of(trial, trial.constraints[constraint], search.placements());
  }

  // The least price; of equals the relation that is then missed by least, of those the last one said.
  std::vector<Demand>::const_iterator cheapest_of(const Clash& clash) {
    const auto begin = clash.demands.begin(), end = clash.demands.end();
    const auto cheapest = std::min_element(
        begin, end, [&](const Demand& a, const Demand& b) { return std::pair(price_of(a), -a.index) < std::pair(price_of(b), -b.index); });
    if (cheapest == end || cheapest->kind == Demand::Kind::kItem || options_.on_conflict != OnConflict::kRelax) return cheapest;
    auto best = cheapest;
    std::int64_t least = -1;
    for (auto it = begin; it != end; ++it) {
      if (price_of(*it) != price_of(*cheapest) || it->kind == Demand::Kind::kItem) continue;
      if (least < 0) {
        if (std::count_if(begin, end, [&](const Demand& d) { return price_of(d) == price_of(*cheapest); }) == 1) return cheapest;
        least = miss_without(cheapest->index);
      }
      if (it == cheapest) continue;
      const std::int64_t miss = miss_without(it->index);
      if (miss < least) least = miss, best = it;
    }
    return best;
  }

  Status give_up(const Clash& clash) {
    Conflict conflict;
    conflict.sentence = describe_clash(model_, clash);
    conflict.minimal = clash.minimal;
    for (const Demand& demand : clash.demands) {
      if (demand.kind == Demand::Kind::kItem) {
        conflict.objects.push_back(model_.items[demand.index].id);
      } else {
        conflict.relations.push_back(model_.constraints[demand.index].name);
      }
    }
    const auto cheapest = cheapest_of(clash);
    if (cheapest == clash.demands.cend()) return fail(ErrorCode::kNotFound, "no layout was found, and nothing is left to give up");
    const bool only_implied =
        cheapest->kind == Demand::Kind::kConstraint && model_.constraints[cheapest->index].firmness == Firmness::kImplied;
    conflicts_.push_back(conflict);
    if (options_.on_conflict == OnConflict::kFail && !only_implied && !clash.proven) {
      return fail(ErrorCode::kNotFound, conflict.sentence + ", and no proof that there is none", {}, "raise --effort or --time-limit");
    }
    if (options_.on_conflict == OnConflict::kFail && !only_implied) {
      Error error{ErrorCode::kInfeasible, "there is no such layout: " + conflict.sentence, {}, "change or drop one of these", {}};
      for (const Conflict& c : conflicts_) error.details.push_back({ErrorCode::kInfeasible, c.sentence, {}, {}, {}});
      return Failure(std::move(error));
    }
    if (options_.on_conflict == OnConflict::kOriginal && !only_implied) {
      fall_back();
      return {};
    }
    if (cheapest->kind == Demand::Kind::kItem) {
      leave_out(cheapest->index, conflict.sentence);
    } else {
      relax(cheapest->index, conflict.sentence);
    }
    return {};
  }

  void leave_out(int item, const std::string& why) {
    left_out_[item] = 1;
    placements_[item] = {};
    reasons_.push_back({model_.items[item].id, 0, "", object_in_words(model_, item) + " is left out: " + why});
    // What stands on it goes with it, unless it can stand elsewhere; relations that speak of it have nothing to hold.
    for (std::size_t c = 0; c < model_.constraints.size(); ++c) {
      if (model_.constraints[c].firmness != Firmness::kHard || given_up_[c]) continue;
      const auto& touched = model_.touching[item];
      if (std::find(touched.begin(), touched.end(), static_cast<int>(c)) != touched.end()) relax(static_cast<int>(c), why);
    }
  }

  // Given up, but still wished for.
  void relax(int index, const std::string& why) {
    given_up_[index] = 1;
    relaxed_.push_back({index, why});
    Constraint& constraint = model_.constraints[index];
    if (constraint.firmness == Firmness::kHard) {
      constraint.firmness = Firmness::kSoft;
      constraint.weight *= kStillWished;
    }
  }

  // The paper's way out: the scene's own positions, or a metre from the corner.
  void fall_back() {
    fallback_ = true;
    for (std::size_t i = 0; i < model_.items.size(); ++i) {
      const Item& item = model_.items[i];
      if (item.is_opening()) continue;
      const auto& hint = item.object->hint;
      Placement p{0, {}};
      const int turn = static_cast<int>(std::lround(normalized_degrees(hint.rotation_deg.value_or(0)))) % 360;
      if (const std::uint64_t states = item.states_at(turn)) p.state = std::countr_zero(states);
      const Vec3& e = item.states[p.state].extent;
      const std::array<double, 3> at = hint.position.value_or(std::array<double, 3>{1000, 1000, 0});
      for (int k = 0; k < 3; ++k) p.at[k] = static_cast<Mm>(std::lround(at[k] - (k < 2 ? e[k] / 2.0 : 0)));
      placements_[i] = p;
    }
  }

  std::int64_t cost() const {
    std::int64_t sum = 0;
    for (const auto& [term, points] : cost_terms(model_, placements_)) sum += points;
    return sum;
  }

  // Local moves end where none helps; then from another start, until the effort is spent. The best of all is kept.
  void improve() {
    Search search(model_, given_up_, options_.seed, size_limit_);
    search.adopt(placements_, left_out_);
    search.improve(budget_);
    placements_ = search.placements();
    std::int64_t least = cost();
    int idle = 0;  // starts since the last that brought something
    for (int start = 1; idle < kIdleStarts && !budget_.spent(); ++start, ++idle) {
      Search other(model_, given_up_, options_.seed + kSeedStep * static_cast<std::uint64_t>(start), size_limit_);
      if (!other.construct(left_out_, 1, budget_)) continue;
      other.improve(budget_);
      Placements before = other.placements();
      std::swap(placements_, before);
      if (const std::int64_t now = cost(); now < least) {
        least = now;
        idle = 0;
      } else {
        std::swap(placements_, before);
      }
    }
  }

  // How far what was given up is from holding; nothing where it holds after all.
  std::optional<Relaxation> relaxation_of(int index, const std::string& why) const {
    const Constraint& constraint = model_.constraints[index];
    Relaxation out{constraint.name, 0, "m", why};
    std::int64_t miss = 0;
    bool placed = true;
    for (const Formula& formula : constraint.formulas) {
      placed = placed && all_placed(formula, placements_);
      if (placed) miss = std::max(miss, miss_of(model_, formula, placements_));
    }
    for (std::size_t i = 0; i < model_.items.size(); ++i) {
      if (model_.items[i].clearance_constraint != index) continue;
      placed = placements_[i].state >= 0;
      if (placed) miss = intrusion_of(model_, static_cast<int>(i), placements_);
    }
    if (placed && miss == 0) return std::nullopt;
    if (!placed || miss > 100'000'000) return Relaxation{constraint.name, 0, "", why};  // it can never hold, or its object is left out
    out.by = static_cast<double>(miss) / 1000;
    return out;
  }

  Layout finish() {
    Layout layout = to_layout(model_, placements_);
    for (const auto& [index, why] : relaxed_) {
      if (const auto relaxation = relaxation_of(index, why)) layout.relaxed.push_back(*relaxation);
    }
    for (const Relaxation& reason : reasons_) layout.relaxed.push_back(reason);
    for (const PlacedRelation& r : layout.relations) {  // not linear, so never in a proof
      if (r.held || !r.relation.hard || r.relation.type != RelationType::kReachable) continue;
      layout.relaxed.push_back({r.relation.id, 0, "", "no free way was found: " + relation_in_words(model_, r.relation)});
    }
    layout.conflicts = conflicts_;
    layout.status = fallback_ ? LayoutStatus::kFallback : layout.relaxed.empty() ? LayoutStatus::kSolved : LayoutStatus::kRelaxed;
    if (layout.status == LayoutStatus::kSolved) layout.conflicts.clear();  // what seemed impossible was only not found
    double total = 0;
    for (const auto& [name, cost] : cost_terms(model_, placements_)) {
      layout.score_terms[name] = 1.0 / (1.0 + static_cast<double>(cost) / 1e6);
      total += static_cast<double>(cost) / 1e6;
    }
    layout.score = 1.0 / (1.0 + total);
    layout.stats.solver = used_cp_sat_ ? "search+cp-sat" : "search";
    layout.stats.seed = options_.seed;
    layout.stats.stopped_by_clock = stopped_by_clock_;
    layout.stats.seconds = seconds();
    return layout;
  }

  Model model_;
  const SolveOptions& options_;
  Clock::time_point started_;
  Budget budget_;
  std::vector<char> given_up_, left_out_;
  std::vector<std::pair<int, std::string>> relaxed_;  // constraints given up, and why
  std::vector<Relaxation> reasons_;                   // objects left out
  std::vector<Conflict> conflicts_;
  Placements placements_;
  std::vector<int> failed_;
  int size_limit_ = 0;
  double proof_time_ = 0;
  bool used_cp_sat_ = false, fallback_ = false, stopped_by_clock_ = false;
};

}  // namespace

Result<Layout> solve(const SceneGraph& scene, const Catalog& catalog, const SolveOptions& options) {
  if (options.effort <= 0 || !(options.time_limit_s > 0)) return fail(ErrorCode::kUsage, "effort and time limit must be positive");
  LAYOUTBOX_ASSIGN(Model model, build_model(scene, catalog));
  return Solver(std::move(model), options).run();
}

Result<std::string> describe_cp_sat_library() {
  LAYOUTBOX_ASSIGN(const CpSatLibrary* library, CpSatLibrary::get());
  return "OR-Tools " + library->version() + ", " + library->path();
}

}  // namespace layoutbox
