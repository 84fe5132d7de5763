// How many calls work at a time, how many wait, and what came of them.
#pragma once

#include <condition_variable>
#include <map>
#include <mutex>
#include <string>

namespace layoutbox::serve {

// Lets so many work at a time; the others wait, up to a number.
class Gate {
 public:
  Gate(int places, int longest_queue) : free_(places), longest_queue_(longest_queue) {}
  // False where too many wait already. Else leave() must follow.
  bool enter();
  void leave();
  int waiting() const;

 private:
  mutable std::mutex mutex_;
  std::condition_variable freed_;
  int free_, longest_queue_, waiting_ = 0;
};

// Counts of answers by operation and status, and the seconds that they took: what /metrics prints.
class Metrics {
 public:
  void add(const std::string& operation, int status, double seconds);
  // Prometheus' text format 0.0.4.
  std::string text() const;

 private:
  struct Row {
    std::map<int, long> answers;
    double seconds = 0;
  };
  mutable std::mutex mutex_;
  std::map<std::string, Row> rows_;
};

}  // namespace layoutbox::serve
