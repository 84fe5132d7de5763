// A set of traits: what a kind of furniture is to the code. The traits themselves are in trait_table.h, so that a new one is news only to
// those who ask for it.
#pragma once

#include <cstdint>

namespace layoutbox {

enum class Trait : std::uint8_t;

class Traits {
 public:
  bool has(Trait trait) const { return (bits_ >> static_cast<unsigned>(trait)) & 1; }
  void set(Trait trait) { bits_ |= std::uint64_t{1} << static_cast<unsigned>(trait); }
  void add(Traits others) { bits_ |= others.bits_; }
  void remove(Traits others) { bits_ &= ~others.bits_; }
  friend bool operator==(Traits, Traits) = default;

 private:
  std::uint64_t bits_ = 0;
};

}  // namespace layoutbox
