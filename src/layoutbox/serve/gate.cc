#include "layoutbox/serve/gate.h"

#include <fmt/format.h>

namespace layoutbox::serve {

bool Gate::enter() {
  std::unique_lock lock(mutex_);
  if (free_ == 0 && waiting_ >= longest_queue_) return false;
  ++waiting_;
  freed_.wait(lock, [&] { return free_ > 0; });
  --waiting_;
  --free_;
  return true;
}

void Gate::leave() {
  {
    const std::lock_guard lock(mutex_);
    ++free_;
  }
  freed_.notify_one();
}

int Gate::waiting() const {
  const std::lock_guard lock(mutex_);
  return waiting_;
}

void Metrics::add(const std::string& operation, int status, double seconds) {
  const std::lock_guard lock(mutex_);
  Row& row = rows_[operation];
  ++row.answers[status];
  row.seconds += seconds;
}

std::string Metrics::text() const {
  const std::lock_guard lock(mutex_);
  std::string text = "# TYPE layoutbox_answers_total counter\n";
  for (const auto& [operation, row] : rows_) {
    for (const auto& [status, count] : row.answers) {
      text += fmt::format("layoutbox_answers_total{{operation=\"{}\",status=\"{}\"}} {}\n", operation, status, count);
    }
  }
  text += "# TYPE layoutbox_answer_seconds_total counter\n";
  for (const auto& [operation, row] : rows_) {
    text += fmt::format("layoutbox_answer_seconds_total{{operation=\"{}\"}} {:.6f}\n", operation, row.seconds);
  }
  return text;
}

}  // namespace layoutbox::serve
