#include "layoutbox/export/plan_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "layoutbox/export/plan_key.h"
#include "layoutbox/export/plan_label_text.h"

namespace layoutbox {
namespace {

// Sizes of letters, in millimetres on paper; below 1.9 nobody reads A4.
constexpr std::array kLetters{2.5, 2.2, 1.9};
constexpr double kBall = kNumberRadius;
constexpr std::size_t kMostNamesBeside = 3;  // equal things: more of them get a number
constexpr Mm kFlat = 30;                     // rugs: labels of others may lie on them

// Equal objects are labelled alike.
struct Group {
  std::string name, size;
  std::vector<int> members;  // places in layout.objects
};

class Labels {
 public:
  Labels(Canvas& page, const PlanInk& ink, const PlanScale& scale, const Layout& layout, const FloorPlanOptions& options)
      : page_(page), ink_(ink), scale_(scale), layout_(layout), options_(options) {}

  void draw(const PaperBox& key) {
    std::vector<Group> rest;
    for (Group& group : groups()) {
      if (!draw_inside(group)) rest.push_back(std::move(group));
    }
    std::vector<Group> numbered;
    for (Group& group : rest) {
      if (!draw_beside(group)) numbered.push_back(std::move(group));
    }
    draw_numbers(numbered, key);
  }

 private:
  const PlacedObject& object(int number) const { return layout_.objects[static_cast<std::size_t>(number)]; }
  bool is_floor(int owner) const { return owner == PlanInk::kFloor || (owner >= 0 && object(owner).size.height <= kFlat); }

  std::vector<Group> groups() const {
    std::vector<Group> groups;
    std::map<std::pair<std::string, std::string>, std::size_t> known;
    for (int i = 0; i < static_cast<int>(layout_.objects.size()); ++i) {
      const std::string name = label_name(object(i)), size = label_size(object(i));
      const auto [place, is_new] = known.try_emplace({name, size}, groups.size());
      if (is_new) groups.push_back({name, size, {}});
      groups[place->second].members.push_back(i);
    }
    return groups;
  }

  PaperBox box_of(int number) const {
    const PlacedObject& o = object(number);
    const double turn = radians_from_degrees(o.rotation_deg), c = std::abs(std::cos(turn)), s = std::abs(std::sin(turn));
    const double w = (c * o.size.width + s * o.size.depth) * scale_.factor, d = (s * o.size.width + c * o.size.depth) * scale_.factor;
    const PaperPoint center = scale_.at(o.position[0], o.position[1]);
    return {center.x - w / 2, center.y - d / 2, center.x + w / 2, center.y + d / 2};
  }

  // ---- inside -------------------------------------------------------------------------------------------------------------------

  // In the largest letters that do for all of the group; false where some have no room in any.
  bool draw_inside(const Group& group) {
    if (object(group.members[0]).mount == Mount::kCeiling) return false;  // only its outline is there
    for (const bool with_size : {true, false}) {
      if (with_size && !options_.sizes) continue;
      for (const double letter : kLetters) {
        std::vector<std::pair<LabelText, PaperPoint>> found;
        for (const int member : group.members) {
          auto place = place_inside(group, member, with_size, letter);
          if (!place) break;
          found.push_back(std::move(*place));
        }
        if (found.size() < group.members.size()) continue;
        for (const auto& [text, middle] : found) text.draw(page_, middle);
        return true;
      }
    }
    return false;
  }

  std::optional<std::pair<LabelText, PaperPoint>> place_inside(const Group& group, int member, bool with_size, double letter) const {
    const PaperBox box = box_of(member);
    for (const bool upright : {false, true}) {
      if (upright && box.width() > box.height()) continue;
      for (const int lines : {1, 2}) {
        LabelText text(group.name, lines, with_size ? group.size : "", letter, upright);
        if (const auto middle = clear_spot(text.around({0, 0}), box, [&](int owner) { return owner == member; })) {
          return std::pair{std::move(text), *middle};
        }
      }
    }
    return std::nullopt;
  }

  // The spot nearest the middle of `within` where a box of that size is clear.
  template <class Allowed>
  std::optional<PaperPoint> clear_spot(const PaperBox& size, const PaperBox& within, const Allowed& allowed) const {
    const double free_x = (within.width() - size.width()) / 2, free_y = (within.height() - size.height()) / 2;
    if (free_x < 0 || free_y < 0) return std::nullopt;
    constexpr std::array kSteps{0.0, 0.25, -0.25, 0.5, -0.5, 0.75, -0.75, 1.0, -1.0};
    std::optional<PaperPoint> best;
    double least = 1e9;
    for (const double x : kSteps) {
      for (const double y : kSteps) {
        const double off = std::hypot(x * free_x, y * free_y);
        if (off >= least) continue;
        const PaperPoint middle{within.center().x + x * free_x, within.center().y + y * free_y};
        if (!ink_.is_clear(moved(size, middle), allowed)) continue;
        best = middle;
        least = off;
      }
    }
    return best;
  }

  static PaperBox moved(const PaperBox& box, PaperPoint by) { return {box.x0 + by.x, box.y0 + by.y, box.x1 + by.x, box.y1 + by.y}; }

  // ---- beside -------------------------------------------------------------------------------------------------------------------

  // On free floor close to the object.
  bool draw_beside(const Group& group) {
    if (group.members.size() > kMostNamesBeside) return false;
    for (const bool with_size : {true, false}) {
      if (with_size && !options_.sizes) continue;
      std::vector<std::pair<LabelText, PaperPoint>> found;
      for (const int member : group.members) {
        const PlacedObject& o = object(member);
        if (o.mount == Mount::kCeiling || o.size.height <= kFlat) break;
        auto place = place_beside(group, member, with_size);
        if (!place) break;
        found.push_back(std::move(*place));
      }
      if (found.size() < group.members.size()) continue;
      for (const auto& [text, middle] : found) text.draw(page_, middle);
      return true;
    }
    return false;
  }

  std::optional<std::pair<LabelText, PaperPoint>> place_beside(const Group& group, int member, bool with_size) const {
    const PaperBox own = box_of(member);
    const PaperPoint c = own.center();
    for (const double letter : {kLetters[1], kLetters[2]}) {
      for (const int lines : {1, 2}) {
        LabelText text(group.name, lines, with_size ? group.size : "", letter, false);
        const PaperBox size = text.around({0, 0});
        const double dx = (own.width() + size.width()) / 2 + 0.5, dy = (own.height() + size.height()) / 2 + 0.4;
        for (const PaperPoint& off : {PaperPoint{0, dy}, {0, -dy}, {dx, 0}, {-dx, 0}}) {
          const PaperPoint middle{c.x + off.x, c.y + off.y};
          if (!ink_.is_clear(moved(size, middle), [&](int owner) { return is_floor(owner); })) continue;
          if (!touches(member, c, middle)) continue;
          return std::pair{std::move(text), middle};
        }
      }
    }
    return std::nullopt;
  }

  // Is there nothing else between the label and the object itself?
  bool touches(int member, PaperPoint from, PaperPoint to) const {
    bool own = false, other = false;
    ink_.along(to, from, [&](int owner, bool) {
      own = own || owner == member;
      other = other || (!own && !is_floor(owner));
    });
    return own && !other;
  }

  // ---- numbers ------------------------------------------------------------------------------------------------------------------

  struct Ball {
    PaperPoint center, target;
    double cost = 1e9;
    bool inside = false;
  };

  void draw_numbers(std::vector<Group>& numbered, const PaperBox& key) {
    // Counted as one reads: from the back to the front, from left to right.
    const auto place = [&](const Group& group) {
      const PlacedObject& o = object(group.members[0]);
      return std::pair{-std::floor(o.position[1] / 500), o.position[0]};
    };
    std::stable_sort(numbered.begin(), numbered.end(), [&](const Group& a, const Group& b) { return place(a) < place(b); });
    int number = 0;
    for (const Group& group : numbered) {
      ++number;
      for (const int member : group.members) draw_ball(best_ball(member), number);
    }
    std::vector<KeyRow> rows;
    for (const Group& group : numbered) rows.push_back({group.name, options_.sizes ? group.size : "", group.members.size()});
    draw_key(page_, rows, key);
  }

  void draw_ball(const Ball& ball, int number) {
    if (!ball.inside) {
      const double length = std::hypot(ball.target.x - ball.center.x, ball.target.y - ball.center.y);
      const double share = std::min(1.0, kBall / std::max(length, 1e-6));
      page_.line({ball.center.x + share * (ball.target.x - ball.center.x), ball.center.y + share * (ball.target.y - ball.center.y)},
                 ball.target, {"none", "#555", 0.15, {}});
      page_.circle(ball.target, 0.35, {"#555", "none", 0, {}});
    }
    draw_number(page_, ball.center, number);
  }

  // Within the object where it is large enough, else at the spot near it that hides and crosses least.
  Ball best_ball(int member) const {
    const PaperBox own = box_of(member), size{-kBall - 0.2, -kBall - 0.2, kBall + 0.2, kBall + 0.2};
    std::vector<PaperPoint> seen = seen_spots(member, own);
    const bool below = seen.empty();  // what hangs, and what others hide, has its number on what is seen there
    if (const auto middle = clear_spot(size, own, [&](int owner) { return owner == member || (below && owner > PlanInk::kSwing); })) {
      return {*middle, *middle, 0, true};
    }
    if (below) seen.push_back(own.center());
    Ball best{own.center(), own.center(), 1e9, true};
    for (const double gap : {0.6, 1.5, 3.0, 5.0, 8.0, 12.0, 18.0}) {
      for (int i = 0; i < 16; ++i) {
        const double angle = i * kPi / 8, x = std::cos(angle), y = std::sin(angle);
        const double reach = std::min(own.width() / 2 / std::max(1e-6, std::abs(x)), own.height() / 2 / std::max(1e-6, std::abs(y)));
        const double way = reach + gap + kBall;
        if (gap >= best.cost) continue;
        const PaperPoint center{own.center().x + way * x, own.center().y + way * y};
        const Ball ball{center, nearest(seen, center), gap, false};
        const double cost = gap + cost_of(ball, member, size);
        if (cost < best.cost) best = {ball.center, ball.target, cost, false};
      }
    }
    return best;
  }

  // Spots of the object that nothing hides.
  std::vector<PaperPoint> seen_spots(int member, const PaperBox& own) const {
    std::vector<PaperPoint> spots;
    constexpr int kSteps = 10;
    for (int i = 0; i <= kSteps; ++i) {
      for (int k = 0; k <= kSteps; ++k) {
        const PaperPoint p{own.x0 + (0.06 + 0.88 * i / kSteps) * own.width(), own.y0 + (0.06 + 0.88 * k / kSteps) * own.height()};
        if (ink_.is_clear({p.x, p.y, p.x, p.y}, [&](int owner) { return owner == member; })) spots.push_back(p);
      }
    }
    return spots;
  }

  static PaperPoint nearest(const std::vector<PaperPoint>& spots, PaperPoint to) {
    return *std::min_element(spots.begin(), spots.end(), [&](const PaperPoint& a, const PaperPoint& b) {
      return std::hypot(a.x - to.x, a.y - to.y) < std::hypot(b.x - to.x, b.y - to.y);
    });
  }

  double cost_of(const Ball& ball, int member, const PaperBox& size) const {
    const int supporter = supporter_of(member);
    double cost = 0;
    const bool clear = ink_.is_clear(moved(size, ball.center), [&](int owner) {
      if (owner >= 0 && owner != supporter && owner != member && !is_floor(owner)) cost = std::max(cost, 6.0);
      return owner >= PlanInk::kSwing;
    });
    if (!clear) return 1e9;
    // The line may lead over what it stands on; every other line on its way costs.
    bool was_ink = true;
    ink_.along(ball.center, ball.target, [&](int owner, bool ink) {
      if (owner == member) return;
      if (ink && !was_ink) cost += 4;
      if (owner >= 0 && owner != supporter && !is_floor(owner)) cost += 0.25;
      was_ink = ink;
    });
    return cost;
  }

  int supporter_of(int member) const {
    for (int i = 0; i < static_cast<int>(layout_.objects.size()); ++i) {
      if (object(i).id == object(member).supported_by) return i;
    }
    return PlanInk::kFloor;
  }

  Canvas& page_;
  const PlanInk& ink_;
  const PlanScale& scale_;
  const Layout& layout_;
  const FloorPlanOptions& options_;
};

}  // namespace

void draw_labels(Canvas& page, const PlanInk& ink, const PlanScale& scale, const Layout& layout, const FloorPlanOptions& options,
                 const PaperBox& key) {
  if (options.names) Labels(page, ink, scale, layout, options).draw(key);
}

}  // namespace layoutbox
