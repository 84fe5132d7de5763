// Reading the catalogue's data; see schema/catalog.schema.json for its form.
#pragma once

#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/catalog.h"

namespace layoutbox {

struct CatalogData {
  std::vector<CatalogEntry> entries;
  std::vector<RoomKind> rooms;
};

// Adds the entries and rooms of one file. REQUIRES: text that is valid by the schema (a wrong type is an Error all the same).
Status read_catalog_data(std::string_view json, CatalogData& data);

// The same for text that nobody has checked: against the schema first, with all violations at once.
Status read_checked_catalog_data(std::string_view json, CatalogData& data);

// What the schema cannot say: ids and words used twice, names of nothing, spaces that leave their box; one error each.
std::vector<Error> check_catalog_data(const CatalogData& data);

}  // namespace layoutbox
