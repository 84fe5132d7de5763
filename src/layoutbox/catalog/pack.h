// The catalogue as bytes that are read in a millisecond: made from catalog/*.json when the program is built (cmake/pack_catalog.cc), read
// when it starts. Made and read on the same machine by the same code; no format for files.
#pragma once

#include <string>
#include <string_view>

#include "layoutbox/catalog/catalog_json.h"

namespace layoutbox {

std::string pack_catalog(const CatalogData& data, const CatalogIndex& index);

// REQUIRES: bytes that pack_catalog made.
void unpack_catalog(std::string_view bytes, CatalogData& data, CatalogIndex& index);

}  // namespace layoutbox
