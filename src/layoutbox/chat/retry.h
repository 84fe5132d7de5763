// When to ask a server again, and after what time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "layoutbox/base/random.h"
#include "layoutbox/chat/http_client.h"

namespace layoutbox::chat {

struct RetryOptions {
  int max_retries = 5;          // after the first request. REQUIRES: >= 0
  int max_quick_retries = 2;    // where waiting seldom helps: no address, no connection, an answer that is no JSON
  double first_delay_s = 0.5;   // doubled each time, then varied by a quarter either way
  double longest_delay_s = 30;  // of one delay of ours; a server may ask for more with Retry-After
  double total_s = 600;         // of all requests and delays of one question. REQUIRES: > 0
};

// What a request came to.
enum class TryOutcome {
  kResponse,  // 2xx with a whole answer
  kBusy,      // 408, 409, 429, 500, 502, 503, 504, 529; or cut off, or without an answer in time: again, with patience
  kUnclear,   // no connection, an empty or broken body: again, a few times
  kFinal,     // all else: never again
};

// Of a status alone.
TryOutcome outcome_of_status(int status);
TryOutcome outcome_of_fault(HttpFault fault);

// Counts the tries of one question.
class RetryPolicy {
 public:
  RetryPolicy(const RetryOptions& options, std::uint64_t jitter_seed);

  // Seconds to wait before the next try; empty when there must be none: kFinal, tries used up, or the wait would pass the total time.
  // `retry_after_s`: what the server asked for; never undercut.
  std::optional<double> wait_after(TryOutcome outcome, std::optional<double> retry_after_s, double elapsed_s);

  int retries() const { return retries_; }

 private:
  RetryOptions options_;
  int retries_ = 0, quick_retries_ = 0;
  Random random_;
};

}  // namespace layoutbox::chat
