#include "layoutbox/chat/retry.h"

#include <algorithm>
#include <cmath>

namespace layoutbox::chat {

TryOutcome outcome_of_status(int status) {
  if (status >= 200 && status < 300) return TryOutcome::kResponse;
  switch (status) {
    case 408:
    case 409:
    case 429:
    case 500:
    case 502:
    case 503:
    case 504:
    case 529: return TryOutcome::kBusy;
    default: return TryOutcome::kFinal;
  }
}

TryOutcome outcome_of_fault(HttpFault fault) {
  switch (fault) {
    case HttpFault::kCut:
    case HttpFault::kTimeout: return TryOutcome::kBusy;
    case HttpFault::kResolve:
    case HttpFault::kConnect: return TryOutcome::kUnclear;
    default: return TryOutcome::kFinal;
  }
}

RetryPolicy::RetryPolicy(const RetryOptions& options, std::uint64_t jitter_seed) : options_(options), random_(jitter_seed) {}

std::optional<double> RetryPolicy::wait_after(TryOutcome outcome, std::optional<double> retry_after_s, double elapsed_s) {
  if (outcome != TryOutcome::kBusy && outcome != TryOutcome::kUnclear) return std::nullopt;
  if (retries_ >= options_.max_retries) return std::nullopt;
  if (outcome == TryOutcome::kUnclear && quick_retries_ >= options_.max_quick_retries) return std::nullopt;
  const double doubled = options_.first_delay_s * std::pow(2.0, retries_);
  double wait = std::min(doubled, options_.longest_delay_s) * (0.75 + random_.fraction() / 2);
  if (retry_after_s) wait = std::max(wait, *retry_after_s * 1.02 + 0.05);  // a little later rather than too early
  if (elapsed_s + wait >= options_.total_s) return std::nullopt;
  ++retries_;
  quick_retries_ += outcome == TryOutcome::kUnclear;
  return wait;
}

}  // namespace layoutbox::chat
