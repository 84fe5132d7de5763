// What stands in rows, and how.
#pragma once

#include "layoutbox/catalog/catalog.h"
#include "layoutbox/catalog/trait_table.h"

namespace layoutbox {

// Lockers, washing machines, shelves: what stands at walls and nobody sits or lies at touches its like in a row.
inline bool stands_close(const CatalogEntry& kind) {
  return kind.mount == Mount::kFloor && kind.back_to_wall && !kind.is(Trait::kSeat) && !kind.is(Trait::kEasySeat) &&
         !kind.is(Trait::kBed) && !kind.is(Trait::kTable);
}

}  // namespace layoutbox
