// What a search spends: steps of work.
#pragma once

#include <cstdint>
#include <functional>

namespace layoutbox::placement {

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
  // Work that nobody has to pay for, but that the stop is asked for all the same.
  void heed(std::int64_t more) {
    const std::int64_t before = work;
    work += more;
    if ((before >> 14) != (work >> 14) && stop && stop()) stopped = true;
  }
};

}  // namespace layoutbox::placement
