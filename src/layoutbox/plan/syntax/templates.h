// Joint features: what the two files of features share.
#pragma once

#include <array>
#include <cstddef>

#include "layoutbox/plan/syntax/features.h"

namespace layoutbox::syntax {

// Atoms are small facts; a template is a set of them (at most five) whose joint values are a feature.
using Atom = std::uint8_t;
using Template = std::array<Atom, 5>;
constexpr Atom kNone = 0xff;

template <typename Atoms>
void combine(const Atoms& atoms, std::span<const Template> templates, std::uint64_t salt, Features& features) {
  features.clear();
  for (const Template& parts : templates) {
    salt += 0x9e3779b97f4a7c15ULL;
    std::uint64_t key = salt;
    for (const Atom part : parts) {
      if (part == kNone) break;
      key = (key ^ atoms[part]) * 0xff51afd7ed558ccdULL;
      key ^= key >> 32;
    }
    features.push_back(scatter(key));
  }
}

template <typename... Parts>
constexpr Template of(Parts... parts) {
  Template made{kNone, kNone, kNone, kNone, kNone};
  std::size_t i = 0;
  ((made[i++] = static_cast<Atom>(parts)), ...);
  return made;
}

}  // namespace layoutbox::syntax
