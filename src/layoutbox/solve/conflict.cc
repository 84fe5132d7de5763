#include "layoutbox/solve/conflict.h"

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

}  // namespace

Result<Proof> decide(const Model& model, const CpSatLibrary& library, const std::vector<char>& given_up, const std::vector<char>& left_out,
                     const Placements& hint, const ProofLimits& limits) {
  Encoding encoding(model, given_up, left_out);
  encoding.hint(hint);
  LAYOUTBOX_ASSIGN(const CpAnswer answer, ask(encoding, library, std::vector<char>(encoding.demands().size(), 1), limits));
  Proof proof;
  proof.deterministic_time = answer.deterministic_time;
  switch (answer.status) {
    case CpStatus::kFeasible:
    case CpStatus::kOptimal:
      proof.outcome = Proof::Outcome::kLayout;
      proof.placements = encoding.placements_of(answer.values);
      break;
    case CpStatus::kInfeasible: {
      proof.outcome = Proof::Outcome::kClash;
      std::vector<std::size_t> core = encoding.demands_in(answer.core);
      if (core.empty()) {  // impossible without any assumption, or the core is not said: start from everything
        for (std::size_t d = 0; d < encoding.demands().size(); ++d) core.push_back(d);
      }
      // Items first: a clash of few objects says more than one of few relations.
      std::stable_sort(core.begin(), core.end(), [&](std::size_t a, std::size_t b) {
        return encoding.demands()[a].kind == Demand::Kind::kItem && encoding.demands()[b].kind != Demand::Kind::kItem;
      });
      LAYOUTBOX_ASSIGN(proof.clash, shrink(encoding, library, std::move(core), limits, proof.deterministic_time));
      break;
    }
    default: break;
  }
  return proof;
}

}  // namespace layoutbox::placement
