#include "layoutbox/export/plan_symbols.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "layoutbox/base/units.h"
#include "layoutbox/catalog/catalog.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/export/plan_symbol_list.h"

namespace layoutbox {
namespace {

struct SymbolRow {
  std::string_view name;  // as in catalog/shapes.json
  void (*draw)(Pen&, const PlacedObject&);
};

constexpr SymbolRow kSymbols[] = {
    {"bed", draw_bed},
    {"sofa", draw_sofa},
    {"chair", draw_chair},
    {"round_seat", draw_round_seat},
    {"bench", draw_bench},
    {"table", draw_table},
    {"desk", draw_desk},
    {"wardrobe", draw_wardrobe},
    {"shelf", draw_shelf},
    {"storage", draw_storage},
    {"plant", draw_plant},
    {"lamp", draw_lamp},
    {"rug", draw_rug},
    {"toilet", draw_toilet},
    {"basin", draw_basin},
    {"tub", draw_tub},
    {"shower", draw_shower},
    {"stove", draw_stove},
    {"kitchen_sink", draw_kitchen_sink},
    {"appliance", draw_appliance},
    {"screen", draw_screen},
    {"piano", draw_piano},
    {"flat", draw_flat},
    {"curtain", draw_curtain},
    {"treadmill", draw_treadmill},
    {"bike", draw_bike},
    {"exercise_bike", draw_exercise_bike},
    {"barbell", draw_barbell},
    {"drums", draw_drums},
    {"mannequin", draw_mannequin},
    {"laptop", draw_laptop},
    {"glass_case", draw_glass_case},
    {"round_thing", draw_round_thing},
    {"pool_table", draw_pool_table},
    {"net_table", draw_net_table},
    {"boxing_ring", draw_boxing_ring},
    {"roof_slope", draw_roof_slope},
};

}  // namespace

double plan_height(const PlacedObject& object, const Catalog& catalog) {
  const CatalogEntry& entry = catalog.entry_or_nearest(object.category);
  if (entry.is(Trait::kRoofSlope)) return 9e5;
  if (object.mount == Mount::kCeiling) return 1e6;
  const bool seat = entry.is(Trait::kSeat) && !entry.is(Trait::kEasySeat);
  return object.position[2] + (seat ? std::min<double>(object.size.height, 460) : object.size.height);
}

bool has_symbol(std::string_view name) {
  return std::any_of(std::begin(kSymbols), std::end(kSymbols), [&](const SymbolRow& row) { return row.name == name; });
}

void draw_symbol(Canvas& page, const PlanScale& scale, const PlacedObject& object, const Catalog& catalog) {
  const CatalogEntry& entry = catalog.entry_or_nearest(object.category);
  Pen pen(page, scale, object, entry.shape.family);
  if (object.mount == Mount::kCeiling && !entry.is(Trait::kRoofSlope)) {
    pen.style.dash = "0.8 0.6";
    pen.style.fill = "none";
    const bool round = std::abs(pen.w() - pen.d()) < 0.1 * pen.w();
    round ? pen.ellipse(0, 0, pen.w() / 2, pen.d() / 2) : pen.outline();
    pen.line(-0.2 * pen.w(), 0, 0.2 * pen.w(), 0);
    return pen.line(0, -0.2 * pen.d(), 0, 0.2 * pen.d());
  }
  const std::string_view symbol = entry.shape.symbol;
  const auto* row = std::find_if(std::begin(kSymbols), std::end(kSymbols), [&](const SymbolRow& r) { return r.name == symbol; });
  row != std::end(kSymbols) ? row->draw(pen, object) : draw_box(pen, object);
}

}  // namespace layoutbox
