// Server-sent events of one answer that is still being worked at, and whether anybody waits for it.
#pragma once

#include <httplib.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string_view>
#include <thread>

namespace layoutbox::serve {

class EventStream {
 public:
  // `ending`: does the service end? REQUIRES: both outlive it.
  EventStream(httplib::DataSink& sink, std::function<bool()> ending);
  ~EventStream();
  EventStream(const EventStream&) = delete;
  EventStream& operator=(const EventStream&) = delete;

  // The data may have several lines. False: nobody is there.
  bool send(std::string_view event, std::string_view data);
  // A number, but not often.
  void send_now_and_then(std::string_view event, double number);

  // Set once the far end has hung up or the service ends.
  const std::atomic<bool>& stop() const { return stop_; }
  bool hung_up() const { return hung_up_; }

 private:
  using Clock = std::chrono::steady_clock;

  void watch();

  httplib::DataSink& sink_;
  std::function<bool()> ending_;
  std::atomic<bool> stop_{false}, hung_up_{false};
  std::mutex mutex_;  // of the sink
  std::condition_variable ended_;
  bool done_ = false;
  Clock::time_point last_ = Clock::now();
  std::thread watch_;
};

}  // namespace layoutbox::serve
