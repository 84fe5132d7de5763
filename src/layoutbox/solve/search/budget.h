// What a search spends: random numbers that are the same everywhere, and steps of work.
#pragma once

#include <cstdint>
#include <functional>

namespace layoutbox::placement {

// A small generator whose numbers are the same everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15u + 0x1234567) {}
  std::uint64_t next() {
    state_ ^= state_ << 13, state_ ^= state_ >> 7, state_ ^= state_ << 17;
    return state_ * 0x2545F4914F6CDD1Du;
  }
  // 0 … bound − 1. REQUIRES: bound > 0.
  std::int64_t below(std::int64_t bound) { return static_cast<std::int64_t>((next() >> 33) % static_cast<std::uint64_t>(bound)); }

 private:
  std::uint64_t state_;
};

// How much work has been done and may be; a step is the trial of one candidate position.
struct Budget {
  std::int64_t steps = 0;
  std::int64_t limit = 0;
  std::function<bool()> stop;  // asked now and then
  bool stopped = false;
  Budget* whole = nullptr;  // of which this is a part: steps count there too
  std::int64_t work = 0;    // what is no step and takes time all the same: the stop is asked for it too

  bool spent() const { return stopped || steps >= limit; }
  void count(std::int64_t more) {
    const std::int64_t before = steps;
    steps += more;
    if (whole != nullptr) whole->steps += more;
    if ((before >> 12) != (steps >> 12) && stop && stop()) stopped = true;
  }
  void toil(std::int64_t more) {
    const std::int64_t before = work;
    work += more;
    if (whole != nullptr) whole->steps += more;
    if ((before >> 14) != (work >> 14) && stop && stop()) stopped = true;
  }
};

}  // namespace layoutbox::placement
