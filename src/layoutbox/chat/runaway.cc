#include "layoutbox/chat/runaway.h"

#include <algorithm>
#include <cstddef>

namespace layoutbox::chat {

bool runs_away(std::string_view text) {
  constexpr std::size_t kWindow = 900, kLongestPeriod = 150, kBlanks = 300;
  const auto is_blank = [](char c) { return static_cast<unsigned char>(c) <= ' '; };
  if (text.size() >= kBlanks && std::ranges::all_of(text.substr(text.size() - kBlanks), is_blank)) return true;
  if (text.size() < kWindow) return false;
  const std::string_view end = text.substr(text.size() - kWindow);
  for (std::size_t period = 1; period <= kLongestPeriod; ++period) {
    if (end.substr(period) == end.substr(0, kWindow - period)) return true;
  }
  return false;
}

}  // namespace layoutbox::chat
