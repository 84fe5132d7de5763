// The symbols that plan_symbols.cc chooses from: each draws an object by its pen, at its size.
#pragma once

#include "layoutbox/export/plan_pen.h"

namespace layoutbox {

void draw_bed(Pen& pen, const PlacedObject& object);
void draw_sofa(Pen& pen, const PlacedObject& object);
void draw_chair(Pen& pen, const PlacedObject& object);
void draw_round_seat(Pen& pen, const PlacedObject& object);
void draw_bench(Pen& pen, const PlacedObject& object);
void draw_table(Pen& pen, const PlacedObject& object);
void draw_desk(Pen& pen, const PlacedObject& object);
void draw_wardrobe(Pen& pen, const PlacedObject& object);
void draw_shelf(Pen& pen, const PlacedObject& object);
void draw_storage(Pen& pen, const PlacedObject& object);
void draw_plant(Pen& pen, const PlacedObject& object);
void draw_lamp(Pen& pen, const PlacedObject& object);
void draw_rug(Pen& pen, const PlacedObject& object);
void draw_toilet(Pen& pen, const PlacedObject& object);
void draw_basin(Pen& pen, const PlacedObject& object);
void draw_tub(Pen& pen, const PlacedObject& object);
void draw_shower(Pen& pen, const PlacedObject& object);
void draw_stove(Pen& pen, const PlacedObject& object);
void draw_kitchen_sink(Pen& pen, const PlacedObject& object);
void draw_appliance(Pen& pen, const PlacedObject& object);
void draw_screen(Pen& pen, const PlacedObject& object);
void draw_piano(Pen& pen, const PlacedObject& object);
void draw_flat(Pen& pen, const PlacedObject& object);
void draw_curtain(Pen& pen, const PlacedObject& object);
void draw_box(Pen& pen, const PlacedObject& object);
void draw_treadmill(Pen& pen, const PlacedObject& object);
void draw_bike(Pen& pen, const PlacedObject& object);
void draw_exercise_bike(Pen& pen, const PlacedObject& object);
void draw_barbell(Pen& pen, const PlacedObject& object);
void draw_drums(Pen& pen, const PlacedObject& object);
void draw_mannequin(Pen& pen, const PlacedObject& object);
void draw_laptop(Pen& pen, const PlacedObject& object);
void draw_glass_case(Pen& pen, const PlacedObject& object);
void draw_round_thing(Pen& pen, const PlacedObject& object);
void draw_pool_table(Pen& pen, const PlacedObject& object);
void draw_boxing_ring(Pen& pen, const PlacedObject& object);
void draw_net_table(Pen& pen, const PlacedObject& object);
void draw_roof_slope(Pen& pen, const PlacedObject& object);

}  // namespace layoutbox
