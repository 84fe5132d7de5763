// What was knocked over lies on its side: its size as it lies, and as it is drawn.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "layoutbox/catalog/catalog.h"

namespace layoutbox {

inline bool is_toppled(const std::vector<std::string>& attributes, Mount mount) {
  return mount == Mount::kFloor && std::ranges::find(attributes, "overturned") != attributes.end();
}

// It falls to the side that its kind is narrower along.
inline bool falls_sideways(const CatalogEntry& entry) { return entry.size.usual.width <= entry.size.usual.depth; }

// As it lies where it stood, and the other way round.
inline Size toppled(const CatalogEntry& entry, Size size) {
  std::swap(falls_sideways(entry) ? size.width : size.depth, size.height);
  return size;
}

}  // namespace layoutbox
