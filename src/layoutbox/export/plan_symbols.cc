#include "layoutbox/export/plan_symbols.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>
#include <string_view>

#include "layoutbox/base/units.h"
#include "layoutbox/export/plan_symbol_list.h"

namespace layoutbox {
namespace {

struct SymbolRow {
  std::initializer_list<std::string_view> words;  // of the category; the first row that has one of them draws
  void (*draw)(Pen&, const PlacedObject&);
  bool whole = false;  // only as a word of its own: a pan, no pantry
};

bool is_row_of(const SymbolRow& row, const std::string& category) {
  if (!row.whole) return has_word(category, row.words);
  const std::string padded = "_" + category + "_";
  return std::any_of(row.words.begin(), row.words.end(),
                     [&](std::string_view word) { return padded.find("_" + std::string(word) + "_") != std::string::npos; });
}

const SymbolRow kSymbols[] = {
    {{"bedside", "nightstand"}, draw_storage},
    {{"tub"}, draw_tub},
    {{"bed", "crib", "cot", "mattress"}, draw_bed},
    {{"rug", "carpet", "mat"}, draw_rug},
    {{"sofa", "couch", "armchair", "loveseat", "settee", "recliner"}, draw_sofa},
    {{"stool", "pouf", "ottoman", "bean_bag", "beanbag"}, draw_round_seat},
    {{"barbell", "weight_bench"}, draw_barbell},
    {{"workbench"}, draw_desk},
    {{"bench"}, draw_bench},
    {{"chair"}, draw_chair},
    {{"lamp", "light", "pendant", "chandelier", "sconce"}, draw_lamp},
    {{"desk"}, draw_desk},
    {{"tv_stand", "tv_console", "tv_unit", "sideboard", "dresser", "console"}, draw_storage},
    {{"kitchen_sink"}, draw_kitchen_sink},
    {{"pool_table", "billiard"}, draw_pool_table},
    {{"ping_pong", "table_tennis"}, draw_net_table},
    {{"tablet", "tablecloth"}, draw_flat},
    {{"table"}, draw_table},
    {{"toilet_brush", "toilet_paper"}, draw_round_thing},
    {{"toilet", "bidet"}, draw_toilet},
    {{"sink", "basin", "vanity"}, draw_basin},
    {{"shower"}, draw_shower},
    {{"stove", "cooker", "hob", "oven", "range"}, draw_stove},
    {{"fridge", "refrigerator", "freezer", "washing", "washer", "dryer"}, draw_appliance},
    {{"plant", "tree", "flower"}, draw_plant},
    {{"laptop"}, draw_laptop},
    {{"tv", "monitor", "screen", "television"}, draw_screen},
    {{"computer_keyboard"}, draw_flat},
    {{"piano", "keyboard"}, draw_piano},
    {{"drum_kit"}, draw_drums},
    {{"treadmill"}, draw_treadmill},
    {{"bike", "bicycle"}, draw_bike},
    {{"mannequin"}, draw_mannequin},
    {{"display_case", "showcase", "aquarium"}, draw_glass_case},
    {{"wardrobe", "closet", "clothing_rack", "clothes_rack"}, draw_wardrobe},
    {{"shelf", "bookcase", "rack"}, draw_shelf},
    {{"cabinet", "cupboard", "drawer", "chest", "locker", "counter", "island"}, draw_storage},
    {{"plate", "bowl", "vase", "glass", "cup", "mug", "candle", "bottle", "jar", "pot", "pan", "globe"}, draw_round_thing, true},
    {{"bin", "ball", "clock", "bucket", "barrel", "basket", "drum", "cake", "pizza", "trophy", "punching_bag", "pillar"},
     draw_round_thing,
     true},
    {{"curtain", "drape", "blind"}, draw_curtain},
    {{"mirror", "picture", "painting", "poster", "whiteboard", "board"}, draw_flat},
};

}  // namespace

double plan_height(const PlacedObject& object) {
  if (object.mount == Mount::kCeiling) return 1e6;
  const bool seat = has_word(object.category, {"chair", "stool", "bench"}) && !has_word(object.category, {"armchair", "recliner"});
  return object.position[2] + (seat ? std::min<double>(object.size.height, 460) : object.size.height);
}

void draw_symbol(Canvas& page, const PlanScale& scale, const PlacedObject& object) {
  Pen pen(page, scale, object);
  if (object.mount == Mount::kCeiling) {
    pen.style.dash = "0.8 0.6";
    pen.style.fill = "none";
    const bool round = std::abs(pen.w() - pen.d()) < 0.1 * pen.w();
    round ? pen.ellipse(0, 0, pen.w() / 2, pen.d() / 2) : pen.outline();
    pen.line(-0.2 * pen.w(), 0, 0.2 * pen.w(), 0);
    return pen.line(0, -0.2 * pen.d(), 0, 0.2 * pen.d());
  }
  for (const SymbolRow& row : kSymbols) {
    if (is_row_of(row, object.category)) return row.draw(pen, object);
  }
  draw_box(pen, object);
}

}  // namespace layoutbox
