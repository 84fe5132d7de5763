// Which positions of one layer of a grid are taken by what stands there, a bit each: most are, and what they cost is not asked.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "layoutbox/solve/model/geometry.h"

namespace layoutbox::placement {

class TakenCells {
 public:
  // REQUIRES: both are in order, and stay as they are while this is asked.
  void start(const std::vector<Mm>& xs, const std::vector<Mm>& ys) {
    xs_ = &xs, ys_ = &ys;
    words_ = xs.size() / kBits + 1;
    taken_.assign(words_ * ys.size(), 0);
  }

  // All inside of the box.
  void add(const Vec3& lo, const Vec3& hi) {
    const auto [x_first, x_end] = inside(*xs_, lo[0], hi[0]);
    const auto [y_first, y_end] = inside(*ys_, lo[1], hi[1]);
    if (x_first == x_end) return;
    for (std::size_t word = x_first / kBits; word <= (x_end - 1) / kBits; ++word) {
      const std::size_t begin = word * kBits, from = std::max(x_first, begin) - begin, to = std::min(x_end, begin + kBits) - begin;
      const std::uint64_t bits = (~std::uint64_t{0} >> (kBits - (to - from))) << from;
      for (std::size_t y = y_first; y < y_end; ++y) taken_[y * words_ + word] |= bits;
    }
  }

  // The first of the row from the x-th on that is not taken; as many as there are: none.
  std::size_t next_free(std::size_t y, std::size_t x) const {
    for (std::size_t word = x / kBits; word < words_; ++word) {
      const std::size_t begin = word * kBits;
      const std::uint64_t passed = x > begin ? (std::uint64_t{1} << (x - begin)) - 1 : 0;
      const std::uint64_t free = ~(taken_[y * words_ + word] | passed);
      if (free != 0) return std::min(begin + static_cast<std::size_t>(std::countr_zero(free)), xs_->size());
    }
    return xs_->size();
  }

 private:
  static constexpr std::size_t kBits = 64;

  static std::pair<std::size_t, std::size_t> inside(const std::vector<Mm>& values, Mm lo, Mm hi) {
    const auto first = std::upper_bound(values.begin(), values.end(), lo), end = std::lower_bound(first, values.end(), hi);
    return {static_cast<std::size_t>(first - values.begin()), static_cast<std::size_t>(end - values.begin())};
  }

  const std::vector<Mm>*xs_ = nullptr, *ys_ = nullptr;
  std::size_t words_ = 0;
  std::vector<std::uint64_t> taken_;  // row by row
};

}  // namespace layoutbox::placement
