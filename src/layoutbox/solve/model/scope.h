// What a question about a model is asked of: all of it but what is given up and left out.
#pragma once

#include <cstddef>
#include <vector>

namespace layoutbox::placement {

// By index; what is past the end of a list is not in it.
struct Scope {
  std::vector<char> given_up;  // constraints: they need not hold
  std::vector<char> left_out;  // items: not there at all; what speaks of them cannot hold

  bool gives_up(int constraint) const { return has(given_up, constraint); }
  bool leaves_out(int item) const { return has(left_out, item); }

 private:
  static bool has(const std::vector<char>& list, int index) {
    const auto i = static_cast<std::size_t>(index);  // −1, which is none, is past the end
    return i < list.size() && list[i] != 0;
  }
};

}  // namespace layoutbox::placement
