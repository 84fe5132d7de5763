#include "layoutbox/export/plan_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "layoutbox/base/units.h"
#include "layoutbox/base/words.h"

namespace layoutbox {
namespace {

double area_m2(const Layout& layout) {
  const auto& polygon = layout.room.polygon;
  double doubled = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    doubled += double(a.x) * double(b.y) - double(a.y) * double(b.x);
  }
  return doubled / 2e6;
}

// The words the room was made from, in at most three lines; a mark parts what stands in lines of its own, as edits do.
void draw_prompt(Canvas& page, const Layout& layout, double y) {
  std::string rest;
  for (const char c : layout.prompt) {
    if (c != '\n')
      rest += c;
    else if (!rest.empty())
      rest += " · ";
  }
  for (int line = 0; line < 3 && !rest.empty(); ++line, y += 3.2) {
    std::size_t end = rest.size();
    while (text_width(rest.substr(0, end), 2.2) > kSheetWidth - 2 * kSheetMargin) {
      const std::size_t space = rest.rfind(' ', end - 1);
      end = space == std::string::npos || space == 0 ? end / 2 : space;
    }
    const bool cut = line == 2 && end < rest.size();
    page.text({kSheetMargin, y}, 2.2, rest.substr(0, end) + (cut ? " …" : ""), TextAnchor::kStart, 0, "#777");
    rest.erase(0, std::min(rest.size(), end + 1));
  }
}

void draw_scale_bar(Canvas& page, int ratio, PaperPoint right) {
  // The longest round length of at most 60 mm on paper.
  const double factor = 1.0 / ratio;
  double metres = 0.1;
  for (const double length : {0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0}) {
    if (length * 1000 * factor <= 60) metres = length;
  }
  const double width = metres * 1000 * factor, x = right.x - width - 6, step = width / 4;
  for (int i = 0; i < 4; ++i) {
    const double a = x + i * step;
    page.polygon({{a, right.y - 1.2}, {a + step, right.y - 1.2}, {a + step, right.y}, {a, right.y}},
                 {i % 2 == 0 ? "#222" : "#fff", "#222", 0.15, {}});
  }
  page.text({x, right.y - 2}, 2.2, "0", TextAnchor::kMiddle);
  page.text({x + width / 2, right.y - 2}, 2.2, fmt::format("{:g}", metres / 2), TextAnchor::kMiddle);
  page.text({x + width, right.y - 2}, 2.2, fmt::format("{:g} m", metres), TextAnchor::kMiddle);
}

// North is the back of the room: +y, up the page.
void draw_north(Canvas& page) {
  const PaperPoint c{kSheetWidth - kSheetMargin - 6, kSheetMargin + 7};
  page.circle(c, 4.5, {"none", "#444", 0.2, {}});
  page.polygon({{c.x, c.y - 4.5}, {c.x + 1.8, c.y + 3.2}, {c.x, c.y + 1.8}, {c.x - 1.8, c.y + 3.2}}, {"#444", "none", 0, {}});
  page.text({c.x, c.y - 5.2}, 2.8, "N", TextAnchor::kMiddle);
}

}  // namespace

std::string plan_title(const Layout& layout) {
  std::string title = !layout.name.empty() ? layout.name : !layout.room.type.empty() ? layout.room.type : std::string("room");
  std::replace(title.begin(), title.end(), '_', ' ');
  if (title[0] >= 'a' && title[0] <= 'z') title[0] = static_cast<char>(title[0] - 'a' + 'A');
  return title;
}

void draw_sheet(Canvas& page, const Layout& layout, int ratio, bool scale_bar) {
  const double top = kSheetTitleTop;
  page.line({kSheetMargin, top}, {kSheetWidth - kSheetMargin, top}, {"none", "#222", 0.3, {}});
  page.text({kSheetMargin, top + 6.5}, 5, plan_title(layout), TextAnchor::kStart);
  page.text({kSheetMargin, top + 11}, 2.6,
            fmt::format("{:.1f} m² · ceiling {:.2f} m · {} · scale 1 : {} on A4 · lengths in metres, furniture in centimetres",
                        area_m2(layout), m_from_mm(layout.room.height), counted(layout.objects.size(), "object"), ratio),
            TextAnchor::kStart, 0, "#555");
  draw_prompt(page, layout, top + 15);
  if (scale_bar) draw_scale_bar(page, ratio, {kSheetWidth - kSheetMargin, top + 8});
  draw_north(page);
}

}  // namespace layoutbox
