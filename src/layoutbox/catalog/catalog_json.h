// Reading the catalogue's data; see schema/catalog.schema.json for its form.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "layoutbox/base/result.h"
#include "layoutbox/catalog/catalog.h"

namespace layoutbox {

// A family of shapes: how the floor plan draws it, and the numbers and words that its mesh is made by.
struct ShapeFamily {
  struct Number {
    double least = 0, most = 0;
    std::optional<double> usual;  // where an entry does not give it; none: by its size
  };
  struct Word {
    std::vector<std::string> values;   // empty: any
    std::optional<std::string> usual;  // where an entry does not give it; none: as the family sees fit
  };
  std::string symbol;
  std::map<std::string, Number> numbers;
  std::map<std::string, Word> words;
};

struct CatalogData {
  std::map<std::string, ShapeFamily> families;           // empty: shapes are not checked
  std::map<std::string, ShapeFamily::Word> shape_words;  // of all families
  std::vector<CatalogEntry> entries;
  std::vector<RoomKind> rooms;
};

// Adds the entries and rooms of one file. REQUIRES: text that is valid by the schema (a wrong type is an Error all the same).
Status read_catalog_data(std::string_view json, CatalogData& data);

// The same for text that nobody has checked: against the schema first, with all violations at once.
Status read_checked_catalog_data(std::string_view json, CatalogData& data);

// Gives each entry the traits of what it is a kind of, but for those that it is said to lack, and the symbol of its shape's family.
void inherit_from_kinds(CatalogData& data);

// What the schema cannot say: ids and words used twice, names of nothing, spaces that leave their box; one error each.
std::vector<Error> check_catalog_data(const CatalogData& data);

}  // namespace layoutbox
