#include "layoutbox/serve/event_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

namespace layoutbox::serve {
namespace {

constexpr auto kLook = std::chrono::milliseconds(50);
constexpr auto kBetweenNumbers = std::chrono::milliseconds(100);

std::string event_text(std::string_view name, std::string_view data) {
  std::string text = "event: ";
  text += name;
  for (std::size_t begin = 0; begin < data.size();) {
    const std::size_t end = std::min(data.find('\n', begin), data.size());
    (text += "\ndata: ") += data.substr(begin, end - begin);
    begin = end + 1;
  }
  return text + "\n\n";
}

}  // namespace

EventStream::EventStream(httplib::DataSink& sink, std::function<bool()> ending)
    : sink_(sink), ending_(std::move(ending)), watch_([this] { watch(); }) {}

EventStream::~EventStream() {
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  ended_.notify_one();
  watch_.join();
}

bool EventStream::send(std::string_view event, std::string_view data) {
  const std::string text = event_text(event, data);
  const std::lock_guard lock(mutex_);
  return !hung_up_ && sink_.write(text.data(), text.size());
}

void EventStream::send_now_and_then(std::string_view event, double number) {
  if (Clock::now() - last_ < kBetweenNumbers) return;
  last_ = Clock::now();
  send(event, fmt::format("{:.2f}", number));
}

void EventStream::watch() {
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, kLook, [this] { return done_; }) && !stop_) {
    hung_up_ = !sink_.is_writable();
    stop_ = hung_up_ || ending_();
  }
}

}  // namespace layoutbox::serve
