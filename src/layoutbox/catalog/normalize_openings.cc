// Doors and windows: how wide they are, where in their walls, and one of each where nobody spoke of any.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "layoutbox/catalog/normalize_steps.h"
#include "layoutbox/catalog/opening_look.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/scene/relation_traits.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox {
namespace {

constexpr double kShareOfWindow = 0.5, kShareOfWideWindow = 0.75;  // of the longest wall
constexpr Mm kWidestWindow = 5400, kBetweenUnderWindow = 100;
constexpr Mm kSeatsBeside = 1000;                     // and their seats, of tables
constexpr Mm kBesideGlass = 120, kAtWholeWall = 500;  // of walls of glass: what is left beside them

class OpeningNormalizer {
 public:
  explicit OpeningNormalizer(NormalizeContext& context) : context_(context), room_(context.scene.room) {}

  void run() {
    settle_openings();
    if (room_.openings.empty() && !room_.openings_given && context_.options.default_openings) add_default_openings();
    for (Error& error : check_openings(room_)) context_.errors.push_back(std::move(error));
  }

 private:
  void settle_openings() {
    for (std::size_t i = 0; i < room_.openings.size(); ++i) {
      Opening& opening = room_.openings[i];
      if (const Wall* wall = context_.scene.find_wall(opening.wall); wall != nullptr && !opening.wall.empty()) opening.wall = wall->id;
      if (opening.id.empty()) opening.id = unused_id(context_.scene, fmt::format("{}{}", name_of(opening.type), i + 1));
      if (opening.type == OpeningType::kWindow && opening.wall.empty()) opening.wall = wall_of_what_is_under(opening);
      take_whole_wall(opening);
      settle_place(opening);
      if (opening.asked()) continue;
      const Mm wanted = std::max(width_of_what_is_under(opening), opening.type == OpeningType::kWindow ? daylight_width() : 0);
      raise_sill(opening);
      fit_assumed(opening, wanted > opening.width ? kShareOfWideWindow : kShareOfWindow,
                  std::max(opening.width, std::min(wanted, kWidestWindow)));
    }
    for (const Wall& wall : room_.walls) share_wall(wall);
  }

  // Several windows of one wall that are together wider than it share it alike.
  void share_wall(const Wall& wall) {
    constexpr Mm kBetween = 100, kLeastWindow = 300;
    std::vector<Opening*> windows;
    Mm taken = kBetween;
    for (Opening& opening : room_.openings) {
      if (opening.wall != wall.id) continue;
      taken += kBetween + opening.width;
      if (opening.type == OpeningType::kWindow && !opening.offset) windows.push_back(&opening);
    }
    const Mm over = taken - static_cast<Mm>(length_of(wall));
    if (over <= 0 || windows.size() < 2) return;
    for (Opening* window : windows) {
      const Mm less = (over / static_cast<Mm>(windows.size()) / kGridMm + 1) * kGridMm;
      window->width = std::max(kLeastWindow, window->width - less);
      context_.note("filled", fmt::format("{} is {} wide, so that all windows of {} fit", window->id, metres_text(window->width), wall.id),
                    "/room/openings");
    }
  }

  // Where the text has its middle; in the middle of its wall; as far off the corner that is named as is said, else a hand's breadth.
  void settle_place(Opening& opening) const {
    const SaidPlace& said = opening.place;
    const Mm off = said.from_corner.value_or(100);
    const Wall* wall = opening.wall.empty() || opening.offset ? nullptr : context_.scene.find_wall(opening.wall);
    if (wall == nullptr) return;
    const Mm room = std::max(0, static_cast<Mm>(length_of(*wall)) - opening.width);
    const bool along_x = wall->start.y == wall->end.y, along_y = wall->start.x == wall->end.x;
    if (const std::optional<Mm> middle = along_x ? said.x : along_y ? said.y : std::nullopt) {
      const Mm start = along_x ? wall->start.x : wall->start.y;
      opening.offset = std::clamp(std::abs(*middle - start) - opening.width / 2, 0, room) / kGridMm * kGridMm;
      return;
    }
    if (said.in_middle) {
      opening.offset = room / 2 / kGridMm * kGridMm;
      return;
    }
    const auto says = [&](std::string_view word) { return said.corner.find(word) != std::string::npos ? 1 : 0; };
    const Point along{wall->end.x - wall->start.x, wall->end.y - wall->start.y};
    const double toward = 1.0 * along.x * (says("right") - says("left")) + 1.0 * along.y * (says("back") - says("front"));
    if (toward != 0) opening.offset = toward < 0 ? std::min(off, room) : std::max(0, room - off);
  }

  // A wall of glass is as wide and high as its wall.
  void take_whole_wall(Opening& opening) const {
    const Wall* wall = opening.wall.empty() ? nullptr : context_.scene.find_wall(opening.wall);
    if (wall == nullptr || opening.type != OpeningType::kWindow || !look_of(opening).whole) return;
    const Mm length = static_cast<Mm>(length_of(*wall));
    if (opening.width < length - kAtWholeWall || length < 4 * kBesideGlass) return;
    opening.width = (length - 2 * kBesideGlass) / kGridMm * kGridMm;
    opening.offset = (length - opening.width) / 2;
    opening.height = room_.height - opening.sill - kBesideGlass;
  }

  // The wall that the thing is told to be at, by itself or with what carries it; null: none.
  const Wall* wall_told(const std::string& id, bool carried = false) const {
    for (const Relation& r : context_.scene.relations) {
      if (std::ranges::find(r.targets, id) == r.targets.end() || r.references.size() != 1 || !r.asked()) continue;
      if (traits_of(r.type).back_to_wall) return context_.scene.find_wall(r.references[0]);
      if (traits_of(r.type).rests && !carried) return wall_told(r.references[0], true);
    }
    return nullptr;
  }

  // … or, of a sink, the one that all other units of the kitchen are told to be at.
  const Wall* wall_of_units(const std::string& sink) const {
    const auto is = [&](const SceneObject& object, Trait trait) { return context_.catalog.entry_or_nearest(object.category).is(trait); };
    const SceneObject* object = context_.scene.find_object(sink);
    if (object == nullptr || !(is(*object, Trait::kWashUp) || context_.catalog.is_a(object->category, "sink"))) return nullptr;
    const Wall* wall = nullptr;
    for (const SceneObject& unit : context_.scene.objects) {
      const Wall* own = is(unit, Trait::kKitchenRun) ? wall_told(unit.id) : nullptr;
      if (own != nullptr && wall != nullptr && own != wall) return nullptr;
      if (own != nullptr) wall = own;
    }
    return wall;
  }

  // A window of which no wall is told is in that of what stands under or by it: "a sink along the left wall under the window".
  std::string wall_of_what_is_under(const Opening& window) const {
    const bool alone = std::ranges::count(room_.openings, OpeningType::kWindow, &Opening::type) <= 1;
    for (const Relation& r : context_.scene.relations) {
      const bool named = names(r.references, window.id) || (alone && names(r.references, "window"));
      const bool under = r.type == RelationType::kUnderWindow && (named || (alone && r.references.empty()));
      if (!r.asked() || r.targets.empty() || !(under || (named && r.type == RelationType::kNextTo))) continue;
      const Wall* told = wall_told(r.targets[0]);
      const Wall* wall = told != nullptr ? told : wall_of_units(r.targets[0]);
      if (wall != nullptr) return wall->id;
    }
    return {};
  }

  // Of what is told to stand side by side under a window whose width is ours to choose: two desks want more of it than one. Tables that
  // are sat at also where they are told to be by it; one may be past its end.
  Mm width_of_what_is_under(const Opening& window) const {
    Mm width = 0;
    int tables_by_it = 0;
    std::vector<std::string> seen;
    for (const Relation& relation : context_.scene.relations) {
      const bool by = relation.type == RelationType::kNextTo && names(relation.references, window.id);
      if ((relation.type != RelationType::kUnderWindow && !by) || window.type != OpeningType::kWindow) continue;
      const bool here = relation.references.empty() || std::ranges::find(relation.references, window.id) != relation.references.end();
      for (const std::string& id : relation.targets) {
        const SceneObject* object = context_.scene.find_object(id);
        if (!here || object == nullptr || !object->size || std::ranges::find(seen, id) != seen.end()) continue;
        if (by && !is_sat_at(id)) continue;
        if (by && ++tables_by_it == 1) continue;
        seen.push_back(id);
        width += object->size->usual.width + (by || is_sat_round(id) ? kSeatsBeside : kBetweenUnderWindow);
      }
    }
    return width;
  }

  // Above what is told to stand under it: a sink with its tap.
  void raise_sill(Opening& window) const {
    constexpr Mm kMostSill = 1250, kLeastGlass = 600;
    if (window.type != OpeningType::kWindow) return;
    Mm top = 0;
    for (const Relation& relation : context_.scene.relations) {
      const bool here = relation.references.empty() || names(relation.references, window.id);
      if (relation.type != RelationType::kUnderWindow || !here) continue;
      for (const SceneObject& object : context_.scene.objects) {
        if (names(relation.targets, object.id) && object.size && object.mount == Mount::kFloor)
          top = std::max(top, object.size->usual.height);
      }
    }
    if (top <= window.sill || top > kMostSill) return;
    const Mm head = window.sill + window.height;
    window.sill = (top + kGridMm - 1) / kGridMm * kGridMm;
    window.height = std::max(kLeastGlass, head - window.sill);
  }

  // By seats that are told to be round it or by it.
  bool is_sat_at(const std::string& id) const {
    return is_sat_round(id) || std::ranges::any_of(context_.scene.relations, [&](const Relation& relation) {
             const SceneObject* seat = relation.targets.empty() ? nullptr : context_.scene.find_object(relation.targets[0]);
             return seat != nullptr && traits_of(relation.type).close_by && names(relation.references, id) &&
                    context_.catalog.entry_or_nearest(seat->category).is(Trait::kTableSeat);
           });
  }

  bool is_sat_round(const std::string& id) const {
    return std::ranges::any_of(context_.scene.relations, [&](const Relation& relation) {
      return traits_of(relation.type).around && std::ranges::find(relation.references, id) != relation.references.end();
    });
  }

  // How wide a window of ours is that gives such a room its light: 8 % of the floor (International Residential Code, R303.1). Kitchens need
  // their walls for units, and where an audience looks at a screen it is dark.
  Mm daylight_width() const {
    constexpr double kShareOfFloor = 0.08, kHeight = 1200;
    constexpr Mm kWidest = 3000, kGlassStep = 100;
    const bool without = std::ranges::any_of(context_.scene.objects, [&](const SceneObject& object) {
      return context_.catalog.entry_or_nearest(object.category).is(Trait::kKitchenRun) ||
             context_.catalog.is_a(object.category, "projector_screen") || context_.catalog.is_a(object.category, "theater_seat");
    });
    if (without) return 0;
    const double width = kShareOfFloor * 0.5 * static_cast<double>(std::abs(doubled_area(room_.polygon))) / kHeight;
    return std::min(kWidest, (static_cast<Mm>(width) + kGlassStep - 1) / kGlassStep * kGlassStep);
  }

  Mm longest_wall() const {
    Mm longest = 0;
    for (const Wall& wall : room_.walls) longest = std::max(longest, static_cast<Mm>(length_of(wall)));
    return longest;
  }

  // Defaults give way to small rooms.
  void fit_assumed(Opening& opening, double share_of_window, Mm width) const {
    const Mm longest = longest_wall();
    const double share = opening.type == OpeningType::kWindow ? share_of_window : 0.8;
    opening.width = std::min(width, static_cast<Mm>(longest * share) / kGridMm * kGridMm);
    if (opening.type != OpeningType::kWindow) {
      opening.height = std::min(opening.height, room_.height - 50);
    } else if (opening.sill + opening.height > room_.height - 200) {
      opening.sill = std::min(opening.sill, room_.height / 3 / kGridMm * kGridMm);
      opening.height = std::min(opening.height, room_.height - 200 - opening.sill);
    }
  }

  void add_default_openings() {
    Opening door;
    door.id = unused_id(context_.scene, "door1");
    door.origin = Origin::kAssumed;
    fit_assumed(door, kShareOfWindow, door.width);
    room_.openings.push_back(door);

    Opening window;
    window.id = unused_id(context_.scene, "window1");
    window.type = OpeningType::kWindow;
    window.width = window.height = 1200;
    window.sill = 900;
    window.swing = Swing::kNone;
    window.origin = Origin::kAssumed;
    window.wall = wall_of_what_is_under(window);
    const Mm wanted = std::min(std::max(width_of_what_is_under(window), daylight_width()), kWidestWindow);
    raise_sill(window);
    fit_assumed(window, wanted > window.width ? kShareOfWideWindow : kShareOfWindow, std::max(window.width, wanted));
    if (window.height >= 300 && window.width >= 300) room_.openings.push_back(window);
    context_.note("filled", "no door or window is named: the room gets one of each, where they are least in the way", "/room/openings");
  }

  NormalizeContext& context_;
  Room& room_;
};

}  // namespace

void normalize_openings(NormalizeContext& context) { OpeningNormalizer(context).run(); }

}  // namespace layoutbox
