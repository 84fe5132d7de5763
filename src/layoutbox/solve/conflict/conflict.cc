#include "layoutbox/solve/conflict/conflict.h"

#include <optional>

namespace layoutbox::placement {
namespace {

// Most questions are answered at once, faster than presolve reads them; distances that clash are answered only after it.
constexpr double kWithoutPresolve = 0.001;
constexpr std::int64_t kMostTerms = 1'200'000;  // of a model that is still asked about: some 300 MB
// Deterministic time, about a second each, that the library leaves out of its own count: a model is read, and presolve looks at all of it
// before it counts anything.
constexpr double kPerByteRead = 2e-8, kPerBytePresolved = 2e-7;
constexpr std::size_t kSmallModel = 1'000'000;  // bytes: its presolve is quick whatever it looks for
constexpr double kSizeQuestion = 0.02;          // of one question about a size that may take part
constexpr double kLeastForSmallest = 0.08;      // to find the smallest conflict of a few things, whatever the question itself took

Result<CpAnswer> ask(Encoding& encoding, const CpSatLibrary& library, const std::vector<char>& demanded, const ProofLimits& limits) {
  CpParameters parameters;
  parameters.seed = limits.seed;
  const std::string model = encoding.bytes(demanded);
  parameters.inclusions = model.size() < kSmallModel;
  double used = 0;
  for (const bool presolve : {false, true}) {
    const double reading = static_cast<double>(model.size()) * (presolve ? kPerBytePresolved : kPerByteRead);
    if (presolve && used + reading >= limits.deterministic_time) {
      CpAnswer unknown;
      unknown.deterministic_time = used;
      return unknown;
    }
    parameters.presolve = presolve;
    parameters.deterministic_time =
        presolve ? limits.deterministic_time - used - reading : std::min(kWithoutPresolve, limits.deterministic_time);
    const std::string bytes = library.solve(model, write_parameters(parameters), limits.stop, limits.seconds);
    LAYOUTBOX_ASSIGN(CpAnswer answer, read_answer(bytes, encoding.variable_count()));
    used = answer.deterministic_time += used + reading;
    const bool stopped = limits.stop && limits.stop->load();
    if (presolve || stopped || answer.status != CpStatus::kUnknown || used >= limits.deterministic_time) return answer;
  }
  return CpAnswer{};
}

bool stopped(const ProofLimits& limits) { return limits.stop && limits.stop->load(); }

// To ask for a relation is to ask for the objects that it speaks of.
class Shrinking {
 public:
  Shrinking(const PlacementModel& model, Encoding& encoding, const CpSatLibrary& library, const ProofLimits& limits, double& used)
      : encoding_(encoding), library_(library), limits_(limits), used_(used), spoken_of_(encoding.demands().size()) {
    ById<ItemId, int> demand_of(model.items.size(), -1);
    for (std::size_t d = 0; d < encoding.demands().size(); ++d) {
      if (encoding.demands()[d].is_item()) demand_of[encoding.demands()[d].item] = static_cast<int>(d);
    }
    for (std::size_t d = 0; d < encoding.demands().size(); ++d) {
      const Demand& demand = encoding.demands()[d];
      if (demand.is_item()) continue;
      const Constraint& constraint = model.constraints[demand.constraint];
      for (const Formula& formula : constraint.formulas) {
        for (const ItemId item : formula.items) {
          if (demand_of[item] >= 0) spoken_of_[d].push_back(static_cast<std::size_t>(demand_of[item]));
        }
      }
      if (!constraint.relation.exists()) continue;
      const Relation& relation = model.relation(constraint.relation);
      for (const auto* ids : {&relation.targets, &relation.references}) {
        for (const std::string& id : *ids) {
          if (const ItemId item = model.find_item(id); item.exists() && demand_of[item] >= 0)
            spoken_of_[d].push_back(static_cast<std::size_t>(demand_of[item]));
        }
      }
    }
  }

  // Drops one demand after another: what is still impossible without it does not need it. Relations first, while all the objects they speak
  // of are there: what cannot be whether or not a relation is asked for is not its fault. Then of the objects those whose sizes take no
  // part.
  Result<Clash> smallest(const std::vector<std::size_t>& core) {
    Clash clash;
    std::vector<char> mask = with_objects(core);
    for (const bool items : {false, true}) {
      for (std::size_t d = 0; d < mask.size() && !out_of_time(clash); ++d) {
        if (!mask[d] || (encoding_.demands()[d].is_item()) != items) continue;
        // Without an object that a relation speaks of that relation is not there either: only whether its size takes part is asked.
        const bool spoken_of = items && is_spoken_of(mask, d);
        mask[d] = 0;
        LAYOUTBOX_ASSIGN(const CpAnswer answer, question(mask, spoken_of ? kSizeQuestion : limits_.deterministic_time));
        if (answer.status == CpStatus::kInfeasible) {
          keep_only(mask, encoding_.demands_in(answer.core), !items);
        } else {
          mask[d] = 1;
          clash.minimal = clash.minimal && (spoken_of || answer.status != CpStatus::kUnknown);
        }
      }
    }
    for (std::size_t d = 0; d < mask.size(); ++d) {
      if (mask[d]) clash.demands.push_back(encoding_.demands()[d]);
    }
    return clash;
  }

 private:
  std::vector<char> with_objects(const std::vector<std::size_t>& chosen) const {
    std::vector<char> demanded(encoding_.demands().size(), 0);
    for (const std::size_t d : chosen) {
      demanded[d] = 1;
      for (const std::size_t item : spoken_of_[d]) demanded[item] = 1;
    }
    return demanded;
  }

  bool is_spoken_of(const std::vector<char>& mask, std::size_t item) const {
    for (std::size_t d = 0; d < mask.size(); ++d) {
      if (mask[d] && std::find(spoken_of_[d].begin(), spoken_of_[d].end(), item) != spoken_of_[d].end()) return true;
    }
    return false;
  }

  Result<CpAnswer> question(const std::vector<char>& demanded, double most) {
    ProofLimits rest = limits_;
    rest.deterministic_time = std::min(most, (limits_.deterministic_time - used_) / 2);
    LAYOUTBOX_ASSIGN(const CpAnswer answer, ask(encoding_, library_, demanded, rest));
    used_ += answer.deterministic_time;
    return answer;
  }

  bool out_of_time(Clash& clash) const {
    const bool out = stopped(limits_) || (limits_.deterministic_time - used_) / 2 < 0.001;
    if (out) clash.minimal = false;
    return out;
  }

  // The solver's own core may be smaller still. With the relations of it goes all that these speak of, as long as relations are dropped.
  void keep_only(std::vector<char>& mask, const std::vector<std::size_t>& core, bool with_spoken_of) const {
    if (core.empty()) return;
    std::vector<char> smaller(mask.size(), 0);
    for (const std::size_t d : core) smaller[d] = 1;
    if (with_spoken_of) smaller = with_objects(core);
    for (std::size_t d = 0; d < mask.size(); ++d) mask[d] = mask[d] && smaller[d];
  }

  Encoding& encoding_;
  const CpSatLibrary& library_;
  const ProofLimits& limits_;
  double& used_;
  std::vector<std::vector<std::size_t>> spoken_of_;  // demand → the demands of the items it speaks of
};

// The items that some demands are about: those that must be there, and those of which the relations speak.
ById<ItemId, char> outside_of(const PlacementModel& model, const Encoding& encoding, const std::vector<std::size_t>& core) {
  ById<ItemId, char> out(model.items.size(), 1);
  const auto keep = [&](const std::vector<Case>& cases) {
    for (const Case& one : cases) {
      for (const StateLiteral& literal : one.states) out[literal.item] = 0;
      for (const Linear& form : one.at_least_zero) {
        for (const Term& term : form.terms) out[term.item] = 0;
      }
    }
  };
  for (const std::size_t d : core) {
    const Demand& demand = encoding.demands()[d];
    if (demand.is_item()) {
      out[demand.item] = 0;
      continue;
    }
    for (const Formula& formula : model.constraints[demand.constraint].formulas) keep(formula.exact ? formula.cases : formula.outer);
    for (const ItemId i : model.items.ids()) {
      if (model.items[i].clearance_constraint == demand.constraint) out[i] = 0;
    }
  }
  // And what could hold them up.
  for (bool more = true; more;) {
    more = false;
    for (const ItemId i : model.items.ids()) {
      if (out[i]) continue;
      for (const SupportOption& support : model.items[i].supports) {
        const bool item = support.kind == SupportOption::Kind::kItem || support.kind == SupportOption::Kind::kSill;
        if (item && out[support.item]) out[support.item] = 0, more = true;
      }
    }
  }
  return out;
}

std::vector<std::size_t> those_of(const Encoding& encoding, const std::vector<Demand>& demands) {
  std::vector<std::size_t> found;
  for (std::size_t d = 0; d < encoding.demands().size(); ++d) {
    const Demand& demand = encoding.demands()[d];
    if (std::find(demands.begin(), demands.end(), demand) != demands.end()) found.push_back(d);
  }
  return found;
}

// Do these demands clash in what is surely needed, too? Then a smallest clash among them; nothing where they do not or nobody knows.
Result<std::optional<Clash>> prove(const PlacementModel& model, const CpSatLibrary& library, const Scope& scope,
                                   const std::vector<Demand>& demands, const ProofLimits& limits, double& used) {
  Encoding encoding(model, scope, Purpose::kProving);
  std::vector<char> mask(encoding.demands().size(), 0);
  const std::vector<std::size_t> all = those_of(encoding, demands);
  for (const std::size_t d : all) mask[d] = 1;
  LAYOUTBOX_ASSIGN(const CpAnswer answer, ask(encoding, library, mask, limits));
  used += answer.deterministic_time;
  if (answer.status != CpStatus::kInfeasible) return std::optional<Clash>{};
  std::vector<std::size_t> core = encoding.demands_in(answer.core);
  if (core.empty()) core = all;
  LAYOUTBOX_ASSIGN(Clash clash, Shrinking(model, encoding, library, limits, used).smallest(core));
  return std::optional<Clash>{std::move(clash)};
}

constexpr std::size_t kMostForWholeProof = 12;  // items

// About how many terms the constraints and the pairs of bodies make in CP-SAT's model, which takes a quarter of a kilobyte for each.
std::int64_t terms_of(const PlacementModel& model, const Scope& scope) {
  constexpr std::int64_t kSidesOfBody = 6;
  std::int64_t terms = 0;
  for (const ConstraintId c : model.constraints.ids()) {
    if (scope.gives_up(c) || model.constraints[c].firmness == Firmness::kSoft) continue;
    for (const Formula& formula : model.constraints[c].formulas) {
      const auto out = [&](ItemId item) { return scope.leaves_out(item); };
      if (std::any_of(formula.items.begin(), formula.items.end(), out)) continue;
      for (const Case& one : formula.cases) {
        for (const Linear& form : one.at_least_zero) terms += static_cast<std::int64_t>(form.terms.size());
      }
    }
  }
  for (const ItemId a : model.items.ids()) {
    for (const ItemId b : model.items.ids_after(a)) {
      const PairRule rule = model.pair(a, b);
      if (scope.leaves_out(a) || scope.leaves_out(b) || rule == PairRule::kFree) continue;
      const Item &x = model.items[a], &y = model.items[b];
      if (x.states.empty() || y.states.empty()) continue;
      const auto states = static_cast<std::int64_t>(x.states.size() + y.states.size());
      const std::size_t parts = rule == PairRule::kSolids ? x.states[0].solids.size() * y.states[0].solids.size() : 1;
      terms += kSidesOfBody * states * static_cast<std::int64_t>(std::max<std::size_t>(1, parts));
    }
  }
  return terms;
}

}  // namespace

Result<Proof> decide(const PlacementModel& model, const CpSatLibrary& library, const Scope& scope, const Placements& hint,
                     const ProofLimits& limits) {
  if (terms_of(model, scope) > kMostTerms) return Proof{};  // nothing known
  Encoding encoding(model, scope);
  encoding.hint(hint);
  LAYOUTBOX_ASSIGN(const CpAnswer answer, ask(encoding, library, std::vector<char>(encoding.demands().size(), 1), limits));
  Proof proof;
  proof.deterministic_time = answer.deterministic_time;
  if (answer.status == CpStatus::kFeasible || answer.status == CpStatus::kOptimal) {
    proof.outcome = Proof::Outcome::kLayout;
    proof.placements = encoding.placements_of(answer.values);
    return proof;
  }
  if (answer.status != CpStatus::kInfeasible) return proof;
  proof.outcome = Proof::Outcome::kClash;
  std::vector<std::size_t> core = encoding.demands_in(answer.core);
  if (core.empty()) {  // impossible without any assumption, or the core is not said: start from everything
    for (std::size_t d = 0; d < encoding.demands().size(); ++d) core.push_back(d);
  }
  std::vector<Demand> demands;
  for (const std::size_t d : core) demands.push_back(encoding.demands()[d]);
  ProofLimits rest = limits;
  rest.deterministic_time = std::max(kLeastForSmallest, limits.deterministic_time - proof.deterministic_time);
  LAYOUTBOX_ASSIGN(std::optional<Clash> proven,
                   prove(model, library, {scope.given_up, outside_of(model, encoding, core)}, demands, rest, proof.deterministic_time));
  if (!proven && model.items.size() <= kMostForWholeProof) {
    LAYOUTBOX_ASSIGN(proven, prove(model, library, scope, encoding.demands(), rest, proof.deterministic_time));
  }
  if (proven) {
    proof.clash = *std::move(proven);
    return proof;
  }
  // Not in the way we place things; that there is no other is not shown.
  LAYOUTBOX_ASSIGN(proof.clash, Shrinking(model, encoding, library, limits, proof.deterministic_time).smallest(core));
  proof.clash.proven = proof.clash.minimal = false;
  return proof;
}

}  // namespace layoutbox::placement
