// Is there a better layout? For rooms of few things CP-SAT answers, with the cost of the best layout found as the bound.
#include "layoutbox/solve/cp_sat/library.h"
#include "layoutbox/solve/objective/cost.h"
#include "layoutbox/solve/search/search.h"
#include "layoutbox/solve/solving.h"

namespace layoutbox::placement {
namespace {

constexpr std::size_t kFew = 4, kFewOpenings = 3;  // objects, doors and windows
constexpr int kMostQuestions = 12;
constexpr std::int64_t kPolish = 20'000;  // steps

}  // namespace

void Solver::prove_best() {
  std::size_t openings = 0;
  for (const Item& item : model_.items) openings += item.is_opening();
  const bool few = model_.items.size() - openings <= kFew && openings <= kFewOpenings;
  if (!few || budgets_.best_proof <= 0 || !options_.prove || !model_.start.empty() || !relaxed_.empty() || !left_out_ids_.empty() ||
      must_stop())
    return;
  std::int64_t best = cost();
  proven_best_ = best < kPoint;  // nothing costs less than nothing
  const auto library = CpSatLibrary::get();
  if (proven_best_ || !library) return;
  used_cp_sat_ = true;
  double time = budgets_.best_proof;
  bool access = false;
  for (int question = 0; question < kMostQuestions && time > 0 && !must_stop(); ++question) {
    Encoding encoding(model_, scope_);
    encoding.bound_cost(best - kPoint, access);
    CpParameters parameters;
    parameters.seed = options_.seed, parameters.presolve = parameters.inclusions = true;
    parameters.deterministic_time = time;
    const std::string model = encoding.bytes(std::vector<char>(encoding.demands().size(), 1));
    const std::string bytes = (*library)->solve(model, write_parameters(parameters), options_.stop, options_.time_limit_s - seconds());
    const auto answer = read_answer(bytes, encoding.variable_count());
    if (!answer) return;
    time -= answer->deterministic_time;
    if (answer->status == CpStatus::kInfeasible) proven_best_ = true;
    if (answer->status != CpStatus::kFeasible && answer->status != CpStatus::kOptimal) {
      must_stop();  // notes that it was the clock, if it was
      return;
    }
    Search search(model_, scope_, options_.seed, size_limit_);
    search.adopt(encoding.placements_of(answer->values));
    Budget polish{0, kPolish, [this] { return must_stop(); }, false};
    search.improve(polish, kPatience);
    Placements better = search.placements();
    std::swap(placements_, better);
    if (const std::int64_t now = cost(); now < best) {
      best = now;
      continue;
    }
    std::swap(placements_, better);
    if (access) return;  // what is better there has worse ways
    access = true;
  }
}

}  // namespace layoutbox::placement
