#include "layoutbox/solve/solving.h"

#include <cmath>

#include "layoutbox/solve/cost.h"
#include "layoutbox/solve/cp_sat/library.h"
#include "layoutbox/solve/guide.h"
#include "layoutbox/solve/quick.h"
#include "layoutbox/solve/relax.h"
#include "layoutbox/solve/search.h"

namespace layoutbox::placement {
namespace {

constexpr std::int64_t kStepsPerUnit = 5000;  // candidate positions tried in about a quarter of a millisecond
constexpr double kProofTimePerUnit = 0.04;    // of CP-SAT's deterministic time
constexpr double kLongestProof = 20, kShortProof = 0.3;
constexpr std::size_t kMostForEarlyProof = 40;
constexpr int kIdleStarts = 8;
constexpr std::int64_t kShareOfStarts = 8;
constexpr std::int64_t kThingsPerEffort = 6;  // that one share of the effort is for

}  // namespace

Solver::Solver(const SceneGraph& scene, const Catalog& catalog, const SolveOptions& options, Model model, Clock::time_point started)
    : asked_(scene), catalog_(catalog), model_(std::move(model)), options_(options), started_(started) {
  size_to_model();
  budget_.limit = options.effort * kStepsPerUnit;
  budget_.stop = [this] { return must_stop(); };
  proof_time_ = std::clamp(static_cast<double>(options.effort) * kProofTimePerUnit, 0.1, kLongestProof);
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
  if (!fallback_) take_back();
  if (options_.improve && !fallback_ && !must_stop()) {
    improve();
    prove_best();
  }
  return finish();
}

void Solver::size_to_model() {
  given_up_.assign(model_.constraints.size(), 0);
  left_out_.assign(model_.items.size(), 0);
  placements_.assign(model_.items.size(), {});
  failed_.clear();
}

bool Solver::must_stop() {
  if (seconds() > options_.time_limit_s) stopped_by_clock_ = true;
  return stopped_by_clock_ || interrupted();
}

// Search, then proof, giving up one thing after another until everything that is left fits.
Status Solver::find_legal() {
  // Each gives up one thing of the scene as it was asked for.
  const std::size_t most_rounds = model_.constraints.size() + model_.items.size();
  for (std::size_t round = 0; round <= most_rounds; ++round) {
    if (interrupted()) return fail(ErrorCode::kInterrupted, "stopped");
    if (fallback_) return {};
    if (must_stop()) break;
    std::vector<Clash> sums = clashes_of_locks(model_, given_up_, left_out_);
    if (sums.empty()) sums = clashes_by_sums(model_, given_up_, left_out_);
    if (!sums.empty()) {
      LAYOUTBOX_ASSIGN(const bool less, shed());
      if (less) continue;
      LAYOUTBOX_CHECK(give_up(sums[0]));  // one at a time: giving up the first may settle the others
      continue;
    }
    if (!search(given_up_)) {
      if (interrupted()) return fail(ErrorCode::kInterrupted, "stopped");
      if (must_stop()) break;
      if (!options_.prove && options_.on_conflict == OnConflict::kFail) break;
      LAYOUTBOX_ASSIGN(const bool impossible, give_up_impossible());
      if (impossible) continue;
      LAYOUTBOX_ASSIGN(const Early early, prove_early());
      if (early == Early::kGivenUp) continue;
      LAYOUTBOX_ASSIGN(const bool found, early == Early::kFound ? Result<bool>(true) : prove());
      if (!found) continue;
    }
    if (left_out_ids_.size() < (shed_ ? 1 : 2) || brought_back_) return {};
    brought_back_ = true;
    LAYOUTBOX_ASSIGN(const bool more, bring_back());
    if (!more) return {};
  }
  return fail(ErrorCode::kNotFound, "no layout was found within the limits, and no proof that there is none", {},
              "raise --effort or --time-limit");
}

// With much effort to spend: a short look for a proof before a long search, then that search.
Result<Solver::Early> Solver::prove_early() {
  const std::int64_t whole = budget_.limit / 2;
  if (whole <= kFirstSteps || must_stop()) return Early::kUnknown;
  if (const auto library = CpSatLibrary::get(); library && options_.prove && model_.items.size() <= kMostForEarlyProof) {
    used_cp_sat_ = true;
    const ProofLimits limits{options_.seed, kShortProof, std::max(0.1, options_.time_limit_s - seconds()), options_.stop};
    LAYOUTBOX_ASSIGN(const Proof proof, decide(model_, **library, given_up_, left_out_, placements_, limits));
    if (interrupted()) return fail(ErrorCode::kInterrupted, "stopped");
    if (proof.outcome == Proof::Outcome::kLayout) {
      placements_ = proof.placements;
      return Early::kFound;
    }
    if (proof.outcome == Proof::Outcome::kClash) {
      LAYOUTBOX_CHECK(give_up(proof.clash));
      return Early::kGivenUp;
    }
  }
  return search(given_up_, whole) ? Early::kFound : Early::kUnknown;
}

bool Solver::any_other_size() const {
  return std::any_of(model_.items.begin(), model_.items.end(), [](const Item& item) {
    return std::any_of(item.states.begin(), item.states.end(), [](const State& state) { return state.size_step > 0; });
  });
}

bool Solver::search(const std::vector<char>& given_up, std::int64_t most_steps) {
  const Dependencies dependencies(model_);
  // A longer search does not go the way of the first once more.
  const std::uint64_t seed = most_steps > kFirstSteps ? options_.seed + kSeedStep : options_.seed;
  for (const int sizes : {0, kAllSizes}) {
    if (sizes > 0 && !any_other_size()) break;
    size_limit_ = sizes;
    Budget budget{0, std::max(std::min(budget_.limit / 2, most_steps), kLeastSteps), budget_.stop, false};
    if (!model_.start.empty()) {  // what stays near its earlier place is looked for there
      Search search(model_, given_up, options_.seed, sizes);
      const bool found = search.construct(left_out_, kRestarts, budget);
      placements_ = search.placements();
      if (found) return true;
      budget.limit += kLeastSteps;
    } else {
      placements_.assign(model_.items.size(), {});
    }
    QuickSearch quick(model_, dependencies, given_up, seed, sizes);
    const bool found = quick.complete(placements_, left_out_, budget);
    failed_ = quick.failed();
    if (found) return true;
    // Crowds that only fit in order: where what is wished for shows the way, the search that looks at costs finds what the quick one
    // does not.
    if (model_.start.empty() && !must_stop()) {
      Search search(model_, given_up, options_.seed, sizes);
      Budget more{0, kLeastSteps, budget_.stop, false};
      if (search.construct(left_out_, 1, more)) {
        placements_ = search.placements();
        return true;
      }
    }
    if (must_stop()) return false;
  }
  return false;
}

// True: a layout was found. False: something was given up; try again.
Result<bool> Solver::prove() {
  const bool loose = search_without_assumptions();
  const Placements loosely = placements_;
  if (interrupted()) return fail(ErrorCode::kInterrupted, "stopped");
  const auto library = CpSatLibrary::get();
  if (!library && options_.on_conflict == OnConflict::kFail) return Failure(library.error());
  Proof proof;
  if (library && options_.prove && proof_time_ > 0) {
    used_cp_sat_ = true;
    ProofLimits limits{options_.seed, loose || !assumptions_left().empty() ? std::min(proof_time_, kShortProof) : proof_time_,
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
  return give_up_unproven(loose, loosely);
}

std::int64_t Solver::cost() const {
  std::int64_t sum = 0;
  for (const auto& [term, points] : cost_terms(model_, placements_)) sum += points;
  return sum;
}

// Local moves end where none helps; then from another start, until the effort is spent. The best of all is kept.
void Solver::improve() {
  // The more things, the more moves it takes to bring all to their places.
  const auto things = static_cast<std::int64_t>(model_.items.size());
  budget_.limit += options_.effort * kStepsPerUnit * std::max<std::int64_t>(0, things - kThingsPerEffort) / kThingsPerEffort;
  Search search(model_, given_up_, options_.seed, size_limit_);
  // To look for a start takes a part of the effort, and leaves the rest for making it better.
  const auto constructs = [&](Search& one) {
    Budget start{0, std::max(kLeastSteps, (budget_.limit - budget_.steps) / kShareOfStarts), budget_.stop, false};
    const bool found = one.construct(left_out_, 1, start);
    budget_.count(start.steps);
    return found;
  };
  // The first legal layout was found without a look at costs; where one can be built that way, it is a better start.
  const bool built = model_.start.empty() && constructs(search);
  if (!built) search.adopt(placements_, left_out_);
  search.improve(budget_);
  std::int64_t least = cost();
  Placements first = search.placements();
  std::swap(placements_, first);
  if (const std::int64_t now = cost(); now <= least) {
    least = now;
  } else {
    std::swap(placements_, first);
  }
  int idle = 0;  // starts since the last that brought something
  for (int start = 1; idle < kIdleStarts && !budget_.spent(); ++start, ++idle) {
    Search other(model_, given_up_, options_.seed + kSeedStep * static_cast<std::uint64_t>(start), size_limit_);
    if (!constructs(other)) continue;
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

}  // namespace layoutbox::placement
