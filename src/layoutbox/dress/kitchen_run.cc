// Fitted kitchens: the free wall between units and on from them becomes base cabinets, round a corner where the form or the room asks.
#include <algorithm>
#include <cmath>

#include "layoutbox/catalog/measures.h"
#include "layoutbox/catalog/trait_table.h"
#include "layoutbox/dress/kitchen.h"
#include "layoutbox/dress/places.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox::dressing {
namespace {

constexpr double kNarrowest = 150, kOfUse = 300, kCabinet = 700;  // widths of cabinets: a pull-out, the least at an end, the usual
constexpr double kChink = 10;                                     // what is wider between two units is filled
constexpr double kInCorner = 350;                                 // what is narrower is part of the corner unit
constexpr double kBeforeGap = 600;                                // free before what closes a gap: one stands at the units beside it
constexpr double kWidestGap = 2400;                               // between two units that become one run
constexpr double kFormlessGap = 1200;                             // from a run to the corner where it meets the next wall's
constexpr double kLeastTurn = 600, kSaidTurn = 1200, kMostTurn = 2400;
constexpr double kLeftOver = 450;                                                     // of wall beyond a run that is filled as well
constexpr double kShortest = 3000, kLongest = 5000, kSmallRoom = 6, kLargeRoom = 16;  // mm of run in rooms of so many m²

class KitchenRun {
 public:
  KitchenRun(Dresser& dresser, const Dressing& row) : dresser_(dresser), row_(row), size_(dresser.size_of(row)) {
    const auto& forms = Dressings::builtin().kitchen_forms;
    const auto said = std::ranges::find_if(forms, [&](const KitchenForm& form) { return dresser.spoken().says_any(form.words); });
    if (said != forms.end()) form_ = said->form;
  }

  void fill() {
    find_main();
    if (main_ == nullptr) return;
    if (form_ == "L" || form_ == "U") open_corners();
    for (const DressedWall& wall : dresser_.room().walls()) close_gaps(wall);
    for (const DressedWall& wall : dresser_.room().walls()) close_corner(wall);
    const double share =
        std::clamp((double(doubled_area(dresser_.layout().room.polygon)) / 2e6 - kSmallRoom) / (kLargeRoom - kSmallRoom), 0.0, 1.0);
    wanted_ = kShortest + share * (kLongest - kShortest) + (form_ == "L" ? kLeastTurn : form_ == "U" ? 2 * kLeastTurn : 0);
    extend();
    for (const DressedWall& wall : dresser_.room().walls()) {
      if (&wall != main_) flank(wall);
    }
    if (form_ == "galley") face();
  }

 private:
  // As long as the units along all walls are.
  double length() const {
    double sum = 0;
    for (const DressedWall& wall : dresser_.room().walls()) {
      for (const KitchenUnit& unit : units_at(dresser_, wall)) sum += unit.span.length();
    }
    return sum;
  }

  void find_main() {
    constexpr double kOfSink = 5000;  // one washes up where the run is, however long another wall's
    double longest = 0;
    for (const DressedWall& wall : dresser_.room().walls()) {
      double sum = 0;
      for (const KitchenUnit& unit : units_at(dresser_, wall)) {
        sum += unit.span.length() + (dresser_.entry_of(*unit.object).is(Trait::kWashUp) ? kOfSink : 0);
        const bool counter = is_worktop(*unit.object) && unit.object->spaces.empty();
        if (counter) size_.depth = unit.object->size.depth, size_.height = unit.object->size.height;
      }
      if (sum > longest) longest = sum, main_ = &wall;
    }
  }

  // A run that is to go round a corner may have a worktop in it that nobody asked for: that one is reached from over the other leg.
  void open_corners() {
    std::vector<std::string> ids;
    for (const KitchenUnit& unit : units_at(dresser_, *main_)) {
      const bool flush = unit.span.low < kNarrowest || main_->length - unit.span.high < kNarrowest;
      if (flush && unit.object->origin == Origin::kAdded && is_worktop(*unit.object)) ids.push_back(unit.object->id);
    }
    for (const std::string& id : ids) dresser_.use_from_no_side(id);
  }

  // A sink is a counter as well, but it is used from the front.
  bool is_worktop(const PlacedObject& unit) const {
    const CatalogEntry& entry = dresser_.entry_of(unit);
    return entry.is(Trait::kCounter) && !entry.is(Trait::kWashUp);
  }

  // Where a cabinet may stand along a wall, with room to walk before it.
  std::vector<Span> free_at(const DressedWall& wall, double most = 1e9) const {
    const double depth = size_.depth;
    const double walk = std::min<double>(most, form_.empty() ? measures().before_run : measures().least_before_run);
    std::vector<Span> spans =
        shared(dresser_.room().free_along(wall, {0, depth}, {0, double(size_.height)}),
               dresser_.room().free_along(wall, {depth, depth + walk}, {0, double(size_.height)}, FreeRoom::Count::kStandingAndDoorways));
    for (const DressedWall& other : dresser_.room().walls()) {
      for (const Span& front : fronts_before(wall, other)) spans = without(spans, front);
    }
    return spans;
  }

  // What of a wall the floor before sinks, stoves and appliances at another wall takes up: those in a corner.
  std::vector<Span> fronts_before(const DressedWall& wall, const DressedWall& other) const {
    std::vector<Span> fronts;
    if (&other == &wall) return fronts;
    for (const KitchenUnit& unit : units_at(dresser_, other)) {
      if (is_worktop(*unit.object)) continue;
      const double depth = other.off(box_round(*unit.object)).high;
      const RoomBox front = other.box(unit.span, {depth, depth + kOfUse}, {0, double(size_.height)});
      if (wall.off(front).low < size_.depth) fronts.push_back(wall.along(front));
    }
    return fronts;
  }

  // Equal cabinets over the whole of it.
  void place(const DressedWall& wall, Span span) {
    if (span.length() < kNarrowest) return;
    const int count = std::max(1, static_cast<int>(std::lround(span.length() / kCabinet)));
    double from = span.low;
    for (int k = 0; k < count; ++k) {
      const double to = k + 1 == count ? std::floor(span.high) : from + std::floor(span.length() / count);
      dresser_.add_at_wall(row_.adds, row_.words, {static_cast<Mm>(to - from), size_.depth, size_.height}, wall, from, 0);
      from = to;
    }
  }

  // A filler, that nobody stands before: no chink is left between two low units.
  bool fill_in(const DressedWall& wall, Span gap) {
    const double low = std::ceil(gap.low), high = std::floor(gap.high);
    if (high - low < kChink || !dresser_.room().is_free(wall.box({low, high}, {0, double(size_.depth)}, {0, double(size_.height)}), true))
      return false;
    dresser_.add_at_wall("kitchen_corner_unit", row_.words, {static_cast<Mm>(high - low), size_.depth, size_.height}, wall, low, 0);
    return true;
  }

  void close_gaps(const DressedWall& wall) {
    const std::vector<KitchenUnit> units = units_at(dresser_, wall);
    for (std::size_t i = 0; i + 1 < units.size(); ++i) {
      const Span gap{units[i].span.high, units[i + 1].span.low};
      if (gap.length() >= kChink && gap.length() < kOfUse && fill_in(wall, gap)) continue;
      if (gap.length() < kNarrowest || gap.length() > kWidestGap) continue;
      for (const Span& span : shared({gap}, free_at(wall, kBeforeGap))) place(wall, span);
    }
  }

  // Two runs that nearly meet in a corner do: both are filled up to it, the corner itself is of the first.
  void close_corner(const DressedWall& wall) {
    const DressedWall* next = dresser_.room().next(wall);
    if (next == nullptr) return;
    const std::vector<KitchenUnit> before = units_at(dresser_, wall), after = units_at(dresser_, *next);
    if (before.empty() || after.empty()) return;
    if (before.back().object->size.height > measures().tall_from || after.front().object->size.height > measures().tall_from) return;
    const double depth = size_.depth, edge = before.back().span.high, first = after.front().span.low;
    const double here = wall.length - edge, most = depth + (form_.empty() ? kFormlessGap : kWidestGap);
    if (here > most || first > most) return;
    const bool taken = std::min(here, first) < kNarrowest;  // one of them stands in it
    const PlacedObject& in = here < first ? *before.back().object : *after.front().object;
    const std::string in_corner = in.id;
    const bool may_be_blocked = in.origin == Origin::kAdded && is_worktop(in);
    if (taken && !may_be_blocked && !goes_round(here < first ? before.back() : after.front())) return;
    const bool of_next = !taken && first < depth - kTouching;
    const double wide = of_next ? first : here - depth < kInCorner ? here : depth;  // no chink, and none that cannot be stood before
    const DressedWall& of = of_next ? *next : wall;
    const double at = of_next ? 0 : wall.length - wide;
    const Span up{edge, taken || of_next ? wall.length - depth : at}, on{depth, first};
    const bool corner_free = taken || dresser_.room().is_free(of.box({at, at + wide}, {0, depth}, {0, double(size_.height)}), true);
    if (!corner_free || !is_free(wall, up) || !is_free(*next, on)) return;
    if (!taken) dresser_.add_at_wall("kitchen_corner_unit", row_.words, {static_cast<Mm>(wide), size_.depth, size_.height}, of, at, 0);
    if (may_be_blocked && std::min(here, first) < depth) dresser_.use_from_no_side(in_corner);
    place(wall, up);
    place(*next, on);
    ++corners_;
  }

  // A worktop, of which enough is left to stand before.
  bool goes_round(const KitchenUnit& unit) const { return unit.span.length() >= size_.depth + kOfUse && is_worktop(*unit.object); }

  // All of it, where it is more than a chink.
  bool is_free(const DressedWall& wall, const Span& whole) const {
    return whole.length() < kTouching ||
           std::ranges::any_of(free_at(wall), [&](const Span& span) { return span.low < whole.low + 1 && span.high > whole.high - 1; });
  }

  // What is free beyond an end of a run, and round the corner there.
  struct End {
    const DressedWall* wall = nullptr;
    bool high = false;
    double straight = 0;  // up to the corner, or to what stands there
    bool corner = false;  // it goes as far as the corner
    bool flush = false;   // the last unit stands in it
    const DressedWall* turned = nullptr;
    double turn = 0;  // along the next wall, from the corner unit on
  };

  // REQUIRES: units stand at the wall.
  End end_of(const DressedWall& wall, bool high) const {
    End end{.wall = &wall, .high = high};
    const std::vector<KitchenUnit> units = units_at(dresser_, wall);
    const KitchenUnit& last = high ? units.back() : units.front();
    if (last.object->size.height > measures().tall_from) return end;
    const double edge = high ? last.span.high : last.span.low;
    for (const Span& span : free_at(wall)) {
      if (std::abs((high ? span.low : span.high) - edge) > kTouching) continue;
      end.straight = span.length();
      end.corner = high ? span.high > wall.length - 1 : span.low < 1;
    }
    end.turned = high ? dresser_.room().next(wall) : dresser_.room().previous(wall);
    end.flush = (high ? wall.length - edge : edge) < kNarrowest;
    if (end.turned == nullptr || !(end.flush || (end.corner && end.straight >= size_.depth))) return end;
    const double corner = size_.depth, length = end.turned->length;  // the corner itself belongs to this wall
    for (const Span& span : free_at(*end.turned)) {
      const Span beyond = high ? Span{std::max(span.low, corner), span.high} : Span{span.low, std::min(span.high, length - corner)};
      const bool meets = high ? beyond.low <= corner + 1 : beyond.high >= length - corner - 1;
      if (meets && beyond.length() >= kLeastTurn) end.turn = beyond.length();
    }
    return end;
  }

  double edge_of(const DressedWall& wall, bool high) const {
    const std::vector<KitchenUnit> units = units_at(dresser_, wall);
    return high ? units.back().span.high : units.front().span.low;
  }

  void turn(const End& end, double wanted) {
    const double edge = edge_of(*end.wall, end.high), depth = size_.depth;
    if (end.flush) return turn_on(end, wanted);
    const double between = (end.high ? end.wall->length - edge : edge) - depth;
    const double wide = between < kInCorner ? depth + between : depth;  // no chink, and none that cannot be stood before
    const double corner = end.high ? end.wall->length - wide : 0;
    place(*end.wall, end.high ? Span{edge, corner} : Span{wide, edge});
    dresser_.add_at_wall("kitchen_corner_unit", row_.words, {static_cast<Mm>(wide), size_.depth, size_.height}, *end.wall, corner, 0);
    turn_on(end, wanted);
  }

  // Along the next wall, from the corner's unit on.
  void turn_on(const End& end, double wanted) {
    const double length = on_grid(std::clamp(wanted, kLeastTurn, std::min(end.turn, kMostTurn)));
    const double from = end.high ? size_.depth : end.turned->length - size_.depth - length;
    place(*end.turned, {from, from + length});
  }

  void go_on(const End& end) {
    const double edge = edge_of(*end.wall, end.high), wanted = wanted_ - length();
    if (wanted < kOfUse || end.straight < kOfUse) return;
    const double length = end.straight - wanted < kLeftOver ? end.straight : on_grid(wanted);
    place(*end.wall, end.high ? Span{edge, edge + length} : Span{edge - length, edge});
  }

  void extend() {
    End ends[] = {end_of(*main_, true), end_of(*main_, false)};
    std::ranges::stable_sort(ends, std::greater{}, [](const End& end) { return std::pair(end.turn > 0, end.straight + end.turn); });
    const double straight = ends[0].straight + ends[1].straight, missing = wanted_ - length();
    const bool short_of_wall = form_.empty() && missing - straight > kLeastTurn;
    const int turns = (form_ == "U" ? 2 : form_ == "L" || short_of_wall ? 1 : 0) - corners_;
    int turned = 0;
    for (const End& end : ends) {
      if (turned < turns && end.turn > 0) {
        turn(end, std::max(wanted_ - length() - end.straight, form_.empty() ? 0 : kSaidTurn));
        ++turned;
      } else {
        go_on(end);
      }
    }
  }

  // The units along another wall get their worktop too.
  void flank(const DressedWall& wall) {
    for (const bool high : {true, false}) {
      if (!units_at(dresser_, wall).empty()) go_on(end_of(wall, high));
    }
  }

  // A second run along the wall across, as long as the first.
  void face() {
    const DressedWall* across = dresser_.room().opposite(*main_);
    if (across == nullptr) return;
    const Span run{edge_of(*main_, false), edge_of(*main_, true)};
    const Span mirrored{across->length - run.high, across->length - run.low};
    for (const Span& span : shared({mirrored}, free_at(*across))) {
      if (span.length() >= kLeastTurn) place(*across, span);
    }
  }

  Dresser& dresser_;
  const Dressing& row_;
  Size size_;
  std::string form_;
  const DressedWall* main_ = nullptr;
  double wanted_ = 0;
  int corners_ = 0;  // that units meet in
};

}  // namespace

std::vector<KitchenUnit> units_at(const Dresser& dresser, const DressedWall& wall) {
  constexpr double kBehind = 80;
  std::vector<KitchenUnit> units;
  for (const PlacedObject& object : dresser.layout().objects) {
    const bool is_unit = object.mount == Mount::kFloor && dresser.entry_of(object).is(Trait::kKitchenRun);
    if (is_unit && dresser.room().behind(object, kBehind) == &wall) units.push_back({&object, wall.along(box_round(object))});
  }
  std::ranges::sort(units, {}, [](const KitchenUnit& unit) { return unit.span.low; });
  return units;
}

void fill_kitchen_run(Dresser& dresser, const Dressing& row) { KitchenRun(dresser, row).fill(); }

}  // namespace layoutbox::dressing
