// What anything becomes whose kind has no family of its own.
#include <algorithm>

#include "layoutbox/furnish/families/parts.h"

namespace layoutbox::kit {
namespace {

// By mount and proportions: a framed panel on a wall, a small case with a lid on a table, a cabinet-like body on the floor.
void generic(Piece& p) {
  const int body = p.main_accent("lacquer");
  if (p.spaces.empty() && std::min({p.w, p.d, p.h}) > 0.02 && p.h > 0.35 && p.mount() == Mount::kFloor) {
    const double plinth = 0.05;
    p.add(p.frame("oak"), box(sides(-p.w / 2 + 0.03, p.w / 2 - 0.03, -p.d / 2 + 0.03, p.d / 2 - 0.03, 0, plinth), 0.004));
    p.add(body, box(sides(-p.w / 2 + 0.006, p.w / 2 - 0.006, -p.d / 2 + 0.006, p.d / 2, plinth, p.h - 0.03), 0.012));
    p.add(p.frame("oak"), box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, p.h - 0.03, p.h), 0.008));
    p.add(p.frame("oak"), box(sides(-p.w / 2 + 0.05, p.w / 2 - 0.05, -p.d / 2 + 0.001, -p.d / 2 + 0.02, plinth + 0.06, p.h - 0.09), 0.004));
    return;
  }
  if (!p.spaces.empty()) {
    carcass(p, {p.body(), body, body, p.named("steel"), 0, 0, false, 0});
    return;
  }
  const double lid = p.h * 0.25;
  p.add(body, rounded_box(sides(-p.w / 2, p.w / 2, -p.d / 2, p.d / 2, 0, p.h - lid), std::min({p.w, p.d, p.h}) * 0.12, 3));
  p.add(p.frame("oak"),
        rounded_box(sides(-p.w / 2 + p.w * 0.02, p.w / 2 - p.w * 0.02, -p.d / 2 + p.d * 0.02, p.d / 2 - p.d * 0.02, p.h - lid * 1.3, p.h),
                    std::min({p.w, p.d, p.h}) * 0.1, 3));
}

}  // namespace

void add_generic(Families& to) { to["generic"] = generic; }

const Families& families() {
  static const Families all = [] {
    Families f;
    add_seats(f);
    add_sofas(f);
    add_tables(f);
    add_beds(f);
    add_cribs(f);
    add_storage(f);
    add_lamps(f);
    add_screens(f);
    add_textiles(f);
    add_wall_things(f);
    add_pictures(f);
    add_plants(f);
    add_lounge(f);
    add_kitchen(f);
    add_sinks(f);
    add_bath(f);
    add_tableware(f);
    add_small_things(f);
    add_devices(f);
    add_toys(f);
    add_music(f);
    add_gym(f);
    add_shop(f);
    add_vending(f);
    add_trade(f);
    add_games_and_clinic(f);
    add_workshop(f);
    add_hall(f);
    add_appliances(f);
    add_outdoor_things(f);
    add_things_on_tables(f);
    add_media(f);
    add_household(f);
    add_pastimes(f);
    add_worn_things(f);
    add_garden_things(f);
    add_clocks(f);
    add_odd_things(f);
    add_pocket_things(f);
    add_rolling_things(f);
    add_serving(f);
    add_roofs(f);
    add_seat_rows(f);
    add_modeled(f);
    add_generic(f);
    return f;
  }();
  return all;
}

Family family_or_generic(std::string_view name) {
  const auto found = families().find(name);
  return found != families().end() ? found->second : families().at("generic");
}

}  // namespace layoutbox::kit
