// What was knocked over lies on its side, and what lies flat by nature hangs flat on a wall: its size as it is then, and as it is drawn.
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

// What lies by nature and hangs on a wall: a sword, a tray, a mat. Not what has its own size there ("wall-mounted"), nor what carries
// things.
inline bool hangs_flat(const CatalogEntry& entry, Mount mount) {
  constexpr Mm kFlat = 150;
  constexpr int kFlatter = 2;
  const Size& size = entry.size.usual;
  const bool lies = size.height <= kFlat && kFlatter * size.height <= std::min(size.width, size.depth);
  const bool knows = std::ranges::any_of(
      entry.variants, [](const SizeVariant& variant) { return std::ranges::find(variant.words, "wall-mounted") != variant.words.end(); });
  return mount == Mount::kWall && entry.mount != Mount::kWall && lies && !entry.top_carries && !knows;
}

// Slim things hang lengthwise, others with what was their far edge up.
inline bool hangs_lengthwise(const CatalogEntry& entry) {
  constexpr int kSlim = 3;
  return entry.size.usual.depth >= kSlim * entry.size.usual.width;
}

// As it hangs where it lay.
inline Size hung_flat(const CatalogEntry& entry, Size size) {
  if (hangs_lengthwise(entry)) return {size.depth, size.height, size.width};
  return {size.width, size.height, size.depth};
}

// The other way round.
inline Size laid_flat(const CatalogEntry& entry, Size size) {
  if (hangs_lengthwise(entry)) return {size.height, size.width, size.depth};
  return {size.width, size.height, size.depth};
}

}  // namespace layoutbox
