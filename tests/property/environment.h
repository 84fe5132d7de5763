// What the environment asks of a test: how many rounds, from which seed.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace layoutbox {

inline std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* value = std::getenv(name);
  return value != nullptr ? std::strtoull(value, nullptr, 10) : otherwise;
}

}  // namespace layoutbox
