#include "layoutbox/solve/solver.h"

#include <fmt/format.h>

#include <bit>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

#include "layoutbox/solve/conflict.h"
#include "layoutbox/solve/cost.h"
#include "layoutbox/solve/cp_sat/library.h"
#include "layoutbox/solve/guide.h"
#include "layoutbox/solve/quick.h"
#include "layoutbox/solve/relax.h"
#include "layoutbox/solve/search.h"
#include "layoutbox/solve/to_layout.h"

namespace layoutbox {
namespace {

using namespace placement;
using Clock = std::chrono::steady_clock;

constexpr std::int64_t kStepsPerUnit = 5000;  // candidate positions tried in about a quarter of a millisecond
constexpr double kProofTimePerUnit = 0.04;    // of CP-SAT's deterministic time
constexpr double kLongestProof = 20, kShortProof = 0.3;
constexpr std::int64_t kLeastSteps = 60000, kFirstSteps = 400'000;
constexpr std::size_t kMostForEarlyProof = 40;
constexpr int kIdleStarts = 8;
constexpr std::uint64_t kSeedStep = 0x9e3779b97f4a7c15;  // golden ratio: no start of one seed is a start of the next
constexpr int kRestarts = 8;
constexpr int kAllSizes = 1000;
constexpr std::size_t kMostTrials = 40;
constexpr int kGuesses = 2;      // relations given up one by one without a proof, before all that do not fit are given up at once
constexpr int kStillWished = 4;  // points a metre, per weight, of a relation that was given up

class Solver {
 public:
  // REQUIRES: scene, catalog and options outlive it.
  Solver(const SceneGraph& scene, const Catalog& catalog, const SolveOptions& options, Model model)
      : asked_(scene), catalog_(catalog), model_(std::move(model)), options_(options), started_(Clock::now()) {
    size_to_model();
    budget_.limit = options.effort * kStepsPerUnit;
    budget_.stop = [this] { return must_stop(); };
    proof_time_ = std::clamp(static_cast<double>(options.effort) * kProofTimePerUnit, 0.1, kLongestProof);
  }

  Result<Layout> run() {
    const Status found = find_legal();
    if (!found && (found.error().code == ErrorCode::kInterrupted || (impossible_.empty() && not_found_.empty())))
      return Failure(found.error());
    if (!impossible_.empty()) {
      Error error{ErrorCode::kInfeasible, "there is no such layout: " + impossible_[0], {}, "change or drop one of these", {}};
      for (const std::string& sentence : impossible_) error.details.push_back({ErrorCode::kInfeasible, sentence, {}, {}, {}});
      return Failure(std::move(error));
    }
    if (!not_found_.empty())
      return fail(ErrorCode::kNotFound, not_found_[0] + ", and no proof that there is none", {}, "raise --effort or --time-limit");
    if (options_.improve && !fallback_) improve();
    return finish();
  }

 private:
  void size_to_model() {
    given_up_.assign(model_.constraints.size(), 0);
    left_out_.assign(model_.items.size(), 0);
    placements_.assign(model_.items.size(), {});
    failed_.clear();
  }

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
      std::vector<Clash> sums = clashes_of_locks(model_, given_up_, left_out_);
      if (sums.empty()) sums = clashes_by_sums(model_, given_up_, left_out_);
      if (!sums.empty()) {
        LAYOUTBOX_CHECK(give_up(sums[0]));  // one at a time: giving up the first may settle the others
        continue;
      }
      if (!search(given_up_)) {
        LAYOUTBOX_ASSIGN(const Early early, prove_early());
        if (early == Early::kGivenUp) continue;
        LAYOUTBOX_ASSIGN(const bool found, early == Early::kFound ? Result<bool>(true) : prove());
        if (!found && !stopped_by_clock_) continue;
        if (!found && !fallback_) {
          LAYOUTBOX_ASSIGN(const bool settled, settle());
          if (!settled) break;
        }
      }
      if (left_out_ids_.size() < 2 || brought_back_) return {};
      brought_back_ = true;
      LAYOUTBOX_ASSIGN(const bool more, bring_back());
      if (!more) return {};
    }
    return fail(ErrorCode::kNotFound, "no layout was found within the limits, and no proof that there is none", {},
                "raise --effort or --time-limit");
  }

  enum class Early { kFound, kGivenUp, kUnknown };

  // With much effort to spend: a short look for a proof before a long search, then that search.
  Result<Early> prove_early() {
    const std::int64_t whole = budget_.limit / 2;
    if (whole <= kFirstSteps || must_stop()) return Early::kUnknown;
    if (const auto library = CpSatLibrary::get(); library && model_.items.size() <= kMostForEarlyProof) {
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

  bool search(const std::vector<char>& given_up, std::int64_t most_steps = kFirstSteps) {
    const Dependencies dependencies(model_);
    for (const int sizes : {0, kAllSizes}) {
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
      QuickSearch quick(model_, dependencies, given_up, options_.seed, sizes);
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
  Result<bool> prove() {
    const bool loose = search_without(Firmness::kImplied);
    const Placements loosely = placements_;
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
    return give_up_unproven(loose, loosely);
  }

  // Nothing found and nothing proven: what, once it is given up, lets a layout be found?
  Result<bool> give_up_unproven(bool loose, const Placements& loosely) {
    if (++unproven_ > kGuesses && demands_left(Firmness::kHard)) {
      LAYOUTBOX_ASSIGN(const bool settled, settle());
      if (settled) return true;
    }
    const bool relations = demands_left(Firmness::kHard);
    if (!relations || !search_without(Firmness::kHard)) {  // relations are not what is in the way
      LAYOUTBOX_CHECK(leave_out_least({}));
      return false;
    }
    if (loose) {
      placements_ = loosely;
      LAYOUTBOX_CHECK(give_up_clearances());
      return true;
    }
    LAYOUTBOX_CHECK(give_up(guess()));
    return false;
  }

  // All that is asked for becomes a wish; what the layout then misses is given up, in one go and whatever the clock says.
  Result<bool> settle() {
    Model trial = model_;
    std::vector<char> given_up = given_up_;
    for (std::size_t c = 0; c < trial.constraints.size(); ++c) {
      Constraint& constraint = trial.constraints[c];
      if (constraint.firmness != Firmness::kHard || given_up[c]) continue;
      constraint.firmness = Firmness::kSoft;
      constraint.weight *= kStillWished;
      given_up[c] = 1;
    }
    Budget budget{0, 4 * kLeastSteps, [this] { return interrupted(); }, false};
    Search search(trial, given_up, options_.seed, kAllSizes);
    if (!search.construct(left_out_, kRestarts, budget)) return false;
    budget.limit = budget.steps + 2 * kLeastSteps;
    search.improve(budget);
    placements_ = search.placements();
    for (std::size_t c = 0; c < trial.constraints.size() && !fallback_; ++c) {
      const bool asked = model_.constraints[c].firmness == Firmness::kHard && !given_up_[c];
      if (!asked || miss_of(trial, trial.constraints[c], placements_) == 0) continue;
      Clash clash;
      clash.proven = clash.minimal = false;
      clash.demands = {{Demand::Kind::kConstraint, static_cast<int>(c)}};
      const int relation = model_.constraints[c].relation;
      clash.sentence = relation < 0 ? std::string("no layout was found in which all relations hold together")
                                    : fmt::format("no layout was found in which, beside all else, {}",
                                                  relation_in_words(model_, scene().relations[static_cast<std::size_t>(relation)]));
      LAYOUTBOX_CHECK(give_up(clash));
    }
    return true;
  }

  bool demands_left(Firmness firmness) const {
    for (std::size_t c = 0; c < model_.constraints.size(); ++c) {
      if (model_.constraints[c].firmness == firmness && !given_up_[c]) return true;
    }
    return false;
  }

  bool clearances_left() const { return demands_left(Firmness::kImplied); }

  // Is there a layout when all demands of that firmness are given up?
  bool search_without(Firmness firmness) {
    if (!demands_left(firmness)) return false;
    std::vector<char> more = given_up_;
    for (std::size_t c = 0; c < model_.constraints.size(); ++c) more[c] |= model_.constraints[c].firmness == firmness;
    const std::vector<int> failed = failed_;
    const bool found = search(more);
    failed_ = failed;
    return found;
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
      clash.sentence = fmt::format("no layout was found that holds all relations and leaves the floor before {} free",
                                   object_in_words(model_, static_cast<int>(i)));
      LAYOUTBOX_CHECK(give_up(clash));
    }
    return {};
  }

  // Without a proof: what the first item that found no place asks for.
  Clash guess() const {
    Clash clash;
    clash.proven = clash.minimal = false;
    const auto asks = [&](int item) {
      for (const int c : model_.touching[item]) {
        if (model_.constraints[c].firmness == Firmness::kHard && !given_up_[c]) clash.demands.push_back({Demand::Kind::kConstraint, c});
      }
    };
    int item = -1;
    for (const int failed : failed_) {  // the first that asks for something
      item = failed;
      asks(failed);
      if (!clash.demands.empty()) break;
    }
    for (std::size_t i = 0; i < model_.items.size() && clash.demands.empty(); ++i) asks(item = static_cast<int>(i));
    if (item < 0) return clash;
    clash.demands.push_back({Demand::Kind::kItem, item});
    clash.sentence = fmt::format("no place was found for {} where all that is asked of it holds", object_in_words(model_, item));
    return clash;
  }

  // ---- too much in too little room

  // The options of a model with fewer objects; nothing locked is ever left out.
  ModelOptions guides() const {
    ModelOptions options;
    options.from = options_.from, options.locked = options_.locked, options.freed = options_.freed, options.unlike = options_.unlike;
    return options;
  }

  // Does a search place everything but these? How many it fails to place.
  std::size_t unplaced_without(const std::vector<std::string>& ids) {
    const LessScene less = without_objects(scene(), ids);
    const Result<Model> model = build_model(less.scene, catalog_, guides());
    if (!model) return asked_.objects.size();
    Search search(*model, given_up_in(*model), options_.seed, kAllSizes);
    Budget budget{0, std::max<std::int64_t>(budget_.limit / 4, kLeastSteps), budget_.stop, false};
    return search.construct(std::vector<char>(model->items.size(), 0), kRestarts, budget)
               ? 0
               : std::max<std::size_t>(1, search.failed().size());
  }

  // Leaves out the object (one of the items, of all where none are named) without which everything else finds a place; where one is not
  // enough, the one that helps most. Of equals the one that is missed least.
  Status leave_out_least(std::vector<int> items, const Clash* clash = nullptr) {
    if (items.empty()) {
      for (std::size_t i = 0; i < model_.items.size(); ++i) items.push_back(static_cast<int>(i));
      items = least_missed_first(model_, std::move(items));
    }
    if (items.size() > kMostTrials) items.resize(kMostTrials);
    Clash found;
    if (clash != nullptr) found = *clash;
    if (clash == nullptr) {
      found.proven = found.minimal = false;
      found.sentence = too_much_in_words(model_);
    }
    if (options_.on_conflict != OnConflict::kRelax) {  // nothing is left out: no need to look for what
      LAYOUTBOX_ASSIGN([[maybe_unused]] const bool relaxing, note_conflict(found, false));
      return {};
    }
    int best = -1;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (const int item : items) {
      const std::size_t unplaced = items.size() == 1 ? 1 : unplaced_without({model_.items[item].id});
      if (unplaced < least) least = unplaced, best = item;
      if (least == 0 || must_stop()) break;
    }
    if (best < 0) return fail(ErrorCode::kNotFound, "no layout was found, and nothing is left to give up");
    LAYOUTBOX_ASSIGN(const bool relaxing, note_conflict(found, false));
    return relaxing ? leave_out(best, conflicts_.back().sentence) : Status{};
  }

  // What was left out before and finds a place now after all comes back.
  Result<bool> bring_back() {
    bool any = false;
    for (std::size_t i = left_out_ids_.size(); i-- > 1;) {  // without the last there was no layout: that is why it went
      std::vector<std::string> fewer = left_out_ids_;
      const std::string back = fewer[i - 1];
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i - 1));
      const LessScene less = without_objects(asked_, fewer);
      const Result<Model> model = build_model(less.scene, catalog_, guides());
      if (!model) continue;
      Search search(*model, given_up_in(*model), options_.seed, kAllSizes);
      Budget budget{0, std::max<std::int64_t>(budget_.limit / 4, kLeastSteps), budget_.stop, false};
      if (!search.construct(std::vector<char>(model->items.size(), 0), kRestarts, budget)) continue;
      left_out_ids_ = std::move(fewer);
      std::erase_if(reasons_, [&](const Relaxation& r) { return r.relation == back; });
      LAYOUTBOX_CHECK(rebuild());
      any = true;
    }
    return any;
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
    const auto price = [&](const Demand& d) { return price_of(model_, clash, d); };
    const auto cheapest = std::min_element(
        begin, end, [&](const Demand& a, const Demand& b) { return std::pair(price(a), -a.index) < std::pair(price(b), -b.index); });
    if (cheapest == end || cheapest->kind == Demand::Kind::kItem || options_.on_conflict != OnConflict::kRelax) return cheapest;
    auto best = cheapest;
    std::int64_t least = -1;
    for (auto it = begin; it != end; ++it) {
      if (price(*it) != price(*cheapest) || it->kind == Demand::Kind::kItem) continue;
      if (least < 0) {
        if (std::count_if(begin, end, [&](const Demand& d) { return price(d) == price(*cheapest); }) == 1) return cheapest;
        least = miss_without(cheapest->index);
      }
      if (it == cheapest) continue;
      const std::int64_t miss = miss_without(it->index);
      if (miss < least) least = miss, best = it;
    }
    return best;
  }

  // True: something is to be given up for it. False: the scene's own positions were taken. An error where that is asked for.
  Result<bool> note_conflict(const Clash& clash, bool only_implied) {
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
    conflicts_.push_back(conflict);
    // Where conflicts are errors, what could be given up is, only to see whether there are others.
    if (options_.on_conflict == OnConflict::kFail && !only_implied) (clash.proven ? impossible_ : not_found_).push_back(conflict.sentence);
    if (options_.on_conflict == OnConflict::kOriginal && !only_implied) {
      fall_back();
      return false;
    }
    return true;
  }

  Status give_up(const Clash& clash) {
    const std::vector<int> objects = objects_to_blame(model_, clash);
    if (!objects.empty()) return leave_out_least(objects, &clash);
    const auto cheapest = cheapest_of(clash);
    if (cheapest == clash.demands.cend()) return fail(ErrorCode::kNotFound, "no layout was found, and nothing is left to give up");
    const bool only_implied =
        cheapest->kind == Demand::Kind::kConstraint && model_.constraints[cheapest->index].firmness == Firmness::kImplied;
    LAYOUTBOX_ASSIGN(const bool relaxing, note_conflict(clash, only_implied));
    if (!relaxing) return {};
    if (cheapest->kind == Demand::Kind::kItem) return leave_out(cheapest->index, conflicts_.back().sentence);
    relax(model_.constraints[cheapest->index].name, conflicts_.back().sentence);
    return {};
  }

  const SceneGraph& scene() const { return *model_.scene; }

  // The object goes; relations keep whom they still have.
  Status leave_out(int item, const std::string& why) {
    const std::string& id = model_.items[item].id;
    for (const Relation& relation : scene().relations) {
      const auto names = [&](const std::vector<std::string>& ids) { return std::find(ids.begin(), ids.end(), id) != ids.end(); };
      if (names(relation.targets) || names(relation.references)) lost_words_[relation.id] = relation_in_words(model_, relation);
    }
    left_out_ids_.push_back(id);
    reasons_.push_back({model_.items[item].id, 0, "", object_in_words(model_, item) + " is left out: " + why});
    return rebuild();
  }

  // The model of what is left of the scene, with the same given up as before.
  Status rebuild() {
    LessScene less = without_objects(asked_, left_out_ids_);
    less_scene_ = std::make_unique<SceneGraph>(std::move(less.scene));
    lost_ = std::move(less.lost);
    LAYOUTBOX_ASSIGN(model_, build_model(*less_scene_, catalog_, guides()));
    size_to_model();
    for (const auto& [name, why] : relaxed_) soften(name);
    return {};
  }

  std::vector<char> given_up_in(const Model& model) const {
    std::vector<char> mask(model.constraints.size(), 0);
    for (std::size_t c = 0; c < mask.size(); ++c) mask[c] = is_relaxed(model.constraints[c].name);
    return mask;
  }

  bool is_relaxed(const std::string& name) const {
    return std::any_of(relaxed_.begin(), relaxed_.end(), [&](const auto& r) { return r.first == name; });
  }

  void relax(const std::string& name, const std::string& why) {
    relaxed_.push_back({name, why});
    soften(name);
  }

  // Given up, but still wished for.
  void soften(const std::string& name) {
    for (std::size_t c = 0; c < model_.constraints.size(); ++c) {
      Constraint& constraint = model_.constraints[c];
      const bool demanded = constraint.firmness == Firmness::kHard || constraint.firmness == Firmness::kImplied;
      if (constraint.name != name || !demanded || given_up_[c]) continue;
      given_up_[c] = 1;
      if (constraint.firmness != Firmness::kHard) continue;
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
    // The first legal layout was found without a look at costs; where one can be built that way, it is a better start.
    const bool built = model_.start.empty() && search.construct(left_out_, 1, budget_);
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
  std::optional<Relaxation> relaxation_of(const std::string& name, const std::string& why) const {
    const auto found =
        std::find_if(model_.constraints.begin(), model_.constraints.end(), [&](const Constraint& c) { return c.name == name; });
    if (found == model_.constraints.end()) return std::nullopt;  // its objects are left out
    const Constraint& constraint = *found;
    const auto index = static_cast<int>(found - model_.constraints.begin());
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
    for (const auto& [name, why] : relaxed_) {
      if (const auto relaxation = relaxation_of(name, why)) layout.relaxed.push_back(*relaxation);
    }
    for (const Relaxation& reason : reasons_) layout.relaxed.push_back(reason);
    for (const std::string& id : lost_) layout.relaxed.push_back({id, 0, "", lost_words_[id] + ": what it speaks of is left out"});
    for (const PlacedRelation& r : layout.relations) {  // what no proof knows of: ways to walk, two things that would hold one
      const auto listed = [&](const Relaxation& relaxation) { return relaxation.relation == r.relation.id; };
      if (r.held || !r.relation.hard || std::any_of(layout.relaxed.begin(), layout.relaxed.end(), listed)) continue;
      const bool way = r.relation.type == RelationType::kReachable;
      layout.relaxed.push_back(
          {r.relation.id, 0, "",
           (way ? "no free way was found: " : "no layout was found such that ") + relation_in_words(model_, r.relation)});
    }
    layout.conflicts = conflicts_;
    layout.status = fallback_ ? LayoutStatus::kFallback : layout.relaxed.empty() ? LayoutStatus::kSolved : LayoutStatus::kRelaxed;
    if (layout.status == LayoutStatus::kSolved) layout.conflicts.clear();  // what seemed impossible was only not found
    double total = 0;
    for (const auto& [name, cost] : cost_terms(model_, placements_)) {
      if (name == "stay") continue;
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

  const SceneGraph& asked_;
  const Catalog& catalog_;
  std::unique_ptr<SceneGraph> less_scene_;  // what the model is of, once something is left out
  Model model_;
  const SolveOptions& options_;
  Clock::time_point started_;
  Budget budget_;
  std::vector<char> given_up_, left_out_;
  std::vector<std::pair<std::string, std::string>> relaxed_;  // constraints given up, and why
  std::vector<std::string> left_out_ids_, lost_;              // objects, and the relations that went with them
  std::map<std::string, std::string> lost_words_;             // by relation
  std::vector<Relaxation> reasons_;                           // of the objects left out
  std::vector<Conflict> conflicts_;
  std::vector<std::string> impossible_, not_found_;  // conflicts that are errors
  Placements placements_;
  std::vector<int> failed_;
  int size_limit_ = 0;
  double proof_time_ = 0;
  int unproven_ = 0;  // rounds that ended without a layout and without a proof
  bool used_cp_sat_ = false, fallback_ = false, stopped_by_clock_ = false, brought_back_ = false;
};

}  // namespace

Result<Layout> solve(const SceneGraph& scene, const Catalog& catalog, const SolveOptions& options) {
  if (options.effort <= 0 || !(options.time_limit_s > 0)) return fail(ErrorCode::kUsage, "effort and time limit must be positive");
  ModelOptions guides;
  guides.from = options.from, guides.locked = options.locked, guides.freed = options.freed, guides.unlike = options.unlike;
  LAYOUTBOX_ASSIGN(Model model, build_model(scene, catalog, guides));
  return Solver(scene, catalog, options, std::move(model)).run();
}

Movement movement_between(const Layout& from, const Layout& to) {
  constexpr double kSame = 0.6;  // mm, degrees
  Movement sum;
  for (const PlacedObject& now : to.objects) {
    const PlacedObject* was = from.find_object(now.id);
    if (was == nullptr) continue;
    const double way = std::hypot(now.position[0] - was->position[0], now.position[1] - was->position[1]);
    const bool turned = std::abs(std::remainder(now.rotation_deg - was->rotation_deg, 360)) > kSame;
    sum.moved += way > kSame || turned || std::abs(now.position[2] - was->position[2]) > kSame;
    sum.metres += way / 1000;
  }
  return sum;
}

Result<std::string> describe_cp_sat_library() {
  LAYOUTBOX_ASSIGN(const CpSatLibrary* library, CpSatLibrary::get());
  return "OR-Tools " + library->version() + ", " + library->path();
}

}  // namespace layoutbox
