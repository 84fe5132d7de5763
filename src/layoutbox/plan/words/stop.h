// Ending the reading from outside.
#pragma once

#include <atomic>

namespace layoutbox::offline {

// Asked in every loop over the text: when it becomes true the loop ends with what was read so far. Null: nobody stops it.
using StopFlag = const std::atomic<bool>*;

inline bool is_set(StopFlag stop) { return stop != nullptr && stop->load(std::memory_order_relaxed); }

}  // namespace layoutbox::offline
