#include "layoutbox/chat/spend_limit.h"

#include <chrono>

namespace layoutbox::chat {

SpendLimit::Draw SpendLimit::fits(const Amount& taken, const Amount& most) const {
  if (max_tokens && taken.tokens + most.tokens >= *max_tokens) return Draw::kTooManyTokens;
  if (max_cost && taken.cost + most.cost > *max_cost) return Draw::kTooDear;
  return Draw::kDone;
}

SpendLimit::Draw SpendLimit::set_aside(const Amount& most, const std::atomic<bool>* stop) {
  std::unique_lock lock(mutex_);
  for (;;) {
    if (const Draw without_others = fits(spent_, most); without_others != Draw::kDone) return without_others;
    if (fits({spent_.cost + aside_.cost, spent_.tokens + aside_.tokens}, most) == Draw::kDone) break;
    if (stop != nullptr && stop->load()) return Draw::kStopped;
    settled_.wait_for(lock, std::chrono::milliseconds(100));  // the stop flag tells nobody
  }
  aside_.cost += most.cost;
  aside_.tokens += most.tokens;
  return Draw::kDone;
}

void SpendLimit::settle(const Amount& most, const Amount& actual) {
  const std::lock_guard guard(mutex_);
  aside_.cost -= most.cost;
  aside_.tokens -= most.tokens;
  spent_.cost += actual.cost;
  spent_.tokens += actual.tokens;
  settled_.notify_all();
}

Amount SpendLimit::spent() const {
  const std::lock_guard guard(mutex_);
  return spent_;
}

}  // namespace layoutbox::chat
