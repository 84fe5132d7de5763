// Random numbers that are the same on every machine and with every library.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace layoutbox {

// SplitMix64 (G. L. Steele, D. Lea, C. H. Flood: Fast Splittable Pseudorandom Number Generators, OOPSLA 2014).
// std::shuffle and the distributions of the standard library differ from one library to the next; these do not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  // 0 … bound − 1, each as likely as any other (a remainder alone would prefer the small ones). REQUIRES: bound > 0.
  template <std::integral Number>
  Number below(Number bound) {
    const auto many = static_cast<std::uint64_t>(bound);
    const std::uint64_t uneven = (0 - many) % many;  // 2^64 mod bound: as many of the smallest numbers are drawn again
    std::uint64_t number = next();
    while (number < uneven) number = next();
    return static_cast<Number>(number % many);
  }

  // 0 ≤ number < 1.
  double fraction() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

  // Every order of the items as likely as any other (Fisher and Yates).
  template <class Items>
  void shuffle(Items& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
  }

 private:
  std::uint64_t state_;
};

}  // namespace layoutbox
