#include "layoutbox/solve/conflict.h"

#include <optional>

namespace layoutbox::placement {
namespace {

Result<CpAnswer> ask(Encoding& encoding, const CpSatLibrary& library, const std::vector<char>& demanded, const ProofLimits& limits) {
  CpParameters parameters;
  parameters.seed = limits.seed;
  parameters.deterministic_time = limits.deterministic_time;
  const std::string bytes = library.solve(encoding.bytes(demanded), write_parameters(parameters), limits.stop, limits.seconds);
  return read_answer(bytes, encoding.variable_count());
}

bool stopped(const ProofLimits& limits) { return limits.stop && limits.stop->load(); }

// Drops one demand after another: what is still impossible without it does not need it.
Result<Clash> shrink(Encoding& encoding, const CpSatLibrary& library, std::vector<std::size_t> core, const ProofLimits& limits,
                     double& used) {
  Clash clash;
  const auto mask = [&](const std::vector<std::size_t>& chosen) {
    std::vector<char> demanded(encoding.demands().size(), 0);
    for (const std::size_t d : chosen) demanded[d] = 1;
    return demanded;
  };
  for (std::size_t i = 0; i < core.size() && !stopped(limits);) {
    std::vector<std::size_t> fewer = core;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    ProofLimits rest = limits;
    rest.deterministic_time = (limits.deterministic_time - used) / 2;
    if (rest.deterministic_time < 0.001) {
      clash.minimal = false;
      break;
    }
    LAYOUTBOX_ASSIGN(const CpAnswer answer, ask(encoding, library, mask(fewer), rest));
    used += answer.deterministic_time;
    if (answer.status == CpStatus::kInfeasible) {
      const std::vector<std::size_t> again = encoding.demands_in(answer.core);
      std::vector<std::size_t> kept;  // those before `i` are known to be needed
      for (const std::size_t d : fewer) {
        const bool known = again.empty() || std::find(core.begin(), core.begin() + static_cast<std::ptrdiff_t>(i), d) !=
                                                core.begin() + static_cast<std::ptrdiff_t>(i);
        if (known || std::find(again.begin(), again.end(), d) != again.end()) kept.push_back(d);
      }
      core = std::move(kept);
    } else {
      clash.minimal = clash.minimal && answer.status != CpStatus::kUnknown;
      ++i;
    }
  }
  clash.minimal = clash.minimal && !stopped(limits);
  for (const std::size_t d : core) clash.demands.push_back(encoding.demands()[d]);
  return clash;
}

// The items that some demands are about: those that must be there, and those of which the relations speak.
std::vector<char> outside_of(const Model& model, const Encoding& encoding, const std::vector<std::size_t>& core) {
  std::vector<char> out(model.items.size(), 1);
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
    if (demand.kind == Demand::Kind::kItem) {
      out[demand.index] = 0;
      continue;
    }
    for (const Formula& formula : model.constraints[demand.index].formulas) keep(formula.exact ? formula.cases : formula.outer);
    for (std::size_t i = 0; i < model.items.size(); ++i) {
      if (model.items[i].clearance_constraint == demand.index) out[i] = 0;
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

// Items first: a clash of few objects says more than one of few relations.
void sort_for_shrinking(const Encoding& encoding, std::vector<std::size_t>& core) {
  std::stable_sort(core.begin(), core.end(), [&](std::size_t a, std::size_t b) {
    return encoding.demands()[a].kind == Demand::Kind::kItem && encoding.demands()[b].kind != Demand::Kind::kItem;
  });
}

// Do these demands clash in what is surely needed, too? Then a smallest clash among them; nothing where they do not or nobody knows.
Result<std::optional<Clash>> prove(const Model& model, const CpSatLibrary& library, const std::vector<char>& given_up,
                                   const std::vector<Demand>& demands, const std::vector<char>& left_out, const ProofLimits& limits,
                                   double& used) {
  Encoding encoding(model, given_up, left_out, Purpose::kProving);
  std::vector<char> mask(encoding.demands().size(), 0);
  const std::vector<std::size_t> all = those_of(encoding, demands);
  for (const std::size_t d : all) mask[d] = 1;
  LAYOUTBOX_ASSIGN(const CpAnswer answer, ask(encoding, library, mask, limits));
  used += answer.deterministic_time;
  if (answer.status != CpStatus::kInfeasible) return std::optional<Clash>{};
  std::vector<std::size_t> core = encoding.demands_in(answer.core);
  if (core.empty()) core = all;
  sort_for_shrinking(encoding, core);
  LAYOUTBOX_ASSIGN(Clash clash, shrink(encoding, library, std::move(core), limits, used));
  return std::optional<Clash>{std::move(clash)};
}

constexpr std::size_t kMostForWholeProof = 12;  // items

}  // namespace

Result<Proof> decide(const Model& model, const CpSatLibrary& library, const std::vector<char>& given_up, const std::vector<char>& left_out,
                     const Placements& hint, const ProofLimits& limits) {
  Encoding encoding(model, given_up, left_out);
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
  rest.deterministic_time = std::max(0.02, limits.deterministic_time - proof.deterministic_time);
  LAYOUTBOX_ASSIGN(std::optional<Clash> proven,
                   prove(model, library, given_up, demands, outside_of(model, encoding, core), rest, proof.deterministic_time));
  if (!proven && model.items.size() <= kMostForWholeProof) {
    LAYOUTBOX_ASSIGN(proven, prove(model, library, given_up, encoding.demands(), left_out, rest, proof.deterministic_time));
  }
  if (proven) {
    proof.clash = *std::move(proven);
    return proof;
  }
  // Not in the way we place things; that there is no other is not shown.
  sort_for_shrinking(encoding, core);
  LAYOUTBOX_ASSIGN(proof.clash, shrink(encoding, library, std::move(core), limits, proof.deterministic_time));
  proof.clash.proven = proof.clash.minimal = false;
  return proof;
}

}  // namespace layoutbox::placement
