// The small form where only one item is free and all else stays: forms of its position alone, and the boxes of positions that are left.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "layoutbox/solve/model/formula.h"

namespace layoutbox::placement {

inline constexpr std::int64_t kNoCost = std::numeric_limits<std::int64_t>::max() / 4;

// A linear form in which only the position of one item is free.
struct Partial {
  std::int64_t constant = 0;
  std::array<std::int32_t, 3> coefficient{};
  std::int32_t scale = 1;  // as of the form
  bool unknown = false;    // speaks of something else that is not placed; `constant` then has the most that can add

  std::int64_t at(const Vec3& p) const {
    return constant + std::int64_t{coefficient[0]} * p[0] + std::int64_t{coefficient[1]} * p[1] + std::int64_t{coefficient[2]} * p[2];
  }
  // The only axis with a coefficient; −1: none, −2: several.
  int axis() const {
    int found = -1;
    for (int k = 0; k < 3; ++k) {
      if (coefficient[k] == 0) continue;
      if (found >= 0) return -2;
      found = k;
    }
    return found;
  }
};

struct Wish {
  Partial form;
  std::int32_t weight = 1, scale = 1;
  std::int64_t cost(const Vec3& at) const { return cost_of(form.at(at)); }
  // Of the form's value. Nearly all scales are 1, and a division takes as long as all the rest.
  std::int64_t cost_of(std::int64_t value) const {
    const std::int64_t whole = std::abs(value) * weight;
    return scale == 1 ? whole : whole / scale;
  }
};

// A case in which only the item at hand is free.
struct Reduced {
  Vec3 lo{-(1 << 29), -(1 << 29), -(1 << 29)}, hi{1 << 29, 1 << 29, 1 << 29};
  std::vector<Partial> checks;  // over several axes; for soft cases all forms
  std::vector<Wish> wishes;
  std::int64_t price = 0;
  std::int64_t miss = 0;  // soft cases: whatever the position
};

struct Region {
  Vec3 lo{}, hi{};
  std::vector<const Reduced*> cases;  // those that check or wish anything
  std::int64_t price = 0;
  bool empty() const { return lo[0] > hi[0] || lo[1] > hi[1] || lo[2] > hi[2]; }
};

inline bool holds_at(const Region& region, const Vec3& at) {
  return std::all_of(region.cases.begin(), region.cases.end(), [&](const Reduced* one) {
    return std::all_of(one->checks.begin(), one->checks.end(), [&](const Partial& check) { return check.at(at) >= 0; });
  });
}

// Something wished for: its cases where only the item at hand is free, and points per metre missed.
struct SoftFormula {
  std::int64_t weight = 0;
  std::vector<Reduced> cases;
  std::size_t count = 0;  // of them; after them are such as were used before
  std::span<const Reduced> all() const { return {cases.data(), count}; }
};

}  // namespace layoutbox::placement
