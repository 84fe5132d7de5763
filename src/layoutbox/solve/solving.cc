#include "layoutbox/solve/solving.h"

#include <algorithm>
#include <utility>

#include "layoutbox/solve/conflict/locks.h"
#include "layoutbox/solve/conflict/relax.h"
#include "layoutbox/solve/cp_sat/library.h"
#include "layoutbox/solve/objective/cost.h"
#include "layoutbox/solve/search/quick.h"
#include "layoutbox/solve/search/search.h"

namespace layoutbox::placement {
namespace {

constexpr double kShortProof = 0.32;  // of CP-SAT's deterministic time
constexpr std::size_t kMostForEarlyProof = 40;
constexpr std::int64_t kShareOfTakingBack = 4;

}  // namespace

Solver::Solver(const SceneGraph& scene, const Catalog& catalog, const SolveOptions& options, PlacementModel model,
               Clock::time_point started)
    : asked_(scene), catalog_(catalog), model_(std::move(model)), options_(options), started_(started) {
  size_to_model();
  budgets_ = budgets_for(options.effort, model_.items.size());
  finding_.limit = budgets_.finding;
  proof_time_ = more_proof_ = budgets_.proof;
}

Result<Layout> Solver::run() {
  Status found = find_legal();
  // The clock never turns a room into none.
  if (!found && found.error().code == ErrorCode::kNotFound && options_.on_conflict == OnConflict::kRelax) found = take_what_fits();
  if (!found && (found.error().code == ErrorCode::kInterrupted || (impossible_.empty() && not_found_.empty())))
    return Failure(found.error());
  if (!impossible_.empty()) {
    Error error{ErrorCode::kInfeasible, "there is no such layout: " + impossible_[0], {}, "change or drop one of these", {}};
    for (const std::string& sentence : impossible_) error.details.push_back({ErrorCode::kInfeasible, sentence, {}, {}, {}});
    return Failure(std::move(error));
  }
  if (!not_found_.empty())
    return fail(ErrorCode::kNotFound, not_found_[0] + ", and no proof that there is none", {}, "raise --effort or --time-limit");
  finding_.limit = finding_.steps + budgets_.finding / kShareOfTakingBack;
  if (!fallback_) take_back();
  if (!fallback_ && !must_stop() && (options_.improve || lacks_a_way())) {
    improve();
    prove_best();
  }
  return finish();
}

void Solver::size_to_model() {
  scope_.given_up.assign(model_.constraints.size(), 0);
  scope_.left_out.assign(model_.items.size(), 0);
  placements_.assign(model_.items.size(), {});
  failed_.clear();
}

bool Solver::must_stop() {
  if (seconds() > options_.time_limit_s) stopped_by_clock_ = true;
  return stopped_by_clock_ || interrupted();
}

// One thing less where sums show that not everything can be; kPlaced: they show nothing.
Result<Solver::Round> Solver::settle_sums() {
  std::vector<Clash> sums = clashes_of_locks(model_, scope_);
  if (sums.empty()) sums = clashes_by_sums(model_, scope_);
  if (sums.empty()) return Round::kPlaced;
  LAYOUTBOX_ASSIGN(const bool less, shed(sums));
  if (!less) {
    LAYOUTBOX_CHECK(give_up(sums[0]));  // one at a time: giving up the first may settle the others
  }
  return Round::kAgain;
}

// Where the search found nothing: a proof, and what is given up by it.
Result<Solver::Round> Solver::settle_failed_search() {
  if (interrupted()) return fail(ErrorCode::kInterrupted, "stopped");
  if (enough()) return Round::kEnd;
  if (!options_.prove && options_.on_conflict == OnConflict::kFail) return Round::kEnd;
  LAYOUTBOX_ASSIGN(const bool impossible, give_up_impossible());
  if (impossible) return Round::kAgain;
  LAYOUTBOX_ASSIGN(const Early early, prove_early());
  if (early == Early::kGivenUp) return Round::kAgain;
  LAYOUTBOX_ASSIGN(const bool found, early == Early::kFound ? Result<bool>(true) : prove());
  return found ? Round::kPlaced : Round::kAgain;
}

// With something legal: whether what was left out comes back, once.
Result<Solver::Round> Solver::settle_left_out() {
  if (left_out_ids_.size() < (shed_ || made_way_ ? 1 : 2) || brought_back_) return Round::kPlaced;
  brought_back_ = true;
  LAYOUTBOX_ASSIGN(const bool more, bring_back());
  return more ? Round::kAgain : Round::kPlaced;
}

// Search, then proof, giving up one thing after another until everything that is left fits.
Status Solver::find_legal() {
  // Each gives up one thing of the scene as it was asked for.
  const std::size_t most_rounds = model_.constraints.size() + model_.items.size();
  Round now = Round::kAgain;
  for (std::size_t k = 0; k <= most_rounds && now == Round::kAgain; ++k) {
    if (interrupted()) return fail(ErrorCode::kInterrupted, "stopped");
    if (fallback_) return {};
    if (enough()) break;
    LAYOUTBOX_ASSIGN(now, settle_sums());
    if (now == Round::kPlaced && !search(scope_)) {
      if (!brought_.empty()) {
        placements_ = brought_, size_limit_ = kAllSizes;
        return {};
      }
      LAYOUTBOX_ASSIGN(now, settle_failed_search());
    }
    if (now == Round::kPlaced) {
      LAYOUTBOX_ASSIGN(now, settle_left_out());
    }
  }
  if (now == Round::kPlaced) return {};
  return fail(ErrorCode::kNotFound, "no layout was found within the limits, and no proof that there is none", {},
              "raise --effort or --time-limit");
}

// With much effort to spend: a short look for a proof before a long search, then that search.
Result<Solver::Early> Solver::prove_early() {
  if (budgets_.search <= budgets_.first || enough()) return Early::kUnknown;
  if (model_.items.size() <= kMostForEarlyProof) {
    LAYOUTBOX_ASSIGN(const Proof proof, ask(scope_, placements_, kShortProof));
    if (interrupted()) return fail(ErrorCode::kInterrupted, "stopped");
    if (proof.outcome == Proof::Outcome::kLayout) {
      placements_ = proof.placements;
      return Early::kFound;
    }
    if (proof.outcome == Proof::Outcome::kClash) {
      LAYOUTBOX_CHECK(give_up(proof.clash));
      look_for_more(proof.clash);
      return Early::kGivenUp;
    }
  }
  // It does not go the way of the first once more.
  return search(scope_, budgets_.search, options_.seed + kSeedStep) ? Early::kFound : Early::kUnknown;
}

bool Solver::any_other_size() const {
  return std::any_of(model_.items.begin(), model_.items.end(), [](const Item& item) {
    return std::any_of(item.states.begin(), item.states.end(), [](const State& state) { return state.size_step > 0; });
  });
}

// Crowds in rows, grids and blocks at their places from the first.
bool Solver::search_formed(const Scope& scope, int sizes) {
  constexpr std::size_t kCrowd = 4;
  Search search(model_, scope, options_.seed, sizes);
  Budget budget = part(2 * kLeastSteps);
  if (!search.construct_formed(kCrowd, budget)) return false;
  placements_ = search.placements();
  return true;
}

bool Solver::search(const Scope& scope, std::int64_t steps, std::uint64_t seed) {
  const Dependencies dependencies(model_);
  for (const int sizes : {0, kAllSizes}) {
    if (sizes > 0 && !any_other_size()) break;
    size_limit_ = sizes;
    Budget budget = part(steps);
    if (!model_.start.empty()) {  // what stays near its earlier place is looked for there
      Search search(model_, scope, options_.seed, sizes);
      const bool found = search.construct(kRestarts, budget);
      placements_ = search.placements();
      if (found) return true;
      budget.limit += kLeastSteps;
    } else {
      placements_.assign(model_.items.size(), {});
      if (search_formed(scope, sizes)) return true;
    }
    QuickSearch quick(model_, dependencies, scope, seed, sizes);
    const bool found = quick.complete(placements_, budget);
    failed_ = quick.failed();
    if (found) return true;
    // Crowds that only fit in order: where what is wished for shows the way, the search that looks at costs finds what the quick one
    // does not.
    if (model_.start.empty() && !enough()) {
      Search search(model_, scope, options_.seed, sizes);
      Budget more = part(kLeastSteps);
      if (search.construct(1, more)) {
        placements_ = search.placements();
        return true;
      }
    }
    if (enough()) return false;
  }
  return false;
}

// CP-SAT's word, as far as it is there and may still be asked. `most`: of its deterministic time.
Result<Proof> Solver::ask(const Scope& scope, const Placements& hint, double most) {
  if (!options_.prove || proof_time_ <= 0 || must_stop()) return Proof{};
  const auto library = CpSatLibrary::get();
  if (!library) return Proof{};
  used_cp_sat_ = true;
  const ProofLimits limits{options_.seed, std::min(most, proof_time_), std::max(0.1, options_.time_limit_s - seconds()), options_.stop};
  LAYOUTBOX_ASSIGN(Proof proof, decide(model_, **library, scope, hint, limits));
  proof_time_ -= proof.deterministic_time;
  return proof;
}

// A conflict was proven and settled: others are looked for as long as the first was, so that all are named, up to a number of them.
void Solver::look_for_more(const Clash& clash) {
  constexpr int kMostConflicts = 8;
  if (!clash.proven || ++conflicts_proven_ > kMostConflicts) return;
  const double more = std::min(budgets_.proof - proof_time_, more_proof_);
  proof_time_ += more, more_proof_ -= more;
  const std::int64_t further = std::min(finding_.steps + budgets_.finding / 2, 2 * budgets_.finding);
  finding_.limit = std::max(finding_.limit, further);
}

// True: a layout was found. False: something was given up; try again.
Result<bool> Solver::prove() {
  const bool loose = search_without_assumptions();
  const Placements loosely = placements_;
  if (interrupted()) return fail(ErrorCode::kInterrupted, "stopped");
  const auto library = CpSatLibrary::get();
  if (!library && options_.on_conflict == OnConflict::kFail) return Failure(library.error());
  const bool others_may_give_way = loose || !assumptions_left().empty();
  LAYOUTBOX_ASSIGN(const Proof proof, ask(scope_, placements_, others_may_give_way ? kShortProof : proof_time_));
  if (interrupted()) return fail(ErrorCode::kInterrupted, "stopped");
  switch (proof.outcome) {
    case Proof::Outcome::kLayout: placements_ = proof.placements; return true;
    case Proof::Outcome::kClash:
      LAYOUTBOX_CHECK(give_up(proof.clash));
      look_for_more(proof.clash);
      return false;
    case Proof::Outcome::kUnknown: break;
  }
  must_stop();
  return give_up_unproven(loose, loosely);
}

}  // namespace layoutbox::placement
