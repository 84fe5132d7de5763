#include "layoutbox/export/plan_labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace layoutbox {
namespace {

constexpr double kNameSize = 2.5, kLeastNameSize = 1.9, kLineHeight = 1.15, kMaxChars = 32;

struct PaperBox {
  double x0, y0, x1, y1;
  bool overlaps(const PaperBox& other) const { return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1; }
};

// The first characters of a text, whole UTF-8 sequences.
std::string shortened(std::string text) {
  std::size_t characters = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xc0u) != 0x80u && ++characters > static_cast<std::size_t>(kMaxChars)) {
      return text.substr(0, i) + "…";
    }
  }
  return text;
}

std::string name_of_object(const PlacedObject& object) {
  std::string name = object.name.empty() ? object.category : object.name;
  std::replace(name.begin(), name.end(), '_', ' ');
  return shortened(std::move(name));
}

// Centimetres: "160 × 200".
std::string size_text(const PlacedObject& object) {
  return fmt::format("{:g} × {:g}", std::round(object.size.width) / 10, std::round(object.size.depth) / 10);
}

// One line, or two broken at the space nearest the middle.
std::vector<std::string> broken(const std::string& name, int lines) {
  if (lines == 1) return {name};
  std::optional<std::size_t> best;
  for (std::size_t i = 1; i + 1 < name.size(); ++i) {
    const auto off = [&](std::size_t place) { return std::abs(static_cast<double>(place) - static_cast<double>(name.size()) / 2); };
    if (name[i] == ' ' && (!best || off(i) < off(*best))) best = i;
  }
  return best ? std::vector<std::string>{name.substr(0, *best), name.substr(*best + 1)} : std::vector<std::string>{name};
}

PaperBox box_on_paper(const PlanScale& scale, const PlacedObject& object) {
  const double turn = radians_from_degrees(object.rotation_deg), c = std::abs(std::cos(turn)), s = std::abs(std::sin(turn));
  const double w = (c * object.size.width + s * object.size.depth) * scale.factor,
               d = (s * object.size.width + c * object.size.depth) * scale.factor;
  const PaperPoint center = scale.at(object.position[0], object.position[1]);
  return {center.x - w / 2, center.y - d / 2, center.x + w / 2, center.y + d / 2};
}

class Labels {
 public:
  Labels(Canvas& page, const PlanScale& scale, const Layout& layout, const FloorPlanOptions& options, const LabelArea& area)
      : page_(page), scale_(scale), layout_(layout), options_(options), area_(area) {}

  void draw() {
    // Large things first: their labels have room to give way.
    std::vector<const PlacedObject*> order;
    for (const PlacedObject& object : layout_.objects) order.push_back(&object);
    const auto area_of = [](const PlacedObject* o) { return std::int64_t{o->size.width} * o->size.depth; };
    std::stable_sort(order.begin(), order.end(), [&](auto* a, auto* b) { return area_of(a) < area_of(b); });
    for (const PlacedObject* object : order) {
      if (!place_inside(*object)) outside_.push_back(object);
    }
    draw_outside();
  }

 private:
  // What lies over an object: a label there would be read as the other's.
  std::vector<PaperBox> covered(const PlacedObject& object) const {
    std::vector<PaperBox> boxes = taken_;
    const double top = plan_height(object);
    for (const PlacedObject& other : layout_.objects) {
      if (&other == &object || other.mount == Mount::kCeiling) continue;
      if (other.supported_by == object.id || plan_height(other) > top) {
        boxes.push_back(box_on_paper(scale_, other));
      }
    }
    return boxes;
  }

  bool place_inside(const PlacedObject& object) {
    if (object.mount == Mount::kWall || object.mount == Mount::kCeiling) return false;
    const PaperBox box = box_on_paper(scale_, object);
    const std::vector<PaperBox> others = covered(object);
    const std::string name = name_of_object(object);
    for (const double size : {kNameSize, (kNameSize + kLeastNameSize) / 2, kLeastNameSize}) {
      for (const bool with_size : {true, false}) {
        for (const bool upright : {false, true}) {
          for (const int lines : {1, 2}) {
            if (try_inside(object, box, others, broken(name, lines), with_size, upright, size)) return true;
          }
        }
      }
    }
    return false;
  }

  bool try_inside(const PlacedObject& object, const PaperBox& box, const std::vector<PaperBox>& others, std::vector<std::string> lines,
                  bool with_size, bool upright, double size) {
    if (with_size && options_.sizes) lines.push_back(size_text(object));
    double width = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      width = std::max(width, text_width(lines[i], is_size(object, lines[i]) ? 0.8 * size : size));
    }
    double across = width + 0.8, down = static_cast<double>(lines.size()) * size * kLineHeight + 0.6;
    if (upright) std::swap(across, down);
    // The middle first, then places above, below and beside it.
    constexpr std::array<PaperPoint, 9> kPlaces{{{0, 0}, {0, 1}, {0, -1}, {1, 0}, {-1, 0}, {1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};
    const double free_x = (box.x1 - box.x0 - across) / 2, free_y = (box.y1 - box.y0 - down) / 2;
    if (free_x < 0 || free_y < 0) return false;
    for (const PaperPoint& place : kPlaces) {
      const PaperPoint center{(box.x0 + box.x1) / 2 + place.x * free_x, (box.y0 + box.y1) / 2 + place.y * free_y};
      const PaperBox label{center.x - across / 2, center.y - down / 2, center.x + across / 2, center.y + down / 2};
      if (std::any_of(others.begin(), others.end(), [&](const PaperBox& other) { return other.overlaps(label); })) continue;
      write_lines(object, lines, center, size, upright);
      taken_.push_back(label);
      return true;
    }
    return false;
  }

  bool is_size(const PlacedObject& object, const std::string& line) const { return options_.sizes && line == size_text(object); }

  void write_lines(const PlacedObject& object, const std::vector<std::string>& lines, PaperPoint center, double size, bool upright) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const double off = (static_cast<double>(i) - (static_cast<double>(lines.size()) - 1) / 2) * size * kLineHeight + 0.35 * size;
      const bool small = is_size(object, lines[i]);
      const PaperPoint at = upright ? PaperPoint{center.x + off, center.y} : PaperPoint{center.x, center.y + off};
      page_.text(at, small ? 0.8 * size : size, lines[i], TextAnchor::kMiddle, upright ? -90 : 0, small ? "#666" : "#222");
    }
  }

  // Labels in a column at each side, in the order of their objects down the page, so that no two lines cross.
  void draw_outside() {
    const double middle = (area_.room_left + area_.room_right) / 2;
    std::array<std::vector<const PlacedObject*>, 2> columns;
    for (const PlacedObject* object : outside_) {
      columns[scale_.at(object->position[0], 0).x < middle ? 0u : 1u].push_back(object);
    }
    // Neither column longer than the page.
    const auto most = static_cast<std::size_t>((area_.bottom - area_.top) / kStep());
    for (const std::size_t from : {0u, 1u}) {
      while (columns[from].size() > most && columns[1 - from].size() < most) {
        columns[1 - from].push_back(columns[from].back());
        columns[from].pop_back();
      }
    }
    draw_column(columns[0], area_.room_left - 2, area_.left, TextAnchor::kEnd);
    draw_column(columns[1], area_.room_right + 2, area_.right, TextAnchor::kStart);
  }

  double kStep() const { return options_.sizes ? 5.4 : 3.6; }

  void draw_column(std::vector<const PlacedObject*> objects, double x, double edge, TextAnchor anchor) {
    const auto height_of = [&](const PlacedObject* object) { return scale_.at(0, object->position[1]).y; };
    std::stable_sort(objects.begin(), objects.end(), [&](auto* a, auto* b) { return height_of(a) < height_of(b); });
    const double step = objects.empty() ? kStep() : std::min(kStep(), (area_.bottom - area_.top) / static_cast<double>(objects.size()));
    double next = area_.top;
    double last = area_.bottom - step * (static_cast<double>(objects.size()) - 1);
    const double room = std::abs(x - edge);
    for (const PlacedObject* object : objects) {
      const double y = std::clamp(height_of(object), next, std::max(next, last));
      next = y + step;
      last += step;
      const PaperPoint target = scale_.at(object->position[0], object->position[1]);
      const double sign = anchor == TextAnchor::kEnd ? -1 : 1;
      page_.polyline({target, {x - sign * 1.2, y}, {x, y}}, {"none", "#888", 0.12, {}});
      page_.circle(target, 0.4, {"#555", "none", 0, {}});
      const std::string name = name_of_object(*object);
      const double size = std::min(kNameSize, kNameSize * room / std::max(room, text_width(name, kNameSize) + 1));
      page_.text({x + sign * 0.6, y + 0.3 * size}, size, name, anchor);
      if (options_.sizes && step > 5)
        page_.text({x + sign * 0.6, y + 0.3 * size + 2.2}, 0.75 * size, size_text(*object), anchor, 0, "#666");
    }
  }

  Canvas& page_;
  const PlanScale& scale_;
  const Layout& layout_;
  const FloorPlanOptions& options_;
  const LabelArea& area_;
  std::vector<PaperBox> taken_;
  std::vector<const PlacedObject*> outside_;
};

}  // namespace

void draw_labels(Canvas& page, const PlanScale& scale, const Layout& layout, const FloorPlanOptions& options, const LabelArea& area) {
  if (options.names) Labels(page, scale, layout, options, area).draw();
}

}  // namespace layoutbox
