#include "layoutbox/catalog/measures.h"

#include <nlohmann/json.hpp>

#include "layoutbox/embedded/catalog_data.h"

namespace layoutbox {
namespace {

Measures read_measures() {
  const nlohmann::json rows = nlohmann::json::parse(embedded::groups_json).at("measures");
  Measures read;
#define LAYOUTBOX_MEASURE(field, key) read.field = mm_from_m(rows.at(key).at("m").get<double>());
#include "layoutbox/catalog/measure_list.inc"
#undef LAYOUTBOX_MEASURE
  return read;
}

}  // namespace

const Measures& measures() {
  static const Measures all = read_measures();
  return all;
}

}  // namespace layoutbox
