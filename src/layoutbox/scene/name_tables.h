// Names of enums as they stand in JSON, one list per enum in the order of its values: both directions read it.
#pragma once

#include <optional>
#include <string_view>

#include "layoutbox/scene/scene_graph.h"

namespace layoutbox {

inline constexpr std::string_view kMountNames[] = {"floor", "wall", "ceiling", "surface", "hung"};
inline constexpr std::string_view kSideNames[] = {"front", "back", "left", "right", "top", "bottom", "long", "short"};
inline constexpr std::string_view kAxisNames[] = {"X", "Y", "Z"};
inline constexpr std::string_view kEdgeNames[] = {"center", "left", "right", "front", "back", "bottom", "top", "min", "max"};
inline constexpr std::string_view kRegionNames[] = {"middle",     "left",        "right",     "front",     "back",
                                                    "front left", "front right", "back left", "back right"};
inline constexpr std::string_view kPartWordNames[] = {"back", "front", "left", "right", "center", "corner", "edge", "end", "top"};
inline constexpr std::string_view kOpeningTypeNames[] = {"door", "window", "open"};
inline constexpr std::string_view kSwingNames[] = {"in-left", "in-right", "out-left", "out-right", "sliding", "none"};
inline constexpr std::string_view kSizeSourceNames[] = {"unknown", "catalog", "inferred", "user"};
inline constexpr std::string_view kOriginNames[] = {"asked", "concluded", "added", "assumed"};
inline constexpr std::string_view kLayoutStatusNames[] = {"solved", "relaxed", "fallback"};

template <class Enum, std::size_t N>
std::string_view name_in(const std::string_view (&names)[N], Enum value) {
  return names[static_cast<std::size_t>(value)];
}

template <class Enum, std::size_t N>
std::optional<Enum> value_in(const std::string_view (&names)[N], std::string_view name) {
  for (std::size_t i = 0; i < N; ++i) {
    if (same_name(names[i], name)) return static_cast<Enum>(i);
  }
  return std::nullopt;
}

}  // namespace layoutbox
