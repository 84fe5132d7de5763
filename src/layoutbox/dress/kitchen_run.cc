// Fitted kitchens: the free wall between units and on from them becomes base cabinets, round a corner where the form or the room asks.
#include <algorithm>
#include <cmath>

#include "layoutbox/dress/kitchen.h"
#include "layoutbox/dress/places.h"
#include "layoutbox/scene/shell.h"

namespace layoutbox::dressing {
namespace {

constexpr double kWalk = 1000;                      // free floor before a run
constexpr double kTall = 1200;                      // a unit that ends a run
constexpr double kNarrowest = 300, kCabinet = 700;  // widths of cabinets
constexpr double kWidestGap = 2400;                 // between two units that become one run
constexpr double kLeastTurn = 600, kMostTurn = 2400;
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
    for (const WallFrame& wall : dresser_.room().walls()) close_gaps(wall);
    const double share =
        std::clamp((double(doubled_area(dresser_.layout().room.polygon)) / 2e6 - kSmallRoom) / (kLargeRoom - kSmallRoom), 0.0, 1.0);
    wanted_ = kShortest + share * (kLongest - kShortest);
    extend();
    if (form_ == "galley") face();
  }

 private:
  // As long as the units along all walls are.
  double length() const {
    double sum = 0;
    for (const WallFrame& wall : dresser_.room().walls()) {
      for (const Unit& unit : units_at(dresser_, wall)) sum += unit.span.length();
    }
    return sum;
  }

  void find_main() {
    double longest = 0;
    for (const WallFrame& wall : dresser_.room().walls()) {
      double sum = 0;
      for (const Unit& unit : units_at(dresser_, wall)) {
        sum += unit.span.length();
        const bool counter = dresser_.catalog().is_a(unit.object->category, "counter") && unit.object->spaces.empty();
        if (counter) size_.depth = unit.object->size.depth, size_.height = unit.object->size.height;
      }
      if (sum > longest) longest = sum, main_ = &wall;
    }
  }

  // Where a cabinet may stand along a wall, with room to walk before it.
  std::vector<Span> free_at(const WallFrame& wall) const {
    const double depth = size_.depth;
    return shared(dresser_.room().free_along(wall, {0, depth}, {0, double(size_.height)}),
                  dresser_.room().free_along(wall, {depth, depth + kWalk}, {0, double(size_.height)}, true));
  }

  // Equal cabinets over the whole of it.
  void place(const WallFrame& wall, Span span) {
    if (span.length() < kNarrowest) return;
    const int count = std::max(1, static_cast<int>(std::lround(span.length() / kCabinet)));
    double from = span.low;
    for (int k = 0; k < count; ++k) {
      const double to = k + 1 == count ? std::floor(span.high) : from + std::floor(span.length() / count);
      dresser_.add_at_wall(row_.adds, row_.words, {static_cast<Mm>(to - from), size_.depth, size_.height}, wall, from, 0);
      from = to;
    }
  }

  void close_gaps(const WallFrame& wall) {
    const std::vector<Unit> units = units_at(dresser_, wall);
    for (std::size_t i = 0; i + 1 < units.size(); ++i) {
      const Span gap{units[i].span.high, units[i + 1].span.low};
      if (gap.length() < kNarrowest || gap.length() > kWidestGap) continue;
      for (const Span& span : shared({gap}, free_at(wall))) place(wall, span);
    }
  }

  // What is free beyond an end of the main run, and round the corner there.
  struct End {
    bool high = false;
    double straight = 0;  // up to the corner, or to what stands there
    bool corner = false;  // it goes as far as the corner
    const WallFrame* turned = nullptr;
    double turn = 0;  // along the next wall, from the corner unit on
  };

  End end_of(bool high) const {
    End end{.high = high};
    const std::vector<Unit> units = units_at(dresser_, *main_);
    const Unit& last = high ? units.back() : units.front();
    if (last.object->size.height > kTall) return end;
    const double edge = high ? last.span.high : last.span.low;
    for (const Span& span : free_at(*main_)) {
      if (std::abs((high ? span.low : span.high) - edge) > kTouching) continue;
      end.straight = span.length();
      end.corner = high ? span.high > main_->length - 1 : span.low < 1;
    }
    end.turned = high ? dresser_.room().next(*main_) : dresser_.room().previous(*main_);
    if (!end.corner || end.straight < size_.depth || end.turned == nullptr) return end;
    const WallFrame& wall = *end.turned;
    for (const Span& span : free_at(wall)) {
      // The corner itself belongs to the main run.
      const Span beyond =
          high ? Span{std::max(span.low, double(size_.depth)), span.high} : Span{span.low, std::min(span.high, wall.length - size_.depth)};
      const bool meets = high ? beyond.low <= size_.depth + 1 : beyond.high >= wall.length - size_.depth - 1;
      if (meets && beyond.length() >= kLeastTurn) end.turn = beyond.length();
    }
    return end;
  }

  double edge_of(bool high) const {
    const std::vector<Unit> units = units_at(dresser_, *main_);
    return high ? units.back().span.high : units.front().span.low;
  }

  void turn(const End& end, double wanted) {
    const double edge = edge_of(end.high), depth = size_.depth;
    const double corner = end.high ? main_->length - depth : 0;
    place(*main_, end.high ? Span{edge, corner} : Span{depth, edge});
    dresser_.add_at_wall("kitchen_corner_unit", row_.words, {size_.depth, size_.depth, size_.height}, *main_, corner, 0);
    const double length = on_grid(std::clamp(wanted, kLeastTurn, std::min(end.turn, kMostTurn)));
    const double from = end.high ? depth : end.turned->length - depth - length;
    place(*end.turned, {from, from + length});
  }

  void go_on(const End& end, double wanted) {
    const double edge = edge_of(end.high);
    const double length = end.straight - wanted < kLeftOver ? end.straight : on_grid(wanted);
    place(*main_, end.high ? Span{edge, edge + length} : Span{edge - length, edge});
  }

  void extend() {
    End ends[] = {end_of(true), end_of(false)};
    std::ranges::stable_sort(ends, std::greater{}, [](const End& end) { return std::pair(end.turn > 0, end.straight + end.turn); });
    const double straight = ends[0].straight + ends[1].straight, missing = wanted_ - length();
    const bool short_of_wall = form_.empty() && missing - straight > kLeastTurn;
    const int turns = form_ == "U" ? 2 : form_ == "L" || short_of_wall ? 1 : 0;
    int turned = 0;
    for (const End& end : ends) {
      const double needed = wanted_ - length();
      if (turned < turns && end.turn > 0) {
        turn(end, form_.empty() ? needed - end.straight : std::max(needed - end.straight, 1200.0));
        ++turned;
      } else if (needed >= kNarrowest && end.straight >= kNarrowest) {
        go_on(end, needed);
      }
    }
  }

  // A second run along the wall across, as long as the first.
  void face() {
    const WallFrame* across = dresser_.room().opposite(*main_);
    if (across == nullptr) return;
    const Span run{edge_of(false), edge_of(true)};
    const Span mirrored{across->length - run.high, across->length - run.low};
    for (const Span& span : shared({mirrored}, free_at(*across))) {
      if (span.length() >= kLeastTurn) place(*across, span);
    }
  }

  Dresser& dresser_;
  const Dressing& row_;
  Size size_;
  std::string form_;
  const WallFrame* main_ = nullptr;
  double wanted_ = 0;
};

}  // namespace

std::vector<Unit> units_at(const Dresser& dresser, const WallFrame& wall) {
  constexpr double kBehind = 80;
  std::vector<Unit> units;
  for (const PlacedObject& object : dresser.layout().objects) {
    const bool is_unit = object.mount == Mount::kFloor && dresser.entry_of(object).is(Trait::kKitchenRun);
    if (is_unit && dresser.room().behind(object, kBehind) == &wall) units.push_back({&object, wall.along(box_round(object))});
  }
  std::ranges::sort(units, {}, [](const Unit& unit) { return unit.span.low; });
  return units;
}

void fill_kitchen_run(Dresser& dresser, const Dressing& row) { KitchenRun(dresser, row).fill(); }

}  // namespace layoutbox::dressing
