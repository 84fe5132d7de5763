// What may be spent on questions, by all who draw on it together.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>

namespace layoutbox::chat {

struct Amount {
  double cost = 0;  // US dollars
  std::int64_t tokens = 0;
};

// Several threads may draw on it.
class SpendLimit {
 public:
  std::optional<double> max_cost;          // empty: no limit. Not changed once somebody draws.
  std::optional<std::int64_t> max_tokens;  // of questions and answers; a question that begins below it is sent

  enum class Draw { kDone, kTooManyTokens, kTooDear, kStopped };

  // Sets `most` aside for a question. What is set aside for questions on their way may come back: where there would be enough without
  // them, waits for their answers.
  Draw set_aside(const Amount& most, const std::atomic<bool>* stop);
  // Takes `actual` out of what was set aside and puts the rest back. Called once for every kDone.
  void settle(const Amount& most, const Amount& actual);

  Amount spent() const;

 private:
  Draw fits(const Amount& taken, const Amount& most) const;

  mutable std::mutex mutex_;
  std::condition_variable settled_;
  Amount spent_, aside_;
};

}  // namespace layoutbox::chat
